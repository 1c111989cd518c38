//! Which columns hold what bearings, pins and rods feel of gas and masses together, through the whole cycle?

use num_complex::Complex;

use super::super::journal::CycleLoadsDocument;
use super::super::journal::document::{At, Bearing, Cylinder, Order, Peak, Solution};
use super::bearings::{position, position_unit};
use super::filling::Filling;
use crate::engine::Engine;
use crate::journal::{CycleBearings, CycleLoads};
use crate::table::{Table, Unit};
use crate::text::Untrusted;

/// The tables of the complete loads, in newtons.
pub(super) fn tables(engine: &Engine, document: &CycleLoadsDocument, loads: &CycleLoads) -> Vec<Table> {
    let solutions = [("continuous", &document.continuous), ("determinate", &document.determinate)];
    let known: Vec<(&'static str, &Solution)> =
        solutions.into_iter().filter_map(|(method, solution)| Some((method, solution.as_ref()?))).collect();
    let continuous = loads.bearings.as_ref().map(|[continuous, _]| continuous);
    let theta = continuous.map(|bearings| theta(document, loads, bearings));
    let first = [of_bearings(engine, &known), of_cylinders(&document.cylinders), orders(&known)];
    first.into_iter().chain(theta).collect()
}

const METHOD: &str = "continuous: one beam on all bearings; determinate: each span a beam of its own";

fn of_bearings(engine: &Engine, solutions: &[(&'static str, &Solution)]) -> Table {
    let rows: Vec<(&'static str, &Solution, &Bearing)> = solutions
        .iter()
        .flat_map(|(method, solution)| solution.bearings.iter().map(move |bearing| (*method, *solution, bearing)))
        .collect();
    let mut table =
        Filling::new("gas_bearings", "a main bearing: the largest load of gas and masses in a cycle", &rows);
    table.words("method", METHOD, |(method, ..)| Some((*method).to_owned()));
    table.whole("bearing", "its number in the file, from 1", |(.., bearing)| bearing.bearing);
    table.exact("position_{unit}", position_unit(engine), "where it stands along the shaft, exact", |(.., bearing)| {
        position(engine, bearing.bearing)
    });
    peak(&mut table, WITH_GAS, |(.., bearing)| &bearing.peak);
    gas(&mut table, |(.., bearing)| &bearing.peak);
    peak(&mut table, WITHOUT_GAS, |(.., bearing)| &bearing.without_gas);
    table.decimal("mean_y_{unit}", Unit::NEWTON, "the force that stays, along y", |(.., bearing)| Some(bearing.mean.y));
    table.decimal("mean_x_{unit}", Unit::NEWTON, "the force that stays, along x", |(.., bearing)| Some(bearing.mean.x));
    table.truth(
        "worst",
        "whether it has the largest load by this method, the first of equal ones",
        |(_, solution, bearing)| Some(solution.worst == bearing.bearing),
    );
    table.decimal(
        "missed_{unit}",
        Unit::NEWTON,
        "how much of a load the orders of `gas_orders` miss at most",
        |(_, solution, _)| Some(solution.missed),
    );
    table.done()
}

const WITH_GAS: [&str; 4] = ["force_zero_to_peak_{unit}", "theta_{unit}", "force_y_{unit}", "force_x_{unit}"];
const WITHOUT_GAS: [&str; 4] =
    ["without_gas_zero_to_peak_{unit}", "without_gas_theta_{unit}", "without_gas_y_{unit}", "without_gas_x_{unit}"];

/// A largest load with its crank angle, and its components there.
fn peak<R>(table: &mut Filling<R>, [size, angle, y, x]: [&'static str; 4], of: impl Fn(&R) -> &Peak) {
    table.decimal(size, Unit::NEWTON, "largest force in a cycle", |row| Some(of(row).value));
    table.decimal(angle, Unit::DEGREE, "crank angle of the cycle where it stands", |row| Some(of(row).crank_angle_deg));
    table.decimal(y, Unit::NEWTON, "its component there along the reference direction y", |row| Some(of(row).y));
    table.decimal(x, Unit::NEWTON, "its component there along x, to the right of y", |row| Some(of(row).x));
}

/// What the gas adds along the largest load.
fn gas<R>(table: &mut Filling<R>, of: impl Fn(&R) -> &Peak) {
    let about = "what the gas adds along the largest force of gas and masses";
    table.decimal("gas_along_{unit}", Unit::NEWTON, about, |row| Some(of(row).gas));
}

fn of_cylinders(cylinders: &[Cylinder]) -> Table {
    let rows: Vec<&Cylinder> = cylinders.iter().collect();
    let mut table = Filling::new(
        "gas_cylinders",
        "a cylinder: the largest loads of its crankpin, its rod and its wall in a cycle",
        &rows,
    );
    table.person("cylinder", "the cylinder", |cylinder| Some(Untrusted::new(&*cylinder.cylinder)));
    peak(&mut table, WITH_GAS, |cylinder| &cylinder.pin);
    gas(&mut table, |cylinder| &cylinder.pin);
    peak(&mut table, WITHOUT_GAS, |cylinder| &cylinder.pin_without_gas);
    at(
        &mut table,
        ["rod_largest_{unit}", "rod_largest_theta_{unit}"],
        "largest force along the rod, positive where it is pressed",
        |cylinder| &cylinder.rod_pressed,
    );
    at(
        &mut table,
        ["rod_least_{unit}", "rod_least_theta_{unit}"],
        "least force along the rod, negative where it is pulled",
        |cylinder| &cylinder.rod_pulled,
    );
    at(
        &mut table,
        ["big_end_pull_{unit}", "big_end_pull_theta_{unit}"],
        "largest pull of the big end, for the bolts",
        |cylinder| &cylinder.big_end_pulls,
    );
    at(
        &mut table,
        ["side_greatest_{unit}", "side_greatest_theta_{unit}"],
        "greatest side force of the wall on the piston, a quarter turn from the axis in the sense of rotation",
        |cylinder| &cylinder.side[0],
    );
    at(
        &mut table,
        ["side_least_{unit}", "side_least_theta_{unit}"],
        "least of it, negative to the other side",
        |cylinder| &cylinder.side[1],
    );
    table.done()
}

fn at<R>(table: &mut Filling<R>, [size, angle]: [&'static str; 2], about: &'static str, of: impl Fn(&R) -> &At) {
    table.decimal(size, Unit::NEWTON, about, |row| Some(of(row).value));
    table.decimal(angle, Unit::DEGREE, "crank angle of the cycle where it stands", |row| Some(of(row).crank_angle_deg));
}

fn orders(solutions: &[(&'static str, &Solution)]) -> Table {
    let rows: Vec<(&'static str, usize, &Order)> = solutions
        .iter()
        .flat_map(|(method, solution)| {
            let of = move |bearing: &'_ Bearing| bearing.bearing;
            solution.bearings.iter().flat_map(move |bearing| {
                let number = of(bearing);
                bearing.orders.iter().map(move |order| (*method, number, order))
            })
        })
        .collect();
    let mut table = Filling::new("gas_orders", "an order κ of what a main bearing feels of gas and masses", &rows);
    table.words("method", METHOD, |(method, ..)| Some((*method).to_owned()));
    table.whole("bearing", "its number in the file, from 1", |(_, bearing, _)| *bearing);
    table.exact("order", Unit::NONE, "the order, halves too in a four-stroke engine: 3/2", |(.., order)| {
        Some(order.order.clone())
    });
    table.truth(
        "force_vanishes",
        "whether it is proved to be 0, for every pressure that the cylinders of a class share",
        |(.., order)| Some(order.vanishes),
    );
    table.decimal("force_zero_to_peak_{unit}", Unit::NEWTON, "largest length", |(.., order)| {
        Some(if order.vanishes { 0.0 } else { order.largest })
    });
    table.done()
}

fn theta(document: &CycleLoadsDocument, loads: &CycleLoads, bearings: &CycleBearings) -> Table {
    let rows: Vec<usize> = (0..document.cycle_deg as usize).collect();
    let about = "a crank angle of the cycle: what each bearing feels of gas and masses on a continuous beam";
    let mut table = Filling::new("gas_theta", about, &rows);
    table.decimal("theta_{unit}", Unit::DEGREE, "the crank angle θ, every degree of the cycle", |theta| {
        Some(*theta as f64)
    });
    for (index, bearing) in bearings.bearings.iter().enumerate() {
        let forces: Vec<Complex<f64>> =
            rows.iter().map(|theta| loads.course.carried(&bearing.carried, (*theta as f64).to_radians())).collect();
        let number = index + 1;
        table.decimal(
            ("bearing_{bearing}_y_{unit}", number),
            Unit::NEWTON,
            "force on this bearing along the reference direction y",
            |theta| forces.get(*theta).map(|force| force.re),
        );
        table.decimal(
            ("bearing_{bearing}_x_{unit}", number),
            Unit::NEWTON,
            "force on it along x, to the right of y",
            |theta| forces.get(*theta).map(|force| -force.im),
        );
    }
    table.done()
}
