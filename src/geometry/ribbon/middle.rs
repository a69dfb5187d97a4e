//! The ribbon of an area that is longer than wide: its middle line by way of the medial axis.

use crate::geometry::{Area, Branch, MedialAxis, Polygon, Pruning, Ribbon};
use glam::DVec2;
use std::collections::BTreeMap;

/// What is less than this many times as long as wide has no way it runs.
const LEAST_RATIO: f64 = 2.0;

/// The middle line is true to this share of the width.
const TOLERANCE: f64 = 0.004;

/// A way through the axis so far: its length, and the points.
type Way = (f64, Vec<DVec2>);

impl Ribbon {
    /// The ribbon that runs along an area: from end to end, about its middle line, over its whole width.
    ///
    /// `None` for what is not at least twice as long as wide. Cost: a medial axis, n log n in the vertices. Holes and
    /// all parts but the largest are left out of account.
    pub fn along(area: &Area) -> Option<Ribbon> {
        let outline = area.largest()?;
        let whole = Polygon::new(outline.outer(), &[])?;
        let (axis, clearance) = longest_way(&whole.clone().into())?;
        let line = simplified(&led_to_the_rim(&whole, &axis, clearance), clearance * TOLERANCE);
        let length: f64 = line.windows(2).map(|w| w[0].distance(w[1])).sum();
        let width = whole.area() / length;
        if length < LEAST_RATIO * width {
            return None;
        }
        let narrow = Ribbon::new(&line, width)?;
        let extent = narrow.extent(area);
        let reach = extent.min.y.abs().max(extent.max.y.abs());
        // Twice, since what the ribbon reaches depends on how it lies: a thinned one may lie further off.
        let ribbon = Ribbon::new(&line, reach * 1.02 + 0.1)?;
        let extent = ribbon.extent(area);
        let reach = extent.min.y.abs().max(extent.max.y.abs()).min(4.0 * reach + 1.0);
        Ribbon::new(&line, reach * 1.02 + 0.1)
    }
}

/// The longest way through the axis, and the mean clearance on it.
fn longest_way(area: &Area) -> Option<(Vec<DVec2>, f64)> {
    let axis = MedialAxis::new(area, Pruning::default());
    let branches: Vec<&Branch> = axis.branches().iter().filter(|b| b.points.len() > 1 && !b.is_closed()).collect();
    let clearances: Vec<f64> = branches.iter().flat_map(|b| b.clearances.iter().copied()).collect();
    let mut at: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (index, branch) in branches.iter().enumerate() {
        branch.nodes.iter().for_each(|node| at.entry(*node).or_default().push(index));
    }
    // In a tree the farthest node from any is an end of the longest way.
    let (end, _) = farthest(*at.keys().next()?, &branches, &at);
    let (_, (_, points)) = farthest(end, &branches, &at);
    let clearance = clearances.iter().copied().fold(0.0, f64::max);
    (points.len() > 1).then_some((points, clearance))
}

/// The node farthest from another along the branches, and the way there.
fn farthest(from: u32, branches: &[&Branch], at: &BTreeMap<u32, Vec<usize>>) -> (u32, Way) {
    let mut best: (u32, Way) = (from, (0.0, Vec::new()));
    let mut used = vec![false; branches.len()];
    let mut open: Vec<(u32, Way)> = vec![(from, (0.0, Vec::new()))];
    while let Some((node, (length, points))) = open.pop() {
        for index in at.get(&node).into_iter().flatten() {
            if std::mem::replace(&mut used[*index], true) {
                continue;
            }
            let branch = branches[*index];
            let [start, end] = branch.nodes;
            let next = if start == node { end } else { start };
            let mut way = points.clone();
            match start == node {
                true => way.extend(&branch.points),
                false => way.extend(branch.points.iter().rev()),
            }
            way.dedup();
            open.push((next, (length + branch.length(), way)));
        }
        if length > best.1.0 {
            best = (node, (length, points));
        }
    }
    best
}

/// A line with both ends led on to the rim, in the direction that it has over the last clearance.
fn led_to_the_rim(polygon: &Polygon, line: &[DVec2], clearance: f64) -> Vec<DVec2> {
    let forth = led_on(polygon, line, clearance);
    let mut back: Vec<DVec2> = forth.into_iter().rev().collect();
    back = led_on(polygon, &back, clearance);
    back.reverse();
    back
}

fn led_on(polygon: &Polygon, line: &[DVec2], clearance: f64) -> Vec<DVec2> {
    let Some(end) = line.last().copied() else { return Vec::new() };
    let far = |p: &&DVec2| p.distance(end) > clearance;
    let before = line.iter().rev().find(far).or(line.first()).copied().unwrap_or(end);
    let Some(along) = (end - before).try_normalize() else { return line.to_vec() };
    let crossed = polygon.edges().filter_map(|(a, b)| {
        let (low, high) = (along.perp_dot(a - end), along.perp_dot(b - end));
        let share = low / (low - high);
        let at = along.dot(a.lerp(b, share) - end);
        ((low > 0.0) != (high > 0.0) && at > 1e-6).then_some(at)
    });
    let room = crossed.fold(f64::INFINITY, f64::min);
    let led = room.is_finite().then(|| end + along * room);
    line.iter().copied().chain(led).collect()
}

/// The line without the vertices that lie within a tolerance of it (Ramer 1972; Douglas and Peucker 1973).
fn simplified(line: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    let last = line.len().saturating_sub(1);
    let mut kept = vec![false; line.len()];
    let mut open = vec![(0, last)];
    kept.iter_mut().step_by(last.max(1)).for_each(|k| *k = true);
    while let Some((from, to)) = open.pop() {
        let off = |i: usize| crate::geometry::nearest_on_segment(line[i], line[from], line[to]).distance(line[i]);
        let Some(worst) = (from + 1..to).max_by(|a, b| off(*a).total_cmp(&off(*b))) else { continue };
        if off(worst) > tolerance {
            kept[worst] = true;
            open.extend([(from, worst), (worst, to)]);
        }
    }
    line.iter().zip(kept).filter(|(_, keep)| *keep).map(|(p, _)| *p).collect()
}
