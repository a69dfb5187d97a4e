//! Values, expressions, arguments.

use super::{Builder, next_if, unescaped};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{Arg, BinaryOp, Expr, ExprKind, Name, Separator, SizeMark, UnaryOp};
use crate::syntax::grammar::{Pair, Rule};
use pest::iterators::Pairs;
use pest::pratt_parser::{Assoc, Op, PrattParser};
use std::sync::LazyLock;

/// The operators by rising precedence.
static PRECEDENCE: LazyLock<PrattParser<Rule>> = LazyLock::new(|| {
    let infix = |rule| Op::infix(rule, Assoc::Left);
    PrattParser::new()
        .op(infix(Rule::or))
        .op(infix(Rule::and))
        .op(infix(Rule::comparison))
        .op(infix(Rule::sum))
        .op(infix(Rule::product))
        .op(Op::prefix(Rule::prefix))
        .op(Op::postfix(Rule::args) | Op::postfix(Rule::values_block) | Op::postfix(Rule::index))
});

impl<'t> Builder<'t> {
    /// A value: an expression or a choice, with or without a size mark.
    pub(super) fn value(&self, pair: Pair<'t>) -> Option<Expr> {
        let mut inner = pair.into_inner();
        let size = self.size(&mut inner);
        let value = match inner.clone().next_back()?.as_rule() {
            Rule::case_values => self.case_values(inner.next_back()?)?,
            Rule::chance_values => {
                let chances = inner.next_back()?;
                self.chance_values(self.parts(inner)?, chances)?
            }
            _ => self.parts(inner)?,
        };
        Some(sized(size, value))
    }

    /// What stands before a separator in a block.
    pub(super) fn key(&self, pair: Pair<'t>) -> Option<Expr> {
        let mut inner = pair.into_inner();
        let size = self.size(&mut inner);
        Some(sized(size, self.parts(inner)?))
    }

    /// The mark at the very start, which belongs to the whole.
    fn size(&self, inner: &mut Pairs<'t, Rule>) -> Option<(SizeMark, Span)> {
        let first = inner.peek().filter(|first| matches!(first.as_rule(), Rule::prefix | Rule::size))?;
        let mark = size_mark(first.as_str())?;
        inner.next();
        Some((mark, self.span(&first)))
    }

    /// A node that holds one expression.
    pub(super) fn expression(&self, pair: Pair<'t>) -> Option<Expr> {
        self.parts(pair.into_inner())
    }

    /// Operands and operators in a row. Never empty, by the grammar.
    fn parts(&self, parts: Pairs<'t, Rule>) -> Option<Expr> {
        if parts.len() == 1 {
            return self.primary(parts.peek()?);
        }
        PRECEDENCE
            .map_primary(|part| self.primary(part))
            .map_prefix(|operator, operand| self.prefixed(&operator, operand?))
            .map_postfix(|operand, operator| self.postfixed(operand?, operator))
            .map_infix(|left, operator, right| self.binary(left?, &operator, right?))
            .parse(parts)
    }

