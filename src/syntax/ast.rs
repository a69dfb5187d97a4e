//! The syntax tree of a rule file: what was written, names unresolved, every node with its place.
//!
//! CityEngine's notation and the papers' give the same tree; what differs only in spelling is kept in [`Spelling`],
//! which equality ignores, so that a formatter can give each rule its own look back.

use crate::diag::Span;
use std::sync::Arc;

/// One rule file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// `version "2025.1"`.
    pub version: Option<Text>,
    /// The definitions in file order; broken ones are left out and reported.
    pub items: Vec<Item>,
}

/// A name with its place; `path.name` for what an import brings.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// As written, dots included.
    pub text: Arc<str>,
    /// Where.
    pub span: Span,
}

/// A text literal with its place, escapes resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The text.
    pub text: Arc<str>,
    /// Where, quotes included.
    pub span: Span,
}

/// One definition with the annotations before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// `@Range(min = 0, max = 1)` and its like, in order.
    pub annotations: Vec<Annotation>,
    /// What is defined.
    pub kind: ItemKind,
    /// From the first annotation to the end of the definition.
    pub span: Span,
}

/// What a definition defines.
#[derive(Clone, Debug, PartialEq)]
pub enum ItemKind {
    /// `import id (style) : "file.cga" (overrides)`.
    Import(Import),
    /// `attr`, `const` or a function.
    Function(Function),
    /// `Name(params) --> body`, or the papers' `id: Name : cond ~> body : prob`.
    Rule(Rule),
    /// `style S extends B`: everything after it, up to the next style, belongs to it.
    Style {
        /// The style.
        name: Name,
        /// The style it extends.
        base: Option<Name>,
    },
    /// Annotations that stand before nothing, at the end of a file or before `version`.
    Nothing,
}

/// `@Name(args)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Annotation {
    /// Without the `@`.
    pub name: Name,
    /// Positional and named arguments.
    pub args: Vec<Arg>,
    /// Where.
    pub span: Span,
}

/// `import id (style, …) : "file.cga" (overrides)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The name it is used by.
    pub name: Name,
    /// The styles it is restricted to.
    pub styles: Vec<Name>,
    /// The file.
    pub path: Text,
    /// `None` without parentheses; `Some([])` protects every attribute.
    pub overrides: Option<Vec<Override>>,
}

/// One entry in the parentheses of an import.
#[derive(Clone, Debug, PartialEq)]
pub enum Override {
    /// `name`: keep the imported file's own value.
    Protect(Name),
    /// `name = expr`.
    Attribute(Name, Expr),
    /// `Name(params) --> body`: a body for an extension rule.
    Rule(Box<Rule>),
}

/// `attr x = …`, `const x = …`, `const f(a) = …`, `f(a) = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Which of the three.
    pub kind: FunctionKind,
    /// Its name.
    pub name: Name,
    /// `None` without parentheses.
    pub params: Option<Vec<Name>>,
    /// `with ( a := expr … )`.
    pub locals: Vec<(Name, Expr)>,
    /// Its value.
    pub value: Expr,
}

/// When a definition is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionKind {
    /// Once per initial shape, before the start rule; users and layouts set it.
    Attr,
    /// The same, but not set from outside.
    Const,
    /// At each call, on the current shape.
    Function,
}

/// A production rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// `start` or `extension` before it.
    pub mark: Option<RuleMark>,
    /// The papers' `id:`.
    pub id: Option<Name>,
    /// The predecessor, possibly `import.Rule` (which redefines it).
    pub name: Name,
    /// `None` without parentheses.
    pub params: Option<Vec<Name>>,
    /// `with ( a := expr … )`.
    pub locals: Vec<(Name, Expr)>,
    /// The papers' guard.
    pub condition: Option<Expr>,
    /// The papers' `: prob`.
    pub probability: Option<Expr>,
    /// The successor.
    pub body: Body,
    /// Which notation.
    pub spelling: Spelling,
}

/// The word before a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RuleMark {
    /// `start R --> …`.
    Start,
    /// `extension R --> …`.
    Extension,
}

/// How something was written where two notations say the same. Always equal: it never changes the meaning.
#[derive(Clone, Copy, Debug, Default)]
pub enum Spelling {
    /// CityEngine's.
    #[default]
    Cga,
    /// The papers': `~>`, `Subdiv`, `Repeat`, `Comp`, `1r`.
    Paper,
}

impl PartialEq for Spelling {
    fn eq(&self, _: &Spelling) -> bool {
        true
    }
}

/// A successor.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// Operations and symbols from left to right; empty is allowed.
    Ops(Vec<Op>),
    /// `case c : … else : …`.
    Case {
        /// Conditions and what they lead to, in order.
        arms: Vec<(Expr, Body)>,
        /// The `else` part.
        otherwise: Box<Body>,
    },
    /// `30% : … else : …`.
    Chance {
        /// Percentages and what they lead to, in order.
        arms: Vec<(Expr, Body)>,
        /// The `else` part.
        otherwise: Box<Body>,
    },
}

