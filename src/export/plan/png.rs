//! The drawing list as pixels.
//!
//! What the plan's window shows is drawn on a picture of its own, which clips it; layers with opacity or blur get
//! one more. Lettering is drawn from the outlines of the embedded font, so no machine's fonts matter. Pixels may
//! differ by a hair between processors: compare with a tolerance.

use crate::export::plan::drawing::{Drawing, Group, Item, Layer, Shape, Stroke, Symbol, Text, Use};
use crate::export::plan::ink::Ink;
use crate::export::plan::lettering;
use crate::export::plan::palette;
use crate::export::plan::path::{Path, Step};
use glam::DVec2;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use tiny_skia::{FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, PixmapPaint, Transform};

/// The largest picture: as much as an A1 sheet at 300 dots per inch.
pub const MOST_PIXELS: u64 = 80_000_000;

/// How fine the picture is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Resolution {
    /// As the plan's options wanted.
    #[default]
    Drawn,
    /// So many dots per inch.
    DotsPerInch(f64),
    /// So many pixels across; the height follows.
    Width(u32),
}

/// Why a plan cannot be a picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// More pixels than [`MOST_PIXELS`], or none.
    #[error("a picture of {width} × {height} pixels cannot be made; between 1 and {MOST_PIXELS} pixels will do")]
    Size {
        /// Width in pixels.
        width: f64,
        /// Height in pixels.
        height: f64,
    },
    /// The picture could not be packed.
    #[error("the picture could not be packed: {0}")]
    Packing(String),
}

/// Paints a drawing and packs it as PNG, with its resolution noted in the file.
pub fn png(drawing: &Drawing, resolution: Resolution) -> Result<Vec<u8>, PlanError> {
    let dots = resolution.dots(drawing);
    let sheet = painted(drawing, dots)?;
    packed(&rgb(&sheet.pixels), [sheet.pixels.width(), sheet.pixels.height()], dots, FilterType::Adaptive)
}

/// The same in so few colours that the file is a third as large: for pictures that stand in texts.
pub fn small_png(drawing: &Drawing, colours: usize) -> Result<Vec<u8>, PlanError> {
    let sheet = painted(drawing, drawing.dots)?;
    let mut rgb = rgb(&sheet.pixels);
    palette::reduce(&mut rgb, colours);
    packed(&rgb, [sheet.pixels.width(), sheet.pixels.height()], drawing.dots, FilterType::NoFilter)
}

impl Resolution {
    /// Dots per millimetre of paper.
    fn dots(self, drawing: &Drawing) -> f64 {
        match self {
            Resolution::Drawn => drawing.dots,
            Resolution::DotsPerInch(dots) => dots / 25.4,
            Resolution::Width(width) => f64::from(width) / drawing.size.x,
        }
    }
}

fn painted(drawing: &Drawing, dots: f64) -> Result<Canvas, PlanError> {
    let mut sheet = Canvas::new(DVec2::ZERO, drawing.size, dots)?;
    let [from, to] = drawing.window;
    let symbols: Vec<Vec<Drawn>> = drawing.symbols.iter().map(prepared).collect();
    let mut window: Option<Canvas> = None;
    for layer in &drawing.layers {
        // The window's picture goes on the sheet before the first layer above it that is not clipped.
        if layer.windowed {
            if window.is_none() {
                window = Some(Canvas::new(from, to - from, dots)?);
            }
            window.as_mut().map_or(Ok(()), |canvas| canvas.layer(layer, &symbols))?;
        } else {
            window.take().iter().for_each(|canvas| sheet.lay(canvas, 1.0));
            sheet.layer(layer, &symbols)?;
        }
    }
    window.take().iter().for_each(|canvas| sheet.lay(canvas, 1.0));
    Ok(sheet)
}

/// A picture of a part of the sheet.
struct Canvas {
    pixels: Pixmap,
    /// The sheet's pixel in its upper left corner.
    corner: [i32; 2],
    /// Pixels per millimetre.
    dots: f64,
}

/// A shape whose path has been built.
struct Drawn<'a> {
    path: tiny_skia::Path,
    shape: &'a Shape,
}

impl Canvas {
    /// An empty picture of a part of the sheet, millimetres.
    fn new(from: DVec2, size: DVec2, dots: f64) -> Result<Canvas, PlanError> {
        let (low, high) = ((from * dots).round(), ((from + size) * dots).round());
        let pixels = (high - low).max(DVec2::ONE);
        let error = PlanError::Size { width: (size.x * dots).round(), height: (size.y * dots).round() };
        let sound = dots.is_finite() && dots > 0.0 && pixels.is_finite();
        if !sound || pixels.x * pixels.y > MOST_PIXELS as f64 {
            return Err(error);
        }
        let pixels = Pixmap::new(pixels.x as u32, pixels.y as u32).ok_or(error)?;
        Ok(Canvas { pixels, corner: [low.x as i32, low.y as i32], dots })
    }

