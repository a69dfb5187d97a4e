//! The language server as editors meet it: real messages, piped to the built command.

mod client;

use client::Client;
use serde_json::{Value, json};

const PLANTS: &str =
    "// A row of trees.\nRow(spacing) --> split(x) { ~spacing : Trunk }*\nTrunk --> Lawn\nattr width = 3\n";
const GARDEN: &str = "import plants : \"plants.cga\"\nattr width = 4\nLot --> plants.Row(width)\n";

fn labels(items: &Value) -> Vec<&str> {
    items.as_array().expect("a list").iter().map(|item| item["label"].as_str().expect("a label")).collect()
}

/// Line, first and last character of a range.
fn stretch(range: &Value) -> (u64, u64, u64) {
    let number = |value: &Value| value.as_u64().expect("a number");
    assert_eq!(range["start"]["line"], range["end"]["line"]);
    (number(&range["start"]["line"]), number(&range["start"]["character"]), number(&range["end"]["character"]))
}

#[test]
fn a_session_begins_and_ends() {
    let mut client = Client::start(&[]);
    assert_eq!(client.refused("textDocument/hover", json!({}))["code"], -32002);
    let begun = client.ask("initialize", json!({ "processId": null, "capabilities": {} }));
    assert_eq!(begun["serverInfo"]["name"], "bosquet");
    assert_eq!(begun["capabilities"]["textDocumentSync"]["change"], 2);
    assert_eq!(client.refused("no/such", json!({}))["code"], -32601);
    assert_eq!(client.ends(&["shutdown", "exit"]), 0);
    assert_eq!(Client::new(&[]).ends(&["exit"]), 1, "an end without shutdown is a failure");
    assert_eq!(Client::new(&[]).ends(&[]), 1, "so is an editor that goes away");
}

#[test]
fn an_error_is_told_and_taken_back() {
    let mut client = Client::new(&[]);
    let told = client.open("a.cga", "Lot --> extrud(3) Hall.\n");
    assert_eq!(told.len(), 1);
    assert_eq!(stretch(&told[0]["range"]), (0, 8, 14));
    assert_eq!((&told[0]["severity"], &told[0]["code"]), (&json!(1), &json!("unknown-name")));
    assert!(told[0]["message"].as_str().is_some_and(|m| m.contains("did you mean `extrude`?")));
    let range = json!({ "start": { "line": 0, "character": 14 }, "end": { "line": 0, "character": 14 } });
    client.change("a.cga", json!([{ "range": range, "text": "e" }]));
    assert_eq!(client.diagnostics("a.cga"), Vec::<Value>::new());
}

#[test]
fn open_buffers_go_before_the_disk() {
    let mut client = Client::new(&[("plants.cga", PLANTS)]);
    assert_eq!(client.open("garden.cga", GARDEN), Vec::<Value>::new());
    client.open("plants.cga", "Row --> Lawn\n");
    let told = client.diagnostics("garden.cga");
    assert!(told[0]["message"].as_str().is_some_and(|m| m.contains("Row")), "{told:?}");
    let uri = client.uri("plants.cga");
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    assert_eq!(client.diagnostics("garden.cga"), Vec::<Value>::new());
}

#[test]
fn mistakes_in_an_import_are_told_there() {
    let mut client = Client::new(&[("plants.cga", "Row --> extrud(1) X.\n")]);
    client.open("garden.cga", "import plants : \"plants.cga\"\nLot --> plants.Row\n");
    assert_eq!(stretch(&client.diagnostics("plants.cga")[0]["range"]), (0, 8, 14));
}

#[test]
fn columns_count_utf_16_units() {
    let mut client = Client::new(&[]);
    let told = client.open("a.cga", "/* é🌳 */ Lot --> extrud(3) X.\r\n// 🌳\rB --> extrud(3) X.");
    assert_eq!(stretch(&told[0]["range"]), (0, 18, 24), "é is one unit, the tree two");
    assert_eq!(stretch(&told[1]["range"]), (2, 6, 12), "a lone \\r ends a line");
    let range = json!({ "start": { "line": 0, "character": 4 }, "end": { "line": 0, "character": 24 } });
    client.change("a.cga", json!([{ "range": range, "text": "🌳é🌳 */ Lot --> extrude" }]));
    let told = client.diagnostics("a.cga");
    assert_eq!((told.len(), stretch(&told[0]["range"])), (1, (2, 6, 12)), "{told:?}");
}

