//! Which tables tell what the best crankshafts are? The front, their counterweights, and uniform balance factors beside them.

use num_rational::BigRational;

use super::amounts::{self, Units};
use crate::engine::{Engine, LengthUnit};
use crate::optimise::{Front, Place};
use crate::page::number::{given, given_with};
use crate::page::{Table, Text, Unit, phrase};

/// The front: a row a point.
pub(super) fn points(layout: &Engine, front: &Front) -> Table {
    let units = Units::of(layout, front);
    let mut table = Table::new([
        "Point",
        "Crankshaft mass",
        "Largest bearing load",
        "Bearing",
        "Above the least possible",
        "Order 1 force",
        "Order 1 couple",
    ]);
    for (index, point) in front.points.iter().enumerate() {
        table.push(vec![
            (index + 1).into(),
            amounts::kilograms(&point.design.mass),
            amounts::load(&point.design, units),
            amounts::worst(&point.design),
            amounts::within(point),
            amounts::left(point.design.force, units.force),
            amounts::left(point.design.couple, units.couple),
        ]);
    }
    table
}

/// Uniform balance factors with the best crankshaft of the same mass beside each; none where a throw has no counterweights.
pub(super) fn compared(layout: &Engine, front: &Front) -> Option<Table> {
    let units = Units::of(layout, front);
    let mut table = Table::new([
        "One balance factor",
        "Crankshaft mass",
        "Largest bearing load",
        "Order 1 couple",
        "Best at that mass",
        "Lightest with that load",
    ]);
    for uniform in &front.uniform {
        table.push(vec![
            given(&uniform.factor),
            amounts::kilograms(&uniform.design.mass),
            amounts::load(&uniform.design, units),
            amounts::left(uniform.design.couple, units.couple),
            uniform.best.as_ref().map_or_else(
                || "none so light".into(),
                |best| {
                    let load = amounts::load(&best.design, units);
                    match amounts::less(&best.design, &uniform.design) {
                        Some(less) => phrase!("{}, {} less", load, less),
                        None => load,
                    }
                },
            ),
            uniform.lightest.as_ref().map_or_else(|| "none".into(), |point| amounts::kilograms(&point.design.mass)),
        ]);
    }
    (!table.rows.is_empty()).then_some(table)
}

/// The counterweights of each point: their balance factor and skew, by plane.
pub(super) fn weights(layout: &Engine, front: &Front) -> Table {
    let place = |place: &Place| {
        let thousand = BigRational::from_integer(1000.into());
        match (layout.length_unit(), place.throw) {
            (LengthUnit::Metre, Some(throw)) => {
                phrase!("Throw {}, z = {}", throw + 1, given_with(&(&place.position * thousand), Unit::MILLIMETRE))
            }
            (LengthUnit::Metre, None) => phrase!("z = {}", given_with(&(&place.position * thousand), Unit::MILLIMETRE)),
            (LengthUnit::Spacing, Some(throw)) => {
                phrase!("Throw {}, z = {}", throw + 1, given(&place.position))
            }
            (LengthUnit::Spacing, None) => phrase!("z = {}", given(&place.position)),
        }
    };
    let mut table = Table::new([Text::from("Point")].into_iter().chain(front.places.iter().map(place)));
    for (index, point) in front.points.iter().enumerate() {
        let cells = point.design.weights.iter().map(amounts::weight);
        table.push([Text::from(index + 1)].into_iter().chain(cells).collect());
    }
    table
}
