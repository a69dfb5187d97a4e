//! Rule text → syntax tree: [`parse`] never fails; what is broken is reported and left out.
//!
//! A file is cut into tokens, the tokens into pieces (one annotation or definition each), and each piece is parsed alone
//! by `grammar/cga.pest`, the one place of syntax. So every broken definition has a diagnostic of its own and the others
//! stand. Nothing here knows which operations, functions or annotations arguments exist: names are resolved by `check`.

pub mod ast;

mod build;
mod depth;
mod explain;
mod format;
mod grammar;
mod outline;
mod paper;
mod source;
mod token;

pub use format::format;
pub use source::Source;

use crate::diag::{Diagnostic, Span};
use ast::{Annotation, File, Item, ItemKind, Text};
use build::Builder;
use explain::Broken;
use grammar::{Cga, Rule};
use outline::{Piece, PieceKind, outline};
use pest::Parser;
use pest::iterators::Pairs;
use token::{Kind, Token};

/// Files longer than this are refused: rules are written by people.
pub const MAX_BYTES: usize = 32 << 20;

/// pest gives up on a piece after so many steps. The grammar is linear and never comes near; this is the belt.
const MAX_STEPS: usize = 2_000_000_000;

/// The tree of the rule file with this number, and what is wrong with it.
///
/// Never fails and never stops at the first error: a broken definition is left out with an error inside its span.
/// Cost: linear in the text.
pub fn parse(file: u16, source: &Source) -> (File, Vec<Diagnostic>) {
    let mut parse = Parse { file, text: source.text(), reports: Vec::new(), tree: File::default(), noted: Vec::new() };
    parse.reports.extend(source.lint(file));
    parse.reports.extend(source.lint_nul(file));
    if parse.text.len() > MAX_BYTES {
        let message = format!("`{}` has more than {} MiB, too much for a rule file", source.path(), MAX_BYTES >> 20);
        parse.reports.push(Diagnostic::error("syntax-limit", Span { file, start: 0, end: 0 }, message));
    } else {
        parse.file();
    }
    (parse.tree, parse.reports)
}

/// One file under way.
struct Parse<'t> {
    file: u16,
    text: &'t str,
    reports: Vec<Diagnostic>,
    tree: File,
    /// Annotations waiting for their definition.
    noted: Vec<Annotation>,
}

impl<'t> Parse<'t> {
    fn file(&mut self) {
        pest::set_call_limit(std::num::NonZeroUsize::new(MAX_STEPS));
        let mut tokens = token::tokens(self.text);
        let pieces = outline(self.text, &mut tokens);
        let builder = Builder::new(self.file, own_names(self.text, &tokens, &pieces));
        for piece in &pieces {
            self.piece(&builder, &tokens, piece);
        }
        self.flush_notes();
    }

    fn piece(&mut self, builder: &Builder<'t>, tokens: &[Token], piece: &Piece) {
        let broken = Broken { file: self.file, text: self.text, tokens, piece };
        if let Some(report) = broken.before_parsing() {
            return self.fail(piece, report);
        }
        match piece.kind {
            PieceKind::Annotation => self.annotation(builder, &broken),
            PieceKind::Version => {
                if let Some(version) = self.read(builder, &broken, Rule::version_piece, Builder::version) {
                    self.version(version);
                }
            }
            kind => {
                let (rule, build): (Rule, Build<'t, ItemKind>) = match kind {
                    PieceKind::Import => (Rule::import_piece, Builder::import),
                    PieceKind::Style => (Rule::style_piece, Builder::style),
                    PieceKind::Value => (Rule::value_piece, Builder::definition),
                    PieceKind::PaperRule => (Rule::paper_piece, Builder::paper_rule),
                    _ => (Rule::rule_piece, Builder::rule),
                };
                match self.read(builder, &broken, rule, build) {
                    Some(kind) => self.define(kind, piece),
                    None => self.noted.clear(),
                }
            }
        }
    }

    /// Parses and builds a piece; what is wrong goes to the reports.
    fn read<T>(&mut self, builder: &Builder<'t>, broken: &Broken, rule: Rule, build: Build<'t, T>) -> Option<T> {
        let bytes = &broken.piece.bytes;
        let text: &'t str = &self.text[bytes.start as usize..bytes.end as usize];
        match Cga::parse(rule, text) {
            Ok(mut pairs) => {
                let inside = pairs.next().map(|pair| pair.into_inner());
                let (built, reports) = builder.piece(bytes.start, |builder| build(builder, inside?));
                self.reports.extend(reports);
                built
            }
            Err(error) => {
                self.reports.push(broken.explain(&error));
                None
            }
        }
    }

    /// An annotation changes nothing in what is derived: one that cannot be read is a lint, and left out.
    fn annotation(&mut self, builder: &Builder<'t>, broken: &Broken) {
        let before = self.reports.len();
        let annotation = self.read(builder, broken, Rule::annotation_piece, Builder::annotation);
        for report in &mut self.reports[before..] {
            report.severity = crate::diag::Severity::Lint;
            report.code = "syntax-annotation";
        }
        if let Some(annotation) = annotation {
            self.reports.extend(explain::unknown_annotation(&annotation.name));
            self.noted.push(annotation);
        }
    }

    fn version(&mut self, version: Text) {
        self.flush_notes();
        match &self.tree.version {
            None => self.tree.version = Some(version),
            Some(first) => {
                let message = format!("the version is said a second time; `{}` holds", first.text);
                self.reports.push(Diagnostic::lint("syntax-version", version.span, message));
            }
        }
    }

    fn define(&mut self, kind: ItemKind, piece: &Piece) {
        let span = Span { file: self.file, start: piece.bytes.start, end: piece.bytes.end };
        let annotations = std::mem::take(&mut self.noted);
        let span = annotations.first().map_or(span, |first| first.span.to(span));
        self.tree.items.push(Item { annotations, kind, span });
    }

    /// Annotations that no definition follows.
    fn flush_notes(&mut self) {
        if let (Some(first), Some(last)) = (self.noted.first(), self.noted.last()) {
            let span = first.span.to(last.span);
            self.tree.items.push(Item { annotations: std::mem::take(&mut self.noted), kind: ItemKind::Nothing, span });
        }
    }

    fn fail(&mut self, piece: &Piece, report: Diagnostic) {
        self.reports.push(report);
        if piece.kind != PieceKind::Annotation {
            self.noted.clear();
        }
    }
}

/// Makes a part of the tree from the inside of a piece.
type Build<'t, T> = fn(&Builder<'t>, Pairs<'t, Rule>) -> Option<T>;

/// The papers' names this file has rules for.
fn own_names<'t>(text: &'t str, tokens: &[Token], pieces: &[Piece]) -> Vec<&'t str> {
    let rules = pieces.iter().filter(|piece| matches!(piece.kind, PieceKind::Rule | PieceKind::PaperRule));
    let before_arrow = |token: &&Token| !matches!(token.kind, Kind::Arrow | Kind::Squiggle);
    let heads = rules.flat_map(|piece| tokens[piece.tokens.clone()].iter().take(3).take_while(before_arrow));
    let words = heads.map(|token| &text[token.start as usize..token.end as usize]);
    let mut own: Vec<&str> = words.filter(|word| paper::NAMES.contains(word)).collect();
    own.sort_unstable();
    own.dedup();
    own
}
