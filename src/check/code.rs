//! Checked expressions: names are indices, what can be known before derivation is folded.

use crate::check::program::Selector;
use crate::diag::Span;
use crate::functions::Function as Builtin;
use crate::ops::Operation;
use crate::syntax::ast::{BinaryOp, SizeMark};
use crate::value::Value;

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

impl Kind {
    /// What messages call it.
    pub fn words(self) -> &'static str {
        match self {
            Kind::Number => "a number",
            Kind::Truth => "a truth value",
            Kind::Text => "a text",
            Kind::Numbers => "an array of numbers",
            Kind::Truths => "an array of truth values",
            Kind::Texts => "an array of texts",
            Kind::Unknown => "a value",
        }
    }
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
    /// `[a, b; c, d]`: rows of elements.
    Array(Box<[Box<[Code]>]>, Span),
    /// `from : to`, `from : step : to`.
    Range(Box<(Code, Option<Code>, Code)>, Span),
    /// `a[i]`, `a[row, column]`.
    Index(Box<Code>, Box<[Code]>, Span),
    /// `a .+ b`.
    Each(BinaryOp, Box<(Code, Code)>, Span),
    /// `comp(e) { front = 3 | all : 0 }`.
    Comp(Box<Measure>),
    /// `with`: locals, which follow the parameters, and the value that uses them.
    With(Box<[Code]>, Box<Code>),
    /// `attr name(index) = value`: the attribute's own value at that index, or the expression where it has none.
    Listed(u32, Box<Code>),
}

/// `comp` as a function: a value for each component.
#[derive(Clone)]
pub struct Measure {
    /// The operation that takes the shape apart.
    pub operation: &'static Operation,
    /// One per parameter.
    pub args: Box<[Option<Code>]>,
    /// Which components have which value.
    pub selectors: Box<[Selector]>,
    /// One for each selector.
    pub values: Box<[Code]>,
    /// Where it is written.
    pub span: Span,
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
            Code::Array(rows, _) => rows.iter().flatten().collect(),
            Code::Range(range, _) => [&range.0, &range.2].into_iter().chain(&range.1).collect(),
            Code::Index(array, indices, _) => [&**array].into_iter().chain(indices).collect(),
            Code::Each(_, pair, _) => vec![&pair.0, &pair.1],
            Code::Comp(measure) => measure.parts(),
            Code::With(locals, value) => locals.iter().chain([&**value]).collect(),
            Code::Listed(_, otherwise) => vec![otherwise],
        }
    }

    /// How high its tree is: what its evaluation takes of the stack. `comp` takes several levels at once.
    pub fn height(&self) -> usize {
        let own = if matches!(self, Code::Comp(_)) { 6 } else { 1 };
        own + self.parts().into_iter().map(Code::height).max().unwrap_or(0)
    }

    /// The attribute that it reads itself, by slot.
    pub fn slot(&self) -> Option<u32> {
        match self {
            Code::Attribute(slot) | Code::Listed(slot, _) => Some(*slot),
            _ => None,
        }
    }

    /// The value, where it is known before derivation.
    pub fn known(&self) -> Option<&Value> {
        match self {
            Code::Value(value) => Some(value),
            _ => None,
        }
    }
}

impl Measure {
    fn parts(&self) -> Vec<&Code> {
        let args = self.args.iter().flatten();
        args.chain(self.selectors.iter().filter_map(|selector| selector.test.code())).chain(&self.values).collect()
    }
}

impl Kind {
    /// The array of it; of an array itself.
    pub fn array(self) -> Kind {
        match self {
            Kind::Number | Kind::Numbers => Kind::Numbers,
            Kind::Truth | Kind::Truths => Kind::Truths,
            Kind::Text | Kind::Texts => Kind::Texts,
            Kind::Unknown => Kind::Unknown,
        }
    }

    /// What an array of it holds; itself where it is none.
    pub fn element(self) -> Kind {
        match self {
            Kind::Number | Kind::Numbers => Kind::Number,
            Kind::Truth | Kind::Truths => Kind::Truth,
            Kind::Text | Kind::Texts => Kind::Text,
            Kind::Unknown => Kind::Unknown,
        }
    }

    /// Whether it is known to be an array.
    pub fn is_array(self) -> bool {
        matches!(self, Kind::Numbers | Kind::Truths | Kind::Texts)
    }
}
