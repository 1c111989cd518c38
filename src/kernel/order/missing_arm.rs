//! Which length does the roll moment hang on that nobody gave?
//!
//! A force whose line passes beside the middle of the engine has an arm. Where a file omits what the arm is, the roll moment is
//! not given, unless all that has such an arm cancels whatever the length is.

use num_traits::Zero;

use super::source::Source;
use super::turning::{TurningMass, of_turning, turning_masses};
use crate::engine::{AxisLeftOut, Engine};
use crate::exact::{PhasorSum, Term};

/// A length that is not there, and that changes the roll moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MissingArm {
    /// The offset of an endless rod: it is no length.
    #[error("the offset of an endless rod is no length")]
    EndlessRod,
    /// How far apart the crankshafts stand, one above the other.
    #[error("the distance of the crankshafts is not given")]
    Distance,
    /// Where this crankshaft stands, by its index.
    #[error("crankshaft {} has no place", .0 + 1)]
    Crankshaft(usize),
    /// Where the axis of this balancer shaft stands, by its index.
    #[error("balancer shaft {} has neither height nor offset; add them to its table [[balancer]]", .0 + 1)]
    Balancer(usize),
}

/// What the roll moment of all masses of an engine lacks, the first of it; none where it can be given.
pub fn roll_lacks(engine: &Engine) -> Option<MissingArm> {
    if engine.rods().any(|rod| !rod.offset.is_zero() && rod.ratio.is_zero()) {
        return Some(MissingArm::EndlessRod);
    }
    let turning = turning_masses(engine);
    let bears = |index: usize| {
        engine.cylinders().iter().any(|cylinder| cylinder.crank == index)
            || turning.iter().any(|mass| mass.crank == Some(index))
    };
    let mut cranks = engine.geared_cranks().iter().enumerate();
    let nowhere = cranks.find(|(index, crank)| crank.left_out == Some(AxisLeftOut::Place) && bears(*index));
    let crank = nowhere.map(|(index, _)| MissingArm::Crankshaft(index));
    let distance = hangs_on_the_distance(engine, &turning).then_some(MissingArm::Distance);
    let shaft = turning.iter().find_map(|mass| match mass.source {
        Source::Balancer(index) => {
            let is_left_out = engine.crankshaft().balancers.get(index).is_some_and(|shaft| shaft.axis.is_none());
            is_left_out.then_some(MissingArm::Balancer(index))
        }
        _ => None,
    });
    crank.or(distance).or(shaft)
}

/// Whether what turns on crankshafts whose distance is omitted has a moment that grows with it. The cylinders lie on the line from
/// axis to axis: no force of a piston has an arm there.
fn hangs_on_the_distance(engine: &Engine, turning: &[TurningMass]) -> bool {
    let apart = |mass: &TurningMass| -> Option<(u32, Term)> {
        match &engine.geared_cranks().get(mass.crank?)?.left_out {
            Some(AxisLeftOut::Distance(axis)) => Some((mass.order, of_turning(mass, axis))),
            Some(AxisLeftOut::Place) | None => None,
        }
    };
    let terms: Vec<(u32, Term)> = turning.iter().filter_map(apart).collect();
    let mut orders: Vec<u32> = terms.iter().map(|(order, _)| *order).collect();
    orders.dedup();
    orders.into_iter().any(|order| {
        let of_order = terms.iter().filter(|(own, _)| *own == order).map(|(_, term)| term.clone());
        !PhasorSum::new(of_order.collect()).vanishes()
    })
}
