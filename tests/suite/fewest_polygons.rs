//! Is the proof of a zero as short as can be? Against all sets of fewer polygons, by linear algebra modulo a prime.

use std::collections::BTreeMap;

use crate::support::dice::{Dice, Terms, phasors, polygons};
use crate::support::written::vectors;
use crankstar::exact::PhasorSum;
use crankstar::proof::{Certificate, check_certificate};

const MODULUS: i64 = 1_000_000_007;

fn inverse(value: i64) -> i64 {
    let (mut result, mut base, mut exponent) = (1, value.rem_euclid(MODULUS), MODULUS - 2);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = result * base % MODULUS;
        }
        base = base * base % MODULUS;
        exponent /= 2;
    }
    result
}

/// A vector less its multiples of rows with a leading place each.
fn reduced(mut vector: Vec<i64>, rows: &[(usize, Vec<i64>)]) -> Vec<i64> {
    for (lead, row) in rows {
        let factor = vector[*lead];
        if factor != 0 {
            vector.iter_mut().zip(row).for_each(|(one, other)| *one = (*one - factor * other).rem_euclid(MODULUS));
        }
    }
    vector
}

/// Whether some set of this many polygons spans the sum, all sets tried.
fn spans(sum: &[i64], polygons: &[Vec<i64>], number: usize, rows: &mut Vec<(usize, Vec<i64>)>) -> bool {
    if reduced(sum.to_vec(), rows).iter().all(|left| *left == 0) {
        return true;
    }
    if number == 0 {
        return false;
    }
    (0..polygons.len()).any(|at| {
        let mut row = reduced(polygons[at].clone(), rows);
        let Some(lead) = row.iter().position(|entry| *entry != 0) else { return false };
        let scale = inverse(row[lead]);
        row.iter_mut().for_each(|entry| *entry = *entry * scale % MODULUS);
        rows.push((lead, row));
        let found = spans(sum, &polygons[at + 1..], number - 1, rows);
        rows.pop();
        found
    })
}

/// All polygons over a conductor, each a list of the weights of all directions.
fn all_polygons(conductor: usize) -> Vec<Vec<i64>> {
    let is_prime = |sides: &usize| (2..*sides).all(|divisor| !sides.is_multiple_of(divisor));
    let sides = (2..=conductor).filter(|sides| conductor.is_multiple_of(*sides)).filter(is_prime);
    let rotated = sides.flat_map(|sides| (0..conductor / sides).map(move |first| (sides, first)));
    rotated
        .map(|(sides, first)| {
            let mut weights = vec![0; conductor];
            weights.iter_mut().skip(first).step_by(conductor / sides).for_each(|weight| *weight = 1);
            weights
        })
        .collect()
}

fn collected(terms: &Terms) -> Terms {
    let mut by_exponent: BTreeMap<u64, i64> = BTreeMap::new();
    terms.iter().for_each(|(exponent, weight)| *by_exponent.entry(*exponent).or_default() += weight);
    by_exponent.into_iter().filter(|(_, weight)| *weight != 0).collect()
}

fn number_of_polygons(sum: &PhasorSum) -> usize {
    let certificate = sum.certificate();
    assert_eq!(check_certificate(&vectors(sum), true, &certificate), Ok(()));
    let Certificate::Polygons { polygons } = certificate else { panic!("{sum:?}") };
    polygons.len()
}

/// Sums of up to twelve vectors that are zero, of polygons that share corners.
fn zeros(conductor: u64, rounds: usize) -> Vec<Terms> {
    let mut dice = Dice::new(conductor);
    let mut zeros = Vec::new();
    while zeros.len() < rounds {
        let count = dice.below(6) + 2;
        let heaviest = dice.below(3) + 1;
        let terms = collected(&polygons(&mut dice, conductor, count, |dice| {
            let weight = dice.below(heaviest) as i64 + 1;
            if dice.below(2) == 0 { weight } else { -weight }
        }));
        if (1..=12).contains(&terms.len()) {
            zeros.push(terms);
        }
    }
    zeros
}

