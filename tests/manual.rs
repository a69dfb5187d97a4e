//! The manual is what the declarations say, and its pictures are what the examples give; every step of the tutorial
//! derives cleanly, and its page shows the files' own text. `UPDATE_MANUAL=1 cargo test --test manual` writes anew.

use bosquet::check::check;
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::layout::read_geojson;
use bosquet::manual::{Chapter, PARTS, Sheet, draw, others, pages, part_of, pictures};
use bosquet::ops::OPERATIONS;
use bosquet::seed::Seed;
use bosquet::world::MemoryWorld;
use std::path::{Path, PathBuf};

/// Steps of the tutorial.
const STEPS: usize = 10;

/// What the pictures of the steps show, metres.
const EXTENT: [f64; 4] = [-11.0, -10.0, 73.0, 67.0];

/// The most that a picture may weigh, bytes: a page of the manual loads at once.
const HEAVIEST: usize = 45_000;

fn manual() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/manual")
}

fn text(path: &str) -> String {
    std::fs::read_to_string(manual().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn pages_and_pictures_are_what_is_committed() {
    let mut chapters = pages();
    chapters.extend(pictures().expect("examples that derive"));
    chapters.extend((1..=STEPS).map(picture));
    assert_eq!(different(&chapters), Vec::<String>::new(), "`UPDATE_MANUAL=1 cargo test --test manual` writes them");
}

#[test]
fn pictures_are_light() {
    let heavy: Vec<String> =
        pictures().expect("examples").into_iter().filter(|p| p.bytes.len() > HEAVIEST).map(|p| p.path).collect();
    assert!(heavy.is_empty(), "{heavy:?}");
}

#[test]
fn every_operation_stands_in_one_part() {
    let named: Vec<&str> = PARTS.iter().flat_map(|part| part.names().iter().copied()).collect();
    for (place, name) in named.iter().enumerate() {
        assert!(OPERATIONS.iter().any(|o| o.spec.name == *name), "there is no operation `{name}`");
        assert!(!named[..place].contains(name), "`{name}` stands in two parts");
    }
    let others: Vec<&str> = others().map(|spec| spec.name).collect();
    let lost = |name: &&str| !named.contains(name) && !others.contains(name);
    let lost: Vec<&str> = OPERATIONS.iter().map(|o| o.spec.name).filter(lost).collect();
    assert!(lost.is_empty(), "no part of the manual has {lost:?}");
    assert!(OPERATIONS.iter().any(|o| part_of(o.spec).is_some()));
}

#[test]
fn every_step_of_the_tutorial_derives_without_a_word() {
    let (layout, found) = read_geojson("square.geojson", text("tutorial/square.geojson").as_bytes());
    assert!(found.is_empty(), "{found:?}");
    for step in 1..=STEPS {
        let world = MemoryWorld::default().with("step.cga", rules(step));
        let (program, found) = check(&world, "step.cga");
        assert!(found.is_empty(), "step {step}: {found:?}");
        let options = Options {
            start: None,
            seed: Seed(1),
            set: Vec::new(),
            catalogue: Catalogue::built_in(),
            world: &world,
            limits: Limits::default(),
        };
        let (derivation, found) = derive(&program, &layout, &options, &Progress::default());
        assert!(found.is_empty(), "step {step}: {found:?}");
        assert_eq!(derivation.lots.len(), 2, "step {step}: the square and the street");
    }
}

#[test]
fn the_tutorial_shows_its_files_and_pictures() {
    let page = text("tutorial.md");
    for step in 1..=STEPS {
        assert!(page.contains(&format!("```cga\n{}```\n", rules(step))), "tutorial.md lacks {}", path(step));
        assert!(page.contains(&format!("](images/tutorial-{step:02}.png)")), "step {step} has no picture");
    }
}

fn path(step: usize) -> String {
    format!("tutorial/{step:02}.cga")
}

fn rules(step: usize) -> String {
    text(&path(step))
}

/// The plan after a step; the last one with its legend.
fn picture(step: usize) -> Chapter {
    let layout = text("tutorial/square.geojson");
    let sheet = if step == STEPS { Sheet::whole(&layout) } else { Sheet::part(&layout, EXTENT) };
    let bytes = draw(&rules(step), &sheet).unwrap_or_else(|problem| panic!("step {step}: {problem}"));
    Chapter { path: format!("images/tutorial-{step:02}.png"), bytes }
}

/// The files that are not as they should be; written anew where that is wanted.
fn different(chapters: &[Chapter]) -> Vec<String> {
    let mut paths = Vec::new();
    for chapter in chapters {
        let path = manual().join(&chapter.path);
        if std::env::var_os("UPDATE_MANUAL").is_some() {
            std::fs::create_dir_all(path.parent().unwrap_or(&path)).expect("a folder");
            std::fs::write(&path, &chapter.bytes).expect("a writable manual");
        } else if std::fs::read(&path).ok().as_deref() != Some(chapter.bytes.as_slice()) {
            paths.push(chapter.path.clone());
        }
    }
    paths
}
