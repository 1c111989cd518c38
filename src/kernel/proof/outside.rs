//! What do documents of loads and comparisons hold beside their evidence? Numbers with their labels: no word of what is zero, and no truth.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::decimals::{Decimal, Size};
use super::format::Format;
use super::quantity::Quantity;

/// The numbers of `loads` that nothing is compared with; the document names them itself.
pub const LOADS_NOT_CHECKED: [&str; 6] =
    ["units.moment", "largest", "left_out", "peaks", "coefficients_computed", "auto"];
/// The same of `compare`.
pub const COMPARE_NOT_CHECKED: [&str; 4] = ["position_unit", "firing", "worst_bearings", "worst_bearing_with_gas"];

/// The document of `loads`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Loads {
    format: Format,
    pub title: String,
    amplitudes: Amplitudes,
    pub units: Units,
    pub scale: Option<Scale>,
    pub effects: Vec<Effect>,
    pub coefficients: Vec<Coefficient>,
    pub orders: Vec<LoadsOrder>,
    pub torque: Vec<LoadsTorque>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub roll: Vec<LoadsTorque>,
    pub largest: AllLargest,
    left_out: LeftOut,
    pub peaks: Peaks,
    coefficients_computed: u32,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub auto: Option<Auto>,
    pub not_checked: Vec<String>,
    /// Read and checked by itself.
    evidence: Value,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Amplitudes {
    ZeroToPeak,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Units {
    force: ForceUnit,
    moment: MomentUnit,
    torque: TorqueUnit,
}

impl Units {
    /// Whether each is one of newtons; none where some are and some are not.
    pub(super) fn are_newtons(&self) -> Option<bool> {
        let force = self.force == ForceUnit::Newton;
        let moment = matches!(self.moment, MomentUnit::NewtonMetre | MomentUnit::NewtonSpacing);
        let torque = self.torque == TorqueUnit::NewtonMetre;
        (force == moment && moment == torque).then_some(force)
    }
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
    pub mass_kg: Size,
    pub crank_radius_m: Size,
    /// 0 of an engine at rest.
    pub speed_rpm: Size,
    pub angular_speed_rad_s: Size,
    pub m_r_omega_squared_n: Size,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Effect {
    Reciprocating,
    Rotating,
    Crankshaft,
    Counterweights,
    Balancers,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Coefficient {
    pub order: u32,
    pub re: Decimal,
    pub im: Decimal,
}

/// One order of force or moment in `loads`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct LoadsOrder {
    pub quantity: Quantity,
    pub order: u32,
    pub direct: Vector,
    pub reverse: Vector,
    pub largest: Size,
    pub smallest: Size,
    pub direction_deg: Option<Decimal>,
    pub along: Size,
    pub across: Size,
    pub dimensionless: Size,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Vector {
    pub amplitude: Size,
    pub angle_deg: Option<Decimal>,
    pub below: Option<Size>,
}

/// One order of the torque, or of the roll moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct LoadsTorque {
    pub order: u32,
    pub amplitude: Size,
    pub phase_deg: Option<Decimal>,
    pub dimensionless: Size,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct AllLargest {
    pub force: Largest,
    pub moment: Largest,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia_torque: Option<Largest>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Largest {
    pub value: Size,
    theta_deg: Option<Decimal>,
    error_bound: Size,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct LeftOut {
    force: Option<Bound>,
    moment: Option<Bound>,
    inertia_torque: Option<Bound>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Bound {
    at_most: Size,
    part: Option<Size>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Peaks {
    pub force: Peak,
    pub moment: Peak,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torque: Option<Peak>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Peak {
    pub value: Size,
    crank_angle_deg: Option<Decimal>,
    pub effects: Vec<(Effect, Decimal)>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Auto {
    accuracy: Size,
    pub kept: Vec<u32>,
    pub dropped: Vec<u32>,
    pub torque_kept: Vec<u32>,
    pub torque_dropped: Vec<u32>,
    looked_at: u32,
}

/// The document of `compare`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Comparison {
    format: Format,
    pub orders: Vec<u32>,
    amplitudes: Amplitudes,
    pub engines: Vec<Compared>,
    pub not_checked: Vec<String>,
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
    pub scale: Option<Scale>,
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
    intervals_deg: Vec<Size>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct ComparedOrder {
    pub order: u32,
    pub force: Amount,
    pub moment: Amount,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Amount {
    pub largest: Option<Size>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Newtons {
    pub order: u32,
    pub force: Size,
    pub moment: Size,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Worst {
    bearings: Vec<u32>,
    peak: Size,
    unit: ForceUnit,
}
