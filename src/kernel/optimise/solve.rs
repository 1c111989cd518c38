//! What are the best mass-radii for sampled crank angles? A second-order cone program, solved by an interior-point method.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use num_complex::Complex;

use super::error::OptimiseError;
use super::problem::Problem;

/// What is to be least.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Least {
    /// The largest bearing load.
    Peak,
    /// The mass of the counterweights.
    Mass,
    /// The sum of the squares of the mass-radii, which one solution alone has.
    Squares,
}

/// What is asked for, with what the other quantities may be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    pub least: Least,
    /// Mass of the crankshaft in kilograms.
    pub mass: Option<f64>,
    /// Largest bearing load in multiples of m r ω².
    pub peak: Option<f64>,
}

/// A crank angle of a bearing, and what it feels there without counterweights, seen from the turning crank.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub bearing: usize,
    pub load: Complex<f64>,
}

impl Sample {
    pub fn new(problem: &Problem, bearing: usize, theta: f64) -> Self {
        Sample { bearing, load: problem.felt.at(bearing, theta) }
    }
}

/// A solution with its multipliers.
pub(super) struct Solution {
    /// Mass-radii in multiples of m r.
    pub weights: Vec<Complex<f64>>,
    /// Mass of the crankshaft in kilograms.
    pub mass: f64,
    /// Largest load at the samples.
    pub peak: f64,
    /// Multiplier of each sample.
    pub of_samples: Vec<Complex<f64>>,
    /// Multipliers of force and couple of each crankshaft.
    pub of_balance: Vec<[Complex<f64>; 2]>,
}

/// `A x + s = b`, row by row, with s in a product of cones.
#[derive(Default)]
struct Rows {
    entries: (Vec<usize>, Vec<usize>, Vec<f64>),
    right: Vec<f64>,
    cones: Vec<SupportedConeT<f64>>,
}

impl Rows {
    /// `s = constant + Σ factor · x`, one entry of the next cone.
    fn push(&mut self, constant: f64, factors: impl IntoIterator<Item = (usize, f64)>) {
        let row = self.right.len();
        for (column, factor) in factors {
            self.entries.0.push(row);
            self.entries.1.push(column);
            self.entries.2.push(-factor);
        }
        self.right.push(constant);
    }
}

/// Solves the problem for these samples.
pub(super) fn solve(problem: &Problem, samples: &[Sample], goal: Goal) -> Result<Solution, OptimiseError> {
    let places = problem.places();
    // Columns: real and imaginary parts of the mass-radii, their lengths, and the largest load.
    let (re, im, length, peak) = (|i: usize| 2 * i, |i: usize| 2 * i + 1, |i: usize| 2 * places + i, 3 * places);
    let mut rows = Rows::default();
    // Force and couple of each crankshaft, with the row where the multiplier of each begins.
    let balance = |rows: &mut Rows, shaft: usize, quantity: usize| {
        let left = problem.shafts[shaft].left[quantity];
        let arm = |i: usize| if quantity == 0 { 1.0 } else { problem.arms[i] };
        let first = rows.right.len();
        rows.push(left.re, problem.places_on(shaft).map(|i| (re(i), arm(i))));
        rows.push(left.im, problem.places_on(shaft).map(|i| (im(i), arm(i))));
        first
    };
    let shafts = 0..problem.shafts.len();
    let forces: Vec<usize> = shafts.clone().map(|shaft| balance(&mut rows, shaft, 0)).collect();
    let most_couples = problem.most_couple.map(|most| problem.of_shafts(most));
    let mut couples: Vec<usize> = match most_couples {
        None => shafts.clone().map(|shaft| balance(&mut rows, shaft, 1)).collect(),
        Some(_) => Vec::new(),
    };
    rows.cones.push(SupportedConeT::ZeroConeT(rows.right.len()));
    for (shaft, most) in most_couples.into_iter().flatten().enumerate() {
        rows.push(most, []);
        couples.push(balance(&mut rows, shaft, 1));
        rows.cones.push(SupportedConeT::SecondOrderConeT(3));
    }
    let mut bounds = 0;
    if let Some(mass) = goal.mass {
        rows.push(mass - problem.bare_mass, problem.weighs.iter().enumerate().map(|(i, kg)| (length(i), -kg)));
        bounds += 1;
    }
    if let Some(most) = goal.peak {
        rows.push(most, [(peak, -1.0)]);
        bounds += 1;
    }
    rows.push(0.0, [(peak, 1.0)]);
    rows.cones.push(SupportedConeT::NonnegativeConeT(bounds + 1));
    for i in 0..places {
        rows.push(0.0, [(length(i), 1.0)]);
        rows.push(0.0, [(re(i), 1.0)]);
        rows.push(0.0, [(im(i), 1.0)]);
        rows.cones.push(SupportedConeT::SecondOrderConeT(3));
    }
    let first_sample = rows.right.len();
    for sample in samples {
        let parts = || problem.parts[sample.bearing].iter().enumerate();
        rows.push(0.0, [(peak, 1.0)]);
        rows.push(sample.load.re, parts().map(|(i, part)| (re(i), *part)));
        rows.push(sample.load.im, parts().map(|(i, part)| (im(i), *part)));
        rows.cones.push(SupportedConeT::SecondOrderConeT(3));
    }
    let columns = 3 * places + 1;
    let (mut linear, mut squares) = (vec![0.0; columns], Vec::new());
    match goal.least {
        Least::Peak => linear[peak] = 1.0,
        Least::Mass => (0..places).for_each(|i| linear[length(i)] = problem.weighs[i]),
        Least::Squares => squares = (0..2 * places).collect(),
    }
    let ones = vec![1.0; squares.len()];
    let quadratic = CscMatrix::new_from_triplets(columns, columns, squares.clone(), squares, ones);
    let (row, column, value) = rows.entries;
    let matrix = CscMatrix::new_from_triplets(rows.right.len(), columns, row, column, value);
    let fail = |reason: String| OptimiseError::Unsolved(reason);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_threads(1)
        .tol_gap_abs(1e-10)
        .tol_gap_rel(1e-10)
        .tol_feas(1e-10)
        .build()
        .map_err(|error| fail(error.to_string()))?;
    let mut solver = DefaultSolver::new(&quadratic, &linear, &matrix, &rows.right, &rows.cones, settings)
        .map_err(|error| fail(error.to_string()))?;
    solver.solve();
    match solver.solution.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved => {}
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
            return Err(fail("no counterweights in these planes leave so little".to_owned()));
        }
        other => return Err(fail(format!("{other:?}"))),
    }
    let (x, z) = (&solver.solution.x, &solver.solution.z);
    let pair = |row: usize| Complex::new(z[row], z[row + 1]);
    let of_sample = |index: usize| -pair(first_sample + 3 * index + 1);
    Ok(Solution {
        weights: (0..places).map(|i| Complex::new(x[re(i)], x[im(i)])).collect(),
        mass: problem.bare_mass + (0..places).map(|i| problem.weighs[i] * x[length(i)]).sum::<f64>(),
        peak: x[peak],
        of_samples: (0..samples.len()).map(of_sample).collect(),
        of_balance: forces.iter().zip(&couples).map(|(force, couple)| [-pair(*force), -pair(*couple)]).collect(),
    })
}
