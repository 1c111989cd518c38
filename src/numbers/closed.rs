//! What is the length of a sum exactly, and its direction? Radicals found by field arithmetic, not from decimals.
//!
//! `|S|²` lies in the real part of Q(ζ_N). The maps `t ↦ at`, a prime to N, carry it to its conjugates; how many
//! differ is its degree (theory, section 6). Degree 1 is a rational number; degree 2^m is worked down by quadratic
//! steps, `Q = (Q + σQ)/2 + (Q − σQ)/2`, whose second part has its square in a smaller field; what remains is a sum of
//! cosines.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::evaluate::evaluate;
use super::form::Form;
use crate::exact::{PhasorSum, Term, Turn};

/// Closed forms are looked for up to this conductor.
const LARGEST_CONDUCTOR: u64 = 1000;
/// Quadratic steps are taken up to this degree; nested roots of a higher one are no help to a reader.
const LARGEST_DEGREE: usize = 8;
/// Among more directions than this the decimals cannot name the one candidate.
const MOST_DIRECTIONS: i64 = 1 << 40;
/// Longer sums of cosines tell a reader nothing; decimals do.
const MOST_COSINES: usize = 6;

/// Direction of a sum that is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Direction {
    /// A rational turn.
    Turn(Turn),
    /// `arctan(tangent)`, and half a turn more where `opposite`.
    Arctangent {
        /// The tangent of the angle.
        tangent: Form,
        /// Whether the direction has a negative real part.
        opposite: bool,
    },
}

/// `|S|` in closed form; `None` for conductors above 1000, and where more than six cosines would be needed.
pub fn modulus(sum: &PhasorSum) -> Option<Form> {
    if let [only] = sum.collected().as_slice() {
        return Some(Form::rational(num_traits::abs(only.weight.clone())));
    }
    Some(real(&sum.squared_modulus())?.square_root())
}

/// The direction of a sum that is not zero, in closed form where it is a rational turn or has a tangent of
/// degree up to 2.
pub fn direction_of(sum: &PhasorSum) -> Option<Direction> {
    if let Some(turn) = rational_direction(sum) {
        return Some(Direction::Turn(turn));
    }
    let half = BigRational::new(1.into(), 2.into());
    let mirrored = sum.conjugate();
    let re = sum.plus(&mirrored).scaled(&half);
    let im = sum.minus(&mirrored).scaled(&half).turned(&Turn::fraction(3, 4));
    // tan = Im/Re = Im·R'/(Re·R'), with R' the conjugate that makes the denominator rational.
    let conjugates = Conjugates::of(&re)?;
    let partner = match conjugates.images.len() {
        1 => PhasorSum::new(vec![Term { angle: Turn::zero(), weight: BigRational::one() }]),
        2 => re.galois(conjugates.images[1]),
        _ => return None,
    };
    let denominator = real(&re.times(&partner))?.as_rational()?;
    let tangent = real(&im.times(&partner))?.scaled(&denominator.recip());
    Some(Direction::Arctangent { tangent, opposite: evaluate(sum).re < 0.0 })
}

/// S points to a rational turn t iff `e^{2πi·2t} = S/S̄` is a root of unity of its field. The decimals only name the
/// one candidate; whether it is right is decided exactly.
fn rational_direction(sum: &PhasorSum) -> Option<Turn> {
    if let [only] = sum.collected().as_slice() {
        let angle = if only.weight < BigRational::zero() { only.angle.opposite() } else { only.angle.clone() };
        return Some(angle);
    }
    let parts: BigInt = common_denominator(sum).lcm(&BigInt::from(2)) * 2;
    let parts = parts.to_i64().filter(|&parts| parts <= MOST_DIRECTIONS)?;
    let nearest = (evaluate(sum).arg() / std::f64::consts::TAU * parts as f64).round().to_i64()?;
    let candidate = Turn::fraction(nearest, parts);
    let upright = sum.turned(&-&candidate);
    upright.minus(&upright.conjugate()).vanishes().then_some(candidate)
}

