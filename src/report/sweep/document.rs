//! What does the JSON of a sweep hold? The points with their proofs of zero, and the exact zeros.

use serde::Serialize;

use super::assumptions::assumptions;
use super::words::{exact, named, quantities, quantity_name, unit, zeros_name};
use crate::proof::Quantity;
use crate::sweep::{Sweep, ZeroSet};

/// A sweep as data.
#[derive(Clone, Debug, Serialize)]
pub struct SweepDocument {
    title: String,
    parameters: Vec<ParameterEntry>,
    orders: Vec<u32>,
    amplitudes: &'static str,
    force_unit: String,
    moment_unit: String,
    /// Null where the parameter is no angle.
    zeros: Option<Vec<ZeroEntry>>,
    points: Vec<PointEntry>,
    assumptions: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct ParameterEntry {
    key: String,
    unit: String,
}

#[derive(Clone, Debug, Serialize)]
struct ZeroEntry {
    order: u32,
    quantity: &'static str,
    of: &'static str,
    everywhere: bool,
    /// Exact values in the unit of the parameter.
    at: Vec<String>,
    /// Whether they are proved to be all in the range.
    complete: bool,
}

#[derive(Clone, Debug, Serialize)]
struct PointEntry {
    values: Vec<String>,
    orders: Vec<OrderEntry>,
    newtons_per_multiple: Option<f64>,
    firing: Option<FiringEntry>,
    counterweight: Option<AmplitudeEntry>,
    envelope: Option<EnvelopeEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct OrderEntry {
    order: u32,
    quantity: &'static str,
    #[serde(flatten)]
    parts: std::collections::BTreeMap<&'static str, AmplitudeEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct AmplitudeEntry {
    value: f64,
    proved_zero: bool,
}

/// Intervals in turns of the crank.
#[derive(Clone, Debug, Serialize)]
struct FiringEntry {
    longest: String,
    shortest: String,
    unevenness: String,
    of_the_file: bool,
}

/// In crank radii.
#[derive(Clone, Debug, Serialize)]
struct EnvelopeEntry {
    length: Option<f64>,
    breadth: f64,
    height: f64,
    metres_per_crank_radius: Option<f64>,
}

/// A sweep as data.
pub fn sweep_document(sweep: &Sweep) -> SweepDocument {
    let parameter = |parameter: &crate::sweep::Parameter| ParameterEntry {
        key: parameter.key.to_string(),
        unit: parameter.range.unit().to_owned(),
    };
    SweepDocument {
        title: sweep.title.written().to_owned(),
        parameters: sweep.parameters.iter().map(parameter).collect(),
        orders: sweep.orders.clone(),
        amplitudes: "zero-to-peak",
        force_unit: unit(sweep, Quantity::Force),
        moment_unit: unit(sweep, Quantity::Moment),
        zeros: sweep.zeros.as_ref().map(|sets| sets.iter().map(zeros).collect()),
        points: sweep.points.iter().map(point).collect(),
        assumptions: assumptions(&sweep.geometry).map(|line| line.plain()).into(),
    }
}

fn zeros(set: &ZeroSet) -> ZeroEntry {
    ZeroEntry {
        order: set.order,
        quantity: quantity_name(set.quantity),
        of: zeros_name(set.of),
        everywhere: set.everywhere,
        at: set.at.iter().map(exact).collect(),
        complete: set.complete,
    }
}

fn point(point: &crate::sweep::SweptEngine) -> PointEntry {
    let amplitude = |part: crate::sweep::Amplitude| AmplitudeEntry { value: part.value, proved_zero: part.vanishes };
    let orders = point.orders.iter().flat_map(|order| {
        quantities(order).map(|(quantity, amplitudes)| OrderEntry {
            order: order.order,
            quantity: quantity_name(quantity),
            parts: named(amplitudes).into_iter().map(|(name, part)| (name, amplitude(part))).collect(),
        })
    });
    PointEntry {
        values: point.values.iter().map(exact).collect(),
        orders: orders.collect(),
        newtons_per_multiple: point.newtons,
        firing: point.evenness.as_ref().map(|firing| FiringEntry {
            longest: firing.longest.to_string(),
            shortest: firing.shortest.to_string(),
            unevenness: firing.unevenness().to_string(),
            of_the_file: firing.of_the_file,
        }),
        counterweight: point.counterweight.map(amplitude),
        envelope: point.envelope.map(|envelope| EnvelopeEntry {
            length: envelope.length,
            breadth: envelope.breadth,
            height: envelope.height,
            metres_per_crank_radius: envelope.metres,
        }),
    }
}
