//! A place: a folder with `bosquet.toml`, or another manifest in it, which names layout, rules, attributes and outputs.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The file that makes a folder a place.
pub const MANIFEST: &str = "bosquet.toml";

/// `bosquet.toml`; paths are relative to its folder.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// The title of plans.
    pub title: Option<String>,
    /// The line under it.
    pub subtitle: Option<String>,
    /// The layout.
    pub layout: String,
    /// The rule file.
    pub rules: String,
    /// The start rule for every region.
    pub start: Option<String>,
    /// The style of the rule file.
    pub style: Option<String>,
    /// The seed of the run.
    pub seed: Option<u64>,
    /// Further element catalogues, later ones over earlier ones.
    #[serde(default)]
    pub catalogues: Vec<String>,
    /// Values of attributes.
    #[serde(default)]
    pub attributes: BTreeMap<String, toml::Value>,
    /// How plans are drawn.
    #[serde(default)]
    pub plan: Plan,
    /// What is written without `-o`, into the working directory.
    #[serde(default)]
    pub outputs: Vec<String>,
}

/// `[plan]`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plan {
    /// `"1:500"` or 500.
    pub scale: Option<toml::Value>,
    /// Degrees counter-clockwise on the sheet.
    pub rotation: Option<f64>,
    /// Plants carry codes.
    pub codes: Option<bool>,
    /// Names of regions are written.
    pub names: Option<bool>,
    /// There is a legend.
    pub legend: Option<bool>,
}

/// The place in a folder, or at a manifest of any name, so that a folder may hold several; `None` where the path is
/// something else.
pub fn find(path: &Path) -> Option<PathBuf> {
    if path.is_dir() {
        return Some(path.join(MANIFEST));
    }
    (path.extension().is_some_and(|ending| ending == "toml")).then(|| path.into())
}

/// Reads a manifest; what is wrong with it comes with line and column.
pub fn read(path: &Path) -> Result<Manifest, String> {
    let text = std::fs::read_to_string(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => {
            let folder = path.parent().unwrap_or(Path::new(".")).display();
            let name = path.file_name().unwrap_or_default().display();
            format!("there is no `{name}` in `{folder}`: a place needs one (`bosquet new DIR` makes a starter)")
        }
        _ => format!("`{}` cannot be read: {error}", path.display()),
    })?;
    toml::from_str(&text).map_err(|error| format!("`{}` is not as it should be\n{error}", path.display()))
}

/// `1:500`, `500`: the second number.
pub fn scale(text: &str) -> Result<f64, String> {
    let number = text.strip_prefix("1:").unwrap_or(text).replace([',', '_'], "");
    match number.trim().parse::<f64>() {
        Ok(scale) if scale.is_finite() && scale > 0.0 => Ok(scale),
        _ => Err(format!("`{text}` is not a scale: write it as in `1:500`")),
    }
}
