//! Expressions: names resolved, constants folded, kinds checked as far as they can be seen.

use crate::check::Checker;
use crate::check::code::{Code, Kind};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, SizeMark, UnaryOp};
use crate::value::{Size, Value};

impl Checker {
    /// An expression with what it gives. What is wrong becomes a 0 that is never evaluated: errors stop the run.
    pub(super) fn value(&mut self, expr: &Expr) -> (Code, Kind) {
        match &expr.kind {
            ExprKind::Number(number) => (Code::Value(Value::Float(*number)), Kind::Number),
            ExprKind::Text(text) => (Code::Value(Value::Text(text.clone())), Kind::Text),
            ExprKind::Bool(truth) => (Code::Value(Value::Bool(*truth)), Kind::Truth),
            ExprKind::Call(name, args) => self.name(name, args.as_deref(), expr.span, &[]),
            ExprKind::Sized(mark, inner) => (self.sized(*mark, inner, expr.span), Kind::Unknown),
            ExprKind::Unary(op, inner) => self.unary(*op, inner, expr.span),
            ExprKind::Binary { op, elementwise: true, left, right } => self.each(*op, left, right, expr.span),
            ExprKind::Binary { op, elementwise: false, left, right } => self.binary(*op, left, right, expr.span),
            ExprKind::Case { arms, otherwise } => self.case(arms, otherwise, expr.span),
            ExprKind::Chance { arms, otherwise } => self.chance(arms, otherwise, expr.span),
            ExprKind::Array(rows) => self.array(rows, expr.span),
            ExprKind::Range { from, step, to } => self.range(from, step.as_deref(), to, expr.span),
            ExprKind::Index(array, indices) => self.index(array, indices, expr.span),
            ExprKind::Comp { args, entries } => self.measure(args, entries, expr.span),
        }
    }

    /// An expression that must be true or false.
    pub(super) fn condition(&mut self, expr: &Expr) -> Code {
        let (code, kind) = self.value(expr);
        self.expect_truth(kind, expr.span);
        code
    }

    /// An expression that must be a number.
    pub(super) fn number(&mut self, expr: &Expr) -> Code {
        let (code, kind) = self.value(expr);
        self.expect_number(kind, expr.span);
        code
    }

    /// `'x`, `~x`, `1r`.
    pub(super) fn sized(&mut self, mark: SizeMark, inner: &Expr, span: Span) -> Code {
        let code = self.number(inner);
        match (mark, code.known().and_then(Value::as_float)) {
            (SizeMark::Relative, Some(number)) => Code::Value(Value::Size(Size::Relative(number))),
            (SizeMark::Floating, Some(number)) => Code::Value(Value::Size(Size::Floating(number))),
            _ => Code::Sized(mark, Box::new(code), span),
        }
    }

    fn expect_truth(&mut self, kind: Kind, span: Span) {
        if !matches!(kind, Kind::Truth | Kind::Unknown) {
            let message = format!("a condition must be true or false, found {}", kind.words());
            let hint = "compare it, as in `x > 0` or `name == \"oak\"`";
            self.tell(Diagnostic::error("kind", span, message).hint(hint));
        }
    }

    fn expect_number(&mut self, kind: Kind, span: Span) {
        if !matches!(kind, Kind::Number | Kind::Unknown) {
            let message = format!("a number is wanted here, found {}", kind.words());
            let diagnostic = Diagnostic::error("kind", span, message);
            self.tell(match kind.is_array() {
                true => diagnostic.hint("operators with a dot before them, `.+`, work element by element"),
                false => diagnostic,
            });
        }
    }

    fn unary(&mut self, op: UnaryOp, inner: &Expr, span: Span) -> (Code, Kind) {
        match op {
            UnaryOp::Not => {
                let (code, kind) = self.value(inner);
                match kind {
                    Kind::Truths => (Code::Not(Box::new(code), span), Kind::Truths),
                    _ => {
                        self.expect_truth(kind, inner.span);
                        (Code::Not(Box::new(code), span), if kind == Kind::Unknown { kind } else { Kind::Truth })
                    }
                }
            }
            UnaryOp::Plus | UnaryOp::Minus => {
                let (code, kind) = self.value(inner);
                if kind != Kind::Numbers {
                    self.expect_number(kind, inner.span);
                }
                match (op, code.known().and_then(Value::as_float)) {
                    (UnaryOp::Plus, _) => (code, kind),
                    (_, Some(number)) => (Code::Value(Value::Float(-number)), Kind::Number),
                    (_, None) => (Code::Negate(Box::new(code), span), kind),
                }
            }
        }
    }

