//! What is the integral of a smooth function? Sixteen points of Gauss and Legendre, five over a short way.

use std::ops::{Add, Mul};

/// The points above the middle of (−1, 1), and their weights (Abramowitz and Stegun, table 25.4, n = 16).
const POINTS: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_58),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_88),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// The points of an interval with their weights.
pub(super) fn points(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    POINTS
        .into_iter()
        .flat_map(move |(x, weight)| [(middle - half * x, half * weight), (middle + half * x, half * weight)])
}

/// `∫ f` from one place to another, exact for polynomials of degree 31.
pub fn integrate<T: Add<Output = T> + Mul<f64, Output = T>>(zero: T, from: f64, to: f64, f: impl Fn(f64) -> T) -> T {
    points(from, to).fold(zero, |sum, (x, weight)| sum + f(x) * weight)
}

/// The five points in (0, 1) and their weights.
const FEW: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// The points of a short way with their weights.
pub fn points_short(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    let width = to - from;
    FEW.into_iter().map(move |(part, weight)| (from + width * part, weight * width))
}

/// `∫ f` over a way so short that f is nearly a polynomial of degree 9 there.
pub fn integrate_short(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    points_short(from, to).map(|(x, weight)| weight * f(x)).sum()
}
