//! What an operation declares about itself: read by the checker, the engine, the manual, the editor and the tests.

use crate::value::{Array, Cells, Size, Value};
use std::sync::Arc;

/// The declaration of an operation or function.
#[derive(Debug)]
pub struct Spec {
    /// How it is called.
    pub name: &'static str,
    /// The papers' or older names of the same operation.
    pub aliases: &'static [&'static str],
    /// The manual: first a sentence, then what is to know, with an example in a ```` ```cga ```` block.
    pub docs: &'static str,
    /// The parameters in order.
    pub params: &'static [Param],
    /// What follows the parentheses.
    pub block: BlockKind,
    /// Whose it is.
    pub origin: Origin,
}

/// One parameter.
#[derive(Debug)]
pub struct Param {
    /// Its name, for named arguments.
    pub name: &'static str,
    /// What it means, with its unit and the papers' symbol.
    pub docs: &'static str,
    /// What it takes.
    pub kind: ParamKind,
    /// The default as text; `None` where it must be given.
    pub default: Option<&'static str>,
    /// What is usual: numbers outside are allowed, with a lint.
    pub usual: Option<[f64; 2]>,
}

/// What a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParamKind {
    /// A plain number.
    Number,
    /// Metres.
    Metres,
    /// Degrees.
    Degrees,
    /// A share, 0 to 1.
    Share,
    /// Plants per square metre.
    PerArea,
    /// A whole number from 0.
    Count,
    /// Metres, or with `'` a share of the scope.
    Size,
    /// A text.
    Text,
    /// A text or a bare word.
    Word,
    /// `true` or `false`.
    Truth,
    /// One of these words. Where it has a default, an argument that is not a word skips it.
    Choice(&'static [&'static str]),
    /// A number from 0, from the end where negative, or one of these words.
    Index(&'static [&'static str]),
    /// The name of an attribute.
    Attribute,
    /// Anything.
    Any,
    /// Metres, or an array with a number of metres for each edge.
    PerEdge,
    /// An array of truth values.
    Truths,
    /// Metres, evaluated with each edge as the current shape.
    OnEdges,
    /// What the kind inside takes, also an expression of the position: it may vary over the shape.
    Varying(&'static ParamKind),
}

/// What follows an operation's parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKind {
    /// Nothing.
    None,
    /// `{ size : A | … }*`
    Cuts,
    /// `{ length : depth : A | … }*{ remainder : B }`
    Perimeter,
    /// `{ selector : A | … }`, and which words it adds to the usual ones.
    Selectors(&'static [&'static str]),
    /// `{ A }`: one successor for every child.
    Body,
    /// `{ A | B }`: so many successors, derived inside the rule.
    Operands(usize),
}

/// Where an operation comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// CityEngine has it under the same name: a rule of a file cannot shadow it.
    CityEngine,
    /// Ours or the papers': a rule, function or import of a file shadows it, with a lint.
    Added,
}

impl ParamKind {
    /// What messages and the manual call it.
    pub fn words(self) -> String {
        match self {
            ParamKind::Number => "a number".into(),
            ParamKind::Metres => "a number of metres".into(),
            ParamKind::Degrees => "a number of degrees".into(),
            ParamKind::Share => "a share from 0 to 1".into(),
            ParamKind::PerArea => "a number per square metre".into(),
            ParamKind::Count => "a whole number".into(),
            ParamKind::Size => "metres, or a share with `'`".into(),
            ParamKind::Text => "a text".into(),
            ParamKind::Word => "a word or a text".into(),
            ParamKind::Truth => "`true` or `false`".into(),
            ParamKind::Choice(words) => format!("one of {}", quoted(words)),
            ParamKind::Index(words) => format!("a number or one of {}", quoted(words)),
            ParamKind::Attribute => "the name of an attribute".into(),
            ParamKind::Any => "any value".into(),
            ParamKind::PerEdge => "metres, or an array with metres for each edge".into(),
            ParamKind::Truths => "an array of truth values".into(),
            ParamKind::OnEdges => "a number of metres, asked on each edge".into(),
            ParamKind::Varying(inner) => format!("{}; it may vary over the shape", inner.words()),
        }
    }

    /// Whether bare words stand for themselves here.
    pub fn takes_words(self) -> bool {
        use ParamKind as P;
        matches!(self, P::Word | P::Choice(_) | P::Index(_) | P::Attribute | P::Any)
    }

