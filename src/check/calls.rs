//! Names in expressions, and arguments put in the order of the parameters.

use crate::check::code::{Code, Kind};
use crate::check::{Checker, advice};
use crate::diag::{Diagnostic, Span};
use crate::functions;
use crate::ops::{Param, ParamKind, Spec};
use crate::syntax::ast::{Arg, Expr, ExprKind};
use crate::text::nearest;
use crate::value::Value;
use std::sync::Arc;

impl Checker {
    /// A name or call in an expression; `words` stand for themselves.
    pub(super) fn name(&mut self, name: &Arc<str>, args: Option<&[Arg]>, span: Span, words: &[&str]) -> (Code, Kind) {
        if args.is_none() && words.contains(&&**name) {
            return (Code::Value(Value::Word(name.clone())), Kind::Text);
        }
        let (module, bare) = self.path(name);
        if let Some(found) = self.shared_with_itself(module, &bare, args) {
            return found;
        }
        if let Some(found) = self.own_name(module, &bare, args, module == self.module) {
            return found;
        }
        match functions::find(name) {
            Some(function) => self.builtin(function, args.unwrap_or_default(), span),
            None => self.unknown(name, args.is_some(), span),
        }
    }

    /// Whether a bare name is a parameter, attribute, constant or function of the files.
    pub(super) fn is_own_name(&self, name: &Arc<str>) -> bool {
        let (module, bare) = self.path(name);
        let functions = &self.names.functions[module];
        (module == self.module && self.params.iter().any(|p| **p == *bare))
            || self.loaded.modules[module].slots.contains_key(&*bare)
            || functions.contains_key(&(bare, 0))
    }

    /// The module that a qualified name leads to, and the name there.
    pub(super) fn path(&self, name: &Arc<str>) -> (usize, Arc<str>) {
        let (mut module, mut rest) = (self.module, &**name);
        while let Some((import, tail)) = rest.split_once('.') {
            let Some(inner) = self.loaded.modules[module].imports.get(import) else { break };
            (module, rest) = (*inner, tail);
        }
        (module, rest.into())
    }

    /// Whether a name is one of an import, whether or not it means anything there.
    pub(super) fn leads_into_import(&self, name: &Arc<str>) -> bool {
        !self.path(name).1.contains('.')
    }

    /// Whether a name leads into an import that could not be loaded.
    pub(super) fn is_lost(&self, name: &str) -> bool {
        name.split_once('.').is_some_and(|(import, _)| self.loaded.modules[self.module].missing.contains(import))
    }

    /// `attr width = plants.width` is that attribute itself, since the import shares it by name: its file's own value
    /// is meant.
    fn shared_with_itself(&mut self, module: usize, name: &Arc<str>, args: Option<&[Arg]>) -> Option<(Code, Kind)> {
        let slot = self.loaded.modules[module].slots.get(name).copied();
        let is_itself = slot.is_some() && slot == self.initialised && module != self.module && args.is_none();
        if is_itself { self.own_value(module, name) } else { None }
    }

    /// A parameter, attribute or function of the files.
    fn own_name(&mut self, module: usize, name: &Arc<str>, args: Option<&[Arg]>, here: bool) -> Option<(Code, Kind)> {
        let position = self.params.iter().position(|p| p == name).filter(|_| here && args.is_none());
        if let Some(position) = position {
            return Some((Code::Param(position as u32), Kind::Unknown));
        }
        let slot = self.loaded.modules[module].slots.get(name).copied().filter(|_| args.is_none_or(<[Arg]>::is_empty));
        if let Some(slot) = slot {
            return Some((Code::Attribute(slot), Kind::Unknown));
        }
        let count = args.map_or(0, <[Arg]>::len);
        let index = *self.names.functions[module].get(&(name.clone(), count))?;
        let kind = self.function_kinds.get(index as usize).copied().unwrap_or(Kind::Unknown);
        let args = args.unwrap_or_default().iter().map(|arg| self.value(&arg.value).0).collect();
        Some((Code::Function(index, args), kind))
    }

