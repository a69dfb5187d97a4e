//! Where faces and edges look, and the words for it: `front`, `object.left`, `world.north`, `street.back`.
//!
//! What looks along an axis looks along the one that its normal points along most: of the scope, of the object (the lot
//! as it was at first), or of the world, whose south is what `front` is elsewhere. By the streets around the lot it looks
//! to their side; where none are known that is the object's.

use crate::shape::{Shape, StreetSide, on_plan};
use glam::DVec3;

/// In which frame a direction is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// That of the scope.
    Scope,
    /// That of the object.
    Object,
    /// The compass.
    World,
    /// That of one who looks at the lot from its widest street.
    Street,
}

/// Some of the six sides in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facing {
    /// The frame.
    pub space: Space,
    /// A bit for each side: right, left, top, bottom, front, back, from the lowest.
    pub sides: u64,
}

const SIDES: [&str; 6] = ["right", "left", "top", "bottom", "front", "back"];
const COMPASS: [&str; 6] = ["east", "west", "up", "down", "south", "north"];

/// The sides that are `side`: all level ones, or, seen from the street, those between front and back.
const LEVEL: u64 = 0b11_0011;
const BETWEEN: u64 = 0b00_0011;

/// What looks up or down by more than this (the height of its unit normal) faces no street.
const UPRIGHT: f64 = 0.98;

impl Space {
    /// All, in their order.
    pub const ALL: [Space; 4] = [Space::Scope, Space::Object, Space::World, Space::Street];

    fn names(self) -> [&'static str; 6] {
        if self == Space::World { COMPASS } else { SIDES }
    }
}

impl Facing {
    /// Every word for a direction, for suggestions and the manual.
    pub const WORDS: [&'static str; 26] = [
        "right",
        "left",
        "top",
        "bottom",
        "front",
        "back",
        "side",
        "object.front",
        "object.back",
        "object.left",
        "object.right",
        "object.top",
        "object.bottom",
        "object.side",
        "street.front",
        "street.back",
        "street.left",
        "street.right",
        "street.side",
        "world.north",
        "world.south",
        "world.east",
        "world.west",
        "world.up",
        "world.down",
        "world.side",
    ];

    /// What a word means; `None` where it is no direction.
    pub fn of_word(word: &str) -> Option<Facing> {
        let (space, name) = match word.split_once('.') {
            None => (Space::Scope, word),
            Some(("object", name)) => (Space::Object, name),
            Some(("world", name)) => (Space::World, name),
            Some(("street", name)) => (Space::Street, name),
            Some(_) => return None,
        };
        let sides = match (space, name) {
            (Space::Street, "side") => BETWEEN,
            (_, "side") => LEVEL,
            _ => 1 << space.names().iter().position(|side| *side == name)?,
        };
        Some(Facing { space, sides })
    }
}

impl Shape {
    /// The bit of the side to which a component looks in a frame, by its middle and its normal in the scope; 0 where it
    /// looks up or down and faces no street. Linear in the edges of the lot where streets are known, else constant.
    pub fn side(&self, space: Space, middle: DVec3, normal: DVec3) -> u64 {
        let world = self.scope.frame.rotation * normal;
        match (space, &self.style.streets) {
            (Space::Scope, _) => side(normal),
            (Space::World, _) => side(world),
            (Space::Object, _) | (Space::Street, None) => side(self.style.object.inverse() * world),
            (Space::Street, Some(_)) if world.y.abs() > UPRIGHT => 0,
            (Space::Street, Some(streets)) => {
                let at = on_plan(self.scope.frame.to_world(middle));
                streets.side(at, on_plan(world)).map_or(0, street)
            }
        }
    }
}

/// The bit of the axis along which a direction points most.
fn side(direction: DVec3) -> u64 {
    let size = direction.abs();
    let axis = if size.y >= size.x && size.y >= size.z {
        1
    } else if size.z >= size.x {
        2
    } else {
        0
    };
    1 << (2 * axis + usize::from(direction[axis] < 0.0))
}

/// The bit of a street side.
fn street(side: StreetSide) -> u64 {
    match side {
        StreetSide::Right => 1,
        StreetSide::Left => 1 << 1,
        StreetSide::Front => 1 << 4,
        StreetSide::Back => 1 << 5,
    }
}
