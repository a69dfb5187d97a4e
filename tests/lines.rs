//! Plants on axes, lattices, lines and rows: where they should be, as far apart as asked, and nowhere else.

use bosquet::geometry::{Area, Bounds, MedialAxis, Path, Polygon, Pruning};
use bosquet::placement::{
    Along, Amount, Body, Field, Lattice, Line, Placed, PlacementError, Radii, Rows, Site, Stop, along, equidistant,
    regular, rows,
};
use bosquet::seed::Seed;
use glam::{DAffine2, DVec2};
use proptest::prelude::*;

/// A star-shaped polygon with a star-shaped hole in it.
fn star(radii: &[f64], hole: f64) -> Area {
    let ring = |scale: f64| -> Vec<DVec2> {
        let step = std::f64::consts::TAU / radii.len() as f64;
        radii.iter().enumerate().map(|(i, r)| DVec2::from_angle(step * i as f64) * *r * scale).collect()
    };
    let holes = if hole > 0.0 { vec![ring(hole)] } else { Vec::new() };
    Polygon::new(&ring(1.0), &holes).into_iter().collect()
}

fn stars() -> impl Strategy<Value = Area> {
    (prop::collection::vec(8.0f64..30.0, 5..24), prop_oneof![Just(0.0), 0.2..0.6]).prop_map(|(r, h)| star(&r, h))
}

fn rectangle(w: f64, h: f64) -> Area {
    Polygon::rectangle(DVec2::ZERO, DVec2::new(w, h)).expect("an extent").into()
}

/// All the rings of an area as lines, the inside to the left.
fn rims(area: &Area) -> Vec<Line> {
    let rings = area.polygons().iter().flat_map(Polygon::rings);
    rings.map(|ring| Line { points: ring.to_vec(), closed: true }).collect()
}

fn lattice(area: &Area, cell: f64, orientation: f64, jitter: f64) -> Lattice {
    Lattice { origin: DVec2::ZERO, direction: DVec2::X, bounds: area.bounds(), cell, orientation, jitter }
}

fn hedge(spacing: f64) -> Along {
    Along { spacing: Field::Constant(spacing), inset: 0.0, corner: 0.0, turn: 20.0, adjust: false }
}

fn whole() -> Amount {
    Amount::default()
}

/// Every disk apart from every other, and allowed.
fn sound(site: &Site, placed: &Placed) -> Result<(), TestCaseError> {
    for (i, spot) in placed.spots.iter().enumerate() {
        prop_assert!(site.allows(spot.position, spot.radius), "{spot:?} is not allowed");
        prop_assert!((spot.direction.length() - 1.0).abs() < 1e-9 && spot.radius > 0.0);
        for other in &placed.spots[..i] {
            let apart = spot.position.distance(other.position);
            prop_assert!(apart >= spot.radius + other.radius - 1e-5, "{spot:?} and {other:?} overlap");
        }
    }
    Ok(())
}

