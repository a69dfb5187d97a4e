//! How deep the tree of a piece will be, told from its tokens before anything recursive sees it.
//!
//! Every later stage walks the tree recursively, and dropping it is recursive too, so its height is bounded here once
//! for all: brackets, operator chains, prefixes and choices within choices all count.

use super::token::{Kind, NONE, Token};

/// How high the tree of one definition may be.
pub(super) const MAX_HEIGHT: usize = 512;

/// What a choice inside a choice counts: it takes more room than an operator when it is parsed.
const CHOICE: usize = 2;

/// The first token at which the tree may grow higher than [`MAX_HEIGHT`]. Cost: linear.
///
/// The estimate is never too low: operators count as if all hung below each other, up to the next comma or colon.
pub(super) fn too_high(tokens: &[Token], first: usize) -> Option<usize> {
    if tokens.len() < MAX_HEIGHT / CHOICE {
        return None;
    }
    let mut levels = vec![Level::default()];
    for (index, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Open => levels.push(Level::default()),
            Kind::Close if levels.len() > 1 => {
                let height = levels.pop().map_or(0, |level| level.height());
                top(&mut levels).within(height + 1);
            }
            Kind::Sign | Kind::Logic | Kind::Mark | Kind::Dot => top(&mut levels).chain += 1,
            Kind::Percent if !kind_is(tokens, index + 1, Kind::Colon) => top(&mut levels).chain += 1,
            Kind::Comma | Kind::Semicolon | Kind::Bar => top(&mut levels).next(),
            Kind::Colon | Kind::Joined => top(&mut levels).rest(),
            Kind::Case if index > 0 && kind_is(tokens, index - 1, Kind::Colon) => top(&mut levels).choices += CHOICE,
            Kind::Percent if chosen_within(tokens, index, first) => top(&mut levels).choices += CHOICE,
            _ => {}
        }
        if top(&mut levels).height() > MAX_HEIGHT {
            return Some(index);
        }
    }
    None
}

/// One pair of brackets under way.
#[derive(Clone, Copy, Default)]
struct Level {
    /// Operators since the last comma or colon.
    chain: usize,
    /// Choices directly inside choices since the last comma, weighed.
    choices: usize,
    /// The highest tree in brackets since the last comma or colon.
    inner: usize,
    /// The highest of what came before.
    highest: usize,
}

impl Level {
    fn height(self) -> usize {
        self.highest.max(self.inner + self.chain) + self.choices
    }

    fn within(&mut self, height: usize) {
        self.inner = self.inner.max(height);
    }

    /// At a colon: another operand or branch begins, inside the same choices.
    fn rest(&mut self) {
        self.highest = self.highest.max(self.inner + self.chain);
        (self.inner, self.chain) = (0, 0);
    }

    /// At a comma or bar: all that was is beside what comes.
    fn next(&mut self) {
        *self = Level { highest: self.height(), ..Level::default() };
    }
}

/// The innermost level; the outermost is never popped.
fn top(levels: &mut [Level]) -> &mut Level {
    let last = levels.len() - 1;
    &mut levels[last]
}

/// Whether the percentage before the `%` at `index` follows a colon: a choice directly inside another.
fn chosen_within(tokens: &[Token], index: usize, first: usize) -> bool {
    let Some(last) = index.checked_sub(1) else { return false };
    let start = match tokens[last] {
        Token { kind: Kind::Close, link, .. } if link != NONE => {
            let open = (link as usize).saturating_sub(first);
            open.saturating_sub(usize::from(open > 0 && kind_is(tokens, open - 1, Kind::Name)))
        }
        _ => last,
    };
    start > 0 && kind_is(tokens, start - 1, Kind::Colon)
}

fn kind_is(tokens: &[Token], index: usize, kind: Kind) -> bool {
    tokens.get(index).is_some_and(|t| t.kind == kind)
}