    fn builtin(&mut self, function: &'static functions::Function, args: &[Arg], span: Span) -> (Code, Kind) {
        let (least, most) = function.arity;
        self.program.looks_around |= function.looks_around;
        self.program.asks_for_tags |= function.asks_for_tags;
        self.program.asks_for_selectors |= function.asks_for_selectors;
        self.program.asks_for_solids |= function.looks_around;
        if args.len() < least || args.len() > most {
            let message = format!("`{}` takes {}, found {}", function.name, arity(least, most), args.len());
            let diagnostic = Diagnostic::error("arguments", span, message);
            self.tell(match function.signature {
                "" => diagnostic,
                signature => diagnostic.hint(format!("it is called as `{}{signature}`", function.name)),
            });
        }
        let values = args.iter().enumerate().map(|(index, arg)| match &arg.value.kind {
            ExprKind::Call(name, args) => {
                let words = if index < function.words_within { function.words } else { &[] };
                self.name(name, args.as_deref(), arg.value.span, words)
            }
            _ => self.value(&arg.value),
        });
        let (codes, kinds): (Vec<Code>, Vec<Kind>) = values.unzip();
        let kind = result(function, kinds.first().copied().unwrap_or(Kind::Unknown));
        let known: Option<Vec<Value>> = codes.iter().map(|code| code.known().cloned()).collect();
        match known.and_then(|args| functions::folded(function, &args)) {
            Some(value) => (Code::Value(value), kind),
            None => (Code::Builtin(function, codes.into(), span), kind),
        }
    }

    fn unknown(&mut self, name: &Arc<str>, call: bool, span: Span) -> (Code, Kind) {
        let zero = (Code::Value(Value::Float(0.0)), Kind::Unknown);
        if self.is_lost(name) {
            return zero;
        }
        let arities = self.other_arities(name);
        if !arities.is_empty() {
            let message = format!("`{name}` takes {} here", arities.join(" or "));
            self.tell(Diagnostic::error("arguments", span, message));
            return zero;
        }
        let what = if call { "function" } else { "attribute, parameter or function" };
        let near = self.near_value(name);
        let mut diagnostic = Diagnostic::error("unknown-name", span, format!("there is no {what} `{name}`"))
            .did_you_mean(near.as_deref());
        if near.is_none() && !call {
            diagnostic = diagnostic.hint(format!("a text stands in quotes: `\"{name}\"`"));
        }
        self.tell(diagnostic);
        zero
    }

    /// With how many arguments a function of that name exists.
    fn other_arities(&self, name: &Arc<str>) -> Vec<String> {
        let (module, bare) = self.path(name);
        let counts = self.names.functions[module].keys().filter(|(n, _)| *n == bare);
        counts.map(|(_, count)| crate::text::counted(*count, "argument")).collect()
    }

    fn near_value(&self, name: &str) -> Option<String> {
        let slots = self.loaded.modules[self.module].slots.keys().map(|k| &**k);
        let own = self.names.functions[self.module].keys().map(|(n, _)| &**n);
        let built_in = functions::all().map(|f| f.name);
        let params = self.params.iter().map(|p| &**p);
        nearest(name, params.chain(slots).chain(own).chain(built_in)).map(str::to_string)
    }

    /// Arguments in the order of the parameters, each with its place.
    pub(super) fn arguments(
        &mut self,
        spec: &'static Spec,
        args: &[Arg],
        span: Span,
    ) -> (Vec<Option<Code>>, Vec<Span>) {
        let mut codes: Vec<Option<Code>> = spec.params.iter().map(|_| None).collect();
        let mut spans = vec![span; spec.params.len()];
        let (mut next, mut strayed) = (0, false);
        for arg in args {
            let position = match &arg.name {
                Some(name) => spec.params.iter().position(|p| p.name == &*name.text),
                None => self.position(spec, &mut next, &arg.value),
            };
            match position {
                Some(position) => {
                    spans[position] = arg.value.span;
                    let code = self.argument(spec, position, &arg.value);
                    if codes[position].replace(code).is_some() {
                        let message = format!("`{}` is given twice", spec.params[position].name);
                        self.tell(Diagnostic::error("arguments", arg.value.span, message));
                    }
                }
                None => {
                    strayed = true;
                    self.stray(spec, arg);
                }
            }
        }
        let missing = spec.params.iter().zip(&codes).filter(|(p, c)| p.default.is_none() && c.is_none());
        let missing: Vec<String> = missing.map(|(p, _)| format!("`{}`", p.name)).collect();
        // What strayed was probably meant for what is missing.
        if !missing.is_empty() && !strayed {
            let message = format!("`{}` needs {}", spec.name, missing.join(", "));
            self.tell(Diagnostic::error("arguments", span, message).hint(usage(spec)));
        }
        (codes, spans)
    }

