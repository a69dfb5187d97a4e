//! A region as an initial shape, with what it sees.
//!
//! The first edge of the outline decides the scope (CityEngine's object system): x along it, y up, z out of the
//! front, the origin at the corner with the least coordinates.

use crate::functions::Initial;
use crate::geometry::{Area, Bounds, BoxGrid, stroke};
use crate::layout::{Feature, Kind, Layout, Region, Shapes};
use crate::placement::{Disk, Standing};
use crate::seed::Seed;
use crate::shape::{
    Extent, Footprint, Frame, Geometry, Occluder, Occluders, Ordinals, Plane, Scope, Shape, Streets, Style,
};
use crate::value::{Cells, Value};
use glam::{DQuat, DVec2, DVec3};
use std::sync::Arc;

/// So far beyond a lot (metres) features keep its plants away: well beyond any usual envelope.
const AROUND: f64 = 30.0;

/// The region as a shape without attributes.
pub(super) fn shape(region: &Region, seed: Seed) -> Shape {
    let outline = region.polygon.outer();
    let along = (outline[1] - outline[0]).normalize_or(DVec2::X);
    let turn = |p: DVec2| DVec2::new(along.dot(p), along.perp_dot(p));
    let turned = region.polygon.mapped(turn);
    let bounds = turned.bounds();
    // Local x is `along`; local z points right of it, so the origin has the least x and the greatest v.
    let corner = DVec2::new(bounds.min.x, bounds.max.y);
    let area = Area::from(turned.translated(-corner));
    let at = along * corner.x + along.perp() * corner.y;
    let rotation = DQuat::from_rotation_y(libm::atan2(along.y, along.x));
    let frame = Frame { origin: DVec3::new(at.x, region.elevation, -at.y), rotation };
    let size = bounds.size();
    Shape {
        scope: Scope { frame, size: DVec3::new(size.x, 0.0, size.y) },
        geometry: Geometry::Flat(Plane::Ground, area),
        attributes: Arc::new([]),
        style: Arc::new(Style { object: rotation, streets: streets(region), ..Style::default() }),
        ordinals: Ordinals::default(),
        seed,
    }
}

/// The streets along the edges, where the region has CityEngine's `streetWidth`: an array with a width for each edge.
fn streets(region: &Region) -> Option<Arc<Streets>> {
    let array = region.attributes.get("streetWidth")?.as_array()?;
    let Cells::Numbers(widths) = array.cells() else { return None };
    Streets::new(&region.polygon, widths).map(Arc::new)
}

/// The seed of a region: its own, or the run's with its id, so that regions do not depend on their order.
pub(super) fn seed(region: &Region, run: Seed) -> Seed {
    match region.seed {
        Some(own) => Seed(own),
        None => run.named(&region.id),
    }
}

/// The object's frame: the first point of the outline, x along the first edge, y up, z out of the front.
fn object(region: &Region) -> Frame {
    let outline = region.polygon.outer();
    let (first, along) = (outline[0], (outline[1] - outline[0]).normalize_or(DVec2::X));
    let rotation = DQuat::from_rotation_y(libm::atan2(along.y, along.x));
    Frame { origin: DVec3::new(first.x, region.elevation, -first.y), rotation }
}

/// What rules can ask of the region.
pub(super) fn facts(region: &Region, start: Arc<str>) -> Initial {
    let lists = region.attributes.iter().filter_map(|(name, value)| {
        Some((name.strip_prefix("/edgeattr/").unwrap_or(name).into(), value.as_array()?.clone()))
    });
    Initial {
        name: region.name.clone(),
        start,
        kind: region.kind.word().into(),
        zone: region.zone.clone(),
        object: object(region),
        outline: Some(region.polygon.clone()),
        edge_attributes: lists.collect(),
    }
}

/// The features of the lot, under the word of their kind.
pub(super) fn intra(layout: &Layout, region: &Region) -> Occluders {
    let mut set = Occluders::new(region.polygon.bounds());
    region.features.iter().filter_map(|i| layout.features.get(*i)).for_each(|feature| occlude(feature, &mut set));
    set
}

/// The features outside the lot from which its plants keep away, and the trees in it and around it with their crowns.
pub(super) fn around(layout: &Layout, region: &Region, features: &BoxGrid) -> (Occluders, Standing) {
    let near = region.polygon.bounds().grown(AROUND);
    let mut found: Vec<usize> = features.touching(near).filter(|i| !is_itself(region, &layout.features[*i])).collect();
    found.sort_unstable();
    let (mut beyond, mut standing) = (Occluders::new(near), Standing::default());
    for index in found {
        let feature = &layout.features[index];
        match (&feature.kind, &feature.shapes) {
            (Kind::Tree, Shapes::Points(points)) => {
                points.iter().for_each(|p| _ = standing.add(Disk { position: *p, radius: crown_radius(feature) }));
            }
            _ if region.features.binary_search(&index).is_err() => occlude(feature, &mut beyond),
            _ => {}
        }
    }
    (beyond, standing)
}

