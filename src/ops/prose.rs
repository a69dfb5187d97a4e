//! What an operation's declaration says in words, as the pages of manual, command and editor all say it.

use crate::ops::{Param, Spec};

impl Spec {
    /// Its doc comment as Markdown, every line ended.
    pub fn prose(&self) -> String {
        self.docs.lines().map(|line| format!("{}\n", line.strip_prefix(' ').unwrap_or(line))).collect()
    }

    /// The first sentence of its doc comment, on one line.
    pub fn summary(&self) -> String {
        let lines = self.docs.lines().map(str::trim);
        let lines: Vec<&str> = lines.take_while(|line| !line.is_empty() && !line.starts_with("```")).collect();
        let paragraph = lines.join(" ");
        paragraph.find(". ").map_or(paragraph.clone(), |end| paragraph[..=end].to_owned())
    }

    /// A paragraph with its other names; empty where it has none.
    pub fn also_called(&self) -> String {
        let names: Vec<String> = self.aliases.iter().map(|alias| format!("`{alias}`")).collect();
        if names.is_empty() { String::new() } else { format!("\nAlso called {}.\n", names.join(", ")) }
    }
}

impl Param {
    /// What it means, on one line.
    pub fn meaning(&self) -> String {
        self.docs.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}
