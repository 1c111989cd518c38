//! How many stars of a grid have balanced first-order force? All are counted, none is looked at.

use std::collections::HashMap;

use crate::exact::modulo::prime_divisors;

/// A sum of N-th roots of unity by its coefficients, so that equal sums have equal ones.
type Sum = Vec<i8>;

/// Throws on multiples of `1 / directions` turn, the first at 0, whose unit vectors add up to zero: how often there are some.
///
/// The sums of half the throws after the first are listed, and each asks how many of the other half are its negative.
pub(super) fn count(directions: usize, throws: usize) -> u64 {
    let units: Vec<Sum> = (0..directions).map(|direction| unit(direction, directions)).collect();
    let mut half = HashMap::from([(vec![0; directions], 1_u64)]);
    for _ in 0..(throws - 1) / 2 {
        let mut longer = HashMap::new();
        for (sum, count) in &half {
            units.iter().for_each(|unit| *longer.entry(plus(sum, unit)).or_default() += count);
        }
        half = longer;
    }
    // A throw that has no partner stands anywhere.
    let odd = if throws.is_multiple_of(2) { units.as_slice() } else { &[vec![0; directions]] };
    let starts: Vec<Sum> = odd.iter().map(|unit| plus(unit, &units[0])).collect();
    let missing =
        |sum: &Sum, start: &Sum| plus(sum, start).into_iter().map(|coefficient| -coefficient).collect::<Sum>();
    let ways = |sum: &Sum| starts.iter().filter_map(|start| half.get(&missing(sum, start))).sum::<u64>();
    half.iter().map(|(sum, count)| count * ways(sum)).sum()
}

fn plus(one: &[i8], other: &[i8]) -> Sum {
    one.iter().zip(other).map(|(one, other)| one + other).collect()
}

/// A root of unity in the basis of all products over the primes of N of `ζ^j` with `j < p^(a−1)(p − 1)`, ζ of order `p^a`, the power of p in N.
///
/// The p roots that are apart by `1/p` turn add up to zero. One of them is outside of the basis, and is minus the others.
fn unit(direction: usize, directions: usize) -> Sum {
    let mut sum = vec![0; directions];
    sum[direction] = 1;
    for prime in prime_divisors(directions as u64) {
        let prime = prime as usize;
        let power =
            (1..).map(|a| prime.pow(a)).take_while(|power| directions.is_multiple_of(*power)).last().unwrap_or(1);
        for outside in (0..directions).filter(|root| root % power >= power - power / prime) {
            let coefficient = sum[outside];
            (0..prime).for_each(|j| sum[(outside + j * (directions / prime)) % directions] -= coefficient);
        }
    }
    sum
}
