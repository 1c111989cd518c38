//! Which tables tell the complete loads? Bearings, crankpins, rods, orders.

use super::super::table;
use super::super::torque::{angle, names};
use crate::engine::Engine;
use crate::journal::{CycleBearings, CycleLoads};
use crate::page::{Table, Text, Unit, phrase};
use crate::torque::Extreme;

/// A force in newtons: 0 where nothing loads.
fn size(value: f64) -> Text {
    if value == 0.0 { Text::zero() } else { Text::measured(value, Unit::NEWTON) }
}

/// The largest load of every bearing, with and without gas; the worst is marked.
pub(super) fn bearings(engine: &Engine, [continuous, determinate]: &[CycleBearings; 2]) -> Table {
    let mut rows = Table::new([
        "Bearing".into(),
        table::position_heading(engine),
        phrase!("Largest load in {}", Unit::NEWTON),
        "at θ".into(),
        phrase!("Gas in it in {}", Unit::NEWTON),
        phrase!("Without gas in {}", Unit::NEWTON),
        phrase!("Determinate in {}", Unit::NEWTON),
    ]);
    let marked = |bearings: &CycleBearings, index: usize| {
        let size = size(bearings.bearings[index].peak.value);
        if bearings.worst == index { phrase!("{}, worst", size) } else { size }
    };
    for (index, bearing) in continuous.bearings.iter().enumerate() {
        rows.push(vec![
            (index + 1).into(),
            table::position(engine, &bearing.position),
            marked(continuous, index),
            angle(bearing.peak.angle),
            size(bearing.peak.gas_along()),
            size(bearing.inertia.value),
            marked(determinate, index),
        ]);
    }
    rows
}

fn name(engine: &Engine, index: usize) -> Text {
    Text::label(engine.cylinders()[index].name.clone())
}

/// The largest load of every crankpin, with and without gas.
pub(super) fn pins(engine: &Engine, loads: &CycleLoads) -> Table {
    let header: [Text; 5] = [
        "Cylinder".into(),
        phrase!("Load of the crankpin in {}", Unit::NEWTON),
        "at θ".into(),
        phrase!("Gas in it in {}", Unit::NEWTON),
        phrase!("Without gas in {}", Unit::NEWTON),
    ];
    let mut rows = Table::new(header);
    for (index, cylinder) in loads.cylinders.iter().enumerate() {
        let peaks = &cylinder.peaks;
        rows.push(vec![
            name(engine, index),
            size(peaks.pin.value),
            angle(peaks.pin.angle),
            size(peaks.pin.gas_along()),
            size(peaks.pin_of_inertia.value),
        ]);
    }
    rows
}

/// The load of every crankpin that rods share, and that of the rod that loads it the most.
pub(super) fn shared_pins(engine: &Engine, loads: &CycleLoads) -> Table {
    let mut rows = Table::new([
        Text::from("Crankpin"),
        Text::from("Rods of cylinders"),
        phrase!("All rods together in {}", Unit::NEWTON),
        Text::from("at θ"),
        phrase!("Gas in it in {}", Unit::NEWTON),
        phrase!("Without gas in {}", Unit::NEWTON),
        phrase!("One rod alone in {}", Unit::NEWTON),
    ]);
    for pin in &loads.shared_pins {
        let of_one = pin.largest_of_a_rod(loads);
        let one = of_one.map(|(index, peak)| phrase!("{} (cylinder {})", size(peak.value), name(engine, index)));
        rows.push(vec![
            (pin.throw + 1).into(),
            names(engine, &pin.cylinders),
            size(pin.peak.value),
            angle(pin.peak.angle),
            size(pin.peak.gas_along()),
            size(pin.inertia.value),
            one.unwrap_or_default(),
        ]);
    }
    rows
}

/// How far every rod is pressed and pulled, what its bolts bear, and the side force of its piston.
pub(super) fn rods(engine: &Engine, loads: &CycleLoads) -> Table {
    let mut rows = Table::new([
        Text::from("Cylinder"),
        phrase!("Rod pressed with {}", Unit::NEWTON),
        "at θ".into(),
        phrase!("pulled with {}", Unit::NEWTON),
        "at θ".into(),
        phrase!("Big end pulls with {}", Unit::NEWTON),
        phrase!("Side force in {}", Unit::NEWTON),
    ]);
    // What never is says nothing of an angle.
    let pair = |one: Extreme| match one.value > 0.0 {
        true => [size(one.value), angle(one.angle)],
        false => [Text::zero(), "–".into()],
    };
    for (index, cylinder) in loads.cylinders.iter().enumerate() {
        let peaks = &cylinder.peaks;
        let [pressed, stretched] = peaks.rod;
        let pulled = Extreme { value: -stretched.value, ..stretched };
        let [left, right] = peaks.side;
        let side = size(left.value.max(-right.value));
        let [big_end, _] = pair(peaks.pull);
        let cells = [pair(pressed), pair(pulled)].into_iter().flatten().chain([big_end, side]);
        rows.push([name(engine, index)].into_iter().chain(cells).collect());
    }
    rows
}

/// The largest value of each order of each bearing: a row an order, a column a bearing.
pub(super) fn orders(bearings: &CycleBearings) -> Table {
    let heads = (1..=bearings.bearings.len()).map(|number| phrase!("Bearing {} in {}", number, Unit::NEWTON));
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
