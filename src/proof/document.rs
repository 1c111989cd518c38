//! What does `classify --json` say, and does all of it hold together?

use std::collections::BTreeSet;
use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::check::check_certificate;
use super::fraction;
use super::theorem::{TheoremClaim, check_theorem};

/// The verdicts on one engine, each with its certificate: the JSON document of `classify --json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Document {
    /// Title of the layout.
    pub title: String,
    /// Position along the crankshaft that the moments are taken about, in metres (or multiples of the spacing).
    #[serde(with = "fraction")]
    pub reference_plane: BigRational,
    /// The engine that the terms come from; may be left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cylinders: Vec<Cylinder>,
    /// One verdict a quantity, order and sense.
    pub verdicts: Vec<VerdictClaim>,
    /// The shape of what is left, one a quantity and order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shapes: Vec<ShapeClaim>,
    /// The statements on every order, one a quantity and sense, where they were asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub theorems: Vec<TheoremClaim>,
}

/// A cylinder as the phasors see it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cylinder {
    /// What the cylinder is called.
    pub name: String,
    /// Crank-throw angle β, in turns.
    #[serde(with = "fraction")]
    pub throw: BigRational,
    /// Angle α of the cylinder axis, in turns.
    #[serde(with = "fraction")]
    pub bank: BigRational,
    /// Position along the crankshaft, in the unit of the reference plane.
    #[serde(with = "fraction")]
    pub position: BigRational,
    /// Reciprocating mass, in kilograms (or multiples of a common mass).
    #[serde(with = "fraction")]
    pub reciprocating_mass: BigRational,
    /// Crank radius, in multiples of a common radius; 1 if left out.
    #[serde(with = "fraction", default = "one", skip_serializing_if = "One::is_one")]
    pub crank_radius: BigRational,
}

/// The crank radius of a document that names none.
pub(super) fn one() -> BigRational {
    BigRational::one()
}

/// What a verdict is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Quantity {
    /// The shaking force.
    Force,
    /// The moment of the shaking forces about the reference plane.
    Moment,
    /// The inertia torque on the crankshaft.
    Torque,
}

/// Which way a vector turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sense {
    /// With the crank, `e^{ikθ}`.
    Direct,
    /// Against the crank, `e^{−ikθ}`.
    Reverse,
}

/// What is left of one order of the force or the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// Both vectors vanish.
    Balanced,
    /// Only the direct vector is left: constant length, turning with the crank.
    Rotating,
    /// Only the reverse vector is left: constant length, turning against the crank.
    CounterRotating,
    /// Vectors of equal length: the resultant swings along a line.
    Planar,
    /// Vectors of different length: the resultant traces an ellipse.
    Elliptical,
}

/// One term of a sum: `weight · e^{2πi·angle}`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Vector {
    /// Direction, in turns.
    #[serde(with = "fraction")]
    pub angle: BigRational,
    /// Length, of either sign.
    #[serde(with = "fraction")]
    pub weight: BigRational,
}

/// A decimal for reading; no verdict is made from it.
#[expect(clippy::disallowed_types, reason = "decimals beside a verdict are shown and never used")]
pub type Decimal = f64;

/// A verdict with its evidence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerdictClaim {
    /// What the verdict is about.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse; none for the torque.
    pub sense: Option<Sense>,
    /// The cylinders that it is about, by name, where the engine has rods that differ: the others have weight 0.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub of: Vec<String>,
    /// Whether the sum is zero.
    pub vanishes: bool,
    /// The sum, one term a cylinder, before collecting.
    pub terms: Vec<Vector>,
    /// `|S|`, approximately.
    pub modulus: Decimal,
    /// The direction of S in degrees, in `(−180, 180]`, approximately; none where S is zero.
    pub angle_deg: Option<Decimal>,
    /// The evidence.
    pub certificate: Certificate,
}

/// The shape of what is left of one order, with the evidence that tells planar from elliptical.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShapeClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// The cylinders that it is about, as in the verdicts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub of: Vec<String>,
    /// The shape.
    pub shape: Shape,
    /// Where neither vector vanishes: evidence that `|direct|² − |reverse|²` is zero (planar) or is not (elliptical).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
}

/// What is wrong with a document: where, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Which entry, as in `verdicts[3] (force, order 2, direct)`.
    pub place: String,
    /// What is wrong with it.
    pub reason: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.reason)
    }
}

impl std::error::Error for Fault {}

