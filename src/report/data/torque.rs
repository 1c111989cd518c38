//! Which columns hold the torque of gas and inertia? The cycle as a whole, a row an order, a class of cylinders, a crank angle, the flywheel.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::filling::Filling;
use crate::engine::Engine;
use crate::report::TorqueStudy;
use crate::table::{Table, Unit};
use crate::torque::{Class, EngineTorque, Evenness, Extreme, HIGHEST, TorqueOrder, guide_moments};

/// A table of the torque.
pub fn torque(study: &TorqueStudy, name: &str) -> Option<Table> {
    let torque = &study.torque;
    Some(match name {
        "orders" => orders(torque),
        "cycle" => cycle(torque),
        "flywheel" => flywheel(torque.evenness.as_ref()?),
        "classes" => classes(torque),
        "guides" => guides(&study.engine, torque)?,
        "theta" => theta(torque),
        _ => return None,
    })
}

fn cycle(torque: &EngineTorque) -> Table {
    let rows = [torque];
    let mut table =
        Filling::new("cycle", "the torque through a cycle, positive in the sense of rotation", &rows).keyed(0);
    let moment = Unit::NEWTON_METRE;
    table.decimal("mean_{unit}", moment, "its mean", |torque| Some(torque.mean));
    type Pick = fn(&EngineTorque) -> Extreme;
    let extremes: [([&str; 2], &str, Pick); 4] = [
        (["highest_{unit}", "highest_theta_{unit}"], "the largest torque", |torque| torque.highest),
        (["lowest_{unit}", "lowest_theta_{unit}"], "the smallest, which may be negative", |torque| torque.lowest),
        (
            ["roll_highest_{unit}", "roll_highest_theta_{unit}"],
            "the largest roll moment on the frame, without that of balancer shafts",
            |torque| torque.roll[0],
        ),
        (["roll_lowest_{unit}", "roll_lowest_theta_{unit}"], "the smallest", |torque| torque.roll[1]),
    ];
    for ([value, angle], about, of) in extremes {
        table.decimal(value, moment, about, |torque| Some(of(torque).value));
        table.decimal(angle, Unit::DEGREE, "crank angle of the cycle where it stands", |torque| Some(of(torque).angle));
    }
    let about = "the largest less the smallest torque, over the mean; empty where the mean is zero";
    table.decimal("unevenness", Unit::NONE, about, |torque| torque.unevenness());
    table.decimal("power_{unit}", Unit::WATT, "mean torque times speed; empty where no speed is given", |torque| {
        torque.power
    });
    let about = "how far mean torque and the area of the loops are apart, as a part of the work";
    table.decimal("energy_balance", Unit::NONE, about, |torque| Some(torque.balance));
    let about = "how much of the torque the orders of `orders` miss at most, looked for through a cycle";
    table.decimal("missed_{unit}", moment, about, |torque| Some(torque.missed));
    table.decimal("bound_{unit}", moment, "no order of the gas above the last is larger", |torque| {
        let of = |class: &Class| class.harmonics.bound(HIGHEST.into()) * class.cylinders.len() as f64;
        Some(torque.classes.iter().map(of).sum())
    });
    table.done()
}

