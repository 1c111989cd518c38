//! What does `torque --json` hold? Mean, extremes and orders of the torque, the flywheel, the cylinders.

use serde::Serialize;

use crate::engine::Engine;
use crate::torque::{Class, EngineTorque, Evenness, Extreme, GuideMoments, HIGHEST, TorqueOrder, guide_moments};

/// The torque of an engine, as data: newton-metres, joules, degrees.
#[derive(Clone, Debug, Serialize)]
pub struct TorqueDocument {
    title: String,
    amplitudes: &'static str,
    sign: &'static str,
    mean: f64,
    highest: ExtremeEntry,
    lowest: ExtremeEntry,
    /// Largest less smallest over the mean; null where the mean is zero.
    unevenness: Option<f64>,
    /// In watts; null where the layout gives no speed.
    power: Option<f64>,
    /// Mean torque against the area of the loops, as a part of the work.
    energy_balance: f64,
    orders: Vec<Order>,
    /// How much of the torque the orders miss at most.
    missed: f64,
    /// No order of the gas above the last is larger.
    bound: f64,
    roll_highest: ExtremeEntry,
    roll_lowest: ExtremeEntry,
    flywheel: Option<Flywheel>,
    cylinders: Vec<Cylinders>,
    guide_force_moments: Option<Vec<Guide>>,
}

#[derive(Clone, Debug, Serialize)]
struct ExtremeEntry {
    value: f64,
    crank_angle_deg: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Order {
    order: String,
    /// `true` where gas, and inertia where it is known, are proved to be zero.
    vanishes: bool,
    gas: Vector,
    /// `true` where every firing star is proved to be zero.
    gas_vanishes: bool,
    /// Null where masses or speed are not known.
    inertia: Option<Vector>,
    inertia_vanishes: bool,
    total: Vector,
    /// One a class of equal cylinders: turns of the terms, each of weight 1.
    stars: Vec<Vec<String>>,
}

/// `a cos κθ + b sin κθ`.
#[derive(Clone, Debug, Serialize)]
struct Vector {
    cos: f64,
    sin: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Flywheel {
    energy: f64,
    reciprocating_inertia: f64,
    needed: Needed,
    given: Option<Given>,
}

#[derive(Clone, Debug, Serialize)]
struct Needed {
    irregularity: f64,
    is_example: bool,
    inertia: f64,
    refined_inertia: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Given {
    inertia: f64,
    irregularity: f64,
    refined_irregularity: f64,
    irregularity_by_energy: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct Cylinders {
    names: Vec<String>,
    /// Crank angle at which each fires.
    fires_deg: Vec<String>,
    peak_pressure: f64,
    mean_pressure: f64,
    work: f64,
    heat: Option<f64>,
    /// Stated error of the harmonics of force, side force and torque.
    quadrature_error: [f64; 3],
    /// Total variation of dT/dψ over a cycle.
    variation: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Guide {
    order: String,
    rocking: f64,
    twisting: f64,
}

/// The torque of an engine as data.
pub fn torque_document(engine: &Engine, torque: &EngineTorque) -> TorqueDocument {
    let guides = |moments: Vec<GuideMoments>| moments.iter().map(guide).collect();
    TorqueDocument {
        title: engine.title().written().to_owned(),
        amplitudes: "zero-to-peak",
        sign: "positive in the sense of rotation; pressures absolute, in pascals",
        mean: torque.mean,
        highest: extreme(torque.highest),
        lowest: extreme(torque.lowest),
        unevenness: torque.unevenness(),
        power: torque.power,
        energy_balance: torque.balance,
        orders: torque.orders.iter().map(order).collect(),
        missed: torque.missed,
        bound: torque
            .classes
            .iter()
            .map(|class| class.harmonics.bound(HIGHEST.into()) * class.cylinders.len() as f64)
            .sum(),
        roll_highest: extreme(torque.roll[0]),
        roll_lowest: extreme(torque.roll[1]),
        flywheel: torque.evenness.as_ref().map(flywheel),
        cylinders: torque.classes.iter().map(|class| cylinders(engine, class)).collect(),
        guide_force_moments: guide_moments(engine, torque).map(guides),
    }
}

fn extreme(extreme: Extreme) -> ExtremeEntry {
    ExtremeEntry { value: extreme.value, crank_angle_deg: extreme.angle }
}

fn vector(value: num_complex::Complex<f64>) -> Vector {
    Vector { cos: value.re, sin: 0.0 - value.im }
}

fn order(order: &TorqueOrder) -> Order {
    let turns =
        |star: &crate::exact::PhasorSum| star.terms().iter().map(|term| term.angle.turns().to_string()).collect();
    Order {
        order: order.order.exact().to_string(),
        vanishes: order.vanishes(),
        gas: vector(order.gas),
        gas_vanishes: order.gas_vanishes,
        inertia: order.inertia.map(vector),
        inertia_vanishes: order.inertia_vanishes,
        total: vector(order.total()),
        stars: order.stars.iter().map(turns).collect(),
    }
}

fn flywheel(evenness: &Evenness) -> Flywheel {
    Flywheel {
        energy: evenness.energy,
        reciprocating_inertia: evenness.reciprocating,
        needed: Needed {
            irregularity: evenness.needed.irregularity,
            is_example: evenness.needed.is_example,
            inertia: evenness.needed.inertia,
            refined_inertia: evenness.needed.refined,
        },
        given: evenness.given.map(|given| Given {
            inertia: given.inertia,
            irregularity: given.irregularity,
            refined_irregularity: given.refined,
            irregularity_by_energy: given.by_energy,
        }),
    }
}

fn cylinders(engine: &Engine, class: &Class) -> Cylinders {
    let degrees = num_rational::BigRational::from_integer(360.into());
    Cylinders {
        names: class.cylinders.iter().map(|&index| engine.cylinders()[index].name.clone()).collect(),
        fires_deg: class.fires.iter().map(|turns| (turns * &degrees).to_string()).collect(),
        peak_pressure: class.gas.peak_pressure().0,
        mean_pressure: class.gas.mean_pressure(),
        work: class.gas.work(),
        heat: class.gas.heat(),
        quadrature_error: class.harmonics.errors,
        variation: class.harmonics.variation,
    }
}

fn guide(moments: &GuideMoments) -> Guide {
    Guide {
        order: moments.order.exact().to_string(),
        rocking: moments.rocking.unwrap_or(0.0),
        twisting: moments.twisting.unwrap_or(0.0),
    }
}
