//! From which end does the layout file look at the engine, and which way does the crank turn there?
//!
//! Inside, angles grow in the sense of rotation (theory of mechanisms, section 4): `α′ = σα`, `β′ = σβ`, σ = −1 for a crank that
//! turns clockwise as drawn. Verdicts, lengths and shapes are those of either drawing.

use std::ops::Neg;

use crate::exact::Turn;

/// Which way the crank turns, as the file draws it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotation {
    /// In the sense in which the angles of the file grow.
    #[default]
    Anticlockwise,
    /// Against it.
    Clockwise,
}

/// The end of the crankshaft that is towards the one who looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SeenFrom {
    /// The end where nothing is driven: +z is towards the reader.
    #[default]
    FreeEnd,
    /// The end that drives: +z is away from the reader.
    Flywheel,
}

/// How a layout file draws its engine; angles grow anticlockwise as drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Convention {
    /// Which way the crank turns there.
    pub rotation: Rotation,
    /// From where it is seen.
    pub seen_from: SeenFrom,
}

impl Convention {
    /// An angle of the file, or a length to its left, in the sense of rotation; the other way it is the same step. In any unit.
    pub fn in_the_sense_of_rotation<T: Neg<Output = T>>(self, angle: T) -> T {
        match self.rotation {
            Rotation::Anticlockwise => angle,
            Rotation::Clockwise => -angle,
        }
    }

    /// A direction in the sense of rotation as the file writes it.
    pub fn as_written(self, angle: &Turn) -> Turn {
        self.in_the_sense_of_rotation(angle.clone())
    }

    /// The end from which the crank turns anticlockwise: from there the angles in the sense of rotation are those of a drawing.
    pub fn turns_anticlockwise_from(self) -> SeenFrom {
        match (self.rotation, self.seen_from) {
            (Rotation::Anticlockwise, end) => end,
            (Rotation::Clockwise, SeenFrom::FreeEnd) => SeenFrom::Flywheel,
            (Rotation::Clockwise, SeenFrom::Flywheel) => SeenFrom::FreeEnd,
        }
    }
}
