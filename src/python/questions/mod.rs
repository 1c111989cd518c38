//! How is each question asked from Python? With the functions that the command line asks, a file each.

mod remedy;
mod search;
mod sweep;
mod verify;

pub(super) use remedy::{Remedy, Wanted, remedy};
pub(super) use search::{StarRequest, search};
pub(super) use sweep::{ranges, sweep};
pub(super) use verify::{Checked, verify};
