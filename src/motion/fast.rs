//! What are the harmonics of a centric crank, fast, for sweeps?

/// The harmonics `c_0 … c_highest` of a centric crank's shaking force in floats; all NaN unless `0 ≤ ratio < 1`.
///
/// With `κ' = √(1−λ²)` and `ρ = (1−κ')/(1+κ')` the m-th harmonic of the root is
/// `½(1+κ') Σ_j C(½,j) C(½,j+m) ρ^{2j+m}`, all terms of one sign. Where ρ is so near to 1 that this takes long, the recurrence of the
/// guaranteed coefficients is steady, and used.
pub fn coefficients_fast(ratio: f64, highest_order: u32) -> Vec<f64> {
    let count = highest_order as usize + 1;
    if !(0.0..1.0).contains(&ratio) {
        return vec![f64::NAN; count];
    }
    let mut coefficients = vec![0.0; count];
    if let Some(first) = coefficients.get_mut(1) {
        *first = 1.0;
    }
    if ratio == 0.0 || count < 3 {
        return coefficients;
    }
    let complement = ((1.0 - ratio) * (1.0 + ratio)).sqrt();
    let half_power = ratio / (1.0 + complement);
    let highest = count.div_ceil(2) - 1;
    let rho = half_power * half_power;
    let harmonics = if rho.powi(highest as i32) > 0.5 {
        by_recurrence(ratio, complement, highest)
    } else {
        by_series(complement, rho, highest)
    };
    for (m, harmonic) in harmonics.iter().enumerate().skip(1) {
        let order = 2.0 * m as f64;
        coefficients[2 * m] = 2.0 * order * order * harmonic / ratio;
    }
    coefficients
}

/// `a_0 … a_highest` by the series in ρ, with `h_j = C(½,j) (−ρ)^j`… of one sign from `h_1` on.
fn by_series(complement: f64, rho: f64, highest: usize) -> Vec<f64> {
    // The terms fall at least like ρ^{2j}: as many as there are bits in a float.
    let terms = (f64::MANTISSA_DIGITS as f64 / (-2.0 * rho.log2())).ceil() as usize + 2;
    let mut h = Vec::with_capacity(terms + highest);
    h.push(1.0);
    for j in 1..terms + highest {
        h.push(h[j - 1] * rho * (j as f64 - 1.5) / j as f64);
    }
    let scale = 0.5 * (1.0 + complement);
    let harmonic = |m: usize| {
        let sum: f64 = h.iter().zip(&h[m..]).map(|(one, other)| one * other).rev().sum();
        // h_j is C(½,j) (−ρ)^j; the harmonic wants the sign of C(½,m).
        if m.is_multiple_of(2) { scale * sum } else { -scale * sum }
    };
    (0..=highest).map(harmonic).collect()
}

/// `a_0 … a_highest` from the arithmetic-geometric mean and the recurrence, upward.
fn by_recurrence(ratio: f64, complement: f64, highest: usize) -> Vec<f64> {
    let square = ratio * ratio;
    let (mut larger, mut smaller, mut rest, mut weight) = (1.0, complement, 1.0 - square / 2.0, 1.0);
    while larger - smaller > 1e-9 * larger {
        let half = 0.5 * (larger - smaller);
        rest -= weight * half * half;
        weight *= 2.0;
        (larger, smaller) = (0.5 * (larger + smaller), (larger * smaller).sqrt());
    }
    let mean = 0.5 * (larger + smaller);
    let first = rest / mean;
    let mut harmonics = vec![first, ((2.0 - square) * first - 2.0 * complement * complement / mean) / (3.0 * square)];
    for n in 1..highest {
        let m = n as f64;
        let sum = (8.0 / square - 4.0) * m * harmonics[n] + (2.0 * m - 3.0) * harmonics[n - 1];
        harmonics.push(-sum / (2.0 * m + 3.0));
    }
    harmonics
}
