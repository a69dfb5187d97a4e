//! One element of the catalogue: what it is called, how it looks on a plan, and its types with their real sizes.

use crate::element::words::words;
use crate::element::{Material, PlantSymbol};
use crate::geometry::Polygon;
use glam::DVec2;
use std::sync::Arc;

/// An element: a species of plant, a piece of furniture, an architectural object, a primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Unique in the catalogue: `betula-pendula`.
    pub id: Arc<str>,
    /// What rules usually call it: `birch`. Several entries may share a category.
    pub category: Arc<str>,
    /// What sort of thing it is.
    pub kind: Kind,
    /// The name people read in legends.
    pub label: Arc<str>,
    /// A plant's Latin name; empty for others.
    pub species: Arc<str>,
    /// A plant's common name; empty for others.
    pub common_name: Arc<str>,
    /// Other names it is found by: synonyms, other languages.
    pub names: Vec<Arc<str>>,
    /// The three-letter code on plans.
    pub code: Arc<str>,
    /// How a plan draws a plant of this kind, unless its type says otherwise.
    pub symbol: PlantSymbol,
    /// The outer form of an object.
    pub form: Form,
    /// Fill colour, sRGB and opacity in 0 to 1.
    pub color: [f32; 4],
    /// Outline colour.
    pub line: [f32; 4],
    /// Attributes for renderers, as written.
    pub shader: toml::Table,
    /// Whatever else is known: climate, habit, origin; as written.
    pub metadata: toml::Table,
    /// Growth data, as written: read by the growth of plants alone.
    pub growth: toml::Table,
    /// Its types in the order written, at least one: age classes and forms of plants, models of furniture.
    pub variants: Vec<Variant>,
}

/// A type within a category: `young`, `medium`, `adult`, `cone` …
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// Its name.
    pub name: Arc<str>,
    /// The size of its box in metres: x, y (up), z.
    pub size: [f64; 3],
    /// The figures of a plant; `None` for objects.
    pub plant: Option<PlantFigures>,
    /// How a plan draws it.
    pub symbol: PlantSymbol,
    /// How many appearances there are, at least one.
    pub appearances: u32,
    /// The user's own model, seen from the same folder as the catalogue's path; empty for built-in forms.
    pub model: Arc<str>,
}

/// What is known of a plant of one type. Metres and years.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlantFigures {
    /// Years.
    pub age: f64,
    /// From the foot to the top.
    pub height: f64,
    /// Radius of the crown.
    pub crown_radius: f64,
    /// Radius kept clear of other plants.
    pub spacing_radius: f64,
    /// Diameter of the trunk at breast height; of the stem for low plants.
    pub trunk_diameter: f64,
}

/// A ground cover, or the substance of a solid: a material by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Cover {
    /// What scenes carry; its name is the cover's own.
    pub material: Arc<Material>,
    /// Other names it is found by.
    pub names: Vec<Arc<str>>,
    /// Attributes for renderers, as written.
    pub shader: toml::Table,
    /// Whatever else is known, as written.
    pub metadata: toml::Table,
}

/// What sort of thing an element is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A tree.
    #[default]
    Tree,
    /// A shrub.
    Shrub,
    /// A hedge plant.
    Hedge,
    /// A flower or herb.
    Flower,
    /// Benches, lamps, vases …
    Furniture,
    /// Statues, fountains, gates …
    Architecture,
    /// Cubes, spheres, cylinders …
    Primitive,
}

words!(Kind {
    Tree = "tree",
    Shrub = "shrub",
    Hedge = "hedge",
    Flower = "flower",
    Furniture = "furniture",
    Architecture = "architecture",
    Primitive = "primitive",
});

/// The outer form of an object that has no model of its own; it fills the object's box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// A box.
    #[default]
    Box,
    /// An upright cylinder.
    Cylinder,
    /// An upright cone.
    Cone,
    /// A ball.
    Sphere,
    /// A four-sided pyramid.
    Pyramid,
    /// A flat rectangle.
    Quad,
    /// A flat disk.
    Disk,
}

words!(Form {
    Box = "box",
    Cylinder = "cylinder",
    Cone = "cone",
    Sphere = "sphere",
    Pyramid = "pyramid",
    Quad = "quad",
    Disk = "disk",
});

/// Corners of a round footprint.
const ROUND_SIDES: usize = 24;

impl Entry {
    /// The type of that name, ignoring case and hyphens; the usual one where `name` is empty.
    pub fn variant(&self, name: &str) -> Option<&Variant> {
        if name.is_empty() {
            return Some(self.usual());
        }
        let wanted = crate::element::fold(name);
        self.variants.iter().find(|variant| crate::element::fold(&variant.name) == wanted)
    }

    /// The type meant where a rule names none: `adult`, or else the first.
    pub fn usual(&self) -> &Variant {
        self.variants.iter().find(|variant| &*variant.name == "adult").unwrap_or(&self.variants[0])
    }

    /// The type whose height is nearest to `height` metres: for plants that were measured.
    pub fn nearest_height(&self, height: f64) -> &Variant {
        let off = |variant: &&Variant| (variant.size[1] - height).abs();
        self.variants.iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(&self.variants[0])
    }

    /// Every name it is found by: category, id, species, common name, and the others.
    pub fn all_names(&self) -> impl Iterator<Item = &Arc<str>> {
        [&self.category, &self.id, &self.species, &self.common_name].into_iter().chain(&self.names)
    }
}

impl Kind {
    /// Whether it lives.
    pub fn is_plant(self) -> bool {
        matches!(self, Kind::Tree | Kind::Shrub | Kind::Hedge | Kind::Flower)
    }
}

impl Form {
    /// The outline on the ground of a form of that width (x) and depth, metres, around the origin;
    /// `None` without extent.
    pub fn footprint(self, width: f64, depth: f64) -> Option<Polygon> {
        let half = DVec2::new(width, depth) * 0.5;
        match self {
            Form::Box | Form::Pyramid | Form::Quad => Polygon::rectangle(-half, half),
            _ => Polygon::regular(DVec2::ZERO, 1.0, ROUND_SIDES)
                .and_then(|circle| circle.transformed(&glam::DAffine2::from_scale(half))),
        }
    }
}
