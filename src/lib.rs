//! Urban open spaces by rules.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod diag;
pub mod element;
pub mod export;
pub mod geometry;
pub mod layout;
pub mod placement;
pub mod scene;
pub mod seed;
pub mod shape;
pub mod syntax;
pub mod text;
pub mod unit;
pub mod value;
pub mod world;
