//! The drawing list: what is on the sheet, in millimetres, before anyone has decided for SVG or pixels.
//!
//! Frame: origin in the upper left corner, x right, y down. Layers and items are painted in order. Both backends
//! read only this; nothing here knows what a plant is.

use crate::export::plan::ink::Ink;
use crate::export::plan::path::Path;
use glam::DVec2;

/// A whole sheet.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// The sheet's title, for the file's metadata.
    pub title: String,
    /// The sheet's width and height.
    pub size: DVec2,
    /// Where the plan shows: its upper left and lower right corner.
    pub window: [DVec2; 2],
    /// How many metres of the plan one metre of paper shows: 500 for 1:500.
    pub scale: f64,
    /// The resolution at which the options wanted the picture, in dots per millimetre.
    pub dots: f64,
    /// Pieces drawn many times.
    pub symbols: Vec<Symbol>,
    /// What is drawn, lowest first.
    pub layers: Vec<Layer>,
}

/// A layer, as drawing programs know it.
#[derive(Clone, Debug)]
pub struct Layer {
    /// A word for selectors, unique in the drawing.
    pub id: &'static str,
    /// The name people read.
    pub label: &'static str,
    /// Opacity of the layer as a whole: overlaps inside it do not add up.
    pub opacity: f64,
    /// Standard deviation of the blur over the whole layer, millimetres; 0 for none.
    pub blur: f64,
    /// Whether it shows in the plan's window only.
    pub windowed: bool,
    /// What is on it.
    pub items: Vec<Item>,
}

/// A piece drawn many times; its origin is where it is placed.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// A word unique in the drawing.
    pub id: String,
    /// What it is made of.
    pub shapes: Vec<Shape>,
}

/// Something on a layer.
#[derive(Clone, Debug)]
pub enum Item {
    /// A path with colours.
    Shape(Shape),
    /// A symbol at its place.
    Use(Use),
    /// Lettering.
    Text(Text),
    /// Several, perhaps clipped or named.
    Group(Group),
}

/// A path with fill and stroke; inside is what rings wind around, opposite rings make holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Where.
    pub path: Path,
    /// The colour of the inside.
    pub fill: Option<Ink>,
    /// The line.
    pub stroke: Option<Stroke>,
}

/// A line's colour and width; ends and corners are round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Colour.
    pub ink: Ink,
    /// Width in millimetres.
    pub width: f64,
}

/// A symbol at its place.
#[derive(Clone, Debug)]
pub struct Use {
    /// Index in [`Drawing::symbols`].
    pub symbol: usize,
    /// Where its origin goes.
    pub at: DVec2,
    /// Enlargement.
    pub scale: f64,
    /// Turn in degrees, clockwise on paper.
    pub turn: f64,
    /// What it is, for people who point at it.
    pub title: Option<String>,
}

/// Several items that belong together.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// Words for selectors.
    pub class: String,
    /// What it is, for people who point at it.
    pub title: Option<String>,
    /// Shows only inside of this.
    pub clip: Option<Path>,
    /// What is in it.
    pub items: Vec<Item>,
}

/// A line of lettering.
#[derive(Clone, Debug)]
pub struct Text {
    /// The words.
    pub words: String,
    /// Where on the baseline: its start, middle or end as `anchor` says.
    pub at: DVec2,
    /// Which part of the line stands at `at`.
    pub anchor: Anchor,
    /// How it looks.
    pub style: Style,
    /// A wider outline underneath that keeps it legible.
    pub halo: Option<Stroke>,
}

/// Which part of a line of lettering stands at its point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// The beginning.
    #[default]
    Start,
    /// The middle.
    Middle,
    /// The end.
    End,
}

/// How lettering looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Font size (em) in millimetres.
    pub size: f64,
    /// Colour.
    pub ink: Ink,
    /// Extra space after each letter, in em.
    pub spacing: f64,
    /// Slanted.
    pub italic: bool,
    /// A little stronger than light.
    pub strong: bool,
}

impl Layer {
    /// An empty layer of full opacity inside the plan's window.
    pub fn new(id: &'static str, label: &'static str) -> Layer {
        Layer { id, label, opacity: 1.0, blur: 0.0, windowed: true, items: Vec::new() }
    }
}

impl Shape {
    /// A path filled without a line.
    pub fn filled(path: Path, ink: Ink) -> Shape {
        Shape { path, fill: Some(ink), stroke: None }
    }

    /// A path drawn as a line.
    pub fn drawn(path: Path, ink: Ink, width: f64) -> Shape {
        Shape { path, fill: None, stroke: Some(Stroke { ink, width }) }
    }

    /// The same with a line around it.
    pub fn outlined(mut self, ink: Ink, width: f64) -> Shape {
        self.stroke = Some(Stroke { ink, width });
        self
    }
}

impl Style {
    /// Upright light lettering in sepia.
    pub fn plain(size: f64) -> Style {
        Style { size, ink: crate::export::plan::ink::SEPIA, spacing: 0.0, italic: false, strong: false }
    }

    /// The same in another colour.
    pub fn ink(self, ink: Ink) -> Style {
        Style { ink, ..self }
    }

    /// The same slanted.
    pub fn italic(self) -> Style {
        Style { italic: true, ..self }
    }

    /// The same a little stronger.
    pub fn strong(self) -> Style {
        Style { strong: true, ..self }
    }

    /// The same with letters set apart, in em.
    pub fn spaced(self, spacing: f64) -> Style {
        Style { spacing, ..self }
    }
}

impl Text {
    /// Lettering that starts at a point.
    pub fn new(words: impl Into<String>, at: DVec2, style: Style) -> Text {
        Text { words: words.into(), at, anchor: Anchor::Start, style, halo: None }
    }

    /// The same with another part at its point.
    pub fn anchored(self, anchor: Anchor) -> Text {
        Text { anchor, ..self }
    }

    /// The same with a halo.
    pub fn with_halo(self, ink: Ink, width: f64) -> Text {
        Text { halo: Some(Stroke { ink, width }), ..self }
    }
}

impl From<Shape> for Item {
    fn from(shape: Shape) -> Item {
        Item::Shape(shape)
    }
}

impl From<Use> for Item {
    fn from(placed: Use) -> Item {
        Item::Use(placed)
    }
}

impl From<Text> for Item {
    fn from(text: Text) -> Item {
        Item::Text(text)
    }
}

impl From<Group> for Item {
    fn from(group: Group) -> Item {
        Item::Group(group)
    }
}
