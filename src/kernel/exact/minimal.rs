//! Which stars of equal vectors sum to zero while no part of them does?
//!
//! Turned so that the differences of their angles are what counts, such a star has a common denominator that no square divides (Mann 1965), and with its largest prime p it is
//! `Σ_u ζ_p^u X_u`, the `X_u` over smaller primes, all of one sum. If one of them is a single vector, `X_0 = {1}`, then no part of any `X_u` is zero, and with −1 beside it `X_u` is the pair of
//! 1 and −1 or a minimal star of smaller primes. So the star is a regular p-gon in which corners are replaced: by all other vectors of such a star. Each star made so is
//! minimal: a part that is zero has the vector of `X_0`, else it has none at all; so it has all of each `X_u`. Below 2p vectors one `X_u` is single, which is so with 12 vectors for p ≥ 7; for
//! p = 5 and ten to twelve vectors no other star exists, which a test goes through. Names and numbers are those of Poonen and Rubinstein (1998).

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::sum::PhasorSum;
use super::term::Term;
use super::turn::Turn;

/// Stars of more vectors are not made.
pub const MOST_VECTORS: usize = super::fewest::MOST_VECTORS;
/// The primes up to there.
const PRIMES: [u32; 5] = [2, 3, 5, 7, 11];
/// Their product: angles are multiples of this part of a turn.
const CONDUCTOR: u32 = 2310;

/// How a minimal star is made: a regular polygon, some of its corners replaced. `(R7 : R5, 2R3)` in the words of Poonen and Rubinstein.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct StarClass {
    /// The number of corners, a prime.
    pub prime: u32,
    /// What replaces corners, rising: all vectors but one of a star of this class.
    pub replaced: Vec<StarClass>,
}

impl StarClass {
    /// Whether it is a regular polygon, and nothing replaced.
    pub fn is_regular(&self) -> bool {
        self.replaced.is_empty()
    }

    /// The number of vectors.
    pub fn vectors(&self) -> usize {
        self.prime as usize + self.replaced.iter().map(|class| class.vectors() - 2).sum::<usize>()
    }
}

impl fmt::Display for StarClass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(_) = self.replaced.first() else { return write!(f, "R_{{{}}}", self.prime) };
        let mut parts: Vec<(&StarClass, usize)> = Vec::new();
        for class in self.replaced.iter().rev() {
            match parts.last_mut() {
                Some((last, count)) if *last == class => *count += 1,
                _ => parts.push((class, 1)),
            }
        }
        let part = |(class, count): &(&StarClass, usize)| {
            if *count == 1 { class.to_string() } else { format!("{count}{class}") }
        };
        write!(f, "(R_{{{}}} : {})", self.prime, parts.iter().map(part).collect::<Vec<_>>().join(", "))
    }
}

/// A star of equal vectors that sums to zero while no part of it does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MinimalStar {
    /// How it is made.
    pub class: StarClass,
    /// Multiples of 1/2310 turn, rising from 0.
    exponents: Vec<u32>,
}

impl MinimalStar {
    /// The angles of its vectors, rising from 0.
    pub fn angles(&self) -> Vec<Turn> {
        self.exponents.iter().map(|exponent| Turn::fraction((*exponent).into(), CONDUCTOR.into())).collect()
    }

    /// The sum of its vectors, each of length 1.
    pub fn sum(&self) -> PhasorSum {
        PhasorSum::new(self.angles().into_iter().map(|angle| Term { angle, weight: BigRational::one() }).collect())
    }

    /// All vectors but this one, turned so that they sum to 1.
    fn without(&self, place: usize) -> Vec<u32> {
        let turn = CONDUCTOR + CONDUCTOR / 2 - self.exponents[place];
        let others = self.exponents.iter().enumerate().filter(|(at, _)| *at != place);
        let mut turned: Vec<u32> = others.map(|(_, exponent)| (exponent + turn) % CONDUCTOR).collect();
        turned.sort_unstable();
        turned
    }
}

