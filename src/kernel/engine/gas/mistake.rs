//! What is wrong with a pressure, where, and what would be right?

use num_rational::BigRational;
use num_traits::Signed;

use super::setting::Setting;

/// A pressure that cannot be.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}; {right}")]
pub struct GasMistake {
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub right: String,
    /// Where.
    pub at: At,
}

/// Where a mistake is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// In the gas as a whole.
    All,
    /// In a row of a table, counted from 0.
    Row(usize),
    /// In one value.
    Setting(Setting),
}

impl GasMistake {
    pub(super) fn new(message: impl Into<String>, right: impl Into<String>, at: At) -> Self {
        GasMistake { message: message.into(), right: right.into(), at }
    }
}

pub(super) fn above_zero(value: &BigRational, setting: Setting) -> Result<(), GasMistake> {
    in_range(value.is_positive(), value, setting, "a value above 0; pressures are absolute")
}

/// Exponents of a change of state: 1 would be isothermal, and no gas has more than 5/3.
pub(super) fn is_exponent(value: &BigRational, setting: Setting) -> Result<(), GasMistake> {
    let ends = [BigRational::from_integer(1.into()), BigRational::from_integer(2.into())];
    let fits = ends[0] < *value && *value <= ends[1];
    in_range(fits, value, setting, "above 1 and at most 2, such as 1.32")
}

fn in_range(fits: bool, value: &BigRational, setting: Setting, right: &str) -> Result<(), GasMistake> {
    let mistake = || GasMistake::new(format!("{} is {value}", setting.key()), right, At::Setting(setting));
    if fits { Ok(()) } else { Err(mistake()) }
}
