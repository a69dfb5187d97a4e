//! One region cut into cells by three rules, and the same cells from a bare work list without any.

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::{self, Area, Bounds, Polygon};
use bosquet::layout::{Kind, Layout, Region};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::world::MemoryWorld;
use glam::DVec2;

/// Natural side of a cell, metres; what the rules below write out.
const CELL: f64 = 4.0;

const RULES: &str = "
Lot --> split(x) { ~4 : split(z) { ~4 : Cell }* }*
Cell --> offset(-0.5, inside) extrude(3) Leaf.
";

/// The leaves of a derivation.
pub fn leaves(derivation: &Derivation) -> usize {
    derivation.lots.iter().map(|lot| lot.outcome.leaves.len()).sum()
}

/// A checked program and the layout it runs on.
pub struct Grid {
    program: Program,
    layout: Layout,
    world: MemoryWorld,
    outline: Polygon,
}

impl Grid {
    /// About so many cells in a quadrilateral without a right angle.
    pub fn new(cells: usize) -> Grid {
        let corners = [(0.0, 0.0), (1.0, 0.03), (0.97, 1.0), (0.04, 0.96)].map(|(x, y)| DVec2::new(x, y));
        let unit = geometry::ring_area(&corners);
        let side = CELL * (cells as f64 / unit).sqrt();
        let outline = Polygon::from_ring(&corners.map(|c| c * side));
        let world = MemoryWorld::default().with("grid.cga", RULES);
        let (program, found) = check(&world, "grid.cga");
        assert!(found.is_empty(), "{found:?}");
        let layout = Layout { regions: vec![region(outline.clone())], ..Layout::default() };
        Grid { program, layout, world, outline }
    }

    pub fn derive(&self) -> Derivation {
        let options = Options {
            start: Some("Lot".into()),
            seed: Seed(1),
            set: Vec::new(),
            catalogue: Catalogue::built_in(),
            world: &self.world,
            // Two shapes a cell: more than a lot has unless it is meant.
            limits: Limits { shapes: 4_000_000, ..Limits::default() },
        };
        let (derivation, found) = derive(&self.program, &self.layout, &options, &Progress::default());
        assert!(found.is_empty(), "{found:?}");
        derivation
    }

    /// The same cells from a plain work list: cut, cut, pushed, popped, shrunk, kept.
    pub fn bound(&self) -> Vec<(Area, Bounds)> {
        let whole = Area::from(self.outline.clone());
        let columns = geometry::bands(&whole, DVec2::X, &cuts(&whole, DVec2::X));
        let mut waiting: Vec<Area> =
            columns.iter().flat_map(|column| geometry::bands(column, DVec2::Y, &cuts(column, DVec2::Y))).collect();
        let mut built = Vec::new();
        while let Some(cell) = waiting.pop() {
            let cell = geometry::offset(&cell, -0.5);
            let bounds = cell.bounds();
            built.push((cell.into_translated(-bounds.min), bounds));
        }
        built
    }
}

/// Where cells of about [`CELL`] begin and end along an axis.
fn cuts(area: &Area, axis: DVec2) -> Vec<f64> {
    let bounds = area.bounds();
    let (from, length) = (bounds.min.dot(axis), bounds.size().dot(axis));
    let count = (length / CELL).round().max(1.0);
    (0..=count as usize).map(|i| from + length * i as f64 / count).collect()
}

fn region(polygon: Polygon) -> Region {
    Region {
        id: "grid".into(),
        name: "grid".into(),
        kind: Kind::Lot,
        zone: "".into(),
        polygon,
        elevation: 0.0,
        start: None,
        seed: None,
        attributes: Default::default(),
        features: Vec::new(),
        neighbours: Vec::new(),
    }
}
