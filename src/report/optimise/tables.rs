//! Which tables tell what the best crankshafts are? The front, their counterweights, and uniform balance factors beside them.

use num_rational::BigRational;

use super::amounts::{self, Units};
use crate::engine::{Engine, LengthUnit};
use crate::optimise::{Front, Place};
use crate::page::{Number, Table, Text, phrase};

/// The front: a row a point.
pub(super) fn points(layout: &Engine, front: &Front) -> Table {
    let units = Units::of(layout, front);
    let mut table = Table::new([
        "Point",
        "Crankshaft mass",
        "Largest bearing load",
        "Bearing",
        "Above the least possible",
        "First-order force",
        "First-order couple",
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
        "First-order couple",
        "Best load at that mass",
        "Less by",
        "Its couple",
        "Least mass with that load",
        "Its couple",
    ]);
    for uniform in &front.uniform {
        let best = match &uniform.best {
            None => ["none so light".into(), "–".into(), "–".into()],
            Some(best) => [
                amounts::load(&best.design, units),
                amounts::less(&best.design, &uniform.design),
                amounts::left(best.design.couple, units.couple),
            ],
        };
        let lightest = match &uniform.lightest {
            None => ["none".into(), "–".into()],
            Some(lightest) => {
                [amounts::kilograms(&lightest.design.mass), amounts::left(lightest.design.couple, units.couple)]
            }
        };
        let first = [
            Text::from(Number::exact(&uniform.factor)),
            amounts::kilograms(&uniform.design.mass),
            amounts::load(&uniform.design, units),
            amounts::left(uniform.design.couple, units.couple),
        ];
        table.push(first.into_iter().chain(best).chain(lightest).collect());
    }
    (!table.rows.is_empty()).then_some(table)
}

/// The counterweights of each point: their balance factor and skew, by plane.
pub(super) fn weights(layout: &Engine, front: &Front) -> Table {
    let place = |place: &Place| {
        let thousand = BigRational::from_integer(1000.into());
        match (layout.length_unit(), place.throw) {
            (LengthUnit::Metre, Some(throw)) => {
                phrase!("Throw {}, z = {} mm", throw + 1, Number::exact(&(&place.position * thousand)))
            }
            (LengthUnit::Metre, None) => phrase!("z = {} mm", Number::exact(&(&place.position * thousand))),
            (LengthUnit::Spacing, Some(throw)) => {
                phrase!("Throw {}, z = {}", throw + 1, Number::exact(&place.position))
            }
            (LengthUnit::Spacing, None) => phrase!("z = {}", Number::exact(&place.position)),
        }
    };
    let mut table = Table::new([Text::from("Point")].into_iter().chain(front.places.iter().map(place)));
    for (index, point) in front.points.iter().enumerate() {
        let cells = point.design.weights.iter().map(amounts::weight);
        table.push([Text::from(index + 1)].into_iter().chain(cells).collect());
    }
    table
}
