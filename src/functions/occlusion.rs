//! Occlusion (Müller et al. 2006; Ulmer et al. 2007, §4.1): how the current shape lies to others.
//!
//! `intra` sees the features of the lot (buildings, water …, under the word of their kind) and the shapes that were
//! derived earlier in it, `inter` the neighbours' initial shapes. Shapes without a label are seen when they are closed;
//! a label finds flat shapes too. Since every query sees only what stands, of mutually overlapping siblings the
//! first survives, then the next that keeps clear of it: a maximal subset. Ancestors never occlude.

use crate::functions::{Function, Surroundings};
use crate::shape::Relation;
use crate::value::Value;

const TARGETS: &[&str] = &["intra", "inter", "all"];
const SIGNATURE: &str = "() | (intra|inter|all) | (target, label)";

pub(super) static LIST: &[Function] = &[
    Function::new("inside", SIGNATURE, (0, 2), "Whether the shape lies inside another.", |args, around| {
        ask(args, around, Relation::Inside)
    })
    .truth()
    .words(TARGETS)
    .looking(),
    Function::new(
        "overlaps",
        SIGNATURE,
        (0, 2),
        "Whether the shape and another share an inner part.",
        |args, around| ask(args, around, Relation::Overlaps),
    )
    .truth()
    .words(TARGETS)
    .looking(),
    Function::new(
        "touches",
        SIGNATURE,
        (0, 2),
        "Whether the shape meets another within a millimetre.",
        |args, around| ask(args, around, Relation::Touches),
    )
    .truth()
    .words(TARGETS)
    .looking(),
];

fn ask(args: &[Value], around: &mut Surroundings, relation: Relation) -> Result<Value, String> {
    let first = args.first().and_then(Value::as_str);
    let (target, label) = match first {
        Some(word) if TARGETS.contains(&word) => (word, args.get(1).and_then(Value::as_str)),
        // `overlaps("tree")`: a label alone asks everywhere.
        Some(label) => ("all", Some(label)),
        None => ("all", None),
    };
    let footprint = around.shape.footprint();
    let within = target != "inter" && around.intra.any(&footprint, label, relation, around.is_ancestor);
    let beyond = || target != "intra" && around.inter.any(&footprint, label, relation, &|_| false);
    Ok(Value::Bool(within || beyond()))
}
