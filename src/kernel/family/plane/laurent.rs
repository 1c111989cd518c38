//! What are the coefficients of polynomials in `y = e^{iu}` and its inverse, multiplied with each other's conjugates?

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::super::circle::Polynomial;
use crate::exact::{PhasorSum, Turn};
use crate::proof::Certificate;

/// Sums by the power of y before them.
pub(super) type Laurent = BTreeMap<i64, PhasorSum>;

/// `conj(p)·q`.
pub(super) fn conjugate_times(p: &Laurent, q: &Laurent) -> Laurent {
    let mut product = Laurent::new();
    for (i, a) in p {
        for (j, b) in q {
            add(&mut product, j - i, &b.times(&a.conjugate()));
        }
    }
    product
}

/// `p − q`.
pub(super) fn less(mut p: Laurent, q: &Laurent) -> Laurent {
    for (power, sum) in q {
        add(&mut p, *power, &sum.scaled(&BigRational::from_integer((-1).into())));
    }
    p
}

fn add(to: &mut Laurent, power: i64, sum: &PhasorSum) {
    let all = to.entry(power).or_insert_with(|| PhasorSum::new(Vec::new()));
    *all = all.plus(sum).tidied();
}

/// Its value at a turn of u.
pub(super) fn value(p: &Laurent, turn: &BigRational) -> PhasorSum {
    let turned = |(power, sum): (&i64, &PhasorSum)| {
        sum.turned(&Turn::new(turn * BigRational::from_integer((*power).into()))).terms().to_vec()
    };
    PhasorSum::new(p.iter().flat_map(turned).collect()).tidied()
}

/// Evidence for every coefficient, by rising powers, and those that are not zero.
pub(super) fn judged(p: Laurent) -> (Vec<Certificate>, Vec<(i64, PhasorSum)>) {
    let certificates: Vec<Certificate> = p.values().map(PhasorSum::certificate).collect();
    let left = p.into_iter().zip(&certificates).filter(|(_, certificate)| !certificate.claims_zero());
    let left = left.map(|(coefficient, _)| coefficient).collect();
    (certificates, left)
}

/// The same of a real polynomial from the constant coefficient on: those before it are conjugates.
pub(super) fn judged_half(mut p: Laurent) -> (Vec<Certificate>, Vec<(i64, PhasorSum)>) {
    p.retain(|power, _| *power >= 0);
    judged(p)
}

/// A real polynomial by its coefficients from the constant one on.
pub(super) fn mirrored_whole(u: &[BigRational; 2], half: Vec<(i64, PhasorSum)>) -> Polynomial {
    let mirrored = half.iter().rev().filter(|(power, _)| *power > 0).map(|(power, sum)| (-power, sum.conjugate()));
    polynomial(u, mirrored.chain(half.iter().cloned()).collect())
}

/// Up to a power of y.
pub(super) fn polynomial([phi, delta]: &[BigRational; 2], rising: Vec<(i64, PhasorSum)>) -> Polynomial {
    let lowest = rising.first().map_or(0, |(power, _)| *power);
    let (exponents, sums) = rising.into_iter().map(|(power, sum)| (power - lowest, sum)).unzip();
    Polynomial { phi: phi.clone(), delta: delta.clone(), exponents, sums }
}
