//! What are the harmonics of force, side force and torque, and how sure are they?
//!
//! Each smooth piece is integrated by itself, in parts that are halved until nothing changes: the last change, and what the sum can have been
//! rounded by, is the stated error. What is below it is 0: it has no sign, and nothing is a multiple of it.
//! What is cut off is bounded by integrating by parts twice: `|t_κ| ≤ 2 Var(T')/(Ψ κ²)`, Var the total variation over a cycle,
//! jumps at the kinks with it.

use num_complex::Complex;

use super::cylinder::{CylinderGas, Side};
use super::quadrature::points;
use crate::engine::CycleOrder;

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
    /// How much the last refinement changed of each of the three, and what they are rounded by at most: their stated error.
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

/// Each term of a sum is rounded this many times at most: in pressure, lever, weight and turning.
const ROUNDINGS: f64 = 64.0;

/// The sums of the three, with what they are rounded by at most.
struct Sums {
    harmonics: [Vec<Complex<f64>>; 3],
    roundings: [f64; 3],
}

impl CylinderGas {
    /// The harmonics up to the n-th of the cycle.
    pub fn harmonics(&self, highest: usize) -> Harmonics {
        Harmonics::new(self, highest)
    }
}

impl Harmonics {
    /// Those of a cylinder, up to this one.
    fn new(gas: &CylinderGas, highest: usize) -> Self {
        let mut sums = sums(gas, highest, 0);
        let mut changes = [f64::INFINITY; 3];
        for halvings in 1..=HALVINGS {
            let finer = self::sums(gas, highest, halvings);
            changes = [0, 1, 2].map(|place| largest_change(&sums.harmonics[place], &finer.harmonics[place]));
            sums = finer;
            let largest = sums.harmonics.each_ref().map(|all| all.iter().map(|one| one.norm()).fold(0.0, f64::max));
            if changes.iter().zip(largest).all(|(change, largest)| *change <= ROUNDING * largest * 8.0) {
                break;
            }
        }
        let errors = [0, 1, 2].map(|place| changes[place] + sums.roundings[place]);
        for (all, error) in sums.harmonics.iter_mut().zip(errors) {
            all.iter_mut().filter(|one| one.norm() <= error).for_each(|one| *one = Complex::default());
        }
        let [force, side, torque] = sums.harmonics;
        Harmonics { revolutions: gas.revolutions(), force, side, torque, errors, variation: variation(gas) }
    }

    /// An order of the torque; zero where there is none, and above those that were computed.
    pub fn torque_at(&self, order: CycleOrder) -> Complex<f64> {
        let index = order.halves() * self.revolutions / 2;
        let exists = index * 2 == order.halves() * self.revolutions;
        self.torque.get(index as usize).copied().filter(|_| exists).unwrap_or_default()
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
    let geometry = gas.geometry();
    let zero = Complex::new(0.0, 0.0);
    let mut sums = [const { Vec::new() }; 3].map(|_: Vec<Complex<f64>>| vec![zero; highest + 1]);
    // Each part has sums of its own, which are then added: fewer terms are rounded one after the other.
    let mut of_part = sums.clone();
    let (mut sizes, mut parts) = ([0.0; 3], 0.0);
    let base = 1.0 / f64::from(gas.revolutions());
    for (side, piece) in gas.sides().iter().flat_map(|side| side.law.pieces.iter().map(move |piece| (side, piece))) {
        let width = piece.to - piece.from;
        let phase = width * base * highest as f64;
        let count = (width / WIDEST).max(phase / MOST_PHASE).ceil().max(1.0) as usize;
        for edge in piece.edges(count << halvings).windows(2) {
            for (psi, weight) in points(edge[0], edge[1]) {
                let pressure = piece.pressure(geometry, psi);
                let force = (pressure - gas.crankcase()) * side.area * weight;
                let (slope, lever) = (geometry.slope(psi), geometry.radius * geometry.lever(psi));
                let values = [force, force * slope, force * lever];
                // Pressures that nearly cancel, and the lever and slope that are small at the dead centres, keep the roundings of what they were made of.
                let size = (pressure + gas.crankcase()) * side.area.abs() * weight;
                for (sum, factor) in sizes.iter_mut().zip([1.0, 1.0 + slope.abs(), geometry.radius + lever.abs()]) {
                    *sum += size * factor;
                }
                let step = Complex::cis(-psi * base);
                let mut turning = Complex::new(1.0, 0.0);
                for index in 0..=highest {
                    for (sum, value) in of_part.iter_mut().zip(values) {
                        sum[index] += turning * value;
                    }
                    turning *= step;
                }
            }
            for (sum, part) in sums.iter_mut().zip(&mut of_part) {
                sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += std::mem::take(part));
            }
            parts += 1.0;
        }
    }
    let period = gas.period();
    for sum in &mut sums {
        for (index, value) in sum.iter_mut().enumerate() {
            *value *= if index == 0 { 1.0 } else { 2.0 } / period;
        }
    }
    // Adding this many parts rounds this many times; powers of the turning add one with each harmonic.
    let part = (parts + highest as f64 + ROUNDINGS) * f64::EPSILON * 2.0 / period;
    Sums { harmonics: sums, roundings: sizes.map(|size| size * part) }
}

/// The total variation of `dT/dψ`, or more where two sides of a piston have a part in it.
fn variation(gas: &CylinderGas) -> f64 {
    gas.sides().iter().map(|side| variation_of(gas, side)).sum()
}

/// That of one side: within the pieces, and its jumps between them.
fn variation_of(gas: &CylinderGas, side: &Side) -> f64 {
    let geometry = gas.geometry();
    let mut slopes = Vec::new();
    for piece in &side.law.pieces {
        let steps = ((piece.to - piece.from) / 0.02).ceil().clamp(2.0, STEPS as f64 * 8.0) as usize;
        slopes.extend(piece.edges(steps).into_iter().map(|psi| {
            let force = (piece.pressure(geometry, psi) - gas.crankcase()) * side.area;
            let slope = piece.slope(geometry, psi) * side.area;
            geometry.radius * (slope * geometry.lever(psi) + force * geometry.lever_slope(psi))
        }));
    }
    let again = slopes.first().copied();
    slopes.iter().zip(slopes.iter().skip(1).copied().chain(again)).map(|(a, b)| (b - a).abs()).sum()
}
