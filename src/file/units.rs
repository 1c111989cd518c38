//! What quantity did a person write? A number with a unit that a person would put behind it.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed, Zero};

use super::number::parse_number;

/// A length as written: its value, and whether it has a unit.
pub(crate) struct Length {
    /// In metres, or in multiples of the spacing where no unit stands.
    pub value: BigRational,
    /// Whether a unit stands behind it.
    pub has_unit: bool,
}

/// Quantities beyond 10^40 of their base unit, or below its 10^-40th part, are refused: no engine has them, and their products
/// would leave the range of decimals.
const LARGEST_POWER: u32 = 40;
/// Larger angles than this, in turns, are refused: whoever writes one means another number.
const MOST_TURNS: u32 = 1_000_000;

/// Whether a quantity is 0 or has a size that decimals of its products can show.
pub(crate) fn has_a_size(value: &BigRational) -> bool {
    let largest = BigRational::from_integer(Pow::pow(BigInt::from(10), LARGEST_POWER));
    let size = value.abs();
    size.is_zero() || (size <= largest && size.recip() <= largest)
}

fn sized(value: BigRational) -> Result<BigRational, String> {
    match has_a_size(&value) {
        true => Ok(value),
        false => {
            Err(format!("out of range; 0, or a size between 10^-{LARGEST_POWER} and 10^{LARGEST_POWER} in SI units"))
        }
    }
}

/// The units of a kind of quantity, by name, with their size in the base unit as a fraction.
type Units = &'static [(&'static str, (i64, i64))];

const ANGLES: Units = &[
    ("turns", (1, 1)),
    ("turn", (1, 1)),
    ("pi rad", (1, 2)),
    ("π rad", (1, 2)),
    ("degrees", (1, 360)),
    ("deg", (1, 360)),
    ("°", (1, 360)),
];
const LENGTHS: Units = &[("mm", (1, 1000)), ("cm", (1, 100)), ("in", (127, 5000)), ("m", (1, 1))];
const SPEEDS: Units = &[("rpm", (1, 1)), ("1/min", (1, 1)), ("rev/s", (60, 1)), ("Hz", (60, 1))];
const MASS_RADII: Units = &[
    ("kg mm", (1, 1000)),
    ("kg m", (1, 1)),
    ("kg·m", (1, 1)),
    ("g mm", (1, 1_000_000)),
    ("g cm", (1, 100_000)),
    ("g m", (1, 1000)),
];
const INERTIAS: Units = &[
    ("kg m^2", (1, 1)),
    ("kg m²", (1, 1)),
    ("kg·m²", (1, 1)),
    ("kg m2", (1, 1)),
    ("kg cm^2", (1, 10_000)),
    ("kg cm²", (1, 10_000)),
    ("g m²", (1, 1000)),
];
const TORSIONAL_STIFFNESSES: Units = &[
    ("MN m/rad", (1_000_000, 1)),
    ("MNm/rad", (1_000_000, 1)),
    ("kN m/rad", (1000, 1)),
    ("kNm/rad", (1000, 1)),
    ("N m/rad", (1, 1)),
    ("N·m/rad", (1, 1)),
    ("Nm/rad", (1, 1)),
];
const MASSES: Units = &[("kg", (1, 1)), ("g", (1, 1000)), ("lb", (45_359_237, 100_000_000))];

/// An angle in turns, not reduced modulo 1; degrees where no unit stands.
pub(crate) fn angle(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, ANGLES, "\"45\", \"22.5 deg\", \"1/12 turn\" or \"2/3 pi rad\"")?;
    let turns = number * ratio(unit.unwrap_or((1, 360)));
    match turns.abs() <= BigRational::from_integer(MOST_TURNS.into()) {
        true => Ok(turns),
        false => Err(format!("more than {MOST_TURNS} turns; an angle is meant modulo a turn, such as \"45\"")),
    }
}

/// Turns in this unit of an angle, the degree where none is named; none where it is no unit of an angle.
pub fn turns_per_unit(unit: &str) -> Option<BigRational> {
    angle(&format!("1 {unit}")).ok()
}

/// A length; without a unit, metres or multiples of the spacing.
pub(crate) fn length(text: &str) -> Result<Length, String> {
    let (number, unit) = with_unit(text, LENGTHS, "\"0.12\", \"120 mm\", \"12 cm\" or \"4.4 in\"")?;
    Ok(Length { value: sized(number * ratio(unit.unwrap_or((1, 1))))?, has_unit: unit.is_some() })
}

/// A mass; kilograms where no unit stands.
pub(crate) fn mass(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, MASSES, "\"0.65\", \"650 g\" or \"1.4 lb\"")?;
    sized(number * ratio(unit.unwrap_or((1, 1))))
}

/// A mass times a radius in kilogram-metres; kilogram-metres where no unit stands.
pub(crate) fn mass_radius(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, MASS_RADII, "\"0.012\", \"0.012 kg m\", \"12 kg mm\" or \"1200 g cm\"")?;
    sized(number * ratio(unit.unwrap_or((1, 1))))
}

/// A moment of inertia in kg m²; in those where no unit stands.
pub(crate) fn inertia(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, INERTIAS, "\"0.03\", \"0.03 kg m^2\" or \"300 kg cm^2\"")?;
    sized(number * ratio(unit.unwrap_or((1, 1))))
}

/// A torsional stiffness in N m per radian; in those where no unit stands.
pub(crate) fn torsional_stiffness(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, TORSIONAL_STIFFNESSES, "\"1000000\", \"1000 kN m/rad\" or \"1 MN m/rad\"")?;
    sized(number * ratio(unit.unwrap_or((1, 1))))
}

/// A speed in revolutions a minute, which is also what a number without a unit means.
pub(crate) fn speed(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, SPEEDS, "\"6000\", \"6000 rpm\" or \"100 Hz\"")?;
    sized(number * ratio(unit.unwrap_or((1, 1))))
}

fn ratio((numerator, denominator): (i64, i64)) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn with_unit(text: &str, units: Units, examples: &str) -> Result<(BigRational, Option<(i64, i64)>), String> {
    let text = text.trim();
    let unit = units.iter().find(|(name, _)| text.ends_with(name));
    let number = unit.map_or(text, |(name, _)| text[..text.len() - name.len()].trim_end());
    let value = parse_number(number).map_err(|error| match unknown_unit(text) {
        Some(word) => {
            let known: Vec<&str> = units.iter().map(|(name, _)| *name).collect();
            format!("`{word}` is none of {}; write, for instance, {examples}", known.join(", "))
        }
        None => format!("{error}; for instance {examples}"),
    })?;
    Ok((value, unit.map(|(_, size)| *size)))
}

/// What stands behind a number.
fn unknown_unit(text: &str) -> Option<&str> {
    let digits = text.rfind(|letter: char| letter.is_ascii_digit())? + 1;
    let word = text[digits..].trim();
    (!word.is_empty() && parse_number(&text[..digits]).is_ok()).then_some(word)
}
