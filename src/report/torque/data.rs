//! Which columns hold the torque of gas and inertia? The cycle as a whole, a row an order, a class of cylinders, a crank angle, the flywheel.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::engine::Engine;
use crate::report::TorqueStudy;
use crate::report::data::Filling;
use crate::table::{Table, Unit};
use crate::torque::{Class, EngineTorque, Evenness, Extreme, HIGHEST, TorqueOrder, guide_moments};

/// A table of the torque.
pub fn table(study: &TorqueStudy, name: &str) -> Option<Table> {
    let torque = &study.torque;
    Some(match name {
        "orders" => orders(torque),
        "cycle" => cycle(torque),
        "flywheel" => flywheel(torque.evenness.as_ref()?),
        "classes" => classes(torque),
        "guides" => guides(&study.engine, torque)?,
        "theta" => theta(torque),
        "shafts" => shafts(&study.engine, torque)?,
        _ => return None,
    })
}

fn cycle(torque: &EngineTorque) -> Table {
    let mut table = Filling::new("torque.cycle", [torque]).keyed(0);
    let moment = Unit::NEWTON_METRE;
    table.decimal("mean_{unit}", moment, |torque| Some(torque.mean));
    type Pick = fn(&EngineTorque) -> Option<Extreme>;
    let extremes: [([&str; 2], Pick); 4] = [
        (["highest_{unit}", "highest_theta_{unit}"], |torque| Some(torque.highest)),
        (["lowest_{unit}", "lowest_theta_{unit}"], |torque| Some(torque.lowest)),
        (["roll_highest_{unit}", "roll_highest_theta_{unit}"], |torque| torque.roll.map(|roll| roll[0])),
        (["roll_lowest_{unit}", "roll_lowest_theta_{unit}"], |torque| torque.roll.map(|roll| roll[1])),
    ];
    for ([value, angle], of) in extremes {
        table.decimal(value, moment, |torque| of(torque).map(|one| one.value));
        table.decimal(angle, Unit::DEGREE, |torque| of(torque).map(|one| one.angle));
    }
    table.decimal("unevenness", Unit::NONE, |torque| torque.unevenness());
    table.decimal("power_{unit}", Unit::WATT, |torque| torque.power);
    table.decimal("energy_balance", Unit::NONE, |torque| Some(torque.balance));
    table.decimal("missed_{unit}", moment, |torque| Some(torque.missed));
    table.decimal("bound_{unit}", moment, |torque| {
        let of = |class: &Class| class.harmonics.bound(HIGHEST.into()) * class.cylinders.len() as f64;
        Some(torque.classes.iter().map(of).sum())
    });
    table.done()
}