    /// An empty picture of the same place.
    fn blank(&self) -> Option<Canvas> {
        let pixels = Pixmap::new(self.pixels.width(), self.pixels.height())?;
        Some(Canvas { pixels, corner: self.corner, dots: self.dots })
    }

    /// From millimetres on the sheet to pixels of this picture.
    fn transform(&self) -> Transform {
        let dots = self.dots as f32;
        Transform::from_row(dots, 0.0, 0.0, dots, -self.corner[0] as f32, -self.corner[1] as f32)
    }

    /// Lays another picture over this one.
    fn lay(&mut self, other: &Canvas, opacity: f64) {
        let paint = PixmapPaint { opacity: opacity as f32, ..PixmapPaint::default() };
        let (x, y) = (other.corner[0] - self.corner[0], other.corner[1] - self.corner[1]);
        self.pixels.draw_pixmap(x, y, other.pixels.as_ref(), &paint, Transform::identity(), None);
    }

    fn layer(&mut self, layer: &Layer, symbols: &[Vec<Drawn>]) -> Result<(), PlanError> {
        if layer.items.is_empty() {
            return Ok(());
        }
        if layer.opacity >= 1.0 && layer.blur <= 0.0 {
            layer.items.iter().for_each(|item| self.item(item, symbols));
            return Ok(());
        }
        let Some(mut own) = self.blank() else { return Ok(()) };
        layer.items.iter().for_each(|item| own.item(item, symbols));
        own.blur(layer.blur);
        self.lay(&own, layer.opacity);
        Ok(())
    }

    fn item(&mut self, item: &Item, symbols: &[Vec<Drawn>]) {
        match item {
            Item::Shape(shape) => drawn(shape).iter().for_each(|d| self.shape(d, self.transform())),
            Item::Use(placed) => self.placed(placed, symbols),
            Item::Text(text) => self.text(text),
            Item::Group(group) => self.group(group, symbols),
        }
    }

    fn placed(&mut self, placed: &Use, symbols: &[Vec<Drawn>]) {
        let transform = self
            .transform()
            .pre_translate(placed.at.x as f32, placed.at.y as f32)
            .pre_rotate(placed.turn as f32)
            .pre_scale(placed.scale as f32, placed.scale as f32);
        symbols.get(placed.symbol).into_iter().flatten().for_each(|d| self.shape(d, transform));
    }

    fn shape(&mut self, drawn: &Drawn, transform: Transform) {
        if let Some(ink) = drawn.shape.fill {
            self.pixels.fill_path(&drawn.path, &paint(ink), FillRule::Winding, transform, None);
        }
        if let Some(line) = drawn.shape.stroke {
            self.pixels.stroke_path(&drawn.path, &paint(line.ink), &pen(line.width), transform, None);
        }
    }

    fn text(&mut self, text: &Text) {
        let path = lettering::outlines(text);
        let layer = |fill: Option<Ink>, stroke: Option<Stroke>| Shape { path: path.clone(), fill, stroke };
        let strength = Stroke { ink: text.style.ink, width: lettering::STRENGTH * text.style.size };
        let halo = text.halo.map(|halo| layer(Some(halo.ink), Some(halo)));
        let words = layer(Some(text.style.ink), text.style.strong.then_some(strength));
        for shape in halo.iter().chain([&words]) {
            drawn(shape).iter().for_each(|d| self.shape(d, self.transform()));
        }
    }

    fn group(&mut self, group: &Group, symbols: &[Vec<Drawn>]) {
        let Some(clip) = &group.clip else {
            return group.items.iter().for_each(|item| self.item(item, symbols));
        };
        let Some((mut part, mask)) = built(clip).and_then(|path| self.part(&path)) else { return };
        group.items.iter().for_each(|item| part.item(item, symbols));
        part.pixels.apply_mask(&mask);
        self.lay(&part, 1.0);
    }

    /// An empty picture as large as a path that clips it, and the path as its mask; `None` where it shows nothing.
    fn part(&self, path: &tiny_skia::Path) -> Option<(Canvas, Mask)> {
        let bounds = path.bounds().transform(self.transform())?;
        let (width, height) = (self.pixels.width() as i32, self.pixels.height() as i32);
        let (left, top) =
            ((bounds.left().floor() as i32).clamp(0, width), (bounds.top().floor() as i32).clamp(0, height));
        let right = (bounds.right().ceil() as i32).clamp(left, width);
        let bottom = (bounds.bottom().ceil() as i32).clamp(top, height);
        let (width, height) = ((right - left) as u32, (bottom - top) as u32);
        let corner = [self.corner[0] + left, self.corner[1] + top];
        let part = Canvas { pixels: Pixmap::new(width, height)?, corner, dots: self.dots };
        let mut mask = Mask::new(width, height)?;
        mask.fill_path(path, FillRule::Winding, true, part.transform());
        Some((part, mask))
    }