/// One thing in a successor.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// An operation, a rule call or a leaf: names decide later.
    Call(Call),
    /// `import(h = 3).Rule(args)`.
    Dynamic {
        /// The import.
        import: Name,
        /// Attributes for this call.
        overrides: Vec<Override>,
        /// The rule with its arguments.
        call: Call,
    },
    /// `[ … ]`.
    Push(Body, Span),
    /// `inline(mode) target`.
    Inline {
        /// `append`, `unify`, `recompose`.
        mode: Vec<Arg>,
        /// What is derived in place: one call, or the operations between braces.
        target: Vec<Op>,
        /// Where.
        span: Span,
    },
}

/// `name(args) { block }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// The operation or symbol, in CityEngine's spelling (`split` also where `Subdiv` was written).
    pub name: Name,
    /// The arguments; empty with and without parentheses.
    pub args: Vec<Arg>,
    /// The blocks after it (`splitAndSetbackPerimeter` has two).
    pub blocks: Vec<Block>,
    /// Written with a dot at the end: a leaf by intention.
    pub leaf: bool,
    /// Which notation.
    pub spelling: Spelling,
    /// From the name to the end of the last block.
    pub span: Span,
}

/// An argument: `expr`, `name = expr`.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// The parameter, where it is named.
    pub name: Option<Name>,
    /// The value.
    pub value: Expr,
}

/// `{ head : body | … }*`.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The alternatives between the bars.
    pub entries: Vec<Entry>,
    /// A `*` follows the brace.
    pub repeat: bool,
    /// From brace to brace.
    pub span: Span,
}

/// One alternative of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Size or selector before the separator; none in `scatter(…) { Tree }`.
    pub head: Option<Head>,
    /// What becomes of the piece.
    pub content: Content,
    /// Where.
    pub span: Span,
}

/// `~3 :`, `front =`, `'0.5 : 2 :`.
#[derive(Clone, Debug, PartialEq)]
pub struct Head {
    /// A size ([`ExprKind::Sized`] with `'`, `~`, `r`), a selector, an index or a condition.
    pub key: Expr,
    /// The second size of a perimeter split.
    pub depth: Option<Expr>,
    /// What separates it from the body.
    pub separator: Separator,
}

/// How the selected components are handed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// `:` one shape each.
    Each,
    /// `=` all in one shape.
    All,
    /// `=:` one shape per connected set.
    Connected,
}

/// The content of an alternative.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A successor.
    Body(Body),
    /// A nested split block, `{ … }*`.
    Block(Block),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where.
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `3`, `.5`, `3e3`.
    Number(f64),
    /// `"…"`.
    Text(Arc<str>),
    /// `true`, `false`.
    Bool(bool),
    /// A name or a call, possibly qualified; `None` without parentheses.
    Call(Arc<str>, Option<Vec<Arg>>),
    /// `'x`, `~x`, `1r`.
    Sized(SizeMark, Box<Expr>),
    /// `-x`, `+x`, `!x`.
    Unary(UnaryOp, Box<Expr>),
    /// `a + b`; `elementwise` for `a .+ b`.
    Binary {
        /// The operator.
        op: BinaryOp,
        /// With a leading dot.
        elementwise: bool,
        /// Left operand.
        left: Box<Expr>,
        /// Right operand.
        right: Box<Expr>,
    },
    /// `a[i]`, `a[r, c]`.
    Index(Box<Expr>, Vec<Expr>),
    /// `[1, 2; 3, 4]`, rows of elements.
    Array(Vec<Vec<Expr>>),
    /// `1 : 2 : 9` in an array or index.
    Range {
        /// First value.
        from: Box<Expr>,
        /// Step, where three are given.
        step: Option<Box<Expr>>,
        /// Last value.
        to: Box<Expr>,
    },
    /// `comp(fe) { front = 3 | all : 0 }`, the function.
    Comp {
        /// The arguments.
        args: Vec<Arg>,
        /// Selectors and values.
        entries: Vec<(Expr, Separator, Expr)>,
    },
    /// `case c : a else : b`.
    Case {
        /// Conditions and values.
        arms: Vec<(Expr, Expr)>,
        /// The `else` value.
        otherwise: Box<Expr>,
    },
    /// `30% : a else : b`.
    Chance {
        /// Percentages and values.
        arms: Vec<(Expr, Expr)>,
        /// The `else` value.
        otherwise: Box<Expr>,
    },
}

/// The mark of a size that is not in metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeMark {
    /// `'`: a share of the scope.
    Relative,
    /// `~`, or the papers' `r`: a weight in what is left over.
    Floating,
}

/// Prefix operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Minus,
    /// `+`
    Plus,
    /// `!`
    Not,
}

/// Infix operators, by rising precedence: or, and, comparisons, sums, products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `||`
    Or,
    /// `&&`
    And,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `%`
    Remainder,
}