/// Checks every certificate of a document, that the terms are those of its cylinders, and that the decimals fit.
///
/// Returns how many certificates were checked.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_document(document: &Document) -> Result<usize, Fault> {
    if document.verdicts.is_empty() {
        return Err(Fault { place: "verdicts".into(), reason: "the list is empty, there is nothing to check".into() });
    }
    let mut checked = 0;
    for (index, verdict) in document.verdicts.iter().enumerate() {
        check_verdict(document, verdict).map_err(|reason| Fault { place: verdict_place(index, verdict), reason })?;
        checked += 1;
    }
    if let Some((index, verdict)) = repeated(&document.verdicts) {
        let reason = "this verdict is in the list twice".into();
        return Err(Fault { place: verdict_place(index, verdict), reason });
    }
    for (index, claim) in document.shapes.iter().enumerate() {
        let place = || format!("shapes[{index}] ({}, order {})", claim.quantity.name(), claim.order);
        check_shape(document, claim).map_err(|reason| Fault { place: place(), reason })?;
        checked += usize::from(claim.certificate.is_some());
    }
    let mut subjects = BTreeSet::new();
    for (index, claim) in document.theorems.iter().enumerate() {
        let place = || format!("theorems[{index}] ({}, {})", claim.quantity.name(), claim.sense.name());
        check_theorem(document, claim).map_err(|reason| Fault { place: place(), reason })?;
        if !subjects.insert((claim.quantity, claim.sense)) {
            return Err(Fault { place: place(), reason: "this theorem is in the list twice".into() });
        }
        checked += claim.verdicts.len();
    }
    Ok(checked)
}

impl Document {
    /// Theory, section 3: direct `kβ − (k−1)α`, reverse `−kβ + (k+1)α`, torque `k(β − α)`; weights m r, the moment's
    /// times the arm, the torque's times r.
    pub(super) fn terms(&self, quantity: Quantity, order: u32, sense: Option<Sense>) -> Vec<Vector> {
        let k = BigRational::from_integer(BigInt::from(order));
        let one = BigRational::from_integer(1.into());
        let term = |cylinder: &Cylinder| {
            let angle = match sense {
                None => &k * (&cylinder.throw - &cylinder.bank),
                Some(Sense::Direct) => &k * &cylinder.throw - (&k - &one) * &cylinder.bank,
                Some(Sense::Reverse) => (&k + &one) * &cylinder.bank - &k * &cylinder.throw,
            };
            let arm = match quantity {
                Quantity::Moment => &cylinder.position - &self.reference_plane,
                Quantity::Force => one.clone(),
                Quantity::Torque => cylinder.crank_radius.clone(),
            };
            Vector { angle, weight: &cylinder.reciprocating_mass * &cylinder.crank_radius * arm }
        };
        self.cylinders.iter().map(term).collect()
    }
}

impl Quantity {
    /// The word of the JSON document.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Force => "force",
            Quantity::Moment => "moment",
            Quantity::Torque => "torque",
        }
    }
}

impl Sense {
    /// The word of the JSON document.
    pub fn name(self) -> &'static str {
        match self {
            Sense::Direct => "direct",
            Sense::Reverse => "reverse",
        }
    }
}

/// The first verdict about what an earlier one is about.
fn repeated(verdicts: &[VerdictClaim]) -> Option<(usize, &VerdictClaim)> {
    let mut seen = BTreeSet::new();
    let subject = |verdict: &VerdictClaim| (verdict.quantity, verdict.order, verdict.sense, verdict.of.clone());
    verdicts.iter().enumerate().find(|(_, verdict)| !seen.insert(subject(verdict)))
}

fn verdict_place(index: usize, verdict: &VerdictClaim) -> String {
    let sense = verdict.sense.map(|sense| format!(", {}", sense.name())).unwrap_or_default();
    format!("verdicts[{index}] ({}, order {}{sense})", verdict.quantity.name(), verdict.order)
}

fn check_verdict(document: &Document, verdict: &VerdictClaim) -> Result<(), String> {
    if (verdict.quantity == Quantity::Torque) != verdict.sense.is_none() {
        return Err("a force or moment needs a sense, direct or reverse, and a torque has none".into());
    }
    check_certificate(&verdict.terms, verdict.vanishes, &verdict.certificate).map_err(|refusal| refusal.to_string())?;
    check_terms(document, verdict)?;
    check_decimals(verdict)
}

