//! What does a file ask for above its tables? Orders, effects, the cycle, and values of its unknowns.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::Signed;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::number::parse_number;
use super::quantities::{self, misread};
use super::written::{Text, place};
use crate::engine::{Cycle, DELTA, Effects, Family, LengthUnit, ORDERS, PHI};

/// What is asked for beyond force and moment.
pub(super) fn effects(list: &[Text]) -> Result<Effects, LayoutError> {
    let mut effects = Effects::default();
    for text in list {
        match text.get_ref().0.as_str() {
            "torque" => effects.torque = true,
            "remedy" => effects.remedy = true,
            "gas" => effects.gas = true,
            "firing" => effects.firing = true,
            "torsion" => effects.torsion = true,
            _ => {
                let right = "\"torque\", \"remedy\", \"gas\", \"firing\" or \"torsion\"";
                return Err(misread(text, "effect", right));
            }
        }
    }
    Ok(effects)
}

/// The values that the file gives to its unknowns.
pub(super) fn values(
    table: &Option<BTreeMap<String, Text>>,
    unit: &mut LengthUnit,
) -> Result<BTreeMap<String, BigRational>, LayoutError> {
    let value = |(name, text): (&String, &Text)| {
        let value = if name == PHI || name == DELTA {
            quantities::known_angle(text)?
        } else {
            let length = quantities::length(text, unit)?;
            let known = length.as_known().cloned();
            known.ok_or_else(|| misread(text, "value", "a known length"))?
        };
        Ok((name.clone(), value))
    };
    table.iter().flatten().map(value).collect()
}

/// A value for what does not occur is a mistake, in the name most likely.
pub(super) fn check_values(table: &Option<BTreeMap<String, Text>>, family: &Family) -> Result<(), LayoutError> {
    let unknowns = family.unknowns();
    match table.iter().flatten().find(|(name, _)| !unknowns.contains(name.as_str())) {
        None => Ok(()),
        Some((name, text)) => {
            let known: Vec<&str> = unknowns.into_iter().collect();
            let right =
                if known.is_empty() { "it has no unknown".to_owned() } else { format!("it has {}", known.join(", ")) };
            Err(LayoutError::new(format!("the layout has no unknown `{name}`"), right, place(text)))
        }
    }
}

/// Two-stroke or four-stroke.
pub(super) fn cycle(text: &Text) -> Result<Cycle, LayoutError> {
    Cycle::of(&text.get_ref().0).ok_or_else(|| misread(text, "cycle", "\"four-stroke\" or \"two-stroke\""))
}

/// The part of the largest order from which on an order is listed separately, of its percentage.
pub(super) fn threshold(text: &Text) -> Result<BigRational, LayoutError> {
    let percent = parse_number(&text.get_ref().0).map_err(|error| misread(text, "threshold", error.to_string()))?;
    let hundred = BigRational::from_integer(100.into());
    match !percent.is_negative() && percent <= hundred {
        true => Ok(percent / hundred),
        false => Err(misread(text, "threshold", "a percentage from 0 to 100, such as 1")),
    }
}

/// The orders that are asked for, rising.
pub(super) fn orders(list: &Spanned<Vec<Text>>) -> Result<Vec<u32>, LayoutError> {
    let right = || format!("whole numbers from 1 to {}, such as [1, 2, 4, 6]", ORDERS.end());
    let mut orders = Vec::new();
    for text in list.get_ref() {
        match text.get_ref().0.parse() {
            Ok(order) if ORDERS.contains(&order) => orders.push(order),
            _ => return Err(misread(text, "order", right())),
        }
    }
    if orders.is_empty() {
        return Err(LayoutError::new("the list of orders is empty", right(), place(list)));
    }
    orders.sort_unstable();
    orders.dedup();
    Ok(orders)
}
