//! Where on a shape an argument is wanted: density, radius and spacing of a placement may vary with it.
//!
//! The functions have a value only there; the engine samples such an argument over the shape.

use crate::functions::args::{number, text_at};
use crate::functions::{Function, Surroundings};
use crate::geometry::Area;
use crate::raster::Measure;
use crate::value::Value;
use glam::DVec2;
use std::cell::Cell;

/// A place on a shape for which an argument is evaluated.
pub struct At<'a> {
    /// On the plan.
    pub plan: DVec2,
    /// Metres along the scope's x and z.
    pub local: DVec2,
    /// Shares of the scope's x and z.
    pub share: DVec2,
    /// The shape's extent on the plan.
    pub area: &'a Area,
    /// Whether anything has asked for the position.
    pub asked: Cell<bool>,
}

/// The words for the axes of `gradient`.
const AXES: &[&str] = &["x", "z"];

macro_rules! position {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "", (0, 0), $docs, |_, around| {
            let f: fn(&At) -> f64 = $f;
            Ok(Value::Float(f(at(around)?)))
        })
        .added()
    };
}

pub(super) static LIST: &[Function] = &[
    position!("place.u", "In an argument that may vary: the share of the scope's x, 0 to 1.", |at| at.share.x),
    position!(
        "place.v",
        "In an argument that may vary: the share of the scope's z, 0 at the back to 1 in front.",
        |at| at.share.y
    ),
    position!("place.x", "In an argument that may vary: metres along the scope's x.", |at| at.local.x),
    position!("place.z", "In an argument that may vary: metres along the scope's z.", |at| at.local.y),
    position!("place.edge", "In an argument that may vary: metres from the edge of the shape.", |at| {
        at.area.distance_to_edges(at.plan)
    }),
    Function::new(
        "gradient",
        "(x|z, from, to)",
        (3, 3),
        "In an argument that may vary: from one value to another along the scope's x, or its z from back to front.",
        |args, around| {
            let (from, to) = (number(args, 1)?, number(args, 2)?);
            let share = at(around)?.share;
            match text_at(args, 0)? {
                "x" => Ok(Value::Float(from + (to - from) * share.x)),
                "z" => Ok(Value::Float(from + (to - from) * share.y)),
                other => Err(format!("takes `x` or `z`, found `{other}`")),
            }
        },
    )
    .words(AXES)
    .added(),
    Function::new(
        "raster",
        "(path) | (path, measure)",
        (1, 2),
        "In an argument that may vary: the value of a raster there; 0 beyond it and where it has no data.",
        |args, around| {
            let word = args.get(1).map_or("cover".into(), ToString::to_string);
            let measure =
                Measure::parse(&word).ok_or_else(|| format!("cannot measure `{word}`: a band has a number"))?;
            let raster =
                around.rasters.get(text_at(args, 0)?).map_err(|error| format!("has nothing to read: {error}"))?;
            Ok(Value::Float(raster.at(at(around)?.plan, &measure).unwrap_or(0.0)))
        },
    )
    .added(),
];

/// The place that is asked for.
fn at<'s>(around: &'s Surroundings) -> Result<&'s At<'s>, String> {
    let at =
        around.at.ok_or("has a value only in arguments that may vary: the density, radius or spacing of plants")?;
    at.asked.set(true);
    Ok(at)
}
