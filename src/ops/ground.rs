//! The ground that placements work on: a shape's surface brought onto the plan, and places brought back as shapes.
//!
//! Level shapes are placed on in plan coordinates, so that buildings, trees and rasters are where they are; others
//! (a green wall) in coordinates of their own plane, where nothing else stands.

use crate::geometry::Area;
use crate::ops::{Part, Problem, fit, points};
use crate::placement::{Line, Spot};
use crate::shape::{Geometry, Place, Plane, Shape, on_plan};
use glam::{DAffine2, DMat3, DQuat, DVec2, DVec3};

/// A surface to place on.
pub struct Ground {
    /// The surface: on the plan where it is level, else in its plane.
    pub area: Area,
    /// Whether it is on the plan.
    pub level: bool,
    plane: Plane,
    lift: DVec3,
    /// From the plane's coordinates to those of `area`.
    map: DAffine2,
}

impl Ground {
    /// The surface of a flat shape or the top of a prism.
    pub fn of(shape: &Shape) -> Result<Ground, Problem> {
        let (plane, area, lift) = points::surface(shape)?;
        let mut ground = Ground { area: Area::empty(), level: false, map: DAffine2::IDENTITY, plane, lift };
        ground.lie_on(shape);
        ground.area = area.transformed(&ground.map);
        Ok(ground)
    }

    /// The lines of a path, to be placed on within `outline`; nothing for other shapes.
    pub fn of_path(shape: &Shape, outline: &Area) -> Option<(Ground, Vec<Line>)> {
        let Geometry::Path(points) = &shape.geometry else { return None };
        let lift = DVec3::Y * points[0].y;
        let mut ground =
            Ground { area: outline.clone(), level: true, map: DAffine2::IDENTITY, plane: Plane::Ground, lift };
        ground.lie_on(shape);
        let points = points.iter().map(|p| on_plan(shape.scope.frame.to_world(*p))).collect();
        Some((ground, vec![Line { points, closed: false }]))
    }

    /// The rims of the surface as closed lines, its inside on their left.
    pub fn rims(&self) -> Vec<Line> {
        let rings = self.area.polygons().iter().flat_map(|polygon| polygon.rings());
        rings.map(|ring| Line { points: ring.to_vec(), closed: true }).collect()
    }

    /// The direction of the scope's x axis.
    pub fn along(&self) -> DVec2 {
        let x = self.plane.foot(DVec3::X) - self.plane.foot(DVec3::ZERO);
        self.map.transform_vector2(x).normalize_or(DVec2::X)
    }

    /// A place in the coordinates of the shape.
    pub fn local(&self, p: DVec2) -> DVec3 {
        self.plane.at(self.map.inverse().transform_point2(p)) + self.lift
    }

    /// A point shape for each place: y along the surface's normal, x along the place's direction.
    pub fn children(&self, shape: &Shape, spots: &[Spot]) -> Vec<Part> {
        let total = spots.len() as u32;
        let turned = |(index, spot): (u32, &Spot)| {
            let mut child = fit::point(shape, self.local(spot.position));
            child.scope.frame.rotation = (shape.scope.frame.rotation * self.turn(spot.direction)).normalize();
            child.ordinals.place = Place { index, total, radius: spot.radius, cluster: spot.cluster, disk: None };
            Part::new(0, child)
        };
        (0..).zip(spots).map(turned).collect()
    }

    /// Puts the plane onto the plan where it is level and faces up.
    fn lie_on(&mut self, shape: &Shape) {
        let frame = &shape.scope.frame;
        self.level = (frame.rotation * self.plane.normal()).y > 1.0 - 1e-9;
        if self.level {
            let (u, v) = self.plane.axes();
            let (u, v) = (on_plan(frame.rotation * u), on_plan(frame.rotation * v));
            self.map = DAffine2::from_cols(u, v, on_plan(frame.to_world(self.plane.at(DVec2::ZERO))));
        }
    }

    /// How a child with its x axis in that direction is turned against the shape.
    fn turn(&self, direction: DVec2) -> DQuat {
        let along = self.map.inverse().transform_vector2(direction).normalize_or(DVec2::X);
        let (u, v) = self.plane.axes();
        let (x, y) = (u * along.x + v * along.y, self.plane.normal());
        DQuat::from_mat3(&DMat3::from_cols(x, y, x.cross(y)))
    }
}
