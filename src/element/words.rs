//! Enums that texts name by one word each: declared once, read and written everywhere by that word.

use crate::text;

/// A choice that a catalogue or an export writes as a word.
pub trait Words: Copy + 'static {
    /// Every choice with its word, the default first.
    const ALL: &'static [(&'static str, Self)];

    /// The word of this choice.
    fn word(self) -> &'static str;

    /// The choice of that word, written exactly so.
    fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == word).map(|(_, choice)| *choice)
    }

    /// The word that was likely meant.
    fn nearest(word: &str) -> Option<&'static str> {
        text::nearest(word, Self::ALL.iter().map(|(known, _)| *known))
    }
}

/// Gives an enum its words.
macro_rules! words {
    ($name:ident { $($choice:ident = $word:literal),+ $(,)? }) => {
        impl $crate::element::Words for $name {
            const ALL: &'static [(&'static str, $name)] = &[$(($word, $name::$choice)),+];

            fn word(self) -> &'static str {
                match self { $($name::$choice => $word),+ }
            }
        }
    };
}

pub(crate) use words;
