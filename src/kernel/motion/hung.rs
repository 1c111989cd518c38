//! What does a link hand on to the crankpin of its master rod?
//!
//! Each rod is two masses at its ends, so that the link pushes its knuckle pin along itself. The knuckle pin stands, seen from the crankpin,
//! at `a e^{iγ}` times the direction `d` of the master rod. A force Q on it is carried by the crankpin and, since the moments on the
//! master rod cancel, by the wall of the master's piston, across that cylinder: with x and f sine and cosine of the master rod's slope and
//! `κ = a/l` the wall pushes with
//!
//! `N = −κ Im((d e^{iγ})* Q)/f`
//!
//! a quarter turn ahead of the master's axis, and the crankpin feels `Q + N`. In the frame of the link's cylinder `d e^{iγ}` is
//! `e^{iε} (f − ix)`, and a quarter turn ahead of the master's axis is `i e^{−iΔ}`.
//!
//! These numbers have no closed form here: they are means of the exact motion over a turn, which converge as the orders of the motion fall,
//! in decimals.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::OnceLock;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::FromPrimitive;

use super::enclosure::{Coefficient, Enclosure};
use super::piston::LinkMotion;

/// A link on its master rod: what its knuckle pin feels, and what becomes of it.
#[derive(Clone, Debug)]
pub struct HungLink {
    motion: LinkMotion,
    known: [OnceLock<Vec<Complex<f64>>>; 2],
}

/// Which mass of a link a force is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LinkMass {
    /// That of its piston, on its small end.
    Piston,
    /// That at its knuckle pin.
    Knuckle,
}

/// Angles of a turn at which the forces are computed: as few as these, and twice as many until the orders fall below roundings.
const FEWEST: usize = 256;
/// A crank that all but stands at its end of reach is left at these.
const MOST: usize = 16384;
/// The roundings of a mean, as a part of the largest force.
const ROUNDING: f64 = 1e-12;

impl HungLink {
    /// From r/L, κ and λ, and Δ and ε in turns.
    pub fn new(ratios: [&BigRational; 3], turns: [&BigRational; 2]) -> Self {
        HungLink { motion: LinkMotion::new(ratios, turns), known: Default::default() }
    }

    /// tan β of the link, in its own cylinder.
    pub fn slope(&self, psi: f64) -> f64 {
        self.motion.slope(psi)
    }

    /// `s''/r` of its piston, outward positive.
    pub fn acceleration(&self, psi: f64) -> f64 {
        self.motion.piston(psi).second
    }

    /// The direction from the crankpin to the knuckle pin, in the frame of the link's cylinder.
    pub fn outward(&self, psi: f64) -> Complex<f64> {
        let [sine, cosine] = self.master_rod(psi);
        let [along, across] = self.motion.correction;
        Complex::new(along, across) * Complex::new(cosine, -sine)
    }

    /// Sine and cosine of the slope of the master rod.
    fn master_rod(&self, psi: f64) -> [f64; 2] {
        let sine = self.motion.master * (psi + self.motion.angle).sin();
        [sine, ((1.0 - sine) * (1.0 + sine)).sqrt()]
    }

    /// What an inertia of 1 of each kind loads the knuckle pin with, in the frame of the cylinder: a force of its piston along the axis,
    /// outward, and a mass at the pin itself, in multiples of its `m r ω²`.
    pub fn on_the_knuckle(&self, psi: f64) -> [Complex<f64>; 2] {
        let [along, across] = self.motion.knuckle(psi);
        [Complex::new(1.0, -self.slope(psi)), -Complex::new(along.second, across.second)]
    }

    /// The force of the wall on the master's piston that a force on the knuckle pin calls for, a quarter turn anticlockwise from the
    /// master's axis outward; the force is in the frame of the link's cylinder.
    pub fn side(&self, psi: f64, force: Complex<f64>) -> f64 {
        let [_, cosine] = self.master_rod(psi);
        -self.motion.knuckle * (self.outward(psi).conj() * force).im / cosine
    }

