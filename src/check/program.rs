//! The checked program: names are indices, arguments stand in the order of the parameters, nothing is left to look up.

use crate::check::code::{Code, Kind};
use crate::check::reach;
use crate::diag::Span;
use crate::ops::{Component, Gather, Given, Operation, Pieces, Problem, Ready};
use crate::shape::Shape;
use crate::syntax::Source;
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
    /// The styles of the main file beside `Default`, in the order of the text.
    pub styles: Vec<Arc<str>>,
    /// Every label that is written in the rules; `None` among them stands for such as are made up on the way.
    pub labels: BTreeSet<Option<Arc<str>>>,
    /// Some rule asks what lies around a shape, so the engine keeps features and labels.
    pub looks_around: bool,
    /// Some rule asks for tags, so operations set theirs.
    pub asks_for_tags: bool,
    /// Some rule asks which selector took a component, so the engine notes it.
    pub asks_for_selectors: bool,
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
    /// The names of its parameters and locals; those of the last alternative in the papers' notation.
    pub names: Box<[Arc<str>]>,
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
    /// `restricted = false`: it may have other values than the choices.
    pub is_open: bool,
    /// Where its name is written.
    pub span: Span,
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
    /// `with`: locals, which follow the parameters, and the body that uses them.
    With(Box<[Code]>, Box<Body>),
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
    /// The operation with its arguments, where all are known before derivation.
    pub ready: Option<Box<dyn Ready>>,
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
    /// Bands of a perimeter.
    Perimeter {
        /// Their lengths.
        cuts: Box<[Cut]>,
        /// Their depths, by entry, each with its place.
        depths: Box<[(Code, Span)]>,
        /// Who takes what they leave.
        rest: Box<[Selector]>,
    },
    /// Selectors.
    Selectors(Box<[Selector]>),
    /// One body for all children.
    Body,
    /// Bodies that are derived inside the rule.
    Operands,
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
#[derive(Clone)]
pub struct Selector {
    /// What it asks for.
    pub test: Test,
    /// Which of its components become one shape.
    pub gather: Gather,
}

/// What a selector asks for.
#[derive(Clone)]
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
    /// `import(name = value).Rule`: the attributes that are found anew.
    pub fresh: Option<Box<Fresh>>,
    /// Where it is written.
    pub span: Span,
}

/// What a dynamic import finds anew for one call, by slot.
pub struct Fresh {
    /// The values in its parentheses, in the names of the caller.
    pub given: Box<[(u32, Code)]>,
    /// Every other attribute of the import and of its own imports, in the order in which they need each other.
    pub anew: Box<[(u32, Renewed)]>,
}

/// Where a fresh value comes from.
pub enum Renewed {
    /// The attribute's own initial value.
    Initial,
    /// The file's own expression, since the parentheses protect it from the importer's attribute of that name.
    Protected(Code),
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
    /// The word of the selector that an entry of the block stands for, where it is one.
    pub fn selector(&self, entry: u16) -> Option<Arc<str>> {
        let Block::Selectors(selectors) = &self.block else { return None };
        match &selectors.get(usize::from(entry))?.test {
            Test::Word(word) => Some(word.clone()),
            Test::Remainder => Some("remainder".into()),
            Test::Index(_) | Test::Condition(_) => None,
        }
    }

    /// The operation with its arguments, where all of them are known.
    pub fn ready(operation: &Operation, args: &[Option<Code>]) -> Option<Box<dyn Ready>> {
        let known = |arg: &Option<Code>| match arg {
            Some(code) => code.known().cloned().map(Some),
            None => Some(None),
        };
        let mut values: Vec<Option<Value>> = args.iter().map(known).collect::<Option<_>>()?;
        operation.ready(&mut values)
    }

    /// The components for the selectors; `values` are used up where the arguments were not known.
    pub fn components(&self, values: &mut [Option<Value>], shape: &Shape) -> Result<Vec<Component>, Problem> {
        match &self.ready {
            Some(ready) => ready.components(shape),
            None => self.operation.components(values, shape),
        }
    }

    /// The entry of each section of a perimeter, `most` at most; `values` are used up where the arguments were not known.
    pub fn sections(
        &self,
        values: &mut [Option<Value>],
        shape: &Shape,
        cuts: &[crate::ops::Cut],
        most: usize,
    ) -> Result<Vec<u16>, Problem> {
        match &self.ready {
            Some(ready) => ready.sections(shape, cuts, most),
            None => self.operation.sections(values, shape, cuts, most),
        }
    }

    /// Changes the shape or gives its pieces; `values` are used up where the arguments were not known.
    pub fn apply(&self, values: &mut [Option<Value>], shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        match &self.ready {
            Some(ready) => ready.apply(shape, given),
            None => self.operation.apply(values, shape, given),
        }
    }

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

impl Test {
    /// The expression that it asks with.
    pub fn code(&self) -> Option<&Code> {
        match self {
            Test::Index(code) | Test::Condition(code) => Some(code),
            Test::Word(_) | Test::Remainder => None,
        }
    }
}
