//! A suburb planted by its tree cover: the example place, and what the report says was read.

use crate::bench::{Bench, repository};

#[test]
fn a_suburb_is_planted_by_its_tree_cover() {
    let bench = Bench::new();
    bench.run(&["derive", &repository("examples/coverage"), "-o", "r.json"]).ends(0);
    let report = bench.json("r.json");
    assert_eq!(report["diagnostics"], serde_json::json!([]));
    // draw.py marks 12 lots and 2 verges; some lots may have no cover of their own.
    assert!(report["counts_by_symbol"]["Wood"].as_u64() > Some(8), "{}", report["counts_by_symbol"]);
    assert!(report["counts_by_symbol"]["StreetTree"].as_u64() > Some(20), "{}", report["counts_by_symbol"]);
    let inputs = report["inputs"].to_string();
    assert!(inputs.contains("cover.png") && inputs.contains("cover.pgw"), "{inputs}");
}
