//! Scene → bytes: plans, plants, surfaces, schedules, reports. Knows the scene and nothing above it.

mod csv;
mod geo;
pub mod plan;
pub mod plants;
pub mod report;
pub mod schedule;
pub mod surfaces;
