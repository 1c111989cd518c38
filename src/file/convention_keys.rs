//! Which way does the crank turn in the file's drawing, and from where is it seen? `rotation`, `seen_from`.

use num_rational::BigRational;
use num_traits::One;

use super::error::LayoutError;
use super::quantities::misread;
use super::written::{Text, place};
use crate::engine::{Convention, Cylinder, Linear, Rotation, SeenFrom};

/// The two keys; left out, the crank turns anticlockwise seen from the free end.
pub(super) fn read(rotation: Option<&Text>, seen_from: Option<&Text>) -> Result<Convention, LayoutError> {
    let mut convention = Convention::default();
    if let Some(text) = rotation {
        convention.rotation = match text.get_ref().0.as_str() {
            "anticlockwise" => Rotation::Anticlockwise,
            "clockwise" => Rotation::Clockwise,
            other => {
                let right = "\"clockwise\" or \"anticlockwise\", as the engine is drawn".to_owned();
                return Err(misread("rotation", other, right, text));
            }
        };
    }
    if let Some(text) = seen_from {
        convention.seen_from = match text.get_ref().0.as_str() {
            "free end" => SeenFrom::FreeEnd,
            "flywheel" => SeenFrom::Flywheel,
            other => {
                let right = "\"free end\" or \"flywheel\": the end of the crankshaft towards the reader".to_owned();
                return Err(misread("end", other, right, text));
            }
        };
    }
    Ok(convention)
}

/// Throws and banks of a drawing as angles in the sense of rotation.
pub(super) fn turn(cylinders: &mut [Cylinder<Linear, Linear>], convention: Convention) {
    let sign = convention.in_the_sense_of_rotation(BigRational::one());
    for cylinder in cylinders.iter_mut().filter(|_| !sign.is_one()) {
        cylinder.throw = cylinder.throw.scaled(&sign);
        cylinder.bank = cylinder.bank.scaled(&sign);
    }
}

/// Several crankshafts each have a sense of their own, which is told as seen from the free end.
pub(super) fn of_one_crankshaft(key: Option<&Text>) -> Result<(), LayoutError> {
    match key {
        None => Ok(()),
        Some(text) => Err(LayoutError::new(
            "one rotation for several crankshafts",
            "leave rotation and seen_from out: angles count anticlockwise from the free end, and each crankshaft has its sense",
            place(text),
        )),
    }
}
