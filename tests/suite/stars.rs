//! Do the theorems on stars hold? Against every star of up to ten throws and of twelve by plain arithmetic, against the search, against random stars above.

use std::collections::{BTreeMap, BTreeSet};

use crankstar::engine::Cycle;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::numbers;
use crankstar::order::Masses;
use crankstar::search::{self, Options, Problem, search as complete};
use crankstar::stars::{self, By, Counted, Fate, Pins, Star};
use crankstar::verdict::{self, EveryOrderTheorem};
use num_bigint::BigUint;
use num_rational::BigRational;

/// The cyclotomic polynomial of an order, the lowest coefficient first.
fn cyclotomic(order: usize) -> Vec<i64> {
    let mut left = vec![0; order + 1];
    (left[0], left[order]) = (-1, 1);
    for divisor in (1..order).filter(|divisor| order.is_multiple_of(*divisor)) {
        left = divided(left, &cyclotomic(divisor)).0;
    }
    left
}

/// Quotient and remainder by a polynomial that begins with 1.
fn divided(mut left: Vec<i64>, by: &[i64]) -> (Vec<i64>, Vec<i64>) {
    let degree = by.len() - 1;
    let mut quotient = vec![0; left.len().saturating_sub(degree)];
    for at in (0..quotient.len()).rev() {
        let factor = left[at + degree];
        quotient[at] = factor;
        by.iter().enumerate().for_each(|(place, coefficient)| left[at + place] -= factor * coefficient);
    }
    left.truncate(degree);
    (quotient, left)
}

/// Moments that are zero, told by polynomials: the orders of roots of unity, 1 left out.
struct Plain(Vec<(usize, Vec<i64>)>);

impl Plain {
    fn new(directions: usize) -> Self {
        let divisors = (2..=directions).filter(|divisor| directions.is_multiple_of(*divisor));
        Plain(divisors.map(|divisor| (divisor, cyclotomic(divisor))).collect())
    }

    /// Throws at any places, in units that make them whole.
    fn lost(&self, throws: &[u32], places: &[i64]) -> BTreeSet<usize> {
        let mean: i64 = places.iter().sum();
        let is_zero = |(divisor, polynomial): &&(usize, Vec<i64>)| {
            let mut sum = vec![0; *divisor];
            for (throw, place) in throws.iter().zip(places) {
                sum[*throw as usize % divisor] += places.len() as i64 * place - mean;
            }
            divided(sum, polynomial).1.iter().all(|left| *left == 0)
        };
        self.0.iter().filter(is_zero).map(|(divisor, _)| *divisor).collect()
    }
}

/// Every star with the first throw at 0.
fn every_star(directions: u32, each: u32, visit: &mut dyn FnMut(&[u32])) {
    fn fill(left: &mut [u32], placed: &mut Vec<u32>, places: usize, visit: &mut dyn FnMut(&[u32])) {
        if placed.len() == places {
            return visit(placed);
        }
        for direction in 0..left.len() {
            if left[direction] > 0 {
                left[direction] -= 1;
                placed.push(direction as u32);
                fill(left, placed, places, visit);
                placed.pop();
                left[direction] += 1;
            }
        }
    }
    let mut left = vec![each; directions as usize];
    left[0] -= 1;
    fill(&mut left, &mut vec![0], (directions * each) as usize, visit);
}

/// How many stars lose exactly these orders of roots.
fn census(pins: Pins) -> BTreeMap<BTreeSet<usize>, u64> {
    let plain = Plain::new(pins.directions as usize);
    let places: Vec<i64> = (0..i64::from(pins.throws())).collect();
    let mut census = BTreeMap::new();
    every_star(pins.directions, pins.each, &mut |throws| *census.entry(plain.lost(throws, &places)).or_default() += 1);
    census
}

