//! `case`, percentages and `else`: which belongs to which, told from the tokens alone.
//!
//! A choice opens where a successor or value may begin, runs on through its further alternatives, and is settled by its
//! `else`. Following that gives the mistakes their right place: the `case` that has no `else`, not the bracket after it.

use super::Broken;
use crate::diag::Diagnostic;
use crate::syntax::token::Kind;

/// One `case …` or `30% : …` under way.
struct Choice {
    /// Brackets around it.
    level: usize,
    /// The first `case`, or the first percentage.
    opened: usize,
    /// The `case` whose colon has not come yet.
    waiting: Option<usize>,
    /// Percentages rather than conditions.
    by_chance: bool,
    /// `else` has been seen.
    settled: bool,
}

/// What is wrong with a choice, and at which token.
enum Fault {
    NoElse { opened: usize, by_chance: bool },
    NoColon { case: usize },
    NoColonAfterElse { at: usize },
    LoneElse { at: usize },
    OperationsBefore { at: usize, by_chance: bool },
}

impl Broken<'_> {
    /// The first choice of the piece that does not work out.
    pub(super) fn broken_choice(&self) -> Option<Diagnostic> {
        let mut walk = Walk { broken: self, level: 0, choices: Vec::new() };
        let fault = self.piece.tokens.clone().find_map(|index| walk.step(index).err());
        fault.or_else(|| walk.leave(0).err()).map(|fault| self.fault(fault))
    }

    fn fault(&self, fault: Fault) -> Diagnostic {
        match fault {
            Fault::NoElse { opened, by_chance } => {
                let what = if by_chance { "choice by chance" } else { "`case`" };
                let message = format!("this {what} has no `else`");
                let hint = "every choice ends with `else : …`; `else : NIL` leaves nothing";
                self.error("syntax-else", self.span(opened), message).hint(hint)
            }
            Fault::NoColon { case } => {
                let message = "the condition of this `case` has no `:` after it";
                self.error("syntax-case", self.span(case), message).hint("write `case condition : …`")
            }
            Fault::NoColonAfterElse { at } => {
                let message = format!(
                    "expected `:` after `else`, found {}",
                    self.found(Some(at + 1).filter(|i| self.kind(*i).is_some()))
                );
                self.error("syntax-else", self.span(at), message)
            }
            Fault::LoneElse { at } => {
                if let Some(percent) = self.bare_percent(at) {
                    return self.no_colon_after_percent(percent);
                }
                let message = "this `else` belongs to no `case` and to no percentage";
                self.error("syntax-else", self.span(at), message)
            }
            Fault::OperationsBefore { at, by_chance } => self.operations_before(at, by_chance),
        }
    }

    fn operations_before(&self, at: usize, by_chance: bool) -> Diagnostic {
        if let Some(percent) = self.bare_percent(at).filter(|_| by_chance) {
            return self.no_colon_after_percent(percent);
        }
        let (code, what) = if by_chance { ("syntax-chance", "a percentage") } else { ("syntax-case", "`case`") };
        let message = format!("operations cannot stand before {what} in the same successor");
        let sign = if by_chance { "50% : A else : B" } else { "case a : A else : B" };
        self.error(code, self.span(at), message)
            .hint(format!("wrap the choice in brackets, `t(0,1,0) [ {sign} ]`, or give it a rule of its own"))
    }
}

impl Broken<'_> {
    /// The last `30 %` before a token that has no colon after it.
    fn bare_percent(&self, before: usize) -> Option<usize> {
        let bare = |at: usize| self.kind(at) == Some(Kind::Percent) && self.kind(at + 1) != Some(Kind::Colon);
        (self.piece.tokens.start..before).rev().find(|at| bare(*at) && self.kind_before(*at) == Some(Kind::Number))
    }

    /// `30% A`
    pub(super) fn no_colon_after_percent(&self, percent: usize) -> Diagnostic {
        let message = "this `%` has no `:` after it";
        self.error("syntax-chance", self.span(percent), message).hint("write `30% : A  20% : B  else : C`")
    }
}

