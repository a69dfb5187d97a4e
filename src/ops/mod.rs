//! The built-in operations, one file each, and [`OPERATIONS`], the list that nobody repeats.
//!
//! An operation takes a shape and gives pieces; it never calls the engine. Which block entry a piece goes to is
//! decided in two steps for operations with selectors: [`Apply::components`] says what there is to choose from, the
//! engine chooses, [`Apply::apply`] builds. What operations derive inside a rule (`inline`, `union`) the engine derives
//! before it applies them: they find the leaves among what they are [`Given`].

mod declare;
mod prose;
mod spec;
mod unbuilt;

mod align_scope_to_axes;
mod align_scope_to_geometry;
mod along;
mod boundary;
mod center;
mod cleanup_geometry;
mod cluster;
mod color;
mod combine;
mod comp;
mod convexify;
mod coverage;
mod delete_holes;
mod distr;
mod envelope;
mod equidistant;
mod extrude;
mod faces;
mod fit;
mod footprint;
mod gather;
mod ground;
mod inner_rectangle;
mod insert;
mod insert_along_uv;
mod instance;
mod label;
mod mirror;
mod normals;
mod offset;
mod plant;
mod points;
mod primitives;
mod print;
mod projection;
mod r;
mod rectify;
mod regular;
mod report;
mod reset_geometry;
mod rim;
mod roofs;
mod rotate_scope;
mod rows;
mod s;
mod scatter;
mod semirandom;
mod set;
mod setback;
mod setback_per_edge;
mod setback_to_area;
mod shape_luo;
mod single;
mod split;
mod split_and_setback_perimeter;
mod split_area;
mod split_uv;
mod strategy;
mod t;
mod tag;
mod texture;
mod translate;
mod trim;
mod uv;
mod without;

pub use comp::joined;
pub use faces::{Component, RoofEdge, Selectors};
pub use gather::{Gather, count};
pub use ground::Ground;
pub use spec::{AttributeName, BlockKind, Origin, Param, ParamKind, Parameter, Spec, Word};
pub use split::Cut;
pub use unbuilt::{UNBUILT_OPERATIONS, Unbuilt};

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
    split_area::SplitArea::OPERATION,
    comp::Comp::OPERATION,
    setback::Setback::OPERATION,
    setback_per_edge::SetbackPerEdge::OPERATION,
    setback_to_area::SetbackToArea::OPERATION,
    split_and_setback_perimeter::SplitAndSetbackPerimeter::OPERATION,
    inner_rectangle::InnerRectangle::OPERATION,
    inner_rectangle::InnerRect::OPERATION,
    shape_luo::ShapeL::OPERATION,
    shape_luo::ShapeU::OPERATION,
    shape_luo::ShapeO::OPERATION,
    offset::Offset::OPERATION,
    convexify::Convexify::OPERATION,
    delete_holes::DeleteHoles::OPERATION,
    cleanup_geometry::CleanupGeometry::OPERATION,
    rectify::Rectify::OPERATION,
    footprint::Footprint::OPERATION,
    mirror::Mirror::OPERATION,
    mirror::ReverseNormals::OPERATION,
    without::Without::OPERATION,
    combine::Inline::OPERATION,
    combine::Union::OPERATION,
    combine::Subtract::OPERATION,
    combine::Intersect::OPERATION,
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
    roofs::Hip::OPERATION,
    roofs::Gable::OPERATION,
    roofs::Pyramid::OPERATION,
    roofs::Ridge::OPERATION,
    roofs::Shed::OPERATION,
    roofs::Taper::OPERATION,
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
    normals::SetNormals::OPERATION,
    normals::SoftenNormals::OPERATION,
    normals::ReduceGeometry::OPERATION,
    trim::Trim::OPERATION,
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
    sections: Sections,
    apply: Application,
    ready: Decoding,
}

/// An operation whose arguments are known before derivation: decoded once, applied to every shape.
pub trait Ready: Send + Sync {
    /// The components for the selectors.
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem>;

    /// The entry of each section of a perimeter, `most` at most.
    fn sections(&self, shape: &Shape, cuts: &[Cut], most: usize) -> Result<Vec<u16>, Problem>;

