//! Are the minimal vanishing stars those of Poonen and Rubinstein, each minimal, and are there no others? By plain loops over roots of unity modulo a prime.

use std::collections::{BTreeMap, BTreeSet};

use crankstar::exact::{MinimalStar, PhasorSum, Term, Turn, minimal_stars, taken_apart};
use num_rational::BigRational;

use crate::support::dice::Dice;

/// A prime that is 1 modulo 2310, and a number of order 2310 modulo it: what is not zero there is not zero.
const PRIME: u64 = 2_310 * 1_000_007 + 1;

fn power(base: u64, exponent: u64) -> u64 {
    let mut result = 1_u128;
    for bit in (0..64).rev() {
        result = result * result % u128::from(PRIME);
        if exponent >> bit & 1 == 1 {
            result = result * u128::from(base) % u128::from(PRIME);
        }
    }
    result as u64
}

/// The roots of unity of an order that divides 2310.
fn roots(order: u64) -> Vec<u64> {
    assert!((2_u64..).take_while(|divisor| divisor * divisor <= PRIME).all(|divisor| !PRIME.is_multiple_of(divisor)));
    let is_primitive = |root: &u64| [2, 3, 5, 7, 11].iter().all(|prime| power(*root, 2310 / prime) != 1);
    let root = (2..).map(|base| power(base, (PRIME - 1) / 2310)).find(is_primitive).expect("a root");
    (0..order).map(|exponent| power(root, 2310 / order * exponent)).collect()
}

fn exponents(star: &MinimalStar) -> Vec<usize> {
    let turns = |turn: &Turn| {
        let part = turn.turns() * BigRational::from_integer(2310.into());
        part.to_integer().try_into().expect("a small number")
    };
    star.angles().iter().map(turns).collect()
}

/// Of all rotations with a vector at 0 the first.
fn turned_least(exponents: &[usize], conductor: usize) -> Vec<usize> {
    let turned = |first: &usize| {
        let mut turned: Vec<usize> =
            exponents.iter().map(|exponent| (exponent + conductor - first) % conductor).collect();
        turned.sort_unstable();
        turned
    };
    exponents.iter().map(turned).min().expect("vectors")
}

#[test]
fn the_classes_have_as_many_stars_as_poonen_and_rubinstein_count() {
    let mut classes: BTreeMap<(usize, String), usize> = BTreeMap::new();
    for star in minimal_stars(12) {
        assert_eq!(star.class.vectors(), star.angles().len());
        *classes.entry((star.angles().len(), star.class.to_string().replace(['{', '}', '_', ' '], ""))).or_default() +=
            1;
    }
    // Table 1 of their paper, from two vectors to twelve.
    let published = [
        (2, "R2", 1),
        (3, "R3", 1),
        (5, "R5", 1),
        (6, "(R5:R3)", 1),
        (7, "(R5:2R3)", 2),
        (7, "R7", 1),
        (8, "(R5:3R3)", 2),
        (8, "(R7:R3)", 1),
        (9, "(R5:4R3)", 1),
        (9, "(R7:2R3)", 3),
        (10, "(R7:3R3)", 5),
        (10, "(R7:R5)", 1),
        (11, "(R7:4R3)", 5),
        (11, "(R7:R5,R3)", 6),
        (11, "(R7:(R5:R3))", 6),
        (11, "R11", 1),
        (12, "(R7:5R3)", 3),
        (12, "(R7:R5,2R3)", 15),
        (12, "(R7:(R5:R3),R3)", 36),
        (12, "(R7:(R5:2R3))", 14),
        (12, "(R11:R3)", 1),
    ];
    let published: BTreeMap<(usize, String), usize> =
        published.into_iter().map(|(vectors, class, stars)| ((vectors, class.to_owned()), stars)).collect();
    assert_eq!(classes, published);
    assert_eq!(classes.values().sum::<usize>(), 107);
}