/// An order of the torque: `a cos κθ + b sin κθ`.
fn orders(torque: &EngineTorque) -> Table {
    let mut table = Filling::new("torque.orders", &torque.orders);
    table.decimal("order", Unit::NONE, |order| order.order.exact().to_f64());
    table.truth("gas_vanishes", |order| Some(order.gas_vanishes));
    table.truth("inertia_vanishes", |order| order.inertia.map(|_| order.inertia_vanishes));
    table.truth("total_vanishes", |order| Some(order.vanishes()));
    let (gas, inertia) = (|order: &TorqueOrder| Some(order.gas), |order: &TorqueOrder| order.inertia);
    let total = |order: &TorqueOrder| Some(order.total());
    type Vector<'a> = &'a dyn Fn(&TorqueOrder) -> Option<num_complex::Complex<f64>>;
    let vectors: [([&'static str; 3], Vector); 3] = [
        (["gas_zero_to_peak_{unit}", "gas_cos_{unit}", "gas_sin_{unit}"], &gas),
        (["inertia_zero_to_peak_{unit}", "inertia_cos_{unit}", "inertia_sin_{unit}"], &inertia),
        (["total_zero_to_peak_{unit}", "total_cos_{unit}", "total_sin_{unit}"], &total),
    ];
    for ([size, cos, sin], of) in vectors {
        table.decimal(size, Unit::NEWTON_METRE, |order| of(order).map(|one| one.norm()));
        table.decimal(cos, Unit::NEWTON_METRE, |order| of(order).map(|one| one.re));
        table.decimal(sin, Unit::NEWTON_METRE, |order| of(order).map(|one| 0.0 - one.im));
    }
    table.done()
}

fn flywheel(evenness: &Evenness) -> Table {
    let mut table = Filling::new("torque.flywheel", [evenness]).keyed(0);
    let inertia = Unit::KILOGRAM_SQUARE_METRE;
    table.decimal("energy_{unit}", Unit::JOULE, |one| Some(one.energy));
    table.decimal("reciprocating_inertia_{unit}", inertia, |one| Some(one.reciprocating));
    table.decimal("irregularity", Unit::NONE, |one| Some(one.needed.irregularity));
    table.truth("is_example", |one| Some(one.needed.is_example));
    table.decimal("inertia_{unit}", inertia, |one| Some(one.needed.inertia));
    table.decimal("refined_inertia_{unit}", inertia, |one| Some(one.needed.refined));
    table.decimal("given_inertia_{unit}", inertia, |one| one.given.map(|given| given.inertia));
    table.decimal("given_irregularity", Unit::NONE, |one| one.given.map(|given| given.irregularity));
    table.decimal("given_refined_irregularity", Unit::NONE, |one| one.given.map(|given| given.refined));
    table.decimal("given_irregularity_by_energy", Unit::NONE, |one| one.given.and_then(|given| given.by_energy));
    table.done()
}

fn classes(torque: &EngineTorque) -> Table {
    let mut table = Filling::new("torque.classes", torque.classes.iter().enumerate());
    table.whole("class", |(index, _)| index + 1);
    let joined = |texts: Vec<String>| Some(texts.join(" "));
    table
        .words("cylinders", |(_, class)| joined(class.cylinders.iter().map(|index| (index + 1).to_string()).collect()));
    let full = BigRational::from_integer(360.into());
    table.exact("fires_{unit}", Unit::DEGREE, |(_, class)| {
        let cycle = BigRational::from_integer(class.gas.revolutions().into());
        let within = |turns: &BigRational| turns - (turns / &cycle).floor() * &cycle;
        joined(class.fires.iter().map(|turns| (within(turns) * &full).to_string()).collect())
    });
    table.decimal("peak_pressure_{unit}", Unit::PASCAL, |(_, class)| Some(class.gas.peak_pressure().0));
    table.decimal("mean_pressure_{unit}", Unit::PASCAL, |(_, class)| Some(class.gas.mean_pressure()));
    table.decimal("work_{unit}", Unit::JOULE, |(_, class)| Some(class.gas.work()));
    table.decimal("heat_{unit}", Unit::JOULE, |(_, class)| class.gas.heat());
    let errors = ["force_error_{unit}", "side_force_error_{unit}", "torque_error_{unit}"];
    for (name, place) in errors.into_iter().zip(0..) {
        let unit = if place == 2 { Unit::NEWTON_METRE } else { Unit::NEWTON };
        table.decimal(name, unit, |(_, class)| class.harmonics.errors.get(place).copied());
    }
    table.decimal("variation_{unit}", Unit::NEWTON_METRE, |(_, class)| Some(class.harmonics.variation));
    table.done()
}

fn guides(engine: &Engine, torque: &EngineTorque) -> Option<Table> {
    let mut table = Filling::new("torque.guides", guide_moments(engine, torque)?);
    table.decimal("order", Unit::NONE, |one| one.order.exact().to_f64());
    table.decimal("h_zero_to_peak_{unit}", Unit::NEWTON_METRE, |one| Some(one.rocking.unwrap_or(0.0)));
    table.decimal("x_zero_to_peak_{unit}", Unit::NEWTON_METRE, |one| Some(one.twisting.unwrap_or(0.0)));
    Some(table.done())
}

fn shafts(engine: &Engine, torque: &EngineTorque) -> Option<Table> {
    let mut table = Filling::new("torque.shafts", &torque.shafts);
    let moment = Unit::NEWTON_METRE;
    table.words("crankshaft", |one| Some(engine.geared_cranks()[one.shaft].name.clone()));
    table.decimal("mean_{unit}", moment, |one| Some(one.mean));
    for (place, [value, angle]) in
        [["highest_{unit}", "highest_theta_{unit}"], ["lowest_{unit}", "lowest_theta_{unit}"]].into_iter().enumerate()
    {
        table.decimal(value, moment, move |one| Some(one.extremes[place].value));
        table.decimal(angle, Unit::DEGREE, move |one| Some(one.extremes[place].angle));
    }
    table.done_if_any()
}

fn theta(torque: &EngineTorque) -> Table {
    let mut table = Filling::new("torque.theta", 0..torque.course.period().to_degrees().round() as u32);
    let radians = |degree: &u32| f64::from(*degree).to_radians();
    table.decimal("theta_{unit}", Unit::DEGREE, |degree| Some(f64::from(*degree)));
    table.decimal("torque_{unit}", Unit::NEWTON_METRE, |degree| Some(torque.course.total(radians(degree))));
    table.decimal("roll_{unit}", Unit::NEWTON_METRE, |degree| torque.course.roll(radians(degree)));
    table.done()
}
