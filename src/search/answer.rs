//! What does a search answer? The front with its counts, or every value there is.

use std::cmp::Ordering;

use num_bigint::BigUint;

use super::found::{self, FoundStar, Standing};
use super::front::{Census, StarValues};
use super::judged;
use super::limit::Limits;
use super::piece::{self, Counts};
use super::problem::{Problem, ProblemError};
use super::space::Space;
use super::symmetry;
use super::tables::Tables;
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

    /// The stars of the front that beat a star, in all of its firing orders where these are compared.
    ///
    /// # Errors
    /// If this is no star of the question.
    pub fn beating(&self, throws: &[u16]) -> Result<Vec<&FoundStar>, ProblemError> {
        let points = self.judge(throws)?;
        let beats = |best: &&(&StarValues, &FoundStar)| {
            points.iter().all(|point| best.0.compare(point) == Some(Ordering::Less))
        };
        let pairs: Vec<(&StarValues, &FoundStar)> = self.points.iter().zip(&self.stars).collect();
        Ok(pairs.iter().filter(beats).map(|(_, star)| *star).collect())
    }

    /// Whether equal stars are counted up to rotation, mirror and reversal; else the mirror image or the reversal of a star has other values.
    pub fn counts_whole_classes(&self) -> bool {
        Space::of_any_size(&self.problem).is_ok_and(|space| space.keeps == symmetry::EVERY_IMAGE)
    }

    fn judge(&self, throws: &[u16]) -> Result<Vec<StarValues>, ProblemError> {
        let space = Space::of_any_size(&self.problem)?;
        match space.holds(throws) {
            true => Ok(judged::judge(&space, &Tables::new(&space), throws)),
            false => Err(ProblemError::new("these throws are not a star of this problem")),
        }
    }
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
        counts.judged += of_piece.judged;
        counts.cut += of_piece.cut;
    }
    Ok(answer(problem, &space, census.points, counts))
}

pub(super) fn answer(problem: &Problem, space: &Space, mut points: Vec<StarValues>, counts: Counts) -> Front {
    points.sort_by(StarValues::rank);
    let stars = points.iter().map(|point| FoundStar::new(problem, point)).collect();
    let (all, judged, cut) = (space.count(), counts.judged, counts.cut);
    Front { problem: problem.clone(), stars, all, judged, cut, limits: Limits::default(), described: None, points }
}
