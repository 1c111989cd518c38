//! Which columns hold what the main bearings feel of the masses? A row a bearing, an order, a crank angle, a crankpin, a part of a load.

use num_complex::Complex;

use super::columns::{components, crankshafts, peak, position_unit};
use super::{gas_data, links};
use crate::exact::PhasorSum;
use crate::loads::{
    BearingLoad, BearingLoads, Circle, Peak, PinLoads, Swing, left_out_of_bearings, left_out_of_pins, pin_loads,
};
use crate::motion::LinkMass;
use crate::numbers;
use crate::order::{Factor, OrderSum};
use crate::report::BearingsStudy;
use crate::report::bearings::orders_of;
use crate::report::calculation::data::Units;
use crate::report::data::{Filling, exact_number};
use crate::table::{Table, Unit};
use crate::text::Untrusted;

/// A table of the bearing loads: of the masses, or of gas and masses where the layout asks for the gas.
pub fn table(study: &BearingsStudy, name: &str) -> Option<Table> {
    let units = Units::new(&study.engine, study.continuous.scale.as_ref());
    Some(match name {
        "bearings" => of_bearings(study, units),
        "worst" => worst(study, units)?,
        "orders" => orders(study, units),
        "terms" => terms(study),
        "theta" => theta(&study.continuous, units),
        "pins" => pins(study, units)?,
        "pin_orders" => pin_orders(study, units)?,
        "parts" => parts(study),
        "knuckles" | "masters" => links::table(&study.engine, units, name)?,
        _ => return gas_data::table(&study.engine, study.with_gas()?, name),
    })
}

