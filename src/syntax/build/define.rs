//! Annotations and definitions.

use super::{Builder, next_if};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{
    Annotation, Expr, ExprKind, Function, FunctionKind, Import, ItemKind, Name, Override, Rule as RuleAst, RuleMark,
    Spelling, Text,
};
use crate::syntax::grammar::{Pair, Rule};
use pest::iterators::Pairs;

impl<'t> Builder<'t> {
    /// `@Name(args)`, from the inside of an `annotation_piece`.
    pub fn annotation(&self, mut inner: Pairs<'t, Rule>) -> Option<Annotation> {
        let name = self.name(&inner.next()?);
        let notes = next_if(&mut inner, Rule::notes);
        let end = notes.as_ref().map_or(name.span, |notes| self.span(notes));
        let span = Span { start: name.span.start - 1, ..name.span }.to(end);
        let args = match notes {
            Some(notes) => self.args(notes)?,
            None => Vec::new(),
        };
        Some(Annotation { name, args, span })
    }

    /// `version "…"`, from the inside of a `version_piece`.
    pub fn version(&self, mut inner: Pairs<'t, Rule>) -> Option<Text> {
        Some(self.text(&inner.next()?))
    }

    /// `style S extends B`, from the inside of a `style_piece`.
    pub fn style(&self, mut inner: Pairs<'t, Rule>) -> Option<ItemKind> {
        let name = self.name(&inner.next()?);
        let base = next_if(&mut inner, Rule::name).map(|base| self.name(&base));
        Some(ItemKind::Style { name, base })
    }

    /// `import …`, from the inside of an `import_piece`.
    pub fn import(&self, mut inner: Pairs<'t, Rule>) -> Option<ItemKind> {
        let name = self.name(&inner.next()?);
        let styles = next_if(&mut inner, Rule::styles).map_or(Vec::new(), |styles| self.names(styles));
        let path = self.text(&inner.next()?);
        let overrides = match next_if(&mut inner, Rule::overrides) {
            Some(list) => Some(list.into_inner().map(|one| self.overridden(one)).collect::<Option<_>>()?),
            None => None,
        };
        Some(ItemKind::Import(Import { name, styles, path, overrides }))
    }

    fn overridden(&self, pair: Pair<'t>) -> Option<Override> {
        let mut inner = pair.into_inner();
        let name = self.name(&inner.next()?);
        match inner.peek().map(|next| next.as_rule()) {
            None => Some(Override::Protect(name)),
            Some(Rule::named) => Some(Override::Attribute(name, self.value(inner.nth(1)?)?)),
            Some(_) => Some(Override::Rule(Box::new(self.rule_from(None, name, inner)?))),
        }
    }

    /// `attr`, `const` or a function, from the inside of a `value_piece`.
    pub fn definition(&self, mut inner: Pairs<'t, Rule>) -> Option<ItemKind> {
        let mut inner = inner.next()?.into_inner();
        let kind = match next_if(&mut inner, Rule::attr_word).map(|word| word.as_str()) {
            Some("attr") => FunctionKind::Attr,
            Some(_) => FunctionKind::Const,
            None => FunctionKind::Function,
        };
        let name = self.name(&inner.next()?);
        let params = next_if(&mut inner, Rule::params).map(|params| self.names(params));
        let locals = self.locals(&mut inner)?;
        let value = match inner.next() {
            Some(value) if value.as_rule() == Rule::value => self.value(value)?,
            _ => self.absent_value(kind, &name, params.is_some()),
        };
        Some(ItemKind::Function(Function { kind, name, params, locals, value }))
    }

    /// The value of `attr streetWidth(index)`: none is written, the layout gives it; without a layout nothing is a street.
    fn absent_value(&self, kind: FunctionKind, name: &Name, with_params: bool) -> Expr {
        if kind != FunctionKind::Attr || !with_params {
            let message = format!("`{}` has no value", name.text);
            let hint = match &*name.text {
                "float" | "int" | "number" | "bool" | "boolean" | "string" | "str" => {
                    "kinds are not written, they follow from the value: `attr a = 3`".to_owned()
                }
                name => format!("write `{name} = …`"),
            };
            self.report(Diagnostic::error("syntax", name.span, message).hint(hint));
        }
        Expr { kind: ExprKind::Number(0.0), span: Span { start: name.span.end, ..name.span } }
    }

    fn locals(&self, inner: &mut Pairs<'t, Rule>) -> Option<Vec<(Name, Expr)>> {
        let mut locals = Vec::new();
        let mut parts = match next_if(inner, Rule::locals) {
            Some(list) => list.into_inner(),
            None => return Some(locals),
        };
        while let Some(name) = parts.next() {
            locals.push((self.name(&name), self.value(parts.next()?)?));
        }
        Some(locals)
    }

    /// `Name(params) --> body`, from the inside of a `rule_piece`.
    pub fn rule(&self, mut inner: Pairs<'t, Rule>) -> Option<ItemKind> {
        let mark = next_if(&mut inner, Rule::rule_mark).map(|mark| match mark.as_str().starts_with("start") {
            true => RuleMark::Start,
            false => RuleMark::Extension,
        });
        let name = self.name(&inner.next()?);
        Some(ItemKind::Rule(self.rule_from(mark, name, inner)?))
    }

    /// What follows a rule's name: parameters, locals, body.
    fn rule_from(&self, mark: Option<RuleMark>, name: Name, mut inner: Pairs<'t, Rule>) -> Option<RuleAst> {
        let params = next_if(&mut inner, Rule::params).map(|params| self.names(params));
        let locals = self.locals(&mut inner)?;
        let body = self.body(inner.next()?)?;
        let (id, condition, probability, spelling) = (None, None, None, Spelling::Cga);
        Some(RuleAst { mark, id, name, params, locals, condition, probability, body, spelling })
    }

    /// `id: Name(params) : condition ~> body : probability`, from the inside of a `paper_piece`.
    pub fn paper_rule(&self, mut inner: Pairs<'t, Rule>) -> Option<ItemKind> {
        let id = next_if(&mut inner, Rule::label).map(|label| self.name(&label));
        let name = self.name(&inner.next()?);
        let params = next_if(&mut inner, Rule::params).map(|params| self.names(params));
        let condition = match next_if(&mut inner, Rule::condition) {
            Some(condition) => Some(self.expression(condition)?),
            None => None,
        };
        let body = self.body(inner.next()?)?;
        let probability = match next_if(&mut inner, Rule::probability) {
            Some(probability) => Some(self.expression(probability)?),
            None => None,
        };
        let (mark, locals, spelling) = (None, Vec::new(), Spelling::Paper);
        Some(ItemKind::Rule(RuleAst { mark, id, name, params, locals, condition, probability, body, spelling }))
    }
}
