//! Rule files from bytes: whatever the bytes, two files that parse and nearly always check. For properties and fuzzers.
//!
//! Nothing is named here that a declaration names already: operations, their parameters and blocks come from
//! [`OPERATIONS`], functions from [`bosquet::functions::all`], so what is added to them is tried from that day on. Each
//! choice takes a byte; where they have run out the plainest alternative is taken, so every text ends.

mod blocks;
mod values;

use crate::place;
use crate::trial::Files;
use bosquet::layout::Layout;
use bosquet::ops::{OPERATIONS, Origin, ParamKind, Spec};
use bosquet::seed::Seed;

/// How deep bodies and expressions nest at most.
const DEPTH: u8 = 4;

/// Longest texts: they would end otherwise where the bytes do, which may be far away.
const MOST: usize = 6_000;

/// Layouts as `place` has them: plain, holed, concave, sliver, tiny, huge, pinched, several lots, far away.
const LAYOUTS: [&[&str]; 10] = [
    &["rect 40 30"],
    &["rect 30 30", "hole 10,10 10,20 20,20 20,10", "feature building 22,3 28,3 28,9 22,9 height=6"],
    &["polygon 0,0 30,0 30,6 6,6 6,24 30,24 30,30 0,30", "attribute size=5"],
    &["rect 60 0.004"],
    &["rect 0.02 0.03"],
    &["rect 900000 700000"],
    &["polygon 0,0 20,0.0001 40,0 21,7 20,30 19,7", "elevation 1e6"],
    &["rect 12 9", "rect 12 9 12 0", "start A", "rect 12 9 24 0", "kind park", "feature street 0,-4 36,-4"],
    &["polygon 0,0 9,0 9,9", "feature tree 3,2", "feature path 0,0 9,9", "rect 4 4 20 20"],
    &["polygon 1e6,1e6 1000030,1e6 1000030,1000012.5 1000015,1000012.5 1000015,1000025 1e6,1000025"],
];

/// A program and where it is tried: the first byte chooses the layout, the second the seed.
pub fn of_bytes(bytes: &[u8]) -> (Files, Layout, Seed) {
    let (head, rest) = bytes.split_at(bytes.len().min(2));
    let byte = |index: usize| head.get(index).copied().unwrap_or_default();
    let layout = place::parse(LAYOUTS[usize::from(byte(0)) % LAYOUTS.len()]).expect("a layout");
    (program(rest), layout, Seed(byte(1).into()))
}

/// The program of these bytes.
fn program(bytes: &[u8]) -> Files {
    let mut writer = Writer { bytes: bytes.iter(), out: String::new(), depth: 0, params: 0, inside: None };
    writer.second();
    let second = std::mem::take(&mut writer.out);
    writer.main();
    Files { main: writer.out, second }
}

struct Writer<'b> {
    bytes: std::slice::Iter<'b, u8>,
    out: String,
    depth: u8,
    /// How many parameters, `n` first, the definition at hand has.
    params: usize,
    /// In which file, or of which definition, names count: what may not be called there.
    inside: Option<Place>,
}

/// Where an expression stands.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// In the value of an attribute: other attributes would go in circles.
    Attribute,
    /// In the imported file: the names of the main one are unknown.
    Second,
}

/// Rules of the main file with their number of parameters.
const RULES: [(&str, usize); 5] = [("A", 0), ("B", 1), ("C", 0), ("second.Row", 0), ("Leaf.", 0)];

