//! What each name of a piece is, told by the signs and brackets around it: a step of a rule, a value, an argument's name,
//! a selector; and what may stand at the place where a walk ends.
//!
//! In: the tokens of one piece, which may be broken anywhere. Out: roles of names, and the brackets that are open at the
//! end. It decides nothing about what is right; that is the grammar's.

use crate::ide::document::{Document, Sort};
use crate::ops::{self, BlockKind, Selectors};
use crate::syntax::{PieceKind, TokenKind};

/// What a name is where it stands; numbers are tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// The name that a definition defines.
    Defined(Sort),
    /// A parameter, where it is declared.
    Param,
    /// A name that `with` declares.
    Local,
    /// An operation, a rule or a leaf.
    Step,
    /// A rule of the import that is called before the dot: `plants(spacing = 3).Row`.
    Member(usize),
    /// An attribute, parameter, function or word.
    Value,
    /// `width` in `boundary(width = 4)`: of what stands before the parentheses.
    Argument(usize),
    /// `front` in `comp(f) { front : A }`, or a word that could be.
    Selector,
    /// `spacing` in `import plants : "plants.cga" (spacing)`.
    Given,
    /// A style that is used.
    Style,
    /// `Range` in `@Range(0, 1)`.
    Annotation,
    /// A word in an annotation.
    Word,
}

/// What a bare name would be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Before the sign of a definition.
    Head,
    /// A successor.
    Steps,
    /// The condition of a `case`: a value until the colon.
    Test,
    /// The head of a block's entry.
    Key,
    /// An expression.
    Value,
    /// A name of the imported file.
    Given,
    /// Parameters.
    Params,
    /// `with ( … )`.
    Locals,
    /// Styles of an import.
    Styles,
    /// The arguments of an annotation.
    Notes,
    /// Nothing that is known.
    Nothing,
}

/// An open bracket, or the piece itself.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    /// What a name would be here.
    pub mode: Mode,
    /// What follows the head of an entry, where this is a block.
    after: Mode,
    /// The opening bracket.
    opener: Option<usize>,
    /// The name before the bracket.
    pub owner: Option<usize>,
    /// The last step in it, to which a block belongs.
    step: Option<usize>,
    /// Which argument, from 0.
    pub argument: usize,
    /// The argument's name, where it has one.
    pub named: Option<usize>,
    /// At the beginning of an argument.
    pub fresh: bool,
    /// The parentheses of a call.
    pub is_call: bool,
    /// The braces of a block.
    pub is_block: bool,
}

/// A walk over the tokens of a piece.
pub(super) struct Walk<'d> {
    document: &'d Document,
    piece: usize,
    /// The piece, and the brackets that are open in it.
    pub frames: Vec<Frame>,
    /// The names so far.
    pub roles: Vec<(usize, Role)>,
    kind: PieceKind,
    is_named: bool,
}

impl Frame {
    fn new(mode: Mode, opener: Option<usize>, owner: Option<usize>) -> Frame {
        Frame {
            mode,
            after: mode,
            opener,
            owner,
            step: None,
            argument: 0,
            named: None,
            fresh: true,
            is_call: false,
            is_block: false,
        }
    }
}

