//! What quantity did a person write? A number with a unit that a person would put behind it.

use std::borrow::Cow;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed, Zero};

use super::number::parse_number;
use crate::exact::fraction;

/// A length as written: its value, and whether it has a unit.
pub(crate) struct Length {
    /// In metres, or in multiples of the spacing where no unit is written.
    pub value: BigRational,
    /// Whether a unit is behind it.
    pub has_unit: bool,
}

/// Quantities beyond 10^40 of their base unit, or below its 10^-40th part, are refused: no engine has them, and their products
/// would leave the range of decimals.
const LARGEST_POWER: u32 = 40;
/// Larger angles than this, in turns, are refused: whoever writes one means another number.
const MOST_TURNS: u32 = 1_000_000;

/// Higher pressures than this, in pascals, are refused.
const MOST_PASCALS: i64 = 100_000_000_000;

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

/// The units of a kind of quantity, by all that one is called ([`before`] has more spellings), with their size in the base unit as a fraction.
type Units = &'static [(&'static [&'static str], (i64, i64))];

/// Each name, in their order, with the size.
fn named(units: Units) -> impl Iterator<Item = (&'static str, (i64, i64))> {
    units.iter().flat_map(|(names, size)| names.iter().map(move |name| (*name, *size)))
}

/// What stands before this unit at the end of a text: `kg m²` may be written `kg·m²`, `kg m^2` or `kg m2`.
fn before<'t>(text: &'t str, unit: &str) -> Option<&'t str> {
    unit.chars().rev().try_fold(text, |text, sign| match sign {
        ' ' => text.strip_suffix([' ', '·']),
        '²' => ["²", "^2", "2"].into_iter().find_map(|square| text.strip_suffix(square)),
        other => text.strip_suffix(other),
    })
}

const ANGLES: Units =
    &[(&["turns", "turn"], (1, 1)), (&["pi rad", "π rad"], (1, 2)), (&["degrees", "deg", "°"], (1, 360))];
const LENGTHS: Units =
    &[(&["mm"], (1, 1000)), (&["cm"], (1, 100)), (&["in"], (127, 5000)), (&["ft"], (381, 1250)), (&["m"], (1, 1))];
const AREAS: Units = &[(&["mm²"], (1, 1_000_000)), (&["cm²"], (1, 10_000)), (&["in²"], (16_129, 25_000_000))];
const SPEEDS: Units =
    &[(&["rpm", "RPM", "1/min", "U/min", "rev/min", "min^-1", "min-1", "min⁻¹"], (1, 1)), (&["rev/s", "Hz"], (60, 1))];
