//! The model or picture that fits the scope, out of those that a query finds.

use crate::functions::args::{number, text_at, word_at};
use crate::functions::assets::{FACES, RATIOS, SIZES, by_error, image_error, ratio_error, size_error};
use crate::functions::{Function, Surroundings};
use crate::value::Value;
use std::sync::Arc;

pub(super) static LIST: &[Function] = &[
    Function::new(
        "assetBestRatio",
        "(query, xy|xz|yz|xyz)",
        (2, 2),
        "The model whose proportions are those of the scope most; empty where the query finds none.",
        |args, around| best_ratio(args, around, 1.0),
    )
    .words(RATIOS)
    .text(),
    Function::new(
        "assetApproxRatio",
        "(query, xy|xz|yz|xyz, n)",
        (3, 3),
        "Any of the n models whose proportions are those of the scope most, from the shape's own numbers.",
        |args, around| best_ratio(args, around, number(args, 2)?),
    )
    .words(RATIOS)
    .text(),
    Function::new(
        "assetBestSize",
        "(query, x|y|z|xy|xz|yz|xyz)",
        (2, 2),
        "The model that is scaled least to fill the scope; empty where the query finds none.",
        |args, around| best_size(args, around, 0.0, 1.0),
    )
    .words(SIZES)
    .text(),
    Function::new(
        "assetApproxSize",
        "(query, x|y|z|xy|xz|yz|xyz, n)",
        (3, 3),
        "Any of the n models that are scaled least to fill the scope, from the shape's own numbers.",
        |args, around| best_size(args, around, 0.0, number(args, 2)?),
    )
    .words(SIZES)
    .text(),
    Function::new(
        "assetFitSize",
        "(query, x|y|z|xy|xz|yz|xyz, most)",
        (3, 3),
        "Any of the models that are scaled by no more than the share `most` to fill the scope (0.1: ±10 %; 0: by any), from \
         the shape's own numbers; empty where there is none.",
        |args, around| best_size(args, around, number(args, 2)?, f64::INFINITY),
    )
    .words(SIZES)
    .text(),
    Function::new(
        "imageBestRatio",
        "(query, xy|xz|yx|yz|zx|zy)",
        (2, 2),
        "The picture whose width to height is that of two axes of the scope most; empty where the query finds none.",
        |args, around| best_image(args, around, 1.0),
    )
    .words(FACES)
    .text(),
    Function::new(
        "imageApproxRatio",
        "(query, xy|xz|yx|yz|zx|zy, n)",
        (3, 3),
        "Any of the n pictures whose width to height is that of two axes of the scope most, from the shape's own numbers.",
        |args, around| best_image(args, around, number(args, 2)?),
    )
    .words(FACES)
    .text(),
];

fn best_ratio(args: &[Value], around: &mut Surroundings, of: f64) -> Result<Value, String> {
    let axes = word_at(args, 1, RATIOS)?;
    best(args, around, of, |around, path| ratio_error(around, path, axes).map(Some))
}

fn best_size(args: &[Value], around: &mut Surroundings, most: f64, of: f64) -> Result<Value, String> {
    let axes = word_at(args, 1, SIZES)?;
    best(args, around, of, |around, path| size_error(around, path, axes, most))
}

fn best_image(args: &[Value], around: &mut Surroundings, of: f64) -> Result<Value, String> {
    let axes = word_at(args, 1, FACES)?;
    best(args, around, of, |around, path| image_error(around, path, axes).map(Some))
}

/// Any of the best so many, which are at least one.
fn best(
    args: &[Value],
    around: &mut Surroundings,
    of: f64,
    error: impl Fn(&Surroundings, &str) -> Result<Option<f64>, String>,
) -> Result<Value, String> {
    let found = around.files.search(around.source, text_at(args, 0)?).map_err(|error| format!("fails: {error}"))?;
    let seen: &Surroundings = around;
    let ranked = by_error(found.iter().map(Arc::as_ref), |path| error(seen, path))?;
    let count = (of.max(1.0) as usize).min(ranked.len());
    let index = if count > 1 { around.random.below(count as u64) as usize } else { 0 };
    Ok(Value::text(ranked.get(index).copied().unwrap_or_default()))
}
