//! What is the sum of an engine at φ and δ, in decimals, straight from its cylinders, and where does a dense search find it to vanish?

use std::f64::consts::TAU;

use crankstar::engine::{Cylinder, DELTA, Family, Linear, PHI};
use crankstar::family::OpenVerdict;
use crankstar::proof::{Planar, Sense};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// An exact number in decimals.
pub fn float(value: &BigRational) -> f64 {
    value.to_f64().expect("a number")
}

/// The sum at φ and δ in turns, straight from the cylinders, in decimals.
pub struct Star {
    /// Known angle, times φ, times δ, weight.
    terms: Vec<[f64; 4]>,
    total: f64,
}

impl Star {
    pub fn of(family: &Family, verdict: &OpenVerdict) -> Star {
        let k = f64::from(verdict.order);
        let [of_throw, of_bank] = match verdict.sense {
            Sense::Direct => [k, 1.0 - k],
            Sense::Reverse => [-k, 1.0 + k],
        };
        let term = |cylinder: &Cylinder<Linear, Linear>| {
            let phase = |throw: &BigRational, bank: &BigRational| of_throw * float(throw) + of_bank * float(bank);
            let times = |name| phase(&cylinder.throw.coefficient(name), &cylinder.bank.coefficient(name));
            let arm = match verdict.quantity {
                Planar::Moment => float(cylinder.position.known()) - float(family.reference_plane().known()),
                _ => 1.0,
            };
            let weight = float(&cylinder.reciprocating_mass) * float(&cylinder.crank_radius) * arm;
            [phase(cylinder.throw.known(), cylinder.bank.known()), times(PHI), times(DELTA), weight]
        };
        let terms: Vec<[f64; 4]> = family.cylinders().iter().map(term).collect();
        let total = terms.iter().map(|[.., weight]| weight.abs()).sum::<f64>().max(1e-9);
        Star { terms, total }
    }

    /// The sum over its weights, and its derivatives by φ and δ.
    pub fn at(&self, [phi, delta]: [f64; 2]) -> [Complex<f64>; 3] {
        let none = Complex::new(0.0, 0.0);
        self.terms.iter().fold([none; 3], |[value, by_phi, by_delta], [known, p, d, weight]| {
            let turned = Complex::from_polar(weight / self.total, TAU * (known + p * phi + d * delta));
            let slope = turned * Complex::new(0.0, TAU);
            [value + turned, by_phi + slope * p, by_delta + slope * d]
        })
    }

    pub fn length(&self, at: [f64; 2]) -> f64 {
        self.at(at)[0].norm()
    }

    /// Steps of least squares, damped, from a point.
    fn descend(&self, mut at: [f64; 2]) -> [f64; 2] {
        for _ in 0..60 {
            let [value, p, d] = self.at(at);
            if value.norm() < 1e-14 {
                break;
            }
            let damping = 1e-3 * value.norm() * TAU;
            let [a, b, c] = [p.norm_sqr() + damping, (p * d.conj()).re, d.norm_sqr() + damping];
            let [x, y] = [(value * p.conj()).re, (value * d.conj()).re];
            let determinant = a * c - b * b;
            let steps = [(c * x - b * y) / determinant, (a * y - b * x) / determinant];
            at = [at[0] - steps[0].clamp(-0.03, 0.03), at[1] - steps[1].clamp(-0.03, 0.03)];
        }
        at
    }

    pub fn zeros(&self) -> Vec<[f64; 2]> {
        let starts =
            (0..18).flat_map(|i| (0..18).map(move |j| [f64::from(i) / 18.0 + 0.01, f64::from(j) / 18.0 + 0.017]));
        starts.map(|start| self.descend(start)).filter(|at| self.length(*at) < 1e-12).collect()
    }
}