/// Every kind and layer of the layout.
pub(super) fn names(layout: &Layout) -> impl Iterator<Item = Arc<str>> {
    let kinds = layout.features.iter().map(|f| &f.kind).chain(layout.regions.iter().map(|r| &r.kind));
    let attributes = layout.features.iter().map(|f| &f.attributes).chain(layout.regions.iter().map(|r| &r.attributes));
    let layers = attributes.filter_map(|attributes| attributes.get("layer")?.as_str());
    kinds.map(Kind::word).chain(layers).map(Into::into)
}

/// Where each feature reaches.
pub(super) fn reaches(layout: &Layout) -> BoxGrid {
    let bounds = |feature: &Feature| extents(feature).iter().fold(Bounds::EMPTY, |all, e| all.union(e.bounds()));
    BoxGrid::new(&layout.features.iter().map(bounds).collect::<Vec<_>>())
}

/// A street on which rules start is a region and a feature.
fn is_itself(region: &Region, feature: &Feature) -> bool {
    let rest = region.id.strip_prefix(&*feature.id).filter(|_| !feature.id.is_empty());
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

fn occlude(feature: &Feature, set: &mut Occluders) {
    let layer = feature.attributes.get("layer").and_then(Value::as_str);
    for extent in extents(feature) {
        let (label, layer) = (Some(feature.kind.word().into()), layer.map(Into::into));
        set.add(Occluder { label, layer, node: None, footprint: footprint(feature, extent) });
    }
}

/// The neighbours' initial shapes, under the word of their kind.
pub(super) fn inter(layout: &Layout, region: &Region) -> Occluders {
    let mut set = Occluders::new(region.polygon.bounds().grown(1.0));
    for neighbour in region.neighbours.iter().filter_map(|i| layout.regions.get(*i)) {
        let extent = Extent::Area(neighbour.polygon.clone().into());
        let (low, high) = (neighbour.elevation, neighbour.elevation);
        let label = Some(neighbour.kind.word().into());
        let layer = neighbour.attributes.get("layer").and_then(Value::as_str).map(Into::into);
        set.add(Occluder { label, layer, node: None, footprint: Footprint { extent, low, high, closed: false } });
    }
    set
}

fn footprint(feature: &Feature, extent: Extent) -> Footprint {
    let (low, high) = (feature.elevation, feature.elevation + feature.height);
    let closed = matches!(feature.kind, Kind::Building | Kind::Tree);
    Footprint { extent, low, high: high.max(low + f64::from(u8::from(closed))), closed }
}

fn extents(feature: &Feature) -> Vec<Extent> {
    match &feature.shapes {
        Shapes::Areas(polygons) => polygons.iter().map(|p| Extent::Area(p.clone().into())).collect(),
        Shapes::Lines(lines, width) if *width > 0.0 => {
            lines.iter().map(|line| Extent::Area(stroke(line, *width))).collect()
        }
        Shapes::Lines(lines, _) => lines.iter().map(|line| Extent::Line(line.clone())).collect(),
        Shapes::Points(points) if feature.kind == Kind::Tree => points.iter().map(|p| crown(feature, *p)).collect(),
        Shapes::Points(points) => points.iter().map(|p| Extent::Point(*p)).collect(),
    }
}

/// A standing tree keeps its crown clear, or two metres where its crown is not known.
fn crown(feature: &Feature, at: DVec2) -> Extent {
    let radius = crown_radius(feature);
    crate::geometry::Polygon::regular(at, radius, 16).map_or(Extent::Point(at), |p| Extent::Area(p.into()))
}

/// `crown_radius`, half of `crown_diameter`, or 2 m.
pub(crate) fn crown_radius(feature: &Feature) -> f64 {
    let number = |name: &str| feature.attributes.get(name).and_then(crate::value::Value::as_float);
    number("crown_radius").or(number("crown_diameter").map(|d| d * 0.5)).filter(|r| *r > 0.0).unwrap_or(2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;
    use crate::shape::on_plan;

    #[test]
    fn first_edge_decides_the_scope_and_nothing_moves() {
        let ring = [DVec2::new(10.0, 5.0), DVec2::new(18.0, 11.0), DVec2::new(15.0, 15.0), DVec2::new(7.0, 9.0)];
        let polygon = Polygon::new(&ring, &[]).unwrap();
        let region = Region {
            id: "a".into(),
            name: "a".into(),
            kind: Kind::Lot,
            zone: "".into(),
            polygon,
            elevation: 3.0,
            start: None,
            seed: None,
            attributes: Default::default(),
            features: Vec::new(),
            neighbours: Vec::new(),
        };
        let shape = shape(&region, Seed(1));
        assert!((shape.scope.size - DVec3::new(10.0, 0.0, 5.0)).length() < 1e-9, "{}", shape.scope.size);
        let Geometry::Flat(plane, area) = &shape.geometry else { panic!("a lot is flat") };
        let back: Vec<DVec2> =
            area.polygons()[0].outer().iter().map(|p| on_plan(shape.scope.frame.to_world(plane.at(*p)))).collect();
        assert!(back.iter().zip(ring).all(|(a, b)| a.distance(b) < 1e-9), "{back:?}");
        // The first edge is the front: it lies at z = sz.
        assert!((plane.at(area.polygons()[0].outer()[0]).z - 5.0).abs() < 1e-9);
    }
}
