//! Coverage maps: where pixels lie on the plan, what area they give, and that no file does harm.
//!
//! The pictures are drawn here and encoded in memory.

#[path = "common/polygons.rs"]
mod polygons;

use bosquet::check::check;
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::{Area, Bounds, Polygon, difference, overlap_area};
use bosquet::layout::{Crs, Georeference};
use bosquet::raster::{Flaw, Measure, Raster, Rasters, without_trifles};
use bosquet::seed::Seed;
use bosquet::world::{MemoryWorld, World, WorldError};
use glam::DVec2;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use proptest::prelude::*;
use std::io::Cursor;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// All of the plan that a test can mean.
const EVERYWHERE: Bounds = Bounds { min: DVec2::splat(-1e5), max: DVec2::splat(1e5) };

/// A picture in grey or black and white, row by row from the top.
#[derive(Clone, Debug)]
struct Picture {
    size: [u32; 2],
    values: Vec<u8>,
}

impl Picture {
    fn drawn([width, height]: [u32; 2], value: impl Fn(u32, u32) -> u8) -> Picture {
        let values = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        Picture { size: [width, height], values: values.map(|(column, row)| value(column, row)).collect() }
    }

    /// All black but for one pixel.
    fn marked(size: [u32; 2], column: u32, row: u32) -> Picture {
        Picture::drawn(size, |c, r| if (c, r) == (column, row) { 255 } else { 0 })
    }

    fn png(&self) -> Vec<u8> {
        png(self.size, &self.values, ExtendedColorType::L8)
    }

    fn tiff(&self, tags: &Tags) -> Vec<u8> {
        tiff::<colortype::Gray8>(self.size, &self.values, tags)
    }

    fn is_covered(&self, column: i64, row: i64) -> bool {
        let [width, height] = self.size.map(i64::from);
        (0..width).contains(&column)
            && (0..height).contains(&row)
            && self.values[(row * width + column) as usize] >= 128
    }

    /// Covered pixels, and sides of pixels between covered and not.
    fn count_and_sides(&self) -> (f64, f64) {
        let [width, height] = self.size.map(i64::from);
        let pixels = || (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let covered = || pixels().filter(|(c, r)| self.is_covered(*c, *r));
        let sides = covered().flat_map(|(c, r)| [(c + 1, r), (c - 1, r), (c, r + 1), (c, r - 1)]);
        (covered().count() as f64, sides.filter(|(c, r)| !self.is_covered(*c, *r)).count() as f64)
    }
}

fn png([width, height]: [u32; 2], bytes: &[u8], color: ExtendedColorType) -> Vec<u8> {
    let mut out = Vec::new();
    PngEncoder::new(&mut out).write_image(bytes, width, height, color).expect("an encoder");
    out
}

/// Tags of a TIFF; empty ones are left out.
#[derive(Default)]
struct Tags {
    scale: Vec<f64>,
    tie: Vec<f64>,
    matrix: Vec<f64>,
    keys: Vec<u16>,
    no_data: &'static str,
}

impl Tags {
    /// Square pixels from an upper left corner, in an EPSG code.
    fn north_up(pixel: f64, [x, y]: [f64; 2], keys: &[[u16; 2]]) -> Tags {
        let mut directory = vec![1, 1, 0, keys.len() as u16];
        directory.extend(keys.iter().flat_map(|[key, value]| [*key, 0, 1, *value]));
        let (scale, tie) = (vec![pixel, pixel, 0.0], vec![0.0, 0.0, 0.0, x, y, 0.0]);
        Tags { scale, tie, keys: directory, ..Tags::default() }
    }
}

fn tiff<C: colortype::ColorType>([width, height]: [u32; 2], values: &[C::Inner], tags: &Tags) -> Vec<u8>
where
    [C::Inner]: tiff::encoder::TiffValue,
{
    let mut out = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut out).expect("an encoder");
    let mut image = encoder.new_image::<C>(width, height).expect("an encoder");
    for (tag, numbers) in [
        (Tag::ModelPixelScaleTag, &tags.scale),
        (Tag::ModelTiepointTag, &tags.tie),
        (Tag::ModelTransformationTag, &tags.matrix),
    ] {
        if !numbers.is_empty() {
            image.encoder().write_tag(tag, &numbers[..]).expect("a tag");
        }
    }
    if !tags.keys.is_empty() {
        image.encoder().write_tag(Tag::GeoKeyDirectoryTag, &tags.keys[..]).expect("a tag");
    }
    if !tags.no_data.is_empty() {
        image.encoder().write_tag(Tag::GdalNodata, tags.no_data).expect("a tag");
    }
    image.write_data(values).expect("an encoder");
    out.into_inner()
}

