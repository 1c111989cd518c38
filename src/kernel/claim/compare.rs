//! Is the length, or the direction, the claimed one? Exactly where the claim is exact, in decimals where it has a tolerance.

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::answer::{Evidence, Status};
use super::real::{is_direction_within, is_length_within};
use super::statement::{Angle, Bearing, Tolerance, Value};
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, ALIKE, Form, as_sum, evaluate, float, number, square_as_sum};

/// Whether `½(|A| + |B|)` is the claimed value; `exact` is its closed form, `decimal` its decimals.
pub(super) fn length(
    value: &Value,
    parts: [&PhasorSum; 2],
    exact: Option<&Form>,
    decimal: f64,
) -> (Status, Vec<Evidence>) {
    let claimed = value.form.to_float();
    let off = (decimal - claimed).abs();
    // Of a number that is a fraction it is decided exactly, whatever the tolerance.
    let is_within =
        |half: &BigRational| value.form.as_rational().map(|written| is_length_within(parts, &written, half));
    match &value.tolerance {
        Tolerance::Within(within) => (nearness(is_within(within), off, float(within)), Vec::new()),
        Tolerance::Part(part) => {
            let exactly = value.form.as_rational().and_then(|written| is_within(&(part * written)));
            (nearness(exactly, off, float(part) * claimed), Vec::new())
        }
        Tolerance::Exact { rounding } => {
            let (equal, evidence) = equals(&value.form, parts, exact, decimal);
            (exact_status(equal, off, rounding.as_ref(), is_within), evidence.into_iter().collect())
        }
    }
}

/// Whether the sum, or where `is_line` the line that it is twice the angle of, points as claimed; `decimal` in degrees.
pub(super) fn bearing(angle: &Angle, sum: &PhasorSum, is_line: bool, decimal: f64) -> (Status, Vec<Evidence>) {
    let claimed = match &angle.bearing {
        Bearing::Turns(turns) => float(turns) * 360.0,
        Bearing::Arctangent(tangent) => tangent.to_float().atan().to_degrees(),
    };
    let period = if is_line { 180.0 } else { 360.0 };
    let off = (decimal - claimed).rem_euclid(period);
    let off = off.min(period - off);
    let is_within = |degrees: &BigRational| is_within(angle, sum, is_line, degrees);
    match &angle.tolerance {
        Tolerance::Within(within) | Tolerance::Part(within) => {
            (nearness(is_within(within), off, float(within)), Vec::new())
        }
        Tolerance::Exact { rounding } => {
            let Some(upright) = upright(&angle.bearing, sum, is_line) else { return (Status::NotDecided, Vec::new()) };
            let across = upright.minus(&upright.conjugate());
            let evidence = Evidence::comparison("The part across the claimed direction", across);
            let equal = evidence.vanishes() && evaluate(&upright).re > 0.0;
            (exact_status(Some(equal), off, rounding.as_ref(), is_within), vec![evidence])
        }
    }
}

/// Whether a sum, or the line that it is twice the angle of, is no farther than so many degrees from an angle in turns; none where these are too
/// many to be decided so, or the angle is one of a tangent.
fn is_within(angle: &Angle, sum: &PhasorSum, is_line: bool, degrees: &BigRational) -> Option<bool> {
    let Bearing::Turns(turns) = &angle.bearing else { return None };
    let twice = BigRational::from_integer(if is_line { 2 } else { 1 }.into());
    let half = degrees / BigRational::from_integer(360.into()) * &twice;
    let is_small = half < BigRational::new(1.into(), 4.into()) && !sum.vanishes();
    is_small.then(|| is_direction_within(sum, &(turns * &twice), &half))
}

/// The sum turned back by the claimed direction (twice by that of a line): real and positive iff the claim is right.
fn upright(bearing: &Bearing, sum: &PhasorSum, is_line: bool) -> Option<PhasorSum> {
    let direction = match bearing {
        Bearing::Turns(turns) => number(BigRational::one()).turned(&Turn::new(turns.clone())),
        Bearing::Arctangent(tangent) => {
            number(BigRational::one()).plus(&as_sum(tangent)?.turned(&Turn::fraction(1, 4)))
        }
    };
    let back = direction.conjugate();
    Some(if is_line { sum.times(&back).times(&back) } else { sum.times(&back) })
}

