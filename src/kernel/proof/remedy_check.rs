//! Does a remedy hold: are its sums those of the corrected engine, and zero where that is claimed?

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::audit::{Audit, Fault, Reason, refuse_if, steps_of_longest};
use super::check::certify;
use super::checked::Checked;
use super::coefficient::{Coefficient, Factor};
use super::collected::{Collected, collect, collected, vectors};
use super::decimals::check_decimals;
use super::engine::{
    Masses, check_asked, check_knuckle, check_masses, check_masters, check_shafts, check_speed, own_order, power, rods,
};
use super::format::Format;
use super::left_out::{LeftOut, check_left_out};
use super::quantity::{Quantity, Sense};
use super::remedy::{CorrectedClaim, LeftOutClaim, RemedyDocument, WeightClaim};
use super::source::{differ, turned};
use super::vector::Vector;
use super::verdict::phase;

/// Checks that the sums of the corrected engine are those of its cylinders, masses and weights, that each order has all
/// of them, and that each is zero except where it is left out.
///
/// # Errors
/// The first entry that does not hold.
pub fn check_remedy_document(document: &RemedyDocument) -> Result<Checked, Fault> {
    let audit = Audit::new();
    let rods_known = check_head(document)?;
    for (index, weight) in document.weights.iter().enumerate() {
        let place = || format!("weights[{index}]");
        check_weight(document, weight, &audit).map_err(|reason| Fault { place: place(), reason })?;
    }
    let mut found = document.sums.iter().enumerate();
    let mut left = Vec::new();
    for &order in &document.orders {
        for quantity in [Quantity::FORCE, Quantity::MOMENT] {
            for sense in Sense::BOTH {
                let about = format!("({}, order {order}, {})", quantity.name(), sense.name());
                let expected = document.expected(quantity, order, sense, &audit);
                for (coefficient, Expected { sum, is_own }) in
                    expected.map_err(|reason| Fault::new(about.clone(), reason))?
                {
                    let Some((index, claim)) = found.next() else {
                        return Err(Fault::new(format!("sums {about}"), "this sum is omitted"));
                    };
                    let place = format!("sums[{index}] {about}");
                    if (claim.quantity, claim.order, claim.sense) != (quantity, order, sense)
                        || claim.coefficient != coefficient
                    {
                        return Err(Fault::new(place, "another sum stands here"));
                    }
                    let may_stay = document.left_out.contains(&LeftOutClaim { order, sense });
                    check_sum(claim, &sum, may_stay, &audit)
                        .map_err(|reason| Fault { place: place.clone(), reason })?;
                    if !claim.certificate.claims_zero() {
                        if !is_own {
                            return Err(Fault::new(
                                place,
                                "the residual is multiplied by a number that the engine does not have",
                            ));
                        }
                        left.push(LeftOut { quantity, order, sense, coefficient, sum });
                    }
                }
            }
        }
    }
    refuse_if(found.next().is_some(), Fault::new("sums", "there are more than the orders have"))?;
    check_left_out(document, &left, &audit)?;
    Ok(Checked::remedy(document, rods_known, audit.counts()))
}

/// Whether the rods are known.
fn check_head(document: &RemedyDocument) -> Result<bool, Fault> {
    refuse_if(document.format != Format::Remedy, Fault::new("format", "remedies are in `crankstar remedy 2`"))?;
    refuse_if(document.masses != Masses::All, Fault::new("masses", "a remedy is about all masses of the engine"))?;
    check_asked(&document.orders, &document.quantities)?;
    if document.quantities != [Quantity::FORCE, Quantity::MOMENT] {
        return Err(Fault::new("quantities", "a remedy is about force and moment, both"));
    }
    refuse_if(document.cylinders.is_empty(), Fault::new("cylinders", "an engine has one at least"))?;
    if let Some(index) = document.turning_masses.iter().position(|mass| mass.order == 0) {
        return Err(Fault::new(format!("turning_masses[{index}]"), "a mass that turns has an order from 1 on"));
    }
    let masses = document.cylinders.iter().flat_map(|one| [&one.weight, &one.knuckle_weight]);
    check_masses(masses).map_err(|reason| Fault::new("cylinders", reason))?;
    for cylinder in &document.cylinders {
        let checked = check_knuckle(&cylinder.rod, &cylinder.knuckle_weight);
        let checked = checked.and_then(|()| check_speed(&cylinder.rod, cylinder.speed));
        checked.map_err(|reason| Fault::new("cylinders", reason))?;
    }
    // Weights are masses times radii here: which radius is not said.
    let cylinders = document.cylinders.iter().filter(|one| one.speed == 1);
    let held = cylinders.map(|one| (&one.throw, &one.bank, &one.rod, [&one.position]));
    check_masters(held).map_err(|reason| Fault::new("cylinders", reason))?;
    let of_shafts = document.turning_masses.iter().filter_map(|mass| mass.coefficient_of.as_ref());
    check_shafts(of_shafts.clone()).map_err(|reason| Fault::new("turning_masses", reason))?;
    let rods = rods(document.cylinders.iter().map(|cylinder| &cylinder.rod).chain(of_shafts));
    rods.map(|rods| rods.is_some()).map_err(|reason| Fault::new("cylinders", reason))
}

