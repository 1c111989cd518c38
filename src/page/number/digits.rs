//! With which digits is a number written?

use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::exact::{Turn, fraction};
use crate::numbers::float;
use crate::table::Unit;
use crate::text::SUPERSCRIPTS;

/// More decimal places than this make a fraction easier to read.
const MOST_PLACES: usize = 6;
/// Beside a long fraction that many do not.
const MOST_PLACES_OF_LONG: usize = 9;
/// Longer exact numbers than this are shown in decimals, after `≈`; the JSON document holds them exactly.
const MOST_LETTERS: usize = 20;
/// The longest fraction that is shown as one.
const LONGEST_FRACTION: usize = 7;

/// The digits of a count in threes, `1 682 445`: narrow spaces that do not break, which no language takes for a decimal sign.
pub(crate) fn grouped(digits: &str) -> String {
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join("\u{202f}")
}

/// An exact number: an integer, a short decimal, or a fraction; `−` for minus.
pub(crate) fn number(value: &BigRational) -> String {
    if is_rounded(value) {
        return approximate(float(value));
    }
    let fraction = exact_text(value);
    let is_short = !fraction.contains('/') || fraction.len() <= LONGEST_FRACTION;
    let text = if is_short { fraction } else { decimals(value, MOST_PLACES_OF_LONG).unwrap_or(fraction) };
    if value.is_negative() { format!("−{text}") } else { text }
}

/// An exact number in little room: decimals after ≈ where it is long.
pub(crate) fn short(value: &BigRational) -> String {
    if is_long(value) { approximate(float(value)) } else { number(value) }
}

/// An exact number that was converted: its decimals, after ≈ where they do not end soon.
pub(crate) fn in_decimals(value: &BigRational) -> String {
    match terminating(value) {
        Some(_) => number(value),
        None => approximate(float(value)),
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
    decimals(value, MOST_PLACES)
}

fn decimals(value: &BigRational, most: usize) -> Option<String> {
    // It ends after this many places where its denominator divides that power of ten.
    let denominator = value.denom().to_u64()?;
    let powers = std::iter::successors(Some(1_u64), |power| Some(10 * power));
    let (places, power) = (0..=most).zip(powers).find(|(_, power)| power.is_multiple_of(denominator))?;
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
    if !text.contains('/') {
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
    pub(in crate::page) fn set(self, value: f64, usual: fn(f64) -> String) -> String {
        self.0.map_or_else(|| usual(value), |count| figures(value, count))
    }

    /// A decimal after its sign.
    pub(in crate::page) fn approximate(self, value: f64) -> String {
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
        _ => to_places(value, &[999.95, 99.995, 9.9995, 0.99995]),
    };
    text.replace('-', "−")
}

/// With as many places as there are limits above its size.
fn to_places(value: f64, limits: &[f64]) -> String {
    let places = limits.iter().filter(|limit| value.abs() < **limit).count();
    format!("{value:.places$}")
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
    let text = match value.abs() {
        0.0 => format!("{value:.3}"),
        size if !(1e-3..1e7).contains(&size) => scientific(value, 2),
        _ => to_places(value, &[99.95, 9.995, 0.9995, 0.09995, 0.009995]),
    };
    text.replace('-', "−")
}

/// The least number of so many figures that is not below a positive one.
pub(crate) fn raised_to(value: f64, figures: usize) -> f64 {
    let places = figures.saturating_sub(1);
    let text = format!("{value:.places$e}");
    let near = text.parse().unwrap_or(value);
    let next = text.split_once('e').and_then(|(digits, power)| {
        let digits: u64 = digits.replace('.', "").parse().ok()?;
        let power: i64 = power.parse().ok()?;
        format!("{}e{}", digits + 1, power - places as i64).parse().ok()
    });
    if near >= value { near } else { next.unwrap_or(value) }
}

/// A bound to sensible figures, which is never rounded down.
pub(crate) fn at_most(value: f64) -> String {
    sensible(raised_to(value, 3))
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
    format!("10{}", raised(power))
}

/// A number as an exponent: `⁻⁴`.
pub(crate) fn raised(power: i64) -> String {
    let sign = |sign: char| sign.to_digit(10).map_or('⁻', |digit| SUPERSCRIPTS[digit as usize]);
    power.to_string().chars().map(sign).collect()
}

/// A unit behind its number.
pub(crate) fn behind(unit: Unit) -> String {
    if unit == Unit::DEGREE { unit.name.to_owned() } else { format!("\u{202f}{}", unit.name) }
}

/// Items in a row: `1, 2, 4`.
pub(crate) fn listed<I: IntoIterator<Item: fmt::Display>>(items: I) -> String {
    items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>().join(", ")
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
    listed(runs.iter().map(run))
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