/// The same of throws each in a direction of its own, faster: the sums of all roots together in one number, each coordinate in eight bits of it, its 0 in their middle.
fn quick_census(directions: u32) -> BTreeMap<BTreeSet<usize>, u64> {
    let plain = Plain::new(directions as usize);
    let (mut middle, mut masks, mut steps) = (0_u128, Vec::new(), vec![0_i128; directions as usize]);
    let mut at = 0;
    for (divisor, polynomial) in &plain.0 {
        let bits = at..at + polynomial.len() - 1;
        masks.push(bits.clone().fold(0_u128, |mask, byte| mask | 255 << (8 * byte)));
        middle |= bits.fold(0, |middle, byte| middle | 128 << (8 * byte));
        for (throw, step) in steps.iter_mut().enumerate() {
            let mut power = vec![0; *divisor];
            power[throw % divisor] = 1;
            for (byte, coordinate) in divided(power, polynomial).1.into_iter().enumerate() {
                assert!(coordinate.abs() <= 1, "sums of places keep within 127 of 0");
                *step += i128::from(coordinate) << (8 * (at + byte));
            }
        }
        at += polynomial.len() - 1;
    }
    assert!(at <= 15 && directions * (directions - 1) / 2 < 128);
    struct Walk<'a> {
        steps: &'a [i128],
        middle: u128,
        masks: &'a [u128],
        found: Vec<u64>,
    }
    impl Walk<'_> {
        fn fill(&mut self, left: u32, place: i128, sum: u128) {
            if left == 0 {
                let off = sum ^ self.middle;
                let lost = self.masks.iter().enumerate();
                let lost = lost.fold(0, |lost, (at, mask)| lost | usize::from(off & mask == 0) << at);
                self.found[lost] += 1;
                return;
            }
            let mut others = left;
            while others != 0 {
                let throw = others.trailing_zeros();
                others &= others - 1;
                let more = self.steps[throw as usize] * place;
                self.fill(left & !(1 << throw), place + 1, sum.wrapping_add_signed(more));
            }
        }
    }
    let mut walk = Walk { steps: &steps, middle, masks: &masks, found: vec![0; 1 << masks.len()] };
    walk.fill((1 << directions) - 2, 1, middle);
    let lost = |bits: usize| (0..masks.len()).filter(|at| bits >> at & 1 == 1).map(|at| plain.0[at].0).collect();
    (0..).zip(&walk.found).filter(|(_, stars)| **stars > 0).map(|(bits, stars)| (lost(bits), *stars)).collect()
}

#[test]
fn the_quick_census_is_the_plain_one() {
    for directions in 2..=8 {
        assert_eq!(quick_census(directions), census(Pins::once(directions)), "{directions}");
    }
}

/// All sets of divisors above 1 of a number, as orders and as the orders of their roots.
fn sets(directions: u32) -> Vec<(Vec<u32>, BTreeSet<usize>)> {
    let roots: Vec<u32> = (2..=directions).filter(|root| directions.is_multiple_of(*root)).collect();
    let set = |bits: u32| {
        let chosen: Vec<u32> =
            roots.iter().enumerate().filter(|(at, _)| bits >> at & 1 == 1).map(|(_, root)| *root).collect();
        (chosen.iter().map(|root| directions / root).collect(), chosen.iter().map(|root| *root as usize).collect())
    };
    (1..1 << roots.len()).map(set).collect()
}

#[test]
fn every_set_of_orders_is_lost_by_as_many_stars_as_the_theorems_say() {
    let (mut never, mut lost, mut counted) = (0, 0, 0);
    let two_stroke = (2..=10).chain([12]).map(|directions| (Pins::once(directions), quick_census(directions)));
    let four_stroke = (1..=5).map(|directions| Pins { directions, each: 2 }).map(|pins| (pins, census(pins)));
    for (pins, census) in two_stroke.chain(four_stroke) {
        for (orders, roots) in sets(pins.directions) {
            let found: u64 = census.iter().filter(|(lost, _)| lost.is_superset(&roots)).map(|(_, stars)| stars).sum();
            match stars::fate(pins, &orders) {
                Fate::Never(why) => {
                    assert_eq!(found, 0, "{pins:?} {orders:?}");
                    assert!(why.orders.iter().all(|order| orders.contains(order)));
                    never += 1;
                }
                Fate::Lost(made) => {
                    assert!(found > 0, "{pins:?} {orders:?}");
                    let places: Vec<i64> = (0..i64::from(pins.throws())).collect();
                    let of_star = Plain::new(pins.directions as usize).lost(made.star.throws(), &places);
                    assert!(of_star.is_superset(&roots), "{pins:?} {orders:?}");
                    lost += 1;
                }
                Fate::Open => {}
            }
            if let Some(count) = stars::count(pins, &orders) {
                assert_eq!(count.stars, BigUint::from(found), "{pins:?} {orders:?}");
                counted += 1;
            }
        }
    }
    assert!(never > 10 && lost > 10 && counted > 10, "{never} {lost} {counted}");
}

