//! Does the page in `reports/stars` still say what the program writes, and is each of its numbers right?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite stars_page` writes it anew.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;
use std::fs;
use std::sync::LazyLock;

use crankstar::engine::Cycle;
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::order::Masses;
use crankstar::page::{Document, Format, Language};
use crankstar::proof::Quantity;
use crankstar::report::{self, StarsStudy};
use crankstar::search::{self, Options, Problem};
use crankstar::verdict::{self, EveryOrderTheorem};

use crate::least_moments::covers;
use crate::support::german::{has_words, phrases};
use crate::support::golden;
use crate::support::pages;
use crate::support::program::call;

static STUDY: LazyLock<StarsStudy> = LazyLock::new(|| StarsStudy::new(&Options::default()).expect("stars"));

#[test]
fn the_page_of_stars_is_as_stored() {
    let page = pages::files(&report::stars_page(&STUDY), Format::GITHUB).into_iter();
    let files = page.chain(report::stars_layouts(&STUDY)).map(|file| (file.name, file.text));
    golden::compare(&golden::reports().join("stars"), &files.collect());
}

#[test]
fn the_page_of_stars_and_what_a_search_knows_have_german_for_every_phrase() {
    let problems =
        [(7, &[1, 2][..]), (10, &[1, 2]), (15, &[1, 2]), (20, &[1]), (22, &[1, 2]), (30, &[1, 2]), (8, &[2, 4])];
    let asked = problems.map(|(cylinders, orders)| Problem::inline(cylinders, Cycle::TwoStroke, orders));
    let four_stroke = Problem::inline(8, Cycle::FourStroke, &[1, 2]);
    let mut documents: Vec<Document> = asked.iter().chain([&four_stroke]).map(report::search_theorems).collect();
    let thirty = search::answer(&asked[5], &Options::default()).expect("a theorem");
    documents.extend([report::search_answer(&thirty), report::search_page(&thirty)]);
    documents.extend([report::stars_page(&STUDY), report::stars_answer(&STUDY)]);
    let phrases = documents.iter().flat_map(phrases);
    let missing: Vec<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

/// The rows of the stored page's tables by the heading of their first two columns.
fn tables() -> BTreeMap<String, Vec<Vec<String>>> {
    let text = fs::read_to_string(golden::reports().join("stars/README.md")).expect("the page");
    let mut tables: BTreeMap<String, Vec<Vec<String>>> = BTreeMap::new();
    let mut heading = None;
    for line in text.lines() {
        let Some(row) = line.strip_prefix("| ").and_then(|line| line.strip_suffix(" |")) else {
            heading = None;
            continue;
        };
        let cells: Vec<String> = row.split(" | ").map(str::to_owned).collect();
        match &heading {
            None => heading = Some(cells.join("|")),
            Some(_) if row.starts_with("---") => {}
            Some(heading) => tables.entry(heading.clone()).or_default().push(cells),
        }
    }
    tables
}

pub fn table(begins: &str) -> Vec<Vec<String>> {
    let all = tables();
    all.into_iter().find(|(heading, _)| heading.starts_with(begins)).unwrap_or_else(|| panic!("no table {begins}")).1
}

pub fn whole(cell: &str) -> u64 {
    cell.replace('\u{202f}', "").parse().unwrap_or_else(|_| panic!("{cell} is not a number"))
}

/// What stands behind ≈ or is exact, as a decimal with the room of its last digit.
pub fn decimal(cell: &str) -> (f64, f64) {
    let text = cell.replace(['$', '`', '*'], "");
    let text =
        text.rsplit("\\approx").next().and_then(|text| text.rsplit('≈').next()).expect("a number").trim().to_owned();
    let (mantissa, power) = match text.split_once("·10") {
        Some((mantissa, power)) => {
            let digit = |sign: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == sign);
            let digits = power.chars().filter_map(digit).fold(0, |number, digit| 10 * number + digit as i32);
            (mantissa.to_owned(), if power.contains('⁻') { -digits } else { digits })
        }
        None => (text, 0),
    };
    let places = mantissa.split_once('.').map_or(0, |(_, places)| places.len());
    let scale = 10_f64.powi(power);
    let value: f64 = mantissa.parse().unwrap_or_else(|_| panic!("{cell} is not a decimal"));
    (value * scale, scale * 0.6 * 10_f64.powi(-(places as i32)))
}

