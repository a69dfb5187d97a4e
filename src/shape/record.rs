//! What a derivation did on its way, where somebody asked for it: every shape as it came to its rule, and what led from
//! one to the next.

use crate::diag::Span;
use crate::shape::Shape;
use crate::value::Value;

/// The way of one lot's derivation.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// Every shape of the tree, in the order of its nodes.
    pub shapes: Vec<Passage>,
    /// What led from its node to each leaf, in the order of the leaves; nothing for leaves by name.
    pub leaves: Vec<Vec<Event>>,
}

/// A shape as it came to its rule.
#[derive(Clone, Debug)]
pub struct Passage {
    /// The shape.
    pub shape: Shape,
    /// The arguments of its rule.
    pub args: Box<[Value]>,
    /// What the rule of its parent did to it, in order; nothing for the start symbol.
    pub trail: Vec<Event>,
}

/// One thing that a rule did on the way to a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Where it is written.
    pub span: Span,
    /// What.
    pub deed: Deed,
}

/// What a rule did.
#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
    /// An operation worked on the current shape, with these arguments by name.
    Applied(&'static str, Vec<(&'static str, Value)>),
    /// The way went on with one piece of a block.
    Took {
        /// The entry as it is written: `~2`, `street.front`; empty where the block has one for all.
        entry: String,
        /// Which piece, from 0.
        index: usize,
        /// How many there were.
        total: usize,
    },
    /// Of several conditions the first that holds was followed.
    Chose {
        /// It; none for `else`.
        condition: Option<String>,
        /// Those before it.
        failed: Vec<String>,
        /// What they read, with the values of that moment.
        reads: Vec<(String, Value)>,
    },
    /// A number was drawn between 0 and `of`, and what its part belongs to was followed.
    Drew {
        /// The number.
        number: f64,
        /// The part: from, to.
        part: (f64, f64),
        /// What the parts sum to: 100 for percentages.
        of: f64,
    },
}
