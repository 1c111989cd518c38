//! What does `loads --json` hold? Vectors, ellipses, peaks; every amplitude zero to peak.

use num_complex::Complex;
use serde::Serialize;

use super::calculation::{Numbers, share};
use super::document::document;
use super::rising;
use crate::accuracy::Largest;
use crate::engine::Engine;
use crate::loads::{Arm, Bound, GroupLoads, Loads, Needed, OrderLoads, Outcome, Peak, Scale, Torque, Vector, Waveform};
use crate::order::{self, MassGroup};
use crate::proof::{Document, Format, LOADS_NOT_CHECKED, Planar, Quantity};
use crate::{numbers, verdict};

/// The loads of an engine as data.
#[derive(Clone, Debug, Serialize)]
pub struct LoadsDocument {
    /// Dispatches it among the documents that `verify` reads.
    format: Format,
    title: String,
    amplitudes: &'static str,
    units: Units,
    scale: Option<ScaleEntry>,
    effects: Vec<&'static str>,
    coefficients: Vec<CoefficientEntry>,
    pub(super) orders: Vec<OrderEntry>,
    pub(super) torque: Vec<TorqueEntry>,
    /// On the frame: −torque and the balancer shafts.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) roll: Vec<TorqueEntry>,
    /// Of the exact motion, all orders.
    pub(super) largest: LargestEntries,
    /// Of the orders that are listed.
    peaks: Peaks,
    /// What is not listed adds at most this, as a part of each peak; null where it might be all of it.
    pub(super) left_out: LeftOutEntry,
    coefficients_computed: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    auto: Option<AutoEntry>,
    /// The numbers that nothing is compared with.
    not_checked: [&'static str; LOADS_NOT_CHECKED.len()],
    /// The verdicts on the same masses and orders, with their certificates.
    evidence: Vec<Document>,
}

/// What the numbers are counted in.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Units {
    pub force: &'static str,
    pub moment: &'static str,
    pub torque: &'static str,
}

#[derive(Clone, Debug, Serialize)]
pub(in crate::report) struct ScaleEntry {
    mass_kg: f64,
    crank_radius_m: f64,
    speed_rpm: f64,
    angular_speed_rad_s: f64,
    m_r_omega_squared_n: f64,
}

impl ScaleEntry {
    pub(in crate::report) fn of(scale: &Scale) -> Self {
        ScaleEntry {
            mass_kg: numbers::float(&scale.mass),
            crank_radius_m: numbers::float(&scale.crank_radius),
            speed_rpm: numbers::float(&scale.speed),
            angular_speed_rad_s: scale.omega(),
            m_r_omega_squared_n: scale.force(),
        }
    }
}

#[derive(Clone, Debug, Serialize)]
struct CoefficientEntry {
    order: u32,
    re: f64,
    im: f64,
}

