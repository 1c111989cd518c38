//! How is a line of a calculation written, so that it is true as printed? Symbol = formula = figures = result.
//!
//! Figures are rounded to eight digits and the result is worked out from the rounded figures, so that a reader who
//! types them in gets the printed result.

/// An arithmetic expression that is printed twice, with symbols and with figures.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    /// A quantity: its symbol in TeX and its value.
    Quantity(String, f64),
    /// An angle: its symbol in TeX and its value in degrees.
    Degrees(String, f64),
    /// A whole number of the formula.
    Number(u64),
    /// What a series omits: nothing, as far as the printed digits go.
    Dots,
    /// The opposite.
    Minus(Box<Expression>),
    /// π, which has no figure.
    Pi,
    /// A product.
    Product(Vec<Expression>),
    /// A sum.
    Sum(Vec<Expression>),
    /// A fraction.
    Fraction(Box<Expression>, Box<Expression>),
    /// A power with a whole exponent.
    Power(Box<Expression>, u32),
    /// A square root.
    Root(Box<Expression>),
    /// The cosine of an angle in degrees.
    Cosine(Box<Expression>),
}

use Expression::*;

/// A quantity by its symbol.
pub(super) fn quantity(symbol: impl Into<String>, value: f64) -> Expression {
    Quantity(symbol.into(), value)
}

/// One over the other.
pub(super) fn fraction(numerator: Expression, denominator: Expression) -> Expression {
    Fraction(Box::new(numerator), Box::new(denominator))
}

/// Half of a product.
pub(super) fn half() -> Expression {
    fraction(Number(1), Number(2))
}

/// A power.
pub(super) fn power(base: Expression, exponent: u32) -> Expression {
    Power(Box::new(base), exponent)
}

/// What stands before the result of a line, and the result.
pub(super) struct Line {
    /// Left side, in TeX.
    pub symbol: String,
    /// Right side.
    pub expression: Expression,
    /// Unit in TeX, empty for a pure number.
    pub unit: &'static str,
}

impl Line {
    /// The line in TeX, aligned: `s = formula ≈ figures ≈ result unit`.
    pub fn tex(&self) -> String {
        let (formula, figures) = (self.expression.symbols(), self.expression.figures());
        let result = significant(self.value(), RESULT_DIGITS);
        let unit = if self.unit.is_empty() { String::new() } else { format!("\\ \\mathrm{{{}}}", self.unit) };
        let lines = match &self.expression {
            Quantity(symbol, _) if symbol.is_empty() => format!("{} &\\approx {result}{unit}", self.symbol),
            Quantity(symbol, _) => format!("{} &= {symbol} \\approx {result}{unit}", self.symbol),
            _ if letters(&formula) + letters(&figures) < WIDE => {
                format!("{} &= {formula} \\approx {figures} \\approx {result}{unit}", self.symbol)
            }
            _ => format!("{} &= {formula} \\\\\n&\\approx {figures} \\\\\n&\\approx {result}{unit}", self.symbol),
        };
        format!("\\begin{{aligned}}\n{lines}\n\\end{{aligned}}")
    }

    /// The result, from the figures as printed.
    pub fn value(&self) -> f64 {
        self.expression.value()
    }
}

/// Digits of a figure.
const FIGURE_DIGITS: usize = 8;
/// Digits of a result.
const RESULT_DIGITS: usize = 6;
/// Letters of formula and figures that still fit on one line.
const WIDE: usize = 52;

/// What is left of figures that cancel is rounding: a value is 0 where it is as small as that beside what it is made of.
fn unless_rounding(value: f64, parts: f64) -> f64 {
    if value.abs() < 1e-12 * parts { 0.0 } else { value }
}

impl Expression {
    /// The value, from the figures as printed.
    fn value(&self) -> f64 {
        match self {
            Quantity(_, value) | Degrees(_, value) => rounded(*value, FIGURE_DIGITS),
            Number(number) => *number as f64,
            Dots => 0.0,
            Minus(of) => -of.value(),
            Pi => std::f64::consts::PI,
            Product(factors) => factors.iter().map(Expression::value).product(),
            Sum(terms) => {
                let values = || terms.iter().map(Expression::value);
                unless_rounding(values().sum(), values().map(f64::abs).sum())
            }
            Fraction(above, below) => above.value() / below.value(),
            Power(base, exponent) => base.value().powi(*exponent as i32),
            Root(square) => square.value().sqrt(),
            Cosine(degrees) => unless_rounding(degrees.value().to_radians().cos(), 1.0),
        }
    }

