//! Successors: operations with their blocks, rule calls, leaves.

use crate::check::Checker;
use crate::check::code::Code;
use crate::check::program::{Application, Block, Body, Cut, Selector, Step, Successor, Test};
use crate::diag::{Diagnostic, Span};
use crate::ops::{self, BlockKind, Gather, OPERATIONS, Operation, Origin, Selectors, Spec, UNBUILT_OPERATIONS};
use crate::syntax::ast::{self, Arg, Call, Content, Entry, Expr, ExprKind, Op, Separator};
use crate::text::nearest;
use std::sync::Arc;

impl Checker {
    /// A successor.
    pub(super) fn body(&mut self, body: &ast::Body) -> Body {
        match body {
            ast::Body::Ops(list) => Body::Steps(list.iter().filter_map(|op| self.step(op)).collect()),
            ast::Body::Case { arms, otherwise } => {
                let span = arms.first().map_or(Span::default(), |(test, _)| test.span);
                let checked = arms.iter().map(|(test, body)| (self.condition(test), self.body(body))).collect();
                Body::Case(checked, Box::new(self.body(otherwise)), span)
            }
            ast::Body::Chance { arms, otherwise } => {
                self.percentages(arms.iter().map(|(percent, _)| percent));
                let span = arms.first().map_or(Span::default(), |(percent, _)| percent.span);
                let checked = arms.iter().map(|(percent, body)| (self.number(percent), self.body(body))).collect();
                Body::Chance(checked, Box::new(self.body(otherwise)), span)
            }
        }
    }

    fn step(&mut self, op: &Op) -> Option<Step> {
        match op {
            Op::Call(call) => self.call(call),
            Op::Push(body, _) => Some(Step::Push(self.body(body))),
            Op::Dynamic { import, overrides, call } => self.dynamic(import, overrides, call),
            Op::Inline { mode, target, span } => self.inline(mode, target, *span),
        }
    }

    /// `inline(mode) target`: what stands behind it is derived inside the rule.
    fn inline(&mut self, mode: &[Arg], target: &[Op], span: Span) -> Option<Step> {
        let operation = ops::find("inline")?;
        let (args, arg_spans) = self.arguments(operation.spec, mode, span);
        let ready = Application::ready(operation, &args);
        let (args, arg_spans) = (args.into(), arg_spans.into());
        let body = Body::Steps(target.iter().filter_map(|op| self.step(op)).collect());
        let (block, bodies) = (Block::Operands, [body].into());
        Some(Step::Apply(Box::new(Application { operation, ready, args, arg_spans, block, bodies, span })))
    }

    /// An operation, a rule or a leaf: CityEngine's operations first, then the file's rules, then ours, then leaves.
    fn call(&mut self, call: &Call) -> Option<Step> {
        if &*call.name.text == "NIL" {
            return Some(Step::Delete);
        }
        // `Pine.` says that a leaf is meant, whatever operations there are.
        let meant = call.leaf && call.args.is_empty() && call.blocks.is_empty();
        let operation = ops::find(&call.name.text).filter(|_| !meant);
        let rule = self.rule_named(&call.name.text, call.args.len());
        let unbuilt = UNBUILT_OPERATIONS.iter().find(|u| u.name == &*call.name.text);
        match (operation, rule) {
            (Some(operation), None) => Some(self.operation(operation, call)),
            (Some(operation), Some(_)) if operation.spec.origin == Origin::CityEngine => {
                self.shadow(call, "the operation is meant: a rule cannot take the name of one of CityEngine's");
                Some(self.operation(operation, call))
            }
            (Some(_), Some(rule)) => {
                self.shadow(call, "the rule is meant, not the operation of that name");
                Some(self.successor(call, Some(rule)))
            }
            (None, Some(rule)) => Some(self.successor(call, Some(rule))),
            (None, None) => match unbuilt {
                Some(unbuilt) => {
                    let name = &call.name.text;
                    let message = format!("`{name}` ({}) is CityEngine's; bosquet does not have it yet", unbuilt.does);
                    let diagnostic = Diagnostic::error("unbuilt", call.name.span, message);
                    self.tell(diagnostic.hint("`bosquet ops` lists what there is"));
                    None
                }
                None => self.stranger(call),
            },
        }
    }

    fn shadow(&mut self, call: &Call, hint: &str) {
        let message = format!("`{}` is a rule and an operation", call.name.text);
        self.tell(Diagnostic::lint("shadow", call.name.span, message).hint(hint));
    }

