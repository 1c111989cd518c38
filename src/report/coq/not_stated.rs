//! Which engines can a file of Coq not state?

use num_traits::Signed;
use thiserror::Error;

use crate::proof::{Cylinder, Document, Masses, Quantity};
use crate::text::harmless;

/// What every reason begins with.
const NO_FILE: &str = "no file of Coq can state this engine";

/// Why there is no file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NotStated {
    /// A cylinder has no rod of its own on the crankpin.
    #[error("{NO_FILE}: cylinder {} has no rod on the crankpin, but several vectors in an order", harmless(.0))]
    NoRod(String),
    /// Several crankshafts, and the roll moment with them.
    #[error("{NO_FILE}: it has several crankshafts; formal/Engine.v knows one, that turns once in a revolution")]
    SeveralCrankshafts,
    /// A shaft is sized by the number c_k of a rod.
    #[error("{NO_FILE}: {} is sized by the number c_k of a rod, which is not rational", harmless(.0))]
    SizedByRod(String),
    /// An odd order of this cylinder has its sign turned, as its offset is below 0.
    #[error(
        "{NO_FILE}: cylinder {} has an offset below 0, which turns the sign of its odd orders above 1; omit them and --all-orders",
        harmless(.0)
    )]
    Reversed(String),
    /// What makes all weights whole holds the prime of a residue once more than what makes the collected ones whole.
    #[error(
        "{NO_FILE}: the weights of order {order} of the {} have a denominator that the prime of its evidence divides; scale masses and \
         lengths by another number",
        .quantity.name()
    )]
    Scale {
        /// Of what.
        quantity: Quantity,
        /// The order.
        order: u32,
    },
}

/// Whether pistons are among the masses that the verdicts are about.
pub(super) fn has_pistons(document: &Document) -> bool {
    match document.masses {
        Masses::Reciprocating | Masses::All => true,
        Masses::Rotating | Masses::Counterweights => false,
    }
}

/// Checks that each sum is one over rational numbers, as those of `formal/Engine.v` are.
pub(super) fn check(document: &Document) -> Result<(), NotStated> {
    let pistons = document.cylinders.iter().filter(|_| has_pistons(document));
    for cylinder in pistons {
        check_cylinder(cylinder)?;
    }
    let is_odd = |order: u32| order > 1 && order % 2 == 1;
    let has_odd = document.verdicts.iter().any(|verdict| is_odd(verdict.order))
        || document.recurrences.iter().any(|claim| !claim.odd.is_empty());
    // Its axis passes the crankshaft on the side that counts as negative.
    let is_below = |one: &&Cylinder| one.rod.on_the_pin().is_some_and(|rod| rod.offset.is_negative());
    if let Some(cylinder) = document.cylinders.iter().find(is_below).filter(|_| has_odd) {
        return Err(NotStated::Reversed(cylinder.name.clone()));
    }
    if document.quantities.contains(&Quantity::ROLL) {
        return Err(NotStated::SeveralCrankshafts);
    }
    if let Some(shaft) = document.turning_masses.iter().find(|mass| mass.coefficient_of.is_some()) {
        return Err(NotStated::SizedByRod(shaft.name.clone()));
    }
    Ok(())
}

fn check_cylinder(cylinder: &Cylinder) -> Result<(), NotStated> {
    if !cylinder.rod.is_rod() {
        return Err(NotStated::NoRod(cylinder.name.clone()));
    }
    if cylinder.speed == 1 && cylinder.crankshaft.is_none() { Ok(()) } else { Err(NotStated::SeveralCrankshafts) }
}
