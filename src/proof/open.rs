//! What does `classify --json` say of a family, and does all of it hold together?
//!
//! A sum over open angles is `Σ_j e^{ix_j} S_j`, x linear in φ and δ. Two parts that do not vanish cancel exactly where
//! `e^{i(x_2 − x_1)} = −S_1/S_2`, so one turn at which they do proves all of it; one part never vanishes.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use serde::{Deserialize, Serialize};

use super::certificate::Certificate;
use super::check::check_certificate;
use super::document::{Fault, Quantity, Sense, Vector, one, squared_modulus};
use super::fraction;

/// The verdicts on a family: the JSON document of `classify --json` where an angle or a length is open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OpenDocument {
    /// Title of the layout.
    pub title: String,
    /// Position of the plane that moments are taken about.
    pub reference_plane: LinearClaim,
    /// The cylinders that the terms come from.
    pub cylinders: Vec<OpenCylinder>,
    /// One verdict a quantity, order and sense.
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
    /// Crank radius, in multiples of a common radius; 1 if left out.
    #[serde(with = "fraction", default = "one", skip_serializing_if = "One::is_one")]
    pub crank_radius: BigRational,
}

/// When one quantity, order and sense vanishes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OpenVerdictClaim {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// One sum an open length, and one for the known lengths: it vanishes for all lengths where all of them do.
    pub sums: Vec<SumClaim>,
}

/// The part of a sum that one length multiplies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SumClaim {
    /// The open length; none for the known lengths, and for the force.
    pub symbol: Option<String>,
    /// The sums by the multiples of φ and δ before them.
    pub parts: Vec<PartClaim>,
    /// When it vanishes.
    pub when: WhenClaim,
}

/// `e^{i(phi·φ + delta·δ)}` times a sum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartClaim {
    /// How many times φ enters.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// The sum without unknowns, one term a cylinder.
    pub terms: Vec<Vector>,
    /// Evidence that the sum is zero, or that it is not.
    pub certificate: Certificate,
}

/// When a sum vanishes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
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
        /// For three parts: evidence that `|S_1|² − |S_j|²` is zero.
        equal_lengths: Vec<Certificate>,
    },
    /// Two parts of equal length that cancel at an angle for which no rational turn is claimed.
    EqualLengths {
        /// Evidence that `|S_1|² − |S_2|²` is zero.
        certificate: Certificate,
    },
    /// No claim: too many parts.
    NotSolved,
}

/// Turns of the parts after the first against the first at which they cancel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AlternativeClaim {
    /// One a part after the first.
    pub conditions: Vec<ConditionClaim>,
    /// Evidence that the parts turned so sum to zero.
    pub certificate: Certificate,
}

/// `phi·φ + delta·δ ≡ turn`, modulo a turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConditionClaim {
    /// How many times φ enters.
    #[serde(with = "fraction")]
    pub phi: BigRational,
    /// How many times δ enters.
    #[serde(with = "fraction")]
    pub delta: BigRational,
    /// What it must be.
    #[serde(with = "fraction")]
    pub turn: BigRational,
}

/// Checks every certificate of a family's document, and that its parts are those of its cylinders.
///
/// Returns how many certificates were checked.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_open_document(document: &OpenDocument) -> Result<usize, Fault> {
    if document.open_verdicts.is_empty() {
        let reason = "the list is empty, there is nothing to check".into();
        return Err(Fault { place: "open_verdicts".into(), reason });
    }
    let mut checked = 0;
    for (index, verdict) in document.open_verdicts.iter().enumerate() {
        let (quantity, sense) = (verdict.quantity.name(), verdict.sense.name());
        let place = format!("open_verdicts[{index}] ({quantity}, order {}, {sense})", verdict.order);
        checked += check_verdict(document, verdict).map_err(|reason| Fault { place, reason })?;
    }
    Ok(checked)
}

fn check_verdict(document: &OpenDocument, verdict: &OpenVerdictClaim) -> Result<usize, String> {
    let expected = expected_parts(document, verdict)?;
    let mut found: Parts = BTreeMap::new();
    let mut checked = 0;
    for sum in &verdict.sums {
        for part in &sum.parts {
            let vanishes = part.certificate.claims_zero();
            check_certificate(&part.terms, vanishes, &part.certificate).map_err(|refusal| refusal.to_string())?;
            let key = (sum.symbol.clone(), part.phi.clone(), part.delta.clone());
            if found.insert(key, collected(&part.terms)).is_some() {
                return Err("the same part is listed twice".into());
            }
        }
        checked += sum.parts.len() + check_when(sum)?;
    }
    found.retain(|_, terms| !terms.is_empty());
    if found == expected { Ok(checked) } else { Err("the parts are not those of the cylinders".into()) }
}

/// Collected terms by length symbol, multiple of φ, multiple of δ.
type Parts = BTreeMap<(Option<String>, BigRational, BigRational), BTreeMap<BigRational, BigRational>>;

