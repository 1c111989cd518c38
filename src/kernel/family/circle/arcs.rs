//! Into which arcs is the circle cut, so that each says how often the sum vanishes on it?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::curve::{Curve, Evaluator, inside, multiples};
use super::factor::Factor;
use super::polynomial::Polynomial;
use super::rational::{self, multiplicity};
use crate::exact::Turn;
use crate::numbers;
use crate::proof::Certificate;

/// A sum over the whole circle.
#[derive(Clone, Debug)]
pub struct Circle {
    /// What the arcs are about: the sum, or a factor of it.
    pub polynomial: Polynomial,
    /// Evidence that the sum vanishes where that factor does; none where the arcs are about the sum.
    pub factor: Option<Factor>,
    /// Enclosures with this many bits decide.
    pub bits: u32,
    /// Evidence that the sum, centred, stays on one line; none where no arc needs it.
    pub mirrored: Vec<Certificate>,
    /// Where the first arc begins, in turns of u.
    pub from: BigRational,
    /// The arcs, one after another, over one turn.
    pub arcs: Vec<Arc>,
}

/// From where the one before ends.
#[derive(Clone, Debug)]
pub struct Arc {
    /// Where it ends, in turns of u.
    pub to: BigRational,
    /// What is known of it.
    pub kind: Kind,
}

/// How often the sum vanishes on an arc.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Never: it keeps away from 0.
    Free,
    /// Never: on its line it moves one way, and does not change its side.
    Monotone,
    /// Once, at no rational turn: on its line it moves one way, and changes its side.
    Crossing {
        /// The zero is between these.
        near: [BigRational; 2],
    },
    /// At this turn alone, as many times as there are certificates.
    Rational {
        /// The turn.
        at: BigRational,
        /// Evidence that the sum and its first derivatives vanish there.
        certificates: Vec<Certificate>,
    },
    /// Not known: the count of enclosed values ended here.
    Open,
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
    let mut found: Vec<Arc> = Vec::new();
    let rational = cutter.around_rational_zeros();
    let from = rational.first().map_or_else(BigRational::zero, |first| first.ends[0].clone());
    let end = &from + BigRational::one();
    let mut at = from.clone();
    for zero in rational {
        cutter.cut([at, zero.ends[0].clone()], &mut found);
        at = zero.ends[1].clone();
        found.push(Arc { to: at.clone(), kind: zero.kind });
    }
    cutter.cut([at, end], &mut found);
    let on_line = |arc: &Arc| match arc.kind {
        Kind::Monotone | Kind::Crossing { .. } => true,
        Kind::Free | Kind::Rational { .. } | Kind::Open => false,
    };
    let mirrored = mirrored.filter(|_| found.iter().any(on_line)).unwrap_or_default();
    Circle { factor: None, bits, mirrored, from, arcs: joined(found), polynomial }
}

/// Open arcs that touch as one.
pub(super) fn joined(arcs: Vec<Arc>) -> Vec<Arc> {
    let mut joined: Vec<Arc> = Vec::new();
    for arc in arcs {
        match (joined.last_mut(), &arc.kind) {
            (Some(Arc { to, kind: Kind::Open }), Kind::Open) => *to = arc.to,
            _ => joined.push(arc),
        }
    }
    joined
}

/// A rational zero with the arc about it.
struct Rational {
    ends: [BigRational; 2],
    kind: Kind,
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
                    return Some(Rational { ends, kind: self.rational(turn.turns(), *times) });
                }
                half /= BigRational::from_integer(2.into());
            }
            None
        };
        let mut kept: Vec<Rational> = Vec::new();
        let one = BigRational::one();
        for zero in zeros.iter().filter_map(about) {
            let is_apart = kept.last().is_none_or(|last: &Rational| last.ends[1] <= zero.ends[0])
                && kept.first().is_none_or(|first: &Rational| zero.ends[1] <= &first.ends[0] + &one);
            if is_apart {
                kept.push(zero);
            }
        }
        kept
    }

    fn rational(&self, at: &BigRational, times: u32) -> Kind {
        let certificates = (0..times).map(|i| self.polynomial.derivative(i, at).certificate()).collect();
        Kind::Rational { at: at.clone(), certificates }
    }

    /// Cuts an arc until each piece is known, or the count ends.
    fn cut(&self, ends: [BigRational; 2], found: &mut Vec<Arc>) {
        let mut waiting = vec![ends];
        while let Some([low, high]) = waiting.pop() {
            if low >= high {
                continue;
            }
            if let Some(known) = self.known([&low, &high]) {
                found.extend(known);
                continue;
            }
            if &high - &low <= self.narrowest || self.ground.spent.get() > MOST_VALUES {
                found.push(Arc { to: high, kind: Kind::Open });
                continue;
            }
            let between = inside([&low, &high]);
            waiting.push([between.clone(), high]);
            waiting.push([low, between]);
        }
    }

    /// What is known of a whole arc.
    fn known(&self, ends: [&BigRational; 2]) -> Option<Vec<Arc>> {
        let whole = |kind: Kind| Some(vec![Arc { to: ends[1].clone(), kind }]);
        if self.plain.is_free(ends) {
            return whole(Kind::Free);
        }
        if let Some(kind) = self.overlooked(ends) {
            return whole(kind);
        }
        let [centred, slope] = self.line.as_ref()?;
        if !slope.is_free(ends) {
            return None;
        }
        if self.side(centred, ends)? { whole(Kind::Monotone) } else { self.crossing(centred, ends) }
    }

    /// Whether two turns are on the same side of 0.
    fn side(&self, centred: &Curve<'_>, [low, high]: [&BigRational; 2]) -> Option<bool> {
        centred.at(low).sign_against(&centred.at(high))
    }

    /// A rational zero in an arc so narrow that each modulus has one candidate at most.
    fn overlooked(&self, ends: [&BigRational; 2]) -> Option<Kind> {
        let moduli = self.polynomial.moduli();
        let within: Vec<([BigInt; 2], &BigInt)> =
            moduli.iter().filter_map(|modulus| Some((multiples(ends, modulus)?, modulus))).collect();
        if within.iter().any(|([first, last], _)| first != last) {
            return None;
        }
        within.into_iter().find_map(|([first, _], modulus)| {
            let at = BigRational::new(first, modulus.clone());
            let times = multiplicity(self.polynomial, &at)?;
            self.ground.derivative(times).is_free(ends).then(|| self.rational(&at, times))
        })
    }

    /// Where the centred sum changes its side and moves one way: halved until no candidate is inside.
    fn crossing(&self, centred: &Curve<'_>, ends: [&BigRational; 2]) -> Option<Vec<Arc>> {
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
        crossed(ends, written?, Kind::Crossing { near: zero }, &self.line.as_ref()?[1])
    }
}

/// An arc with a crossing in it cut down to the narrow one that holds it; none where that is not known to move one way everywhere.
pub(super) fn crossed(
    [from, to]: [&BigRational; 2],
    [low, high]: [BigRational; 2],
    crossing: Kind,
    slope: &Curve<'_>,
) -> Option<Vec<Arc>> {
    let pieces = [
        (from.clone(), low.clone(), Kind::Monotone),
        (low, high.clone(), crossing),
        (high, to.clone(), Kind::Monotone),
    ];
    let arcs = pieces.into_iter().filter(|(from, to, _)| from < to);
    arcs.map(|(from, to, kind)| slope.is_free([&from, &to]).then_some(Arc { to, kind })).collect()
}
