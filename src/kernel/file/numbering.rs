//! Which cylinder has which number? Bank after bank, pin after pin, or as the list of a book says.

use std::collections::BTreeMap;

use super::error::LayoutError;
use super::quantities::{choice, misread};
use super::written::{Column, Text, Values, place};
use crate::engine::{Cylinder, Linear};

/// In which order the cylinders of several banks stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Along {
    /// Bank 1 from the free end, then bank 2.
    Banks,
    /// The cylinders of pin 1, then those of pin 2.
    Pins,
}

const WORDS: [(&str, Along); 4] =
    [("per bank", Along::Banks), ("by-bank", Along::Banks), ("alternating", Along::Pins), ("by-pin", Along::Pins)];

/// What the key `numbering` says of the order; a list names the cylinders bank after bank.
pub(super) fn along(numbering: Option<&Column>) -> Result<Along, LayoutError> {
    let Some(numbering) = numbering else { return Ok(Along::Banks) };
    match numbering.get_ref() {
        Values::Each(_) => Ok(Along::Banks),
        Values::One(text) => {
            let right = "\"per bank\" or \"alternating\" (also \"by-bank\" or \"by-pin\"), or a list";
            choice(&Text::new(numbering.span(), text.clone()), "numbering", right, &WORDS)
        }
    }
}

/// The narrow V and the throw of each cylinder of an engine with narrow banks, in the order in which they are numbered; a list
/// names them along the crankshaft, one V after the other.
pub(super) fn along_narrow(
    numbering: Option<&Column>,
    vees: usize,
    throws: usize,
) -> Result<Vec<(usize, usize)>, LayoutError> {
    let mut all: Vec<(usize, usize)> = (0..vees).flat_map(|vee| (0..throws).map(move |throw| (vee, throw))).collect();
    let Some(numbering) = numbering else { return Ok(all) };
    if let Values::One(text) = numbering.get_ref() {
        match text.0.as_str() {
            "along the shaft" => {}
            // The banks of a narrow V take turns along its throws.
            "per bank" => all.sort_by_key(|&(vee, throw)| (vee, throw % 2, throw)),
            "alternating" => all.sort_by_key(|&(vee, throw)| (throw, vee)),
            _ => {
                let right = "\"along the shaft\", \"per bank\" or \"alternating\", or a list";
                let text = Text::new(numbering.span(), text.clone());
                return Err(misread(&text, "numbering", right));
            }
        }
    }
    Ok(all)
}

/// Names the cylinders as the list says, bank after bank from the free end.
pub(super) fn name(
    mut cylinders: Vec<Cylinder<Linear, Linear>>,
    numbering: Option<&Column>,
) -> Result<Vec<Cylinder<Linear, Linear>>, LayoutError> {
    let Some((column, list)) = numbering.and_then(|column| match column.get_ref() {
        Values::One(_) => None,
        Values::Each(list) => Some((column, list)),
    }) else {
        return Ok(cylinders);
    };
    if list.len() != cylinders.len() {
        let message = format!("a numbering of {} for {} cylinders", list.len(), cylinders.len());
        let right = "the name of each cylinder, bank after bank from the free end, such as [1, 3, 5, 2, 4, 6]";
        return Err(LayoutError::new(message, right, place(column)));
    }
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for (index, (cylinder, text)) in cylinders.iter_mut().zip(list).enumerate() {
        cylinder.name = cylinder_name(text)?;
        if let Some(first) = seen.insert(cylinder.name.clone(), index) {
            let message = format!("the numbering has `{}` at places {} and {}", cylinder.name, first + 1, index + 1);
            return Err(LayoutError::new(message, "every cylinder needs a name of its own", place(text)));
        }
    }
    Ok(cylinders)
}

/// In which order the cylinders stand: that of their numbers, where a list numbers all of them, else as they are.
pub(super) fn in_order(cylinders: &[Cylinder<Linear, Linear>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..cylinders.len()).collect();
    if cylinders.iter().all(|cylinder| number(cylinder).is_some()) {
        order.sort_by_key(|&index| number(&cylinders[index]));
    }
    order
}

fn number<A, L>(cylinder: &Cylinder<A, L>) -> Option<u32> {
    cylinder.name.parse().ok()
}

/// The name of a cylinder.
pub(super) fn cylinder_name(text: &Text) -> Result<String, LayoutError> {
    let name = &text.get_ref().0;
    let fits = (1..=6).contains(&name.len()) && name.bytes().all(|byte| byte.is_ascii_alphanumeric());
    let right = "one to six letters (A to Z, a to z) or digits, such as \"L2\"";
    if fits { Ok(name.clone()) } else { Err(misread(text, "name", right)) }
}

/// The same cylinders numbered 1, 2, 3, … along their banks, or along their pins; none where they are so already, or where a
/// bank or a pin lacks a cylinder.
pub(super) fn renumbered<A: Clone + PartialEq, L: Clone>(
    cylinders: &[Cylinder<A, L>],
    along: Along,
) -> Option<Vec<Cylinder<A, L>>> {
    let mut banks: Vec<&A> = Vec::new();
    for cylinder in cylinders {
        if !banks.contains(&&cylinder.bank) {
            banks.push(&cylinder.bank);
        }
    }
    let mut places: BTreeMap<(usize, usize), &Cylinder<A, L>> = BTreeMap::new();
    for cylinder in cylinders {
        let bank = banks.iter().position(|bank| **bank == cylinder.bank)?;
        let at = match along {
            Along::Banks => (bank, cylinder.pin),
            Along::Pins => (cylinder.pin, bank),
        };
        places.insert(at, cylinder);
    }
    let pins = cylinders.iter().map(|cylinder| cylinder.pin).max()? + 1;
    let in_order: Vec<&Cylinder<A, L>> = places.into_values().collect();
    if in_order.len() != cylinders.len() || banks.len() * pins != cylinders.len() {
        return None;
    }
    let name = |index: usize| (index + 1).to_string();
    let same = |(index, cylinder): (usize, &&Cylinder<A, L>)| cylinder.name == name(index);
    if in_order.iter().enumerate().all(same) {
        return None;
    }
    let numbered = |(index, cylinder): (usize, &Cylinder<A, L>)| Cylinder { name: name(index), ..cylinder.clone() };
    Some(in_order.into_iter().enumerate().map(numbered).collect())
}
