//! Coordinate systems: the scope's, the object's (the lot as it was at first), the world's, and the layout's own.
//!
//! The pivot is what `setPivot` made it, and the scope's origin and axes before: what `r`, `rotate` and `translate` go by.

use crate::functions::args::{number, word_at, wrong};
use crate::functions::{Function, Gives, Surroundings};
use crate::shape::{Frame, on_plan};
use crate::value::{Array, Cells, Value};
use glam::{DQuat, DVec3, EulerRot};

const SYSTEMS: &[&str] = &["scope", "pivot", "object", "world"];
const KINDS: &[&str] = &["pos", "orient"];
const AXES: &[&str] = &["x", "y", "z"];

pub(super) static LIST: &[Function] = &[
    Function::new(
        "convert",
        "(x|y|z, from, to, pos|orient, x, y, z) | (from, to, pos|orient, coordinates)",
        (4, 7),
        "Coordinates (metres) or turns about x, y and z (degrees) of one system in another: `scope`, `pivot`, `object` or \
         `world`. One of them, or from an array of threes an array of the same rows.",
        convert,
    )
    .words(&["x", "y", "z", "scope", "pivot", "object", "world", "pos", "orient"])
    .words_within(4)
    .gives(Gives::Any),
    Function::new(
        "getGeoCoord",
        "(X|Y|lon|lat)",
        (1, 1),
        "Where the scope's origin lies in the layout's own coordinates, or its longitude or latitude in degrees (WGS84).",
        geographic,
    )
    .words(&["X", "Y", "lon", "lat"]),
];

fn convert(args: &[Value], around: &mut Surroundings) -> Result<Value, String> {
    match args.len() {
        4 => {
            let conversion = Conversion::of(args, around)?;
            let array = args[3].as_array().ok_or_else(|| wrong("an array of numbers", &args[3]))?;
            let (threes, rest) = match array.cells() {
                Cells::Numbers(numbers) => numbers.as_chunks::<3>(),
                _ => return Err(wrong("an array of numbers", &args[3])),
            };
            if !rest.is_empty() {
                return Err(format!("takes three coordinates each, found {}", array.len()));
            }
            let converted = threes.iter().flat_map(|three| conversion.apply(DVec3::from_array(*three)).to_array());
            let cells = Cells::Numbers(converted.collect());
            Ok(Value::Array(Array::new(array.columns(), cells).expect("as many cells as before").into()))
        }
        7 => {
            let axis = word_at(args, 0, AXES)?;
            let conversion = Conversion::of(&args[1..], around)?;
            let from = DVec3::new(number(args, 4)?, number(args, 5)?, number(args, 6)?);
            let to = conversion.apply(from);
            Ok(Value::Float(match axis {
                "x" => to.x,
                "y" => to.y,
                _ => to.z,
            }))
        }
        count => Err(format!("takes 4 or 7 arguments, found {count}")),
    }
}

/// From one system to another, places or turns.
struct Conversion {
    from: Frame,
    to: Frame,
    turns: bool,
}

impl Conversion {
    fn of(args: &[Value], around: &Surroundings) -> Result<Conversion, String> {
        let frame = |index: usize| {
            Ok::<Frame, String>(match word_at(args, index, SYSTEMS)? {
                "scope" => around.shape.scope.frame,
                "pivot" => around.shape.pivot(),
                "world" => Frame::WORLD,
                _ => around.initial.object,
            })
        };
        Ok(Conversion { from: frame(0)?, to: frame(1)?, turns: word_at(args, 2, KINDS)? == "orient" })
    }

    fn apply(&self, coordinates: DVec3) -> DVec3 {
        if !self.turns {
            return self.to.to_local(self.from.to_world(coordinates));
        }
        let [x, y, z] = coordinates.to_array().map(f64::to_radians);
        let turned = self.from.rotation * DQuat::from_euler(EulerRot::XYZ, x, y, z);
        angles(self.to.rotation.inverse() * turned)
    }
}

/// The turns about x, y and z in degrees; of the two that every rotation has, the one that lies nearer to a mere turn
/// about y.
pub(super) fn angles(rotation: DQuat) -> DVec3 {
    let (x, y, z) = rotation.to_euler(EulerRot::XYZ);
    let turn = DVec3::new(x, y, z).map(f64::to_degrees);
    if turn.x.abs() + turn.z.abs() <= 180.0 {
        return turn;
    }
    let opposite = |angle: f64| angle - 180f64.copysign(angle);
    DVec3::new(opposite(turn.x), -opposite(turn.y), opposite(turn.z))
}

fn geographic(args: &[Value], around: &mut Surroundings) -> Result<Value, String> {
    let plan = on_plan(around.shape.scope.frame.origin);
    let [x, y] = around.georeference.to_world(plan);
    let degrees = || around.georeference.lonlat(plan).ok_or("has no degrees: the layout is in local metres");
    Ok(Value::Float(match word_at(args, 0, &["X", "Y", "lon", "lat"])? {
        "X" => x,
        "Y" => y,
        "lon" => degrees()?[0],
        _ => degrees()?[1],
    }))
}

/// Where the object's origin lies in the world, and how it is turned.
pub(super) fn object(around: &Surroundings) -> (DVec3, DVec3) {
    (around.initial.object.origin, angles(around.initial.object.rotation))
}
