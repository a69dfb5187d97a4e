//! The checked program: names are indices, arguments stand in the order of the parameters, nothing is left to look up.

use crate::check::reach;
use crate::diag::Span;
use crate::functions::Function as Builtin;
use crate::ops::Operation;
use crate::syntax::Source;
use crate::syntax::ast::{BinaryOp, SizeMark};
use crate::value::Value;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A rule file with everything it imports, ready to derive.
#[derive(Default)]
pub struct Program {
    /// The files, in order of loading; spans refer to them.
    pub sources: Vec<Source>,
    /// The names of rules and symbols.
    pub symbols: Vec<Arc<str>>,
    /// Every rule of every file.
    pub rules: Vec<Rule>,
    /// Every function of every file.
    pub functions: Vec<Function>,
    /// Every attribute and constant of every file; shapes hold their values in this order.
    pub attributes: Vec<Attribute>,
    /// The order in which attributes are evaluated: what another needs comes first.
    pub order: Vec<u32>,
    /// The rules of the main file that can begin: those without parameters, by name.
    pub starts: Vec<(Arc<str>, u32)>,
    /// `@Zone(kind, zone)` on rules of the main file.
    pub zones: Vec<Zone>,
    /// The main file's `start` rule or `@StartRule`.
    pub start: Option<u32>,
    /// Every label that is written in the rules; `None` among them stands for such as are made up on the way.
    pub labels: BTreeSet<Option<Arc<str>>>,
    /// Some rule asks what lies around a shape, so the engine keeps features and labels.
    pub looks_around: bool,
    /// Some rule asks for tags, so operations set theirs.
    pub asks_for_tags: bool,
    /// Some rule asks how shapes lie to each other, so the engine keeps what it builds as well.
    pub asks_for_solids: bool,
}

/// `@Zone(kind, zone)`: the rule begins on regions of that kind and zone.
pub struct Zone {
    /// The region's kind.
    pub kind: Arc<str>,
    /// Its zone; `None` takes every one.
    pub zone: Option<Arc<str>>,
    /// The rule.
    pub rule: u32,
}

/// A rule.
pub struct Rule {
    /// Its name.
    pub symbol: u32,
    /// How many parameters it has.
    pub params: usize,
    /// What it makes of a shape.
    pub body: Body,
    /// Where its name is written.
    pub span: Span,
}

/// A function of a file.
pub struct Function {
    /// Its name.
    pub name: Arc<str>,
    /// How many parameters it has.
    pub params: usize,
    /// Its value.
    pub value: Code,
    /// How high the tree of its value is: what a call takes of the stack.
    pub height: usize,
    /// Where its name is written.
    pub span: Span,
}

/// An attribute or constant of a file.
pub struct Attribute {
    /// Its name, as `--set` and layouts say it; with the import's name before it where the file is imported.
    pub name: Arc<str>,
    /// Whether users and layouts may set it.
    pub public: bool,
    /// Its value where nobody sets it.
    pub initial: Code,
    /// What it holds, where that can be seen.
    pub kind: Kind,
    /// `@Context(radius)`: metres within which other lots have a share in its value.
    pub context: Option<f64>,
    /// `@Description`.
    pub description: Option<Arc<str>>,
    /// `@Range(min, max)`.
    pub range: Option<(f64, f64)>,
    /// `@Enum(…)` or `@Range("a", "b")`.
    pub choices: Vec<Value>,
    /// Where its name is written.
    pub span: Span,
}

/// What an expression gives, as far as it can be seen before derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A truth value.
    Truth,
    /// A text.
    Text,
    /// An array of numbers.
    Numbers,
    /// An array of truth values.
    Truths,
    /// An array of texts.
    Texts,
    /// Not known before derivation.
    Unknown,
}

