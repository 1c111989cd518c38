//! Does all that is said of a family hold together?
//!
//! A sum over open angles is `Σ_j e^{ix_j} S_j`, x linear in φ and δ. Two parts that do not vanish cancel exactly where
//! `e^{i(x_2 − x_1)} = −S_1/S_2`, so one turn at which they do proves all of it; one part never vanishes.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::audit::{Audit, Fault, Reason, refuse_if, steps_of};
use super::checked::Checked;
use super::collected::turn;
use super::engine::{Masses, check_asked, check_names};
use super::format::Format;
use super::open::{LinearClaim, OpenCylinder, OpenDocument, OpenVerdictClaim, PartClaim, WhenClaim};
use super::part::{Part, check_part};
use super::quantity::{Quantity, Sense};
use super::vector::Vector;
use super::when::check_when;

/// Checks that a family's document holds: that the verdicts asked for are all there and no other, that their parts are
/// those of its cylinders, and that each certificate and each condition holds.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_open_document(document: &OpenDocument) -> Result<Checked, Fault> {
    let audit = Audit::new();
    check_head(document)?;
    let mut found = document.open_verdicts.iter();
    let asked = document.orders.iter().flat_map(|&order| {
        let pairs = move |&quantity: &Quantity| Sense::BOTH.map(|sense| (order, quantity, sense));
        document.quantities.iter().flat_map(pairs)
    });
    for (index, (order, quantity, sense)) in asked.enumerate() {
        let place = format!("open_verdicts[{index}] ({}, order {order}, {})", quantity.name(), sense.name());
        let Some(verdict) = found.next() else { return Err(Fault::new(place, "this verdict is missing")) };
        if (verdict.order, verdict.quantity, verdict.sense) != (order, quantity, sense) {
            return Err(Fault::new(place, "another verdict stands here"));
        }
        check_verdict(document, verdict, &audit).map_err(|reason| Fault { place, reason })?;
    }
    refuse_if(found.next().is_some(), Fault::new("open_verdicts", "there are more than were asked for"))?;
    if audit.counts().certificates() == 0 {
        return Err(Fault::new("open_verdicts", "nothing is proved: no cylinder has a weight"));
    }
    let sums = document.open_verdicts.iter().flat_map(|verdict| &verdict.sums);
    let all_solved = sums.into_iter().all(|sum| is_solved(&sum.when));
    Ok(Checked::family(document, all_solved, audit.counts()))
}

/// Whether the claim names all angles at which a sum vanishes.
fn is_solved(when: &WhenClaim) -> bool {
    match when {
        WhenClaim::Always
        | WhenClaim::Never
        | WhenClaim::UnequalLengths { .. }
        | WhenClaim::Where { .. }
        | WhenClaim::Cosine(_)
        | WhenClaim::Coprime(_)
        | WhenClaim::Triangle(_) => true,
        WhenClaim::Circle(claim) => claim.is_complete(),
        WhenClaim::Classes(claim) => claim.is_complete(),
        WhenClaim::Quadratic(claim) => claim.is_complete(),
        WhenClaim::Boxes(claim) => claim.is_complete(),
        WhenClaim::Product(claim) => is_solved(&claim.group) && is_solved(&claim.firsts),
        WhenClaim::EqualLengths { .. } | WhenClaim::NotSolved => false,
    }
}

fn check_head(document: &OpenDocument) -> Result<(), Fault> {
    refuse_if(document.format != Format::Family, Fault::new("format", "families are in `crankstar family 2`"))?;
    if document.masses != Masses::Reciprocating {
        return Err(Fault::new("masses", "this format knows verdicts on the reciprocating masses only"));
    }
    check_names(document.cylinders.iter().map(|cylinder| cylinder.name.as_str()))?;
    check_asked(&document.orders, &document.quantities)?;
    if document.quantities.iter().any(|quantity| quantity.senses().len() == 1) {
        return Err(Fault::new("quantities", "this format knows force and moment, and not the torque of a family"));
    }
    let linears = document.cylinders.iter().flat_map(|cylinder| {
        let OpenCylinder { throw, bank, position, .. } = cylinder;
        [(throw, &cylinder.name), (bank, &cylinder.name), (position, &cylinder.name)]
    });
    for (linear, name) in linears {
        check_linear(linear).map_err(|reason| Fault::new(format!("cylinders ({name})"), reason))?;
    }
    check_linear(&document.reference_plane).map_err(|reason| Fault::new("reference_plane", reason))?;
    for cylinder in &document.cylinders {
        let mut names = cylinder.throw.keys().chain(cylinder.bank.keys());
        if names.any(|name| !["1", "phi", "delta"].contains(&name.as_str())) {
            let place = format!("cylinders ({})", cylinder.name);
            return Err(Fault::new(place, "an angle holds another unknown than phi and delta"));
        }
    }
    Ok(())
}