impl<'d> Walk<'d> {
    /// From the beginning of a piece to a token, which is left out. Cost: linear, but quadratic in how deep blocks nest.
    pub fn until(document: &'d Document, piece: usize, end: usize) -> Walk<'d> {
        let part = &document.pieces[piece];
        let mut walk =
            Walk { document, piece, frames: Vec::new(), roles: Vec::new(), kind: part.kind, is_named: false };
        walk.kind = walk.likely_kind();
        let mode = if walk.kind == PieceKind::Stray { Mode::Nothing } else { Mode::Head };
        walk.frames.push(Frame::new(mode, None, None));
        for token in part.tokens.start..end.min(part.tokens.end) {
            walk.token(token);
        }
        walk
    }

    /// The innermost open bracket, or the piece.
    pub fn top(&self) -> &Frame {
        self.frames.last().expect("the piece itself is never closed")
    }

    /// A rule whose arrow is bent is a rule.
    fn likely_kind(&self) -> PieceKind {
        let part = &self.document.pieces[self.piece];
        let bent = || part.tokens.clone().take(8).any(|token| self.document.kind(token) == Some(TokenKind::Bent));
        if part.kind == PieceKind::Stray && bent() { PieceKind::Rule } else { part.kind }
    }

    fn token(&mut self, token: usize) {
        match self.document.kind(token) {
            Some(TokenKind::Name) => self.name(token),
            Some(TokenKind::Open) => self.open(token),
            Some(TokenKind::Close) => self.close(token),
            Some(kind) => self.sign(token, kind),
            None => {}
        }
        let top = self.top_mut();
        top.fresh = top.fresh && top.opener == Some(token);
        if matches!(self.document.kind(token), Some(TokenKind::Comma)) {
            self.top_mut().fresh = true;
        }
    }

    fn name(&mut self, token: usize) {
        let role = match self.top().mode {
            Mode::Head => self.head(token),
            Mode::Steps => Some(self.step(token)),
            Mode::Value | Mode::Test | Mode::Locals => Some(self.value(token)),
            Mode::Key => Some(self.key(token)),
            Mode::Given => Some(Role::Given),
            Mode::Params => Some(Role::Param),
            Mode::Styles => Some(Role::Style),
            Mode::Notes => Some(self.note(token)),
            Mode::Nothing => None,
        };
        self.roles.extend(role.map(|role| (token, role)));
    }

    fn head(&mut self, token: usize) -> Option<Role> {
        let next = self.document.kind(token + 1);
        let word = self.document.word(token);
        let sort = match self.kind {
            PieceKind::Annotation => return Some(Role::Annotation),
            PieceKind::Version | PieceKind::Stray => return None,
            PieceKind::Style if self.is_named => return (word != "extends").then_some(Role::Style),
            PieceKind::Style if word == "style" && next == Some(TokenKind::Name) => return None,
            _ if self.is_named => return None,
            PieceKind::Style => Sort::Style,
            PieceKind::Import => Sort::Import,
            PieceKind::Value => self.value_sort(),
            PieceKind::PaperRule if self.is_label(token) => return None,
            _ if matches!(word, "start" | "extension") && next == Some(TokenKind::Name) => return None,
            _ => Sort::Rule,
        };
        self.is_named = true;
        Some(Role::Defined(sort))
    }

    /// The id of a rule in the papers' notation: a name with its own colon or arrow follows.
    fn is_label(&self, token: usize) -> bool {
        let after = self.document.past_group(token + 3).unwrap_or(token + 3);
        token == self.document.pieces[self.piece].tokens.start
            && self.document.kind(token + 1) == Some(TokenKind::Colon)
            && self.document.kind(token + 2) == Some(TokenKind::Name)
            && matches!(self.document.kind(after), Some(TokenKind::Colon | TokenKind::Squiggle))
    }

    fn value_sort(&self) -> Sort {
        match self.document.kind(self.document.pieces[self.piece].tokens.start) {
            Some(TokenKind::Attr) => Sort::Attribute,
            Some(TokenKind::Const) => Sort::Constant,
            _ => Sort::Function,
        }
    }

    fn step(&mut self, token: usize) -> Role {
        if self.is_percentage(token) {
            return Role::Value;
        }
        if let Some(import) = self.called_before_dot(token) {
            return Role::Member(import);
        }
        self.top_mut().step = Some(token);
        Role::Step
    }

    /// Whether `%:` follows the name and its parentheses.
    fn is_percentage(&self, token: usize) -> bool {
        let after = self.document.past_group(token + 1).unwrap_or(token + 1);
        self.document.kind(after) == Some(TokenKind::Percent) && self.document.kind(after + 1) == Some(TokenKind::Colon)
    }

    /// The import of `import(…).Name`.
    fn called_before_dot(&self, token: usize) -> Option<usize> {
        let close = token.checked_sub(2).filter(|_| self.document.kind(token - 1) == Some(TokenKind::Dot))?;
        let bracket = self.document.tokens.get(close).filter(|t| t.kind == TokenKind::Close)?;
        let import = (bracket.link as usize).checked_sub(1)?;
        (self.document.kind(import) == Some(TokenKind::Name)).then_some(import)
    }

    fn value(&mut self, token: usize) -> Role {
        let next = self.document.kind(token + 1);
        let top = self.top_mut();
        match (top.owner, top.mode) {
            (_, Mode::Locals) if next == Some(TokenKind::Joined) => Role::Local,
            (Some(owner), _) if top.is_call && top.fresh && next == Some(TokenKind::Equal) => {
                top.named = Some(token);
                Role::Argument(owner)
            }
            _ => Role::Value,
        }
    }

    fn key(&self, token: usize) -> Role {
        let extra = match self.block() {
            Some(BlockKind::Selectors(extra)) => extra,
            Some(_) => return Role::Value,
            None => &[],
        };
        let word = self.document.word(token);
        let known = Selectors::of_word(word).is_some() || extra.contains(&word) || word == "remainder";
        let alone =
            !matches!(self.document.kind(token + 1), Some(TokenKind::Open | TokenKind::Sign | TokenKind::Logic));
        if known && alone { Role::Selector } else { Role::Value }
    }

    fn note(&self, token: usize) -> Role {
        match (self.top().owner, self.document.kind(token + 1)) {
            (Some(owner), Some(TokenKind::Equal)) => Role::Argument(owner),
            _ => Role::Word,
        }
    }

    fn open(&mut self, token: usize) {
        let before = token.checked_sub(1).filter(|before| self.document.kind(*before) == Some(TokenKind::Name));
        let byte = self.document.word(token).as_bytes().first().copied();
        let frame = match (byte, self.top().mode) {
            (_, Mode::Head) => Frame::new(self.head_bracket(token), Some(token), before),
            (_, Mode::Given) => Frame::new(Mode::Params, Some(token), before),
            (_, mode @ (Mode::Nothing | Mode::Notes | Mode::Styles | Mode::Params)) => {
                Frame::new(mode, Some(token), None)
            }
            (Some(b'{'), mode) => self.block_at(token, mode),
            (Some(b'['), Mode::Steps) => Frame::new(Mode::Steps, Some(token), None),
            (Some(b'('), _) if before.is_some() => {
                Frame { is_call: true, ..Frame::new(Mode::Value, Some(token), before) }
            }
            _ => Frame::new(Mode::Value, Some(token), None),
        };
        self.frames.push(frame);
    }

    fn head_bracket(&self, token: usize) -> Mode {
        let before = token.checked_sub(1).and_then(|before| self.document.kind(before));
        match self.kind {
            PieceKind::Annotation => Mode::Notes,
            PieceKind::Import if before == Some(TokenKind::Text) => Mode::Given,
            PieceKind::Import => Mode::Styles,
            _ if before == Some(TokenKind::With) => Mode::Locals,
            _ => Mode::Params,
        }
    }

    /// `{ … }` of the last step, of the function before it, or of the block it stands in.
    fn block_at(&self, token: usize, mode: Mode) -> Frame {
        let top = self.top();
        let (owner, after) = match mode {
            Mode::Steps => (top.step, Mode::Steps),
            Mode::Key => (top.owner, top.after),
            _ => (None, Mode::Value),
        };
        let mut frame = Frame { after, is_block: true, ..Frame::new(Mode::Key, Some(token), owner) };
        frame.mode = self.entry(token + 1, &frame);
        frame
    }

    /// What an entry of a block begins with: a head, or what it leads to.
    fn entry(&self, from: usize, frame: &Frame) -> Mode {
        let block = frame.owner.and_then(|owner| ops::find(self.document.word(owner))).map(|o| o.spec.block);
        if matches!(block, Some(BlockKind::Body | BlockKind::Operands(_)))
            || self.document.kind(from) == Some(TokenKind::Case)
        {
            return frame.after;
        }
        let end = self.document.pieces[self.piece].tokens.end;
        let mut at = from;
        while at < end {
            match self.document.kind(at) {
                Some(TokenKind::Bar | TokenKind::Close) | None => break,
                Some(TokenKind::Colon) if self.document.kind(at - 1) == Some(TokenKind::Percent) => return frame.after,
                Some(TokenKind::Colon | TokenKind::Equal | TokenKind::Joined) => return Mode::Key,
                Some(TokenKind::Open) => at = self.document.past_group(at).unwrap_or(at + 1),
                _ => at += 1,
            }
        }
        let headed = matches!(block, Some(BlockKind::Cuts | BlockKind::Selectors(_)));
        if headed || frame.after == Mode::Value { Mode::Key } else { frame.after }
    }

    fn close(&mut self, token: usize) {
        let wanted = match self.document.word(token) {
            ")" => "(",
            "]" => "[",
            _ => "{",
        };
        let opens = |frame: &Frame| frame.opener.is_some_and(|opener| self.document.word(opener) == wanted);
        if let Some(index) = self.frames.iter().rposition(opens) {
            self.frames.truncate(index.max(1));
        }
    }

    fn sign(&mut self, token: usize, kind: TokenKind) {
        let depth = self.frames.len();
        let before = token.checked_sub(1).and_then(|before| self.document.kind(before));
        let (paper, named) = (self.kind == PieceKind::PaperRule, self.is_named);
        let is_list = self.top().opener.is_some_and(|o| o > 0 && self.document.kind(o - 1) == Some(TokenKind::Text));
        let entry = (kind == TokenKind::Bar && self.top().is_block).then(|| self.entry(token + 1, self.top()));
        // `length : depth : A`: a second colon ends the head.
        let is_length = kind == TokenKind::Colon
            && self.block() == Some(BlockKind::Perimeter)
            && self.entry(token + 1, self.top()) == Mode::Key;
        let top = self.top_mut();
        match (kind, top.mode) {
            (TokenKind::Colon, Mode::Key) if is_length => {}
            (TokenKind::Comma, Mode::Value | Mode::Steps) if is_list => top.mode = Mode::Given,
            (TokenKind::Comma, _) => (top.argument, top.named) = (top.argument + 1, None),
            (TokenKind::Bar, _) => top.mode = entry.unwrap_or(top.mode),
            (TokenKind::Case, Mode::Steps) => top.mode = Mode::Test,
            (TokenKind::Colon, Mode::Test) => top.mode = Mode::Steps,
            (TokenKind::Colon | TokenKind::Equal | TokenKind::Joined, Mode::Key) => top.mode = top.after,
            (TokenKind::Colon, Mode::Head) if paper && named => top.mode = Mode::Value,
            (TokenKind::Colon, Mode::Steps) if paper && depth == 1 => {
                let choice = matches!(before, Some(TokenKind::Else | TokenKind::Percent));
                top.mode = if choice { Mode::Steps } else { Mode::Value };
            }
            (TokenKind::Arrow | TokenKind::Squiggle | TokenKind::Bent, Mode::Head | Mode::Given) => {
                top.mode = Mode::Steps;
            }
            (TokenKind::Squiggle, _) if depth == 1 => top.mode = Mode::Steps,
            (TokenKind::Equal, Mode::Head | Mode::Given) => top.mode = Mode::Value,
            _ => {}
        }
    }

    /// What the block under way takes, where its operation is known.
    fn block(&self) -> Option<BlockKind> {
        let owner = self.top().owner?;
        ops::find(self.document.word(owner)).map(|operation| operation.spec.block)
    }

    fn top_mut(&mut self) -> &mut Frame {
        self.frames.last_mut().expect("the piece itself is never closed")
    }
}
