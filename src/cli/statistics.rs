//! What `bosquet stats` shows: tables for people, curves as CSV, everything as JSON.

use bosquet::stats::{
    Comparison, Curves, Distances, Pattern, Spread, Summary, curves, nearest_neighbours, shares_within, summary,
};
use bosquet::text::{area_words, number, thousands};
use serde_json::{Value, json};
use std::fmt::Write;

/// A set of points with all that was measured of it.
pub struct Set {
    name: String,
    outside: usize,
    summary: Summary,
    curves: Curves,
    /// At each distance of the curves, the share of points whose nearest neighbour is not farther.
    nearest_within: Vec<f64>,
    /// The same of the window's edge.
    window_within: Vec<f64>,
    /// Distances to other things, by what they are.
    further: Vec<(&'static str, Spread)>,
}

/// Quantiles of [`Spread`] that the table shows: 10, 25, 50, 75, 90 %.
const SHOWN: std::ops::Range<usize> = 1..6;
/// Rows of curves in the table.
const ROWS: usize = 8;

impl Set {
    /// Measures a pattern, its curves at `steps` distances up to `reach` metres.
    pub fn measure(name: &str, pattern: &Pattern, reach: f64, steps: usize) -> Set {
        let curves = curves(pattern, reach, steps);
        Set {
            name: name.into(),
            outside: pattern.outside(),
            summary: summary(pattern),
            nearest_within: shares_within(&nearest_neighbours(pattern.points()), &curves.radius),
            window_within: shares_within(&pattern.distances_to_rim(), &curves.radius),
            curves,
            further: Vec::new(),
        }
    }

