//! Has every length and direction of an engine that a book draws a closed form, within the budget, and is it the plain one?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite book_lengths` writes `reports/forms` anew.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::path::Path;
use std::{env, fs};

use crankstar::engine::Engine;
use crankstar::exact::PhasorSum;
use crankstar::file;
use crankstar::numbers::{self, Budget, Direction, Form};
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use num_bigint::BigInt;

use crate::support::dice::Dice;
use crate::support::{books, decimals};

const ORDERS: [u32; 4] = [1, 2, 4, 6];
const QUANTITIES: [Quantity; 2] = [Quantity::FORCE, Quantity::MOMENT];

fn written(text: &str) -> Engine {
    file::parse("book.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn vectors(engine: &Engine, quantity: Quantity, order: u32) -> [PhasorSum; 2] {
    [Sense::Direct, Sense::Reverse].map(|sense| order::star(engine, quantity, order, Some(sense)))
}

/// Both vectors of every order and quantity of 300 layouts, each pair once, and the layout.
fn pairs() -> Vec<(String, [PhasorSum; 2])> {
    let (mut dice, mut seen) = (Dice::new(300), BTreeSet::new());
    let mut all = Vec::new();
    for make in books::MAKES.iter().cycle().take(300) {
        let text = books::file(&mut dice, make);
        let engine = written(&text);
        for (order, quantity) in ORDERS.into_iter().flat_map(|order| QUANTITIES.map(|quantity| (order, quantity))) {
            let pair = vectors(&engine, quantity, order);
            if pair.iter().any(|sum| !sum.vanishes()) && seen.insert(format!("{pair:?}")) {
                all.push((format!("{text}{} {order}", quantity.name()), pair));
            }
        }
    }
    all
}

#[test]
fn no_length_of_300_layouts_at_whole_degrees_is_left_a_decimal_and_few_directions() {
    let mut seen = BTreeSet::new();
    let (mut counts, mut decimals_left) = ([0; 3], 0);
    for (name, pair) in pairs() {
        for sum in pair.into_iter().filter(|sum| !sum.vanishes()) {
            if !seen.insert(format!("{:?}", sum.collected())) {
                continue;
            }
            let mut budget = Budget::new();
            let length = numbers::modulus_within(&sum, &mut budget).unwrap_or_else(|| panic!("no length\n{name}"));
            let (tests, proposals) = budget.spent();
            assert!(tests <= Budget::TESTS && proposals <= Budget::PROPOSALS);
            assert!(decimals::agree(&decimals::form(&length), &decimals::modulus(&sum)), "{length}\n{name}");
            let Some(direction) = numbers::direction_of(&sum) else {
                decimals_left += 1;
                continue;
            };
            counts[match &direction {
                Direction::Turn(_) => 0,
                Direction::Arctangent { .. } => 1,
                Direction::Turned { .. } => 2,
            }] += 1;
            points_there(&sum, &direction, &name);
        }
    }
    assert!(counts[0] > 500 && counts[1] > 20 && counts[2] > 50, "{counts:?}");
    let all: usize = counts.iter().sum();
    assert!(50 * decimals_left < all, "{decimals_left} directions are decimals, {counts:?}");
}

/// How many different vectors are printed with fewer letters than before, as many, and more: those with a root of at most four
/// square roots, and those for which there was the root of a sum of cosines alone.
struct Shorter {
    than_roots: [usize; 3],
    than_cosines: [usize; 3],
}

fn shorter() -> Shorter {
    let letters = |form: &Form| form.to_string().chars().filter(|letter| !matches!(letter, ' ' | '°')).count();
    let (mut seen, mut counts) = (BTreeSet::new(), Shorter { than_roots: [0; 3], than_cosines: [0; 3] });
    for (name, pair) in pairs() {
        for sum in pair.into_iter().filter(|sum| !sum.vanishes()) {
            if !seen.insert(format!("{:?}", sum.collected())) {
                continue;
            }
            let after = numbers::modulus(&sum).unwrap_or_else(|| panic!("no length\n{name}"));
            let (before, counts) = match numbers::modulus_by_roots(&sum) {
                Some(before) => (before, &mut counts.than_roots),
                None => (root_of_cosines(&sum), &mut counts.than_cosines),
            };
            let place = match letters(&after).cmp(&letters(&before)) {
                Ordering::Less => 0,
                Ordering::Equal => 1,
                Ordering::Greater => 2,
            };
            counts[place] += 1;
        }
    }
    counts
}

/// `√(2 − 2 cos 1°)`: the square is real, so that it is the sum of the cosines of its terms.
fn root_of_cosines(sum: &PhasorSum) -> Form {
    let zero = Form::rational(num_rational::BigRational::from_integer(0.into()));
    let square = sum.squared_modulus().collected();
    square.into_iter().fold(zero, |all, term| all.plus(&Form::cosine(term.weight, term.angle))).square_root()
}

#[test]
fn two_thirds_of_the_lengths_of_300_layouts_are_shorter_than_roots_or_cosines_print_them() {
    let Shorter { than_roots, than_cosines } = shorter();
    let [fewer, same, more] = [0, 1, 2].map(|place| than_roots[place] + than_cosines[place]);
    assert!(3 * fewer >= 2 * (fewer + same + more), "{than_roots:?} {than_cosines:?}");
    assert!(same > 0 && than_roots[0] > 0 && than_cosines[0] > 0, "{than_roots:?} {than_cosines:?}");
}

/// The sum turned back by its direction lies on the positive real axis, to fifty digits.
fn points_there(sum: &PhasorSum, direction: &Direction, name: &str) {
    let zero = BigInt::from(0);
    let (by, tangent) = match direction {
        Direction::Turn(turn) => (turn.clone(), None),
        Direction::Arctangent { tangent, opposite: true } => (crankstar::exact::Turn::fraction(1, 2), Some(tangent)),
        Direction::Arctangent { tangent, opposite: false } => (crankstar::exact::Turn::zero(), Some(tangent)),
        Direction::Turned { by, tangent } => (by.clone(), Some(tangent)),
    };
    let (re, im) = decimals::sum(&sum.turned(&-&by));
    let tangent = tangent.map_or(zero.clone(), decimals::form);
    assert!(re > zero, "{direction:?} points the other way\n{name}");
    let expected = &re * &tangent / decimals::one();
    assert!(decimals::agree(&(&re + &expected), &(&re + &im)), "{direction:?}\n{name}");
}

#[test]
fn half_of_both_lengths_has_a_closed_form_for_every_layout() {
    let mut both = 0;
    for (name, [direct, reverse]) in pairs() {
        let form = numbers::half_of_lengths(&direct, &reverse).unwrap_or_else(|| panic!("no form\n{name}"));
        let of = |sum: &PhasorSum| if sum.vanishes() { BigInt::from(0) } else { decimals::modulus(sum) };
        let half = (of(&direct) + of(&reverse)) / BigInt::from(2);
        assert!(decimals::agree(&decimals::form(&form), &half), "{form}\n{name}");
        both += usize::from(!direct.vanishes() && !reverse.vanishes());
    }
    assert!(both > 200, "{both}");
}

#[test]
fn the_couple_of_the_v10_at_72_degrees_is_the_sine_of_36_degrees() {
    let v10 = file::find("V10-72").expect("in the catalogue").engine().expect("it reads");
    let couple = |order| {
        let [direct, reverse] = vectors(&v10, Quantity::MOMENT, order);
        numbers::half_of_lengths(&direct, &reverse).expect("a form").to_string()
    };
    assert_eq!(couple(1), "sin(36°)");
    assert_eq!([4, 6].map(couple), ["sin(36°)", "sin(36°)"]);
}

/// Stars of the page: a layout, what it is called, and the order of the moment or the force.
const SHOWN: [(&str, &str, Quantity, u32); 12] = [
    ("V10, 72°", "vee = { bank_angle = 72, throws = [0, 216, 144, 72, 288] }", Quantity::MOMENT, 1),
    ("V10, 72°", "vee = { bank_angle = 72, throws = [0, 216, 144, 72, 288] }", Quantity::MOMENT, 2),
    ("V10, 77°", "vee = { bank_angle = 77, throws = [0, 72, 144, 216, 288] }", Quantity::MOMENT, 1),
    (
        "V10, 90°, pins split by 18°",
        "vee = { bank_angle = 90, pin_split = -18, throws = [0, 216, 144, 72, 288] }",
        Quantity::MOMENT,
        1,
    ),
    ("V2, 13°", "vee = { bank_angle = 13, throws = [0] }", Quantity::FORCE, 2),
    ("V2, 45°", "vee = { bank_angle = 45, throws = [0] }", Quantity::FORCE, 2),
    ("V6, 65°", "vee = { bank_angle = 65, throws = [0, 120, 240] }", Quantity::MOMENT, 1),
    ("V8, 72°, cross-plane", "vee = { bank_angle = 72, throws = [0, 90, 270, 180] }", Quantity::MOMENT, 1),
    ("W15, 35°", "fan = { banks = [-35, 0, 35], throws = [0, 288, 144, 72, 216] }", Quantity::MOMENT, 1),
    ("W12, 60°", "fan = { banks = [-60, 0, 60], throws = [0, 90, 270, 180] }", Quantity::MOMENT, 1),
    ("I5, 1-2-4-5-3", "inline.throws = [0, 216, 144, 288, 72]", Quantity::MOMENT, 2),
    ("I2, 1°", "inline.throws = [0, 1]", Quantity::FORCE, 1),
];

fn counted() -> String {
    let Shorter { than_roots, than_cosines } = shorter();
    let told = |[fewer, same, more]: [usize; 3]| format!("{fewer} are shorter now, {same} as long, {more} longer");
    format!(
        "Of {} different vectors (300 random layouts at whole degrees, orders 1, 2, 4 and 6) {} had such roots before, and by printed letters\n\
         {}. The other {} were decimals; compared with the root of\n\
         their square as a sum of cosines, {}. None is a decimal now.\n\n",
        than_roots.iter().chain(&than_cosines).sum::<usize>(),
        than_roots.iter().sum::<usize>(),
        told(than_roots),
        than_cosines.iter().sum::<usize>(),
        told(than_cosines)
    )
}

fn page() -> String {
    let closed =
        |form: Option<Form>, decimal: f64| form.map_or_else(|| format!("≈ {decimal:.6}"), |form| form.to_string());
    let rows = SHOWN.iter().flat_map(|(name, text, quantity, order)| {
        let [direct, reverse] = vectors(&written(text), *quantity, *order);
        let length = |sum: &PhasorSum| numbers::length(numbers::evaluate(sum));
        let before = |sum: &PhasorSum| {
            if sum.vanishes() { "0".to_owned() } else { closed(numbers::modulus_by_roots(sum), length(sum)) }
        };
        let after =
            |sum: &PhasorSum| if sum.vanishes() { "0".to_owned() } else { closed(numbers::modulus(sum), length(sum)) };
        let largest = (length(&direct) + length(&reverse)) / 2.0;
        let head = format!("| {name} | {} {order}", quantity.name());
        let sums = [("direct", &direct), ("reverse", &reverse)];
        let mut rows: Vec<String> =
            sums.iter().map(|(sense, sum)| format!("{head}, {sense} | {} | {} |\n", before(sum), after(sum))).collect();
        let by_roots = match [&direct, &reverse].map(|sum| {
            if sum.vanishes() {
                Some(Form::rational(num_rational::BigRational::from_integer(0.into())))
            } else {
                numbers::modulus_by_roots(sum)
            }
        }) {
            [Some(a), Some(b)] => Some(a.plus(&b).scaled(&num_rational::BigRational::new(1.into(), 2.into()))),
            _ => None,
        };
        rows.push(format!(
            "{head}, largest | {} | {} |\n",
            closed(by_roots, largest),
            closed(numbers::half_of_lengths(&direct, &reverse), largest)
        ));
        rows
    });
    format!(
        "# Closed forms\n\n\
         Lengths of the vectors of an order, and the largest value through a revolution, which is half of their sum. Before: by the\n\
         quadratic step alone, roots of at most four square roots, and decimals where there are none. After: the plainest of all\n\
         forms that are proposed and proved, by the count of signs, roots and cosines. Forces in m r ω² c_k, moments in that times the\n\
         cylinder spacing.\n\n{}\
         | Engine | Vector | Before | After |\n| --- | --- | --- | --- |\n{}",
        counted(),
        rows.collect::<String>()
    )
}

#[test]
fn the_page_of_closed_forms_is_as_stored() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/forms");
    let written = page();
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::create_dir_all(&folder).expect("the folder");
        fs::write(folder.join("README.md"), &written).expect("the page");
    }
    let stored = fs::read_to_string(folder.join("README.md")).unwrap_or_default();
    assert!(stored == written, "reports/forms/README.md differs:\n{written}");
    // The page shows what it is for: decimals before, and none after.
    let cells: Vec<Vec<&str>> =
        written.lines().map(|line| line.split(" | ").collect()).filter(|row: &Vec<_>| row.len() == 4).collect();
    assert!(cells.iter().any(|row| row[2].contains('≈')) && cells.iter().all(|row| !row[3].contains('≈')), "{written}");
}
