//! What was probably meant: values that are right in kind and wrong in meaning (millimetres, per cent, radians), and
//! words of the catalogue with a slip of the pen.
//!
//! All of it is lints and hints: a place may have a catalogue of its own, and a cliff may be a kilometre high.

use crate::check::Checker;
use crate::check::code::Code;
use crate::diag::{Diagnostic, Span};
use crate::element::{Catalogue, NotFound};
use crate::ops::{Param, ParamKind, Spec};
use crate::syntax::ast::{Expr, ExprKind, SizeMark, UnaryOp};
use crate::text::number;
use crate::value::Value;

/// Lengths between these are millimetres rather than metres.
const MILLIMETRES: std::ops::RangeInclusive<f64> = 1e3..=1e6;

/// Angles below this that are no whole degrees are radians rather than degrees: half a turn.
const HALF_TURN: f64 = std::f64::consts::PI + 0.01;

impl Checker {
    /// A number that means something else in another unit.
    pub(super) fn unit(&mut self, param: &Param, found: f64, span: Span) {
        let (name, shown) = (param.name, number(found, 4));
        let (message, hint) = match inner(param.kind) {
            ParamKind::Metres | ParamKind::PerEdge | ParamKind::OnEdges if MILLIMETRES.contains(&found.abs()) => (
                format!("`{name}` is {shown} metres"),
                format!("lengths are metres: {shown} mm are `{}`", number(found / 1000.0, 4)),
            ),
            ParamKind::Degrees if found.abs() < HALF_TURN && found.fract() != 0.0 => {
                let degrees = number(found.to_degrees(), 1);
                (format!("`{name}` is {shown} degrees"), format!("{shown} in radians are `{degrees}` degrees"))
            }
            _ => return,
        };
        self.tell(Diagnostic::lint("usual", span, message).hint(hint));
    }

    /// A size in a split that no part can have.
    pub(super) fn part_size(&mut self, size: &Expr) {
        let (message, hint) = match &size.kind {
            ExprKind::Sized(SizeMark::Relative, share) => match share.kind {
                ExprKind::Number(times) if times > 1.0 => {
                    let percent = number(times / 100.0, 4);
                    let message = format!("a part of {} times the whole", number(times, 4));
                    (message, format!("a share is from 0 to 1: {} % are `'{percent}`", number(times, 4)))
                }
                _ => return,
            },
            ExprKind::Unary(UnaryOp::Minus, _) => {
                ("a size below 0 leaves no part".to_string(), "sizes are metres from 0 up".to_string())
            }
            _ => return,
        };
        self.tell(Diagnostic::lint("usual", size.span, message).hint(hint));
    }

    /// Names of plants, things, palettes and ground covers that are nearly those of the catalogue.
    pub(super) fn elements(&mut self, spec: &Spec, args: &[Option<Code>], spans: &[Span]) {
        let word = |index: usize| args.get(index).and_then(|code| code.as_ref()?.known()?.as_str());
        let at = |index: usize| spans.get(index).copied().unwrap_or_default();
        let mut found: Vec<(String, String, Span)> = Vec::new();
        match spec.name {
            "plant" => {
                found.extend(word(0).and_then(element).map(|(message, near)| (message, near, at(0))));
                found.extend(word(1).and_then(palette).map(|(message, near)| (message, near, at(1))));
            }
            "i" => found.extend(word(0).and_then(element).map(|(message, near)| (message, near, at(0)))),
            "I" => {
                found.extend(word(0).and_then(element).map(|(message, near)| (message, near, at(0))));
                found.extend(word(0).and_then(|name| variant(name, word(1)?)).map(|(m, near)| (m, near, at(1))));
            }
            "set" if word(0) == Some("material.name") => {
                found.extend(word(1).and_then(cover).map(|(message, near)| (message, near, at(1))));
            }
            _ => {}
        }
        for (message, near, span) in found {
            self.tell(Diagnostic::lint("catalogue", span, message).did_you_mean(Some(&near)));
        }
    }
}

/// What a share that was meant in per cent would be.
pub(super) fn percent(found: f64) -> Option<String> {
    let is_percent = found > 5.0 && found <= 100.0;
    is_percent.then(|| format!("{} % are `{}`", number(found, 4), number(found / 100.0, 4)))
}

/// What a text would be without its quotes, where a number is wanted.
pub(super) fn unquoted(kind: ParamKind, value: &Value) -> Option<String> {
    let text = value.as_str().filter(|text| text.parse::<f64>().is_ok())?;
    kind.accepts(&Value::Float(1.0)).then(|| format!("without quotes it is a number: `{text}`"))
}

/// Another parameter whose word that is.
pub(super) fn elsewhere(spec: &Spec, word: &str) -> Option<&'static str> {
    let has = |param: &&Param| matches!(param.kind, ParamKind::Choice(words) if words.contains(&word));
    spec.params.iter().find(has).map(|param| param.name)
}

fn inner(kind: ParamKind) -> ParamKind {
    match kind {
        ParamKind::Varying(inner) => *inner,
        kind => kind,
    }
}

fn element(name: &str) -> Option<(String, String)> {
    match Catalogue::built_in().find(name, "") {
        Err(NotFound::Element { suggestion: Some(near), .. }) => {
            Some((format!("the catalogue has no plant or thing `{name}`"), near))
        }
        _ => None,
    }
}

fn variant(name: &str, kind: &str) -> Option<(String, String)> {
    match Catalogue::built_in().find(name, kind) {
        Err(error @ NotFound::Variant { suggestion: Some(_), .. }) => {
            Some((error.to_string(), error.suggestion().unwrap_or_default().to_string()))
        }
        _ => None,
    }
}

fn palette(name: &str) -> Option<(String, String)> {
    let near = Catalogue::built_in().nearest_palette(name)?;
    let is_missing = Catalogue::built_in().palette(name).is_none();
    is_missing.then(|| (format!("the catalogue has no palette `{name}`"), near.to_string()))
}

fn cover(word: &str) -> Option<(String, String)> {
    let near = Catalogue::built_in().nearest_cover(word)?;
    let is_missing = Catalogue::built_in().cover(word).is_none();
    is_missing.then(|| (format!("the catalogue has no ground cover `{word}`"), near.to_string()))
}
