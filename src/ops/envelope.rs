//! What plants keep clear of: buildings with their doors and windows, paving, water, and what a rule names.
//!
//! Niese et al. 2022, §4 (6 m from walls, 1.5 m from drives) and §5.2 (further in front of doors and windows).

use crate::geometry::Bounds;
use crate::ops::{Given, Problem};
use crate::placement::Body;
use crate::shape::{Envelope, Extent, Occluder};

/// Kinds of features that count as paving.
const PAVING: &[&str] = &["driveway", "footway", "street", "kerb", "curb"];
/// Kinds of markers in front of which nothing stands.
const OPENINGS: &[&str] = &["door", "window", "entrance", "garage"];

/// Nothing stands on what is kept clear of, even where the distance is 0 (metres).
const LEAST: f64 = 1e-6;

/// What a rule wants to be kept clear of: `"pond kind:building layer:pipes"`.
#[derive(Debug, Default)]
pub struct Avoided<'a> {
    names: Vec<(Option<&'a str>, &'a str)>,
}

impl<'a> Avoided<'a> {
    /// Names between blanks, commas or semicolons, each perhaps with `kind:`, `label:` or `layer:` before it.
    pub fn parse(text: &'a str) -> Result<Avoided<'a>, Problem> {
        let mut names = Vec::new();
        for word in text.split([' ', ',', ';']).filter(|word| !word.is_empty()) {
            match word.split_once(':') {
                None => names.push((None, word)),
                Some((what @ ("kind" | "label" | "layer"), name)) => names.push((Some(what), name)),
                Some((what, _)) => {
                    let message = format!("`avoid` knows `kind:`, `label:` and `layer:`, not `{what}:`");
                    return Err(Problem { parameter: Some("avoid"), ..Problem::new(message) });
                }
            }
        }
        Ok(Avoided { names })
    }

    fn names(&self, occluder: &Occluder) -> bool {
        let label = occluder.label.as_deref();
        self.names.iter().any(|(what, name)| match what {
            None => label == Some(name) || occluder.layer.as_deref() == Some(name),
            Some("kind") => occluder.node.is_none() && label == Some(name),
            Some("label") => occluder.node.is_some() && label == Some(name),
            _ => occluder.layer.as_deref() == Some(name),
        })
    }
}

/// Everything near a place that plants keep clear of, each with its distance in metres.
pub fn bodies(near: Bounds, envelope: &Envelope, avoided: &Avoided, margin: f64, given: &Given) -> Vec<(Body, f64)> {
    let widest = [envelope.walls.max(0.0) + envelope.openings, envelope.paving, envelope.water, margin];
    let reach = near.grown(widest.into_iter().fold(0.0, f64::max));
    let found = given.intra.near(reach).chain(given.inter.near(reach));
    let kept = found.filter_map(|occluder| {
        let own = usual(occluder, envelope);
        let named = avoided.names(occluder).then_some(margin);
        let distance = own.into_iter().chain(named).reduce(f64::max)?.max(LEAST);
        Some((body(&occluder.footprint.extent)?, distance))
    });
    kept.collect()
}

/// The distance that the envelope asks for; none where it looks away.
fn usual(occluder: &Occluder, envelope: &Envelope) -> Option<f64> {
    let label = occluder.label.as_deref()?;
    let distance = match label {
        "building" => envelope.walls,
        "water" => envelope.water,
        _ if PAVING.contains(&label) => envelope.paving,
        _ if OPENINGS.contains(&label) && envelope.openings >= 0.0 => envelope.walls.max(0.0) + envelope.openings,
        _ => return None,
    };
    (distance >= 0.0).then_some(distance)
}

fn body(extent: &Extent) -> Option<Body> {
    match extent {
        Extent::Nothing => None,
        Extent::Point(point) => Some(Body::Point(*point)),
        Extent::Line(points) => Some(Body::Line(points.clone())),
        Extent::Area(area) => Some(Body::Area(area.clone())),
    }
}
