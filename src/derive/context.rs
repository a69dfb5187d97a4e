//! Attributes that a lot shares with those around it: `@Context(radius)` (Niese et al. 2022, §5.5).
//!
//! The value of a lot is the mean over the lots whose centres lie within the radius ξ, its own among them, weighted by
//! a Gaussian of the distance with a standard deviation of ξ/3. Numbers are blended; words are drawn by the same
//! weights from the lot's seed. A lot has an attribute where its start rule, or what can come of it, reads it; others
//! have no share in its value.
//!
//! In: what each lot would have alone. Out: what it has in its context. Computed once for a layout, in parallel.

use crate::check::{Code, Program};
use crate::derive::Run;
use crate::derive::beginning::Beginning;
use crate::geometry::PointGrid;
use crate::seed::Seed;
use crate::value::Value;
use glam::DVec2;
use rayon::prelude::*;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Values by slot.
pub(super) type Context = Vec<(usize, Value)>;

/// A lot by itself.
struct Own {
    region: usize,
    centre: DVec2,
    seed: Seed,
    rule: u32,
    values: Arc<[Value]>,
}

/// The values that each region has from its context; nothing where no attribute asks for one.
///
/// Costs n·k for n lots with k others within the radius.
pub(super) fn contexts(run: &Run, rules: &[Option<u32>]) -> Vec<Context> {
    let attributes = run.program.attributes.iter().enumerate();
    let asked: Vec<(usize, f64)> = attributes.filter_map(|(slot, a)| Some((slot, a.context?))).collect();
    if asked.is_empty() {
        return Vec::new();
    }
    let all = own(run, rules);
    let begun: BTreeSet<u32> = all.iter().map(|lot| lot.rule).collect();
    let read: BTreeMap<u32, BTreeSet<u32>> = begun.into_iter().map(|r| (r, run.program.attributes_of(r))).collect();
    let mut contexts = vec![Context::new(); run.layout.regions.len()];
    for (slot, radius) in asked {
        let lots: Vec<&Own> = all.iter().filter(|lot| read[&lot.rule].contains(&(slot as u32))).collect();
        let centres: Vec<DVec2> = lots.iter().map(|lot| lot.centre).collect();
        let grid = PointGrid::new(&centres, radius.max(1.0));
        let name = &run.program.attributes[slot].name;
        let blended: Vec<Value> = lots.par_iter().map(|lot| blend(lot, slot, radius, name, &lots, &grid)).collect();
        lots.iter().zip(blended).for_each(|(lot, value)| contexts[lot.region].push((slot, value)));
    }
    contexts
}

/// Every lot on which a rule begins, as it would be alone.
fn own(run: &Run, rules: &[Option<u32>]) -> Vec<Own> {
    let looks = attributes_look(run.program);
    let lot = |(region, rule): (usize, &Option<u32>)| {
        let beginning = Beginning::of(run, region, (*rule)?, looks);
        // What fails here fails again when the lot is derived, and is reported then.
        let (values, _) = beginning.attributes(run, &beginning.given(run, &[]), &RefCell::default());
        Some(Own { region, centre: beginning.region.polygon.centroid(), seed: beginning.seed, rule: (*rule)?, values })
    };
    rules.par_iter().enumerate().filter_map(lot).collect()
}

fn blend(lot: &Own, slot: usize, radius: f64, name: &str, lots: &[&Own], grid: &PointGrid) -> Value {
    let mut near: Vec<usize> = grid.within(lot.centre, radius).collect();
    // In the layout's order, so that a lot far away cannot change how the sum is rounded.
    near.sort_unstable();
    let deviation = radius / 3.0;
    let weight = |other: &usize| {
        let distance = lots[*other].centre.distance_squared(lot.centre);
        if deviation > 0.0 { libm::exp(-0.5 * distance / (deviation * deviation)) } else { 1.0 }
    };
    let weights: Vec<f64> = near.iter().map(weight).collect();
    let numbers: Option<Vec<f64>> = near.iter().map(|other| lots[*other].values[slot].as_float()).collect();
    if let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) {
        let sum: f64 = numbers.iter().zip(&weights).map(|(number, weight)| number * weight).sum();
        return Value::Float(sum / weights.iter().sum::<f64>());
    }
    let chosen = lot.seed.named(name).draw("context").choose(&weights);
    chosen.map_or(&lot.values[slot], |index| &lots[near[index]].values[slot]).clone()
}

/// Whether the value of any attribute asks how shapes lie to each other.
fn attributes_look(program: &Program) -> bool {
    let attributes = program.attributes.iter().map(|attribute| &attribute.initial);
    let mut open: Vec<&Code> = attributes.chain(program.functions.iter().map(|function| &function.value)).collect();
    while let Some(code) = open.pop() {
        if matches!(code, Code::Builtin(function, ..) if function.looks_around) {
            return true;
        }
        open.extend(code.parts());
    }
    false
}