#[test]
fn no_set_of_fewer_polygons_makes_up_a_zero_of_up_to_twelve_vectors() {
    let mut longest = 0;
    for (conductor, rounds, most) in
        [(6, 60, 5), (12, 60, 4), (10, 60, 5), (15, 60, 4), (30, 120, 3), (42, 60, 3), (60, 30, 2)]
    {
        let all = all_polygons(conductor as usize);
        for terms in zeros(conductor, rounds) {
            let sum = phasors(conductor, &terms);
            let number = sum.fewest_polygons().unwrap_or_else(|| panic!("not proved: {conductor} {terms:?}"));
            assert_eq!(number_of_polygons(&sum), number, "{conductor} {terms:?}");
            let mut weights = vec![0; conductor as usize];
            terms.iter().for_each(|(exponent, weight)| weights[*exponent as usize] = weight.rem_euclid(MODULUS));
            let fewer = (number - 1).min(most);
            assert!(!spans(&weights, &all, fewer, &mut Vec::new()), "{conductor} {terms:?}");
            longest = longest.max(number);
        }
    }
    assert!(longest > 4, "{longest}");
}

#[test]
fn polygons_of_other_primes_and_finer_rotations_do_not_help() {
    for (conductor, finer) in [(3, 6), (5, 10), (6, 30), (15, 30), (9, 18), (10, 20), (6, 12)] {
        let all = all_polygons(finer as usize);
        for terms in zeros(conductor, 30) {
            let number = phasors(conductor, &terms).fewest_polygons().expect("proved");
            let mut weights = vec![0; finer as usize];
            for (exponent, weight) in &terms {
                weights[(exponent * finer / conductor) as usize] = weight.rem_euclid(MODULUS);
            }
            assert!(!spans(&weights, &all, (number - 1).min(3), &mut Vec::new()), "{conductor} {terms:?}");
        }
    }
}

/// Over four primes all sets are too many: what is claimed to be proved is reached, and stays the same when all is turned and scaled.
#[test]
fn over_many_primes_too_the_fewest_are_proved() {
    let mut proved = 0;
    for conductor in [30_u64, 66, 70, 105, 210, 330, 420] {
        for terms in zeros(conductor, 60) {
            let sum = phasors(conductor, &terms);
            let number = sum.fewest_polygons().unwrap_or_else(|| panic!("not proved: {conductor} {terms:?}"));
            let changed: Terms = terms
                .iter()
                .map(|(exponent, weight)| ((exponent * 11 % conductor + 7) % conductor, -3 * weight))
                .collect();
            if !conductor.is_multiple_of(11) {
                assert_eq!(phasors(conductor, &changed).fewest_polygons(), Some(number), "{conductor} {terms:?}");
            }
            assert_eq!(number_of_polygons(&sum), number);
            proved += 1;
        }
    }
    assert!(proved > 400);
}

/// A power modulo a small number.
fn power(base: u64, exponent: u64, modulus: u64) -> u64 {
    (0..exponent).fold(1, |product, _| product * base % modulus)
}

#[test]
fn no_smaller_prime_shows_that_a_sum_is_not_zero() {
    let (mut shown, mut by_another_root) = (0, 0);
    for conductor in 1..=36_u64 {
        let mut dice = Dice::new(conductor);
        for _ in 0..8 {
            let terms: Terms =
                (0..dice.below(4) + 1).map(|_| (dice.below(conductor), dice.below(9) as i64 - 4)).collect();
            let terms = collected(&terms);
            let Certificate::Residue(residue) = phasors(conductor, &terms).certificate() else { continue };
            let [order, prime, root] = [residue.conductor, residue.prime, residue.root]
                .map(|number| u64::try_from(number).expect("a small number"));
            let image = |root: u64, prime: u64| {
                let vector = |(exponent, weight): &(u64, i64)| {
                    let exponent = exponent * order / conductor;
                    weight.rem_euclid(prime as i64) as u64 * power(root, exponent, prime) % prime
                };
                terms.iter().map(vector).sum::<u64>() % prime
            };
            let is_prime = |number: &u64| *number > 1 && (2..*number).all(|divisor| !number.is_multiple_of(divisor));
            let has_order = |root: &u64, prime: u64| {
                (1..=order).find(|exponent| power(*root, *exponent, prime) == 1) == Some(order)
            };
            for smaller in (2..prime).filter(is_prime) {
                assert!(
                    (1..smaller).filter(|root| has_order(root, smaller)).all(|root| image(root, smaller) == 0),
                    "{terms:?}"
                );
            }
            let first = (1..prime).find(|root| has_order(root, prime)).expect("a root");
            assert!(
                (first..root).filter(|root| has_order(root, prime)).all(|root| image(root, prime) == 0),
                "{terms:?}"
            );
            by_another_root += usize::from(first < root);
            shown += 1;
        }
    }
    assert!(shown > 100 && by_another_root > 2, "{shown} {by_another_root}");
}
