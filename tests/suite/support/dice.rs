//! Which sums do tests try? Pseudo-random ones over a given conductor, many zero and many not, the same every time.

use crankstar::exact::{PhasorSum, Term, Turn};

/// Terms `(exponent, weight)` over some conductor, not collected.
pub type Terms = Vec<(u64, i64)>;

/// SplitMix64.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Dice(seed)
    }

    pub fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % bound
    }

    fn sign(&mut self) -> i64 {
        if self.below(2) == 0 { 1 } else { -1 }
    }

    /// Of either sign, from 1 to `most`.
    fn weight(&mut self, most: u64) -> i64 {
        (self.below(most) as i64 + 1) * self.sign()
    }
}

/// One sum of every make over this conductor.
pub fn one_of_each(dice: &mut Dice, conductor: u64) -> [Terms; 8] {
    let few = dice.below(6) + 2;
    let some = dice.below(6) + 1;
    let signed = polygons(dice, conductor, some, Dice::sign);
    let positive = polygons(dice, conductor, some, |dice| dice.below(5) as i64 + 1);
    [
        scattered(dice, conductor, few, 1),
        scattered(dice, conductor, 2 * few, 9),
        scattered(dice, conductor, conductor, 2),
        with_a_pair(dice, conductor, signed.clone()),
        spoiled(dice, conductor, signed.clone()),
        spoiled(dice, conductor, positive.clone()),
        signed,
        positive,
    ]
}

fn scattered(dice: &mut Dice, conductor: u64, count: u64, most: u64) -> Terms {
    (0..count).map(|_| (dice.below(conductor), dice.weight(most))).collect()
}

/// A sum that is zero: rotated regular polygons with prime numbers of sides.
pub fn polygons(dice: &mut Dice, conductor: u64, count: u64, mut weight: impl FnMut(&mut Dice) -> i64) -> Terms {
    let primes: Vec<u64> = (2..=conductor.min(300)).filter(|&p| conductor.is_multiple_of(p) && is_prime(p)).collect();
    let count = if primes.is_empty() { 0 } else { count };
    let polygon = |_| {
        let (sides, first) = (primes[dice.below(primes.len() as u64) as usize], dice.below(conductor));
        let weight = weight(dice);
        (0..sides).map(move |j| ((first + j * (conductor / sides)) % conductor, weight)).collect::<Terms>()
    };
    (0..count).flat_map(polygon).collect()
}

/// One term more, so that a sum that was zero no longer is.
pub fn spoiled(dice: &mut Dice, conductor: u64, mut terms: Terms) -> Terms {
    terms.push((dice.below(conductor), dice.weight(3)));
    terms
}

fn with_a_pair(dice: &mut Dice, conductor: u64, mut terms: Terms) -> Terms {
    let exponent = dice.below(conductor);
    terms.push((exponent, 1));
    terms.push(((exponent + conductor / 2) % conductor, 1));
    terms
}

fn is_prime(candidate: u64) -> bool {
    candidate > 1 && (2..candidate).all(|d| !candidate.is_multiple_of(d))
}

pub fn phasors(conductor: u64, terms: &[(u64, i64)]) -> PhasorSum {
    let conductor = i64::try_from(conductor).expect("a small conductor");
    let term = |&(exponent, weight): &(u64, i64)| Term {
        angle: Turn::fraction(i64::try_from(exponent).expect("below the conductor"), conductor),
        weight: num_rational::BigRational::from_integer(weight.into()),
    };
    PhasorSum::new(terms.iter().map(term).collect())
}