struct Walk<'b, 't> {
    broken: &'b Broken<'t>,
    level: usize,
    choices: Vec<Choice>,
}

impl Walk<'_, '_> {
    fn step(&mut self, index: usize) -> Result<(), Fault> {
        match self.broken.kind(index) {
            Some(Kind::Open) => self.level += 1,
            Some(Kind::Close) => {
                self.leave(self.level)?;
                self.level = self.level.saturating_sub(1);
            }
            Some(Kind::Bar | Kind::Comma | Kind::Semicolon | Kind::Joined) => self.leave(self.level)?,
            Some(Kind::Colon) => self.colon(),
            Some(Kind::Case) => self.case(index)?,
            Some(Kind::Else) => self.otherwise(index)?,
            Some(Kind::Percent) if self.broken.kind(index + 1) == Some(Kind::Colon) => self.percent(index)?,
            _ => {}
        }
        Ok(())
    }

    fn colon(&mut self) {
        if let Some(choice) = self.choices.last_mut().filter(|choice| choice.level == self.level) {
            choice.waiting = None;
        }
    }

    fn case(&mut self, index: usize) -> Result<(), Fault> {
        if self.opens(index) {
            self.open(index, Some(index), false);
            return Ok(());
        }
        match self.unsettled()? {
            Some(choice) if !choice.by_chance => {
                choice.waiting = Some(index);
                Ok(())
            }
            _ => Err(Fault::OperationsBefore { at: index, by_chance: false }),
        }
    }

    fn percent(&mut self, index: usize) -> Result<(), Fault> {
        let start = self.broken.operand_start(index.saturating_sub(1));
        if self.opens(start) {
            self.open(start, None, true);
            return Ok(());
        }
        match self.unsettled()? {
            Some(choice) if choice.by_chance => Ok(()),
            _ => Err(Fault::OperationsBefore { at: start, by_chance: true }),
        }
    }

    fn otherwise(&mut self, index: usize) -> Result<(), Fault> {
        let Some(choice) = self.unsettled()? else { return Err(Fault::LoneElse { at: index }) };
        choice.settled = true;
        match self.broken.kind(index + 1) {
            Some(Kind::Colon) => Ok(()),
            _ => Err(Fault::NoColonAfterElse { at: index }),
        }
    }

    fn open(&mut self, opened: usize, waiting: Option<usize>, by_chance: bool) {
        self.choices.push(Choice { level: self.level, opened, waiting, by_chance, settled: false });
    }

    /// Whether a successor or value may begin at this token.
    fn opens(&self, index: usize) -> bool {
        let before = self.broken.kind_before(index);
        let starts = matches!(
            before,
            None | Some(Kind::Colon | Kind::Open | Kind::Arrow | Kind::Squiggle | Kind::Equal | Kind::Joined)
        );
        starts || matches!(before, Some(Kind::Bar | Kind::Comma | Kind::Semicolon | Kind::Mark))
    }

    /// The innermost choice on this level that still waits for its `else`; settled ones inside it are done.
    fn unsettled(&mut self) -> Result<Option<&mut Choice>, Fault> {
        while self.choices.last().is_some_and(|choice| choice.level == self.level && choice.settled) {
            self.choices.pop();
        }
        match self.choices.last_mut().filter(|choice| choice.level == self.level) {
            Some(Choice { waiting: Some(case), .. }) => Err(Fault::NoColon { case: *case }),
            other => Ok(other),
        }
    }

    /// All choices on this level and inside end here.
    fn leave(&mut self, level: usize) -> Result<(), Fault> {
        while let Some(choice) = self.choices.pop_if(|choice| choice.level >= level) {
            match choice {
                Choice { waiting: Some(case), .. } => return Err(Fault::NoColon { case }),
                Choice { settled: false, opened, by_chance, .. } => return Err(Fault::NoElse { opened, by_chance }),
                _ => {}
            }
        }
        Ok(())
    }
}
