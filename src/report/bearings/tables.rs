//! Which tables tell what the bearings feel? Peaks, orders, the exact vectors, the parts of a load.

use std::collections::BTreeSet;

use num_traits::Zero;

use super::super::calculation::Unit;
use super::super::{calculation, residual, table};
use super::amounts;
use crate::engine::{Engine, Rod};
use crate::loads::{BearingLoads, PinLoads, left_out_of_pins};
use crate::motion::Enclosure;
use crate::order::{self, Factor, OrderSum};
use crate::page::{Number, Table, Text, phrase};

/// The peaks of every bearing, those of the determinate approximation beside them; the worst bearing is marked.
pub(in crate::report) fn peaks(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> Table {
    let unit = amounts::unit_of(continuous);
    let marked = |loads: &BearingLoads, index: usize| {
        let size = amounts::size(&loads.bearings[index].peak, unit);
        if loads.worst.contains(&index) { phrase!("{}, worst", size) } else { size }
    };
    Table::of(continuous.bearings.iter().enumerate())
        .column("Bearing", |(_, bearing)| bearing.name.clone())
        .column(table::position_heading(engine), |(_, bearing)| table::position(engine, &bearing.position))
        .column(phrase!("Peak of R in {}", unit.label()), |(index, _)| marked(continuous, *index))
        .column("at θ", |(_, bearing)| amounts::angle(&bearing.peak, unit))
        .column(phrase!("Peak of y in {}", unit.label()), |(_, bearing)| amounts::size(&bearing.along, unit))
        .column(phrase!("Peak of x in {}", unit.label()), |(_, bearing)| amounts::size(&bearing.across, unit))
        .column(phrase!("Stat. determinate R in {}", unit.label()), |(index, _)| marked(determinate, *index))
        .done()
}

/// The largest value of each order of each reaction: a row per bearing, a column per order.
pub(in crate::report) fn orders(loads: &BearingLoads) -> Table {
    let unit = amounts::unit_of(loads);
    let orders = loads.bearings.first().map_or(&[][..], |bearing| &bearing.orders);
    let heading = |order: u32| phrase!("Order {} in {}", order, unit.label());
    let mut table = Table::new([Text::from("Bearing")].into_iter().chain(orders.iter().map(|o| heading(o.order))));
    for bearing in &loads.bearings {
        let cells = bearing.orders.iter().map(|order| amounts::largest(&order.swing, unit));
        table.push([Text::from(bearing.name.clone())].into_iter().chain(cells).collect());
    }
    table
}

/// The two vectors of each order of each reaction: exact, in multiples of m r times c_k or n_k, and in newtons.
pub(super) fn vectors(loads: &BearingLoads) -> Table {
    let unit = amounts::unit_of(loads);
    let count = loads.bearings.first().map_or(0, |bearing| bearing.orders.len());
    let of_order = |place: usize| loads.bearings.iter().map(move |one| (&one.name, &one.orders[place]));
    Table::of((0..count).flat_map(of_order))
        .column("Order", |(_, order)| order.order)
        .column("Bearing", |(name, _)| name.to_string())
        .column("Direct, exact", |(_, order)| exact(&order.sums[0], order.order))
        .column(phrase!("Direct in {}", unit.label()), |(_, order)| amounts::vector(&order.swing.direct, unit))
        .column("Reverse, exact", |(_, order)| exact(&order.sums[1], order.order))
        .column(phrase!("Reverse in {}", unit.label()), |(_, order)| amounts::vector(&order.swing.reverse, unit))
        .done()
}

/// The length of each sum with what it is multiplied by, where all pistons move alike.
fn exact(sum: &OrderSum, order: u32) -> Text {
    if sum.vanishes() {
        return Text::zero();
    }
    if sum.parts().keys().any(Factor::is_decimal) {
        return "decimal only".into();
    }
    // Of an offset to the other side the side force alone is that of the same rod.
    let rods: BTreeSet<Rod> = sum.parts().keys().filter_map(Factor::rod).map(Rod::unsigned).collect();
    let symbols: Vec<(Option<char>, u32)> = sum.parts().keys().map(|factor| symbol(factor, order)).collect();
    if rods.len() > 1 || symbols.iter().collect::<BTreeSet<_>>().len() < symbols.len() {
        return "rods differ".into();
    }
    let parts = sum.parts().values().zip(symbols).map(|(sum, symbol)| {
        let length = residual::modulus_of(sum);
        match symbol {
            (None, _) => length.into(),
            (Some(letter), own) => phrase!("{} {}", length, Text::formula(format!("{letter}_{{{own}}}"))),
        }
    });
    Text::joined(parts, ", ")
}

/// The letter of what a sum is multiplied by, and the order of its own crank that is this order of the engine.
fn symbol(factor: &Factor, order: u32) -> (Option<char>, u32) {
    let (own, order) = factor.own(order);
    (own.letter(), order)
}

/// The numbers of the motion that the sums of these orders are multiplied by, where all pistons move alike and without an offset.
pub(super) fn numbers(engine: &Engine, loads: &BearingLoads) -> Option<Table> {
    let mechanisms = engine.mechanisms();
    let [mechanism] = mechanisms[..] else { return None };
    if !mechanism.is_centric() {
        return None;
    }
    let crank = order::crank(mechanism)?;
    let cell = |part: Enclosure| match (part.low == part.high, part.low.is_zero()) {
        (true, true) => Text::zero(),
        (true, false) => Number::exact(&part.low).into(),
        (false, _) => Number::Decimal(part.to_float()).into(),
    };
    let table = Table::of(loads.bearings.first().map_or(&[][..], |bearing| &bearing.orders))
        .column("Order", |order| order.order)
        .column(Text::formula("c_k".to_owned()), |order| cell(crank.coefficient(order.order).re))
        .column(Text::formula("n_k".to_owned()), |order| cell(crank.side_coefficient(order.order).re));
    Some(table.done())
}

/// The largest load of every crankpin by a rod without links, by cylinder.
pub(super) fn pins(engine: &Engine, pins: &PinLoads) -> Table {
    let unit = Unit::of_force(pins.scale.as_ref());
    let left_out = left_out_of_pins(engine, pins).unwrap_or_default();
    let others = |index: usize| match left_out.get(index) {
        None => "–".into(),
        Some(0.0) => Text::zero(),
        Some(most) => calculation::bound(*most, unit),
    };
    let rows = engine.cylinders().iter().zip(&pins.pins);
    // What a master rod and its links do to their crankpin is told of all together.
    let plain = rows.enumerate().filter(|(index, _)| engine.has_plain_rod(*index));
    Table::of(plain.map(|(index, (cylinder, pin))| (cylinder, pin, index)))
        .column("Cylinder", |(cylinder, ..)| cylinder.name.clone())
        .column(phrase!("Largest load in {}", unit.label()), |(_, pin, _)| amounts::size(&pin.peak, unit))
        .column("at θ", |(_, pin, _)| amounts::angle(&pin.peak, unit))
        .column(phrase!("Along the throw in {}", unit.label()), |(_, pin, _)| amounts::size(&pin.along, unit))
        .column(phrase!("Across it in {}", unit.label()), |(_, pin, _)| amounts::size(&pin.across, unit))
        .column(phrase!("Other orders at most in {}", unit.label()), |(.., index)| others(*index))
        .done()
}

/// The part of a unit load that each bearing carries: a row a position of a load.
pub(super) fn parts(engine: &Engine, loads: &BearingLoads) -> Table {
    let bearings = (1..=engine.bearings().len()).map(|number| phrase!("Bearing {}", number));
    let mut rows = Table::new([table::load_heading(engine)].into_iter().chain(bearings));
    for (position, parts) in loads.parts.iter().rev() {
        let cells = parts.iter().map(|part| Number::exact(part).into());
        rows.push([table::position(engine, position)].into_iter().chain(cells).collect());
    }
    rows
}
