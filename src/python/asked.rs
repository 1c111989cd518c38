//! What do the arguments of a question mean? Numbers are taken exactly, words are those of the command line.

use num_rational::BigRational;
use num_traits::{One, Signed};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::error::told;
use super::keys;
use crate::engine::{Cycle, CycleOrder, ORDERS};
use crate::exact::Turn;
use crate::file::{parse_angle, parse_number};
use crate::firing::Weights;
use crate::order::Masses;
use crate::remedy;
use crate::report::ValueName;
pub(super) use crate::report::rising;
use crate::search::{self, Limit};
use crate::text::counted;

/// Orders of force and moment: whole numbers, in a list or an array; none where they are omitted.
pub(super) fn orders(value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Vec<u32>>> {
    let Some(value) = value else { return Ok(None) };
    let read = |text: &String| {
        let order = text.parse().ok().filter(|order| ORDERS.contains(order));
        order.ok_or_else(|| told(format!("order `{text}`; allowed are whole numbers from 1 to {}", ORDERS.end())))
    };
    keys::numbers(value)?.iter().map(read).collect::<PyResult<_>>().map(Some)
}

/// Exact values as texts that are read again.
pub(super) fn written(values: &[impl ToString]) -> Vec<String> {
    values.iter().map(ToString::to_string).collect()
}

/// An angle as a text that is read again.
pub(super) fn in_turns(angle: &Turn) -> String {
    format!("{} turn", angle.turns())
}

/// The masses that the verdicts are about.
pub(super) fn masses(name: &str) -> PyResult<Masses> {
    let known = serde_json::from_value(name.into());
    known.map_err(|_| told(format!("masses `{name}`; allowed are reciprocating, rotating, counterweights or all")))
}

/// The working cycle.
pub(super) fn cycle(name: &str) -> PyResult<Cycle> {
    Cycle::of(name).ok_or_else(|| told(format!("cycle `{name}`; two-stroke or four-stroke")))
}

/// Two positions along the crankshaft, as they are written.
pub(super) fn planes(value: &Bound<'_, PyAny>) -> PyResult<[String; 2]> {
    let planes: Vec<String> = keys::numbers(value)?;
    let count = counted(planes.len(), "position");
    planes.try_into().map_err(|_| told(format!("planes: {count}; give two, such as (0.12, -0.12)")))
}

/// Balance factors: none, one for all, or one per throw.
pub(super) fn factors(value: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<BigRational>> {
    let refused = |text: &str, why: String| told(format!("balance_factor: cannot read `{text}`: {why}"));
    all(value)?.iter().map(|text| remedy::factor_of(text).map_err(|why| refused(text, why))).collect()
}

/// Rod ratios: none, one, or several.
pub(super) fn rod_ratios(value: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<BigRational>> {
    let read = |text: String| match exact("rod_ratios", &text)? {
        ratio if ratio.is_negative() || ratio >= BigRational::one() => {
            Err(told(format!("rod_ratios: `{text}`; a rod ratio is from 0 to below 1")))
        }
        ratio => Ok(ratio),
    };
    all(value)?.into_iter().map(read).collect()
}

/// Angles in degrees: none, one for all, or one per throw.
pub(super) fn skews(value: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<Turn>> {
    all(value)?.iter().map(|text| angle("skew", text)).collect()
}

/// An angle, in degrees where it has no unit.
pub(super) fn angle(name: &str, text: &str) -> PyResult<Turn> {
    let turns = parse_angle(text).map_err(|right| told(format!("{name}: cannot read `{text}`: {right}")))?;
    Ok(Turn::new(turns))
}

/// The largest moments that a search allows: {2: 1.5}, {2: "30 kN m"}.
pub(super) fn limits(value: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<Limit>> {
    let read = |(order, most): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let text = format!("{}={}", keys::number(&order)?, keys::number(&most)?);
        Limit::parse(&text).map_err(|right| told(format!("limits: cannot read `{text}`: {right}")))
    };
    value.into_iter().flat_map(|limits| limits.iter()).map(read).collect()
}

/// Names of values.
pub(super) fn value_names(keyword: &str, names: &[String]) -> PyResult<Vec<ValueName>> {
    names.iter().map(|name| name.parse().map_err(|why| told(format!("{keyword}: {why}")))).collect()
}

/// The angle between the banks of a V that is searched.
pub(super) fn bank_angle(text: &str) -> PyResult<Turn> {
    let refused = |right: &dyn std::fmt::Display| told(format!("bank_angle: cannot read `{text}`: {right}"));
    let turns = parse_angle(text).map_err(|right| refused(&right))?;
    search::bank_angle(&turns).map_err(|right| refused(&right))
}

/// Orders of what repeats once a cycle: `[0.5, 1, "3/2"]`.
pub(super) fn cycle_orders(value: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<CycleOrder>> {
    all(value)?.iter().map(|text| text.parse().map_err(|error| told(format!("order `{text}`: {error}")))).collect()
}

/// What firing stars are weighed by.
pub(super) fn weights(mode_shape: Option<&Bound<'_, PyAny>>) -> PyResult<Weights> {
    Ok(deflections(mode_shape)?.map_or(Weights::Rigid, Weights::ModeShape))
}

/// The deflections of a mode shape, where one is given.
pub(super) fn deflections(mode_shape: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Vec<BigRational>>> {
    let Some(shape) = mode_shape else { return Ok(None) };
    keys::numbers(shape)?.iter().map(|text| exact("mode_shape", text)).collect::<PyResult<_>>().map(Some)
}

/// A number as it is written.
pub(super) fn exact(name: &str, text: &str) -> PyResult<BigRational> {
    parse_number(text).map_err(|error| told(format!("{name}: cannot read `{text}`: {error}")))
}

fn all(value: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<String>> {
    value.map_or_else(|| Ok(Vec::new()), keys::numbers)
}
