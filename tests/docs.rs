//! What the documentation shows holds: every fenced `cga` block of the README and of `docs/` is checked.
//!
//! A block fenced as `cga,broken` must have an error, any other must have none; lints are fine. A block whose first
//! line is `// name.cga` is the file of that name, which the other blocks of the page may import.

use bosquet::check::check;
use bosquet::world::MemoryWorld;
use std::path::{Path, PathBuf};

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
    let mut blocks = Vec::new();
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let Some(fence) = line.strip_prefix("```") else { continue };
        let inside: Vec<&str> = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != "```").collect();
        if fence == "cga" || fence == "cga,broken" {
            let named = inside.first().and_then(|line| line.strip_prefix("// ")).filter(|name| name.ends_with(".cga"));
            let path = named.map_or_else(|| format!("line-{}.cga", number + 1), str::to_owned);
            blocks.push(Block { path, text: inside.join("\n"), broken: fence == "cga,broken" });
        }
    }
    blocks
}
