//! Which mode shape do firing orders of a search have, and what do its minor orders sum to?

use num_rational::BigRational;
use num_traits::Zero;

use super::firing;
use super::problem::{Problem, ProblemError};
use crate::engine::{Cycle, CycleOrder};
use crate::exact::{PhasorSum, Term};
use crate::firing::NoStar;
use crate::text::counted;

/// Cylinders of more instants than this, two at each, may fire in more than 256 orders.
const MOST_CHOICES: u32 = 9;

/// The mode in which the firing orders of a front are evaluated: a given one, or one that falls evenly from the free end, n, n − 1, …, 1.
///
/// # Errors
/// A mode shape with another number of values than the crankshaft has throws, or more than 256 firing orders of each star.
pub fn mode_shape(problem: &Problem, shape: Option<Vec<BigRational>>) -> Result<Vec<BigRational>, ProblemError> {
    let instants = if problem.cycle == Cycle::FourStroke { problem.cylinders / 2 } else { 1 };
    if instants > MOST_CHOICES {
        return Err(ProblemError::new(format!(
            "a star of {} cylinders has 2^{} firing orders, too many to list; omit --torsion",
            problem.cylinders,
            instants - 1
        )));
    }
    deflections(problem, shape)
}

/// The deflections of all throws.
pub(super) fn deflections(
    problem: &Problem,
    shape: Option<Vec<BigRational>>,
) -> Result<Vec<BigRational>, ProblemError> {
    let throws = problem.throws();
    let falling = || (1..=throws).rev().map(|deflection| BigRational::from_integer(deflection.into())).collect();
    let shape: Vec<BigRational> = shape.unwrap_or_else(falling);
    match shape.len() == throws as usize {
        true if shape.iter().all(Zero::is_zero) => Err(ProblemError::new(NoStar::NoDeflection.to_string())),
        true => Ok(shape),
        false => {
            let each = if problem.bank_angle.is_some() { "throw" } else { "cylinder" };
            Err(ProblemError::new(format!(
                "the mode shape has {} for {}; one per {each} is needed",
                counted(shape.len(), "value"),
                counted(throws as usize, each)
            )))
        }
    }
}

/// The phase-vector sum of an even firing order.
pub(super) fn sum(firing_order: &[usize], cycle: Cycle, shape: &[BigRational], order: CycleOrder) -> PhasorSum {
    let shots = firing::even(firing_order, cycle).shots.into_iter();
    let term = |(cylinder, angle): (usize, BigRational)| Term {
        angle: order.phase(&angle),
        weight: shape[cylinder % shape.len()].clone(),
    };
    PhasorSum::new(shots.map(|shot| term((shot.cylinder, shot.angle))).collect())
}
