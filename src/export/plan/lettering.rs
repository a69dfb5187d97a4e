//! Lettering: how wide words are, and their outlines for the backend that knows no fonts.
//!
//! One embedded free font (Ubuntu Light) measures for both backends, so that a legend is laid out the same.
//! Slant is a shear and strength a stroke: one font file does for all styles. Kerning is applied; scripts that need
//! shaping are set letter by letter.

use crate::export::plan::drawing::{Anchor, Style, Text};
use crate::export::plan::path::{Path, Step};
use ab_glyph::{Font, FontRef, GlyphId, OutlineCurve};
use glam::DVec2;
use std::sync::LazyLock;

/// The slant of italics: sideways per height.
pub const SLANT: f64 = 0.19;
/// Stroke that makes letters strong, in em.
pub const STRENGTH: f64 = 0.035;

static FONT: LazyLock<FontRef<'static>> =
    LazyLock::new(|| FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT).expect("the embedded font is sound"));

/// Width of a line of words in millimetres.
pub fn width(words: &str, style: &Style) -> f64 {
    let mut last = 0.0;
    place(words, style, |_, _, end| last = end - style.spacing * style.size);
    last
}

/// Where a text's line starts on its baseline.
pub fn start(text: &Text) -> DVec2 {
    let share = match text.anchor {
        Anchor::Start => return text.at,
        Anchor::Middle => 0.5,
        Anchor::End => 1.0,
    };
    text.at - DVec2::new(share * width(&text.words, &text.style), 0.0)
}

/// The outlines of all letters of a text, where they stand.
pub fn outlines(text: &Text) -> Path {
    let (mut path, origin) = (Path::default(), start(text));
    place(&text.words, &text.style, |glyph, x, _| {
        add_glyph(&mut path, glyph, origin + DVec2::new(x, 0.0), &text.style)
    });
    path
}

/// The words cut to a width, with an ellipsis where something is missing.
pub fn fitted(words: &str, style: &Style, room: f64) -> String {
    if width(words, style) <= room {
        return words.to_string();
    }
    let mut letters: Vec<char> = words.chars().collect();
    while letters.pop().is_some() {
        let shorter = letters.iter().collect::<String>().trim_end().to_string() + "…";
        if width(&shorter, style) <= room {
            return shorter;
        }
    }
    String::new()
}

/// The words on as many lines as a width needs; a single word may be wider.
pub fn wrapped(words: &str, style: &Style, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), style) <= room => *line = format!("{line} {word}"),
            _ => lines.push(word.to_string()),
        }
    }
    lines
}

/// Calls `visit` with each glyph, its start and its end on the line, millimetres.
fn place(words: &str, style: &Style, mut visit: impl FnMut(GlyphId, f64, f64)) {
    let scale = style.size / em();
    let (mut x, mut before) = (0.0, None);
    for letter in words.chars().filter(|c| !c.is_control()) {
        let glyph = FONT.glyph_id(letter);
        x += before.map_or(0.0, |b| f64::from(FONT.kern_unscaled(b, glyph)) * scale);
        let end = x + f64::from(FONT.h_advance_unscaled(glyph)) * scale + style.spacing * style.size;
        visit(glyph, x, end);
        (x, before) = (end, Some(glyph));
    }
}

fn em() -> f64 {
    f64::from(FONT.units_per_em().unwrap_or(1000.0))
}

fn add_glyph(path: &mut Path, glyph: GlyphId, at: DVec2, style: &Style) {
    let Some(outline) = FONT.outline(glyph) else { return };
    let (scale, slant) = (style.size / em(), if style.italic { SLANT } else { 0.0 });
    let point = |p: ab_glyph::Point| {
        let (x, y) = (f64::from(p.x) * scale, f64::from(p.y) * scale);
        at + DVec2::new(x + slant * y, -y)
    };
    let mut pen: Option<DVec2> = None;
    for curve in &outline.curves {
        let (from, step) = match curve {
            OutlineCurve::Line(a, b) => (point(*a), Step::Line(point(*b))),
            OutlineCurve::Quad(a, b, c) => (point(*a), cubic(point(*a), point(*b), point(*c))),
            OutlineCurve::Cubic(a, b, c, d) => (point(*a), Step::Curve(point(*b), point(*c), point(*d))),
        };
        if pen.is_none_or(|pen| pen.distance_squared(from) > 1e-12) {
            path.steps.push(Step::Move(from));
        }
        path.steps.push(step);
        pen = Some(match step {
            Step::Line(p) | Step::Curve(_, _, p) => p,
            Step::Move(_) | Step::Close => from,
        });
    }
}

fn cubic(from: DVec2, handle: DVec2, to: DVec2) -> Step {
    Step::Curve(from.lerp(handle, 2.0 / 3.0), to.lerp(handle, 2.0 / 3.0), to)
}