#[test]
fn each_is_zero_no_part_of_it_is_and_none_with_a_vector_turned() {
    let roots = roots(2310);
    let mut different = BTreeSet::new();
    for star in minimal_stars(12) {
        let exponents = exponents(&star);
        assert!(different.insert(turned_least(&exponents, 2310)));
        assert!(star.sum().vanishes());
        let all = (1_usize << exponents.len()) - 1;
        for part in 1..all {
            let vectors = exponents.iter().enumerate().filter(|(place, _)| part >> place & 1 == 1);
            let sum: u64 = vectors.map(|(_, exponent)| roots[*exponent]).sum();
            assert_ne!(sum % PRIME, 0, "{exponents:?} {part:b}");
        }
        let mut terms = star.sum().terms().to_vec();
        terms[1].angle = &terms[1].angle + &Turn::fraction(1, 2310);
        assert!(!PhasorSum::new(terms).vanishes());
    }
}

/// Every set of up to this many directions with one at 0 and no part zero, by trying all; the last vector is looked up.
fn by_trying(conductor: usize, most: usize) -> BTreeSet<Vec<usize>> {
    struct Trying {
        roots: Vec<u64>,
        most: usize,
        found: BTreeSet<Vec<usize>>,
    }
    impl Trying {
        fn extend(&mut self, chosen: &mut Vec<usize>, sum: u64) {
            let last = chosen[chosen.len() - 1];
            let wanted = PRIME - sum;
            if let Some(at) = self.roots.iter().skip(last + 1).position(|root| *root == wanted) {
                let star = [chosen.as_slice(), &[last + 1 + at]].concat();
                self.found.insert(turned_least(&star, self.roots.len()));
            }
            if chosen.len() + 1 < self.most {
                for next in last + 1..self.roots.len() {
                    let sum = (sum + self.roots[next]) % PRIME;
                    // Two opposite vectors are zero already.
                    let half = self.roots.len() / 2;
                    if sum != 0 && (next < half || !chosen.contains(&(next - half))) {
                        chosen.push(next);
                        self.extend(chosen, sum);
                        chosen.pop();
                    }
                }
            }
        }
    }
    let mut trying = Trying { roots: roots(conductor as u64), most, found: BTreeSet::new() };
    trying.extend(&mut vec![0], 1);
    let roots = trying.roots;
    let is_minimal = |star: &Vec<usize>| {
        (1..(1_usize << star.len()) - 1).all(|part| {
            let vectors = star.iter().enumerate().filter(|(place, _)| part >> place & 1 == 1);
            vectors.map(|(_, exponent)| roots[*exponent]).sum::<u64>() % PRIME != 0
        })
    };
    trying.found.into_iter().filter(is_minimal).collect()
}

#[test]
fn over_thirty_and_forty_two_directions_there_are_no_others() {
    for (conductor, most) in [(30, 12), (42, 9)] {
        let told: BTreeSet<Vec<usize>> = minimal_stars(most)
            .iter()
            .map(exponents)
            .filter(|star| star.iter().all(|exponent| exponent % (2310 / conductor) == 0))
            .map(|star| star.iter().map(|exponent| exponent / (2310 / conductor)).collect())
            .collect();
        assert_eq!(by_trying(conductor, most), told, "{conductor}");
    }
}

/// A sixth root of unity, `a + bω` with ω at 60°.
const SIXTHS: [(i32, i32); 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];

fn value(times: &[u32; 6]) -> (i32, i32) {
    let add = |(a, b): (i32, i32), (root, times): (&(i32, i32), &u32)| {
        (a + root.0 * *times as i32, b + root.1 * *times as i32)
    };
    SIXTHS.iter().zip(times).fold((0, 0), add)
}

/// How often each sixth root is taken, this many vectors in all.
fn taken(vectors: u32) -> Vec<[u32; 6]> {
    let mut all = Vec::new();
    for code in 0..(vectors + 1).pow(5) {
        let mut times = [0; 6];
        let mut left = code;
        for place in times.iter_mut().take(5) {
            *place = left % (vectors + 1);
            left /= vectors + 1;
        }
        let sum: u32 = times.iter().sum();
        if sum <= vectors {
            times[5] = vectors - sum;
            all.push(times);
        }
    }
    all
}

