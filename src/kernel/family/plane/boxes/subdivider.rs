//! Into which boxes is the torus cut? In two, across its longer side, until each is known or the count of boxes ends.

use std::collections::VecDeque;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::super::super::part::Part;
use super::Boxes;
use super::evaluator::{Evaluator, FINEST, dyadic};
use super::torus::Torus;
use crate::exact::PhasorSum;
use crate::proof::{BoxZeroClaim, BoxesClaim};

/// More boxes are not looked at for one sum.
const MOST_BOXES: usize = 2000;
/// About a zero few boxes wait at once; along a curve there are more and more.
const MOST_WAITING: usize = 800;
/// About a zero boxes with half-widths from `2^−3` to this power of two are tried.
const LEAST_HALF: u32 = 14;
/// In turns: points that decimals do not tell apart.
const SAME: f64 = 1e-8;

/// More open regions are no answer, nor is more than this part of the torus.
const MOST_OPEN: usize = 16;
const LARGEST_OPEN: i64 = 16;

/// From `index · 2^−level` of a turn on, so wide, along s and t.
#[derive(Clone, Copy)]
struct Place {
    index: [i64; 2],
    level: [u32; 2],
}

#[derive(Clone, Copy)]
enum Known {
    Free,
    Zero,
    Open,
    /// Cut across this axis; the halves stand here and next.
    Cut(usize, usize),
}

impl Place {
    /// The two halves.
    fn halves(self, axis: usize) -> [Place; 2] {
        [0, 1].map(|half| {
            let mut place = self;
            place.index[axis] = 2 * place.index[axis] + half;
            place.level[axis] += 1;
            place
        })
    }

    /// In units of `2^−(FINEST + 1)` of a turn.
    fn middle(self) -> [i64; 2] {
        [0, 1].map(|axis: usize| (2 * self.index[axis] + 1) << (FINEST - self.level[axis]))
    }

    fn ends(self) -> [[BigRational; 2]; 2] {
        [0, 1].map(|axis: usize| {
            [0, 1].map(|end| BigRational::new((self.index[axis] + end).into(), BigInt::one() << self.level[axis]))
        })
    }
}

/// Where the parts cancel; `None` where an unknown enters too many times, or where too much stays open.
pub(in super::super::super) fn solve(parts: &[&Part]) -> Option<Boxes> {
    let torus = Torus::of(parts)?;
    let found = cut(&Evaluator::new(&torus), &torus);
    let area: BigRational = found.open.iter().map(|[s, t]| (&s[1] - &s[0]) * (&t[1] - &t[0])).sum();
    let is_answer = found.open.len() <= MOST_OPEN && area <= BigRational::new(1.into(), LARGEST_OPEN.into());
    is_answer.then_some(found)
}

/// Cuts the torus.
fn cut(ground: &Evaluator, torus: &Torus) -> Boxes {
    let mut subdivider = Subdivider { ground, torus, zeros: Vec::new(), near: Vec::new(), failed: Vec::new() };
    let mut places = vec![Place { index: [0, 0], level: [0, 0] }];
    let mut known = vec![Known::Open];
    let mut waiting = VecDeque::from([0]);
    let degrees = torus.degrees().map(|degree| degree as f64);
    while let Some(at) = waiting.pop_front() {
        let place = places[at];
        if places.len() > MOST_BOXES || waiting.len() > MOST_WAITING {
            continue;
        }
        if let Some(found) = subdivider.known(place) {
            known[at] = found;
            continue;
        }
        let [s, t] = [0, 1].map(|axis: usize| degrees[axis] / f64::from(1_u32 << place.level[axis]));
        let axis = usize::from(t > s);
        if place.level[axis] < FINEST {
            known[at] = Known::Cut(axis, places.len());
            for half in place.halves(axis) {
                waiting.push_back(places.len());
                places.push(half);
                known.push(Known::Open);
            }
        }
    }
    // A box that was open may be within that of a zero that was found later.
    for (place, known) in places.iter().zip(&mut known) {
        if matches!(known, Known::Open) && subdivider.is_within_one(*place) {
            *known = Known::Zero;
        }
    }
    let open = places.iter().zip(&known).filter(|(_, known)| matches!(known, Known::Open));
    let open = joined(open.map(|(place, _)| place.ends()).collect());
    let [phi, delta] = torus.times.clone();
    let claim = BoxesClaim { phi, delta, tree: written(&known), zeros: subdivider.zeros };
    Boxes { claim, near: subdivider.near, open }
}

