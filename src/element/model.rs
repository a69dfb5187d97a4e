//! The size of a user's own model: the bounds of a `.glb`, `.gltf` or `.obj` file, metres, y up.
//!
//! Only the outermost numbers are read; nothing is drawn here. Broken files give an error, never a panic: indices
//! are looked up, cycles of nodes are cut by a depth limit.

use glam::{DMat4, DQuat, DVec3};
use gltf::json::{self, validation::Checked};

/// Why a model's size could not be had.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// The file's name ends in none of the known ways.
    #[error("a model must be a `.glb`, `.gltf` or `.obj` file")]
    Format,
    /// The file cannot be understood.
    #[error("the model cannot be read: {0}")]
    Broken(String),
    /// There is no vertex in it, or no bounds are given for any.
    #[error("the model has no extent")]
    Empty,
}

/// Nodes deeper than this are a cycle.
const MOST_DEPTH: usize = 64;
/// More nodes than this are not looked at: a few nested instances may unfold to billions.
const MOST_NODES: usize = 100_000;

/// The least and greatest corner of a model, metres, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelBounds {
    /// The least x, y and z.
    pub min: [f64; 3],
    /// The greatest x, y and z.
    pub max: [f64; 3],
}

impl ModelBounds {
    /// The size along x, y (up) and z.
    pub fn size(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.max[axis] - self.min[axis])
    }
}

/// The bounds of the model in a file of that name.
pub fn model_bounds(path: &str, bytes: &[u8]) -> Result<ModelBounds, ModelError> {
    let name = path.to_ascii_lowercase();
    let bounds = match name.rsplit('.').next() {
        Some("glb" | "gltf") => gltf_bounds(bytes)?,
        Some("obj") => obj_bounds(bytes)?,
        _ => return Err(ModelError::Format),
    };
    let size = bounds.max - bounds.min;
    if size.is_finite() && size.min_element() >= 0.0 && size.max_element() > 0.0 {
        Ok(ModelBounds { min: bounds.min.to_array(), max: bounds.max.to_array() })
    } else {
        Err(ModelError::Empty)
    }
}

#[derive(Clone, Copy)]
struct Box3 {
    min: DVec3,
    max: DVec3,
}

impl Box3 {
    const EMPTY: Box3 = Box3 { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    fn add(&mut self, point: DVec3) {
        self.min = self.min.min(point);
        self.max = self.max.max(point);
    }
}

fn gltf_bounds(bytes: &[u8]) -> Result<Box3, ModelError> {
    let file = gltf::Gltf::from_slice_without_validation(bytes).map_err(|e| ModelError::Broken(e.to_string()))?;
    let root = file.document.as_json();
    let scene = root.scene.map_or(0, |scene| scene.value());
    let mut walk = Walk { root, bounds: Box3::EMPTY, nodes: 0 };
    for node in root.scenes.get(scene).map_or(&[][..], |scene| &scene.nodes) {
        walk.node(node.value(), DMat4::IDENTITY, 0);
    }
    Ok(walk.bounds)
}

struct Walk<'a> {
    root: &'a json::Root,
    bounds: Box3,
    nodes: usize,
}

impl Walk<'_> {
    fn node(&mut self, index: usize, above: DMat4, depth: usize) {
        self.nodes += 1;
        let Some(node) = self.root.nodes.get(index) else { return };
        if depth > MOST_DEPTH || self.nodes > MOST_NODES {
            return;
        }
        let place = above * placement(node);
        if let Some(mesh) = node.mesh.and_then(|mesh| self.root.meshes.get(mesh.value())) {
            mesh.primitives.iter().for_each(|primitive| self.primitive(primitive, place));
        }
        for child in node.children.iter().flatten() {
            self.node(child.value(), place, depth + 1);
        }
    }

    fn primitive(&mut self, primitive: &json::mesh::Primitive, place: DMat4) {
        let positions = primitive.attributes.get(&Checked::Valid(json::mesh::Semantic::Positions));
        let accessor = positions.and_then(|index| self.root.accessors.get(index.value()));
        let corner = |value: &Option<json::Value>| value.as_ref().and_then(triple);
        let Some((low, high)) = accessor.and_then(|a| Some((corner(&a.min)?, corner(&a.max)?))) else { return };
        for bits in 0..8 {
            let pick = |axis: usize| if bits >> axis & 1 == 0 { low[axis] } else { high[axis] };
            self.bounds.add(place.transform_point3(DVec3::new(pick(0), pick(1), pick(2))));
        }
    }
}

fn triple(value: &json::Value) -> Option<DVec3> {
    let numbers = value.as_array().filter(|numbers| numbers.len() == 3)?;
    Some(DVec3::new(numbers[0].as_f64()?, numbers[1].as_f64()?, numbers[2].as_f64()?))
}

fn placement(node: &json::Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let scale = node.scale.map_or(DVec3::ONE, |s| DVec3::from_array(s.map(f64::from)));
    let turn = node.rotation.map_or(DQuat::IDENTITY, |r| DQuat::from_array(r.0.map(f64::from)));
    let offset = node.translation.map_or(DVec3::ZERO, |t| DVec3::from_array(t.map(f64::from)));
    DMat4::from_scale_rotation_translation(scale, turn, offset)
}

fn obj_bounds(mut bytes: &[u8]) -> Result<Box3, ModelError> {
    let no_materials = |_: &std::path::Path| Ok((Vec::new(), Default::default()));
    let (models, _) = tobj::load_obj_buf(&mut bytes, &tobj::LoadOptions::default(), no_materials)
        .map_err(|e| ModelError::Broken(e.to_string()))?;
    let mut bounds = Box3::EMPTY;
    for corner in models.iter().flat_map(|model| model.mesh.positions.as_chunks::<3>().0) {
        bounds.add(DVec3::from_array(corner.map(f64::from)));
    }
    Ok(bounds)
}
