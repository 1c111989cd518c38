//! Why can tables not be written?

use std::fmt;

/// Why tables cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unwritable {
    /// The program was built without the format: the name of its feature.
    NotBuilt(&'static str),
    /// The format does not hold it; comma-separated values do.
    Refused(String),
    /// It could not be written in any format: a full disk, rows of other columns.
    Failed(String),
}

impl fmt::Display for Unwritable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unwritable::NotBuilt(feature) => write!(
                f,
                "this program was built without {feature}; build it with `cargo build --release --features {feature}`, or take --format csv"
            ),
            Unwritable::Refused(why) => write!(f, "the tables cannot be written: {why}; take --format csv"),
            Unwritable::Failed(why) => write!(f, "the tables cannot be written: {why}"),
        }
    }
}

impl std::error::Error for Unwritable {}
