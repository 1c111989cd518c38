//! What does a search answer? The front with its counts, the part of it that keeps limits, or every value there is.

use num_bigint::BigUint;

use super::found::{self, FoundStar, Moment, Standing};
use super::front::{Census, StarValues};
use super::limit::{Limit, Limits};
use super::problem::{Problem, ProblemError};
use super::sizes::Sizes;
use super::space::Space;
use super::tables::Tables;
use super::walk::Counts;
use super::{judged, piece, symmetry};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;
use crate::stars::By;

/// The answer: no other star is as good in everything and better in something.
#[derive(Clone, Debug)]
pub struct Front {
    /// The question.
    pub problem: Problem,
    /// One star for each combination of values, by the first order, then the next.
    pub stars: Vec<FoundStar>,
    /// Stars with cylinder 1 at 0 that there are.
    pub all: BigUint,
    /// How many of them have balanced first-order force, where only these are compared: on a grid.
    pub balanced: Option<u64>,
    /// Stars judged one by one, up to rotation, mirror and reversal.
    pub judged: u64,
    /// Starts omitted with all their completions.
    pub cut: u64,
    /// The limits that its stars keep, and the sizes of their moments.
    pub limits: Limits,
    /// How its one star was made, where a theorem gave it and nothing was searched.
    pub described: Option<By>,
    pub(super) points: Vec<StarValues>,
}

impl Front {
    /// Stars with cylinder 1 at 0 that are compared.
    pub fn compared(&self) -> BigUint {
        self.balanced.map_or_else(|| self.all.clone(), BigUint::from)
    }

    /// How a star stands to this front: throws as whole multiples of `1 / directions` turn, the first 0.
    ///
    /// # Errors
    /// If this is no star of the question.
    pub fn standing(&self, throws: &[u16]) -> Result<Standing, ProblemError> {
        Ok(found::standing(&self.points, &self.judge(throws)?))
    }

    /// What is known of a star of the question, with the first of its firing orders where these are compared.
    ///
    /// # Errors
    /// If this is no star of the question.
    pub fn known(&self, throws: &[u16]) -> Result<FoundStar, ProblemError> {
        let points = self.judge(throws)?;
        let first = points.first().ok_or_else(|| ProblemError::new("this star does not fire evenly"))?;
        Ok(FoundStar::new(&self.problem, first))
    }

    /// Whether equal stars are counted up to rotation, mirror and reversal; else the mirror image or the reversal of a star has other values.
    pub fn counts_whole_classes(&self) -> bool {
        Space::of_any_size(&self.problem).is_ok_and(|space| space.keeps == symmetry::EVERY_IMAGE)
    }

    /// The stars that keep these limits, with what turns moments into newton-metres. What beats a star that keeps them keeps them too, so
    /// these are the best of all that do.
    ///
    /// # Errors
    /// Limits of orders that are not compared; newton-metres without sizes.
    pub fn limited(mut self, limits: Vec<Limit>, sizes: Option<Sizes>) -> Result<Front, ProblemError> {
        if self.problem.bank_angle.is_some() && !(limits.is_empty() && sizes.is_none()) {
            return Err(ProblemError::new("limits and newton-metres are for engines in line"));
        }
        for limit in &limits {
            if !self.problem.orders.contains(&limit.order) {
                return Err(ProblemError::new(format!(
                    "a limit of order {}, which is not compared; give it with --orders",
                    limit.order
                )));
            }
            if limit.in_newton_metres && sizes.is_none() {
                return Err(ProblemError::new(
                    "a limit in newton-metres needs --sizes LAYOUT: masses, rod, spacing, speed",
                ));
            }
        }
        let of = self.stars.len();
        let keeps = |moment: &Moment| {
            let mut own = limits.iter().filter(|limit| limit.order == moment.order);
            own.all(|limit| is_within(moment, limit, sizes.as_ref()))
        };
        let kept: Vec<bool> = self.stars.iter().map(|star| star.moments.iter().all(keeps)).collect();
        let mut of_stars = kept.iter();
        self.stars.retain(|_| of_stars.next() == Some(&true));
        if self.points.len() == kept.len() {
            let mut of_points = kept.iter();
            self.points.retain(|_| of_points.next() == Some(&true));
        }
        self.limits = Limits { limits, sizes, of };
        Ok(self)
    }

    fn judge(&self, throws: &[u16]) -> Result<Vec<StarValues>, ProblemError> {
        let space = Space::of_any_size(&self.problem)?;
        match space.holds(throws) {
            true => Ok(judged::judge(&space, &Tables::new(&space), throws)),
            false => Err(ProblemError::new("these throws are not a star of this problem")),
        }
    }
}

/// Whether a moment is no longer than a limit: exactly in multiples, in decimals in newton-metres.
fn is_within(moment: &Moment, limit: &Limit, sizes: Option<&Sizes>) -> bool {
    if let Some(sizes) = sizes.filter(|_| limit.in_newton_metres) {
        let size = if moment.sum.vanishes() { 0.0 } else { moment.decimal * sizes.newton_metres(moment.order) };
        return size <= numbers::float(&limit.most);
    }
    let square = Term { angle: Turn::zero(), weight: &limit.most * &limit.most };
    let excess = moment.sum.times(&moment.sum.conjugate()).minus(&PhasorSum::new(vec![square]));
    excess.vanishes() || numbers::evaluate(&excess).re < 0.0
}

/// Every combination of values there is, by looking at every star; ranked as a front is.
///
/// # Errors
/// If the question makes no sense.
pub fn every_value(problem: &Problem) -> Result<Front, ProblemError> {
    let space = Space::new(problem)?;
    let tables = Tables::with_bounds(&space);
    let (mut census, mut counts) = (Census::default(), Counts::default());
    for piece in piece::pieces(&space, &tables) {
        let (next, of_piece) = piece::run(&space, &tables, &piece, census);
        census = next;
        counts = counts.plus(of_piece).unwrap_or_else(|| unreachable!("this many stars exist"));
    }
    Ok(answer(problem, &space, census.points, counts))
}

pub(super) fn answer(problem: &Problem, space: &Space, mut points: Vec<StarValues>, counts: Counts) -> Front {
    points.sort_by(StarValues::rank);
    let stars = points.iter().map(|point| FoundStar::new(problem, point)).collect();
    let (all, balanced) = (space.count(), space.count_of_balanced());
    let Counts { judged, cut } = counts;
    let (problem, limits) = (problem.clone(), Limits::default());
    Front { problem, stars, all, balanced, judged, cut, limits, described: None, points }
}
