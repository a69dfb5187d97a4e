//! The built-in operations, one file each, and [`OPERATIONS`], the list that nobody repeats.
//!
//! An operation takes a shape and gives pieces; it never calls the engine. Which block entry a piece goes to is
//! decided in two steps for operations with selectors: [`Apply::components`] says what there is to choose from, the
//! engine chooses, [`Apply::apply`] builds. Operations that derive inside themselves (inline, union, modify) will be
//! one more case of [`Pieces`].

mod declare;
mod spec;
mod unbuilt;

mod align_scope_to_axes;
mod align_scope_to_geometry;
mod along;
mod boundary;
mod center;
mod cluster;
mod color;
mod comp;
mod coverage;
mod distr;
mod envelope;
mod equidistant;
mod extrude;
mod faces;
mod fit;
mod ground;
mod insert;
mod insert_along_uv;
mod instance;
mod label;
mod offset;
mod plant;
mod points;
mod primitives;
mod print;
mod projection;
mod r;
mod regular;
mod report;
mod reset_geometry;
mod rotate_scope;
mod rows;
mod s;
mod scatter;
mod semirandom;
mod set;
mod setback;
mod single;
mod split;
mod split_uv;
mod strategy;
mod t;
mod tag;
mod texture;
mod translate;
mod uv;
mod without;

pub use faces::{Component, Selectors};
pub use ground::Ground;
pub use spec::{AttributeName, BlockKind, Origin, Param, ParamKind, Parameter, Spec, Word};
pub use split::Cut;
pub use unbuilt::{UNBUILT_FUNCTIONS, UNBUILT_OPERATIONS, Unbuilt};

use crate::element::Catalogue;
use crate::geometry::Area;
use crate::placement::{Field, Standing};
use crate::raster::Rasters;
use crate::seed::Seed;
use crate::shape::{Geometry, NodeId, Shape};
use crate::value::{Array, Value};
use crate::world::World;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Every operation, in the order of the manual.
pub static OPERATIONS: &[Operation] = &[
    split::Split::OPERATION,
    comp::Comp::OPERATION,
    setback::Setback::OPERATION,
    offset::Offset::OPERATION,
    without::Without::OPERATION,
    coverage::Coverage::OPERATION,
    scatter::Scatter::OPERATION,
    distr::Distr::OPERATION,
    semirandom::SemiRandom::OPERATION,
    boundary::Boundary::OPERATION,
    cluster::Cluster::OPERATION,
    single::Single::OPERATION,
    equidistant::Equidistant::OPERATION,
    regular::Regular::OPERATION,
    along::AlongLines::OPERATION,
    rows::ParallelRows::OPERATION,
    rows::Quincunx::OPERATION,
    extrude::Extrude::OPERATION,
    insert::Insert::OPERATION,
    insert_along_uv::InsertAlongUv::OPERATION,
    instance::Instance::OPERATION,
    plant::Plant::OPERATION,
    primitives::Quad::OPERATION,
    primitives::Disk::OPERATION,
    primitives::Cube::OPERATION,
    primitives::Cylinder::OPERATION,
    primitives::Cone::OPERATION,
    primitives::Sphere::OPERATION,
    t::Translate::OPERATION,
    s::Resize::OPERATION,
    r::Rotate::OPERATION,
    center::Center::OPERATION,
    translate::Move::OPERATION,
    translate::Turn::OPERATION,
    align_scope_to_axes::AlignScopeToAxes::OPERATION,
    align_scope_to_geometry::AlignScopeToGeometry::OPERATION,
    align_scope_to_geometry::AlignToBox::OPERATION,
    rotate_scope::RotateScope::OPERATION,
    rotate_scope::MirrorScope::OPERATION,
    rotate_scope::SetPivot::OPERATION,
    reset_geometry::ResetGeometry::OPERATION,
    set::Set::OPERATION,
    color::Color::OPERATION,
    texture::SetTexture::OPERATION,
    texture::SetMaterial::OPERATION,
    texture::ResetMaterial::OPERATION,
    projection::SetupProjection::OPERATION,
    projection::ProjectUv::OPERATION,
    uv::TranslateUv::OPERATION,
    uv::ScaleUv::OPERATION,
    uv::RotateUv::OPERATION,
    uv::NormalizeUv::OPERATION,
    uv::TileUv::OPERATION,
    uv::CopyUv::OPERATION,
    uv::DeleteUv::OPERATION,
    tag::Tag::OPERATION,
    tag::DeleteTags::OPERATION,
    tag::SetTagsFromEdgeAttrs::OPERATION,
    label::Label::OPERATION,
    report::ReportValue::OPERATION,
    print::PrintValue::OPERATION,
];