const MASS_RADII: Units = &[
    (&["kg mm"], (1, 1000)),
    (&["kg m"], (1, 1)),
    (&["g mm"], (1, 1_000_000)),
    (&["g cm"], (1, 100_000)),
    (&["g m"], (1, 1000)),
    (&["oz in"], (45_359_237 * 127, 1_600_000_000 * 5000)),
    (&["lb in"], (45_359_237 * 127, 100_000_000 * 5000)),
    (&["lb ft"], (45_359_237 * 381, 100_000_000 * 1250)),
];
const PRESSURES: Units = &[
    (&["mbar"], (100, 1)),
    (&["bar"], (100_000, 1)),
    (&["MPa"], (1_000_000, 1)),
    (&["kPa"], (1000, 1)),
    (&["Pa"], (1, 1)),
    // A pound-force of 4.4482216152605 N on a square inch.
    (&["psi"], (44_482_216_152_605, 6_451_600_000)),
];
/// A pound-force on a foot: 4.4482216152605 N times 0.3048 m.
const FOOT_POUND: (i64, i64) = (8_896_443_230_521 * 381, 2_000_000_000_000 * 1250);
const ENERGIES: Units = &[(&["MJ"], (1_000_000, 1)), (&["kJ"], (1000, 1)), (&["J"], (1, 1)), (&["ft lbf"], FOOT_POUND)];
const INERTIAS: Units = &[
    (&["kg m²"], (1, 1)),
    (&["kg cm²"], (1, 10_000)),
    (&["g m²"], (1, 1000)),
    (&["lb ft²"], (45_359_237 * 145_161, 100_000_000 * 1_562_500)),
    (&["lb in²"], (45_359_237 * 16_129, 100_000_000 * 25_000_000)),
];
const TORSIONAL_STIFFNESSES: Units = &[
    (&["MN m/rad", "MNm/rad"], (1_000_000, 1)),
    (&["kN m/rad", "kNm/rad"], (1000, 1)),
    (&["N m/rad", "Nm/rad"], (1, 1)),
    (&["ft lbf/rad", "lbf ft/rad"], FOOT_POUND),
];
/// A pound-force on an inch: 4.4482216152605 N over 0.0254 m.
const POUND_PER_INCH: (i64, i64) = (44_482_216_152_605, 254_000_000_000);
const STIFFNESSES: Units = &[
    (&["MN/m", "kN/mm"], (1_000_000, 1)),
    (&["kN/m", "N/mm"], (1000, 1)),
    (&["N/m"], (1, 1)),
    (&["lbf/in"], POUND_PER_INCH),
];
const DAMPINGS: Units = &[(&["kN s/m", "N s/mm"], (1000, 1)), (&["N s/m"], (1, 1)), (&["lbf s/in"], POUND_PER_INCH)];
const TORSIONAL_DAMPINGS: Units = &[
    (&["MN m s/rad"], (1_000_000, 1)),
    (&["kN m s/rad"], (1000, 1)),
    (&["N m s/rad"], (1, 1)),
    (&["MN m s"], (1_000_000, 1)),
    (&["kN m s"], (1000, 1)),
    (&["N m s", "Nms/rad"], (1, 1)),
    (&["ft lbf s/rad", "lbf ft s/rad"], FOOT_POUND),
];
const TORQUES: Units = &[
    (&["MN m"], (1_000_000, 1)),
    (&["kN m", "kNm"], (1000, 1)),
    (&["N m", "Nm"], (1, 1)),
    (&["ft lbf", "lbf ft"], FOOT_POUND),
];
const STRESSES: Units = &[
    (&["GPa"], (1_000_000_000, 1)),
    (&["MPa", "N/mm²"], (1_000_000, 1)),
    (&["kPa"], (1000, 1)),
    (&["Pa"], (1, 1)),
    (&["psi"], (44_482_216_152_605, 6_451_600_000)),
];
const MASSES: Units = &[
    (&["kg"], (1, 1)),
    (&["g"], (1, 1000)),
    (&["lb"], (45_359_237, 100_000_000)),
    (&["oz"], (45_359_237, 1_600_000_000)),
    (&["t"], (1000, 1)),
];

/// An angle in turns, not reduced modulo 1; degrees where no unit is written.
pub(crate) fn angle(text: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(&of_pi(text), ANGLES, "\"45\", \"22.5 deg\", \"1/12 turn\" or \"2/3 pi rad\"")?;
    let turns = in_base_units(&number, unit.unwrap_or((1, 360)));
    match turns.numer().magnitude() <= &(turns.denom().magnitude() * MOST_TURNS) {
        true => Ok(turns),
        false => Err(format!("more than {MOST_TURNS} turns; an angle is meant modulo a turn, such as \"45\"")),
    }
}

/// `π/3 rad` as `1/3 pi rad`, and `pi rad` as `1 pi rad`; other texts as they are.
fn of_pi(text: &str) -> Cow<'_, str> {
    let trimmed = text.trim();
    let (sign, unsigned) = trimmed.split_at(usize::from(trimmed.starts_with(['-', '+'])));
    let behind = unsigned.strip_prefix("pi").or_else(|| unsigned.strip_prefix('π'));
    match behind.and_then(|behind| behind.strip_suffix("rad")).map(str::trim) {
        Some(part) if part.is_empty() || part.starts_with('/') => Cow::Owned(format!("{sign}1{part} pi rad")),
        _ => Cow::Borrowed(text),
    }
}

