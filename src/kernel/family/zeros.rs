//! At which values of one unknown does a sum vanish? One answer for pages, sweeps and sliders.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::circle::{self, Circle};
use super::part::Part;
use super::verdict::{OpenSum, OpenVerdict};
use super::when::When;
use crate::engine::PHI;
use crate::exact::Turn;

/// The values of one unknown in a range, in turns, at which something vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Zeros {
    /// All.
    Everywhere,
    /// These.
    At(Solutions),
    /// Another unknown enters too, or this one too many times.
    NotSolved,
}

/// Values in turns, rising.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Solutions {
    /// Those that are rational.
    pub exact: BTreeSet<BigRational>,
    /// Ends between which there is one each, which is irrational.
    pub irrational: Vec<[BigRational; 2]>,
    /// Ends between which there may be more; nowhere else.
    pub open: Vec<[BigRational; 2]>,
}

impl Solutions {
    /// Whether there is surely none.
    pub fn is_none(&self) -> bool {
        self.exact.is_empty() && self.irrational.is_empty() && self.open.is_empty()
    }

    /// All of them, where all are rational.
    pub fn all_exact(&self) -> Option<&BTreeSet<BigRational>> {
        (self.irrational.is_empty() && self.open.is_empty()).then_some(&self.exact)
    }

    /// Without the values of which this does not hold.
    ///
    /// `borders`: where it changes for values that are not rational.
    pub fn retain(&mut self, holds: impl Fn(&BigRational) -> bool, borders: &[BigRational]) {
        self.exact.retain(&holds);
        let is_crossed = |[low, high]: &[BigRational; 2]| borders.iter().any(|border| low < border && border < high);
        let (crossed, whole): (Vec<_>, Vec<_>) = std::mem::take(&mut self.irrational).into_iter().partition(is_crossed);
        let middle = |[low, high]: &[BigRational; 2]| (low + high) / BigRational::from_integer(2.into());
        self.irrational = whole.into_iter().filter(|ends| holds(&middle(ends))).collect();
        self.open.retain(|ends| is_crossed(ends) || holds(&middle(ends)));
        self.open.extend(crossed);
        self.open.sort();
    }

    /// Where both vanish.
    fn and(&self, other: &Solutions) -> Solutions {
        let holds = |ends: &[BigRational; 2], at: &BigRational| ends[0] <= *at && *at <= ends[1];
        let mut open: Vec<[BigRational; 2]> = Vec::new();
        // What is left open by one may be a zero where the other has one, or is open too.
        for (one, two) in [(self, other), (other, self)] {
            let maybe = one.exact.iter().filter(|at| !two.exact.contains(*at));
            let maybe = maybe.filter(|at| two.open.iter().any(|ends| holds(ends, at)));
            open.extend(maybe.map(|at| [at.clone(), at.clone()]));
            open.extend(overlaps(&one.irrational, &two.open));
        }
        open.extend(overlaps(&self.open, &other.open));
        // Two irrational zeros near each other may be one or two.
        open.extend(overlaps(&self.irrational, &other.irrational));
        open.sort();
        Solutions { exact: self.exact.intersection(&other.exact).cloned().collect(), irrational: Vec::new(), open }
    }
}

fn overlaps(some: &[[BigRational; 2]], others: &[[BigRational; 2]]) -> Vec<[BigRational; 2]> {
    let pairs = some.iter().flat_map(|one| others.iter().map(move |other| (one, other)));
    let common = pairs.map(|(a, b)| [a[0].clone().max(b[0].clone()), a[1].clone().min(b[1].clone())]);
    common.filter(|[low, high]| low <= high).collect()
}

impl Zeros {
    /// Nowhere.
    pub(super) fn never() -> Self {
        Zeros::At(Solutions::default())
    }

    /// Where both vanish.
    pub fn and(self, other: Zeros) -> Zeros {
        match (self, other) {
            (Zeros::Everywhere, other) | (other, Zeros::Everywhere) => other,
            (Zeros::At(one), Zeros::At(other)) => Zeros::At(one.and(&other)),
            // Where one vanishes nowhere, both do not.
            (Zeros::At(none), Zeros::NotSolved) | (Zeros::NotSolved, Zeros::At(none)) if none.is_none() => {
                Zeros::never()
            }
            (Zeros::NotSolved, Zeros::At(_) | Zeros::NotSolved) | (Zeros::At(_), Zeros::NotSolved) => Zeros::NotSolved,
        }
    }
}

impl OpenSum {
    /// The values of one unknown, φ or δ, at which it vanishes, the ends of the range among them.
    pub fn zeros(&self, unknown: &str, range: [&BigRational; 2]) -> Zeros {
        let of_circle = |circle: &Circle| circle.solutions(unknown, range).map_or(Zeros::NotSolved, Zeros::At);
        match &self.when {
            When::Always => Zeros::Everywhere,
            When::Never(_) => Zeros::never(),
            When::Where(angles) => match angles.values(unknown, range) {
                Some(exact) => Zeros::At(Solutions { exact, ..Solutions::default() }),
                None => Zeros::NotSolved,
            },
            When::Circle(circle) => of_circle(circle),
            When::Cosine(_) => {
                let parts: Vec<&Part> = self.left().collect();
                circle::arcs_of(&parts).as_ref().map_or(Zeros::NotSolved, of_circle)
            }
            When::Irrational { .. } | When::Triangle(_) | When::Classes(_) | When::Quadratic(_) => Zeros::NotSolved,
            When::Product(_) | When::Boxes(_) | When::NotSolved(_) => Zeros::NotSolved,
        }
    }

