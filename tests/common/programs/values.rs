//! Expressions of a wanted kind, and arguments of operations.

use super::{DEPTH, Place, Wanted, Writer};
use bosquet::functions::{Function, Gives, all};
use bosquet::ops::ParamKind;

/// Numbers at which arithmetic and geometry break, among those that rules are made of.
const NUMBERS: [&str; 24] = [
    "1", "2", "0.5", "3", "0.1", "10", "4", "0", "-1", "45", "90", "180", "1e-9", "1e9", "1e300", "-1e300", "1e-300",
    "(0 / 0)", "(1 / 0)", "(-1 / 0)", "0.333", "25", "100", "7",
];
const TEXTS: [&str; 12] = [
    "\"oak\"",
    "\"\"",
    "\"lawn\"",
    "\"a;b;c\"",
    "\"1;2;-3\"",
    "\"building\"",
    "\"#ff8800\"",
    "\"table.csv\"",
    "\"birch\"",
    "\"temperate\"",
    "\"*a?\"",
    "\"é🌳\"",
];
const ARRAYS: [&str; 8] =
    ["[1, 2, 3]", "[1]", "[0 : 9]", "[5 : -1 : -5]", "[1, 2; 3, 4]", "[0.5, 1e300, -2]", "[]", "[1 : 0.1 : 3]"];
const INFIXES: [&str; 6] = ["+", "-", "*", "/", "%", "+"];
const COMPARISONS: [&str; 6] = ["<", "<=", ">", ">=", "==", "!="];
/// Attributes of the main file.
const OWN: [(&str, ParamKind); 3] = [("size", ParamKind::Number), ("kind", ParamKind::Text), ("on", ParamKind::Truth)];

