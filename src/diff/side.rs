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
    /// Areas of ground covers, m², by lot and material; under the empty lot where lots are not known.
    pub grounds: Option<BTreeMap<String, Figures>>,
    /// Shapes by symbol.
    pub symbols: Option<Figures>,
    /// What rules reported, summed by key.
    pub reports: Option<Figures>,
    /// Plants by species, by category where the species is not known.
    pub species: Figures,
    /// Totals by name.
    pub totals: Figures,
}

/// Numbers by name.
pub type Figures = BTreeMap<String, f64>;

impl Side {
    /// A run.
    pub fn of_run(scene: &Scene, derivation: &Derivation) -> Side {
        let mut grounds: BTreeMap<String, Figures> = BTreeMap::new();
        for cover in &scene.covers {
            let lot = grounds.entry(cover.origin.lot.to_string()).or_default();
            *lot.entry(cover.material.name.to_string()).or_default() += cover.area.area();
        }
        let mut symbols = Figures::new();
        for node in derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes) {
            *symbols.entry(derivation.symbols[node.symbol as usize].to_string()).or_default() += 1.0;
        }
        let counts = [
            ("lots", scene.lots.len()),
            ("covers", scene.covers.len()),
            ("solids", scene.solids.len()),
            ("lines", scene.lines.len()),
            ("objects", scene.objects.len()),
        ];
        let mut side = Side::of_plants(scene.plants.clone());
        side.totals.extend(counts.map(|(name, count)| (name.into(), count as f64)));
        side.reports = Some(scene.reports.iter().map(|report| (report.key.to_string(), report.sum)).collect());
        Side { grounds: Some(grounds), symbols: Some(symbols), ..side }
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
        side.totals.insert("crown_area".into(), crowns);
        side.plants = Some(plants);
        side
    }

    /// A report that a run wrote; none where the text is no such thing.
    pub fn of_report(report: &Value) -> Option<Side> {
        let summary = report.get("summary")?;
        let reported = report.get("reports").and_then(Value::as_array).into_iter().flatten();
        let sum = |one: &Value| Some((one.get("key")?.as_str()?.to_string(), one.get("sum")?.as_f64()?));
        Some(Side {
            plants: None,
            grounds: Some(BTreeMap::from([(String::new(), figures(summary.get("area_by_material")))])),
            symbols: Some(figures(report.get("counts_by_symbol"))),
            reports: Some(reported.filter_map(sum).collect()),
            species: figures(summary.get("plants_by_species")),
            totals: figures(Some(summary)),
        })
    }
}

/// The numbers of an object.
fn figures(value: Option<&Value>) -> Figures {
    let object = value.and_then(Value::as_object).into_iter().flatten();
    object.filter_map(|(name, figure)| Some((name.clone(), figure.as_f64()?))).collect()
}