/// In the order in which the boxes are cut.
fn written(known: &[Known]) -> String {
    let (mut tree, mut waiting) = (String::new(), vec![0]);
    while let Some(at) = waiting.pop() {
        tree.push(match known[at] {
            Known::Free => '0',
            Known::Zero => '1',
            Known::Open => '?',
            Known::Cut(axis, first) => {
                waiting.extend([first + 1, first]);
                if axis == 0 { 's' } else { 't' }
            }
        });
    }
    tree
}

/// Boxes that touch as one that is around both.
fn joined(boxes: Vec<[[BigRational; 2]; 2]>) -> Vec<[[BigRational; 2]; 2]> {
    let mut joined: Vec<[[BigRational; 2]; 2]> = Vec::new();
    for mut new in boxes {
        let touches = |a: &[[BigRational; 2]; 2], b: &[[BigRational; 2]; 2]| {
            a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
        };
        while let Some(at) = joined.iter().position(|other| touches(other, &new)) {
            let other = joined.swap_remove(at);
            for (new, other) in new.iter_mut().zip(other) {
                let [low, high] = other;
                *new = [low.min(new[0].clone()), high.max(new[1].clone())];
            }
        }
        joined.push(new);
    }
    joined.sort();
    joined
}

struct Subdivider<'a> {
    ground: &'a Evaluator,
    torus: &'a Torus,
    zeros: Vec<BoxZeroClaim>,
    /// The same in decimals.
    near: Vec<[f64; 2]>,
    /// Where decimals have a zero, and no box about it holds one alone.
    failed: Vec<[f64; 2]>,
}

impl Subdivider<'_> {
    fn known(&mut self, place: Place) -> Option<Known> {
        if self.is_within_one(place) {
            return Some(Known::Zero);
        }
        if self.ground.is_free(place.middle(), place.level.map(|level| level + 1)) {
            return Some(Known::Free);
        }
        self.look_for_one(place);
        self.is_within_one(place).then_some(Known::Zero)
    }

    fn is_within_one(&self, place: Place) -> bool {
        let two = BigRational::from_integer(2.into());
        let of = |[low, high]: &[BigRational; 2]| ((low + high) / &two, (high - low) / &two);
        let ends = place.ends();
        let near = place.middle().map(|middle| middle as f64 / (1_u64 << (FINEST + 1)) as f64);
        self.zeros.iter().zip(&self.near).filter(|(_, zero)| far(**zero, near) < 0.26).any(|(zero, _)| {
            ends.iter().zip([&zero.s, &zero.t]).all(|(ends, middle)| {
                let (here, half) = of(ends);
                apart(&here, middle) + half <= zero.reach
            })
        })
    }

    /// Looks for a zero that Newton's method finds from a box, and for a box about it.
    fn look_for_one(&mut self, place: Place) {
        let near = place.middle().map(|middle| middle as f64 / (1_u64 << (FINEST + 1)) as f64);
        let Some(zero) = self.torus.newton(near).map(|zero| zero.map(|turns| turns.rem_euclid(1.0))) else { return };
        let wide = f64::from(1_u32 << place.level[0].min(place.level[1])).recip();
        let is_new = |other: &[f64; 2]| far(*other, zero) > SAME;
        if far(zero, near) > 2.0 * wide || !self.near.iter().chain(&self.failed).all(is_new) {
            return;
        }
        let exact = self.torus.rational(zero);
        let certificate = exact.as_ref().map(|at| PhasorSum::certificate(&self.torus.at(at)));
        let middle = exact.unwrap_or_else(|| zero.map(dyadic));
        for half in 3..=LEAST_HALF {
            let reach = BigRational::new(BigInt::one(), BigInt::one() << half);
            let is_apart = self.zeros.iter().all(|other| {
                let widths = &other.reach + &reach;
                [&other.s, &other.t].into_iter().zip(&middle).any(|(a, b)| apart(a, b) > widths)
            });
            if is_apart && self.ground.holds_one(&middle, half, certificate.is_some()) {
                let [s, t] = middle;
                self.zeros.push(BoxZeroClaim { s, t, reach, certificate });
                self.near.push(zero);
                return;
            }
        }
        self.failed.push(zero);
    }
}

/// How far two numbers of turns are from each other, modulo a turn.
fn apart(one: &BigRational, other: &BigRational) -> BigRational {
    let apart = one - other;
    let apart = &apart - apart.floor();
    let back = BigRational::one() - &apart;
    apart.min(back)
}

fn far(one: [f64; 2], other: [f64; 2]) -> f64 {
    let each = one.iter().zip(other).map(|(a, b)| (a - b).rem_euclid(1.0)).map(|apart| apart.min(1.0 - apart));
    each.fold(0.0, f64::max)
}
