//! Urban open spaces by rules: layouts and pattern files in a CGA-style shape grammar become planting plans, plants
//! and surfaces.
//!
//! ```text
//! rule text ── syntax ──▶ File ── check ──▶ Program ─┐
//! layout text ─ layout ─▶ Layout ────────────────────┴─ derive ─▶ Derivation ─ scene ─▶ Scene ─ export ─▶ bytes
//! ```
//!
//! Every stage is a pure function on plain values; files come in through [`world::World`]. A garden in memory:
//!
//! ```
//! use bosquet::{check, derive, element, export, layout, scene, seed, world};
//!
//! let rules = r#"
//!     Lot   --> setback(1) { all = Hedge | remainder : Lawn }
//!     Hedge --> set(material.name, "hedge") extrude(1.2)
//!     Lawn  --> Distr(0.02, 0) { Tree }
//!     Tree  --> I(birch, medium, rand(7))
//! "#;
//! let plot = r#"{ "type": "Feature", "crs": "local", "properties": { "kind": "lot" }, "geometry":
//!     { "type": "Polygon", "coordinates": [[[0, 0], [30, 0], [30, 20], [0, 20], [0, 0]]] } }"#;
//!
//! let world = world::MemoryWorld::default().with("garden.cga", rules);
//! let (program, found) = check::check(&world, "garden.cga");
//! assert!(found.is_empty());
//! let (layout, _) = layout::read_geojson("plot.geojson", plot.as_bytes());
//! let catalogue = element::Catalogue::built_in();
//! let options = derive::Options {
//!     start: None,
//!     seed: seed::Seed(1),
//!     set: Vec::new(),
//!     catalogue,
//!     world: &world,
//!     limits: derive::Limits::default(),
//! };
//! let (derivation, _) = derive::derive(&program, &layout, &options, &derive::Progress::default());
//! let (scene, _) = scene::resolve(&layout, &derivation, catalogue, "A garden");
//! assert_eq!(scene.plants.len(), 10); // 28 × 18 m at 0.02 a square metre
//! let plan = export::plan::draw(&scene, &export::plan::PlanOptions::default());
//! assert!(export::plan::svg(&plan).starts_with("<?xml"));
//! ```
//!
//! The command `bosquet` is a thin face over the same calls. `docs/architecture.md` tells how the rooms lie to each
//! other and what always holds.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod check;
pub mod derive;
pub mod diag;
pub mod diff;
pub mod element;
pub mod export;
pub mod files;
pub mod functions;
pub mod geometry;
pub mod layout;
pub mod library;
pub mod manual;
pub mod ops;
pub mod pattern;
pub mod placement;
pub mod plant;
pub mod raster;
pub mod scene;
pub mod seed;
pub mod shape;
pub mod shelf;
pub mod stats;
pub mod syntax;
pub mod text;
pub mod trace;
pub mod unit;
pub mod value;
pub mod world;