fn alike(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

/// Whether two sets of positions are the same but for rounding and order.
fn same(a: &Placed, b: &Placed, map: DAffine2) -> bool {
    let near = |p: DVec2| b.spots.iter().any(|s| s.position.distance(map.transform_point2(p)) < 1e-6);
    a.spots.len() == b.spots.len() && a.spots.iter().all(|s| near(s.position))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn equidistant_places_lie_on_the_axis_at_the_spacing(area in stars(), spacing in 0.8f64..6.0, seed in any::<u64>()) {
        let axis = MedialAxis::new(&area, Pruning::default());
        let site = Site::new(area.clone());
        let radii = Radii::constant(0.4);
        let placed = equidistant(&site, &axis, &spacing.into(), &radii, &whole(), Seed(seed)).expect("allowed");
        sound(&site, &placed)?;
        prop_assert!(!placed.spots.is_empty());
        for (index, branch) in axis.branches().iter().enumerate() {
            let own: Vec<_> = placed.spots.iter().filter(|s| s.cluster == index as u32).collect();
            let Some(path) = Path::new(&branch.points) else { continue };
            let mut at: Vec<f64> = own.iter().map(|s| path.nearest(s.position).0).collect();
            prop_assert!(own.iter().all(|s| path.distance_to(s.position) < 1e-3));
            at.sort_by(f64::total_cmp);
            for pair in at.windows(2) {
                // Whole steps, since a place near a junction may be left out.
                let steps = (pair[1] - pair[0]) / spacing;
                prop_assert!(branch.is_closed() || (steps - steps.round()).abs() < 1e-6 && steps > 0.5, "{steps}");
            }
        }
        for (i, a) in placed.spots.iter().enumerate() {
            let others = placed.spots[..i].iter().filter(|b| b.cluster != a.cluster);
            let nearest = others.map(|b| b.position.distance(a.position)).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest >= spacing * (1.0 - 1e-6), "{nearest} m at a spacing of {spacing} m");
        }
    }

    #[test]
    fn lattices_are_lattices_and_jitter_stays_in_the_cell(
        area in stars(), cell in 2.0f64..6.0, orientation in 0.0f64..180.0, jitter in 0.0f64..1.0, seed in any::<u64>(),
    ) {
        let site = Site::new(area.clone());
        let radii = Radii::constant(0.3);
        let seed = Seed(seed);
        let exact = regular(&site, &lattice(&area, cell, orientation, 0.0), &radii, &whole(), seed).expect("allowed");
        sound(&site, &exact)?;
        let axis = DVec2::from_angle(orientation.to_radians());
        let own = |p: DVec2| DVec2::new(axis.dot(p), axis.perp_dot(p)) / cell;
        let Some(first) = exact.spots.first() else { return Ok(()) };
        for spot in &exact.spots {
            let steps = own(spot.position - first.position);
            prop_assert!((steps - steps.round()).length() < 1e-6, "{steps}");
        }
        let loose = regular(&site, &lattice(&area, cell, orientation, jitter), &radii, &whole(), seed).expect("allowed");
        sound(&site, &loose)?;
        let mut cells: Vec<[i64; 2]> = Vec::new();
        for spot in &loose.spots {
            let steps = own(spot.position - first.position);
            prop_assert!((steps - steps.round()).abs().max_element() <= 0.5 * jitter + 1e-6);
            cells.push(steps.round().to_array().map(|c| c as i64));
        }
        let count = cells.len();
        cells.sort_unstable();
        cells.dedup();
        prop_assert_eq!(count, cells.len(), "one plant a cell");
    }

    #[test]
    fn every_allowed_middle_of_a_cell_has_its_plant(area in stars(), cell in 1.0f64..5.0) {
        let site = Site::new(area.clone());
        let lattice = lattice(&area, cell, 0.0, 0.0);
        let placed = regular(&site, &lattice, &Radii::constant(0.3), &whole(), Seed(1)).expect("allowed");
        let size = area.bounds().size();
        let count = (size / cell).floor().max(DVec2::ONE);
        let first = area.bounds().centre() - 0.5 * cell * (count - 1.0);
        let mut inside = 0;
        for x in 0..count.x as usize {
            for y in 0..count.y as usize {
                inside += usize::from(site.allows(first + cell * DVec2::new(x as f64, y as f64), 0.3));
            }
        }
        prop_assert_eq!(placed.spots.len(), inside);
    }

    #[test]
    fn plants_along_a_rim_keep_their_inset(
        area in stars(), spacing in 1.0f64..4.0, inset in 0.0f64..5.0, corner in 0.0f64..2.0, adjust in any::<bool>(),
    ) {
        let site = Site::new(area.clone());
        let options = Along { inset, corner, adjust, ..hedge(spacing) };
        let radii = Radii { mean: Field::Constant(0.5), deviation: 0.1, least: Some(0.1) };
        let placed = along(&site, &rims(&area), &options, &radii, &whole(), Seed(3)).expect("allowed");
        sound(&site, &placed)?;
        for spot in &placed.spots {
            let edge = area.nearest_edge(spot.position).expect("a rim");
            prop_assert!(edge.distance >= inset - 1e-6, "{} m", edge.distance);
            let beside = area.edges().any(|(a, b)| {
                let along = (b - a).normalize();
                ((spot.position - a).perp_dot(along).abs() - inset).abs() < 1e-6 && spot.direction.dot(along) > 1.0 - 1e-9
            });
            prop_assert!(beside, "{spot:?} stands beside no edge");
        }
        if inset == 0.0 {
            let near = |p: DVec2| area.polygons()[0].points().iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min);
            prop_assert!(placed.spots.iter().all(|s| near(s.position) >= corner - 1e-9));
        }
    }

    #[test]
    fn rows_keep_their_lattice_and_their_inset(
        area in stars(), spacing in 1.0f64..5.0, distance in 1.0f64..5.0, inset in 0.0f64..3.0, angle in 0.0f64..6.3,
    ) {
        let site = Site::new(area.clone());
        let axis = DVec2::from_angle(angle);
        let planted = Rows { spacing, distance, inset, stagger: 0.5 };
        let placed = rows(&site, axis, &planted, &Radii::constant(0.4), &whole(), Seed(3)).expect("allowed");
        sound(&site, &placed)?;
        let Some(first) = placed.spots.first() else { return Ok(()) };
        for spot in &placed.spots {
            prop_assert!(area.distance_to_edges(spot.position) >= inset - 1e-6);
            let row = axis.perp_dot(spot.position - first.position) / distance;
            let steps = axis.dot(spot.position - first.position) / spacing + 0.5 * row.round();
            prop_assert!((row - row.round()).abs() < 1e-6 && (steps - steps.round()).abs() < 1e-6);
            prop_assert_eq!(spot.cluster as i64 - first.cluster as i64, row.round() as i64);
        }
    }

    #[test]
    fn what_is_moved_and_turned_is_planted_alike(area in stars(), angle in 0.0f64..6.3, x in -500.0f64..500.0) {
        let map = DAffine2::from_angle_translation(angle, DVec2::new(x, 3.0));
        let turned = area.transformed(&map);
        let (here, there) = (Site::new(area.clone()), Site::new(turned.clone()));
        let radii = Radii::constant(0.4);
        let planted = Rows { spacing: 2.3, distance: 1.7, inset: 0.9, stagger: 0.25 };
        let a = rows(&here, DVec2::X, &planted, &radii, &whole(), Seed(1)).expect("allowed");
        let b = rows(&there, DVec2::from_angle(angle), &planted, &radii, &whole(), Seed(1)).expect("allowed");
        prop_assert!(same(&a, &b, map));
        let frame = lattice(&area, 2.1, 20.0, 0.6);
        let moved = Lattice { origin: map.translation, direction: DVec2::from_angle(angle), ..frame };
        let a = regular(&here, &frame, &radii, &whole(), Seed(1)).expect("allowed");
        let b = regular(&there, &moved, &radii, &whole(), Seed(1)).expect("allowed");
        prop_assert!(same(&a, &b, map));
        let options = Along { inset: 1.5, corner: 0.5, ..hedge(1.9) };
        let a = along(&here, &rims(&area), &options, &radii, &whole(), Seed(1)).expect("allowed");
        let b = along(&there, &rims(&turned), &options, &radii, &whole(), Seed(1)).expect("allowed");
        prop_assert!(same(&a, &b, map));
    }

    #[test]
    fn density_is_a_share(share in 0.0f64..=1.0, seed in any::<u64>()) {
        let area = rectangle(60.0, 40.0);
        let amount = Amount { density: Field::Constant(share), ..whole() };
        let planted = Rows::quincunx(2.0, 1.0);
        let placed = rows(&Site::new(area.clone()), DVec2::X, &planted, &Radii::constant(1.0), &amount, Seed(seed)).expect("allowed");
        let full = rows(&Site::new(area), DVec2::X, &planted, &Radii::constant(1.0), &whole(), Seed(seed)).expect("allowed");
        prop_assert_eq!(placed.spots.len(), (share * full.spots.len() as f64).round() as usize);
    }
}

