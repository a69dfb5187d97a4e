//! `bosquet manual`: writes the manual with its pictures.

use crate::cli::disk::write_all;
use crate::cli::{Ended, show};
use bosquet::manual::{Chapter, pages, pictures};
use std::path::{Path, PathBuf};

/// Arguments of `bosquet manual`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The folder to write it into
    #[arg(value_name = "FOLDER", default_value = "manual")]
    folder: PathBuf,
}

/// Writes every page and picture.
pub fn run(arguments: &Arguments) -> Ended {
    let chapters = match pictures() {
        Ok(pictures) => pages().into_iter().chain(pictures).collect::<Vec<_>>(),
        Err(message) => {
            show::tell(format_args!("error: {message}"));
            return Ended::Wrong;
        }
    };
    let written =
        folders(&arguments.folder, &chapters).and_then(|()| write_all(&files(&arguments.folder, chapters)).map(drop));
    match written {
        Ok(_) => {
            show::tell(format_args!("wrote {}", arguments.folder.join("README.md").display()));
            Ended::Well
        }
        Err(message) => {
            show::tell(format_args!("error: {message}"));
            Ended::Wrong
        }
    }
}

fn files(folder: &Path, chapters: Vec<Chapter>) -> Vec<(PathBuf, Vec<u8>)> {
    chapters.into_iter().map(|chapter| (folder.join(chapter.path), chapter.bytes)).collect()
}

fn folders(folder: &Path, chapters: &[Chapter]) -> Result<(), String> {
    for chapter in chapters {
        let path = folder.join(&chapter.path);
        let parent = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(parent).map_err(|error| format!("`{}` cannot be made: {error}", parent.display()))?;
    }
    Ok(())
}
