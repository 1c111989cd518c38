//! Which way does the crank turn in the file's drawing, and from where is it seen? `rotation`, `seen_from`.

use num_rational::BigRational;
use num_traits::One;

use super::error::LayoutError;
use super::geared_keys::Geared;
use super::quantities::choice;
use super::written::Text;
use crate::engine::{Convention, Cylinder, Linear, Rotation, SeenFrom};

/// The two keys; where they are omitted, the crank turns anticlockwise seen from the free end.
pub(super) fn read(rotation: Option<&Text>, seen_from: Option<&Text>) -> Result<Convention, LayoutError> {
    let mut convention = Convention::default();
    if let Some(text) = rotation {
        let words = [("anticlockwise", Rotation::Anticlockwise), ("clockwise", Rotation::Clockwise)];
        let right = "\"clockwise\" or \"anticlockwise\", as the engine is drawn";
        convention.rotation = choice(text, "rotation", right, &words)?;
    }
    if let Some(text) = seen_from {
        let words = [("free end", SeenFrom::FreeEnd), ("flywheel", SeenFrom::Flywheel)];
        let right = "\"free end\" or \"flywheel\": the end of the crankshaft towards the reader";
        convention.seen_from = choice(text, "end", right, &words)?;
    }
    Ok(convention)
}

/// Throws and banks of a drawing as angles in the sense of rotation, and the axes of several crankshafts placed likewise.
pub(super) fn turn(cylinders: &mut [Cylinder<Linear, Linear>], geared: &mut [Geared], convention: Convention) {
    let sign = convention.in_the_sense_of_rotation(BigRational::one());
    for cylinder in cylinders.iter_mut().filter(|_| !sign.is_one()) {
        cylinder.throw = cylinder.throw.scaled(&sign);
        cylinder.bank = cylinder.bank.scaled(&sign);
    }
    geared.iter_mut().for_each(|crank| crank.axis.turn(convention));
}
