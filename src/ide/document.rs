//! One rule file as an editor has it: its text cut into tokens and pieces, what each name in it is, what it defines.
//!
//! In: any bytes. Out: a [`Document`]. What a name *means* is not known here: that may need other files.

use crate::ide::walk::{Role, Walk};
use crate::syntax::{NO_PARTNER, Piece, PieceKind, Source, Token, TokenKind, pieces};
use std::collections::BTreeMap;
use std::ops::Range;

/// A rule file, whole or broken.
pub struct Document {
    source: Source,
    pub(super) tokens: Vec<Token>,
    pub(super) pieces: Vec<Piece>,
    definitions: Vec<Definition>,
    /// Indices of definitions by their names.
    by_name: BTreeMap<String, Vec<usize>>,
    pub(super) names: Vec<NameUse>,
}

/// A name in a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct NameUse {
    /// Its token.
    pub token: usize,
    /// The piece that it stands in.
    pub piece: usize,
    /// What it is there.
    pub role: Role,
}

/// Something that a file defines.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Its name; with the import's name before it where a rule of an import is replaced.
    pub name: String,
    /// What it is.
    pub sort: Sort,
    /// Where its name is written.
    pub at: Range<usize>,
    /// From its first annotation to its end.
    pub whole: Range<usize>,
    /// The names of its parameters; `None` without parentheses.
    pub params: Option<Vec<String>>,
    /// Its piece.
    pub(super) piece: usize,
    /// The pieces of the annotations before it.
    pub(super) annotations: Range<usize>,
}

/// What a definition defines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sort {
    /// `Lot --> …`
    Rule,
    /// `attr a = …`
    Attribute,
    /// `const a = …`
    Constant,
    /// `f(x) = …`
    Function,
    /// `import a : "…"`
    Import,
    /// `style A`
    Style,
}

impl Document {
    /// The file at `path` with these bytes. Cost: linear, but for brackets that nest.
    pub fn new(path: &str, bytes: &[u8]) -> Document {
        let source = Source::new(path, bytes);
        let (tokens, pieces) = pieces(source.text());
        let mut document =
            Document { source, tokens, pieces, definitions: Vec::new(), by_name: BTreeMap::new(), names: Vec::new() };
        for piece in 0..document.pieces.len() {
            let end = document.pieces[piece].tokens.end;
            let roles = Walk::until(&document, piece, end).roles;
            document.names.extend(roles.into_iter().map(|(token, role)| NameUse { token, piece, role }));
        }
        document.definitions = document.define();
        for (index, definition) in document.definitions.iter().enumerate() {
            document.by_name.entry(definition.name.clone()).or_default().push(index);
        }
        document
    }

    /// Its path.
    pub fn path(&self) -> &str {
        self.source.path()
    }

    /// Its text.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The text as it was read.
    pub(super) fn source(&self) -> &Source {
        &self.source
    }

    /// What it defines, in order.
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// Its definitions of a name, in order. Cost: logarithmic in the names.
    pub(super) fn named(&self, name: &str) -> impl Iterator<Item = &Definition> {
        let indices = self.by_name.get(name).map_or(&[][..], Vec::as_slice);
        indices.iter().map(|index| &self.definitions[*index])
    }

    /// The definition that a piece is.
    pub(super) fn definition_of(&self, piece: usize) -> Option<&Definition> {
        let index = self.definitions.binary_search_by_key(&piece, |definition| definition.piece).ok()?;
        self.definitions.get(index)
    }

    /// The use of a name at a token.
    pub(super) fn name_at(&self, token: usize) -> Option<NameUse> {
        let index = self.names.binary_search_by_key(&token, |name| name.token).ok()?;
        self.names.get(index).copied()
    }

    /// The token at or just before a byte; of two that touch there, the name or text.
    pub(super) fn token_at(&self, offset: usize) -> Option<usize> {
        let after = self.tokens.partition_point(|token| token.start as usize <= offset);
        let covers = |index: &usize| self.tokens.get(*index).is_some_and(|token| offset <= token.end as usize);
        let last = after.checked_sub(1).filter(covers)?;
        let speaks = |index: usize| matches!(self.tokens[index].kind, TokenKind::Name | TokenKind::Text);
        let before = last.checked_sub(1).filter(covers).filter(|before| speaks(*before) && !speaks(last));
        Some(before.unwrap_or(last))
    }

    /// The piece of a token.
    pub(super) fn piece_of(&self, token: usize) -> usize {
        self.pieces.partition_point(|piece| piece.tokens.end <= token)
    }

    /// What a token is; `None` past the last.
    pub(super) fn kind(&self, token: usize) -> Option<TokenKind> {
        self.tokens.get(token).map(|token| token.kind)
    }

    /// Where a token stands.
    pub(super) fn range(&self, token: usize) -> Range<usize> {
        self.tokens.get(token).map_or(0..0, |token| token.start as usize..token.end as usize)
    }

    /// A token as written.
    pub(super) fn word(&self, token: usize) -> &str {
        &self.text()[self.range(token)]
    }

    /// The token after a bracket's partner.
    pub(super) fn past_group(&self, open: usize) -> Option<usize> {
        let token = self.tokens.get(open)?;
        (token.kind == TokenKind::Open && token.link != NO_PARTNER).then_some(token.link as usize + 1)
    }

    /// What a text token says, without quotes; escapes stay as written.
    pub(super) fn text_of(&self, token: usize) -> &str {
        let word = self.word(token);
        let inner = word.strip_prefix('"').unwrap_or(word);
        inner.strip_suffix('"').unwrap_or(inner)
    }

    fn define(&self) -> Vec<Definition> {
        let mut found: Vec<Definition> = Vec::new();
        for name in &self.names {
            match name.role {
                Role::Defined(sort) => found.push(self.definition(name, sort)),
                Role::Param => self.add_param(&mut found, name),
                _ => {}
            }
        }
        found
    }

    fn definition(&self, name: &NameUse, sort: Sort) -> Definition {
        let is_note = |piece: &&Piece| piece.kind == PieceKind::Annotation;
        let notes = self.pieces[..name.piece].iter().rev().take_while(is_note).count();
        let annotations = name.piece - notes..name.piece;
        let start = self.pieces[annotations.start].bytes.start as usize;
        let opens = self.kind(name.token + 1) == Some(TokenKind::Open)
            && matches!(sort, Sort::Rule | Sort::Function | Sort::Attribute | Sort::Constant);
        Definition {
            name: self.word(name.token).to_string(),
            sort,
            at: self.range(name.token),
            whole: start..self.pieces[name.piece].bytes.end as usize,
            params: opens.then(Vec::new),
            piece: name.piece,
            annotations,
        }
    }

    fn add_param(&self, found: &mut [Definition], name: &NameUse) {
        let owner =
            found.last_mut().filter(|definition| definition.piece == name.piece && definition.sort != Sort::Import);
        if let Some(params) = owner.and_then(|definition| definition.params.as_mut()) {
            params.push(self.word(name.token).to_string());
        }
    }
}

impl Sort {
    /// What people call it.
    pub fn word(self) -> &'static str {
        match self {
            Sort::Rule => "rule",
            Sort::Attribute => "attribute",
            Sort::Constant => "constant",
            Sort::Function => "function",
            Sort::Import => "import",
            Sort::Style => "style",
        }
    }
}
