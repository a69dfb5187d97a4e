//! Shape attributes: read by name, some set by `set()`.

use crate::element::hex_text;
use crate::functions::coordinates::{angles, object};
use crate::functions::{Function, Surroundings};
use crate::value::Value;
use glam::DVec3;

macro_rules! attribute {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "", (0, 0), $docs, |_, around| {
            let f: fn(&Surroundings) -> Value = $f;
            Ok(f(around))
        })
    };
}

pub(super) static LIST: &[Function] = &[
    attribute!("scope.sx", "The size along x in metres.", |a| Value::Float(a.shape.scope.size.x)),
    attribute!("scope.sy", "The size along y in metres.", |a| Value::Float(a.shape.scope.size.y)),
    attribute!("scope.sz", "The size along z in metres.", |a| Value::Float(a.shape.scope.size.z)),
    attribute!("scope.tx", "The world x of the origin: metres east of the layout's centre.", |a| {
        Value::Float(a.shape.scope.frame.origin.x)
    }),
    attribute!("scope.ty", "The world y of the origin: metres up.", |a| Value::Float(a.shape.scope.frame.origin.y)),
    attribute!("scope.tz", "The world z of the origin: metres south of the layout's centre.", |a| {
        Value::Float(a.shape.scope.frame.origin.z)
    }),
    attribute!("scope.elevation", "The height of the origin in metres.", |a| {
        Value::Float(a.shape.scope.frame.origin.y)
    }),
    attribute!("scope.rx", "The turn about x in degrees.", |a| Value::Float(angles(a.shape.scope.frame.rotation).x)),
    attribute!("scope.ry", "The turn about y in degrees.", |a| Value::Float(angles(a.shape.scope.frame.rotation).y)),
    attribute!("scope.rz", "The turn about z in degrees.", |a| Value::Float(angles(a.shape.scope.frame.rotation).z)),
    attribute!("split.index", "The number of the part in the last split, from 0.", |a| {
        Value::Float(f64::from(a.shape.ordinals.split.0))
    }),
    attribute!("split.total", "The number of parts of the last split.", |a| {
        Value::Float(f64::from(a.shape.ordinals.split.1))
    }),
    attribute!("comp.index", "The number of the component among those that its selector took, from 0.", |a| {
        Value::Float(f64::from(a.shape.ordinals.comp.0))
    }),
    attribute!("comp.total", "The number of components that the selector of the last component split took.", |a| {
        Value::Float(f64::from(a.shape.ordinals.comp.1))
    }),
    attribute!(
        "comp.sel",
        "The word of the selector that took the component; empty where an index or a condition did.",
        |a| { Value::Text(a.shape.style.selector.clone().unwrap_or_default()) }
    )
    .text()
    .asking_for_selectors(),
    attribute!("place.index", "The number of the point in the last placement, from 0.", |a| {
        Value::Float(f64::from(a.shape.ordinals.place.index))
    })
    .added(),
    attribute!("place.total", "The number of points of the last placement.", |a| {
        Value::Float(f64::from(a.shape.ordinals.place.total))
    })
    .added(),
    attribute!("place.radius", "The radius that the last placement reserved, metres.", |a| {
        Value::Float(a.shape.ordinals.place.radius)
    })
    .added(),
    attribute!("place.cluster", "The cluster, row, branch or edge of the last placement, from 0.", |a| {
        Value::Float(f64::from(a.shape.ordinals.place.cluster))
    })
    .added(),
    attribute!("seedian", "The shape's seed as a number.", |a| Value::Float((a.shape.seed.0 >> 11) as f64)).settable(),
    attribute!("initialShape.name", "The name of the region.", |a| Value::Text(a.initial.name.clone())).text(),
    attribute!("initialShape.startRule", "The rule the region began with.", |a| Value::Text(a.initial.start.clone()))
        .text(),
    attribute!("initialShape.symbol", "The rule the region began with, as old files say it.", |a| {
        Value::Text(a.initial.start.clone())
    })
    .text(),
    attribute!("initialShape.kind", "The kind of the region.", |a| Value::Text(a.initial.kind.clone())).text().added(),
    attribute!("initialShape.zone", "The zone of the region.", |a| Value::Text(a.initial.zone.clone())).text().added(),
    attribute!("initialShape.origin.px", "The world x of the object's origin: metres east.", |a| Value::Float(
        object(a).0.x
    )),
    attribute!("initialShape.origin.py", "The world y of the object's origin: metres up.", |a| Value::Float(
        object(a).0.y
    )),
    attribute!("initialShape.origin.pz", "The world z of the object's origin: metres south.", |a| Value::Float(
        object(a).0.z
    )),
    attribute!("initialShape.origin.ox", "The object's turn about x in degrees.", |a| Value::Float(object(a).1.x)),
    attribute!("initialShape.origin.oy", "The object's turn about y in degrees.", |a| Value::Float(object(a).1.y)),
    attribute!("initialShape.origin.oz", "The object's turn about z in degrees.", |a| Value::Float(object(a).1.z)),
    attribute!("material.name", "The material: a ground cover of the catalogue, or a word of your own.", |a| {
        Value::Text(a.shape.style.material.clone().unwrap_or_default())
    })
    .text()
    .settable(),
    attribute!("material.color.r", "Red, 0 to 1.", |a| channel(a, 0)).settable(),
    attribute!("material.color.g", "Green, 0 to 1.", |a| channel(a, 1)).settable(),
    attribute!("material.color.b", "Blue, 0 to 1.", |a| channel(a, 2)).settable(),
    attribute!("material.opacity", "Opacity, 0 to 1.", |a| channel(a, 3)).settable(),
    attribute!("material.color.rgb", "The colour as `#rrggbb`; `material.opacity` is apart.", |a| {
        let color = a.shape.style.color.unwrap_or([1.0; 4]);
        Value::text(hex_text(color.into_iter().take(3).map(f64::from)))
    })
    .text()
    .settable(),
    attribute!("envelope.walls", "How far plants keep from buildings, metres; negative looks away.", |a| {
        Value::Float(a.shape.style.envelope.walls)
    })
    .settable()
    .added(),
    attribute!("envelope.paving", "How far plants keep from drives, kerbs, footways and streets, metres.", |a| {
        Value::Float(a.shape.style.envelope.paving)
    })
    .settable()
    .added(),
    attribute!(
        "envelope.openings",
        "How far plants keep from doors and windows beyond `envelope.walls`, metres.",
        |a| { Value::Float(a.shape.style.envelope.openings) }
    )
    .settable()
    .added(),
    attribute!("envelope.water", "How far plants keep from water, metres.", |a| {
        Value::Float(a.shape.style.envelope.water)
    })
    .settable()
    .added(),
    attribute!("envelope.seams", "Whether the disks of plants stay inside their own lot.", |a| {
        Value::Bool(a.shape.style.envelope.seams)
    })
    .truth()
    .settable()
    .added(),
    attribute!(
        "pivot.px",
        "Where the pivot lies in the object (metres); the scope's origin until `setPivot` moves it.",
        |a| { Value::Float(pivot(a)[0].x) }
    ),
    attribute!(
        "pivot.py",
        "Where the pivot lies in the object (metres); the scope's origin until `setPivot` moves it.",
        |a| { Value::Float(pivot(a)[0].y) }
    ),
    attribute!(
        "pivot.pz",
        "Where the pivot lies in the object (metres); the scope's origin until `setPivot` moves it.",
        |a| { Value::Float(pivot(a)[0].z) }
    ),
    attribute!(
        "pivot.ox",
        "How the pivot is turned in the object (degrees); as the scope until `setPivot` turns it.",
        |a| { Value::Float(pivot(a)[1].x) }
    ),
    attribute!(
        "pivot.oy",
        "How the pivot is turned in the object (degrees); as the scope until `setPivot` turns it.",
        |a| { Value::Float(pivot(a)[1].y) }
    ),
    attribute!(
        "pivot.oz",
        "How the pivot is turned in the object (degrees); as the scope until `setPivot` turns it.",
        |a| { Value::Float(pivot(a)[1].z) }
    ),
    attribute!("trim.horizontal", "Whether solids are trimmed along level edges; bosquet keeps it for scenes.", |a| {
        trim(a, 0)
    })
    .truth()
    .settable(),
    attribute!("trim.vertical", "Whether solids are trimmed along upright edges; bosquet keeps it for scenes.", |a| {
        trim(a, 1)
    })
    .truth()
    .settable(),
    attribute!("label.name", "The last label, empty where there is none.", |a| {
        Value::Text(a.shape.style.label.clone().unwrap_or_default())
    })
    .text()
    .added(),
];

/// Place and turns of the pivot in the object's coordinates.
fn pivot(around: &Surroundings) -> [DVec3; 2] {
    let (pivot, object) = (around.shape.pivot(), &around.initial.object);
    [object.to_local(pivot.origin), angles(object.rotation.inverse() * pivot.rotation)]
}

/// Whether it is trimmed: yes, until it is set.
fn trim(around: &Surroundings, which: usize) -> Value {
    Value::Bool(around.shape.attached().and_then(|surface| surface.trim[which]).unwrap_or(true))
}

fn channel(around: &Surroundings, index: usize) -> Value {
    Value::Float(f64::from(around.shape.style.color.unwrap_or([1.0; 4])[index]))
}
