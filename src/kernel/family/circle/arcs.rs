//! Into which arcs is the circle cut, so that each says how often the sum vanishes on it?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::curve::{Curve, Evaluator, inside, multiples};
use super::polynomial::Polynomial;
use super::rational::{self, multiplicity};
use crate::exact::Turn;
use crate::numbers;
use crate::proof::{ArcClaim, CircleClaim};

/// A sum over the whole circle.
#[derive(Clone, Debug)]
pub struct Circle {
    /// What the arcs are about: the sum, or a factor of it.
    pub polynomial: Polynomial,
    /// The arcs, one after another, over one turn.
    pub claim: CircleClaim,
    /// Between which turns the zero of each crossing is.
    pub near: Vec<[BigRational; 2]>,
}

/// More values are not enclosed for one sum.
const MOST_VALUES: usize = 6000;
/// A crossing is enclosed to `2^−REFINED` of a turn.
const REFINED: u32 = 44;
/// A crossing that is written down is no wider than this part of a turn.
const WIDEST_CROSSING: u32 = 12;
/// Bits beyond those that tell two candidates apart.
const SPARE_BITS: u64 = 64;
const FEWEST_BITS: u64 = 128;
/// Turns with more digits are not told apart.
const MOST_BITS: u64 = 480;

/// Cuts the circle.
pub(super) fn cover(polynomial: Polynomial) -> Circle {
    let finest = polynomial.moduli().iter().map(BigInt::bits).max().unwrap_or(1);
    let bits = (2 * finest + SPARE_BITS).clamp(FEWEST_BITS, MOST_BITS).next_multiple_of(32) as u32;
    let mirrored = polynomial.mirrored();
    let ground = Evaluator::new(&polynomial, bits);
    let cutter = Subdivider {
        plain: ground.derivative(0),
        line: mirrored.is_some().then(|| [ground.centred(), ground.slope()]),
        narrowest: BigRational::new(BigInt::one(), BigInt::one() << (bits / 2)),
        ground: &ground,
        polynomial: &polynomial,
    };
    let (mut found, mut near) = (Vec::new(), Vec::new());
    let rational = cutter.around_rational_zeros();
    let from = rational.first().map_or_else(BigRational::zero, |first| first.from.clone());
    let end = &from + BigRational::one();
    let mut at = from.clone();
    for zero in rational {
        cutter.cut([at, zero.from], &mut found, &mut near);
        at = zero.arc.to().clone();
        found.push(zero.arc);
    }
    cutter.cut([at, end], &mut found, &mut near);
    let mirrored = mirrored.filter(|_| found.iter().any(rests_on_line)).unwrap_or_default();
    let (phi, delta) = (polynomial.phi.clone(), polynomial.delta.clone());
    let claim = CircleClaim { phi, delta, divided: None, bits, mirrored, from, arcs: joined(found) };
    Circle { polynomial, claim, near }
}

/// Whether what an arc says is of a sum that stays on a line.
pub(super) fn rests_on_line(arc: &ArcClaim) -> bool {
    match arc {
        ArcClaim::Monotone { .. } | ArcClaim::Crossing { .. } => true,
        ArcClaim::Free { .. } | ArcClaim::Rational { .. } | ArcClaim::Open { .. } => false,
    }
}

/// Open arcs that touch as one.
pub(super) fn joined(arcs: Vec<ArcClaim>) -> Vec<ArcClaim> {
    let mut joined: Vec<ArcClaim> = Vec::new();
    for arc in arcs {
        match (joined.last_mut(), arc) {
            (Some(ArcClaim::Open { to }), ArcClaim::Open { to: next }) => *to = next,
            (_, arc) => joined.push(arc),
        }
    }
    joined
}

/// A rational zero with the arc about it.
struct Rational {
    from: BigRational,
    arc: ArcClaim,
}

struct Subdivider<'a> {
    polynomial: &'a Polynomial,
    ground: &'a Evaluator,
    plain: Curve<'a>,
    /// The centred sum and its derivative, where they stay on a line.
    line: Option<[Curve<'a>; 2]>,
    narrowest: BigRational,
}

