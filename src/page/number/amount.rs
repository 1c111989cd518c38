//! Is a number exact, closed or a decimal, and so a length and a direction?

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::digits::{approximate, degrees, is_long, signed_degrees};
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction, Form, float};

/// Longer closed forms than this tell a reader nothing; their decimals do.
const LONGEST_FORM: usize = 48;
/// Digits of the longest number in a closed form that is shown.
const MOST_DIGITS: usize = 4;

/// Whether a form tells more than its decimals: it is short, and its numbers do not just repeat the digits of the layout's.
fn is_readable(form: &Form) -> bool {
    let text = form.to_string();
    let longest_number = text.split(|letter: char| !letter.is_ascii_digit()).map(str::len).max().unwrap_or(0);
    text.chars().count() <= LONGEST_FORM && longest_number <= MOST_DIGITS
}

/// A number on a page.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Number {
    /// Exactly zero, proved.
    Zero,
    /// An exact number that is short enough to be read.
    Exact(BigRational),
    /// An irrational number, exact, with its decimals.
    Closed(Form, f64),
    /// A decimal.
    Decimal(f64),
}

impl Number {
    /// An exact number; a decimal where it is too long to be read.
    pub fn exact(value: &BigRational) -> Self {
        match value {
            zero if zero.is_zero() => Number::Zero,
            long if is_long(long) => Number::Decimal(float(long)),
            short => Number::Exact(short.clone()),
        }
    }
}

/// A length: exact where a closed form is known, and in decimals.
#[derive(Clone, Debug)]
pub struct Amount {
    /// The number itself.
    pub exact: Option<Form>,
    /// Its decimals.
    pub decimal: f64,
}

impl Amount {
    /// Zero, exactly.
    pub fn zero() -> Self {
        Amount { exact: Some(Form::rational(BigRational::zero())), decimal: 0.0 }
    }

    /// The length of a sum; exactly zero where that is proved.
    pub fn of(sum: &PhasorSum) -> Self {
        match sum.vanishes() {
            true => Amount::zero(),
            false => Amount { exact: numbers::modulus(sum), decimal: numbers::length(numbers::evaluate(sum)) },
        }
    }

    /// Half the sum of two amounts.
    pub fn mean(&self, other: &Amount) -> Amount {
        let half = BigRational::new(1.into(), 2.into());
        let exact =
            self.exact.as_ref().zip(other.exact.as_ref()).map(|(a, b)| numbers::plainer(a.plus(b).scaled(&half)));
        Amount { exact, decimal: (self.decimal + other.decimal) / 2.0 }
    }

    /// As it is shown.
    pub fn number(&self) -> Number {
        match &self.exact {
            None => Number::Decimal(self.decimal),
            Some(form) => match form.as_rational() {
                Some(value) => Number::exact(&value),
                None if is_readable(form) => Number::Closed(form.clone(), self.decimal),
                None => Number::Decimal(self.decimal),
            },
        }
    }
}

/// A direction: exact where a closed form is known.
#[derive(Clone, Debug)]
pub struct Bearing {
    /// The direction itself.
    pub exact: Option<Direction>,
    /// In degrees, in `(−180, 180]`.
    pub decimal: f64,
}

impl Bearing {
    /// An arctangent in TeX and as plain text, where it is one.
    pub(crate) fn arctangent(&self) -> Option<[String; 2]> {
        let (tangent, opposite) = match &self.exact {
            Some(Direction::Arctangent { tangent, opposite }) => (tangent, opposite),
            Some(Direction::Turned { by, tangent }) => return Some(turned(by, tangent)),
            Some(Direction::Turn(_)) | None => return None,
        };
        let negative = tangent.to_float() < 0.0;
        let size = if negative { tangent.scaled(&-BigRational::one()) } else { tangent.clone() };
        let set = |half_turn: &str, minus: &str, function: String| {
            // An arctangent lies within 90° of 0°; the opposite direction is half a turn from it.
            let before = match (opposite, negative) {
                (false, false) => String::new(),
                (false, true) => minus.to_owned(),
                (true, true) => format!("{half_turn} {minus} "),
                (true, false) => format!("{minus}{half_turn} + "),
            };
            format!("{before}{function}")
        };
        Some([set("180^\\circ", "-", format!("\\arctan({})", size.tex())), set("180°", "−", format!("arctan({size})"))])
    }

    /// The degrees: exact where they are rational, else decimals.
    pub(crate) fn degrees(&self) -> String {
        match &self.exact {
            Some(Direction::Turn(turn)) => degrees(&signed_degrees(turn)),
            Some(Direction::Arctangent { .. } | Direction::Turned { .. }) | None => {
                format!("{}°", approximate(self.decimal))
            }
        }
    }
}

/// `16.5° + arctan(…)` in TeX and as plain text.
fn turned(by: &Turn, tangent: &Form) -> [String; 2] {
    let before = degrees(&signed_degrees(by));
    let (size, sign) = match tangent.to_float() < 0.0 {
        true => (tangent.scaled(&-BigRational::one()), ["-", "−"]),
        false => (tangent.clone(), ["+", "+"]),
    };
    let in_tex = before.replace('°', "^\\circ").replace('−', "-");
    [format!("{in_tex} {} \\arctan({})", sign[0], size.tex()), format!("{before} {} arctan({size})", sign[1])]
}