#[test]
fn the_counts_are_those_of_the_search() {
    let found = |cylinders, cycle, orders: &[u32]| {
        let front = complete(&Problem::inline(cylinders, cycle, orders), &Options::default()).expect("a front");
        let star = &front.stars[0];
        assert!(star.moments.iter().all(|moment| moment.sum.vanishes()));
        [star.stars, star.classes].map(|count| BigUint::from(count.expect("counted")))
    };
    for (cylinders, orders) in [(6, &[1][..]), (10, &[1]), (12, &[1]), (14, &[1])] {
        let [stars, classes] = found(cylinders, Cycle::TwoStroke, orders);
        let count = stars::count(Pins::once(cylinders), orders).expect("a count");
        assert_eq!(count.stars, stars, "{cylinders}");
        assert!(count.classes.is_none_or(|told| told == classes), "{cylinders}");
    }
    for (cylinders, orders) in [(6, &[1][..]), (8, &[1, 2]), (10, &[1]), (12, &[1, 2, 3])] {
        let [stars, classes] = found(cylinders, Cycle::FourStroke, orders);
        let count = stars::count(Pins::inline(cylinders, true), orders).expect("a count");
        assert_eq!((count.stars, count.classes), (stars, Some(classes)), "{cylinders}");
    }
    // Theorem 8 has no count for fewer orders, and there are more stars.
    assert_eq!(stars::count(Pins::inline(12, true), &[1, 2]), None);
    // 48 of them are no mirror images: what they leave are odd orders, which exist only with a pin offset.
    let existing: Vec<u32> = [1, 2, 4, 6, 8].to_vec();
    assert_eq!(found(12, Cycle::FourStroke, &existing)[0], BigUint::from(120_u32 + 48));
}

#[test]
fn exact_covers_count_the_stars_of_two_primes() {
    for (throws, covers, all) in
        [(12, 61, 1464_u64), (18, 6286, 3_620_736), (20, 741, 4_268_160), (24, 1_682_445, 0), (28, 9136, 0)]
    {
        let count = stars::count(Pins::once(throws), &[1]).expect("a count");
        let Counted::Covers(_, found) = count.by else { panic!("{throws}") };
        assert_eq!(found, BigUint::from(covers as u64), "{throws}");
        assert!(all == 0 || count.stars == BigUint::from(all), "{throws}");
    }
}

#[test]
fn the_listed_stars_lose_order_1_and_a_changed_one_does_not() {
    for (throws, number) in [(6_u32, 4), (10, 48), (14, 1440), (15, 96), (21, 2880)] {
        let listed = stars::listed(throws, 3000);
        let different: BTreeSet<&[u32]> = listed.iter().map(Star::throws).collect();
        assert_eq!((listed.len(), different.len()), (number, number), "{throws}");
        assert_eq!(stars::count(Pins::once(throws), &[1]).expect("a count").stars, BigUint::from(number));
        for star in listed.iter().step_by(number / 4) {
            assert!(star.loses(1), "{throws}");
            // Two throws exchanged change the sum by a difference of directions, which is not 0.
            let mut changed = star.throws().to_vec();
            changed.swap(1, throws as usize / 2);
            assert!(!Star::new(throws, &changed).loses(1), "{throws}");
        }
        assert!(stars::listed(throws, number - 1).is_empty(), "no more than were asked for");
    }
}

#[test]
fn theorem_2_tells_which_numbers_lose_orders_1_2_and_4() {
    let fates = |orders: &[u32]| -> Vec<u32> {
        (2..=30).filter(|&throws| matches!(stars::fate(Pins::once(throws), orders), Fate::Lost(_))).collect()
    };
    let is_told = |throws| {
        (0..3).all(|j| {
            let orders: Vec<u32> = (0..=j).map(|power| 1 << power).collect();
            !matches!(stars::fate(Pins::once(throws), &orders), Fate::Open)
        })
    };
    assert!((2..=60).all(is_told));
    assert_eq!(fates(&[1]), [6, 10, 12, 14, 15, 18, 20, 21, 22, 24, 26, 28, 30]);
    assert_eq!(fates(&[1, 2]), [12, 15, 20, 21, 24, 28, 30]);
    assert_eq!(fates(&[1, 2, 4]), [15, 21, 24, 30]);
}

