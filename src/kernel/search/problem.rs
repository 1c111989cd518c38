//! Which stars are compared, and by what? The question of a search, and whether it makes sense.

use num_rational::BigRational;
use num_traits::Signed;

use crate::engine::{Cycle, CycleOrder, ORDERS};
use crate::exact::Turn;
use crate::stars::Pins;

/// More throws than this are not searched: twenty have 1.2e17 stars.
pub const MOST_THROWS: u32 = 20;
/// Finer grids than this are not searched.
pub const FINEST_GRID: u32 = 360;
/// Grids with more stars than this, up to rotation, are not searched.
pub const MOST_GRID_STARS: u128 = 1_000_000_000_000;
/// More orders than this are not compared at once.
pub const MOST_ORDERS: usize = 8;

/// A question: the best crank stars of which engine, by which orders of the moment?
///
/// Throws are one spacing apart, masses are equal, and moments are about the mid-plane.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Number of cylinders.
    pub cylinders: u32,
    /// Two-stroke or four-stroke: fixes the throws of an in-line engine that fires evenly.
    pub cycle: Cycle,
    /// The angle between the banks of a V of `cylinders / 2` throws, from bank 1 to bank 2 ([`bank_angle`]); `None` for an in-line engine.
    pub bank_angle: Option<Turn>,
    /// For a V: how many different directions the pins have, each as often as the others; as many as pins if `None`.
    pub directions: Option<u32>,
    /// Throws at any whole multiples of `1/grid` turn, as often as they like, with balanced first-order force.
    pub grid: Option<u32>,
    /// The orders whose moments are compared, rising.
    pub orders: Vec<u32>,
    /// Whether neighbours that fire in succession count too.
    pub neighbours: bool,
    /// For a V: how far ahead of the pin of bank 1 that of bank 2 stands; on one pin if `None`.
    pub pin_split: Option<Turn>,
    /// For a V: how far bank 1 stands towards the free end of bank 2, in spacings of the throws.
    pub bank_offset: Option<BigRational>,
    /// The orders of the cycle whose phase-vector sums are compared too, rising.
    pub minor_orders: Vec<CycleOrder>,
    /// The deflections of the throws that weigh these sums; falling evenly from the free end if `None`.
    pub mode_shape: Option<Vec<BigRational>>,
}

/// The angle from bank 1 of a V to bank 2, of turns as they were written: above 0 and below 1, and no other angle for it.
///
/// # Errors
/// What would be right.
pub fn bank_angle(turns: &BigRational) -> Result<Turn, ProblemError> {
    let whole = BigRational::from_integer(1.into());
    let size = turns.abs();
    match turns.is_negative() {
        false if *turns < whole => Ok(Turn::new(turns.clone())),
        true if size < whole => Err(ProblemError::new(format!(
            "a V of −{0}° is one of {0}° with its banks exchanged; give {0}, and pin split and bank offset with the other sign",
            Turn::new(size).degrees()
        ))),
        _ => Err(ProblemError::new("the angle from bank 1 to bank 2 is between 0 and 360")),
    }
}

/// Why a question has no answer: what is wrong, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ProblemError(String);

impl ProblemError {
    pub(super) fn new(message: impl Into<String>) -> Self {
        ProblemError(message.into())
    }
}

impl Problem {
    /// An in-line engine that fires evenly, compared by the moments of these orders.
    pub fn inline(cylinders: u32, cycle: Cycle, orders: &[u32]) -> Self {
        let orders = orders.to_vec();
        Problem {
            cylinders,
            cycle,
            bank_angle: None,
            directions: None,
            grid: None,
            orders,
            neighbours: false,
            pin_split: None,
            bank_offset: None,
            minor_orders: Vec::new(),
            mode_shape: None,
        }
    }

    /// A V on shared pins in different, evenly spread directions.
    pub fn vee(cylinders: u32, cycle: Cycle, bank_angle: Turn, orders: &[u32]) -> Self {
        Problem { bank_angle: Some(bank_angle), ..Problem::inline(cylinders, cycle, orders) }
    }

    /// Number of throws along the crankshaft: cylinders of an in-line engine, pins of a V.
    pub fn throws(&self) -> u32 {
        if self.bank_angle.is_some() { self.cylinders / 2 } else { self.cylinders }
    }

