//! Which columns hold what bearings, pins and rods feel of gas and masses together, through the whole cycle?

use num_complex::Complex;

use super::columns::{components, crankshafts, position_unit};
use crate::engine::Engine;
use crate::journal::{CycleBearing, CycleBearings, CycleLoads, CyclePeak, CylinderLoads, JournalOrder};
use crate::report::data::{Filling, exact_number};
use crate::table::{Table, Unit};
use crate::text::Untrusted;
use crate::torque::Extreme;

/// A table of the complete loads, in newtons.
pub(super) fn table(engine: &Engine, loads: &CycleLoads, name: &str) -> Option<Table> {
    Some(match name {
        "gas_bearings" => of_bearings(engine, loads),
        "gas_cylinders" => of_cylinders(engine, loads),
        "gas_knuckles" => of_knuckles(engine, loads)?,
        "gas_pins" => shared_pins(engine, loads),
        "gas_orders" => orders(loads),
        "gas_pin_orders" => pin_orders(engine, loads),
        "gas_theta" => theta(loads)?,
        _ => return None,
    })
}

/// Both ways to share a load, by their names in tables; none without bearings.
fn methods(loads: &CycleLoads) -> impl Iterator<Item = (&'static str, &CycleBearings)> {
    let both = loads.bearings.iter().flatten();
    ["continuous", "determinate"].into_iter().zip(both)
}

fn of_bearings(engine: &Engine, loads: &CycleLoads) -> Table {
    let rows = methods(loads).flat_map(|(method, all)| {
        let missed = loads.missed(all);
        all.bearings.iter().enumerate().map(move |(index, bearing)| (method, index, all, missed, bearing))
    });
    let mut table = Filling::new("bearings.gas_bearings", rows).keyed(2);
    table.words("method", |row| Some(row.0.to_owned()));
    table.whole("bearing", |row| row.1 + 1);
    crankshafts(&mut table, engine, |row| row.4.crank);
    table.exact("position_{unit}", position_unit(engine), |row| Some(exact_number(&row.4.position)));
    with_and_without_gas(&mut table, |row| [&row.4.peak, &row.4.inertia]);
    let mean = |bearing: &CycleBearing| bearing.series.mean.total();
    table.decimal("mean_y_{unit}", Unit::NEWTON, |row| Some(mean(row.4).re));
    table.decimal("mean_x_{unit}", Unit::NEWTON, |row| Some(0.0 - mean(row.4).im));
    table.truth("worst", |row| Some(row.2.worst.contains(&row.1)));
    table.decimal("missed_{unit}", Unit::NEWTON, |row| Some(row.3));
    table.done()
}

const WITH_GAS: [&str; 4] = ["force_zero_to_peak_{unit}", "theta_{unit}", "force_y_{unit}", "force_x_{unit}"];
const WITHOUT_GAS: [&str; 4] =
    ["without_gas_zero_to_peak_{unit}", "without_gas_theta_{unit}", "without_gas_y_{unit}", "without_gas_x_{unit}"];