    /// Adds distances to other things, where there are any.
    pub fn add(&mut self, name: &'static str, distances: Option<impl Iterator<Item = f64>>) {
        self.further.extend(distances.map(|sample| (name, Spread::of(&sample.collect::<Vec<_>>()))));
    }
}

/// Everything for people, one set after the other.
pub fn table(sets: &[Set], compared: &[(&str, Comparison)]) -> String {
    let mut out = String::new();
    for set in sets {
        describe(set, &mut out);
    }
    for (name, found) in compared {
        let _ = writeln!(out, "{} and {name}", sets[0].name);
        contrast(found, &mut out);
    }
    out
}

fn contrast(found: &Comparison, out: &mut String) {
    let (m, s) = (found.metres, found.scaled);
    let rows = [
        ("W1 of nearest neighbours", Some((m.nearest, s.nearest))),
        ("W1 of distances to the window", Some((m.rim, s.rim))),
        ("L2 of pair correlations", m.pair_correlation.zip(s.pair_correlation)),
        ("largest difference of L", Some((m.l, s.l))),
    ];
    let _ = writeln!(out, "  {:<34}{:>10}{:>10}", "", "metres", "scaled");
    for (words, (metres, scaled)) in rows.into_iter().filter_map(|(words, pair)| Some((words, pair?))) {
        let _ = writeln!(out, "  {words:<34}{metres:>10.3}{scaled:>10.3}");
    }
    let _ = writeln!(out, "  {:<34}{:>10.3}", "Chamfer, k = 1, means added", found.chamfer);
    let _ = writeln!(out, "  {:<34}{:>10.3}\n", "Hausdorff", found.hausdorff);
}

fn describe(set: &Set, out: &mut String) {
    let s = &set.summary;
    let _ = writeln!(out, "{}", set.name);
    let mut row = |words: &str, value: String| {
        let _ = writeln!(out, "  {words:<34}{value}");
    };
    row("points", thousands(s.count));
    row("window", area_words(s.area));
    row("density", format!("{} per ha", number(s.density * 10_000.0, 2)));
    let index = s.clark_evans;
    row("Clark-Evans R", format!("{:.3} (Donnelly), {:.3} (uncorrected)", index.donnelly, index.naive));
    let spreads = [("nearest neighbour", s.nearest), ("to the window's edge", s.rim)];
    let _ = writeln!(out, "  {:<34}    mean      sd     p10     p25     p50     p75     p90", "metres");
    for (words, spread) in spreads.into_iter().chain(set.further.iter().copied()) {
        let values = [spread.mean, spread.deviation].into_iter().chain(spread.quantiles[SHOWN].iter().copied());
        let cells: String = values.map(|v| format!("{v:>8.1}")).collect();
        let _ = writeln!(out, "  {words:<34}{cells}");
    }
    curve_rows(&set.curves, out);
    out.push('\n');
}

fn curve_rows(curves: &Curves, out: &mut String) {
    let bandwidth = curves.bandwidth;
    let _ = writeln!(
        out,
        "  {:>10}{:>12}{:>10}{:>8}   isotropic correction; kernel of g ± {bandwidth:.2} m",
        "r", "K", "L - r", "g"
    );
    let every = curves.radius.len().div_ceil(ROWS).max(1);
    let l = curves.l_less_r();
    for i in (every - 1..curves.radius.len()).step_by(every) {
        let (r, k, g) = (curves.radius[i], curves.k[i], curves.g[i]);
        let _ = writeln!(out, "  {r:>10.2}{k:>12.2}{:>10.3}{g:>8.3}", l[i]);
    }
}

/// The curves of all sets as a table: set, distance, K, L less the distance, g, and the distributions of distances to
/// nearest neighbours and to the window's edge.
pub fn csv(sets: &[Set]) -> String {
    let mut out = String::from("set,r,k,l_less_r,g,nearest_within,window_within\r\n");
    for set in sets {
        let name = format!("\"{}\"", set.name.replace('"', "\"\""));
        for (i, l) in set.curves.l_less_r().iter().enumerate() {
            let (r, k, g) = (set.curves.radius[i], set.curves.k[i], set.curves.g[i]);
            let _ = write!(out, "{name},{r},{k},{l},{g},{},{}\r\n", set.nearest_within[i], set.window_within[i]);
        }
    }
    out
}

/// Everything, unrounded, in metres.
pub fn json(sets: &[Set], compared: &[(&str, Comparison)]) -> String {
    let sets: Vec<Value> = sets.iter().map(set_json).collect();
    let compared: Vec<Value> = compared
        .iter()
        .map(|(name, c)| {
            json!({
                "with": name,
                "metres": distances_json(&c.metres),
                "scaled": distances_json(&c.scaled),
                "chamfer": c.chamfer,
                "hausdorff": c.hausdorff,
            })
        })
        .collect();
    format!("{:#}\n", json!({ "sets": sets, "comparisons": compared }))
}

fn set_json(set: &Set) -> Value {
    let s = &set.summary;
    let further: serde_json::Map<String, Value> =
        set.further.iter().map(|(name, spread)| (name.replace(' ', "_"), spread_json(spread))).collect();
    json!({
        "name": set.name,
        "points": s.count,
        "outside": set.outside,
        "area": s.area,
        "per_hectare": s.density * 10_000.0,
        "clark_evans": { "donnelly": s.clark_evans.donnelly, "uncorrected": s.clark_evans.naive },
        "nearest_neighbour": spread_json(&s.nearest),
        "to_window": spread_json(&s.rim),
        "distances": further,
        "curves": {
            "correction": "isotropic",
            "bandwidth": set.curves.bandwidth,
            "r": set.curves.radius,
            "k": set.curves.k,
            "l_less_r": set.curves.l_less_r(),
            "g": set.curves.g,
            "nearest_within": set.nearest_within,
            "window_within": set.window_within,
        },
    })
}

fn spread_json(spread: &Spread) -> Value {
    let [least, p10, p25, p50, p75, p90, most] = spread.quantiles;
    json!({
        "mean": spread.mean, "deviation": spread.deviation,
        "least": least, "p10": p10, "p25": p25, "p50": p50, "p75": p75, "p90": p90, "most": most,
    })
}

fn distances_json(d: &Distances) -> Value {
    json!({ "nearest_w1": d.nearest, "window_w1": d.rim, "pcf_l2": d.pair_correlation, "l_sup": d.l })
}
