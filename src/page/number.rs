//! How do numbers become text? In one place: exact ones bare, decimals after `≈`, what has a unit to sensible figures.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::exact::{Turn, fraction};
use crate::numbers::{self, Direction, Form};
use crate::text::SUPERSCRIPTS;

/// More decimal places than this make a fraction easier to read.
const MOST_PLACES: usize = 6;
const POWERS_OF_TEN: [u64; MOST_PLACES + 1] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000];
/// Longer exact numbers than this are shown in decimals, after `≈`; the JSON document holds them exactly.
const MOST_LETTERS: usize = 20;
/// The longest fraction that is shown as one.
const LONGEST_FRACTION: usize = 7;
/// Longer closed forms than this tell a reader nothing; their decimals do.
const LONGEST_FORM: usize = 48;
/// Digits of the longest number in a closed form that is shown.
const MOST_DIGITS: usize = 4;

/// The digits of a count in threes, `1 682 445`: narrow spaces that do not break, which no language takes for a decimal sign.
pub(crate) fn grouped(digits: &str) -> String {
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join("\u{202f}")
}

/// An exact number: an integer, a short decimal, or a fraction; `−` for minus.
pub(crate) fn number(value: &BigRational) -> String {
    if is_rounded(value) {
        return approximate(value.to_f64().unwrap_or(f64::NAN));
    }
    let text = exact_text(value);
    if value.is_negative() { format!("−{text}") } else { text }
}

/// An exact number in little room: decimals after ≈ where it is long.
pub(crate) fn short(value: &BigRational) -> String {
    if is_long(value) { approximate(value.to_f64().unwrap_or(f64::NAN)) } else { number(value) }
}

/// An exact number that was converted: its decimals, after ≈ where they do not end soon.
pub(crate) fn in_decimals(value: &BigRational) -> String {
    match terminating(value) {
        Some(_) => number(value),
        None => approximate(value.to_f64().unwrap_or(f64::NAN)),
    }
}

/// Whether an exact number is shown in decimals, for it is too long.
pub(crate) fn is_rounded(value: &BigRational) -> bool {
    exact_text(value).len() > MOST_LETTERS
}

/// The modulus, exactly.
fn exact_text(value: &BigRational) -> String {
    terminating(value).unwrap_or_else(|| value.abs().to_string())
}

/// Whether an exact number is too long to be read: a fraction of large numbers tells less than its decimals.
pub(crate) fn is_long(value: &BigRational) -> bool {
    let text = exact_text(value);
    text.len() > if text.contains('/') { LONGEST_FRACTION } else { MOST_LETTERS }
}

