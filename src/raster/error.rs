//! Why a coverage map cannot be used.

use crate::layout::{Crs, CrsError};
use crate::raster::{MOST_BYTES, MOST_PIXELS, MOST_TRACED};
use crate::text::thousands;
use crate::world::WorldError;

/// A coverage map that cannot be used, by its path, and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the coverage map `{path}` cannot be used: {flaw}")]
pub struct RasterError {
    /// The file.
    pub path: String,
    /// What is wrong with it.
    pub flaw: Flaw,
}

/// What is wrong with a coverage map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Flaw {
    /// It, or its world file, cannot be had.
    #[error(transparent)]
    World(#[from] WorldError),
    /// It is some other file.
    #[error("it is neither PNG nor TIFF nor GeoJSON")]
    Format,
    /// It breaks off, or is not what it says it is.
    #[error("it is damaged: {0}")]
    Damaged(String),
    /// A sort of picture that nobody reads here.
    #[error("{0} are not read: grey, RGB and RGBA are, and palettes in PNG files")]
    Unsupported(String),
    /// No columns or no rows.
    #[error("it has no pixels")]
    Empty,
    /// More than [`MOST_PIXELS`].
    #[error("it has {} pixels, more than the limit of {}", thousands(*.0 as usize), thousands(MOST_PIXELS as usize))]
    TooManyPixels(u64),
    /// More than [`MOST_BYTES`].
    #[error("it takes more than the limit of {} bytes", thousands(MOST_BYTES))]
    TooManyBytes,
    /// More than [`MOST_TRACED`].
    #[error("the shape has {} of its pixels, more than the limit of {}", thousands(*.0), thousands(MOST_TRACED))]
    TooManyTraced(usize),
    /// Neither tags nor world file.
    #[error("nothing says where it lies: there is no {}", listed(.0))]
    Placeless(Vec<String>),
    /// A world file that is none.
    #[error("its world file `{path}` is not six numbers, one a line: {reason}")]
    WorldFile {
        /// The world file.
        path: String,
        /// What is there instead.
        reason: String,
    },
    /// Georeferencing that nobody understands here.
    #[error("its place on earth is not understood: {0}")]
    Place(String),
    /// Pixels without an extent, or not finite.
    #[error("its pixels have no extent on the plan")]
    NoExtent,
    /// A projection that cannot be followed back to the pixel.
    #[error("its coordinates cannot be brought into the plan to within 1 cm")]
    Unplaceable,
    /// A system that cannot be had in the plan of the layout.
    #[error("it is in {found} and the layout in {layout}: bring one of them into the other's system")]
    OtherSystem {
        /// Its own.
        found: Crs,
        /// The layout's.
        layout: Crs,
    },
    /// A system that cannot be used at all.
    #[error(transparent)]
    System(#[from] CrsError),
    /// A band that it has not.
    #[error("it has no band `{wanted}`: it has {bands}")]
    NoBand {
        /// What was asked for.
        wanted: String,
        /// How many it has, in words.
        bands: String,
    },
    /// A GeoJSON text with an error.
    #[error("{0}")]
    Drawing(String),
}

impl Flaw {
    /// The flaw of the file at `path`.
    pub(super) fn of(self, path: &str) -> RasterError {
        RasterError { path: path.into(), flaw: self }
    }
}

/// `` `a`, `b` or `c` ``
fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
        None => "world file".into(),
    }
}