/// A largest load with its crank angle, and its components there.
fn peak<R>(table: &mut Filling<R>, [size, angle, y, x]: [&'static str; 4], of: impl Fn(&R) -> &CyclePeak) {
    table.decimal(size, Unit::NEWTON, |row| Some(of(row).value));
    table.decimal(angle, Unit::DEGREE, |row| Some(of(row).angle).filter(|_| of(row).value > 0.0));
    table.decimal(y, Unit::NEWTON, |row| Some(of(row).vector.re));
    table.decimal(x, Unit::NEWTON, |row| Some(0.0 - of(row).vector.im));
}

/// The largest load of gas and masses, what the gas adds along it, and the largest of the masses alone.
fn with_and_without_gas<R>(table: &mut Filling<R>, of: impl Fn(&R) -> [&CyclePeak; 2]) {
    peak(table, WITH_GAS, |row| of(row)[0]);
    table.decimal("gas_along_{unit}", Unit::NEWTON, |row| Some(of(row)[0].gas_along()));
    peak(table, WITHOUT_GAS, |row| of(row)[1]);
}

fn of_cylinders(engine: &Engine, loads: &CycleLoads) -> Table {
    let mut table = Filling::new("bearings.gas_cylinders", engine.cylinders().iter().zip(&loads.cylinders));
    table.person("cylinder", |(cylinder, _)| Some(Untrusted::new(&*cylinder.name)));
    with_and_without_gas(&mut table, |(_, loads)| [&loads.peaks.pin, &loads.peaks.pin_of_inertia]);
    type Pick = fn(&CylinderLoads) -> Extreme;
    let extremes: [([&str; 2], Pick); 5] = [
        (["rod_largest_{unit}", "rod_largest_theta_{unit}"], |loads| loads.peaks.rod[0]),
        (["rod_least_{unit}", "rod_least_theta_{unit}"], |loads| loads.peaks.rod[1]),
        (["big_end_pull_{unit}", "big_end_pull_theta_{unit}"], |loads| loads.peaks.pull),
        (["side_greatest_{unit}", "side_greatest_theta_{unit}"], |loads| loads.peaks.side[0]),
        (["side_least_{unit}", "side_least_theta_{unit}"], |loads| loads.peaks.side[1]),
    ];
    for ([size, angle], of) in extremes {
        table.decimal(size, Unit::NEWTON, |(_, loads)| Some(of(loads).value));
        table.decimal(angle, Unit::DEGREE, |(_, loads)| Some(of(loads).angle));
    }
    table.done()
}

fn of_knuckles(engine: &Engine, loads: &CycleLoads) -> Option<Table> {
    let person = |index: usize| Some(Untrusted::new(&*engine.cylinders()[index].name));
    let mut table = Filling::new("bearings.gas_knuckles", &loads.knuckles);
    table.person("cylinder", |knuckle| person(knuckle.cylinder));
    table.person("master", |knuckle| person(knuckle.master));
    with_and_without_gas(&mut table, |knuckle| [&knuckle.peak, &knuckle.inertia]);
    table.done_if_any()
}

fn shared_pins(engine: &Engine, loads: &CycleLoads) -> Table {
    let mut table = Filling::new("bearings.gas_pins", &loads.shared_pins);
    table.whole("crankpin", |pin| pin.throw + 1);
    table.words("cylinders", |pin| {
        let numbers: Vec<String> = pin.cylinders.iter().map(|index| (index + 1).to_string()).collect();
        Some(numbers.join(" "))
    });
    table.exact("position_{unit}", position_unit(engine), |pin| Some(exact_number(&pin.position)));
    with_and_without_gas(&mut table, |pin| [&pin.peak, &pin.inertia]);
    table.done()
}

fn orders(loads: &CycleLoads) -> Table {
    let rows = methods(loads).flat_map(|(method, all)| {
        all.bearings
            .iter()
            .enumerate()
            .flat_map(move |(index, bearing)| bearing.series.orders.iter().map(move |order| (method, index + 1, order)))
    });
    let mut table = Filling::new("bearings.gas_orders", rows).keyed(3);
    table.words("method", |(method, ..)| Some((*method).to_owned()));
    table.whole("bearing", |(_, bearing, _)| *bearing);
    of_orders(&mut table, |(.., order)| order);
    table.done()
}

fn pin_orders(engine: &Engine, loads: &CycleLoads) -> Table {
    let pairs = engine.cylinders().iter().zip(&loads.cylinders);
    let rows = pairs.flat_map(|(cylinder, loads)| loads.pin.orders.iter().map(move |order| (cylinder, order)));
    let mut table = Filling::new("bearings.gas_pin_orders", rows).keyed(2);
    table.person("cylinder", |(cylinder, _)| Some(Untrusted::new(&*cylinder.name)));
    of_orders(&mut table, |(_, order)| order);
    table.done()
}

/// What is said of an order: whether it vanishes, how large it is, the vectors of gas and of masses.
fn of_orders<R>(table: &mut Filling<R>, of: impl Fn(&R) -> &JournalOrder) {
    table.exact("order", Unit::NONE, |row| Some(of(row).order.exact().to_string()));
    table.truth("force_vanishes", |row| Some(of(row).vanishes()));
    table.decimal("force_zero_to_peak_{unit}", Unit::NEWTON, |row| {
        Some(if of(row).vanishes() { 0.0 } else { of(row).largest() })
    });
    type Pick = fn(&JournalOrder) -> Complex<f64>;
    let vectors: [([&str; 2], Pick); 4] = [
        (["gas_direct_y_{unit}", "gas_direct_x_{unit}"], |order| order.gas[0]),
        (["gas_reverse_y_{unit}", "gas_reverse_x_{unit}"], |order| order.gas[1]),
        (["masses_direct_y_{unit}", "masses_direct_x_{unit}"], |order| order.inertia[0]),
        (["masses_reverse_y_{unit}", "masses_reverse_x_{unit}"], |order| order.inertia[1]),
    ];
    for ([y, x], vector) in vectors {
        table.decimal(y, Unit::NEWTON, |row| Some(vector(of(row)).re));
        table.decimal(x, Unit::NEWTON, |row| Some(0.0 - vector(of(row)).im));
    }
}

fn theta(loads: &CycleLoads) -> Option<Table> {
    let [continuous, _] = loads.bearings.as_ref()?;
    let rows = 0..loads.course.period().to_degrees().round() as usize;
    let mut table = Filling::new("bearings.gas_theta", rows.clone());
    table.decimal("theta_{unit}", Unit::DEGREE, |theta| Some(*theta as f64));
    for (index, bearing) in continuous.bearings.iter().enumerate() {
        let forces: Vec<Complex<f64>> =
            rows.clone().map(|theta| loads.course.carried(&bearing.carried, (theta as f64).to_radians())).collect();
        components(&mut table, index + 1, Unit::NEWTON, |theta| forces.get(*theta).copied());
    }
    Some(table.done())
}