/// A raster beside its world file, on the plan of a layout.
fn read_in(bytes: &[u8], world_file: &str, layout: &Georeference) -> Result<Raster, Flaw> {
    let world = MemoryWorld::default().with("cover.wld", world_file);
    Raster::read("cover.png", bytes, &world, layout)
}

fn read(bytes: &[u8], world_file: &str) -> Raster {
    read_in(bytes, world_file, &Georeference::default()).expect("a sound raster")
}

/// The middle of the only patch.
fn middle_of_mark(raster: &Raster) -> DVec2 {
    let area = raster.area(&Measure::Cover, 0.5, EVERYWHERE).expect("a small raster");
    assert_eq!(area.polygons().len(), 1);
    area.bounds().centre()
}

fn local(centre: [f64; 2]) -> Georeference {
    Georeference::new(Crs::Local, centre).expect("always")
}

/// A mask of blobs and specks.
fn mask() -> impl Strategy<Value = Picture> {
    let disks = prop::collection::vec((0.0..40.0f64, 0.0..40.0f64, 0.4..12.0f64), 0..7);
    (1u32..40, 1u32..40, disks).prop_map(|(width, height, disks)| {
        Picture::drawn([width, height], |column, row| {
            let p = DVec2::new(column.into(), row.into());
            let inside = disks.iter().filter(|(x, y, r)| p.distance(DVec2::new(*x, *y)) < *r).count();
            if inside % 2 == 1 { 255 } else { 0 }
        })
    })
}

