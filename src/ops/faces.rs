//! Components and the words that select them.
//!
//! A face looks `front` where its normal points along the scope's z more than along its other axes, `back` against
//! it, `right` and `left` along x, `top` and `bottom` along y; an edge of a flat shape looks where its outward normal
//! points. `object.…` asks in the frame of the initial shape, `world.…` in the world's, `street.…` by the streets
//! around the lot.

use crate::shape::{Facing, Shape, Space};
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

const STREET_WORDS: [&str; 2] = ["streetSide", "noStreetSide"];
/// Words without a frame stand behind the sides of the four frames, in this order.
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
        let of_space = |space: Space| shape.side(space, middle, normal) << shift(space);
        let sides = Space::ALL.map(of_space).into_iter().fold(0, |all, side| all | side);
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
        Facing::WORDS.into_iter().chain(STREET_WORDS).chain(PLAIN_WORDS).chain(UV_WORDS)
    }
}

/// The bits of a direction.
fn of_side(word: &str) -> Option<u64> {
    let bits = |facing: Facing| facing.sides << shift(facing.space);
    match word {
        "streetSide" => Facing::of_word("street.front").map(bits),
        "noStreetSide" => ["street.back", "street.side"].into_iter().map(|word| Facing::of_word(word).map(bits)).sum(),
        _ => Facing::of_word(word).map(bits),
    }
}

/// Where the bits of a frame begin.
fn shift(space: Space) -> u32 {
    6 * space as u32
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
