//! What does `accuracy --json` hold? For each rod ratio and load: the peak, guaranteed, and what each method finds.

use num_rational::BigRational;
use serde::Serialize;

use super::engine_torque::PeakRow;
use super::{AccuracyCase, methods};
use crate::accuracy::{BearingMethod, BearingRow, Method, Row, Study};
use crate::engine::Engine;
use crate::proof::Quantity;
use crate::torque::PeakMethod;

/// The methods and their errors as data.
#[derive(Clone, Debug, Serialize)]
pub struct AccuracyDocument {
    title: String,
    cases: Vec<Case>,
}

#[derive(Clone, Debug, Serialize)]
struct Case {
    rod_ratio: Option<String>,
    loads: Vec<Load>,
    /// The largest bearing load of inertia, in the unit of the force.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bearings: Vec<FurtherEntry>,
    /// The largest torque of gas and inertia in newton-metres.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    engine_torque: Vec<FurtherEntry>,
    /// The largest bearing load of gas and masses in newtons.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bearings_with_gas: Vec<FurtherEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct FurtherEntry {
    method: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    setting: Option<f64>,
    value: f64,
    error: f64,
    /// The largest error anywhere in the cycle, which the bound of the torque is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    farthest: Option<f64>,
    bound: Option<f64>,
    seconds: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct Load {
    quantity: &'static str,
    unit: &'static str,
    /// Units a multiple: the ends of the peak are in multiples.
    multiple: f64,
    vanishes: bool,
    /// Rounded outward behind the fortieth place.
    peak_low: String,
    peak_high: String,
    rounding: f64,
    /// The peak is known to this part of itself.
    reference_error: f64,
    methods: Vec<Entry>,
}

#[derive(Clone, Debug, Serialize)]
struct Entry {
    method: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    setting: Option<u32>,
    value: f64,
    error: f64,
    /// Whether the reference is too coarse to tell the error.
    below_reference_error: bool,
    bound: Option<f64>,
    looked_at: Option<usize>,
    seconds: Option<f64>,
    on_front: bool,
}

/// The methods and their errors as data; errors and bounds are parts of the peak.
pub fn accuracy_document(engine: &Engine, cases: &[AccuracyCase]) -> AccuracyDocument {
    let case = |case: &AccuracyCase| Case {
        rod_ratio: case.ratio.as_ref().map(BigRational::to_string),
        loads: case.studies.iter().map(|study| load(engine, study)).collect(),
        bearings: case.bearings.iter().flatten().map(|row| bearing_entry(engine, row)).collect(),
        engine_torque: case.engine_torque.iter().flatten().map(of_gas).collect(),
        bearings_with_gas: case.gas_bearings.iter().flatten().map(of_gas).collect(),
    };
    AccuracyDocument { title: engine.title().written().to_owned(), cases: cases.iter().map(case).collect() }
}

fn bearing_entry(engine: &Engine, row: &BearingRow) -> FurtherEntry {
    let (_, multiple) = methods::unit(engine, Quantity::FORCE);
    let (method, setting) = match row.method {
        BearingMethod::Orders(order) => ("orders", Some(f64::from(order))),
        BearingMethod::Angles(steps) => ("closed form", Some(f64::from(steps))),
        BearingMethod::ClosedForm => ("closed form, refined", None),
    };
    let (value, seconds) = (row.value * multiple, row.time.map(|time| time.as_secs_f64()));
    FurtherEntry { method, setting, value, error: row.error, farthest: None, bound: row.bound, seconds }
}

fn of_gas(row: &PeakRow) -> FurtherEntry {
    let (method, setting) = match row.method {
        PeakMethod::Orders(order) => ("orders of the gas", Some(f64::from(order.halves()) / 2.0)),
        PeakMethod::Samples(steps) => ("time law", Some(f64::from(steps))),
        PeakMethod::TimeLaw => ("time law, refined", None),
    };
    let seconds = row.time.map(|time| time.as_secs_f64());
    FurtherEntry {
        method,
        setting,
        value: row.value,
        error: row.error,
        farthest: row.farthest,
        bound: row.bound,
        seconds,
    }
}

/// The name of a load in the document.
fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE => "force",
        Quantity::MOMENT => "moment",
        Quantity::Axial(_) => "inertia torque",
    }
}

fn load(engine: &Engine, study: &Study) -> Load {
    let (unit, multiple) = methods::unit(engine, study.quantity);
    let front = methods::front(study);
    let entry = |(place, row): (usize, &Row)| {
        let (method, setting) = match row.method {
            Method::Orders(order) => ("orders", Some(order)),
            Method::Doubles(steps) => ("closed form, 64 bits", Some(steps)),
            Method::Intervals(digits) => ("intervals", Some(digits)),
            Method::Fractions => ("intervals of fractions", None),
        };
        Entry {
            method,
            setting,
            value: row.value * multiple,
            error: row.error,
            below_reference_error: study.is_below_reference(row),
            bound: row.bound,
            looked_at: row.looked_at,
            seconds: row.time.map(|time| time.as_secs_f64()),
            on_front: front.contains(&place),
        }
    };
    Load {
        quantity: name(study.quantity),
        unit,
        multiple,
        vanishes: study.rows.is_empty(),
        peak_low: methods::decimals(&study.peak.low, false),
        peak_high: methods::decimals(&study.peak.high, true),
        rounding: study.rounding,
        reference_error: study.doubt,
        methods: study.rows.iter().enumerate().map(entry).collect(),
    }
}
