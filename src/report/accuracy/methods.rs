//! How are methods, their errors and their times told?

use std::time::Duration;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::super::calculation;
use crate::accuracy::{self, Method, Row, Study};
use crate::engine::Engine;
use crate::loads;
pub(super) use crate::page::number::power_of_ten;
use crate::page::{Piece, Setting, Text, Unit, phrase};
use crate::proof::Quantity;

/// What a load is counted in, and how many of it are one multiple.
pub(in crate::report) fn unit(engine: &Engine, quantity: Quantity) -> (Unit, f64) {
    // At rest every peak is 0, and only its multiple tells the methods apart.
    let moving = loads::scale(engine).filter(|scale| !scale.is_at_rest());
    let calculation::Unit { unit, factor } = calculation::Unit::at(engine, moving.as_ref(), quantity);
    (unit, factor)
}

/// The methods of a study that are worth their time, by what they guarantee or, where they do not, by their error.
pub(in crate::report) fn front(study: &Study) -> Vec<usize> {
    let cost = |row: &Row| (row.time.map_or(f64::NAN, |time| time.as_secs_f64()), shown_error(study, row));
    accuracy::front(&study.rows.iter().map(cost).collect::<Vec<_>>())
}

/// What a plot shows of a method: its bound where it is certain of the whole, else its error, no less than roundings.
pub(super) fn shown_error(study: &Study, row: &Row) -> f64 {
    match row.method {
        Method::Intervals(_) | Method::Fractions => row.bound.unwrap_or(row.error),
        Method::Orders(_) | Method::Doubles(_) => row.error.max(study.rounding),
    }
}

/// The name of a method.
pub(super) fn name(method: Method) -> Text {
    match method {
        Method::Orders(order) => phrase!("orders up to {}", order),
        Method::Doubles(steps) => phrase!("closed form, {} angles, 64 bits", steps),
        Method::Intervals(digits) => phrase!("intervals to {}", power_of_ten(-i64::from(digits))),
        Method::Fractions => "intervals of fractions".into(),
    }
}

/// The same with the number of spans that intervals looked at.
pub(super) fn name_and_spans(row: &Row) -> Text {
    match (row.method, row.looked_at) {
        (Method::Intervals(_), Some(count)) => phrase!("{}, {} spans", name(row.method), count),
        (Method::Intervals(_) | Method::Orders(_) | Method::Doubles(_) | Method::Fractions, _) => name(row.method),
    }
}

/// A measured error in two digits; below the roundings of doubles only that it is below them.
pub(super) fn measured(study: &Study, row: &Row) -> Text {
    match row.method {
        Method::Fractions => Text::default(),
        Method::Orders(_) | Method::Doubles(_) | Method::Intervals(_) => match row.error {
            _ if study.is_below_reference(row) => "below the reference's own error".into(),
            _ if study.rounding.is_infinite() => "not known".into(),
            error if error < study.rounding => {
                phrase!("below {}", power_of_ten(study.rounding.log10().round() as i64))
            }
            error => power(error).into(),
        },
    }
}

/// A bound in two digits; one of the fractions only as a power of ten, for their last digits follow the start of a search.
pub(super) fn guaranteed(row: &Row) -> Text {
    match (row.method, row.bound) {
        (_, None) => Text::default(),
        (Method::Fractions, Some(bound)) if bound > 0.0 => {
            phrase!("below {}", power_of_ten(bound.log10().ceil() as i64))
        }
        (_, Some(bound)) => power(bound).into(),
    }
}

/// The part of a peak that a designer may want to be sure of.
pub(super) const USUAL: f64 = 1e-3;

/// The fewest orders that have the peak within a thousandth, guaranteed.
pub(super) fn orders_for_a_thousandth(study: &Study) -> Option<u32> {
    study.rows.iter().find_map(|row| match row.method {
        Method::Orders(order) => row.bound.filter(|bound| *bound <= USUAL).map(|_| order),
        Method::Doubles(_) | Method::Intervals(_) | Method::Fractions => None,
    })
}

/// The fastest method that has the peak within a thousandth, where times were measured.
pub(super) fn fastest_within_a_thousandth(study: &Study) -> Option<(&Row, Duration)> {
    let near = study.rows.iter().filter(|row| shown_error(study, row) <= USUAL);
    near.filter_map(|row| Some((row, row.time?))).min_by_key(|(_, time)| *time)
}