impl Writer<'_> {
    /// One argument; gives what the argument after it has to be, where this one decides that.
    pub fn argument(&mut self, kind: ParamKind, wanted: Wanted) -> Wanted {
        match kind {
            ParamKind::Varying(ParamKind::Word | ParamKind::Text) => self.text(),
            ParamKind::Varying(ParamKind::Share) => drop(self.argument(ParamKind::Share, None)),
            ParamKind::Varying(_) => self.amount(),
            ParamKind::Choice(words) => {
                let word = words[self.pick(words.len())];
                self.put(word);
            }
            ParamKind::Attribute => return self.settable(),
            ParamKind::Size => self.size(&["", "", "'"]),
            ParamKind::Text | ParamKind::Word => self.text(),
            ParamKind::Truth => self.truth(),
            ParamKind::Truths => self.put("[true, false, true]"),
            ParamKind::PerEdge if self.chance() => self.numbers(),
            ParamKind::Share => {
                let share = ["0.5", "1", "0", "0.02", "rand(1)", "(rand(9) - 4)"][self.pick(6)];
                self.put(share);
            }
            ParamKind::Count | ParamKind::PerArea => self.amount(),
            ParamKind::Any => match wanted {
                Some(kind) => drop(self.argument(kind, None)),
                None => self.any(),
            },
            _ => self.number(),
        }
        None
    }

    /// The name of an attribute that can be set.
    fn settable(&mut self) -> Wanted {
        if self.inside.is_none() && self.chance() {
            let (name, kind) = OWN[self.pick(OWN.len())];
            self.put(name);
            return Some(kind);
        }
        let known: Vec<&Function> = all().filter(|function| function.settable).collect();
        let function = known[self.pick(known.len())];
        self.put(function.name);
        Some(match function.gives {
            Gives::Text => ParamKind::Text,
            Gives::Truth => ParamKind::Truth,
            _ => ParamKind::Number,
        })
    }

    /// A number behind one of these marks.
    pub fn size(&mut self, marks: &[&str]) {
        let mark = marks[self.pick(marks.len())];
        self.put(&format!("{mark}("));
        self.number();
        self.put(")");
    }

    /// A number that is not below 0, or one that cannot be told before.
    pub fn amount(&mut self) {
        let amount =
            ["1", "0.5", "3", "0", "0.02", "12", "300", "1e9", "1e300", "1e-9", "(rand(9) - 4)", "place.u", "size"];
        let known = if self.inside.is_some() { 11 } else { 13 };
        let amount = amount[self.pick(known)];
        self.put(amount);
    }

    pub fn number(&mut self) {
        self.depth += 1;
        match self.pick_nested(12) {
            6 => {
                let infix = INFIXES[self.pick(INFIXES.len())];
                self.put("(");
                self.number();
                self.put(&format!(" {infix} "));
                self.number();
                self.put(")");
            }
            7 => self.call(Gives::Number),
            8 => {
                self.put("(");
                self.cases(Writer::truth, "case ", Writer::number);
                self.put(")");
            }
            9 => self.own_number(),
            10 => {
                self.put("comp(e) { front : ");
                self.number();
                self.put(" | all : ");
                self.number();
                self.put(" }[0]");
            }
            11 => self.call(Gives::Any),
            _ => {
                let number = NUMBERS[self.pick(NUMBERS.len())];
                self.put(number);
            }
        }
        self.depth -= 1;
    }

    /// A name of the files.
    fn own_number(&mut self) {
        if self.params > 0 && self.chance() {
            return self.put("n");
        }
        match self.inside {
            Some(Place::Attribute) => self.put("2"),
            Some(Place::Second) => self.put("wide"),
            None => {
                let name = ["size", "list[1]", "second.wide", "f(2)", "g(3)", "g(300)"];
                // Functions that call themselves without an end would only ever meet their limit.
                let name = name[self.pick(if self.params > 0 { 3 } else { 6 })];
                self.put(name);
            }
        }
    }

    pub fn text(&mut self) {
        self.depth += 1;
        match self.pick_nested(8) {
            5 => {
                self.put("(\"a\" + ");
                self.number();
                self.put(")");
            }
            6 => self.call(Gives::Text),
            7 if self.inside.is_none() => self.put("kind"),
            _ => {
                let text = TEXTS[self.pick(TEXTS.len())];
                self.put(text);
            }
        }
        self.depth -= 1;
    }

    pub fn truth(&mut self) {
        self.depth += 1;
        match self.pick_nested(6) {
            3 => self.call(Gives::Truth),
            4 => {
                self.put("!(");
                self.truth();
                self.put(")");
            }
            5 if self.inside.is_none() => self.put("on"),
            1 | 2 => {
                let comparison = COMPARISONS[self.pick(COMPARISONS.len())];
                self.number();
                self.put(&format!(" {comparison} "));
                self.number();
            }
            _ => {
                let truth = ["true", "false"][self.pick(2)];
                self.put(truth);
            }
        }
        self.depth -= 1;
    }

    pub fn numbers(&mut self) {
        self.depth += 1;
        match self.pick_nested(6) {
            3 => self.call(Gives::Numbers),
            4 => {
                self.put("(");
                self.numbers();
                self.put(" .* ");
                self.number();
                self.put(")");
            }
            5 => {
                self.put("[");
                self.number();
                self.put(", ");
                self.number();
                self.put("]");
            }
            _ => {
                let array = ARRAYS[self.pick(ARRAYS.len())];
                self.put(array);
            }
        }
        self.depth -= 1;
    }

    fn any(&mut self) {
        match self.pick(4) {
            0 => self.number(),
            1 => self.text(),
            2 => self.truth(),
            _ => self.numbers(),
        }
    }

    /// A call of a function that gives this, with arguments as its signature names them.
    fn call(&mut self, gives: Gives) {
        let known: Vec<&Function> = all().filter(|function| function.gives == gives).collect();
        let function = known[self.pick(known.len())];
        self.put(function.name);
        let count = function.arity.0 + self.pick(function.arity.1.min(function.arity.0 + 3) - function.arity.0 + 1);
        if function.arity.1 == 0 {
            return;
        }
        let names = function.signature.trim_matches(['(', ')']);
        let mut names = names.split(',').map(str::trim);
        self.put("(");
        for index in 0..count {
            self.put(if index > 0 { ", " } else { "" });
            let name = names.next().unwrap_or_default();
            self.argument_named(function, index, name);
        }
        self.put(")");
    }

    fn argument_named(&mut self, function: &Function, index: usize, name: &str) {
        let is = |words: &[&str]| words.iter().any(|word| name.to_lowercase().contains(word));
        if index < function.words_within && !function.words.is_empty() && (name.contains('|') || self.chance()) {
            let word = function.words[self.pick(function.words.len())];
            return self.put(word);
        }
        if self.depth > DEPTH {
            return self.put(if is(&["text", "list", "path", "name", "file"]) { "\"a\"" } else { "2" });
        }
        match () {
            () if is(&["array", "values", "elem", "matrix"]) => self.numbers(),
            () if is(&["text", "list", "path", "name", "file", "part", "colour", "color", "key", "item", "label"]) => {
                self.text();
            }
            () if is(&["value", "any"]) => self.any(),
            () if is(&["condition", "truth"]) => self.truth(),
            () => self.number(),
        }
    }
}
