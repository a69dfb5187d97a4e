//! `roofHip` and `roofGable`: a plane over every edge, cut with the others along the straight skeleton.
//!
//! A gable is an edge that stands still while the others move inwards: its face stays upright. An overhang widens the
//! outline and lowers the eaves, so that the planes stay where they are.

use crate::geometry::{Mesh, Polygon, StraightSkeleton, Unskeletal};
use crate::ops::declare::operation;
use crate::ops::roofs::{By, Steepness, cover, solid};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::unit::Metres;
use glam::{DVec2, DVec3};

operation! {
    /// A hip roof: every edge has its plane, all equally steep.
    ///
    /// It goes on flat shapes, also with holes, and on the tops of prisms. The result is closed, with one face for
    /// each edge above its bottom; the scope's y stands on the eaves. `even` levels the ridges at their mean height,
    /// which breaks faces into triangles.
    /// ```cga
    /// Lot   --> shapeL(14, 12) { shape : Wing | remainder : Lawn }
    /// Wing --> set(material.name, "roof") extrude(4) roofHip(35, 0.6) House.
    /// ```
    "roofHip" (CityEngine, None) => pub struct Hip {
        /// What the value says.
        kind: By = By::Angle => "byAngle",
        /// The slope (degrees), or with `byHeight` the height of the ridge (metres).
        value: f64,
        /// How far the planes reach beyond the edges, along the slope (metres).
        overhang: Metres = Metres(0.0) => "0",
        /// Whether the ridges are made level.
        even: bool = false => "false",
    }
}

operation! {
    /// A gable roof: planes over the long edges, upright gables over the ends.
    ///
    /// Ends are the edges over which a hip roof has a triangle between two planes that face away from each other;
    /// where there is no such end, the roof is hipped. An `index` makes that edge and the one across it the gables
    /// of a convex outline.
    /// ```cga
    /// Lot   --> shapeL(14, 12) { shape : Wing | remainder : Lawn }
    /// Wing --> set(material.name, "roof") extrude(4) roofGable(40, 0.5) House.
    /// ```
    "roofGable" (CityEngine, None) => pub struct Gable {
        /// What the value says.
        kind: By = By::Angle => "byAngle",
        /// The slope (degrees), or with `byHeight` the height of the ridge (metres).
        value: f64,
        /// How far the planes reach beyond the eaves, along the slope (metres).
        overhang_x: Metres = Metres(0.0) => "0",
        /// How far they reach beyond the gables, along the ridge (metres); as far as beyond the eaves where it is not given.
        overhang_y: Option<Metres> = None => "overhang_x",
        /// Whether the ridges are made level.
        even: bool = false => "false",
        /// The edge that has the gable, from 0; found where it is not given.
        index: Option<f64> = None => "found",
    }
}

impl Apply for Hip {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(steepness) = Steepness::of(self.kind, self.value)? else { return Ok(Pieces::Changed) };
        let overhang = reach("overhang", self.overhang)?;
        let wish = Wish { steepness, beyond: [overhang; 2], even: self.even };
        cover(shape, "roofHip", |part, walls| wish.build(part, &[], walls))
    }
}

impl Apply for Gable {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(steepness) = Steepness::of(self.kind, self.value)? else { return Ok(Pieces::Changed) };
        let eaves = reach("overhang_x", self.overhang_x)?;
        let gables = self.overhang_y.map_or(Ok(eaves), |given| reach("overhang_y", given))?;
        let wish = Wish { steepness, beyond: [eaves, gables], even: self.even };
        cover(shape, "roofGable", |part, walls| {
            let ends = match self.index {
                Some(index) => across(part, index),
                None => ends(part, &StraightSkeleton::of(part, &[]).map_err(refused)?),
            };
            wish.build(part, &ends, walls).or_else(|_| wish.build(part, &[], walls))
        })
    }
}

fn reach(name: &'static str, distance: Metres) -> Result<f64, Problem> {
    match distance.0 {
        d if d.is_finite() && d >= 0.0 => Ok(d),
        d => Err(Problem { parameter: Some(name), ..Problem::new(format!("an overhang of {d} m cannot be built")) }),
    }
}

/// What is wanted of a roof over edges.
struct Wish {
    steepness: Steepness,
    /// Overhang of the eaves along the slope, and of the gables along the ridge.
    beyond: [f64; 2],
    even: bool,
}

impl Wish {
    fn build(&self, part: &Polygon, gables: &[usize], walls: f64) -> Result<Mesh, Problem> {
        let edges = part.points().len();
        let speeds: Vec<f64> = (0..edges).map(|edge| f64::from(u8::from(!gables.contains(&edge)))).collect();
        let skeleton = StraightSkeleton::of(part, &speeds).map_err(refused)?;
        let slope = self.steepness.slope(self.run(&skeleton, edges));
        if self.beyond.iter().all(|beyond| *beyond == 0.0) {
            return Ok(self.raised(part, skeleton, slope, 0.0, walls));
        }
        // The overhang is measured on the slope: its shadow is shorter, and its eaves lie lower.
        let length = libm::sqrt(1.0 + slope * slope);
        let (out, drop) = (self.beyond[0] / length, self.beyond[0] * slope / length);
        let outs: Vec<f64> = speeds.iter().map(|speed| if *speed > 0.0 { out } else { self.beyond[1] }).collect();
        let wide = widened(part, &outs).ok_or_else(|| {
            Problem::new(format!("an overhang of {} m closes the corners of the outline", self.beyond[0]))
        })?;
        let skeleton = StraightSkeleton::of(&wide, &speeds).map_err(refused)?;
        // The walls end at the eaves, on which the roof lies.
        let mut mesh = match walls > drop {
            true => Mesh::prism(&part.clone().into(), 0.0, walls - drop, |p, height| DVec3::new(p.x, height, -p.y)),
            false => Mesh::default(),
        };
        let mut roof = self.raised(&wide, skeleton, slope, drop, 0.0);
        roof.positions.iter_mut().for_each(|p| p.y += walls);
        mesh.append(&roof);
        Ok(mesh)
    }

