//! Point-pattern statistics: values of other programs, what is known of lattices and of chance, and invariances.
//!
//! The values are from spatstat.explore and spatstat.geom 3.0-6 under R 4.2.2, and SciPy 1.17.1. Points are uniform,
//! rounded to a centimetre.

use bosquet::geometry::{Area, Polygon};
use bosquet::seed::Seed;
use bosquet::stats::{self, Pattern, Window, curves, summary};
use glam::{DAffine2, DVec2};
use proptest::prelude::*;

/// 40 points in the rectangle from (0, 0) to (40, 25).
const FIELD: [(f64, f64); 40] = [
    (39.56, 19.99),
    (15.91, 9.55),
    (4.63, 18.99),
    (2.79, 10.92),
    (9.75, 22.61),
    (31.68, 7.99),
    (13.6, 2.06),
    (38.88, 20.41),
    (6.63, 22.46),
    (18.36, 24.16),
    (6.87, 14.33),
    (9.26, 18.0),
    (30.91, 19.35),
    (3.85, 15.69),
    (18.14, 18.07),
    (3.39, 9.67),
    (22.43, 4.07),
    (0.35, 4.68),
    (39.43, 9.78),
    (12.66, 6.85),
    (25.58, 4.8),
    (11.81, 12.61),
    (39.87, 19.1),
    (36.24, 17.34),
    (39.55, 13.6),
    (2.63, 16.48),
    (25.08, 11.72),
    (19.62, 12.05),
    (38.84, 8.43),
    (14.49, 10.61),
    (27.2, 7.18),
    (10.55, 15.03),
    (7.43, 21.02),
    (7.41, 15.52),
    (15.17, 3.36),
    (33.88, 14.19),
    (19.92, 11.09),
    (31.62, 10.95),
    (33.54, 15.59),
    (18.28, 23.32),
];

/// 30 points in [`park`].
const PARK: [(f64, f64); 30] = [
    (30.21, 19.17),
    (29.87, 11.09),
    (8.23, 1.64),
    (25.21, 20.62),
    (13.18, 17.5),
    (25.91, 22.1),
    (11.83, 5.15),
    (14.17, 23.32),
    (11.7, 14.85),
    (30.99, 15.77),
    (6.19, 6.19),
    (24.58, 19.79),
    (19.45, 8.99),
    (18.36, 21.27),
    (12.07, 4.49),
    (28.02, 17.5),
    (6.33, 3.03),
    (16.53, 21.8),
    (16.9, 21.81),
    (13.16, 14.14),
    (21.87, 24.52),
    (11.69, 18.41),
    (26.02, 21.23),
    (22.69, 10.57),
    (17.45, 21.97),
    (6.06, 10.21),
    (19.13, 20.49),
    (9.15, 10.65),
    (24.45, 20.02),
    (6.56, 1.04),
];

fn points(list: &[(f64, f64)]) -> Vec<DVec2> {
    list.iter().map(|(x, y)| DVec2::new(*x, *y)).collect()
}

fn rectangle(width: f64, height: f64) -> Window {
    let polygon = Polygon::rectangle(DVec2::ZERO, DVec2::new(width, height)).expect("a rectangle");
    Window::new([&Area::from(polygon)]).expect("an area")
}

/// Five corners around a hole of four: 586.5 m².
fn park() -> Window {
    let outline = points(&[(0.0, 0.0), (30.0, 2.0), (34.0, 20.0), (18.0, 28.0), (6.0, 18.0)]);
    let hole = points(&[(12.0, 8.0), (14.0, 16.0), (20.0, 15.0), (19.0, 7.0)]);
    let polygon = Polygon::new(&outline, &[hole]).expect("a polygon");
    Window::new([&Area::from(polygon)]).expect("an area")
}

fn field_pattern() -> Pattern {
    Pattern::new(&points(&FIELD), rectangle(40.0, 25.0)).expect("40 points")
}

fn park_pattern() -> Pattern {
    Pattern::new(&points(&PARK), park()).expect("30 points")
}

#[track_caller]
fn near(found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len());
    let off = |(f, w): (&f64, &f64)| (f - w).abs() / w.abs().max(1.0);
    assert!(found.iter().zip(wanted).all(|pair| off(pair) <= tolerance), "{found:?}, not {wanted:?}");
}