    fn binary(&mut self, op: BinaryOp, left: &Expr, right: &Expr, span: Span) -> (Code, Kind) {
        use BinaryOp as B;
        match op {
            B::And | B::Or => {
                let pair = Box::new((self.condition(left), self.condition(right)));
                (if op == B::And { Code::And(pair, span) } else { Code::Or(pair, span) }, Kind::Truth)
            }
            _ => {
                let ((a, a_kind), (b, b_kind)) = (self.value(left), self.value(right));
                let kind = self.operands(op, (a_kind, left.span), (b_kind, right.span));
                if matches!(op, B::Equal | B::NotEqual) {
                    self.compared(&a, &b, right);
                    self.compared(&b, &a, left);
                }
                (Code::Binary(op, Box::new((a, b)), span), kind)
            }
        }
    }

    /// What an operator gives for operands of these kinds; operands that cannot be are reported.
    pub(super) fn operands(&mut self, op: BinaryOp, left: (Kind, Span), right: (Kind, Span)) -> Kind {
        use BinaryOp as B;
        match op {
            B::Add if left.0 == Kind::Text || right.0 == Kind::Text => Kind::Text,
            B::Add if left.0 == Kind::Unknown || right.0 == Kind::Unknown => Kind::Unknown,
            B::Add | B::Subtract | B::Multiply | B::Divide | B::Remainder => {
                self.expect_number(left.0, left.1);
                self.expect_number(right.0, right.1);
                Kind::Number
            }
            _ => {
                let known = left.0 != Kind::Unknown && right.0 != Kind::Unknown;
                if known && left.0 != right.0 {
                    let message = format!("{} is compared with {}", left.0.words(), right.0.words());
                    self.tell(Diagnostic::error("kind", left.1.to(right.1), message));
                }
                Kind::Truth
            }
        }
    }

    fn case(&mut self, arms: &[(Expr, Expr)], otherwise: &Expr, span: Span) -> (Code, Kind) {
        let checked: Vec<(Code, (Code, Kind))> =
            arms.iter().map(|(test, value)| (self.condition(test), self.value(value))).collect();
        let (last, kind) = self.value(otherwise);
        let kind = checked.iter().fold(kind, |kind, (_, (_, k))| if kind == *k { kind } else { Kind::Unknown });
        (Code::Case(checked.into_iter().map(|(t, (v, _))| (t, v)).collect(), Box::new(last), span), kind)
    }

    fn chance(&mut self, arms: &[(Expr, Expr)], otherwise: &Expr, span: Span) -> (Code, Kind) {
        self.percentages(arms.iter().map(|(percent, _)| percent));
        let checked: Vec<(Code, (Code, Kind))> =
            arms.iter().map(|(percent, value)| (self.number(percent), self.value(value))).collect();
        let (last, kind) = self.value(otherwise);
        let kind = checked.iter().fold(kind, |kind, (_, (_, k))| if kind == *k { kind } else { Kind::Unknown });
        (Code::Chance(checked.into_iter().map(|(t, (v, _))| (t, v)).collect(), Box::new(last), span), kind)
    }

    /// `0.8%`, where 80 in a hundred were meant.
    fn tiny(&mut self, percent: f64, span: Span) {
        if percent > 0.0 && percent < 1.0 {
            let [found, meant] = [percent, 100.0 * percent].map(|n| crate::text::number(n, 4));
            let message = format!("`{found}%` is less than one in a hundred");
            self.tell(Diagnostic::lint("usual", span, message).hint(format!("a share of {found} is `{meant}%`")));
        }
    }

    /// Percentages that are written as numbers must not exceed 100 together.
    pub(super) fn percentages<'a>(&mut self, percents: impl Iterator<Item = &'a Expr>) {
        let mut sum = 0.0;
        let mut place: Option<Span> = None;
        for percent in percents {
            place = Some(place.map_or(percent.span, |p| p.to(percent.span)));
            if let ExprKind::Number(number) = percent.kind {
                self.tiny(number, percent.span);
                sum += number;
            }
        }
        if let (true, Some(span)) = (sum > 100.0 + 1e-9, place) {
            let message = format!("the percentages sum to {}, more than 100", crate::text::number(sum, 3));
            self.tell(Diagnostic::error("percentages", span, message).hint("the `else` takes what is left of 100"));
        }
    }
}
