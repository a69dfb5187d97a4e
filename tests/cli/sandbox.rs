//! What rules and catalogues may read: the place's folder, the folders of files named on the command line, and
//! everything where the user allows it.

use crate::bench::Bench;

const IMPORTING: &str = "import x : \"PATH\"\nLot --> x.Foo";

/// A place whose rules import `path`, with a file to import beside the place.
fn place(path: &str) -> Bench {
    let rules = IMPORTING.replace("PATH", path);
    Bench::garden().with("garden/garden.cga", rules).with("beside/x.cga", "Foo --> Lawn")
}

fn is_refused_unless_allowed(bench: &Bench) {
    let ran = bench.bosquet("derive garden -o a.svg").ends(1);
    ran.says(&["lies outside the place's folder", "garden/garden.cga:1:12", "nothing is written"]);
    bench.bosquet("check garden/garden.cga").ends(1).says(&["lies outside"]);
    bench.bosquet("derive garden -o a.svg --allow-outside").ends(0);
    bench.bosquet("check garden/garden.cga --allow-outside").ends(0);
}

#[test]
fn imports_stay_in_the_folder() {
    is_refused_unless_allowed(&place("../beside/x.cga"));
    is_refused_unless_allowed(&place("sub/../../beside/x.cga"));
    let bench = place("");
    let absolute = bench.path("beside/x.cga").to_string_lossy().replace('\\', "/");
    is_refused_unless_allowed(&bench.with("garden/garden.cga", IMPORTING.replace("PATH", &absolute)));
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_out() {
    let bench = place("link.cga");
    std::os::unix::fs::symlink(bench.path("beside/x.cga"), bench.path("garden/link.cga")).expect("a link");
    is_refused_unless_allowed(&bench);
    let bench = place("link/x.cga");
    std::os::unix::fs::symlink(bench.path("beside"), bench.path("garden/link")).expect("a link");
    is_refused_unless_allowed(&bench);
}

#[test]
fn imports_inside_the_folder_may_go_up_and_down() {
    let bench = place("sub/y.cga").with("garden/sub/y.cga", "import z : \"../z.cga\"\nFoo --> z.Foo");
    bench.with("garden/z.cga", "Foo --> Lawn").bosquet("derive garden -o a.svg").ends(0);
}

#[test]
fn a_manifest_cannot_open_other_folders() {
    let bench = place("").with("garden/bosquet.toml", "layout = 'lot.geojson'\nrules = '../beside/x.cga'");
    bench.bosquet("derive garden").ends(1).says(&["`garden/../beside/x.cga` lies outside"]);
    let manifest = "layout = 'lot.geojson'\nrules = 'garden.cga'\ncatalogues = ['../beside/more.toml']";
    let bench = Bench::garden().with("garden/bosquet.toml", manifest).with("beside/more.toml", "");
    bench.bosquet("derive garden -o a.svg").ends(1).says(&["lies outside"]);
}

#[test]
fn files_named_on_the_command_line_open_their_folders() {
    let rules = "import x : \"x.cga\"\nLot --> x.Foo";
    let bench = place("").with("beside/main.cga", rules).with("more/more.toml", "[cover.moss]\nfill = '#aabbcc'");
    bench.bosquet("derive garden --rules beside/main.cga --catalogue more/more.toml -o a.svg").ends(0);
}

#[test]
fn models_stay_in_the_folder() {
    let catalogue = "[object.seat]\nkind = 'furniture'\nmodel = '../seat.obj'\ntypes.long = {}";
    let manifest = "layout = 'lot.geojson'\nrules = 'garden.cga'\ncatalogues = ['c.toml']";
    let bench = Bench::garden().with("garden/bosquet.toml", manifest).with("garden/c.toml", catalogue);
    let bench = bench.with("seat.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n");
    bench.bosquet("derive garden -o a.svg").ends(1).says(&["`seat.obj` lies outside", "garden/c.toml:"]);
    bench.bosquet("derive garden -o a.svg --allow-outside").ends(0);
}

#[test]
fn tables_and_searches_stay_in_the_folder() {
    let rules = "Lot --> print(\"there: \" + fileExists(\"../beside/oaks.csv\")) print(fileSearch(\"*.csv\")) Rows\n\
                 Rows --> report(rows, nRows(readStringTable(\"../beside/oaks.csv\"))) Lawn";
    let bench = Bench::garden().with("garden/garden.cga", rules).with("beside/oaks.csv", "a,b\n");
    let bench = bench.with("garden/data/elms.csv", "a,b\n");
    let ran = bench.bosquet("derive garden -o a.svg").says(&["`beside/oaks.csv` lies outside the place's folder"]);
    assert!(ran.out.contains("there: false") && ran.out.contains("data/elms.csv;"), "{ran:#?}");
    assert!(!ran.out.contains("oaks.csv"), "{ran:#?}");
    let ran = bench.bosquet("derive garden -o a.svg --allow-outside").ends(0);
    assert!(ran.out.contains("there: true") && ran.out.contains("beside/oaks.csv;"), "{ran:#?}");
}