/// An operation as the engine finds it.
pub struct Operation {
    /// Its declaration.
    pub spec: &'static Spec,
    /// It asks for what lies around the shape.
    pub looks_around: bool,
    /// Its first argument becomes a label.
    pub labels: bool,
    /// Plans do not show what it does.
    pub unseen: bool,
    components: Components,
    apply: Application,
}

/// Arguments, one per parameter, and a shape → what selectors choose among.
type Components = fn(&mut [Option<Value>], &Shape) -> Result<Vec<Component>, Problem>;

/// Arguments, one per parameter, and a shape → pieces; the shape is changed in place.
type Application = fn(&mut [Option<Value>], &mut Shape, &Given) -> Result<Pieces, Problem>;

/// What the engine hands to an operation beside the shape and its arguments.
pub struct Given<'a> {
    /// The sizes of a split block, evaluated on the shape.
    pub cuts: &'a [Cut],
    /// For each component the entry of the block that selected it, and whether its pieces are put together.
    pub chosen: &'a [Option<Choice>],
    /// Where the operation's random numbers come from.
    pub seed: Seed,
    /// The seed of the lot: what its plants have in common.
    pub lot: Seed,
    /// The seed of the run: what all lots have in common.
    pub run: Seed,
    /// The size of the scope that the shape's parent had when the rule began: what `center` centres in.
    pub around: &'a crate::shape::Scope,
    /// Arguments that vary over the shape, by parameter.
    pub fields: &'a [(&'static str, Field)],
    /// The lot's outline on the plan.
    pub outline: &'a Area,
    /// The region's attributes with a value for each edge of that outline.
    pub edge_attributes: &'a [(Arc<str>, Arc<Array>)],
    /// Some rule asks for tags.
    pub tags: bool,
    /// The radii that are reserved in the lot so far.
    pub standing: &'a Standing,
    /// The earlier shapes and the features of the lot.
    pub intra: &'a crate::shape::Occluders,
    /// The initial shapes of the neighbours.
    pub inter: &'a crate::shape::Occluders,
    /// The features around the lot, from which its plants keep away.
    pub beyond: &'a crate::shape::Occluders,
    /// Every kind and layer of the layout and every label of the rules; none where labels are made up on the way.
    pub names: Option<&'a BTreeSet<Arc<str>>>,
    /// Whether a branch of the derivation is one that the shape comes from.
    pub is_ancestor: &'a dyn Fn(NodeId) -> bool,
    /// The element repository.
    pub catalogue: &'a Catalogue,
    /// Where models come from.
    pub world: &'a dyn World,
    /// Coverage maps.
    pub rasters: &'a Rasters<'a>,
    /// The largest number of children an operation may make.
    pub most: usize,
}

/// Which entry of a selector block took a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The entry.
    pub entry: u16,
    /// `=`: all components of the entry in one shape.
    pub together: bool,
}

/// What an operation makes of a shape.
pub enum Pieces {
    /// The current shape goes on, changed.
    Changed,
    /// Nothing is left of the current shape: it is deleted.
    Vanished,
    /// The same, and something is told.
    Told(Effect),
    /// Successors, each for an entry of the block, that use the shape up.
    Parts(Vec<Part>),
    /// The same, beside the shape: points set on a lawn leave the lawn.
    Beside(Vec<Part>),
    /// The same, and something is to be known about them.
    Placed(Vec<Part>, Vec<Remark>),
}

/// What was done, but hardly as meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Remark {
    /// What was found.
    pub message: String,
    /// The argument that it is about.
    pub parameter: Option<&'static str>,
    /// It is worth knowing, and probably meant.
    pub is_note: bool,
}