#[test]
fn hovers_show_the_manual_comments_and_the_catalogue() {
    let mut client = Client::new(&[("plants.cga", PLANTS), ("docs/manual/images/split.png", "png")]);
    client.open(
        "garden.cga",
        "import plants : \"plants.cga\"\nLot --> plants.Row(2)\nB --> split(x) { ~1 : I(birch, adult) }\n",
    );
    let text = |hover: Value| hover["contents"]["value"].as_str().expect("Markdown").to_string();
    let split = text(client.at("hover", "garden.cga", 2, 8));
    assert!(split.contains("split(axis") && split.contains("![split](file:///"), "{split}");
    let row = client.at("hover", "garden.cga", 1, 16);
    assert_eq!(stretch(&row["range"]), (1, 15, 18));
    let row = text(row);
    assert!(row.contains("Row(spacing) -->") && row.contains("A row of trees."), "{row}");
    let birch = text(client.at("hover", "garden.cga", 2, 25));
    assert!(birch.contains("Betula") && birch.contains("adult"), "{birch}");
    assert!(client.at("hover", "garden.cga", 2, 16).is_null());
}

#[test]
fn the_catalogue_of_the_place_is_known() {
    let oak = "[plant.ilex]\ncategory = \"holm\"\nkind = \"tree\"\nspecies = \"Quercus ilex\"\n\
        types.evergreen = { age = 60, height = 15, crown_radius = 6 }\n";
    let manifest = "layout = \"a.geojson\"\nrules = \"rules/a.cga\"\ncatalogues = [\"own.toml\"]\n";
    let mut client = Client::new(&[("bosquet.toml", manifest), ("own.toml", oak)]);
    client.open("rules/a.cga", "Lot --> I(\"holm\", evergreen)\nB --> I(holm, ");
    let hover = client.at("hover", "rules/a.cga", 0, 13);
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.contains("Quercus ilex")), "{hover}");
    assert!(labels(&client.at("completion", "rules/a.cga", 1, 14)).contains(&"evergreen"));
}

#[test]
fn completions_work_while_the_rule_is_broken() {
    let mut client = Client::new(&[("plants.cga", PLANTS)]);
    client.open("garden.cga", "import plants : \"plants.cga\"\nLot --> spl\nB --> split(\nC --> plants.\n");
    let steps = client.at("completion", "garden.cga", 1, 11);
    let split = steps.as_array().expect("a list").iter().find(|item| item["label"] == "split").expect("split");
    assert_eq!(stretch(&split["textEdit"]["range"]), (1, 8, 11));
    assert!(split["textEdit"]["newText"].as_str().is_some_and(|text| text.starts_with("split(${1|x,y,z")), "{split}");
    assert!(labels(&steps).contains(&"Lot"));
    let arguments = client.at("completion", "garden.cga", 2, 12);
    assert!(labels(&arguments).contains(&"x") && labels(&arguments).contains(&"axis ="), "{:?}", labels(&arguments));
    let imported = client.at("completion", "garden.cga", 3, 13);
    let row = imported.as_array().expect("a list").iter().find(|item| item["label"] == "plants.Row").expect("a rule");
    assert_eq!(stretch(&row["textEdit"]["range"]), (3, 6, 13));
}

#[test]
fn signatures_follow_the_cursor() {
    let mut client = Client::new(&[]);
    client.open("a.cga", "Bed(area, depth) --> Lawn\nLot --> boundary(width = 4, radius = \nB --> Bed(1, \n");
    let known = client.at("signatureHelp", "a.cga", 1, 37);
    let signature = &known["signatures"][0];
    let param = &signature["parameters"][known["activeParameter"].as_u64().expect("a number") as usize]["label"];
    let label = signature["label"].as_str().expect("a label");
    let (start, end) = (param[0].as_u64().expect("a number"), param[1].as_u64().expect("a number"));
    assert_eq!(&label[start as usize..end as usize], "radius");
    let own = client.at("signatureHelp", "a.cga", 2, 13);
    assert_eq!((&own["signatures"][0]["label"], &own["activeParameter"]), (&json!("Bed(area, depth)"), &json!(1)));
}

