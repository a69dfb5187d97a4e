//! What can be folded: definitions, blocks and brackets over several lines, runs of comments.

use crate::ide::Desk;
use crate::ide::document::Document;
use crate::syntax::{NO_PARTNER, TokenKind};
use std::ops::Range;

/// A stretch that can be folded.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// Where.
    pub range: Range<usize>,
    /// It is a comment.
    pub is_comment: bool,
}

impl Desk<'_> {
    /// Everything in a file that takes more than a line and can be folded, in order.
    pub fn folds(&self, path: &str) -> Vec<Fold> {
        let Some(document) = self.document(path) else { return Vec::new() };
        let text = document.text();
        let definitions = document.definitions().iter().map(|definition| definition.whole.clone());
        let code = definitions.chain(brackets(&document)).map(|range| Fold { range, is_comment: false });
        let comments = comments(&document).into_iter().map(|range| Fold { range, is_comment: true });
        let mut found: Vec<Fold> = code.chain(comments).filter(|f| text[f.range.clone()].contains('\n')).collect();
        found.sort_by_key(|fold| (fold.range.start, std::cmp::Reverse(fold.range.end)));
        found
    }
}

fn brackets(document: &Document) -> impl Iterator<Item = Range<usize>> {
    let opening = document.tokens.iter().filter(|t| t.kind == TokenKind::Open && t.link != NO_PARTNER);
    opening.map(|open| open.start as usize..document.range(open.link as usize).end)
}

/// What stands between tokens and is no blank, from the first such character to the last; a free line parts comments.
fn comments(document: &Document) -> Vec<Range<usize>> {
    let (mut found, mut at) = (Vec::new(), 0);
    let ends = document.tokens.iter().map(|token| (token.start as usize, token.end as usize));
    for (start, end) in ends.chain([(document.text().len(), document.text().len())]) {
        let mut from = at;
        for part in document.text()[at..start].split("\n\n") {
            let trimmed = part.trim();
            let begin = from + (part.len() - part.trim_start().len());
            if !trimmed.is_empty() {
                found.push(begin..begin + trimmed.len());
            }
            from += part.len() + 2;
        }
        at = end;
    }
    found
}
