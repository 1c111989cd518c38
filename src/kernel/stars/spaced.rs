//! Which stars lose their first-order moment, one by one? Theorems 5 and 9: the places are a sum `A ⊕ B`.

use num_rational::BigRational;
use num_traits::Zero;

use super::factors::two_primes;
use super::star::Star;

/// Places as sums: each is an element of the first set plus one of the second, in one way. Both sets rise from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decomposition {
    /// As many as the first prime.
    pub first: Vec<BigRational>,
    /// As many as the second one.
    pub second: Vec<BigRational>,
}

/// All ways in which p·q places are a sum of p and of q; none where their number is no product of two primes.
///
/// Places in any order; they differ, or there is no way.
pub fn decompositions(places: &[BigRational]) -> Vec<Decomposition> {
    let Some([p, q]) = u32::try_from(places.len()).ok().and_then(two_primes) else { return Vec::new() };
    let mut rising = places.to_vec();
    rising.sort();
    let lowest = rising[0].clone();
    rising.iter_mut().for_each(|place| *place -= &lowest);
    let mut found = Vec::new();
    choose(&rising, p as usize, &mut vec![BigRational::zero()], 1, &mut |first| {
        if let Some(second) = second_of(&rising, first).filter(|second| second.len() == q as usize) {
            found.push(Decomposition { first: first.to_vec(), second });
        }
    });
    found
}

/// Calls with every set of this many of the places that holds the first.
fn choose(
    places: &[BigRational],
    size: usize,
    chosen: &mut Vec<BigRational>,
    from: usize,
    call: &mut dyn FnMut(&[BigRational]),
) {
    if chosen.len() == size {
        return call(chosen);
    }
    for next in from..places.len() {
        chosen.push(places[next].clone());
        choose(places, size, chosen, next + 1, call);
        chosen.pop();
    }
}

/// The other set: the lowest place that is not covered is one of its elements.
fn second_of(places: &[BigRational], first: &[BigRational]) -> Option<Vec<BigRational>> {
    let (mut left, mut second) = (places.to_vec(), Vec::new());
    while let Some(lowest) = left.first().cloned() {
        for step in first {
            let at = left.binary_search(&(&lowest + step)).ok()?;
            left.remove(at);
        }
        second.push(lowest);
    }
    Some(second)
}

/// The stars that lose the first-order moment at these places, as the direction of each place in multiples of `1/n` turn, the first place at 0; each once.
pub fn stars_of(places: &[BigRational]) -> Vec<Vec<u32>> {
    let Some([p, q]) = u32::try_from(places.len()).ok().and_then(two_primes) else { return Vec::new() };
    let lowest = places.iter().min().cloned().unwrap_or_default();
    let mut stars = Vec::new();
    for Decomposition { first, second } in decompositions(places) {
        for a in placings(&first) {
            for b in placings(&second) {
                let direction_of = |place: &BigRational| {
                    let is_it = |x: &u32| &a[(x % p) as usize] + &b[(x % q) as usize] == place - &lowest;
                    (0..p * q).find(is_it)
                };
                let throws: Option<Vec<u32>> = places.iter().map(direction_of).collect();
                // One of the rotations has the first place at 0.
                stars.extend(throws.filter(|throws| throws[0] == 0));
            }
        }
    }
    stars
}

/// The stars of theorem 5, which lose the first-order moment of a product of two primes, one spacing apart and with place 0 at direction 0: all of
/// them, each once. None of another number of throws, or where there are more than this many.
pub fn listed(throws: u32, most: usize) -> Vec<Star> {
    let Some([p, q]) = two_primes(throws) else { return Vec::new() };
    let all = |prime: u32| (1..prime as usize).try_fold(1_usize, usize::checked_mul);
    let number = all(p).zip(all(q)).and_then(|(p, q)| p.checked_mul(q)?.checked_mul(2));
    if number.is_none_or(|number| number > most) {
        return Vec::new();
    }
    let from_0 = |prime: u32| {
        let orders = placings(&(1..prime).collect::<Vec<u32>>()).into_iter();
        orders.map(|order| [vec![0], order].concat()).collect::<Vec<_>>()
    };
    let mut stars = Vec::new();
    for (scale_of_first, scale_of_second) in [(1, p), (q, 1)] {
        for first in &from_0(p) {
            for second in &from_0(q) {
                let place =
                    |x: u32| scale_of_first * first[(x % p) as usize] + scale_of_second * second[(x % q) as usize];
                stars.push(Star::of_places(&(0..throws).map(place).collect::<Vec<_>>()));
            }
        }
    }
    stars
}

/// All orders of a set.
fn placings<T: Clone>(set: &[T]) -> Vec<Vec<T>> {
    match set {
        [] => vec![Vec::new()],
        _ => (0..set.len())
            .flat_map(|at| {
                let mut rest = set.to_vec();
                let first = rest.remove(at);
                placings(&rest).into_iter().map(move |others| [vec![first.clone()], others].concat())
            })
            .collect(),
    }
}