fn parts(times: &[u32; 6]) -> Vec<[u32; 6]> {
    (0..=times.iter().sum())
        .flat_map(taken)
        .filter(|part| part.iter().zip(times).all(|(one, most)| one <= most))
        .collect()
}

/// What the proof leaves to be gone through: vectors may stand in one direction, and no group of five is a single one.
#[test]
fn five_groups_of_two_and_more_sixth_roots_have_a_part_that_is_zero() {
    let zero_free = |times: &[u32; 6]| {
        (0..3).all(|at| times[at] == 0 || times[at + 3] == 0)
            && (0..2).all(|at| (0..3).any(|third| times[at + 2 * third] == 0))
    };
    // Over sixth roots alone nothing else is zero.
    assert!((1..=12).flat_map(taken).filter(zero_free).all(|times| value(&times) != (0, 0)));
    let groups: Vec<[u32; 6]> = (2..=4).flat_map(taken).filter(zero_free).collect();
    let mut tried = 0;
    for value_of_all in groups.iter().map(value).collect::<BTreeSet<_>>() {
        let alike: Vec<&[u32; 6]> = groups.iter().filter(|group| value(group) == value_of_all).collect();
        let size = |group: &[u32; 6]| group.iter().sum::<u32>();
        for code in 0..alike.len().pow(5) {
            let chosen: Vec<&[u32; 6]> =
                (0..5).map(|place| alike[code / alike.len().pow(place) % alike.len()]).collect();
            // In any order of the groups: they are sorted.
            if !chosen.is_sorted() || chosen.iter().map(|group| size(group)).sum::<u32>() > 12 {
                continue;
            }
            let sums = chosen.iter().map(|group| parts(group).iter().map(value).collect::<BTreeSet<_>>());
            let common = sums.reduce(|one, other| one.intersection(&other).copied().collect()).expect("five groups");
            // 0 and all of it are common; a third value is a part that is zero.
            assert!(common.len() > 2, "{chosen:?}");
            tried += 1;
        }
    }
    assert!(tried > 10, "{tried}");
}

#[test]
fn what_is_put_together_of_minimal_stars_is_taken_apart_and_nothing_else_is() {
    let stars = minimal_stars(12);
    let mut dice = Dice::new(107);
    for _ in 0..60 {
        let mut sum = PhasorSum::new(Vec::new());
        for _ in 0..=dice.below(2) {
            let star = &stars[dice.below(stars.len() as u64) as usize];
            let length = BigRational::from_integer((dice.below(3) as i64 + 1).into());
            sum = sum.plus(&star.sum().turned(&Turn::fraction(dice.below(2310) as i64, 2310)).scaled(&length));
        }
        if let Some(parts) = taken_apart(&sum, &stars) {
            let again = parts.iter().map(|part| stars[part.star].sum().turned(&part.turn).scaled(&part.length));
            let again = again.reduce(|one, other| one.plus(&other)).expect("parts");
            assert_eq!(again.collected(), sum.collected());
        }
        let one = Term { angle: Turn::fraction(1, 4620), weight: BigRational::from_integer(1.into()) };
        assert_eq!(taken_apart(&sum.plus(&PhasorSum::new(vec![one])), &stars), None);
    }
    for (place, star) in stars.iter().enumerate() {
        let parts = taken_apart(&star.sum().turned(&Turn::fraction(1, 9)), &stars).expect("a star of the list");
        assert_eq!(parts.iter().map(|part| part.star).collect::<Vec<_>>(), [place]);
    }
}

/// Of the shortest proofs: no stars of the list but regular polygons do with two polygons, as two share a corner at most.
#[test]
fn the_fewest_polygons_of_each_are_proved() {
    for star in minimal_stars(12) {
        let fewest = star.sum().fewest_polygons().expect("proved");
        assert_eq!(fewest == 1, star.class.is_regular());
        assert!(fewest != 2);
    }
}
