//! How is each question asked from Python? With the functions that the command line asks, a file each.

mod bearings;
mod firing;
mod loads;
mod remedy;
mod search;
mod sweep;
mod torque;
mod verify;

pub(super) use bearings::bearings;
pub(super) use firing::firing;
pub(super) use loads::loads;
pub(super) use remedy::{Remedy, Wanted, remedy};
pub(super) use search::search;
pub(super) use sweep::{Ranges, sweep};
pub(super) use torque::torque;
pub(super) use verify::{Checked, verify};
