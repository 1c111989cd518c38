//! How is a shaft that twists written? `[torsion]`: moments of inertia, stiffnesses, and where the crankpins stand.

use num_rational::BigRational;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities::{List, misread, whole};
use super::units;
use super::written::{Table, Text, place};
use crate::engine::{Cylinder, NoShaft, Torsion};

/// `[torsion]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    inertias: List,
    stiffnesses: List,
    crankpins_at: Option<List>,
}

/// The shaft of an engine with these cylinders.
pub(super) fn read(table: &Spanned<Table<Keys>>, cylinders: &[Cylinder]) -> Result<Torsion, LayoutError> {
    let keys = &table.get_ref().0;
    let pins = cylinders.iter().map(|cylinder| cylinder.pin + 1).max().unwrap_or(0);
    let at = match &keys.crankpins_at {
        None => (0..pins).collect(),
        Some(list) => list.get_ref().iter().map(disc).collect::<Result<_, _>>()?,
    };
    let torsion = Torsion {
        inertias: each(&keys.inertias, "moment of inertia", units::inertia)?,
        stiffnesses: each(&keys.stiffnesses, "stiffness", units::torsional_stiffness)?,
        pins: at,
    };
    let span = |why: &NoShaft| match why {
        NoShaft::Discs(_) => place(&keys.inertias),
        NoShaft::Stiffnesses { .. } => place(&keys.stiffnesses),
        NoShaft::NotPositive("stiffness", index) => place(&keys.stiffnesses.get_ref()[index - 1]),
        NoShaft::NotPositive(_, index) => place(&keys.inertias.get_ref()[index - 1]),
        NoShaft::Pins { .. } | NoShaft::NoSuchDisc { .. } => {
            keys.crankpins_at.as_ref().map_or_else(|| place(&keys.inertias), place)
        }
    };
    match torsion.check(pins) {
        Ok(()) => Ok(torsion),
        Err(why) => {
            let right = "inertias = one per disc from the free end on, stiffnesses = one between each two, crankpins_at = the disc of each \
                         crankpin, [1, 2, …] by default";
            Err(LayoutError::new(why.to_string(), right, span(&why)))
        }
    }
}

/// The number of a disc, from 1 in the file.
fn disc(text: &Text) -> Result<usize, LayoutError> {
    Ok(whole(text, "number of the disc")? as usize - 1)
}

fn each(
    list: &List,
    what: &'static str,
    unit: fn(&str) -> Result<BigRational, String>,
) -> Result<Vec<BigRational>, LayoutError> {
    let value = |text: &Text| {
        let written = &text.get_ref().0;
        unit(written).map_err(|right| misread(what, written, right, text))
    };
    list.get_ref().iter().map(value).collect()
}
