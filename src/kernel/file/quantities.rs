//! How are the quantities of a layout file read, and what is said of one that cannot be?

use num_rational::BigRational;
use num_traits::Signed;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::linear;
use super::number::parse_number;
use super::units;
use super::written::{Column, Text, Values, place};
use crate::engine::{DELTA, LengthUnit, Linear, MOST_CYLINDERS, PHI, Throw};

/// Reads an angle as a layout file does, in turns that are not reduced.
///
/// # Errors
/// What would be right.
pub fn parse_angle(text: &str) -> Result<BigRational, String> {
    units::angle(text)
}

/// Reads a length as a layout file does: in metres where a unit is behind it, else in the unit of the layout.
///
/// # Errors
/// What would be right.
pub fn parse_length(text: &str) -> Result<(BigRational, LengthUnit), String> {
    let length = units::length(text)?;
    Ok((length.value, if length.has_unit { LengthUnit::Metre } else { LengthUnit::Spacing }))
}

/// Reads a radius above 0 in metres, which needs its unit.
///
/// # Errors
/// What would be right.
pub fn parse_radius(text: &str) -> Result<BigRational, String> {
    match units::length(text)? {
        units::Length { value, has_unit: true } if value.is_positive() => Ok(value),
        _ => Err("a length above 0 with its unit, such as \"3.5 in\"".to_owned()),
    }
}

/// A list with its place in the file.
pub(super) type List = Spanned<Vec<Text>>;

/// An angle in turns, not yet modulo 1; `phi` and `delta` may be in it.
pub(super) fn angle(text: &Text) -> Result<Linear, LayoutError> {
    let written = text.get_ref().0.replace('φ', PHI).replace('δ', DELTA);
    linear::read(&written, units::angle, |name| name == PHI || name == DELTA)
        .map_err(|right| misread("angle", &written, right, text))
}

/// An angle without unknowns, in turns.
pub(super) fn known_angle(text: &Text) -> Result<BigRational, LayoutError> {
    value(text, "angle", units::angle)
}

/// A value in the units that `unit` reads.
pub(super) fn value(
    text: &Text,
    what: &str,
    unit: impl Fn(&str) -> Result<BigRational, String>,
) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    unit(written).map_err(|right| misread(what, written, right, text))
}

/// A number without a unit, such as this one.
pub(super) fn plain(text: &str, such: &str) -> Result<BigRational, String> {
    let value = parse_number(text).map_err(|error| error.to_string())?;
    if units::has_a_size(&value) { Ok(value) } else { Err(format!("out of range; such as {such}")) }
}

/// A length; a unit behind it makes the layout metric; symbols of one lower-case letter may be in it.
pub(super) fn length(text: &Text, unit: &mut LengthUnit) -> Result<Linear, LayoutError> {
    let written = &text.get_ref().0;
    let has_unit = std::cell::Cell::new(false);
    let known = |text: &str| {
        let length = units::length(text)?;
        has_unit.set(has_unit.get() || length.has_unit);
        Ok(length.value)
    };
    let length =
        linear::read(written, known, is_length_symbol).map_err(|right| misread("length", written, right, text))?;
    if has_unit.get() {
        *unit = LengthUnit::Metre;
    }
    Ok(length)
}

/// One lower-case letter, but not that of the metre or the gram.
fn is_length_symbol(name: &str) -> bool {
    !matches!(name, "m" | "g") && name.len() == 1 && name.bytes().all(|letter| letter.is_ascii_lowercase())
}

/// A value that cannot be taken as written.
pub(super) fn misread(what: &str, written: &str, right: String, text: &Text) -> LayoutError {
    let shown: String = written.chars().take(40).collect();
    let dots = if shown.len() < written.len() { "…" } else { "" };
    LayoutError::new(format!("cannot read the {what} `{shown}{dots}`"), right, place(text))
}

pub(super) fn angles(list: &List) -> Result<Vec<Linear>, LayoutError> {
    list.get_ref().iter().map(angle).collect()
}

pub(super) fn lengths(list: &List, unit: &mut LengthUnit) -> Result<Vec<Linear>, LayoutError> {
    list.get_ref().iter().map(|text| length(text, unit)).collect()
}

