//! Layouts for tests, from a few words: `rect 40 20`, `hole 10,5 20,5 20,10`, `feature building 0,0 8,0 8,6 height=5`.

use bosquet::geometry::Polygon;
use bosquet::layout::{Feature, Kind, Layout, Region, Shapes};
use bosquet::value::{Array, Cells, Value};
use glam::DVec2;
use std::sync::Arc;

/// A lot of that outline.
pub fn region(id: &str, polygon: Polygon) -> Region {
    Region {
        id: id.into(),
        name: id.into(),
        kind: Kind::Lot,
        zone: "".into(),
        polygon,
        elevation: 0.0,
        start: None,
        seed: None,
        attributes: Default::default(),
        features: Vec::new(),
        neighbours: Vec::new(),
    }
}

/// Regions that all see each other and every feature.
pub fn layout(mut regions: Vec<Region>, features: Vec<Feature>) -> Layout {
    let count = regions.len();
    for (index, region) in regions.iter_mut().enumerate() {
        region.features = (0..features.len()).collect();
        region.neighbours = (0..count).filter(|other| *other != index).collect();
    }
    Layout { regions, features, ..Layout::default() }
}

/// A value as written behind `name=`: a number, an array of numbers (`[1,0,2]`), a truth value, or else a text.
pub fn value(text: &str) -> Value {
    let list = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let numbers = list.and_then(|list| list.split(',').map(|n| n.parse().ok()).collect::<Option<Vec<f64>>>());
    if let Some(numbers) = numbers {
        return Value::Array(Arc::new(Array::row(Cells::Numbers(numbers))));
    }
    match (text.parse::<f64>(), text) {
        (Ok(number), _) => Value::Float(number),
        (_, "true" | "false") => Value::Bool(text == "true"),
        _ => Value::text(text),
    }
}

/// A layout from statements, one a line; a lot of 40 × 20 m where none is given.
///
/// `rect w h [x y]` and `polygon x,y …` begin a region (`lot`, `lot2`, …), on which `hole`, `id`, `kind`, `zone`,
/// `start`, `elevation` and `attribute name=value` have their say; `feature kind x,y … [height=h]` adds a feature.
pub fn parse(statements: &[&str]) -> Result<Layout, String> {
    let (mut regions, mut features) = (Vec::new(), Vec::new());
    for statement in statements {
        let (word, rest) = statement.split_once(' ').unwrap_or((statement, ""));
        let done = match word {
            "rect" | "polygon" => outline(word, rest).map(|p| regions.push(region(&name(regions.len()), p))),
            "feature" => feature(rest, features.len()).map(|f| features.push(f)),
            _ => regions.last_mut().and_then(|region| change(region, word, rest)),
        };
        done.ok_or_else(|| format!("`{statement}` is not understood"))?;
    }
    if regions.is_empty() {
        regions.extend(outline("rect", "40 20").map(|p| region("lot", p)));
    }
    Ok(layout(regions, features))
}

fn name(index: usize) -> String {
    if index == 0 { "lot".into() } else { format!("lot{}", index + 1) }
}

fn outline(word: &str, rest: &str) -> Option<Polygon> {
    if word == "polygon" {
        return Polygon::new(&points(rest)?, &[]);
    }
    let numbers: Vec<f64> = rest.split_whitespace().map(|n| n.parse().ok()).collect::<Option<_>>()?;
    match numbers.as_slice() {
        [w, h] => Polygon::rectangle(DVec2::ZERO, DVec2::new(*w, *h)),
        [w, h, x, y] => Polygon::rectangle(DVec2::new(*x, *y), DVec2::new(x + w, y + h)),
        _ => None,
    }
}

fn points(text: &str) -> Option<Vec<DVec2>> {
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',')?;
        Some(DVec2::new(x.parse().ok()?, y.parse().ok()?))
    };
    text.split_whitespace().map(point).collect()
}

fn feature(rest: &str, index: usize) -> Option<Feature> {
    let (kind, rest) = rest.split_once(' ')?;
    let (places, height) = rest.split_once(" height=").unwrap_or((rest, "0"));
    let points = points(places)?;
    let shapes = match points.len() {
        1 => Shapes::Points(points),
        2 => Shapes::Lines(vec![points], 0.0),
        _ => Shapes::Areas(vec![Polygon::new(&points, &[])?]),
    };
    let id: Arc<str> = format!("feature{index}").into();
    let (kind, height) = (Kind::parse(kind), height.parse().ok()?);
    Some(Feature { id: id.clone(), name: id, kind, shapes, elevation: 0.0, height, attributes: Default::default() })
}

fn change(region: &mut Region, word: &str, rest: &str) -> Option<()> {
    match word {
        "id" => (region.id, region.name) = (rest.into(), rest.into()),
        "kind" => region.kind = Kind::parse(rest),
        "zone" => region.zone = rest.into(),
        "start" => region.start = Some(rest.into()),
        "elevation" => region.elevation = rest.parse().ok()?,
        "hole" => {
            let mut holes: Vec<Vec<DVec2>> = region.polygon.holes().map(<[DVec2]>::to_vec).collect();
            holes.push(points(rest)?);
            region.polygon = Polygon::new(region.polygon.outer(), &holes)?;
        }
        "attribute" => {
            let (name, text) = rest.split_once('=')?;
            region.attributes.insert(name.into(), value(text));
        }
        _ => return None,
    }
    Some(())
}
