//! Which number or direction is claimed, and how near does it have to be?

use num_rational::BigRational;
use num_traits::{One, Pow, Signed};

use super::error::ClaimError;
use super::statement::{Angle, Bearing, Tolerance, Unit, Value};
use crate::file::{parse_number, units};
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

/// `√3`, `0.449 ± 0.001`, `65.18 N·m ± 1 %`.
pub(super) fn value(text: &str, about: bool, quantity: Quantity) -> Result<Value, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let unit = UNITS.iter().find(|(name, ..)| number.ends_with(name));
    let number = unit.map_or(number, |(name, ..)| number[..number.len() - name.len()].trim_end());
    let (unit, size) =
        (unit.map(|(_, unit, _)| *unit), BigRational::from_integer(unit.map_or(1, |(.., size)| *size).into()));
    let right = "a number such as 4, 2√3, √(5 − 2√5), 1.732 or 3·cos(40°), 0 or more";
    let form = Form::parse(number).filter(|form| form.to_float() >= 0.0);
    let form = form.ok_or_else(|| ClaimError::new(format!("cannot read the value `{number}`"), right))?;
    let fits = match unit {
        None => true,
        Some(Unit::Newton) => quantity == Quantity::FORCE,
        Some(Unit::NewtonMetre) => quantity == Quantity::MOMENT,
    };
    if !fits {
        return Err(ClaimError::new(
            "this unit belongs to another quantity",
            "a force has N or kN, a moment N·m or kN·m",
        ));
    }
    let tolerance = match tolerance {
        Some(text) => self::tolerance(text, &size)?,
        None => unstated(number, about).times(&size),
    };
    Ok(Value { form: form.scaled(&size), tolerance, unit })
}

/// `4.08375 kg`, `4.0837 kg ± 0.0001 kg`.
pub(super) fn kilograms(text: &str, about: bool) -> Result<Value, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let right = "a mass in kilograms, such as 4.08375 kg";
    let mistake = || ClaimError::new(format!("cannot read the mass `{number}`"), right);
    let number = number.strip_suffix("kg").ok_or_else(mistake)?.trim_end();
    let mass = parse_number(number).ok().filter(|mass| !mass.is_negative()).ok_or_else(mistake)?;
    let tolerance = match tolerance {
        Some(text) => self::tolerance(text.trim_end_matches("kg").trim_end(), &BigRational::one())?,
        None => unstated(number, about),
    };
    Ok(Value { form: Form::rational(mass), tolerance, unit: None })
}

/// `30°`, `-18.43° ± 0.01°`, `1/12 turn`, `-arctan(1/3)`.
pub(super) fn angle(text: &str) -> Result<Angle, ClaimError> {
    let (number, tolerance) = split_tolerance(text);
    let right = "an angle such as 30°, 22.5 deg, 1/12 turn or −arctan(1/3)";
    let mistake = || ClaimError::new(format!("cannot read the angle `{number}`"), right);
    let plain = number.replace('−', "-");
    let (sign, positive) = plain.strip_prefix('-').map_or((1, plain.as_str()), |rest| (-1, rest));
    let tangent = positive.trim().strip_prefix("arctan(").and_then(|rest| rest.strip_suffix(')'));
    let bearing = match tangent {
        Some(tangent) => {
            let form = Form::parse(tangent).ok_or_else(mistake)?;
            Bearing::Arctangent(form.scaled(&BigRational::from_integer(sign.into())))
        }
        None => Bearing::Turns(units::angle(number).map_err(|_| mistake())?),
    };
    let tolerance = match tolerance {
        Some(text) => {
            self::tolerance(text.trim_end_matches("deg").trim_end_matches('°').trim_end(), &BigRational::one())?
        }
        None => unstated(number.trim_end_matches(|letter: char| !letter.is_ascii_digit()), false),
    };
    if matches!(tolerance, Tolerance::Part(_)) {
        return Err(ClaimError::new("an angle has no tolerance in percent", "a tolerance in degrees, such as ± 0.01°"));
    }
    Ok(Angle { bearing, tolerance })
}

/// `3 %`, of the largest value of a cycle.
pub(super) fn part_of_the_largest(text: &str) -> Result<BigRational, ClaimError> {
    match tolerance(text, &BigRational::one())? {
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

/// A tolerance, of a value in a unit of this size.
fn tolerance(text: &str, size: &BigRational) -> Result<Tolerance, ClaimError> {
    let (number, is_part) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
    // The tolerance may have a unit of its own.
    let own = UNITS.iter().find_map(|(name, _, size)| Some((number.strip_suffix(name)?, *size)));
    let size = own.map_or_else(|| size.clone(), |(_, size)| BigRational::from_integer(size.into()));
    match parse_number(own.map_or(number, |(number, _)| number)) {
        Ok(value) if value.is_negative() => Err(ClaimError::new("a tolerance is 0 or more", "such as ± 0.01 or ± 1 %")),
        Ok(value) if is_part => Ok(Tolerance::Part(value / BigRational::from_integer(100.into()))),
        Ok(value) => Ok(Tolerance::Within(value * size)),
        Err(_) => Err(ClaimError::new(format!("cannot read the tolerance `{text}`"), "such as ± 0.01 or ± 1 %")),
    }
}

impl Tolerance {
    /// That of a number this many times as large.
    fn times(self, size: &BigRational) -> Self {
        match self {
            Tolerance::Exact { rounding } => Tolerance::Exact { rounding: rounding.map(|rounding| rounding * size) },
            Tolerance::Within(within) => Tolerance::Within(within * size),
            Tolerance::Part(part) => Tolerance::Part(part),
        }
    }
}

/// Without ±: after ≈ the digits given; after = the number itself, its decimals told apart as rounding.
fn unstated(number: &str, about: bool) -> Tolerance {
    let is_decimal = parse_number(number).is_ok() && !number.contains('/');
    let places = number.split_once('.').map(|(_, places)| places.len());
    let half = |places: usize| BigRational::new(1.into(), 2.into()) / BigRational::from_integer(10.into()).pow(places);
    match (about && is_decimal, places.filter(|_| is_decimal)) {
        (true, places) => Tolerance::Within(half(places.unwrap_or(0))),
        (false, places) => Tolerance::Exact { rounding: places.map(half) },
    }
}