/// K: `Kest(X, correction = "isotropic")$iso` at 1 … 6 m. g: the sum of `pcf.ppp` with `divisor = "r"` written out
/// over `pairdist` and the weights of `edge.Ripley`, half the kernel's width `0.15 / sqrt(intensity(X))` (`pcf` itself
/// goes through a fast Fourier transform and differs in the fourth digit).
#[test]
fn curves_agree_with_spatstat_in_a_rectangle() {
    let found = curves(&field_pattern(), 6.0, 6);
    near(&found.radius, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 1e-12);
    near(&found.k, &[5.035569210, 17.934093702, 24.481974304, 47.921655328, 78.432901956, 121.465392213], 1e-8);
    near(&found.g, &[1.876009256, 0.623723525, 1.000108601, 0.996629813, 1.137668291, 0.981618475], 1e-8);
}

#[test]
fn curves_agree_with_spatstat_around_a_hole() {
    let found = curves(&park_pattern(), 6.0, 6);
    near(&found.k, &[9.437931034, 25.484280168, 40.783820830, 57.810841118, 85.457958447, 142.282592086], 1e-8);
    near(&found.g, &[2.157852936, 1.343694204, 1.067085846, 0.536571503, 1.530373061, 1.236218705], 1e-8);
}

/// The estimate with translation correction is another one of the same K: `Kest(X, correction = "translate")$trans`.
#[test]
fn another_edge_correction_says_much_the_same() {
    let translated = [9.878886494, 26.457294827, 42.780368847, 60.269351744, 89.769498567, 146.310542693];
    near(&curves(&park_pattern(), 6.0, 6).k, &translated, 0.06);
}

/// `nndist`, `bdist.points`, `clarkevans(X, correction = c("none", "Donnelly"))`, `area`, `perimeter`.
#[test]
fn summaries_agree_with_spatstat() {
    let field = summary(&field_pattern());
    near(
        &[field.nearest.mean, field.nearest.deviation, field.rim.mean],
        &[2.316939329, 1.324759154, 5.115750000],
        1e-9,
    );
    near(&[field.clark_evans.naive, field.clark_evans.donnelly], &[0.926775732, 0.861885590], 1e-8);
    let park = summary(&park_pattern());
    near(&[park.area, park.nearest.mean, park.rim.mean], &[586.5, 1.944670959, 2.809143088], 1e-9);
    near(&[park_pattern().window().perimeter()], &[130.4507], 1e-6);
}

/// `scipy.stats.wasserstein_distance` on the distances to nearest neighbours, `scipy.spatial.distance` for the others.
#[test]
fn distances_agree_with_scipy() {
    let found = stats::compare(&field_pattern(), &park_pattern());
    near(&[found.metres.nearest, found.hausdorff], &[0.3949192740187656, 9.649336764773006], 1e-12);
    near(&[found.chamfer], &[8.016583075212775], 1e-12);
}

/// Rows of points, each a half step beside the last where `shift` is a half.
fn lattice(columns: usize, rows: usize, height: f64, shift: f64) -> Pattern {
    let place = |i: usize| {
        let (column, row) = (i % columns, i / columns);
        DVec2::new(column as f64 + 0.25 + shift * (row % 2) as f64, (row as f64 + 0.5) * height)
    };
    let all: Vec<DVec2> = (0..columns * rows).map(place).collect();
    Pattern::new(&all, rectangle(columns as f64, rows as f64 * height)).expect("points")
}

#[test]
fn lattices_have_their_index() {
    let square = summary(&lattice(40, 40, 1.0, 0.0)).clark_evans;
    assert!((square.naive - 2.0).abs() < 1e-9, "{square:?}");
    let triangular = summary(&lattice(40, 40, 0.75_f64.sqrt(), 0.5)).clark_evans;
    assert!((triangular.naive - 2.149).abs() < 1e-3, "{triangular:?}");
    assert!(square.donnelly < square.naive && square.donnelly > 1.9, "{square:?}");
}

