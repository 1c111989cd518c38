//! Which throws do cylinders need that fire so, and how far apart do those of one pin stand?

use num_rational::BigRational;

use crate::engine::{Cylinder, Linear};

/// The throws, each in [0, 1), with which the cylinders fire so.
pub(super) fn throws_of(cylinders: &[Cylinder<Linear, Linear>], fires: &[Linear]) -> Vec<Linear> {
    let all: Vec<Linear> = cylinders.iter().zip(fires).map(|(cylinder, fires)| cylinder.bank.minus(fires)).collect();
    let first = all.first().cloned().unwrap_or_default();
    all.iter().map(|throw| reduced(throw.minus(&first))).collect()
}

/// A throw in [0, 1), the unknowns as they are.
pub(super) fn reduced(throw: Linear) -> Linear {
    throw.minus(&Linear::constant(throw.known().floor()))
}

/// Cylinders of one pin, the first with each of the others.
pub(super) fn neighbours(cylinders: &[Cylinder<Linear, Linear>]) -> impl Iterator<Item = [usize; 2]> + '_ {
    cylinders.iter().enumerate().filter_map(|(index, cylinder)| {
        let first = cylinders.iter().position(|other| other.pin == cylinder.pin)?;
        (first != index).then_some([first, index])
    })
}

/// The pins of two banks, so far apart at every pin, in turns, where that is one angle.
pub(super) fn split_of(cylinders: &[Cylinder<Linear, Linear>], throws: &[Linear]) -> Option<Linear> {
    let mut splits = neighbours(cylinders).map(|[one, other]| signed(throws[other].minus(&throws[one])));
    let first = splits.next()?;
    splits.all(|split| split == first).then_some(first)
}

/// From more than −1/2 up to 1/2 of a turn; the unknowns as they are.
pub(super) fn signed(angle: Linear) -> Linear {
    let half = BigRational::new(1.into(), 2.into());
    let turns = (angle.known() - &half).ceil();
    angle.minus(&Linear::constant(turns))
}
