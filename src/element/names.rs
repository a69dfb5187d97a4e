//! What a model says of itself: the names of its groups and materials, and the metadata of glTF files.

use crate::element::ModelError;
use crate::value::{Array, Cells, Value};
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a model says of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelNames {
    /// Its groups or meshes, each once, in the order of the file.
    pub groups: Vec<Arc<str>>,
    /// Its materials, likewise.
    pub materials: Vec<Arc<str>>,
    /// The `extras` of the file and its scene: numbers, truth values, texts, and arrays of one kind.
    pub metadata: BTreeMap<String, Value>,
}

/// The names in the model of a file of that name.
pub fn model_names(path: &str, bytes: &[u8]) -> Result<ModelNames, ModelError> {
    let name = path.to_ascii_lowercase();
    match name.rsplit('.').next() {
        Some("glb" | "gltf") => gltf_names(bytes),
        Some("obj") => Ok(obj_names(&String::from_utf8_lossy(bytes))),
        _ => Err(ModelError::Format),
    }
}

fn obj_names(text: &str) -> ModelNames {
    let mut names = ModelNames::default();
    for line in text.lines() {
        match line.trim().split_once(char::is_whitespace) {
            Some(("g" | "o", name)) => add(&mut names.groups, name.trim()),
            Some(("usemtl", name)) => add(&mut names.materials, name.trim()),
            _ => {}
        }
    }
    names
}

/// Adds a name that is not there yet.
fn add(names: &mut Vec<Arc<str>>, name: &str) {
    if !names.iter().any(|known| **known == *name) {
        names.push(name.into());
    }
}

fn gltf_names(bytes: &[u8]) -> Result<ModelNames, ModelError> {
    let broken = |error: String| ModelError::Broken(error);
    let text = match bytes.starts_with(b"glTF") {
        true => gltf::binary::Glb::from_slice(bytes).map_err(|e| broken(e.to_string()))?.json,
        false => bytes.into(),
    };
    let file: Json = serde_json::from_slice(&text).map_err(|e| broken(e.to_string()))?;
    let mut names = ModelNames::default();
    for (list, found) in [("meshes", &mut names.groups), ("materials", &mut names.materials)] {
        let things = file[list].as_array().into_iter().flatten();
        things.for_each(|thing| add(found, thing["name"].as_str().unwrap_or_default()));
    }
    let scene = &file["scenes"][file["scene"].as_u64().unwrap_or(0) as usize];
    for extras in [&scene["extras"], &file["asset"]["extras"], &file["extras"]] {
        let entries = extras.as_object().into_iter().flatten();
        names.metadata.extend(entries.filter_map(|(key, value)| Some((key.clone(), known(value)?))));
    }
    Ok(names)
}

/// A value as the language has it.
fn known(json: &Json) -> Option<Value> {
    Some(match json {
        Json::Number(number) => Value::Float(number.as_f64()?),
        Json::Bool(truth) => Value::Bool(*truth),
        Json::String(text) => Value::text(text.as_str()),
        Json::Array(values) => Value::Array(Arc::new(Array::row(cells(values)?))),
        _ => return None,
    })
}

fn cells(values: &[Json]) -> Option<Cells> {
    Some(match values.first()? {
        Json::Number(_) => Cells::Numbers(values.iter().map(Json::as_f64).collect::<Option<_>>()?),
        Json::Bool(_) => Cells::Truths(values.iter().map(Json::as_bool).collect::<Option<_>>()?),
        _ => Cells::Texts(values.iter().map(|value| value.as_str().map(Into::into)).collect::<Option<_>>()?),
    })
}
