//! Which work does the gas do in a cycle? The area of its loop, in closed form where there is one.
//!
//! Another way than the mean of the torque, with which it has to agree: `∮ p dV = t₀ Ψ`.

use super::geometry::Geometry;
use super::law::{Law, Piece, Shape};
use super::quadrature::integrate;

impl Law {
    /// `∮ p dV`; 0 where it is below what its sum is rounded by.
    pub fn work(&self, geometry: &Geometry) -> f64 {
        let work: f64 = self.pieces.iter().map(|piece| piece.work(geometry)).sum();
        let largest = geometry.volume(geometry.innermost);
        let size = |piece: &Piece| {
            let ends = [piece.from, piece.to].map(|psi| piece.pressure(geometry, psi) * largest);
            ends.iter().sum::<f64>() + piece.heat().abs()
        };
        let size: f64 = self.pieces.iter().map(size).sum();
        let roundings = self.pieces.len() as f64 + ROUNDINGS;
        if work.abs() <= roundings * f64::EPSILON * size { 0.0 } else { work }
    }
}

/// Each piece is rounded this many times at most.
const ROUNDINGS: f64 = 256.0;

impl Piece {
    /// The heat that is released in it.
    fn heat(&self) -> f64 {
        match &self.shape {
            Shape::Burning(.., heat) => *heat,
            Shape::Line(..) | Shape::Polytropic(..) | Shape::Ramp(..) => 0.0,
        }
    }

    fn work(&self, geometry: &Geometry) -> f64 {
        let [first, last] = [self.from, self.to].map(|psi| self.pressure(geometry, psi) * geometry.volume(psi));
        let over = |count: usize, f: &dyn Fn(f64) -> f64| -> f64 {
            self.edges(count).windows(2).map(|edge| integrate(0.0, edge[0], edge[1], f)).sum()
        };
        // Wide pieces need more points than the steps of a table.
        let count = ((self.to - self.from) / 0.1).ceil().max(1.0) as usize;
        match &self.shape {
            Shape::Line(from, to) if from == to => from * (geometry.volume(self.to) - geometry.volume(self.from)),
            Shape::Line(from, to) => {
                let slope = (to - from) / (self.to - self.from);
                last - first - slope * over(count, &|psi| geometry.volume(psi))
            }
            Shape::Polytropic(n, _) => (first - last) / (n - 1.0),
            Shape::Burning(_, n, _, heat) => heat + (first - last) / (n - 1.0),
            Shape::Ramp(..) => over(4 * count, &|psi| self.pressure(geometry, psi) * geometry.volume_slope(psi)),
        }
    }
}
