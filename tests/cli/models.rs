//! The user's own elements: catalogues with `.obj` and `.glb` models.

use crate::bench::Bench;
use serde_json::json;

const CATALOGUE: &str = r##"
[object.oak-seat]
category = "seat"
kind = "furniture"
label = "Oak seat"
color = "#a07040"
types.long = { model = "models/seat.obj" }

[object.boulder]
kind = "furniture"
label = "Boulder"
types.big = { model = "models/rock.glb" }

[plant.home-pear]
category = "pear"
species = "Pyrus communis 'Home'"
common_name = "Home pear"
code = "HOP"
types.adult = { age = 30, height = 7, crown_radius = 2.25 }

[cover.moss]
label = "Moss"
fill = "#7f8f4f"
"##;

const RULES: &str = "Lot -->
    [ t(2, 0, 2) s(0, 0, 0) I(seat, long, 1) ]
    [ t(8, 0, 2) s(0, 0, 0) I(boulder, big, 1) ]
    [ t(8, 0, 8) s(0, 0, 0) I(pear, adult, 1) ]
    Moss";

/// 2 m wide, 0.9 m high, 0.6 m deep.
const SEAT: &str = "v 0 0 0\nv 2 0 0\nv 2 0.9 0\nv 0 0.9 0.6\nf 1 2 3\nf 1 3 4\n";

/// A triangle of 1 × 2 × 3 m that its node scales to twice that, as the bytes of a `.glb` file.
fn glb() -> Vec<u8> {
    let points = [[0.0f32, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
    let binary: Vec<u8> = points.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    let document = json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 2, 3]}],
        "bufferViews": [{"buffer": 0, "byteLength": binary.len()}],
        "buffers": [{"byteLength": binary.len()}],
    });
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |n: usize| (n as u32).to_le_bytes();
    let total = 12 + 8 + text.len() + 8 + binary.len();
    [
        b"glTF".as_slice(),
        &length(2),
        &length(total),
        &length(text.len()),
        b"JSON",
        &text,
        &length(binary.len()),
        b"BIN\0",
        &binary,
    ]
    .concat()
}

pub fn bench() -> Bench {
    let bench = Bench::two_lots(RULES).with("more.toml", CATALOGUE);
    bench.with("models/seat.obj", SEAT).with("models/rock.glb", glb())
}

#[test]
fn models_have_the_size_of_their_bounds_and_are_drawn_and_counted() {
    let bench = bench();
    bench.derive_two("--catalogue more.toml -o a.svg -o a.csv -o a.json -o plants:p.csv").ends(0);
    let schedule = bench.text("a.csv");
    for row in ["oak-seat,Oak seat,seat,long,2", "boulder,Boulder,boulder,big,2", "moss,Moss,2,"] {
        assert!(schedule.contains(row), "{row} in {schedule}");
    }
    let svg = bench.text("a.svg");
    assert!(svg.contains("Oak seat") && svg.contains("Boulder") && svg.contains("Home pear"));
    assert!(bench.text("p.csv").contains("Pyrus communis 'Home',Home pear,HOP,2.25,2.25,30,7,"));
    let summary = bench.json("a.json")["summary"].clone();
    assert_eq!((&summary["objects"], &summary["plants"]), (&json!(4), &json!(3)));
    let inputs = bench.json("a.json")["inputs"].to_string();
    assert!(inputs.contains("models/seat.obj") && inputs.contains("models/rock.glb"), "{inputs}");
}

#[test]
fn rules_see_the_size_of_models() {
    let rules = |name: &str| {
        format!(
            "Lot --> s(0, 0, 0) I({name}) Seen\nSeen --> report(\"x\", scope.sx) report(\"y\", scope.sy) report(\"z\", scope.sz)"
        )
    };
    for (name, size) in [("seat, long, 1", [2.0, 0.9, 0.6]), ("boulder, big, 1", [2.0, 4.0, 6.0])] {
        let bench = bench().with("rules.cga", rules(name));
        bench.derive_two("--catalogue more.toml -o a.json --start Lot").ends(0);
        let reports = bench.json("a.json")["reports"].clone();
        for (axis, wanted) in size.iter().enumerate() {
            let found = reports[axis]["max"].as_f64().expect("a number");
            assert!((found - wanted).abs() < 1e-6, "{name}: {reports}");
        }
    }
}

#[test]
fn broken_models_and_entries_are_told_and_the_rest_is_drawn() {
    let half = &glb()[..60];
    let bench = bench().with("models/rock.glb", half);
    bench.derive_two("--catalogue more.toml -o a.svg").ends(1).says(&["models/rock.glb", "more.toml:", "wrote a.svg"]);
    let bench = bench.with(
        "more.toml",
        CATALOGUE.replace("height = 7", "height = 'tall'").replace("label = \"Moss\"", "labl = \"Moss\""),
    );
    let ran = bench.derive_two("--catalogue more.toml -o a.svg").ends(1);
    ran.says(&["`height` must be a number", "there is no key `labl`", "did you mean `label`?"]);
    bench.derive_two("--catalogue gone.toml -o a.svg").ends(1).says(&["there is no file `gone.toml`"]);
}
