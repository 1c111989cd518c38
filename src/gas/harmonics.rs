//! What are the harmonics of force, side force and torque, and how sure are they?
//!
//! Each smooth piece is integrated by itself, in parts that are halved until nothing changes: the last change is the stated error.
//! What is cut off is bounded by integrating by parts twice: `|t_κ| ≤ 2 Var(T')/(Ψ κ²)`, Var the total variation over a cycle,
//! jumps at the kinks with it.

use num_complex::Complex;

use super::cylinder::CylinderGas;
use super::quadrature::points;

/// The harmonics of one cylinder, by its own cycle angle: a mean, and `Re Σ h_n e^{inψ/R}`, R the revolutions of a cycle.
#[derive(Clone, Debug)]
pub struct Harmonics {
    /// Revolutions of a cycle: the order of the n-th harmonic is n/R.
    pub revolutions: u32,
    /// f: the force on the piston, in newtons, the mean first.
    pub force: Vec<Complex<f64>>,
    /// h: the side force `F_g tan β`, in newtons.
    pub side: Vec<Complex<f64>>,
    /// t: the torque, in newton-metres.
    pub torque: Vec<Complex<f64>>,
    /// How much the last refinement changed of each of the three: their stated error.
    pub errors: [f64; 3],
    /// Total variation of `dT/dψ` over a cycle, in newton-metres a radian.
    pub variation: f64,
}

/// A part of a piece is at most so wide, in radians.
const WIDEST: f64 = 0.2;
/// The phase of the highest harmonic turns at most so much in a part.
const MOST_PHASE: f64 = 3.0;
/// Changes below this part of the largest harmonic are roundings.
const ROUNDING: f64 = 2e-15;
/// Parts are halved at most so often.
const HALVINGS: u32 = 5;
/// Steps of a smooth piece between which its slope is followed.
const STEPS: usize = 64;

type Sums = [Vec<Complex<f64>>; 3];

impl Harmonics {
    /// Those of a cylinder, up to this one.
    pub(super) fn new(gas: &CylinderGas, highest: usize) -> Self {
        let mut sums = sums(gas, highest, 0);
        let mut errors = [f64::INFINITY; 3];
        for halvings in 1..=HALVINGS {
            let finer = self::sums(gas, highest, halvings);
            errors = [0, 1, 2].map(|place| largest_change(&sums[place], &finer[place]));
            sums = finer;
            let largest = sums.each_ref().map(|all| all.iter().map(|one| one.norm()).fold(0.0, f64::max));
            if errors.iter().zip(largest).all(|(error, largest)| *error <= ROUNDING * largest * 8.0) {
                break;
            }
        }
        let [force, side, torque] = sums;
        Harmonics { revolutions: gas.revolutions(), force, side, torque, errors, variation: variation(gas) }
    }

    /// The order of a harmonic.
    pub fn order(&self, index: usize) -> f64 {
        index as f64 / f64::from(self.revolutions)
    }

    /// No harmonic of the torque from this order on is larger, in newton-metres.
    pub fn bound(&self, order: f64) -> f64 {
        2.0 * self.variation / (self.period() * order * order)
    }

    /// The harmonics of the torque above those that were computed are together at most this.
    pub fn rest(&self) -> f64 {
        // Σ 1/n² over n > N is below 1/N.
        let highest = self.torque.len() - 1;
        let revolutions = f64::from(self.revolutions);
        2.0 * self.variation * revolutions * revolutions / (self.period() * highest.max(1) as f64)
    }

    fn period(&self) -> f64 {
        std::f64::consts::TAU * f64::from(self.revolutions)
    }
}

fn largest_change(one: &[Complex<f64>], other: &[Complex<f64>]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

fn sums(gas: &CylinderGas, highest: usize, halvings: u32) -> Sums {
    let (geometry, law) = (gas.geometry(), gas.law());
    let zero = Complex::new(0.0, 0.0);
    let mut sums = [const { Vec::new() }; 3].map(|_: Vec<Complex<f64>>| vec![zero; highest + 1]);
    let base = 1.0 / f64::from(gas.revolutions());
    for piece in &law.pieces {
        let width = piece.to - piece.from;
        let phase = width * base * highest as f64;
        let count = (width / WIDEST).max(phase / MOST_PHASE).ceil().max(1.0) as usize;
        for edge in piece.edges(count << halvings).windows(2) {
            for (psi, weight) in points(edge[0], edge[1]) {
                let force = (piece.pressure(geometry, psi) - gas.crankcase()) * geometry.area * weight;
                let values = [force, force * geometry.slope(psi), force * geometry.radius * geometry.lever(psi)];
                let step = Complex::cis(-psi * base);
                let mut turning = Complex::new(1.0, 0.0);
                for index in 0..=highest {
                    for (sum, value) in sums.iter_mut().zip(values) {
                        sum[index] += turning * value;
                    }
                    turning *= step;
                }
            }
        }
    }
    let period = law.period;
    for sum in &mut sums {
        for (index, value) in sum.iter_mut().enumerate() {
            *value *= if index == 0 { 1.0 } else { 2.0 } / period;
        }
    }
    sums
}

/// The total variation of `dT/dψ`: within the pieces, and its jumps between them.
fn variation(gas: &CylinderGas) -> f64 {
    let (geometry, law) = (gas.geometry(), gas.law());
    let mut slopes = Vec::new();
    for piece in &law.pieces {
        let steps = ((piece.to - piece.from) / 0.02).ceil().clamp(2.0, STEPS as f64 * 8.0) as usize;
        slopes.extend(piece.edges(steps).into_iter().map(|psi| {
            let force = (piece.pressure(geometry, psi) - gas.crankcase()) * geometry.area;
            let slope = piece.slope(geometry, psi) * geometry.area;
            geometry.radius * (slope * geometry.lever(psi) + force * geometry.lever_slope(psi))
        }));
    }
    let again = slopes.first().copied();
    slopes.iter().zip(slopes.iter().skip(1).copied().chain(again)).map(|(a, b)| (b - a).abs()).sum()
}
