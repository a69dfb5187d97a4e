//! The suite's files as text: sections, their directives, and the notes that say what must be reported.
//!
//! A section begins with `// --- name stage ---` and holds one rule file, or several, each further one after
//! `// File: name.cga`. Under a line stands what must be reported about it:
//!
//!     Lot --> extrde(3)
//!     //      ^^^^^^ error: there is no operation or rule `extrde`
//!     // hint: did you mean `extrude`?
//!
//! Where a place begins too far left for carets, its columns stand instead (`// 1-3 error: …`); what has no place in
//! the section stands at its end (`// run note: …`). `UPDATE_SUITE=1` writes these lines.

use std::path::{Path, PathBuf};

/// One test.
pub struct Section {
    /// The suite's file.
    pub path: PathBuf,
    /// The line of its header, from 0.
    pub line: usize,
    /// Unique over the whole suite.
    pub name: String,
    /// What is tested: `check`, `tree` or `report`.
    pub stage: String,
    /// `// Word: text` lines.
    pub directives: Vec<(String, String)>,
    /// The rule files, the first being the main one.
    pub files: Vec<RuleFile>,
}

/// One rule file of a section, without its notes.
pub struct RuleFile {
    /// Its path.
    pub path: String,
    /// Its lines, each with its number in the suite's file, from 0.
    pub lines: Vec<(usize, String)>,
    /// What must be reported.
    pub notes: Vec<Note>,
}

/// One diagnostic as the suite writes it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Note {
    /// The line in the rule file, from 0; the number of lines where it has no place.
    pub line: usize,
    /// First and last column, from 1; `None` where it has no place.
    pub columns: Option<(usize, usize)>,
    /// `error: message`.
    pub text: String,
    /// Advice.
    pub hints: Vec<String>,
}

const DIRECTIVES: [&str; 8] = ["Layout", "Set", "Seed", "Limit", "Report", "Count", "Start", "Style"];

/// Every section under a folder, in the order of paths and lines.
pub fn sections(folder: &Path) -> Vec<Section> {
    let mut paths: Vec<PathBuf> = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).expect("the suite is there") {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() { folders.push(path) } else { paths.push(path) }
        }
    }
    paths.sort();
    let cga = paths.iter().filter(|path| path.extension().is_some_and(|e| e == "cga"));
    cga.flat_map(|path| sections_of(path, &std::fs::read_to_string(path).expect("a readable suite"))).collect()
}

fn sections_of(path: &Path, text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if let Some((name, stage)) = header(line) {
            let main = RuleFile { path: "main.cga".into(), lines: Vec::new(), notes: Vec::new() };
            let (path, name, stage) = (path.to_path_buf(), name.into(), stage.into());
            sections.push(Section { path, line: number, name, stage, directives: Vec::new(), files: vec![main] });
        } else if let Some(section) = sections.last_mut() {
            section.take(number, line);
        }
    }
    sections
}

fn header(line: &str) -> Option<(&str, &str)> {
    line.strip_prefix("// --- ")?.strip_suffix(" ---")?.split_once(' ')
}

impl Section {
    fn take(&mut self, number: usize, line: &str) {
        if let Some((word, text)) = directive(line) {
            return self.directives.push((word.into(), text.into()));
        }
        if let Some(path) = line.strip_prefix("// File: ") {
            return self.files.push(RuleFile { path: path.into(), lines: Vec::new(), notes: Vec::new() });
        }
        let file = self.files.last_mut().expect("a section has a file");
        let after = file.lines.len();
        match (note(line, after), line.strip_prefix("// hint: ")) {
            (Some(note), _) => file.notes.push(note),
            (None, Some(hint)) => file.notes.last_mut().expect("a hint follows a note").hints.push(hint.into()),
            (None, None) => file.lines.push((number, line.to_string())),
        }
    }

    /// The texts of a directive.
    pub fn all<'s>(&'s self, word: &'s str) -> impl Iterator<Item = &'s str> {
        self.directives.iter().filter(move |(w, _)| w == word).map(|(_, text)| text.as_str())
    }

    /// What `print` must give, in order: the comments `// = value`.
    pub fn prints(&self) -> Vec<&str> {
        let lines = self.files.iter().flat_map(|file| &file.lines);
        lines.filter_map(|(_, line)| line.split_once("// = ").map(|(_, value)| value)).collect()
    }

    /// Where a line of one of its files stands, as `path:line`.
    pub fn place(&self, file: usize, line: usize) -> String {
        let lines = &self.files[file].lines;
        let number = lines.get(line).or(lines.last()).map_or(self.line, |(number, _)| *number);
        format!("{}:{}", self.path.display(), number + 1)
    }

    /// Its text with other notes, one list per file.
    pub fn rewritten(&self, notes: &[Vec<Note>]) -> String {
        let mut lines = vec![format!("// --- {} {} ---", self.name, self.stage)];
        lines.extend(self.directives.iter().map(|(word, text)| format!("// {word}: {text}")));
        for (number, (file, notes)) in self.files.iter().zip(notes).enumerate() {
            lines.extend((number > 0).then(|| format!("// File: {}", file.path)));
            // What has no place stands before the blank lines that end a file.
            let content = file.lines.iter().rposition(|(_, line)| !line.is_empty()).map_or(0, |last| last + 1);
            for at in 0..=file.lines.len() {
                if at == content {
                    lines.extend(notes.iter().filter(|n| n.columns.is_none()).flat_map(Note::lines));
                }
                lines.extend(file.lines.get(at).map(|(_, line)| line.clone()));
                lines.extend(notes.iter().filter(|n| n.line == at && n.columns.is_some()).flat_map(Note::lines));
            }
        }
        lines.join("\n") + "\n"
    }
}

impl RuleFile {
    /// The text that is checked.
    pub fn text(&self) -> String {
        self.lines.iter().map(|(_, line)| format!("{line}\n")).collect()
    }
}

fn directive(line: &str) -> Option<(&str, &str)> {
    let (word, text) = line.strip_prefix("// ")?.split_once(": ")?;
    DIRECTIVES.contains(&word).then_some((word, text))
}

/// A line that says what must be reported about the line before it; `after` lines have gone before.
fn note(line: &str, after: usize) -> Option<Note> {
    let comment = line.strip_prefix("//")?;
    let (mark, text) = comment.trim_start().split_once(' ')?;
    let known = ["error: ", "warning: ", "note: "].iter().any(|word| text.starts_with(word));
    let columns = if mark == "run" {
        None
    } else if !mark.is_empty() && mark.chars().all(|c| c == '^') {
        let first = line.chars().take_while(|c| *c != '^').count() + 1;
        Some((first, first + mark.len() - 1))
    } else {
        let (first, last) = mark.split_once('-')?;
        Some((first.parse().ok()?, last.parse().ok()?))
    };
    let line = after.saturating_sub(usize::from(columns.is_some()));
    known.then(|| Note { line, columns, text: text.into(), hints: Vec::new() })
}

impl Note {
    /// As the suite writes it.
    pub fn lines(&self) -> Vec<String> {
        let first = match self.columns {
            None => format!("// run {}", self.text),
            Some((first, last)) if first > 3 => {
                format!("//{}{} {}", " ".repeat(first - 3), "^".repeat(last + 1 - first), self.text)
            }
            Some((first, last)) => format!("// {first}-{last} {}", self.text),
        };
        std::iter::once(first).chain(self.hints.iter().map(|hint| format!("// hint: {hint}"))).collect()
    }
}
