//! A rule file of many gardens under different names: attributes, functions, splits, selectors, cases, percentages, both
//! notations and comments, in about the proportions of real files.

use bosquet::syntax::Source;

/// Size of the file, bytes.
pub const BYTES: usize = 1 << 20;

/// One garden; `@` is its number.
const GARDEN: &str = r##"
// Garden number _@: a hedge all round, beds between paths, a tree in some of them.
@Group("Garden _@", 1)
@Range(min=0.5, max=6)
@Description("Width of the paths in metres")
attr path_width_@ = 1.5

attr season_@ = "summer"
const bed_@ = 4 + path_width_@ * 2

height_@(age) = case age < 10 : 1 + 0.35 * age
                case age < 40 && season_@ != "winter" : 3.5 + 0.2 * age
                else : 12

@StartRule
Garden_@ -->
    setback(path_width_@) { all : Hedge_@(rand(1, 3)) | remainder : Beds_@ }

Hedge_@(years) --> color("#5b7b3a") extrude(height_@(years) * 0.5) label("hedge") Hedge.

Beds_@ --> split(x) { path_width_@ : Path_@ | { ~bed_@ : Row_@ | path_width_@ : Path_@ }* }

Row_@ --> split(z) { { ~bed_@ : Bed_@ | path_width_@ : Path_@ }* }

Bed_@ -->
    case geometry.area < 2 : NIL
    case touches(inter, "street") : offset(-0.25, inside) Flowers_@
    else :
        30% : Flowers_@ [ t('0.5, 0, '0.5) Tree_@(5 + rand(30)) ]
        50% : Flowers_@
        else : color(0.6, 0.7, 0.4) Lawn.

Flowers_@ --> set(material.name, "flowers") report("flowers", geometry.area) Flowers.

/* The trees of the garden, by age. */
Tree_@(age) --> s(0, height_@(age), 0) center(xz) i("birch") label("tree")

Path_@ --> set(material.name, "gravel") Gravel.

r_@: Orchard_@ : Shape.area > 40 ~> Subdiv(x, 1r, 6) { Plum_@ | Grass } : 0.7
"##;

/// The file.
pub fn source() -> Source {
    Source::new("gardens.cga", gardens().as_bytes())
}

/// Gardens up to [`BYTES`].
fn gardens() -> String {
    let mut text = String::with_capacity(BYTES + GARDEN.len());
    for number in 0.. {
        if text.len() >= BYTES {
            break;
        }
        text.push_str(&GARDEN.replace("_@", &format!("_{number}")));
    }
    text
}
