//! Colours in a file: texts such as `"#9bb86b"`, and ground covers, which have colours of their own.

use crate::element::{color_text, parse_color};
use crate::ide::Desk;
use crate::ide::document::Document;
use crate::ide::walk::Role;
use crate::ops;
use crate::syntax::TokenKind;
use std::ops::Range;

/// A colour and where it is said.
#[derive(Clone, Debug, PartialEq)]
pub struct Swatch {
    /// The text literal, quotes included, or the cover's name.
    pub range: Range<usize>,
    /// sRGB and opacity, 0 to 1.
    pub color: [f32; 4],
}

impl Desk<'_> {
    /// Every colour that a file says.
    pub fn swatches(&self, path: &str) -> Vec<Swatch> {
        let Some(document) = self.document(path) else { return Vec::new() };
        let count = document.tokens.len();
        let swatch = |token: usize| {
            let color = match document.kind(token)? {
                TokenKind::Text => self.text_color(&document, token)?,
                TokenKind::Name => self.leaf_color(&document, token)?,
                _ => return None,
            };
            Some(Swatch { range: document.range(token), color })
        };
        (0..count).filter_map(swatch).collect()
    }

    /// How a colour is written over what stands at a stretch; `None` where no colour is written but a cover's name.
    pub fn color_written(&self, path: &str, range: Range<usize>, color: [f32; 4]) -> Option<String> {
        let document = self.document(path)?;
        let old = document.text().get(range)?;
        let share = |channel: f32| if channel.is_finite() { channel.clamp(0.0, 1.0) } else { 0.0 };
        let byte = |channel: f32| (share(channel) * 255.0).round() / 255.0;
        old.starts_with("\"#").then(|| format!("\"{}\"", color_text(color.map(byte))))
    }

    /// `"#rrggbb"` anywhere; a cover's name where a material is set.
    fn text_color(&self, document: &Document, token: usize) -> Option<[f32; 4]> {
        let text = document.text_of(token);
        if text.starts_with('#') {
            return parse_color(text);
        }
        let material = token.checked_sub(2).map(|before| document.word(before));
        let cover = self.catalogue.cover(text).filter(|_| material == Some("material.name"))?;
        Some(cover.material.fill)
    }

    /// A leaf that is a ground cover.
    fn leaf_color(&self, document: &Document, token: usize) -> Option<[f32; 4]> {
        let name = document.name_at(token).filter(|name| name.role == Role::Step)?;
        let word = document.word(token);
        let cover = self.catalogue.cover(word).filter(|_| ops::find(word).is_none())?;
        let is_leaf = self.segments(document, &name).iter().all(|segment| segment.identity.is_none());
        is_leaf.then_some(cover.material.fill)
    }
}