/// One successor.
pub struct Part {
    /// The entry of the block it goes to.
    pub entry: u16,
    /// Its shape; the engine gives it its seed.
    pub shape: Shape,
}

/// What an operation tells beside the shape.
pub enum Effect {
    /// `report(key, value)`.
    Report(Arc<str>, Value),
    /// `print(value)`.
    Print(Value),
    /// What was done, but hardly as meant.
    Remark(Remark),
    /// `label(name)`: from now on occlusion queries find the shape under this name.
    Label(Arc<str>),
}

/// Why an operation could not be applied.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// What was found and what would do.
    pub message: String,
    /// Advice.
    pub hints: Vec<String>,
    /// The argument that it is about; the whole call where there is none.
    pub parameter: Option<&'static str>,
}

/// What an operation does.
pub trait Apply {
    /// It asks for what lies around the shape, so the engine must keep it.
    const LOOKS_AROUND: bool = false;

    /// Its first argument becomes a label, so that rules may name it elsewhere.
    const LABELS: bool = false;

    /// Plans do not show what it does.
    const UNSEEN: bool = false;

    /// What the selectors of the block choose among; nothing for operations without selectors.
    fn components(&self, _shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(Vec::new())
    }

    /// Changes the shape or gives its pieces; pieces leave the shape as it was.
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem>;
}

/// Arguments → typed operation; written by the declaration.
pub trait Decode: Sized {
    /// Takes the values out of the slots, in the order of the parameters.
    fn decode(values: &mut [Option<Value>]) -> Result<Self, Problem>;
}

impl Given<'_> {
    /// An argument as it varies over the shape, or as the number it is.
    pub fn field(&self, parameter: &'static str, value: f64) -> Field {
        let found = self.fields.iter().find(|(name, _)| *name == parameter);
        found.map_or(Field::Constant(value), |(_, field)| field.clone())
    }
}

impl Pieces {
    /// The shape goes on where something is left of it.
    fn left_of(shape: &Shape) -> Pieces {
        if shape.geometry == Geometry::Empty { Pieces::Vanished } else { Pieces::Changed }
    }
}

impl Operation {
    const fn of<T: Apply + Decode>(spec: &'static Spec) -> Operation {
        Operation {
            spec,
            looks_around: T::LOOKS_AROUND,
            labels: T::LABELS,
            unseen: T::UNSEEN,
            components: |values, shape| T::decode(values)?.components(shape),
            apply: |values, shape, given| T::decode(values)?.apply(shape, given),
        }
    }

    /// The components for the selectors; the values are used up.
    pub fn components(&self, values: &mut [Option<Value>], shape: &Shape) -> Result<Vec<Component>, Problem> {
        (self.components)(values, shape)
    }

    /// Changes the shape or gives its pieces; the values are used up.
    pub fn apply(&self, values: &mut [Option<Value>], shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        (self.apply)(values, shape, given)
    }
}

impl Problem {
    /// A problem of one branch.
    pub fn new(message: impl Into<String>) -> Problem {
        Problem { message: message.into(), hints: Vec::new(), parameter: None }
    }

    /// An argument that must be given is not.
    pub fn missing(parameter: &str) -> Problem {
        Problem::new(format!("the argument `{parameter}` is missing"))
    }

    /// The same with one more piece of advice.
    pub fn hint(mut self, hint: impl Into<String>) -> Problem {
        self.hints.push(hint.into());
        self
    }
}

/// The operation of that name or alias.
pub fn find(name: &str) -> Option<&'static Operation> {
    OPERATIONS.iter().find(|o| o.spec.name == name || o.spec.aliases.contains(&name))
}

/// A value as the type of its parameter.
pub fn decode_value<T: Parameter>(parameter: &'static str, value: Value) -> Result<T, Problem> {
    T::from_value(&value).ok_or_else(|| {
        let (wanted, found) = (T::KIND.words(), value.type_name());
        let message = format!("`{parameter}` takes {wanted}, found {found} `{value}`");
        Problem { parameter: Some(parameter), ..Problem::new(message) }
    })
}
