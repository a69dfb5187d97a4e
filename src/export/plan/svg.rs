//! The drawing list as SVG: millimetres as user units, layers as drawing programs know them, real lettering.
//!
//! Numbers have at most three decimals (a thousandth of a millimetre), names are escaped, characters that XML forbids
//! are left out. Same drawing, same bytes. Cost: linear in the drawing.

use crate::export::plan::drawing::{Anchor, Drawing, Group, Item, Layer, Shape, Stroke, Style, Symbol, Text, Use};
use crate::export::plan::ink::Ink;
use crate::export::plan::path::{Path, Step};
use glam::DVec2;
use std::fmt::Write;

/// The fonts asked for; the first is the one that was measured.
const FONTS: &str = "Ubuntu, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";

/// Writes a drawing.
pub fn svg(drawing: &Drawing) -> String {
    let mut page = Page { out: String::with_capacity(1 << 16), symbols: &drawing.symbols, clips: 0 };
    page.head(drawing);
    page.definitions(drawing);
    for layer in &drawing.layers {
        page.layer(layer);
    }
    page.out.push_str("</svg>\n");
    page.out
}

/// What has been written, and what is needed on the way.
struct Page<'a> {
    out: String,
    symbols: &'a [Symbol],
    clips: usize,
}

impl Page<'_> {
    fn head(&mut self, drawing: &Drawing) {
        self.out.push_str("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
        self.out.push_str(" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"");
        let (width, height) = (decimal(drawing.size.x), decimal(drawing.size.y));
        self.write(format_args!(" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\""));
        self.write(format_args!(" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\""));
        self.write(format_args!(" font-family=\"{FONTS}\" font-weight=\"300\">\n"));
        self.title(&drawing.title);
        let scale = decimal(drawing.scale);
        self.write(format_args!(
            "\n<desc>Planting plan, scale 1:{scale}; one unit is one millimetre of paper.</desc>\n"
        ));
    }

    fn definitions(&mut self, drawing: &Drawing) {
        self.out.push_str("<defs>\n");
        let [from, to] = drawing.window;
        self.clip_path("window", &Path::rectangle(from, to - from));
        for layer in drawing.layers.iter().filter(|l| l.blur > 0.0) {
            let (id, blur) = (layer.id, decimal(layer.blur));
            self.write(format_args!("<filter id=\"soft-{id}\"><feGaussianBlur stdDeviation=\"{blur}\"/></filter>\n"));
        }
        for symbol in &drawing.symbols {
            self.write(format_args!("<g id=\"{}\">", symbol.id));
            symbol.shapes.iter().for_each(|s| self.shape(s));
            self.out.push_str("</g>\n");
        }
        self.out.push_str("</defs>\n");
    }

    fn layer(&mut self, layer: &Layer) {
        let (id, label) = (layer.id, layer.label);
        self.write(format_args!("<g id=\"{id}\" class=\"layer\" inkscape:groupmode=\"layer\""));
        self.write(format_args!(" inkscape:label=\"{label}\""));
        if layer.opacity < 1.0 {
            self.write(format_args!(" opacity=\"{}\"", decimal(layer.opacity)));
        }
        if layer.windowed {
            self.out.push_str(" clip-path=\"url(#window)\"");
        }
        self.out.push_str(">\n");
        // The blur has a group of its own: it must come before the layer's clip.
        if layer.blur > 0.0 {
            self.write(format_args!("<g filter=\"url(#soft-{id})\">\n"));
        }
        layer.items.iter().for_each(|item| self.item(item));
        self.out.push_str(if layer.blur > 0.0 { "</g>\n</g>\n" } else { "</g>\n" });
    }

    fn item(&mut self, item: &Item) {
        match item {
            Item::Shape(shape) => self.shape(shape),
            Item::Use(placed) => self.placed(placed),
            Item::Text(text) => self.text(text),
            Item::Group(group) => self.group(group),
        }
        self.out.push('\n');
    }

    fn group(&mut self, group: &Group) {
        let clip = group.clip.as_ref().map(|clip| {
            self.clips += 1;
            let id = format!("clip-{}", self.clips);
            self.clip_path(&id, clip);
            id
        });
        self.out.push_str("<g");
        if !group.class.is_empty() {
            self.attribute("class", &group.class);
        }
        if let Some(id) = clip {
            self.write(format_args!(" clip-path=\"url(#{id})\""));
        }
        self.out.push('>');
        group.title.iter().for_each(|t| self.title(t));
        self.out.push('\n');
        group.items.iter().for_each(|item| self.item(item));
        self.out.push_str("</g>");
    }

    fn clip_path(&mut self, id: &str, path: &Path) {
        self.write(format_args!("<clipPath id=\"{id}\"><path d=\""));
        self.steps(path);
        self.out.push_str("\"/></clipPath>\n");
    }

    fn shape(&mut self, shape: &Shape) {
        self.out.push_str("<path d=\"");
        self.steps(&shape.path);
        self.out.push('"');
        shape.fill.iter().for_each(|ink| self.paint("fill", *ink));
        shape.stroke.iter().for_each(|stroke| self.stroke(stroke));
        self.out.push_str("/>");
    }

    fn placed(&mut self, placed: &Use) {
        let Some(symbol) = self.symbols.get(placed.symbol) else { return };
        let (x, y) = (decimal(placed.at.x), decimal(placed.at.y));
        self.write(format_args!("<use href=\"#{}\" transform=\"translate({x} {y})", symbol.id));
        if placed.turn != 0.0 {
            self.write(format_args!("rotate({})", decimal(placed.turn)));
        }
        self.write(format_args!("scale({})\"", decimal(placed.scale)));
        match &placed.title {
            None => self.out.push_str("/>"),
            Some(title) => {
                self.out.push('>');
                self.title(title);
                self.out.push_str("</use>");
            }
        }
    }

    fn text(&mut self, text: &Text) {
        let (x, y, size) = (decimal(text.at.x), decimal(text.at.y), decimal(text.style.size));
        self.write(format_args!("<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\""));
        self.style(&text.style);
        match text.anchor {
            Anchor::Start => {}
            Anchor::Middle => self.out.push_str(" text-anchor=\"middle\""),
            Anchor::End => self.out.push_str(" text-anchor=\"end\""),
        }
        if let Some(halo) = &text.halo {
            self.stroke(halo);
            self.out.push_str(" paint-order=\"stroke\"");
        }
        self.out.push('>');
        self.escaped(&text.words);
        self.out.push_str("</text>");
    }

    fn style(&mut self, style: &Style) {
        self.paint("fill", style.ink);
        if style.spacing != 0.0 {
            self.write(format_args!(" letter-spacing=\"{}\"", decimal(style.spacing * style.size)));
        }
        if style.italic {
            self.out.push_str(" font-style=\"italic\"");
        }
        if style.strong {
            self.out.push_str(" font-weight=\"400\"");
        }
    }

    fn paint(&mut self, what: &str, ink: Ink) {
        let [r, g, b] = ink.rgb;
        self.write(format_args!(" {what}=\"#{r:02x}{g:02x}{b:02x}\""));
        if ink.alpha < 255 {
            self.write(format_args!(" {what}-opacity=\"{}\"", decimal(ink.opacity())));
        }
    }

    fn stroke(&mut self, stroke: &Stroke) {
        self.paint("stroke", stroke.ink);
        self.write(format_args!(" stroke-width=\"{}\"", decimal(stroke.width)));
    }

    fn steps(&mut self, path: &Path) {
        let mut pen = DVec2::NAN;
        for step in &path.steps {
            match *step {
                Step::Move(p) => self.points('M', &[p]),
                Step::Line(p) if p.y == pen.y => self.write(format_args!("H{}", decimal(p.x))),
                Step::Line(p) if p.x == pen.x => self.write(format_args!("V{}", decimal(p.y))),
                Step::Line(p) => self.points('L', &[p]),
                Step::Curve(a, b, p) => self.points('C', &[a, b, p]),
                Step::Close => self.out.push('Z'),
            }
            pen = match *step {
                Step::Move(p) | Step::Line(p) | Step::Curve(_, _, p) => p,
                Step::Close => DVec2::NAN,
            };
        }
    }

    fn points(&mut self, command: char, points: &[DVec2]) {
        self.out.push(command);
        for (i, point) in points.iter().enumerate() {
            let space = if i > 0 { " " } else { "" };
            self.write(format_args!("{space}{} {}", decimal(point.x), decimal(point.y)));
        }
    }

    fn title(&mut self, words: &str) {
        self.out.push_str("<title>");
        self.escaped(words);
        self.out.push_str("</title>");
    }

    fn attribute(&mut self, name: &str, value: &str) {
        self.write(format_args!(" {name}=\""));
        self.escaped(value);
        self.out.push('"');
    }

    /// Text as XML has it; characters that no XML file may hold are left out.
    fn escaped(&mut self, words: &str) {
        for letter in words.chars() {
            match letter {
                '&' => self.out.push_str("&amp;"),
                '<' => self.out.push_str("&lt;"),
                '>' => self.out.push_str("&gt;"),
                '"' => self.out.push_str("&quot;"),
                '\u{fffe}' | '\u{ffff}' => {}
                c if c.is_control() && !matches!(c, '\n' | '\t') => {}
                c => self.out.push(c),
            }
        }
    }

    fn write(&mut self, words: std::fmt::Arguments) {
        // Writing to a string cannot fail.
        let _ = self.out.write_fmt(words);
    }
}

/// A number with at most three decimals and no trailing zeros; no number at all becomes 0.
fn decimal(value: f64) -> Decimal {
    Decimal((value * 1000.0).round() as i64)
}

/// A number in thousandths.
struct Decimal(i64);

impl std::fmt::Display for Decimal {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let (whole, rest) = (self.0.unsigned_abs() / 1000, self.0.unsigned_abs() % 1000);
        let sign = if self.0 < 0 { "-" } else { "" };
        match rest {
            0 => write!(f, "{sign}{whole}"),
            r if r % 100 == 0 => write!(f, "{sign}{whole}.{}", r / 100),
            r if r % 10 == 0 => write!(f, "{sign}{whole}.{:02}", r / 10),
            r => write!(f, "{sign}{whole}.{r:03}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn numbers_are_short_and_exact_to_a_thousandth() {
        let words = [0.0, -0.0004, 1.5, -0.25, 12.345_6, 1e3, -0.001, f64::NAN].map(|v| decimal(v).to_string());
        assert_eq!(words, ["0", "0", "1.5", "-0.25", "12.346", "1000", "-0.001", "0"]);
    }
}
