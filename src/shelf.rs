//! Things that are made once in a run, by whoever asks first, and shared by all: files read, maps and tables.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Things by name, each made once; a failure is kept like a success.
pub struct Shelf<T, E>(Mutex<BTreeMap<String, Slot<T, E>>>);

/// A thing that is made, or is about to be.
type Slot<T, E> = Arc<OnceLock<Result<T, E>>>;

impl<T, E> Default for Shelf<T, E> {
    fn default() -> Shelf<T, E> {
        Shelf(Mutex::default())
    }
}

impl<T: Clone, E: Clone> Shelf<T, E> {
    /// The thing of that name; the first to ask makes it, others wait for that one alone.
    pub fn get(&self, name: &str, make: impl FnOnce(&str) -> Result<T, E>) -> Result<T, E> {
        let slot = {
            let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            match slots.get(name) {
                Some(slot) => slot.clone(),
                None => slots.entry(name.into()).or_default().clone(),
            }
        };
        slot.get_or_init(|| make(name)).clone()
    }

    /// Everything that was made, by name.
    pub fn made(&self) -> Vec<(String, T)> {
        let slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let made = slots.iter().filter_map(|(name, slot)| Some((name, slot.get()?)));
        made.filter_map(|(name, thing)| Some((name.clone(), thing.as_ref().ok()?.clone()))).collect()
    }
}
