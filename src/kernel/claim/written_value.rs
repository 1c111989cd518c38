//! Which number or direction is claimed, and how near does it have to be?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::error::ClaimError;
use super::formula::half_of_place;
use super::statement::{Angle, Bearing, Tolerance, Unit, Value};
use crate::file::{NumberError, parse_number, units};
use crate::numbers::Form;
use crate::proof::Quantity;

/// Units with the quantity that is counted in them, longest first, and their size in newtons or newton-metres.
const UNITS: [(&str, Unit, i32); 8] = [
    ("kN·m", Unit::NewtonMetre, 1000),
    ("kN m", Unit::NewtonMetre, 1000),
    ("kNm", Unit::NewtonMetre, 1000),
    ("N·m", Unit::NewtonMetre, 1),
    ("N m", Unit::NewtonMetre, 1),
    ("Nm", Unit::NewtonMetre, 1),
    ("kN", Unit::Newton, 1000),
    ("N", Unit::Newton, 1),
];

/// `√3`, `0.449 ± 0.001`, `65.18 N·m ± 1 %`, `11 ± 1 kN`: a unit behind the tolerance alone is that of both.
pub(super) fn value(text: &str, about: bool, quantity: Quantity) -> Result<Value, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let (number, of_number) = measured(number);
    let (tolerance, of_tolerance) = tolerance.map(measured).unzip();
    let of_tolerance = of_tolerance.flatten();
    let unit = of_number.or(of_tolerance);
    let right = "a number such as 4, 2√3, √(5 − 2√5), 1.732 or 3·cos(40°), 0 or more";
    let form = Form::parse(number).filter(|form| form.to_float() >= 0.0);
    let form = form.ok_or_else(|| {
        let mistake = format!("cannot read the value `{number}`");
        match parse_number(number) {
            Err(comma @ NumberError::DecimalComma) => ClaimError::new(mistake, comma.to_string()),
            _ => ClaimError::new(mistake, right),
        }
    })?;
    let fits = |unit: Unit| match unit {
        Unit::Newton => quantity == Quantity::FORCE,
        Unit::NewtonMetre | Unit::Spacing => quantity == Quantity::MOMENT,
    };
    if ![of_number, of_tolerance].into_iter().flatten().all(|(unit, _)| fits(unit)) {
        return Err(ClaimError::new(
            "this unit belongs to another quantity",
            "a force has N or kN, a moment N·m or kN·m",
        ));
    }
    let size = |unit: Option<(Unit, i32)>| BigRational::from_integer(unit.map_or(1, |(_, size)| size).into());
    let tolerance = match (tolerance, size_unstated(number, about)) {
        (Some(text), _) => self::tolerance(text)?.times(&size(of_tolerance.or(unit))),
        // A whole number of newtons or kilonewtons is a rounded one; nothing is a rounding of none.
        (None, Tolerance::Exact { rounding: None }) if unit.is_some() && is_whole(&form) => {
            Tolerance::Exact { rounding: Some(half_of_place(0) * size(unit)) }
        }
        (None, unstated) => unstated.times(&size(unit)),
    };
    Ok(Value { form: form.scaled(&size(unit)), tolerance, unit: unit.map(|(unit, _)| unit), is_bare: false })
}

fn is_whole(form: &Form) -> bool {
    form.as_rational().is_some_and(|number| number.is_integer() && !number.is_zero())
}

/// A number without its unit, and the unit.
fn measured(text: &str) -> (&str, Option<(Unit, i32)>) {
    let unit = UNITS.iter().find_map(|(name, unit, size)| Some((text.strip_suffix(name)?, (*unit, *size))));
    unit.map_or((text, None), |(number, unit)| (number.trim_end(), Some(unit)))
}

/// `4.08375 kg`, `4.0837 kg ± 0.0001 kg`.
pub(super) fn kilograms(text: &str, about: bool) -> Result<Value, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let right = "a mass in kilograms, such as 4.08375 kg";
    let mistake = || ClaimError::new(format!("cannot read the mass `{number}`"), right);
    let (plain, tolerance_plain) = (number.strip_suffix("kg"), tolerance.map(|text| text.strip_suffix("kg")));
    // A unit behind the tolerance alone is that of both.
    let number = plain.or(tolerance_plain.flatten().map(|_| number)).ok_or_else(mistake)?.trim_end();
    let mass = parse_number(number).ok().filter(|mass| !mass.is_negative()).ok_or_else(mistake)?;
    let tolerance = match tolerance {
        Some(text) => self::tolerance(text.strip_suffix("kg").unwrap_or(text))?,
        None => size_unstated(number, about),
    };
    Ok(Value { form: Form::rational(mass), tolerance, unit: None, is_bare: false })
}

