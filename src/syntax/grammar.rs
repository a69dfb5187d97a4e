//! The parser that pest makes of `grammar/cga.pest`.

/// Parses one piece of a rule file by one rule of the grammar.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/cga.pest"]
pub(super) struct Cga;

/// One node of pest's tree.
pub(super) type Pair<'i> = pest::iterators::Pair<'i, Rule>;