/// A world file: a pixel of that side, turned by some degrees, the picture from a place on.
fn turned(pixel: f64, degrees: f64, [x, y]: [f64; 2]) -> String {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let numbers = [pixel * cos, pixel * sin, pixel * sin, -pixel * cos, x, y];
    numbers.map(|number| format!("{number:.12}\n")).concat()
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn areas_are_those_of_the_pixels(mask in mask(), pixel in 0.05..20.0f64, degrees in 0.0..360.0f64) {
        let raster = read(&mask.png(), &turned(pixel, degrees, [30.0, -20.0]));
        let area = raster.area(&Measure::Cover, 0.5, EVERYWHERE).unwrap();
        let (count, sides) = mask.count_and_sides();
        let off = (area.area() - count * pixel * pixel).abs();
        prop_assert!(off <= 0.5 * sides * pixel * pixel + 1e-6, "{} for {count} pixels", area.area() / (pixel * pixel));
        for polygon in area.polygons() {
            prop_assert_eq!(polygon.sanity_check(), Ok(()));
        }
        // No two parts overlap: the union is no smaller than the sum.
        let united = bosquet::geometry::union_all(&area.polygons().iter().cloned().map(Area::from).collect::<Vec<_>>());
        prop_assert!((united.area() - area.area()).abs() <= 1e-5 * (1.0 + area.perimeter()));
    }

    #[test]
    fn drawn_polygons_come_back_within_a_pixel(star in polygons::area(), pixel in 0.3..0.6f64) {
        // Narrow places vanish or close: what lies farther than a pixel from every edge is certain.
        let bounds = star.bounds().grown(3.0 * pixel);
        let size = (bounds.size() / pixel).ceil().as_uvec2().to_array();
        let centre = |c: u32, r: u32| DVec2::new(bounds.min.x + (f64::from(c) + 0.5) * pixel, bounds.max.y - (f64::from(r) + 0.5) * pixel);
        let picture = Picture::drawn(size, |c, r| if star.contains(centre(c, r)) { 255 } else { 0 });
        let raster = read(&picture.png(), &turned(pixel, 0.0, centre(0, 0).to_array()));
        let area = raster.area(&Measure::Cover, 0.5, EVERYWHERE).unwrap();
        for polygon in area.polygons() {
            for p in polygon.points() {
                prop_assert!(star.distance_to_edges(*p) <= pixel, "{} m off", star.distance_to_edges(*p));
            }
        }
        for p in (0..size[1]).flat_map(|r| (0..size[0]).map(move |c| centre(c, r))) {
            if star.distance_to_edges(p) > 1.5 * pixel {
                prop_assert_eq!(area.contains(p), star.contains(p), "at {}", p);
            }
        }
    }

    #[test]
    fn a_part_of_the_plan_sees_what_the_whole_sees(mask in mask(), x in 0.0..30.0f64, y in 0.0..30.0f64) {
        let raster = read(&mask.png(), &turned(1.0, 0.0, [0.5, 39.5]));
        let window = Bounds { min: DVec2::new(x, y), max: DVec2::new(x + 8.0, y + 8.0) };
        let frame: Area = Polygon::rectangle(window.min, window.max).unwrap().into();
        let cut = |within| bosquet::geometry::intersection(&raster.area(&Measure::Cover, 0.5, within).unwrap(), &frame);
        let (whole, part) = (cut(EVERYWHERE), cut(window));
        // The outline is thinned from other vertices on: within half a pixel on either side.
        let apart = difference(&whole, &part).area() + difference(&part, &whole).area();
        prop_assert!(apart <= whole.perimeter().max(part.perimeter()) + 1e-6, "{apart} m² apart");
    }

    #[test]
    fn no_bytes_panic(which in 0..2usize, cut in 0.0..1.0f64, changes in prop::collection::vec((0.0..1.0f64, any::<u8>()), 0..6)) {
        let picture = Picture::drawn([9, 7], |c, r| (c * r) as u8);
        let tags = Tags::north_up(0.5, [3.0, 4.0], &[[1024, 1], [3072, 32633]]);
        let mut bytes = [picture.png(), picture.tiff(&tags)][which].clone();
        bytes.truncate((bytes.len() as f64 * (1.0 - cut * cut * cut)) as usize);
        for (place, byte) in changes {
            let place = (place * bytes.len() as f64) as usize;
            bytes.get_mut(place).into_iter().for_each(|old| *old = byte);
        }
        if let Ok(raster) = read_in(&bytes, &turned(1.0, 0.0, [0.0, 0.0]), &Georeference::default()) {
            let _ = raster.area(&Measure::Cover, 0.5, EVERYWHERE);
            let _ = raster.at(DVec2::new(3.0, 3.0), &Measure::Luminance);
        }
    }

    #[test]
    fn no_world_file_panics(text in "[-+0-9.e\n x]{0,60}", numbers in prop::collection::vec(any::<f64>(), 0..8)) {
        let picture = Picture::marked([4, 4], 1, 1).png();
        let written: String = numbers.iter().map(|n| format!("{n}\n")).collect();
        for file in [text, written] {
            if let Ok(raster) = read_in(&picture, &file, &Georeference::default()) {
                prop_assert!(raster.area(&Measure::Cover, 0.5, EVERYWHERE).is_ok());
            }
        }
    }
}

