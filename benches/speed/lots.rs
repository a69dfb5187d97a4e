//! Many lots, one extrusion each.

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::{Area, Polygon};
use bosquet::layout::{Kind, Layout, Region};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::world::MemoryWorld;
use glam::DVec2;

const RULES: &str = "Lot --> extrude(10)";

/// Lots of five corners, side by side.
pub struct Lots {
    program: Program,
    layout: Layout,
    world: MemoryWorld,
}

impl Lots {
    /// So many lots.
    pub fn new(count: usize) -> Lots {
        let world = MemoryWorld::default().with("lots.cga", RULES);
        let (program, found) = check(&world, "lots.cga");
        assert!(found.is_empty(), "{found:?}");
        let across = (count as f64).sqrt().ceil() as usize;
        let regions = (0..count).map(|index| region(index, across)).collect();
        Lots { program, layout: Layout { regions, ..Layout::default() }, world }
    }

    /// How many there are.
    pub fn count(&self) -> f64 {
        self.layout.regions.len() as f64
    }

    /// The lots by their rule.
    pub fn derive(&self) -> Derivation {
        let options = Options {
            start: Some("Lot".into()),
            seed: Seed(1),
            set: Vec::new(),
            catalogue: Catalogue::built_in(),
            world: &self.world,
            limits: Limits::default(),
        };
        let (derivation, found) = derive(&self.program, &self.layout, &options, &Progress::default());
        assert!(found.is_empty(), "{found:?}");
        derivation
    }

    /// The same prisms without rules: each outline turned along its first edge, moved to its corner, given a height.
    pub fn bound(&self) -> Vec<(DVec2, Area, f64)> {
        let prism = |region: &Region| {
            let ring = region.polygon.outer();
            let along = (ring[1] - ring[0]).normalize();
            let turned = region.polygon.mapped(|p| DVec2::new(along.dot(p), along.perp_dot(p)));
            let corner = turned.bounds().min;
            (corner, Area::from(turned).into_translated(-corner), 10.0)
        };
        self.layout.regions.iter().map(prism).collect()
    }
}

fn region(index: usize, across: usize) -> Region {
    let corner = DVec2::new((index % across) as f64, (index / across) as f64) * DVec2::new(24.0, 32.0);
    let ring = [(0.0, 0.0), (22.0, 0.5), (23.0, 16.0), (21.0, 30.0), (1.0, 29.0)];
    let id: std::sync::Arc<str> = index.to_string().into();
    Region {
        name: id.clone(),
        id,
        kind: Kind::Lot,
        zone: "".into(),
        polygon: Polygon::from_ring(&ring.map(|(x, y)| corner + DVec2::new(x, y))),
        elevation: 0.0,
        start: None,
        seed: None,
        attributes: Default::default(),
        features: Vec::new(),
        neighbours: Vec::new(),
    }
}
