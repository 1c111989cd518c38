//! Which tables tell what the bearings feel? Peaks, orders, the exact vectors, the parts of a load.

use super::super::calculation::Rows;
use super::super::{residual, table, typeset};
use super::amounts;
use crate::engine::Engine;
use crate::loads::{BearingLoad, BearingLoads};
use crate::order::OrderSum;

/// The peaks of every bearing, those of the determinate approximation beside them; the worst bearing is marked.
pub fn bearings_rows(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Rows {
    let unit = amounts::unit_of(continuous);
    let place = format!("Position{}", table::position_unit(engine));
    let force = |what: &str| format!("{what} in {}", unit.name);
    let header = vec![
        "Bearing".to_owned(),
        place,
        force("Peak of R"),
        "at θ".into(),
        force("Peak of y"),
        force("Peak of x"),
        force("Determinate R"),
    ];
    let marked = |loads: &BearingLoads, index: usize| {
        let worst = if loads.worst.contains(&index) { ", worst" } else { "" };
        format!("{}{worst}", amounts::size(&loads.bearings[index].peak, unit))
    };
    let row = |(index, bearing): (usize, &BearingLoad)| {
        vec![
            (index + 1).to_string(),
            typeset::number(&bearing.position),
            marked(continuous, index),
            amounts::angle(&bearing.peak),
            amounts::size(&bearing.along, unit),
            amounts::size(&bearing.across, unit),
            marked(determinate, index),
        ]
    };
    Rows { header, rows: continuous.bearings.iter().enumerate().map(row).collect() }
}

/// The largest value of each order of each reaction: a row per bearing, a column per order.
pub fn bearings_tables(loads: &BearingLoads) -> Rows {
    let unit = amounts::unit_of(loads);
    let orders = loads.bearings.first().map_or(&[][..], |bearing| &bearing.orders);
    let header =
        ["Bearing".to_owned()].into_iter().chain(orders.iter().map(|o| format!("Order {} in {}", o.order, unit.name)));
    let row = |(index, bearing): (usize, &BearingLoad)| {
        let cells = bearing.orders.iter().map(|order| amounts::largest(&order.swing, unit));
        [(index + 1).to_string()].into_iter().chain(cells).collect()
    };
    Rows { header: header.collect(), rows: loads.bearings.iter().enumerate().map(row).collect() }
}

/// The two vectors of each order of each reaction: exact, in multiples of m r c_k, and in newtons.
pub(super) fn vectors(loads: &BearingLoads) -> Rows {
    let unit = amounts::unit_of(loads);
    let header = [
        "Order".to_owned(),
        "Bearing".into(),
        "Direct, exact".into(),
        format!("Direct in {}", unit.name),
        "Reverse, exact".into(),
        format!("Reverse in {}", unit.name),
    ];
    let count = loads.bearings.first().map_or(0, |bearing| bearing.orders.len());
    let row = |place: usize, (index, bearing): (usize, &BearingLoad)| {
        let order = &bearing.orders[place];
        let [direct, reverse] = &order.sums;
        vec![
            order.order.to_string(),
            (index + 1).to_string(),
            exact(direct),
            amounts::vector(&order.swing.direct, unit),
            exact(reverse),
            amounts::vector(&order.swing.reverse, unit),
        ]
    };
    let rows = (0..count).flat_map(|place| loads.bearings.iter().enumerate().map(move |pair| row(place, pair)));
    Rows { header: header.into(), rows: rows.collect() }
}

/// The length of a vector where all that is left of it has one coefficient.
fn exact(sum: &OrderSum) -> String {
    match sum.only() {
        Some((_, only)) => residual::modulus_of(only).prose(),
        None if sum.vanishes() => "**0**".to_owned(),
        None => "rods differ".to_owned(),
    }
}

/// The part of a unit load that each bearing carries: a row a position of a load.
pub(super) fn parts(engine: &Engine, loads: &BearingLoads) -> Rows {
    let bearings = (1..=loads.bearings.len()).map(|number| format!("Bearing {number}"));
    let header = [format!("Load at{}", table::position_unit(engine))].into_iter().chain(bearings).collect();
    let row = |(position, parts): (_, &Vec<_>)| {
        [typeset::number(position)].into_iter().chain(parts.iter().map(typeset::number)).collect()
    };
    Rows { header, rows: loads.parts.iter().rev().map(row).collect() }
}
