//! `cleanupGeometry`: merges what is almost the same.

use crate::geometry::{self, Area, Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Shape};
use std::sync::Arc;

operation! {
    /// Merges vertices, edges and faces of a shape that are almost the same.
    ///
    /// `vertices` merges near vertices and drops those on straight edges, `edges` joins neighbouring faces of one plane,
    /// `faces` drops faces that are tiny or there twice, `all` does all. The tolerance scales what counts as near: at 1
    /// vertices within 1 m, bends up to 10°, faces up to 1 m²; at 0 only what is equal. Faces stay flat, so those that
    /// make no flat face together stay apart. What vanishes wholly is deleted.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { ~1 : Basin(0.01) | ~1 : Basin(1) }
    /// Basin(near) --> s(7, 0, 7) center(xz) primitiveDisk(64) cleanupGeometry(all, near) Water
    /// ```
    "cleanupGeometry" (CityEngine, None) => pub struct CleanupGeometry {
        /// What is cleaned up.
        components: Components,
        /// How far apart things may be, from 0 (not at all) to 1.
        tolerance: f64 [0.0, 1.0],
    }
}

choice! {
    /// What is cleaned up.
    pub enum Components {
        /// Near vertices and straight corners.
        Vertices = "vertices",
        /// Edges within a plane.
        Edges = "edges",
        /// Tiny and double faces.
        Faces = "faces",
        /// All of it.
        All = "all",
    }
}

/// The bend that counts as straight at full tolerance, degrees.
const WIDEST: f64 = 10.0;

/// Tolerances in their units.
struct Slack {
    metres: f64,
    radians: f64,
    square_metres: f64,
}

impl Apply for CleanupGeometry {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let share = self.tolerance;
        if !(0.0..=1.0).contains(&share) {
            return Err(Problem::new(format!("a tolerance of {share} is none from 0 to 1")));
        }
        let slack = Slack { metres: share, radians: (share * WIDEST).to_radians(), square_metres: share };
        let geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => Geometry::Flat(plane.clone(), self.area(area, &slack, true)),
            Geometry::Prism(plane, area, height) => {
                Geometry::Prism(plane.clone(), self.area(area, &slack, false), *height)
            }
            Geometry::Mesh(mesh) => match self.mesh(mesh, &slack) {
                tidy if tidy.faces.is_empty() => Geometry::Empty,
                tidy => Geometry::Mesh(Arc::new(tidy)),
            },
            Geometry::Empty | Geometry::Point | Geometry::Path(_) | Geometry::Element(_) => return Ok(Pieces::Changed),
        };
        fit::refit(shape, geometry);
        Ok(Pieces::left_of(shape))
    }
}

impl CleanupGeometry {
    fn does(&self, components: Components) -> bool {
        self.components == components || self.components == Components::All
    }

    fn area(&self, area: &Area, slack: &Slack, flat: bool) -> Area {
        let joined = match self.does(Components::Edges) {
            true => {
                geometry::union_all(area.polygons().iter().map(|p| Area::from(p.clone())).collect::<Vec<_>>().iter())
            }
            false => area.clone(),
        };
        let angle = if self.does(Components::Vertices) { slack.radians } else { 0.0 };
        let tidy = |polygon: Polygon| match self.does(Components::Vertices) {
            true => geometry::thinned(&polygon, slack.metres, angle),
            false => Some(polygon),
        };
        let wide = |polygon: &Polygon| !(flat && self.does(Components::Faces) && polygon.area() <= slack.square_metres);
        joined.into_polygons().filter_map(tidy).filter(wide).collect()
    }

    fn mesh(&self, mesh: &Mesh, slack: &Slack) -> Mesh {
        let mut tidy = mesh.welded(slack.metres.max(1e-9));
        if self.does(Components::Faces) {
            tidy = tidy.without_trifles(slack.square_metres);
        }
        if self.does(Components::Edges) {
            tidy = tidy.with_planes_joined(slack.radians);
        }
        if self.does(Components::Vertices) {
            tidy = tidy.without_straight_corners(slack.radians);
        }
        tidy
    }
}
