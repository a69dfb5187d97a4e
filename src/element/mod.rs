//! The element repository (Ulmer et al. 2007, §2.1–2.2): plants, furniture, architectural objects, primitives and
//! ground covers by category, type and instance, described in TOML and extended by users beside their rules.
//!
//! In: catalogue texts, and models through the world. Out: real sizes, names and looks. Knows no shapes, no scene
//! and no language. The texts under `catalogue/` are the manual of the schema: every field is used there.

mod appearance;
mod catalogue;
mod color;
mod entry;
mod look;
mod model;
mod read;
mod record;
mod words;

pub use appearance::Appearance;
pub use catalogue::{Catalogue, Found, NotFound};
pub use color::{color_text, parse_color};
pub use entry::{Cover, Entry, Form, Kind, PlantFigures, Variant};
pub use look::{Material, PlantSymbol, Texture};
pub use words::Words;

use catalogue::fold;
