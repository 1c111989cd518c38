//! What do documents of loads and comparisons hold beside their evidence? Numbers with their labels: no word of what is zero, and no truth.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::decimals::Decimal;
use super::format::Format;
use super::quantity::Quantity;

/// The document of `loads`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Loads {
    format: Format,
    pub title: String,
    amplitudes: Amplitudes,
    units: Units,
    pub scale: Option<Scale>,
    effects: Vec<Effect>,
    coefficients: Vec<Coefficient>,
    pub orders: Vec<LoadsOrder>,
    pub torque: Vec<LoadsTorque>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    roll: Vec<LoadsTorque>,
    largest: AllLargest,
    left_out: LeftOut,
    peaks: Peaks,
    coefficients_computed: u32,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    auto: Option<Auto>,
    /// Read and checked by itself.
    evidence: Value,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Amplitudes {
    ZeroToPeak,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Units {
    force: ForceUnit,
    moment: MomentUnit,
    torque: TorqueUnit,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum ForceUnit {
    #[serde(rename = "N")]
    Newton,
    #[serde(rename = "m r ω²")]
    Multiple,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum MomentUnit {
    #[serde(rename = "N m")]
    NewtonMetre,
    #[serde(rename = "N a")]
    NewtonSpacing,
    #[serde(rename = "m r ω² · 1 m")]
    MultipleMetre,
    #[serde(rename = "m r ω² a")]
    MultipleSpacing,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum TorqueUnit {
    #[serde(rename = "N m")]
    NewtonMetre,
    #[serde(rename = "m r² ω²")]
    Multiple,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Scale {
    mass_kg: Decimal,
    crank_radius_m: Decimal,
    speed_rpm: Decimal,
    angular_speed_rad_s: Decimal,
    /// 0 of an engine at rest.
    pub m_r_omega_squared_n: Decimal,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Effect {
    Reciprocating,
    Rotating,
    Crankshaft,
    Counterweights,
    Balancers,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Coefficient {
    order: u32,
    re: Decimal,
    im: Decimal,
}

/// One order of force or moment in `loads`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct LoadsOrder {
    pub quantity: Quantity,
    pub order: u32,
    pub direct: Vector,
    pub reverse: Vector,
    pub largest: Decimal,
    smallest: Decimal,
    direction_deg: Option<Decimal>,
    along: Decimal,
    across: Decimal,
    pub dimensionless: Decimal,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Vector {
    pub amplitude: Decimal,
    angle_deg: Option<Decimal>,
    below: Option<Decimal>,
}

/// One order of the torque, or of the roll moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct LoadsTorque {
    pub order: u32,
    pub amplitude: Decimal,
    phase_deg: Option<Decimal>,
    pub dimensionless: Decimal,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct AllLargest {
    force: Largest,
    moment: Largest,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    inertia_torque: Option<Largest>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Largest {
    value: Decimal,
    theta_deg: Option<Decimal>,
    error_bound: Decimal,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct LeftOut {
    force: Option<Bound>,
    moment: Option<Bound>,
    inertia_torque: Option<Bound>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Bound {
    at_most: Decimal,
    part: Option<Decimal>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Peaks {
    force: Peak,
    moment: Peak,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    torque: Option<Peak>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Peak {
    value: Decimal,
    crank_angle_deg: Option<Decimal>,
    effects: Vec<(Effect, Decimal)>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Auto {
    accuracy: Decimal,
    kept: Vec<u32>,
    dropped: Vec<u32>,
    torque_kept: Vec<u32>,
    torque_dropped: Vec<u32>,
    looked_at: u32,
}

/// The document of `compare`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Comparison {
    format: Format,
    pub orders: Vec<u32>,
    amplitudes: Amplitudes,
    pub engines: Vec<Compared>,
    /// Read and checked by itself.
    evidence: Value,
}

/// One engine of a comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Compared {
    pub title: String,
    position_unit: PositionUnit,
    firing: Option<Firing>,
    pub orders: Vec<ComparedOrder>,
    pub newtons: Option<Vec<Newtons>>,
    worst_bearings: Option<Worst>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    worst_bearing_with_gas: Option<Worst>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum PositionUnit {
    #[serde(rename = "m")]
    Metre,
    #[serde(rename = "spacing")]
    Spacing,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Firing {
    intervals_deg: Vec<Decimal>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct ComparedOrder {
    pub order: u32,
    pub force: Amount,
    pub moment: Amount,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Amount {
    pub largest: Option<Decimal>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Newtons {
    pub order: u32,
    force: Decimal,
    moment: Decimal,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Worst {
    bearings: Vec<u32>,
    peak: Decimal,
    unit: ForceUnit,
}
