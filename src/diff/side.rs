//! One side of a comparison: what is known of a result.

use crate::scene::{Plant, Scene};
use crate::shape::Derivation;
use serde_json::Value;
use std::collections::BTreeMap;

/// What is known of a result.
#[derive(Clone, Debug, Default)]
pub struct Side {
    /// The plants, positions in the plan that both sides share; none where only figures are known.
    pub plants: Option<Vec<Plant>>,
    /// Areas of ground covers, m², by lot and material.
    pub grounds: BTreeMap<String, BTreeMap<String, f64>>,
    /// Shapes by symbol.
    pub symbols: BTreeMap<String, f64>,
    /// Plants by species, by category where the species is not known.
    pub species: BTreeMap<String, f64>,
    /// Totals by name.
    pub totals: BTreeMap<String, f64>,
}

impl Side {
    /// A run.
    pub fn of_run(scene: &Scene, derivation: &Derivation) -> Side {
        let mut side = Side::of_plants(scene.plants.clone());
        for cover in &scene.covers {
            let lot = side.grounds.entry(cover.origin.lot.to_string()).or_default();
            *lot.entry(cover.material.name.to_string()).or_default() += cover.area.area();
        }
        for node in derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes) {
            *side.symbols.entry(derivation.symbols[node.symbol as usize].to_string()).or_default() += 1.0;
        }
        let covers: f64 = side.grounds.values().flat_map(BTreeMap::values).sum();
        let counts = [
            ("lots", scene.lots.len()),
            ("covers", scene.covers.len()),
            ("solids", scene.solids.len()),
            ("lines", scene.lines.len()),
            ("objects", scene.objects.len()),
        ];
        side.totals.extend(counts.map(|(name, count)| (name.into(), count as f64)));
        side.totals.insert("area of covers".into(), covers);
        side.totals.extend(scene.reports.iter().map(|report| (format!("report {}", report.key), report.sum)));
        side
    }

    /// Written plants.
    pub fn of_plants(plants: Vec<Plant>) -> Side {
        let mut side = Side::default();
        for plant in &plants {
            let name = if plant.species.is_empty() { &plant.category } else { &plant.species };
            *side.species.entry(name.to_string()).or_default() += 1.0;
        }
        let crowns = plants.iter().map(|plant| std::f64::consts::PI * plant.crown_radius * plant.crown_radius).sum();
        side.totals.insert("plants".into(), plants.len() as f64);
        side.totals.insert("area of crowns".into(), crowns);
        side.plants = Some(plants);
        side
    }

    /// A report that a run wrote; none where the text is no such thing.
    pub fn of_report(report: &Value) -> Option<Side> {
        let summary = report.get("summary")?;
        let figures = |value: Option<&Value>| -> BTreeMap<String, f64> {
            let object = value.and_then(Value::as_object).into_iter().flatten();
            object.filter_map(|(name, figure)| Some((name.clone(), figure.as_f64()?))).collect()
        };
        let mut totals = figures(Some(summary));
        for reported in report.get("reports").and_then(Value::as_array).into_iter().flatten() {
            let key = reported.get("key").and_then(Value::as_str)?;
            totals.insert(format!("report {key}"), reported.get("sum").and_then(Value::as_f64).unwrap_or(0.0));
        }
        Some(Side {
            plants: None,
            grounds: BTreeMap::from([(String::new(), figures(summary.get("area_by_material")))]),
            symbols: figures(report.get("counts_by_symbol")),
            species: figures(summary.get("plants_by_species")),
            totals,
        })
    }
}
