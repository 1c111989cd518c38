//! What does a form need that is above its table? The firing, from which throws follow that it omits, and the drawing.

use std::ops::Range;

use num_rational::BigRational;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::firing_order::{self, FiringOrder};
use super::quantities::{List, angle, angles};
use super::written::place;
use crate::engine::{Convention, Cycle, Cylinder, Linear, MOST_CYLINDERS, not_one_each};

/// The keys above the form.
pub(super) struct SharedKeys<'a> {
    pub order: Option<&'a Spanned<FiringOrder>>,
    pub angles: Option<&'a List>,
    pub cycle: Option<Cycle>,
    pub convention: Convention,
}

/// Where the throws of a form come from.
pub(super) enum Throws {
    /// The file lists them.
    Listed,
    /// They follow from the firing; those of the cylinders count from their pins so far.
    Follow {
        /// Whether the file, or the form, says how the throws of one pin stand to each other.
        splits_given: bool,
        /// How each pin stands to its throw, one per cylinder; empty where pins are at their throws.
        splays: Vec<Splay>,
    },
}

/// How the pin of a cylinder in a narrow V stands to its throw, in the sense of rotation.
#[derive(Clone)]
pub(super) struct Splay {
    /// How far it is turned with its bank.
    pub pin: Linear,
    /// How much of that is more than the bank itself is turned: what the dead centre of an offset axis asks for, as it is rounded.
    pub beyond: Linear,
}

impl Throws {
    /// Listed, or to follow.
    pub fn of(list: &Option<List>, splits_given: bool) -> Self {
        match list {
            Some(_) => Throws::Listed,
            None => Throws::Follow { splits_given, splays: Vec::new() },
        }
    }
}

impl SharedKeys<'_> {
    /// The place where the firing is said, if it is said with its cycle.
    pub fn firing_place(&self) -> Option<Range<usize>> {
        self.cycle?;
        self.order.and_then(place).or_else(|| self.angles.and_then(place))
    }

    /// The throws of the pins, as listed; or a zero for each, as many as the firing needs for this many banks. And where it is said.
    pub fn throws(
        &self,
        list: &Option<List>,
        banks: usize,
        table: Range<usize>,
    ) -> Result<(Vec<Linear>, Range<usize>), LayoutError> {
        if let Some(list) = list {
            return Ok((angles(list)?, list.span()));
        }
        let Some(said) = self.firing_place() else { return Err(missing(Some(table))) };
        let (count, what) = match (self.order, self.angles) {
            (Some(order), _) => (order.get_ref().len(), "a firing order"),
            (None, angles) => (angles.map_or(0, |list| list.get_ref().len()), "firing angles"),
        };
        if count > MOST_CYLINDERS {
            let message = format!("{what} of {count} cylinders");
            return Err(LayoutError::new(message, format!("up to {MOST_CYLINDERS} are read"), Some(said)));
        }
        if count == 0 && self.order.is_some() {
            let right = "such as \"1-3-4-2\" or [1, 3, 4, 2]";
            return Err(LayoutError::new("the firing order is empty", right, Some(said)));
        }
        if count % banks != 0 {
            let message = format!("{what} of {count} cylinders for {banks} banks");
            return Err(LayoutError::new(message, "every bank has a cylinder at each pin", Some(said)));
        }
        Ok((vec![Linear::default(); count / banks], said))
    }

    /// The crank angle in turns at which each cylinder fires; a firing order is taken to fire evenly.
    pub fn fires(&self, cylinders: &[Cylinder<Linear, Linear>]) -> Result<Vec<Linear>, LayoutError> {
        match (self.order, self.angles, self.cycle) {
            (Some(_), Some(list), _) => Err(firing_order::both_given(list)),
            (Some(order), None, Some(cycle)) => {
                let indices = order.get_ref().indices(cylinders, place(order))?;
                Ok(evenly(&indices, cycle))
            }
            (None, Some(list), Some(_)) if list.get_ref().len() == cylinders.len() => {
                list.get_ref().iter().map(angle).collect()
            }
            (None, Some(list), Some(_)) => {
                let (message, right) = not_one_each(list.get_ref().len(), cylinders.len());
                Err(LayoutError::new(message, right, place(list)))
            }
            (_, _, None) | (None, None, _) => Err(missing(None)),
        }
    }
}

/// When the cylinders fire, evenly in this order.
pub(super) fn evenly(order: &[usize], cycle: Cycle) -> Vec<Linear> {
    let interval = cycle.turns() / BigRational::from_integer(order.len().max(1).into());
    let mut fires = vec![Linear::default(); order.len()];
    for (position, &cylinder) in order.iter().enumerate() {
        fires[cylinder] = Linear::constant(&interval * BigRational::from_integer(position.into()));
    }
    fires
}

/// Neither throws nor a firing from which they follow.
pub(super) fn missing(table: Option<Range<usize>>) -> LayoutError {
    let right = "add throws = [0, 180, …], or above the table a firing_order with its cycle";
    LayoutError::new("the crank throws are missing", right, table)
}
