//! All aims of a search by a plain loop: every star a file that is read, every choice of the revolution tried, every pair compared.

use crankstar::engine::{Cycle, CycleOrder};
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use num_rational::BigRational;

use super::plain_search::Star;

/// Instants are counted in these parts of a revolution.
pub const TICKS: i64 = 5040;

/// What is compared, in plain numbers.
#[derive(Clone, Debug)]
pub struct Asked {
    pub cycle: Cycle,
    pub directions: i64,
    /// Bank angle and pin split in ticks, offset in spacings as a file writes it.
    pub vee: Option<(i64, i64, String)>,
    pub orders: Vec<u32>,
    pub neighbours: bool,
    /// Halves of the minor orders, and the deflections of the throws.
    pub minor: Vec<u32>,
    pub shape: Vec<i64>,
}

impl Asked {
    fn file(&self, star: &[i64]) -> String {
        let throws: Vec<String> = star.iter().map(|throw| format!("\"{throw}/{} turn\"", self.directions)).collect();
        let throws = throws.join(", ");
        match &self.vee {
            None => format!("title = \"star\"\n[inline]\nthrows = [{throws}]\n"),
            Some((angle, split, offset)) => format!(
                "title = \"star\"\n[vee]\nthrows = [{throws}]\nbank_angle = \"{angle}/{TICKS} turn\"\n\
                 pin_split = \"{split}/{TICKS} turn\"\nbank_offset = \"{offset}\"\n"
            ),
        }
    }

    /// Squares of all moments: the direct ones of an engine in line, both of a V.
    fn moments(&self, star: &[i64]) -> Vec<PhasorSum> {
        let engine = crankstar::file::parse("star.toml", &self.file(star)).expect("a layout");
        let senses: &[Sense] = if self.vee.is_some() { &[Sense::Direct, Sense::Reverse] } else { &[Sense::Direct] };
        let of = |&order: &u32| {
            let engine = &engine;
            senses.iter().map(move |sense| order::star(engine, Quantity::MOMENT, order, Some(*sense)).squared_modulus())
        };
        self.orders.iter().flat_map(of).collect()
    }

    /// Whether the first-order force of all cylinders vanishes.
    pub fn is_balanced(&self, star: &[i64]) -> bool {
        let engine = crankstar::file::parse("star.toml", &self.file(star)).expect("a layout");
        Sense::BOTH.iter().all(|sense| order::star(&engine, Quantity::FORCE, 1, Some(*sense)).vanishes())
    }

    /// Crank angles of top dead centre, bank after bank.
    fn dead_centres(&self, star: &[i64]) -> Vec<i64> {
        let banks = match &self.vee {
            None => vec![0],
            // The first at −φ/2, the second at φ/2 with its pin ahead: all later by half the bank angle.
            Some((angle, split, _)) => vec![0, angle - split],
        };
        let of_bank = |bank: i64| star.iter().map(move |throw| bank - throw * TICKS / self.directions);
        banks.into_iter().flat_map(of_bank).map(|angle| angle.rem_euclid(TICKS)).collect()
    }

    /// The instants of every firing order that is as even as can be, after cylinder 1.
    fn instants(&self, star: &[i64]) -> Vec<Vec<i64>> {
        let angles = self.dead_centres(star);
        let revolutions = if self.cycle == Cycle::FourStroke { 2 } else { 1 };
        let mut all = vec![vec![angles[0]]];
        for angle in &angles[1..] {
            let late =
                |known: Vec<i64>| (0..revolutions).map(move |turn| [&known[..], &[angle + turn * TICKS]].concat());
            all = all.into_iter().flat_map(late).collect();
        }
        let unevenness = |instants: &Vec<i64>| {
            let mut sorted = instants.clone();
            sorted.sort_unstable();
            sorted.push(sorted[0] + revolutions * TICKS);
            sorted.windows(2).map(|pair| (pair[1] - pair[0]).pow(2)).sum::<i64>()
        };
        let least = all.iter().map(unevenness).min().expect("a choice");
        all.retain(|instants| unevenness(instants) == least);
        all
    }

    /// Pairs of neighbours between which, on one side, nobody fires.
    fn neighbours(&self, instants: &[i64], throws: usize) -> i64 {
        let cycle = if self.cycle == Cycle::FourStroke { 2 * TICKS } else { TICKS };
        let nobody = |from: i64, to: i64| {
            let length = (to - from).rem_euclid(cycle);
            !instants.iter().any(|instant| (1..length).contains(&(instant - from).rem_euclid(cycle)))
        };
        let follow = |one: i64, other: i64| one == other || nobody(one, other) || nobody(other, one);
        let mut count = 0;
        for first in 0..instants.len() - 1 {
            let is_pair = first / throws == (first + 1) / throws;
            count += i64::from(is_pair && follow(instants[first], instants[first + 1]));
        }
        count
    }

    fn phase_sums(&self, instants: &[i64]) -> Vec<PhasorSum> {
        let of = |halves: &u32| {
            let order = CycleOrder::of_halves(*halves).expect("an order");
            let vector = |(cylinder, instant): (usize, &i64)| Term {
                angle: order.phase(&BigRational::new((*instant).into(), TICKS.into())),
                weight: BigRational::from_integer(self.shape[cylinder % self.shape.len()].into()),
            };
            PhasorSum::new(instants.iter().enumerate().map(vector).collect()).squared_modulus()
        };
        self.minor.iter().map(of).collect()
    }

    /// Everything that a star can be, each once.
    fn values(&self, star: &[i64]) -> Vec<Star> {
        let moments = self.moments(star);
        let all = if self.neighbours || !self.minor.is_empty() { self.instants(star) } else { Vec::new() };
        let counts: Vec<i64> = all.iter().map(|instants| self.neighbours(instants, star.len())).collect();
        let least = counts.iter().min().copied();
        let with = |count: Option<i64>, sums: Vec<PhasorSum>| {
            let counted = count.filter(|_| self.neighbours).map(whole);
            Star::new(moments.iter().cloned().chain(sums).chain(counted).collect(), 1)
        };
        if self.minor.is_empty() {
            return vec![with(least, Vec::new())];
        }
        let mut different: Vec<Star> = Vec::new();
        for (instants, count) in all.iter().zip(counts) {
            let star = with(Some(count), self.phase_sums(instants));
            if !different.iter().any(|known| known.has_values_of(&star)) {
                different.push(star);
            }
        }
        different
    }

    /// The front of these stars, with their numbers.
    pub fn front(&self, stars: &[Vec<i64>]) -> Vec<Star> {
        let mut distinct: Vec<Star> = Vec::new();
        for star in stars {
            for value in self.values(star) {
                match distinct.binary_search_by(|known| known.rank(&value)) {
                    Ok(at) => distinct[at].count += 1,
                    Err(at) => distinct.insert(at, value),
                }
            }
        }
        let is_best = |star: &Star| !distinct.iter().any(|other| other.beats(star));
        let best: Vec<bool> = distinct.iter().map(is_best).collect();
        distinct.into_iter().zip(best).filter(|(_, best)| *best).map(|(star, _)| star).collect()
    }
}

/// A whole number as a sum of one vector: squares are compared.
pub fn whole(number: i64) -> PhasorSum {
    PhasorSum::new(vec![Term { angle: Turn::zero(), weight: BigRational::from_integer(number.into()) }])
}