pub(super) fn optional_angle(text: &Option<Text>) -> Result<Linear, LayoutError> {
    text.as_ref().map_or(Ok(Linear::default()), angle)
}

pub(super) fn optional_length(
    text: &Option<Text>,
    usual: Linear,
    unit: &mut LengthUnit,
) -> Result<Linear, LayoutError> {
    text.as_ref().map_or(Ok(usual), |text| length(text, unit))
}

pub(super) fn whole(text: &Text, what: &str) -> Result<i64, LayoutError> {
    let written = &text.get_ref().0;
    match written.parse() {
        Ok(count) if (1..=MOST_CYLINDERS as i64).contains(&count) => Ok(count),
        _ => Err(misread(what, written, format!("a whole number from 1 to {MOST_CYLINDERS}"), text)),
    }
}

/// A mass in kilograms, 0 or more.
pub(super) fn mass(text: &Text) -> Result<BigRational, LayoutError> {
    not_negative(value(text, "mass", units::mass)?, "mass", text)
}

/// A mass times a radius in kilogram-metres, 0 or more, and whether it is written in multiples of m r, which is `unit`.
pub(super) fn mass_radius(text: &Text, unit: &BigRational) -> Result<(BigRational, bool), LayoutError> {
    let written = &text.get_ref().0;
    let read = units::mass_radius(written).map_err(|right| misread("mass-radius", written, right, text))?;
    let (value, in_multiples) = match read {
        units::MassRadius::KilogramMetres(value) => (value, false),
        units::MassRadius::Multiples(value) => (value * unit, true),
    };
    Ok((not_negative(value, "mass-radius", text)?, in_multiples))
}

/// A length in metres of either sign.
pub(super) fn metres(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    units::length(written).map(|length| length.value).map_err(|right| misread("length", written, right, text))
}

/// A length in metres above 0.
pub(super) fn positive_metres(text: &Text) -> Result<BigRational, LayoutError> {
    let radius = metres(text)?;
    if radius.is_positive() {
        Ok(radius)
    } else {
        Err(misread("radius", &text.get_ref().0, "a length above 0".to_owned(), text))
    }
}

/// A balance factor, 0 or more.
pub(super) fn factor(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    if let Some(percent) = written.trim().strip_suffix('%').map(str::trim_end) {
        let right = format!(
            "which part of which masses is meant? balance_factor = BF makes BF × (rotating + ½ reciprocating); for {percent} % of the reciprocating masses beside all that rotate write counterweights = {{ rotating = 1, reciprocating = \"{percent}/100\" }}"
        );
        return Err(misread("balance factor", written, right, text));
    }
    not_negative(value(text, "balance factor", |text| plain(text, "0.5"))?, "balance factor", text)
}

/// A value that is 0 or more.
pub(super) fn not_negative(value: BigRational, what: &str, text: &Text) -> Result<BigRational, LayoutError> {
    if value.is_negative() {
        return Err(misread(what, &text.get_ref().0, format!("a {what} is 0 or more"), text));
    }
    Ok(value)
}

/// What is said of a length with a unit, where the cylinders are one spacing apart and nobody says how far that is.
pub(super) fn among_spacings(place: Option<std::ops::Range<usize>>) -> LayoutError {
    let right = "give the engine its spacing or positions, or count in spacings here too";
    LayoutError::new("a length in an engine whose cylinders are one spacing apart", right, place)
}

/// One value per throw.
pub(super) fn each(
    list: &Column,
    throws: &[Throw],
    mut read: impl FnMut(&Text) -> Result<BigRational, LayoutError>,
) -> Result<Vec<BigRational>, LayoutError> {
    match list.get_ref() {
        Values::One(text) => Ok(vec![read(&Text::new(list.span(), text.clone()))?; throws.len()]),
        Values::Each(texts) if texts.len() == throws.len() => texts.iter().map(read).collect(),
        Values::Each(texts) => {
            let message = format!("{} values for {} throws", texts.len(), throws.len());
            Err(LayoutError::new(message, "one value for all, or a list with one per throw", place(list)))
        }
    }
}