#[test]
fn between_pixels_the_edge_lies_where_the_value_reaches_the_threshold() {
    // Values rise from the left by 0.1 a pixel of 2 m: 0.3 is reached 6 m right of the first centre.
    let values: Vec<f32> = (0..8).flat_map(|_| (0..10).map(|c| c as f32 * 0.1)).collect();
    let raster =
        read(&tiff::<colortype::Gray32Float>([10, 8], &values, &Tags::default()), &turned(2.0, 0.0, [1.0, 15.0]));
    let bounds = raster.area(&Measure::Cover, 0.3, EVERYWHERE).unwrap().bounds();
    assert!((bounds.min.x - 7.0).abs() < 0.01 && (bounds.max.x - 20.0).abs() < 1e-6, "{bounds:?}");
    let value = raster.at(DVec2::new(7.6, 8.3), &Measure::Cover).unwrap();
    assert!((value - 0.33).abs() < 1e-6, "{value}");
}

#[test]
fn a_world_file_places_the_centre_of_the_first_pixel() {
    // A sheet of Wikipedia's article on world files: 32 m pixels, first centre at 691200, 4576000. By hand, column 3
    // and row 2 lie at 691200 + 96, 4576000 - 64.
    let file = "32.0\n0.0\n0.0\n-32.0\n691200.0\n4576000.0\n";
    let raster = read_in(&Picture::marked([8, 6], 3, 2).png(), file, &local([691_000.0, 4_576_000.0])).unwrap();
    assert!(middle_of_mark(&raster).distance(DVec2::new(296.0, -64.0)) < 0.01);
    assert!((raster.pixel() - 32.0).abs() < 1e-9);
    // Turned by a quarter: columns run north, rows run east.
    let raster = read_in(&Picture::marked([8, 6], 3, 2).png(), "0\n2\n2\n0\n10\n20\n", &local([0.0; 2])).unwrap();
    assert!(middle_of_mark(&raster).distance(DVec2::new(14.0, 26.0)) < 0.01);
}

