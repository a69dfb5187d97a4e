//! The papers' operations in CityEngine's terms.
//!
//! Müller et al. 2006 and Ulmer et al. 2007 write `Subdiv(y, 7, 2r, 5){ A | B | A }`, `Repeat(x, 2){ A }`,
//! `Comp("faces"){ A }`, `T`, `S`, `Rx`, `I("id")`. Each becomes the call that CityEngine would write, marked
//! [`Spelling::Paper`]; where it has no such counterpart (`Distr`, `I` with three arguments) it stays what it is. A
//! rule of the file's own by one of these names wins over the papers' meaning.

use super::ast::{Arg, Block, Call, Content, Entry, Expr, ExprKind, Head, Separator, SizeMark, Spelling};
use super::build::Builder;
use crate::diag::{Diagnostic, Span};
use crate::text;

/// The names that mean an operation in the papers.
pub(super) const NAMES: [&str; 9] = ["Subdiv", "Repeat", "Comp", "T", "S", "Rx", "Ry", "Rz", "I"];

/// What `Comp` may take apart: the papers' word, CityEngine's, and its selector.
const COMPONENTS: [(&str, &str, &str); 12] = [
    ("faces", "f", "all"),
    ("face", "f", "all"),
    ("f", "f", "all"),
    ("edges", "e", "all"),
    ("edge", "e", "all"),
    ("e", "e", "all"),
    ("vertices", "v", "all"),
    ("vertex", "v", "all"),
    ("v", "v", "all"),
    ("sidefaces", "f", "side"),
    ("topfaces", "f", "top"),
    ("bottomfaces", "f", "bottom"),
];

/// The call as CityEngine writes it; any call that is not one of the papers' comes back as it is.
pub(super) fn lowered<'t>(builder: &Builder<'t>, call: Call) -> Call {
    if builder.is_own(&call.name.text) {
        return call;
    }
    match (&*call.name.text, call.args.len(), call.blocks.len()) {
        ("Subdiv", 1.., 1) => subdivision(builder, call),
        ("Repeat", 1.., 1) => repetition(builder, call),
        ("Comp", 1.., 1) => components(builder, call),
        ("T", 3, 0) => renamed(builder, call, "t"),
        ("S", 3, 0) => renamed(builder, call, "s"),
        ("I", 1, 0) => renamed(builder, call, "i"),
        ("Rx", 1, 0) => rotation(builder, call, 0),
        ("Ry", 1, 0) => rotation(builder, call, 1),
        ("Rz", 1, 0) => rotation(builder, call, 2),
        _ => call,
    }
}

fn renamed<'t>(builder: &Builder<'t>, mut call: Call, name: &'static str) -> Call {
    call.name.text = builder.intern(name);
    call.spelling = Spelling::Paper;
    call
}

/// `Rx(a)` → `r(a, 0, 0)`
fn rotation(builder: &Builder<'_>, mut call: Call, axis: usize) -> Call {
    let end = Span { start: call.span.end, ..call.span };
    let zero = || Arg { name: None, value: Expr { kind: ExprKind::Number(0.0), span: end } };
    for index in (0..3).filter(|index| *index != axis) {
        call.args.insert(index, zero());
    }
    renamed(builder, call, "r")
}

/// `Subdiv(y, 7, 2r){ A | B }` → `split(y){ 7 : A | ~2 : B }`
fn subdivision(builder: &Builder<'_>, mut call: Call) -> Call {
    let sizes: Vec<Arg> = call.args.drain(1..).collect();
    let parts = call.blocks[0].entries.len();
    if sizes.len() != parts {
        let (sizes, parts) = (text::counted(sizes.len(), "size"), text::counted(parts, "part"));
        let message = format!("`Subdiv` has {sizes} for {parts}");
        let hint = "each part between the bars needs its size: `Subdiv(y, 7, 1r){ A | B }`";
        builder.report(Diagnostic::error("syntax-arguments", call.span, message).hint(hint));
        return call;
    }
    for (entry, size) in call.blocks[0].entries.iter_mut().zip(sizes) {
        give_head(builder, entry, size.value, "Subdiv");
    }
    axis(builder, &mut call);
    renamed(builder, call, "split")
}

