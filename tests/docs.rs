//! What the documentation shows holds: every fenced `cga` block of the README and of `docs/` is checked, the place of
//! `docs/place.md` derives, and its lists have everything there is.
//!
//! A block fenced as `cga,broken` must have an error, any other must have none; lints are fine. A block whose first
//! line is `// name.cga` is the file of that name, which the other blocks of the page may import.

use bosquet::check::check;
use bosquet::export::plants::FIELDS;
use bosquet::world::MemoryWorld;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A block: the file it stands for, its text, and whether it is meant to be wrong.
struct Block {
    path: String,
    text: String,
    broken: bool,
}

#[test]
fn rules_in_the_documentation_are_what_they_claim() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for page in pages() {
        let text = std::fs::read_to_string(&page).expect("a page of text");
        let blocks = blocks(&text);
        let world = blocks.iter().fold(MemoryWorld::default(), |world, block| world.with(&block.path, &block.text));
        count += blocks.len();
        for block in &blocks {
            let (_, found) = check(&world, &block.path);
            let errors: Vec<&str> = found.iter().filter(|d| d.is_error()).map(|d| &*d.message).collect();
            if errors.is_empty() == block.broken {
                wrong.push(format!("{}, {}: {errors:?}\n{}", page.display(), block.path, block.text));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 0, "no page has a block of rules");
}

/// The rules that the manifest of the page is for.
const RULES: &str = "import plants : \"plants.cga\"\nattr hedge_height = 1\n\
    Lot --> split(x) { ~1 : Seat | ~1 : CrushedTile. | ~1 : plants.Row }\nSeat --> I(seat, oak)\n";
const PLANTS: &str = "attr spacing = 4\nRow --> split(x) { ~spacing : I(oak, evergreen, rand(3)) }*\n";
const LAYOUT: &str = r#"{"type": "Feature", "crs": "local", "properties": {"kind": "lot"}, "geometry":
    {"type": "Polygon", "coordinates": [[[0, 0], [40, 0], [40, 20], [0, 20], [0, 0]]]}}"#;
const SEAT: &str = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0.5\nf 1 2 3 4\n";

#[test]
fn manifest_and_catalogue_of_the_documentation_derive() {
    let page = page("place.md");
    let blocks = fenced(&page);
    let toml = |with: &str| {
        let block = blocks.iter().find(|(_, fence, text)| *fence == "toml" && text.contains(with));
        block.map(|(_, _, text)| text.as_str()).expect("a block of that sort")
    };
    let folder = tempfile::tempdir().expect("a folder");
    let models = folder.path().join("models");
    std::fs::create_dir(&models).expect("a folder of models");
    std::fs::write(models.join("seat.obj"), SEAT).expect("a model");
    let (manifest, catalogue) = (toml("layout ="), toml("[plant."));
    let files = [("bosquet.toml", manifest), ("own.toml", catalogue), ("garden.geojson", LAYOUT)];
    for (name, text) in files.into_iter().chain([("garden.cga", RULES), ("plants.cga", PLANTS)]) {
        std::fs::write(folder.path().join(name), text).expect("a file");
    }
    let ran = bosquet(&["derive", "."], folder.path());
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    let plants = std::fs::read_to_string(folder.path().join("trees.csv")).expect("the second output");
    assert!(plants.contains("Quercus ilex"), "{plants}");
}

#[test]
fn the_record_of_a_plant_is_listed_whole() {
    let page = page("place.md");
    let rows: Vec<String> = FIELDS.iter().map(|field| format!("| `{}` | {} |\n", field.name, field.doc)).collect();
    assert!(page.contains(&rows.concat()), "docs/place.md lacks\n{}", rows.concat());
}

#[test]
fn every_option_and_limit_is_listed() {
    let (place, architecture) = (page("place.md"), page("architecture.md"));
    let ran = bosquet(&["derive", "--help"], Path::new("."));
    let help = String::from_utf8(ran.stdout).expect("text");
    let options: Vec<&str> = help.lines().filter_map(|line| line.split("--").nth(1)).collect();
    assert!(options.len() > 10, "{help}");
    for option in options {
        let name = option.split_whitespace().next().unwrap_or_default();
        let listed = place.contains(&format!("--{name}")) || ["help", "output"].contains(&name);
        assert!(listed, "docs/place.md says nothing of `--{name}`");
        if let Some((_, default)) = option.split_once("[default: ").filter(|_| name.starts_with("limit-")) {
            let row = format!("| `--{name}` | {}", default.trim_end_matches(']'));
            assert!(architecture.contains(&row), "docs/architecture.md lacks {row}");
        }
    }
}

fn bosquet(arguments: &[&str], folder: &Path) -> Output {
    let command = Command::new(env!("CARGO_BIN_EXE_bosquet")).args(arguments).current_dir(folder).output();
    command.expect("the command runs")
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(name);
    std::fs::read_to_string(path).expect("a page of text")
}

/// The README and every page of `docs/`, by name.
fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(root.join("docs")).expect("the folder of the documentation");
    let mut pages: Vec<PathBuf> = entries.map(|entry| entry.expect("a readable folder").path()).collect();
    pages.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    pages.push(root.join("README.md"));
    pages.sort();
    pages
}

/// The fenced blocks of rules on a page.
fn blocks(page: &str) -> Vec<Block> {
    let rules = fenced(page).into_iter().filter(|(_, fence, _)| ["cga", "cga,broken"].contains(fence));
    let block = |(line, fence, text): (usize, &str, String)| {
        let named = text.lines().next().and_then(|first| first.strip_prefix("// "));
        let path =
            named.filter(|name| name.ends_with(".cga")).map_or_else(|| format!("line-{line}.cga"), str::to_owned);
        Block { path, text, broken: fence == "cga,broken" }
    };
    rules.map(block).collect()
}

/// Every fenced block of a page: its line, what stands behind the fence, its text.
fn fenced(page: &str) -> Vec<(usize, &str, String)> {
    let mut blocks = Vec::new();
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let Some(fence) = line.strip_prefix("```") else { continue };
        let inside: Vec<&str> = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != "```").collect();
        blocks.push((number + 1, fence, inside.join("\n")));
    }
    blocks
}
