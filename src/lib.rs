//! Urban open spaces by rules.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod check;
pub mod derive;
pub mod diag;
pub mod element;
pub mod export;
pub mod functions;
pub mod geometry;
pub mod layout;
pub mod ops;
pub mod placement;
pub mod scene;
pub mod seed;
pub mod shape;
pub mod syntax;
pub mod text;
pub mod unit;
pub mod value;
pub mod world;
