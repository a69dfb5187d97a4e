//! Blocks on a shape: sizes of splits evaluated, components given to the selectors that ask for them.

use crate::check::{Cut, Selector, Test};
use crate::derive::evaluate::{Failure, Names, evaluate, number, reborrow};
use crate::derive::frame::Frame;
use crate::functions::Surroundings;
use crate::ops::{self, Choice, Component, Selectors};
use crate::shape::Shape;
use crate::value::{Size, Value};

/// The sizes of a split block on the current shape.
pub(super) fn cuts(cuts: &[Cut], frame: &mut Frame) -> Result<Vec<ops::Cut>, Failure> {
    cuts.iter()
        .map(|cut| {
            Ok(match cut {
                Cut::Piece(size, entry, span) => {
                    let value = frame.with(|names, around| evaluate(size, names, around))?;
                    let size = match value {
                        Value::Size(size) => size,
                        Value::Float(metres) => Size::Absolute(metres),
                        other => {
                            let message = format!("a size must be a number, found {} `{other}`", other.type_name());
                            return Err(Failure { span: *span, message });
                        }
                    };
                    ops::Cut::Piece(size, *entry)
                }
                Cut::Repeat(inner) => ops::Cut::Repeat(self::cuts(inner, frame)?),
                Cut::Group(inner) => ops::Cut::Group(self::cuts(inner, frame)?),
            })
        })
        .collect()
}

/// The selector that takes each component: the first that asks for it.
pub(super) fn choose(
    selectors: &[Selector],
    components: &[Component],
    names: &Names,
    around: &mut Surroundings,
) -> Result<Vec<Option<Choice>>, Failure> {
    let mut chosen = vec![None; components.len()];
    for (entry, selector) in selectors.iter().enumerate() {
        let choice = Choice { entry: entry as u16, gather: selector.gather };
        // What is left over answers to its own word alone: it has no number, and no condition takes it.
        let total = components.iter().filter(|component| !component.is_rest()).count();
        for (index, component) in components.iter().enumerate() {
            if chosen[index].is_none() && asks_for(selector, component, (index, total), names, around)? {
                chosen[index] = Some(choice);
            }
        }
    }
    Ok(chosen)
}

fn asks_for(
    selector: &Selector,
    component: &Component,
    (index, total): (usize, usize),
    names: &Names,
    around: &mut Surroundings,
) -> Result<bool, Failure> {
    match &selector.test {
        Test::Word(word) => Ok(Selectors::of_word(word).is_some_and(|s| component.selectors.meets(s))
            || component.words.contains(&&**word)),
        Test::Remainder => Ok(component.words.contains(&"remainder")),
        _ if component.is_rest() => Ok(false),
        Test::Index(code) => {
            let wanted = number(code, names, around, crate::diag::Span::default())?;
            let wanted = wanted.round();
            let wanted = if wanted < 0.0 { wanted + total as f64 } else { wanted };
            Ok(wanted == index as f64)
        }
        Test::Condition(code) => match evaluate(code, names, &mut on(&component.shape, around))? {
            Value::Bool(truth) => Ok(truth),
            // A computed index: `comp(e) { last : A }` with `last = 3`.
            value => Ok(value.as_float().is_some_and(|n| n.round() == index as f64)),
        },
    }
}

/// The same surroundings with a component for the current shape.
fn on<'s>(shape: &'s Shape, around: &'s mut Surroundings) -> Surroundings<'s> {
    Surroundings { shape, ..reborrow(around) }
}
