//! What does a document say that it is?

use serde::{Deserialize, Serialize};

/// What a document says that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// Verdicts on an engine.
    #[serde(rename = "crankstar classify 2")]
    Classify,
    /// Verdicts on a family of engines.
    #[serde(rename = "crankstar family 2")]
    Family,
    /// A remedy.
    #[serde(rename = "crankstar remedy 2")]
    Remedy,
    /// Firing stars of an engine.
    #[serde(rename = "crankstar firing 1")]
    Firing,
    /// Numbers of one engine, with the verdicts on it.
    #[serde(rename = "crankstar loads 4")]
    Loads,
    /// Engines side by side, with the verdicts on each.
    #[serde(rename = "crankstar compare 4")]
    Compare,
}
