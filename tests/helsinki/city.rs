//! The centre of Helsinki out of OpenStreetMap: its trees, and the lots in which trees may stand.
//!
//! In: the layers of `shared/data/helsinki_osm`. Out: plan metres. Lots are of two zones, both within the convex hull of
//! the trees: `park` are the green areas, `street` what lies at most [`VERGE`] metres beside a carriageway, each side
//! of a street between two others a lot of its own. Only lots in which trees stand count.

use bosquet::geometry::{Area, Polygon, convex_hull, difference, intersection, stroke, union, union_all};
use bosquet::layout::{Feature, Georeference, Layout, Shapes, read_geojson};
use bosquet::stats::{Segments, Window};
use bosquet::value::Value;
use glam::DVec2;
use serde_json::{Value as Json, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// From the edge of the carriageway to the far side of the ground where street trees stand, metres.
const VERGE: f64 = 5.0;
/// A lot with fewer real trees is left out: that nobody plants there is no matter of how to plant.
const LEAST_TREES: usize = 3;
/// Carriageways without courts and car parks, and how wide they are where nothing says how many lanes they have.
const STREETS: [(&str, f64); 7] = [
    ("primary", 9.0),
    ("secondary", 9.0),
    ("tertiary", 8.0),
    ("residential", 7.0),
    ("unclassified", 7.0),
    ("primary_link", 5.0),
    ("tertiary_link", 5.0),
];
/// Width of a lane, metres.
const LANE: f64 = 3.25;
/// What counts as green.
const GREEN: [(&str, &[&str]); 3] = [
    ("leisure", &["park", "garden", "playground"]),
    ("landuse", &["grass"]),
    ("natural", &["heath", "scrub", "wood", "grassland"]),
];

/// Everything that plantings are made of and compared with.
pub struct City {
    /// The trees that stand there.
    pub trees: Vec<DVec2>,
    /// Where others are planted, with the buildings that the lots see.
    pub layout: Layout,
    /// The buildings, to measure distances.
    pub buildings: Window,
    /// The axes of all carriageways, courts and car parks included, to measure distances.
    pub axes: Segments,
}

impl City {
    /// Reads the layers; `None` where they are not there.
    pub fn read() -> Option<City> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/helsinki_osm/layers");
        let trees = layer(&folder, "trees")?;
        let plan = &trees.georeference;
        let [buildings, streets, green] = ["buildings", "streets", "areas"].map(|name| layer(&folder, name));
        let (buildings, streets, green) = (buildings?, streets?, green?);
        let trees: Vec<DVec2> = trees.features.iter().flat_map(points).collect();
        let houses = areas(&buildings, plan, |_| true);
        let lots = lots(&trees, &streets, &areas(&green, plan, is_green), plan)?;
        let axes = lines(&streets, plan).filter(|(f, _)| width(f).is_some() || word(f, "highway") == "service");
        let pairs = axes.flat_map(|(_, line)| line.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>());
        Some(City {
            axes: Segments::new(pairs.collect()),
            layout: layout(&lots, &houses),
            buildings: Window::new(&houses)?,
            trees,
        })
    }
}

fn layer(folder: &Path, name: &str) -> Option<Layout> {
    let path: PathBuf = folder.join(name).with_extension("geojson");
    Some(read_geojson(name, &std::fs::read(path).ok()?).0)
}

fn points(feature: &Feature) -> Vec<DVec2> {
    if let Shapes::Points(points) = &feature.shapes { points.clone() } else { Vec::new() }
}

/// The polygons of a layer, which without a kind are taken for lots, in the plan of another.
fn areas(layer: &Layout, plan: &Georeference, wanted: impl Fn(&dyn Fn(&str) -> String) -> bool) -> Vec<Area> {
    let is_wanted = |r: &&bosquet::layout::Region| wanted(&|key| text(r.attributes.get(key)));
    let moved = |p: &Polygon| p.mapped(|p| plan.to_plan(layer.georeference.to_world(p))).into();
    layer.regions.iter().filter(is_wanted).map(|r| moved(&r.polygon)).collect()
}

fn lines<'a>(layer: &'a Layout, plan: &'a Georeference) -> impl Iterator<Item = (&'a Feature, Vec<DVec2>)> {
    let moved = |line: &Vec<DVec2>| line.iter().map(|p| plan.to_plan(layer.georeference.to_world(*p))).collect();
    layer.features.iter().filter_map(move |feature| match &feature.shapes {
        Shapes::Lines(lines, _) => Some((feature, moved(lines.first()?))),
        _ => None,
    })
}

