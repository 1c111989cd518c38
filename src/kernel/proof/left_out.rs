//! Is what a remedy omits too little for a weight?
//!
//! The force that is left in an order, both senses end to end, is below a millionth of the load: of the force that all pistons make
//! at order 1, end to end. The moment that is left is below a millionth of these forces, each times the distance of its piston from the
//! centre of mass of all: neither a light mass far off nor the plane of reference makes it larger. A vector S is a force of half its
//! length, so the load is the vector that is twice all weights long.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::audit::{Audit, Fault, Reason, steps_of};
use super::coefficient::Coefficient;
use super::collected::Collected;
use super::judged::{Judged, JudgedGroup};
use super::motion::Motion;
use super::quantity::{Quantity, Sense};
use super::refusal::Refusal;
use super::remedy::RemedyDocument;
use super::whole_sum::longest;

/// The part of the load that what is left has to stay below.
const SLIGHT: (i64, i64) = (1, 1_000_000);

/// The c_k of rods that are not known counts as so much: its size rises with λ up to that of |cos| at λ = 1, which is at most
/// 16/(3π).
const MOST_COMMON: i64 = 2;

/// A sum of the corrected engine that is not zero.
pub(super) struct LeftOut {
    pub quantity: Quantity,
    pub order: u32,
    pub sense: Sense,
    pub coefficient: Coefficient,
    pub sum: Collected,
}

/// Checks that `left_out` names the orders and senses in which something is left, each once, and that it is little.
pub(super) fn check_left_out(document: &RemedyDocument, left: &[LeftOut], audit: &Audit) -> Result<(), Fault> {
    let named: BTreeSet<(u32, Sense)> = document.left_out.iter().map(|one| (one.order, one.sense)).collect();
    let found: BTreeSet<(u32, Sense)> = left.iter().map(|one| (one.order, one.sense)).collect();
    if named.len() < document.left_out.len() || named != found {
        return Err(Fault::new("left_out", "it names orders and senses without a residual, or one of them twice"));
    }
    let orders: BTreeSet<u32> = named.into_iter().map(|(order, _)| order).collect();
    if orders.is_empty() {
        return Ok(());
    }
    let loads = loads(document, audit).map_err(|refusal| Fault::new("left_out", refusal))?;
    for order in orders {
        for (quantity, unit) in [Quantity::FORCE, Quantity::MOMENT].into_iter().zip(&loads) {
            let place = || format!("left_out (order {order}, {})", quantity.name());
            let of_order = left.iter().filter(|one| (one.quantity, one.order) == (quantity, order));
            let of_order: Vec<&LeftOut> = of_order.collect();
            if of_order.is_empty() {
                continue;
            }
            let most = end_to_end(&of_order, order, audit).map_err(|reason| Fault { place: place(), reason })?;
            if most >= unit * BigRational::new((2 * SLIGHT.0).into(), SLIGHT.1.into()) {
                return Err(Fault::new(place(), "the residual is not below a millionth of the load"));
            }
        }
    }
    Ok(())
}

/// The force of all pistons, and that of each times its distance from their centre of mass.
fn loads(document: &RemedyDocument, audit: &Audit) -> Result<[BigRational; 2], Refusal> {
    let sum = |arm: &dyn Fn(&BigRational) -> BigRational| {
        document.cylinders.iter().try_fold(BigRational::zero(), |sum, cylinder| {
            audit.spend(steps_of(&sum) + steps_of(&cylinder.weight) + steps_of(&cylinder.position))?;
            Ok(sum + &cylinder.weight * arm(&cylinder.position))
        })
    };
    let load = sum(&|_| BigRational::one())?;
    if load.is_zero() {
        return Ok([load.clone(), load]);
    }
    let centre = sum(&BigRational::clone)? / &load;
    audit.spend((document.cylinders.len() as u64).saturating_mul(steps_of(&centre)))?;
    let moment = sum(&|position| (position - &centre).abs())?;
    Ok([load, moment])
}

/// The lengths of the vectors of both senses, added.
fn end_to_end(left: &[&LeftOut], order: u32, audit: &Audit) -> Result<BigRational, Reason> {
    let motion = Motion::new(audit);
    let mut most = BigRational::zero();
    for (place, sense) in Sense::BOTH.into_iter().enumerate() {
        let of_sense = || left.iter().filter(|one| one.sense == sense);
        let known: Vec<(Coefficient, &Collected)> = of_sense()
            .filter(|one| !one.coefficient.is_open())
            .map(|one| (one.coefficient.clone(), &one.sum))
            .collect();
        most += longest_of(&known, order, place, &motion)?;
        for open in of_sense().filter(|one| one.coefficient.is_open()) {
            let bare = longest_of(&[(Coefficient::One, &open.sum)], order, place, &motion)?;
            most += bare * BigRational::from_integer(BigInt::from(MOST_COMMON));
        }
    }
    Ok(most)
}

fn longest_of(
    sums: &[(Coefficient, &Collected)],
    order: u32,
    place: usize,
    motion: &Motion<'_>,
) -> Result<BigRational, Reason> {
    if sums.is_empty() {
        return Ok(BigRational::zero());
    }
    let group = |(coefficient, sum): &(Coefficient, &Collected)| {
        JudgedGroup::of_sense(coefficient.clone(), false, place, ((*sum).clone(), false))
    };
    let groups = sums.iter().map(group).collect();
    longest(&Judged { quantity: Quantity::FORCE, order, groups, wholes: Vec::new() }, place, motion)
}