    fn primary(&self, pair: Pair<'t>) -> Option<Expr> {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::number => match pair.as_str().strip_suffix('r') {
                None => ExprKind::Number(self.number(pair.as_str(), span)),
                Some(digits) => {
                    let number = Expr { kind: ExprKind::Number(self.number(digits, span)), span };
                    ExprKind::Sized(SizeMark::Floating, Box::new(number))
                }
            },
            Rule::text => ExprKind::Text(unescaped(pair.as_str())),
            Rule::name => match pair.as_str() {
                "true" => ExprKind::Bool(true),
                "false" => ExprKind::Bool(false),
                name => ExprKind::Call(self.intern(name), None),
            },
            Rule::paren => return self.paren(pair),
            Rule::array => self.array(pair)?,
            Rule::braced => ExprKind::Array(vec![pair.into_inner().map(|v| self.value(v)).collect::<Option<_>>()?]),
            Rule::value => return self.value(pair),
            _ => return None,
        };
        Some(Expr { kind, span })
    }

    /// A value in parentheses, which leave no trace but the place.
    pub(super) fn paren(&self, pair: Pair<'t>) -> Option<Expr> {
        let span = self.span(&pair);
        Some(Expr { span, ..self.value(pair.into_inner().next()?)? })
    }

    pub(super) fn number(&self, digits: &str, span: Span) -> f64 {
        let number: f64 = digits.parse().unwrap_or(f64::INFINITY);
        if number.is_infinite() {
            self.report(Diagnostic::error("syntax-number", span, format!("`{digits}` is too large a number")));
        }
        number
    }

    fn prefixed(&self, operator: &Pair<'t>, operand: Expr) -> Option<Expr> {
        let span = self.span(operator).to(operand.span);
        let unary = |op, operand| ExprKind::Unary(op, Box::new(operand));
        let kind = match operator.as_str() {
            "-" => unary(UnaryOp::Minus, operand),
            "+" => unary(UnaryOp::Plus, operand),
            "!" | ".!" => unary(UnaryOp::Not, operand),
            mark => ExprKind::Sized(size_mark(mark)?, Box::new(operand)),
        };
        Some(Expr { kind, span })
    }

    fn postfixed(&self, operand: Expr, operator: Pair<'t>) -> Option<Expr> {
        let span = operand.span.to(self.span(&operator));
        let kind = match (operator.as_rule(), operand.kind) {
            (Rule::index, kind) => {
                let indexed = Expr { kind, ..operand };
                let at = operator.into_inner().map(|element| self.element(element)).collect::<Option<_>>()?;
                ExprKind::Index(Box::new(indexed), at)
            }
            (Rule::args, ExprKind::Call(name, None)) => ExprKind::Call(name, Some(self.args(operator)?)),
            (Rule::args, ExprKind::Bool(value)) => {
                let message = format!("`{value}` takes no arguments");
                self.report(Diagnostic::error("syntax-arguments", span, message));
                ExprKind::Bool(value)
            }
            (Rule::values_block, ExprKind::Call(name, Some(args))) if &*name == "comp" => {
                ExprKind::Comp { args, entries: self.values_block(operator)? }
            }
            (Rule::values_block, kind) => {
                let message = "no function but `comp(…)` takes a block";
                self.report(Diagnostic::error("syntax-block", self.span(&operator), message));
                kind
            }
            _ => return None,
        };
        Some(Expr { kind, span })
    }

    fn values_block(&self, pair: Pair<'t>) -> Option<Vec<(Expr, Separator, Expr)>> {
        let (mut inner, mut entries) = (pair.into_inner(), Vec::new());
        while let Some(key) = inner.next() {
            let key = self.key(key)?;
            let separator = separator(&inner.next()?);
            entries.push((key, separator, self.value(inner.next()?)?));
        }
        Some(entries)
    }

    fn binary(&self, left: Expr, operator: &Pair<'t>, right: Expr) -> Option<Expr> {
        let span = left.span.to(right.span);
        let (elementwise, sign) = match operator.as_str().strip_prefix('.') {
            Some(sign) => (true, sign),
            None => (false, operator.as_str()),
        };
        let op = binary_op(sign)?;
        Some(Expr { kind: ExprKind::Binary { op, elementwise, left: Box::new(left), right: Box::new(right) }, span })
    }

    /// `(a, width = 4)`
    pub(super) fn args(&self, pair: Pair<'t>) -> Option<Vec<Arg>> {
        let (mut inner, mut args) = (pair.into_inner(), Vec::new());
        while inner.peek().is_some() {
            args.push(self.arg(&mut inner)?);
        }
        Some(args)
    }

    /// One argument from a row of values and equals signs.
    pub(super) fn arg(&self, inner: &mut Pairs<'t, Rule>) -> Option<Arg> {
        let value = self.primary(inner.next()?)?;
        if next_if(inner, Rule::named).is_none() {
            return Some(Arg { name: None, value });
        }
        let name = match value.kind {
            ExprKind::Call(text, None) => Some(Name { text, span: value.span }),
            _ => {
                let message = "only a name can stand before the `=` of an argument";
                let hint = "`name = value` names an argument; `==` compares";
                self.report(Diagnostic::error("syntax-arguments", value.span, message).hint(hint));
                None
            }
        };
        Some(Arg { name, value: self.primary(inner.next()?)? })
    }

    fn array(&self, pair: Pair<'t>) -> Option<ExprKind> {
        let row = |row: Pair<'t>| row.into_inner().map(|element| self.element(element)).collect::<Option<Vec<_>>>();
        Some(ExprKind::Array(pair.into_inner().map(row).collect::<Option<_>>()?))
    }

    fn element(&self, pair: Pair<'t>) -> Option<Expr> {
        let mut inner = pair.into_inner();
        let first = self.value(inner.next()?)?;
        let Some(second) = inner.next() else { return Some(first) };
        let second = self.value(second)?;
        let (step, to) = match inner.next() {
            Some(third) => (Some(Box::new(second)), self.value(third)?),
            None => (None, second),
        };
        let span = first.span.to(to.span);
        Some(Expr { kind: ExprKind::Range { from: Box::new(first), step, to: Box::new(to) }, span })
    }

    fn case_values(&self, pair: Pair<'t>) -> Option<Expr> {
        let start = self.span(&pair);
        let (mut inner, mut arms) = (pair.into_inner(), Vec::new());
        while let Some(condition) = next_if(&mut inner, Rule::condition) {
            arms.push((self.expression(condition)?, self.value(inner.next()?)?));
        }
        let otherwise = Box::new(self.value(inner.next()?)?);
        let span = start.to(otherwise.span);
        Some(Expr { kind: ExprKind::Case { arms, otherwise }, span })
    }

    fn chance_values(&self, first: Expr, pair: Pair<'t>) -> Option<Expr> {
        let (mut inner, start) = (pair.into_inner(), first.span);
        let mut arms = vec![(first, self.value(inner.next()?)?)];
        while let Some(chance) = next_if(&mut inner, Rule::chance) {
            arms.push((self.expression(chance)?, self.value(inner.next()?)?));
        }
        let otherwise = Box::new(self.value(inner.next()?)?);
        let span = start.to(otherwise.span);
        Some(Expr { kind: ExprKind::Chance { arms, otherwise }, span })
    }
}

