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

fn irregularity(text: &Text) -> Result<BigRational, LayoutError> {
    let value = parse_number(&text.get_ref().0).map_err(|error| misread(text, "irregularity", error.to_string()))?;
    let fits = units::has_a_size(&value) && value.is_positive() && value < BigRational::one();
    let right = "largest speed less smallest, over the mean: such as \"1/50\"";
    if fits { Ok(value) } else { Err(misread(text, "irregularity", right)) }
}