    fn symbols(&self) -> String {
        self.print(&|symbol, _, _| symbol.to_owned(), "\\,")
    }

    fn figures(&self) -> String {
        let figure = |_: &str, value: f64, unit: &str| format!("{}{unit}", significant(value, FIGURE_DIGITS));
        self.print(&figure, " \\cdot ")
    }

    /// In brackets where it is a sum or begins with a minus.
    fn print_as_a_factor(&self, quantity: &impl Fn(&str, f64, &str) -> String, times: &str) -> String {
        match self.print(quantity, times) {
            text if matches!(self, Sum(_)) || text.starts_with('-') => format!("\\left({text}\\right)"),
            text => text,
        }
    }

    fn print(&self, quantity: &impl Fn(&str, f64, &str) -> String, times: &str) -> String {
        match self {
            Quantity(symbol, value) => quantity(symbol, *value, ""),
            Degrees(symbol, value) => quantity(symbol, *value, "^{\\circ}"),
            Dots => "\\dots".to_owned(),
            Minus(of) => format!("-{}", of.print_as_a_factor(quantity, times)),
            Number(number) => number.to_string(),
            Pi => "\\pi".to_owned(),
            Product(factors) => {
                let factors = factors.iter().map(|factor| factor.print_as_a_factor(quantity, times));
                factors.collect::<Vec<_>>().join(times)
            }
            Sum(terms) => {
                let terms = terms.iter().map(|term| term.print(quantity, times));
                let mut text = String::new();
                let mut length = 0;
                for (index, term) in terms.enumerate() {
                    length += letters(&term) + 3;
                    // A sum too long for a line goes on in the next.
                    let space = if length > WIDE && index > 0 { " \\\\\n&\\quad " } else { " " };
                    if length > WIDE {
                        length = letters(&term);
                    }
                    match term.strip_prefix('-') {
                        Some(size) if index > 0 => text.push_str(&format!("{space}- {size}")),
                        _ if index > 0 => text.push_str(&format!("{space}+ {term}")),
                        _ => text.push_str(&term),
                    }
                }
                text
            }
            Fraction(above, below) => {
                format!("\\frac{{{}}}{{{}}}", above.print(quantity, times), below.print(quantity, times))
            }
            Power(base, exponent) => {
                let text = base.print(quantity, times);
                let simple = matches!(**base, Quantity(..) | Number(_) | Pi) && !text.contains(['-', ' ']);
                if simple { format!("{text}^{{{exponent}}}") } else { format!("\\left({text}\\right)^{{{exponent}}}") }
            }
            Root(square) => format!("\\sqrt{{{}}}", square.print(quantity, times)),
            Cosine(degrees) => format!("\\cos\\left({}\\right)", degrees.print(quantity, times)),
        }
    }
}

/// A number in TeX, to this many significant digits, without zeros that say nothing.
pub(super) fn significant(value: f64, digits: usize) -> String {
    figures(value, digits, |power| format!(" \\times 10^{{{power}}}"))
}

/// The same, with a power of ten put down in a way of its own.
pub(super) fn figures(value: f64, digits: usize, power: fn(i32) -> String) -> String {
    let (mantissa, exponent) = scientific(value, digits);
    if !(-4..digits as i32 + 2).contains(&exponent) {
        return trimmed(&mantissa) + &power(exponent);
    }
    let places = (digits as i32 - 1 - exponent).max(0) as usize;
    trimmed(&format!("{:.places$}", rounded(value, digits)))
}

/// The number that [`significant`] prints.
pub(super) fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

fn scientific(value: f64, digits: usize) -> (String, i32) {
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (mantissa.to_owned(), exponent.parse().unwrap_or(0))
}

fn trimmed(decimal: &str) -> String {
    let text = if decimal.contains('.') { decimal.trim_end_matches('0').trim_end_matches('.') } else { decimal };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Letters of a formula as it is set: braces are none, a TeX command is about one.
fn letters(formula: &str) -> usize {
    let mut count = 0;
    let mut in_command = false;
    for letter in formula.chars() {
        in_command = letter == '\\' || in_command && letter.is_ascii_alphabetic();
        count += usize::from(letter == '\\' || !in_command && !"{}$*".contains(letter));
    }
    count
}
