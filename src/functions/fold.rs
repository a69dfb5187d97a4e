//! Functions before there is a shape: what depends on its arguments alone can be known while rules are checked.

use crate::element::Catalogue;
use crate::files::Files;
use crate::functions::{Function, Initial, Surroundings};
use crate::layout::{Crs, Georeference};
use crate::raster::Rasters;
use crate::seed::Seed;
use crate::shape::{Frame, Geometry, Occluders, Ordinals, Scope, Shape, Style};
use crate::value::Value;
use crate::world::MemoryWorld;
use glam::DVec3;
use std::cell::RefCell;
use std::sync::Arc;

/// The value of a function for known arguments; none where it needs a shape, or fails and is to say so when it is called.
pub fn folded(function: &Function, args: &[Value]) -> Option<Value> {
    let takes = (function.arity.0..=function.arity.1).contains(&args.len());
    if !function.constant || !takes {
        return None;
    }
    let (world, georeference) = (MemoryWorld::default(), Georeference::new(Crs::Local, [0.0; 2]).ok()?);
    let empty: Arc<str> = "".into();
    let initial = Initial {
        name: empty.clone(),
        start: empty.clone(),
        kind: empty.clone(),
        zone: empty,
        object: Frame::WORLD,
        outline: None,
        edge_attributes: Vec::new(),
    };
    let mut around = Surroundings {
        shape: &nothing(),
        random: &mut Seed(0).random(),
        intra: &Occluders::default(),
        inter: &Occluders::default(),
        is_ancestor: &|_| false,
        initial: &initial,
        at: None,
        catalogue: Catalogue::built_in(),
        rasters: &Rasters::new(&world, "", georeference.clone()),
        files: &Files::new(&world, []),
        source: 0,
        georeference: &georeference,
        tree_key: &String::new,
        told: &RefCell::default(),
    };
    (function.call)(args, &mut around).ok()
}

fn nothing() -> Shape {
    Shape {
        scope: Scope { frame: Frame::WORLD, size: DVec3::ZERO },
        geometry: Geometry::Empty,
        attributes: Arc::new([]),
        style: Arc::new(Style::default()),
        ordinals: Ordinals::default(),
        seed: Seed(0),
    }
}
