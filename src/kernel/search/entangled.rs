//! What moments has a V whose banks are offset, on a grid? Those of all its cylinders, which are no multiples of those of its pins.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::problem::{Problem, ProblemError};
use super::roots::Roots;
use super::value::Value;
use crate::exact::{Turn, fraction};
use crate::order;
use crate::proof::Sense;

/// More stars than this, up to rotation, are not looked at: none can be omitted unseen.
const MOST_STARS: u128 = 2_000_000;
/// All vectors are at multiples of a turn divided by no more than this.
const FINEST: usize = 20_000;
/// The sum of all arms is below this, in the whole numbers that twice the arms are multiples of.
const LONGEST: i64 = 1 << 20;

/// The vectors of the cylinders in every order and sense.
pub(super) struct Entangled {
    roots: Roots,
    /// For each order and sense, bank and direction: the exponent of the vector.
    exponents: Vec<[Vec<usize>; 2]>,
    /// For each bank the arms of its cylinders along the shaft.
    arms: [Vec<i64>; 2],
}

impl Entangled {
    /// What a question asks for; none where the moments of the pins tell all.
    pub fn new(problem: &Problem) -> Result<Option<Self>, ProblemError> {
        let banks = problem.banks();
        let ([first, second], true) = (banks.as_slice(), problem.is_entangled()) else { return Ok(None) };
        let (directions, _) = problem.supply();
        if u128::from(directions).pow(problem.throws() - 1) > MOST_STARS {
            return Err(ProblemError::new(format!(
                "with a bank offset up to {MOST_STARS} stars of a grid are searched; give fewer cylinders or directions"
            )));
        }
        let both = Sense::BOTH;
        let senses = problem.orders.iter().flat_map(|&order| both.map(|sense| (order, sense)));
        let throw = |direction: u32| Turn::fraction(direction.into(), directions.into());
        let angles: Vec<[Vec<Turn>; 2]> = senses
            .map(|(order, sense)| {
                [first, second].map(|bank| {
                    let of = |d| order::phase_of(&(&throw(d) + &bank.split), &bank.axis, order, Some(sense));
                    (0..directions).map(of).collect()
                })
            })
            .collect();
        let fine = fraction::common_denominator(angles.iter().flatten().flatten().map(Turn::turns));
        let count = fine.to_usize().filter(|count| *count <= FINEST).ok_or_else(|| {
            ProblemError::new(format!(
                "with a bank offset, grid, bank angle and pin split are to be multiples of one angle, a turn divided by up to {FINEST}"
            ))
        })?;
        let exponent = |angle: &Turn| (angle.turns() * BigInt::from(count)).to_integer().to_usize().unwrap_or(0);
        let exponents = angles.iter().map(|pair| pair.each_ref().map(|bank| bank.iter().map(exponent).collect()));
        let exponents = exponents.collect();
        let arms = whole(problem.throws(), [&first.offset, &second.offset]).ok_or_else(|| {
            ProblemError::new("the bank offset is too fine or too long; give a number of up to 4 digits")
        })?;
        Ok(Some(Entangled { roots: Roots::new(count), exponents, arms }))
    }

    /// The squares of the direct and the reverse vector of each order.
    pub fn values(&self, throws: &[u16]) -> impl Iterator<Item = Value> {
        self.exponents.iter().map(move |of_banks| {
            let banks = of_banks.iter().zip(&self.arms);
            let terms = banks.flat_map(|(exponents, arms)| {
                throws.iter().zip(arms).map(|(&throw, &arm)| (exponents[usize::from(throw)], arm))
            });
            self.roots.square(&terms.collect::<Vec<_>>())
        })
    }
}

/// All arms about the middle, as whole numbers in one unit; none where these are too long.
fn whole(throws: u32, offsets: [&BigRational; 2]) -> Option<[Vec<i64>; 2]> {
    let two = BigRational::from_integer(2.into());
    let throws = i64::from(throws);
    let arm =
        |place: i64, offset: &BigRational| BigRational::from_integer((throws - 1 - 2 * place).into()) + offset * &two;
    let scale = fraction::common_denominator(offsets.map(|offset| offset * &two));
    let scaled =
        offsets.map(|offset| (0..throws).map(|place| (arm(place, offset) * &scale).to_integer()).collect::<Vec<_>>());
    let total: BigInt = scaled.iter().flatten().map(BigInt::abs).sum();
    (total < BigInt::from(LONGEST)).then(|| scaled.map(|bank| bank.iter().filter_map(BigInt::to_i64).collect()))
}
