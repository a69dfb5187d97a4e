//! Small things about words, numbers and letters that several rooms say the same way.

/// The candidate nearest to `word`, where one is near enough to be a likely slip of the pen.
///
/// Case and underscores count little: `SetBack` finds `setback`. Cost: linear in the candidates.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let folded = fold(word);
    // One letter more or less makes any other word of two.
    let allowed = match folded.chars().count() {
        0..=2 => 0,
        letters => (letters / 3).clamp(1, 3),
    };
    candidates
        .into_iter()
        .filter(|c| *c != word)
        .map(|c| (distance(&folded, &fold(c)), c))
        .filter(|(d, _)| *d <= allowed)
        .min_by_key(|(d, c)| (*d, c.len().abs_diff(word.len()), *c))
        .map(|(_, c)| c)
}

/// The question after a likely slip of the pen, as a hint of its own.
pub fn did_you_mean(near: &str) -> String {
    format!("did you mean `{near}`?")
}

/// The same as the end of a message, with the colon before it; nothing where nothing is near.
pub fn suggestion(near: Option<&str>) -> String {
    near.map_or(String::new(), |near| format!(": {}", did_you_mean(near)))
}

/// A number as people write it: at most `decimals` places, no trailing zeros, never `-0`.
pub fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// The number that a text begins with, spaces before it aside; not a number where there is none.
pub fn leading_number(text: &str) -> f64 {
    let text = text.trim();
    if let Ok(number) = text.parse() {
        return number;
    }
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let end = text.find(|c: char| !is_part(c)).unwrap_or(text.len()).min(LONGEST_NUMBER);
    (1..=end).rev().find_map(|end| text[..end].parse().ok()).unwrap_or(f64::NAN)
}

/// Characters within which a number must end where other words follow.
const LONGEST_NUMBER: usize = 64;

/// A count with its noun: `1 plant`, `1,204 plants`.
pub fn counted(count: usize, noun: &str) -> String {
    format!("{} {noun}{}", thousands(count), if count == 1 { "" } else { "s" })
}

/// A whole number with commas between thousands.
pub fn thousands(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// An area in m² as people write it, in hectares where it is large.
pub fn area_words(area: f64) -> String {
    match area {
        a if a >= 99_950.0 => format!("{} ha", number(a / 10_000.0, 1)),
        a if a >= 10_000.0 => format!("{} ha", number(a / 10_000.0, 2)),
        a if a >= 10.0 => format!("{} m²", thousands(a.round() as usize)),
        a => format!("{} m²", number(a, 1)),
    }
}

/// The characters of the Windows-1252 bytes from 0x80 on; the five unassigned ones give the control characters of Latin-1.
const FROM_80: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The character of a Windows-1252 byte.
pub fn from_windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9f => FROM_80[usize::from(byte - 0x80)],
        other => char::from(other),
    }
}

/// The byte that [`from_windows_1252`] gives the character for; `?` where there is none.
pub fn to_windows_1252(character: char) -> u8 {
    match FROM_80.iter().position(|c| *c == character) {
        Some(index) => 0x80 + index as u8,
        None => u8::try_from(u32::from(character)).unwrap_or(b'?'),
    }
}

fn fold(word: &str) -> String {
    word.chars().filter(|c| *c != '_' && *c != '-').flat_map(char::to_lowercase).collect()
}

/// Damerau–Levenshtein distance with adjacent transpositions (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut before: Vec<usize> = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let change = usize::from(a[i - 1] != b[j - 1]);
            row[j] = (above[j] + 1).min(row[j - 1] + 1).min(above[j - 1] + change);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_found_and_strangers_are_not() {
        let names = ["split", "setback", "scatter", "extrude"];
        assert_eq!(nearest("splt", names), Some("split"));
        assert_eq!(nearest("SetBack", names), Some("setback"));
        assert_eq!(nearest("extrdue", names), Some("extrude"));
        assert_eq!(nearest("window", names), None);
        assert_eq!(nearest("A", ["B", "C"]), None);
        assert_eq!(suggestion(nearest("splt", names)), ": did you mean `split`?");
        assert_eq!(suggestion(None), "");
    }

    #[test]
    fn every_byte_of_windows_1252_comes_back() {
        assert!((0..=u8::MAX).all(|byte| to_windows_1252(from_windows_1252(byte)) == byte));
        assert_eq!([0x80, 0x9f, 0xe9].map(from_windows_1252), ['€', 'Ÿ', 'é']);
        assert_eq!(to_windows_1252('漢'), b'?');
    }

    #[test]
    fn numbers_read_well() {
        assert_eq!(number(3.0, 3), "3");
        assert_eq!(number(-0.0001, 2), "0");
        assert_eq!(number(2.5, 3), "2.5");
        assert_eq!(counted(1204, "plant"), "1,204 plants");
        assert_eq!(counted(1, "rule"), "1 rule");
        let words = [3.24, 1204.4, 9_999.4, 23_500.0, 1_234_000.0].map(area_words);
        assert_eq!(words, ["3.2 m²", "1,204 m²", "9,999 m²", "2.35 ha", "123.4 ha"]);
    }
}
