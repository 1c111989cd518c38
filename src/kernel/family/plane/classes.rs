//! When do two classes of parts cancel, `A(y) + e^{iv} B(y)` with `y = e^{iu}`? Where `|A|² = |B|²`, a real polynomial in one unknown.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;

use super::super::circle::{self, Circle, Kind, Polynomial};
use super::super::part::Part;
use super::split::{Split, split};
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction};
use crate::proof::Certificate;

/// The classes A and B, and where they are equally long.
#[derive(Clone, Debug)]
pub struct Classes {
    /// How many times φ and δ enter u, which turns the parts of one class.
    pub u: [BigRational; 2],
    /// How many times φ and δ enter v, which turns the second class against the first.
    pub v: [BigRational; 2],
    /// The places of the parts of the second class among those that are left.
    pub second: Vec<usize>,
    /// Evidence for every coefficient of `|A|² − |B|²`, from the constant one on.
    pub squares: Vec<Certificate>,
    /// Where `|A|² − |B|²` vanishes; none where it is constant.
    pub circle: Option<Circle>,
    /// For which v the sum vanishes at each rational u of the circle, in their order.
    pub meetings: Vec<Meeting>,
    /// For which v, in degrees, it does at each irrational u, in their order: one, for A = B = 0 makes a double zero.
    pub degrees: Vec<f64>,
}

/// For which v the sum vanishes at a rational u at which A and B are equally long.
#[derive(Clone, Debug)]
pub enum Meeting {
    /// For all: A = B = 0, with evidence.
    All(Box<[Certificate; 2]>),
    /// For one rational turn.
    Rational {
        /// Evidence that A is not zero.
        first: Certificate,
        /// The turn.
        turn: Turn,
        /// Evidence that the sum vanishes there.
        certificate: Box<Certificate>,
    },
    /// For one, for which no rational turn was found.
    Once {
        /// Evidence that A is not zero.
        first: Certificate,
        /// The closed form, where it has one.
        exact: Option<Direction>,
        /// In degrees.
        degrees: f64,
    },
}

/// Where the classes cancel; `None` where the parts do not make two.
pub(in super::super) fn solve(parts: &[&Part]) -> Option<Classes> {
    let Split { u, v, classes } = split(parts)?;
    let second = classes[1].iter().map(|(_, place)| *place).collect();
    let classes = classes.map(|class| Class(class.into_iter().map(|(times, at)| (times, &parts[at].sum)).collect()));
    let coefficients = squares(&classes);
    let squares: Vec<Certificate> = coefficients.values().map(PhasorSum::certificate).collect();
    let left = coefficients.into_iter().zip(&squares).filter(|(_, certificate)| !certificate.claims_zero());
    let left: Vec<(i64, PhasorSum)> = left.map(|(coefficient, _)| coefficient).collect();
    let circle = left.last().filter(|(m, _)| *m > 0).map(|(degree, _)| {
        let mirrored = left.iter().rev().filter(|(m, _)| *m > 0).map(|(m, sum)| (degree - m, sum.conjugate()));
        let whole = mirrored.chain(left.iter().map(|(m, sum)| (degree + m, sum.clone())));
        let (exponents, sums) = whole.unzip();
        let [phi, delta] = u.clone();
        circle::arcs_of_polynomial(Polynomial { phi, delta, exponents, sums })
    });
    let meetings = circle.iter().flat_map(Circle::rational_in_order).map(|at| meeting(&classes, at)).collect();
    let middle = |[low, high]: [&BigRational; 2]| (low + high) / BigRational::from_integer(2.into());
    let degrees = circle.iter().flat_map(Circle::irrational).map(|ends| near(&classes, &middle(ends))).collect();
    Some(Classes { u, v, second, squares, circle, meetings, degrees })
}

/// The parts of a class with the power of y before them.
struct Class<'a>(Vec<(i64, &'a PhasorSum)>);

impl Class<'_> {
    fn at(&self, turn: &BigRational) -> PhasorSum {
        let turned = |(times, sum): &(i64, &PhasorSum)| {
            sum.turned(&Turn::new(turn * BigRational::from_integer(BigInt::from(*times)))).terms().to_vec()
        };
        PhasorSum::new(PhasorSum::new(self.0.iter().flat_map(turned).collect()).collected())
    }
}

/// The coefficients of `y^m` in `|A|² − |B|²` for m from 0 on; those of `y^{−m}` are their conjugates.
fn squares([first, second]: &[Class<'_>; 2]) -> BTreeMap<i64, PhasorSum> {
    let mut found: BTreeMap<i64, PhasorSum> = BTreeMap::new();
    let mut add = |class: &Class<'_>, sign: i64| {
        for (low, other) in &class.0 {
            for (high, sum) in class.0.iter().filter(|(high, _)| high >= low) {
                let product = sum.times(&other.conjugate()).scaled(&BigRational::from_integer(sign.into()));
                let all = found.entry(high - low).or_insert_with(|| PhasorSum::new(Vec::new()));
                *all = PhasorSum::new(all.plus(&product).collected());
            }
        }
    };
    add(first, 1);
    add(second, -1);
    found
}

/// `e^{iv} = −A/B`, along `−A·conj(B)`.
fn meeting(classes: &[Class<'_>; 2], at: &BigRational) -> Meeting {
    let [first, second] = classes.each_ref().map(|class| class.at(at));
    if first.vanishes() {
        return Meeting::All(Box::new([first, second].map(|sum| sum.certificate())));
    }
    let quotient = first.times(&second.conjugate()).turned(&Turn::fraction(1, 2));
    let evidence = first.certificate();
    match numbers::direction_of(&quotient) {
        Some(Direction::Turn(turn)) => {
            let certificate = Box::new(first.plus(&second.turned(&turn)).certificate());
            Meeting::Rational { first: evidence, turn, certificate }
        }
        exact => Meeting::Once { first: evidence, exact, degrees: numbers::degrees(numbers::evaluate(&quotient)) },
    }
}

/// v in degrees from 0 to 360, in decimals.
fn near(classes: &[Class<'_>; 2], at: &BigRational) -> f64 {
    let [first, second] = classes.each_ref().map(|class| numbers::evaluate(&class.at(at)));
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
        self.squares.iter().all(Certificate::claims_zero)
    }

    /// The rational turns of u at which the classes are equally long, each with its v.
    pub fn rational(&self) -> impl Iterator<Item = (&BigRational, &Meeting)> {
        self.circle.iter().flat_map(Circle::rational_in_order).zip(&self.meetings)
    }

    /// Between which turns each irrational u is, narrowly, with its v in degrees.
    pub fn irrational(&self) -> impl Iterator<Item = ([&BigRational; 2], f64)> {
        self.circle.iter().flat_map(Circle::irrational).zip(self.degrees.iter().copied())
    }
}

impl Circle {
    /// The zeros that are rational turns, as they follow each other on the arcs.
    pub(super) fn rational_in_order(&self) -> impl Iterator<Item = &BigRational> {
        self.arcs.iter().filter_map(|arc| match &arc.kind {
            Kind::Rational { at, .. } => Some(at),
            Kind::Free | Kind::Monotone | Kind::Crossing { .. } | Kind::Open => None,
        })
    }
}
