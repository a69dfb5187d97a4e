//! Patterns in texts: `*` and `?` ([`glob`]), and regular expressions ([`Regex`]) of the size that rules need.
//!
//! Neither backtracks: the cost is the length of the text times that of the pattern, whatever they are.

mod parse;
mod regex;

pub use regex::Regex;

/// Whether a whole text is as a pattern says: `*` stands for any letters, also none, and `?` for one.
pub fn glob(pattern: &str, text: &str) -> bool {
    let (mut pattern, mut rest) = (pattern.chars(), text.chars());
    // Where to go on when a later letter does not fit: after the last `*`, one letter further.
    let mut retry = None;
    loop {
        let before = (pattern.clone(), rest.clone());
        match (pattern.next(), rest.next()) {
            (Some('*'), _) => {
                rest = before.1;
                retry = Some((pattern.clone(), rest.clone()));
            }
            (None, None) => return true,
            (Some('?'), Some(_)) => {}
            (Some(wanted), Some(found)) if wanted == found => {}
            _ => {
                let Some((after, mut from)) = retry.take() else { return false };
                if from.next().is_none() {
                    return false;
                }
                pattern = after.clone();
                rest = from.clone();
                retry = Some((after, from));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::glob;

    #[test]
    fn stars_stand_for_any_letters_and_marks_for_one() {
        for (pattern, text) in
            [("*", ""), ("a*c", "ac"), ("a*c", "abcbc"), ("?é*", "eée"), ("*a*b*", "xaxbx"), ("", "")]
        {
            assert!(glob(pattern, text), "{pattern} {text}");
        }
        for (pattern, text) in [("?", ""), ("a*c", "abcb"), ("a", "ab"), ("*ab", "aba"), ("?", "ab")] {
            assert!(!glob(pattern, text), "{pattern} {text}");
        }
    }
}
