//! How are the quantities of a layout file read, and what is said of one that cannot be?

use num_rational::BigRational;
use num_traits::Signed;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::linear;
use super::number::parse_number;
use super::rewritten::bare_number;
use super::units;
use super::written::{Column, Text, Values, place};
use crate::engine::{Cylinder, DELTA, LengthUnit, Linear, MOST_CYLINDERS, PHI, Throw};
use crate::proof::Sense;
use crate::text::counted;

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
        .map_err(|right| misread_as(&written, text, "angle", right))
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
    unit(&text.get_ref().0).map_err(|right| misread(text, what, right))
}

/// The same above 0.
pub(crate) fn positive(
    text: &Text,
    what: &str,
    unit: impl Fn(&str) -> Result<BigRational, String>,
) -> Result<BigRational, LayoutError> {
    let value = value(text, what, unit)?;
    if value.is_positive() { Ok(value) } else { Err(misread(text, what, "above 0")) }
}

/// What one of these words stands for.
pub(super) fn choice<T: Copy>(text: &Text, what: &str, right: &str, words: &[(&str, T)]) -> Result<T, LayoutError> {
    let found = words.iter().find(|(word, _)| *word == text.get_ref().0);
    found.map(|(_, meant)| *meant).ok_or_else(|| misread(text, what, right))
}

/// Which way a shaft turns, as a file has it.
pub(super) const SENSES: [(&str, Sense); 2] = [("with", Sense::Direct), ("against", Sense::Reverse)];

/// The cylinder that a text names, by its index.
pub(super) fn cylinder<A, L>(text: &Text, cylinders: &[Cylinder<A, L>]) -> Option<usize> {
    cylinders.iter().position(|cylinder| cylinder.name == text.get_ref().0)
}

/// A number without a unit, such as this one.
pub(super) fn plain(text: &str, such: &str) -> Result<BigRational, String> {
    let value = parse_number(text).map_err(|error| error.to_string())?;
    if units::has_a_size(&value) { Ok(value) } else { Err(format!("out of range; such as {such}")) }
}

