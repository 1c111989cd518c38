//! Which way does the crank turn in the file's drawing, and from where is it seen? `rotation`, `seen_from`.

use num_rational::BigRational;
use num_traits::One;

use super::error::LayoutError;
use super::geared_keys::Geared;
use super::quantities::misread;
use super::written::Text;
use crate::engine::{Convention, Cylinder, Linear, Rotation, SeenFrom};

/// The two keys; where they are omitted, the crank turns anticlockwise seen from the free end.
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

/// Throws and banks of a drawing as angles in the sense of rotation, and the axes of several crankshafts placed likewise.
pub(super) fn turn(cylinders: &mut [Cylinder<Linear, Linear>], geared: &mut [Geared], convention: Convention) {
    let sign = convention.in_the_sense_of_rotation(BigRational::one());
    for cylinder in cylinders.iter_mut().filter(|_| !sign.is_one()) {
        cylinder.throw = cylinder.throw.scaled(&sign);
        cylinder.bank = cylinder.bank.scaled(&sign);
    }
    geared.iter_mut().for_each(|crank| crank.axis.turn(convention));
}
