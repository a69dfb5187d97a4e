//! What follows an operation's parentheses.

use super::{DEPTH, Writer};
use bosquet::ops::{BlockKind, Spec};

const SIDES: [&str; 16] = [
    "all",
    "front",
    "back",
    "left",
    "right",
    "top",
    "bottom",
    "side",
    "0",
    "1",
    "comp.index % 2 == 0",
    "horizontal",
    "street.front",
    "world.up",
    "scope.sx > 3",
    "vertical",
];

impl Writer<'_> {
    pub fn block(&mut self, spec: &'static Spec) {
        self.depth += 1;
        match spec.block {
            BlockKind::None => {}
            BlockKind::Cuts => self.cuts(),
            BlockKind::Perimeter => {
                self.put(" { ");
                self.size(&["", "'", "~"]);
                self.put(" : ");
                self.size(&["", "'"]);
                self.put(" : ");
                self.inner();
                self.put(" }* { remainder : ");
                self.inner();
                self.put(" }");
            }
            BlockKind::Selectors(extra) => self.selectors(extra),
            BlockKind::Body => self.entries(1),
            // `inline` takes operations alone.
            BlockKind::Operands(1) => {
                self.put(" { ");
                self.steps();
                self.put(" }");
            }
            BlockKind::Operands(count) => self.entries(count),
        }
        self.depth -= 1;
    }

    fn cuts(&mut self) {
        self.put(" { ");
        for _ in 0..=self.pick(3) {
            if self.depth < DEPTH && self.pick(5) == 4 {
                self.put("{ ~1 : Leaf. | 2 : Leaf. }* | ");
            }
            self.size(&["", "'", "~", "~"]);
            self.put(" : ");
            self.inner();
            self.put(" | ");
        }
        self.put("~1 : Leaf. }");
        let repeat = ["", "*"][self.pick(2)];
        self.put(repeat);
    }

    fn selectors(&mut self, extra: &[&str]) {
        self.put(" { ");
        for _ in 0..self.pick(3) {
            let own = self.chance();
            let word = if own && !extra.is_empty() { extra[self.pick(extra.len())] } else { SIDES[self.pick(16)] };
            // What is left over is one shape, and takes no other separator.
            let separator = if word == "remainder" { ":" } else { [":", "=", "=:"][self.pick(3)] };
            self.put(&format!("{word} {separator} "));
            self.inner();
            self.put(" | ");
        }
        let rest = if extra.contains(&"remainder") && self.chance() { "remainder : " } else { "all : " };
        self.put(rest);
        self.inner();
        self.put(" }");
    }

    fn entries(&mut self, count: usize) {
        for index in 0..count {
            self.put(if index == 0 { " { " } else { " | " });
            self.inner();
        }
        self.put(" }");
    }

    /// A body, or a leaf where nesting has gone deep enough.
    fn inner(&mut self) {
        if self.depth >= DEPTH { self.put("Leaf.") } else { self.body() }
    }
}
