//! How are methods, their errors and their times told?

use std::time::Duration;

use num_rational::BigRational;

use super::loads_document::units;
use super::typeset;
use crate::accuracy::{self, Method, Row, Study};
use crate::engine::Engine;
use crate::loads;
use crate::proof::Quantity;
use crate::text::SUPERSCRIPTS;

/// An engine at one rod ratio, with its loads by all methods.
#[derive(Clone, Debug)]
pub struct AccuracyCase {
    /// The rod ratio λ; none where the rods differ.
    pub ratio: Option<BigRational>,
    /// Its loads.
    pub studies: Vec<Study>,
}

impl AccuracyCase {
    /// The loads of a layout by all methods: force, moment, torque.
    ///
    /// # Errors
    /// What the layout lacks for numbers.
    pub fn of(engine: &Engine, quantities: &[Quantity], timing: accuracy::Timing) -> Result<Self, loads::Missing> {
        let studies = quantities.iter().map(|quantity| accuracy::study(engine, *quantity, timing));
        let mut rods = engine.rods().map(|rod| &rod.ratio);
        let first = rods.next().cloned();
        let ratio = first.filter(|first| rods.all(|ratio| ratio == first));
        Ok(AccuracyCase { ratio, studies: studies.collect::<Result<_, _>>()? })
    }

    /// `λ = 0.3`.
    pub(super) fn label(&self) -> String {
        let Some(ratio) = &self.ratio else { return "each its own λ".to_owned() };
        let number = typeset::number(ratio);
        if number.starts_with('≈') { format!("λ {number}") } else { format!("λ = {number}") }
    }
}

/// A row a method: what it finds in newtons or multiples, its errors, its cost, and whether it is on the Pareto front.
pub fn accuracy_rows(engine: &Engine, study: &Study) -> Vec<[String; 6]> {
    let (unit, factor) = unit(engine, study.quantity);
    let front = front(study);
    let row = |(place, row): (usize, &Row)| {
        let spans = row.looked_at.filter(|_| matches!(row.method, Method::Intervals(_)));
        let spans = spans.map_or_else(String::new, |count| format!(", {count} spans"));
        [
            format!("{}{spans}", method(row.method)),
            format!("{:.9} {unit}", Significant(row.value * factor)),
            measured(study, row),
            row.bound.map_or_else(String::new, power),
            row.time.map_or_else(String::new, time),
            if front.contains(&place) { "●".to_owned() } else { String::new() },
        ]
    };
    study.rows.iter().enumerate().map(row).collect()
}

/// Headings of those rows.
pub const HEADER: [&str; 6] = ["Method", "Peak", "Error", "Guaranteed", "Time", "Front"];

/// Unit of a load, and how many of it are one multiple.
pub(super) fn unit(engine: &Engine, quantity: Quantity) -> (&'static str, f64) {
    let scale = loads::scale(engine);
    let units = units(engine, scale.as_ref());
    let factor = |of: fn(&loads::Scale) -> f64| scale.as_ref().map_or(1.0, of);
    match quantity {
        Quantity::Force => (units.force, factor(loads::Scale::force)),
        Quantity::Moment => (units.moment, factor(loads::Scale::force)),
        Quantity::Torque => (units.torque, factor(loads::Scale::torque)),
    }
}

/// The methods of a study that are worth their time, by what they guarantee or, where they do not, by their error.
pub(super) fn front(study: &Study) -> Vec<usize> {
    let cost = |row: &Row| (row.time.map_or(f64::NAN, |time| time.as_secs_f64()), shown_error(study, row));
    accuracy::front(&study.rows.iter().map(cost).collect::<Vec<_>>())
}

/// What a plot shows of a method: its bound where it is certain of the whole, else its error, no less than roundings.
pub(super) fn shown_error(study: &Study, row: &Row) -> f64 {
    match row.method {
        Method::Intervals(_) | Method::Fractions => row.bound.unwrap_or(row.error),
        Method::Orders(_) | Method::Doubles(_) => row.error.max(study.rounding),
        Method::Singles(_) => row.error.max(study.doubt),
    }
}

/// The name of a method.
pub(super) fn method(method: Method) -> String {
    match method {
        Method::Orders(order) => format!("orders up to {order}"),
        Method::Doubles(steps) => format!("closed form, {steps} angles, 64 bits"),
        Method::Singles(steps) => format!("closed form, {steps} angles, 32 bits"),
        Method::Intervals(digits) => format!("intervals to {}", power_of_ten(-i64::from(digits))),
        Method::Fractions => "intervals of fractions".to_owned(),
    }
}

/// The name of a load.
pub(super) fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Force => "force",
        Quantity::Moment => "moment",
        Quantity::Torque => "inertia torque",
    }
}

/// A measured error in two digits; below the roundings of doubles only that it is below them.
pub(super) fn measured(study: &Study, row: &Row) -> String {
    match row.method {
        Method::Fractions => String::new(),
        _ if study.is_below_reference(row) => "below the reference's own error".to_owned(),
        Method::Singles(_) => power(row.error),
        _ if study.rounding.is_infinite() => "not known".to_owned(),
        _ if row.error < study.rounding => format!("below {}", power_of_ten(study.rounding.log10().round() as i64)),
        _ => power(row.error),
    }
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

/// `10⁻⁴`.
pub(super) fn power_of_ten(power: i64) -> String {
    let digits = power.unsigned_abs().to_string();
    let digits = digits.bytes().filter_map(|digit| SUPERSCRIPTS.get(usize::from(digit.wrapping_sub(b'0'))));
    let minus = if power < 0 { "⁻" } else { "" };
    format!("10{minus}{}", digits.collect::<String>())
}

/// Decimal places of the ends of a peak.
const PLACES: u32 = 40;

/// A number that is not negative with forty places, rounded down or up.
pub(super) fn decimals(number: &BigRational, up: bool) -> String {
    let scaled = number * BigRational::from_integer(num_bigint::BigInt::from(10).pow(PLACES));
    let whole = if up { scaled.ceil() } else { scaled.floor() };
    let digits = format!("{:0>width$}", whole.to_integer().to_string(), width = PLACES as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - PLACES as usize);
    format!("{whole}.{fraction}")
}

/// The digits that both ends of a peak share, at most twenty places; none where they share none behind the point.
pub(super) fn sure_digits(study: &Study) -> Option<String> {
    let ends = [decimals(&study.peak.low, false), decimals(&study.peak.high, true)];
    let [low, high] = &ends;
    let shared = low.bytes().zip(high.bytes()).take_while(|(one, other)| one == other).count();
    let point = low.find('.')?;
    (shared > point + 1).then(|| low[..shared.min(point + 21)].to_owned())
}

fn time(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        _ if seconds < 1e-6 => format!("{:.0} ns", seconds * 1e9),
        _ if seconds < 1e-3 => format!("{:.3} µs", Significant(seconds * 1e6)),
        _ if seconds < 1.0 => format!("{:.3} ms", Significant(seconds * 1e3)),
        _ => format!("{:.3} s", Significant(seconds)),
    }
}

/// A decimal with as many significant digits as its precision asks for.
struct Significant(f64);

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
