//! Columns: arrows, colons and comments that stood below each other stand below each other again.

use super::WIDTH;

/// What may be lined up, in the order in which it stands in a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Class {
    /// The arrow, equals sign or colon of a definition.
    Sign,
    /// The colon of an arm or alternative.
    Colon,
    /// A comment behind something.
    Comment,
}

/// A place in the text before which blanks may go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    /// Bytes before it.
    pub offset: usize,
    /// What stands there.
    pub class: Class,
    /// The column it had.
    pub column: usize,
}

/// The text with blanks before its marks, which ascend. Cost: linear.
pub(super) fn aligned(text: &str, marks: &[Mark]) -> String {
    let mut lines: Vec<Line> = lines(text, marks);
    for class in [Class::Sign, Class::Colon, Class::Comment] {
        let mut at = 0;
        while at < lines.len() {
            let run = run(&lines[at..], class);
            line_up(&mut lines[at..at + run.max(1)], class);
            at += run.max(1);
        }
    }
    written(text, marks, &lines)
}

/// A line and its marks, one of a class at most.
struct Line {
    /// Characters.
    width: usize,
    /// For each class the column in the new text, the one in the old text, and the blanks that go before it.
    marks: [Option<(usize, usize, usize)>; 3],
}

fn lines(text: &str, marks: &[Mark]) -> Vec<Line> {
    let (mut marks, mut start) = (marks.iter().peekable(), 0);
    let line = |line: &str| {
        let mut found = Line { width: line.trim_end().chars().count(), marks: [None; 3] };
        while let Some(mark) = marks.next_if(|mark| mark.offset < start + line.len()) {
            let column = line[..mark.offset - start].chars().count();
            found.marks[mark.class as usize].get_or_insert((column, mark.column, 0));
        }
        start += line.len();
        found
    };
    text.split_inclusive('\n').map(line).collect()
}

/// How many lines from the first one on have a mark of the class that stood in the same column.
fn run(lines: &[Line], class: Class) -> usize {
    let column = |line: &Line| line.marks[class as usize].map(|(_, old, _)| old);
    let Some(first) = lines.first().and_then(column) else { return 0 };
    lines.iter().take_while(|line| column(line) == Some(first)).count()
}

fn line_up(lines: &mut [Line], class: Class) {
    let index = class as usize;
    let moved = |line: &Line| line.marks[..index].iter().flatten().map(|mark| mark.2).sum::<usize>();
    let column = |line: &Line| line.marks[index].map_or(0, |mark| mark.0 + moved(line));
    let most = lines.iter().map(column).max().unwrap_or(0);
    let fits = |line: &Line| class == Class::Comment || line.width + moved(line) + most - column(line) <= WIDTH;
    if lines.len() < 2 || !lines.iter().all(fits) {
        return;
    }
    for line in lines {
        let blanks = most - column(line);
        line.marks[index] = line.marks[index].map(|(new, old, _)| (new, old, blanks));
    }
}

fn written(text: &str, marks: &[Mark], lines: &[Line]) -> String {
    let (mut out, mut marks, mut start) = (String::with_capacity(text.len()), marks.iter().peekable(), 0);
    for (line, laid) in text.split_inclusive('\n').zip(lines) {
        let (mut at, mut seen) = (0, [false; 3]);
        while let Some(mark) = marks.next_if(|mark| mark.offset < start + line.len()) {
            let class = mark.class as usize;
            if !std::mem::replace(&mut seen[class], true) {
                let blanks = laid.marks[class].map_or(0, |mark| mark.2);
                out.push_str(&line[at..mark.offset - start]);
                out.extend(std::iter::repeat_n(' ', blanks));
                at = mark.offset - start;
            }
        }
        out.push_str(&line[at..]);
        start += line.len();
    }
    out
}
