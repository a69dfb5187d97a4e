//! The built-in functions and shape attributes of the language, and [`all`], the list.
//!
//! A function takes values and what surrounds the current shape, and gives a value. `rand` draws from the shape's own
//! stream, so a function's result depends on the shape alone.

mod args;
mod arrays;
mod assets;
mod attributes;
mod choice;
mod colours;
mod context;
mod coordinates;
mod edges;
mod elements;
mod files;
mod fold;
mod geometry;
mod kinds;
mod lists;
mod material;
mod math;
mod occlusion;
mod position;
mod ramps;
mod random;
mod species;
mod surface;
mod text;
mod trace;

pub use fold::folded;
pub use position::At;

use crate::element::Catalogue;
use crate::files::Files;
use crate::geometry::Polygon;
use crate::layout::Georeference;
use crate::raster::Rasters;
use crate::seed::Random;
use crate::shape::{Frame, NodeId, Occluders, Shape};
use crate::value::{Array, Value};
use std::cell::RefCell;
use std::sync::Arc;

/// A function or shape attribute as checker and engine find it.
pub struct Function {
    /// How it is called, dots included.
    pub name: &'static str,
    /// Its arguments as the manual writes them: `(value, min, max)`; empty for attributes.
    pub signature: &'static str,
    /// What it gives.
    pub docs: &'static str,
    /// The least and the greatest number of arguments.
    pub arity: (usize, usize),
    /// Arguments that are bare words: selectors such as `intra`.
    pub words: &'static [&'static str],
    /// How many of the first arguments may be such words.
    pub words_within: usize,
    /// Gives the same for the same arguments anywhere: may be computed before derivation.
    pub constant: bool,
    /// What sort of value it gives.
    pub gives: Gives,
    /// `set()` may change it.
    pub settable: bool,
    /// It asks how shapes lie to each other.
    pub looks_around: bool,
    /// It asks which selector took a component.
    pub asks_for_selectors: bool,
    /// It asks for tags, so operations set theirs.
    pub asks_for_tags: bool,
    /// CityEngine's, or ours.
    pub added: bool,
    /// Its value.
    pub call: fn(&[Value], &mut Surroundings) -> Result<Value, String>,
}

/// What sort of value a function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// A number.
    Number,
    /// A truth value.
    Truth,
    /// A text.
    Text,
    /// An array of numbers.
    Numbers,
    /// An array of truth values.
    Truths,
    /// An array of texts.
    Texts,
    /// What its first argument is: `setElems`, `transpose`.
    Same,
    /// A truth value for each of its first argument: `isNull`.
    TruthOfEach,
    /// What only its arguments tell: `sum`.
    Any,
}

/// What a function may look at.
pub struct Surroundings<'a> {
    /// The current shape; none while attributes without one are folded.
    pub shape: &'a Shape,
    /// The shape's own numbers.
    pub random: &'a mut Random,
    /// The earlier shapes and the features of the lot.
    pub intra: &'a Occluders,
    /// The initial shapes of the neighbours.
    pub inter: &'a Occluders,
    /// The node of the current shape, and whether another node is an ancestor of it.
    pub is_ancestor: &'a dyn Fn(NodeId) -> bool,
    /// The initial shape.
    pub initial: &'a Initial,
    /// The place for which an argument that may vary is evaluated.
    pub at: Option<&'a At<'a>>,
    /// The element repository.
    pub catalogue: &'a Catalogue,
    /// Coverage maps.
    pub rasters: &'a Rasters<'a>,
    /// Tables, texts, and what files there are.
    pub files: &'a Files<'a>,
    /// The number of the rule file that asks: paths are relative to it.
    pub source: u16,
    /// The way from the plan to the layout's own coordinates.
    pub georeference: &'a Georeference,
    /// The path to the shape's node as `0;2;1;`.
    pub tree_key: &'a dyn Fn() -> String,
    /// What `print` was given, for whoever keeps it.
    pub told: &'a RefCell<Vec<Value>>,
}

/// What rules can ask of their initial shape.
#[derive(Clone, Debug)]
pub struct Initial {
    /// The region's name.
    pub name: Arc<str>,
    /// The start rule.
    pub start: Arc<str>,
    /// The region's kind.
    pub kind: Arc<str>,
    /// The region's zone.
    pub zone: Arc<str>,
    /// The region's outline on the plan.
    pub outline: Option<Polygon>,
    /// The region's attributes that have a value for each edge of the outline, without `/edgeattr/` before their names.
    pub edge_attributes: Vec<(Arc<str>, Arc<Array>)>,
    /// The object's coordinates: from the outline's first point, x along the first edge, y up.
    pub object: Frame,
}

/// Every function and attribute, by group.
pub fn all() -> impl Iterator<Item = &'static Function> {
    FUNCTIONS.iter().copied().flatten()
}

/// The function or attribute of that name.
pub fn find(name: &str) -> Option<&'static Function> {
    all().find(|f| f.name == name)
}

static FUNCTIONS: &[&[Function]] = &[
    math::LIST,
    random::LIST,
    kinds::LIST,
    text::LIST,
    lists::LIST,
    arrays::LIST,
    elements::LIST,
    geometry::LIST,
    surface::LIST,
    coordinates::LIST,
    occlusion::LIST,
    context::LIST,
    position::LIST,
    species::LIST,
    edges::LIST,
    files::LIST,
    assets::LIST,
    choice::LIST,
    colours::LIST,
    trace::LIST,
    attributes::LIST,
    material::LIST,
    material::COLORS.as_flattened(),
    material::PLACINGS.as_flattened(),
    material::WHOLE,
];

impl Function {
    const fn new(
        name: &'static str,
        signature: &'static str,
        arity: (usize, usize),
        docs: &'static str,
        call: fn(&[Value], &mut Surroundings) -> Result<Value, String>,
    ) -> Function {
        Function {
            name,
            signature,
            docs,
            arity,
            words: &[],
            words_within: usize::MAX,
            constant: false,
            gives: Gives::Number,
            settable: false,
            looks_around: false,
            asks_for_selectors: false,
            asks_for_tags: false,
            added: false,
            call,
        }
    }

    const fn constant(mut self) -> Function {
        self.constant = true;
        self
    }

    const fn words(mut self, words: &'static [&'static str]) -> Function {
        self.words = words;
        self
    }

    /// Words only among the first so many arguments.
    const fn words_within(mut self, arguments: usize) -> Function {
        self.words_within = arguments;
        self
    }

    const fn truth(mut self) -> Function {
        self.gives = Gives::Truth;
        self
    }

    const fn text(mut self) -> Function {
        self.gives = Gives::Text;
        self
    }

    const fn gives(mut self, gives: Gives) -> Function {
        self.gives = gives;
        self
    }

    const fn settable(mut self) -> Function {
        self.settable = true;
        self
    }

    const fn asking_for_selectors(mut self) -> Function {
        self.asks_for_selectors = true;
        self
    }

    const fn looking(mut self) -> Function {
        self.looks_around = true;
        self
    }

    const fn tagging(mut self) -> Function {
        self.asks_for_tags = true;
        self
    }

    const fn added(mut self) -> Function {
        self.added = true;
        self
    }
}
