//! What lies at a place of a scene, from top to bottom, and what has an id.

use crate::geometry::nearest_on_segment;
use crate::scene::{Cover, Line, Object, Origin, Plant, Scene, Solid};
use glam::DVec2;

/// So near to a line (metres) it is meant.
const NEAR: f64 = 0.5;

/// A thing of a scene.
#[derive(Clone, Copy, Debug)]
pub enum Thing<'a> {
    /// A plant, with all that its crown covers.
    Plant(&'a Plant),
    /// Furniture.
    Object(&'a Object),
    /// A thing with height.
    Solid(&'a Solid),
    /// A line.
    Line(&'a Line),
    /// A ground surface.
    Cover(&'a Cover),
}

impl<'a> Thing<'a> {
    /// Where it comes from.
    pub fn origin(self) -> &'a Origin {
        match self {
            Thing::Plant(plant) => &plant.origin,
            Thing::Object(object) => &object.origin,
            Thing::Solid(solid) => &solid.origin,
            Thing::Line(line) => &line.origin,
            Thing::Cover(cover) => &cover.origin,
        }
    }

    /// The word for it: `plant`, `object`, `solid`, `line`, `ground`.
    pub fn class(self) -> &'static str {
        match self {
            Thing::Plant(_) => "plant",
            Thing::Object(_) => "object",
            Thing::Solid(_) => "solid",
            Thing::Line(_) => "line",
            Thing::Cover(_) => "ground",
        }
    }

    /// The height of its top above the datum, metres.
    pub fn top(self) -> f64 {
        match self {
            Thing::Plant(plant) => plant.elevation + plant.height,
            Thing::Object(object) => object.base + object.size[1],
            Thing::Solid(solid) => solid.base + solid.height,
            Thing::Line(line) => line.elevation,
            Thing::Cover(cover) => cover.elevation,
        }
    }

    /// Whether it lies over or under a place of the plan.
    fn covers(self, place: DVec2) -> bool {
        match self {
            Thing::Plant(plant) => plant.position.distance(place) <= plant.crown_radius,
            Thing::Object(object) => object.footprint.contains(place),
            Thing::Solid(solid) => solid.footprint.contains(place),
            Thing::Line(line) => {
                line.points.windows(2).any(|w| nearest_on_segment(place, w[0], w[1]).distance(place) <= NEAR)
            }
            Thing::Cover(cover) => cover.area.contains(place),
        }
    }
}

/// Everything at a place in plan metres, from top to bottom; of grounds as high as each other the one that was laid
/// last comes first. Cost: linear in the scene.
pub fn at<'a>(scene: &'a Scene, place: DVec2) -> Vec<Thing<'a>> {
    let mut found: Vec<Thing<'a>> = all(scene).filter(|thing| thing.covers(place)).collect();
    found.reverse();
    found.sort_by(|a, b| b.top().total_cmp(&a.top()));
    found
}

/// Everything whose id is `id`, or begins with it where nothing has it whole.
pub fn by_id<'a>(scene: &'a Scene, id: &str) -> Vec<Thing<'a>> {
    let whole: Vec<Thing<'a>> = all(scene).filter(|thing| &*thing.origin().id == id).collect();
    let begun = || all(scene).filter(|thing| thing.origin().id.starts_with(id)).collect();
    if whole.is_empty() && !id.is_empty() { begun() } else { whole }
}

/// Everything, the ground first.
fn all(scene: &Scene) -> impl Iterator<Item = Thing<'_>> {
    let covers = scene.covers.iter().map(Thing::Cover);
    let lines = scene.lines.iter().map(Thing::Line);
    let solids = scene.solids.iter().map(Thing::Solid);
    let objects = scene.objects.iter().map(Thing::Object);
    covers.chain(lines).chain(solids).chain(objects).chain(scene.plants.iter().map(Thing::Plant))
}
