//! Components and the words that select them.
//!
//! A face looks `front` where its normal points along the scope's z more than along its other axes, `back` against
//! it, `right` and `left` along x, `top` and `bottom` along y; an edge of a flat shape looks where its outward normal
//! points. `object.…` asks in the frame of the initial shape, `world.…` in the world's.

use crate::shape::Shape;
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
pub struct Selectors(u32);

const SIDES: [&str; 6] = ["right", "left", "top", "bottom", "front", "back"];
const ALL: u32 = 1 << 30;
const BORDER: u32 = 1 << 29;
const INSIDE: u32 = 1 << 28;
/// Bits of the slopes follow those of scope, object and world.
const SLOPES: u32 = 18;
const SLOPE_WORDS: [&str; 4] = ["horizontal", "vertical", "aslant", "nutant"];

impl Selectors {
    /// The words of a component: its outward normal in the scope, and the shape it belongs to.
    pub fn of_normal(normal: DVec3, shape: &Shape) -> Selectors {
        let world = shape.scope.frame.rotation * normal;
        let object = shape.style.object.inverse() * world;
        // North is −z: in the world `front` is south.
        Selectors(ALL | side(normal) | side(object) << 6 | side(world) << 12 | slope(world) << SLOPES)
    }

    /// Only `all`.
    pub fn all() -> Selectors {
        Selectors(ALL)
    }

    /// None: not even `all` takes it.
    pub fn none() -> Selectors {
        Selectors(0)
    }

    /// The same with `border`.
    pub fn border(self) -> Selectors {
        Selectors(self.0 | BORDER)
    }

    /// The same with `inside`.
    pub fn inside(self) -> Selectors {
        Selectors(self.0 | INSIDE)
    }

    /// Whether the two have a word in common.
    pub fn meets(self, other: Selectors) -> bool {
        self.0 & other.0 != 0
    }

    /// The bits of a word; `None` where it is not a selector.
    pub fn of_word(word: &str) -> Option<Selectors> {
        let (space, name) = word.split_once('.').unwrap_or(("", word));
        let shift = match space {
            "" => 0,
            // Without street edges `street.…` means the object's sides.
            "object" | "street" => 6,
            "world" => 12,
            _ => return None,
        };
        let bits = match (space, name) {
            (_, "side") => 0b11_0011 << shift,
            ("world", "east") => 1 << 12,
            ("world", "west") => 1 << 13,
            ("world", "up") => 1 << 14,
            ("world", "down") => 1 << 15,
            ("world", "south") => 1 << 16,
            ("world", "north") => 1 << 17,
            ("world", _) => return None,
            ("", "all") => ALL,
            ("", "border") => BORDER,
            ("", "inside") => INSIDE,
            _ => match SIDES.iter().position(|s| *s == name) {
                Some(index) => 1 << (shift + index),
                None => 1 << (SLOPES as usize + SLOPE_WORDS.iter().position(|s| *s == name && space.is_empty())?),
            },
        };
        Some(Selectors(bits))
    }

    /// Every word, for suggestions and the manual.
    pub fn words() -> impl Iterator<Item = &'static str> {
        let usual = ["all", "side", "border", "inside"];
        let far = [
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
        SIDES.into_iter().chain(usual).chain(SLOPE_WORDS).chain(far)
    }
}

/// The bit of the axis along which a direction points most.
fn side(direction: DVec3) -> u32 {
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
fn slope(normal: DVec3) -> u32 {
    let angle = libm::asin(normal.y.clamp(-1.0, 1.0)).to_degrees();
    match angle {
        a if a.abs() > 78.75 => 1,
        a if a.abs() <= 11.25 => 2,
        a if a > 0.0 => 4,
        _ => 8,
    }
}
