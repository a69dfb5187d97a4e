//! Where lines break. Each part stands in one line if it fits and its author had it so; else its shape decides.

use super::INDENT;
use super::align::Class;
use super::structure::{Part, Shape};
use super::writer::{Break, Writer};
use crate::syntax::outline::{Piece, PieceKind};
use crate::syntax::token::Kind;

impl Writer<'_> {
    /// Writes an annotation or definition; `is_noted` says that an annotation stands before it.
    pub fn definition(&mut self, piece: &Piece, parts: &[Part], is_noted: bool) {
        let end = piece.tokens.end;
        if !is_noted {
            self.open_paragraph();
        }
        let shares = is_noted && !self.began_line(self.at) && self.fits(end);
        if !shares {
            self.break_out();
        }
        self.indent = 0;
        for part in parts {
            self.header(piece, part.tokens.start);
            match part.shape {
                Shape::List | Shape::Locals => self.part(part),
                _ => self.main(part, end),
            }
        }
        self.header(piece, end);
        if piece.kind != PieceKind::Annotation {
            self.close_paragraph();
        }
    }

    /// Writes up to a token, the sign of the definition marked.
    fn header(&mut self, piece: &Piece, end: usize) {
        while self.at < end {
            let is_sign = match self.kind(self.at) {
                Some(Kind::Arrow | Kind::Squiggle) => true,
                Some(Kind::Equal) => piece.kind == PieceKind::Value,
                Some(Kind::Colon) => piece.kind == PieceKind::Import,
                _ => false,
            };
            if is_sign {
                self.mark = Some(Class::Sign);
            }
            self.token();
        }
    }

    /// What a definition gives its name: after the sign, or on lines of its own.
    fn main(&mut self, part: &Part, end: usize) {
        if part.tokens.is_empty() {
            return;
        }
        if self.fits(end) {
            return self.flat(end);
        }
        self.break_to(INDENT);
        self.inside(INDENT, |writer| writer.part(part));
    }

    /// Lays out at another indentation.
    fn inside(&mut self, indent: usize, lay: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.indent, indent);
        lay(self);
        self.indent = before;
    }

    fn part(&mut self, part: &Part) {
        if self.fits(part.tokens.end) {
            return self.flat(part.tokens.end);
        }
        match part.shape {
            Shape::Ops => self.ops(part),
            Shape::Choice => self.choice(part),
            Shape::Arm | Shape::Entry => self.headed(part),
            Shape::Op => self.op(part),
            Shape::List => self.list(part),
            Shape::Locals => self.locals(part),
            Shape::Push => self.push_block(part),
            Shape::Block => self.block(part),
            Shape::Value => self.value(part),
        }
        self.flat(part.tokens.end);
    }

    /// In the author's lines; each on its own where there was but one and it is too long.
    fn ops(&mut self, part: &Part) {
        let in_lines = part.parts.iter().skip(1).any(|op| self.must_break(op.tokens.start));
        for (index, op) in part.parts.iter().enumerate() {
            if index > 0 && (!in_lines || self.must_break(op.tokens.start) || !self.fits(op.tokens.end)) {
                self.break_to(self.indent);
            }
            self.part(op);
        }
    }

    fn op(&mut self, part: &Part) {
        for (index, inner) in part.parts.iter().enumerate() {
            self.flat(inner.tokens.start);
            let next_block = part.parts.get(index + 1).is_some_and(|next| next.shape == Shape::Block);
            // The brace of the block has to follow the arguments.
            let end = inner.tokens.end + usize::from(next_block);
            match inner.shape == Shape::List && self.fits(end) {
                true => self.flat(inner.tokens.end),
                false => self.part(inner),
            }
        }
    }

    fn choice(&mut self, part: &Part) {
        let indent = if self.is_at_start() { self.indent } else { self.indent + INDENT };
        self.inside(indent, |writer| {
            for (index, arm) in part.parts.iter().enumerate() {
                if index > 0 || !writer.is_at_start() {
                    writer.break_to(indent);
                }
                writer.part_in_lines(arm);
            }
        });
    }

    /// An arm or alternative, its colon marked for alignment.
    fn part_in_lines(&mut self, part: &Part) {
        self.headed(part);
        self.flat(part.tokens.end);
    }

    fn headed(&mut self, part: &Part) {
        let Some((content, heads)) = part.parts.split_last() else { return };
        if content.shape == Shape::Block {
            return self.part(content);
        }
        for head in heads {
            self.flat(head.tokens.start);
            self.part(head);
        }
        let sign = content.tokens.start.saturating_sub(1);
        if heads.len() < 2 && sign > self.at {
            self.flat(sign);
        }
        if self.at == sign && self.kind(sign) == Some(Kind::Colon) && heads.len() < 2 {
            self.mark = Some(Class::Colon);
        }
        self.flat(content.tokens.start);
        self.content(content);
    }

    /// What stands after a colon: in the line, on lines of its own, or beginning in the line where it has a block.
    fn content(&mut self, content: &Part) {
        let (end, inner) = (content.tokens.end, self.indent + INDENT);
        if content.tokens.is_empty() {
            return;
        }
        let begins_here = has_one_block(content) && !self.fits_at(inner, end) && !self.has_breaking_comment(self.at);
        if self.fits(end) || self.pending.is_none() && begins_here {
            return self.part(content);
        }
        self.break_to(inner);
        self.inside(inner, |writer| writer.part(content));
    }

    fn list(&mut self, part: &Part) {
        let indent = self.indent + INDENT;
        if matches!(&part.parts[..], [one] if one.tokens.len() == 1) {
            return self.flat(part.tokens.end);
        }
        self.flat(part.tokens.start + 1);
        self.inside(indent, |writer| {
            for (index, inner) in part.parts.iter().enumerate() {
                writer.flat(inner.tokens.start);
                if index == 0 || writer.began_line(inner.tokens.start) || !writer.fits(inner.tokens.end) {
                    writer.break_to(indent);
                }
                writer.part(inner);
            }
        });
    }

    fn locals(&mut self, part: &Part) {
        let indent = self.indent + INDENT;
        self.flat(part.tokens.start + 1);
        self.inside(indent, |writer| {
            for local in &part.parts {
                writer.break_to(indent);
                writer.part(local);
            }
        });
        self.close(part);
    }

    fn push_block(&mut self, part: &Part) {
        let indent = self.indent + INDENT;
        self.flat(part.tokens.start + 1);
        self.break_to(indent);
        self.inside(indent, |writer| part.parts.iter().for_each(|body| writer.part(body)));
        self.close(part);
    }

    /// Alternatives on lines of their own, the bars below each other.
    fn block(&mut self, part: &Part) {
        let (bars, indent) = (self.indent + INDENT / 2, self.indent + INDENT);
        self.flat(part.tokens.start + 1);
        self.break_to(indent);
        self.inside(indent, |writer| {
            for (index, entry) in part.parts.iter().enumerate() {
                if index > 0 {
                    writer.pending = Some(Break { indent: bars, comments: indent, is_outer: false });
                    writer.flat(entry.tokens.start);
                }
                writer.part_in_lines(entry);
            }
        });
        self.close(part);
    }

    /// The closing bracket on a line of its own.
    fn close(&mut self, part: &Part) {
        let (indent, comments) = (self.indent, self.indent + INDENT);
        self.flat(part.tokens.end - 1);
        self.pending = Some(Break { indent, comments, is_outer: false });
        self.flat(part.tokens.end);
    }

    /// Operands and operators: lines break before an operator, where the author broke them or the next operand is too
    /// long.
    fn value(&mut self, part: &Part) {
        let (spaced, hanging) = (self.spaced(), self.indent + INDENT);
        let mut inner = part.parts.iter().peekable();
        while self.at < part.tokens.end {
            if let Some(part) = inner.next_if(|inner| inner.tokens.start == self.at) {
                match part.shape {
                    Shape::Ops => self.content(part),
                    _ => self.part(part),
                }
                continue;
            }
            let breaks = |at| self.began_line(at) || self.began_line(at + 1) || !self.fits(self.operand_end(at, part));
            if spaced.is_infix(self.at) && self.at > part.tokens.start && breaks(self.at) {
                self.break_to(hanging);
            }
            self.token();
        }
    }

    /// Where the operand after an operator ends.
    fn operand_end(&self, operator: usize, part: &Part) -> usize {
        let (spaced, mut at) = (self.spaced(), operator + 1);
        while at < part.tokens.end && !spaced.is_infix(at) {
            at = if self.kind(at) == Some(Kind::Open) { self.partner(at) + 1 } else { at + 1 };
        }
        at.min(part.tokens.end)
    }
}

/// Whether a successor is one operation that can begin in a line and go on in others.
fn has_one_block(content: &Part) -> bool {
    matches!(&content.parts[..], [op] if content.shape == Shape::Ops && !op.parts.is_empty())
}
