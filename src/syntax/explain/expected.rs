//! The last resort: what pest would have taken, as a few human phrases.

use super::Broken;
use crate::diag::Diagnostic;
use crate::syntax::grammar::Rule;

impl Broken<'_> {
    /// "expected … found …"
    pub(super) fn expected(&self, place: Option<usize>, positives: &[Rule]) -> Diagnostic {
        let mut phrases: Vec<&str> = Vec::new();
        for phrase in positives.iter().filter_map(|rule| phrase(*rule)).chain(self.closing(place)) {
            if !phrases.contains(&phrase) {
                phrases.push(phrase);
            }
        }
        if phrases.contains(&VALUE) || phrases.contains(&OPERATION) {
            phrases.retain(|phrase| !matches!(*phrase, "a name" | "a text in double quotes"));
        }
        let found = self.found(place);
        phrases.retain(|phrase| *phrase != found);
        let message = match phrases.split_last() {
            None => format!("{found} cannot stand here"),
            Some((last, [])) => format!("expected {last}, found {found}"),
            Some((last, rest)) => format!("expected {} or {last}, found {found}", rest.join(", ")),
        };
        self.error("syntax", self.place(place), message)
    }

    /// What would go on with, or end, the bracket around the place; pest does not tell about single signs.
    fn closing(&self, place: Option<usize>) -> Vec<&'static str> {
        let bracket = self.opener(place.unwrap_or(self.piece.tokens.end)).map(|opener| self.word(opener));
        match bracket {
            Some("(") => vec!["`,`", "`)`"],
            Some("[") => vec!["`]`"],
            Some("{") => vec!["`|`", "`}`"],
            _ => Vec::new(),
        }
    }
}

const VALUE: &str = "a value";
const OPERATION: &str = "an operation or symbol";

/// A rule of the grammar as people would say it; `None` for what would only be noise.
fn phrase(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::number | Rule::paren | Rule::array | Rule::prefix | Rule::value | Rule::condition => "a value",
        Rule::element | Rule::row | Rule::probability | Rule::key => VALUE,
        Rule::case_values | Rule::chance => VALUE,
        Rule::step | Rule::push | Rule::inline | Rule::perimeter | Rule::perimeter_name => OPERATION,
        Rule::body | Rule::entry => OPERATION,
        Rule::name => "a name",
        Rule::text => "a text in double quotes",
        Rule::params => "parameters in parentheses",
        Rule::styles | Rule::overrides | Rule::args | Rule::notes => "`(`",
        Rule::overriding => "a name",
        Rule::block | Rule::values_block | Rule::perimeter_block => "`{`",
        Rule::separator => "`:`",
        Rule::assign => "`:=`",
        Rule::sum | Rule::product | Rule::comparison | Rule::and | Rule::or => "an operator",
        Rule::percentage => "a percentage",
        Rule::else_word => "`else`",
        _ => return None,
    })
}
