//! How do numbers become text? In one place: exact ones after `=`, decimals after `≈`.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::exact::Turn;

/// More decimal places than this make a fraction easier to read.
const MOST_PLACES: usize = 4;
/// Longer exact numbers than this are shown in decimals, after `≈`; the JSON document holds them exactly.
const MOST_LETTERS: usize = 20;

/// An exact number: an integer, a short decimal, or a fraction; `−` for minus.
pub(super) fn number(value: &BigRational) -> String {
    let text = terminating(value).unwrap_or_else(|| value.abs().to_string());
    if text.len() > MOST_LETTERS {
        return format!("≈ {}", decimal(value.to_f64().unwrap_or(f64::NAN)));
    }
    if value.is_negative() { format!("−{text}") } else { text }
}

/// The decimal form of a modulus, where it ends after a few places.
fn terminating(value: &BigRational) -> Option<String> {
    let value = value.abs();
    let ten = BigRational::from_integer(10.into());
    let mut scaled = value.clone();
    let places = (0..=MOST_PLACES).find(|_| {
        let whole = scaled.is_integer();
        if !whole {
            scaled = &scaled * &ten;
        }
        whole
    })?;
    let digits = format!("{:0>width$}", scaled.to_integer().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Some(if fraction.is_empty() { whole.to_owned() } else { format!("{whole}.{fraction}") })
}

/// An exact number of degrees: `22.5°`, `(360/7)°`.
pub(super) fn degrees(value: &BigRational) -> String {
    let text = number(value);
    if !text.contains('/') || text.starts_with('≈') {
        return format!("{text}°");
    }
    let modulus = value.abs();
    format!("{}({modulus})°", if value.is_negative() { "−" } else { "" })
}

/// A direction in `[0°, 360°)`.
pub(super) fn angle(turn: &Turn) -> String {
    degrees(&turn.degrees())
}

/// A direction in `(−180°, 180°]`, as bank angles are spoken of.
pub(super) fn signed_degrees(turn: &Turn) -> BigRational {
    let degrees = turn.degrees();
    let full = BigRational::from_integer(360.into());
    if &degrees * BigRational::from_integer(2.into()) > full { degrees - full } else { degrees }
}

/// A decimal of four places, or of four digits where it is small.
pub(super) fn decimal(value: f64) -> String {
    let text = match value.abs() {
        size if size != 0.0 && !(0.01..1e9).contains(&size) => format!("{value:.3e}"),
        _ => format!("{value:.4}"),
    };
    text.replace('-', "−")
}

/// A length of a vector or a half-sum of two: exact where it is rational, else in decimals.
pub(super) enum Amount {
    /// The number itself.
    Exact(BigRational),
    /// Its decimals.
    Approximate(f64),
}

impl Amount {
    /// `= 4` or `≈ 3.1623`.
    pub fn related(&self) -> String {
        match self {
            Amount::Exact(value) => format!("= {}", number(value)),
            Amount::Approximate(value) => format!("≈ {}", decimal(*value)),
        }
    }

    /// Half the sum of two amounts.
    pub fn mean(&self, other: &Amount) -> Amount {
        match (self, other) {
            (Amount::Exact(a), Amount::Exact(b)) => Amount::Exact((a + b) / BigRational::from_integer(2.into())),
            _ => Amount::Approximate((self.to_float() + other.to_float()) / 2.0),
        }
    }

    /// The amount in decimals.
    pub fn to_float(&self) -> f64 {
        match self {
            Amount::Exact(value) => value.to_f64().unwrap_or(f64::NAN),
            Amount::Approximate(value) => *value,
        }
    }
}

/// Names in a row, runs of three and more numbers drawn together: `1, 4–7`.
pub(super) fn names(names: &[&str]) -> String {
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
pub(super) fn multiple(factor: i64, degrees_value: &BigRational) -> Option<(bool, String)> {
    let product_sign = degrees_value * BigRational::from_integer(factor.into());
    if factor.is_zero() || degrees_value.is_zero() {
        return None;
    }
    let modulus = degrees(&degrees_value.abs());
    let text = if factor.abs().is_one() { modulus } else { format!("{}·{modulus}", factor.abs()) };
    Some((product_sign.is_negative(), text))
}

/// The kinds of regular polygon that proofs speak of.
pub(super) fn polygon_name(sides: u64) -> String {
    match sides {
        2 => "an opposed pair".to_owned(),
        3 => "a regular triangle".to_owned(),
        5 => "a regular pentagon".to_owned(),
        7 => "a regular heptagon".to_owned(),
        _ => format!("a regular {sides}-gon"),
    }
}
