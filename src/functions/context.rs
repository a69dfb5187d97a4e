//! Context queries: how far, how many, and which in order.
//!
//! `intra` sees the features of the lot and what was labelled earlier in it, `inter` the neighbours' initial shapes
//! under the word of their kind. A query sees what stands at its moment, in the order of the text: what is to be found
//! has to be labelled before.

use crate::functions::args::text_at;
use crate::functions::{Function, Surroundings};
use crate::shape::{Footprint, Occluder};
use crate::value::Value;

const WORDS: &[&str] = &[
    "intra",
    "inter",
    "all",
    "world.northernmost",
    "world.southernmost",
    "world.easternmost",
    "world.westernmost",
    "world.highest",
    "world.lowest",
    "area.largest",
    "area.smallest",
];

pub(super) static LIST: &[Function] = &[
    Function::new(
        "minimumDistance",
        "(intra|inter|all, label)",
        (2, 2),
        "Distance to the nearest shape of that label (metres); infinite where there is none. What the shape comes from \
         does not count.",
        |args, around| {
            let label = text_at(args, 1)?;
            let own = around.shape.footprint();
            let within = || around.intra.nearest(&own, label, around.is_ancestor);
            let beyond = || around.inter.nearest(&own, label, &|_| false);
            let found = match target(args)? {
                "intra" => within(),
                "inter" => beyond(),
                _ => within().into_iter().chain(beyond()).reduce(f64::min),
            };
            Ok(Value::Float(found.unwrap_or(f64::INFINITY)))
        },
    )
    .words(WORDS)
    .looking(),
    Function::new(
        "contextCount",
        "(intra|inter|all, label)",
        (2, 2),
        "How many shapes have that label so far.",
        |args, around| Ok(Value::Float(labelled(args, around)?.count() as f64)),
    )
    .words(WORDS)
    .looking(),
    Function::new(
        "contextCompare",
        "(intra|inter|all, label, order)",
        (3, 3),
        "The shape's rank among those of that label so far, from 0: how many of them come before it.",
        |args, around| {
            let order = text_at(args, 2)?;
            if !WORDS.contains(&order) || !order.contains('.') {
                return Err(format!("there is no order `{order}`"));
            }
            let own = key(&around.shape.footprint(), order);
            let before = labelled(args, around)?.filter(|other| key(&other.footprint, order) > own);
            Ok(Value::Float(before.count() as f64))
        },
    )
    .words(WORDS)
    .looking(),
];

fn target(args: &[Value]) -> Result<&str, String> {
    let target = text_at(args, 0)?;
    let known = ["intra", "inter", "all"].contains(&target);
    if known { Ok(target) } else { Err(format!("looks at `intra`, `inter` or `all`, not at `{target}`")) }
}

/// Everything of a label that a query looks at.
fn labelled<'s>(args: &'s [Value], around: &'s Surroundings) -> Result<impl Iterator<Item = &'s Occluder>, String> {
    let (target, label) = (target(args)?, text_at(args, 1)?);
    let within = around.intra.labelled(label).filter(move |_| target != "inter");
    Ok(within.chain(around.inter.labelled(label).filter(move |_| target != "intra")))
}

/// What an order goes by: the greatest comes first.
fn key(footprint: &Footprint, order: &str) -> f64 {
    let bounds = footprint.extent.bounds();
    match order {
        "world.northernmost" => bounds.max.y,
        "world.southernmost" => -bounds.min.y,
        "world.easternmost" => bounds.max.x,
        "world.westernmost" => -bounds.min.x,
        "world.highest" => footprint.high,
        "world.lowest" => -footprint.low,
        "area.largest" => footprint.extent.area(),
        _ => -footprint.extent.area(),
    }
}