/// A real sum in closed form; `None` for conductors above 1000, and where more than six cosines would be needed.
pub fn real(sum: &PhasorSum) -> Option<Form> {
    let conjugates = Conjugates::of(sum)?;
    match conjugates.images.len() {
        1 => Some(Form::rational(trace(sum))),
        degree if degree.is_power_of_two() && degree <= LARGEST_DEGREE => {
            // Every way down is tried where they are few, for the shortest form.
            let ways = if degree > 4 { 1 } else { degree };
            let steps = conjugates.involutions(sum).into_iter().take(ways).filter_map(|unit| quadratic_step(sum, unit));
            steps.min_by_key(|form| (format!("{form:?}").len(), form.clone()))
        }
        _ => Some(cosines(sum)).filter(|form| form.terms().len() <= MOST_COSINES),
    }
}

/// `Q = A + B` with `A = (Q + σQ)/2` and `B = (Q − σQ)/2 = ±√(B²)`, for σ of order 2.
fn quadratic_step(sum: &PhasorSum, unit: i64) -> Option<Form> {
    let half = BigRational::new(1.into(), 2.into());
    let image = sum.galois(unit);
    let (mean, difference) = (sum.plus(&image).scaled(&half), sum.minus(&image).scaled(&half));
    let root = real(&difference.times(&difference))?.square_root();
    let sign = if evaluate(&difference).re < 0.0 { -BigRational::one() } else { BigRational::one() };
    Some(real(&mean)?.plus(&root.scaled(&sign)))
}

/// The maps `t ↦ at` of a sum, and what they do to it.
struct Conjugates {
    /// One a for each different image, the first being 1; no more than one above the largest degree.
    images: Vec<i64>,
}

impl Conjugates {
    fn of(sum: &PhasorSum) -> Option<Self> {
        let conductor = conductor(sum)?;
        let units = (1..=conductor.max(1)).filter(|a| a.gcd(&conductor) == 1).filter_map(|a| i64::try_from(a).ok());
        let units: Vec<i64> = units.collect();
        let modulus = i64::try_from(conductor.max(1)).ok()?;
        let mut images: Vec<(i64, PhasorSum)> = Vec::new();
        // The maps that leave the sum as it is form a group; maps that differ by one of them have the same image.
        let mut fixing = BTreeSet::from([1 % modulus]);
        for &unit in &units {
            if images.iter().any(|(known, _)| fixing.iter().any(|fixed| known * fixed % modulus == unit % modulus)) {
                continue;
            }
            let image = sum.galois(unit);
            match images.iter().find(|(_, known)| known.minus(&image).vanishes()) {
                Some((known, _)) => {
                    let inverse = units.iter().find(|inverse| *inverse * known % modulus == 1 % modulus)?;
                    extend(&mut fixing, unit * inverse % modulus, modulus);
                }
                None => images.push((unit, image)),
            }
            if images.len() > LARGEST_DEGREE {
                break;
            }
        }
        Some(Conjugates { images: images.into_iter().map(|(unit, _)| unit).collect() })
    }

    /// One a of each image with `σ_a ≠ 1` and `σ_a² = 1` on the sum.
    fn involutions(&self, sum: &PhasorSum) -> Vec<i64> {
        let returns = |unit: &i64| sum.galois(*unit).galois(*unit).minus(sum).vanishes();
        self.images[1..].iter().copied().filter(returns).collect()
    }
}

/// The group that a group of units and one more unit generate.
fn extend(group: &mut BTreeSet<i64>, unit: i64, modulus: i64) {
    let mut power = unit;
    while !group.contains(&power) {
        let coset: Vec<i64> = group.iter().map(|element| element * power % modulus).collect();
        group.extend(coset);
        power = power * unit % modulus;
    }
}

/// The common denominator of the angles, where closed forms are looked for.
fn conductor(sum: &PhasorSum) -> Option<u64> {
    common_denominator(sum).to_u64().filter(|&n| n <= LARGEST_CONDUCTOR)
}

