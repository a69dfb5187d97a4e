//! Point patterns: how plants stand to each other and to the edges of their window, in numbers.
//!
//! In: points and a [`Window`] in plane metres, together a [`Pattern`]. Out: densities, nearest neighbours, Ripley's K,
//! pair correlations, and distances between two patterns. Knows no plants, files or rules. The statistics are those of
//! Baddeley, Rubak and Turner, Spatial Point Patterns (2015); the comparison follows what evaluations of planting
//! models measure (Niese et al. 2022, §6). Sums run in an order of their own, so threads change no bit.

mod compare;
mod curves;
mod nearest;
mod pattern;
mod segments;
mod summary;
mod window;

pub use compare::{Comparison, Distances, chamfer, compare, hausdorff, normalised_score, wasserstein};
pub use curves::{Curves, bandwidth, curves, default_reach};
pub use nearest::{nearest_between, nearest_neighbours};
pub use pattern::{Pattern, PatternError};
pub use segments::Segments;
pub use summary::{ClarkEvans, Spread, Summary, clark_evans, shares_within, summary};
pub use window::Window;

/// Points that one thread works on at a time: sums are added up in the order of the chunks.
const CHUNK: usize = 256;
