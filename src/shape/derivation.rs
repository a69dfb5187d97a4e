//! What a derivation leaves: per lot the tree of shapes with its leaves, and what rules reported.

use crate::diag::Diagnostic;
use crate::shape::{Record, Shape};
use crate::value::Value;
use std::sync::Arc;

/// Every lot's outcome, in the order of the layout.
#[derive(Clone, Debug, Default)]
pub struct Derivation {
    /// The names of rules and symbols; nodes refer to them by index.
    pub symbols: Arc<[Arc<str>]>,
    /// One outcome per region that has a start rule.
    pub lots: Vec<Lot>,
    /// The ids of regions that no rule starts on.
    pub without_rule: Vec<Arc<str>>,
}

/// One region's outcome.
#[derive(Clone, Debug)]
pub struct Lot {
    /// The region's index in the layout.
    pub region: usize,
    /// The region's id.
    pub id: Arc<str>,
    /// What the rules made.
    pub outcome: Outcome,
}

/// The tree of shapes of one lot and what its rules said.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The tree in derivation order: a parent stands before its children, the start symbol first.
    pub nodes: Vec<Node>,
    /// What is built.
    pub leaves: Vec<LeafOf>,
    /// `report(key, value)` in order.
    pub reports: Vec<(Arc<str>, Value)>,
    /// `print(value)` in order.
    pub prints: Vec<Print>,
    /// Branches that were stopped, and why.
    pub diagnostics: Vec<Diagnostic>,
    /// The way to it, where it was asked for.
    pub record: Option<Box<Record>>,
}

/// Index of a node in its lot's tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct NodeId(pub u32);

/// A shape of the tree, without its geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The node it came from; itself for the start symbol.
    pub parent: NodeId,
    /// Its symbol, an index into [`Derivation::symbols`].
    pub symbol: u32,
    /// The rule that replaced it, an index into the program's rules; none for leaves by name.
    pub rule: Option<u32>,
}

/// A leaf: what is built, and the node whose rule made it.
#[derive(Clone, Debug)]
pub struct LeafOf {
    /// The node.
    pub node: NodeId,
    /// The shape, in the place in memory where the engine first put it.
    pub shape: Box<Shape>,
}

/// One `print`.
#[derive(Clone, Debug, PartialEq)]
pub struct Print {
    /// The rule that printed.
    pub symbol: u32,
    /// What.
    pub value: Value,
}
