//! Which engines can a file of Coq not state?

use std::fmt;

use num_traits::Signed;

use crate::proof::{Cylinder, Document, Masses, Quantity};
use crate::text::harmless;

/// Why there is no file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotStated {
    /// A cylinder has no rod of its own on the crankpin.
    NoRod(String),
    /// Several crankshafts, and the roll moment with them.
    SeveralCrankshafts,
    /// A shaft is sized by the number c_k of a rod.
    SizedByRod(String),
    /// An odd order of this cylinder has its sign turned, as its offset is below 0.
    Reversed(String),
    /// What makes all weights whole holds the prime of a residue once more than what makes the collected ones whole.
    Scale {
        /// Of what.
        quantity: Quantity,
        /// The order.
        order: u32,
    },
}

impl fmt::Display for NotStated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no file of Coq can state this engine: ")?;
        match self {
            NotStated::NoRod(name) => {
                write!(f, "cylinder {} has no rod on the crankpin, but several vectors in an order", harmless(name))
            }
            NotStated::SeveralCrankshafts => {
                f.write_str("it has several crankshafts; formal/Engine.v knows one, that turns once in a revolution")
            }
            NotStated::SizedByRod(name) => {
                write!(f, "{} is sized by the number c_k of a rod, which is not rational", harmless(name))
            }
            NotStated::Reversed(name) => write!(
                f,
                "cylinder {} has an offset below 0, which turns the sign of its odd orders above 1; omit them and --all-orders",
                harmless(name)
            ),
            NotStated::Scale { quantity, order } => write!(
                f,
                "the weights of order {order} of the {} have a denominator that the prime of its evidence divides; scale masses and \
                 lengths by another number",
                quantity.name()
            ),
        }
    }
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