/// Turns in this unit of an angle, the degree where none is named; none where it is no unit of an angle.
pub fn turns_per_unit(unit: &str) -> Option<BigRational> {
    angle(&format!("1 {unit}")).ok()
}

/// A length; without a unit, metres or multiples of the spacing.
pub(crate) fn length(text: &str) -> Result<Length, String> {
    let (number, unit) = with_unit(text, LENGTHS, "\"0.12\", \"120 mm\", \"12 cm\", \"4.4 in\" or \"0.4 ft\"")?;
    Ok(Length { value: sized(in_base_units(&number, unit.unwrap_or((1, 1))))?, has_unit: unit.is_some() })
}

/// The same in metres, whether it has a unit or not.
pub(crate) fn metres(text: &str) -> Result<BigRational, String> {
    length(text).map(|length| length.value)
}

/// A mass; kilograms where no unit is written.
pub(crate) fn mass(text: &str) -> Result<BigRational, String> {
    in_units(text, MASSES, "\"0.65\", \"650 g\", \"1.4 lb\" or \"23 oz\"")
}

/// A mass times a radius.
pub(crate) enum MassRadius {
    /// In kilogram-metres, which is also what a number without a unit means.
    KilogramMetres(BigRational),
    /// In multiples of m r, the reciprocating mass and the crank radius of the engine.
    Multiples(BigRational),
}

/// A mass times a radius.
pub(crate) fn mass_radius(text: &str) -> Result<MassRadius, String> {
    const EXAMPLES: &str = "\"0.012\", \"0.012 kg m\", \"12 kg mm\", \"16.7 oz in\" or \"1/4 m r\"";
    let multiple = text.trim().strip_suffix("m r").map(str::trim_end);
    match multiple.filter(|number| !number.ends_with(char::is_alphabetic)) {
        Some("") => Ok(MassRadius::Multiples(BigRational::from_integer(1.into()))),
        Some(number) => parse_number(number)
            .map_err(|error| format!("{error}; for instance {EXAMPLES}"))
            .and_then(sized)
            .map(MassRadius::Multiples),
        None => in_units(text, MASS_RADII, EXAMPLES).map(MassRadius::KilogramMetres),
    }
}

/// Pascals in a unit of pressure.
pub(crate) type PressureUnit = (i64, i64);

/// A unit of pressure by its name.
pub(crate) fn pressure_unit(name: &str) -> Result<PressureUnit, String> {
    pressure_unit_named(name.trim()).map(|(_, size)| size).ok_or_else(|| format!("one of {}", names(PRESSURES)))
}

/// A unit of pressure by its name, with that name.
pub(crate) fn pressure_unit_named(name: &str) -> Option<(&'static str, PressureUnit)> {
    named(PRESSURES).find(|(known, _)| *known == name)
}

/// A pressure in pascals; its unit is behind it, or holds for a whole table.
pub(crate) fn pressure(text: &str, of_all: Option<PressureUnit>) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, PRESSURES, "\"0.9 bar\", \"8.2 MPa\", \"101325 Pa\" or \"14.7 psi\"")?;
    match unit.or(of_all) {
        Some(unit) => match in_base_units(&number, unit) {
            value if value.abs() <= BigRational::from_integer(MOST_PASCALS.into()) => sized(value),
            _ => Err("no engine has more than a million bar: is the unit right?".to_owned()),
        },
        None => Err(format!("a pressure needs its unit, one of {}; a table may say unit = \"bar\"", names(PRESSURES))),
    }
}

/// An energy in joules, which is also what a number without a unit means.
pub(crate) fn energy(text: &str) -> Result<BigRational, String> {
    in_units(text, ENERGIES, "\"1100 J\" or \"1.6 MJ\"")
}