fn primes(number: u64) -> Vec<u64> {
    let is_prime = |candidate: u64| (2..candidate).all(|divisor| !candidate.is_multiple_of(divisor));
    (2..=number).filter(|candidate| number.is_multiple_of(*candidate) && is_prime(*candidate)).collect()
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The prime q for which these orders bring throws 1/q of a turn apart together: their roots of unity have every order that q divides as often as the number
/// of throws. Of several primes that which asks for the fewest of them, then the least.
fn obstruction(number: u64, orders: &[u64]) -> Option<u64> {
    let roots: BTreeSet<u64> = orders.iter().map(|order| number / gcd(number, *order)).collect();
    let asked = |prime: u64| {
        let is_whole = |root: &u64| !(number / root).is_multiple_of(prime);
        (1..=number).filter(|root| number.is_multiple_of(*root)).filter(is_whole).collect::<BTreeSet<u64>>()
    };
    let forbidden = primes(number).into_iter().filter(|prime| asked(*prime).is_subset(&roots));
    forbidden.min_by_key(|prime| asked(*prime).len())
}

/// By the criteria of the page, in other words: no order to be lost may be a power of a prime alone.
#[test]
fn what_each_number_loses_follows_from_its_factors() {
    let rows = table("Cylinders|Factors|Order 1|");
    assert_eq!(rows.len(), 29);
    for row in rows {
        let number = whole(&row[0]);
        for (cell, power) in [(2, 0), (3, 1), (4, 2)] {
            let yes = primes(number / gcd(number, 1 << power)).len() > 1;
            assert_eq!(row[cell] == "yes", yes, "{row:?}");
        }
        let odd = primes(number).iter().filter(|prime| **prime > 2).count();
        assert_eq!(row[5] == "yes", number.is_multiple_of(2) && odd > 1, "{row:?}");
        let every: Vec<u64> = [1].into_iter().chain((2..=2 * number).step_by(2)).collect();
        for (cell, orders) in [(2, &[1][..]), (3, &[1, 2]), (4, &[1, 2, 4]), (5, &every)] {
            let why = obstruction(number, orders).map_or("yes".to_owned(), |prime| format!("no: {prime}"));
            assert_eq!(row[cell], why, "{row:?}");
        }
        let factorial = |n: u64| (1..=n).product::<u64>();
        let stars = match primes(number)[..] {
            [_] => 0,
            [p, q] if p * q == number => 2 * factorial(p - 1) * factorial(q - 1),
            [2, q] => {
                let parts = number / 2 / q;
                u64::try_from(
                    u128::from(covers(number as usize, q as usize))
                        * (1..=u128::from(parts)).product::<u128>()
                        * u128::from(2 * factorial(q)).pow(parts as u32)
                        / u128::from(number),
                )
                .expect("it fits")
            }
            _ => {
                assert_eq!(row[6], "not known");
                continue;
            }
        };
        assert_eq!(whole(&row[6]), stars, "{row:?}");
    }
}

/// Least moment of order 1, stars that have it, least of order 2 beside it, by every star in decimals.
fn least(number: usize) -> (f64, u64, f64) {
    let directions: Vec<[(f64, f64); 2]> = (0..number)
        .map(|direction| [1.0, 2.0].map(|order| (TAU * order * direction as f64 / number as f64).sin_cos()))
        .collect();
    fn fill(
        directions: &[[(f64, f64); 2]],
        left: &mut Vec<usize>,
        place: usize,
        sums: [(f64, f64); 2],
        best: &mut (f64, u64, f64),
    ) {
        let number = directions.len();
        if place == number {
            let [first, second] = sums.map(|(sine, cosine)| sine.hypot(cosine));
            if first < best.0 - 1e-9 {
                *best = (first, 0, f64::MAX);
            }
            if first < best.0 + 1e-9 {
                (best.1, best.2) = (best.1 + 1, best.2.min(second));
            }
            return;
        }
        for at in 0..left.len() {
            let direction = left.swap_remove(at);
            let arm = place as f64 - (number as f64 - 1.0) / 2.0;
            let add = |order: usize| {
                let (sine, cosine) = directions[direction][order];
                (sums[order].0 + arm * sine, sums[order].1 + arm * cosine)
            };
            fill(directions, left, place + 1, [add(0), add(1)], best);
            left.push(direction);
            let last = left.len() - 1;
            left.swap(at, last);
        }
    }
    let arm = -(number as f64 - 1.0) / 2.0;
    let mut best = (f64::MAX, 0, f64::MAX);
    fill(&directions, &mut (1..number).collect(), 1, [(0.0, arm), (0.0, arm)], &mut best);
    best
}

#[test]
fn the_best_stars_are_those_of_a_plain_loop() {
    let rows = table("Cylinders|Least moment of order 1");
    assert_eq!(rows.len(), 17);
    let of = |number: usize| &rows[number - 2];
    for number in 2..=9 {
        let row = of(number);
        let (first, stars, second) = least(number);
        for (cell, value) in [(1, first), (3, second)] {
            let (told, room) = decimal(&row[cell]);
            assert!((told - value).abs() < room.max(1e-9), "{row:?}: {value}");
        }
        assert_eq!(whole(&row[2]), stars, "{row:?}");
    }
    // Twice the best star of half as many, by theorem 6.
    for (number, half) in [(10, 5), (14, 7)] {
        let (told, room) = decimal(&of(number)[3]);
        assert!((told - 2.0 * least(half).0).abs() < room, "{:?}", of(number));
    }
    for row in table("V on shared pins") {
        // The largest couple, as `classify` gives it of the V on these pins at a right angle: there it turns with the crank alone.
        let name = format!("best-{}.toml", row[1]);
        let text = fs::read_to_string(golden::reports().join("stars").join(&name)).expect("a layout file");
        let engine = file::parse(&name, &text.replace("[inline]", "[vee]\nbank_angle = 90")).expect("it reads");
        assert_eq!(
            (engine.cylinders().len(), format!("V{}", engine.cylinders().len())),
            (2 * whole(&row[1]) as usize, row[0].clone())
        );
        let judged = verdict::classify(&engine, &[1], Masses::Reciprocating, &Quantity::PLANAR).expect("verdicts");
        let couple = &judged[0].parts[0].moment;
        let (told, room) = if row[2].contains("**0**") { (0.0, 1e-9) } else { decimal(&row[2]) };
        assert!((told - report::largest_length(couple).decimal).abs() < room.max(1e-9), "{row:?}");
        assert!((told - least(whole(&row[1]) as usize).0).abs() < room.max(1e-9), "{row:?}");
    }
    for row in &rows {
        let name = format!("best-{}.toml", row[0]);
        let text = fs::read_to_string(golden::reports().join("stars").join(&name)).expect("a layout file");
        let engine = file::parse(&name, &text).expect("it reads");
        let turns = row[4].split(", ").map(|step| Turn::fraction(whole(step) as i64, whole(&row[0]) as i64));
        assert!(turns.eq(engine.cylinders().iter().map(|cylinder| cylinder.throw.clone())), "{row:?}");
        let judged = verdict::classify(&engine, &[1, 2], Masses::Reciprocating, &Quantity::PLANAR).expect("verdicts");
        for (order, cell) in judged.iter().zip([1, 3]) {
            let (told, room) = if row[cell].contains("**0**") { (0.0, 1e-9) } else { decimal(&row[cell]) };
            let moment = report::largest_length(&order.parts[0].moment).decimal;
            assert!((told - moment).abs() < room.max(1e-9), "{row:?}: {moment}");
        }
    }
    for row in table("Cylinders, four-stroke") {
        let directions = whole(&row[0]) / 2;
        assert_eq!((whole(&row[1]), whole(&row[2])), (directions, (1..directions).product()), "{row:?}");
    }
}

/// Six throws about a wider or a narrower gap, by every order of them: with ζ at 60°, ζ² = ζ − 1, a moment is a pair of whole numbers.
#[test]
fn the_spacings_have_as_many_stars_as_a_plain_loop_finds() {
    const SIXTHS: [(i64, i64); 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
    fn zeros(places: &[i64], left: &[usize], sum: (i64, i64)) -> usize {
        let Some((place, others)) = places.split_first() else { return usize::from(sum == (0, 0)) };
        let with = |direction: &usize| {
            let (one, other) = SIXTHS[*direction];
            let rest: Vec<usize> = left.iter().copied().filter(|other| other != direction).collect();
            zeros(others, &rest, (sum.0 + place * one, sum.1 + place * other))
        };
        left.iter().map(with).sum()
    }
    let rows = table("Gap in the middle");
    assert_eq!(rows.len(), 5);
    for row in rows {
        // In half spacings, from the first throw at 0 in direction 0.
        let gap = (2.0 * row[0].parse::<f64>().expect("a gap")) as i64;
        let places = [2, 4, 4 + gap, 6 + gap, 8 + gap];
        assert_eq!(whole(&row[1]), zeros(&places, &[1, 2, 3, 4, 5], (0, 0)) as u64, "{row:?}");
    }
}

#[test]
fn the_golden_spacing_leaves_what_the_page_says() {
    let text = fs::read_to_string(golden::reports().join("stars/README.md")).expect("the page");
    let arms: Vec<f64> = (0..5).map(|throw| (2.0 * TAU * f64::from(throw) / 5.0).sin()).collect();
    let mut places = arms.clone();
    places.sort_by(f64::total_cmp);
    let gaps: Vec<f64> = places.windows(2).map(|pair| (pair[1] - pair[0]) / (places[1] - places[0])).collect();
    let golden = (1.0 + 5_f64.sqrt()) / 2.0;
    assert!(gaps.iter().zip([1.0, golden, golden, 1.0]).all(|(gap, told)| (gap - told).abs() < 1e-9), "{gaps:?}");
    let left = |order: f64| {
        let add = |sum: (f64, f64), (throw, arm): (usize, &f64)| {
            let (sine, cosine) = (order * TAU * throw as f64 / 5.0).sin_cos();
            (sum.0 + arm * sine, sum.1 + arm * cosine)
        };
        let (sine, cosine) = arms.iter().enumerate().fold((0.0, 0.0), add);
        sine.hypot(cosine)
    };
    assert!(left(1.0) < 1e-12 && (left(2.0) - 2.5).abs() < 1e-12);
    assert!(text.contains("order 1 leaves **0**, order 2 leaves 2.5."));
}

#[test]
fn the_engines_of_the_page_lose_what_it_says() {
    for (cylinders, first, force) in [(6, Some(2), 6), (12, Some(4), 12), (15, Some(6), 30), (30, None, 30)] {
        let name = format!("star-{cylinders}.toml");
        let text = fs::read_to_string(golden::reports().join("stars").join(&name)).expect("a layout file");
        let engine = file::parse(&name, &text).expect("it reads");
        assert_eq!(engine.cylinders().len(), cylinders);
        let Ok(EveryOrderTheorem::Period(theorem)) = verdict::every_order(&engine, Masses::Reciprocating) else {
            panic!()
        };
        let existing = || [1].into_iter().chain((2..=60).step_by(2));
        let left = existing().find(|order| theorem.moment.survivors().contains(*order));
        assert_eq!(left, first, "{name}");
        assert_eq!(existing().find(|order| theorem.force.survivors().contains(*order)), Some(force), "{name}");
    }
}

#[test]
fn the_verdicts_in_a_terminal_cite_the_theorem_after_their_proof_and_only_where_one_applies() {
    let shown = |engine: &str| {
        let output = call(&["classify", engine]);
        assert!(output.status.success(), "{engine}");
        String::from_utf8(output.stdout).expect("a text").split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let stars = [12, 15, 30].map(|cylinders| {
        let file = golden::reports().join(format!("stars/star-{cylinders}.toml"));
        (cylinders, file.to_str().expect("a path").to_owned())
    });
    let of = |cylinders: u32| stars.iter().find(|(one, _)| *one == cylinders).expect("a star").1.as_str();
    for (engine, cited) in [
        (
            "I5-12453",
            "No star of 5 throws in evenly spread directions, equally far apart, is free of the first-order couple",
        ),
        ("V8-crossplane", "No order of the 4 pins, and no bank angle, removes the rotating first-order couple"),
        ("I4", "The crankshaft is its own mirror image"),
        ("I6", "The crankshaft is its own mirror image"),
        ("V8-flatplane", "The crankshaft is its own mirror image"),
        (
            "I6-two-stroke",
            "No star of 6 throws is free of the moments of these orders together: 1, 2. Throws 1/3 of a turn",
        ),
        ("I6-two-stroke", "No star of 6 throws without a first-order moment leaves less of order 2"),
        (
            of(12),
            "No star of 2 to 11 throws in evenly spread directions is free of the moments of these orders: 1, 2 (",
        ),
        (of(12), "No star of 12 throws is free of the moments of these orders together: 1, 2, 4. Throws 1/3 of a turn"),
        (
            of(15),
            "No star of 2 to 14 throws in evenly spread directions is free of the moments of these orders: 1, 2, 4 (",
        ),
        (of(15), "No star of 15 throws is free of the moments of these orders together: 1, 6. Throws 1/5 of a turn"),
        (of(30), "No star of 2 to 29 throws in evenly spread directions is free of the moments of every order"),
    ] {
        let text = shown(engine);
        let place = text.find(cited).unwrap_or_else(|| panic!("{engine}: {text}"));
        assert!(text.find("Order Force").is_some_and(|verdicts| verdicts < place), "{engine}: {text}");
    }
    for engine in ["I2-360", "radial-9", "V6-60-even", "I2-180"] {
        assert!(!shown(engine).contains("crankstar stars"), "{engine}");
    }
}