fn word(feature: &Feature, key: &str) -> String {
    text(feature.attributes.get(key))
}

fn text(value: Option<&Value>) -> String {
    value.map(Value::to_string).unwrap_or_default()
}

fn is_green(word: &dyn Fn(&str) -> String) -> bool {
    GREEN.iter().any(|(key, words)| words.contains(&word(key).as_str()))
}

/// Width of a carriageway, metres; none for what is no street.
fn width(feature: &Feature) -> Option<f64> {
    let class = word(feature, "highway");
    let (_, usual) = STREETS.iter().find(|(name, _)| *name == class)?;
    let lanes = word(feature, "lanes").parse::<f64>().ok().filter(|lanes| *lanes >= 1.0);
    Some(lanes.map_or(*usual, |lanes| lanes * LANE))
}

/// The lots that are planted, with their zones.
fn lots(
    trees: &[DVec2],
    streets: &Layout,
    green: &[Area],
    plan: &Georeference,
) -> Option<Vec<(Polygon, &'static str)>> {
    let hull: Area = Polygon::new(&convex_hull(trees), &[])?.into();
    let axes =
        || lines(streets, plan).filter_map(|(feature, line)| Some((word(feature, "name"), line, width(feature)?)));
    let carriageways = union_all(&axes().map(|(_, line, width)| stroke(&line, width)).collect::<Vec<_>>());
    let parks = intersection(&difference(&union_all(green), &carriageways), &hull);
    let mut wide: BTreeMap<String, Vec<Area>> = BTreeMap::new();
    for (name, line, width) in axes() {
        wide.entry(name).or_default().push(stroke(&line, width + 2.0 * VERGE));
    }
    // Carriageways and the verges of crossing streets cut the sides of a street into one lot for each block.
    let mut taken = union(&carriageways, &parks);
    let mut all: Vec<(Polygon, &str)> = parks.polygons().iter().map(|p| (p.clone(), "park")).collect();
    for sides in wide.values().map(union_all) {
        let verges = intersection(&difference(&sides, &taken), &hull);
        all.extend(verges.polygons().iter().map(|p| (p.clone(), "street")));
        taken = union(&taken, &sides);
    }
    all.retain(|(polygon, _)| is_planted(polygon, trees));
    Some(all)
}

fn is_planted(lot: &Polygon, trees: &[DVec2]) -> bool {
    let bounds = lot.bounds();
    let near = trees.iter().filter(|tree| bounds.contains(**tree));
    let window = Window::new(&[lot.clone().into()]);
    window.is_some_and(|lot| near.filter(|tree| lot.contains(**tree)).count() >= LEAST_TREES)
}

/// A layout, by way of GeoJSON: so lots find the buildings that stand in them and near.
fn layout(lots: &[(Polygon, &str)], buildings: &[Area]) -> Layout {
    let feature = |polygon: &Polygon, properties: Json| {
        let rings: Vec<Vec<[f64; 2]>> = polygon.rings().enumerate().map(|(i, ring)| closed(ring, i == 0)).collect();
        json!({ "type": "Feature", "properties": properties, "geometry": { "type": "Polygon", "coordinates": rings } })
    };
    let lots = lots.iter().map(|(polygon, zone)| feature(polygon, json!({ "kind": "lot", "zone": zone })));
    let houses = buildings.iter().flat_map(|area| area.polygons());
    let houses = houses.map(|polygon| feature(polygon, json!({ "kind": "building" })));
    let features: Vec<Json> = lots.chain(houses).collect();
    let text = json!({ "type": "FeatureCollection", "crs": "local", "features": features }).to_string();
    read_geojson("helsinki", text.as_bytes()).0
}

/// A closed ring, an outer one from its longest edge on: that is the front, and gives the lot its main axis.
fn closed(ring: &[DVec2], is_outer: bool) -> Vec<[f64; 2]> {
    let length = |i: usize| ring[i].distance(ring[(i + 1) % ring.len()]);
    let longest = (0..ring.len()).max_by(|a, b| length(*a).total_cmp(&length(*b))).unwrap_or(0);
    let first = if is_outer { longest } else { 0 };
    (0..=ring.len()).map(|i| ring[(first + i) % ring.len()].to_array()).collect()
}