/// One order of the force or the moment.
#[derive(Clone, Debug, Serialize)]
pub(super) struct OrderEntry {
    pub(super) quantity: &'static str,
    pub(super) order: u32,
    /// Whether some piston or shaft has the order at all. In JSON the evidence says this, and what is zero.
    #[serde(skip)]
    pub(super) exists: bool,
    /// `true` proved zero, `false` proved not zero, none not decided.
    #[serde(skip)]
    pub(super) vanishes: Option<bool>,
    pub(super) direct: VectorEntry,
    pub(super) reverse: VectorEntry,
    pub(super) largest: f64,
    pub(super) smallest: f64,
    pub(super) direction_deg: Option<f64>,
    pub(super) along: f64,
    pub(super) across: f64,
    /// The largest length in multiples of m r ω² (times the unit of the positions).
    dimensionless: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct VectorEntry {
    pub(super) amplitude: f64,
    pub(super) angle_deg: Option<f64>,
    #[serde(skip)]
    pub(super) vanishes: Option<bool>,
    /// Where it is not decided whether it is zero: it is shorter than this.
    pub(super) below: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct TorqueEntry {
    pub(super) order: u32,
    #[serde(skip)]
    pub(super) vanishes: Option<bool>,
    pub(super) amplitude: f64,
    pub(super) phase_deg: Option<f64>,
    dimensionless: f64,
    #[serde(skip)]
    pub(super) below: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct Peaks {
    force: PeakEntry,
    moment: PeakEntry,
    #[serde(skip_serializing_if = "Option::is_none")]
    torque: Option<PeakEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct PeakEntry {
    value: f64,
    crank_angle_deg: Option<f64>,
    /// What each effect adds along the direction of the peak.
    effects: Vec<(&'static str, f64)>,
}

#[derive(Clone, Debug, Serialize)]
struct AutoEntry {
    /// As a part of each peak.
    accuracy: f64,
    kept: Vec<u32>,
    dropped: Vec<u32>,
    torque_kept: Vec<u32>,
    torque_dropped: Vec<u32>,
    looked_at: u32,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct LargestEntries {
    pub(super) force: LargestEntry,
    pub(super) moment: LargestEntry,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) inertia_torque: Option<LargestEntry>,
}

/// A largest value: the truth lies within the error bound of it.
#[derive(Clone, Debug, Serialize)]
pub(super) struct LargestEntry {
    pub(super) value: f64,
    pub(super) theta_deg: Option<f64>,
    pub(super) error_bound: f64,
    /// `true` proved zero at every order, `false` not zero, none not decided; no evidence of it is in the document.
    #[serde(skip)]
    pub(super) vanishes: Option<bool>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct LeftOutEntry {
    pub(super) force: Option<BoundEntry>,
    pub(super) moment: Option<BoundEntry>,
    pub(super) inertia_torque: Option<BoundEntry>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct BoundEntry {
    /// In the unit of the load.
    pub(super) at_most: f64,
    /// Of the peak; null where it might be all of it.
    part: Option<f64>,
}

fn bound_entry(bound: &Option<Bound>, factor: f64) -> Option<BoundEntry> {
    let bound = bound.as_ref()?;
    Some(BoundEntry { at_most: bound.most * factor, part: bound.part() })
}

fn largest_entry(largest: &Largest, factor: f64) -> LargestEntry {
    match *largest {
        Largest::Zero => LargestEntry { value: 0.0, theta_deg: None, error_bound: 0.0, vanishes: Some(true) },
        Largest::Known { value, angle, error } => LargestEntry {
            value: size(value, factor, false),
            theta_deg: angle,
            error_bound: error * factor,
            vanishes: Some(false),
        },
        // Between nothing and the bound.
        Largest::Below(bound) => {
            let middle = size(bound / 2.0, factor, false);
            LargestEntry { value: middle, theta_deg: None, error_bound: middle, vanishes: None }
        }
    }
}

/// The loads of an engine as data, in newtons where the layout gives mass, crank radius and speed.
pub fn loads_document(engine: &Engine, numbers: &Numbers, needed: Option<&Needed>) -> LoadsDocument {
    let Numbers { loads, largest, left } = numbers;
    let factor = loads.scale.as_ref().map_or(1.0, |scale| scale.force());
    let torque_factor = loads.scale.as_ref().map_or(1.0, |scale| scale.torque());
    let of = |quantity| loads.orders.iter().map(move |order| order_entry(quantity, order, engine, factor));
    let rows = Planar::BOTH.into_iter().flat_map(of);
    let coefficient = |order: &OrderLoads| {
        let c = order.coefficient.as_ref()?.to_complex();
        Some(CoefficientEntry { order: order.order, re: c.re, im: c.im })
    };
    let torque_orders = |torque: &Option<Torque>| -> Vec<TorqueEntry> {
        let orders = torque.iter().flat_map(|torque| &torque.orders).map(|order| TorqueEntry {
            order: order.order,
            vanishes: order.vector.outcome.vanishes(),
            amplitude: amplitude(&order.vector, torque_factor),
            phase_deg: angle(&order.vector),
            dimensionless: amplitude(&order.vector, 1.0),
            below: below(&order.vector).map(|below| size(below, torque_factor, false)),
        });
        orders.collect()
    };
    // Where nothing is decided, the middle between nothing and the bound.
    let entry = |peak: Peak, doubt: f64, effects, factor: f64, is_zero: bool| PeakEntry {
        value: size(peak.value.max(doubt / 4.0), factor, is_zero),
        crank_angle_deg: peak.angle,
        effects,
    };
    let planar = |quantity: Planar, waveform: &Waveform, part: fn(&GroupLoads) -> &Waveform| {
        let peak = waveform.peak();
        let shares = loads.groups.iter().map(|group| (effect_name(group.group), share(part(group), &peak) * factor));
        let doubt = loads.orders.iter().map(|order| order.swing(quantity).doubt()).sum();
        entry(peak, doubt, shares.collect(), factor, loads.orders.iter().all(|order| order.swing(quantity).vanishes()))
    };
    LoadsDocument {
        format: Format::Loads,
        not_checked: LOADS_NOT_CHECKED,
        evidence: vec![evidence(engine, loads)],
        title: engine.title().written().to_owned(),
        amplitudes: "zero-to-peak",
        units: units(engine, loads.scale.as_ref()),
        scale: loads.scale.as_ref().map(ScaleEntry::of),
        effects: loads.groups.iter().map(|group| effect_name(group.group)).collect(),
        coefficients: loads.orders.iter().filter_map(coefficient).collect(),
        orders: rows.collect(),
        torque: torque_orders(&loads.torque),
        roll: torque_orders(&loads.roll),
        largest: LargestEntries {
            force: largest_entry(&largest.force, factor),
            moment: largest_entry(&largest.moment, factor),
            inertia_torque: largest.torque.as_ref().map(|torque| largest_entry(torque, torque_factor)),
        },
        left_out: LeftOutEntry {
            force: bound_entry(&left.force, factor),
            moment: bound_entry(&left.moment, factor),
            inertia_torque: bound_entry(&left.torque, torque_factor),
        },
        peaks: Peaks {
            force: planar(Planar::Force, &loads.force, |group| &group.force),
            moment: planar(Planar::Moment, &loads.moment, |group| &group.moment),
            torque: loads.torque.as_ref().map(|torque| {
                let is_zero = torque.orders.iter().all(|order| order.vector.vanishes());
                let doubt = torque.orders.iter().map(|order| order.vector.doubt()).sum();
                entry(torque.waveform.real_peak(), doubt, Vec::new(), torque_factor, is_zero)
            }),
        },
        coefficients_computed: loads.coefficients,
        auto: needed.map(|needed| AutoEntry {
            accuracy: needed.accuracy,
            kept: needed.kept.clone(),
            dropped: needed.dropped.clone(),
            torque_kept: needed.torque_kept.clone(),
            torque_dropped: needed.torque_dropped.clone(),
            looked_at: needed.looked_at,
        }),
    }
}

impl LoadsDocument {
    /// The same without its proofs, which `verify` then does not take.
    pub fn without_evidence(self) -> Self {
        LoadsDocument { evidence: Vec::new(), ..self }
    }
}

/// The verdicts that the zeros of these loads are.
fn evidence(engine: &Engine, loads: &Loads) -> Document {
    let masses = order::masses_as_built(engine);
    let mut orders: Vec<u32> = loads.orders.iter().map(|order| order.order).collect();
    let mut quantities = vec![Quantity::FORCE, Quantity::MOMENT];
    if let Some(torque) = &loads.torque {
        orders.extend(torque.orders.iter().map(|order| order.order));
        orders = rising(orders);
        quantities.push(Quantity::TORQUE);
    }
    if loads.roll.as_ref().is_some_and(|roll| !roll.orders.is_empty()) {
        quantities.push(Quantity::ROLL);
    }
    let judged = verdict::classify(engine, &orders, masses, &quantities)
        .unwrap_or_else(|number| unreachable!("loads are those of orders: {number}"));
    document(engine, masses, &judged, &quantities, None)
}

fn order_entry(quantity: Planar, order: &OrderLoads, engine: &Engine, factor: f64) -> OrderEntry {
    let swing = order.swing(quantity);
    let vector = |vector: &Vector| VectorEntry {
        amplitude: amplitude(vector, factor / 2.0),
        angle_deg: angle(vector),
        vanishes: vector.outcome.vanishes(),
        below: below(vector).map(|below| size(below / 2.0, factor, false)),
    };
    let (direct, reverse) = (vector(&swing.direct), vector(&swing.reverse));
    let is_zero = [&direct, &reverse].into_iter().all(|one| one.vanishes == Some(true));
    let largest = (length(&swing.direct) + length(&swing.reverse)) / 2.0;
    OrderEntry {
        quantity: quantity.name(),
        order: order.order,
        exists: order.exists(engine),
        vanishes: verdict::both_vanish(direct.vanishes, reverse.vanishes),
        largest: size(largest, factor, is_zero),
        direct,
        reverse,
        smallest: if swing.path.is_line { 0.0 } else { swing.smallest() * factor },
        direction_deg: swing.direction(),
        along: if swing.path.nothing_along { 0.0 } else { swing.along() * factor },
        across: if swing.path.nothing_across { 0.0 } else { swing.across() * factor },
        dimensionless: size(largest, 1.0, is_zero),
    }
}

fn amplitude(vector: &Vector, factor: f64) -> f64 {
    size(length(vector), factor, vector.vanishes())
}

/// The length; of one that is not decided the middle between nothing and its bound.
fn length(vector: &Vector) -> f64 {
    below(vector).map_or(vector.value.norm(), |below| below / 2.0)
}

fn below(vector: &Vector) -> Option<f64> {
    if let Outcome::Undecided { below } = vector.outcome { Some(below) } else { None }
}

/// 0 says that it is proved to be zero, or that the engine is at rest: all else has a decimal above it, however small it is.
pub(super) fn size(multiple: f64, unit: f64, is_zero: bool) -> f64 {
    if is_zero || unit == 0.0 { 0.0 } else { (multiple * unit).max(f64::MIN_POSITIVE) }
}

fn angle(vector: &Vector) -> Option<f64> {
    (vector.value != Complex::new(0.0, 0.0)).then(|| numbers::degrees(vector.value))
}

/// The word of an effect in the JSON document.
pub(super) fn effect_name(effect: MassGroup) -> &'static str {
    match effect {
        MassGroup::Reciprocating => "reciprocating",
        MassGroup::Rotating => "rotating",
        MassGroup::Crankshaft => "crankshaft",
        MassGroup::Counterweights => "counterweights",
        MassGroup::Balancers => "balancers",
    }
}

pub(super) fn units(engine: &Engine, scale: Option<&Scale>) -> Units {
    match (scale, Arm::of(engine)) {
        (Some(_), Arm::Metre) => Units { force: "N", moment: "N m", torque: "N m" },
        (Some(_), Arm::Spacing) => Units { force: "N", moment: "N a", torque: "N m" },
        (None, Arm::Metre) => Units { force: "m r ω²", moment: "m r ω² · 1 m", torque: "m r² ω²" },
        (None, Arm::Spacing) => Units { force: "m r ω²", moment: "m r ω² a", torque: "m r² ω²" },
    }
}
