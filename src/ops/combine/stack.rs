//! Layers, one above the other, → one solid: walls for each layer, and floors and roofs only where nothing adjoins.

use crate::geometry::{self, Area, Mesh};
use glam::{DVec2, DVec3};

/// An area between two heights (metres).
pub(super) type Layer<'a> = (&'a Area, f64, f64);

/// The surface of layers of which no two share a height within; heights within `same` metres are one.
///
/// `map` takes a point of the plane and a height into space. Corners of one face on the edges of another are corners of
/// both, so that the solid is closed. Cost: at worst the square of the corners at one height.
pub(super) fn stacked(layers: &[Layer], same: f64, map: impl Fn(DVec2, f64) -> DVec3) -> Mesh {
    let mut heights: Vec<f64> = layers.iter().flat_map(|(_, low, high)| [*low, *high]).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|a, b| (*a - *b).abs() < same);
    let is_at = |a: f64, height: f64| (a - height).abs() < same;
    let slices: Vec<Slice> = heights
        .iter()
        .map(|height| {
            let of = |end: fn(&Layer) -> f64| {
                geometry::union_all(layers.iter().filter(|layer| is_at(end(layer), *height)).map(|layer| layer.0))
            };
            Slice::new(*height, same, &of(|layer| layer.2), &of(|layer| layer.1))
        })
        .collect();
    let mut mesh = Mesh::default();
    slices.iter().for_each(|slice| slice.caps(&mut mesh, &map));
    for (area, low, high) in layers {
        let slice = |height: f64| slices.iter().find(|slice| is_at(slice.height, height));
        if let Some((low, high)) = slice(*low).zip(slice(*high)) {
            walls(&mut mesh, area, low, high, &map);
        }
    }
    let mut mesh = mesh.welded(same);
    if mesh.volume() < 0.0 {
        mesh.turn_round();
    }
    mesh
}

/// What lies at a height.
struct Slice {
    height: f64,
    /// Points nearer than this (metres) are one.
    same: f64,
    /// Where a layer ends with nothing above.
    roof: Area,
    /// Where one begins with nothing below.
    floor: Area,
    /// All corners, by x.
    corners: Vec<DVec2>,
}

impl Slice {
    fn new(height: f64, same: f64, below: &Area, above: &Area) -> Slice {
        let (roof, floor) = (geometry::difference(below, above), geometry::difference(above, below));
        let areas = [below, above, &roof, &floor];
        let points = areas.iter().flat_map(|area| area.polygons()).flat_map(|part| part.points());
        let mut corners: Vec<DVec2> = points.copied().collect();
        corners.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        corners.dedup_by(|a, b| a.distance(*b) < same);
        Slice { height, same, roof, floor, corners }
    }

    /// An edge with the corners that lie on it, without its end.
    fn edge(&self, from: DVec2, to: DVec2) -> Vec<DVec2> {
        let (left, right) = (from.x.min(to.x) - self.same, from.x.max(to.x) + self.same);
        let first = self.corners.partition_point(|p| p.x < left);
        let length = from.distance(to);
        let along = (to - from).normalize_or_zero();
        let mut on: Vec<(f64, DVec2)> = vec![(0.0, from)];
        on.extend(self.corners[first..].iter().take_while(|p| p.x <= right).filter_map(|p| {
            let (far, off) = (along.dot(*p - from), along.perp_dot(*p - from).abs());
            (far > self.same && far < length - self.same && off < self.same).then_some((far, *p))
        }));
        on.sort_by(|a, b| a.0.total_cmp(&b.0));
        on.into_iter().map(|(_, p)| p).collect()
    }

    fn ring(&self, ring: &[DVec2]) -> Vec<DVec2> {
        ring.iter().zip(ring.iter().cycle().skip(1)).flat_map(|(a, b)| self.edge(*a, *b)).collect()
    }

    /// Roofs that look up and floors that look down.
    fn caps(&self, mesh: &mut Mesh, map: &impl Fn(DVec2, f64) -> DVec3) {
        for (area, is_floor) in [(&self.roof, false), (&self.floor, true)] {
            for part in area.polygons() {
                let rings: Vec<Vec<u32>> = part
                    .rings()
                    .map(|ring| {
                        let mut points = self.ring(ring);
                        if is_floor {
                            points.reverse();
                        }
                        put(mesh, points.into_iter().map(|p| map(p, self.height)))
                    })
                    .collect();
                mesh.push_face(rings);
            }
        }
    }
}

/// A wall over every edge of an area.
fn walls(mesh: &mut Mesh, area: &Area, low: &Slice, high: &Slice, map: &impl Fn(DVec2, f64) -> DVec3) {
    for ring in area.polygons().iter().flat_map(|part| part.rings()) {
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let bottom = low.edge(*a, *b).into_iter().chain([*b]).map(|p| map(p, low.height));
            let top = high.edge(*a, *b).into_iter().chain([*b]).rev().map(|p| map(p, high.height));
            let face = put(mesh, bottom.chain(top));
            mesh.push_face([face]);
        }
    }
}

/// The numbers of new vertices.
fn put(mesh: &mut Mesh, points: impl Iterator<Item = DVec3>) -> Vec<u32> {
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(points);
    (first..mesh.positions.len() as u32).collect()
}
