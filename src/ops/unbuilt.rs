//! What CityEngine has and bosquet has not yet: the one list that checker and manual read.

/// An operation of CityEngine that is known by name only.
#[derive(Debug)]
pub struct Unbuilt {
    /// Its name.
    pub name: &'static str,
    /// What it does there, in a few words.
    pub does: &'static str,
}

const fn unbuilt(name: &'static str, does: &'static str) -> Unbuilt {
    Unbuilt { name, does }
}

/// All of them; of the functions none is missing.
pub static UNBUILT_OPERATIONS: &[Unbuilt] =
    &[unbuilt("envelope", "makes a zoning envelope"), unbuilt("modify", "changes components in place")];
