//! Which tables tell the complete loads? Bearings, crankpins, rods, orders.

use super::super::table;
use super::super::torque::{angle, names};
use crate::engine::Engine;
use crate::journal::{CycleBearings, CycleLoads, CyclePeak};
use crate::page::{Table, Text, Unit, phrase};
use crate::torque::Extreme;

/// A force in newtons: 0 where nothing loads.
fn size(value: f64) -> Text {
    if value == 0.0 { Text::zero() } else { Text::measured(value, Unit::NEWTON) }
}

/// Where a load is largest; nowhere, where nothing loads.
fn at_peak(peak: &CyclePeak) -> Text {
    if peak.value == 0.0 { "–".into() } else { angle(peak.angle) }
}

/// The largest load of every bearing, with and without gas; the worst are marked.
pub(super) fn bearings(engine: &Engine, [continuous, determinate]: &[CycleBearings; 2]) -> Table {
    let marked = |bearings: &CycleBearings, index: usize| {
        let size = size(bearings.bearings[index].peak.value);
        if bearings.worst.contains(&index) { phrase!("{}, worst", size) } else { size }
    };
    Table::of(continuous.bearings.iter().enumerate())
        .column("Bearing", |(_, bearing)| bearing.name.clone())
        .column(table::position_heading(engine), |(_, bearing)| table::position(engine, &bearing.position))
        .column(phrase!("Largest load in {}", Unit::NEWTON), |(index, _)| marked(continuous, *index))
        .column("at θ", |(_, bearing)| at_peak(&bearing.peak))
        .column(phrase!("Gas component in {}", Unit::NEWTON), |(_, bearing)| size(bearing.peak.gas_along()))
        .column(phrase!("Without gas in {}", Unit::NEWTON), |(_, bearing)| size(bearing.inertia.value))
        .column(phrase!("Statically determinate in {}", Unit::NEWTON), |(index, _)| marked(determinate, *index))
        .done()
}

/// The largest load of every crankpin by a rod without links, with and without gas.
pub(super) fn pins(engine: &Engine, loads: &CycleLoads) -> Table {
    // What a master rod and its links do to their crankpin is told of all together.
    let all = loads.cylinders.iter().map(|cylinder| &cylinder.peaks).enumerate();
    Table::of(all.filter(|(index, _)| engine.has_plain_rod(*index)))
        .column("Cylinder", |(index, _)| names(engine, &[*index]))
        .column(phrase!("Load of the crankpin in {}", Unit::NEWTON), |(_, peaks)| size(peaks.pin.value))
        .column("at θ", |(_, peaks)| at_peak(&peaks.pin))
        .column(phrase!("Gas component in {}", Unit::NEWTON), |(_, peaks)| size(peaks.pin.gas_along()))
        .column(phrase!("Without gas in {}", Unit::NEWTON), |(_, peaks)| size(peaks.pin_of_inertia.value))
        .done()
}

/// The load of every crankpin that rods share, and that of the rod that loads it the most.
pub(super) fn shared_pins(engine: &Engine, loads: &CycleLoads) -> Table {
    let has_plain = loads.shared_pins.iter().any(|pin| pin.largest_of_a_rod(loads).is_some());
    Table::of(&loads.shared_pins)
        .column("Crankpin", |pin| pin.throw + 1)
        .column("Cylinders", |pin| names(engine, &pin.cylinders))
        .column(phrase!("All together in {}", Unit::NEWTON), |pin| size(pin.peak.value))
        .column("at θ", |pin| at_peak(&pin.peak))
        .column(phrase!("Gas component in {}", Unit::NEWTON), |pin| size(pin.peak.gas_along()))
        .column(phrase!("Without gas in {}", Unit::NEWTON), |pin| size(pin.inertia.value))
        .column_if(has_plain, phrase!("One alone in {}", Unit::NEWTON), |pin| -> Text {
            let of_one = pin.largest_of_a_rod(loads);
            of_one.map_or_else(Text::default, |(index, peak)| {
                phrase!("{} (cylinder {})", size(peak.value), names(engine, &[index]))
            })
        })
        .done()
}

/// The largest load of the knuckle pin of every link, with and without gas.
pub(super) fn knuckles(engine: &Engine, loads: &CycleLoads) -> Table {
    Table::of(&loads.knuckles)
        .column("Link of cylinder", |knuckle| names(engine, &[knuckle.cylinder]))
        .column("Master rod", |knuckle| names(engine, &[knuckle.master]))
        .column(phrase!("Load of the knuckle pin in {}", Unit::NEWTON), |knuckle| size(knuckle.peak.value))
        .column("at θ", |knuckle| at_peak(&knuckle.peak))
        .column(phrase!("Gas component in {}", Unit::NEWTON), |knuckle| size(knuckle.peak.gas_along()))
        .column(phrase!("Without gas in {}", Unit::NEWTON), |knuckle| size(knuckle.inertia.value))
        .done()
}

/// How far every rod is pressed and pulled, what its bolts bear, and the side force of its piston.
pub(super) fn rods(engine: &Engine, loads: &CycleLoads) -> Table {
    // What never is says nothing of an angle.
    let force = |one: Extreme| if one.value > 0.0 { size(one.value) } else { Text::zero() };
    let at = |one: Extreme| if one.value > 0.0 { angle(one.angle) } else { "–".into() };
    let pulled = |[_, stretched]: [Extreme; 2]| Extreme { value: -stretched.value, ..stretched };
    Table::of(loads.cylinders.iter().map(|cylinder| &cylinder.peaks).enumerate())
        .column("Cylinder", |(index, _)| names(engine, &[*index]))
        .column(phrase!("Rod compression in {}", Unit::NEWTON), |(_, peaks)| force(peaks.rod[0]))
        .column("at θ", |(_, peaks)| at(peaks.rod[0]))
        .column(phrase!("Rod tension in {}", Unit::NEWTON), |(_, peaks)| force(pulled(peaks.rod)))
        .column("at θ", |(_, peaks)| at(pulled(peaks.rod)))
        .column(phrase!("Big-end tension in {}", Unit::NEWTON), |(_, peaks)| force(peaks.pull))
        .column(phrase!("Side force in {}", Unit::NEWTON), |(_, peaks)| {
            let [left, right] = peaks.side;
            size(left.value.max(-right.value))
        })
        .done()
}

/// The largest value of each order of each bearing: a row an order, a column a bearing.
pub(super) fn orders(bearings: &CycleBearings) -> Table {
    let named = bearings.bearings.iter().map(|bearing| bearing.name.clone());
    let heads = named.map(|name| phrase!("Bearing {} in {}", name, Unit::NEWTON));
    let mut table = Table::new([Text::from("Order κ")].into_iter().chain(heads));
    let row = |name: Text, cells: &mut dyn Iterator<Item = Text>| [name].into_iter().chain(cells).collect();
    let means = bearings.bearings.iter().map(|bearing| &bearing.series.mean);
    let mut means = means.map(|mean| if mean.vanishes { Text::zero() } else { size(mean.total().norm()) });
    table.push(row("mean".into(), &mut means));
    let count = bearings.bearings.first().map_or(0, |bearing| bearing.series.orders.len());
    for place in 0..count {
        let orders = bearings.bearings.iter().map(|bearing| &bearing.series.orders[place]);
        let name = Text::label(bearings.bearings[0].series.orders[place].order.to_string());
        let mut cells = orders.map(|order| if order.vanishes() { Text::zero() } else { size(order.largest()) });
        table.push(row(name, &mut cells));
    }
    table
}
