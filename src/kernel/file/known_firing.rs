//! When does an engine fire whose angles are known, by its order, its angles, or as a two-stroke?

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::contradiction;
use super::error::LayoutError;
use super::firing_order;
use super::shared_keys::SharedKeys;
use super::written::place;
use crate::engine::{Cycle, Cylinder, Engine, Firing};

/// The firings of the engine; none where the file says nothing of them and has several cylinders.
///
/// # Errors
/// What the throws cannot fire, with what would fit.
pub(super) fn read(
    above: &SharedKeys<'_>,
    values: &BTreeMap<String, BigRational>,
    engine: &Engine,
) -> Result<Option<Firing>, LayoutError> {
    let cylinders = engine.cylinders();
    let Some(cycle) = above.cycle else { return firing_order::without_cycle(above.order, above.angles).map(|()| None) };
    match (above.order, above.angles) {
        (None, None) if cycle == Cycle::TwoStroke => Ok(Some(Firing::two_stroke(cylinders))),
        (None, None) => Ok((cylinders.len() == 1).then(|| Firing::from_order(&[0], cycle, cylinders).ok()).flatten()),
        (Some(order), None) => {
            let indices = order.get_ref().indices(cylinders, place(order))?;
            let fits = |others: &[Cylinder]| {
                let indices = order.get_ref().indices(others, None).ok()?;
                Firing::from_order(&indices, cycle, others).ok()
            };
            let fired = Firing::from_order(&indices, cycle, cylinders).map(Some);
            fired.map_err(|said| contradiction::of_order(said, engine, &indices, cycle, place(order), fits))
        }
        (None, Some(list)) => {
            let angle = |text| firing_order::known_angle(text, values);
            let angles = list.get_ref().iter().map(angle).collect::<Result<Vec<_>, _>>()?;
            let fits = |others: &[Cylinder]| Firing::from_angles(&angles, cycle, others).ok();
            let fired = Firing::from_angles(&angles, cycle, cylinders).map(Some);
            fired.map_err(|said| contradiction::of_angles(said, engine, place(list), fits))
        }
        (Some(_), Some(list)) => Err(firing_order::both_given(list)),
    }
}
