//! What is the pressure at an angle? Smooth pieces, one after the other, once round the cycle.

use std::f64::consts::{PI, TAU};

use num_rational::BigRational;

use super::burning::Burning;
use super::geometry::Geometry;
use crate::engine::{Cycle, IdealCycle, PressureTable};
use crate::motion::{float, golden_section};

/// A pressure over a cycle.
#[derive(Clone, Debug)]
pub(super) struct Law {
    pub pieces: Vec<Piece>,
    /// Length of the cycle in radians.
    pub period: f64,
}

/// A piece on which the pressure is smooth.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub from: f64,
    pub to: f64,
    pub shape: Shape,
}

/// How the pressure goes in a piece.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// From one value straight to the next.
    Line(f64, f64),
    /// `p Vⁿ` stays this: n, and the constant.
    Polytropic(f64, f64),
    /// Burning from `p₀V₀ⁿ` with this heat: n, the constant, Q.
    Burning(Box<Burning>, f64, f64, f64),
    /// From one value to the next by half a cosine.
    Ramp(f64, f64),
}

/// An angle in turns as radians.
pub(super) fn radians(turns: &BigRational) -> f64 {
    float(turns) * TAU
}

/// Length of a cycle in radians.
pub(super) fn period(cycle: Cycle) -> f64 {
    match cycle {
        Cycle::TwoStroke => TAU,
        Cycle::FourStroke => 2.0 * TAU,
    }
}

impl Piece {
    /// The pressure; at the ends that of this piece.
    pub fn pressure(&self, geometry: &Geometry, psi: f64) -> f64 {
        match &self.shape {
            Shape::Line(first, last) => first + (last - first) * self.part(psi),
            Shape::Polytropic(n, constant) => constant * geometry.volume(psi).powf(-n),
            Shape::Burning(burning, n, start, heat) => {
                (start + heat * burning.sum(geometry, psi)) * geometry.volume(psi).powf(-n)
            }
            Shape::Ramp(first, last) => last + (first - last) * 0.5 * (1.0 + (PI * self.part(psi)).cos()),
        }
    }

    /// `dp/dψ`.
    pub fn slope(&self, geometry: &Geometry, psi: f64) -> f64 {
        let width = self.to - self.from;
        let polytropic = |n: f64| -n * self.pressure(geometry, psi) * geometry.volume_slope(psi) / geometry.volume(psi);
        match &self.shape {
            Shape::Line(first, last) => (last - first) / width,
            Shape::Polytropic(n, _) => polytropic(*n),
            Shape::Burning(burning, n, _, heat) => {
                polytropic(*n) + (n - 1.0) * heat * burning.rate(psi) / geometry.volume(psi)
            }
            Shape::Ramp(first, last) => -(first - last) * 0.5 * PI / width * (PI * self.part(psi)).sin(),
        }
    }

    fn part(&self, psi: f64) -> f64 {
        (psi - self.from) / (self.to - self.from)
    }

    /// The same piece cut in this many parts, over each of which it is smooth enough for a quadrature.
    pub fn edges(&self, count: usize) -> Vec<f64> {
        let even = |place: usize| self.from + (self.to - self.from) * place as f64 / count as f64;
        match &self.shape {
            Shape::Burning(burning, ..) => (0..=count).map(|place| burning.edge(place, count)).collect(),
            Shape::Line(..) | Shape::Polytropic(..) | Shape::Ramp(..) => (0..=count).map(even).collect(),
        }
    }
}

impl Law {
    /// The piece that an angle is in, and the angle brought into the cycle of the pieces.
    pub fn at(&self, psi: f64) -> (&Piece, f64) {
        let first = self.pieces[0].from;
        let psi = first + (psi - first).rem_euclid(self.period);
        let place = self.pieces.partition_point(|piece| piece.to <= psi);
        (&self.pieces[place.min(self.pieces.len() - 1)], psi)
    }