/// Both ways to share a load, by their names in tables.
fn methods(study: &BearingsStudy) -> [(&'static str, &BearingLoads); 2] {
    [("continuous", &study.continuous), ("determinate", &study.determinate)]
}

/// Each bearing by each method.
fn each(study: &BearingsStudy) -> impl Iterator<Item = (&'static str, usize, &BearingLoad)> {
    methods(study).into_iter().flat_map(|(method, loads)| {
        loads.bearings.iter().enumerate().map(move |(index, bearing)| (method, index + 1, bearing))
    })
}

fn of_bearings(study: &BearingsStudy, units: Units) -> Table {
    let left_out = methods(study).map(|(_, loads)| left_out_of_bearings(&study.engine, loads).ok().flatten());
    let of_method = |method: &str| usize::from(method != "continuous");
    let mut table = Filling::new("bearings.bearings", each(study)).keyed(2);
    table.words("method", |(method, ..)| Some((*method).to_owned()));
    table.whole("bearing", |(_, number, _)| *number);
    crankshafts(&mut table, &study.engine, |(.., bearing)| bearing.crank);
    let unit = position_unit(&study.engine);
    table.exact("position_{unit}", unit, |(.., bearing)| Some(exact_number(&bearing.position)));
    type PeakOf = fn(&BearingLoad) -> &Peak;
    let peaks: [([&str; 2], PeakOf); 3] = [
        (["force_zero_to_peak_{unit}", "theta_{unit}"], |one| &one.peak),
        (["force_y_zero_to_peak_{unit}", "force_y_theta_{unit}"], |one| &one.along),
        (["force_x_zero_to_peak_{unit}", "force_x_theta_{unit}"], |one| &one.across),
    ];
    for (names, of) in peaks {
        peak(&mut table, names, units, |(.., bearing)| of(bearing));
    }
    table.truth("worst", |(method, number, _)| Some(methods(study)[of_method(method)].1.worst.contains(&(number - 1))));
    table.decimal("left_out_{unit}", units.force, |(method, ..)| {
        left_out[of_method(method)].as_ref().map(|bound| bound.most * units.newtons)
    });
    table.done()
}

/// The most loaded bearing of the continuous beam; none where no bearing feels anything.
fn worst(study: &BearingsStudy, units: Units) -> Option<Table> {
    let of_masses = || {
        let index = *study.continuous.worst.first()?;
        let peak = &study.continuous.bearings[index].peak;
        Some((index, peak.value * units.newtons, peak.angle))
    };
    let of_all = study.with_gas().and_then(|loads| loads.bearings.as_ref()).and_then(|[continuous, _]| {
        let index = *continuous.worst.first()?;
        let peak = &continuous.bearings[index].peak;
        Some((index, peak.value, Some(peak.angle)))
    });
    let with_gas = of_all.is_some();
    let mut table = Filling::new("bearings.worst", [of_all.or_else(of_masses)?]).keyed(0);
    table.whole("bearing", |(index, ..)| index + 1);
    table.decimal("force_zero_to_peak_{unit}", units.force, |(_, force, _)| Some(*force));
    table.decimal("theta_{unit}", Unit::DEGREE, |(.., angle)| *angle);
    table.truth("with_gas", |_| Some(with_gas));
    Some(table.done())
}

/// The largest length of an order, and its two vectors.
fn vectors<R>(table: &mut Filling<R>, units: Units, of: impl Fn(&R) -> (u32, &[OrderSum; 2], &Swing)) {
    table.decimal("force_zero_to_peak_{unit}", units.force, |row| Some(of(row).2.largest() * units.newtons));
    let both: [[&'static str; 4]; 2] = [
        ["direct_zero_to_peak_{unit}", "direct_exact", "direct_angle_{unit}", "direct_vanishes"],
        ["reverse_zero_to_peak_{unit}", "reverse_exact", "reverse_angle_{unit}", "reverse_vanishes"],
    ];
    let vector = |swing: &Swing, place: usize| [&swing.direct, &swing.reverse][place].clone();
    for (place, [size, exact, angle, zero]) in both.into_iter().enumerate() {
        table.decimal(size, units.force, |row| Some(vector(of(row).2, place).value.norm() / 2.0 * units.newtons));
        table.exact(exact, Unit::MASS_RADIUS, |row| lengths(&of(row).1[place], of(row).0));
        table.decimal(angle, Unit::DEGREE, |row| {
            let value = vector(of(row).2, place).value;
            (value.norm_sqr() > 0.0).then(|| numbers::degrees(value))
        });
        table.truth(zero, |row| vector(of(row).2, place).outcome.vanishes());
    }
}

fn orders(study: &BearingsStudy, units: Units) -> Table {
    let rows = each(study)
        .flat_map(|(method, number, bearing)| bearing.orders.iter().map(move |order| (method, number, order)));
    let mut table = Filling::new("bearings.orders", rows).keyed(3);
    table.words("method", |(method, ..)| Some((*method).to_owned()));
    table.whole("bearing", |(_, number, _)| *number);
    table.whole("order", |(.., order)| order.order as usize);
    vectors(&mut table, units, |(.., order)| (order.order, &order.sums, &order.swing));
    table.done()
}

/// The length of each sum in closed form, with what it is multiplied by: `√2 c_2, 1/2`; none where one has no closed form or the rods differ.
fn lengths(sum: &OrderSum, order: u32) -> Option<String> {
    if sum.vanishes() {
        return Some("0".to_owned());
    }
    let letters: Vec<Option<char>> = sum.parts().keys().map(Factor::letter).collect();
    let differ = letters.iter().enumerate().any(|(index, letter)| letters[..index].contains(letter));
    let part = |(letter, sum): (&Option<char>, &PhasorSum)| {
        let length = numbers::modulus(sum)?;
        Some(letter.map_or_else(|| length.to_string(), |letter| format!("{length} {letter}_{order}")))
    };
    let parts: Option<Vec<String>> = letters.iter().zip(sum.parts().values()).map(part).collect();
    parts.filter(|_| !differ).map(|parts| parts.join(", "))
}

/// The exact sums that the vectors of the continuous beam are, term by term.
fn terms(study: &BearingsStudy) -> Table {
    let mut rows = Vec::new();
    for (index, bearing) in study.continuous.bearings.iter().enumerate() {
        for order in &bearing.orders {
            for (sense, sum) in ["direct", "reverse"].into_iter().zip(&order.sums) {
                for (factor, sum) in sum.parts() {
                    rows.extend(sum.terms().iter().map(|term| (index + 1, order.order, sense, factor, term)));
                }
            }
        }
    }
    let mut table = Filling::new("bearings.terms", &rows).keyed(5);
    table.whole("bearing", |row| row.0);
    table.whole("order", |row| row.1 as usize);
    table.words("sense", |row| Some(row.2.to_owned()));
    table.words("coefficient", |row| Some(coefficient(row.3)));
    table.exact("angle_turns", Unit::NONE, |row| Some(row.4.angle.turns().to_string()));
    table.exact("weight", Unit::NONE, |row| Some(row.4.weight.to_string()));
    table.done()
}

/// `1`, or c_k or n_k of which rod.
fn coefficient(factor: &Factor) -> String {
    let (letter, rod) = match factor {
        Factor::One => return "1".to_owned(),
        Factor::Open | Factor::OpenTorque => return "c_k".to_owned(),
        Factor::Motion(rod) => ("c_k", rod),
        Factor::Quadrature(rod) => return format!("Im c_1 of λ = {}, δ = {}", rod.ratio, rod.offset),
        Factor::Torque(_) | Factor::DecimalTorque(_) => return "t_k".to_owned(),
        // Without an offset it is all there is of n_k in an odd order.
        Factor::Side(rod) if rod.is_centric() => ("n_k", rod),
        Factor::Side(rod) => ("u_k", rod),
        Factor::Geared(speed, own) => return format!("{} of order k/{speed}", coefficient(own)),
        Factor::Linkage(linkage) => return format!("g_k of r/L = {}, κ = {}", linkage.ratio, linkage.knuckle),
        Factor::OnPin(link, mass, _) => {
            let of = match mass {
                LinkMass::Piston => "piston",
                LinkMass::Knuckle => "knuckle",
            };
            let angle = link.angle.degrees();
            return format!("p_k of the {of} of the link at Δ = {angle}°, decimal");
        }
        Factor::Corrected(linkage, _) => return format!("h_k of r/L = {}, κ = {}", linkage.ratio, linkage.knuckle),
    };
    format!("{letter} of λ = {}, δ = {}", rod.ratio, rod.offset)
}

/// Steps of a revolution: a degree each.
const STEPS: usize = 360;

fn theta(loads: &BearingLoads, units: Units) -> Table {
    let circle = Circle::new(STEPS);
    let all: Vec<Vec<Complex<f64>>> = loads.bearings.iter().map(|bearing| bearing.waveform.sample(&circle)).collect();
    let mut table = Filling::new("bearings.theta", 0..STEPS);
    table.decimal("theta_{unit}", Unit::DEGREE, |theta| Some(*theta as f64));
    for (index, tips) in all.iter().enumerate() {
        let force = |theta: usize| Some(tips[theta] * units.newtons);
        components(&mut table, index + 1, units.force, |theta| force(*theta));
    }
    table.done()
}

/// What the rods load the crankpins with, each beside its cylinder.
fn pins_of(study: &BearingsStudy) -> Option<PinLoads> {
    pin_loads(&study.engine, &orders_of(&study.continuous)).ok()
}

fn pins(study: &BearingsStudy, units: Units) -> Option<Table> {
    let loads = pins_of(study)?;
    let left_out = left_out_of_pins(&study.engine, &loads).ok();
    let pins = study.engine.cylinders().iter().zip(&loads.pins).enumerate();
    let rows = pins.map(|(index, (cylinder, pin))| (cylinder, pin, index));
    let mut table = Filling::new("bearings.pins", rows);
    table.person("cylinder", |(cylinder, ..)| Some(Untrusted::new(&*cylinder.name)));
    crankshafts(&mut table, &study.engine, |(cylinder, ..)| cylinder.crank);
    table.exact("position_{unit}", position_unit(&study.engine), |(_, pin, _)| Some(exact_number(&pin.position)));
    let force = ["force_zero_to_peak_{unit}", "theta_{unit}"];
    peak(&mut table, force, units, |(_, pin, _)| &pin.peak);
    let along = ["along_throw_zero_to_peak_{unit}", "along_throw_theta_{unit}"];
    peak(&mut table, along, units, |(_, pin, _)| &pin.along);
    let across = ["across_throw_zero_to_peak_{unit}", "across_throw_theta_{unit}"];
    peak(&mut table, across, units, |(_, pin, _)| &pin.across);
    table.decimal("left_out_{unit}", units.force, |(.., index)| {
        left_out.as_ref().map(|bounds| bounds[*index] * units.newtons).filter(|bound| *bound > 0.0)
    });
    Some(table.done())
}

fn pin_orders(study: &BearingsStudy, units: Units) -> Option<Table> {
    let loads = pins_of(study)?;
    let pairs = study.engine.cylinders().iter().zip(&loads.pins);
    let rows = pairs.flat_map(|(cylinder, pin)| pin.orders.iter().map(move |order| (cylinder, order)));
    let mut table = Filling::new("bearings.pin_orders", rows).keyed(2);
    table.person("cylinder", |(cylinder, _)| Some(Untrusted::new(&*cylinder.name)));
    table.whole("order", |(_, order)| order.order as usize);
    vectors(&mut table, units, |(_, order)| (order.order, &order.sums, &order.swing));
    Some(table.done())
}

fn parts(study: &BearingsStudy) -> Table {
    let rows = methods(study).into_iter().flat_map(|(method, loads)| {
        loads.parts.iter().flat_map(move |(at, parts)| {
            parts.iter().enumerate().map(move |(index, part)| (method, at, index + 1, part))
        })
    });
    let mut table = Filling::new("bearings.parts", rows).keyed(3);
    table.words("method", |(method, ..)| Some((*method).to_owned()));
    table.exact("load_position_{unit}", position_unit(&study.engine), |(_, at, ..)| Some(exact_number(at)));
    table.whole("bearing", |(_, _, bearing, _)| *bearing);
    table.exact("part", Unit::NONE, |(.., part)| Some(exact_number(part)));
    table.done()
}