/// The known part is there, be it 0; of the symbols only those that occur.
fn check_linear(linear: &LinearClaim) -> Result<(), &'static str> {
    refuse_if(!linear.contains_key("1"), "the known part, under \"1\", is missing")?;
    match linear.iter().any(|(name, exact)| name != "1" && exact.0.is_zero()) {
        true => Err("a symbol is taken 0 times"),
        false => Ok(()),
    }
}

fn check_verdict(document: &OpenDocument, verdict: &OpenVerdictClaim, audit: &Audit) -> Result<(), Reason> {
    let expected = expected_sums(document, verdict, audit)?;
    if verdict.sums.len() != expected.len() {
        return Err(format!("{} sums for {} lengths", verdict.sums.len(), expected.len()).into());
    }
    for (sum, (symbol, parts)) in verdict.sums.iter().zip(&expected) {
        let name = symbol.as_deref().unwrap_or("known lengths");
        if sum.symbol != *symbol {
            return Err(format!("the sum of {name} is missing, or not in its place").into());
        }
        if sum.parts.len() != parts.len() {
            return Err(format!("{} parts in the sum of {name}, it has {}", sum.parts.len(), parts.len()).into());
        }
        let mut left = Vec::new();
        for (claim, ((phi, delta), terms)) in sum.parts.iter().zip(parts) {
            if (&claim.phi, &claim.delta) != (phi, delta) || !same_terms(claim, terms) {
                return Err("the parts are not those of the cylinders".into());
            }
            let part: Part<'_> = check_part(claim, audit)?;
            if !claim.certificate.claims_zero() {
                left.push(part);
            }
        }
        check_when(&sum.when, &left, audit)?;
    }
    Ok(())
}

fn same_terms(claim: &PartClaim, terms: &[Vector]) -> bool {
    let same = |(a, b): (&Vector, &Vector)| a.weight == b.weight && a.angle == turn(&b.angle);
    claim.terms.len() == terms.len() && claim.terms.iter().zip(terms).all(same)
}

/// The multiples of φ and δ, each with the terms behind that factor.
type Parts = BTreeMap<(BigRational, BigRational), Vec<Vector>>;

/// Theory, section 3, with the unknowns kept apart: direct `kβ − (k−1)α`, reverse `−kβ + (k+1)α`; one sum per length.
fn expected_sums(
    document: &OpenDocument,
    verdict: &OpenVerdictClaim,
    audit: &Audit,
) -> Result<Vec<(Option<String>, Parts)>, Reason> {
    let k = BigRational::from_integer(BigInt::from(verdict.order));
    let (of_throw, of_bank) = match verdict.sense {
        Sense::Direct => (k.clone(), BigRational::one() - k),
        Sense::Reverse => (-&k, k + BigRational::one()),
    };
    let mut terms = Vec::new();
    let mut symbols: BTreeSet<Option<String>> = BTreeSet::new();
    for cylinder in &document.cylinders {
        let phase = |name: &str| &of_throw * part(&cylinder.throw, name) + &of_bank * part(&cylinder.bank, name);
        let weights = weights(document, cylinder, verdict.quantity, audit)?;
        symbols.extend(weights.iter().filter(|(_, weight)| !weight.is_zero()).map(|(symbol, _)| symbol.clone()));
        terms.push(((phase("phi"), phase("delta")), phase("1"), weights));
    }
    let mut sums = Vec::new();
    for symbol in symbols {
        let mut parts = Parts::new();
        for (factor, angle, weights) in &terms {
            audit.spend(steps_of(angle))?;
            let weight = weights.get(&symbol).cloned().unwrap_or_else(BigRational::zero);
            parts.entry(factor.clone()).or_default().push(Vector { angle: angle.clone(), weight });
        }
        sums.push((symbol, parts));
    }
    Ok(sums)
}

/// What a cylinder weighs, by length.
fn weights(
    document: &OpenDocument,
    cylinder: &OpenCylinder,
    quantity: Quantity,
    audit: &Audit,
) -> Result<BTreeMap<Option<String>, BigRational>, Reason> {
    let mass_radius = &cylinder.reciprocating_mass * &cylinder.crank_radius;
    match quantity {
        Quantity::FORCE => Ok(BTreeMap::from([(None, mass_radius)])),
        Quantity::MOMENT => {
            let mut weights = BTreeMap::new();
            for name in cylinder.position.keys().chain(document.reference_plane.keys()) {
                let arm = part(&cylinder.position, name) - part(&document.reference_plane, name);
                audit.spend(steps_of(&arm))?;
                weights.insert((name != "1").then(|| name.clone()), &mass_radius * arm);
            }
            Ok(weights)
        }
        Quantity::Axial(_) => Err("the torque of a family is not known to this format".into()),
    }
}

fn part(linear: &LinearClaim, name: &str) -> BigRational {
    linear.get(name).map_or_else(BigRational::zero, |exact| exact.0.clone())
}
