//! A shape: scope, geometry, what it inherits, and its seed.

use crate::seed::Seed;
use crate::shape::{Geometry, Scope, Streets, Surface};
use crate::value::Value;
use glam::DQuat;
use std::sync::Arc;

/// A shape of a derivation; its symbol and rule are the node's that holds it.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Where it is, how it is turned, how large.
    pub scope: Scope,
    /// What it is made of.
    pub geometry: Geometry,
    /// The attributes of its rule file and imports, by slot; shared until one is set.
    pub attributes: Arc<[Value]>,
    /// What it looks like.
    pub style: Arc<Style>,
    /// Its place among its siblings.
    pub ordinals: Ordinals,
    /// Where its random numbers come from.
    pub seed: Seed,
}

/// What a shape inherits beside its attributes, mostly looks: shared until changed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Style {
    /// `color()`: red, green, blue, opacity in 0 to 1.
    pub color: Option<[f32; 4]>,
    /// `set(material.name, "gravel")`: a ground cover of the catalogue, or the user's own word.
    pub material: Option<Arc<str>>,
    /// The last `label()`.
    pub label: Option<Arc<str>>,
    /// `comp.sel`: the selector that took the component; only where a rule asks for it.
    pub selector: Option<Arc<str>>,
    /// How the initial shape was turned: what `object.front` means.
    pub object: DQuat,
    /// The streets around the lot: what `street.front` means; the sides of the initial shape where none are known.
    pub streets: Option<Arc<Streets>>,
    /// What plants keep clear of.
    pub envelope: Envelope,
    /// Texture coordinates, textures and tags; none for most shapes.
    pub surface: Option<Arc<Surface>>,
}

/// How far plants keep away from what stands (Niese et al. 2022, §4, §5.2), metres. A negative distance looks away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Envelope {
    /// `envelope.walls`: from buildings.
    pub walls: f64,
    /// `envelope.paving`: from drives, kerbs, footways and streets.
    pub paving: f64,
    /// `envelope.openings`: in front of doors and windows, beyond the distance from walls.
    pub openings: f64,
    /// `envelope.water`: from water.
    pub water: f64,
    /// `envelope.seams`: disks stay inside their own lot.
    pub seams: bool,
}

impl Default for Envelope {
    fn default() -> Envelope {
        Envelope { walls: 6.0, paving: 1.5, openings: 3.0, water: 0.0, seams: false }
    }
}

/// The last index and total that a split and a component split gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ordinals {
    /// `split.index`, `split.total`.
    pub split: (u32, u32),
    /// `comp.index`, `comp.total`.
    pub comp: (u32, u32),
    /// The last placement.
    pub place: Place,
}

/// What a placement gave a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// `place.index`.
    pub index: u32,
    /// `place.total`.
    pub total: u32,
    /// `place.radius`: the radius that is reserved, metres; 0 where none is.
    pub radius: f64,
    /// `place.cluster`: which cluster, row, branch or edge.
    pub cluster: u32,
    /// The number of its disk among those that stand in the lot.
    pub disk: Option<u32>,
}
