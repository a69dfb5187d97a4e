//! `bosquet new`: a starter place that derives.

use crate::cli::disk::write_all;
use crate::cli::{Ended, show};
use std::path::PathBuf;

/// Arguments of `bosquet new`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The folder to make
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// The files of a starter place.
static FILES: &[(&str, &str)] = &[
    ("bosquet.toml", include_str!("starter/bosquet.toml")),
    ("garden.cga", include_str!("starter/garden.cga")),
    ("garden.geojson", include_str!("starter/garden.geojson")),
];

/// Makes the folder and its files; never writes over anything.
pub fn run(arguments: &Arguments) -> Ended {
    let folder = &arguments.folder;
    if let Some((name, _)) = FILES.iter().find(|(name, _)| folder.join(name).exists()) {
        return Ended::Usage(format!("`{}` is there already", folder.join(name).display()));
    }
    if let Err(error) = std::fs::create_dir_all(folder) {
        return Ended::Usage(format!("`{}` cannot be made: {error}", folder.display()));
    }
    let files: Vec<(PathBuf, Vec<u8>)> =
        FILES.iter().map(|(name, text)| (folder.join(name), text.as_bytes().to_vec())).collect();
    if let Err(message) = write_all(&files) {
        show::tell(format_args!("error: {message}"));
        return Ended::Wrong;
    }
    show::tell(format_args!("made {}; now: bosquet derive {}", folder.display(), folder.display()));
    Ended::Well
}
