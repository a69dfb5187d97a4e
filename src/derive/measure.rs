//! `comp` as a function: an expression on each component of a shape → an array in the order of the components.
//!
//! What no selector takes has 0, `false` or an empty text. After `=` the value is found once, on all taken components
//! put together, and stands for each of them. `comp.index` and `comp.total` count what an entry has taken.

use crate::check::Measure;
use crate::derive::evaluate::{Failure, Names, evaluate, reborrow};
use crate::derive::select;
use crate::functions::Surroundings;
use crate::ops::{self, Component, Gather, Problem};
use crate::shape::Shape;
use crate::value::{Array, Cells, MOST_CELLS, Value};
use smallvec::SmallVec;
use std::sync::Arc;

/// The values of all components.
#[inline(never)]
pub(super) fn measure(measure: &Measure, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    let mut args: SmallVec<[Option<Value>; 2]> = SmallVec::new();
    for arg in &measure.args {
        args.push(arg.as_ref().map(|code| evaluate(code, names, around)).transpose()?);
    }
    let components = measure.operation.components(&mut args, around.shape);
    let mut components = components.and_then(within_limit).map_err(|problem| failure(measure, problem.message))?;
    let chosen = select::choose(&measure.selectors, &components, names, around)?;
    let taken = chosen.iter().zip(&mut components);
    ops::count(taken.filter_map(|(choice, component)| Some(((*choice)?.entry, &mut component.shape))));
    let mut values: Vec<Option<Value>> = vec![None; components.len()];
    for (entry, code) in measure.values.iter().enumerate() {
        let taken = |index: &usize| chosen[*index].is_some_and(|choice| usize::from(choice.entry) == entry);
        let taken: Vec<usize> = (0..components.len()).filter(taken).collect();
        if measure.selectors[entry].gather != Gather::Each {
            let Some(shape) = together(around.shape, &components, &taken) else { continue };
            let value = on(&shape, code, names, around)?;
            taken.iter().for_each(|index| values[*index] = Some(value.clone()));
            continue;
        }
        for index in taken {
            values[index] = Some(on(&components[index].shape, code, names, around)?);
        }
    }
    filled(values).map(|cells| Value::Array(Arc::new(Array::row(cells)))).map_err(|message| failure(measure, message))
}

fn failure(measure: &Measure, message: String) -> Failure {
    Failure { span: measure.span, message }
}

fn within_limit(components: Vec<Component>) -> Result<Vec<Component>, Problem> {
    match components.len() > MOST_CELLS {
        true => Err(Problem::new(format!(
            "{} components are more than the limit `array` of {MOST_CELLS}",
            components.len()
        ))),
        false => Ok(components),
    }
}

fn on(shape: &Shape, code: &crate::check::Code, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    evaluate(code, names, &mut Surroundings { shape, ..reborrow(around) })
}

/// The taken components as one shape: the faces, or, since edges and points cannot be put together, the first of them.
fn together(parent: &Shape, components: &[Component], taken: &[usize]) -> Option<Shape> {
    let shapes: Vec<Shape> = taken.iter().map(|index| components[*index].shape.clone()).collect();
    let first = shapes.first()?.clone();
    let joined = ops::joined(parent, &shapes, Gather::All).ok().and_then(|joined| joined.into_iter().next());
    let mut shape = joined.unwrap_or(first);
    shape.ordinals.comp = (0, 1);
    Some(shape)
}

/// Values of one type; what is missing is empty.
fn filled(values: Vec<Option<Value>>) -> Result<Cells, String> {
    let empty = match values.iter().flatten().next() {
        Some(Value::Bool(_)) => Value::Bool(false),
        Some(Value::Text(_) | Value::Word(_)) => Value::text(""),
        _ => Value::Float(0.0),
    };
    Cells::of(values.into_iter().map(|value| value.unwrap_or_else(|| empty.clone())).collect())
        .map_err(|message| format!("the array {message}"))
}
