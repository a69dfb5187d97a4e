//! Covers and solids as GeoJSON polygons: what the ground is made of, and what stands on it.
//!
//! In: a scene. Out: text in the layout's own coordinates, one feature a line, covers first, in drawing order.

use crate::export::geo::{Coordinates, collection, push_number, push_text};
use crate::geometry::Area;
use crate::scene::{Material, Origin, Scene};

/// What both have in common.
struct Surface<'a> {
    class: &'static str,
    origin: &'a Origin,
    material: &'a Material,
    area: &'a Area,
    elevation: f64,
    height: f64,
}

/// Every cover and every solid's footprint as a feature with its material, area and height.
///
/// `class` is `cover` or `solid`; `elevation` is the height of a cover, or of a solid's foot, above the datum.
pub fn surfaces_geojson(scene: &Scene) -> String {
    let coordinates = Coordinates::new(&scene.georeference);
    collection(scene, "surfaces", surfaces(scene), |out, surface| push_feature(out, &surface, &coordinates))
}

fn surfaces(scene: &Scene) -> impl Iterator<Item = Surface<'_>> {
    let covers = scene.covers.iter().map(|cover| Surface {
        class: "cover",
        origin: &cover.origin,
        material: &cover.material,
        area: &cover.area,
        elevation: cover.elevation,
        height: 0.0,
    });
    covers.chain(scene.solids.iter().map(|solid| Surface {
        class: "solid",
        origin: &solid.origin,
        material: &solid.material,
        area: &solid.footprint,
        elevation: solid.base,
        height: solid.height,
    }))
}

fn push_feature(out: &mut String, surface: &Surface<'_>, coordinates: &Coordinates<'_>) {
    out.push_str("{\"type\":\"Feature\",\"id\":");
    push_text(out, &surface.origin.id);
    out.push_str(",\"geometry\":");
    coordinates.push_area(out, surface.area, surface.elevation);
    out.push_str(",\"properties\":{\"id\":");
    push_text(out, &surface.origin.id);
    let texts = [
        ("class", surface.class),
        ("material", &surface.material.name),
        ("label", &surface.material.label),
        ("lot", &surface.origin.lot),
        ("rule", &surface.origin.rule),
    ];
    for (name, text) in texts {
        push_name(out, name);
        push_text(out, text);
    }
    let area = (surface.area.area() * 1e4).round() / 1e4;
    for (name, number) in [("area_m2", area), ("elevation", surface.elevation), ("height", surface.height)] {
        push_name(out, name);
        push_number(out, number);
    }
    out.push_str("}}");
}

fn push_name(out: &mut String, name: &str) {
    out.push(',');
    push_text(out, name);
    out.push(':');
}