    /// What the crankpin feels of a force on the knuckle pin, both in the frame of the link's cylinder.
    pub fn handed_on(&self, psi: f64, force: Complex<f64>) -> Complex<f64> {
        let across_the_master = Complex::<f64>::cis(FRAC_PI_2 - self.motion.angle);
        force + across_the_master * self.side(psi, force)
    }

    /// What the crankpin feels of a mass of the link, in multiples of its `m r ω²`.
    fn inertia(&self, mass: LinkMass, psi: f64) -> Complex<f64> {
        let [of_piston, of_knuckle] = self.on_the_knuckle(psi);
        let force = match mass {
            LinkMass::Piston => of_piston * -self.acceleration(psi),
            LinkMass::Knuckle => of_knuckle,
        };
        self.handed_on(psi, force)
    }

    fn samples(&self, mass: LinkMass) -> &[Complex<f64>] {
        self.known[mass as usize].get_or_init(|| {
            let law =
                |steps: usize| (0..steps).map(|step| self.inertia(mass, TAU * step as f64 / steps as f64)).collect();
            let mut steps = FEWEST;
            let mut samples: Vec<Complex<f64>> = law(steps);
            while steps < MOST
                && [steps / 4, 3 * steps / 4].iter().any(|&k| harmonic(&samples, k).norm() > rounding(&samples))
            {
                steps *= 2;
                samples = law(steps);
            }
            samples
        })
    }

    /// The harmonic of `e^{ikψ}`, k of either sign.
    fn harmonic(&self, mass: LinkMass, order: i64) -> Complex<f64> {
        let samples = self.samples(mass);
        match order.unsigned_abs() < samples.len() as u64 / 4 {
            true => harmonic(samples, order.rem_euclid(samples.len() as i64) as usize),
            false => Complex::new(0.0, 0.0),
        }
    }

    /// What the load of the crankpin is multiplied by in an order: twice the harmonic of `e^{ikψ}`, or the conjugate of that of `e^{−ikψ}`
    /// (`reverse`), the roundings of the decimals about it; of order 0 half of that.
    pub fn number(&self, mass: LinkMass, order: u32, reverse: bool) -> Coefficient {
        let twice = if order == 0 { 1.0 } else { 2.0 };
        let signed = if reverse { -i64::from(order) } else { i64::from(order) };
        let number = self.harmonic(mass, signed) * twice;
        let rounding = rounding(self.samples(mass));
        let im = if reverse { -number.im } else { number.im };
        Coefficient { re: about(number.re, rounding), im: about(im, rounding) }
    }

    /// What the orders above this one add to the load, about: the sum of their sizes.
    pub fn above(&self, mass: LinkMass, order: u32) -> f64 {
        let samples = self.samples(mass);
        let mut sum = rounding(samples);
        let mut small = 0;
        // They fall as a geometric series does, but one of them may be none.
        for k in order.saturating_add(1)..samples.len() as u32 / 4 {
            let both: f64 = [i64::from(k), -i64::from(k)].map(|k| self.harmonic(mass, k).norm()).iter().sum();
            sum += both;
            small = if both < rounding(samples) { small + 1 } else { 0 };
            if small > 2 {
                break;
            }
        }
        sum
    }
}

/// The mean of samples of a turn times `e^{−ikψ}`.
pub fn harmonic(samples: &[Complex<f64>], order: usize) -> Complex<f64> {
    let step = Complex::cis(-TAU * order as f64 / samples.len() as f64);
    let mut turned = Complex::new(1.0, 0.0);
    let mut sum = Complex::new(0.0, 0.0);
    for (place, sample) in samples.iter().enumerate() {
        // A product of many is off by its roundings: it begins anew now and then.
        if place % 16 == 0 {
            turned = Complex::cis(-TAU * (order * place % samples.len()) as f64 / samples.len() as f64);
        }
        sum += sample * turned;
        turned *= step;
    }
    sum / samples.len() as f64
}

fn rounding(samples: &[Complex<f64>]) -> f64 {
    samples.iter().map(|force| force.norm()).fold(0.0, f64::max) * ROUNDING
}

/// A number with its roundings.
fn about(value: f64, rounding: f64) -> Enclosure {
    let end = |value: f64| BigRational::from_f64(value).unwrap_or_default();
    Enclosure { low: end(value - rounding), high: end(value + rounding) }
}
