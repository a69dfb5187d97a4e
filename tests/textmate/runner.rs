//! A small TextMate runner: text and grammar → the innermost scope of every stretch, as editors see it.
//!
//! It has what the grammar of this house uses: `match`, `begin` and `end`, captures, includes of the repository.

use fancy_regex::Regex;
use serde_json::Value;
use std::collections::BTreeMap;

/// A grammar, read.
pub struct Grammar {
    patterns: Vec<Pattern>,
    repository: BTreeMap<String, Vec<Pattern>>,
}

enum Pattern {
    Match(Regex, String, BTreeMap<usize, String>),
    Region(Box<Region>),
    Include(String),
}

struct Region {
    begin: Regex,
    end: Regex,
    name: String,
    inside: Vec<Pattern>,
}

/// A stretch of a text with its innermost scope.
#[derive(Debug)]
pub struct Scoped<'t> {
    /// The stretch.
    pub text: &'t str,
    /// Its scope, empty where it has none.
    pub scope: String,
}

impl Grammar {
    /// The grammar of a `.tmLanguage.json`.
    pub fn read(json: &Value) -> Grammar {
        let repository = json["repository"].as_object().expect("a repository");
        let rules = repository.iter().map(|(name, rule)| (name.clone(), patterns(&rule["patterns"])));
        Grammar { patterns: patterns(&json["patterns"]), repository: rules.collect() }
    }

    /// The scopes of a text, line by line, blanks left out.
    pub fn scopes<'t>(&self, text: &'t str) -> Vec<Scoped<'t>> {
        let (mut found, mut open) = (Vec::new(), Vec::new());
        text.lines().for_each(|line| self.line(line, &mut open, &mut found));
        found.retain(|scoped| !scoped.text.trim().is_empty());
        found
    }

    fn line<'g, 't>(&'g self, line: &'t str, open: &mut Vec<&'g Region>, found: &mut Vec<Scoped<'t>>) {
        let mut at = 0;
        while at <= line.len() {
            let scope = open.last().map_or(String::new(), |region| region.name.clone());
            let patterns = open.last().map_or(&self.patterns, |region| &region.inside);
            let end = open.last().and_then(|region| span(&region.end, line, at));
            let best = self.first(patterns, line, at).filter(|(start, _)| end.is_none_or(|(stop, _)| *start < stop));
            match (best, end) {
                (Some((start, pattern)), _) => {
                    found.push(Scoped { text: &line[at..start], scope });
                    at = self.apply(pattern, line, start, open, found);
                }
                (None, Some((start, stop))) => {
                    found.push(Scoped { text: &line[at..start], scope: scope.clone() });
                    found.push(Scoped { text: &line[start..stop], scope });
                    open.pop();
                    at = stop;
                }
                (None, None) => {
                    found.push(Scoped { text: &line[at..], scope });
                    return;
                }
            }
        }
    }

    /// The pattern that matches first, the earlier one of two.
    fn first<'g>(&'g self, patterns: &'g [Pattern], line: &str, at: usize) -> Option<(usize, &'g Pattern)> {
        let candidates = patterns.iter().filter_map(|pattern| match pattern {
            Pattern::Match(regex, ..) => Some((span(regex, line, at)?.0, pattern)),
            Pattern::Region(region) => Some((span(&region.begin, line, at)?.0, pattern)),
            Pattern::Include(name) => self.first(&self.repository[name], line, at),
        });
        candidates.min_by_key(|(start, _)| *start)
    }

    /// Scopes what a pattern matches; where it ends.
    fn apply<'g, 't>(
        &'g self,
        pattern: &'g Pattern,
        line: &'t str,
        start: usize,
        open: &mut Vec<&'g Region>,
        found: &mut Vec<Scoped<'t>>,
    ) -> usize {
        match pattern {
            Pattern::Match(regex, name, captures) => {
                let groups = regex.captures_from_pos(line, start).expect("a regex").expect("it has matched");
                let whole = groups.get(0).expect("the whole").range();
                let mut at = whole.start;
                for (range, scope) in captures.iter().filter_map(|(n, scope)| Some((groups.get(*n)?.range(), scope))) {
                    found.push(Scoped { text: &line[at..range.start], scope: name.clone() });
                    found.push(Scoped { text: &line[range.clone()], scope: scope.clone() });
                    at = range.end;
                }
                found.push(Scoped { text: &line[at..whole.end], scope: name.clone() });
                assert!(whole.end > start, "`{name}` matches nothing in {line:?}");
                whole.end
            }
            Pattern::Region(region) => {
                let (start, end) = span(&region.begin, line, start).expect("it has matched");
                found.push(Scoped { text: &line[start..end], scope: region.name.clone() });
                open.push(region);
                end
            }
            Pattern::Include(_) => unreachable!("`first` looks into includes"),
        }
    }
}

fn patterns(list: &Value) -> Vec<Pattern> {
    list.as_array().expect("patterns").iter().map(pattern).collect()
}

fn pattern(rule: &Value) -> Pattern {
    let regex = |key: &str| Regex::new(rule[key].as_str().expect("a regex")).unwrap_or_else(|e| panic!("{rule}: {e}"));
    let name = rule["name"].as_str().unwrap_or_default().to_string();
    if let Some(include) = rule["include"].as_str() {
        return Pattern::Include(include.trim_start_matches('#').to_string());
    }
    if rule.get("begin").is_some() {
        let inside = rule.get("patterns").map_or(Vec::new(), patterns);
        return Pattern::Region(Box::new(Region { begin: regex("begin"), end: regex("end"), name, inside }));
    }
    let captures = rule["captures"].as_object().into_iter().flatten();
    let captures =
        captures.map(|(n, c)| (n.parse().expect("a number"), c["name"].as_str().expect("a name").to_string()));
    Pattern::Match(regex("match"), name, captures.collect())
}

fn span(regex: &Regex, line: &str, at: usize) -> Option<(usize, usize)> {
    regex.find_from_pos(line, at).expect("a regex that ends").map(|found| (found.start(), found.end()))
}
