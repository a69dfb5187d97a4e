//! Points, areas and lines out of files, brought into one plan.
//!
//! In: GeoJSON of any sort, or plants as CSV. Out: metres in the plan of the first file that knows its coordinates.

use crate::cli::disk::Disk;
use bosquet::diag::Diagnostic;
use bosquet::export::plants::read_plants;
use bosquet::geometry::{Area, Polygon};
use bosquet::layout::{Crs, Georeference, Kind, Layout, Shapes, read_geojson};
use glam::DVec2;

/// What a file holds that can be measured, in plan metres once [`share_plan`] has been called.
pub struct Source {
    /// The file as the user named it.
    pub path: String,
    /// Points with the word of their kind.
    pub points: Vec<(DVec2, String)>,
    /// Polygons with what they are.
    pub areas: Vec<(Kind, Polygon)>,
    /// Lines.
    pub lines: Vec<Vec<DVec2>>,
    /// Features that could not be used.
    pub flaws: Vec<Diagnostic>,
    /// The way to its coordinates; none for metres of a table, which are those of the other files.
    way: Option<Georeference>,
}

impl Source {
    /// Reads a file; what is wrong comes as diagnostics where nothing of it can be used.
    pub fn read(path: &str, disk: &Disk) -> Result<Source, Vec<Diagnostic>> {
        let refused = |message: String| vec![Diagnostic::data("points", path, message)];
        let bytes = disk.named(path).map_err(|error| vec![Diagnostic::data("file", path, error.to_string())])?;
        if bytes.trim_ascii_start().is_empty() {
            return Err(refused("the file is empty".into()));
        }
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
        if !text.trim_ascii_start().starts_with(b"{") && !text.trim_ascii_start().starts_with(b"[") {
            return table(path, text).map_err(refused);
        }
        let (layout, found) = read_geojson(path, &bytes);
        let flaws: Vec<Diagnostic> = found.into_iter().filter(Diagnostic::is_error).collect();
        let is_empty = layout.regions.is_empty() && layout.features.is_empty();
        if is_empty && !flaws.is_empty() { Err(flaws) } else { Ok(Source::of(path, layout, flaws)) }
    }

    fn of(path: &str, layout: Layout, flaws: Vec<Diagnostic>) -> Source {
        let regions = layout.regions.into_iter().map(|region| (region.kind, region.polygon));
        let mut source = Source {
            path: path.into(),
            points: Vec::new(),
            areas: regions.collect(),
            lines: Vec::new(),
            flaws,
            way: Some(layout.georeference),
        };
        for feature in layout.features {
            match feature.shapes {
                Shapes::Points(points) => {
                    source.points.extend(points.into_iter().map(|p| (p, feature.kind.word().to_owned())));
                }
                Shapes::Lines(lines, _) => source.lines.extend(lines),
                // What is region and feature at once is there already.
                Shapes::Areas(_) if feature.kind.is_region() => {}
                Shapes::Areas(areas) => source.areas.extend(areas.into_iter().map(|a| (feature.kind.clone(), a))),
            }
        }
        source
    }

    /// The points of a kind, or all.
    pub fn points_of(&self, kind: Option<&str>) -> Vec<DVec2> {
        let wanted = |(_, word): &&(DVec2, String)| kind.is_none_or(|kind| word == kind);
        self.points.iter().filter(wanted).map(|(p, _)| *p).collect()
    }

    /// The areas of a kind.
    pub fn areas_of(&self, kind: &Kind) -> Vec<Area> {
        self.areas.iter().filter(|(k, _)| k == kind).map(|(_, p)| p.clone().into()).collect()
    }

    /// All areas.
    pub fn all_areas(&self) -> Vec<Area> {
        self.areas.iter().map(|(_, p)| p.clone().into()).collect()
    }

    fn moved(&mut self, map: impl Fn(DVec2) -> DVec2) {
        self.points.iter_mut().for_each(|(p, _)| *p = map(*p));
        self.areas.iter_mut().for_each(|(_, polygon)| *polygon = polygon.mapped(&map));
        self.lines.iter_mut().flatten().for_each(|p| *p = map(*p));
    }
}

/// Brings all files into the plan of the first that knows its coordinates; an error where their systems differ.
pub fn share_plan(sources: &mut [&mut Source]) -> Result<(), Vec<Diagnostic>> {
    let Some((first, plan)) = sources.iter().find_map(|s| Some((s.path.clone(), s.way.clone()?))) else {
        return Ok(());
    };
    for source in sources.iter_mut() {
        let own = source.way.clone();
        match own {
            Some(own) if own == plan => {}
            Some(own) if own.crs == plan.crs => source.moved(|p| plan.to_plan(own.to_world(p))),
            None if plan.crs != Crs::Wgs84 => source.moved(|p| plan.to_plan(p.to_array())),
            own => {
                let system = own.map_or("metres".to_owned(), |own| format!("`{}`", own.crs));
                let message = format!("the coordinates are in {system}, those of `{first}` in `{}`", plan.crs);
                let hint = "bring the files into one coordinate system";
                return Err(vec![Diagnostic::data("points-crs", &*source.path, message).hint(hint)]);
            }
        }
    }
    Ok(())
}

/// Plants of a table: in degrees around their mean place, or in metres of a system that others know.
fn table(path: &str, text: &[u8]) -> Result<Source, String> {
    let world = Georeference::default();
    let plants = read_plants(text, &world).map_err(|error| error.to_string())?;
    let header = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let in_degrees = String::from_utf8_lossy(header).split(',').any(|title| title.trim() == "longitude");
    let points: Vec<(DVec2, String)> = plants.into_iter().map(|p| (p.position, p.kind.to_string())).collect();
    let mut source =
        Source { path: path.into(), points, areas: Vec::new(), lines: Vec::new(), flaws: Vec::new(), way: None };
    if in_degrees && !source.points.is_empty() {
        if let Some((p, _)) = source.points.iter().find(|(p, _)| p.x.abs() > 180.0 || p.y.abs() > 90.0) {
            return Err(format!(
                "the position {}, {} lies off the globe: metres stand in columns `x` and `y`",
                p.x, p.y
            ));
        }
        let centre = source.points.iter().map(|(p, _)| *p).sum::<DVec2>() / source.points.len() as f64;
        let way = Georeference::new(Crs::Wgs84, centre.to_array()).map_err(|error| error.to_string())?;
        source.moved(|p| way.to_plan(p.to_array()));
        source.way = Some(way);
    }
    Ok(source)
}
