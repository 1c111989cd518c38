//! When do the cylinders of a star fire, and how many neighbours fire in succession?
//!
//! Neighbours are on neighbouring throws in the same bank. They fire in succession if no third instant lies between theirs on one side
//! of the cycle, and at once if the instants are one.

use num_bigint::BigInt;
use num_traits::ToPrimitive;

use super::firing;
use super::problem::{Problem, ProblemError};
use crate::engine::Cycle;
use crate::exact::{Turn, fraction};

/// Four-stroke engines of more cylinders that fire unevenly have too many choices of the revolution.
const MOST_CHOOSING: u32 = 12;
/// More ticks than this a revolution has not: squares of intervals are added in 128 bits.
const MOST_TICKS: u64 = 1 << 40;

/// The crank angles at which the cylinders on each direction are at top dead centre, as whole ticks after that of cylinder 1.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    /// Throws along the shaft.
    throws: usize,
    /// How often each direction is taken; `None` on a grid.
    supply: Option<usize>,
    /// Ticks of a revolution.
    turn: u64,
    /// Revolutions of a cycle.
    revolutions: u64,
    /// For each bank and direction.
    ticks: Vec<Vec<u64>>,
    /// For each bank and direction the steps of an even cycle at this angle, whole revolutions omitted.
    steps: Vec<Vec<Vec<usize>>>,
}

impl Clock {
    /// The clock of a question.
    ///
    /// # Errors
    /// If the angles are too fine, or there are too many orders in which an uneven engine may fire.
    pub fn new(problem: &Problem) -> Result<Self, ProblemError> {
        let (directions, supply) = problem.supply();
        let dead_centres = problem.dead_centres(directions);
        let fine = fraction::common_denominator(dead_centres.iter().flatten().map(Turn::turns));
        let turn = fine.to_u64().filter(|turn| *turn <= MOST_TICKS).ok_or_else(|| {
            ProblemError::new(
                "neighbours are counted for angles of up to 12 digits; round the bank angle or the pin split",
            )
        })?;
        let tick = |angle: &Turn| (angle.turns() * BigInt::from(turn)).to_integer().to_u64().unwrap_or(0);
        let ticks: Vec<Vec<u64>> = dead_centres.iter().map(|bank| bank.iter().map(tick).collect()).collect();
        let steps = dead_centres.iter().map(|bank| bank.iter().map(|angle| firing::steps(angle, problem)).collect());
        let revolutions = if problem.cycle == Cycle::FourStroke { 2 } else { 1 };
        let throws = problem.throws() as usize;
        let supply = supply.map(|supply| supply as usize);
        let clock = Clock { throws, supply, turn, revolutions, ticks, steps: steps.collect() };
        if !clock.is_even() && revolutions == 2 && problem.cylinders > MOST_CHOOSING {
            return Err(ProblemError::new(format!(
                "in {} cylinders that fire unevenly too many orders are possible; neighbours are counted for up to {MOST_CHOOSING}",
                problem.cylinders
            )));
        }
        Ok(clock)
    }

    /// Whether every star fires evenly: all have the same directions, each so often, but for those of a grid.
    pub fn is_even(&self) -> bool {
        self.supply.is_some_and(|supply| {
            let directions = 0..self.throws.checked_div(supply).unwrap_or(0) as u16;
            let throws: Vec<u16> = directions.flat_map(|direction| std::iter::repeat_n(direction, supply)).collect();
            self.even_steps(&throws).is_some()
        })
    }

    /// The least number of neighbours that fire in succession, over the most even firing orders of a star.
    pub fn neighbours(&self, throws: &[u16]) -> usize {
        match self.even_steps(throws) {
            Some(steps) => firing::best_order(&steps, self.throws).1,
            None => self.uneven(throws),
        }
    }

    /// For each cylinder when it may fire; none where the star cannot fire evenly.
    pub fn even_steps(&self, throws: &[u16]) -> Option<Vec<&[usize]>> {
        let banks = self.steps.iter();
        let lists: Vec<&[usize]> =
            banks.flat_map(|bank| throws.iter().map(|&throw| bank[usize::from(throw)].as_slice())).collect();
        firing::are_even(&lists).then_some(lists)
    }

    /// Of all choices of the revolution those with the least sum of squared intervals count, and of them the fewest neighbours.
    fn uneven(&self, throws: &[u16]) -> usize {
        let angles: Vec<u64> =
            self.ticks.iter().flat_map(|bank| throws.iter().map(|&throw| bank[usize::from(throw)])).collect();
        // Cylinder 1 fires in the first revolution: a revolution more for all is the same order.
        let choices = if self.revolutions == 1 { 1_u64 } else { 1 << (angles.len() - 1) };
        let mut best = (u128::MAX, usize::MAX);
        for choice in 0..choices {
            let late = |cylinder: usize| cylinder > 0 && choice >> (cylinder - 1) & 1 == 1;
            let instant = |(cylinder, angle): (usize, &u64)| angle + if late(cylinder) { self.turn } else { 0 };
            let instants: Vec<u64> = angles.iter().enumerate().map(instant).collect();
            let mut sorted = instants.clone();
            sorted.sort_unstable();
            let squares = self.squared_intervals(&sorted);
            if squares <= best.0 {
                let count = in_succession(&instants, sorted, self.throws);
                best = if squares < best.0 { (squares, count) } else { (squares, best.1.min(count)) };
            }
        }
        best.1
    }

    fn squared_intervals(&self, sorted: &[u64]) -> u128 {
        let square = |interval: u64| u128::from(interval) * u128::from(interval);
        let between: u128 = sorted.windows(2).map(|pair| square(pair[1] - pair[0])).sum();
        let last =
            sorted.first().zip(sorted.last()).map_or(0, |(first, last)| first + self.turn * self.revolutions - last);
        between + square(last)
    }
}

/// Pairs of neighbours in a bank whose instants are one, or follow each other around the cycle.
fn in_succession(instants: &[u64], mut distinct: Vec<u64>, throws: usize) -> usize {
    distinct.dedup();
    let place = |instant: u64| distinct.binary_search(&instant).unwrap_or(0);
    let follow = |pair: &&[u64]| {
        let apart = place(pair[0]).abs_diff(place(pair[1]));
        apart <= 1 || apart == distinct.len() - 1
    };
    instants.chunks(throws).flat_map(|bank| bank.windows(2)).filter(follow).count()
}
