//! Where does the knuckle pin of a link stand? `knuckle_angle`, or `knuckle_correction`, in `[articulated]`.

use num_rational::BigRational;
use num_traits::Signed;

use super::error::LayoutError;
use super::quantities::{known_angle, twice};
use super::written::{Column, Text, place};
use crate::exact::Turn;

/// The two keys, either of which may be given.
#[derive(Clone, Copy)]
pub(super) struct Keys<'a> {
    /// γ, from the master rod on.
    pub angle: Option<&'a Column>,
    /// ε, from the angle of the cylinder on.
    pub correction: Option<&'a Column>,
}

impl Keys<'_> {
    /// ε of the link of a cylinder, which is at Δ from that of its master; `value` is what a key says of this link.
    pub fn correction(
        &self,
        (name, delta): (&str, &Turn),
        value: impl Fn(&Column) -> Result<Text, LayoutError>,
    ) -> Result<Turn, LayoutError> {
        let (text, correction) = match (self.angle, self.correction) {
            (None, None) => return Ok(Turn::zero()),
            (Some(_), Some(list)) => return Err(twice("knuckle_angle", "knuckle_correction", list)),
            (Some(list), None) => {
                let text = value(list)?;
                let angle = known_angle(&text)?;
                (text, &Turn::new(angle) - delta)
            }
            (None, Some(list)) => {
                let text = value(list)?;
                let correction = known_angle(&text)?;
                (text, Turn::new(correction))
            }
        };
        let [off, at] = [&correction, delta].map(signed_degrees);
        if off.abs() < BigRational::from_integer(90.into()) {
            return Ok(correction);
        }
        let message = format!("the knuckle pin of cylinder {name} is {off}° ahead of its cylinder");
        let right = format!(
            "a correction is less than 90° either way; a knuckle angle counts from the master rod on, in the sense of rotation, where this cylinder is at {at}°"
        );
        Err(LayoutError::new(message, &right, place(&text)))
    }
}

/// In degrees above −180 and up to 180.
fn signed_degrees(angle: &Turn) -> BigRational {
    let (degrees, whole) = (angle.degrees(), BigRational::from_integer(360.into()));
    if &degrees + &degrees > whole { degrees - whole } else { degrees }
}