#[test]
fn an_avenue_has_equal_rests() {
    let area = rectangle(40.0, 6.0);
    let axis = MedialAxis::new(&area, Pruning::default());
    let site = Site::new(area);
    let placed = equidistant(&site, &axis, &10.0.into(), &Radii::constant(3.0), &whole(), Seed(1)).expect("allowed");
    // The axis runs from 3 to 37: three steps of 10, and 2 more at each end.
    let mut xs: Vec<f64> = placed.spots.iter().map(|s| s.position.x).collect();
    xs.sort_by(f64::total_cmp);
    assert!(xs.len() == 3 && xs.iter().zip([10.0, 20.0, 30.0]).all(|(x, y)| (x - y).abs() < 0.005), "{xs:?}");
}

#[test]
fn spacing_may_vary_along_the_axis() {
    let area = rectangle(100.0, 2.0);
    let axis = MedialAxis::new(&area, Pruning::default());
    let bounds = Bounds { min: DVec2::ZERO, max: DVec2::new(100.0, 2.0) };
    let grid = bosquet::placement::Grid::sample(bounds, [2, 2], |p| Ok::<f64, ()>(1.0 + 0.04 * p.x)).expect("numbers");
    let spacing = Field::Grid(std::sync::Arc::new(grid));
    let placed =
        equidistant(&Site::new(area), &axis, &spacing, &Radii::constant(0.4), &whole(), Seed(1)).expect("allowed");
    let mut xs: Vec<f64> = placed.spots.iter().map(|s| s.position.x).collect();
    xs.sort_by(f64::total_cmp);
    // Steps from 1.04 to 4.96 metres: the integral of 1 / (1 + 0.04 x) is 25 ln(4.96 / 1.04) = 39.05.
    assert_eq!(xs.len(), 39);
    for pair in xs.windows(2) {
        let middle = 1.0 + 0.02 * (pair[0] + pair[1]);
        assert!(((pair[1] - pair[0]) / middle - 1.0).abs() < 0.01, "{pair:?}");
    }
}

