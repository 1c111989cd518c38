//! The independent method: reduce modulo the N-th cyclotomic polynomial and look whether anything is left.
//!
//! It needs N coefficients and the polynomial itself, so it serves conductors up to some hundreds.

/// Coefficients of the N-th cyclotomic polynomial, constant term first: `x^N − 1` divided by `Φ_d` for each proper d | N.
pub fn cyclotomic(n: usize) -> Vec<i128> {
    let mut quotient = vec![0; n + 1];
    (quotient[0], quotient[n]) = (-1, 1);
    for d in (1..n).filter(|d| n.is_multiple_of(*d)) {
        quotient = divide(quotient, &cyclotomic(d)).0;
    }
    quotient
}

/// Quotient and remainder by a polynomial with leading coefficient 1.
fn divide(mut dividend: Vec<i128>, divisor: &[i128]) -> (Vec<i128>, Vec<i128>) {
    let degree = divisor.len() - 1;
    let mut quotient = vec![0; dividend.len().saturating_sub(degree)];
    for shift in (0..quotient.len()).rev() {
        let factor = dividend[shift + degree];
        quotient[shift] = factor;
        for (i, coefficient) in divisor.iter().enumerate() {
            dividend[shift + i] -= factor * coefficient;
        }
    }
    dividend.truncate(degree);
    (quotient, dividend)
}

/// Whether `Σ weight · e^{2πi·exponent/n}` is zero, given the n-th cyclotomic polynomial.
pub fn vanishes(n: usize, cyclotomic: &[i128], terms: &[(u64, i64)]) -> bool {
    let mut dense = vec![0; n];
    for (exponent, weight) in terms {
        dense[*exponent as usize] += i128::from(*weight);
    }
    divide(dense, cyclotomic).1.iter().all(|coefficient| *coefficient == 0)
}