#[test]
fn geotiff_tags_place_areas_and_points() {
    // OGC 19-008r4 has 440720, 3751320 with pixels of 60 m as its example: the upper left corner where pixels are
    // areas, the first centre where they are points.
    let mark = Picture::marked([8, 6], 3, 2);
    let layout = Georeference::new(Crs::Epsg(32611), [440_720.0, 3_751_320.0]).unwrap();
    for (kind, place) in [(1, DVec2::new(210.0, -150.0)), (2, DVec2::new(180.0, -120.0))] {
        let tags = Tags::north_up(60.0, [440_720.0, 3_751_320.0], &[[1024, 1], [1025, kind], [3072, 32611]]);
        let raster = read_in(&mark.tiff(&tags), "", &layout).unwrap();
        assert!(middle_of_mark(&raster).distance(place) < 0.01, "{kind}: {}", middle_of_mark(&raster));
    }
    // The same as a matrix, with no system named: it is the layout's.
    let matrix = [60.0, 0.0, 0.0, 440_720.0, 0.0, -60.0, 0.0, 3_751_320.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let raster = read_in(&mark.tiff(&Tags { matrix: matrix.to_vec(), ..Tags::default() }), "", &layout).unwrap();
    assert!(middle_of_mark(&raster).distance(DVec2::new(210.0, -150.0)) < 0.01);
}

#[test]
fn degrees_are_exact_over_a_wide_raster() {
    // 0.02° by 0.01° about Paris: a pixel near the corner, 700 m off, where an affine map would be 3 cm off.
    let layout = Georeference::new(Crs::Wgs84, [2.35, 48.86]).unwrap();
    let (pixel, corner) = (1e-5, [2.34, 48.865]);
    let tags = Tags::north_up(pixel, corner, &[[1024, 2], [1025, 1], [2048, 4326]]);
    let raster = read_in(&Picture::marked([2000, 1000], 1990, 10).tiff(&tags), "", &layout).unwrap();
    let centre = layout.to_plan([corner[0] + 1990.5 * pixel, corner[1] - 10.5 * pixel]);
    assert!(middle_of_mark(&raster).distance(centre) < 0.01, "{} for {centre}", middle_of_mark(&raster));
    assert!(raster.at(centre, &Measure::Cover).unwrap() > 0.99);
}

#[test]
fn a_projected_raster_lies_right_in_a_layout_in_degrees() {
    // PROJ 9 puts 392000, 5820000 of EPSG:25833 at 13.4082754403, 52.5193953184 degrees.
    let layout = Georeference::new(Crs::Wgs84, [13.408_275_440_3, 52.519_395_318_4]).unwrap();
    let tags = Tags::north_up(0.5, [391_900.25, 5_820_100.25], &[[1024, 1], [3072, 25833]]);
    let raster = read_in(&Picture::marked([400, 300], 199, 200).tiff(&tags), "", &layout).unwrap();
    assert!(middle_of_mark(&raster).length() < 0.01, "{}", middle_of_mark(&raster));
    let refused = read_in(&Picture::marked([4, 3], 1, 1).tiff(&tags), "", &local([0.0; 2])).unwrap_err();
    assert_eq!(refused, Flaw::OtherSystem { found: Crs::Epsg(25833), layout: Crs::Local });
}

#[test]
fn drawn_polygons_lie_where_their_coordinates_are() {
    // PROJ 9 puts 392000, 5820000 of EPSG:25833 at 13.4082754403, 52.5193953184 degrees.
    let layout = Georeference::new(Crs::Wgs84, [13.408_275_440_3, 52.519_395_318_4]).unwrap();
    let square = "[[[392000, 5820000], [392020, 5820000], [392020, 5820010], [392000, 5820010], [392000, 5820000]]]";
    let file =
        |crs: &str, rings: &str| format!("{{\"type\": \"Polygon\", \"crs\": \"{crs}\", \"coordinates\": {rings}}}");
    let degrees = "[[[13.408, 52.519], [13.409, 52.519], [13.409, 52.520], [13.408, 52.519]]]";
    let world = MemoryWorld::default()
        .with("grid.geojson", file("EPSG:25833", square))
        .with("degrees.geojson", file("EPSG:4326", degrees))
        .with("local.geojson", file("local", square));
    let rasters = Rasters::new(&world, "main.cga", layout.clone());
    let has_vertex = |path: &str, place: DVec2| {
        let area = rasters.drawn(path).unwrap().area(EVERYWHERE);
        area.polygons().iter().flat_map(Polygon::points).any(|p| p.distance(place) < 0.01)
    };
    assert!(has_vertex("grid.geojson", DVec2::ZERO));
    assert!(has_vertex("degrees.geojson", layout.to_plan([13.409, 52.519])));
    let refused = rasters.drawn("local.geojson").unwrap_err();
    assert_eq!(refused.flaw, Flaw::OtherSystem { found: Crs::Local, layout: Crs::Wgs84 });
}

#[test]
fn what_says_nothing_is_not_covered() {
    let values = [1.0, 1.0, f32::NAN, -9999.0, 1.0, 0.0f32];
    let tags = Tags { no_data: "-9999", ..Tags::default() };
    let raster = read(&tiff::<colortype::Gray32Float>([6, 1], &values, &tags), &turned(1.0, 0.0, [0.5, 0.5]));
    let at = |x: f64| raster.at(DVec2::new(x, 0.5), &Measure::Cover);
    assert_eq!([at(0.5), at(2.5), at(3.5), at(5.5), at(6.5)], [Some(1.0), None, None, Some(0.0), None]);
    assert_eq!(at(1.9), Some(1.0), "beside what says nothing counts what is there");
    let below = raster.area(&Measure::Cover, -1e6, EVERYWHERE).unwrap();
    assert!((below.bounds().min.x, below.bounds().max.x) == (0.0, 6.0) && !below.contains(DVec2::new(3.0, 0.5)));
}

#[test]
fn every_sort_of_picture_is_read() {
    let file = turned(1.0, 0.0, [0.5, 0.5]);
    let value = |bytes: &[u8], measure: Measure| read(bytes, &file).at(DVec2::new(1.5, 0.5), &measure);
    let near = |found: Option<f64>, wanted: f64| assert!((found.unwrap() - wanted).abs() < 1e-6, "{found:?}");
    let color = ExtendedColorType::Rgb8;
    let green = png([2, 1], &[9, 9, 9, 0, 255, 0], color);
    near(value(&green, Measure::Cover), 0.7152);
    near(value(&green, Measure::Band(1)), 1.0);
    near(value(&green, Measure::Color { color: [0.02, 0.98, 0.0], tolerance: 0.03 }), 1.0);
    near(value(&green, Measure::Color { color: [0.02, 0.98, 0.0], tolerance: 0.01 }), 0.0);
    assert_eq!(value(&green, Measure::Opacity), None);
    // Where there are clear pixels, what is opaque is covered, black or not.
    let clear = png([2, 1], &[255, 255, 255, 0, 0, 0, 0, 204], ExtendedColorType::Rgba8);
    near(value(&clear, Measure::Cover), 0.8);
    let opaque = png([2, 1], &[255, 255, 255, 255, 0, 0, 0, 255], ExtendedColorType::Rgba8);
    near(value(&opaque, Measure::Cover), 0.0);
    let words: Vec<u8> = [0u16, 13107].iter().flat_map(|v| v.to_ne_bytes()).collect();
    near(value(&png([2, 1], &words, ExtendedColorType::L16), Measure::Cover), 0.2);
    near(value(&tiff::<colortype::Gray16>([2, 1], &[0, 13107], &Tags::default()), Measure::Cover), 0.2);
    near(value(&tiff::<colortype::RGB8>([2, 1], &[0, 0, 0, 0, 255, 0], &Tags::default()), Measure::Cover), 0.7152);
    near(value(&tiff::<colortype::GrayI16>([2, 1], &[0, -3], &Tags::default()), Measure::Cover), -3.0);
    // A mask of nothing but 0 and 1.
    near(value(&png([2, 1], &[0, 1], ExtendedColorType::L8), Measure::Cover), 1.0);
}

#[test]
fn single_bits_and_palettes_are_read() {
    // By hand: a TIFF of 10 × 2 pixels, one bit each, rows of two bytes.
    let entry = |tag: u16, kind: u16, count: u32, value: u32| {
        let value = if kind == 3 && count == 1 { (value as u16, 0u16) } else { (value as u16, (value >> 16) as u16) };
        let mut bytes = [tag.to_le_bytes(), kind.to_le_bytes()].concat();
        bytes.extend(count.to_le_bytes());
        bytes.extend([value.0.to_le_bytes(), value.1.to_le_bytes()].concat());
        bytes
    };
    let tiff = |photometric: u32| {
        let map: Vec<u8> = [0u16, 0, 0, 65535, 0, 0].iter().flat_map(|v| v.to_le_bytes()).collect();
        let data = [0b0100_0000, 0b0100_0000, 0, 0];
        let entries = [
            entry(256, 3, 1, 10),
            entry(257, 3, 1, 2),
            entry(258, 3, 1, 1),
            entry(259, 3, 1, 1),
            entry(262, 3, 1, photometric),
            entry(273, 4, 1, 8),
            entry(277, 3, 1, 1),
            entry(278, 3, 1, 2),
            entry(279, 4, 1, 4),
            entry(320, 3, 6, 12),
        ];
        let mut bytes = [b"II*\0".as_slice(), &24u32.to_le_bytes(), &data, &map].concat();
        bytes.extend((entries.len() as u16).to_le_bytes());
        entries.iter().for_each(|entry| bytes.extend(entry));
        bytes.extend([0; 4]);
        bytes
    };
    let file = turned(1.0, 0.0, [0.5, 1.5]);
    let at = |raster: &Raster, x: f64, y: f64| raster.at(DVec2::new(x, y), &Measure::Cover).unwrap();
    let (light, dark) = (read(&tiff(1), &file), read(&tiff(0), &file));
    assert_eq!([1.5, 9.5, 5.5].map(|x| at(&light, x, 1.5)), [1.0, 1.0, 0.0]);
    assert_eq!([1.5, 9.5, 5.5].map(|x| at(&dark, x, 1.5)), [0.0, 0.0, 1.0], "white is zero");
    assert_eq!(at(&light, 1.5, 0.5), 0.0);
    assert!(matches!(read_in(&tiff(3), &file, &Georeference::default()), Err(Flaw::Unsupported(_))), "a palette");
    let palette = read(&palette_png(), &turned(1.0, 0.0, [0.5, 0.5]));
    assert_eq!([0.5, 1.5].map(|x| palette.at(DVec2::new(x, 0.5), &Measure::Band(1))), [Some(0.0), Some(1.0)]);
}

/// Two pixels, the second of them green, by a palette.
fn palette_png() -> Vec<u8> {
    let plain = png([2, 1], &[0, 1], ExtendedColorType::L8);
    let mut header = plain[8..33].to_vec();
    header[17] = 3;
    let checksum = crc(&header[4..21]);
    header[21..].copy_from_slice(&checksum.to_be_bytes());
    let mut palette = [&6u32.to_be_bytes(), b"PLTE".as_slice(), &[9, 0, 9, 0, 255, 0]].concat();
    let checksum = crc(&palette[4..]);
    palette.extend(checksum.to_be_bytes());
    [&plain[..8], &header, &palette, &plain[33..]].concat()
}

#[test]
fn files_that_are_none_say_why() {
    let picture = Picture::marked([40, 40], 3, 3);
    let file = turned(1.0, 0.0, [0.0, 0.0]);
    let refused = |bytes: &[u8], file: &str| read_in(bytes, file, &Georeference::default()).unwrap_err();
    for bytes in [picture.png(), picture.tiff(&Tags::default())] {
        for end in [9, 30, bytes.len() / 2] {
            assert!(matches!(refused(&bytes[..end], &file), Flaw::Damaged(_)), "cut at {end}");
        }
    }
    assert_eq!(refused(b"GIF89a", &file), Flaw::Format);
    assert_eq!(refused(&picture.png(), "0\n0\n0\n0\n0\n0\n"), Flaw::NoExtent);
    assert_eq!(refused(&picture.png(), "1\n0\n2\n0\n0\n0\n"), Flaw::NoExtent);
    for (text, reason) in [("1\n2\n3\n", "it has 3 numbers"), ("1 0 0 NaN 0 0", "`NaN` is no number")] {
        let Flaw::WorldFile { path, reason: found } = refused(&picture.png(), text) else { panic!("no world file") };
        assert_eq!((path.as_str(), found.as_str()), ("cover.wld", reason));
    }
    // A header that promises 65535 × 65535 pixels.
    let mut huge = picture.png();
    huge[16..24].copy_from_slice(&[0, 0, 255, 255, 0, 0, 255, 255]);
    let checksum = crc(&huge[12..29]);
    huge[29..33].copy_from_slice(&checksum.to_be_bytes());
    assert_eq!(refused(&huge, &file), Flaw::TooManyPixels(65_535 * 65_535));
}

/// The checksum of a PNG chunk (ISO 15948, annex D).
fn crc(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(u32::MAX, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), step))
}