fn common_denominator(sum: &PhasorSum) -> BigInt {
    sum.collected().iter().fold(BigInt::one(), |n, term| n.lcm(term.angle.denominator()))
}

/// The mean of all conjugates of a sum: rational, and the sum itself where that is rational; `None` for conductors
/// above 1000.
pub fn mean_of_conjugates(sum: &PhasorSum) -> Option<BigRational> {
    conductor(sum).map(|_| trace(sum))
}

/// The mean of the conjugates, `Σ w μ(n)/φ(n)` over terms of exact order n: the sum itself where it is rational.
fn trace(sum: &PhasorSum) -> BigRational {
    let mean = |term: &Term| {
        let order = term.angle.denominator().to_u64().unwrap_or(1);
        let units = (1..=order).filter(|a| a.gcd(&order) == 1).count();
        &term.weight * BigRational::new(moebius(order).into(), units.into())
    };
    sum.collected().iter().map(mean).sum()
}

fn moebius(number: u64) -> i64 {
    let (mut left, mut sign) = (number, 1);
    for prime in 2..=number {
        if left.is_multiple_of(prime) {
            left /= prime;
            sign = -sign;
            if left.is_multiple_of(prime) {
                return 0;
            }
        }
    }
    sign
}

/// A real sum as `Σ q cos(2πt)`, `0 ≤ t ≤ ½`, shortened by whole polygons.
fn cosines(sum: &PhasorSum) -> Form {
    // The mean with the mirror image is the same number, with like weights at t and −t.
    let half = BigRational::new(1.into(), 2.into());
    let symmetric = PhasorSum::new(sum.plus(&sum.conjugate()).scaled(&half).collected());
    let shortened = without_common_polygons(&symmetric);
    let parts = shortened.collected().into_iter().map(|term| fold(&term));
    parts.fold(Form::rational(BigRational::zero()), |form, part| form.plus(&part))
}

/// `w cos(2πt)` with its angle in the first quarter.
fn fold(term: &Term) -> Form {
    let turns = term.angle.turns();
    let (half, quarter) = (BigRational::new(1.into(), 2.into()), BigRational::new(1.into(), 4.into()));
    let upper = if *turns > half { BigRational::one() - turns } else { turns.clone() };
    let (angle, weight) = if upper > quarter { (half - upper, -&term.weight) } else { (upper, term.weight.clone()) };
    let sixth = BigRational::new(1.into(), 6.into());
    match () {
        () if angle.is_zero() => Form::rational(weight),
        () if angle == quarter => Form::rational(BigRational::zero()),
        () if angle == sixth => Form::rational(weight / BigRational::from_integer(2.into())),
        () => Form::cosine(weight, Turn::new(angle)),
    }
}

/// Takes off polygons whose corners mostly have the same weight, as long as that leaves fewer terms.
fn without_common_polygons(sum: &PhasorSum) -> PhasorSum {
    let mut best = sum.clone();
    let Some(conductor) = conductor(sum) else { return best };
    let primes = (2..=conductor).filter(|p| conductor.is_multiple_of(*p) && (2..*p).all(|d| p % d != 0));
    for prime in primes {
        let corner =
            |first: u64, j: u64| Turn::new(BigRational::new((first + j * conductor / prime).into(), conductor.into()));
        for first in 0..conductor / prime {
            let weights: BTreeMap<Turn, BigRational> =
                best.collected().into_iter().map(|t| (t.angle, t.weight)).collect();
            let at = |j: u64| weights.get(&corner(first, j)).cloned().unwrap_or_else(BigRational::zero);
            let mut counts: BTreeMap<BigRational, usize> = BTreeMap::new();
            (0..prime).for_each(|j| *counts.entry(at(j)).or_default() += 1);
            let Some((common, _)) = counts.into_iter().max_by_key(|(_, count)| *count) else { continue };
            let polygon = (0..prime).map(|j| Term { angle: corner(first, j), weight: common.clone() });
            best = PhasorSum::new(best.minus(&PhasorSum::new(polygon.collect())).collected());
        }
    }
    best
}
