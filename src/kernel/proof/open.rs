//! What does `classify --json` say of a family? Where an angle or a length is open, when each sum vanishes.

use std::collections::BTreeMap;

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::alternative::AlternativeClaim;
use super::boxes::BoxesClaim;
use super::certificate::Certificate;
use super::circle::{CircleClaim, CoprimeClaim};
use super::engine::Masses;
use super::format::Format;
use super::fraction;
use super::plane::{ClassesClaim, TriangleClaim};
use super::quadratic::QuadraticClaim;
use super::quantity::{Quantity, Sense};
use super::vector::Vector;

/// The verdicts on a family: the JSON document of `classify --json` where an angle or a length is open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpenDocument {
    /// `crankstar family 2`.
    pub format: Format,
    /// Title of the layout: free text.
    pub title: String,
    /// Whose masses the verdicts are about: the reciprocating ones.
    pub masses: Masses,
    /// The orders that were asked for, rising.
    pub orders: Vec<u32>,
    /// The quantities that were asked for: force and moment.
    pub quantities: Vec<Quantity>,
    /// Position of the plane that moments are taken about.
    pub reference_plane: LinearClaim,
    /// The cylinders that the terms come from.
    pub cylinders: Vec<OpenCylinder>,
    /// One verdict per order, quantity and sense, in this order.
    pub open_verdicts: Vec<OpenVerdictClaim>,
}

/// An exact number in JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Exact(#[serde(with = "fraction")] pub BigRational);

/// A linear expression: coefficients by symbol; the known part under `"1"`.
pub type LinearClaim = BTreeMap<String, Exact>;

/// A cylinder of a family: angles in turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpenCylinder {
    /// What the cylinder is called.
    pub name: String,
    /// Crank-throw angle β.
    pub throw: LinearClaim,
    /// Angle α of the cylinder axis.
    pub bank: LinearClaim,
    /// Position along the crankshaft.
    pub position: LinearClaim,
    /// Reciprocating mass.
    #[serde(with = "fraction")]
    pub reciprocating_mass: BigRational,
    /// Crank radius, in multiples of a common radius.
    #[serde(with = "fraction")]
    pub crank_radius: BigRational,
}

/// When one quantity, order and sense vanishes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpenVerdictClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// One sum for the known lengths and one an open length, by name, of those that have a weight: it vanishes for all
    /// lengths where all of them do.
    pub sums: Vec<SumClaim>,
}

/// The part of a sum that one length multiplies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SumClaim {
    /// The open length; none for the known lengths, and for the force.
    pub symbol: Option<String>,
    /// The sums by the multiples of φ and δ before them, rising.
    pub parts: Vec<PartClaim>,
    /// When it vanishes.
    pub when: WhenClaim,
}

/// `e^{i(phi·φ + delta·δ)}` times a sum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartClaim {
    /// How many times φ enters.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// The sum without unknowns, one term per cylinder that has this factor.
    pub terms: Vec<Vector>,
    /// Evidence that the sum is zero, or that it is not.
    pub certificate: Certificate,
}

/// When a sum vanishes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum WhenClaim {
    /// For all angles: every part is zero.
    Always,
    /// For no angle: one part is left.
    Never,
    /// For no angle: two parts are left, and `|S_1|² − |S_2|²` is not zero.
    UnequalLengths {
        /// The evidence.
        certificate: Certificate,
    },
    /// Exactly where one of the alternatives holds.
    Where {
        /// One for two parts, two for three.
        alternatives: Vec<AlternativeClaim>,
        /// For three parts: evidence that `|S_1|² − |S_j|²` is zero; for two there is none, as the alternative shows it.
        equal_lengths: Vec<Certificate>,
    },
    /// Exactly where a cosine has a value.
    Cosine(Box<CosineClaim>),
    /// For no angle: parts in one unknown, which have no zero on the circle.
    Coprime(Box<CoprimeClaim>),
    /// Where the arcs say so: parts in one unknown.
    Circle(Box<CircleClaim>),
    /// Where three parts in two unknowns make a triangle.
    Triangle(Box<TriangleClaim>),
    /// Where two classes of parts in two unknowns are equally long and opposite.
    Classes(Box<ClassesClaim>),
    /// Where three classes of parts in two unknowns cancel.
    Quadratic(Box<QuadraticClaim>),
    /// At the zeros of boxes into which the torus is cut: parts in two unknowns.
    Boxes(Box<BoxesClaim>),
    /// Where one of two sums vanishes whose product it is.
    Product(Box<ProductClaim>),
    /// Two parts of equal length that cancel at an angle for which no rational turn is claimed.
    EqualLengths {
        /// Evidence that `|S_1|² − |S_2|²` is zero.
        certificate: Certificate,
    },
    /// No claim: two unknowns that enter in another way, or one too many times.
    NotSolved,
}

/// Exactly where `cos(phi·φ + delta·δ + turn)` is `cosine`: of three parts two are `−1/(2 cosine)` of the one in the middle,
/// turned by `turn` and back.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CosineClaim {
    /// Which of the parts that do not vanish is the one in the middle.
    pub middle: usize,
    /// How many times φ enters.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// What is added to them, in turns.
    #[serde(with = "fraction")]
    pub turn: BigRational,
    /// The value of the cosine.
    #[serde(with = "fraction")]
    pub cosine: BigRational,
    /// Evidence for the other two parts, in their order.
    pub multiples: [Certificate; 2],
}

/// All parts in groups that are multiples of each other: the sum is that of one group, times that of the first parts of all, up to a
/// factor that is not zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProductClaim {
    /// The places of the parts of each group among those that do not vanish.
    pub groups: Vec<Vec<usize>>,
    /// Evidence that `S_{gj} S_{00} − S_{g0} S_{0j}` is zero, group by group from the second on, for every part but the first of each.
    pub certificates: Vec<Certificate>,
    /// When the parts of the first group cancel.
    pub group: WhenClaim,
    /// When the first parts of all groups cancel.
    pub firsts: WhenClaim,
}
