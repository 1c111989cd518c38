//! Is a real number a sum of square roots of whole numbers? `Σ a_d √d`, read off its conjugates.
//!
//! The map of a carries √d to χ_d(a) √d, so the mean of `χ_d(a) Q_a` is `a_d √d`.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::form::Form;

/// Sums of more roots tell a reader nothing.
const MOST_ROOTS: usize = 4;
/// Relative distance within which two decimals are taken for the same number, to be decided exactly later.
pub(super) const NEAR: f64 = 1e-10;

/// The number whose conjugates these are under `units` modulo `conductor`; `rational` reads a decimal as a fraction.
pub(super) fn propose(
    values: &[f64],
    units: &[u64],
    conductor: u64,
    rational: impl Fn(f64) -> Option<BigRational>,
) -> Option<Form> {
    let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let mut left = values.to_vec();
    let mut form = Form::rational(BigRational::from_integer(0.into()));
    let mut roots = 0;
    for d in radicands(conductor) {
        let signs: Vec<f64> = units.iter().map(|&a| f64::from(character(d, a))).collect();
        let mean = values.iter().zip(&signs).map(|(value, sign)| value * sign).sum::<f64>() / values.len() as f64;
        let root = (d as f64).sqrt();
        if mean.abs() <= NEAR * size {
            continue;
        }
        roots += 1;
        let coefficient = rational(mean / root).filter(|_| roots <= MOST_ROOTS)?;
        let part = coefficient.to_f64()? * root;
        left.iter_mut().zip(&signs).for_each(|(value, sign)| *value -= sign * part);
        form = form.plus(&Form::rational(BigRational::from_integer(d.into())).square_root().scaled(&coefficient));
    }
    left.iter().all(|value| value.abs() <= NEAR * size).then_some(form)
}

/// A fraction over a few powers of 2: the coefficients of whole numbers of such fields.
pub(super) fn over_sixteen(value: f64) -> Option<BigRational> {
    let whole = (value * 16.0).round();
    let near = (value * 16.0 - whole).abs() <= 1e-5;
    near.then(|| whole.to_i64().map(|whole| BigRational::new(whole.into(), 16.into())))?
}

/// The first fraction of the continued fraction that is near enough.
pub(super) fn fraction(value: f64) -> Option<BigRational> {
    let (mut before, mut now) = ((0_i64, 1_i64), (1_i64, 0_i64));
    let mut rest = value;
    loop {
        let whole = rest.floor();
        let step = whole.to_i64().filter(|step| step.unsigned_abs() < 1 << 20)?;
        let next = |last: i64, earlier: i64| step.checked_mul(last)?.checked_add(earlier);
        (before, now) = (now, (next(now.0, before.0)?, next(now.1, before.1)?));
        if now.1 > 1 << 20 {
            return None;
        }
        if (now.0 as f64 / now.1 as f64 - value).abs() <= 1e-11 * value.abs().max(1.0) {
            return Some(BigRational::new(now.0.into(), now.1.into()));
        }
        rest = (rest - whole).recip();
    }
}

/// Whole numbers d free of squares, 1 first, with √d in the field of the conductor: the discriminant of √d divides it.
fn radicands(conductor: u64) -> Vec<u64> {
    let is_squarefree = |d: u64| (2..).take_while(|p| p * p <= d).all(|p| !d.is_multiple_of(p * p));
    (1..=conductor).filter(|&d| conductor.is_multiple_of(discriminant(d)) && is_squarefree(d)).collect()
}

/// The discriminant of √d for d free of squares.
pub(super) fn discriminant(d: u64) -> u64 {
    if d % 4 == 1 { d } else { 4 * d }
}

/// What the map of a does to √d: 1 or −1.
pub(super) fn character(d: u64, a: u64) -> i32 {
    let minus_four = |a: u64| if a % 4 == 3 { -1 } else { 1 };
    let mut sign = 1;
    let (mut rest, mut p) = (d, 2);
    while rest > 1 {
        if rest.is_multiple_of(p) {
            rest /= p;
            sign *= match p {
                2 if [1, 7].contains(&(a % 8)) => 1,
                2 => -1,
                // Gauss's sum of p ≡ 3 (mod 4) is i√p.
                _ if p % 4 == 3 => legendre(a, p) * minus_four(a),
                _ => legendre(a, p),
            };
        }
        p += 1;
    }
    sign
}

fn legendre(a: u64, p: u64) -> i32 {
    if (1..p).any(|b| b * b % p == a % p) { 1 } else { -1 }
}
