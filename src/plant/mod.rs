//! Plants by species and age: how large they are, and which species a place gets.
//!
//! In: entries of the catalogue, ages, seeds. Out: sizes in metres ([`sizes`], [`Growth`]) and a species for a plant
//! ([`choose`]). Knows no shapes, no operations and no scene.
//!
//! Niese et al. 2022, §5.4, for the choice; the Urban Tree Database (McPherson, van Doorn, Peper 2016) for growth.

mod choice;
mod curve;
mod growth;
mod stages;

pub use choice::{Seeds, Stock, Structure, choose, landscape, of_lot};
pub use curve::Curve;
pub use growth::{Growth, GrowthError, Sizes, age_class, sizes};
