//! What does `bearings --json` hold? Peaks, orders with their exact sums, the parts of a load.

use std::collections::BTreeMap;

use serde::Serialize;

use super::super::calculation::Unit;
use super::super::journal::CycleLoadsDocument;
use super::amounts::unit_of;
use super::page::orders_of;
use crate::engine::{Engine, Mechanism};
use crate::loads::{BearingLoad, BearingLoads, Outcome, Peak, Swing, Vector, left_out_of_bearings, pin_loads};
use crate::numbers;
use crate::order::{Factor, OrderSum};

/// What the main bearings feel, as data.
#[derive(Clone, Debug, Serialize)]
pub struct BearingsDocument {
    title: String,
    amplitudes: &'static str,
    sign: &'static str,
    unit: &'static str,
    /// Newtons a multiple of m r ω²; null where the layout does not say.
    newtons_per_multiple: Option<f64>,
    /// What the rods load the crankpins with, a row per cylinder.
    pub(in crate::report) pins: Vec<Pin>,
    pub(in crate::report) continuous: Solution,
    pub(in crate::report) determinate: Solution,
    /// Gas and masses together, where the layout asks for the gas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::report) with_gas: Option<CycleLoadsDocument>,
}

impl BearingsDocument {
    /// The same with the loads of gas and masses together.
    pub fn with_gas(self, loads: CycleLoadsDocument) -> Self {
        BearingsDocument { with_gas: Some(loads), ..self }
    }
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Pin {
    pub(in crate::report) cylinder: String,
    pub(in crate::report) position: String,
    pub(in crate::report) peak: PeakEntry,
    /// Seen from the crank: outward along the throw, and in the sense of rotation.
    pub(in crate::report) along_the_throw: PeakEntry,
    pub(in crate::report) across_the_throw: PeakEntry,
    orders: Vec<Order>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Solution {
    /// Numbers of the bearings with the largest peak, from 1.
    pub(in crate::report) worst: Vec<usize>,
    /// What the orders that are not listed add to the load of any bearing; null where they add nothing.
    pub(in crate::report) left_out: Option<LeftOut>,
    /// Position of a load to the parts of it that the bearings carry.
    parts: BTreeMap<String, Vec<String>>,
    pub(in crate::report) bearings: Vec<Bearing>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct LeftOut {
    /// In the unit of the loads.
    pub(in crate::report) at_most: f64,
    /// Of the largest load; null where it might be all of it.
    part: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Bearing {
    pub(in crate::report) bearing: usize,
    pub(in crate::report) position: String,
    pub(in crate::report) peak: PeakEntry,
    pub(in crate::report) y: PeakEntry,
    pub(in crate::report) x: PeakEntry,
    pub(in crate::report) orders: Vec<Order>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct PeakEntry {
    pub(in crate::report) value: f64,
    pub(in crate::report) crank_angle_deg: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Order {
    pub(in crate::report) order: u32,
    pub(in crate::report) largest: f64,
    pub(in crate::report) direct: Turning,
    pub(in crate::report) reverse: Turning,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct Turning {
    pub(in crate::report) amplitude: f64,
    pub(in crate::report) angle_deg: Option<f64>,
    /// `true` proved zero, `false` proved not zero, null not decided.
    pub(in crate::report) vanishes: Option<bool>,
    /// The vector in multiples of m r ω² is half the sum of these, each times its coefficient, which is conjugated in a reverse one.
    sums: Vec<Sum>,
}

#[derive(Clone, Debug, Serialize)]
struct Sum {
    coefficient: String,
    terms: Vec<Term>,
}

#[derive(Clone, Debug, Serialize)]
struct Term {
    turn: String,
    weight: String,
}

/// What the main bearings feel as data, in newtons where the layout gives mass, crank radius and speed.
pub fn bearings_document(engine: &Engine, continuous: &BearingLoads, determinate: &BearingLoads) -> BearingsDocument {
    let unit = unit_of(continuous);
    BearingsDocument {
        title: engine.title().written().to_owned(),
        amplitudes: "zero-to-peak",
        sign: "the force that the bearing feels; y in the reference direction, x across it",
        unit: unit.name,
        newtons_per_multiple: continuous.scale.as_ref().map(|scale| scale.force()),
        pins: pins(engine, &orders_of(continuous), unit),
        continuous: solution(engine, continuous, unit),
        determinate: solution(engine, determinate, unit),
        with_gas: None,
    }
}

fn pins(engine: &Engine, orders: &[u32], unit: Unit) -> Vec<Pin> {
    let Ok(loads) = pin_loads(engine, orders) else { return Vec::new() };
    let pins = engine.cylinders().iter().zip(loads.pins).map(|(cylinder, pin)| Pin {
        cylinder: cylinder.name.clone(),
        position: pin.position.to_string(),
        peak: peak(&pin.peak, unit),
        along_the_throw: peak(&pin.along, unit),
        across_the_throw: peak(&pin.across, unit),
        orders: pin.orders.iter().map(|one| order(one.order, &one.sums, &one.swing, unit)).collect(),
    });
    pins.collect()
}

fn solution(engine: &Engine, loads: &BearingLoads, unit: Unit) -> Solution {
    let left_out = left_out_of_bearings(engine, loads).ok().flatten();
    let text = |parts: &Vec<num_rational::BigRational>| parts.iter().map(ToString::to_string).collect();
    let bearing = |(index, bearing): (usize, &BearingLoad)| Bearing {
        bearing: index + 1,
        position: bearing.position.to_string(),
        peak: peak(&bearing.peak, unit),
        y: peak(&bearing.along, unit),
        x: peak(&bearing.across, unit),
        orders: bearing.orders.iter().map(|one| order(one.order, &one.sums, &one.swing, unit)).collect(),
    };
    Solution {
        worst: loads.worst.iter().map(|index| index + 1).collect(),
        left_out: left_out.map(|bound| LeftOut { at_most: bound.most * unit.factor, part: bound.part() }),
        parts: loads.parts.iter().map(|(at, parts)| (at.to_string(), text(parts))).collect(),
        bearings: loads.bearings.iter().enumerate().map(bearing).collect(),
    }
}

fn peak(peak: &Peak, unit: Unit) -> PeakEntry {
    PeakEntry { value: peak.value * unit.factor, crank_angle_deg: peak.angle.filter(|_| peak.value > 0.0) }
}

fn order(order: u32, [direct, reverse]: &[OrderSum; 2], swing: &Swing, unit: Unit) -> Order {
    Order {
        order,
        largest: swing.largest() * unit.factor,
        direct: turning(&swing.direct, direct, unit),
        reverse: turning(&swing.reverse, reverse, unit),
    }
}

fn turning(vector: &Vector, sum: &OrderSum, unit: Unit) -> Turning {
    let vanishes = match vector.outcome {
        Outcome::Zero => Some(true),
        Outcome::NotZero => Some(false),
        Outcome::Undecided { .. } => None,
    };
    let terms = |sum: &crate::exact::PhasorSum| {
        sum.terms()
            .iter()
            .map(|term| Term { turn: term.angle.turns().to_string(), weight: term.weight.to_string() })
            .collect()
    };
    Turning {
        amplitude: vector.value.norm() / 2.0 * unit.factor,
        angle_deg: (vector.value.norm_sqr() > 0.0).then(|| numbers::degrees(vector.value)),
        vanishes,
        sums: sum
            .parts()
            .iter()
            .map(|(factor, sum)| Sum { coefficient: coefficient(factor), terms: terms(sum) })
            .collect(),
    }
}

/// `1`, or c_k or n_k of which rod.
fn coefficient(factor: &Factor) -> String {
    let (letter, mechanism) = match factor {
        Factor::One => return "1".to_owned(),
        Factor::Open | Factor::OpenTorque => return "c_k".to_owned(),
        Factor::Motion(mechanism) => ("c_k", mechanism),
        Factor::Quadrature(rod) => return format!("Im c_1 of λ = {}, δ = {}", rod.ratio, rod.offset),
        Factor::Torque(mechanism) => ("t_k", mechanism),
        // Without an offset it is all there is of n_k in an odd order.
        Factor::Side(mechanism) if mechanism.is_centric() => ("n_k", mechanism),
        Factor::Side(mechanism) => ("u_k", mechanism),
        Factor::Geared(speed, own) => return format!("{} of order k/{speed}", coefficient(own)),
        Factor::Linkage(linkage) => return format!("g_k of r/L = {}, κ = {}", linkage.ratio, linkage.knuckle),
        Factor::Corrected(linkage, _) => return format!("h_k of r/L = {}, κ = {}", linkage.ratio, linkage.knuckle),
    };
    match mechanism {
        Mechanism::SliderCrank(rod) => format!("{letter} of λ = {}, δ = {}", rod.ratio, rod.offset),
        Mechanism::Link(link) => format!("{letter} of a link, r/L = {}, κ = {}", link.ratio, link.knuckle),
    }
}