#[test]
fn chance_has_no_structure() {
    let random = lattice(70, 70, 1.0, 0.0).random(Seed(3)).expect("few points");
    let index = summary(&random).clark_evans.donnelly;
    assert!((index - 1.0).abs() < 0.02, "{index}");
    let found = curves(&random, stats::default_reach(&random), 100);
    assert!(found.l_less_r().iter().all(|l| l.abs() < 0.05), "{:?}", found.l_less_r());
    let above = found.g.iter().zip(&found.radius).filter(|(_, r)| **r > 0.5);
    assert!(above.clone().count() > 50 && above.clone().all(|(g, _)| (g - 1.0).abs() < 0.15), "{:?}", found.g);
}

/// Around a hole and in two parts the correction has no bias either: the mean over many draws is that of the plane.
#[test]
fn edges_leave_no_bias() {
    let far = Polygon::rectangle(DVec2::new(36.0, 4.0), DVec2::new(44.0, 15.0)).expect("a rectangle");
    let window = Window::new([park().region(), &Area::from(far)]).expect("an area");
    let start = Pattern::new(&[PARK, PARK, PARK].concat().iter().map(|p| DVec2::from(*p)).collect::<Vec<_>>(), window);
    let start = start.expect("points");
    let draws = 200;
    let mut mean = [0.0; 5];
    for draw in 0..draws {
        let found = curves(&start.random(Seed(draw)).expect("few points"), 5.0, 5);
        mean.iter_mut().zip(&found.k).for_each(|(sum, k)| *sum += k / draws as f64);
    }
    let plane: Vec<f64> = (1..=5).map(|r| std::f64::consts::PI * f64::from(r * r)).collect();
    near(&mean, &plane, 0.04);
}

#[test]
fn clusters_and_rows_are_told_apart() {
    let centres = lattice(12, 12, 1.0, 0.0).random(Seed(5)).expect("few points");
    let around = |(i, c): (usize, &DVec2)| {
        let mut random = Seed(6).child(i as u64).random();
        (0..8).map(|_| DVec2::new(random.normal(c.x, 0.1), random.normal(c.y, 0.1))).collect::<Vec<_>>()
    };
    let gathered: Vec<DVec2> = centres.points().iter().enumerate().flat_map(around).collect();
    let gathered = Pattern::new(&gathered, rectangle(12.0, 12.0)).expect("points");
    assert!(summary(&gathered).clark_evans.donnelly < 0.8);
    assert!(curves(&gathered, 0.5, 10).g.iter().skip(1).take(3).all(|g| *g > 1.5));
    assert!(gathered.outside() > 0, "some of a cluster at the rim lie beyond it");

    let rows = lattice(40, 40, 1.0, 0.0);
    let (one, other) = (rows.random(Seed(1)).expect("few points"), rows.random(Seed(2)).expect("few points"));
    let real = stats::compare(&rows, &lattice(30, 50, 1.0, 0.0)).scaled;
    let chance = stats::compare(&one, &rows).scaled;
    let same = stats::compare(&one, &other).scaled;
    assert!(chance.nearest > 10.0 * same.nearest && chance.l > 3.0 * same.l, "{chance:?} {same:?}");
    let [far, near] = [chance, same].map(|d| d.pair_correlation.expect("a wide window"));
    assert!(far > 3.0 * near, "{chance:?} {same:?}");
    assert_eq!(stats::normalised_score(chance.nearest, chance.nearest, real.nearest), Some(1.0));
    assert_eq!(stats::normalised_score(real.nearest, chance.nearest, real.nearest), Some(0.0));
    assert_eq!(stats::normalised_score(1.0, 2.0, 2.0), None);
}

#[test]
fn density_alone_makes_no_scaled_difference() {
    let coarse = field_pattern();
    let fine: Vec<DVec2> = coarse.points().iter().map(|p| *p * 0.25).collect();
    let fine = Pattern::new(&fine, rectangle(10.0, 6.25)).expect("points");
    let found = stats::compare(&coarse, &fine);
    let g = found.scaled.pair_correlation.expect("a wide window");
    let all = [found.scaled.nearest, found.scaled.rim, g, found.scaled.l];
    assert!(all.iter().all(|d| *d < 1e-9), "{found:?}");
    assert!(found.metres.nearest > 1.0 && found.metres.rim > 3.0, "{found:?}");
}