#[test]
fn a_quincunx_has_six_neighbours() {
    let site = Site::new(rectangle(50.0, 50.0));
    let planted = Rows::quincunx(4.0, 1.0);
    let placed = rows(&site, DVec2::Y, &planted, &Radii::constant(2.0), &whole(), Seed(1)).expect("allowed");
    let deep = |p: DVec2| (p - 25.0).abs().max_element() < 15.0;
    for spot in placed.spots.iter().filter(|s| deep(s.position)) {
        let near = placed.spots.iter().filter(|o| (o.position.distance(spot.position) - 4.0).abs() < 1e-9);
        assert_eq!(near.count(), 6, "{spot:?}");
    }
    // 48 m hold 13 plants in a row and 14 rows 3.46 m apart; shifted rows end half a step before the rim.
    assert_eq!(placed.spots.len(), 7 * 13 + 7 * 12);
}

#[test]
fn a_rim_is_planted_from_corner_to_corner() {
    let area = rectangle(20.0, 12.0);
    let site = Site::new(area.clone());
    let options = Along { inset: 1.0, adjust: true, ..hedge(4.0) };
    let placed = along(&site, &rims(&area), &options, &Radii::constant(1.5), &whole(), Seed(1)).expect("allowed");
    // 18 m take 4 steps of 4.5, 10 m take 2 of 5; the four corners are shared.
    assert_eq!(placed.spots.len(), 2 * (4 + 2));
    let at = |x: f64, y: f64| placed.spots.iter().any(|s| s.position.distance(DVec2::new(x, y)) < 1e-9);
    assert!(at(1.0, 1.0) && at(5.5, 1.0) && at(19.0, 6.0) && at(1.0, 11.0), "{placed:?}");
    // Clear of corners by 2 m, in steps of exactly 4.
    let options = Along { inset: 1.0, corner: 2.0, ..hedge(4.0) };
    let placed = along(&site, &rims(&area), &options, &Radii::constant(1.0), &whole(), Seed(1)).expect("allowed");
    let bottom: Vec<f64> = placed.spots.iter().filter(|s| s.cluster == 0).map(|s| s.position.x).collect();
    assert!(alike(&bottom, &[4.0, 8.0, 12.0, 16.0]), "{bottom:?}");
}

