//! Random points: spread uniformly, or gathered around a centre.

use crate::geometry::Area;
use crate::placement::{PlacementError, allowed};
use crate::seed::{Random, Seed};
use glam::DVec2;

/// Points, and how many of those asked for found no place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scatter {
    /// The points.
    pub points: Vec<DVec2>,
    /// How many are missing.
    pub missing: usize,
}

/// How often a place is looked for before a point is given up.
const TRIES: usize = 256;
/// After so many points in a row without a place, the others are not tried.
const VAIN: usize = 32;

/// `count` points, each anywhere in the area with equal probability.
///
/// An empty area gets none. Costs the logarithm of the number of vertices a point.
pub fn uniform(area: &Area, count: usize, seed: Seed) -> Result<Vec<DVec2>, PlacementError> {
    let tiles = Tiles::of(area);
    let point = |index: u64| {
        let mut random = seed.child(index).random();
        tiles.at(random.unit() * tiles.total()).map(|tile| within(tile, &mut random))
    };
    Ok((0..allowed(count)? as u64).filter_map(point).collect())
}

/// `count` points, normally distributed around `centre` with a standard deviation in metres along each axis, those
/// outside the area drawn again.
///
/// Where the centre is far off, some or all find no place: they are counted as missing. Costs the number of edges a
/// draw.
pub fn gaussian(
    area: &Area,
    count: usize,
    centre: DVec2,
    deviation: DVec2,
    seed: Seed,
) -> Result<Scatter, PlacementError> {
    if let Some(wrong) = deviation.to_array().into_iter().find(|d| !d.is_finite() || *d < 0.0) {
        return Err(PlacementError::Deviation(wrong));
    }
    let count = allowed(count)?;
    let mut points = Vec::new();
    let mut vain = 0;
    for index in 0..count as u64 {
        let mut random = seed.child(index).random();
        let mut draw = || DVec2::new(random.normal(centre.x, deviation.x), random.normal(centre.y, deviation.y));
        let place = (0..TRIES).map(|_| draw()).find(|point| area.contains(*point));
        vain = if place.is_some() { 0 } else { vain + 1 };
        points.extend(place);
        if vain == VAIN {
            break;
        }
    }
    let missing = count - points.len();
    Ok(Scatter { points, missing })
}

/// An area as triangles, each with the area of all up to and with it: a measure along which to draw.
pub(super) struct Tiles {
    triangles: Vec<[DVec2; 3]>,
    ends: Vec<f64>,
}

impl Tiles {
    pub fn of(area: &Area) -> Tiles {
        let triangles = area.triangles();
        let sum = |total: &mut f64, triangle: &[DVec2; 3]| {
            *total += size(triangle);
            Some(*total)
        };
        let ends = triangles.iter().scan(0.0, sum).collect();
        Tiles { triangles, ends }
    }

    /// The area of all, m².
    pub fn total(&self) -> f64 {
        self.ends.last().copied().unwrap_or(0.0)
    }

    /// The triangles with the stretch of the measure that each covers.
    pub fn stretches(&self) -> impl Iterator<Item = ([DVec2; 3], [f64; 2])> {
        let starts = std::iter::once(&0.0).chain(&self.ends);
        self.triangles.iter().zip(starts.zip(&self.ends)).map(|(triangle, (from, to))| (*triangle, [*from, *to]))
    }

    fn at(&self, measure: f64) -> Option<[DVec2; 3]> {
        let index = self.ends.partition_point(|end| *end <= measure);
        self.triangles.get(index).or(self.triangles.last()).copied()
    }
}

/// Any point of a triangle with equal probability.
pub(super) fn within([a, b, c]: [DVec2; 3], random: &mut Random) -> DVec2 {
    let root = random.unit().sqrt();
    a + (b - a) * root * (1.0 - random.unit()) + (c - a) * (1.0 - root)
}

fn size([a, b, c]: &[DVec2; 3]) -> f64 {
    0.5 * (*b - *a).perp_dot(*c - *a).abs()
}
