//! Derivation inside a rule: the parts of a block of operands, each on a copy of the current shape, down to its leaves.
//!
//! What they make is taken out of the lot's leaves again and handed to the operation, which makes the current shape of
//! it. The nodes stay in the tree, so that it shows what was derived.

use crate::check::Application;
use crate::derive::engine::{Current, Engine, Stop, Turn};
use crate::seed::Seed;
use crate::shape::{Geometry, Shape};

/// Operands derived inside operands: each takes a piece of the stack.
const DEEPEST: usize = 48;

impl Engine<'_> {
    /// The leaves of every operand, without those that cannot become part of a shape: they stay the lot's.
    pub(super) fn operands(
        &mut self,
        application: &Application,
        seed: Seed,
        turn: &Turn,
        current: &Current,
    ) -> Result<Vec<Vec<Shape>>, Stop> {
        if self.inside == DEEPEST {
            let message = format!("`{}` is nested deeper than {DEEPEST} times", application.operation.spec.name);
            let diagnostic = self.diagnostic("limit", application.span, message, turn.node);
            let hint = "a rule that comes back to itself inside one needs a `case` that ends it";
            return Err(Stop::Branch(Box::new(diagnostic.hint(hint))));
        }
        let mut operands = Vec::with_capacity(application.bodies.len());
        self.inside += 1;
        for (index, body) in application.bodies.iter().enumerate() {
            let mut shape = current.shape.clone();
            shape.seed = seed.child(index as u64);
            let inner = Current::new(shape, self.branch(current.branch));
            let (waiting, first) = (std::mem::take(&mut self.queue), self.outcome.leaves.len());
            let aside = self.set_aside(turn.node);
            let mut done = self.body(body, turn, inner);
            self.queue.reverse();
            if done.is_ok() {
                done = self.work();
            }
            self.queue = waiting;
            self.taken_up(turn.node, aside);
            operands.push(self.taken(first));
            if done.is_err() {
                self.inside -= 1;
                return done.map(|()| operands);
            }
        }
        self.inside -= 1;
        Ok(operands)
    }

    /// The leaves from the `first`-th on, taken out where they are needed.
    fn taken(&mut self, first: usize) -> Vec<Shape> {
        let mut made = Vec::new();
        let leaves = self.outcome.leaves.split_off(first);
        self.unbuilt(first, leaves.iter().map(|leaf| is_matter(&leaf.shape)));
        for leaf in leaves {
            match is_matter(&leaf.shape) {
                true => made.push(*leaf.shape),
                false => self.outcome.leaves.push(leaf),
            }
        }
        made
    }

    /// Whether a leaf is the lot's: what an operand makes is not, unless it cannot become part of a shape.
    pub(super) fn stays(&self, shape: &Shape) -> bool {
        self.inside == 0 || !is_matter(shape)
    }
}

/// Whether it can become part of a shape.
fn is_matter(shape: &Shape) -> bool {
    matches!(shape.geometry, Geometry::Flat(..) | Geometry::Prism(..) | Geometry::Mesh(_))
}
