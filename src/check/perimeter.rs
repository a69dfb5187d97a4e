//! The two blocks of `splitAndSetbackPerimeter`: `{ length : depth : A | … }*{ remainder : B }`.

use crate::check::Checker;
use crate::check::code::Code;
use crate::check::program::{Block, Body, Cut};
use crate::diag::Diagnostic;
use crate::ops::Spec;
use crate::syntax::ast;

impl Checker {
    /// Lengths and depths of the bands, and who takes what they leave.
    pub(super) fn perimeter(&mut self, spec: &Spec, blocks: &[ast::Block], bodies: &mut Vec<Body>) -> Block {
        let [bands, rest @ ..] = blocks else { return Block::None };
        let depths = bands.entries.iter().filter_map(|entry| self.depth(entry)).collect();
        let cuts = self.cuts(&bands.entries, bodies);
        let cuts = if bands.repeat { Box::new([Cut::Repeat(cuts)]) } else { cuts };
        let entries = rest.iter().flat_map(|block| &block.entries);
        let rest = entries.filter_map(|entry| self.selector(spec, &["remainder"], entry, bodies)).collect();
        Block::Perimeter { cuts, depths, rest }
    }

    /// How deep a band is.
    fn depth(&mut self, entry: &ast::Entry) -> Option<(Code, crate::diag::Span)> {
        match entry.head.as_ref().and_then(|head| head.depth.as_ref()) {
            Some(depth) => Some((self.number(depth), depth.span)),
            None => {
                let message = "a band of a perimeter needs a length and a depth";
                let diagnostic = Diagnostic::error("block", entry.span, message);
                self.tell(diagnostic.hint("as in `8 : 2 : Hedge`, 2 m deep"));
                None
            }
        }
    }
}
