//! Declarations → the manual: one page an operation with a plan of its example, and the lists of everything else.
//!
//! Nothing is said here that a declaration does not say; a page is its operation's text, its parameters as a table, and
//! what the example gives on a lot of 40 by 30 metres. Pages are Markdown, pictures PNG, both the same at every run.

mod chapters;
mod page;
mod picture;

pub use chapters::{PARTS, Part, others, part_of};
pub use picture::{Sheet, draw};

use crate::ops::{OPERATIONS, Spec};

/// A file of the manual.
pub struct Chapter {
    /// Where it stands below the manual's folder.
    pub path: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// Every page, without the pictures.
pub fn pages() -> Vec<Chapter> {
    let text = |path: &str, text: String| Chapter { path: path.into(), bytes: text.into() };
    let operation = |spec: &Spec| text(&page_path(spec), page::operation(spec));
    let mut chapters: Vec<Chapter> = OPERATIONS.iter().map(|o| operation(o.spec)).collect();
    chapters.extend([
        text("README.md", page::contents()),
        text("functions.md", page::functions()),
        text("selectors.md", page::selectors()),
        text("covers.md", page::covers()),
        text("elements.md", page::elements()),
    ]);
    chapters
}

/// The plan of every operation's example. Cost: a derivation and a drawing each, in the order of the manual.
///
/// An example that does not derive is a mistake of the declaration: the error says what was found.
pub fn pictures() -> Result<Vec<Chapter>, String> {
    let picture = |spec: &Spec| {
        let example = example(spec).ok_or_else(|| format!("`{}` has no example", spec.name))?;
        let bytes = draw(example, &Sheet::small()).map_err(|problem| format!("`{}`: {problem}", spec.name))?;
        Ok(Chapter { path: picture_path(spec), bytes })
    };
    OPERATIONS.iter().map(|o| picture(o.spec)).collect()
}

/// Where the page of an operation stands.
pub fn page_path(spec: &Spec) -> String {
    format!("operations/{}.md", spec.name)
}

/// Where the picture of an operation's example stands.
pub fn picture_path(spec: &Spec) -> String {
    format!("images/{}.png", spec.name)
}

/// The rules of an operation's example.
pub fn example(spec: &Spec) -> Option<&'static str> {
    spec.docs.split("```cga\n").nth(1)?.split("```").next()
}
