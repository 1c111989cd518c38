//! What is wrong with a pressure, where, and what would be right?

use std::fmt;

use super::setting::Setting;

/// A pressure that cannot be.
#[derive(Clone, Debug, PartialEq, Eq)]
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
#[non_exhaustive]
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

impl fmt::Display for GasMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.message, self.right)
    }
}