#[test]
fn thirty_is_the_first_two_stroke_engine_without_any_moment() {
    let every = |throws: u32| -> Vec<u32> { [1].into_iter().chain((2..=2 * throws).step_by(2)).collect() };
    let without_any = |throws: &u32| matches!(stars::fate(Pins::once(*throws), &every(*throws)), Fate::Lost(_));
    let told = |throws: &u32| !matches!(stars::fate(Pins::once(*throws), &every(*throws)), Fate::Open);
    assert!((2..=100).all(|throws| told(&throws)));
    assert_eq!((2..=100).filter(without_any).collect::<Vec<u32>>(), [30, 42, 60, 66, 70, 78, 84, 90]);
    for throws in [30, 42, 90] {
        let Fate::Lost(made) = stars::fate(Pins::once(throws), &every(throws)) else { panic!("{throws}") };
        assert!(matches!(made.by, By::EveryMoment { .. }));
        assert_eq!(made.star.first_left(), None, "{throws}");
        let mut changed = made.star.throws().to_vec();
        changed.swap(0, 1);
        assert!(Star::new(throws, &changed).first_left().is_some(), "{throws}");
    }
    // The engine itself, by the decision of every order.
    let problem = Problem::inline(30, Cycle::TwoStroke, &[1, 2]);
    let front = search::answer(&problem, &Options::default()).expect("at once");
    assert_eq!((front.stars.len(), front.judged, front.described.is_some()), (1, 0, true));
    let engine = front.stars[0].engine(&problem).expect("an engine");
    let Ok(EveryOrderTheorem::Period(theorem)) = verdict::every_order(&engine, Masses::Reciprocating) else { panic!() };
    assert!(theorem.moment.first.is_none());
    assert_eq!(theorem.force.survivors().residues, [0]);
    assert_eq!((theorem.force.survivors().modulus, theorem.force.survivors().order_one), (30, false));
}

#[test]
fn fifteen_without_order_1_loses_2_4_and_8_but_not_6_and_10() {
    for star in stars::listed(15, 100) {
        assert!([1, 2, 4, 8].iter().all(|order| star.loses(*order)));
        assert_eq!((star.loses(6), star.loses(10), star.first_left()), (false, false, Some(6)));
    }
    for orders in [[1, 6], [1, 10]] {
        assert!(matches!(stars::fate(Pins::once(15), &orders), Fate::Never(_)));
    }
}

#[test]
fn what_is_left_of_order_2_is_the_bound_of_theorem_6() {
    for (throws, prime) in [(6, 3), (10, 5), (14, 7)] {
        let [bound] = stars::least(Pins::once(throws), &[1, 2])[..] else { panic!("{throws}") };
        assert_eq!((bound.order, bound.factor, bound.of), (2, 2, prime));
        let front = complete(&Problem::inline(prime, Cycle::TwoStroke, &[1]), &Options::default()).expect("a front");
        let least = front.stars[0].moments[0].sum.scaled(&BigRational::from_integer(2.into()));
        let lengths = stars::listed(throws, 2000).into_iter().map(|star| star.moment(2));
        let shortest = lengths.min_by(|a, b| numbers::evaluate(a).norm().total_cmp(&numbers::evaluate(b).norm()));
        assert!(shortest.expect("stars").is_as_long_as(&least), "{throws}");
    }
}

#[test]
fn what_a_theorem_answers_is_what_the_search_finds() {
    for (cylinders, orders) in [(6, &[1][..]), (10, &[1]), (14, &[1])] {
        let problem = Problem::inline(cylinders, Cycle::TwoStroke, orders);
        let told = search::described(&problem).expect("a theorem");
        let found = complete(&problem, &Options::default()).expect("a front");
        let values = |front: &search::Front| {
            front.stars.iter().map(|star| (star.throws.clone(), star.stars, star.classes)).collect::<Vec<_>>()
        };
        assert_eq!(values(&told), values(&found), "{cylinders}");
        assert_eq!((told.all.clone(), told.judged), (found.all, 0));
    }
    for (cylinders, orders) in [(7, &[1][..]), (10, &[1, 2]), (12, &[1, 2])] {
        assert!(search::described(&Problem::inline(cylinders, Cycle::TwoStroke, orders)).is_none(), "{cylinders}");
    }
    // What is compared besides needs a search, and so does a grid.
    let problem = Problem::inline(15, Cycle::TwoStroke, &[1]);
    assert!(search::described(&problem).is_some());
    assert!(search::described(&Problem { neighbours: true, ..problem.clone() }).is_none());
    assert!(search::described(&Problem { grid: Some(15), ..problem }).is_none());
    assert!(complete(&Problem::inline(30, Cycle::TwoStroke, &[1, 6]), &Options::default()).is_err());
}

/// Numbers that look random, the same in every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