/// A checked expression.
#[derive(Clone)]
pub enum Code {
    /// A value.
    Value(Value),
    /// A parameter or local of the rule or function, by position.
    Param(u32),
    /// An attribute, by slot.
    Attribute(u32),
    /// A function of a file.
    Function(u32, Box<[Code]>),
    /// A built-in function or shape attribute.
    Builtin(&'static Builtin, Box<[Code]>, Span),
    /// `'x`, `~x`.
    Sized(SizeMark, Box<Code>, Span),
    /// `-x`.
    Negate(Box<Code>, Span),
    /// `!x`.
    Not(Box<Code>, Span),
    /// `a && b`: the right side is evaluated where the left is true.
    And(Box<(Code, Code)>, Span),
    /// `a || b`: the right side is evaluated where the left is false.
    Or(Box<(Code, Code)>, Span),
    /// Sums, products, comparisons.
    Binary(BinaryOp, Box<(Code, Code)>, Span),
    /// `case`.
    Case(Box<[(Code, Code)]>, Box<Code>, Span),
    /// `30% :`.
    Chance(Box<[(Code, Code)]>, Box<Code>, Span),
}

/// A checked successor.
pub enum Body {
    /// From left to right.
    Steps(Box<[Step]>),
    /// The first whose condition holds.
    Case(Box<[(Code, Body)]>, Box<Body>, Span),
    /// One by percentages.
    Chance(Box<[(Code, Body)]>, Box<Body>, Span),
    /// The papers' alternatives: of those whose condition holds one by probability.
    Alternatives(Box<[Alternative]>),
}

/// One of several rules with the same predecessor.
pub struct Alternative {
    /// The guard.
    pub condition: Option<Code>,
    /// The weight; the first that holds is taken where no alternative has one.
    pub probability: Option<Code>,
    /// The successor.
    pub body: Body,
    /// Where it is written.
    pub span: Span,
}

/// One step of a successor.
pub enum Step {
    /// An operation.
    Apply(Box<Application>),
    /// A successor: a rule, or a leaf where there is none.
    Successor(Successor),
    /// `[ … ]`.
    Push(Body),
    /// `NIL`.
    Delete,
}

/// An operation with its arguments.
pub struct Application {
    /// The operation.
    pub operation: &'static Operation,
    /// One per parameter.
    pub args: Box<[Option<Code>]>,
    /// Where each argument is written; the operation's own place where there is none.
    pub arg_spans: Box<[Span]>,
    /// The block.
    pub block: Block,
    /// The bodies that the block's entries lead to.
    pub bodies: Box<[Body]>,
    /// Where it is written.
    pub span: Span,
}

/// A checked block; entries refer to the application's bodies.
pub enum Block {
    /// No block.
    None,
    /// Sizes.
    Cuts(Box<[Cut]>),
    /// Selectors.
    Selectors(Box<[Selector]>),
    /// One body for all children.
    Body,
}

/// An entry of a split block.
pub enum Cut {
    /// `size : body`.
    Piece(Code, u16, Span),
    /// `{ … }*`.
    Repeat(Box<[Cut]>),
    /// `{ … }` inside another.
    Group(Box<[Cut]>),
}

/// An entry of a selector block.
pub struct Selector {
    /// What it asks for.
    pub test: Test,
    /// `=`: all in one shape.
    pub together: bool,
}

/// What a selector asks for.
pub enum Test {
    /// A word.
    Word(Arc<str>),
    /// `remainder`: what no edge has taken.
    Remainder,
    /// A number: that component, from the end where negative.
    Index(Code),
    /// A condition on the component.
    Condition(Code),
}

/// A successor shape.
pub struct Successor {
    /// Its symbol.
    pub symbol: u32,
    /// Its rule; a leaf where there is none.
    pub rule: Option<u32>,
    /// Its arguments.
    pub args: Box<[Code]>,
    /// Where it is written.
    pub span: Span,
}

impl Program {
    /// The attributes that users may set: slot and declaration.
    pub fn public_attributes(&self) -> impl Iterator<Item = (usize, &Attribute)> {
        self.attributes.iter().enumerate().filter(|(_, a)| a.public)
    }

    /// The slot of a public attribute: by its whole name, or by its own where only one import has it.
    pub fn slot(&self, name: &str) -> Option<usize> {
        let exact = self.public_attributes().find(|(_, a)| &*a.name == name);
        let mut own = self.public_attributes().filter(|(_, a)| a.names().last() == Some(name));
        let only = own.next().filter(|_| own.next().is_none());
        exact.or(only).map(|(slot, _)| slot)
    }

    /// The attributes that a rule and all that can come of it read, by slot.
    pub fn attributes_of(&self, rule: u32) -> BTreeSet<u32> {
        reach::attributes_of(self, rule)
    }

    /// A rule as a step of a trace.
    pub fn rule_step(&self, rule: u32) -> crate::diag::Step {
        let rule = &self.rules[rule as usize];
        crate::diag::Step { rule: self.symbols[rule.symbol as usize].clone(), span: rule.span }
    }

    /// The rule of the main file that can begin under this name.
    pub fn start_named(&self, name: &str) -> Option<u32> {
        self.starts.iter().find(|(n, _)| &**n == name).map(|(_, rule)| *rule)
    }
}

impl Application {
    /// Where the argument of a parameter is written.
    pub fn argument_span(&self, parameter: &str) -> Option<Span> {
        let index = self.operation.spec.params.iter().position(|p| p.name == parameter)?;
        self.arg_spans.get(index).copied()
    }
}

impl Attribute {
    /// What it is called, the import's name first, and then without it: `bosquet.room`, `room`.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let own = self.name.rsplit('.').next().unwrap_or(&self.name);
        [&*self.name, own].into_iter()
    }
}

impl Code {
    /// The expressions directly inside.
    pub fn parts(&self) -> Vec<&Code> {
        match self {
            Code::Value(_) | Code::Param(_) | Code::Attribute(_) => Vec::new(),
            Code::Function(_, args) | Code::Builtin(_, args, _) => args.iter().collect(),
            Code::Sized(_, inner, _) | Code::Negate(inner, _) | Code::Not(inner, _) => vec![inner],
            Code::And(pair, _) | Code::Or(pair, _) | Code::Binary(_, pair, _) => vec![&pair.0, &pair.1],
            Code::Case(arms, otherwise, _) | Code::Chance(arms, otherwise, _) => {
                arms.iter().flat_map(|(test, value)| [test, value]).chain([&**otherwise]).collect()
            }
        }
    }

    /// How high its tree is.
    pub fn height(&self) -> usize {
        1 + self.parts().into_iter().map(Code::height).max().unwrap_or(0)
    }

    /// The value, where it is known before derivation.
    pub fn known(&self) -> Option<&Value> {
        match self {
            Code::Value(value) => Some(value),
            _ => None,
        }
    }
}