/// `v = ½(a + b)`: where one of a, b is zero or both are equal, `a² = (2v)²` or `a² = v²`; else squared twice,
/// `(4v² − a² − b²)² = 4a²b²`, whose other solutions the decimals rule out.
fn equals(
    value: &Form,
    parts: [&PhasorSum; 2],
    exact: Option<&Form>,
    decimal: f64,
) -> (Option<bool>, Option<Evidence>) {
    let Some(square) = square_as_sum(value) else {
        let same = exact
            .is_some_and(|exact| exact == value || exact.times(exact).is_some_and(|s| Some(s) == value.times(value)));
        let differs = (decimal - value.to_float()).abs() > ALIKE * (1.0 + decimal.abs());
        return (
            if same {
                Some(true)
            } else if differs {
                Some(false)
            } else {
                None
            },
            None,
        );
    };
    let four = BigRational::from_integer(4.into());
    let [a, b] = parts.map(PhasorSum::squared_modulus);
    let (a_empty, b_empty) = (a.vanishes(), b.vanishes());
    let difference = match () {
        () if a_empty && b_empty => square,
        () if a_empty => b.minus(&square.scaled(&four)),
        () if b_empty => a.minus(&square.scaled(&four)),
        () if a.minus(&b).vanishes() => a.minus(&square),
        () => {
            let rest = square.scaled(&four).minus(&a).minus(&b);
            rest.times(&rest).minus(&a.times(&b).scaled(&four))
        }
    };
    let evidence = Evidence::comparison("The difference of the squares", difference);
    let near = (decimal - value.to_float()).abs() < ALIKE * (1.0 + decimal.abs());
    (Some(evidence.vanishes() && near), Some(evidence))
}

/// A value that is not the claimed one may still round to it: `is_within` knows that exactly, where it knows it, else the decimals tell.
fn exact_status(
    equal: Option<bool>,
    off: f64,
    rounding: Option<&BigRational>,
    is_within: impl Fn(&BigRational) -> Option<bool>,
) -> Status {
    let rounds = |half: &BigRational| !half.is_zero() && is_within(half).unwrap_or(off <= float(half));
    match equal {
        Some(true) => Status::True,
        None => Status::NotDecided,
        Some(false) if rounding.is_some_and(rounds) => Status::TrueAsRounded,
        Some(false) => Status::False,
    }
}

/// Exactly, where that is known; else by how far the decimals are off.
fn nearness(exactly: Option<bool>, off: f64, within: f64) -> Status {
    match (exactly, off - within) {
        (Some(true), _) => Status::True,
        (Some(false), _) => Status::False,
        (None, edge) if edge.abs() < ALIKE * within && off > 0.0 => Status::NotDecided,
        (None, edge) if edge <= 0.0 => Status::True,
        (None, _) => Status::False,
    }
}

/// `½(|A| + |B|)` in closed form and in decimals.
pub(super) fn half_of_lengths(sums: [&PhasorSum; 2]) -> (Option<Form>, f64) {
    let decimal = sums.map(|sum| evaluate(sum).norm()).iter().sum::<f64>() / 2.0;
    (numbers::half_of_lengths(sums[0], sums[1]), decimal)
}

/// How far decimals may be from a claimed value; none of one that is said to be exact.
pub(super) fn half_width(value: &Value) -> Option<f64> {
    match &value.tolerance {
        Tolerance::Within(within) => Some(float(within)),
        Tolerance::Part(part) => Some(float(part) * value.form.to_float()),
        Tolerance::Exact { rounding } => rounding.as_ref().map(float),
    }
}

/// Whether it is claimed that nothing is left, without a tolerance.
pub(super) fn is_exact_zero(value: &Value) -> bool {
    let is_exact = matches!(value.tolerance, Tolerance::Exact { .. });
    is_exact && value.form.as_rational().is_some_and(|claimed| claimed.is_zero())
}
