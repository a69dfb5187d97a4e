//! Blocks: alternatives between bars, with and without heads.

use super::value::separator;
use super::{Builder, next_if};
use crate::diag::Diagnostic;
use crate::syntax::ast::{Block, Call, Content, Entry, Head, Op, Separator, Spelling};
use crate::syntax::grammar::{Pair, Rule};
use pest::iterators::Pairs;

/// Operations each of whose alternatives needs a head, and what the head is.
const HEADED: [(&str, &str); 12] = [
    ("split", "size"),
    ("splitArea", "size"),
    ("splitAndSetbackPerimeter", "size"),
    ("comp", "selector"),
    ("modify", "selector"),
    ("setback", "selector"),
    ("setbackPerEdge", "selector"),
    ("setbackToArea", "selector"),
    ("innerRectangle", "selector"),
    ("shapeL", "selector"),
    ("shapeU", "selector"),
    ("shapeO", "selector"),
];

impl<'t> Builder<'t> {
    /// The blocks at the end of an operation, each with its `*`.
    pub(super) fn blocks(&self, mut inner: Pairs<'t, Rule>) -> Option<Vec<Block>> {
        let mut blocks = Vec::new();
        while let Some(block) = inner.next() {
            let repeat = next_if(&mut inner, Rule::repeat).is_some();
            blocks.push(self.block(block, repeat)?);
        }
        Some(blocks)
    }

    fn block(&self, pair: Pair<'t>, repeat: bool) -> Option<Block> {
        let span = self.span(&pair);
        let entries = pair.into_inner().map(|entry| self.entry(entry)).collect::<Option<_>>()?;
        Some(Block { entries, repeat, span })
    }

    fn entry(&self, pair: Pair<'t>) -> Option<Entry> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let (head, content) = match inner.peek()?.as_rule() {
            Rule::block => {
                let block = inner.next()?;
                let repeat = inner.next().is_some();
                (None, Content::Block(self.block(block, repeat)?))
            }
            Rule::key => {
                let key = self.key(inner.next()?)?;
                let head = Head { key, depth: None, separator: separator(&inner.next()?) };
                (Some(head), Content::Body(self.body(inner.next()?)?))
            }
            _ => (None, Content::Body(self.body(inner.next()?)?)),
        };
        Some(Entry { head, content, span })
    }

    /// `splitAndSetbackPerimeter(…){ size : depth : body | … }*{ remainder : body }`
    pub(super) fn perimeter(&self, pair: Pair<'t>) -> Option<Op> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let name = self.name(&inner.next()?);
        let args = self.args(inner.next()?)?;
        let first = inner.next()?;
        let block_span = self.span(&first);
        let entries = first.into_inner().map(|entry| self.perimeter_entry(entry)).collect::<Option<_>>()?;
        let repeat = next_if(&mut inner, Rule::repeat).is_some();
        let mut blocks = vec![Block { entries, repeat, span: block_span }];
        blocks.extend(self.blocks(inner)?);
        let call = Call { name, args, blocks, leaf: false, spelling: Spelling::Cga, span };
        Some(Op::Call(self.checked(call)))
    }

    fn perimeter_entry(&self, pair: Pair<'t>) -> Option<Entry> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let key = self.key(inner.next()?)?;
        let depth = Some(self.key(inner.next()?)?);
        let separator: Separator = separator(&inner.next()?);
        let head = Some(Head { key, depth, separator });
        Some(Entry { head, content: Content::Body(self.body(inner.next()?)?), span })
    }

    /// The call, after a look at whether heads stand where they must.
    pub(super) fn checked(&self, call: Call) -> Call {
        for block in &call.blocks {
            self.check_heads(&call, block);
            if block.repeat && !is_split(&call) {
                let message = format!("`*` repeats a split, and `{}` is none", call.name.text);
                let hint = "a block that repeats inside a split has a `|` before it: `{ 1 : A | { 2 : B }* }`";
                self.report(Diagnostic::error("syntax-block", block.span, message).hint(hint));
            }
        }
        if matches!(&*call.name.text, "union" | "subtract" | "intersect") {
            self.check_operands(&call);
        }
        call
    }

    fn check_heads(&self, call: &Call, block: &Block) {
        let mixed = block.entries.iter().any(|entry| entry.head.is_some());
        let needed = HEADED.iter().find(|(name, _)| *name == &*call.name.text).map(|(_, head)| *head);
        for entry in &block.entries {
            match (&entry.content, needed) {
                (Content::Block(inner), _) if is_split(call) => self.check_heads(call, inner),
                (Content::Block(_), _) => self.report_block(call, entry),
                (Content::Body(_), Some(head)) if entry.head.is_none() => self.report_headless(call, entry, head),
                (Content::Body(_), None) if mixed && entry.head.is_none() => {
                    self.report_headless(call, entry, "selector or size");
                }
                _ => {}
            }
        }
    }

    fn report_headless(&self, call: &Call, entry: &Entry, head: &str) {
        let message = format!("this part of `{}` has no {head} with a `:` before it", call.name.text);
        let hint = match head {
            "size" => "write for example `2 : Path` or `~1 : Lawn`",
            _ => "write for example `top : Roof` or `all : Part`",
        };
        self.report(Diagnostic::error("syntax-block", entry.span, message).hint(hint));
    }

    fn report_block(&self, call: &Call, entry: &Entry) {
        let name = &call.name.text;
        let message = format!("braces directly inside braces repeat parts of a split, and `{name}` is none");
        self.report(Diagnostic::error("syntax-block", entry.span, message));
    }

    /// Boolean operations join two alternatives.
    fn check_operands(&self, call: &Call) {
        let count: usize = call.blocks.iter().map(|block| block.entries.len()).sum();
        if count == 1 {
            let message = format!("`{}` needs two operands between its braces, found 1", call.name.text);
            let hint = format!("write `{} {{ A | B }}`", call.name.text);
            self.report(Diagnostic::error("syntax-block", call.span, message).hint(hint));
        }
    }
}

fn is_split(call: &Call) -> bool {
    matches!(&*call.name.text, "split" | "splitArea" | "splitAndSetbackPerimeter")
}