    /// How far planes run inwards up to the ridges, or where those are made level to their mean.
    fn run(&self, skeleton: &StraightSkeleton, corners: usize) -> f64 {
        if self.even { mean(&skeleton.nodes[corners..]) } else { skeleton.latest() }
    }

    /// The faces of a skeleton at their heights, on a flat bottom.
    fn raised(&self, part: &Polygon, skeleton: StraightSkeleton, slope: f64, drop: f64, walls: f64) -> Mesh {
        let StraightSkeleton { mut nodes, faces } = skeleton;
        let corners = part.points().len();
        let mean = mean(&nodes[corners..]);
        let uneven = self.even && nodes[corners..].iter().any(|node| (node.z - mean).abs() > 1e-6);
        if uneven {
            nodes[corners..].iter_mut().for_each(|node| node.z = mean);
        }
        nodes.iter_mut().for_each(|node| node.z = node.z * slope - drop);
        let mesh = solid(part, &nodes, &faces, walls);
        if uneven { mesh.triangulated() } else { mesh }
    }
}

/// The mean time at which planes meet.
fn mean(inner: &[DVec3]) -> f64 {
    inner.iter().map(|node| node.z).sum::<f64>() / inner.len().max(1) as f64
}

fn refused(why: Unskeletal) -> Problem {
    match why {
        Unskeletal::TooLarge => Problem::new("the outline has too many corners for a roof over each edge")
            .hint("`roofShed` and `roofRidge` roof outlines of any size"),
        Unskeletal::Contradiction => Problem::new("the planes over the edges do not meet in a roof")
            .hint("`roofShed` and `roofRidge` roof any outline"),
    }
}

/// The ends of the outline that gables stand on: triangles of a hip roof whose neighbours face away from each other,
/// no two side by side.
fn ends(part: &Polygon, hips: &StraightSkeleton) -> Vec<usize> {
    let edges: Vec<DVec2> = part.edges().map(|(a, b)| (b - a).normalize_or_zero()).collect();
    let mut ends: Vec<usize> = Vec::new();
    let mut first = 0;
    for ring in part.rings() {
        let count = ring.len();
        for i in 0..count {
            let (before, edge, after) = (first + (i + count - 1) % count, first + i, first + (i + 1) % count);
            let opposed = edges[before].dot(edges[after]) < -0.7;
            let free = !ends.contains(&before) && !ends.contains(&after);
            if hips.faces[edge].len() == 3 && opposed && free {
                ends.push(edge);
            }
        }
        first += count;
    }
    ends
}

/// An edge of a convex outline and the one that faces away from it most.
fn across(part: &Polygon, index: f64) -> Vec<usize> {
    let edges: Vec<DVec2> = part.edges().map(|(a, b)| (b - a).normalize_or_zero()).collect();
    if !part.is_convex() || !index.is_finite() {
        return Vec::new();
    }
    let edge = index.round().rem_euclid(edges.len() as f64) as usize;
    let faces = |other: &usize| edges[edge].dot(edges[*other]);
    let opposite = (0..edges.len()).min_by(|a, b| faces(a).total_cmp(&faces(b)));
    opposite.into_iter().filter(|other| *other != edge).chain([edge]).collect()
}

/// The outline with every edge moved outwards by its own distance; `None` where an edge would turn round.
fn widened(part: &Polygon, outs: &[f64]) -> Option<Polygon> {
    let mut rings: Vec<Vec<DVec2>> = Vec::new();
    let mut first = 0;
    for ring in part.rings() {
        let count = ring.len();
        let along = |i: usize| (ring[(i + 1) % count] - ring[i % count]).normalize_or_zero();
        let corner = |i: usize| {
            let before = (i + count - 1) % count;
            ring[i] + corner_shift([along(before), along(i)], [outs[first + before], outs[first + i]])
        };
        let moved: Vec<DVec2> = (0..count).map(corner).collect();
        if (0..count).any(|i| (moved[(i + 1) % count] - moved[i]).dot(along(i)) <= 0.0) {
            return None;
        }
        rings.push(moved);
        first += count;
    }
    Polygon::new(&rings[0], &rings[1..]).filter(|wide| wide.points().len() == part.points().len())
}

/// How a corner moves when the two edges at it move outwards, to their right.
fn corner_shift([before, after]: [DVec2; 2], [out_before, out_after]: [f64; 2]) -> DVec2 {
    let turn = before.perp_dot(after);
    if turn.abs() < 1e-9 { -before.perp() * out_before } else { (before * out_after - after * out_before) / turn }
}