    /// Whether a value known before derivation can be right.
    pub fn accepts(self, value: &Value) -> bool {
        match (self, value) {
            (ParamKind::Any, _) => true,
            (ParamKind::Varying(inner), value) => inner.accepts(value),
            (ParamKind::Number | ParamKind::Metres | ParamKind::Degrees, Value::Float(_)) => true,
            (ParamKind::PerEdge | ParamKind::OnEdges, Value::Float(_)) => true,
            (ParamKind::Truths, Value::Array(array)) => matches!(array.cells(), Cells::Truths(_)),
            (ParamKind::PerEdge, Value::Array(array)) => matches!(array.cells(), Cells::Numbers(_)),
            (ParamKind::Share | ParamKind::PerArea, Value::Float(number)) => *number >= 0.0,
            (ParamKind::Count, Value::Float(number)) => *number >= 0.0,
            (ParamKind::Size, Value::Float(_) | Value::Size(Size::Absolute(_) | Size::Relative(_))) => true,
            (ParamKind::Text | ParamKind::Word, Value::Text(_)) => true,
            (ParamKind::Word | ParamKind::Attribute, Value::Word(_)) => true,
            (ParamKind::Attribute, Value::Text(_)) => true,
            (ParamKind::Truth, Value::Bool(_)) => true,
            (ParamKind::Choice(words) | ParamKind::Index(words), Value::Word(word) | Value::Text(word)) => {
                words.contains(&&**word)
            }
            (ParamKind::Index(_), Value::Float(_)) => true,
            _ => false,
        }
    }
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ")
}

/// A Rust type that a parameter can have.
pub trait Parameter: Sized {
    /// What it takes.
    const KIND: ParamKind;
    /// The value, where it fits.
    fn from_value(value: &Value) -> Option<Self>;
}

macro_rules! number_parameter {
    ($($type:ty, $kind:ident, $make:expr;)*) => {$(
        impl Parameter for $type {
            const KIND: ParamKind = ParamKind::$kind;
            fn from_value(value: &Value) -> Option<Self> {
                value.as_float().filter(|n| !n.is_nan()).map($make)
            }
        }
    )*};
}

number_parameter! {
    f64, Number, |n| n;
    crate::unit::Metres, Metres, crate::unit::Metres;
    crate::unit::Degrees, Degrees, crate::unit::Degrees;
    crate::unit::Share, Share, crate::unit::Share;
    crate::unit::PerArea, PerArea, crate::unit::PerArea;
}

impl Parameter for u32 {
    const KIND: ParamKind = ParamKind::Count;
    fn from_value(value: &Value) -> Option<Self> {
        let number = value.as_float().filter(|n| *n > -0.5)?;
        Some(number.round().min(f64::from(u32::MAX)) as u32)
    }
}

impl Parameter for Size {
    const KIND: ParamKind = ParamKind::Size;
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Float(number) => Some(Size::Absolute(*number)),
            Value::Size(size @ (Size::Absolute(_) | Size::Relative(_))) => Some(*size),
            _ => None,
        }
    }
}

impl Parameter for bool {
    const KIND: ParamKind = ParamKind::Truth;
    fn from_value(value: &Value) -> Option<Self> {
        value.as_bool()
    }
}

impl Parameter for Value {
    const KIND: ParamKind = ParamKind::Any;
    fn from_value(value: &Value) -> Option<Self> {
        Some(value.clone())
    }
}

/// What may be left out, without a default of its own.
impl<T: Parameter> Parameter for Option<T> {
    const KIND: ParamKind = T::KIND;
    fn from_value(value: &Value) -> Option<Self> {
        T::from_value(value).map(Some)
    }
}

/// A number that may vary over the shape; this is its value where it does not ([`crate::ops::Given::field`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Varying<T>(pub T);

impl<T: Parameter> Parameter for Varying<T> {
    const KIND: ParamKind = ParamKind::Varying(&T::KIND);
    fn from_value(value: &Value) -> Option<Self> {
        T::from_value(value).map(Varying)
    }
}

/// A number of metres for all edges, or an array with one for each.
#[derive(Clone, Debug, PartialEq)]
pub enum PerEdge {
    /// The same for all.
    Same(f64),
    /// One for each; 0 beyond the last.
    Each(Arc<Array>),
}

