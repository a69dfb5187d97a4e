//! Scene → bytes: plans, plants, surfaces, schedules, reports. Knows the scene and nothing above it.
pub mod plan;
