//! A regular expression as a tree.
//!
//! Letters, `.`, classes `[a-z]` `[^;]` `\d \w \s`, groups, `|`, `* + ? {2,5}` and their lazy forms, `^ $ \b \B`.
//! Looking ahead or back, and back-references, are not understood, and said to be.

/// A part of an expression.
#[derive(Clone, Debug)]
pub(super) enum Node {
    /// One letter of a set.
    Set(Set),
    /// Where something must hold between two letters.
    Edge(Edge),
    /// One after the other.
    Sequence(Vec<Node>),
    /// The first that leads on.
    Either(Vec<Node>),
    /// Again and again: from so many times to so many, as often or as seldom as possible.
    Repeat(Box<Node>, usize, Option<usize>, bool),
}

/// Letters, by ranges; or all others.
#[derive(Clone, Debug, Default)]
pub(super) struct Set {
    pub ranges: Vec<(char, char)>,
    pub others: bool,
}

/// What holds between two letters.
#[derive(Clone, Copy, Debug)]
pub(super) enum Edge {
    /// `^`
    Start,
    /// `$`
    End,
    /// `\b`, or `\B` where it is false.
    Word(bool),
}

impl Set {
    /// Whether a letter is in it.
    pub fn has(&self, letter: char) -> bool {
        self.ranges.iter().any(|(low, high)| (*low..=*high).contains(&letter)) != self.others
    }
}

/// Brackets within brackets.
const DEEPEST: usize = 50;
/// The most that `{n}` repeats.
const MOST_TIMES: usize = 1_000;

/// Reads an expression.
pub(super) fn parse(text: &str) -> Result<Node, String> {
    let mut parser = Parser { rest: text.chars().peekable(), depth: 0 };
    let node = parser.either()?;
    match parser.rest.next() {
        None => Ok(node),
        Some(letter) => Err(format!("has a `{letter}` too many")),
    }
}

struct Parser<'a> {
    rest: std::iter::Peekable<std::str::Chars<'a>>,
    depth: usize,
}