    /// A name that is neither operation nor rule: a leaf, or a slip of the pen.
    pub(super) fn stranger(&mut self, call: &Call) -> Option<Step> {
        let name = &call.name.text;
        if self.is_lost(name) {
            return None;
        }
        // What is near is costly to find, and nobody asks for it where the leaf is meant.
        let is_meant = call.args.is_empty() && call.blocks.is_empty() && (call.leaf || self.is_cover(name));
        let near = if is_meant { None } else { self.near_step(name) };
        let others = self.other_rules(name);
        let span = call.name.span;
        if !call.blocks.is_empty() {
            let message = format!("there is no operation `{name}`");
            self.tell(Diagnostic::error("unknown-name", span, message).did_you_mean(near.as_deref()));
            return None;
        }
        if !others.is_empty() {
            let message = format!("`{name}` takes {}, found {}: it is a leaf", others.join(" or "), call.args.len());
            let hint = "a rule of that name with as many parameters would take it";
            self.tell(Diagnostic::lint("arguments", call.span, message).hint(hint));
            return Some(self.successor(call, None));
        }
        if name.contains('.') && !call.leaf && !self.leads_into_import(name) {
            let message = format!("there is no rule `{name}`");
            let hint = crate::functions::find(name)
                .map(|_| format!("it is a value and no step: `print({name})` shows it, arguments and `set` use it"));
            let error = Diagnostic::error("unknown-name", span, message).did_you_mean(near.as_deref());
            self.tell(hint.into_iter().fold(error, Diagnostic::hint));
            return None;
        }
        if !call.args.is_empty() && near.is_some() {
            let message = format!("there is no operation or rule `{name}`");
            self.tell(Diagnostic::error("unknown-name", span, message).did_you_mean(near.as_deref()));
            return None;
        }
        if !call.leaf && !self.is_cover(name) && !self.has_syntax_errors() {
            let message = format!("`{name}` has no rule: it is a leaf");
            let hint = format!("write `{name}.` where that is meant");
            let cover = crate::element::Catalogue::built_in().nearest_cover(name).map(str::to_string);
            let near = near.or(cover);
            self.tell(Diagnostic::lint("leaf", span, message).did_you_mean(near.as_deref()).hint(hint));
        }
        Some(self.successor(call, None))
    }

