//! In which firing order does a crank star twist its shaft least? The minor orders of each in a mode of torsional vibration, compared exactly.
//!
//! Two cylinders of an even four-stroke engine share a direction and may change places in the firing order: with n cylinders in line
//! there are `2^(n/2 − 1)` orders, where n is even, and one where it is odd or the engine a two-stroke.

use std::cmp::Reverse;

use num_rational::BigRational;

use super::answer::Front;
use super::firing::orders_of;
use super::found::FoundStar;
use super::mode_shape::{mode_shape, sum};
use super::problem::{Problem, ProblemError};
use super::{firing, found};
use crate::engine::CycleOrder;
use crate::exact::PhasorSum;
use crate::firing::by_length;
use crate::numbers;

/// The firing orders of this many stars of a front are evaluated, the first ones.
pub const MOST_TORSION_STARS: usize = 12;

/// The firing orders of the stars of a front, judged in a mode of torsional vibration.
#[derive(Clone, Debug)]
pub struct Torsion {
    /// The deflections of the throws, from the free end.
    pub shape: Vec<BigRational>,
    /// The minor orders up to the middle of a period, above which the stars are mirror images.
    pub orders: Vec<CycleOrder>,
    /// After which order the stars repeat: the first major one.
    pub repeats_after: CycleOrder,
    /// One for each of the first stars of the front.
    pub stars: Vec<StarTorsion>,
}

/// The firing orders of one star.
#[derive(Clone, Debug)]
pub struct StarTorsion {
    /// How many there are; 0 where it does not fire evenly.
    pub all: usize,
    /// Those to which no other is as good in every minor order and better in one; that with the weakest strongest order first.
    pub best: Vec<RankedOrder>,
}

/// A firing order with its phase-vector sums.
#[derive(Clone, Debug)]
pub struct RankedOrder {
    /// Cylinders, counted from 0, in the order in which they fire.
    pub firing_order: Vec<usize>,
    /// The sum `Σ Δ_j e^{−iκφ_j}` of each minor order.
    pub sums: Vec<PhasorSum>,
    /// Which of the minor orders are the strongest, by their places.
    pub strongest: Vec<usize>,
    /// How many firing orders of the star have sums of the same lengths.
    pub equal: usize,
}

impl RankedOrder {
    /// `1-3-4-2`.
    pub fn name(&self) -> String {
        found::dashed(&self.firing_order)
    }
}

/// Judges the firing orders of the first stars of a front in a mode of [`mode_shape`].
///
/// # Errors
/// As [`mode_shape`].
pub fn torsion(front: &Front, shape: Option<Vec<BigRational>>) -> Result<Torsion, ProblemError> {
    let problem = &front.problem;
    let shape = mode_shape(problem, shape)?;
    let cylinders = problem.cylinders;
    let step = problem.cycle.lowest_order().halves();
    let order = |index: u32| CycleOrder::of_halves(index * step);
    let orders: Vec<CycleOrder> = (1..=cylinders / 2).filter_map(order).collect();
    let stars = front.stars.iter().take(MOST_TORSION_STARS);
    Ok(Torsion {
        stars: stars.map(|star| judged(problem, star, &shape, &orders)).collect(),
        repeats_after: order(cylinders).unwrap_or_else(|| problem.cycle.lowest_order()),
        shape,
        orders,
    })
}

fn judged(problem: &Problem, star: &FoundStar, shape: &[BigRational], orders: &[CycleOrder]) -> StarTorsion {
    let all = firing_orders(problem, star);
    let sums: Vec<Vec<PhasorSum>> = all
        .iter()
        .map(|firing_order| orders.iter().map(|order| sum(firing_order, problem.cycle, shape, *order)).collect())
        .collect();
    let lengths = ranks(&sums);
    // From the strongest minor order down.
    let key = |place: &usize| {
        let mut falling: Vec<Reverse<usize>> = lengths[*place].iter().copied().map(Reverse).collect();
        falling.sort_unstable();
        falling.into_iter().map(|Reverse(length)| length).collect::<Vec<_>>()
    };
    let beats = |one: &[usize], other: &[usize]| one != other && one.iter().zip(other).all(|(one, other)| one <= other);
    let is_first = |place: &usize| !lengths[..*place].contains(&lengths[*place]);
    let is_best = |place: &usize| !lengths.iter().any(|other| beats(other, &lengths[*place]));
    let mut best: Vec<usize> = (0..all.len()).filter(is_first).filter(is_best).collect();
    best.sort_by_key(key);
    let ranked = |place: usize| {
        let strongest = lengths[place].iter().max();
        let is_strongest = |at: &usize| Some(&lengths[place][*at]) == strongest;
        RankedOrder {
            firing_order: all[place].clone(),
            sums: sums[place].clone(),
            strongest: (0..orders.len()).filter(is_strongest).collect(),
            equal: lengths.iter().filter(|other| **other == lengths[place]).count(),
        }
    };
    StarTorsion { all: all.len(), best: best.into_iter().map(ranked).collect() }
}

/// All firing orders of a star, cylinder 1 first; none where it does not fire evenly.
fn firing_orders(problem: &Problem, star: &FoundStar) -> Vec<Vec<usize>> {
    let Some(steps) = firing::even_steps(&problem.dead_centres_of(&star.throws), problem) else { return Vec::new() };
    orders_of(&steps.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

/// The place of each sum among all lengths, equal ones alike. Decimals only make the exact comparisons few.
fn ranks(sums: &[Vec<PhasorSum>]) -> Vec<Vec<usize>> {
    let mut ranks: Vec<Vec<usize>> = sums.iter().map(|of_one| vec![0; of_one.len()]).collect();
    let places = sums.iter().enumerate().flat_map(|(row, of_one)| (0..of_one.len()).map(move |column| (row, column)));
    let measured = |(row, column): (usize, usize)| (numbers::evaluate(&sums[row][column]).norm(), row, column);
    let mut all: Vec<(f64, usize, usize)> = places.map(measured).collect();
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    all.sort_by(|one, other| by_length(&sums[one.1][one.2], &sums[other.1][other.2]));
    let mut rank = 0;
    for (place, (_, row, column)) in all.iter().enumerate() {
        if let Some((_, before_row, before_column)) = place.checked_sub(1).map(|before| all[before]) {
            let is_equal = by_length(&sums[before_row][before_column], &sums[*row][*column]).is_eq();
            rank += usize::from(!is_equal);
        }
        ranks[*row][*column] = rank;
    }
    ranks
}