impl Parser<'_> {
    fn takes(&mut self, letter: char) -> bool {
        self.rest.next_if_eq(&letter).is_some()
    }

    fn either(&mut self) -> Result<Node, String> {
        let mut ways = vec![self.sequence()?];
        while self.takes('|') {
            ways.push(self.sequence()?);
        }
        Ok(if ways.len() == 1 { ways.remove(0) } else { Node::Either(ways) })
    }

    fn sequence(&mut self) -> Result<Node, String> {
        let mut nodes = Vec::new();
        while let Some(letter) = self.rest.next_if(|letter| !matches!(letter, '|' | ')')) {
            let node = self.atom(letter)?;
            let node = self.repeated(node)?;
            // What is nothing would be repeated without ever coming to the limit of steps.
            if !is_nothing(&node) {
                nodes.push(node);
            }
        }
        Ok(Node::Sequence(nodes))
    }

    fn atom(&mut self, letter: char) -> Result<Node, String> {
        Ok(match letter {
            '.' => Node::Set(Set { ranges: vec![('\n', '\n')], others: true }),
            '^' => Node::Edge(Edge::Start),
            '$' => Node::Edge(Edge::End),
            '(' => self.group()?,
            '[' => Node::Set(self.class()?),
            '\\' => self.escaped()?,
            '*' | '+' | '?' => return Err(format!("has a `{letter}` with nothing before it to repeat")),
            letter => Node::Set(one(letter)),
        })
    }

    fn group(&mut self) -> Result<Node, String> {
        if self.takes('?') && !self.takes(':') {
            return Err("looks ahead or back with `(?`, which is not understood".into());
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("has brackets more than {DEEPEST} deep"));
        }
        let inner = self.either()?;
        self.depth -= 1;
        if self.takes(')') { Ok(inner) } else { Err("has a `(` that is never closed".into()) }
    }

    fn repeated(&mut self, node: Node) -> Result<Node, String> {
        let (least, most) = match self.rest.peek() {
            Some('*') => (0, None),
            Some('+') => (1, None),
            Some('?') => (0, Some(1)),
            Some('{') => {
                self.rest.next();
                let range = self.times()?;
                return Ok(self.lazy(node, range));
            }
            _ => return Ok(node),
        };
        self.rest.next();
        Ok(self.lazy(node, (least, most)))
    }

    fn lazy(&mut self, node: Node, (least, most): (usize, Option<usize>)) -> Node {
        let greedy = !self.takes('?');
        Node::Repeat(Box::new(node), least, most, greedy)
    }

    /// `2}`, `2,}` or `2,5}`.
    fn times(&mut self) -> Result<(usize, Option<usize>), String> {
        let mut text = String::new();
        while let Some(letter) = self.rest.next_if(|letter| *letter != '}') {
            text.push(letter);
        }
        let wrong = || format!("repeats `{{{text}}}`, which is no number of times");
        if !self.takes('}') {
            return Err(wrong());
        }
        let count = |part: &str| part.trim().parse::<usize>().ok().filter(|n| *n <= MOST_TIMES).ok_or_else(wrong);
        let (least, most) = match text.split_once(',') {
            None => (count(&text)?, Some(count(&text)?)),
            Some((least, "")) => (count(least)?, None),
            Some((least, most)) => (count(least)?, Some(count(most)?)),
        };
        if most.is_some_and(|most| most < least) { Err(wrong()) } else { Ok((least, most)) }
    }

    /// What follows a `[`.
    fn class(&mut self) -> Result<Set, String> {
        let mut set = Set { ranges: Vec::new(), others: self.takes('^') };
        let mut first = true;
        loop {
            let letter = self.rest.next().ok_or("has a `[` that is never closed")?;
            if letter == ']' && !first {
                return Ok(set);
            }
            first = false;
            let low = match letter {
                '\\' => match self.escaped()? {
                    Node::Set(Set { ranges, others: false }) if ranges.len() == 1 && ranges[0].0 == ranges[0].1 => {
                        ranges[0].0
                    }
                    Node::Set(Set { ranges, others: false }) => {
                        set.ranges.extend(ranges);
                        continue;
                    }
                    _ => return Err("has a class within a class that is not understood".into()),
                },
                letter => letter,
            };
            set.ranges.push((low, self.high(low)?));
        }
    }

    /// The end of a range that begins with `low`; itself where none does.
    fn high(&mut self, low: char) -> Result<char, String> {
        let mut ahead = self.rest.clone();
        if ahead.next() != Some('-') || matches!(ahead.peek(), None | Some(']')) {
            return Ok(low);
        }
        self.rest = ahead;
        match self.rest.next() {
            Some(high) if high >= low => Ok(high),
            _ => Err(format!("has a range from `{low}` that runs backwards")),
        }
    }

    /// What follows a `\`.
    fn escaped(&mut self) -> Result<Node, String> {
        let letter = self.rest.next().ok_or("ends in a `\\`")?;
        let ranges = match letter.to_ascii_lowercase() {
            'd' => vec![('0', '9')],
            'w' => vec![('a', 'z'), ('A', 'Z'), ('0', '9'), ('_', '_')],
            's' => vec![(' ', ' '), ('\t', '\r')],
            'b' => return Ok(Node::Edge(Edge::Word(letter == 'b'))),
            _ => Vec::new(),
        };
        Ok(Node::Set(match letter {
            _ if !ranges.is_empty() => Set { ranges, others: letter.is_ascii_uppercase() },
            't' => one('\t'),
            'n' => one('\n'),
            'r' => one('\r'),
            'x' => one(self.hexadecimal()?),
            '1'..='9' => return Err("refers back to a group, which is not understood".into()),
            letter => one(letter),
        }))
    }

    fn hexadecimal(&mut self) -> Result<char, String> {
        let digits: String = self.rest.by_ref().take(2).collect();
        let code = u8::from_str_radix(&digits, 16);
        code.map(char::from).map_err(|_| format!("has `\\x{digits}`, which is no letter"))
    }
}

/// Whether it fits the empty text alone, and at every place.
fn is_nothing(node: &Node) -> bool {
    match node {
        Node::Sequence(nodes) => nodes.is_empty(),
        Node::Repeat(inner, _, most, _) => *most == Some(0) || is_nothing(inner),
        Node::Set(_) | Node::Edge(_) | Node::Either(_) => false,
    }
}

fn one(letter: char) -> Set {
    Set { ranges: vec![(letter, letter)], others: false }
}
