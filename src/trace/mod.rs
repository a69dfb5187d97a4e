//! Derivations as people read them: the tree of shapes as text, and the way from the start rule to what was built.

mod chain;
mod describe;
mod place;
mod tree;
mod words;

pub use chain::{Explanation, Happened, Neighbour, Step, explain};
pub use describe::shape_words;
pub use place::{Thing, at, by_id};
pub use tree::{TreeOptions, lot_text, tree_text};
