//! Regular expressions by a list of threads that walk over the text together (Thompson 1968; Pike's virtual machine).

use crate::pattern::parse::{Edge, Node, Set, parse};

/// A regular expression. Matching costs the length of the text times that of the expression.
#[derive(Debug)]
pub struct Regex {
    steps: Vec<Step>,
}

#[derive(Debug)]
enum Step {
    /// A letter of the set, then the next step.
    Letter(Set),
    /// Something that holds here, then the next step.
    Edge(Edge),
    /// Both, the first before the second.
    Fork(usize, usize),
    /// On from there.
    Jump(usize),
    /// Found.
    End,
}

/// Steps of one expression.
const MOST_STEPS: usize = 10_000;

impl Regex {
    /// Reads an expression; a `$` that CityEngine puts before it is not part of it.
    pub fn new(text: &str) -> Result<Regex, String> {
        let failed = |reason: String| format!("takes a regular expression, and `{text}` {reason}");
        let mut regex = Regex { steps: Vec::new() };
        regex.compile(&parse(text).map_err(failed)?).map_err(failed)?;
        regex.steps.push(Step::End);
        Ok(regex)
    }

    /// Whether it fits the whole text.
    pub fn fits(&self, text: &str) -> bool {
        self.end(text, 0, true) == Some(text.len())
    }

    /// The parts of a text between what it finds. Nothing found at the start or end of the text splits nothing off.
    ///
    /// Cost: the square of the text's length at worst, where it looks far and finds nothing.
    pub fn split<'t>(&self, text: &'t str) -> Vec<&'t str> {
        let (mut parts, mut from, mut at) = (Vec::new(), 0, 0);
        while let Some(letter) = text[at..].chars().next() {
            match self.end(text, at, false) {
                Some(end) if end > at || (at > from && end == at) => {
                    parts.push(&text[from..at]);
                    from = end;
                    at = if end > at { end } else { at + letter.len_utf8() };
                }
                _ => at += letter.len_utf8(),
            }
        }
        parts.push(&text[from..]);
        parts
    }

    fn compile(&mut self, node: &Node) -> Result<(), String> {
        if self.steps.len() > MOST_STEPS {
            return Err(format!("is longer than {MOST_STEPS} steps"));
        }
        match node {
            Node::Set(set) => self.steps.push(Step::Letter(set.clone())),
            Node::Edge(edge) => self.steps.push(Step::Edge(*edge)),
            Node::Sequence(nodes) => nodes.iter().try_for_each(|node| self.compile(node))?,
            Node::Either(ways) => self.either(ways)?,
            Node::Repeat(inner, least, most, greedy) => self.repeat(inner, *least, *most, *greedy)?,
        }
        Ok(())
    }

    fn either(&mut self, ways: &[Node]) -> Result<(), String> {
        let mut ends = Vec::new();
        for (index, way) in ways.iter().enumerate() {
            let fork = self.steps.len();
            if index + 1 < ways.len() {
                self.steps.push(Step::Fork(fork + 1, 0));
            }
            self.compile(way)?;
            if index + 1 < ways.len() {
                ends.push(self.steps.len());
                self.steps.push(Step::Jump(0));
                self.steps[fork] = Step::Fork(fork + 1, self.steps.len());
            }
        }
        let after = self.steps.len();
        ends.into_iter().for_each(|end| self.steps[end] = Step::Jump(after));
        Ok(())
    }

    fn repeat(&mut self, inner: &Node, least: usize, most: Option<usize>, greedy: bool) -> Result<(), String> {
        for _ in 0..least {
            self.compile(inner)?;
        }
        let forked =
            |enter: usize, leave: usize| if greedy { Step::Fork(enter, leave) } else { Step::Fork(leave, enter) };
        let Some(most) = most else {
            let fork = self.steps.len();
            self.steps.push(Step::End);
            self.compile(inner)?;
            self.steps.push(Step::Jump(fork));
            self.steps[fork] = forked(fork + 1, self.steps.len());
            return Ok(());
        };
        let mut forks = Vec::new();
        for _ in least..most {
            forks.push(self.steps.len());
            self.steps.push(Step::End);
            self.compile(inner)?;
        }
        let after = self.steps.len();
        forks.into_iter().for_each(|fork| self.steps[fork] = forked(fork + 1, after));
        Ok(())
    }

    /// Where the match ends that begins at a byte; `whole` ones must reach the end of the text.
    fn end(&self, text: &str, from: usize, whole: bool) -> Option<usize> {
        let (mut now, mut next) = (Threads::new(self.steps.len()), Threads::new(self.steps.len()));
        self.follow(0, text, from, &mut now);
        let (mut at, mut found) = (from, None);
        loop {
            let letter = text[at..].chars().next();
            for index in 0..now.order.len() {
                match &self.steps[now.order[index]] {
                    Step::End if !whole || letter.is_none() => {
                        found = Some(at);
                        // What was tried after it is no better.
                        break;
                    }
                    Step::Letter(set) if letter.is_some_and(|letter| set.has(letter)) => {
                        let after = at + letter.map_or(0, char::len_utf8);
                        self.follow(now.order[index] + 1, text, after, &mut next);
                    }
                    _ => {}
                }
            }
            let Some(letter) = letter.filter(|_| !next.order.is_empty()) else { return found };
            at += letter.len_utf8();
            std::mem::swap(&mut now, &mut next);
            next.clear();
        }
    }

    /// Adds what can be reached from a step without a letter, in order.
    fn follow(&self, step: usize, text: &str, at: usize, threads: &mut Threads) {
        let mut waiting = vec![step];
        while let Some(step) = waiting.pop() {
            if std::mem::replace(&mut threads.seen[step], true) {
                continue;
            }
            match &self.steps[step] {
                Step::Jump(to) => waiting.push(*to),
                Step::Fork(first, second) => waiting.extend([*second, *first]),
                Step::Edge(edge) if holds(*edge, text, at) => waiting.push(step + 1),
                Step::Edge(_) => {}
                Step::Letter(_) | Step::End => threads.order.push(step),
            }
        }
    }
}

