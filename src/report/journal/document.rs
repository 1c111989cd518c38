//! What does `bearings --json` hold of gas and masses together? Peaks with the gas in them, rods, side forces, orders.

use num_complex::Complex;
use serde::Serialize;

use crate::engine::Engine;
use crate::journal::{CycleBearing, CycleBearings, CycleLoads, CyclePeak, CylinderLoads, Series, SharedPin};
use crate::torque::Extreme;

/// The complete loads as data: newtons, degrees of the crank within the cycle.
#[derive(Clone, Debug, Serialize)]
pub struct CycleLoadsDocument {
    pub(in crate::report) cycle_deg: f64,
    sign: &'static str,
    pub(in crate::report) cylinders: Vec<Cylinder>,
    /// Crankpins with several rods, all of them together.
    shared_pins: Vec<Shared>,
    pub(in crate::report) continuous: Option<Solution>,
    pub(in crate::report) determinate: Option<Solution>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Solution {
    /// Number of the bearing with the largest load, from 1.
    pub(in crate::report) worst: usize,
    /// How much of a load the orders miss at most.
    pub(in crate::report) missed: f64,
    pub(in crate::report) bearings: Vec<Bearing>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Bearing {
    pub(in crate::report) bearing: usize,
    pub(in crate::report) position: String,
    /// What it carries of a unit load on the crankpin of each cylinder.
    parts: Vec<String>,
    pub(in crate::report) peak: Peak,
    pub(in crate::report) without_gas: Peak,
    pub(in crate::report) mean: Vector,
    pub(in crate::report) orders: Vec<Order>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Cylinder {
    pub(in crate::report) cylinder: String,
    pub(in crate::report) rod_pressed: At,
    /// Negative where the rod is pulled.
    pub(in crate::report) rod_pulled: At,
    pub(in crate::report) big_end_pulls: At,
    /// Of the wall on the piston, a quarter turn anticlockwise from the axis.
    pub(in crate::report) side: [At; 2],
    pub(in crate::report) pin: Peak,
    pub(in crate::report) pin_without_gas: Peak,
    mean: Vector,
    orders: Vec<Order>,
}

#[derive(Clone, Debug, Serialize)]
struct Shared {
    /// Number of the throw, from 1.
    crankpin: usize,
    cylinders: Vec<String>,
    position: String,
    peak: Peak,
    without_gas: Peak,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct At {
    pub(in crate::report) value: f64,
    pub(in crate::report) crank_angle_deg: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Peak {
    pub(in crate::report) value: f64,
    pub(in crate::report) crank_angle_deg: f64,
    pub(in crate::report) y: f64,
    pub(in crate::report) x: f64,
    /// What the gas adds along it.
    pub(in crate::report) gas: f64,
}

/// y in the reference direction, x to the right of it.
#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Vector {
    pub(in crate::report) y: f64,
    pub(in crate::report) x: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Order {
    pub(in crate::report) order: String,
    /// `true` where it is proved to be zero, for every pressure that the cylinders of a class share.
    pub(in crate::report) vanishes: bool,
    pub(in crate::report) largest: f64,
    /// Of gas and of masses at θ = 0: what turns with the crank, and against it.
    pub(in crate::report) gas: [Vector; 2],
    pub(in crate::report) inertia: [Vector; 2],
}

impl CycleLoadsDocument {
    /// The complete loads of an engine.
    pub fn new(engine: &Engine, loads: &CycleLoads) -> Self {
        let solution = |bearings: &CycleBearings| Solution {
            worst: bearings.worst + 1,
            missed: loads.missed(bearings),
            bearings: bearings.bearings.iter().enumerate().map(bearing).collect(),
        };
        let [continuous, determinate] = match &loads.bearings {
            None => [None, None],
            Some(both) => both.each_ref().map(|bearings| Some(solution(bearings))),
        };
        let shared = |pin: &SharedPin| Shared {
            crankpin: pin.throw + 1,
            cylinders: pin.cylinders.iter().map(|&index| engine.cylinders()[index].name.clone()).collect(),
            position: pin.position.to_string(),
            peak: peak(&pin.peak),
            without_gas: peak(&pin.inertia),
        };
        let names = engine.cylinders().iter().map(|cylinder| cylinder.name.clone());
        CycleLoadsDocument {
            cycle_deg: loads.course.period().to_degrees().round(),
            sign: "the force that bearing or pin feels; rods positive where they are pressed",
            cylinders: names.zip(&loads.cylinders).map(|(name, loads)| cylinder(name, loads)).collect(),
            shared_pins: loads.shared_pins.iter().map(shared).collect(),
            continuous,
            determinate,
        }
    }
}

fn vector(value: Complex<f64>) -> Vector {
    Vector { y: value.re, x: 0.0 - value.im }
}

fn at(extreme: Extreme) -> At {
    At { value: extreme.value, crank_angle_deg: extreme.angle }
}

fn peak(peak: &CyclePeak) -> Peak {
    let Vector { y, x } = vector(peak.vector);
    Peak { value: peak.value, crank_angle_deg: peak.angle, y, x, gas: peak.gas_along() }
}

fn orders(series: &Series) -> Vec<Order> {
    let order = |order: &crate::journal::JournalOrder| Order {
        order: order.order.exact().to_string(),
        vanishes: order.vanishes(),
        largest: order.largest(),
        gas: order.gas.map(vector),
        inertia: order.inertia.map(vector),
    };
    series.orders.iter().map(order).collect()
}

fn bearing((index, bearing): (usize, &CycleBearing)) -> Bearing {
    Bearing {
        bearing: index + 1,
        position: bearing.position.to_string(),
        parts: bearing.parts.iter().map(ToString::to_string).collect(),
        peak: peak(&bearing.peak),
        without_gas: peak(&bearing.inertia),
        mean: vector(bearing.series.mean.total()),
        orders: orders(&bearing.series),
    }
}

fn cylinder(name: String, loads: &CylinderLoads) -> Cylinder {
    let peaks = &loads.peaks;
    Cylinder {
        cylinder: name,
        rod_pressed: at(peaks.rod[0]),
        rod_pulled: at(peaks.rod[1]),
        big_end_pulls: at(peaks.pull),
        side: peaks.side.map(at),
        pin: peak(&peaks.pin),
        pin_without_gas: peak(&peaks.pin_of_inertia),
        mean: vector(loads.pin.mean.total()),
        orders: orders(&loads.pin),
    }
}