/// A weight turns at an order that is asked for, and each part is a sum of some length.
fn check_weight(document: &RemedyDocument, weight: &WeightClaim, audit: &Audit) -> Result<(), Reason> {
    if !document.orders.contains(&weight.order) {
        return Err(format!("it turns at order {}, which is not asked for", weight.order).into());
    }
    if weight.parts.is_empty() || weight.parts.windows(2).any(|pair| pair[0].coefficient >= pair[1].coefficient) {
        return Err("it has parts, rising by their coefficients, each once".into());
    }
    for part in &weight.parts {
        let sum = collected(&part.terms, audit)?;
        refuse_if(vectors(sum.clone()) != part.terms, "its terms are not collected, at rising angles")?;
        check_decimals(&sum, false, part.modulus, Some(part.angle_deg), audit)?;
    }
    Ok(())
}

fn check_sum(claim: &CorrectedClaim, expected: &Collected, may_stay: bool, audit: &Audit) -> Result<(), Reason> {
    certify(expected, !may_stay || claim.certificate.claims_zero(), &claim.certificate, audit)?;
    match vectors(expected.clone()) == claim.terms {
        true => Ok(()),
        false => Err("its terms are not those of the engine and the weights, collected".into()),
    }
}

/// A sum of the corrected engine.
struct Expected {
    sum: Collected,
    /// Whether the engine has terms before this coefficient itself, be there a weight or not.
    is_own: bool,
}

impl RemedyDocument {
    /// The collected sums of one quantity, order and sense by coefficient (theory, sections 3 and 7), those that have a
    /// term; an empty one where none has.
    fn expected(
        &self,
        quantity: Quantity,
        order: u32,
        sense: Sense,
        audit: &Audit,
    ) -> Result<BTreeMap<Coefficient, Expected>, Reason> {
        let mut sums: BTreeMap<Coefficient, Vec<(BigRational, BigRational)>> = BTreeMap::new();
        let arm = |position: &BigRational| match quantity {
            Quantity::MOMENT => position - &self.reference_plane,
            Quantity::FORCE | Quantity::Axial(_) => BigRational::one(),
        };
        let terms = |angle: &BigRational, weight: &BigRational, parts: &[Vector]| -> Vec<(BigRational, BigRational)> {
            let vectors = parts.iter().map(|part| turned(angle, weight, part, Some(sense)));
            vectors.map(|vector| (vector.angle, vector.weight)).collect()
        };
        let cylinders = self.cylinders.iter().map(|one| [&one.weight, &one.knuckle_weight, &one.position]);
        let turning = self.turning_masses.iter().map(|one| [&one.mass_radius, &one.position]);
        let weights = self.weights.iter().map(|one| steps_of_longest([&one.position]));
        let sources = cylinders.map(steps_of_longest).chain(turning.map(steps_of_longest)).chain(weights);
        audit.spend(sources.fold(0, u64::saturating_add))?;
        let do_rods_differ = differ(self.cylinders.iter().map(|cylinder| &cylinder.rod));
        for cylinder in &self.cylinders {
            let Some(own) = own_order(cylinder.speed, order) else { continue };
            let weight = &cylinder.weight * arm(&cylinder.position) * power(cylinder.speed, 2);
            let angle = phase(&cylinder.throw, &cylinder.bank, own, Some(sense));
            if let Some(link) = cylinder.rod.link() {
                audit.spend(link.steps(order))?;
            }
            let factors = Factor::of_force(&cylinder.rod, own, do_rods_differ);
            for Factor { coefficient, parts, .. } in factors.into_iter().filter(|factor| !factor.is_zero) {
                sums.entry(coefficient.geared(cylinder.speed)).or_default().extend(terms(&angle, &weight, &parts));
            }
            let Some(link) = cylinder.rod.link() else { continue };
            let Factor { coefficient, is_zero, .. } = Factor::of_rod(&link.master_rod(), order);
            if !is_zero && !cylinder.knuckle_weight.is_zero() {
                let weight = &cylinder.knuckle_weight * &link.knuckle * arm(&cylinder.position);
                let bank = &cylinder.bank - &link.angle;
                let angle = phase(&cylinder.throw, &bank, order, Some(sense)) + &link.angle + &link.correction;
                sums.entry(coefficient).or_default().push((angle, weight));
            }
        }
        let k = BigRational::from_integer(BigInt::from(order));
        let double = &k * &k * BigRational::from_integer(2.into());
        for mass in self.turning_masses.iter().filter(|mass| (mass.order, mass.sense) == (order, sense)) {
            let factors = Factor::of_shaft(mass.coefficient_of.as_ref(), order, do_rods_differ);
            let weight = &double * &mass.mass_radius * arm(&mass.position);
            for Factor { coefficient, parts, .. } in factors.into_iter().filter(|factor| !factor.is_zero) {
                sums.entry(coefficient).or_default().extend(terms(&mass.angle, &weight, &parts));
            }
        }
        let own: BTreeSet<Coefficient> = sums.keys().cloned().chain([Coefficient::One]).collect();
        for weight in self.weights.iter().filter(|weight| (weight.order, weight.sense) == (order, sense)) {
            let share = &double * arm(&weight.position);
            for part in &weight.parts {
                audit.spend(part.terms.iter().map(|term| steps_of_longest([&term.weight, &share])).sum())?;
                let terms = part.terms.iter().map(|term| (term.angle.clone(), &term.weight * &share));
                sums.entry(part.coefficient.clone()).or_default().extend(terms);
            }
        }
        let mut left: BTreeMap<Coefficient, Expected> = BTreeMap::new();
        for (coefficient, terms) in sums {
            let is_own = own.contains(&coefficient);
            left.insert(coefficient, Expected { sum: collect(terms, audit)?, is_own });
        }
        left.retain(|_, expected| !expected.sum.is_empty());
        if left.is_empty() {
            left.insert(Coefficient::One, Expected { sum: Collected::new(), is_own: true });
        }
        Ok(left)
    }
}
