//! Which tables tell what the best crankshafts are? The front, their counterweights, and uniform balance factors beside them.

use num_rational::BigRational;

use super::amounts::{self, Units};
use crate::engine::{Engine, LengthUnit};
use crate::optimise::{Front, Place, Uniform};
use crate::page::number::{given, given_with};
use crate::page::{Table, Unit, phrase};

/// The front: a row a point.
pub(super) fn points(layout: &Engine, front: &Front) -> Table {
    let units = Units::of(layout, front);
    Table::of(front.points.iter().enumerate())
        .column("Point", |(index, _)| index + 1)
        .column("Crankshaft mass", |(_, point)| amounts::kilograms(&point.design.mass))
        .column("Largest bearing load", |(_, point)| amounts::load(&point.design, units))
        .column("Bearing", |(_, point)| amounts::worst(&point.design))
        .column("Above the least possible", |(_, point)| amounts::within(point))
        .column("Order 1 force with the crank", |(_, point)| amounts::left(point.design.force, units.force))
        .column("Order 1 couple with the crank", |(_, point)| amounts::left(point.design.couple, units.couple))
        .done()
}

/// Uniform balance factors with the best crankshaft of the same mass beside each; none where a throw has no counterweights.
pub(super) fn compared(layout: &Engine, front: &Front) -> Option<Table> {
    let units = Units::of(layout, front);
    let best = |uniform: &Uniform| {
        let Some(best) = &uniform.best else { return "none so light".into() };
        let load = amounts::load(&best.design, units);
        match amounts::less(&best.design, &uniform.design) {
            Some(less) => phrase!("{}, {} less", load, less),
            None => load,
        }
    };
    Table::of(&front.uniform)
        .column("One balance factor", |uniform| given(&uniform.factor))
        .column("Crankshaft mass", |uniform| amounts::kilograms(&uniform.design.mass))
        .column("Largest bearing load", |uniform| amounts::load(&uniform.design, units))
        .column("Order 1 force with the crank", |uniform| amounts::left(uniform.design.force, units.force))
        .column("Order 1 couple with the crank", |uniform| amounts::left(uniform.design.couple, units.couple))
        .column("Best at that mass", |uniform| best(uniform))
        .column("Lightest with that load", |uniform| match &uniform.lightest {
            Some(point) => amounts::kilograms(&point.design.mass),
            None => "none".into(),
        })
        .done_if_any()
}

/// The counterweights of each point: their balance factor and skew, by plane.
pub(super) fn weights(layout: &Engine, front: &Front) -> Table {
    let place = |place: &Place| {
        let thousand = BigRational::from_integer(1000.into());
        let at = match layout.length_unit() {
            LengthUnit::Metre => given_with(&(&place.position * thousand), Unit::MILLIMETRE),
            LengthUnit::Spacing => given(&place.position),
        };
        match place.throw {
            Some(throw) => phrase!("Throw {}, z = {}", throw + 1, at),
            None => phrase!("z = {}", at),
        }
    };
    let table = Table::of(front.points.iter().enumerate()).column("Point", |(index, _)| index + 1);
    let with_places = front.places.iter().enumerate().fold(table, |table, (at, heading)| {
        table.column(place(heading), |(_, point)| point.design.weights.get(at).map(amounts::weight).unwrap_or_default())
    });
    with_places.done()
}