/// The decimal form of a modulus, where it ends after a few places.
fn terminating(value: &BigRational) -> Option<String> {
    // It ends after this many places where its denominator divides that power of ten.
    let denominator = value.denom().to_u64()?;
    let (places, power) = (0..=MOST_PLACES).zip(POWERS_OF_TEN).find(|(_, power)| power.is_multiple_of(denominator))?;
    let scaled = value.numer().magnitude() * (power / denominator);
    let digits = format!("{:0>width$}", scaled.to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Some(if fraction.is_empty() { whole.to_owned() } else { format!("{whole}.{fraction}") })
}

/// Whether an exact number is shown as a whole number or a decimal, and not as a fraction.
pub(crate) fn terminates(value: &BigRational) -> bool {
    is_rounded(value) || terminating(value).is_some()
}

/// An exact number of degrees: `22.5°`, `(360/7)°`.
pub fn degrees(value: &BigRational) -> String {
    let text = number(value);
    if terminates(value) {
        return format!("{text}°");
    }
    let modulus = value.abs();
    format!("{}({modulus})°", if value.is_negative() { "−" } else { "" })
}

/// A number of turns in degrees, not reduced: a firing interval of `720°`.
pub fn turns(value: &BigRational) -> String {
    degrees(&fraction::times(value, &BigRational::from_integer(360.into())))
}

/// The same where nobody counts with it: `≈ 102.9°` for (720/7)°.
pub(crate) fn turns_in_decimals(value: &BigRational) -> String {
    format!("{}°", in_decimals(&fraction::times(value, &BigRational::from_integer(360.into()))))
}

/// A direction in `[0°, 360°)`.
pub(crate) fn angle(turn: &Turn) -> String {
    degrees(&turn.degrees())
}

/// A direction in `(−180°, 180°]`, as bank angles are spoken of.
pub(crate) fn signed_degrees(turn: &Turn) -> BigRational {
    let degrees = turn.degrees();
    match *turn > Turn::fraction(1, 2) {
        true => fraction::minus(&degrees, &BigRational::from_integer(360.into())),
        false => degrees,
    }
}

/// How many figures a decimal has: those that are usual at its place, or as many as a reader asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Figures(Option<usize>);

impl Figures {
    /// More than these are not certain where a decimal is computed in floats.
    pub const MOST: usize = 12;

    /// This many, from 1 to [`Figures::MOST`].
    pub fn new(count: usize) -> Self {
        Figures(Some(count.clamp(1, Figures::MOST)))
    }

    /// A decimal; where nothing is asked for as is usual there.
    pub(super) fn set(self, value: f64, usual: fn(f64) -> String) -> String {
        self.0.map_or_else(|| usual(value), |count| figures(value, count))
    }

    /// A decimal after its sign.
    pub(super) fn approximate(self, value: f64) -> String {
        format!("≈\u{a0}{}", self.set(value, decimal))
    }
}

/// This many figures, without zeros that say nothing; a whole number keeps all of its own.
fn figures(value: f64, count: usize) -> String {
    let places = count.saturating_sub(1);
    let power = format!("{value:.places$e}").split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0_i32);
    let text = match power {
        -4..7 => format!("{value:.*}", usize::try_from(places as i32 - power).unwrap_or(0)),
        _ => scientific(value, places),
    };
    let (digits, power) = text.split_once('·').map_or((text.as_str(), None), |(digits, power)| (digits, Some(power)));
    let digits = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    let digits = if digits == "-0" { "0" } else { digits };
    power.map_or_else(|| digits.to_owned(), |power| format!("{digits}·{power}")).replace('-', "−")
}

/// A decimal of four digits; whole numbers whole.
pub(crate) fn decimal(value: f64) -> String {
    let text = match value.abs() {
        0.0 => "0".to_owned(),
        size if !(0.01..1e9).contains(&size) => scientific(value, 3),
        size if size >= 999.95 => format!("{value:.0}"),
        size if size >= 99.995 => format!("{value:.1}"),
        size if size >= 9.9995 => format!("{value:.2}"),
        size if size >= 0.99995 => format!("{value:.3}"),
        _ => format!("{value:.4}"),
    };
    text.replace('-', "−")
}

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
            long if is_long(long) => Number::Decimal(long.to_f64().unwrap_or(f64::NAN)),
            short => Number::Exact(short.clone()),
        }
    }
}

/// An exact number that is given, not found: its zero is no verdict, and stands as any other number does.
pub(crate) fn given(value: &BigRational) -> super::Text {
    match Number::exact(value) {
        Number::Zero => Number::Exact(value.clone()).into(),
        other @ (Number::Exact(_) | Number::Closed(..) | Number::Decimal(_)) => other.into(),
    }
}

/// The same in this unit, which is given elsewhere.
pub(crate) fn given_in(value: &BigRational, unit: super::Unit) -> super::Text {
    super::Piece::Shortly(value.clone(), unit).into()
}