    /// A rule that could not be read is missing: its name is no leaf then.
    fn has_syntax_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.is_error() && d.code.starts_with("syntax"))
    }

    /// Whether a leaf's name says what it is made of.
    fn is_cover(&self, name: &str) -> bool {
        crate::element::Catalogue::built_in().cover(name).is_some()
    }

    pub(super) fn successor(&mut self, call: &Call, rule: Option<u32>) -> Step {
        if let Some(block) = call.blocks.first() {
            let message = format!("`{}` is a rule: it takes no block", call.name.text);
            self.tell(Diagnostic::error("block", block.span, message));
        }
        let symbol = self.symbol(&call.name.text);
        let args = call.args.iter().map(|arg| self.positional(arg)).collect();
        Step::Successor(Successor { symbol, rule, args, fresh: None, span: call.span })
    }

    fn positional(&mut self, arg: &Arg) -> Code {
        if let Some(name) = &arg.name {
            let message = "arguments of rules are given by position".to_string();
            self.tell(Diagnostic::error("arguments", name.span, message));
        }
        self.value(&arg.value).0
    }

    pub(super) fn rule_named(&self, name: &Arc<str>, count: usize) -> Option<u32> {
        let (module, bare) = self.path(name);
        if &*bare == "start" && module != self.module {
            return self.start_of(module);
        }
        self.names.rules[module].get(&(bare, count)).copied()
    }

    /// `import.start`: the start rule of an imported file.
    fn start_of(&self, module: usize) -> Option<u32> {
        let module_of = &self.loaded.modules[module];
        let mut start = module_of.items.iter().filter_map(|item| match &module_of.tree.items[*item].kind {
            ast::ItemKind::Rule(rule) if rule.mark == Some(ast::RuleMark::Start) => Some(rule.name.text.clone()),
            _ => None,
        });
        start.next_back().and_then(|name| self.names.rules[module].get(&(name, 0)).copied())
    }

    fn other_rules(&self, name: &Arc<str>) -> Vec<String> {
        let (module, bare) = self.path(name);
        let rules = self.names.rules[module].keys().filter(|(n, _)| *n == bare);
        rules.map(|(_, count)| crate::text::counted(*count, "argument")).collect()
    }

    fn near_step(&self, name: &str) -> Option<String> {
        if let Some((import, _)) = name.rsplit_once('.') {
            let (module, bare) = self.path(&name.into());
            let rules = self.names.rules[module].keys().map(|(n, _)| &**n);
            return nearest(&bare, rules).map(|rule| format!("{import}.{rule}"));
        }
        let rules = self.names.rules[self.module].keys().map(|(n, _)| &**n);
        let built = OPERATIONS.iter().flat_map(|o| o.spec.aliases.iter().copied().chain([o.spec.name]));
        nearest(name, rules.chain(built)).map(str::to_string)
    }

    fn operation(&mut self, operation: &'static Operation, call: &Call) -> Step {
        let (args, arg_spans) = self.arguments(operation.spec, &call.args, call.span);
        self.elements(operation.spec, &args, &arg_spans);
        self.program.looks_around |= operation.looks_around;
        self.unseen(operation, call);
        if operation.labels {
            let label = args.first().and_then(|arg| arg.as_ref()?.known()?.as_str().map(Into::into));
            self.program.labels.insert(label);
        }
        let mut bodies = Vec::new();
        let block = match (operation.spec.block, call.blocks.first()) {
            (BlockKind::None, None) => Block::None,
            (BlockKind::None, Some(block)) => {
                let message = format!("`{}` takes no block", operation.spec.name);
                self.tell(Diagnostic::error("block", block.span, message));
                Block::None
            }
            (_, None) => {
                let message = format!("`{}` needs a block", operation.spec.name);
                self.tell(
                    Diagnostic::error("block", call.span, message).hint(format!("as in `{}`", operation.spec.usage())),
                );
                Block::None
            }
            (BlockKind::Cuts, Some(block)) => {
                self.same_axis(call);
                let cuts = self.cuts(&block.entries, &mut bodies);
                Block::Cuts(if block.repeat { Box::new([Cut::Repeat(cuts)]) } else { cuts })
            }
            (BlockKind::Perimeter, Some(_)) => self.perimeter(operation.spec, &call.blocks, &mut bodies),
            (BlockKind::Selectors(extra), Some(block)) => {
                self.no_repeat(operation.spec, block);
                let entries = block.entries.iter();
                Block::Selectors(entries.filter_map(|e| self.selector(operation.spec, extra, e, &mut bodies)).collect())
            }
            (BlockKind::Body, Some(block)) => {
                self.no_repeat(operation.spec, block);
                self.single_body(operation.spec, block, &mut bodies);
                Block::Body
            }
            (BlockKind::Operands(count), Some(block)) => {
                self.no_repeat(operation.spec, block);
                self.inner_bodies(operation.spec, count, block, &mut bodies);
                Block::Operands
            }
        };
        if bodies.len() > usize::from(u16::MAX) {
            let parts = crate::text::counted(bodies.len(), "part");
            self.tell(Diagnostic::error("block", call.span, format!("a block of {parts} is more than can be derived")));
        }
        let span = call.span;
        let ready = Application::ready(operation, &args);
        let (args, arg_spans, bodies) = (args.into(), arg_spans.into(), bodies.into());
        Step::Apply(Box::new(Application { operation, ready, args, arg_spans, block, bodies, span }))
    }

    /// Once for all files: what plans do not show.
    fn unseen(&mut self, operation: &Operation, call: &Call) {
        if operation.unseen && !self.diagnostics.iter().any(|d| d.code == "unseen") {
            let message = format!("plans do not show what `{}` and its like do: it is kept for scenes", call.name.text);
            let place = crate::diag::Place::Rule(call.name.span);
            self.tell(Diagnostic::new(crate::diag::Severity::Note, "unseen", place, message));
        }
    }

    fn no_repeat(&mut self, spec: &Spec, block: &ast::Block) {
        if block.repeat {
            let message = format!("the block of `{}` cannot repeat", spec.name);
            self.tell(Diagnostic::error("block", block.span, message));
        }
    }

    fn single_body(&mut self, spec: &Spec, block: &ast::Block, bodies: &mut Vec<Body>) {
        match block.entries.as_slice() {
            [Entry { head: None, content: Content::Body(body), .. }] => {
                let body = self.body(body);
                bodies.push(body);
            }
            _ => {
                let message = format!("the block of `{}` holds one successor for every child", spec.name);
                self.tell(Diagnostic::error("block", block.span, message).hint(format!("as in `{}`", spec.usage())));
            }
        }
    }

    fn inner_bodies(&mut self, spec: &Spec, count: usize, block: &ast::Block, bodies: &mut Vec<Body>) {
        let plain = |entry: &Entry| match (&entry.head, &entry.content) {
            (None, Content::Body(body)) => Some(body.clone()),
            _ => None,
        };
        let given: Vec<ast::Body> = block.entries.iter().filter_map(plain).collect();
        if given.len() != count || block.entries.len() != count {
            let message = format!("the block of `{}` has {}", spec.name, crate::text::counted(count, "part"));
            self.tell(Diagnostic::error("block", block.span, message).hint(format!("as in `{}`", spec.usage())));
        }
        bodies.extend(given.iter().map(|body| self.body(body)));
    }

    pub(super) fn cuts(&mut self, entries: &[Entry], bodies: &mut Vec<Body>) -> Box<[Cut]> {
        entries.iter().filter_map(|entry| self.cut(entry, bodies)).collect()
    }

    fn cut(&mut self, entry: &Entry, bodies: &mut Vec<Body>) -> Option<Cut> {
        match (&entry.content, &entry.head) {
            (Content::Block(block), _) => {
                let cuts = self.cuts(&block.entries, bodies);
                Some(if block.repeat { Cut::Repeat(cuts) } else { Cut::Group(cuts) })
            }
            (Content::Body(body), Some(head)) => {
                self.part_size(&head.key);
                let size = self.size(&head.key);
                let body = self.body(body);
                bodies.push(body);
                Some(Cut::Piece(size, (bodies.len() - 1) as u16, head.key.span))
            }
            (Content::Body(_), None) => {
                let message = "a part of a split needs a size";
                let hint = "as in `3 : A`, `'0.5 : A` or `~1 : A`";
                self.tell(Diagnostic::error("block", entry.span, message).hint(hint));
                None
            }
        }
    }

    fn size(&mut self, expr: &Expr) -> Code {
        match &expr.kind {
            ExprKind::Sized(mark, inner) => self.sized(*mark, inner, expr.span),
            _ => self.number(expr),
        }
    }

    pub(super) fn selector(
        &mut self,
        spec: &Spec,
        extra: &'static [&'static str],
        entry: &Entry,
        bodies: &mut Vec<Body>,
    ) -> Option<Selector> {
        let (Some(head), Content::Body(body)) = (&entry.head, &entry.content) else {
            let message = format!("a part of `{}` needs a selector", spec.name);
            let hint = "as in `front : A` or `all : A`";
            self.tell(Diagnostic::error("block", entry.span, message).hint(hint));
            return None;
        };
        let test = self.test(extra, &head.key);
        let body = self.body(body);
        bodies.push(body);
        let gather = match head.separator {
            Separator::Each => Gather::Each,
            Separator::All => Gather::All,
            Separator::Connected => Gather::Connected,
        };
        Some(Selector { test: test?, gather })
    }

    pub(super) fn test(&mut self, extra: &'static [&'static str], key: &Expr) -> Option<Test> {
        match &key.kind {
            ExprKind::Call(word, None) if &**word == "remainder" && extra.contains(&"remainder") => {
                Some(Test::Remainder)
            }
            ExprKind::Call(word, None) if Selectors::of_word(word).is_some() || extra.contains(&&**word) => {
                Some(Test::Word(word.clone()))
            }
            ExprKind::Call(word, None) if !self.is_own_name(word) && crate::functions::find(word).is_none() => {
                let near = nearest(word, Selectors::words().chain(extra.iter().copied()));
                let message = format!("there is no selector `{word}`");
                let rest = "only setbacks and their like leave a remainder; `all` takes what no entry before it took";
                let hint = Some(rest).filter(|_| &**word == "remainder");
                let error = Diagnostic::error("selector", key.span, message).did_you_mean(near);
                self.tell(hint.into_iter().fold(error, Diagnostic::hint));
                None
            }
            ExprKind::Number(_) | ExprKind::Unary(ast::UnaryOp::Minus, _) => Some(Test::Index(self.number(key))),
            _ => Some(Test::Condition(self.value(key).0)),
        }
    }

    /// `split(x) { 3 : split(x) { … } }`: the inner split cuts what the outer has cut already.
    fn same_axis(&mut self, call: &Call) {
        let Some(axis) = axis_of(call) else { return };
        for block in &call.blocks {
            self.same_axis_in(call, axis, block);
        }
    }

    fn same_axis_in(&mut self, call: &Call, axis: &str, block: &ast::Block) {
        for entry in &block.entries {
            if let Content::Block(inner) = &entry.content {
                self.same_axis_in(call, axis, inner);
            }
            let Content::Body(ast::Body::Ops(inner)) = &entry.content else { continue };
            let Some(Op::Call(first)) = inner.first() else { continue };
            if first.name.text == call.name.text && axis_of(first) == Some(axis) && !first.blocks.is_empty() {
                let message = format!("`split({axis})` directly inside `split({axis})`");
                let hint = "another axis may be meant; a nested block `{ … }*` repeats inside one split";
                self.tell(Diagnostic::lint("same-axis", first.name.span, message).hint(hint));
            }
        }
    }
}

fn axis_of(call: &Call) -> Option<&str> {
    match call.args.first().map(|a| &a.value.kind) {
        Some(ExprKind::Call(axis, None)) if &*call.name.text == "split" => Some(axis),
        _ => None,
    }
}