/// Steps at which a match stands, the preferred ones first.
struct Threads {
    order: Vec<usize>,
    seen: Vec<bool>,
}

impl Threads {
    fn new(steps: usize) -> Threads {
        Threads { order: Vec::new(), seen: vec![false; steps] }
    }

    fn clear(&mut self) {
        self.order.clear();
        self.seen.fill(false);
    }
}

fn holds(edge: Edge, text: &str, at: usize) -> bool {
    let is_word = |letter: Option<char>| letter.is_some_and(|c| c == '_' || c.is_ascii_alphanumeric());
    match edge {
        Edge::Start => at == 0,
        Edge::End => at == text.len(),
        Edge::Word(wanted) => (is_word(text[..at].chars().next_back()) != is_word(text[at..].chars().next())) == wanted,
    }
}

#[cfg(test)]
mod tests {
    use super::Regex;

    #[test]
    fn whole_texts_fit() {
        let fits = |expression: &str, text: &str| Regex::new(expression).unwrap().fits(text);
        assert!(fits("[12].png", "1.png") && fits(".*/[2-5]\\.png", "a/b/4.png") && fits("a|b.*", "bcd"));
        assert!(fits("tree_\\d{2,3}(_old)?", "tree_07_old") && fits("[^;]+", "é-x") && fits("(a*)*b", "aaab"));
        assert!(fits("_f([6-9]|[1-9][0-9]+).*", "_f12_x") && fits("a\\x20b", "a b"));
        assert!(!fits("[12].png", "3.png") && !fits("a|b", "ab") && !fits("x{2}", "xxx") && !fits("\\d", "x"));
        assert!(!fits("(a*)*(a*)*(a*)*c", &"a".repeat(2_000)));
    }

    #[test]
    fn texts_split_at_what_is_found() {
        let split = |expression: &str, text: &'static str| Regex::new(expression).unwrap().split(text);
        assert_eq!(split(";|\n", "a;b\nc"), ["a", "b", "c"]);
        assert_eq!(split("\t+", "a\t\tb\tc"), ["a", "b", "c"]);
        assert_eq!(split("\\B", "abc"), ["a", "b", "c"]);
        assert_eq!(split(",", ",a,"), ["", "a", ""]);
        assert_eq!(split("x", ""), [""]);
        assert_eq!(split("a*?b", "aabcb"), ["", "c", ""]);
    }

    #[test]
    fn what_is_not_understood_is_named() {
        for (expression, reason) in
            [("(a", "never closed"), ("[a", "never closed"), ("*a", "nothing before"), ("a)", "too many")]
        {
            let error = Regex::new(expression).unwrap_err();
            assert!(error.contains(reason), "{error}");
        }
        assert!(
            Regex::new("(?<=b)").is_err() && Regex::new("a{3,2}").is_err() && Regex::new("((a{1000}){1000})").is_err()
        );
        for nothing in ["", "a{0}", "((){2}|a){0}"] {
            let thrice = format!("x(((({nothing}){{1000}}){{1000}}){{1000}}){{1000}}y");
            assert!(Regex::new(&thrice).unwrap().fits("xy"));
        }
        assert!(Regex::new("((((|){1000}){1000}){1000}){1000}").is_err());
        assert!(Regex::new(&"(".repeat(10_000)).is_err() && Regex::new("\\").is_err() && Regex::new("(a)\\1").is_err());
    }
}