#[test]
fn definitions_are_found_across_files_and_in_the_library() {
    let mut client = Client::new(&[("plants.cga", PLANTS)]);
    client
        .open("garden.cga", &format!("{GARDEN}import edge : \"bosquet:patterns/boundary.cga\"\nB --> edge.Planting\n"));
    let found = client.at("definition", "garden.cga", 2, 16);
    assert_eq!(found[0]["uri"], client.uri("plants.cga"));
    assert_eq!(stretch(&found[0]["range"]), (1, 0, 3));
    let path = client.at("definition", "garden.cga", 0, 20);
    assert_eq!(path[0]["uri"], client.uri("plants.cga"));
    let library = client.at("definition", "garden.cga", 4, 12);
    let uri = library[0]["uri"].as_str().expect("a URI").strip_prefix("file://").expect("a file").to_string();
    assert!(std::fs::read_to_string(&uri).is_ok_and(|text| text.contains("Planting")), "{uri}");
}

#[test]
fn renaming_reaches_every_file_and_refuses_clashes() {
    let mut client = Client::new(&[("plants.cga", PLANTS), ("garden.cga", GARDEN)]);
    client.open("plants.cga", PLANTS);
    let rename = |client: &mut Client, line: u32, character: u32, name: &str| {
        let position = json!({ "line": line, "character": character });
        json!({ "textDocument": { "uri": client.uri("plants.cga") }, "position": position, "newName": name })
    };
    let params = rename(&mut client, 1, 1, "Avenue");
    let renamed = client.ask("textDocument/rename", params);
    let (plants, garden) = (client.uri("plants.cga"), client.uri("garden.cga"));
    assert_eq!(stretch(&renamed["changes"][&plants][0]["range"]), (1, 0, 3));
    assert_eq!(stretch(&renamed["changes"][&garden][0]["range"]), (2, 15, 18));
    let params = rename(&mut client, 3, 6, "breadth");
    let renamed = client.ask("textDocument/rename", params);
    assert_eq!(renamed["changes"][&garden].as_array().map(Vec::len), Some(2), "one attribute in two files");
    for (name, reason) in [("Trunk", "already"), ("split", "operation"), ("1x", "no name")] {
        let params = rename(&mut client, 1, 1, name);
        let refusal = client.refused("textDocument/rename", params);
        assert!(refusal["message"].as_str().is_some_and(|message| message.contains(reason)), "{refusal}");
    }
    let position = json!({ "line": 1, "character": 19 });
    let params = json!({ "textDocument": { "uri": plants }, "position": position });
    assert!(
        client.refused("textDocument/prepareRename", params)["message"]
            .as_str()
            .is_some_and(|m| m.contains("built in"))
    );
}

#[test]
fn uses_are_found_in_files_that_are_not_open() {
    let mut client = Client::new(&[("plants.cga", PLANTS), ("garden.cga", GARDEN)]);
    client.open("plants.cga", PLANTS);
    let params = |declared: bool| {
        json!({ "textDocument": { "uri": client.uri("plants.cga") }, "position": { "line": 1, "character": 1 },
                "context": { "includeDeclaration": declared } })
    };
    let (all, uses) = (params(true), params(false));
    assert_eq!(client.ask("textDocument/references", all).as_array().map(Vec::len), Some(2));
    let uses = client.ask("textDocument/references", uses);
    assert_eq!((uses.as_array().map(Vec::len), &uses[0]["uri"]), (Some(1), &json!(client.uri("garden.cga"))));
}

#[test]
fn outlines_and_folds_survive_a_broken_rule() {
    let mut client = Client::new(&[]);
    client.open("a.cga", "@Hidden\nattr a = 1\nLot --> split(x) {\n  1 : A\n\nf(x) = x\n// one\n// two\nB --> Lawn\n");
    let symbols = client.about("documentSymbol", "a.cga");
    let names: Vec<&Value> = symbols.as_array().expect("a list").iter().map(|symbol| &symbol["name"]).collect();
    assert_eq!(names, ["a", "Lot", "f", "B"]);
    assert_eq!(symbols[0]["range"]["start"]["line"], 0, "annotations belong to their definition");
    let folds = client.about("foldingRange", "a.cga");
    let has = |start: u32, kind: &str| {
        folds.as_array().expect("a list").iter().any(|f| f["startLine"] == start && f["kind"] == kind)
    };
    assert!(has(2, "region") && has(6, "comment"), "{folds}");
}

