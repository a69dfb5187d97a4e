//! Plantings beside the real trees: statistics of each, and how far each is from the real one.
//!
//! A planting is compared across halves: places are dealt out like the squares of a chessboard, and what is measured at
//! the trees on the one half is held against the real trees on the other. So real against real is a distance of the same
//! make, between as many trees. g needs whole windows, and thinning leaves it alone: there every second tree is dealt out.

use crate::city::City;
use bosquet::geometry::Area;
use bosquet::seed::Seed;
use bosquet::stats::{Pattern, Spread, Window, compare, nearest_neighbours, normalised_score, summary, wasserstein};
use glam::DVec2;

/// Side of the squares, metres.
const SQUARE: f64 = 50.0;
/// What plantings are compared by.
pub const DISTANCES: [&str; 5] = ["nn", "lot edge", "building", "street", "g"];

/// A city, and the union of its lots.
pub struct Ground<'a> {
    pub city: &'a City,
    pub window: Window,
    real: Samples,
}

/// What is measured at each tree of a planting: the square, the distances to the nearest tree, lot edge, building and
/// street.
struct Samples {
    pattern: Pattern,
    squares: Vec<usize>,
    distances: [Vec<f64>; 4],
}

/// Trees, and the mean of what is measured of several plantings.
#[derive(Clone, Default)]
pub struct Row {
    /// Trees before thinning.
    pub planted: f64,
    /// Trees that were measured.
    pub count: f64,
    /// Index of Clark and Evans, with Donnelly's correction.
    pub index: f64,
    /// Quantiles 25, 50 and 75 % of the distances in metres: to the nearest tree, lot edge, building and street.
    pub quartiles: [[f64; 3]; 4],
    /// How far from the real trees, in the order of [`DISTANCES`]: metres, g without unit.
    pub distances: [f64; 5],
}

impl Ground<'_> {
    /// The lots of a city; `None` without any, or without trees in them.
    pub fn of(city: &City) -> Option<Ground<'_>> {
        let lots: Vec<Area> = city.layout.regions.iter().map(|region| region.polygon.clone().into()).collect();
        let window = Window::new(&lots)?;
        let real = Samples::of(city, Pattern::new(&city.trees, window.clone()).ok()?);
        Some(Ground { city, window, real })
    }

    /// The real trees in the lots.
    pub fn real(&self) -> &[DVec2] {
        self.real.pattern.points()
    }

    /// Points in the lots, thinned at random to the number of real trees. That changes neither g nor the distances to
    /// other things.
    pub fn thinned(&self, points: &[DVec2], seed: Seed) -> Vec<DVec2> {
        let inside = points.iter().copied().filter(|p| self.window.contains(*p));
        let mut dealt: Vec<(f64, DVec2)> =
            inside.enumerate().map(|(i, p)| (seed.child(i as u64).random().unit(), p)).collect();
        dealt.sort_by(|a, b| a.0.total_cmp(&b.0));
        dealt.into_iter().take(self.real().len()).map(|(_, p)| p).collect()
    }

    /// Everything about one planting.
    pub fn measure(&self, points: &[DVec2]) -> Row {
        let own = Samples::of(self.city, Pattern::new(points, self.window.clone()).expect("trees in the lots"));
        let found = summary(&own.pattern);
        let quartiles = own.distances.each_ref().map(|sample| {
            let [_, _, low, middle, high, ..] = Spread::of(sample).quantiles;
            [low, middle, high]
        });
        Row {
            planted: points.len() as f64,
            count: found.count as f64,
            index: found.clark_evans.donnelly,
            quartiles,
            distances: self.distances(&own),
        }
    }

    fn distances(&self, own: &Samples) -> [f64; 5] {
        let real = &self.real;
        let both = |distance: &dyn Fn(usize, usize) -> f64| (distance(0, 1) + distance(1, 0)) / 2.0;
        let across = |i: usize| both(&|a, b| wasserstein(&own.half(i, a), &real.half(i, b)));
        let g = both(&|a, b| {
            compare(&own.every_second(a), &real.every_second(b)).metres.pair_correlation.unwrap_or(f64::NAN)
        });
        [across(0), across(1), across(2), across(3), g]
    }
}

impl Samples {
    fn of(city: &City, pattern: Pattern) -> Samples {
        let points = pattern.points();
        let houses = &city.buildings;
        let to_building = |p: &DVec2| if houses.contains(*p) { 0.0 } else { houses.distance_to_rim(*p) };
        let squares = points.iter().map(|p| (*p / SQUARE).floor()).map(|s| (s.x + s.y).rem_euclid(2.0) as usize);
        Samples {
            squares: squares.collect(),
            distances: [
                nearest_neighbours(points),
                pattern.distances_to_rim(),
                points.iter().map(to_building).collect(),
                points.iter().map(|p| city.axes.distance(*p)).collect(),
            ],
            pattern,
        }
    }

    /// One of the measures on the white squares or on the black ones.
    fn half(&self, measure: usize, half: usize) -> Vec<f64> {
        let all = self.distances[measure].iter().zip(&self.squares);
        all.filter(|(_, square)| **square == half).map(|(distance, _)| *distance).collect()
    }

    /// Half of the trees, dealt out at random.
    fn every_second(&self, half: usize) -> Pattern {
        let dealt = |index: usize| Seed(1).child(index as u64).random().below(2) as usize;
        let points = self.pattern.points().iter().enumerate().filter(|(index, _)| dealt(*index) == half);
        let points: Vec<DVec2> = points.map(|(_, p)| *p).collect();
        Pattern::new(&points, self.pattern.window().clone()).expect("many trees in the lots")
    }
}

impl Row {
    /// The mean of several plantings.
    pub fn mean(rows: &[Row]) -> Row {
        let share = 1.0 / rows.len() as f64;
        let mean = |of: &dyn Fn(&Row) -> f64| rows.iter().map(of).sum::<f64>() * share;
        Row {
            planted: mean(&|row| row.planted),
            count: mean(&|row| row.count),
            index: mean(&|row| row.index),
            quartiles: std::array::from_fn(|s| std::array::from_fn(|q| mean(&|row| row.quartiles[s][q]))),
            distances: std::array::from_fn(|i| mean(&|row| row.distances[i])),
        }
    }

    /// The scores between the real trees and random points; none where those are as near as the real ones.
    pub fn scores(&self, real: &Row, random: &Row) -> [Option<f64>; 5] {
        std::array::from_fn(|i| normalised_score(self.distances[i], random.distances[i], real.distances[i]))
    }
}