impl Writer<'_> {
    // ---- definitions

    fn second(&mut self) {
        self.inside = Some(Place::Attribute);
        self.put("attr wide = ");
        self.number();
        self.put("\nattr word = ");
        self.text();
        self.inside = Some(Place::Second);
        self.put("\nRow --> ");
        self.body();
        self.put("\nextension Bed --> ");
        self.body();
        self.put("\n");
        self.inside = None;
    }

    fn main(&mut self) {
        self.put("import second : \"second.cga\" ");
        let overrides = ["", "()", "(wide)", "(wide = 3)", "(word = \"oak\")", "(Bed --> Leaf.)"][self.pick(6)];
        self.put(overrides);
        self.attributes();
        self.functions();
        for (name, params) in [("Lot", 0), ("A", 0), ("B(n)", 1), ("C", 0)] {
            self.rule(name, params);
        }
        if self.chance() {
            self.put("\nstyle Winter\nC --> ");
            self.body();
        }
    }

    fn attributes(&mut self) {
        self.inside = Some(Place::Attribute);
        let context = ["", "", "@Context(40)\n"][self.pick(3)];
        self.put(&format!("\n{context}attr size = "));
        self.number();
        self.put("\nattr kind = ");
        self.text();
        self.put("\nattr on = ");
        self.truth();
        self.put("\nconst list = ");
        self.numbers();
        self.inside = None;
    }

    fn functions(&mut self) {
        self.params = 1;
        self.put("\nf(n)");
        self.locals();
        self.put(" = ");
        self.number();
        self.put("\ng(n) = case n > 0 : g(n - 1) + ");
        self.number();
        self.put(" else : 1");
        self.params = 0;
    }

    fn rule(&mut self, name: &str, params: usize) {
        self.params = params;
        self.put(&format!("\n{name}"));
        if params > 0 {
            self.locals();
        }
        self.put(" --> ");
        self.body();
        self.params = 0;
        self.put("\n");
    }

    fn locals(&mut self) {
        if self.chance() {
            self.put(" with (m := ");
            self.number();
            self.put(")");
        }
    }

    // ---- successors

    fn body(&mut self) {
        self.depth += 1;
        match self.pick_nested(8) {
            6 => self.cases(Writer::truth, "case ", Writer::body),
            7 => self.cases(Writer::share, "", Writer::body),
            _ => self.steps(),
        }
        self.depth -= 1;
    }

    /// Operations, then perhaps what comes next.
    pub fn steps(&mut self) {
        for _ in 0..=self.pick(4) {
            self.step();
        }
        if self.chance() {
            self.successor();
        }
    }

    fn step(&mut self) {
        if self.out.len() > MOST {
            return self.put("NIL ");
        }
        match self.pick_nested(16) {
            0 => self.successor(),
            1 => {
                self.put("[ ");
                self.body();
                self.put("] ");
            }
            _ => {
                let operation = &OPERATIONS[self.pick(OPERATIONS.len())];
                self.operation(operation.spec);
            }
        }
    }

    fn successor(&mut self) {
        let (name, params) = match self.inside {
            Some(Place::Second) => [("Bed", 0), ("Leaf.", 0)][self.pick(2)],
            _ => RULES[self.pick(RULES.len())],
        };
        if self.inside.is_none() && self.pick(12) == 11 {
            self.put("second(wide = ");
            self.number();
            self.put(").Row ");
            return;
        }
        self.put(name);
        if params > 0 {
            self.put("(");
            self.number();
            self.put(")");
        }
        self.put(" ");
    }

    fn operation(&mut self, spec: &'static Spec) {
        let aliases = spec.aliases.len() + 1;
        let name = match self.pick(aliases) {
            0 => spec.name,
            alias => spec.aliases[alias - 1],
        };
        // The papers' `Subdiv` and `Repeat` have an order of arguments of their own.
        let name = if spec.block == bosquet::ops::BlockKind::Cuts { spec.name } else { name };
        self.put(name);
        self.arguments(spec);
        self.block(spec);
        self.put(" ");
    }

    fn arguments(&mut self, spec: &'static Spec) {
        let (mut before, mut last) = ("(", None);
        for param in spec.params {
            if param.default.is_some() && !self.chance() {
                continue;
            }
            self.put(before);
            if param.default.is_some() {
                self.put(&format!("{} = ", param.name));
            }
            last = match (spec.origin, param.kind) {
                // What is ours refuses negative lengths while it is checked.
                (Origin::Added, ParamKind::Metres | ParamKind::Number | ParamKind::Degrees) => {
                    self.amount();
                    None
                }
                (_, kind) => self.argument(kind, last),
            };
            before = ", ";
        }
        self.put(if before == "(" { "" } else { ")" });
    }

    // ---- choices

    /// `head a : content head b : content else : content`.
    fn cases(&mut self, head: fn(&mut Self), word: &str, content: fn(&mut Self)) {
        for _ in 0..=self.pick(2) {
            self.put(&format!(" {word}"));
            head(self);
            self.put(" : ");
            content(self);
        }
        self.put(" else : ");
        content(self);
    }

    fn share(&mut self) {
        let share = ["30%", "0%", "5.5%", "33%"][self.pick(4)];
        self.put(share);
    }

    // ---- bytes

    fn put(&mut self, text: &str) {
        self.out.push_str(text);
    }

    /// One of so many, the first where no bytes are left.
    fn pick(&mut self, count: usize) -> usize {
        self.bytes.next().map_or(0, |byte| usize::from(*byte) % count)
    }

    /// The same, and the first where nesting has gone deep enough.
    fn pick_nested(&mut self, count: usize) -> usize {
        if self.depth >= DEPTH { 0 } else { self.pick(count) }
    }

    fn chance(&mut self) -> bool {
        self.pick(3) == 2
    }
}

/// What a `set` of an attribute takes, where the attribute is known.
type Wanted = Option<ParamKind>;
