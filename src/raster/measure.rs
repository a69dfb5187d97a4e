//! What of a pixel counts: its light, its opacity, a band, or how near it is to a colour.

use crate::raster::Flaw;
use crate::raster::pixels::Pixels;

/// What of a pixel counts.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Measure {
    /// Its opacity in pictures with clear pixels, its luminance in others.
    #[default]
    Cover,
    /// Its luminance, 0 black to 1 white; in pictures without colours the first band.
    Luminance,
    /// Its opacity, 0 clear to 1 opaque.
    Opacity,
    /// A band, counted from 0.
    Band(usize),
    /// 1 where each of red, green and blue is within a tolerance of this colour, else 0.
    Color {
        /// Red, green and blue, 0 to 1.
        color: [f32; 3],
        /// The largest difference of a channel.
        tolerance: f32,
    },
}

/// Rec. 709, on the values as they are.
const LIGHT: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// Two colours of eight bits that are written alike are alike.
const ROUNDING: f32 = 1e-4;

impl Measure {
    /// The measure of a word: `cover`, `luminance`, `alpha`, `red`, `green`, `blue`, or the number of a band from 1.
    pub fn parse(word: &str) -> Option<Measure> {
        Some(match word {
            "cover" => Measure::Cover,
            "luminance" => Measure::Luminance,
            "alpha" => Measure::Opacity,
            "red" => Measure::Band(0),
            "green" => Measure::Band(1),
            "blue" => Measure::Band(2),
            number => Measure::Band(number.parse::<usize>().ok()?.checked_sub(1)?),
        })
    }

    /// The measure that a picture answers to: an error where it has no such band.
    pub(super) fn on(&self, pixels: &Pixels) -> Result<Measure, Flaw> {
        let missing = |wanted: String| Flaw::NoBand { wanted, bands: bands(pixels) };
        match self {
            Measure::Cover if pixels.is_clear_somewhere() => Ok(Measure::Opacity),
            Measure::Cover => Measure::Luminance.on(pixels),
            Measure::Luminance if !pixels.is_coloured() => Ok(Measure::Band(0)),
            Measure::Opacity if !pixels.has_alpha() => Err(missing("alpha".into())),
            Measure::Band(band) if *band >= pixels.bands() => Err(missing((band + 1).to_string())),
            Measure::Color { .. } if !pixels.is_coloured() && pixels.bands() > 2 => Err(missing("color".into())),
            other => Ok(other.clone()),
        }
    }

    /// The value of a pixel that has such bands; none where it says nothing.
    pub(super) fn of(&self, pixels: &Pixels, column: usize, row: usize) -> Option<f32> {
        let value = |band: usize| pixels.value(column, row, band);
        match self {
            Measure::Opacity => value(pixels.bands() - 1),
            Measure::Band(band) => value(*band),
            Measure::Cover | Measure::Luminance => {
                Some(LIGHT[0] * value(0)? + LIGHT[1] * value(1)? + LIGHT[2] * value(2)?)
            }
            Measure::Color { color, tolerance } => {
                let far = |channel: usize| {
                    let band = if pixels.is_coloured() { channel } else { 0 };
                    Some((value(band)? - color[channel]).abs() > tolerance + ROUNDING)
                };
                Some(if far(0)? || far(1)? || far(2)? { 0.0 } else { 1.0 })
            }
        }
    }
}

fn bands(pixels: &Pixels) -> String {
    match (pixels.is_coloured(), pixels.has_alpha()) {
        (true, true) => "`red`, `green`, `blue` and `alpha`".into(),
        (true, false) => "`red`, `green` and `blue`".into(),
        (false, true) => "`1` and `alpha`".into(),
        (false, false) => crate::text::counted(pixels.bands(), "band"),
    }
}