/// A moment of inertia in kilograms times square metres, which is also what a number without a unit means.
pub(crate) fn inertia(text: &str) -> Result<BigRational, String> {
    in_units(text, INERTIAS, "\"0.5\", \"0.5 kg m²\" or \"5000 kg cm²\"")
}

/// A stiffness in newtons a metre, which is also what a number without a unit means.
pub(crate) fn stiffness(text: &str) -> Result<BigRational, String> {
    in_units(text, STIFFNESSES, "\"220000\", \"220 kN/m\", \"220 N/mm\" or \"1250 lbf/in\"")
}

/// A viscous damping in newton seconds a metre, which is also what a number without a unit means.
pub(crate) fn damping(text: &str) -> Result<BigRational, String> {
    in_units(text, DAMPINGS, "\"350\", \"350 N s/m\", \"0.35 N s/mm\" or \"2 lbf s/in\"")
}

/// A torsional stiffness in N m per radian; in those where no unit is written.
pub(crate) fn torsional_stiffness(text: &str) -> Result<BigRational, String> {
    in_units(text, TORSIONAL_STIFFNESSES, "\"1000000\", \"1000 kN m/rad\" or \"1 MN m/rad\"")
}

/// A damping of a vibration of torsion in N m s per radian, which is also what a number without a unit means.
pub(crate) fn torsional_damping(text: &str) -> Result<BigRational, String> {
    in_units(text, TORSIONAL_DAMPINGS, "\"30\", \"30 N m s/rad\" or \"60 kN m s/rad\"")
}

/// A torque in N m, which is also what a number without a unit means.
pub(crate) fn torque(text: &str) -> Result<BigRational, String> {
    in_units(text, TORQUES, "\"100\", \"100 N m\" or \"63.6 kN m\"")
}

/// A number, or a moment in N m where a unit is behind it, with which of both it is.
pub(crate) fn moment(text: &str) -> Result<(BigRational, bool), String> {
    let (number, unit) = with_unit(text, TORQUES, "\"1.5\" or \"30 kN m\"")?;
    Ok((sized(in_base_units(&number, unit.unwrap_or((1, 1))))?, unit.is_some()))
}

/// A stress or a modulus in pascals, which is also what a number without a unit means.
pub(crate) fn stress(text: &str) -> Result<BigRational, String> {
    in_units(text, STRESSES, "\"80 GPa\", \"560 MPa\" or \"560 N/mm²\"")
}

/// An area of a diagram of torque over angle.
pub(crate) enum Area {
    /// In square metres of the drawing.
    Square(BigRational),
    /// As the work that it stands for.
    Joules(BigRational),
}

/// An area of a diagram, of the drawing or as a work; a number without a unit is neither.
pub(crate) fn area(text: &str) -> Result<Area, String> {
    const EXAMPLES: &str = "\"52 mm²\", \"-0.45 cm²\", \"1.2 in²\" or \"1400 J\"";
    if let Ok((joules, Some(unit))) = with_unit(text, ENERGIES, EXAMPLES) {
        return sized(in_base_units(&joules, unit)).map(Area::Joules);
    }
    match with_unit(text, AREAS, EXAMPLES)? {
        (square, Some(unit)) => sized(in_base_units(&square, unit)).map(Area::Square),
        (_, None) => Err(format!("with its unit, for instance {EXAMPLES}")),
    }
}

/// What of a torque a metre of the drawing stands for.
pub(crate) fn torque_scale(text: &str) -> Result<BigRational, String> {
    per(text, torque, LENGTHS, "\"600 N m/mm\" or \"1 mm = 600 N m\"")
}

/// What of an angle, in turns, a metre of the drawing stands for.
pub(crate) fn angle_scale(text: &str) -> Result<BigRational, String> {
    per(text, angle, LENGTHS, "\"3°/mm\" or \"1 mm = 3°\"")
}

/// What of a work in joules a square metre of the drawing stands for.
pub(crate) fn area_scale(text: &str) -> Result<BigRational, String> {
    per(text, energy, AREAS, "\"1400 J/cm²\" or \"1 cm² = 1400 J\"")
}

