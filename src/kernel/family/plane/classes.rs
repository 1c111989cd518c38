//! When do two classes of parts cancel, `A(y) + e^{iv} B(y)` with `y = e^{iu}`? Where `|A|² = |B|²`, a real polynomial in one unknown.

use num_rational::BigRational;

use super::super::circle::{self, Circle};
use super::super::part::Part;
use super::laurent::{Laurent, conjugate_times, judged_half, less, mirrored_whole, value};
use super::roots::Root;
use super::split::{Split, split};
use crate::exact::Turn;
use crate::numbers::{self, Direction};
use crate::proof::{Certificate, ClassesClaim, MeetingClaim};

/// The classes A and B, and where they are equally long.
#[derive(Clone, Debug)]
pub struct Classes {
    /// How many times φ and δ enter u, which turns the parts of one class.
    pub u: [BigRational; 2],
    /// How many times φ and δ enter v, which turns the second class against the first.
    pub v: [BigRational; 2],
    /// Where `|A|² − |B|²` vanishes; none where it is constant.
    pub circle: Option<Circle>,
    /// What the checker is told: what is said of the v at which the sum vanishes at each rational u of the circle among it, in their order.
    pub claim: ClassesClaim,
    /// These v, one each; none where it vanishes for all.
    pub at: Vec<Option<Vec<Root>>>,
    /// For which v, in degrees, it does at each irrational u, in their order: one, for A = B = 0 makes a double zero.
    pub degrees: Vec<f64>,
}

/// Where the classes cancel; `None` where the parts do not make two.
pub(in super::super) fn solve(parts: &[&Part]) -> Option<Classes> {
    let Split { u, v, classes } = split(parts)?;
    let second = classes[1].iter().map(|(_, place)| *place).collect();
    let classes =
        classes.map(|class| class.into_iter().map(|(times, at)| (times, parts[at].sum.clone())).collect::<Laurent>());
    let [first, second_class] = &classes;
    let whole = less(conjugate_times(first, first), &conjugate_times(second_class, second_class));
    let (squares, left) = judged_half(whole);
    let has_zeros = left.last().is_some_and(|(degree, _)| *degree > 0);
    let circle = has_zeros.then(|| circle::arcs_of_polynomial(mirrored_whole(&u, left)));
    let rational = circle.iter().flat_map(Circle::rational_in_order);
    let (meetings, at) = rational.map(|at| meeting(&classes, at)).unzip();
    let middle = |[low, high]: [&BigRational; 2]| (low + high) / BigRational::from_integer(2.into());
    let degrees = circle.iter().flat_map(Circle::irrational).map(|ends| near(&classes, &middle(ends))).collect();
    let ([phi, delta], of_circle) = (u.clone(), circle.as_ref().map(|circle| circle.claim.clone()));
    let claim = ClassesClaim { phi, delta, second, squares, circle: of_circle, meetings };
    Some(Classes { u, v, circle, claim, at, degrees })
}

/// `e^{iv} = −A/B`, along `−A·conj(B)`; none where all v are.
fn meeting(classes: &[Laurent; 2], at: &BigRational) -> (MeetingClaim, Option<Vec<Root>>) {
    let [first, second] = classes.each_ref().map(|class| value(class, at));
    if first.vanishes() {
        let certificates = Box::new([first, second].map(|sum| sum.certificate()));
        return (MeetingClaim::All { certificates }, None);
    }
    let quotient = first.times(&second.conjugate()).turned(&Turn::fraction(1, 2));
    let evidence = first.certificate();
    let (claim, root) = match numbers::direction_of(&quotient) {
        Some(Direction::Turn(turn)) => {
            let certificate = Box::new(first.plus(&second.turned(&turn)).certificate());
            (MeetingClaim::Rational { first: evidence, turn: turn.turns().clone(), certificate }, Root::at(turn))
        }
        exact => {
            let degrees = numbers::degrees(numbers::evaluate(&quotient));
            (MeetingClaim::Once { first: evidence }, Root { exact, degrees })
        }
    };
    (claim, Some(vec![root]))
}

/// v in degrees from 0 to 360, in decimals.
fn near(classes: &[Laurent; 2], at: &BigRational) -> f64 {
    let [first, second] = classes.each_ref().map(|class| numbers::evaluate(&value(class, at)));
    numbers::degrees(-first * second.conj()).rem_euclid(360.0)
}

impl Classes {
    /// Whether they cancel nowhere.
    pub(in super::super) fn is_never(&self) -> bool {
        match &self.circle {
            Some(circle) => circle.is_free(),
            None => !self.is_curve(),
        }
    }

    /// Whether A and B are equally long for every u: then each has one v, or all where A = B = 0.
    pub fn is_curve(&self) -> bool {
        self.claim.squares.iter().all(Certificate::claims_zero)
    }

    /// The rational turns of u at which the classes are equally long, each with its v; none where all are.
    pub fn rational(&self) -> impl Iterator<Item = (&BigRational, &Option<Vec<Root>>)> {
        self.circle.iter().flat_map(Circle::rational_in_order).zip(&self.at)
    }

    /// Between which turns each irrational u is, narrowly, with its v in degrees.
    pub fn irrational(&self) -> impl Iterator<Item = ([&BigRational; 2], f64)> {
        self.circle.iter().flat_map(Circle::irrational).zip(self.degrees.iter().copied())
    }
}
