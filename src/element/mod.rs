//! The element repository (Ulmer et al. 2007, §2.1–2.2): plants, furniture, architectural objects, primitives and
//! ground covers by category, type and instance, described in TOML and extended by users beside their rules.
//!
//! In: catalogue texts, and models through the world. Out: real sizes, names and looks. Knows no shapes, no scene
//! and no language.
//!
//! A user's catalogue lies beside the rules. It adds elements, and changes the built-in ones field by field:
//!
//! ```toml
//! [plant.quercus-ilex]                # the unique id
//! category = "oak"                    # what rules say: `I(oak, evergreen, rand(3))`
//! kind = "tree"                       # tree, shrub, hedge, flower
//! species = "Quercus ilex"
//! common_name = "Holm oak"
//! names = ["chêne vert"]              # also found by these
//! code = "ILX"                        # three letters on plans
//! symbol = "broadleaf"                # broadleaf, feathery, conifer, palm, clipped, box, cone, shrub, flower
//! color = "#7f9566"
//! line = "#48593a"
//! shader = { leaf = "#4f6a3c" }       # free: for renderers
//! metadata = { zones = "7-9" }        # free: whatever else is known
//! [plant.quercus-ilex.types]          # metres and years; height and crown are needed, the rest is helpful
//! evergreen = { age = 60, height = 15, crown_radius = 6, spacing_radius = 5, trunk_diameter = 0.6, appearances = 3 }
//!
//! [object.bench-louis]
//! category = "bench"
//! kind = "furniture"                  # furniture, architecture, primitive
//! form = "box"                        # box, cylinder, cone, sphere, pyramid, quad, disk
//! types.louis = { model = "models/louis.glb" }        # size from the model, or: size = [2.2, 1.0, 0.7]
//!
//! [cover.crushed-tile]
//! label = "Crushed tile"
//! fill = "#e2b9a0"
//! line = "#a06a4c"
//! line_width = 0.1                    # millimetres on paper
//! texture = "stipple"                 # plain, stipple, strokes, ripples, hatch, foliage, embroidery, flowers
//!
//! [palette.quay]                      # what `plant(palette = quay)` chooses from
//! label = "Quays"
//! plants = ["holm oak", "plane", "lavender"]
//! ```

mod appearance;
mod catalogue;
mod color;
mod entry;
mod look;
mod model;
mod names;
mod palette;
mod read;
mod record;
mod words;

pub use appearance::Appearance;
pub use catalogue::{Catalogue, Found, NotFound};
pub use color::{color_bytes, color_text, hex_text, parse_color};
pub use entry::{Cover, Entry, Form, Kind, PlantFigures, Variant};
pub use look::{Material, PlantSymbol, Texture};
pub use model::{ModelBounds, ModelError, model_bounds};
pub use names::{ModelNames, model_names};
pub use palette::Palette;
pub use words::Words;

use catalogue::fold;
