//! Are the firing orders of a crank star ranked rightly by torsional vibration? Against the known table of the six, and all of them in doubles.

use std::f64::consts::TAU;

use crankstar::engine::Cycle;
use crankstar::numbers;
use crankstar::page::{self, Document, Format, Language, Options};
use crankstar::report;
use crankstar::search::{self, Options as Search, Problem, RankedOrder, StarTorsion, search as best, torsion};
use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::german::phrases;

fn judged(cylinders: u32, cycle: Cycle, shape: Option<&[i64]>) -> (search::Front, search::Torsion) {
    let front = best(&Problem::inline(cylinders, cycle, &[1, 2]), &Search::default()).expect("a front");
    let whole = |value: &i64| BigRational::from_integer(BigInt::from(*value));
    let shape = shape.map(|shape| shape.iter().map(whole).collect());
    let torsion = torsion(&front, shape).expect("in line");
    (front, torsion)
}

fn lengths(ranked: &RankedOrder) -> Vec<String> {
    let closed = |sum| numbers::modulus(sum).map(|form| form.to_string()).unwrap_or_default();
    ranked.sums.iter().map(closed).collect()
}

/// The same order, read from cylinder 1 the other way round: that of the mirror image of the crank.
fn mirrored(order: &str) -> String {
    let names: Vec<&str> = order.split('-').collect();
    let rest = names[1..].iter().rev().copied();
    [names[0]].into_iter().chain(rest).collect::<Vec<_>>().join("-")
}

/// `theory-gas`, section 3: four firing orders of the throws 0-240-120-120-240-0, Δ = 6, 5, 4, 3, 2, 1.
#[test]
fn the_firing_orders_of_the_six_have_the_sums_of_the_table() {
    let (front, torsion) = judged(6, Cycle::FourStroke, None);
    assert_eq!(front.stars.len(), 1);
    let orders: Vec<String> = torsion.orders.iter().map(ToString::to_string).collect();
    assert_eq!(orders, ["½", "1", "1½"]);
    assert_eq!(torsion.repeats_after.to_string(), "3");
    let StarTorsion { all, best } = &torsion.stars[0];
    assert_eq!(*all, 4);
    let found: Vec<(String, Vec<String>)> = best.iter().map(|ranked| (ranked.name(), lengths(ranked))).collect();
    // The star that the search finds is the mirror image of that of the table.
    let right = [
        ("1-2-3-6-5-4", ["4√3", "0", "3"]),
        ("1-5-4-6-2-3", ["2√7", "0", "7"]),
        ("1-2-4-6-5-3", ["2√13", "0", "1"]),
        ("1-5-3-6-2-4", ["2√3", "0", "9"]),
    ];
    let right = right.map(|(order, lengths)| (mirrored(order), lengths.map(str::to_owned).to_vec()));
    assert_eq!(found, right);
}

#[test]
fn a_crank_of_five_has_one_firing_order() {
    let (_, torsion) = judged(5, Cycle::FourStroke, None);
    for star in &torsion.stars {
        assert_eq!((star.all, star.best.len()), (1, 1));
    }
    let of = |order: &str| {
        let mut all = torsion.stars.iter().flat_map(|star| &star.best);
        let ranked = all.find(|ranked| [order.to_owned(), mirrored(order)].contains(&ranked.name())).expect(order);
        ranked.sums.iter().map(|sum| numbers::evaluate(sum).norm()).collect::<Vec<f64>>()
    };
    for (order, half, one) in
        [("1-2-4-5-3", 4.979_797, 0.449_028), ("1-5-2-3-4", 0.449_028, 4.979_797), ("1-4-5-3-2", 4.749_980, 1.561_312)]
    {
        let found = of(order);
        assert!((found[0] - half).abs() < 1e-6 && (found[1] - one).abs() < 1e-6, "{order}: {found:?}");
    }
}

/// `|Σ Δ_j e^{−iκφ_j}|` in doubles at the first half of the minor orders.
fn in_doubles(order: &[usize], shape: &[f64]) -> Vec<f64> {
    let count = order.len();
    let of_order = |index: usize| {
        let vector = |(step, &cylinder): (usize, &usize)| {
            Complex::from_polar(1.0, -TAU * (index * step) as f64 / count as f64) * shape[cylinder]
        };
        order.iter().enumerate().map(vector).sum::<Complex<f64>>().norm()
    };
    (1..=count / 2).map(of_order).collect()
}

/// All orders in which the two cylinders of a direction change places.
fn all_orders(order: &[usize]) -> Vec<Vec<usize>> {
    let half = order.len() / 2;
    let swapped = |choice: usize| {
        let mut swapped = order.to_vec();
        for place in (1..half).filter(|place| choice >> (place - 1) & 1 == 1) {
            swapped.swap(place, place + half);
        }
        swapped
    };
    (0..1 << (half - 1)).map(swapped).collect()
}