    /// A table, its rows joined by lines; `zero` is where its angles count from.
    pub fn table(table: &PressureTable, cycle: Cycle, zero: f64) -> Self {
        // Whole cycles are taken off before anything is rounded.
        let turns = cycle.turns();
        let off =
            table.rows().first().map_or_else(BigRational::default, |(first, _)| (first / &turns).floor() * &turns);
        let row = |(angle, p): &(BigRational, BigRational)| (radians(&(angle - &off)) + zero, float(p));
        let rows: Vec<(f64, f64)> = table.rows().iter().map(row).collect();
        let period = period(cycle);
        let next = rows.iter().skip(1).copied().chain(rows.first().map(|(angle, p)| (angle + period, *p)));
        let line = |((from, first), (to, last)): (&(f64, f64), (f64, f64))| Piece {
            from: *from,
            to,
            shape: Shape::Line(*first, last),
        };
        Law { pieces: rows.iter().zip(next).map(line).collect(), period }
    }

    /// An ideal cycle that releases so much heat.
    pub fn cycle(ideal: &IdealCycle, geometry: &Geometry, cycle: Cycle, zero: f64, heat: f64) -> Self {
        let period = period(cycle);
        let [closes, starts, opens] =
            [&ideal.intake_closes, &ideal.combustion_starts, &ideal.exhaust_opens].map(|turns| radians(turns) + zero);
        let [lasts, blowdown] = [&ideal.combustion_lasts, &ideal.blowdown].map(radians);
        let [intake, exhaust] = [&ideal.intake_pressure, &ideal.exhaust_pressure].map(float);
        let [compression, expansion] = [&ideal.compression_exponent, &ideal.expansion_exponent].map(float);
        let burnt = starts + lasts;
        let volume = |psi: f64| geometry.volume(psi);
        let compressed = intake * volume(closes).powf(compression);
        let at_start = compressed * volume(starts).powf(expansion - compression);
        let burning = Burning::new(geometry, starts, lasts, float(&ideal.wiebe_exponent), expansion);
        let at_end = at_start + heat * burning.sum(geometry, burnt);
        let at_opening = at_end * volume(opens).powf(-expansion);
        let mut pieces = Vec::new();
        let mut from = closes;
        let mut until = |to: f64, shape: Shape| {
            if to > from {
                pieces.push(Piece { from, to, shape });
            }
            from = to;
        };
        until(starts, Shape::Polytropic(compression, compressed));
        until(burnt, Shape::Burning(Box::new(burning), expansion, at_start, heat));
        until(opens, Shape::Polytropic(expansion, at_end));
        let open = opens + blowdown;
        match cycle {
            Cycle::FourStroke => {
                let change = zero + TAU + radians(&IdealCycle::change());
                until(open, Shape::Ramp(at_opening, exhaust));
                until(zero + TAU, Shape::Line(exhaust, exhaust));
                until(change, Shape::Ramp(exhaust, intake));
            }
            Cycle::TwoStroke => until(open, Shape::Ramp(at_opening, intake)),
        }
        until(closes + period, Shape::Line(intake, intake));
        Law { pieces, period }
    }

    /// The largest pressure in the pieces, and where it is.
    pub fn peak(&self, geometry: &Geometry) -> (f64, f64) {
        let mut best = (f64::NEG_INFINITY, 0.0);
        for piece in &self.pieces {
            let count = match piece.shape {
                Shape::Line(..) => 1,
                Shape::Ramp(..) | Shape::Polytropic(..) => 64,
                Shape::Burning(..) => 256,
            };
            let edges = piece.edges(count);
            let values: Vec<f64> = edges.iter().map(|&psi| piece.pressure(geometry, psi)).collect();
            let Some(top) = (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])) else { continue };
            let (low, high) = (edges[top.saturating_sub(1)], edges[(top + 1).min(count)]);
            let psi = golden_section(low, high, 60, |psi| piece.pressure(geometry, psi));
            for psi in [edges[top], psi] {
                let value = piece.pressure(geometry, psi);
                if value > best.0 {
                    best = (value, psi);
                }
            }
        }
        best
    }
}