impl Subdivider<'_> {
    /// Arcs about the rational zeros that decimals propose, none touching another.
    fn around_rational_zeros(&self) -> Vec<Rational> {
        let proposed = rational::propose(self.polynomial);
        let zeros: &BTreeMap<Turn, u32> = &proposed.rational;
        let decimal = |turn: &Turn| numbers::float(turn.turns());
        let places: Vec<f64> = proposed.places.iter().copied().chain(zeros.keys().map(decimal)).collect();
        let about = |(turn, times): (&Turn, &u32)| {
            let here = decimal(turn);
            let apart = places.iter().map(|place| (place - here).abs()).map(|apart| apart.min(1.0 - apart));
            let nearest = apart.filter(|apart| *apart > 2e-6).fold(0.5_f64, f64::min);
            let top = self.ground.derivative(*times);
            let mut half = BigRational::new(1.into(), 8.into());
            while half > self.narrowest {
                let ends = [turn.turns() - &half, turn.turns() + &half];
                if numbers::float(&half) < nearest / 2.0 && top.is_free(ends.each_ref()) {
                    let [from, to] = ends;
                    return Some(Rational { from, arc: self.rational(to, turn.turns().clone(), *times) });
                }
                half /= BigRational::from_integer(2.into());
            }
            None
        };
        let mut kept: Vec<Rational> = Vec::new();
        let one = BigRational::one();
        for zero in zeros.iter().filter_map(about) {
            let is_apart = kept.last().is_none_or(|last: &Rational| *last.arc.to() <= zero.from)
                && kept.first().is_none_or(|first: &Rational| *zero.arc.to() <= &first.from + &one);
            if is_apart {
                kept.push(zero);
            }
        }
        kept
    }

    fn rational(&self, to: BigRational, at: BigRational, times: u32) -> ArcClaim {
        let certificates = (0..times).map(|i| self.polynomial.derivative(i, &at).certificate()).collect();
        ArcClaim::Rational { to, at, certificates }
    }

    /// Cuts an arc until each piece is known, or the count ends.
    fn cut(&self, ends: [BigRational; 2], found: &mut Vec<ArcClaim>, near: &mut Vec<[BigRational; 2]>) {
        let mut waiting = vec![ends];
        while let Some([low, high]) = waiting.pop() {
            if low >= high {
                continue;
            }
            if let Some(known) = self.known([&low, &high], near) {
                found.extend(known);
                continue;
            }
            if &high - &low <= self.narrowest || self.ground.spent.get() > MOST_VALUES {
                found.push(ArcClaim::Open { to: high });
                continue;
            }
            let between = inside([&low, &high]);
            waiting.push([between.clone(), high]);
            waiting.push([low, between]);
        }
    }

    /// What is known of a whole arc.
    fn known(&self, ends: [&BigRational; 2], near: &mut Vec<[BigRational; 2]>) -> Option<Vec<ArcClaim>> {
        let to = || ends[1].clone();
        if self.plain.is_free(ends) {
            return Some(vec![ArcClaim::Free { to: to() }]);
        }
        if let Some(arc) = self.overlooked(ends) {
            return Some(vec![arc]);
        }
        let [centred, slope] = self.line.as_ref()?;
        if !slope.is_free(ends) {
            return None;
        }
        if self.side(centred, ends)? {
            return Some(vec![ArcClaim::Monotone { to: to() }]);
        }
        let (arcs, zero) = self.crossing(centred, ends)?;
        near.push(zero);
        Some(arcs)
    }

    /// Whether two turns are on the same side of 0.
    fn side(&self, centred: &Curve<'_>, [low, high]: [&BigRational; 2]) -> Option<bool> {
        centred.at(low).sign_against(&centred.at(high))
    }

    /// A rational zero in an arc so narrow that each modulus has one candidate at most.
    fn overlooked(&self, ends: [&BigRational; 2]) -> Option<ArcClaim> {
        let moduli = self.polynomial.moduli();
        let within: Vec<([BigInt; 2], &BigInt)> =
            moduli.iter().filter_map(|modulus| Some((multiples(ends, modulus)?, modulus))).collect();
        if within.iter().any(|([first, last], _)| first != last) {
            return None;
        }
        within.into_iter().find_map(|([first, _], modulus)| {
            let at = BigRational::new(first, modulus.clone());
            let times = multiplicity(self.polynomial, &at)?;
            self.ground.derivative(times).is_free(ends).then(|| self.rational(ends[1].clone(), at, times))
        })
    }

    /// Where the centred sum changes its side and moves one way: halved until no candidate is inside, with the zero more narrowly.
    fn crossing(&self, centred: &Curve<'_>, ends: [&BigRational; 2]) -> Option<(Vec<ArcClaim>, [BigRational; 2])> {
        let moduli = self.polynomial.moduli();
        let below = |digits: u32| BigRational::new(BigInt::one(), BigInt::one() << digits);
        let (widest, refined) = (below(WIDEST_CROSSING), below(REFINED).max(self.narrowest.clone()));
        let mut zero = ends.map(Clone::clone);
        let mut written = None;
        while written.is_none() || &zero[1] - &zero[0] > refined {
            let has_none = || moduli.iter().all(|modulus| multiples(zero.each_ref(), modulus).is_none());
            if written.is_none() && &zero[1] - &zero[0] <= widest && has_none() {
                written = Some(zero.clone());
            }
            if &zero[1] - &zero[0] <= self.narrowest {
                break;
            }
            let between = inside(zero.each_ref());
            if self.side(centred, [&zero[0], &between])? { zero[0] = between } else { zero[1] = between }
        }
        Some((crossed(ends, written?, &self.line.as_ref()?[1])?, zero))
    }
}

/// An arc with a crossing in it cut down to the narrow one that holds it; none where that is not known to move one way everywhere.
pub(super) fn crossed(
    [from, to]: [&BigRational; 2],
    [low, high]: [BigRational; 2],
    slope: &Curve<'_>,
) -> Option<Vec<ArcClaim>> {
    let pieces = [
        (from.clone(), ArcClaim::Monotone { to: low.clone() }),
        (low, ArcClaim::Crossing { to: high.clone() }),
        (high, ArcClaim::Monotone { to: to.clone() }),
    ];
    let arcs = pieces.into_iter().filter(|(from, arc)| from < arc.to());
    arcs.map(|(from, arc)| slope.is_free([&from, arc.to()]).then_some(arc)).collect()
}
