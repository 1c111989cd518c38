//! Where do the main bearings stand? What the key `bearings` says: positions along the shaft, two or more.

use std::collections::BTreeMap;

use num_rational::BigRational;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities::{self, List, misread};
use super::written::{Text, place};
use crate::engine::{Engine, LengthUnit};
use crate::text::counted;

/// The most bearings that are read: 100 spans.
const MOST_BEARINGS: usize = 101;

/// The positions, in the order of the file, by the rules of the cylinders' positions.
///
/// `positions_given` says whether the file tells where the cylinders stand: where it does not, they are one spacing
/// apart, and a bearing in metres has no place among them.
pub(super) fn read(list: &List, unit: &mut LengthUnit, positions_given: bool) -> Result<Vec<BigRational>, LayoutError> {
    let texts = list.get_ref();
    if !(2..=MOST_BEARINGS).contains(&texts.len()) {
        let message = counted(texts.len(), "main bearing");
        return Err(LayoutError::new(message, format!("a shaft lies in 2 to {MOST_BEARINGS}"), place(list)));
    }
    let mut places: BTreeMap<BigRational, usize> = BTreeMap::new();
    let mut positions = Vec::new();
    for (index, text) in texts.iter().enumerate() {
        let position = position(text, unit, positions_given)?;
        if let Some(first) = places.insert(position.clone(), index) {
            let at = quantities::shown_position(&position, *unit);
            let message = format!("main bearings {} and {} are both at {at}", first + 1, index + 1);
            return Err(LayoutError::new(message, "each needs a position of its own", place(text)));
        }
        positions.push(position);
    }
    Ok(positions)
}

fn position(text: &Text, unit: &mut LengthUnit, positions_given: bool) -> Result<BigRational, LayoutError> {
    let mut own = LengthUnit::Spacing;
    let length = quantities::length(text, &mut own)?;
    let Some(known) = length.as_known() else {
        return Err(misread(text, "position", "a bearing is at a known length"));
    };
    if own == LengthUnit::Metre {
        if !positions_given {
            let message = "a main bearing in metres, but the cylinders are in multiples of their spacing";
            return Err(LayoutError::new(message, "add the spacing or the positions of the cylinders", place(text)));
        }
        *unit = own;
    }
    Ok(known.clone())
}

/// Every bearing is on the crankshaft, where the file says how long that is.
pub(super) fn check_ends(list: Option<&List>, layout: &Engine) -> Result<(), LayoutError> {
    let (Some(list), Some([low, high])) = (list, layout.shaft_ends()) else { return Ok(()) };
    for (index, (at, text)) in layout.bearings().iter().zip(list.get_ref()).enumerate() {
        if *at < low || *at > high {
            let [at, low, high] = [at, &low, &high].map(|at| quantities::shown_position(at, layout.length_unit()));
            let message = format!("main bearing {} at {at} is beyond the crankshaft", index + 1);
            return Err(LayoutError::new(message, format!("the shaft reaches from {low} to {high}"), place(text)));
        }
    }
    Ok(())
}

/// Bearings of a layout that leaves an angle or a position open.
pub(super) fn of_open_layout<T>(list: &Spanned<T>) -> LayoutError {
    LayoutError::new(
        "the loads of main bearings cannot be computed while an angle or position is open",
        "give the unknowns values, or leave the bearings out",
        place(list),
    )
}