/// `30°`, `-18.43° ± 0.01°`, `1/12 turn`, `-arctan(1/3)`.
pub(super) fn angle(text: &str) -> Result<Angle, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let right = "an angle such as 30°, 22.5 deg, 1/12 turn or −arctan(1/3)";
    let mistake = || ClaimError::new(format!("cannot read the angle `{number}`"), right);
    let plain = number.replace('−', "-");
    let (sign, positive) = plain.strip_prefix('-').map_or((1, plain.as_str()), |rest| (-1, rest));
    let tangent = positive.trim().strip_prefix("arctan(").and_then(|rest| rest.strip_suffix(')'));
    // A unit behind one of both is that of the other too; the angle of a tangent has none.
    let own = if tangent.is_none() { unit_behind(number) } else { "°" };
    let unit = if own.is_empty() { tolerance.map_or("", unit_behind) } else { own };
    let turns = |text: &str| {
        let unit = if unit_behind(text).is_empty() { unit } else { "" };
        units::angle(&format!("{text} {unit}")).ok()
    };
    let bearing = match tangent {
        Some(tangent) => {
            let form = Form::parse(tangent).ok_or_else(mistake)?;
            Bearing::Arctangent(form.scaled(&BigRational::from_integer(sign.into())))
        }
        None => Bearing::Turns(turns(number).ok_or_else(mistake)?),
    };
    let full = BigRational::from_integer(360.into());
    let tolerance = match tolerance {
        Some(text) => {
            let turns = turns(text).filter(|turns| !turns.is_negative());
            let turns = turns.ok_or_else(|| {
                ClaimError::new(
                    format!("cannot read the tolerance `{text}` of an angle"),
                    "degrees or turns, 0 or more, such as ± 0.01° or ± 0.001 turn",
                )
            })?;
            Tolerance::Within(turns * full)
        }
        None => {
            let digits = number.trim_end_matches(|letter: char| !letter.is_ascii_digit());
            let degrees = units::turns_per_unit(unit).map(|turns| turns * full);
            unstated(digits, false).times(&degrees.unwrap_or_else(BigRational::one))
        }
    };
    Ok(Angle { bearing, tolerance })
}

/// What is behind a number.
fn unit_behind(text: &str) -> &str {
    text.trim_start_matches(|letter: char| letter.is_ascii_digit() || "+-−./eE ".contains(letter))
}

/// `3 %`, of the largest value of a cycle.
pub(super) fn part_of_the_largest(text: &str) -> Result<BigRational, ClaimError> {
    match tolerance(text)? {
        Tolerance::Part(part) => Ok(part),
        Tolerance::Within(_) | Tolerance::Exact { .. } => {
            Err(ClaimError::new(format!("`{text}` is not a part of the largest value"), "percent, such as ± 3 %"))
        }
    }
}

fn split_tolerance(text: &str) -> (&str, Option<&str>) {
    match text.split_once('±').or_else(|| text.split_once("+/-")) {
        Some((number, tolerance)) => (number.trim(), Some(tolerance.trim())),
        None => (text.trim(), None),
    }
}

/// A tolerance without its unit.
fn tolerance(text: &str) -> Result<Tolerance, ClaimError> {
    let (number, is_part) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
    match parse_number(number) {
        Ok(value) if value.is_negative() => Err(ClaimError::new("a tolerance is 0 or more", "such as ± 0.01 or ± 1 %")),
        Ok(value) if is_part => Ok(Tolerance::Part(value / BigRational::from_integer(100.into()))),
        Ok(value) => Ok(Tolerance::Within(value)),
        Err(_) => Err(ClaimError::new(format!("cannot read the tolerance `{text}`"), "such as ± 0.01 or ± 1 %")),
    }
}

impl Tolerance {
    /// That of a number this many times as large.
    pub(super) fn times(self, size: &BigRational) -> Self {
        match self {
            Tolerance::Exact { rounding } => Tolerance::Exact { rounding: rounding.map(|rounding| rounding * size) },
            Tolerance::Within(within) => Tolerance::Within(within * size),
            Tolerance::Part(part) => Tolerance::Part(part),
        }
    }
}

/// The same of a size: zero is no rounding of anything.
fn size_unstated(number: &str, about: bool) -> Tolerance {
    match parse_number(number).is_ok_and(|number| number.is_zero()) {
        true => Tolerance::Exact { rounding: None },
        false => unstated(number, about),
    }
}

/// Without ±: after ≈ the digits given; after = the number itself, its decimals told apart as rounding.
fn unstated(number: &str, about: bool) -> Tolerance {
    let is_decimal = parse_number(number).is_ok() && !number.contains('/');
    let places = number.split_once('.').map(|(_, places)| places.len());
    match (about && is_decimal, places.filter(|_| is_decimal)) {
        (true, places) => Tolerance::Within(half_of_place(places.unwrap_or(0))),
        (false, places) => Tolerance::Exact { rounding: places.map(half_of_place) },
    }
}
