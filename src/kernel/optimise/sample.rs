//! Which crank angles are enough? Samples are added where a solution peaks higher, until none does.

use std::f64::consts::TAU;

use super::error::OptimiseError;
use super::problem::Problem;
use super::solve::{Goal, Sample, Solution, solve};

/// Crank angles of a bearing in a revolution that every solution starts with.
const FIRST: usize = 12;
/// A peak that is higher than those of the samples by less than this part is not higher.
const AGREES: f64 = 1e-6;
/// More rounds than this were never needed: the peaks move by the square of what is left.
const MOST_ROUNDS: usize = 40;

/// The samples of a problem, which all of its solutions share.
pub(super) struct Samples(Vec<Sample>);

impl Samples {
    pub fn new(problem: &Problem) -> Self {
        let of_bearing = |bearing: usize| {
            let count = FIRST * problem.felt.revolutions();
            (0..count).map(move |step| Sample::new(problem, bearing, TAU * step as f64 / FIRST as f64))
        };
        Samples((0..problem.felt.bearings()).flat_map(of_bearing).collect())
    }

    pub fn all(&self) -> &[Sample] {
        &self.0
    }

    /// Solves for a goal, with more samples until the true peak is that of the samples.
    pub fn solve(&mut self, problem: &Problem, goal: Goal) -> Result<Solution, OptimiseError> {
        let mut solution = solve(problem, &self.0, goal)?;
        for _ in 0..MOST_ROUNDS {
            let limit = goal.peak.unwrap_or(0.0).max(solution.peak) * (1.0 + AGREES);
            let before = self.0.len();
            for bearing in 0..problem.felt.bearings() {
                let tops = problem.felt.tops(bearing, problem.added(bearing, &solution.weights), limit);
                self.0.extend(tops.into_iter().map(|theta| Sample::new(problem, bearing, theta)));
            }
            if self.0.len() == before {
                return Ok(solution);
            }
            solution = solve(problem, &self.0, goal)?;
        }
        Err(OptimiseError::Unsolved(format!("the peaks still move after {MOST_ROUNDS} rounds")))
    }
}
