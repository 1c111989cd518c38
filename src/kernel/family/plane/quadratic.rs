//! When do three classes of parts cancel, `A(y) + B(y) x + C(y) x²` with `x = e^{iv}` and `y = e^{iu}`? Where a real polynomial in y vanishes.
//!
//! Theory, section 17: with `D = |A|² − |C|²` and `E = conj(A) B − C conj(B)` every zero has `D + E x = 0`, so that `D² = |E|²`. Where D = 0
//! throughout, that has double zeros alone, and E is solved in its place.

use num_rational::BigRational;

use super::super::circle::{self, Circle};
use super::super::part::Part;
use super::laurent::{Laurent, conjugate_times, judged, judged_half, less, mirrored_whole, polynomial, value};
use super::roots::{Root, mirrored, near, roots};
use super::split::{Split, three};
use super::triangle::enclosed_sign;
use crate::exact::PhasorSum;
use crate::proof::{Certificate, QuadraticClaim, TwistClaim};

/// The classes A, B and C, and where they cancel.
#[derive(Clone, Debug)]
pub struct Quadratic {
    /// How many times φ and δ enter u, which turns the parts of one class.
    pub u: [BigRational; 2],
    /// How many times φ and δ enter v, which turns B against A, and C against B.
    pub v: [BigRational; 2],
    /// Where `D² − |E|²` vanishes; none where it is constant.
    pub circle: Option<Circle>,
    /// What the checker is told: what is said of the v at which the sum vanishes at each rational u of the circle among it, in their order.
    pub claim: QuadraticClaim,
    /// These v; none where it vanishes for all.
    pub at: Vec<Option<Vec<Root>>>,
    /// For which v, in degrees, it does at each irrational u, in their order: one where D is not 0, else none or two.
    pub degrees: Vec<Vec<f64>>,
}

/// Where the classes cancel; `None` where the parts do not make three equally far apart.
pub(in super::super) fn solve(parts: &[&Part]) -> Option<Quadratic> {
    let Split { u, v, classes } = three(parts)?;
    let polynomials = classes
        .each_ref()
        .map(|class| -> Laurent { class.iter().map(|(times, place)| (*times, parts[*place].sum.tidied())).collect() });
    let [difference, twist] = eliminants(&polynomials);
    let whole = less(conjugate_times(&difference, &difference), &conjugate_times(&twist, &twist));
    let (coefficients, left) = judged_half(whole);
    let degree = left.last().map(|(degree, _)| *degree);
    let is_twisted = degree.is_some_and(|degree| degree > 0) && difference.values().all(PhasorSum::vanishes);
    let lengths = match degree.is_none() || is_twisted {
        true => difference.iter().filter(|(power, _)| **power >= 0).map(|(_, sum)| sum.certificate()).collect(),
        false => Vec::new(),
    };
    let (circle, twist) = match degree.filter(|degree| *degree > 0) {
        None => (None, None),
        Some(_) if is_twisted => {
            let (circle, twist) = twisted(&u, &polynomials, twist);
            (Some(circle), Some(twist))
        }
        Some(_) => (Some(circle::arcs_of_polynomial(mirrored_whole(&u, left))), None),
    };
    let at = |turn: &BigRational| polynomials.each_ref().map(|polynomial| value(polynomial, turn));
    let rational = circle.iter().flat_map(Circle::rational_in_order);
    let roots: Option<Vec<_>> = rational.map(|turn| roots(&at(turn))).collect();
    let (roots, zeros) = roots?.into_iter().unzip();
    let middle = |[low, high]: [&BigRational; 2]| (low + high) / BigRational::from_integer(2.into());
    let irrational = circle.iter().flat_map(Circle::irrational).map(|ends| at(&middle(ends)));
    let degrees = match &twist {
        None => irrational.map(|sums| vec![near(&sums)]).collect(),
        Some(twist) => irrational.zip(&twist.signs).map(|(sums, sign)| mirrored(&sums, sign)).collect(),
    };
    let [_, second, third] = classes.map(|class| class.into_iter().map(|(_, place)| place).collect());
    let ([phi, delta], of_circle) = (u.clone(), circle.as_ref().map(|circle| circle.claim.clone()));
    let claim = QuadraticClaim { phi, delta, second, third, coefficients, lengths, twist, circle: of_circle, roots };
    Some(Quadratic { u, v, circle, claim, at: zeros, degrees })
}

/// The zeros of E on the circle, with the sign of `4|A|² − |B|²` at the irrational ones; where it is not found the arc is opened.
fn twisted(u: &[BigRational; 2], [first, second, _]: &[Laurent; 3], twist: Laurent) -> (Circle, TwistClaim) {
    let (coefficients, left) = judged(twist);
    let circle = circle::whole(polynomial(u, left));
    let four = BigRational::from_integer(4.into());
    let squares = conjugate_times(first, first).into_iter().map(|(power, sum)| (power, sum.scaled(&four))).collect();
    let number = less(squares, &conjugate_times(second, second));
    let sign = |turn: &BigRational| enclosed_sign(&value(&number, turn));
    let (circle, signs) = circle.settled(&polynomial(u, number.clone().into_iter().collect()), sign);
    (circle, TwistClaim { coefficients, signs })
}

/// D and E.
fn eliminants([first, second, third]: &[Laurent; 3]) -> [Laurent; 2] {
    let difference = less(conjugate_times(first, first), &conjugate_times(third, third));
    let twist = less(conjugate_times(first, second), &conjugate_times(second, third));
    [difference, twist]
}

impl Quadratic {
    /// Whether they cancel nowhere.
    pub(in super::super) fn is_never(&self) -> bool {
        let Some(circle) = &self.circle else { return !self.is_curve() };
        let is_none = |at: &Option<Vec<Root>>| at.as_ref().is_some_and(Vec::is_empty);
        circle.is_complete() && self.degrees.iter().all(Vec::is_empty) && self.at.iter().all(is_none)
    }

    /// Whether `D² = |E|²` for every u, so that the classes cancel along a curve.
    pub fn is_curve(&self) -> bool {
        self.claim.coefficients.iter().all(Certificate::claims_zero)
    }

    /// Whether A and C are equally long for every u.
    pub fn is_mirrored(&self) -> bool {
        self.is_curve() && self.claim.lengths.iter().all(Certificate::claims_zero)
    }

    /// The rational turns of u at which the classes may cancel, each with its v; none where all are.
    pub fn rational(&self) -> impl Iterator<Item = (&BigRational, &Option<Vec<Root>>)> {
        self.circle.iter().flat_map(Circle::rational_in_order).zip(&self.at)
    }

    /// Between which turns each irrational u is, narrowly, with each of its v in degrees.
    pub fn irrational(&self) -> impl Iterator<Item = ([&BigRational; 2], f64)> {
        let each = self.circle.iter().flat_map(Circle::irrational).zip(&self.degrees);
        each.flat_map(|(ends, degrees)| degrees.iter().map(move |degrees| (ends, *degrees)))
    }
}
