//! A growth curve: one equation of the Urban Tree Database with its coefficients and the range it was measured on.
//!
//! McPherson, van Doorn, Peper 2016 (PSW-GTR-253), table 3, as corrected in January 2020. With L = ln(ln(x + 1)):
//!
//! | form | value |
//! |---|---|
//! | `lin` `quad` `cub` `quart` | a + b x + c x² + d x³ + e x⁴ |
//! | `loglogw1` … `loglogw4` | exp(a + b L + w c/2) |
//! | `expow1` … `expow4` | exp(a + b x + w c/2) |
//!
//! with w = 1, √x, x, x² for the weights 1 to 4; c is the mean squared error of the fit in logarithms.
//!
//! **`loglogw1`.** The table prints exp(a + b ln(ln(x + 1) + c/2)), the mean squared error inside the outer logarithm,
//! unlike the other seven. The measured trees (table TS3: 451 equations with ten trees and more, 17,745 values) decide
//! for the form above. The median over equations of the absolute bias is, above against printed: height 0.3 % against
//! 0.9 %, crown diameter 0.5 % against 0.7 %, crown height 0.4 % against 1.3 %, trunk 0.6 % against 1.2 %, leaf area
//! 4.5 % against 10 %; it is the nearer one for 345 of the 451. The limits `Apps min` and `Apps max` of the table were
//! worked out with the printed form; for lengths the two differ by about a hundredth.

/// An equation, where it holds, and what it may give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    form: Form,
    /// a, b, c, d, e; 0 where the form has no more.
    with: [f64; 5],
    /// The part of x on which the curve rises; outside of it the end's value holds.
    over: [f64; 2],
    /// The least and greatest value.
    within: [f64; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    Polynomial,
    LogLog(Weight),
    Exponential(Weight),
}

/// What the correction for logarithms grows with.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Weight {
    One,
    Root,
    Linear,
    Square,
}

/// Every form with the table's word for it and how many coefficients it takes.
const FORMS: [(&str, Form, usize); 12] = [
    ("lin", Form::Polynomial, 2),
    ("quad", Form::Polynomial, 3),
    ("cub", Form::Polynomial, 4),
    ("quart", Form::Polynomial, 5),
    ("loglogw1", Form::LogLog(Weight::One), 3),
    ("loglogw2", Form::LogLog(Weight::Root), 3),
    ("loglogw3", Form::LogLog(Weight::Linear), 3),
    ("loglogw4", Form::LogLog(Weight::Square), 3),
    ("expow1", Form::Exponential(Weight::One), 3),
    ("expow2", Form::Exponential(Weight::Root), 3),
    ("expow3", Form::Exponential(Weight::Linear), 3),
    ("expow4", Form::Exponential(Weight::Square), 3),
];

impl Curve {
    /// The curve that a catalogue describes: `{ form = "quad", with = [a, b, c], over = [0, 56], within = [2, 18] }`.
    pub fn read(table: &toml::Table) -> Result<Curve, String> {
        let word = table.get("form").and_then(toml::Value::as_str).unwrap_or_default();
        let Some((_, form, count)) = FORMS.iter().find(|(known, ..)| *known == word) else {
            let known: Vec<String> = FORMS.iter().map(|(word, ..)| format!("`{word}`")).collect();
            return Err(format!("`form` must be one of {}, not `{word}`", known.join(", ")));
        };
        let given = numbers(table, "with").filter(|given| given.len() == *count);
        let given = given.ok_or_else(|| format!("`with` must be a list of {count} numbers for `{word}`"))?;
        let mut with = [0.0; 5];
        with[..*count].copy_from_slice(&given);
        Ok(Curve { form: *form, with, over: range(table, "over")?, within: range(table, "within")? })
    }

    /// Its value at `x`, in the units of its table; beyond its range that of the nearer end. Always finite.
    pub fn at(&self, x: f64) -> f64 {
        let x = x.max(self.over[0]).min(self.over[1]);
        let value = self.equation(x);
        value.max(self.within[0]).min(self.within[1])
    }

    /// The equation alone, anywhere; 0 or not finite where it has no meaning.
    pub fn equation(&self, x: f64) -> f64 {
        let [a, b, c, d, e] = self.with;
        match self.form {
            Form::Polynomial => a + x * (b + x * (c + x * (d + x * e))),
            // The double logarithm has no value at 0: nothing has grown yet.
            Form::LogLog(_) if x <= 0.0 => 0.0,
            Form::LogLog(weight) => libm::exp(a + b * libm::log(libm::log(x + 1.0)) + weight.at(x) * c / 2.0),
            Form::Exponential(weight) => libm::exp(a + b * x + weight.at(x) * c / 2.0),
        }
    }
}

impl Weight {
    fn at(self, x: f64) -> f64 {
        match self {
            Weight::One => 1.0,
            Weight::Root => x.max(0.0).sqrt(),
            Weight::Linear => x,
            Weight::Square => x * x,
        }
    }
}

/// A list of finite numbers.
fn numbers(table: &toml::Table, key: &str) -> Option<Vec<f64>> {
    let number = |value: &toml::Value| value.as_float().or(value.as_integer().map(|n| n as f64));
    let list = table.get(key)?.as_array()?;
    list.iter().map(|value| number(value).filter(|n| n.is_finite())).collect()
}

/// A pair of numbers from 0 up, the lesser first.
pub(super) fn range(table: &toml::Table, key: &str) -> Result<[f64; 2], String> {
    match numbers(table, key).as_deref() {
        Some([low, high]) if 0.0 <= *low && low <= high => Ok([*low, *high]),
        _ => Err(format!("`{key}` must be two numbers from 0 up, the lesser first")),
    }
}
