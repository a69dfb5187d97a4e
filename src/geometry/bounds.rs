//! Axis-parallel rectangles.

use glam::DVec2;

/// The rectangle from `min` to `max`; empty where a minimum exceeds its maximum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner.
    pub min: DVec2,
    /// Upper right corner.
    pub max: DVec2,
}

impl Bounds {
    /// The bounds of nothing: neutral in [`Bounds::union`].
    pub const EMPTY: Bounds = Bounds { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// The least rectangle around the points.
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |b, p| Bounds { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The least rectangle around both.
    pub fn union(self, other: Bounds) -> Bounds {
        Bounds { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Width and height; zero for nothing.
    pub fn size(self) -> DVec2 {
        (self.max - self.min).max(DVec2::ZERO)
    }

    /// The middle.
    pub fn centre(self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Whether nothing is inside.
    pub fn is_empty(self) -> bool {
        self.min.x > self.max.x || self.min.y > self.max.y
    }

    /// Whether the two share a point.
    pub fn touches(self, other: Bounds) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }

    /// Whether the point lies inside or on the rim.
    pub fn contains(self, point: DVec2) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// The same grown by `margin` on every side.
    pub fn grown(self, margin: f64) -> Bounds {
        Bounds { min: self.min - margin, max: self.max + margin }
    }
}
