//! Why can tables not be written?

/// Why tables cannot be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unwritable {
    /// The program was built without the format: the name of its feature.
    #[error(
        "this program was built without {0}; build it with `cargo build --release --features {0}`, or take --format csv"
    )]
    NotBuilt(&'static str),
    /// The format does not hold it; comma-separated values do.
    #[error("the tables cannot be written: {0}; take --format csv")]
    Refused(String),
    /// It could not be written in any format: a full disk, rows of other columns.
    #[error("the tables cannot be written: {0}")]
    Failed(String),
}
