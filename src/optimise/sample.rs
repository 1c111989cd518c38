//! Which crank angles are enough? Samples are added where a solution peaks higher, until none does.

use std::f64::consts::TAU;

use super::error::OptimiseError;
use super::problem::Problem;
use super::solve::{Goal, Sample, Solution, solve};
use crate::loads::Circle;

/// Crank angles of a bearing that every solution starts with.
const FIRST: usize = 12;
/// Crank angles at which a solution is searched for peaks.
const STEPS: usize = 720;
/// A peak that is higher than those of the samples by less than this part is not higher.
const AGREES: f64 = 1e-6;
/// More rounds than this were never needed: the peaks move by the square of what is left.
const MOST_ROUNDS: usize = 40;

/// The samples of a problem, which all of its solutions share.
pub(super) struct Samples(Vec<Sample>);

impl Samples {
    pub fn new(problem: &Problem) -> Self {
        let of_bearing = |bearing: usize| {
            (0..FIRST).map(move |step| Sample::new(problem, bearing, TAU * step as f64 / FIRST as f64))
        };
        Samples((0..problem.waveforms.len()).flat_map(of_bearing).collect())
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
            let circle = Circle::new(STEPS);
            for bearing in 0..problem.waveforms.len() {
                let waveform = problem.waveform(bearing, &solution.weights);
                let sizes: Vec<f64> = waveform.sample(&circle).iter().map(|force| force.norm()).collect();
                let is_top = |&step: &usize| {
                    let (last, next) = (sizes[(step + STEPS - 1) % STEPS], sizes[(step + 1) % STEPS]);
                    sizes[step] > limit && sizes[step] >= last && sizes[step] >= next
                };
                let tops = (0..STEPS).filter(is_top).map(|step| TAU * step as f64 / STEPS as f64);
                let peak = waveform.peak();
                let highest = peak.angle.filter(|_| peak.value > limit).map(f64::to_radians);
                self.0.extend(tops.chain(highest).map(|theta| Sample::new(problem, bearing, theta)));
            }
            if self.0.len() == before {
                return Ok(solution);
            }
            solution = solve(problem, &self.0, goal)?;
        }
        Err(OptimiseError::Unsolved(format!("the peaks still move after {MOST_ROUNDS} rounds")))
    }
}