    /// Changes the shape or gives its pieces.
    fn apply(&self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem>;
}

struct Decoded<T>(T);

impl<T: Apply + Clone + Send + Sync> Ready for Decoded<T> {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        self.0.components(shape)
    }

    fn sections(&self, shape: &Shape, cuts: &[Cut], most: usize) -> Result<Vec<u16>, Problem> {
        self.0.sections(shape, cuts, most)
    }

    fn apply(&self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        self.0.clone().apply(shape, given)
    }
}

/// Arguments, one per parameter, and a shape → what selectors choose among.
type Components = fn(&mut [Option<Value>], &Shape) -> Result<Vec<Component>, Problem>;

/// Arguments, one per parameter, a shape and the sizes of a block → the entry of each section.
type Sections = fn(&mut [Option<Value>], &Shape, &[Cut], usize) -> Result<Vec<u16>, Problem>;

/// Arguments, one per parameter, and a shape → pieces; the shape is changed in place.
type Application = fn(&mut [Option<Value>], &mut Shape, &Given) -> Result<Pieces, Problem>;

/// Arguments, one per parameter → the operation with them, where they can be taken.
type Decoding = fn(&mut [Option<Value>]) -> Option<Box<dyn Ready>>;

/// What the engine hands to an operation beside the shape and its arguments.
pub struct Given<'a> {
    /// The sizes of a split block, evaluated on the shape.
    pub cuts: &'a [Cut],
    /// The depth of each section of a perimeter, as [`Apply::sections`] counts them.
    pub depths: &'a [f64],
    /// For each component the entry of the block that selected it, and whether its pieces are put together.
    pub chosen: &'a [Option<Choice>],
    /// What was derived of each part of a block of operands: what can become part of a shape.
    pub operands: &'a [Vec<Shape>],
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
    /// What becomes of the entry's components.
    pub gather: Gather,
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
    /// The same, and something is to be known about them.
    Noted(Vec<Part>, Vec<Remark>),
    /// The same, beside the shape: points set on a lawn leave the lawn.
    Beside(Vec<Part>),
    /// The same with places that plants keep for themselves, and something is to be known about them.
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
    /// Its shape, in the box that it stays in; the engine gives it its seed.
    pub shape: Box<Shape>,
}

impl Part {
    /// A successor for an entry of the block.
    pub fn new(entry: u16, shape: Shape) -> Part {
        Part { entry, shape: Box::new(shape) }
    }
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

    /// The entry of every section that a perimeter is split into, so that their depths can be evaluated.
    fn sections(&self, _shape: &Shape, _cuts: &[Cut], _most: usize) -> Result<Vec<u16>, Problem> {
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
    const fn of<T: Apply + Decode + Clone + Send + Sync + 'static>(spec: &'static Spec) -> Operation {
        Operation {
            spec,
            looks_around: T::LOOKS_AROUND,
            labels: T::LABELS,
            unseen: T::UNSEEN,
            components: |values, shape| T::decode(values)?.components(shape),
            sections: |values, shape, cuts, most| T::decode(values)?.sections(shape, cuts, most),
            apply: |values, shape, given| T::decode(values)?.apply(shape, given),
            ready: |values| T::decode(values).ok().map(|decoded| Box::new(Decoded(decoded)) as Box<dyn Ready>),
        }
    }

    /// The operation with its arguments, where they are known and can be taken; the values are used up.
    pub fn ready(&self, values: &mut [Option<Value>]) -> Option<Box<dyn Ready>> {
        (self.ready)(values)
    }

    /// The components for the selectors; the values are used up.
    pub fn components(&self, values: &mut [Option<Value>], shape: &Shape) -> Result<Vec<Component>, Problem> {
        (self.components)(values, shape)
    }

    /// The entry of each section of a perimeter, `most` at most; the values are used up.
    pub fn sections(
        &self,
        values: &mut [Option<Value>],
        shape: &Shape,
        cuts: &[Cut],
        most: usize,
    ) -> Result<Vec<u16>, Problem> {
        (self.sections)(values, shape, cuts, most)
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
