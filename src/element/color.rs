//! Colours as texts: `#rrggbb` and its kin, to and from sRGB with opacity in 0 to 1.

/// The colour that a text means: `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa`, or `rgba(r g b a)` with shares of one.
pub fn parse_color(text: &str) -> Option<[f32; 4]> {
    match text.strip_prefix('#') {
        Some(digits) => parse_hex(digits),
        None => parse_shares(text.strip_prefix("rgba(")?.strip_suffix(')')?),
    }
}

/// The shortest text that [`parse_color`] reads back as exactly this colour.
pub fn color_text(color: [f32; 4]) -> String {
    let bytes = color.map(|share| (share * 255.0).round() as u8);
    if bytes.map(|byte| f32::from(byte) / 255.0) != color {
        return format!("rgba({} {} {} {})", color[0], color[1], color[2], color[3]);
    }
    let [r, g, b, a] = bytes;
    if a == 255 { format!("#{r:02x}{g:02x}{b:02x}") } else { format!("#{r:02x}{g:02x}{b:02x}{a:02x}") }
}

fn parse_hex(digits: &str) -> Option<[f32; 4]> {
    let digits: Vec<u32> = digits.chars().map(|c| c.to_digit(16)).collect::<Option<_>>()?;
    let bytes: Vec<u32> = match digits.len() {
        3 | 4 => digits.iter().map(|d| d * 17).collect(),
        6 | 8 => digits.chunks(2).map(|pair| pair[0] * 16 + pair[1]).collect(),
        _ => return None,
    };
    let share = |i: usize| bytes.get(i).map_or(1.0, |byte| *byte as f32 / 255.0);
    Some([share(0), share(1), share(2), share(3)])
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
