//! Colours as texts: `#rrggbb` and its kin, to and from sRGB with opacity in 0 to 1.

/// The colour that a text means: `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa`, or `rgba(r g b a)` with shares of one.
pub fn parse_color(text: &str) -> Option<[f32; 4]> {
    if let Some(shares) = text.strip_prefix("rgba(") {
        return parse_shares(shares.strip_suffix(')')?);
    }
    let bytes = color_bytes(text)?;
    Some(std::array::from_fn(|index| bytes.get(index).map_or(1.0, |byte| f32::from(*byte) / 255.0)))
}

/// The bytes behind a `#`: three, or four with an opacity.
pub fn color_bytes(text: &str) -> Option<Vec<u8>> {
    let digits = text.strip_prefix('#')?.chars().map(|c| Some(c.to_digit(16)? as u8));
    let digits: Vec<u8> = digits.collect::<Option<_>>()?;
    match digits.len() {
        3 | 4 => Some(digits.iter().map(|digit| digit * 17).collect()),
        6 | 8 => Some(digits.chunks(2).map(|pair| pair[0] * 16 + pair[1]).collect()),
        _ => None,
    }
}

/// Shares from 0 to 1 as the nearest bytes behind a `#`; what lies outside is clamped, and what is no number is 0.
pub fn hex_text(shares: impl IntoIterator<Item = f64>) -> String {
    let byte = |share: f64| (share.clamp(0.0, 1.0) * 255.0).round() as u8;
    shares.into_iter().fold(String::from("#"), |text, share| text + &format!("{:02x}", byte(share)))
}

/// The shortest text that [`parse_color`] reads back as exactly this colour.
pub fn color_text(color: [f32; 4]) -> String {
    let bytes = color.map(|share| (share * 255.0).round() as u8);
    if bytes.map(|byte| f32::from(byte) / 255.0) != color {
        return format!("rgba({} {} {} {})", color[0], color[1], color[2], color[3]);
    }
    let said = if bytes[3] == 255 { 3 } else { 4 };
    hex_text(color.into_iter().take(said).map(f64::from))
}

fn parse_shares(text: &str) -> Option<[f32; 4]> {
    let shares: Vec<f32> = text.split_whitespace().map(|part| part.parse().ok()).collect::<Option<_>>()?;
    shares.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_usual_spelling_is_read() {
        assert_eq!(parse_color("#fff"), Some([1.0; 4]));
        assert_eq!(parse_color("#ff0000"), parse_color("#f00f"));
        assert_eq!(parse_color("#00000000"), Some([0.0; 4]));
        for bad in ["", "#", "#12", "#gggggg", "red", "rgba(1 2)", "#1234567"] {
            assert_eq!(parse_color(bad), None, "{bad}");
        }
    }

    #[test]
    fn colours_come_back_exactly() {
        for color in [[0.1, 0.25, 1.0 / 3.0, 0.9], [1.0, 0.0, 0.2, 1.0], [0.5, 0.5, 0.5, 0.0]] {
            assert_eq!(parse_color(&color_text(color)), Some(color));
        }
        assert_eq!(color_text([1.0, 0.0, 0.2, 1.0]), "#ff0033");
    }
}