    /// Blurs by a standard deviation in millimetres: three box filters come close to a Gaussian.
    fn blur(&mut self, deviation: f64) {
        let pixels = deviation * self.dots;
        let radius = (((4.0 * pixels * pixels + 1.0).sqrt() - 1.0) / 2.0).round() as usize;
        let (width, height) = (self.pixels.width() as usize, self.pixels.height() as usize);
        if radius == 0 || radius * 2 >= width.min(height) {
            return;
        }
        for _ in 0..3 {
            box_rows(self.pixels.data_mut(), width, radius);
            box_columns(self.pixels.data_mut(), width, radius);
        }
    }
}

/// The mean of `2 · radius + 1` neighbours along each row, four channels at a time.
fn box_rows(data: &mut [u8], width: usize, radius: usize) {
    let mut before = vec![0u8; width * 4];
    for row in data.chunks_exact_mut(width * 4) {
        before.copy_from_slice(row);
        for channel in 0..4 {
            let at = |x: usize| u32::from(before[x.min(width - 1) * 4 + channel]);
            let mut sum = (0..radius).map(at).sum::<u32>() + at(0) * (radius as u32 + 1);
            for x in 0..width {
                sum = sum + at(x + radius) - if x > 0 { at((x - 1).saturating_sub(radius)) } else { at(0) };
                row[x * 4 + channel] = (sum / (2 * radius as u32 + 1)) as u8;
            }
        }
    }
}

/// The same along columns, a whole row at a time so that memory is read in order.
fn box_columns(data: &mut [u8], width: usize, radius: usize) {
    let (stride, height) = (width * 4, data.len() / (width * 4));
    let before = data.to_vec();
    let row = |y: usize| &before[y.min(height - 1) * stride..][..stride];
    let mut sums: Vec<u32> = row(0).iter().map(|b| u32::from(*b) * (radius as u32 + 1)).collect();
    for y in 0..radius {
        sums.iter_mut().zip(row(y)).for_each(|(sum, b)| *sum += u32::from(*b));
    }
    for (y, out) in data.chunks_exact_mut(stride).enumerate() {
        let leaving = row(y.saturating_sub(radius + 1));
        for (((sum, new), old), byte) in sums.iter_mut().zip(row(y + radius)).zip(leaving).zip(out) {
            *sum = *sum + u32::from(*new) - u32::from(*old);
            *byte = (*sum / (2 * radius as u32 + 1)) as u8;
        }
    }
}

fn prepared(symbol: &Symbol) -> Vec<Drawn<'_>> {
    symbol.shapes.iter().filter_map(drawn).collect()
}

fn drawn(shape: &Shape) -> Option<Drawn<'_>> {
    Some(Drawn { path: built(&shape.path)?, shape })
}

/// The path as the rasteriser wants it; `None` where it has no extent or a number is not finite.
fn built(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    let xy = |p: DVec2| (p.x as f32, p.y as f32);
    for step in &path.steps {
        match *step {
            Step::Move(p) => builder.move_to(xy(p).0, xy(p).1),
            Step::Line(p) => builder.line_to(xy(p).0, xy(p).1),
            Step::Curve(a, b, p) => builder.cubic_to(xy(a).0, xy(a).1, xy(b).0, xy(b).1, xy(p).0, xy(p).1),
            Step::Close => builder.close(),
        }
    }
    builder.finish()
}

fn paint(ink: Ink) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    let [r, g, b] = ink.rgb;
    paint.set_color_rgba8(r, g, b, ink.alpha);
    paint
}

fn pen(width: f64) -> tiny_skia::Stroke {
    let (line_cap, line_join) = (LineCap::Round, LineJoin::Round);
    tiny_skia::Stroke { width: width as f32, line_cap, line_join, ..tiny_skia::Stroke::default() }
}

/// The picture as a PNG file: paper is opaque, so three channels do.
fn rgb(pixels: &Pixmap) -> Vec<u8> {
    pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
}

fn packed(rgb: &[u8], [width, height]: [u32; 2], dots: f64, filter: FilterType) -> Result<Vec<u8>, PlanError> {
    let mut bytes = Vec::new();
    // Few colours only come out small where the packer looks for long repetitions.
    let effort = if filter == FilterType::NoFilter { CompressionType::Best } else { CompressionType::Default };
    PngEncoder::new_with_quality(&mut bytes, effort, filter)
        .write_image(rgb, width, height, ExtendedColorType::Rgb8)
        .map_err(|error| PlanError::Packing(error.to_string()))?;
    note_resolution(&mut bytes, dots);
    Ok(bytes)
}

/// Puts the `pHYs` chunk behind the header, which always ends at byte 33.
fn note_resolution(bytes: &mut Vec<u8>, dots: f64) {
    let per_metre = ((dots * 1000.0).round() as u32).to_be_bytes();
    let chunk = [b"pHYs".as_slice(), &per_metre, &per_metre, &[1]].concat();
    let check = crc(&chunk).to_be_bytes();
    bytes.splice(33..33, [9u32.to_be_bytes().as_slice(), &chunk, &check].concat());
}

/// The check sum PNG uses (CRC-32).
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| if c & 1 == 1 { (c >> 1) ^ 0xedb8_8320 } else { c >> 1 })
    })
}