/// `600 N m/mm`, `600 N m per mm`, `1 mm = 600 N m`: a quantity for one of these units.
fn per(
    text: &str,
    of: impl Fn(&str) -> Result<BigRational, String>,
    units: Units,
    examples: &str,
) -> Result<BigRational, String> {
    let of_a_unit = |unit: &str| format!("1 {}", unit.trim());
    let (above, below) = match (text.split_once('='), text.split_once(" per ")) {
        (Some((below, above)), _) => (above, below.to_owned()),
        (None, Some((above, below))) => (above, of_a_unit(below)),
        (None, None) => text
            .rsplit_once('/')
            .map(|(above, below)| (above, of_a_unit(below)))
            .ok_or_else(|| format!("such as {examples}"))?,
    };
    match with_unit(&below, units, examples)? {
        (number, Some(unit)) if !number.is_zero() => sized(of(above)? / in_base_units(&number, unit)),
        _ => Err(format!("such as {examples}")),
    }
}

/// π, less than 10^-34 too small.
pub(crate) fn pi() -> BigRational {
    BigRational::new(PI.0.into(), PI.1.into())
}

fn names(units: Units) -> String {
    named(units).map(|(name, _)| name).collect::<Vec<_>>().join(", ")
}

/// π, less than 10^-34 too small: a speed in radians a second is a whole multiple of a millionth of a revolution a minute, the nearest one.
const PI: (i128, i128) =
    (31_415_926_535_897_932_384_626_433_832_795_028, 10_000_000_000_000_000_000_000_000_000_000_000);

/// A speed in revolutions a minute, which is also what a number without a unit means.
pub(crate) fn speed(text: &str) -> Result<BigRational, String> {
    const EXAMPLES: &str = "\"6000\", \"6000 rpm\", \"6000 1/min\", \"100 Hz\" or \"314 rad/s\"";
    let Some(radians) = text.trim().strip_suffix("rad/s") else { return in_units(text, SPEEDS, EXAMPLES) };
    let radians = in_units(radians.trim_end(), &[], EXAMPLES)?;
    let millionths = BigRational::from_integer(30_000_000.into()) * BigRational::new(PI.1.into(), PI.0.into());
    Ok((radians * millionths).round() / BigRational::from_integer(1_000_000.into()))
}

/// A quantity in the base unit of these, which is also what a number without a unit means.
fn in_units(text: &str, units: Units, examples: &str) -> Result<BigRational, String> {
    let (number, unit) = with_unit(text, units, examples)?;
    sized(in_base_units(&number, unit.unwrap_or((1, 1))))
}

fn in_base_units(number: &BigRational, (numerator, denominator): (i64, i64)) -> BigRational {
    fraction::times(number, &fraction::ratio(numerator, denominator))
}

fn with_unit(text: &str, units: Units, examples: &str) -> Result<(BigRational, Option<(i64, i64)>), String> {
    let text = text.trim();
    let found = named(units).find_map(|(name, size)| Some((before(text, name)?.trim_end(), size)));
    let (number, unit) = found.map_or((text, None), |(number, size)| (number, Some(size)));
    let value = parse_number(number).map_err(|error| match unknown_unit(text) {
        Some(word) => {
            format!("`{word}` is none of {}; write, for instance, {examples}", names(units))
        }
        None => format!("{error}; for instance {examples}"),
    })?;
    Ok((value, unit))
}

/// What is behind a number.
fn unknown_unit(text: &str) -> Option<&str> {
    let digits = text.rfind(|letter: char| letter.is_ascii_digit())? + 1;
    // Digits may be in the unit too, as in 1/s.
    let parts = [Some(text.split_at(digits)), text.split_once(' ')];
    let is_unit = |(number, word): &(&str, &str)| {
        !word.trim().is_empty() && parse_number(word).is_err() && parse_number(number).is_ok()
    };
    parts.into_iter().flatten().find(is_unit).map(|(_, word)| word.trim())
}