/// A world that counts what is asked of it.
struct Counting(MemoryWorld, AtomicUsize);

impl World for Counting {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.asset(path)
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        let found = self.0.asset(path);
        self.1.fetch_add(usize::from(found.is_ok()), Ordering::Relaxed);
        found
    }
}

#[test]
fn a_map_is_read_once_and_lies_beside_the_rules() {
    let files = MemoryWorld::default()
        .with("maps/cover.png", Picture::marked([4, 4], 1, 1).png())
        .with("maps/cover.pgw", turned(1.0, 0.0, [0.0, 0.0]));
    let world = Counting(files, AtomicUsize::new(0));
    let rasters = Rasters::new(&world, "rules/main.cga", Georeference::default());
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| assert!(rasters.get("../maps/cover.png").is_ok()));
        }
    });
    assert_eq!(world.1.load(Ordering::Relaxed), 2, "the picture and its world file");
    let missing = rasters.get("cover.png").err().map(|error| error.to_string());
    assert_eq!(
        missing.as_deref(),
        Some("the coverage map `rules/cover.png` cannot be used: there is no file `rules/cover.png`")
    );
}

#[test]
fn a_picture_without_a_place_names_the_files_that_would_do() {
    let world = MemoryWorld::default().with("cover.png", Picture::marked([4, 4], 1, 1).png());
    let error = Rasters::new(&world, "main.cga", Georeference::default()).get("cover.png").map(|_| ()).unwrap_err();
    let said = "the coverage map `cover.png` cannot be used: nothing says where it lies: there is no `cover.pgw`, \
                `cover.pngw` or `cover.wld`";
    assert_eq!(error.to_string(), said);
}

