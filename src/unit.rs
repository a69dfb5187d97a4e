//! Units as types, for the boundaries where a bare number would not say what it is.
//!
//! Inside an algorithm lengths are plain `f64` metres and angles plain `f64` radians or degrees as its doc says;
//! declarations of operations and public configuration use these.

/// A length in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Metres(pub f64);

/// An angle in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Degrees(pub f64);

impl Degrees {
    /// The same angle in radians.
    pub fn radians(self) -> f64 {
        self.0 * (std::f64::consts::PI / 180.0)
    }
}

/// A share of a whole, usually in 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Share(pub f64);

/// A density in plants per square metre.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct PerArea(pub f64);
