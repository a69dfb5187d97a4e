//! Points in polygons: all inside, as many as promised, spread as promised, always the same.

use bosquet::geometry::{Area, Polygon};
use bosquet::placement::{MOST_POINTS, PlacementError, distributed, gaussian, homogeneous, uniform};
use bosquet::seed::Seed;
use glam::DVec2;
use proptest::prelude::*;

/// A star-shaped polygon with a star-shaped hole in it, and a second part beside it.
fn star(radii: &[f64], hole: f64) -> Area {
    let ring = |scale: f64, centre: DVec2| -> Vec<DVec2> {
        let step = std::f64::consts::TAU / radii.len() as f64;
        radii.iter().enumerate().map(|(i, r)| centre + DVec2::from_angle(step * i as f64) * *r * scale).collect()
    };
    let holes = if hole > 0.0 { vec![ring(hole, DVec2::ZERO)] } else { Vec::new() };
    let beside = Polygon::new(&ring(0.2, DVec2::new(80.0, 3.0)), &[]);
    Polygon::new(&ring(1.0, DVec2::ZERO), &holes).into_iter().chain(beside).collect()
}

fn square(side: f64) -> Area {
    Polygon::rectangle(DVec2::ZERO, DVec2::splat(side)).expect("an extent").into()
}

fn nearest_distances(points: &[DVec2]) -> Vec<f64> {
    let nearest = |p: &DVec2| points.iter().filter(|q| *q != p).map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
    points.iter().map(nearest).collect()
}

/// Standard deviation over mean.
fn variation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64;
    variance.sqrt() / mean
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn points_lie_inside_and_come_again(
        radii in prop::collection::vec(4.0f64..30.0, 5..24),
        hole in prop_oneof![Just(0.0), 0.2..0.7],
        count in 0usize..200,
        seed in any::<u64>(),
    ) {
        let (area, seed) = (star(&radii, hole), Seed(seed));
        let spread = uniform(&area, count, seed).expect("allowed");
        prop_assert_eq!(spread.len(), count);
        let density = 0.05;
        let even = homogeneous(&area, density, seed).expect("allowed");
        prop_assert_eq!(even.len(), (area.area() * density).round() as usize);
        let gathered = gaussian(&area, count, DVec2::new(5.0, 0.0), DVec2::new(9.0, 4.0), seed).expect("allowed");
        prop_assert_eq!(gathered.points.len() + gathered.missing, count);
        let middle = distributed(&area, density, 0.5, seed).expect("allowed");
        prop_assert_eq!(middle.points.len() + middle.missing, even.len());
        for point in spread.iter().chain(&even).chain(&gathered.points).chain(&middle.points) {
            prop_assert!(area.contains(*point), "{point} lies outside");
        }
        prop_assert_eq!(&uniform(&area, count, seed).expect("allowed"), &spread);
        prop_assert_eq!(&homogeneous(&area, density, seed).expect("allowed"), &even);
        let more = uniform(&area, count + 1, seed).expect("allowed");
        prop_assert_eq!(&more[..count], &spread[..], "one more moves none");
    }

    #[test]
    fn homogeneous_points_keep_equal_distances(seed in any::<u64>()) {
        let points = homogeneous(&square(100.0), 0.04, Seed(seed)).expect("allowed");
        prop_assert_eq!(points.len(), 400);
        let distances = nearest_distances(&points);
        prop_assert!(variation(&distances) < 0.2, "{}", variation(&distances));
        // Poisson points have pairs at a twentieth of this; hexagons reach 1.07 of the root of the share of each.
        prop_assert!(distances.iter().all(|d| *d > 0.5 * 5.0), "two points nearly touch");
    }
}

#[test]
fn uniform_points_fill_equal_cells_equally() {
    // A square with a square hole: 12 cells of equal area are left of 16. Chi-square with 11 degrees of freedom
    // exceeds 31.26 once in a thousand.
    let outer = Polygon::rectangle(DVec2::ZERO, DVec2::splat(40.0)).expect("an extent");
    let hole = Polygon::rectangle(DVec2::splat(10.0), DVec2::splat(30.0)).expect("an extent");
    let area = Area::from(Polygon::new(outer.outer(), &[hole.outer().to_vec()]).expect("a frame"));
    let points = uniform(&area, 24_000, Seed(11)).expect("allowed");
    let mut cells = [[0u32; 4]; 4];
    for point in points {
        let cell = (point / 10.0).floor().clamp(DVec2::ZERO, DVec2::splat(3.0));
        cells[cell.x as usize][cell.y as usize] += 1;
    }
    let expected = 24_000.0 / 12.0;
    let counts = cells.iter().flatten().filter(|count| **count > 0);
    let chi: f64 = counts.clone().map(|count| (f64::from(*count) - expected).powi(2) / expected).sum();
    assert!(counts.count() == 12 && chi < 31.26, "{chi} {cells:?}");
}

#[test]
fn gathered_points_have_their_moments() {
    let deviation = DVec2::new(6.0, 3.0);
    let scatter = gaussian(&square(100.0), 20_000, DVec2::splat(50.0), deviation, Seed(3)).expect("allowed");
    let mean = scatter.points.iter().sum::<DVec2>() / 20_000.0;
    let spread = scatter.points.iter().map(|p| (*p - mean).powf(2.0)).sum::<DVec2>() / 20_000.0;
    assert!(scatter.missing == 0 && mean.distance(DVec2::splat(50.0)) < 0.15, "{mean}");
    assert!((spread.x.sqrt() - 6.0).abs() < 0.1 && (spread.y.sqrt() - 3.0).abs() < 0.05, "{spread}");
}

#[test]
fn what_has_no_place_is_counted() {
    let far = gaussian(&square(10.0), 5_000, DVec2::splat(1e6), DVec2::ONE, Seed(1)).expect("allowed");
    assert_eq!((far.points.len(), far.missing), (0, 5_000));
    assert_eq!(uniform(&Area::empty(), 9, Seed(1)), Ok(vec![]));
    assert_eq!(homogeneous(&Area::empty(), 9.0, Seed(1)), Ok(vec![]));
    let one = homogeneous(&square(10.0), 0.01, Seed(1)).expect("allowed");
    assert!(one.len() == 1 && one[0].distance(DVec2::splat(5.0)) < 0.1, "a single one stands in the middle: {one:?}");
}

#[test]
fn limits_are_named() {
    let error = homogeneous(&square(1e5), 1.0, Seed(1)).expect_err("too many");
    assert_eq!(error.to_string(), "10,000,000,000 points are more than the limit of 10,000,000 in one shape");
    assert_eq!(uniform(&square(1.0), MOST_POINTS + 1, Seed(1)), Err(PlacementError::TooMany(10_000_001.0)));
    assert_eq!(homogeneous(&square(1.0), -1.0, Seed(1)), Err(PlacementError::Density(-1.0)));
    assert!(matches!(homogeneous(&square(1.0), f64::NAN, Seed(1)), Err(PlacementError::Density(_))));
    assert_eq!(distributed(&square(9.0), 1.0, -0.5, Seed(1)), Err(PlacementError::Deviation(-0.5)));
    let bad = gaussian(&square(9.0), 1, DVec2::ZERO, DVec2::new(f64::INFINITY, 1.0), Seed(1));
    assert_eq!(bad, Err(PlacementError::Deviation(f64::INFINITY)));
}