/// Theory, section 3, with the unknowns kept apart: direct `kβ − (k−1)α`, reverse `−kβ + (k+1)α`.
fn expected_parts(document: &OpenDocument, verdict: &OpenVerdictClaim) -> Result<Parts, String> {
    let k = BigRational::from_integer(BigInt::from(verdict.order));
    let one = BigRational::one();
    let (of_throw, of_bank) = match verdict.sense {
        Sense::Direct => (k.clone(), &one - &k),
        Sense::Reverse => (-&k, &k + &one),
    };
    let mut parts = Parts::new();
    for cylinder in &document.cylinders {
        if cylinder.throw.keys().chain(cylinder.bank.keys()).any(|name| !["1", "phi", "delta"].contains(&name.as_str()))
        {
            return Err(format!("an angle of cylinder {} holds another unknown than phi and delta", cylinder.name));
        }
        let phase = |name: &str| &of_throw * part(&cylinder.throw, name) + &of_bank * part(&cylinder.bank, name);
        let angle = phase("1");
        let mass_radius = &cylinder.reciprocating_mass * &cylinder.crank_radius;
        let mut weights: BTreeMap<Option<String>, BigRational> = BTreeMap::new();
        if verdict.quantity == Quantity::Moment {
            for name in cylinder.position.keys().chain(document.reference_plane.keys()) {
                let arm = part(&cylinder.position, name) - part(&document.reference_plane, name);
                weights.insert((name != "1").then(|| name.clone()), &mass_radius * arm);
            }
        } else {
            weights.insert(None, mass_radius);
        }
        for (symbol, weight) in weights {
            let terms = parts.entry((symbol, phase("phi"), phase("delta"))).or_default();
            *terms.entry(&angle - angle.floor()).or_insert_with(BigRational::zero) += weight;
        }
    }
    parts.values_mut().for_each(|terms| terms.retain(|_, weight| !weight.is_zero()));
    parts.retain(|_, terms| !terms.is_empty());
    Ok(parts)
}

fn part(linear: &LinearClaim, name: &str) -> BigRational {
    linear.get(name).map_or_else(BigRational::zero, |exact| exact.0.clone())
}

fn collected(terms: &[Vector]) -> BTreeMap<BigRational, BigRational> {
    let mut sum = BTreeMap::new();
    for term in terms {
        *sum.entry(&term.angle - term.angle.floor()).or_insert_with(BigRational::zero) += &term.weight;
    }
    sum.retain(|_, weight| !weight.is_zero());
    sum
}

/// Whether the claim on when a sum vanishes follows from its parts; how many certificates that took.
fn check_when(sum: &SumClaim) -> Result<usize, String> {
    let left: Vec<&PartClaim> = sum.parts.iter().filter(|part| !part.certificate.claims_zero()).collect();
    match (&sum.when, left.as_slice()) {
        (WhenClaim::Always, []) | (WhenClaim::Never, [_]) | (WhenClaim::NotSolved, [_, _, _, ..]) => Ok(0),
        (WhenClaim::UnequalLengths { certificate }, [first, second]) => {
            check_lengths(first, second, false, certificate)
        }
        (WhenClaim::EqualLengths { certificate }, [first, second]) => check_lengths(first, second, true, certificate),
        (WhenClaim::Where { alternatives, .. }, [first, second]) => match alternatives.as_slice() {
            [only] => check_alternative(first, &[second], only),
            _ => Err("two parts cancel at one turn, so there is one alternative".into()),
        },
        (WhenClaim::Where { alternatives, equal_lengths }, [first, second, third]) => {
            // Three vectors of equal length sum to zero iff they stand 120° apart: in one order or the other.
            let ([one, other], [with_second, with_third]) = (alternatives.as_slice(), equal_lengths.as_slice()) else {
                return Err("three parts need two alternatives, and evidence that they are equally long".into());
            };
            if one.conditions.iter().zip(&other.conditions).any(|(a, b)| (&a.turn - &b.turn).is_integer()) {
                return Err("the two alternatives are the same".into());
            }
            let lengths =
                check_lengths(first, second, true, with_second)? + check_lengths(first, third, true, with_third)?;
            let turns =
                check_alternative(first, &[second, third], one)? + check_alternative(first, &[second, third], other)?;
            Ok(lengths + turns)
        }
        (_, left) => Err(format!("{} parts do not vanish, which contradicts `when`", left.len())),
    }
}

fn check_lengths(a: &PartClaim, b: &PartClaim, equal: bool, certificate: &Certificate) -> Result<usize, String> {
    let mut difference = squared_modulus(&a.terms);
    difference.extend(squared_modulus(&b.terms).into_iter().map(|vector| Vector { weight: -vector.weight, ..vector }));
    let collected = collected(&difference).into_iter().map(|(angle, weight)| Vector { angle, weight });
    let difference: Vec<Vector> = collected.collect();
    check_certificate(&difference, equal, certificate).map(|()| 1).map_err(|refusal| refusal.to_string())
}

fn check_alternative(first: &PartClaim, others: &[&PartClaim], claim: &AlternativeClaim) -> Result<usize, String> {
    if claim.conditions.len() != others.len() {
        return Err("there is one condition a part after the first".into());
    }
    let mut sum = first.terms.clone();
    for (part, condition) in others.iter().zip(&claim.conditions) {
        if condition.phi != &part.phi - &first.phi || condition.delta != &part.delta - &first.delta {
            return Err("a condition is not about how its part is turned against the first".into());
        }
        let turned = part.terms.iter().map(|v| Vector { angle: &v.angle + &condition.turn, weight: v.weight.clone() });
        sum.extend(turned);
    }
    check_certificate(&sum, true, &claim.certificate).map(|()| 1).map_err(|refusal| refusal.to_string())
}
