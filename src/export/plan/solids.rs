//! What stands on the ground: hedges, walls and buildings, with their shadows and roofs.
//!
//! Light comes from the north-west of the paper: edges that face away from it get the heavier line, roofs are as
//! bright as they face it.

use crate::export::plan::drawing::{Group, Item, Layer, Shape};
use crate::export::plan::field;
use crate::export::plan::ink::{Ink, LIGHT, SHADOW};
use crate::export::plan::path::{Path, direction};
use crate::export::plan::sheet::Sheet;
use crate::export::plan::symbol::LEE;
use crate::export::plan::texture::{self, Ground};
use crate::geometry::{Area, Face, Mesh, Polygon, setback};
use crate::scene::{Material, Solid};
use crate::text::number;
use glam::{DVec2, DVec3};

/// Length of a shadow per metre of height.
const SUN: f64 = 0.34;
/// No shadow is longer than this on paper, millimetres.
const LONGEST: f64 = 9.0;
/// Roofs below this many mm² on paper are not modelled.
const LEAST_ROOF: f64 = 9.0;
/// Faces whose slope (sine of the angle) is less have no tiles.
const LEVEL: f64 = 0.05;
/// Solids with more faces than this are round or modelled, and show their texture.
const MOST_FACETS: usize = 64;

/// All solids of a scene.
pub fn layer(solids: &[Solid], sheet: &Sheet) -> Layer {
    let mut ordered: Vec<&Solid> = solids.iter().collect();
    ordered.sort_by(|a, b| (a.base + a.height).total_cmp(&(b.base + b.height)));
    Layer { items: ordered.into_iter().filter_map(|s| draw(s, sheet)).collect(), ..Layer::new("solids", "Solids") }
}

/// The shadows of all solids: each footprint swept along the light.
pub fn shadows(solids: &[Solid], sheet: &Sheet) -> Vec<Item> {
    let cast = |solid: &Solid| {
        let area = sheet.shown(&solid.footprint)?;
        let reach = sheet.frame.length(SUN * solid.height).clamp(0.0, LONGEST);
        (reach > 0.05).then(|| Shape::filled(swept(&area, direction(LEE) * reach), SHADOW).into())
    };
    solids.iter().filter_map(cast).collect()
}

/// The region, its copy moved by `by`, and all between.
fn swept(area: &Area, by: DVec2) -> Path {
    let mut path = Path::area(area);
    path.append(&Path::area(&area.translated(by)));
    for (a, b) in area.edges() {
        // Each quad runs the way outer rings run, so that overlaps add up instead of cancelling.
        let quad = if (b - a).perp_dot(by) > 0.0 { [a, b, b + by, a + by] } else { [b, a, a + by, b + by] };
        path.add_line(&quad, true);
    }
    path
}

fn draw(solid: &Solid, sheet: &Sheet) -> Option<Item> {
    let area = sheet.shown(&solid.footprint)?;
    let ground = Ground::new(&area, sheet.window, &solid.material, sheet.frame.length(1.0), &solid.origin.id);
    let items = body(&ground, &solid.material, solid.mesh.as_deref(), sheet);
    let title = Some(format!("{}, height {} m", solid.material.label, number(solid.height, 1)));
    Some(Group { class: format!("solid {}", solid.material.name), title, clip: None, items }.into())
}

/// Fill, inside and edges of a solid on paper; the mesh, where there is one, in plan metres.
pub fn body(ground: &Ground, material: &Material, mesh: Option<&Mesh>, sheet: &Sheet) -> Vec<Item> {
    let mut items = vec![Shape::filled(Path::area(ground.area), ground.fill).into()];
    match mesh {
        Some(mesh) if has_roof(material) => items.extend(faces(mesh, ground.line, true, sheet)),
        Some(mesh) if is_faceted(mesh) => items.extend(faces(mesh, ground.line, false, sheet)),
        None if has_roof(material) => items.extend(roofs(ground)),
        _ => items.extend(texture::draw(material.texture, ground)),
    }
    items.extend(edges(ground.area, ground.line.darker(0.35)));
    items
}

/// Whether it is a building.
fn has_roof(material: &Material) -> bool {
    ["roof", "building"].iter().any(|word| material.name.contains(word))
}

/// Whether its form is told by a few slopes: spires and pyramids, not balls and models.
fn is_faceted(mesh: &Mesh) -> bool {
    let slopes = |face: Face| (0.05..0.99).contains(&face.normal().y);
    mesh.face_count() <= MOST_FACETS && mesh.faces().any(slopes)
}

