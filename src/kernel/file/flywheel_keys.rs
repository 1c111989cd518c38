//! How is the flywheel written? `[flywheel]`: its inertia, or how evenly the engine is to turn, or both.

use num_rational::BigRational;
use num_traits::{One, Signed};
use serde::Deserialize;

use super::error::LayoutError;
use super::number::parse_number;
use super::quantities::misread;
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

fn inertia(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    let refuse = |right: String| misread("moment of inertia", written, right, text);
    let value = units::inertia(written).map_err(refuse)?;
    if value.is_positive() { Ok(value) } else { Err(refuse("above 0; of all that turns with the crank".to_owned())) }
}

fn irregularity(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    let refuse = |right: String| misread("irregularity", written, right, text);
    let value = parse_number(written).map_err(|error| refuse(error.to_string()))?;
    let fits = units::has_a_size(&value) && value.is_positive() && value < BigRational::one();
    if fits {
        Ok(value)
    } else {
        Err(refuse("largest speed less smallest, over the mean: such as \"1/50\"".to_owned()))
    }
}
