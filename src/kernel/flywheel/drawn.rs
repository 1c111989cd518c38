//! What does a torque tell by how it is drawn, and why may it tell nothing?

use num_rational::BigRational;

use super::with_pi::WithPi;
use crate::file::bare_number;

/// An area between two crossings.
#[derive(Clone, Debug)]
pub struct Lobe {
    /// Where it begins, in turns; none of areas that are given.
    pub from: Option<BigRational>,
    /// The work above the load, in joules; below it negative.
    pub work: WithPi,
    /// The running sum up to its end, in joules, from 0 before the first.
    pub sum: WithPi,
}

/// The part of an answer that depends on how the torque is drawn.
pub(super) struct Drawn {
    pub mean: Option<WithPi>,
    pub cycle: Option<BigRational>,
    pub energy: WithPi,
    pub fastest_and_slowest: Option<[f64; 2]>,
    pub lobes: Vec<Lobe>,
}

/// Why a diagram has no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoFluctuation {
    /// The load takes another work in a cycle than the engine gives: their means in N m.
    #[error(
        "the load takes another work in a cycle than the engine gives, so that no speed is kept: their means, {} and {} N m, must be equal",
        bare_number(.load), bare_number(.torque)
    )]
    Unequal {
        /// The mean of the load.
        load: Box<BigRational>,
        /// The mean of the torque of all cylinders.
        torque: Box<BigRational>,
    },
    /// The load is given for another cycle.
    #[error("the load's points span another angle than the torque's")]
    OtherCycle,
    /// Angles are asked of a diagram that is areas alone.
    #[error("areas alone do not give the torque at an angle: give points, triangles or harmonics")]
    NoAngles,
}