#[test]
fn colours_are_shown_and_written() {
    let mut client = Client::new(&[]);
    client.open("a.cga", "Lot --> color(\"#ff000080\") Slab.\nB --> Lawn\n");
    let colors = client.about("documentColor", "a.cga");
    assert_eq!(stretch(&colors[0]["range"]), (0, 14, 25));
    assert_eq!((&colors[0]["color"]["red"], colors.as_array().map(Vec::len)), (&json!(1.0), Some(2)));
    let written = |client: &mut Client, index: usize| {
        let uri = client.uri("a.cga");
        let color = json!({ "red": 0.0, "green": 1.0, "blue": 0.0, "alpha": 1.0 });
        let params = json!({ "textDocument": { "uri": uri }, "color": color, "range": colors[index]["range"] });
        client.ask("textDocument/colorPresentation", params)
    };
    assert_eq!(written(&mut client, 0)[0]["label"], "\"#00ff00\"");
    assert_eq!(written(&mut client, 1), json!([]), "a cover's name is no colour");
}

#[test]
fn files_are_laid_out_and_broken_ones_left_alone() {
    let mut client = Client::new(&[]);
    client.open("a.cga", "Lot-->split( x ){1:A.|~2:Lawn}\n");
    let edits = client.about("formatting", "a.cga");
    let laid_out = edits[0]["newText"].as_str().expect("a text").to_string();
    assert!(laid_out.starts_with("Lot -->") && laid_out.ends_with('\n'), "{laid_out}");
    let everything = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 1, "character": 0 } });
    assert_eq!(edits[0]["range"], everything);
    client.open("b.cga", &laid_out);
    assert_eq!(client.about("formatting", "b.cga"), json!([]), "nothing is left to do");
    client.open("c.cga", "Lot --> split(x) {");
    assert!(client.about("formatting", "c.cga").is_null());
}

#[test]
fn names_are_coloured_by_what_they_mean() {
    let mut client = Client::new(&[]);
    client.open("a.cga", "attr w = 1\nLot --> extrude(w) Hall\nHall --> Lawn\n");
    let data = client.about("semanticTokens/full", "a.cga")["data"].clone();
    let numbers: Vec<u64> = data.as_array().expect("a list").iter().map(|n| n.as_u64().expect("a number")).collect();
    let types: Vec<u64> = numbers.chunks(5).map(|token| token[3]).collect();
    assert_eq!(types, [3, 1, 0, 3, 1, 1, 1], "attribute, rule, operation, attribute, rule, rule, leaf");
    assert_eq!(numbers[..10], [0, 5, 1, 3, 1, 1, 0, 3, 1, 1]);
}

#[test]
fn malformed_messages_are_answered_and_survived() {
    let mut client = Client::new(&[]);
    client.raw(b"Content-Length: 9\r\n\r\n{\"broken\"");
    assert_eq!(client.receive()["error"]["code"], -32700);
    client.raw(b"Content-Length: 2\r\n\r\n{}");
    assert_eq!(client.receive()["error"]["code"], -32600);
    client.raw(b"Nonsense\r\n\r\n");
    assert_eq!(client.receive()["error"]["code"], -32700);
    client.raw(b"Content-Length: 3\r\n\r\n\xff\xfe\xfd");
    assert_eq!(client.receive()["error"]["code"], -32700);
    assert_eq!(client.refused("textDocument/hover", json!({ "position": 3 }))["code"], -32602);
    client.tell("textDocument/didChange", json!({ "nothing": true }));
    let far = json!({ "line": 4_000_000_000u32, "character": 4_000_000_000u32 });
    let hover = json!({ "textDocument": { "uri": "untitled:Untitled-1" }, "position": far });
    assert!(client.ask("textDocument/hover", hover).is_null());
    assert_eq!(client.ends(&["shutdown", "exit"]), 0);
}

#[test]
fn what_was_cancelled_is_not_worked_on() {
    let mut client = Client::new(&[]);
    let request = json!({ "jsonrpc": "2.0", "id": "x", "method": "textDocument/foldingRange", "params": {
        "textDocument": { "uri": client.uri("a.cga") } } });
    let cancel = json!({ "jsonrpc": "2.0", "method": "$/cancelRequest", "params": { "id": "x" } });
    let frames: String = [request, cancel]
        .map(|message| message.to_string())
        .map(|text| format!("Content-Length: {}\r\n\r\n{text}", text.len()))
        .concat();
    client.raw(frames.as_bytes());
    let answer = client.receive();
    assert_eq!(answer["id"], "x");
    // The reader may be slower than the answer: then the answer has come, which the protocol allows.
    assert!(answer["error"]["code"] == -32800 || answer["result"].is_array(), "{answer}");
    assert!(client.at("hover", "a.cga", 0, 0).is_null());
}