    /// The next parameter for a positional argument; optional choices are skipped by what is not one of their words.
    fn position(&self, spec: &Spec, next: &mut usize, value: &Expr) -> Option<usize> {
        loop {
            let param = spec.params.get(*next)?;
            *next += 1;
            let skipped = match (param.kind, param.default) {
                (ParamKind::Choice(words), Some(_)) => {
                    !is_word(value, words) && self.fits_later(words, &spec.params[*next..], value)
                }
                _ => false,
            };
            if !skipped {
                return Some(*next - 1);
            }
        }
    }

    /// Whether a later parameter is rather meant than one of `words`, which the argument is not.
    fn fits_later(&self, words: &[&str], rest: &[Param], value: &Expr) -> bool {
        let chosen = |param: &Param| matches!(param.kind, ParamKind::Choice(words) if is_word(value, words));
        let slip = match &value.kind {
            ExprKind::Call(name, None) => nearest(name, words.iter().copied()).is_some(),
            _ => false,
        };
        !rest.is_empty() && (self.is_value(value) || rest.iter().any(chosen) || !slip)
    }

    /// Whether an expression is something else than a bare word.
    fn is_value(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Call(name, None) => self.is_own_name(name),
            _ => true,
        }
    }

    fn argument(&mut self, spec: &Spec, position: usize, value: &Expr) -> Code {
        let param = &spec.params[position];
        // A word of another parameter stands for itself, so that what is said is about the order.
        let stray = match &value.kind {
            ExprKind::Call(name, None) if !param.kind.takes_words() && functions::find(name).is_none() => {
                advice::elsewhere(spec, name)
            }
            _ => None,
        };
        let code = match (&value.kind, param.kind) {
            (ExprKind::Call(name, None), ParamKind::Choice(words)) if words.contains(&&**name) => {
                Code::Value(Value::Word(name.clone()))
            }
            (ExprKind::Call(name, None) | ExprKind::Text(name), ParamKind::Attribute) => {
                self.attribute_name(name, value.span)
            }
            (ExprKind::Call(name, None), kind)
                if kind.takes_words() && !self.is_own_name(name) && !is_read(name, kind) =>
            {
                if kind == ParamKind::Any {
                    self.bare(name, value.span);
                }
                Code::Value(Value::Word(name.clone()))
            }
            (ExprKind::Call(name, None), _) if !self.is_own_name(name) && stray.is_some() => {
                Code::Value(Value::Word(name.clone()))
            }
            _ => self.value(value).0,
        };
        if let Some(known) =
            code.known().filter(|known| !param.kind.accepts(known)).filter(|_| param.kind != ParamKind::Attribute)
        {
            let message =
                format!("`{}` takes {}, found {} `{known}`", param.name, param.kind.words(), known.type_name());
            let near = match param.kind {
                ParamKind::Choice(words) => known.as_str().and_then(|w| nearest(w, words.iter().copied())),
                _ => None,
            };
            let order = stray.map(|other| format!("it is a word of `{other}`: {}", usage(spec)));
            let hints = order.into_iter().chain(advice::unquoted(param.kind, known));
            let error = Diagnostic::error("arguments", value.span, message).did_you_mean(near);
            self.tell(hints.fold(error, Diagnostic::hint));
        }
        self.usual(param, &code, value.span);
        code
    }

    /// A number beyond what is usual works, but may be a slip.
    fn usual(&mut self, param: &Param, code: &Code, span: Span) {
        let Some(number) = code.known().and_then(Value::as_float) else { return };
        let Some([low, high]) = param.usual else { return self.unit(param, number, span) };
        if (low..=high).contains(&number) || !param.kind.accepts(&Value::Float(number)) {
            return;
        }
        // Beyond a share or below nothing there is no meaning at all.
        if low == 0.0 && high == 1.0 || low >= 0.0 && number < 0.0 {
            let allowed = if high == 1.0 { "a share from 0 to 1" } else { "a number from 0 up" };
            let message = format!("`{}` must be {allowed}, not {}", param.name, crate::text::number(number, 4));
            let hint = advice::percent(number).filter(|_| high == 1.0);
            return self.tell(hint.into_iter().fold(Diagnostic::error("arguments", span, message), Diagnostic::hint));
        }
        let [low, high, found] = [low, high, number].map(|n| crate::text::number(n, 4));
        let message = format!("`{}` is {found}, beyond the usual {low} to {high}", param.name);
        self.tell(Diagnostic::lint("usual", span, message));
    }

    /// A bare word where anything may stand: the word itself, or a slip of the pen.
    fn bare(&mut self, name: &Arc<str>, span: Span) {
        if let Some(near) = self.near_value(name) {
            let message = format!("there is no attribute, parameter or function `{name}`: it stands for the text");
            let quoted = format!("a text that is meant stands in quotes: `\"{name}\"`");
            self.tell(Diagnostic::lint("word", span, message).did_you_mean(Some(&near)).hint(quoted));
        }
    }

    /// The slot of an attribute as a number, or the name of a built-in one as a word.
    fn attribute_name(&mut self, name: &Arc<str>, span: Span) -> Code {
        let (module, bare) = self.path(name);
        if let Some(slot) = self.loaded.modules[module].slots.get(&bare) {
            return Code::Value(Value::Float(f64::from(*slot)));
        }
        if self.is_lost(name) || functions::find(name).is_some_and(|f| f.settable) {
            return Code::Value(Value::Word(name.clone()));
        }
        let settable = functions::all().filter(|f| f.settable).map(|f| f.name);
        let near = nearest(name, self.loaded.modules[module].slots.keys().map(|k| &**k).chain(settable));
        let message = format!("there is no attribute `{name}` that can be set");
        let diagnostic = Diagnostic::error("unknown-name", span, message).did_you_mean(near);
        let own = format!("`attr {name} = …` at the top of the file makes one");
        self.tell(Some(own).filter(|_| !name.contains('.')).into_iter().fold(diagnostic, Diagnostic::hint));
        Code::Value(Value::Word(name.clone()))
    }

    fn stray(&mut self, spec: &Spec, arg: &Arg) {
        let diagnostic = match &arg.name {
            Some(name) => {
                let near = nearest(&name.text, spec.params.iter().map(|p| p.name));
                Diagnostic::error("arguments", name.span, format!("`{}` has no parameter `{}`", spec.name, name.text))
                    .did_you_mean(near)
            }
            None => {
                let most = crate::text::counted(spec.params.len(), "argument");
                Diagnostic::error("arguments", arg.value.span, format!("`{}` takes at most {most}", spec.name))
            }
        };
        self.tell(diagnostic.hint(usage(spec)));
    }
}

