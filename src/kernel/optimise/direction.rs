//! In which directions are counterweights written exactly? Those of the throws, where every sum of the engine has its terms.

use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::direction;

/// Directions round the circle, so that every vector is `a e^{iα} + b e^{iβ}` with a, b ≥ 0 of two neighbours.
pub(super) struct Directions {
    /// In rising order.
    turns: Vec<Turn>,
    vectors: Vec<Complex<f64>>,
    /// Whether they are the corners of a square or of a hexagon: then rational sums of them are rational sums of two.
    lattice: bool,
}

impl Directions {
    /// Those of these angles and their opposites, made square or hexagonal where they fit in.
    pub fn new(angles: &[Turn]) -> Self {
        let zero = Turn::zero();
        let first = angles.first().unwrap_or(&zero);
        let fits = |corners: i64| {
            let whole = |angle: &Turn| (angle - first).times(corners).turns().is_zero();
            angles.iter().all(whole)
        };
        let polygon =
            |corners: i64| (0..corners).map(|corner| first + &Turn::fraction(corner, corners)).collect::<Vec<_>>();
        let lattice = [4, 6].into_iter().find(|corners| fits(*corners));
        let mut turns: Vec<Turn> = match lattice {
            Some(corners) => polygon(corners),
            None => angles.iter().flat_map(|angle| [angle.clone(), angle.opposite()]).collect(),
        };
        let sort = |turns: &mut Vec<Turn>| {
            turns.sort_by(|a, b| a.turns().cmp(b.turns()));
            turns.dedup();
        };
        sort(&mut turns);
        // Between neighbours that are nearly opposite both parts of a vector would be long.
        let gap = |pair: [usize; 2]| (&turns[pair[1]] - &turns[pair[0]]).turns().clone();
        let count = turns.len();
        if (0..count).any(|index| gap([index, (index + 1) % count]) > BigRational::new(1.into(), 3.into())) {
            turns.extend([1, 3].map(|quarters| first + &Turn::fraction(quarters, 4)));
            sort(&mut turns);
        }
        Directions { vectors: turns.iter().map(direction).collect(), turns, lattice: lattice.is_some() }
    }

    /// A direction and the one after it.
    fn pairs(&self) -> impl Iterator<Item = [usize; 2]> {
        let count = self.turns.len();
        (0..count).map(move |index| [index, (index + 1) % count])
    }

    /// The vector rounded to whole multiples of a unit along its two neighbours; nothing where it rounds to nothing.
    pub fn rounded(&self, vector: Complex<f64>, unit: &BigRational) -> PhasorSum {
        use num_traits::ToPrimitive;
        let size = unit.to_f64().unwrap_or(1.0);
        let cross = |a: Complex<f64>, b: Complex<f64>| a.re * b.im - a.im * b.re;
        let along = |[first, second]: [usize; 2]| {
            let (a, b) = (self.vectors[first], self.vectors[second]);
            [cross(vector, b) / cross(a, b) / size, cross(a, vector) / cross(a, b) / size]
        };
        let holds = |pair: &[usize; 2]| along(*pair).iter().all(|part| *part >= -1e-6);
        let Some(pair) = self.pairs().find(holds) else { return PhasorSum::new(Vec::new()) };
        let terms = pair.into_iter().zip(along(pair)).filter_map(|(index, part)| {
            let whole = BigInt::from(part.round() as i64);
            (!whole.is_zero())
                .then(|| Term { angle: self.turns[index].clone(), weight: BigRational::from_integer(whole) * unit })
        });
        PhasorSum::new(terms.collect())
    }

    /// The same vector in as few terms of positive weight as its exact form has: two at most on a square or hexagon.
    pub fn positive(&self, sum: &PhasorSum) -> PhasorSum {
        let collected = sum.tidied().positive().collected();
        if !self.lattice {
            return PhasorSum::new(self.cancelled(collected));
        }
        let coordinates = collected.iter().fold([BigRational::zero(), BigRational::zero()], |[x, y], term| {
            let [on_first, on_second] = self.corner(&term.angle);
            [x + &term.weight * whole(on_first), y + &term.weight * whole(on_second)]
        });
        let [x, y] = &coordinates;
        for pair in self.pairs() {
            let [[a, c], [b, d]] = pair.map(|index| self.corner(&self.turns[index]));
            // Neighbouring corners have determinant 1.
            let parts = [x * whole(d) - y * whole(b), y * whole(a) - x * whole(c)];
            if parts.iter().all(|part| !part.is_negative()) {
                let terms = pair.into_iter().zip(parts).filter(|(_, weight)| !weight.is_zero());
                let term = |(index, weight): (usize, BigRational)| Term { angle: self.turns[index].clone(), weight };
                return PhasorSum::new(terms.map(term).collect());
            }
        }
        PhasorSum::new(collected)
    }

    /// What opposite directions have in common cancels.
    fn cancelled(&self, terms: Vec<Term>) -> Vec<Term> {
        let of = |angle: &Turn| {
            let same = terms.iter().find(|term| term.angle == *angle);
            same.map_or_else(BigRational::zero, |term| term.weight.clone())
        };
        let left = terms
            .iter()
            .map(|term| Term { weight: &term.weight - of(&term.angle.opposite()), angle: term.angle.clone() });
        left.filter(|term| term.weight.is_positive()).collect()
    }

    /// A corner in multiples of the first and of the second corner.
    fn corner(&self, angle: &Turn) -> [i64; 2] {
        let place = self.turns.iter().position(|turn| turn == angle);
        match (self.turns.len(), place) {
            (4, Some(place)) => [[1, 0], [0, 1], [-1, 0], [0, -1]][place],
            (_, Some(place)) => [[1, 0], [0, 1], [-1, 1], [-1, 0], [0, -1], [1, -1]][place],
            (_, None) => unreachable!("the sums of an engine have their terms along its throws"),
        }
    }
}

fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}
