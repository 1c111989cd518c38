//! What does each cure of an order leave, per shaft and per weight? One shaft at its best, or all that are needed.
//!
//! A shaft takes one vector away; what is left has the length of the other. So one shaft at best removes the longer vector whole, the part
//! `max(|P⁺|, |P⁻|)/(|P⁺| + |P⁻|)` of the peak: half where the force swings along a line, all where one vector vanishes.

use super::comparable_engine::ComparableEngine;
use super::shafts::Kind;
use crate::numbers;
use crate::order::OrderSum;
use crate::proof::Sense;

/// A cure of the force of an order, or of its couple where the force vanishes.
#[derive(Clone, Debug, PartialEq)]
pub struct Cure {
    /// The order k.
    pub order: u32,
    /// Whether it cancels a force or a couple.
    pub kind: Kind,
    /// The senses in which weights turn at k times the speed of the crank.
    pub senses: Vec<Sense>,
    /// How many balancer shafts that takes: counterweights on the crankshaft take none.
    pub shafts: usize,
    /// Mass times radius of all, in multiples of m r; of a couple times the unit of the positions.
    pub mass_radius: f64,
    /// The peak of the order without it and with it, in multiples of m r ω²; of a couple times the unit of the positions.
    pub peak: [f64; 2],
    /// The part of the peak that it removes.
    pub removed: f64,
    /// Whether that part is exact: one vector vanishes, or both are equally long.
    pub is_exact: bool,
}

impl Cure {
    /// What it removes of the peak.
    pub fn removes(&self) -> f64 {
        self.peak[0] - self.peak[1]
    }

    /// What it removes of the peak for each shaft; none where it needs no shaft.
    pub fn per_shaft(&self) -> Option<f64> {
        (self.shafts > 0).then(|| self.removes() / self.shafts as f64)
    }

    /// What it removes of the peak for each m r of its weights.
    pub fn per_mass_radius(&self) -> f64 {
        self.removes() / self.mass_radius
    }
}

/// The cures of these orders, of forces before those of couples; of either those first that remove most of the peak for each shaft, and of
/// equal ones for each weight. None of an order whose coefficients are not known.
pub fn cures(subject: &ComparableEngine, orders: &[u32]) -> Vec<Cure> {
    let mut all: Vec<Cure> = orders.iter().flat_map(|&order| of_order(subject, order)).collect();
    let per_shaft = |cure: &Cure| cure.per_shaft().unwrap_or(f64::INFINITY);
    all.sort_by(|one, other| {
        let by_kind = (one.kind != Kind::Force).cmp(&(other.kind != Kind::Force));
        by_kind
            .then(per_shaft(other).total_cmp(&per_shaft(one)))
            .then(other.per_mass_radius().total_cmp(&one.per_mass_radius()))
    });
    all
}

fn of_order(subject: &ComparableEngine, order: u32) -> Vec<Cure> {
    let of = |sum: fn(&ComparableEngine, u32, Sense) -> OrderSum| Sense::BOTH.map(|sense| sum(subject, order, sense));
    let forces = of(ComparableEngine::force);
    let (kind, sums) = match forces.iter().all(OrderSum::vanishes) {
        true => (Kind::Couple, of(ComparableEngine::moment)),
        false => (Kind::Force, forces),
    };
    let length = |place: usize, sense: Sense| match sums[place].vanishes() {
        true => Some(0.0),
        false => subject.value(&sums[place], order, sense).map(numbers::length),
    };
    let (Some(direct), Some(reverse)) = (length(0, Sense::Direct), length(1, Sense::Reverse)) else {
        return Vec::new();
    };
    let lengths = [(Sense::Direct, direct), (Sense::Reverse, reverse)];
    let present: Vec<(Sense, f64)> = lengths.into_iter().filter(|(_, length)| *length > 0.0).collect();
    let whole = direct + reverse;
    let are_equal = sums[0].is_as_long_as(&sums[1], order);
    let cure = |taken: &[(Sense, f64)]| {
        let length: f64 = taken.iter().map(|(_, length)| length).sum();
        let is_all = taken.len() == present.len();
        let removed = if is_all { 1.0 } else { length / whole };
        Cure {
            order,
            kind,
            senses: taken.iter().map(|(sense, _)| *sense).collect(),
            shafts: taken.iter().filter(|(sense, _)| !subject.engine().has_crank_turning(order, *sense)).count(),
            mass_radius: length / f64::from(2 * order * order),
            peak: [whole / 2.0, if is_all { 0.0 } else { (whole - length) / 2.0 }],
            removed: if are_equal && !is_all { 0.5 } else { removed },
            is_exact: is_all || are_equal,
        }
    };
    match present.as_slice() {
        [] => Vec::new(),
        [_] => vec![cure(&present)],
        both => {
            // Of equally long ones that with the crank.
            let longer = if both[1].1 > both[0].1 && !are_equal { &both[1..] } else { &both[..1] };
            vec![cure(longer), cure(both)]
        }
    }
}