#[test]
fn trifles_go_and_small_gaps_close() {
    let square = |x: f64, side: f64| {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(a, b)| DVec2::new(x + a * side, b * side))
    };
    let holes = [square(1.0, 0.5).map(|p| p + 1.0).to_vec(), square(4.0, 3.0).map(|p| p + 1.0).to_vec()];
    let area: Area = [Polygon::new(&square(0.0, 10.0), &holes), Polygon::new(&square(20.0, 0.9), &[])]
        .into_iter()
        .flatten()
        .collect();
    let left = without_trifles(&area, 1.0);
    assert_eq!((left.polygons().len(), left.area()), (1, 91.0));
}

/// The areas of the leaves of each symbol, and of the parts of two symbols that overlap.
fn parts(rules: &str, mask: &Picture, lot: Polygon) -> (f64, f64, f64) {
    let world = MemoryWorld::default()
        .with("main.cga", rules)
        .with("cover.png", mask.png())
        .with("cover.pgw", turned(1.3, 20.0, [-25.0, 25.0]));
    let (program, found) = check(&world, "main.cga");
    assert!(found.is_empty(), "{found:?}");
    let rings: Vec<Vec<[f64; 2]>> = lot.rings().map(|ring| ring.iter().map(|p| p.to_array()).collect()).collect();
    let text = format!("{{\"type\": \"Polygon\", \"crs\": \"local\", \"coordinates\": {rings:?}}}");
    let (layout, _) = bosquet::layout::read_geojson("lot.geojson", text.as_bytes());
    let (catalogue, limits) = (Catalogue::built_in(), Limits::default());
    let options = Options { start: None, seed: Seed(3), set: Vec::new(), catalogue, world: &world, limits };
    let (derivation, found) = derive(&program, &layout, &options, &Progress::default());
    assert!(found.is_empty(), "{found:?}");
    let outcome = &derivation.lots[0].outcome;
    let area = |name: &str| -> Area {
        let is_named = |node: usize| *derivation.symbols[outcome.nodes[node].symbol as usize] == *name;
        let leaves = outcome.leaves.iter().filter(|leaf| is_named(leaf.node.0 as usize));
        let areas = leaves.filter_map(|leaf| match leaf.shape.footprint().extent {
            bosquet::shape::Extent::Area(area) => Some(area.polygons().to_vec()),
            _ => None,
        });
        areas.flatten().collect()
    };
    let (wood, lawn) = (area("Wood"), area("Lawn"));
    (wood.area(), lawn.area(), overlap_area(&wood, &lawn))
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn parts_sum_to_the_whole(mask in mask(), lot in prop_oneof![polygons::polygon(), polygons::convex()], together in any::<bool>(), least in 0.0..20.0f64) {
        let sign = if together { '=' } else { ':' };
        let rules = format!("Lot --> coverage(\"cover.png\", least = {least:.3}) {{ cover {sign} Wood. | remainder : Lawn. }}");
        let (whole, around) = (lot.area(), lot.perimeter());
        let (wood, lawn, both) = parts(&rules, &mask, lot);
        prop_assert!((wood + lawn - whole).abs() < 1e-4 * around, "{wood} + {lawn} = {whole} m²");
        prop_assert!(both < 1e-4 * around, "{both} m² are in both");
    }
}
