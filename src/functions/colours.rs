//! Colours as texts `#RRGGBB` and `#RRGGBBOO`: made of parts, taken apart, and looked up on ramps. Shares are 0 to 1,
//! hues 0 to 360 degrees.

use crate::element::{color_bytes, hex_text};
use crate::functions::Function;
use crate::functions::args::{any, number, text_at, wrong};
use crate::functions::ramps;
use crate::value::Value;

/// A part of a colour.
macro_rules! part {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(colour)", (1, 1), $docs, |args, _| {
            let f: fn([f64; 4]) -> f64 = $f;
            Ok(Value::Float(f(parts(args)?)))
        })
        .constant()
    };
}

pub(super) static LIST: &[Function] = &[
    part!("colorHexToR", "The red of a colour, 0 to 1.", |[r, ..]| r),
    part!("colorHexToG", "The green of a colour, 0 to 1.", |[_, g, ..]| g),
    part!("colorHexToB", "The blue of a colour, 0 to 1.", |[_, _, b, _]| b),
    part!("colorHexToO", "The opacity of a colour, 0 to 1; 0 where the text has none.", |[.., o]| o),
    part!("colorHexToH", "The hue of a colour, degrees; 0 for greys.", |[r, g, b, _]| hsv([r, g, b])[0]),
    part!("colorHexToS", "The saturation of a colour, 0 to 1.", |[r, g, b, _]| hsv([r, g, b])[1]),
    part!("colorHexToV", "The brightness of a colour, 0 to 1.", |[r, g, b, _]| hsv([r, g, b])[2]),
    Function::new(
        "colorRGBToHex",
        "(red, green, blue)",
        (3, 3),
        "The colour of three shares, which are clamped.",
        |args, _| Ok(hex(&numbers::<3>(args)?)),
    )
    .text()
    .constant(),
    Function::new(
        "colorRGBOToHex",
        "(red, green, blue, opacity)",
        (4, 4),
        "The colour of three shares with its opacity, all clamped.",
        |args, _| Ok(hex(&numbers::<4>(args)?)),
    )
    .text()
    .constant(),
    Function::new(
        "colorHSVToHex",
        "(hue, saturation, value)",
        (3, 3),
        "The colour of a hue in degrees, which wraps round, and two shares, which are clamped.",
        |args, _| Ok(hex(&rgb(numbers::<3>(args)?))),
    )
    .text()
    .constant(),
    Function::new(
        "colorHSVOToHex",
        "(hue, saturation, value, opacity)",
        (4, 4),
        "As `colorHSVToHex`, with an opacity.",
        |args, _| {
            let [h, s, v, o] = numbers::<4>(args)?;
            let [r, g, b] = rgb([h, s, v]);
            Ok(hex(&[r, g, b, o]))
        },
    )
    .text()
    .constant(),
    Function::new(
        "colorRamp",
        "(gradient, value)",
        (2, 2),
        "The colour at a place from 0 to 1 on a ramp: `whiteToBlack`, `whiteToBlue`, `greenToRed`, `yellowToRed`, \
         `redToBlue`, `orangeToBlue`, `brownToBlue` or `spectrum`.",
        |args, _| {
            let name = text_at(args, 0)?;
            let ramp = ramps::find(name).ok_or_else(|| {
                let known: Vec<String> = ramps::names().map(|name| format!("`{name}`")).collect();
                format!("knows no ramp `{name}`: there are {}", known.join(", "))
            })?;
            Ok(hex(&ramps::at(ramp, number(args, 1)?)))
        },
    )
    .text()
    .constant(),
];

/// Red, green, blue and opacity; the opacity is 0 where the text has none. The `#` may be missing.
fn parts(args: &[Value]) -> Result<[f64; 4], String> {
    let digits = text_at(args, 0)?.trim().trim_start_matches('#');
    match color_bytes(&format!("#{digits}")) {
        Some(bytes) => Ok(std::array::from_fn(|part| bytes.get(part).map_or(0.0, |byte| f64::from(*byte) / 255.0))),
        None => Err(wrong("a colour as `\"#rrggbb\"` or `\"#rrggbboo\"`", any(args, 0)?)),
    }
}

fn numbers<const N: usize>(args: &[Value]) -> Result<[f64; N], String> {
    let mut numbers = [0.0; N];
    for (index, place) in numbers.iter_mut().enumerate() {
        *place = number(args, index)?;
    }
    Ok(numbers)
}

/// As CityEngine writes colours, in capitals.
fn hex(shares: &[f64]) -> Value {
    Value::text(hex_text(shares.iter().copied()).to_uppercase())
}

/// Red, green and blue as hue, saturation and value.
fn hsv([r, g, b]: [f64; 3]) -> [f64; 3] {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let span = most - least;
    if span <= 0.0 {
        return [0.0, 0.0, most];
    }
    let sixth = if most == r {
        ((g - b) / span).rem_euclid(6.0)
    } else if most == g {
        (b - r) / span + 2.0
    } else {
        (r - g) / span + 4.0
    };
    [60.0 * sixth, span / most, most]
}

/// Hue, saturation and value as red, green and blue.
fn rgb([h, s, v]: [f64; 3]) -> [f64; 3] {
    let (s, v) = (s.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
    let sixth = h.rem_euclid(360.0) / 60.0;
    // How far a channel lies from its full sixths, 0 to 1.
    let channel = |shift: f64| {
        let k = (shift + sixth).rem_euclid(6.0);
        v - v * s * k.min(4.0 - k).clamp(0.0, 1.0)
    };
    [channel(5.0), channel(3.0), channel(1.0)]
}