impl PerEdge {
    /// The distance of an edge.
    pub fn at(&self, edge: usize) -> f64 {
        match self {
            PerEdge::Same(metres) => *metres,
            PerEdge::Each(array) => array.at(edge).as_float().unwrap_or(0.0),
        }
    }

    /// Whether each edge has its own.
    pub fn is_array(&self) -> bool {
        matches!(self, PerEdge::Each(_))
    }
}

impl Parameter for PerEdge {
    const KIND: ParamKind = ParamKind::PerEdge;
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Array(array) => matches!(array.cells(), Cells::Numbers(_)).then(|| PerEdge::Each(array.clone())),
            value => value.as_float().filter(|n| !n.is_nan()).map(PerEdge::Same),
        }
    }
}

/// An array of truth values.
#[derive(Clone, Debug, PartialEq)]
pub struct Truths(Arc<Array>);

impl Truths {
    /// The value of that number; `false` beyond the last.
    pub fn at(&self, index: usize) -> bool {
        self.0.at(index).as_bool().unwrap_or(false)
    }
}

impl Parameter for Truths {
    const KIND: ParamKind = ParamKind::Truths;
    fn from_value(value: &Value) -> Option<Self> {
        let array = value.as_array().filter(|array| matches!(array.cells(), Cells::Truths(_)))?;
        Some(Truths(array.clone()))
    }
}

/// Metres by edge that the engine has asked on each; none while it asks for the edges.
#[derive(Clone, Debug, PartialEq)]
pub struct OnEdges(Arc<Array>);

impl OnEdges {
    /// The distance of an edge.
    pub fn at(&self, edge: usize) -> f64 {
        self.0.at(edge).as_float().unwrap_or(0.0)
    }
}

impl Parameter for OnEdges {
    const KIND: ParamKind = ParamKind::OnEdges;
    fn from_value(value: &Value) -> Option<Self> {
        value.as_array().cloned().map(OnEdges)
    }
}

/// A text or a bare word.
#[derive(Clone, Debug, PartialEq)]
pub struct Word(pub Arc<str>);

impl Parameter for Word {
    const KIND: ParamKind = ParamKind::Word;
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Text(text) | Value::Word(text) => Some(Word(text.clone())),
            Value::Float(_) => Some(Word(value.to_string().into())),
            _ => None,
        }
    }
}

/// An attribute, resolved by the checker.
#[derive(Clone, Debug, PartialEq)]
pub enum AttributeName {
    /// Of a rule file, by slot.
    Slot(usize),
    /// Of the shape, by name.
    Shape(Arc<str>),
}

impl Parameter for AttributeName {
    const KIND: ParamKind = ParamKind::Attribute;
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Float(slot) => Some(AttributeName::Slot(*slot as usize)),
            Value::Text(name) | Value::Word(name) => Some(AttributeName::Shape(name.clone())),
            _ => None,
        }
    }
}

/// Declares an enum whose variants are the words of a parameter.
macro_rules! choice {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$doc:meta])* $variant:ident = $word:literal),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        $vis enum $name { $($(#[$doc])* $variant),* }

        impl $crate::ops::Parameter for $name {
            const KIND: $crate::ops::ParamKind = $crate::ops::ParamKind::Choice(&[$($word),*]);
            fn from_value(value: &$crate::value::Value) -> Option<Self> {
                match value.as_str()? {
                    $($word => Some($name::$variant),)*
                    _ => None,
                }
            }
        }
    };
}
pub(crate) use choice;

impl Spec {
    /// How it is called, on one line: `setback(distance) { selector : A | remainder : B }`.
    pub fn usage(&self) -> String {
        let params: Vec<String> = self.params.iter().map(usage_of).collect();
        let block = match self.block {
            BlockKind::None => "",
            BlockKind::Cuts => " { size : A | size : B }",
            BlockKind::Perimeter => " { length : depth : A } { remainder : B }",
            BlockKind::Selectors(extra) if extra.contains(&"remainder") => " { selector : A | remainder : B }",
            BlockKind::Selectors(_) => " { selector : A }",
            BlockKind::Body | BlockKind::Operands(1) => " { A }",
            BlockKind::Operands(_) => " { A | B }",
        };
        format!("{}({}){block}", self.name, params.join(", "))
    }
}

fn usage_of(param: &Param) -> String {
    match param.default {
        Some(default) => format!("{} = {default}", param.name),
        None => param.name.into(),
    }
}
