//! What is written: kinds and endings, whole files or none, and plans true to scale.

use crate::bench::Bench;
use bosquet::export::plants::read_plants;
use bosquet::layout::read_geojson;

#[test]
fn every_kind_and_every_bare_ending_is_written() {
    let bench = Bench::garden();
    let outputs = "-o p.svg -o p.png -o both.geojson -o bare.csv -o bare.json -o plan:q.svg -o plan:q.png \
                   -o plants:t.geojson -o plants:t.csv -o surfaces:g.geojson -o schedule:s.csv -o report:r.json";
    bench.bosquet(&format!("derive garden {outputs}")).ends(0);
    for (bare, kind) in [("p.svg", "q.svg"), ("p.png", "q.png"), ("bare.csv", "s.csv"), ("bare.json", "r.json")] {
        assert_eq!(bench.bytes(bare), bench.bytes(kind), "{bare}");
    }
    let count = |file: &str| bench.json(file)["features"].as_array().expect("features").len();
    assert_eq!(count("both.geojson"), count("t.geojson") + count("g.geojson"), "plants and surfaces");
    assert!(bench.text("bare.csv").starts_with("Plants"));
    assert!(bench.text("t.csv").starts_with("x,y,id,"));
}

#[test]
fn plants_come_back_from_both_formats_as_they_were() {
    let bench = Bench::two_lots("Lot --> [ Distr(0.05, 0) { T } ] Lawn\nT --> I(birch, adult, rand(5))");
    bench.derive_two("-o plants:p.csv -o plants:p.geojson -o r.json").ends(0);
    let (layout, _) = read_geojson("two.geojson", &bench.bytes("two.geojson"));
    let [csv, json] = ["p.csv", "p.geojson"].map(|f| read_plants(&bench.bytes(f), &layout.georeference).expect(f));
    assert_eq!(csv, json);
    assert_eq!(bench.json("r.json")["summary"]["plants"], csv.len());
    assert!(csv.len() > 20 && csv[0].existing && csv[0].elevation == 2.5, "the oak stands first: {:?}", csv[0]);
}

#[test]
fn what_cannot_be_written_is_said_before_the_run() {
    let bench = Bench::garden().with("folder.svg/x", "").with("a.svg", "old");
    let cases: &[(&str, &[&str])] = &[
        ("-o a.txt", &["`.txt`", ".svg"]),
        ("-o plants:a.svg", &["`plants` is written as .geojson or .csv"]),
        ("-o plann:a.svg", &["no output kind `plann`", "did you mean `plan`?"]),
        ("-o a.svg -o folder.svg", &["`folder.svg` is a folder"]),
        ("-o a.svg -o nowhere/b.svg", &["there is no folder `nowhere`"]),
        ("-o a.svg -o ./a.svg", &["`./a.svg` would be written twice"]),
        ("-o a.svg -o garden/lot.geojson", &["`garden/lot.geojson` is read by this run"]),
        ("-o a.svg -o a.png --size 90000x90000", &["90000"]),
    ];
    let before = bench.text("garden/lot.geojson");
    for (arguments, words) in cases {
        bench.bosquet(&format!("derive garden {arguments}")).ends(2).says(words);
    }
    assert_eq!(bench.names(), ["a.svg", "folder.svg", "garden"], "no half file, no temporary file");
    assert_eq!((bench.text("a.svg"), bench.text("garden/lot.geojson")), ("old".into(), before));
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written_to_stays_as_it_is() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::garden().with("locked/a.svg", "old");
    let lock = |mode| std::fs::set_permissions(bench.path("locked"), std::fs::Permissions::from_mode(mode)).unwrap();
    lock(0o555);
    if std::fs::write(bench.path("locked/probe"), "").is_ok() {
        println!("skipped: this user may write anywhere");
        return lock(0o755);
    }
    bench.bosquet("derive garden -o b.json -o locked/a.svg").ends(1).says(&["`locked/a.svg` cannot be written"]);
    lock(0o755);
    assert_eq!((bench.text("locked/a.svg"), bench.names()), ("old".into(), vec!["garden".into(), "locked".into()]));
}

#[test]
fn a_scale_makes_the_paper_true() {
    let bench = Bench::garden();
    for (scale, metre) in [("1:100", 10.0), ("1:500", 2.0), ("2000", 0.5)] {
        bench.run(&["derive", "garden", "--scale", scale, "-o", "p.svg"]).ends(0);
        let text = bench.text("p.svg");
        let svg = roxmltree::Document::parse(&text).expect("XML");
        let root = svg.root_element();
        let side = |name| root.attribute(name).and_then(|w| w.strip_suffix("mm")).expect("millimetres");
        let viewbox = format!("0 0 {} {}", side("width"), side("height"));
        assert_eq!(root.attribute("viewBox"), Some(&*viewbox), "a unit is a millimetre");
        let lawn = outline(&svg, "cover lawn");
        assert!((lawn[0] - 28.0 * metre).abs() < 0.02 && (lawn[1] - 18.0 * metre).abs() < 0.02, "{scale}: {lawn:?}");
    }
}

/// Width and height of the outline of the first surface of that class: of paths from `M`, `L`, `H` and `V`.
fn outline(svg: &roxmltree::Document, class: &str) -> [f64; 2] {
    let surface = svg.descendants().find(|n| n.attribute("class") == Some(class)).expect("a surface");
    let path = surface.descendants().find_map(|n| n.attribute("d")).expect("an outline");
    let (mut xs, mut ys) = (Vec::new(), Vec::new());
    for (at, letter) in path.match_indices(char::is_alphabetic) {
        let rest = &path[at + 1..];
        let end = rest.find(char::is_alphabetic).unwrap_or(rest.len());
        let numbers: Vec<f64> = rest[..end].split_whitespace().map(|n| n.parse().expect("a number")).collect();
        match letter {
            "H" => xs.extend(numbers),
            "V" => ys.extend(numbers),
            _ => numbers.chunks_exact(2).for_each(|pair| {
                xs.push(pair[0]);
                ys.push(pair[1]);
            }),
        }
    }
    [xs, ys]
        .map(|values| values.iter().fold(f64::MIN, |a, b| a.max(*b)) - values.iter().fold(f64::MAX, |a, b| a.min(*b)))
}

#[test]
fn a_size_makes_the_picture() {
    let bench = Bench::garden();
    let pixels = |file: &str| {
        let bytes = bench.bytes(file);
        [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
    };
    bench.bosquet("derive garden --size 640x480 -o a.png").ends(0);
    assert_eq!(pixels("a.png"), [640, 480]);
    bench.bosquet("derive garden --size 0.1m --scale 200 -o b.png").ends(0);
    bench.bosquet("derive garden --size 0.2m --scale 200 -o c.png").ends(0);
    let ([b, _], [c, _]) = (pixels("b.png"), pixels("c.png"));
    assert!(b.abs_diff(2 * c) <= 2, "half the metres, twice the pixels: {b}, {c}");
}
