//! `material.*`: what a surface looks like beyond its colour. Scenes carry it; plans show name and colour alone.

use crate::element::color_text;
use crate::functions::args::text_at;
use crate::functions::{Function, Gives, Surroundings};
use crate::shape::Surface;
use crate::value::{Array, Cells, Value};
use std::sync::Arc;

macro_rules! text {
    ($name:literal, $docs:literal) => {
        Function::new(concat!("material.", $name), "", (0, 0), $docs, |_, around| {
            Ok(stored(around, $name).cloned().unwrap_or_else(|| Value::text("")))
        })
        .text()
        .settable()
    };
}

macro_rules! number {
    ($name:literal, $default:literal, $docs:literal) => {
        Function::new(concat!("material.", $name), "", (0, 0), $docs, |_, around| {
            Ok(stored(around, $name).cloned().unwrap_or(Value::Float($default)))
        })
        .settable()
    };
}

macro_rules! color {
    ($name:literal, $red:literal, $green:literal, $blue:literal, $hex:literal, $default:literal, $docs:literal) => {
        [
            number!($red, $default, $docs),
            number!($green, $default, $docs),
            number!($blue, $default, $docs),
            text!($hex, $docs),
        ]
    };
}

macro_rules! placing {
    ($su:literal, $sv:literal, $tu:literal, $tv:literal, $rw:literal, $docs:literal) => {
        [
            number!($su, 1.0, $docs),
            number!($sv, 1.0, $docs),
            number!($tu, 0.0, $docs),
            number!($tv, 0.0, $docs),
            number!($rw, 0.0, $docs),
        ]
    };
}

pub(super) static LIST: &[Function] = &[
    text!("colormap", "The file of the texture that `texture` sets."),
    text!("dirtmap", "The file of a texture that darkens the first."),
    text!("bumpmap", "The file of a map of heights."),
    text!("normalmap", "The file of a map of normals."),
    text!("specularmap", "The file of a map of highlights."),
    text!("opacitymap", "The file of a map of opacity."),
    text!("emissivemap", "The file of a map of light."),
    text!("occlusionmap", "The file of a map of shade."),
    text!("roughnessmap", "The file of a map of roughness."),
    text!("metallicmap", "The file of a map of metal."),
    text!("shader", "The shader that a renderer is asked for."),
    text!("opacitymap.mode", "How the map of opacity is read: `opaque`, `mask` or `blend`."),
    number!("opacitymap.cutoff", 0.5, "Below this a mask is clear, 0 to 1."),
    number!("bumpValue", 0.0, "How strong the map of heights is."),
    number!("shininess", 50.0, "How sharp highlights are."),
    number!("reflectivity", 0.0, "How much is mirrored, 0 to 1."),
    number!("metallic", 0.0, "How metallic it is, 0 to 1."),
    number!("roughness", 1.0, "How rough it is, 0 to 1."),
    number!("color.a", 1.0, "Opacity as older rules write it, 0 to 1."),
];

/// Colours other than the first, four attributes each.
pub(super) static COLORS: &[[Function; 4]] = &[
    color!("ambient", "ambient.r", "ambient.g", "ambient.b", "ambient.rgb", 0.0, "The ambient colour."),
    color!("specular", "specular.r", "specular.g", "specular.b", "specular.rgb", 0.0, "The colour of highlights."),
    color!("emissive", "emissive.r", "emissive.g", "emissive.b", "emissive.rgb", 0.0, "The colour of its own light."),
];

/// How textures are scaled (`su`, `sv`), moved (`tu`, `tv`) and turned (`rw`), five attributes each.
pub(super) static PLACINGS: &[[Function; 5]] = &[
    placing!("colormap.su", "colormap.sv", "colormap.tu", "colormap.tv", "colormap.rw", "How the texture is placed."),
    placing!("dirtmap.su", "dirtmap.sv", "dirtmap.tu", "dirtmap.tv", "dirtmap.rw", "How the dirt is placed."),
    placing!("bumpmap.su", "bumpmap.sv", "bumpmap.tu", "bumpmap.tv", "bumpmap.rw", "How the heights are placed."),
    placing!("normalmap.su", "normalmap.sv", "normalmap.tu", "normalmap.tv", "normalmap.rw", "How normals are placed."),
    placing!("opacitymap.su", "opacitymap.sv", "opacitymap.tu", "opacitymap.tv", "opacitymap.rw", "Opacity's place."),
    placing!("specularmap.su", "specularmap.sv", "specularmap.tu", "specularmap.tv", "specularmap.rw", "Highlights."),
];

/// Whole materials as rows of a name and a value.
pub(super) static WHOLE: &[Function] = &[
    Function::new(
        "getMaterial",
        "()",
        (0, 0),
        "The material as rows of a name and a value, for `setMaterial`: what rules have set of it.",
        |_, around| {
            let style = &around.shape.style;
            let name = style.material.iter().map(|name| ["name".into(), name.clone()]);
            let color = style.color.iter().flat_map(|[r, g, b, opacity]| {
                let color = color_text([*r, *g, *b, 1.0]);
                [["color.rgb".into(), color.into()], ["opacity".into(), opacity.to_string().into()]]
            });
            let stored = around.shape.attached().into_iter().flat_map(|surface| &surface.material);
            let stored = stored.map(|(name, value)| [name.clone(), value.to_string().into()]);
            Ok(rows(name.chain(color).chain(stored).flatten().collect()))
        },
    )
    .gives(Gives::Texts),
    Function::new(
        "readMaterial",
        "(path)",
        (1, 1),
        "The material of a file, for `setMaterial`: its name, since the file itself is not read.",
        |args, _| {
            let path = text_at(args, 0)?;
            let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
            let name = file.split('.').next().unwrap_or(file);
            Ok(rows(vec!["name".into(), name.into()]))
        },
    )
    .gives(Gives::Texts),
];

fn rows(cells: Vec<Arc<str>>) -> Value {
    let columns = if cells.is_empty() { 0 } else { 2 };
    Value::Array(Arc::new(Array::new(columns, Cells::Texts(cells)).unwrap_or_else(|| Array::row(Cells::Texts(vec![])))))
}

fn stored<'a>(around: &'a Surroundings, name: &str) -> Option<&'a Value> {
    around.shape.attached().and_then(|surface: &Surface| surface.material(name))
}