/// All minimal stars of up to this many vectors, twelve at most, each once up to rotation: by their number of vectors, then by class.
pub fn minimal_stars(most: usize) -> Vec<MinimalStar> {
    let most = most.min(MOST_VECTORS);
    let mut stars: Vec<MinimalStar> = Vec::new();
    for prime in PRIMES.into_iter().filter(|prime| *prime as usize <= most) {
        let pieces: BTreeMap<Vec<u32>, StarClass> = stars
            .iter()
            .flat_map(|star| (0..star.exponents.len()).map(|place| (star.without(place), star.class.clone())))
            .filter(|(piece, _)| piece.len() > 1)
            .collect();
        let mut made =
            Made { prime, most, pieces: pieces.into_iter().collect(), known: BTreeSet::new(), stars: Vec::new() };
        made.corners(&mut vec![0], &mut Vec::new(), 1);
        stars.extend(made.stars);
    }
    stars.sort_by(|one, other| {
        let key = |star: &MinimalStar| (star.exponents.len(), star.class.clone(), star.exponents.clone());
        key(one).cmp(&key(other))
    });
    stars
}

/// The stars of one largest prime.
struct Made {
    prime: u32,
    most: usize,
    /// What may replace a corner, with its class.
    pieces: Vec<(Vec<u32>, StarClass)>,
    known: BTreeSet<Vec<u32>>,
    stars: Vec<MinimalStar>,
}

impl Made {
    /// Fills the corners from this one on: each with one vector, or a piece.
    fn corners(&mut self, exponents: &mut Vec<u32>, replaced: &mut Vec<StarClass>, corner: u32) {
        if corner == self.prime {
            let turned = turned_least(exponents);
            if self.known.insert(turned.clone()) {
                let mut replaced = replaced.clone();
                replaced.sort();
                self.stars.push(MinimalStar { class: StarClass { prime: self.prime, replaced }, exponents: turned });
            }
            return;
        }
        let at = CONDUCTOR / self.prime * corner;
        let (filled, left) = (exponents.len(), (self.prime - corner) as usize);
        exponents.push(at);
        self.corners(exponents, replaced, corner + 1);
        exponents.truncate(filled);
        for place in 0..self.pieces.len() {
            let (piece, class) = self.pieces[place].clone();
            if filled + piece.len() + left - 1 <= self.most {
                exponents.extend(piece.iter().map(|exponent| (exponent + at) % CONDUCTOR));
                replaced.push(class);
                self.corners(exponents, replaced, corner + 1);
                replaced.pop();
                exponents.truncate(filled);
            }
        }
    }
}

/// Of all rotations with a vector at 0 the one that comes first.
fn turned_least(exponents: &[u32]) -> Vec<u32> {
    let turned = exponents.iter().map(|first| {
        let mut turned: Vec<u32> =
            exponents.iter().map(|exponent| (exponent + CONDUCTOR - first) % CONDUCTOR).collect();
        turned.sort_unstable();
        turned
    });
    turned.min().unwrap_or_default()
}

/// A part of a star: the place of a minimal star in a list, how far it is turned, the length of its vectors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StarPart {
    /// The place in the list.
    pub star: usize,
    /// How far it is turned.
    pub turn: Turn,
    /// The length of its vectors.
    pub length: BigRational,
}

/// Takes a star, negative vectors turned by half a turn, apart into stars of a list: earlier ones first, each at the greatest length that fits. None where something is left.
pub fn taken_apart(sum: &PhasorSum, stars: &[MinimalStar]) -> Option<Vec<StarPart>> {
    let mut left: BTreeMap<Turn, BigRational> =
        sum.positive().collected().into_iter().map(|term| (term.angle, term.weight)).collect();
    let mut parts = Vec::new();
    for (star, minimal) in stars.iter().enumerate() {
        let angles = minimal.angles();
        // Each vector is tried as the first of such a star.
        for turn in left.keys().cloned().collect::<Vec<Turn>>() {
            if angles.len() > left.len() {
                break;
            }
            let corners = angles.iter().map(|angle| angle + &turn);
            let Some(corners) = corners.map(|at| Some((left.get(&at)?.clone(), at))).collect::<Option<Vec<_>>>() else {
                continue;
            };
            let Some(length) = corners.iter().map(|(length, _)| length.clone()).min() else { continue };
            for (before, at) in corners {
                let after = before - &length;
                match after.is_positive() {
                    true => left.insert(at, after),
                    false => left.remove(&at),
                };
            }
            parts.push(StarPart { star, turn, length });
        }
    }
    left.is_empty().then_some(parts)
}
