//! Dynamic imports: the attributes of an import found anew for one call.

use crate::check::{Fresh, Renewed};
use crate::derive::beginning::at_slot;
use crate::derive::engine::{Current, Engine, Stop, Turn};
use crate::derive::evaluate::{self, Names};
use crate::derive::frame::Frame;
use crate::seed::Seed;
use crate::value::Value;
use std::sync::Arc;

impl Engine<'_> {
    /// The attributes with which a rule of a dynamic import begins: what the call gives first, then all others of the
    /// import in their order, as the lot was given them or else with numbers of their own from the seed of the successor.
    pub(super) fn fresh(
        &mut self,
        fresh: &Fresh,
        seed: Seed,
        turn: &Turn,
        current: &mut Current,
    ) -> Result<Arc<[Value]>, Stop> {
        let before = current.shape.attributes.clone();
        let renewed = self.renew(fresh, seed, turn, current);
        let after = std::mem::replace(&mut current.shape.attributes, before);
        renewed.map(|()| after)
    }

    /// Sets them on the current shape itself, on which they are evaluated.
    fn renew(&mut self, fresh: &Fresh, seed: Seed, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        let mut given = Vec::with_capacity(fresh.given.len());
        for (slot, code) in &fresh.given {
            let value = self.frame(turn, current).with(|n, a| evaluate::evaluate(code, n, a));
            given.push((*slot, value.map_err(|f| self.failed(f, turn))?));
        }
        let attributes = Arc::make_mut(&mut current.shape.attributes);
        given.into_iter().for_each(|(slot, value)| attributes[slot as usize] = value);
        for (slot, renewed) in &fresh.anew {
            let attribute = &self.program.attributes[*slot as usize];
            let outside = at_slot(&self.given, *slot as usize).filter(|_| matches!(renewed, Renewed::Initial));
            if let Some(value) = outside {
                Arc::make_mut(&mut current.shape.attributes)[*slot as usize] = value.clone();
                continue;
            }
            let code = match renewed {
                Renewed::Initial => &attribute.initial,
                Renewed::Protected(code) => code,
            };
            let mut random = seed.named(&attribute.name).random();
            let frame = self.frame(turn, current);
            let names = Names { params: &[], ..frame.names };
            let value = Frame { names, random: &mut random, ..frame }.with(|n, a| evaluate::evaluate(code, n, a));
            let value = value.map_err(|f| self.failed(f, turn))?;
            Arc::make_mut(&mut current.shape.attributes)[*slot as usize] = value;
        }
        Ok(())
    }
}