/// Two digits: `0.41`, `4.1·10⁻⁴`.
pub(super) fn power(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { "∞".to_owned() };
    }
    let text = format!("{value:.1e}");
    let Some((digits, exponent)) = text.split_once('e') else { return text };
    match exponent.parse::<i64>() {
        Ok(0) => digits.to_owned(),
        Ok(-1) => format!("{value:.2}"),
        Ok(-2) => format!("{value:.3}"),
        Ok(power) => format!("{digits}·{}", power_of_ten(power)),
        Err(_) => text,
    }
}

/// Decimal places of the ends of a peak.
const PLACES: u32 = 40;

/// Decimal places of a peak that are told.
pub(super) const CUT: usize = 20;

/// A number that is not negative with forty places, rounded down or up.
pub(in crate::report) fn decimals(number: &BigRational, up: bool) -> String {
    let scaled = number * BigRational::from_integer(num_bigint::BigInt::from(10).pow(PLACES));
    let whole = if up { scaled.ceil() } else { scaled.floor() };
    let digits = format!("{:0>width$}", whole.to_integer().to_string(), width = PLACES as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - PLACES as usize);
    format!("{whole}.{fraction}")
}

/// The digits that both ends of a peak share, at most [`CUT`] places; none where they share none behind the point.
pub(super) fn sure_digits(study: &Study) -> Option<String> {
    let ends = [decimals(&study.peak.low, false), decimals(&study.peak.high, true)];
    let [low, high] = &ends;
    let shared = low.bytes().zip(high.bytes()).take_while(|(one, other)| one == other).count();
    let point = low.find('.')?;
    (shared > point + 1).then(|| low[..shared.min(point + 1 + CUT)].to_owned())
}

/// The number of [`CUT`] places that both ends of a peak round to, and a power of ten that they are nearer to it than; none where they
/// are further apart. Ends on both sides of 1.25 share only the digits 1.2.
pub(super) fn rounded(study: &Study) -> Option<(String, i64)> {
    let (low, high) = (&study.peak.low, &study.peak.high);
    let ten = BigRational::from_integer(num_bigint::BigInt::from(10));
    let near = ((low + high) / BigRational::from_integer(2.into()) * ten.pow(CUT as i32)).round() / ten.pow(CUT as i32);
    let distance = (high - &near).max(&near - low).to_f64()?;
    let power = distance.log10().floor() as i64 + 1;
    let digits = decimals(&near, false);
    (distance > 0.0 && power <= -(CUT as i64))
        .then(|| (digits.trim_end_matches('0').trim_end_matches('.').to_owned(), power))
}

/// `1.23 µs`.
pub(super) fn time(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        _ if seconds < 1e-6 => format!("{:.0} ns", seconds * 1e9),
        _ if seconds < 1e-3 => format!("{:.3} µs", Significant(seconds * 1e6)),
        _ if seconds < 1.0 => format!("{:.3} ms", Significant(seconds * 1e3)),
        _ => format!("{:.3} s", Significant(seconds)),
    }
}

/// A load in a table of methods, to nine digits: where they differ is what is compared.
pub(super) fn to_nine_digits(value: f64, unit: Unit) -> Text {
    Piece::Measured(value, unit, Setting::Fixed(|value| significant(value, 9))).into()
}

/// A load to six digits.
pub(super) fn to_digits(value: f64, unit: Unit) -> Text {
    Piece::Measured(value, unit, Setting::Fixed(|value| significant(value, 6))).into()
}

fn significant(value: f64, digits: usize) -> String {
    let text = format!("{:.digits$}", Significant(value));
    let power = text.split_once('e').and_then(|(digits, power)| Some((digits, power.parse().ok()?)));
    power.map_or(text.clone(), |(digits, power)| format!("{digits}·{}", power_of_ten(power))).replace('-', "−")
}

/// A decimal with as many significant digits as its precision asks for.
pub(super) struct Significant(pub f64);

impl std::fmt::Display for Significant {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digits = f.precision().unwrap_or(6) as i32;
        if !self.0.is_finite() {
            return f.write_str("(overflow)");
        }
        if self.0 == 0.0 {
            return f.write_str("0");
        }
        let power = self.0.abs().log10().floor() as i32;
        if !(-6..12).contains(&power) {
            return write!(f, "{:.*e}", (digits - 1).max(0) as usize, self.0);
        }
        write!(f, "{:.*}", (digits - 1 - power).max(0) as usize, self.0)
    }
}