/// Thin lines towards the light, heavy ones away from it.
fn edges(area: &Area, ink: Ink) -> Vec<Item> {
    let mut heavy = Path::default();
    let lee = direction(LEE);
    for (a, b) in area.edges().filter(|(a, b)| (*b - *a).normalize_or_zero().perp_dot(lee) < -0.2) {
        heavy.add_line(&[a, b], false);
    }
    vec![Shape::drawn(Path::area(area), ink, 0.12).into(), Shape::drawn(heavy, ink, 0.24).into()]
}

/// The upward faces of a modelled solid, lowest first, each as bright as it faces the light; ridges and hips are where
/// they meet. Roofs have tiles.
fn faces(mesh: &Mesh, line: Ink, tiled: bool, sheet: &Sheet) -> Vec<Item> {
    let on_paper = |p: DVec3| sheet.frame.point(DVec2::new(p.x, -p.z));
    let mut upward: Vec<(f64, Vec<Item>)> = Vec::new();
    for face in mesh.faces() {
        let normal = face.area_vector().normalize_or_zero();
        if normal.y < 0.05 {
            continue;
        }
        let rings: Vec<Vec<DVec2>> = face.rings().map(|ring| face.positions(ring).map(on_paper).collect()).collect();
        let mut path = Path::default();
        rings.iter().for_each(|ring| path.add_line(ring, true));
        let slope = (on_paper(DVec3::new(normal.x, 0.0, normal.z)) - on_paper(DVec3::ZERO)).normalize_or_zero();
        let steep = libm::hypot(normal.x, normal.z);
        let mut items = vec![Shape::filled(path.clone(), shade(slope * steep * 1.3)).into()];
        if tiled && steep > LEVEL {
            items.push(Shape::drawn(tiles(&rings, slope).coarse(), line.faded(0.35), 0.06).into());
        }
        items.push(Shape::drawn(path, line.faded(0.8), 0.12).into());
        let top = face.positions(face.outline()).map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
        upward.push((top, items));
    }
    upward.sort_by(|a, b| a.0.total_cmp(&b.0));
    upward.into_iter().flat_map(|(_, items)| items).collect()
}

/// Courses of tiles as lines down the slope.
fn tiles(rings: &[Vec<DVec2>], slope: DVec2) -> Path {
    let mut tiles = Path::default();
    let area: Area = rings.first().and_then(|outline| Polygon::new(outline, &rings[1..])).into_iter().collect();
    for line in field::hatched(&area, slope, 0.55, 0.0) {
        tiles.add_line(&line, false);
    }
    tiles
}

/// A mansard: slopes along every edge, each as bright as it faces the light, and a flat top.
fn roofs(ground: &Ground) -> Vec<Item> {
    let parts = ground.area.polygons().iter();
    parts.flat_map(|polygon| if polygon.area() < LEAST_ROOF { Vec::new() } else { roof(ground, polygon) }).collect()
}

fn roof(ground: &Ground, polygon: &Polygon) -> Vec<Item> {
    let Some(around) = polygon.oriented_box() else { return Vec::new() };
    let depth = (around.size.min_element() * 0.3).min(4.5 * ground.metre);
    let edges: Vec<(DVec2, DVec2)> = polygon.edges().collect();
    let slopes = setback(polygon, |_| depth);
    let (mut items, mut tiles) = (Vec::new(), Path::default());
    for strip in &slopes.strips {
        let (a, b) = edges[strip.edge];
        let along = (b - a).normalize_or(DVec2::X);
        // The inside lies to the left of an edge, so it looks outwards to its right.
        let shape = Shape::filled(Path::area(&strip.area), shade(-along.perp()));
        items.push(shape.outlined(ground.line.faded(0.7), 0.09).into());
        for line in field::hatched(&strip.area, along.perp(), 0.55, 0.0) {
            tiles.add_line(&line, false);
        }
    }
    items.push(Shape::drawn(tiles.coarse(), ground.line.faded(0.35), 0.06).into());
    items.push(Shape::drawn(Path::area(&slopes.remainder), ground.line.faded(0.8), 0.12).into());
    items
}

/// Light or shade over a face that looks in a direction; longer is steeper.
fn shade(outwards: DVec2) -> Ink {
    let lee = outwards.dot(direction(LEE));
    if lee > 0.0 { SHADOW.faded(0.34 * lee.min(1.0)) } else { LIGHT.faded(0.42 * (-lee).min(1.0)) }
}
