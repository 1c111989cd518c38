//! What does the JSON of a sweep hold? The points with their proofs of zero, and the exact zeros.

use num_rational::BigRational;
use serde::Serialize;

use super::assumptions::assumptions;
use super::words::{exact, quantities, unit, zeros_name};
use crate::numbers::float;
use crate::proof::Planar;
use crate::sweep::{FiringZeros, Sweep, ZeroSet};

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
    /// Where the firing stars vanish, where they are asked for and the parameter is an angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    firing_zeros: Option<Vec<FiringZeroEntry>>,
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
    /// Decimals of those at no rational turn, in the same unit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    irrational: Vec<f64>,
    /// Whether they are proved to be all in the range.
    complete: bool,
}

#[derive(Clone, Debug, Serialize)]
struct FiringZeroEntry {
    order: String,
    /// Whether the cylinders can fire as the layout says somewhere in the range.
    fires: bool,
    everywhere: bool,
    /// Exact values in the unit of the parameter.
    at: Vec<String>,
    /// Decimals of those at no rational turn, in the same unit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    irrational: Vec<f64>,
    /// Whether they are proved to be all in the range.
    complete: bool,
}

/// The length of a firing star in crank radii; null where the cylinders cannot fire as the layout says.
#[derive(Clone, Debug, Serialize)]
struct FiringStarEntry {
    order: String,
    length: Option<AmplitudeEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct PointEntry {
    values: Vec<String>,
    orders: Vec<OrderEntry>,
    newtons_per_multiple: Option<f64>,
    firing: Option<FiringEntry>,
    counterweight: Option<AmplitudeEntry>,
    envelope: Option<EnvelopeEntry>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    firing_stars: Vec<FiringStarEntry>,
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
        force_unit: unit(sweep, Planar::Force),
        moment_unit: unit(sweep, Planar::Moment),
        zeros: sweep.zeros.as_ref().map(|sets| sets.iter().map(zeros).collect()),
        firing_zeros: sweep
            .firing
            .as_ref()
            .and_then(|firing| Some(firing.zeros.as_ref()?.iter().map(firing_zeros).collect())),
        points: (0..sweep.points.len()).map(|index| point(sweep, index)).collect(),
        assumptions: assumptions(&sweep.geometry).map(|line| line.plain()).into(),
    }
}

fn zeros(set: &ZeroSet) -> ZeroEntry {
    ZeroEntry {
        order: set.order,
        quantity: set.quantity.name(),
        of: zeros_name(set.of),
        everywhere: set.everywhere,
        at: set.at.iter().map(exact).collect(),
        irrational: set.irrational.iter().map(middle).collect(),
        complete: set.complete,
    }
}

fn middle([low, high]: &[BigRational; 2]) -> f64 {
    float(&((low + high) / BigRational::from_integer(2.into())))
}

fn firing_zeros(zeros: &FiringZeros) -> FiringZeroEntry {
    FiringZeroEntry {
        order: zeros.order.exact().to_string(),
        fires: zeros.fires,
        everywhere: zeros.everywhere,
        at: zeros.at.iter().map(exact).collect(),
        irrational: zeros.irrational.iter().map(middle).collect(),
        complete: zeros.complete,
    }
}

fn point(sweep: &Sweep, index: usize) -> PointEntry {
    let point = &sweep.points[index];
    let stars = sweep.firing.iter().flat_map(|firing| firing.orders.iter().zip(&firing.points[index]));
    let amplitude = |part: crate::sweep::Amplitude| AmplitudeEntry { value: part.value, proved_zero: part.vanishes };
    let orders = point.orders.iter().flat_map(|order| {
        quantities(order).map(|(quantity, amplitudes)| OrderEntry {
            order: order.order,
            quantity: quantity.name(),
            parts: amplitudes.named().into_iter().map(|(name, part)| (name, amplitude(part))).collect(),
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
        firing_stars: stars
            .map(|(order, star)| FiringStarEntry { order: order.exact().to_string(), length: star.map(amplitude) })
            .collect(),
    }
}
