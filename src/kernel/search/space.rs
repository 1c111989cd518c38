//! Which stars are there? Places along the crankshaft, directions to fill them with, and the order of filling.

use num_bigint::BigUint;

use super::balanced;
use super::clock::Clock;
use super::entangled::Entangled;
use super::problem::{Problem, ProblemError};
use super::symmetry::{EVERY_IMAGE, Same};
use super::twist::Twist;

/// All stars of a problem. Cylinder 1 has direction 0, which takes one star of each class of rotations.
pub(super) struct Space {
    /// How many directions make a turn.
    pub directions: usize,
    /// How often each direction is taken; `None` as often as it likes, with balanced first-order force of the engine.
    pub supply: Option<usize>,
    /// Whether the pins have to balance it among themselves: on a grid, unless the banks of every throw do.
    pub pins_balance: bool,
    /// Number of throws.
    pub places: usize,
    /// Places in the order of filling: the outermost pair first, `0, n−1, 1, n−2, …`, a middle one last.
    pub sequence: Vec<usize>,
    /// Twice the arm of each place, in spacings: `n − 1 − 2·place`.
    pub weights: Vec<i64>,
    /// The orders whose moments differ from star to star.
    pub orders: Vec<u32>,
    /// When the cylinders fire; kept where neighbours count.
    pub clock: Option<Clock>,
    /// The minor orders that count.
    pub twist: Option<Twist>,
    /// The moments of all cylinders, where those of the pins do not tell them; then `orders` is empty.
    pub entangled: Option<Entangled>,
    /// Which images (mirror, reversal, both) have the same values.
    pub keeps: Same,
}

impl Space {
    pub fn new(problem: &Problem) -> Result<Self, ProblemError> {
        problem.check()?;
        Space::unchecked(problem)
    }

    /// The stars of a question that may have too many to be searched.
    pub fn of_any_size(problem: &Problem) -> Result<Self, ProblemError> {
        problem.check_unsearched()?;
        Space::unchecked(problem)
    }

    fn unchecked(problem: &Problem) -> Result<Self, ProblemError> {
        let places = problem.throws() as usize;
        let (directions, supply) = problem.supply();
        let sequence = (0..places).map(|at| if at % 2 == 0 { at / 2 } else { places - 1 - at / 2 }).collect();
        let weights = (0..places as i64).map(|place| places as i64 - 1 - 2 * place).collect();
        let (twist, entangled) = (Twist::new(problem)?, Entangled::new(problem)?);
        let keeps = match (&entangled, twist.as_ref().is_none_or(|twist| twist.reverses)) {
            // The mirror image changes the banks, and so does the shaft end for end.
            (Some(_), _) => [false, false, true],
            (None, true) => EVERY_IMAGE,
            (None, false) => [true, false, false],
        };
        let differs = |order: &u32| entangled.is_none() && !problem.is_settled(*order);
        let orders = problem.orders.iter().copied().filter(differs).collect();
        let clock = problem.neighbours.then(|| Clock::new(problem)).transpose()?;
        Ok(Space {
            directions: directions as usize,
            supply: supply.map(|supply| supply as usize),
            pins_balance: supply.is_none() && !problem.banks_cancel(1),
            places,
            sequence,
            weights,
            orders,
            clock,
            twist,
            entangled,
            keeps,
        })
    }

    /// Whether all stars of a class have the same values, each one set of them.
    pub fn gives_one_point(&self) -> bool {
        self.keeps == EVERY_IMAGE && self.twist.is_none()
    }

    /// Pairs of places symmetric about the mid-plane.
    pub fn pairs(&self) -> usize {
        self.places / 2
    }

    /// Number of stars with cylinder 1 at direction 0, before any of them is evaluated.
    pub fn count(&self) -> BigUint {
        let factorial = |n: usize| (1..=n).map(BigUint::from).product::<BigUint>();
        match self.supply {
            None => BigUint::from(self.directions).pow(self.places as u32 - 1),
            Some(supply) => factorial(self.places - 1) * supply / factorial(supply).pow(self.directions as u32),
        }
    }

    /// Whether throws (direction of each place) are a star of this space.
    pub fn holds(&self, throws: &[u16]) -> bool {
        let mut taken = vec![0; self.directions];
        for &throw in throws {
            match taken.get_mut(usize::from(throw)) {
                Some(count) => *count += 1,
                None => return false,
            }
        }
        let supplied = self.supply.is_none_or(|supply| taken.iter().all(|&count| count == supply));
        throws.len() == self.places && throws[0] == 0 && supplied && self.is_balanced(throws)
    }

    /// How many of them have balanced first-order force, where not all need to have it.
    pub fn count_of_balanced(&self) -> Option<u64> {
        self.pins_balance.then(|| balanced::count(self.directions, self.places))
    }

    /// Whether the pins balance the first-order force, where they have to.
    pub fn is_balanced(&self, throws: &[u16]) -> bool {
        if !self.pins_balance {
            return true;
        }
        let terms: Vec<(u64, i64)> = throws.iter().map(|&throw| (u64::from(throw), 1)).collect();
        crate::exact::vanishes(&(self.directions as u64), &terms)
    }
}