#[test]
fn curves_are_run_through() {
    let disk = Polygon::regular(DVec2::ZERO, 20.0, 90).expect("a disk");
    let site = Site::new(disk.clone().into());
    let options = Along { inset: 2.0, corner: 3.0, adjust: true, ..hedge(5.0) };
    let placed =
        along(&site, &rims(&disk.into()), &options, &Radii::constant(2.5), &whole(), Seed(1)).expect("allowed");
    // A circle of 18 m has no corners and takes 22 steps of 5 m.
    assert_eq!(placed.spots.len(), 22);
    assert!(placed.spots.iter().all(|s| s.cluster == 0 && (s.position.length() - 18.0).abs() < 0.03));
}

#[test]
fn a_count_is_spread_evenly_and_what_is_missing_is_said() {
    let street = Line { points: vec![DVec2::new(0.0, 5.0), DVec2::new(100.0, 5.0)], closed: false };
    let site = Site::new(rectangle(100.0, 10.0)).clear_of(Body::Point(DVec2::new(50.0, 5.0)), 6.0);
    let radii = Radii::constant(1.0);
    let counted = |count| {
        let amount = Amount { stop: Stop::Count(count), ..whole() };
        along(&site, std::slice::from_ref(&street), &hedge(5.0), &radii, &amount, Seed(1)).expect("allowed")
    };
    // 21 places, three of them too near to the middle.
    assert_eq!((counted(30).spots.len(), counted(30).missing), (18, 12));
    let half: Vec<f64> = counted(9).spots.iter().map(|s| s.position.x).collect();
    assert!(alike(&half, &[5.0, 15.0, 25.0, 35.0, 60.0, 70.0, 80.0, 90.0, 100.0]), "{half:?}");
}

#[test]
fn parameters_are_named() {
    let area = rectangle(20.0, 10.0);
    let (site, radii) = (Site::new(area.clone()), Radii::constant(1.0));
    let axis = MedialAxis::new(&area, Pruning::default());
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let found = [
            equidistant(&site, &axis, &spacing.into(), &radii, &whole(), Seed(1)),
            along(&site, &rims(&area), &hedge(spacing), &radii, &whole(), Seed(1)),
            rows(&site, DVec2::X, &Rows { spacing, ..Rows::quincunx(3.0, 0.0) }, &radii, &whole(), Seed(1)),
        ];
        for result in found {
            assert!(matches!(result, Err(PlacementError::Value { parameter: "spacing", .. })), "{result:?}");
        }
    }
    let wide = regular(&site, &lattice(&area, 1.5, 0.0, 0.0), &radii, &whole(), Seed(1));
    assert!(matches!(wide, Err(PlacementError::Value { parameter: "radius", .. })), "{wide:?}");
    let jitter = regular(&site, &lattice(&area, 3.0, 0.0, 1.5), &radii, &whole(), Seed(1));
    assert!(matches!(jitter, Err(PlacementError::Value { parameter: "jitter", .. })), "{jitter:?}");
    let tiny = Radii::constant(1e-7);
    let many = regular(&site, &lattice(&area, 1e-6, 0.0, 0.0), &tiny, &whole(), Seed(1));
    assert!(matches!(many, Err(PlacementError::TooMany(_))), "{many:?}");
    let many = equidistant(&site, &axis, &1e-9.into(), &Radii::constant(1e-10), &whole(), Seed(1));
    assert!(matches!(many, Err(PlacementError::TooMany(_))), "{many:?}");
    let none = rows(&Site::default(), DVec2::X, &Rows::quincunx(3.0, 1.0), &radii, &whole(), Seed(1));
    assert_eq!(none, Ok(Placed::default()));
}