#[test]
fn the_orders_that_are_listed_are_those_that_no_other_beats() {
    for (cylinders, shape) in [(4, None), (8, None), (8, Some(&[5, 4, 4, 2, 1, 0, -1, -3])), (10, None)] {
        let (front, torsion) = judged(cylinders, Cycle::FourStroke, shape.map(|shape: &[i64; 8]| &shape[..]));
        let falling: Vec<f64> = (1..=cylinders).rev().map(f64::from).collect();
        let shape = shape.map_or(falling, |shape| shape.iter().map(|&value| value as f64).collect());
        for (star, judged) in front.stars.iter().zip(&torsion.stars) {
            let all = all_orders(star.firing_order.as_ref().expect("it fires evenly"));
            assert_eq!(judged.all, all.len());
            let lengths: Vec<Vec<f64>> = all.iter().map(|order| in_doubles(order, &shape)).collect();
            let beats = |one: &[f64], other: &[f64]| {
                let pairs = || one.iter().zip(other);
                pairs().all(|(one, other)| *one < other + 1e-9) && pairs().any(|(one, other)| *one < other - 1e-9)
            };
            let is_best = |own: &Vec<f64>| !lengths.iter().any(|other| beats(other, own));
            let right = lengths.iter().filter(|own| is_best(own)).count();
            let equal: usize = judged.best.iter().map(|ranked| ranked.equal).sum();
            assert_eq!(equal, right, "{cylinders} cylinders");
            let strongest =
                |ranked: &RankedOrder| in_doubles(&ranked.firing_order, &shape).into_iter().fold(0.0, f64::max);
            let rising: Vec<f64> = judged.best.iter().map(strongest).collect();
            assert!(rising.windows(2).all(|pair| pair[0] < pair[1] + 1e-9), "{rising:?}");
            for ranked in &judged.best {
                let own = in_doubles(&ranked.firing_order, &shape);
                let sums = ranked.sums.iter().map(|sum| numbers::evaluate(sum).norm());
                assert!(sums.zip(&own).all(|(sum, own)| (sum - own).abs() < 1e-9));
                assert!(is_best(&own), "{}", ranked.name());
            }
        }
    }
}

#[test]
fn a_shape_of_another_length_is_refused_and_so_is_a_star_of_too_many_firing_orders() {
    let (front, _) = judged(4, Cycle::FourStroke, None);
    let short = vec![BigRational::from_integer(1.into()); 3];
    let refused = torsion(&front, Some(short)).expect_err("three values");
    assert!(refused.to_string().contains("3 values for 4 cylinders"));
    let vee = |cylinders| Problem::vee(cylinders, Cycle::FourStroke, crankstar::Turn::fraction(1, 4), &[2]);
    let refused =
        search::mode_shape(&vee(8), Some(vec![BigRational::from_integer(1.into()); 8])).expect_err("4 throws");
    assert!(refused.to_string().contains("8 values for 4 throws"), "{refused}");
    assert_eq!(search::mode_shape(&vee(18), None).expect("256 firing orders").len(), 9);
    let refused = search::mode_shape(&vee(20), None).expect_err("512 firing orders");
    assert!(refused.to_string().contains("2^9 firing orders"), "{refused}");
}

#[test]
fn the_eight_firing_orders_of_the_cross_plane_v8_are_judged_by_the_deflections_of_its_throws() {
    let vee = Problem::vee(8, Cycle::FourStroke, crankstar::Turn::fraction(1, 4), &[1, 2]);
    let front = best(&vee, &Search::default()).expect("a front");
    let torsion = torsion(&front, None).expect("four throws");
    assert_eq!(torsion.shape.len(), 4);
    // Both cylinders of a throw have its deflection.
    let shape: Vec<f64> = [4, 3, 2, 1, 4, 3, 2, 1].map(f64::from).into();
    for (star, judged) in front.stars.iter().zip(&torsion.stars) {
        let all = all_orders(star.firing_order.as_ref().expect("it fires evenly"));
        assert_eq!((judged.all, all.len()), (8, 8));
        for ranked in &judged.best {
            let own = in_doubles(&ranked.firing_order, &shape);
            assert!(all.contains(&ranked.firing_order), "{}", ranked.name());
            let sums = ranked.sums.iter().map(|sum| numbers::evaluate(sum).norm());
            assert!(sums.zip(&own).all(|(sum, own)| (sum - own).abs() < 1e-9));
        }
    }
}

#[test]
fn a_page_and_a_document_tell_the_firing_orders() {
    let (front, torsion) = judged(6, Cycle::FourStroke, None);
    let mut page = Document::new("search", "".to_owned());
    page.blocks = report::search_torsion(&front, &torsion);
    let text = page::write(&page, Format::GITHUB, &Options::default()).remove(0).text;
    assert!(
        text.contains("**Star 1** has 4 firing orders. 1-4-5-6-3-2 keeps the strongest minor order smallest"),
        "{text}"
    );
    let unknown: Vec<&str> = phrases(&page).into_iter().filter(|words| !Language::De.knows(words)).collect();
    let unknown: Vec<&&str> = unknown.iter().filter(|words| words.chars().any(char::is_alphabetic)).collect();
    assert!(unknown.is_empty(), "no German for {unknown:#?}");
    let document = search::document(&front).with_torsion(&torsion);
    assert_eq!(document.stars[0].torsion.len(), 4);
    assert_eq!(document.stars[0].torsion[0].sums[2].order, "3/2");
}