/// The same with the unit behind it.
pub(crate) fn given_with(value: &BigRational, unit: super::Unit) -> super::Text {
    super::text::phrase!("{} {}", given_in(value, unit), unit)
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

    /// Half the sum of two amounts.
    pub fn mean(&self, other: &Amount) -> Amount {
        let half = BigRational::new(1.into(), 2.into());
        let exact =
            self.exact.as_ref().zip(other.exact.as_ref()).map(|(a, b)| numbers::plainer(a.plus(b).scaled(&half)));
        Amount { exact, decimal: (self.decimal + other.decimal) / 2.0 }
    }

    /// Plain text: `4`, `√10 ≈ 3.162`, `≈ 0.1234`.
    pub fn plain(&self) -> String {
        super::Text::from(self.clone()).plain()
    }

    /// Prose with a formula: `$\\sqrt{10}$ ≈ 3.162`.
    pub fn prose(&self) -> String {
        match self.number() {
            Number::Closed(form, decimal) => format!("${}$ {}", form.tex(), approximate(decimal)),
            _ => self.plain(),
        }
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

    /// Plain text: `−arctan(1/3) ≈ −18.43°`.
    pub fn plain(&self) -> String {
        super::Text::from(self.clone()).plain()
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

/// A decimal after its sign.
pub(crate) fn approximate(value: f64) -> String {
    format!("≈\u{a0}{}", decimal(value))
}

/// A number as an index: `₂`.
pub(crate) fn lowered(number: u32) -> String {
    number.to_string().chars().filter_map(|digit| char::from_u32(0x2080 + digit.to_digit(10)?)).collect()
}

/// A decimal to sensible figures: `9862`, `715`, `71.5`, `7.15`, `0.715`, `0.0715`.
pub fn sensible(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        _ if size != 0.0 && !(1e-3..1e7).contains(&size) => scientific(value, 2),
        _ if size >= 99.95 => format!("{value:.0}"),
        _ if size >= 9.995 => format!("{value:.1}"),
        _ if size >= 0.9995 => format!("{value:.2}"),
        _ if size >= 0.09995 => format!("{value:.3}"),
        _ if size >= 0.009995 => format!("{value:.4}"),
        _ if size != 0.0 => format!("{value:.5}"),
        _ => format!("{value:.3}"),
    };
    text.replace('-', "−")
}

/// The same in letters that other programs read: `-4.13e-4`.
pub(crate) fn in_ascii(number: &str) -> String {
    let letter = |letter: char| match letter {
        '−' | '⁻' => '-',
        letter => SUPERSCRIPTS.iter().position(|sign| *sign == letter).map_or(letter, digit),
    };
    number.replace("·10", "e").chars().map(letter).collect()
}

fn digit(value: usize) -> char {
    char::from_digit(value as u32, 10).unwrap_or('0')
}

/// This many places and a power of ten: `4.13·10⁻⁴`.
fn scientific(value: f64, places: usize) -> String {
    let text = format!("{value:.places$e}");
    match text.split_once('e').and_then(|(digits, power)| Some((digits, power.parse().ok()?))) {
        Some((digits, power)) => format!("{digits}·{}", power_of_ten(power)),
        // Nothing finite.
        None => text,
    }
}

/// `10⁻⁴`.
pub(crate) fn power_of_ten(power: i64) -> String {
    let digits = power.unsigned_abs().to_string();
    let digits = digits.bytes().filter_map(|digit| SUPERSCRIPTS.get(usize::from(digit.wrapping_sub(b'0'))));
    let minus = if power < 0 { "⁻" } else { "" };
    format!("10{minus}{}", digits.collect::<String>())
}

/// A unit behind its number.
pub(crate) fn behind(unit: super::Unit) -> String {
    match unit == super::Unit::DEGREE {
        true => unit.name.to_owned(),
        false => format!("\u{202f}{}", unit.name),
    }
}

/// Names in a row, runs of three and more numbers drawn together: `1, 4–7`.
pub(crate) fn names(names: &[&str]) -> String {
    let numbers: Option<Vec<u32>> = names.iter().map(|name| name.parse().ok()).collect();
    let Some(mut numbers) = numbers else { return names.join(", ") };
    numbers.sort_unstable();
    let mut runs: Vec<(u32, u32)> = Vec::new();
    for number in numbers {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => runs.push((number, number)),
        }
    }
    let run = |&(first, last): &(u32, u32)| match last - first {
        0 => first.to_string(),
        1 => format!("{first}, {last}"),
        _ => format!("{first}–{last}"),
    };
    runs.iter().map(run).collect::<Vec<_>>().join(", ")
}

/// A multiple of an angle as it is worked out by hand: `2·270°`, nothing for a factor of 0.
pub(crate) fn multiple(factor: i64, degrees_value: &BigRational) -> Option<(bool, String)> {
    if factor.is_zero() || degrees_value.is_zero() {
        return None;
    }
    let modulus = degrees(&degrees_value.abs());
    let text = if factor.abs().is_one() { modulus } else { format!("{}·{modulus}", factor.abs()) };
    Some((factor.is_negative() != degrees_value.is_negative(), text))
}