pub(super) fn separator(pair: &Pair<'_>) -> Separator {
    match pair.as_str() {
        "=" => Separator::All,
        "=:" => Separator::Connected,
        _ => Separator::Each,
    }
}

fn sized(size: Option<(SizeMark, Span)>, value: Expr) -> Expr {
    match size {
        Some((mark, span)) => Expr { span: span.to(value.span), kind: ExprKind::Sized(mark, Box::new(value)) },
        None => value,
    }
}

fn size_mark(sign: &str) -> Option<SizeMark> {
    match sign {
        "'" => Some(SizeMark::Relative),
        "~" => Some(SizeMark::Floating),
        _ => None,
    }
}

fn binary_op(sign: &str) -> Option<BinaryOp> {
    Some(match sign {
        "||" => BinaryOp::Or,
        "&&" => BinaryOp::And,
        "==" => BinaryOp::Equal,
        "!=" => BinaryOp::NotEqual,
        "<" => BinaryOp::Less,
        "<=" => BinaryOp::LessEqual,
        ">" => BinaryOp::Greater,
        ">=" => BinaryOp::GreaterEqual,
        "+" => BinaryOp::Add,
        "-" => BinaryOp::Subtract,
        "*" => BinaryOp::Multiply,
        "/" => BinaryOp::Divide,
        "%" => BinaryOp::Remainder,
        _ => return None,
    })
}