#[test]
fn threads_change_no_bit() {
    let many = lattice(60, 60, 1.0, 0.0).random(Seed(9)).expect("few points");
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| (curves(&many, 4.0, 64), summary(&many)))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn what_cannot_be_measured_is_refused_or_empty() {
    assert!(Window::new(&[]).is_none());
    let few = Pattern::new(&points(&[(1.0, 1.0), (99.0, 1.0)]), rectangle(2.0, 2.0)).expect_err("one point");
    assert_eq!(few.to_string(), "1 of 2 points lie in the window: two are needed");
    let twice = points(&[(1.0, 1.0), (1.0, 1.0), (f64::NAN, 0.0), (f64::INFINITY, 1.0)]);
    let twice = Pattern::new(&twice, rectangle(2.0, 2.0)).expect("two points");
    assert_eq!((twice.outside(), summary(&twice).nearest.mean), (2, 0.0));
    assert!(curves(&twice, f64::NAN, 10).k.is_empty() && curves(&twice, 0.0, 10).k.is_empty());
    assert_eq!((stats::wasserstein(&[], &[]), stats::wasserstein(&[1.0], &[])), (0.0, f64::INFINITY));
    assert_eq!(stats::hausdorff(&[], &[DVec2::ZERO]), f64::INFINITY);
}

fn cloud() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((0.0..40.0, 0.0..25.0).prop_map(|(x, y)| DVec2::new(x, y)), 2..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn turning_and_moving_changes_nothing(cloud in cloud(), angle in 0.0..6.3, x in -1e4..1e4, y in -1e4..1e4) {
        let map = DAffine2::from_angle_translation(angle, DVec2::new(x, y));
        let still = rectangle(40.0, 25.0);
        let moved = Window::new([&still.region().transformed(&map)]).expect("an area");
        let elsewhere: Vec<DVec2> = cloud.iter().map(|p| map.transform_point2(*p)).collect();
        let (a, b) = (Pattern::new(&cloud, still).expect("points"), Pattern::new(&elsewhere, moved).expect("points"));
        near(&curves(&a, 5.5, 7).k, &curves(&b, 5.5, 7).k, 1e-6);
        near(&[summary(&a).nearest.mean, summary(&a).rim.mean], &[summary(&b).nearest.mean, summary(&b).rim.mean], 1e-6);
    }

    #[test]
    fn nearest_neighbours_are_nearest(cloud in cloud(), others in cloud()) {
        let least = |p: &DVec2, all: &mut dyn Iterator<Item = DVec2>| all.map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
        let other = |i: usize| cloud.iter().enumerate().filter(move |(j, _)| *j != i).map(|(_, q)| *q);
        let own: Vec<f64> = cloud.iter().enumerate().map(|(i, p)| least(p, &mut other(i))).collect();
        near(&stats::nearest_neighbours(&cloud), &own, 1e-12);
        let between: Vec<f64> = cloud.iter().map(|p| least(p, &mut others.iter().copied())).collect();
        near(&stats::nearest_between(&cloud, &others), &between, 1e-12);
    }

    #[test]
    fn wasserstein_is_a_distance(a in sample(), b in sample(), c in sample(), step in -5.0..5.0_f64) {
        let w = stats::wasserstein;
        prop_assert_eq!(w(&a, &a), 0.0);
        prop_assert!((w(&a, &b) - w(&b, &a)).abs() < 1e-9);
        prop_assert!(w(&a, &c) <= w(&a, &b) + w(&b, &c) + 1e-9);
        let moved: Vec<f64> = a.iter().map(|v| v + step).collect();
        prop_assert!((w(&a, &moved) - step.abs()).abs() < 1e-9);
    }

    #[test]
    fn windows_know_in_from_out(x in -5.0..40.0, y in -5.0..32.0) {
        let (window, p) = (park(), DVec2::new(x, y));
        prop_assert_eq!(window.contains(p), window.region().contains(p));
        prop_assert!((window.distance_to_rim(p) - window.region().distance_to_edges(p)).abs() < 1e-9);
    }
}

fn sample() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-10.0..10.0, 1..20)
}
