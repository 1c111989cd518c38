//! What is answered: the masses that balance a shaft, or why there are none?

use num_rational::BigRational;

use super::exact::Real;
use crate::exact::{PhasorSum, Turn};

/// What is known of masses on a shaft.
#[derive(Clone, Debug)]
pub enum Answer {
    /// Nothing is wanted, and nothing is left: proved.
    Balanced,
    /// Nothing is wanted, and this is left: `ΣU` and `ΣzU` about position 0.
    Residual(Box<[PhasorSum; 2]>),
    /// All solutions: one, or two that are mirrored.
    Found(Vec<Vec<Found>>),
    /// No masses balance it.
    Never(Reason),
    /// Any of many do.
    Many(Reason),
}

/// Why there is no solution, or more than can be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Both wanted masses are in one plane, and a couple is left.
    OnePlane,
    /// The wanted mass can balance the force, but then a couple is left.
    Couple,
    /// The forces cannot be balanced in these directions.
    Force,
    /// A couple is left in a direction in which the wanted masses balance no force.
    CoupleAlone,
    /// The one mass would have to be in no plane: force and couple are not parallel.
    NotParallel,
    /// Both wanted masses are in one line, and their planes are free.
    OneLine,
    /// Of three moments about the plane of the wanted mass, one is larger than the other two together.
    NoTriangle,
    /// Balanced without the wanted masses, so that their planes and directions are free.
    BalancedAlready,
}

/// What was found of a mass.
#[derive(Clone, Debug)]
pub struct Found {
    /// Which mass, by its index.
    pub index: usize,
    /// Mass times radius in kilogram-metres, 0 or more.
    pub mass_radius: Real,
    /// The vector itself, where it is a sum of vectors at rational angles.
    pub vector: Option<PhasorSum>,
    /// The direction in degrees from 0 to 360, half a turn from that of the file where a mass there would have to be below 0; of a mass of 0 any
    /// would do.
    pub angle: f64,
    /// The same exactly, where the file gives a direction: that one, or the opposite one.
    pub turn: Option<Turn>,
    /// The cosine of the direction against that of the first mass without an angle, where that is rational.
    pub cosine: Option<BigRational>,
    /// Where it stands, in metres, where that was wanted.
    pub position: Option<Real>,
}

/// Which unknowns are not solved for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "these unknowns are not solved for; what may be omitted: mass (or radius) and angle of one or two masses, and of one that is wanted alone its position too; the masses of one or two whose angles are given, with or without their positions; mass and angle of one with the angles of three others, or of two of them, or its mass alone with the angles of all three; with secondary = true the angles of four cranks in planes symmetric about the middle and the masses of the inner two, the outer two being equal"
)]
pub struct NotSolved;
