//! How is the flywheel written? `[flywheel]`: its inertia, or how evenly the engine is to turn, or both.

use num_rational::BigRational;
use num_traits::{One, Signed};
use serde::Deserialize;

use super::error::LayoutError;
use super::number::parse_number;
use super::quantities::{misread, value};
use super::units;
use super::written::Text;
use crate::engine::Flywheel;

/// `[flywheel]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    inertia: Option<Text>,
    irregularity: Option<Text>,
}

impl Keys {
    pub fn read(&self) -> Result<Flywheel, LayoutError> {
        Ok(Flywheel {
            inertia: self.inertia.as_ref().map(inertia).transpose()?,
            irregularity: self.irregularity.as_ref().map(irregularity).transpose()?,
        })
    }
}

const WHAT: &str = "moment of inertia";

fn inertia(text: &Text) -> Result<BigRational, LayoutError> {
    let value = value(text, WHAT, units::inertia)?;
    let right = "above 0; of all that turns with the crank";
    if value.is_positive() { Ok(value) } else { Err(misread(text, WHAT, right)) }
}

/// Largest speed less smallest, over the mean: ±1 % of the mean is 0.02.
pub(super) fn irregularity(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    let refuse = |right: String| misread(text, "coefficient of fluctuation", right);
    let (rest, mut by) = match written.trim().strip_prefix('±') {
        Some(rest) => (rest, BigRational::from_integer(2.into())),
        None => (written.trim(), BigRational::one()),
    };
    let number = match rest.strip_suffix('%') {
        Some(rest) => {
            by /= BigRational::from_integer(100.into());
            rest
        }
        None => rest,
    };
    let value = parse_number(number.trim()).map_err(|error| refuse(error.to_string()))? * by;
    let fits = units::has_a_size(&value) && value.is_positive() && value < BigRational::one();
    let right = "largest speed less smallest, over the mean: such as 0.02, \"1/50\", \"2 %\" or \"±1 %\"";
    if fits { Ok(value) } else { Err(refuse(right.to_owned())) }
}
