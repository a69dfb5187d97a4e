//! Models and pictures: how large they are, what they say of themselves, and which fits the scope.

use crate::element::ModelBounds;
use crate::functions::args::{any, number, text_at, word_at, wrong};
use crate::functions::lists::{items, listed};
use crate::functions::{Function, Gives, Surroundings};
use crate::value::{Array, Cells, Value};
use glam::DVec3;
use std::sync::Arc;

/// Axes that a ratio may compare.
pub(super) const RATIOS: &[&str] = &["xy", "xz", "yz", "xyz"];
/// Axes whose sizes may be compared.
pub(super) const SIZES: &[&str] = &["x", "y", "z", "xy", "xz", "yz", "xyz"];
/// Axes that stand for the width and height of a picture.
pub(super) const FACES: &[&str] = &["xy", "xz", "yx", "yz", "zx", "zy"];

pub(super) static LIST: &[Function] = &[
    Function::new(
        "assetInfo",
        "(path, sx|sy|sz|tx|ty|tz)",
        (2, 2),
        "The size of a model along an axis, or its least coordinate there, metres, y up. An element of the catalogue has \
         its own size and stands about its middle.",
        |args, around| {
            let word = word_at(args, 1, &["sx", "sy", "sz", "tx", "ty", "tz"])?;
            let bounds = bounds(around, text_at(args, 0)?)?;
            let values = if word.starts_with('s') { bounds.size() } else { bounds.min };
            Ok(Value::Float(values[usize::from(word.as_bytes()[1] - b'x')]))
        },
    )
    .words(&["sx", "sy", "sz", "tx", "ty", "tz"]),
    Function::new(
        "assetNamingInfo",
        "(path, g|m)",
        (2, 2),
        "The names of a model's groups or materials, as a list.",
        |args, around| Ok(Value::text(listed(names(args, around)?.iter().map(|name| &**name)))),
    )
    .words(&["g", "m"])
    .text(),
    Function::new(
        "assetNamingInfos",
        "(path, g|m)",
        (2, 2),
        "The names of a model's groups or materials, as an array.",
        |args, around| Ok(Value::Array(Array::row(Cells::Texts(names(args, around)?)).into())),
    )
    .words(&["g", "m"])
    .gives(Gives::Texts),
    Function::new(
        "assetMetadata",
        "(path, key, default)",
        (3, 3),
        "What a glTF model says under a key in its `extras`; the default where it says nothing of that kind.",
        |args, around| {
            let (path, default) = (text_at(args, 0)?, any(args, 2)?);
            let said = around.files.names(around.source, path).map_err(|error| error.to_string())?;
            let value = said.metadata.get(text_at(args, 1)?).filter(|v| v.type_name() == default.type_name());
            Ok(value.unwrap_or(default).clone())
        },
    )
    .gives(Gives::Any),
    Function::new(
        "assetsSortRatio",
        "(paths, xy|xz|yz|xyz)",
        (2, 2),
        "Models by how well their proportions are those of the scope, the best first; a list or an array, as given.",
        |args, around| {
            let axes = word_at(args, 1, RATIOS)?;
            sorted(args, |path| ratio_error(around, path, axes).map(Some))
        },
    )
    .words(RATIOS)
    .gives(Gives::Same),
    Function::new(
        "assetsSortSize",
        "(paths, x|y|z|xy|xz|yz|xyz, most)",
        (3, 3),
        "Models by how little they are scaled to fill the scope, the best first; those scaled by more than the share `most` \
         (0.1: ±10 %) are left out, unless it is 0.",
        |args, around| {
            let (axes, most) = (word_at(args, 1, SIZES)?, number(args, 2)?);
            sorted(args, |path| size_error(around, path, axes, most))
        },
    )
    .words(SIZES)
    .gives(Gives::Same),
    Function::new(
        "imageInfo",
        "(path, sx|sy)",
        (2, 2),
        "The width or height of a picture in pixels: PNG, JPEG, GIF or BMP.",
        |args, around| {
            let axis = usize::from(word_at(args, 1, &["sx", "sy"])? == "sy");
            let size = around.files.picture(around.source, text_at(args, 0)?).map_err(failed)?;
            Ok(Value::Float(f64::from(size[axis])))
        },
    )
    .words(&["sx", "sy"]),
    Function::new(
        "imagesSortRatio",
        "(paths, xy|xz|yx|yz|zx|zy)",
        (2, 2),
        "Pictures by how well their width to height is that of two axes of the scope, the best first; a list or an array, \
         as given.",
        |args, around| {
            let axes = word_at(args, 1, FACES)?;
            sorted(args, |path| image_error(around, path, axes).map(Some))
        },
    )
    .words(FACES)
    .gives(Gives::Same),
];

