//! What a feature says about itself: the properties with a meaning of their own, and all of them as attributes.

use crate::layout::Kind;
use crate::layout::geojson::document::word;
use crate::value::{Array, Cells, Value};
use serde_json::{Map, Value as Json};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// No height, width or elevation is larger.
const MOST_METRES: f64 = 1e6;

/// A feature's properties, understood.
pub struct Properties {
    /// From `kind`; from `type` or `class` where they hold a word that is a kind; from `marker`.
    pub kind: Option<Kind>,
    /// From `name`.
    pub name: Option<Arc<str>>,
    /// From `zone`; empty where there is none.
    pub zone: Arc<str>,
    /// From `start`.
    pub start: Option<Arc<str>>,
    /// From `seed`.
    pub seed: Option<u64>,
    /// From `height`, metres.
    pub height: f64,
    /// From `width`, metres.
    pub width: f64,
    /// From `elevation`, metres.
    pub elevation: Option<f64>,
    /// All by name, except nothing (`null`), objects and lists of several types.
    pub attributes: BTreeMap<Arc<str>, Value>,
    /// Names of the lists and objects that were skipped.
    pub nested: Vec<Arc<str>>,
    /// Names of properties with a meaning whose value has none.
    pub misused: Vec<&'static str>,
}

/// Words that occur many times, held once.
#[derive(Default)]
pub struct Words(HashMap<String, Arc<str>>);

impl Words {
    fn get(&mut self, word: &str) -> Arc<str> {
        if let Some(known) = self.0.get(word) {
            return known.clone();
        }
        let new: Arc<str> = word.into();
        self.0.insert(word.to_owned(), new.clone());
        new
    }
}

impl Properties {
    /// Understands the properties.
    pub fn of(map: &Map<String, Json>, words: &mut Words) -> Properties {
        let text = |name: &str| word(map.get(name));
        let mut misused = Vec::new();
        let mut length = |name: &'static str| match map.get(name) {
            None | Some(Json::Null) => None,
            Some(json) => metres(json).filter(|length| length.abs() <= MOST_METRES).or_else(|| {
                misused.push(name);
                None
            }),
        };
        let (height, width, elevation) = (length("height"), length("width"), length("elevation"));
        let seed = map.get("seed").filter(|s| !s.is_null()).map(seed);
        if seed == Some(None) {
            misused.push("seed");
        }
        let mut properties = Properties {
            kind: kind(map),
            name: text("name").map(Arc::from),
            zone: words.get(&text("zone").unwrap_or_default()),
            start: text("start").map(|s| words.get(&s)),
            seed: seed.flatten(),
            height: height.unwrap_or(0.0).max(0.0),
            width: width.unwrap_or(0.0).max(0.0),
            elevation,
            attributes: BTreeMap::new(),
            nested: Vec::new(),
            misused,
        };
        properties.attach(map, words);
        properties
    }

    /// Makes every property an attribute.
    fn attach(&mut self, map: &Map<String, Json>, words: &mut Words) {
        for (name, json) in map {
            let value = match json {
                Json::Null => continue,
                Json::Bool(truth) => Value::Bool(*truth),
                Json::Number(number) => Value::Float(number.as_f64().unwrap_or_default()),
                Json::String(text) => Value::Text(words.get(text)),
                Json::Array(_) | Json::Object(_) => match array(json, words) {
                    Some(array) => Value::Array(Arc::new(array)),
                    None => {
                        self.nested.push(words.get(name));
                        continue;
                    }
                },
            };
            self.attributes.insert(words.get(name), value);
        }
    }
}

/// A list of numbers, truth values or texts, or of such lists of the same length: rows and columns.
fn array(json: &Json, words: &mut Words) -> Option<Array> {
    let list = json.as_array()?;
    let columns = match list.first() {
        Some(Json::Array(row)) => row.len(),
        _ => return Some(Array::row(cells(list.iter().collect(), words)?)),
    };
    let rows: Vec<&Vec<Json>> = list.iter().map(Json::as_array).collect::<Option<_>>()?;
    let is_even = rows.iter().all(|row| row.len() == columns);
    is_even.then(|| Array::new(columns, cells(rows.into_iter().flatten().collect(), words)?)).flatten()
}

fn cells(list: Vec<&Json>, words: &mut Words) -> Option<Cells> {
    match list.first() {
        None | Some(Json::Number(_)) => {
            list.iter().map(|json| json.as_f64()).collect::<Option<_>>().map(Cells::Numbers)
        }
        Some(Json::Bool(_)) => list.iter().map(|json| json.as_bool()).collect::<Option<_>>().map(Cells::Truths),
        Some(Json::String(_)) => {
            list.iter().map(|json| json.as_str().map(|text| words.get(text))).collect::<Option<_>>().map(Cells::Texts)
        }
        Some(_) => None,
    }
}

/// What the feature says it is.
fn kind(map: &Map<String, Json>) -> Option<Kind> {
    let text = |name: &str| map.get(name).and_then(Json::as_str).map(str::trim).filter(|w| !w.is_empty());
    let said = text("kind").map(Kind::parse);
    let known = || ["type", "class"].into_iter().filter_map(text).find_map(Kind::known);
    match (said.or_else(known), text("marker")) {
        (None | Some(Kind::Marker(_)), Some(word)) => Some(Kind::Marker(word.into())),
        (kind, _) => kind,
    }
}

/// A number of metres, also as a text: `"12"`, `"12.5 m"`.
fn metres(json: &Json) -> Option<f64> {
    match json {
        Json::Number(number) => number.as_f64(),
        Json::String(text) => text.trim().trim_end_matches('m').trim_end().parse().ok().filter(|v: &f64| v.is_finite()),
        _ => None,
    }
}

/// A whole number, also as a text.
fn seed(json: &Json) -> Option<u64> {
    match json {
        Json::Number(number) => number.as_u64(),
        Json::String(text) => text.trim().parse().ok(),
        _ => None,
    }
}