    /// The number of different directions, and how often each is taken (`None`: as often as it likes).
    pub(super) fn supply(&self) -> (u32, Option<u32>) {
        let throws = self.throws();
        let twice = self.bank_angle.is_none() && self.cycle == Cycle::FourStroke && throws.is_multiple_of(2);
        match (self.grid, self.directions) {
            (Some(grid), _) => (grid, None),
            (None, Some(directions)) => (directions, Some(throws / directions)),
            // Two cylinders that fire a revolution apart share a direction.
            (None, None) if twice => (throws / 2, Some(2)),
            (None, None) => (throws, Some(1)),
        }
    }

    /// Whether the question makes sense, and its stars can be searched.
    pub fn check(&self) -> Result<(), ProblemError> {
        self.check_engine()?;
        self.check_number()?;
        self.check_star()?;
        self.check_orders()?;
        self.check_minor_orders()
    }

    /// The same of a question that is answered without a search.
    pub(super) fn check_unsearched(&self) -> Result<(), ProblemError> {
        self.check_engine()?;
        self.check_star()?;
        self.check_orders()
    }

    /// How the throws stand, where directions are evenly spread and equally taken.
    pub(super) fn pins(&self) -> Option<Pins> {
        let (directions, each) = self.supply();
        each.map(|each| Pins { directions, each })
    }

    fn check_engine(&self) -> Result<(), ProblemError> {
        let cylinders = self.cylinders;
        if cylinders == 0 {
            return Err(ProblemError::new("an engine without cylinders has no crank star; give 1 or more"));
        }
        if let Some(angle) = &self.bank_angle {
            if *angle == Turn::zero() {
                return Err(ProblemError::new(
                    "a V of 0° has both banks in one place; give an angle between 0 and 360",
                ));
            }
            if !cylinders.is_multiple_of(2) {
                return Err(ProblemError::new(format!("a V has an even number of cylinders, and {cylinders} is odd")));
            }
        }
        Ok(())
    }

    fn check_number(&self) -> Result<(), ProblemError> {
        let cylinders = self.cylinders;
        if self.throws() > MOST_THROWS {
            let what = if self.bank_angle.is_some() { "cylinders in V" } else { "cylinders in line" };
            let most = MOST_THROWS * (cylinders / self.throws());
            return Err(ProblemError::new(format!(
                "up to {most} {what} are searched; {cylinders} have too many stars"
            )));
        }
        Ok(())
    }

    fn check_star(&self) -> Result<(), ProblemError> {
        let throws = self.throws();
        if let Some(directions) = self.directions {
            if self.bank_angle.is_none() {
                return Err(ProblemError::new("even firing fixes the directions of an in-line engine; leave them out"));
            }
            if self.grid.is_some() {
                return Err(ProblemError::new("a grid already says which directions there are; give one of the two"));
            }
            if directions == 0 || !throws.is_multiple_of(directions) {
                return Err(ProblemError::new(format!("{throws} pins cannot share {directions} directions equally")));
            }
        }
        if self.bank_angle.is_none() && (self.pin_split.is_some() || self.bank_offset.is_some()) {
            return Err(ProblemError::new("pin splits and bank offsets are those of a V; give its bank angle"));
        }
        let Some(grid) = self.grid else { return Ok(()) };
        if grid == 0 || grid > FINEST_GRID {
            return Err(ProblemError::new(format!("a grid has 1 to {FINEST_GRID} directions, not {grid}")));
        }
        if u128::from(grid).pow(throws - 1) > MOST_GRID_STARS {
            return Err(ProblemError::new(format!(
                "{throws} throws on {grid} directions make {grid}^{} stars; up to 10^12 are searched",
                throws - 1
            )));
        }
        Ok(())
    }

    fn check_orders(&self) -> Result<(), ProblemError> {
        if self.orders.is_empty() || self.orders.len() > MOST_ORDERS {
            return Err(ProblemError::new(format!(
                "1 to {MOST_ORDERS} orders are compared, not {}",
                self.orders.len()
            )));
        }
        if let Some(order) = self.orders.iter().find(|order| !ORDERS.contains(order)) {
            let right = format!("orders from 1 to {} are compared", ORDERS.end());
            return Err(ProblemError::new(format!("order {order} is none; {right}")));
        }
        if self.orders.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(ProblemError::new("orders are given rising, each once"));
        }
        match self.orders.iter().all(|&order| self.is_settled(order)) {
            true if self.bank_offset.is_some() => {
                Err(ProblemError::new("at this bank angle the moments of these orders are the same for every star"))
            }
            true => Err(ProblemError::new("at this bank angle the moments of these orders vanish for every star")),
            false => Ok(()),
        }
    }
}
