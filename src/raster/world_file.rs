//! World files: six lines beside a picture that say where it lies.
//!
//! The numbers are, in this order, how x and y change by a column (lines 1 and 2), how they change by a row (3 and 4),
//! and x and y of the centre of the upper left pixel (5 and 6). Names no coordinate system: it is the layout's.

use glam::{DAffine2, DVec2};

/// Where the world file of a picture may be: `cover.pgw`, `cover.pngw`, `cover.wld` for `cover.png`.
pub fn names(path: &str) -> Vec<String> {
    let (stem, ending) = path.rsplit_once('.').filter(|(_, e)| !e.contains('/')).unwrap_or((path, ""));
    let lower = ending.to_ascii_lowercase();
    let short = match lower.as_str() {
        "png" => "pgw",
        "tif" | "tiff" => "tfw",
        _ => "wld",
    };
    let long = format!("{lower}w");
    let mut endings = vec![short, long.as_str(), "wld"];
    endings.dedup();
    endings.into_iter().map(|ending| format!("{stem}.{ending}")).collect()
}

/// The map from pixels, the upper left corner of the picture at 0, 0 and y downwards, to its coordinates.
pub fn parse(bytes: &[u8]) -> Result<DAffine2, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "it is no text".to_owned())?;
    let text = text.trim_start_matches('\u{feff}');
    let number = |word: &str| {
        let value: Option<f64> = word.parse().ok().filter(|n: &f64| n.is_finite());
        value.ok_or_else(|| format!("`{}` is no number", word.chars().take(20).collect::<String>()))
    };
    // A stranger's file may be long: seven words are enough to know.
    let numbers = text.split_whitespace().take(7).map(number).collect::<Result<Vec<f64>, String>>()?;
    let [a, d, b, e, c, f] = numbers[..] else { return Err(format!("it has {} numbers", numbers.len())) };
    let (column, row) = (DVec2::new(a, d), DVec2::new(b, e));
    Ok(DAffine2::from_cols(column, row, DVec2::new(c, f) - (column + row) * 0.5))
}
