//! A lot before its first rule: its initial shape, what it sees, and the values of its attributes.

use crate::derive::evaluate::{self, Failure};
use crate::derive::{Run, initial};
use crate::functions::{Initial, Surroundings};
use crate::layout::Region;
use crate::placement::Standing;
use crate::seed::Seed;
use crate::shape::{Occluders, Shape};
use crate::value::Value;
use std::cell::RefCell;
use std::sync::Arc;

/// What a lot's derivation begins with.
pub(super) struct Beginning<'a> {
    /// The region.
    pub region: &'a Region,
    /// Its seed.
    pub seed: Seed,
    /// Its shape, without attributes.
    pub shape: Shape,
    /// What rules can ask of it.
    pub initial: Initial,
    /// The features of the lot.
    pub intra: Occluders,
    /// The initial shapes of the neighbours.
    pub inter: Occluders,
    /// The features around it.
    pub beyond: Occluders,
    /// The trees that stand in it and around it.
    pub standing: Standing,
}

impl<'a> Beginning<'a> {
    /// The region number `index` with the rule that begins on it; what it sees only where something `looks`.
    pub fn of(run: &Run<'a>, index: usize, rule: u32, looks: bool) -> Beginning<'a> {
        let Run { program, layout, options, .. } = *run;
        let region = &layout.regions[index];
        let start = program.symbols[program.rules[rule as usize].symbol as usize].clone();
        let seed = initial::seed(region, options.seed);
        let around = run.reaches.as_ref().filter(|_| looks).map(|grid| initial::around(layout, region, grid));
        let (beyond, standing) = around.unwrap_or_default();
        Beginning {
            region,
            seed,
            shape: initial::shape(region, seed),
            initial: initial::facts(region, start),
            intra: if looks { initial::intra(layout, region) } else { Occluders::default() },
            inter: if looks { initial::inter(layout, region) } else { Occluders::default() },
            beyond,
            standing,
        }
    }

    /// What is given from outside, in the order of the slots: by the context first, then by the run, then by the layout.
    pub fn given(&self, run: &Run, context: &[(usize, Value)]) -> Vec<(usize, Value)> {
        let Run { program, options, .. } = *run;
        let blended = |slot: usize| context.iter().find(|(s, _)| *s == slot).map(|(_, value)| value.clone());
        let set = |slot: usize| options.set.iter().rev().find(|(s, _)| *s == slot).map(|(_, value)| value.clone());
        let said = |slot: usize| {
            let attribute = &program.attributes[slot];
            let mut names = attribute.names().filter(|_| attribute.public);
            names.find_map(|name| self.region.attributes.get(name)).cloned()
        };
        let given = |slot: usize| blended(slot).or_else(|| set(slot)).or_else(|| said(slot));
        (0..program.attributes.len()).filter_map(|slot| Some((slot, given(slot)?))).collect()
    }

    /// The values of all attributes: what is given, and else what the file says.
    ///
    /// What `print` is given on the way goes to `told`.
    pub fn attributes(
        &self,
        run: &Run,
        given: &[(usize, Value)],
        told: &RefCell<Vec<Value>>,
    ) -> (Arc<[Value]>, Vec<Failure>) {
        let Run { program, options, .. } = *run;
        let mut random = self.shape.seed.random();
        let mut around = Surroundings {
            shape: &self.shape,
            random: &mut random,
            intra: &self.intra,
            inter: &self.inter,
            is_ancestor: &|_| false,
            initial: &self.initial,
            at: None,
            catalogue: options.catalogue,
            rasters: run.rasters,
            files: run.files,
            source: 0,
            georeference: &run.layout.georeference,
            tree_key: &|| "0;".into(),
            told,
        };
        evaluate::attributes(program, |slot| at_slot(given, slot).cloned(), &mut around, options.limits.calls)
    }
}

/// The value that is given for a slot.
pub(super) fn at_slot(given: &[(usize, Value)], slot: usize) -> Option<&Value> {
    given.binary_search_by_key(&slot, |(slot, _)| *slot).ok().map(|index| &given[index].1)
}
