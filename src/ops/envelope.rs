//! What plants keep clear of: buildings with their doors and windows, paving, water, and what a rule names.
//!
//! Niese et al. 2022, §4 (6 m from walls, 1.5 m from drives) and §5.2 (further in front of doors and windows).

use crate::geometry::Bounds;
use crate::layout::Kind;
use crate::ops::{Given, Problem};
use crate::placement::Body;
use crate::shape::{Envelope, Extent, Occluder};
use std::borrow::Cow;

/// Kinds of features that count as paving.
const PAVING: &[&str] = &["driveway", "footway", "street", "kerb", "curb"];
/// Kinds of markers in front of which nothing stands.
const OPENINGS: &[&str] = &["door", "window", "entrance", "garage"];

/// Nothing stands on what is kept clear of, even where the distance is 0 (metres).
const LEAST: f64 = 1e-6;

/// What a rule wants to be kept clear of: `"pond kind:building layer:pipes"`.
#[derive(Debug, Default)]
pub struct Avoided<'a> {
    names: Vec<(Option<&'a str>, Cow<'a, str>)>,
}

impl<'a> Avoided<'a> {
    /// Names between blanks, commas or semicolons, each perhaps with `kind:`, `label:` or `layer:` before it.
    pub fn parse(parameter: &'static str, text: &'a str) -> Result<Avoided<'a>, Problem> {
        let mut names = Vec::new();
        for word in text.split([' ', ',', ';']).filter(|word| !word.is_empty()) {
            match word.split_once(':') {
                None => names.push((None, word.into())),
                Some(("kind", name)) => names.push((Some("kind"), kind(name))),
                Some((what @ ("label" | "layer"), name)) => names.push((Some(what), name.into())),
                Some((what, _)) => {
                    let message = format!("`{parameter}` knows `kind:`, `label:` and `layer:`, not `{what}:`");
                    return Err(Problem { parameter: Some(parameter), ..Problem::new(message) });
                }
            }
        }
        Ok(Avoided { names })
    }

    /// Whether it is one of those.
    pub fn names(&self, occluder: &Occluder) -> bool {
        let (label, layer) = (occluder.label.as_deref(), occluder.layer.as_deref());
        self.names.iter().any(|(what, name)| match what {
            None => label == Some(name) || layer == Some(name) || label == Some(&kind(name)),
            Some("kind") => occluder.node.is_none() && label == Some(name),
            Some("label") => occluder.node.is_some() && label == Some(name),
            _ => layer == Some(name),
        })
    }

    /// The first name that nothing has: no kind, no layer of the layout, no label of the rules.
    pub fn unheard(&self, given: &Given) -> Option<&str> {
        let names = given.names?;
        let is_heard = |name: &str| Kind::known(name).is_some() || names.contains(name);
        self.names.iter().map(|(_, name)| &**name).find(|name| !is_heard(name))
    }
}

/// The word of a kind that has other names: `drive` is a `driveway`.
pub fn kind(name: &str) -> Cow<'_, str> {
    match Kind::known(name) {
        Some(known) => Cow::Owned(known.word().into()),
        None => Cow::Borrowed(name),
    }
}

/// Everything near a place that plants keep clear of, each with its distance in metres.
pub fn bodies(near: Bounds, envelope: &Envelope, avoided: &Avoided, margin: f64, given: &Given) -> Vec<(Body, f64)> {
    let widest = [envelope.walls.max(0.0) + envelope.openings, envelope.paving, envelope.water, margin];
    let reach = near.grown(widest.into_iter().fold(0.0, f64::max));
    let found = around(reach, given);
    let kept = found.filter_map(|occluder| {
        let own = usual(occluder, envelope);
        let named = avoided.names(occluder).then_some(margin);
        let distance = own.into_iter().chain(named).reduce(f64::max)?.max(LEAST);
        Some((body(&occluder.footprint.extent)?, distance))
    });
    kept.collect()
}

/// What lies in a lot and around it, without what the shape comes from.
pub fn around<'g>(near: Bounds, given: &'g Given) -> impl Iterator<Item = &'g Occluder> {
    let sets = [given.intra, given.inter, given.beyond].into_iter();
    sets.flat_map(move |set| set.near(near)).filter(|occluder| !occluder.node.is_some_and(given.is_ancestor))
}

/// The distance that the envelope asks for; none where it looks away.
fn usual(occluder: &Occluder, envelope: &Envelope) -> Option<f64> {
    let label = occluder.label.as_deref()?;
    let distance = match label {
        "building" => envelope.walls,
        "water" | "pool" => envelope.water,
        "tree" => 0.0,
        _ if PAVING.contains(&label) => envelope.paving,
        _ if OPENINGS.contains(&label) && matches!(occluder.footprint.extent, Extent::Area(_)) => envelope.walls,
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
