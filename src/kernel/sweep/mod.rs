//! How does the balance change with a parameter of the layout: a bank angle, a rod ratio, a spacing?
//!
//! Any value of a layout file runs over an exact range; two at once span a map. For each point the file with that value is
//! read as any other, and its vectors are summed in floats. Whether a sum vanishes is decided exactly: floats only rule out
//! sums that are further from zero than floats can be off by, and by far. Where the parameter is an angle,
//! [`zeros()`] finds the exact angles at which each vector vanishes, between the points of the grid too.

mod amplitude;
mod counterweight;
mod envelope;
mod evenness;
mod firing;
mod integers;
mod multiples;
mod observed;
mod opened;
mod parameter;
mod range;
mod reader;
mod record;
mod run;
mod stream;
mod swept_engine;
mod zeros;

pub use amplitude::{Amplitude, Amplitudes};
pub use envelope::{Envelope, Geometry, envelope};
pub use evenness::{Evenness, dead_centre_intervals, most_even_firings};
pub use firing::{FiringSweep, FiringZeros, StarLength};
pub use multiples::Multiples;
pub use observed::{Observed, ObservedSweep, Observer};
pub use opened::zeros;
pub use parameter::{Parameter, SHORT_CUTS};
pub use range::{MOST_POINTS, Range};
pub use record::Sweep;
pub use run::sweep;
pub use stream::{NOTHING_SWEPT, Stream};
pub use swept_engine::{SweptEngine, SweptOrder, judge};
pub use zeros::{ZeroSet, Zeros};

use crate::file::LayoutError;

/// Why a sweep is refused.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{0}")]
pub struct SweepError(String);

impl SweepError {
    pub(super) fn new(message: impl Into<String>) -> Self {
        SweepError(message.into())
    }

    /// A layout that cannot be read with these values, which `at` names.
    fn at(at: &str, error: &LayoutError) -> Self {
        match error.span().filter(|span| !span.is_empty()) {
            Some(_) => SweepError(format!("with {at} the layout cannot be read:\n{error}")),
            None => SweepError(format!("with {at}: {}; {}", error.message(), error.right())),
        }
    }
}
