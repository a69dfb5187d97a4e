//! A derivation as text, made to be compared line by line: the tree by indentation, behind each leaf what is built.
//!
//! Where a lot was derived with its record, inner shapes say as much of themselves as leaves do, and every shape says
//! its arguments, the attributes that were set on it, and its seed.

use crate::check::Program;
use crate::shape::{Derivation, LeafOf, Lot, Node, Passage};
use crate::text::counted;
use crate::trace::shape_words;
use crate::trace::words::plain;
use std::fmt::Write;

/// How much of a tree is shown.
#[derive(Clone, Copy)]
pub struct TreeOptions<'a> {
    /// The program, for the names of attributes.
    pub program: Option<&'a Program>,
    /// Rules inside rules that are shown; what lies deeper is counted.
    pub depth: usize,
    /// Shapes of a lot that are shown; the rest is counted.
    pub most: usize,
}

/// Every shape at every depth, without seeds and attributes: those need the program.
impl Default for TreeOptions<'_> {
    fn default() -> Self {
        TreeOptions { program: None, depth: usize::MAX, most: usize::MAX }
    }
}

/// Every lot, each under its id. Cost: linear in the shapes, and in the depth of each for its indentation.
pub fn tree_text(derivation: &Derivation, options: &TreeOptions) -> String {
    let lots = derivation.lots.iter().map(|lot| lot_text(derivation, lot, options));
    lots.collect::<Vec<_>>().join("\n")
}

/// One lot, under its id.
pub fn lot_text(derivation: &Derivation, lot: &Lot, options: &TreeOptions) -> String {
    Tree::new(derivation, lot, options).text()
}

/// One lot on its way into text.
struct Tree<'a> {
    derivation: &'a Derivation,
    lot: &'a Lot,
    options: &'a TreeOptions<'a>,
    /// The leaves, by node, and for each where its leaves begin.
    leaves: Vec<&'a LeafOf>,
    depths: Vec<usize>,
    text: String,
}

impl<'a> Tree<'a> {
    fn new(derivation: &'a Derivation, lot: &'a Lot, options: &'a TreeOptions<'a>) -> Tree<'a> {
        let mut leaves: Vec<&LeafOf> = lot.outcome.leaves.iter().collect();
        leaves.sort_by_key(|leaf| leaf.node);
        let depths = depths(&lot.outcome.nodes);
        Tree { derivation, lot, options, leaves, depths, text: String::new() }
    }

    fn text(mut self) -> String {
        self.head();
        let (mut cut, mut shown) = (0, 0);
        for index in 0..self.lot.outcome.nodes.len() {
            if self.depths[index] > self.options.depth {
                cut += 1;
                continue;
            }
            self.cut(std::mem::take(&mut cut));
            if shown == self.options.most {
                let rest = counted(self.lot.outcome.nodes.len() - index, "more shape");
                self.line(0, format_args!("… and {rest}: `--lot` shows all, `--depth` fewer"));
                return self.text;
            }
            shown += 1;
            self.node(index);
        }
        self.cut(cut);
        self.text
    }

    /// The lot, and with a record what it began with.
    fn head(&mut self) {
        let mut head = self.lot.id.to_string();
        if let Some((first, program)) = self.passage(0).zip(self.options.program) {
            let _ = write!(head, ": seed {:016x}", first.shape.seed.0);
            for (slot, attribute) in program.public_attributes() {
                let _ = write!(head, ", {} = {}", attribute.name, plain(&first.shape.attributes[slot]));
            }
        }
        self.text.push_str(&head);
        self.text.push('\n');
    }

    /// A line per node, and a line per leaf that its rule built without naming it.
    fn node(&mut self, index: usize) {
        let node = &self.lot.outcome.nodes[index];
        let depth = self.depths[index];
        let first = self.leaves.partition_point(|leaf| (leaf.node.0 as usize) < index);
        let last = self.leaves.partition_point(|leaf| leaf.node.0 as usize <= index);
        let own = (node.rule.is_none() && first < last).then(|| self.leaves[first]);
        let mut line = self.derivation.symbols[node.symbol as usize].to_string();
        let known = self.passage(index);
        if let Some(args) = known.map(|passage| &passage.args).filter(|args| !args.is_empty()) {
            let args: Vec<String> = args.iter().map(plain).collect();
            let _ = write!(line, "({})", args.join(", "));
        }
        match (own, known) {
            (Some(leaf), _) => _ = write!(line, ": {}", shape_words(&leaf.shape)),
            (None, Some(passage)) => _ = write!(line, " --> {}", shape_words(&passage.shape)),
            (None, None) => {}
        }
        if let Some(passage) = known {
            let _ = write!(line, "{}, seed {:016x}", self.set(index, passage), passage.shape.seed.0);
        }
        self.line(depth, line);
        for at in first + usize::from(own.is_some())..last {
            let shape = &self.leaves[at].shape;
            let seed = known.map(|_| format!(", seed {:016x}", shape.seed.0)).unwrap_or_default();
            self.line(depth + 1, format_args!("- {}{seed}", shape_words(shape)));
        }
    }

    /// The attributes in which a shape differs from its parent.
    fn set(&self, index: usize, passage: &Passage) -> String {
        let parent = self.lot.outcome.nodes[index].parent.0 as usize;
        let mut words = String::new();
        if let Some((program, before)) = self.options.program.zip(self.passage(parent)) {
            for (slot, attribute) in program.attributes.iter().enumerate() {
                let (old, new) = (before.shape.attributes.get(slot), passage.shape.attributes.get(slot));
                if let Some(new) = new.filter(|_| old != new) {
                    let _ = write!(words, ", {} = {}", attribute.name, plain(new));
                }
            }
        }
        words
    }

    fn passage(&self, index: usize) -> Option<&'a Passage> {
        self.lot.outcome.record.as_ref()?.shapes.get(index)
    }

    fn cut(&mut self, shapes: usize) {
        if shapes > 0 {
            self.line(self.options.depth + 1, format_args!("… {} below", counted(shapes, "shape")));
        }
    }

    fn line(&mut self, depth: usize, line: impl std::fmt::Display) {
        let _ = writeln!(self.text, "{}{line}", "  ".repeat(depth + 1));
    }
}

/// How deep each node lies; a parent stands before its children.
fn depths(nodes: &[Node]) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::with_capacity(nodes.len());
    for (index, node) in nodes.iter().enumerate() {
        let parent = node.parent.0 as usize;
        depths.push(if parent < index { depths[parent] + 1 } else { 0 });
    }
    depths
}
