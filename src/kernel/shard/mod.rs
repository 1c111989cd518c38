//! How is work cut among machines, and put together again? Numbered pieces, kept in files that tell which question they answer.
//!
//! A question has a fixed number of pieces, whoever computes them. [`Shard`] `i/N` takes every N-th of them; a [`Store`] is a file
//! that keeps finished ones, and goes on where it was stopped; [`Merged`] reads several such files as one. Since a piece is the same
//! bytes whichever machine makes it, what is merged is what one run gives.

mod frame;
mod in_order;
mod merged;
mod store;

use std::fmt;
use std::io;
use std::path::Path;

pub use in_order::{cores, in_order};
pub use merged::Merged;
pub use store::Store;

use crate::text::harmless;

/// One of N equal parts of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which one, from 1.
    number: usize,
    /// Of how many.
    of: usize,
}

/// What is asked, and into how many pieces that is cut.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The question in words that no other question shares.
    pub words: String,
    /// How many pieces it has.
    pub pieces: usize,
}

/// Why shards cannot be written, read or merged.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ShardError(String);

impl Shard {
    /// The whole question.
    pub const WHOLE: Shard = Shard { number: 1, of: 1 };

    /// Reads `i/N`.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::shard::Shard;
    /// let second = Shard::parse("2/3").unwrap();
    /// assert_eq!((0..8).filter(|piece| second.takes(*piece)).collect::<Vec<_>>(), [1, 4, 7]);
    /// assert!(Shard::parse("4/3").is_err());
    /// ```
    ///
    /// # Errors
    /// What no shard is.
    pub fn parse(text: &str) -> Result<Self, ShardError> {
        let numbers = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        match numbers {
            Some((number, of)) if 1 <= number && number <= of => Ok(Shard { number, of }),
            Some(_) | None => {
                let shown = harmless(text);
                Err(ShardError(format!("`{shown}` is not a shard; write i/N, from 1/N to N/N, such as 2/8")))
            }
        }
    }

    /// Whether it computes this piece.
    pub fn takes(self, piece: usize) -> bool {
        piece % self.of == self.number - 1
    }

    /// The shard of equally many that computes this piece.
    fn with(self, piece: usize) -> Shard {
        Shard { number: piece % self.of + 1, of: self.of }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl ShardError {
    fn of(path: &Path, what: impl fmt::Display) -> Self {
        ShardError(format!("`{}` {what}", harmless(&path.to_string_lossy())))
    }

    fn reading(path: &Path, error: &io::Error) -> Self {
        ShardError(format!("cannot read `{}`: {error}", harmless(&path.to_string_lossy())))
    }

    fn writing(path: &Path, error: &io::Error) -> Self {
        ShardError(format!("cannot write `{}`: {error}", harmless(&path.to_string_lossy())))
    }
}