fn is_word(value: &Expr, words: &[&str]) -> bool {
    match &value.kind {
        ExprKind::Call(name, None) | ExprKind::Text(name) => words.contains(&&**name),
        _ => false,
    }
}

/// Whether a bare word is one of the language's own names, to be read rather than to stand for itself: where a word is
/// wanted (`report(inside, 1)`), only those that give a text.
fn is_read(name: &str, kind: ParamKind) -> bool {
    functions::find(name).is_some_and(|f| kind != ParamKind::Word || f.gives == functions::Gives::Text)
}

/// `it is called as …`, from the declaration.
fn usage(spec: &Spec) -> String {
    format!("it is called as `{}`", spec.usage())
}

fn arity(least: usize, most: usize) -> String {
    match (least, most) {
        (0, 0) => "no arguments".into(),
        (a, b) if a == b => crate::text::counted(a, "argument"),
        (a, b) => format!("{a} to {b} arguments"),
    }
}

/// What a built-in function gives, as expressions are checked, where its first argument is of some kind.
fn result(function: &functions::Function, first: Kind) -> Kind {
    match function.gives {
        functions::Gives::Number => Kind::Number,
        functions::Gives::Truth => Kind::Truth,
        functions::Gives::Text => Kind::Text,
        functions::Gives::Numbers => Kind::Numbers,
        functions::Gives::Truths => Kind::Truths,
        functions::Gives::Texts => Kind::Texts,
        functions::Gives::Same => first,
        functions::Gives::TruthOfEach => match first {
            Kind::Numbers | Kind::Truths | Kind::Texts => Kind::Truths,
            Kind::Number | Kind::Truth | Kind::Text => Kind::Truth,
            Kind::Unknown => Kind::Unknown,
        },
        functions::Gives::Any => Kind::Unknown,
    }
}
