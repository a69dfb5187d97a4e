//! The element repository (Ulmer et al. 2007, §2.1–2.2): plants, furniture, architectural objects, primitives and
//! ground covers by category, type and instance, described in TOML and extended by users beside their rules.

mod look;

pub use look::{Material, PlantSymbol, Texture};