/// `Repeat(x, 2){ A }` → `split(x){ ~2 : A }*`
fn repetition(builder: &Builder<'_>, mut call: Call) -> Call {
    let sizes: Vec<Arg> = call.args.drain(1..).collect();
    let parts = call.blocks[0].entries.len();
    if sizes.len() != 1 || parts != 1 {
        let (sizes, parts) = (text::counted(sizes.len(), "size"), text::counted(parts, "part"));
        let message = format!("`Repeat` has {sizes} and {parts}, and takes one of each");
        let hint = "write `Repeat(x, 2){ A }`, or `split(x){ ~2 : A | 1 : B }*` for more";
        builder.report(Diagnostic::error("syntax-arguments", call.span, message).hint(hint));
        return call;
    }
    for (entry, size) in call.blocks[0].entries.iter_mut().zip(sizes) {
        give_head(builder, entry, floating(size.value), "Repeat");
    }
    call.blocks[0].repeat = true;
    axis(builder, &mut call);
    renamed(builder, call, "split")
}

fn floating(size: Expr) -> Expr {
    match size.kind {
        ExprKind::Sized(..) => size,
        _ => Expr { span: size.span, kind: ExprKind::Sized(SizeMark::Floating, Box::new(size)) },
    }
}

fn give_head(builder: &Builder<'_>, entry: &mut Entry, key: Expr, name: &str) {
    if entry.head.is_some() || matches!(entry.content, Content::Block(_)) {
        let message = format!("the sizes of `{name}` stand in its parentheses, not before its parts");
        builder.report(Diagnostic::error("syntax-block", entry.span, message));
    }
    entry.head = Some(Head { key, depth: None, separator: Separator::Each });
}

/// `"Y"` → `y`; the papers' snap lines (`"YS"`) have no counterpart, which is said.
fn axis(builder: &Builder<'_>, call: &mut Call) {
    let Some(value) = call.args.first_mut().map(|arg| &mut arg.value) else { return };
    let Some(word) = word_of(value) else { return };
    let (axis, snaps) = match word {
        "x" | "X" => ("x", false),
        "y" | "Y" => ("y", false),
        "z" | "Z" => ("z", false),
        "XS" => ("x", true),
        "YS" => ("y", true),
        "ZS" => ("z", true),
        _ => return,
    };
    if snaps {
        let message = format!("snap lines are not supported; `{word}` is read as `{axis}`");
        builder.report(Diagnostic::lint("syntax-arguments", value.span, message));
    }
    value.kind = ExprKind::Call(builder.intern(axis), None);
}

/// `Comp("sidefaces"){ A }` → `comp(f){ side : A }`; `Comp("edge", 3){ A }` → `comp(e){ 3 : A }`
fn components(builder: &Builder<'_>, mut call: Call) -> Call {
    let kind = call.args[0].value.clone();
    let Some(word) = word_of(&kind) else { return renamed(builder, call, "comp") };
    let Some((_, letter, selector)) = COMPONENTS.iter().find(|(name, ..)| *name == word) else {
        return unknown_components(builder, call, word, kind.span);
    };
    let index = (call.args.len() == 2).then(|| call.args.pop()).flatten();
    let selector = match index {
        Some(index) => index.value,
        None => Expr { kind: ExprKind::Call(builder.intern(selector), None), span: kind.span },
    };
    call.args[0].value.kind = ExprKind::Call(builder.intern(letter), None);
    select(builder, &mut call.blocks[0], selector);
    renamed(builder, call, "comp")
}

/// Gives the parts of a `Comp` their selector, unless they bring their own.
fn select(builder: &Builder<'_>, block: &mut Block, selector: Expr) {
    if block.entries.iter().any(|entry| entry.head.is_some()) {
        return;
    }
    if let [_, second, ..] = &block.entries[..] {
        let message = "`Comp` gives all components to one part, and here are several";
        let hint = "with several parts each needs its selector: `comp(f){ top : A | side : B }`";
        builder.report(Diagnostic::error("syntax-arguments", second.span, message).hint(hint));
    }
    for entry in &mut block.entries {
        let key = selector.clone();
        entry.head = Some(Head { key, depth: None, separator: Separator::Each });
    }
}

fn unknown_components<'t>(builder: &Builder<'t>, call: Call, word: &str, span: Span) -> Call {
    let likely = text::nearest(word, COMPONENTS.iter().map(|(name, ..)| *name));
    let message = format!("`Comp` knows no components called `{word}`");
    let hint = "it knows `faces`, `sidefaces`, `topfaces`, `bottomfaces`, `edges` and `vertices`";
    let report = Diagnostic::error("syntax-arguments", span, message);
    builder.report(report.did_you_mean(likely).hint(hint));
    call
}

/// A bare name, or a text: the papers print both.
fn word_of(value: &Expr) -> Option<&str> {
    match &value.kind {
        ExprKind::Text(word) | ExprKind::Call(word, None) => Some(word),
        _ => None,
    }
}
