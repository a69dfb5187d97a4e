//! Disks at random: where they may stand, as near as their radii allow, and none left out.

use bosquet::geometry::{Area, Bounds, PointGrid, Polygon};
use bosquet::placement::{
    Amount, Body, Disk, Field, Grid, MOST_POINTS, Placed, PlacementError, Radii, Site, Spot, Stop, boundary, clusters,
    semirandom, single, uniform,
};
use bosquet::seed::Seed;
use glam::DVec2;
use proptest::prelude::*;
use std::sync::Arc;

/// Overlaps up to this are rounding, metres.
const TOLERANCE: f64 = 1e-9;

/// A star-shaped ring: one radius for each direction.
fn ring(centre: DVec2, radii: &[f64]) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / radii.len() as f64;
    radii.iter().enumerate().map(|(i, r)| centre + DVec2::from_angle(step * i as f64) * *r).collect()
}

/// A concave star with star-shaped holes around its middle, all drawn from a seed; its greatest extent is `size`.
fn star(seed: u64, vertices: usize, holes: usize, size: f64) -> Area {
    let mut random = Seed(seed).draw("star");
    let mut radii = |count: usize, low: f64, high: f64| -> Vec<f64> {
        (0..count).map(|_| random.uniform(low, high) * size * 0.5).collect()
    };
    let outer = ring(DVec2::ZERO, &radii(vertices, 0.55, 1.0));
    let holes: Vec<Vec<DVec2>> = (0..holes)
        .map(|hole| {
            let centre = DVec2::from_angle(hole as f64 * std::f64::consts::TAU / holes as f64) * (0.15 * size);
            ring(centre, &radii(16, 0.05, 0.12))
        })
        .collect();
    Polygon::new(&outer, &holes).into_iter().collect()
}

fn square(side: f64) -> Area {
    Polygon::rectangle(DVec2::ZERO, DVec2::splat(side)).expect("an extent").into()
}

fn varied(mean: f64, deviation: f64) -> Radii {
    Radii { mean: Field::Constant(mean), deviation, least: None }
}

fn all(site: &Site, radii: &Radii, seed: u64) -> Placed {
    semirandom(site, radii, &Amount::default(), Seed(seed)).expect("allowed")
}

fn until(stop: Stop) -> Amount {
    Amount { stop, ..Amount::default() }
}

/// The neighbours of places among disks.
struct Near<'a> {
    spots: &'a [Spot],
    grid: PointGrid,
    most: f64,
}