fn check_terms(document: &Document, verdict: &VerdictClaim) -> Result<(), String> {
    if document.cylinders.is_empty() {
        return Ok(());
    }
    if document.cylinders.len() != verdict.terms.len() {
        return Err(format!("{} terms for {} cylinders", verdict.terms.len(), document.cylinders.len()));
    }
    if let Some(name) = verdict.of.iter().find(|name| document.cylinders.iter().all(|cylinder| cylinder.name != **name))
    {
        return Err(format!("there is no cylinder {name}"));
    }
    let right = document.terms(verdict.quantity, verdict.order, verdict.sense);
    for ((cylinder, term), Vector { angle, weight }) in document.cylinders.iter().zip(&verdict.terms).zip(right) {
        if !(&term.angle - &angle).is_integer() {
            let right = &angle - angle.floor();
            return Err(format!("the angle of cylinder {} is {}, it should be {right}", cylinder.name, term.angle));
        }
        let is_meant = verdict.of.is_empty() || verdict.of.contains(&cylinder.name);
        let weight = if is_meant { weight } else { BigRational::zero() };
        if term.weight != weight {
            return Err(format!("the weight of cylinder {} is {}, it should be {weight}", cylinder.name, term.weight));
        }
    }
    Ok(())
}

/// The decimals are for reading; a file whose decimals contradict its terms is refused all the same.
#[expect(clippy::float_arithmetic, clippy::disallowed_types, reason = "decimals are compared with decimals")]
fn check_decimals(verdict: &VerdictClaim) -> Result<(), String> {
    if verdict.vanishes != verdict.angle_deg.is_none() {
        return Err("`angle_deg` is null exactly where the sum vanishes".into());
    }
    if verdict.modulus < 0.0 || verdict.angle_deg.is_some_and(|angle| angle.abs() > 180.0) {
        return Err("`modulus` is not negative and `angle_deg` lies between -180 and 180".into());
    }
    let (mut x, mut y, mut total) = (0.0, 0.0, 0.0_f64);
    for term in &verdict.terms {
        let turns = (&term.angle - term.angle.floor()).to_f64().unwrap_or(f64::NAN);
        let weight = term.weight.to_f64().unwrap_or(f64::NAN);
        let (sin, cos) = (turns * std::f64::consts::TAU).sin_cos();
        (x, y, total) = (x + weight * cos, y + weight * sin, total + weight.abs());
    }
    let (shown_y, shown_x) = verdict.angle_deg.unwrap_or(0.0).to_radians().sin_cos();
    let (shown_x, shown_y) = (verdict.modulus * shown_x, verdict.modulus * shown_y);
    let fits = total.is_finite() && (x - shown_x).hypot(y - shown_y) <= 1e-9 * total.max(f64::MIN_POSITIVE);
    if fits { Ok(()) } else { Err("`modulus` and `angle_deg` do not fit the terms".into()) }
}

fn check_shape(document: &Document, claim: &ShapeClaim) -> Result<(), String> {
    let verdict = |sense: Sense| {
        let matches = |v: &&VerdictClaim| {
            v.quantity == claim.quantity && v.order == claim.order && v.sense == Some(sense) && v.of == claim.of
        };
        document.verdicts.iter().find(matches).ok_or(format!("there is no {} verdict for it", sense.name()))
    };
    let (direct, reverse) = (verdict(Sense::Direct)?, verdict(Sense::Reverse)?);
    let difference_vanishes = match (direct.vanishes, reverse.vanishes, claim.shape) {
        (true, true, Shape::Balanced) | (false, true, Shape::Rotating) | (true, false, Shape::CounterRotating) => {
            let needless = claim.certificate.is_some();
            return if needless {
                Err("no moduli are compared, so no certificate belongs here".into())
            } else {
                Ok(())
            };
        }
        (false, false, Shape::Planar) => true,
        (false, false, Shape::Elliptical) => false,
        _ => return Err("the shape contradicts the verdicts".into()),
    };
    let certificate = claim.certificate.as_ref().ok_or("a certificate that compares the two moduli is missing")?;
    let mut difference = squared_modulus(&direct.terms);
    difference.extend(squared_modulus(&reverse.terms).into_iter().map(|v| Vector { weight: -v.weight, ..v }));
    check_certificate(&difference, difference_vanishes, certificate).map_err(|refusal| refusal.to_string())
}

/// `|S|² = Σ_j Σ_l w_j w_l e^{2πi(t_j − t_l)}`, not collected.
pub(super) fn squared_modulus(terms: &[Vector]) -> Vec<Vector> {
    let terms: Vec<&Vector> = terms.iter().filter(|term| !term.weight.is_zero()).collect();
    let product = |a: &&Vector, b: &&Vector| Vector { angle: &a.angle - &b.angle, weight: &a.weight * &b.weight };
    terms.iter().flat_map(|a| terms.iter().map(move |b| product(a, b))).collect()
}