fn failed(error: crate::files::FileError) -> String {
    format!("has nothing to measure: {error}")
}

/// The bounds of a model, or of an element of the catalogue about its middle.
fn bounds(around: &Surroundings, path: &str) -> Result<ModelBounds, String> {
    around.files.model(around.source, path).or_else(|error| {
        let found = around.catalogue.find(path, "").map_err(|_| failed(error))?;
        let [x, y, z] = found.variant.size;
        Ok(ModelBounds { min: [-0.5 * x, 0.0, -0.5 * z], max: [0.5 * x, y, 0.5 * z] })
    })
}

fn names(args: &[Value], around: &Surroundings) -> Result<Vec<Arc<str>>, String> {
    let which = word_at(args, 1, &["g", "m"])?;
    let names =
        around.files.names(around.source, text_at(args, 0)?).map_err(|e| format!("has nothing to read: {e}"))?;
    Ok(if which == "g" { names.groups.clone() } else { names.materials.clone() })
}

/// The paths by their error, the least first, and those of the same as they stood; such as have none are left out.
fn sorted(args: &[Value], error: impl Fn(&str) -> Result<Option<f64>, String>) -> Result<Value, String> {
    Ok(match any(args, 0)? {
        Value::Text(list) => Value::text(listed(by_error(items(list), error)?.into_iter())),
        Value::Array(array) => match array.cells() {
            Cells::Texts(paths) => {
                let best = by_error(paths.iter().map(|path| &**path), error)?;
                Value::Array(Array::row(Cells::Texts(best.into_iter().map(Into::into).collect())).into())
            }
            _ => return Err(wrong("a list or an array of paths", &args[0])),
        },
        other => return Err(wrong("a list or an array of paths", other)),
    })
}

pub(super) fn by_error<'a>(
    paths: impl Iterator<Item = &'a str>,
    error: impl Fn(&str) -> Result<Option<f64>, String>,
) -> Result<Vec<&'a str>, String> {
    let mut found: Vec<(f64, &str)> = Vec::new();
    for path in paths {
        found.extend(error(path)?.map(|error| (error, path)));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(found.into_iter().map(|(_, path)| path).collect())
}

/// How far the proportions of a model are from those of the scope: the sum of what each pair of axes is off, as factors.
pub(super) fn ratio_error(around: &Surroundings, path: &str, axes: &str) -> Result<f64, String> {
    let (scope, own) = (around.shape.scope.size, DVec3::from(bounds(around, path)?.size()));
    let axes: Vec<usize> = indices(axes).collect();
    let pairs = (0..axes.len()).flat_map(|i| (i + 1..axes.len()).map(move |j| (i, j)));
    Ok(pairs.map(|(i, j)| (stretch(scope, own, axes[i]) - stretch(scope, own, axes[j])).abs()).sum())
}

/// By what factor a model is scaled most to fill the scope; none where that is more than `most` allows.
pub(super) fn size_error(around: &Surroundings, path: &str, axes: &str, most: f64) -> Result<Option<f64>, String> {
    let (scope, own) = (around.shape.scope.size, DVec3::from(bounds(around, path)?.size()));
    let error = indices(axes).map(|axis| stretch(scope, own, axis).abs()).fold(0.0, f64::max);
    let fits = |axis: usize| (scope[axis] - own[axis]).abs() <= most * own[axis] + 1e-9;
    Ok((most <= 0.0 || indices(axes).all(fits)).then_some(error))
}

/// How far the width to height of a picture is from that of two axes of the scope, as a factor.
pub(super) fn image_error(around: &Surroundings, path: &str, axes: &str) -> Result<f64, String> {
    let [width, height] = around.files.picture(around.source, path).map_err(failed)?.map(f64::from);
    let axes: Vec<usize> = indices(axes).collect();
    let (across, up) = (around.shape.scope.size[axes[0]], around.shape.scope.size[axes[1]]);
    Ok((factor(across, width) - factor(up, height)).abs())
}

fn indices(axes: &str) -> impl Iterator<Item = usize> {
    axes.bytes().map(|axis| usize::from(axis - b'x'))
}

/// The factor from a model to the scope along an axis, as a logarithm.
fn stretch(scope: DVec3, own: DVec3, axis: usize) -> f64 {
    factor(scope[axis], own[axis])
}

/// Lengths below a tenth of a millimetre count as that, so that flat things can be compared.
fn factor(wanted: f64, own: f64) -> f64 {
    libm::log(wanted.max(1e-4) / own.max(1e-4))
}
