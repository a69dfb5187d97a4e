//! Plants along lines: hedges inside a rim, avenues beside a street, rows on an axis.
//!
//! In: lines, and how far beside them and from their corners plants stand. Out: places at even spacing on each run, a
//! run being what lies between two corners.

use crate::geometry::Path;
use crate::placement::beside::{Run, runs};
use crate::placement::places::{Places, few_enough, from_zero};
use crate::placement::walk::{Walk, check_spacing};
use crate::placement::{Amount, Field, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;
use glam::DVec2;

/// Shorter than a whole step by less than this share of one still counts as whole.
const SLACK: f64 = 1e-9;

/// A line in the plan, metres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// Its vertices.
    pub points: Vec<DVec2>,
    /// Whether it goes on from the last vertex to the first.
    pub closed: bool,
}

/// How plants stand along lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Along {
    /// From plant to plant, metres.
    pub spacing: Field,
    /// How far to the left of the lines, metres: inside of rings that run counter-clockwise and holes that run
    /// clockwise. Negative to the right.
    pub inset: f64,
    /// How far from corners and ends nothing stands, metres along the run.
    pub corner: f64,
    /// A vertex that turns by more than this (degrees) is a corner; others are run through.
    pub turn: f64,
    /// Whether the spacing is stretched so that the first and the last plant stand at the very ends of a run; else it
    /// is kept, and the rests at both ends are equal.
    pub adjust: bool,
}

/// Places along lines, the cluster of a spot being its run.
///
/// With an inset a run lies where the line moves to when all of it moves aside: moved edges end where they meet, and no
/// place is nearer to any of the lines than the inset. A run that is shorter than the spacing gets one plant in its
/// middle; one that is all corner gets none. Where runs meet, a place whose disk would overlap one of an earlier run is
/// left out. Costs n log n for n edges, more where the inset is much longer than they are.
pub fn along(
    site: &Site,
    lines: &[Line],
    options: &Along,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    options.check()?;
    let mut places = Places::new(site, radii, amount, [options.spacing.least(), options.spacing.most()], seed)?;
    few_enough(lines.iter().map(Line::length).sum::<f64>() / options.spacing.least())?;
    for (index, run) in runs(lines, options.inset, options.turn).iter().enumerate() {
        let stops = options.stops(run)?;
        places.take_run(&stops, run.closed, index as u32, |_| 0.0);
    }
    places.finish(amount)
}

impl Line {
    /// Metres along it.
    fn length(&self) -> f64 {
        let closing = self.points.last().zip(self.points.first()).filter(|_| self.closed);
        let pieces = self.points.windows(2).map(|w| w[0].distance(w[1]));
        pieces.chain(closing.map(|(a, b)| a.distance(*b))).sum()
    }
}

impl Along {
    fn check(&self) -> Result<(), PlacementError> {
        check_spacing(&self.spacing)?;
        from_zero("inset", self.inset.abs())?;
        from_zero("corner", self.corner)?;
        if !(0.0..=180.0).contains(&self.turn) {
            let allowed = "an angle from 0 to 180 degrees";
            return Err(PlacementError::Value { parameter: "bend", found: self.turn, allowed });
        }
        Ok(())
    }

    /// The places of one run.
    fn stops(&self, run: &Run) -> Result<Vec<(DVec2, DVec2)>, PlacementError> {
        let Some(whole) = Path::new(&run.points) else { return Ok(Vec::new()) };
        let clear = if run.closed { 0.0 } else { self.corner };
        let Some(free) = whole.piece(clear, whole.length() - clear) else { return Ok(Vec::new()) };
        let walk = Walk::new(free, &self.spacing)?;
        let gaps = (walk.steps() + SLACK).floor();
        if run.closed {
            let count = gaps.max(1.0);
            let step = if self.adjust || gaps == 0.0 { walk.steps() / count } else { 1.0 };
            return Ok((0..count as usize).map(|i| walk.at(i as f64 * step)).collect());
        }
        let step = if self.adjust && gaps > 0.0 { walk.steps() / gaps } else { 1.0 };
        let rest = 0.5 * (walk.steps() - gaps * step);
        Ok((0..=gaps as usize).map(|i| walk.at(rest + i as f64 * step)).collect())
    }
}
