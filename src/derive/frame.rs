//! What an expression sees of a derivation: the current shape, its numbers, and what stands around it.
//!
//! The engine fills a [`Frame`] in for each expression; evaluation and selectors read it. Nothing here changes a shape.

use crate::derive::evaluate::Names;
use crate::element::Catalogue;
use crate::files::Files;
use crate::functions::{At, Initial, Surroundings};
use crate::layout::Georeference;
use crate::raster::Rasters;
use crate::seed::Random;
use crate::shape::{Node, NodeId, Occluders, Shape};
use crate::value::Value;
use std::cell::RefCell;

/// What an expression is evaluated with: the current shape and all around it.
pub(super) struct Frame<'f> {
    /// What names stand for.
    pub names: Names<'f>,
    /// The current shape.
    pub shape: &'f Shape,
    /// Its own numbers.
    pub random: &'f mut Random,
    /// The earlier shapes and the features of the lot.
    pub intra: &'f Occluders,
    /// The initial shapes of the neighbours.
    pub inter: &'f Occluders,
    /// The initial shape.
    pub initial: &'f Initial,
    /// The element repository.
    pub catalogue: &'f Catalogue,
    /// Coverage maps.
    pub rasters: &'f Rasters<'f>,
    /// Tables, texts, and what files there are.
    pub files: &'f Files<'f>,
    /// The way from the plan to the layout's own coordinates.
    pub georeference: &'f Georeference,
    /// The tree so far.
    pub nodes: &'f [Node],
    /// The node whose rule runs.
    pub node: NodeId,
    /// What `print` was given within expressions.
    pub told: &'f RefCell<Vec<Value>>,
    /// Each branch's parent.
    pub branches: &'f [NodeId],
    /// The current shape's branch.
    pub branch: NodeId,
    /// The place for which an argument that may vary is evaluated.
    pub at: Option<&'f At<'f>>,
}

impl Frame<'_> {
    /// Evaluates on the current shape.
    pub fn with<T>(&mut self, f: impl FnOnce(&Names, &mut Surroundings) -> T) -> T {
        self.on(self.shape, f)
    }

    /// Evaluates on another shape: a component that a selector asks about.
    pub fn on<T>(&mut self, shape: &Shape, f: impl FnOnce(&Names, &mut Surroundings) -> T) -> T {
        let is_ancestor = |other: NodeId| climb(self.branches, self.branch).any(|branch| branch == other);
        let tree_key = || tree_key(self.nodes, self.node);
        let mut around = Surroundings {
            shape,
            random: self.random,
            intra: self.intra,
            inter: self.inter,
            is_ancestor: &is_ancestor,
            initial: self.initial,
            at: self.at,
            catalogue: self.catalogue,
            rasters: self.rasters,
            files: self.files,
            source: 0,
            georeference: self.georeference,
            tree_key: &tree_key,
            told: self.told,
        };
        f(&self.names, &mut around)
    }

    /// The same frame for a shorter time.
    pub fn reborrow(&mut self) -> Frame<'_> {
        Frame { names: self.names, random: self.random, ..*self }
    }
}

/// A branch and those that it grows from.
pub(super) fn climb(branches: &[NodeId], from: NodeId) -> impl Iterator<Item = NodeId> {
    std::iter::successors(Some(from), |id| Some(branches[id.0 as usize]).filter(|parent| parent != id))
}

/// The number of each node on the way down to one among its siblings: `0;2;1;`. Cost: linear in the nodes before it.
fn tree_key(nodes: &[Node], node: NodeId) -> String {
    let mut numbers = Vec::new();
    let mut at = node;
    while let Some(parent) = nodes.get(at.0 as usize).map(|n| n.parent).filter(|parent| *parent != at) {
        let between = &nodes[parent.0 as usize + 1..at.0 as usize];
        numbers.push(between.iter().filter(|n| n.parent == parent).count());
        at = parent;
    }
    numbers.iter().rev().fold(String::from("0;"), |key, number| format!("{key}{number};"))
}