impl Near<'_> {
    fn of(spots: &[Spot]) -> Near<'_> {
        let most = spots.iter().map(|s| s.radius).fold(1e-3, f64::max);
        let points: Vec<DVec2> = spots.iter().map(|s| s.position).collect();
        Near { spots, grid: PointGrid::new(&points, 2.0 * most), most }
    }

    /// Whether a disk of the radius overlaps none.
    fn fits(&self, p: DVec2, radius: f64) -> bool {
        let mut near = self.grid.within(p, radius + self.most);
        near.all(|i| self.spots[i].position.distance(p) >= self.spots[i].radius + radius)
    }

    /// The greatest overlap of two disks, metres; negative where none touch.
    fn overlap(&self) -> f64 {
        let pair = |i: usize, j: usize| {
            let (a, b) = (&self.spots[i], &self.spots[j]);
            a.radius + b.radius - a.position.distance(b.position)
        };
        (0..self.spots.len())
            .flat_map(|i| {
                let near = self.grid.within(self.spots[i].position, self.spots[i].radius + self.most);
                near.filter(move |j| *j != i).map(move |j| pair(i, j))
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Places where `also` holds and the least radius still fits, of `probes` thrown over the site.
fn free(site: &Site, radii: &Radii, spots: &[Spot], probes: usize, also: impl Fn(DVec2) -> bool) -> Option<DVec2> {
    let near = Near::of(spots);
    let least = |p: DVec2| radii.range(radii.mean.at(p))[0] + TOLERANCE;
    let thrown = uniform(site.area(), probes, Seed(99)).expect("allowed");
    thrown.into_iter().find(|p| near.fits(*p, least(*p)) && also(*p) && site.allows(*p, least(*p)))
}

/// What holds for all that was placed.
fn sound(site: &Site, radii: &Radii, spots: &[Spot]) -> Result<(), TestCaseError> {
    let overlap = Near::of(spots).overlap();
    prop_assert!(overlap <= TOLERANCE, "overlap of {overlap} m");
    for spot in spots {
        let [low, high] = radii.range(radii.mean.at(spot.position));
        prop_assert!((low..=high).contains(&spot.radius), "a radius of {}, not {low} to {high}", spot.radius);
        prop_assert!(site.allows(spot.position, spot.radius - TOLERANCE), "{} is not allowed", spot.position);
        prop_assert!((spot.direction.length() - 1.0).abs() < 1e-9);
    }
    Ok(())
}

/// Buildings, a path, a well and a tree in a star of 60 m.
fn furnished(seed: u64, clearance: f64) -> Site {
    let mut random = Seed(seed).draw("things");
    let mut place = || DVec2::new(random.uniform(-25.0, 25.0), random.uniform(-25.0, 25.0));
    let house = Polygon::regular(place(), 4.0, 5).expect("a pentagon");
    Site::new(star(seed, 24, 3, 60.0))
        .clear_of(Body::Area(house.into()), clearance)
        .clear_of(Body::Line(vec![place(), place(), place()]), 0.75 * clearance)
        .clear_of(Body::Point(place()), 2.0)
        .standing([Disk { position: place(), radius: 4.0 }, Disk { position: place(), radius: 0.5 }])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn plants_stand_apart_inside_and_leave_no_gap(
        shape in any::<u64>(),
        vertices in 5usize..40,
        holes in 0usize..6,
        mean in 0.8f64..4.0,
        spread in prop_oneof![Just(0.0), 0.05..0.5],
        seed in any::<u64>(),
    ) {
        let site = Site::new(star(shape, vertices, holes, 60.0));
        let radii = varied(mean, mean * spread);
        let placed = all(&site, &radii, seed);
        sound(&site, &radii, &placed.spots)?;
        prop_assert_eq!(free(&site, &radii, &placed.spots, 4_000, |_| true), None);
        prop_assert_eq!(all(&site, &radii, seed), placed);
    }

    #[test]
    fn what_stands_in_the_way_is_kept_clear(
        shape in any::<u64>(),
        clearance in 0.0f64..6.0,
        seam in any::<bool>(),
        spread in prop_oneof![Just(0.0), Just(0.4)],
        seed in any::<u64>(),
    ) {
        let mut site = furnished(shape, clearance);
        if seam {
            site = site.within(star(shape ^ 1, 9, 0, 50.0));
        }
        let radii = varied(1.2, spread);
        let spots = all(&site, &radii, seed).spots;
        sound(&site, &radii, &spots)?;
        prop_assert_eq!(free(&site, &radii, &spots, 4_000, |_| true), None);
    }

    #[test]
    fn a_band_follows_the_edges(shape in any::<u64>(), width in 0.0f64..8.0, seed in any::<u64>()) {
        let rim = star(shape, 20, 2, 60.0);
        let site = furnished(shape, 1.0);
        let radii = varied(1.0, 0.2);
        let spots = boundary(&site, &rim, width, &radii, &Amount::default(), Seed(seed)).expect("allowed").spots;
        sound(&site, &radii, &spots)?;
        let within = |p: DVec2, width: f64| rim.contains(p) && rim.distance_to_edges(p) <= width;
        prop_assert!(spots.iter().all(|s| within(s.position, width + TOLERANCE)));
        prop_assert_eq!(free(&site, &radii, &spots, 4_000, |p| within(p, width - TOLERANCE)), None);
    }

    #[test]
    fn clusters_are_disks_of_plants(
        shape in any::<u64>(),
        radius in 2.0f64..12.0,
        least in 0usize..4,
        more in 0usize..4,
        seed in any::<u64>(),
    ) {
        let site = furnished(shape, 1.0);
        let radii = varied(1.0, 0.2);
        let counts = [least, least + more];
        let spots = clusters(&site, radius, counts, &radii, &Amount::default(), Seed(seed)).expect("allowed").spots;
        sound(&site, &radii, &spots)?;
        prop_assert!(spots.iter().all(|s| (s.cluster as usize) < counts[1]));
        prop_assert_eq!(spots.is_empty(), spots.is_empty() && least == 0, "no plant in {} clusters", least);
        for cluster in 0..counts[1] as u32 {
            let own: Vec<&Spot> = spots.iter().filter(|s| s.cluster == cluster).collect();
            let far = own.iter().flat_map(|a| own.iter().map(|b| a.position.distance(b.position))).fold(0.0, f64::max);
            prop_assert!(far <= 2.0 * radius + TOLERANCE, "{far} m apart in a cluster");
        }
    }

    #[test]
    fn the_radius_may_vary_over_the_plan(shape in any::<u64>(), slope in 0.0f64..0.05, seed in any::<u64>()) {
        let bounds = Bounds { min: DVec2::splat(-20.0), max: DVec2::splat(25.0) };
        let hills = |p: DVec2| Ok::<f64, ()>(2.0 + slope * p.x + 0.6 * (p.y * 0.2).sin());
        let grid = Grid::sample(bounds, [12, 9], hills).expect("numbers");
        let radii = Radii { mean: Field::Grid(Arc::new(grid)), deviation: 0.2, least: None };
        let site = furnished(shape, 2.0);
        let spots = all(&site, &radii, seed).spots;
        sound(&site, &radii, &spots)?;
        prop_assert_eq!(free(&site, &radii, &spots, 4_000, |_| true), None);
    }

    #[test]
    fn counts_are_kept_or_reported(shape in any::<u64>(), count in 0usize..400, seed in any::<u64>()) {
        let site = Site::new(star(shape, 24, 3, 60.0));
        let radii = varied(1.5, 0.3);
        let placed = semirandom(&site, &radii, &until(Stop::Count(count)), Seed(seed)).expect("allowed");
        sound(&site, &radii, &placed.spots)?;
        prop_assert_eq!(placed.spots.len() + placed.missing, count);
        prop_assert!(placed.missing == 0 || free(&site, &radii, &placed.spots, 4_000, |_| true).is_none());
        let density = count as f64 / 10_000.0;
        let spread = semirandom(&site, &radii, &until(Stop::PerArea(density)), Seed(seed)).expect("allowed");
        prop_assert_eq!(spread.spots.len() + spread.missing, (site.area().area() * density).round() as usize);
    }

    #[test]
    fn a_density_keeps_its_share_and_a_greater_one_the_same(
        shape in any::<u64>(),
        shares in (0.0f64..=1.0, 0.0f64..=1.0),
        seed in any::<u64>(),
    ) {
        let site = Site::new(star(shape, 12, 2, 60.0));
        let radii = Radii::constant(1.0);
        let (low, high) = (shares.0.min(shares.1), shares.0.max(shares.1));
        let kept = |share: f64| {
            let amount = Amount { density: Field::Constant(share), ..Amount::default() };
            semirandom(&site, &radii, &amount, Seed(seed)).expect("allowed").spots
        };
        let (few, many, full) = (kept(low), kept(high), kept(1.0));
        prop_assert_eq!(few.len(), (low * full.len() as f64).round() as usize);
        prop_assert!(few.iter().all(|spot| many.contains(spot)) && many.iter().all(|spot| full.contains(spot)));
    }

    #[test]
    fn slivers_and_far_parts_are_filled(
        parts in prop::collection::vec((-1e5f64..1e5, -1e5f64..1e5, 0.01f64..30.0, 1e-6f64..3.0), 0..6),
        seed in any::<u64>(),
    ) {
        let strip = |(i, (x, y, length, width)): (usize, (f64, f64, f64, f64))| {
            // Apart by their number, askew by their place.
            let at = DVec2::new(x + 1e6 * i as f64, y);
            let along = DVec2::from_angle(x) * length;
            Polygon::new(&[at, at + along, at + along + along.perp().normalize() * width], &[])
        };
        let site = Site::new(parts.into_iter().enumerate().filter_map(strip).collect());
        let radii = varied(1.0, 0.2);
        let spots = all(&site, &radii, seed).spots;
        sound(&site, &radii, &spots)?;
        prop_assert_eq!(free(&site, &radii, &spots, 2_000, |_| true), None);
    }
}

#[test]
fn a_million_probes_find_no_gap() {
    let size = 400.0;
    let house =
        |x: f64, y: f64| Polygon::rectangle(DVec2::new(x, y), DVec2::new(x + 22.0, y + 13.0)).expect("an extent");
    let site = [(-110.0, 40.0), (60.0, 70.0), (-30.0, -120.0)]
        .into_iter()
        .fold(Site::new(star(11, 80, 5, size)), |site, (x, y)| site.clear_of(Body::Area(house(x, y).into()), 6.0));
    let radii = varied(2.0, 0.5);
    let spots = all(&site, &radii, 5).spots;
    assert!(sound(&site, &radii, &spots).is_ok());
    assert_eq!(free(&site, &radii, &spots, 1_000_000, |_| true), None);
}

#[test]
fn one_radius_packs_as_random_disks_do() {
    // Random sequential adsorption jams at a coverage of 0.547 (Feder 1980); Clark and Evans' ratio of it and the
    // distance of nearest neighbours were measured on other programs' sets (two of them agree).
    let (side, radius) = (600.0, 1.0);
    let spots = all(&Site::new(square(side)), &Radii::constant(radius), 3).spots;
    let near = Near::of(&spots);
    let inner: Vec<&Spot> =
        spots.iter().filter(|s| (s.position - side * 0.5).abs().max_element() < side * 0.5 - 10.0).collect();
    let inner_area = (side - 20.0) * (side - 20.0);
    let coverage = inner.len() as f64 * std::f64::consts::PI * radius * radius / inner_area;
    assert!((coverage - 0.547).abs() < 0.003, "{coverage}");
    let nearest = |s: &Spot| {
        let others = near.grid.within(s.position, 8.0).map(|i| spots[i].position.distance(s.position));
        others.filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min)
    };
    let mean = inner.iter().map(|s| nearest(s)).sum::<f64>() / inner.len() as f64;
    let ratio = 2.0 * mean * (inner.len() as f64 / inner_area).sqrt();
    assert!((ratio - 1.761).abs() < 0.01, "{ratio}");
    assert!((mean / (2.0 * radius) - 1.054).abs() < 0.005, "{mean}");
}

#[test]
fn a_count_is_spread_over_the_whole() {
    // A quarter of what fits: each sixteenth gets its share, give or take five deviations of a count by chance.
    let spots = semirandom(&Site::new(square(160.0)), &varied(1.0, 0.2), &until(Stop::Count(1600)), Seed(7));
    let mut counts = [[0; 4]; 4];
    for spot in spots.expect("allowed").spots {
        let cell = (spot.position / 40.0).floor().clamp(DVec2::ZERO, DVec2::splat(3.0));
        counts[cell.x as usize][cell.y as usize] += 1;
    }
    assert!(counts.iter().flatten().all(|count| (50..=150).contains(count)), "{counts:?}");
}

#[test]
fn sparse_radii_keep_their_distribution() {
    let amount = until(Stop::Count(2_000));
    let spots = semirandom(&Site::new(square(1e4)), &varied(2.0, 0.5), &amount, Seed(1)).expect("allowed").spots;
    let mean = spots.iter().map(|s| s.radius).sum::<f64>() / spots.len() as f64;
    let variance = spots.iter().map(|s| (s.radius - mean).powi(2)).sum::<f64>() / spots.len() as f64;
    // A normal distribution cut off at two deviations has 0.880 of the deviation.
    assert!((mean - 2.0).abs() < 0.04 && (variance.sqrt() - 0.44).abs() < 0.03, "{mean} {}", variance.sqrt());
}

#[test]
fn a_single_plant_stands_anywhere_or_is_missing() {
    let site = Site::new(square(40.0)).clear_of(Body::Area(square(20.0)), 0.0);
    let mut counts = [0; 4];
    for seed in 0..1_200 {
        let placed = single(&site, &Radii::constant(0.01), &Amount::default(), Seed(seed)).expect("allowed");
        assert_eq!((placed.spots.len(), placed.missing), (1, 0));
        let cell = (placed.spots[0].position / 20.0).floor().clamp(DVec2::ZERO, DVec2::ONE);
        counts[cell.x as usize + 2 * cell.y as usize] += 1;
    }
    // Three quarters of 400 each; five deviations are 82.
    assert!(counts[0] == 0 && counts[1..].iter().all(|c| (318..=482).contains(c)), "{counts:?}");
    let full = Site::new(square(9.0)).within(square(9.0));
    let placed = single(&full, &Radii::constant(5.0), &Amount::default(), Seed(1)).expect("allowed");
    assert_eq!((placed.spots.len(), placed.missing), (0, 1));
}

#[test]
fn nothing_and_next_to_nothing_have_room_for_little() {
    let (radii, amount) = (Radii::constant(1.0), Amount::default());
    assert_eq!(all(&Site::new(Area::empty()), &radii, 1), Placed::default());
    // Gaps of a millimetre are none; five are found.
    assert_eq!(all(&Site::new(square(5e-3)), &radii, 1).spots.len(), 1);
    assert_eq!(boundary(&Site::default(), &square(9.0), 2.0, &radii, &amount, Seed(1)), Ok(Placed::default()));
    assert_eq!(clusters(&Site::default(), 4.0, [1, 3], &radii, &amount, Seed(1)), Ok(Placed::default()));
    let asked = semirandom(&Site::default(), &radii, &until(Stop::Count(3)), Seed(1)).expect("allowed");
    assert_eq!((asked.spots.len(), asked.missing), (0, 3));
}

#[test]
fn what_is_too_much_is_refused_before_it_is_begun() {
    let site = Site::new(square(1e4));
    let refused = |radii: &Radii| semirandom(&site, radii, &Amount::default(), Seed(1)).expect_err("too many");
    match refused(&Radii::constant(0.5)) {
        PlacementError::Crowded { estimate } => assert!((estimate - 6.97e7).abs() < 3e6, "{estimate}"),
        other => panic!("{other}"),
    }
    assert!(matches!(refused(&Radii::constant(1e-9)), PlacementError::Crowded { .. }));
    assert!(matches!(refused(&Radii::constant(f64::NAN)), PlacementError::Value { parameter: "radius", .. }));
    let fine = Radii { mean: Field::Constant(9.0), deviation: 1.0, least: Some(1e-3) };
    assert!(!matches!(refused(&varied(0.5, 0.2)), PlacementError::Value { .. }));
    assert!(semirandom(&site, &fine, &Amount::default(), Seed(1)).is_ok(), "two deviations are above the least");
    let wide = Radii { mean: Field::Constant(9.0), deviation: 9.0, least: Some(1e-3) };
    assert!(matches!(refused(&wide), PlacementError::Value { parameter: "radius_min", .. }));
    let many = semirandom(&site, &Radii::constant(1.0), &until(Stop::Count(MOST_POINTS + 1)), Seed(1));
    assert_eq!(many, Err(PlacementError::TooMany(10_000_001.0)));
    let few = semirandom(&site, &Radii::constant(1e-6), &until(Stop::Count(5)), Seed(1)).expect("a few have room");
    assert_eq!(few.spots.len(), 5);
}

#[test]
fn a_strip_without_width_comes_to_an_end() {
    // A band as wide as the clearance from the same line leaves a line free and nothing beside it: whatever is found
    // there stands on it, and the search for more ends.
    let rim = square(200.0);
    let outline: Vec<DVec2> = rim.edges().map(|(p, _)| p).chain([DVec2::ZERO]).collect();
    let site = Site::new(rim.clone()).clear_of(Body::Line(outline), 1.5);
    let radii = varied(1.0, 0.2);
    let spots = boundary(&site, &rim, 1.5, &radii, &Amount::default(), Seed(1)).expect("allowed").spots;
    assert!(spots.iter().all(|spot| (rim.distance_to_edges(spot.position) - 1.5).abs() <= TOLERANCE));
}
