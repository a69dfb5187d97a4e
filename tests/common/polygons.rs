//! Random polygons for property tests: stars with star-shaped holes, always simple, mostly concave.

use bosquet::geometry::{Area, Polygon};
use glam::DVec2;
use proptest::prelude::*;

/// A star around the origin, 5 to 60 m across, with up to three holes that touch neither it nor each other.
pub fn polygon() -> impl Strategy<Value = Polygon> {
    let holes = prop::collection::vec(ring(0.15..0.9), 0..4);
    (ring(0.45..1.0), holes, 5.0..60.0f64).prop_map(|(outer, holes, size)| {
        let outer: Vec<DVec2> = outer.iter().map(|p| *p * size).collect();
        // The star contains the disk of this radius whatever its corners: three seats fit into it.
        let free = size * 0.15;
        let seat = |i: usize| Polygon::regular(DVec2::ZERO, free * 0.55, 3).unwrap().points()[i] + 0.01;
        let seated = |(i, hole): (usize, &Vec<DVec2>)| hole.iter().map(|p| *p * free * 0.4 + seat(i)).collect();
        let holes: Vec<Vec<DVec2>> = holes.iter().enumerate().map(seated).collect();
        Polygon::new(&outer, &holes).expect("stars are sound")
    })
}

/// A convex polygon without holes.
pub fn convex() -> impl Strategy<Value = Polygon> {
    (ring(0.3..1.0), 5.0..60.0f64).prop_map(|(ring, size)| {
        Polygon::new(&ring.iter().map(|p| *p * size).collect::<Vec<_>>(), &[]).expect("stars are sound").hull()
    })
}

/// One polygon, moved to anywhere within a kilometre.
pub fn area() -> impl Strategy<Value = Area> {
    (polygon(), -1e3..1e3f64, -1e3..1e3f64).prop_map(|(p, x, y)| p.translated(DVec2::new(x, y)).into())
}

/// A star-shaped ring around the origin whose corners lie within a range of radii: gaps between corners stay below a
/// half turn, so it contains the disk of about half its least radius.
fn ring(radii: std::ops::Range<f64>) -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((radii, 0.05..0.95f64), 4..14).prop_map(|corners| {
        let step = std::f64::consts::TAU / corners.len() as f64;
        let corner = |(i, (radius, jitter)): (usize, &(f64, f64))| {
            let angle = step * (i as f64 + jitter * 0.5);
            *radius * DVec2::new(libm::cos(angle), libm::sin(angle))
        };
        corners.iter().enumerate().map(corner).collect()
    })
}