/// An order of the torque: `a cos κθ + b sin κθ`.
fn orders(torque: &EngineTorque) -> Table {
    let mut table = Filling::new("orders", "an order of the torque", &torque.orders);
    table.decimal("order", Unit::NONE, "the order κ of the crank speed", |order| order.order.exact().to_f64());
    let about = "whether the part of the gas is proved to be 0, for every pressure that equal cylinders share";
    table.truth("gas_vanishes", about, |order| Some(order.gas_vanishes));
    let about = "whether the part of the inertia is proved to be 0";
    table.truth("inertia_vanishes", about, |order| order.inertia.map(|_| order.inertia_vanishes));
    let about = "whether both are";
    table.truth("total_vanishes", about, |order| Some(order.vanishes()));
    let (gas, inertia) = (|order: &TorqueOrder| Some(order.gas), |order: &TorqueOrder| order.inertia);
    let total = |order: &TorqueOrder| Some(order.total());
    type Vector<'a> = &'a dyn Fn(&TorqueOrder) -> Option<num_complex::Complex<f64>>;
    let vectors: [([&'static str; 3], &'static str, Vector); 3] = [
        (["gas_zero_to_peak_{unit}", "gas_cos_{unit}", "gas_sin_{unit}"], "of the gas", &gas),
        (
            ["inertia_zero_to_peak_{unit}", "inertia_cos_{unit}", "inertia_sin_{unit}"],
            "of the inertia; empty where masses or speed are not given",
            &inertia,
        ),
        (["total_zero_to_peak_{unit}", "total_cos_{unit}", "total_sin_{unit}"], "of gas and inertia together", &total),
    ];
    for ([size, cos, sin], about, of) in vectors {
        table.decimal(size, Unit::NEWTON_METRE, about, |order| of(order).map(|one| one.norm()));
        table.decimal(cos, Unit::NEWTON_METRE, "a of a cos κθ + b sin κθ", |order| of(order).map(|one| one.re));
        table.decimal(sin, Unit::NEWTON_METRE, "b of a cos κθ + b sin κθ", |order| {
            of(order).map(|one| 0.0 - one.im)
        });
    }
    table.done()
}

fn flywheel(evenness: &Evenness) -> Table {
    let rows = [evenness];
    let mut table =
        Filling::new("flywheel", "the flywheel that the torque needs at the speed of the layout", &rows).keyed(0);
    let inertia = Unit::KILOGRAM_SQUARE_METRE;
    let about = "energy fluctuation ΔW: the largest less the smallest work of the torque above its mean";
    table.decimal("energy_{unit}", Unit::JOULE, about, |one| Some(one.energy));
    let about = "mean of Σ m s'², the inertia of the reciprocating masses";
    table.decimal("reciprocating_inertia_{unit}", inertia, about, |one| Some(one.reciprocating));
    let about = "the coefficient of fluctuation of speed δ that is wanted";
    table.decimal("irregularity", Unit::NONE, about, |one| Some(one.needed.irregularity));
    let about = "whether the layout wants none, so that the one before is an example";
    table.truth("is_example", about, |one| Some(one.needed.is_example));
    table.decimal("inertia_{unit}", inertia, "the inertia that it needs, J = ΔW/(δ ω²)", |one| {
        Some(one.needed.inertia)
    });
    let about = "the same less that of the reciprocating masses";
    table.decimal("refined_inertia_{unit}", inertia, about, |one| Some(one.needed.refined));
    let about = "the inertia that the layout gives; empty where it gives none";
    table.decimal("given_inertia_{unit}", inertia, about, |one| one.given.map(|given| given.inertia));
    let about = "the coefficient of fluctuation of speed with it, δ = ΔW/(J ω²)";
    table.decimal("given_irregularity", Unit::NONE, about, |one| one.given.map(|given| given.irregularity));
    let about = "the same with the reciprocating masses";
    table.decimal("given_refined_irregularity", Unit::NONE, about, |one| one.given.map(|given| given.refined));
    let about = "the same by the balance of energy; empty where it stops within a cycle";
    table.decimal("given_irregularity_by_energy", Unit::NONE, about, |one| one.given.and_then(|given| given.by_energy));
    table.done()
}

fn classes(torque: &EngineTorque) -> Table {
    let rows: Vec<_> = torque.classes.iter().enumerate().collect();
    let mut table = Filling::new("classes", "cylinders that are alike, with what the gas does in each", &rows);
    table.whole("class", "its number, from 1", |(index, _)| index + 1);
    let joined = |texts: Vec<String>| Some(texts.join(" "));
    table.words("cylinders", "their numbers in the file, with a space between", |(_, class)| {
        joined(class.cylinders.iter().map(|index| (index + 1).to_string()).collect())
    });
    let full = BigRational::from_integer(360.into());
    table.exact(
        "fires_{unit}",
        Unit::DEGREE,
        "crank angles of the cycle at which they fire, with a space between",
        |(_, class)| joined(class.fires.iter().map(|turns| (turns * &full).to_string()).collect()),
    );
    table.decimal("peak_pressure_{unit}", Unit::PASCAL, "highest pressure, absolute", |(_, class)| {
        Some(class.gas.peak_pressure().0)
    });
    table.decimal("mean_pressure_{unit}", Unit::PASCAL, "mean effective pressure", |(_, class)| {
        Some(class.gas.mean_pressure())
    });
    table.decimal("work_{unit}", Unit::JOULE, "work of a cycle", |(_, class)| Some(class.gas.work()));
    table.decimal("heat_{unit}", Unit::JOULE, "heat of a cycle; empty where none is given", |(_, class)| {
        class.gas.heat()
    });
    let errors: [(&str, &str); 3] = [
        ("force_error_{unit}", "stated error of the harmonics of the force"),
        ("side_force_error_{unit}", "stated error of the harmonics of the side force"),
        ("torque_error_{unit}", "stated error of the harmonics of the torque"),
    ];
    for ((name, about), place) in errors.into_iter().zip(0..) {
        let unit = if place == 2 { Unit::NEWTON_METRE } else { Unit::NEWTON };
        table.decimal(name, unit, about, |(_, class)| class.harmonics.errors.get(place).copied());
    }
    let about = "total variation of dT/dψ over a cycle";
    table.decimal("variation_{unit}", Unit::NEWTON_METRE, about, |(_, class)| Some(class.harmonics.variation));
    table.done()
}

fn guides(engine: &Engine, torque: &EngineTorque) -> Option<Table> {
    let rows = guide_moments(engine, torque)?;
    let mut table = Filling::new("guides", "an order of the guide-force moments", &rows);
    table.decimal("order", Unit::NONE, "the order κ of the crank speed", |one| one.order.exact().to_f64());
    let about = "H, the order of the torque, which rocks the frame about the shaft; 0 where it is proved";
    table.decimal("h_zero_to_peak_{unit}", Unit::NEWTON_METRE, about, |one| Some(one.rocking.unwrap_or(0.0)));
    let about =
        "X, the sum of the couples, each times its distance from the middle, over the rod length; 0 where it is proved";
    table.decimal("x_zero_to_peak_{unit}", Unit::NEWTON_METRE, about, |one| Some(one.twisting.unwrap_or(0.0)));
    Some(table.done())
}

fn theta(torque: &EngineTorque) -> Table {
    let rows: Vec<u32> = (0..torque.course.period().to_degrees().round() as u32).collect();
    let mut table = Filling::new("theta", "a crank angle of the cycle", &rows);
    let radians = |degree: &u32| f64::from(*degree).to_radians();
    table.decimal("theta_{unit}", Unit::DEGREE, "the crank angle θ", |degree| Some(f64::from(*degree)));
    let about = "the torque on the crankshaft, of gas and inertia";
    table.decimal("torque_{unit}", Unit::NEWTON_METRE, about, |degree| Some(torque.course.total(radians(degree))));
    let about = "the roll moment on the frame, without that of balancer shafts";
    table.decimal("roll_{unit}", Unit::NEWTON_METRE, about, |degree| Some(torque.course.roll(radians(degree))));
    table.done()
}