/// A length; a unit behind it makes the layout metric; symbols of one lower-case letter may be in it.
pub(super) fn length(text: &Text, unit: &mut LengthUnit) -> Result<Linear, LayoutError> {
    let has_unit = std::cell::Cell::new(false);
    let known = |text: &str| {
        let length = units::length(text)?;
        has_unit.set(has_unit.get() || length.has_unit);
        Ok(length.value)
    };
    let length = linear::read(&text.get_ref().0, known, is_length_symbol);
    let length = length.map_err(|right| misread(text, "length", right))?;
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
pub(crate) fn misread(text: &Text, what: &str, right: impl Into<String>) -> LayoutError {
    misread_as(&text.get_ref().0, text, what, right)
}

/// The same of what was made of it.
pub(super) fn misread_as(written: &str, text: &Text, what: &str, right: impl Into<String>) -> LayoutError {
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
    match text.get_ref().0.parse() {
        Ok(count) if (1..=MOST_CYLINDERS as i64).contains(&count) => Ok(count),
        _ => Err(misread(text, what, format!("a whole number from 1 to {MOST_CYLINDERS}"))),
    }
}

/// A mass in kilograms, 0 or more.
pub(super) fn mass(text: &Text) -> Result<BigRational, LayoutError> {
    not_negative(value(text, "mass", units::mass)?, "mass", text)
}

/// A mass times a radius in kilogram-metres, 0 or more, and whether it is written in multiples of m r, which is `unit`.
pub(super) fn mass_radius(text: &Text, unit: &BigRational) -> Result<(BigRational, bool), LayoutError> {
    let read = units::mass_radius(&text.get_ref().0).map_err(|right| misread(text, "mass-radius", right))?;
    let (value, in_multiples) = match read {
        units::MassRadius::KilogramMetres(value) => (value, false),
        units::MassRadius::Multiples(value) => (value * unit, true),
    };
    Ok((not_negative(value, "mass-radius", text)?, in_multiples))
}

/// A length in metres of either sign.
pub(super) fn metres(text: &Text) -> Result<BigRational, LayoutError> {
    value(text, "length", units::metres)
}

/// A length in metres above 0.
pub(super) fn positive_metres(text: &Text) -> Result<BigRational, LayoutError> {
    let length = metres(text)?;
    if length.is_positive() { Ok(length) } else { Err(misread(text, "length", "a length above 0")) }
}

/// A balance factor, 0 or more.
pub(super) fn factor(text: &Text) -> Result<BigRational, LayoutError> {
    if let Some(percent) = text.get_ref().0.trim().strip_suffix('%').map(str::trim_end) {
        let right = format!(
            "which part of which masses is meant? balance_factor = BF makes BF × (rotating + ½ reciprocating); for {percent} % of the reciprocating masses beside all that rotate write counterweights = {{ rotating = 1, reciprocating = \"{percent}/100\" }}"
        );
        return Err(misread(text, "balance factor", right));
    }
    not_negative(value(text, "balance factor", |text| plain(text, "0.5"))?, "balance factor", text)
}

/// A value that is 0 or more.
pub(super) fn not_negative(value: BigRational, what: &str, text: &Text) -> Result<BigRational, LayoutError> {
    if value.is_negative() { Err(misread(text, what, format!("a {what} is 0 or more"))) } else { Ok(value) }
}

/// What is said of two keys of which one is enough.
pub(super) fn twice(first: &str, second: &str, list: &Column) -> LayoutError {
    LayoutError::new(format!("both {first} and {second} are given"), "one of them is enough", place(list))
}

/// What is said of more cylinders, or pistons, than are read.
pub(super) fn not_too_many(count: usize, what: &str) -> Result<(), LayoutError> {
    match count <= MOST_CYLINDERS {
        true => Ok(()),
        false => Err(LayoutError::new(format!("{count} {what}"), format!("up to {MOST_CYLINDERS} are read"), None)),
    }
}

/// A position along the shaft as a person writes it: millimetres where the layout is metric.
pub fn shown_position(at: &BigRational, unit: LengthUnit) -> String {
    match unit {
        LengthUnit::Metre => format!("{} mm", bare_number(&(at * integer(1000)))),
        LengthUnit::Spacing => at.to_string(),
    }
}

/// What is said of a length with a unit, where the cylinders are one spacing apart and nobody says how far that is.
pub(super) fn among_spacings(text: &Text) -> LayoutError {
    let right = "give the engine its spacing or positions, or count in spacings here too";
    let shown: String = text.get_ref().0.chars().take(40).collect();
    let message = format!("the length `{shown}` in an engine whose cylinders are one spacing apart");
    LayoutError::new(message, right, place(text))
}

/// Whether it is a length with a unit.
pub(super) fn has_unit(text: &Text) -> bool {
    let mut unit = LengthUnit::Spacing;
    length(text, &mut unit).is_ok() && unit == LengthUnit::Metre
}

pub(super) fn integer(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

pub(super) fn half() -> BigRational {
    BigRational::new(1.into(), 2.into())
}

/// The values of a column as they are written: one alone may stand for all.
pub(super) fn texts(list: &Column) -> Vec<Text> {
    match list.get_ref() {
        Values::One(text) => vec![Text::new(list.span(), text.clone())],
        Values::Each(texts) => texts.clone(),
    }
}

/// One for each of so many, of which one is called so.
pub(super) fn for_each(list: &Column, count: usize, what: &str, right: &str) -> Result<Vec<Text>, LayoutError> {
    match (list.get_ref(), texts(list)) {
        (Values::One(_), only) => Ok(only.into_iter().cycle().take(count).collect()),
        (Values::Each(_), all) if all.len() == count => Ok(all),
        (Values::Each(_), all) => {
            let message = format!("{} for {}", counted(all.len(), "value"), counted(count, what));
            Err(LayoutError::new(message, right, place(list)))
        }
    }
}

/// One value per throw.
pub(super) fn each(
    list: &Column,
    throws: &[Throw],
    read: impl FnMut(&Text) -> Result<BigRational, LayoutError>,
) -> Result<Vec<BigRational>, LayoutError> {
    let right = "one value for all, or a list with one per throw";
    for_each(list, throws.len(), "throw", right)?.iter().map(read).collect()
}
