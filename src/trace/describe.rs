//! A shape in one line: what it is, its size, place, turn, measures and looks, rounded to millimetres.

use crate::element::color_text;
use crate::shape::{Geometry, Shape};
use crate::text::number;
use glam::{DVec3, EulerRot};
use std::fmt::Write;

/// What it is, its size along its own axes, the middle of its box in the world, its turn (about y, x and z in degrees,
/// or about y alone), its measures and looks.
pub fn shape_words(shape: &Shape) -> String {
    let (scope, measure) = (&shape.scope, shape.measure());
    let middle = scope.frame.to_world(scope.size * 0.5);
    let mut text = format!("{} {} about {}", geometry(shape), triple(scope.size), triple(middle));
    let (y, x, z) = scope.frame.rotation.to_euler(EulerRot::YXZ);
    let [y, x, z] = [y, x, z].map(|angle| number(angle.to_degrees(), 3).replace("-180", "180"));
    // Writing into a text cannot fail.
    let _ = match [&*x, &*z] {
        ["0", "0"] if y == "0" => Ok(()),
        ["0", "0"] => write!(text, " turned {y}"),
        _ => write!(text, " turned {y}, {x}, {z}"),
    };
    for (word, value) in [("area", measure.area), ("volume", measure.volume)].into_iter().filter(|(_, v)| *v != 0.0) {
        let _ = write!(text, ", {word} {}", number(value, 3));
    }
    let style = &shape.style;
    let color = style.color.map(|c| format!("color {}", color_text(c)));
    let material = style.material.as_ref().map(|m| format!("material {m}"));
    let label = style.label.as_ref().map(|l| format!("label {l}"));
    [color, material, label].into_iter().flatten().for_each(|word| _ = write!(text, ", {word}"));
    text
}

fn geometry(shape: &Shape) -> String {
    match &shape.geometry {
        Geometry::Empty => "nothing".into(),
        Geometry::Point => "point".into(),
        Geometry::Path(points) => format!("path of {}", points.len()),
        Geometry::Flat(..) => "flat".into(),
        Geometry::Prism(..) => "prism".into(),
        Geometry::Mesh(mesh) => format!("mesh of {}", mesh.faces.len()),
        Geometry::Element(placed) => format!("{} {} #{}", placed.entry, placed.kind, placed.appearance),
    }
}

fn triple(v: DVec3) -> String {
    format!("{} {} {}", number(v.x, 3), number(v.y, 3), number(v.z, 3))
}
