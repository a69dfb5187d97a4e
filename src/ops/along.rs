//! `along`: places at even spacing along edges, lines and streets.

use crate::ops::envelope::{self, Avoided};
use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::{not_negative, strategy};
use crate::ops::{Apply, Given, Pieces, Problem, Remark, Word};
use crate::placement::{self, Along, Line};
use crate::shape::{Extent, Shape};
use crate::unit::{Degrees, Metres};

strategy! {
    /// Sets points evenly spaced along the edges of a shape, along a line shape, or beside what the lot has under a
    /// label, such as a street.
    ///
    /// The points of each run between two corners are equally far apart. x runs along the line, and `place.cluster`
    /// says which run. `comp(e) { front : along(8) { Tree } }` takes one edge of a lot.
    /// ```cga
    /// Square --> [ along(spacing = 6, inset = 3.5, corner = 3.5) { plant("plane") } ] setback(7) { all = Gravel | remainder : Lawn }
    /// ```
    "along" => pub struct AlongLines {
        /// From point to point along the line, metres.
        spacing: Varying<Metres>,
        /// How far from the line, metres: inwards from the edges of a shape, to the left of a line shape.
        inset: Metres = Metres(0.0) => "0",
        /// How far from corners and ends nothing stands, metres along the line.
        corner: Metres = Metres(0.0) => "0",
        /// What to follow instead of the shape's own edges, named as in `avoid`: outside of areas, on both sides of lines,
        /// within the shape.
        on: Option<Word> = None => "edges",
        /// Whether the spacing is stretched until points stand at both ends of a run; else the rests are equal.
        stretch: bool = true => "true",
        /// A bend of more than this is a corner.
        bend: Degrees = Degrees(30.0) => "30",
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Option<Varying<Metres>> [1.0, 10.0] = None => "spacing / 2",
    }
}

impl Apply for AlongLines {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let shared = self.shared();
        let (ground, own) = match Ground::of_path(shape, given.outline) {
            Some(found) => found,
            None => Ground::of(shape).map(|ground| (ground.rims(), ground)).map(|(rims, ground)| (ground, rims))?,
        };
        let spacing = given.field("spacing", self.spacing.0.0);
        let lines = match &self.on {
            Some(names) => beside(&Avoided::parse("on", &names.0)?, self.inset.0, &ground, given),
            None => own,
        };
        let followed = self.on.is_some().then_some(lines.is_empty());
        let radii = shared.radii_or(given, self.radius, &spacing)?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let options = Along {
            spacing,
            inset: self.inset.0,
            corner: not_negative("corner", self.corner.0)?,
            turn: self.bend.0,
            adjust: self.stretch,
        };
        let placed = placement::along(&site, &lines, &options, &radii, &shared.amount(given)?, given.seed);
        let pieces = shared.pieces(&ground, shape, given, &radii, placed)?;
        Ok(match (followed, pieces) {
            (Some(true), Pieces::Placed(parts, mut remarks)) => {
                let message = "nothing of that name is near, so nothing is followed".into();
                remarks.push(Remark { message, parameter: Some("on"), is_note: false });
                Pieces::Placed(parts, remarks)
            }
            (_, pieces) => pieces,
        })
    }
}

/// What has one of the names near the ground, as lines whose left is the side to plant on.
fn beside(names: &Avoided, inset: f64, ground: &Ground, given: &Given) -> Vec<Line> {
    let reach = ground.area.bounds().grown(inset.abs());
    let named = envelope::around(reach, given).filter(|occluder| names.names(occluder));
    named.flat_map(|occluder| sides(&occluder.footprint.extent, inset)).collect()
}

fn sides(extent: &Extent, inset: f64) -> Vec<Line> {
    let reversed = |points: &[glam::DVec2]| points.iter().rev().copied().collect();
    match extent {
        Extent::Nothing | Extent::Point(_) => Vec::new(),
        Extent::Line(points) if inset == 0.0 => vec![Line { points: points.clone(), closed: false }],
        Extent::Line(points) => {
            vec![Line { points: points.clone(), closed: false }, Line { points: reversed(points), closed: false }]
        }
        Extent::Area(area) => {
            let rings = area.polygons().iter().flat_map(|polygon| polygon.rings());
            rings.map(|ring| Line { points: reversed(ring), closed: true }).collect()
        }
    }
}
