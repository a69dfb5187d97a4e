//! Colours, and the few that belong to the sheet and not to a material.

/// An sRGB colour with opacity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Ink {
    /// Red, green and blue.
    pub rgb: [u8; 3],
    /// 255 covers.
    pub alpha: u8,
}

/// The paper.
pub const PAPER: Ink = Ink::hex(0xf8f4e9);
/// The ground of the plan, a breath darker than the paper.
pub const FIELD: Ink = Ink::hex(0xf3edde);
/// Lettering, frame and the strongest lines.
pub const SEPIA: Ink = Ink::hex(0x3a342b);
/// Second lettering: what may be overlooked.
pub const UMBER: Ink = Ink::hex(0x7b7263);
/// Shadows, before their layer's opacity.
pub const SHADOW: Ink = Ink::hex(0x39402f);
/// Light that falls on edges.
pub const LIGHT: Ink = Ink::hex(0xfffbe8);

impl Ink {
    /// A covering colour from `0xrrggbb`.
    pub const fn hex(rgb: u32) -> Ink {
        Ink { rgb: [(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8], alpha: 255 }
    }

    /// A colour from channels in 0 to 1; what lies outside is taken to the nearest, what is no number to 0.
    pub fn of(color: [f32; 4]) -> Ink {
        let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0).round() as u8;
        Ink { rgb: [byte(color[0]), byte(color[1]), byte(color[2])], alpha: byte(color[3]) }
    }

    /// The colour on the way to another, `share` 0 to 1; keeps its own opacity.
    pub fn mixed(self, other: Ink, share: f64) -> Ink {
        let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share).round() as u8;
        let rgb = std::array::from_fn(|i| mix(self.rgb[i], other.rgb[i]));
        Ink { rgb, alpha: self.alpha }
    }

    /// The same nearer to sepia ink.
    pub fn darker(self, share: f64) -> Ink {
        self.mixed(SEPIA, share)
    }

    /// The same nearer to warm light.
    pub fn lighter(self, share: f64) -> Ink {
        self.mixed(LIGHT, share)
    }

    /// The same with its opacity multiplied.
    pub fn faded(self, opacity: f64) -> Ink {
        Ink { alpha: (f64::from(self.alpha) * opacity).round() as u8, ..self }
    }

    /// Opacity in 0 to 1.
    pub fn opacity(self) -> f64 {
        f64::from(self.alpha) / 255.0
    }
}
