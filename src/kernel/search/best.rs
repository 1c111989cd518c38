//! Which in-line stars are the best of their number of cylinders? The front of orders 1 and 2, ties broken by order 4.

use num_bigint::BigUint;

use super::answer::Front;
use super::found::FoundStar;
use super::options::{Options, SearchError};
use super::pieces::search;
use super::problem::Problem;
use crate::engine::Cycle;

/// The best in-line stars of a number of cylinders.
#[derive(Clone, Debug)]
pub struct Best {
    /// The question that the stars answer.
    pub problem: Problem,
    /// Stars with cylinder 1 at 0 that there are.
    pub all: BigUint,
    /// The front of orders 1 and 2.
    pub stars: Vec<FoundStar>,
    /// Where several classes of stars leave neither moment: how many; the star given has the least moment of order 4 of them.
    pub tied: Option<u64>,
}

/// Searches the in-line stars of this many cylinders that fire evenly.
///
/// Where just one point (0, 0) is on the front and several classes share it, the one with the least M_4 is given. It is
/// found on the front of orders 1, 2 and 4: there a star without M_1 and M_2 is beaten only by another of these with less
/// M_4, so that one point of the front has (0, 0), and that has the least.
///
/// # Errors
/// If there are no such stars, or the search is stopped.
pub fn best_in_line(cylinders: u32, cycle: Cycle, options: &Options) -> Result<Best, SearchError> {
    let problem = Problem::inline(cylinders, cycle, &[1, 2]);
    let front = search(&problem, options)?;
    let Front { all, stars, .. } = front;
    let tied = match stars.as_slice() {
        [only] if leaves_nothing(only) && only.classes.is_some_and(|classes| classes > 1) => only.classes,
        _ => return Ok(Best { problem, all, stars, tied: None }),
    };
    let problem = Problem::inline(cylinders, cycle, &[1, 2, 4]);
    let front = search(&problem, options)?;
    let stars = front.stars.into_iter().filter(leaves_nothing).collect();
    Ok(Best { problem, all, stars, tied })
}

/// Whether the moments of orders 1 and 2 are zero.
fn leaves_nothing(star: &FoundStar) -> bool {
    star.moments.iter().filter(|moment| moment.order <= 2).all(|moment| moment.sum.vanishes())
}
