//! The built-in functions and shape attributes of the language, and [`all`], the list.
//!
//! A function takes values and what surrounds the current shape, and gives a value. `rand` draws from the shape's own
//! stream, so a function's result depends on the shape alone.

mod attributes;
mod edges;
mod geometry;
mod material;
mod math;
mod occlusion;
mod position;
mod random;
mod species;
mod surface;
mod text;

pub use position::At;

use crate::element::Catalogue;
use crate::geometry::Polygon;
use crate::raster::Rasters;
use crate::seed::Random;
use crate::shape::{NodeId, Occluders, Shape};
use crate::value::{Array, Value};
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
    /// Gives the same for the same arguments anywhere: may be computed before derivation.
    pub constant: bool,
    /// What sort of value it gives.
    pub gives: Gives,
    /// `set()` may change it.
    pub settable: bool,
    /// It asks how shapes lie to each other.
    pub looks_around: bool,
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
    /// What its arguments are: `setElems`, `transpose`.
    Same,
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
}

/// What rules can ask of their initial shape.
#[derive(Clone, Debug, Default)]
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
    text::LIST,
    geometry::LIST,
    surface::LIST,
    occlusion::LIST,
    position::LIST,
    species::LIST,
    edges::LIST,
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
            constant: false,
            gives: Gives::Number,
            settable: false,
            looks_around: false,
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

/// The number at `index`.
fn number(args: &[Value], index: usize) -> Result<f64, String> {
    let value = args.get(index).ok_or("an argument is missing")?;
    value.as_float().ok_or_else(|| format!("takes a number, found {} `{value}`", value.type_name()))
}

/// The text at `index`.
fn text_at(args: &[Value], index: usize) -> Result<&str, String> {
    let value = args.get(index).ok_or("an argument is missing")?;
    value.as_str().ok_or_else(|| format!("takes a text, found {} `{value}`", value.type_name()))
}