    /// Whether it is a multiple of another, and vanishes where that does.
    fn is_multiple_of(&self, other: &OpenSum) -> bool {
        let (own, others): (Vec<&Part>, Vec<&Part>) = (self.left().collect(), other.left().collect());
        let (Some(first), Some(reference), true) = (own.first(), others.first(), own.len() == others.len()) else {
            return false;
        };
        own.iter().zip(&others).all(|(a, b)| {
            let turns_alike = &a.phi - &first.phi == &b.phi - &reference.phi
                && &a.delta - &first.delta == &b.delta - &reference.delta;
            turns_alike && a.sum.times(&reference.sum) == b.sum.times(&first.sum)
        })
    }
}

impl OpenVerdict {
    /// The angles φ in (0°, 360°) at which it vanishes for all lengths; `None` where it always does, where δ enters,
    /// or where not all of them are rational.
    pub fn bank_angles(&self) -> Option<BTreeSet<Turn>> {
        self.angles_of(PHI)
    }

    /// The same of an unknown, φ or δ: `None` where the other one enters.
    pub fn angles_of(&self, unknown: &str) -> Option<BTreeSet<Turn>> {
        let (none, one) = (BigRational::zero(), BigRational::one());
        let values = self.values(unknown, [&none, &one])?;
        Some(values.into_iter().filter(|value| *value != none && *value != one).map(Turn::new).collect())
    }

    /// The values of one unknown, φ or δ, in a range at which it vanishes for all lengths, in turns and with the ends of the
    /// range; `None` where it always does, where the other one enters, or where not all of them are rational.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        match self.zeros(unknown, range) {
            Zeros::At(solutions) => solutions.all_exact().cloned(),
            Zeros::Everywhere | Zeros::NotSolved => None,
        }
    }
    /// The values of one unknown, φ or δ, at which it vanishes for all lengths, the ends of the range among them.
    pub fn zeros(&self, unknown: &str, range: [&BigRational; 2]) -> Zeros {
        if self.never() {
            return Zeros::never();
        }
        sums_zeros(&self.sums, unknown, range)
    }
}

/// Where all sums vanish.
pub(super) fn sums_zeros(sums: &[OpenSum], unknown: &str, range: [&BigRational; 2]) -> Zeros {
    let is_new = |place: &usize| !sums[..*place].iter().any(|earlier| sums[*place].is_multiple_of(earlier));
    let apart = (0..sums.len()).filter(is_new).map(|place| sums[place].zeros(unknown, range));
    apart.fold(Zeros::Everywhere, Zeros::and)
}

impl Circle {
    /// The values of one unknown in a range; `None` where the other one enters.
    fn solutions(&self, unknown: &str, range: [&BigRational; 2]) -> Option<Solutions> {
        let (phi, delta) = (&self.polynomial.phi, &self.polynomial.delta);
        let (own, other) = if unknown == PHI { (phi, delta) } else { (delta, phi) };
        if !other.is_zero() || !own.is_positive() {
            return None;
        }
        let lifted = |ends: [&BigRational; 2]| lifted(ends, own, range);
        let mut found = Solutions::default();
        for turn in self.rational() {
            found.exact.extend(lifted([turn.turns(); 2]).into_iter().map(|[at, _]| at));
        }
        found.irrational = self.irrational().flat_map(lifted).collect();
        found.open = self.open().flat_map(lifted).collect();
        // An irrational value may be on either side of an end of the range.
        let [low, high] = range;
        found.retain(|value| low <= value && value <= high, &[low.clone(), high.clone()]);
        found.irrational.sort();
        found.open = within(found.open, range);
        Some(found)
    }
}

/// All x in a range with `times·x` between two turns, modulo a turn.
pub(super) fn lifted(
    ends: [&BigRational; 2],
    times: &BigRational,
    [low, high]: [&BigRational; 2],
) -> Vec<[BigRational; 2]> {
    let mut whole: BigInt = (times * low - ends[1]).ceil().to_integer();
    let last = (times * high - ends[0]).floor().to_integer();
    let mut found = Vec::new();
    while whole <= last {
        let turns = BigRational::from_integer(whole.clone());
        found.push(ends.map(|end| (end + &turns) / times));
        whole += BigInt::one();
    }
    found
}

fn within(open: Vec<[BigRational; 2]>, [low, high]: [&BigRational; 2]) -> Vec<[BigRational; 2]> {
    let cut = open.into_iter().map(|[from, to]| [from.max(low.clone()), to.min(high.clone())]);
    cut.filter(|[from, to]| from <= to).collect()
}