#[test]
fn no_random_star_loses_what_none_can() {
    let mut dice = Dice(31);
    let mut lost_something = 0;
    for throws in 13..=40_u32 {
        let plain = Plain::new(throws as usize);
        let places: Vec<i64> = (0..i64::from(throws)).collect();
        for round in 0..6 {
            // Half of them are mirrored at half a turn, so that they lose even orders.
            let mut star: Vec<u32> = (0..throws).collect();
            for at in (1..throws as usize).rev() {
                star.swap(at, dice.below(at + 1));
            }
            if round % 2 == 0 && throws % 2 == 0 {
                let half: Vec<u32> = star.iter().copied().filter(|throw| *throw < throws / 2).collect();
                let other = half.iter().rev().map(|throw| throw + throws / 2);
                star = half.iter().copied().chain(other).collect();
            }
            let lost = plain.lost(&star, &places);
            let orders: Vec<u32> =
                (1..=throws).filter(|order| lost.contains(&((throws / gcd(throws, *order)) as usize))).collect();
            assert!(!matches!(stars::fate(Pins::once(throws), &orders), Fate::Never(_)), "{star:?} loses {orders:?}");
            lost_something += usize::from(!orders.is_empty());
            let judged = Star::new(throws, &star);
            assert!((1..throws).all(|order| judged.loses(order) == orders.contains(&order)));
        }
    }
    assert!(lost_something > 20);
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn theorem_9_finds_every_star_of_six_unevenly_spaced_throws() {
    let plain = Plain::new(6);
    let spacings: [([i64; 6], usize); 7] = [
        ([0, 1, 2, 3, 4, 5], 4),
        ([0, 1, 2, 4, 5, 6], 2),
        ([0, 2, 4, 5, 7, 9], 2),
        ([0, 1, 3, 4, 6, 7], 2),
        ([0, 1, 2, 3, 4, 6], 0),
        ([0, 2, 3, 5, 6, 8], 0),
        ([0, 1, 3, 7, 12, 20], 0),
    ];
    for (places, _) in spacings {
        let rational: Vec<BigRational> =
            places.iter().map(|place| BigRational::from_integer((*place).into())).collect();
        let mut told = stars::stars_of(&rational);
        let mut found = Vec::new();
        every_star(6, 1, &mut |throws| {
            if plain.lost(throws, &places).contains(&6) {
                found.push(throws.to_vec());
            }
        });
        told.sort();
        assert_eq!(told, found, "{places:?}");
    }
    let counts =
        spacings.map(|(places, _)| stars::stars_of(&places.map(|place| BigRational::from_integer(place.into()))).len());
    assert_eq!(counts[..2], [4, 2]);
    assert!(counts.contains(&0));
}

#[test]
fn five_cylinders_at_the_golden_ratio_lose_order_1() {
    // The arm sin(4πx/5) at angle 2πx/5, as a sum of two rotating vectors.
    let half = BigRational::new(1.into(), 2.into());
    let moment = |order: i64| {
        let terms = (0..5_i64).flat_map(|x| {
            let term = |sign: i64| Term {
                angle: &Turn::fraction((order + 2 * sign) * x, 5) - &Turn::fraction(sign, 4),
                weight: half.clone(),
            };
            [term(1), term(-1)]
        });
        PhasorSum::new(terms.collect())
    };
    assert!(moment(1).vanishes() && !moment(2).vanishes());
    assert!((numbers::evaluate(&moment(2)).norm() - 2.5).abs() < 1e-12);
}

#[test]
fn no_bank_angle_helps_the_couple_of_a_v_on_four_or_five_pins() {
    for (pins, angle) in [(4_u32, 90_i64), (4, 60), (5, 72), (5, 90), (6, 60)] {
        let problem = Problem::vee(2 * pins, Cycle::FourStroke, Turn::fraction(angle, 360), &[1]);
        let told = search::theorems(&problem);
        assert_eq!(told.never.is_empty(), pins == 6, "{pins} pins");
        let front = complete(&problem, &Options::default()).expect("a front");
        let direct = &front.stars[0].moments[0];
        assert_eq!(direct.sum.vanishes(), pins == 6);
        // The couple that turns with the crank is that of a bank, twice.
        let line = complete(&Problem::inline(pins, Cycle::TwoStroke, &[1]), &Options::default()).expect("a front");
        let twice = line.stars[0].moments[0].sum.scaled(&BigRational::from_integer(2.into()));
        assert!(direct.sum.is_as_long_as(&twice), "{pins} pins, {angle}°");
    }
}

#[test]
fn bad_numbers_of_throws_have_no_answer_and_no_panic() {
    for pins in
        [Pins::once(0), Pins::once(100_000), Pins { directions: u32::MAX, each: 2 }, Pins { directions: 4, each: 0 }]
    {
        assert_eq!(stars::fate(pins, &[1, 2]), Fate::Open, "{pins:?}");
        assert_eq!(stars::count(pins, &[1]), None, "{pins:?}");
    }
    assert_eq!(stars::fate(Pins::once(1), &[1]), stars::fate(Pins::once(1), &[2]));
    assert!(stars::decompositions(&[]).is_empty() && stars::stars_of(&[]).is_empty());
}
