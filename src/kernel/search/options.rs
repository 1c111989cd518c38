//! What is asked of a search, and how does it end?

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use super::plan::Way;
use super::problem::ProblemError;
use crate::shard::{ShardError, cores};

/// How far a search is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Pieces finished, those of earlier runs too.
    pub done: usize,
    /// Pieces in all, of a shard those that it has.
    pub pieces: usize,
    /// Stars judged in this run.
    pub judged: u64,
}

/// How to search.
pub struct Options<'a> {
    /// Number of threads, at least 1.
    pub threads: usize,
    /// How the stars are gone through; the front is the same.
    pub way: Way,
    /// The file that keeps the finished pieces.
    pub resume: Option<PathBuf>,
    /// Told after each piece; a break stops the search.
    pub progress: &'a (dyn Fn(Progress) -> ControlFlow<()> + Sync),
    /// Once it is set, no piece is begun any more.
    pub stop: Option<&'a AtomicBool>,
}

impl Options<'_> {
    /// Whether somebody waits for the end.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

impl Default for Options<'_> {
    /// One thread per available core, nothing kept, nothing told.
    fn default() -> Self {
        Options {
            threads: cores(),
            way: Way::default(),
            resume: None,
            progress: &|_| ControlFlow::Continue(()),
            stop: None,
        }
    }
}

/// Why a search has no front.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// The question makes no sense.
    #[error("{0}")]
    Problem(ProblemError),
    /// A file of pieces cannot be read or written, or is none of this search.
    #[error("{0}")]
    Pieces(ShardError),
    /// A piece cannot be put into words.
    #[error("a piece cannot be written: {0}")]
    NotWritten(String),
    /// A piece is whole, but cannot have come of this search.
    #[error("`{files}` does not fit this search at piece {piece}; remove it and compute it again")]
    DoesNotFit {
        /// Its number.
        piece: usize,
        /// The files that were read.
        files: String,
    },
    /// Stopped by the progress callback, or by the flag.
    #[error("stopped")]
    Stopped,
}
