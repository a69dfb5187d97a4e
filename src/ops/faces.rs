//! Components and the words that select them.
//!
//! A face looks `front` where its normal points along the scope's z more than along its other axes, `back` against
//! it, `right` and `left` along x, `top` and `bottom` along y; an edge of a flat shape looks where its outward normal
//! points. `object.…` asks in the frame of the initial shape, `world.…` in the world's, `street.…` by the streets
//! around the lot.

use crate::shape::{Shape, StreetSide, on_plan};
use glam::DVec3;

/// A part of a shape that a selector can take.
pub struct Component {
    /// As the engine shows it to conditions.
    pub shape: Shape,
    /// The usual words that it answers to.
    pub selectors: Selectors,
    /// Further words.
    pub words: &'static [&'static str],
}

impl Component {
    /// Whether it is what other components leave over, not a component itself.
    pub fn is_rest(&self) -> bool {
        self.selectors == Selectors::none()
    }
}

/// A set of selector words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Selectors(u64);

const SIDES: [&str; 6] = ["right", "left", "top", "bottom", "front", "back"];
/// The sides in the frames of scope, object, world and street, each with as many bits as there are sides.
const OBJECT: u32 = 6;
const WORLD: u32 = 12;
const STREET: u32 = 18;
/// Words without a frame stand behind them, in this order.
const PLAIN: u32 = 24;
const PLAIN_WORDS: [&str; 11] =
    ["horizontal", "vertical", "aslant", "nutant", "all", "border", "inside", "eave", "hip", "valley", "ridge"];
const UV: u32 = 35;
const UV_WORDS: [&str; 8] = ["uv.left", "uv.right", "uv.bottom", "uv.top", "uv.uMin", "uv.uMax", "uv.vMin", "uv.vMax"];
const ALL: u64 = 1 << (PLAIN + 4);
const BORDER: u64 = 1 << (PLAIN + 5);
const INSIDE: u64 = 1 << (PLAIN + 6);

/// What an edge between two slopes of a roof is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoofEdge {
    /// At the foot of a slope.
    Eave,
    /// Between two slopes, from an eave up.
    Hip,
    /// Between two slopes that meet in a hollow.
    Valley,
    /// Any other between two slopes.
    Ridge,
}

impl Selectors {
    /// The words of a component: its middle and its outward normal in the scope, and the shape it belongs to.
    pub fn of(middle: DVec3, normal: DVec3, shape: &Shape) -> Selectors {
        let world = shape.scope.frame.rotation * normal;
        let object = side(shape.style.object.inverse() * world);
        let street = match &shape.style.streets {
            None => object,
            Some(streets) => {
                let at = on_plan(shape.scope.frame.to_world(middle));
                let upright = world.y.abs() > UPRIGHT;
                streets.side(at, on_plan(world)).filter(|_| !upright).map_or(0, street)
            }
        };
        // North is −z: in the world `front` is south.
        let sides = side(normal) | object << OBJECT | side(world) << WORLD | street << STREET;
        Selectors(ALL | sides | slope(world) << PLAIN)
    }

    /// Only `all`.
    pub fn all() -> Selectors {
        Selectors(ALL)
    }

    /// None: not even `all` takes it.
    pub fn none() -> Selectors {
        Selectors(0)
    }

    /// The words of either.
    pub fn or(self, other: Selectors) -> Selectors {
        Selectors(self.0 | other.0)
    }

    /// The same with `border`.
    pub fn border(self) -> Selectors {
        Selectors(self.0 | BORDER)
    }

    /// The same with `inside`.
    pub fn inside(self) -> Selectors {
        Selectors(self.0 | INSIDE)
    }

    /// The same with the word of an edge of a roof.
    pub fn roof(self, edge: RoofEdge) -> Selectors {
        Selectors(self.0 | 1 << (PLAIN + 7 + edge as u32))
    }

    /// The same with one of the eight `uv.…` words, by its place: left, right, bottom and top by the way an edge looks,
    /// then least u, greatest u, least v and greatest v.
    pub fn uv(self, place: usize) -> Selectors {
        Selectors(self.0 | 1 << (UV as usize + place))
    }

    /// Whether the two have a word in common.
    pub fn meets(self, other: Selectors) -> bool {
        self.0 & other.0 != 0
    }

    /// The bits of a word; `None` where it is not a selector.
    pub fn of_word(word: &str) -> Option<Selectors> {
        let plain =
            |words: &[&str], first: u32| words.iter().position(|w| *w == word).map(|i| 1 << (first as usize + i));
        let bits = plain(&PLAIN_WORDS, PLAIN).or_else(|| plain(&UV_WORDS, UV));
        bits.or_else(|| of_side(word)).map(Selectors)
    }

    /// Every word, for suggestions and the manual.
    pub fn words() -> impl Iterator<Item = &'static str> {
        let far = [
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
            "streetSide",
            "noStreetSide",
        ];
        SIDES.into_iter().chain(PLAIN_WORDS).chain(far).chain(UV_WORDS)
    }
}

/// What looks up or down by more than this (the height of its unit normal) faces no street.
const UPRIGHT: f64 = 0.98;

/// The bits of a side in one of the frames.
fn of_side(word: &str) -> Option<u64> {
    let (space, name) = word.split_once('.').unwrap_or(("", word));
    let shift = match space {
        "" => 0,
        "object" => OBJECT,
        "world" => WORLD,
        "street" => STREET,
        _ => return None,
    };
    let sides = |bits: u64| Some(bits << shift);
    match (space, name) {
        ("", "streetSide") => Some(0b01_0000 << STREET),
        ("", "noStreetSide") => Some(0b10_0011 << STREET),
        ("street", "side") => sides(0b00_0011),
        (_, "side") => sides(0b11_0011),
        ("world", name) => {
            let names = ["east", "west", "up", "down", "south", "north"];
            names.iter().position(|n| *n == name).and_then(|index| sides(1 << index))
        }
        _ => SIDES.iter().position(|s| *s == name).and_then(|index| sides(1 << index)),
    }
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

/// The bit of the axis along which a direction points most.
fn side(direction: DVec3) -> u64 {
    let size = direction.abs();
    let axis = if size.y >= size.x && size.y >= size.z {
        2
    } else if size.z >= size.x {
        4
    } else {
        0
    };
    let along = [direction.x, direction.y, direction.z][axis / 2];
    1 << (axis + usize::from(along < 0.0))
}

/// The bit of the slope: the angle between a face's normal and the level plane.
fn slope(normal: DVec3) -> u64 {
    let angle = libm::asin(normal.y.clamp(-1.0, 1.0)).to_degrees();
    match angle {
        a if a.abs() > 78.75 => 1,
        a if a.abs() <= 11.25 => 2,
        a if a > 0.0 => 4,
        _ => 8,
    }
}
