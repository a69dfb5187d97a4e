//! A derivation as text: the tree by indentation, behind each leaf what is built, rounded to millimetres.

use bosquet::element::color_text;
use bosquet::shape::{Derivation, Geometry, LeafOf, Lot, Node, NodeId, Shape};
use bosquet::text::number;
use glam::{DVec3, EulerRot};
use std::fmt::Write;
use std::sync::Arc;

/// Every lot, each under its id.
pub fn tree_text(derivation: &Derivation) -> String {
    let lots = derivation.lots.iter();
    lots.map(|lot| format!("{}\n{}", lot.id, lot_text(&derivation.symbols, lot))).collect::<Vec<_>>().join("\n")
}

/// One lot: a line per node, and a line per leaf that its rule built without naming it.
pub fn lot_text(symbols: &[Arc<str>], lot: &Lot) -> String {
    let nodes = &lot.outcome.nodes;
    let mut text = String::new();
    for (index, node) in nodes.iter().enumerate() {
        let indent = "  ".repeat(depth(nodes, index) + 1);
        let mut leaves = lot.outcome.leaves.iter().filter(|leaf| leaf.node == NodeId(index as u32)).peekable();
        write!(text, "{indent}{}", symbols[node.symbol as usize]).expect("memory");
        if let Some(LeafOf { shape, .. }) = leaves.next_if(|_| node.rule.is_none()) {
            write!(text, ": {}", shape_text(shape)).expect("memory");
        }
        text.push('\n');
        leaves.for_each(|leaf| writeln!(text, "{indent}  - {}", shape_text(&leaf.shape)).expect("memory"));
    }
    text
}

fn depth(nodes: &[Node], index: usize) -> usize {
    let parent = |i: &usize| Some(nodes[*i].parent.0 as usize).filter(|p| p != i);
    std::iter::successors(Some(index), parent).count() - 1
}

/// What it is, its size along its own axes, the middle of its box in the world, its turn (about y, x and
/// z in degrees, or about y alone), its measures and looks.
fn shape_text(shape: &Shape) -> String {
    let (scope, measure) = (&shape.scope, shape.measure());
    let middle = scope.frame.to_world(scope.size * 0.5);
    let mut text = format!("{} {} about {}", geometry(shape), triple(scope.size), triple(middle));
    let (y, x, z) = scope.frame.rotation.to_euler(EulerRot::YXZ);
    let [y, x, z] = [y, x, z].map(|angle| number(angle.to_degrees(), 3).replace("-180", "180"));
    match [&*x, &*z] {
        ["0", "0"] if y == "0" => {}
        ["0", "0"] => write!(text, " turned {y}").expect("memory"),
        _ => write!(text, " turned {y}, {x}, {z}").expect("memory"),
    }
    for (word, value) in [("area", measure.area), ("volume", measure.volume)].into_iter().filter(|(_, v)| *v != 0.0) {
        write!(text, ", {word} {}", number(value, 3)).expect("memory");
    }
    let style = &shape.style;
    let color = style.color.map(|c| format!("color {}", color_text(c)));
    let material = style.material.as_ref().map(|m| format!("material {m}"));
    let label = style.label.as_ref().map(|l| format!("label {l}"));
    [color, material, label].into_iter().flatten().for_each(|word| write!(text, ", {word}").expect("memory"));
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
