//! Are the angles at which an order of the gas torque vanishes found rightly, and completely? Against sums computed by themselves.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, DELTA, Engine, Family, NoSpans, PHI};
use crankstar::family::{self, NoOpenStar, OpenStar};
use crankstar::file::{self, Layout};
use crankstar::firing::{NoStar, Weights};
use crankstar::page::{self, Format, Language, Options};
use crankstar::report::{self, OpenFiringStudy};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::figure_texts::FigureTexts;
use crate::support::german::{has_words, phrases};
use crate::support::written::fraction;

const V2: &str = "cycle = 'four-stroke'\nfiring_angles = [0, '360 + phi']\nvee = { bank_angle = 'phi', throws = [0] }";
const V6: &str =
    "cycle = 'four-stroke'\nfiring_order = '1-4-3-6-2-5'\nvee = { bank_angle = 'phi', throws = [0, 240, 120] }";
const V6_OF_TWO_RANGES: &str =
    "cycle = 'four-stroke'\nfiring_order = '1-5-3-4-2-6'\nvee = { bank_angle = 'phi', throws = [0, 240, 120] }";
const V6_SPLIT: &str = "cycle = 'four-stroke'\nfiring_order = '1-6-3-5-2-4'\n\
                        vee = { bank_angle = 60, throws = [0, 240, 120], pin_split = 'delta' }";
const V8: &str =
    "cycle = 'four-stroke'\nfiring_order = '1-5-4-3-7-2-6-8'\nvee = { bank_angle = 'phi', throws = [0, 270, 90, 180] }";
const FOUR_BANKS: &str =
    "cycle = 'two-stroke'\nfan = { banks = ['-phi', 0, 'phi', '2phi'], throws = [0, 180], positions = [0, 1] }";
const FOUR_BANKS_OF_ANGLES: &str = "cycle = 'four-stroke'\nfiring_angles = ['-phi', 360, 'phi', '2phi + 360']\n\
                                    fan = { banks = ['-phi', 0, 'phi', '2phi'], throws = [0], positions = [0] }";

fn open(text: &str) -> Family {
    match file::parse_layout("test", text).expect("it reads") {
        Layout::Open(family) => *family,
        Layout::Known(..) => panic!("nothing is open in {text}"),
    }
}

fn orders(halves: impl IntoIterator<Item = u32>) -> Vec<CycleOrder> {
    halves.into_iter().map(|halves| CycleOrder::of_halves(halves).expect("an order")).collect()
}

fn judged(family: &Family, orders: &[CycleOrder]) -> Vec<OpenStar> {
    family::firing_stars(family, orders, &Weights::Rigid, [&fraction(0, 1), &fraction(1, 1)], false).expect("stars")
}

fn degrees(star: &OpenStar, unknown: &str) -> Vec<String> {
    let values = star.values(unknown, [&fraction(0, 1), &fraction(1, 1)]).expect("solved");
    let degrees = values.iter().map(|value| (value * fraction(360, 1)).to_string());
    degrees.filter(|value| value != "0" && value != "360").collect()
}

fn member(family: &Family, unknown: &str, value: &BigRational) -> Engine {
    let values = BTreeMap::from([(unknown.to_owned(), value.clone())]);
    family.with(&values).expect("it is built").only().expect("nothing else is open").expect("it is built")
}

/// `|Σ e^{−iκφ_j}|` in doubles; at whole orders of top dead centres, which need no firing order.
fn length(engine: &Engine, order: CycleOrder) -> Option<f64> {
    let angles: Vec<f64> = match (engine.firing(), order.is_whole()) {
        (Some(firing), _) => firing.shots.iter().filter_map(|shot| shot.angle.to_f64()).collect(),
        (None, true) => engine.cylinders().iter().filter_map(|one| (&one.bank - &one.throw).turns().to_f64()).collect(),
        (None, false) => return None,
    };
    let kappa = f64::from(order.halves()) / 2.0;
    Some(angles.iter().map(|angle| Complex::from_polar(1.0, -kappa * TAU * angle)).sum::<Complex<f64>>().norm())
}

#[test]
fn every_angle_of_a_grid_vanishes_exactly_where_it_is_listed() {
    for (text, unknown) in [
        (V2, PHI),
        (V6, PHI),
        (V6_OF_TWO_RANGES, PHI),
        (V6_SPLIT, DELTA),
        (V8, PHI),
        (FOUR_BANKS, PHI),
        (FOUR_BANKS_OF_ANGLES, PHI),
    ] {
        let family = open(text);
        let step = if text == FOUR_BANKS { 2 } else { 1 };
        for star in judged(&family, &orders((1..=12 / step).map(|index| index * step))) {
            let listed = star.values(unknown, [&fraction(0, 1), &fraction(1, 1)]);
            let grid = (1..144).map(|place| fraction(place, 144));
            for value in grid.chain(listed.iter().flatten().filter(|value| !value.is_integer()).cloned()) {
                let engine = member(&family, unknown, &value);
                let spans = star.spans.as_ref().expect("the layout says it");
                let fires = spans.iter().any(|part| part.span.holds(&value));
                let length = length(&engine, star.order);
                assert_eq!(fires, length.is_some(), "{text} order {} at {value}", star.order);
                let is_listed = fires && star.always() || listed.as_ref().is_some_and(|listed| listed.contains(&value));
                let vanishes = length.is_some_and(|length| length < 1e-9);
                let is_solved = star.always() || listed.is_some();
                assert!(is_solved, "{text} order {} is not solved", star.order);
                assert_eq!(vanishes, is_listed, "{text} order {} at {value}: {length:?}", star.order);
            }
        }
    }
}

/// `|1 + e^{−iκg}| = 2 |cos(κg/2)|` with the interval g = 360° + φ.
#[test]
fn a_twin_on_one_pin_vanishes_where_the_cosine_of_half_the_interval_does() {
    let family = open(V2);
    for star in judged(&family, &orders(1..=24)) {
        let kappa = star.order.exact();
        // κ (360° + φ) = 180° + m 360°.
        let zeros = (0..64).map(|m| (fraction(1, 2) + fraction(m, 1)) / &kappa - fraction(1, 1));
        let inside = zeros.filter(|phi| *phi > fraction(0, 1) && *phi < fraction(1, 1));
        let right: Vec<String> = inside.map(|phi| (phi * fraction(360, 1)).to_string()).collect();
        assert_eq!(degrees(&star, PHI), right, "order {}", star.order);
    }
}

/// `|S_{1½ j}| = 6 |cos(¾ j γ')|`, γ' the angle by which bank 2 fires behind bank 1.
#[test]
fn half_orders_of_a_six_in_v_have_the_zeros_of_the_paper() {
    let order = |text: &str| vec![text.parse::<CycleOrder>().expect("an order")];
    let at = |layout: &str, text: &str| degrees(&judged(&open(layout), &order(text))[0], PHI);
    assert_eq!(at(V6, "3/2"), ["120"]);
    assert_eq!(at(V6, "3"), ["60", "180", "300"]);
    assert_eq!(at(V6, "9/2"), ["40", "120", "200"]);
    assert_eq!(at(V6_OF_TWO_RANGES, "3/2"), [""; 0]);
    assert_eq!(at(V6_OF_TWO_RANGES, "9/2"), ["80", "280"]);
    for text in ["1/2", "1", "2", "5/2", "7/2", "4"] {
        assert!(judged(&open(V6), &order(text))[0].always(), "order {text}");
    }
    let family = open(V6_OF_TWO_RANGES);
    for (degrees, gamma) in [(10, 130.0_f64), (100, 220.0), (250, 10.0), (350, 110.0)] {
        let engine = member(&family, PHI, &fraction(degrees, 360));
        let length = length(&engine, order("3/2")[0]).expect("it fires");
        assert!((length - 6.0 * (0.75 * gamma).to_radians().cos().abs()).abs() < 1e-9, "{degrees}: {length}");
    }
}

#[test]
fn a_range_that_turns_further_has_its_zeros_too() {
    let family = open(V2);
    let (low, high) = (fraction(-1, 1), fraction(5, 1));
    let stars = family::firing_stars(&family, &orders([1, 3]), &Weights::Rigid, [&low, &high], true).expect("stars");
    for star in stars {
        let kappa = star.order.exact();
        let zeros = (-64..64).map(|m| (fraction(1, 2) + fraction(m, 1)) / &kappa - fraction(1, 1));
        let right: Vec<BigRational> = zeros.filter(|phi| *phi >= low && *phi <= high).collect();
        let found: Vec<BigRational> = star.values(PHI, [&low, &high]).expect("solved").into_iter().collect();
        assert_eq!(found, right);
    }
}

#[test]
fn half_orders_need_to_know_in_which_revolution_a_cylinder_fires() {
    let family = open("cycle = 'four-stroke'\nvee = { bank_angle = 'phi', throws = [0, 240, 120] }");
    let stars = judged(&family, &orders([1, 2]));
    assert_eq!(stars[0].spans.as_ref().err(), Some(&NoSpans::NotSaid));
    assert!(stars[1].always());
    let page = report::open_firing_answer(&OpenFiringStudy::new(&family, &[], Weights::Rigid).expect("stars"));
    let text = page::write(&page, Format::GITHUB, &Options::default()).remove(0).text;
    assert!(text.contains("Half orders need to know in which revolution each cylinder fires"), "{text}");
    assert!(text.contains("| 3 | 0 at φ = 60°, 180°, 300° | 6 \\|cos(3φ/2)\\| |"), "{text}");
    assert!(!text.contains('½'), "{text}");
    let two = "cycle = 'four-stroke'\nfiring_order = '1-4-3-6-2-5'\n\
               vee = { bank_angle = 'phi', throws = [0, 240, 120], pin_split = 'delta' }";
    let stars = judged(&open(two), &orders([1, 3, 6]));
    assert_eq!(stars[1].spans.as_ref().err(), Some(&NoSpans::TwoAngles));
    assert!(stars[2].spans.is_ok());
    let two_stroke = open(FOUR_BANKS);
    let ends = [&fraction(0, 1), &fraction(1, 1)];
    let refused = family::firing_stars(&two_stroke, &orders([1]), &Weights::Rigid, ends, false);
    assert!(matches!(refused, Err(NoOpenStar::NoStar(NoStar::HalfOrder(_)))));
}

#[test]
fn firing_angles_with_unknowns_fit_the_dead_centres_or_are_refused() {
    let wrong = V2.replace("360 + phi", "360");
    let refused = file::parse_layout("test", &wrong).expect_err("the dead centre moves");
    assert!(refused.to_string().contains("cylinder 2 cannot fire 360° after the first"), "{refused}");
    assert!(refused.to_string().contains("it reaches top dead centre at phi°"), "{refused}");
    let known = format!("{V2}\n[values]\nphi = 90");
    let engine = file::parse("test", &known).expect("an engine");
    let intervals: Vec<String> =
        engine.firing().expect("it fires").intervals().iter().map(ToString::to_string).collect();
    assert_eq!(intervals, ["5/4", "3/4"]);
}

#[test]
fn open_lengths_leave_every_order_judged() {
    let family = open(
        "cycle = 'four-stroke'\nfiring_order = '1-3-4-2'\ninline = { throws = [0, 180, 180, 0], positions = [0, 'a', '2a', '3a'] }",
    );
    let stars = judged(&family, &orders(1..=4));
    let zero: Vec<bool> = stars.iter().map(OpenStar::always).collect();
    assert_eq!(zero, [true, true, true, false]);
    let never: Vec<bool> = stars.iter().map(OpenStar::never).collect();
    assert_eq!(never, [false, false, false, true]);
}

#[test]
fn answers_and_pages_have_german_for_every_phrase() {
    let two = V6_SPLIT.replace("bank_angle = 60", "bank_angle = 'phi'");
    let silent = V6.replace("firing_order = '1-4-3-6-2-5'", "");
    let never = V6.replace("1-4-3-6-2-5", "1-4-2-5-3-6");
    let lengths = "cycle = 'four-stroke'\nfiring_order = '1-3-4-2'\n\
                   inline = { throws = [0, 180, 180, 0], positions = [0, 'a', '2a', '3a'] }";
    let texts = [V2, V6, V6_OF_TWO_RANGES, V6_SPLIT, FOUR_BANKS, &two, &silent, &never, lengths];
    for text in texts {
        let family = open(text);
        let shape = family.cylinders().iter().map(|_| fraction(1, 1)).collect();
        for weights in [Weights::Rigid, Weights::ModeShape(shape)] {
            let asked = if text == FOUR_BANKS { orders([2, 4]) } else { orders([1, 2, 3, 6]) };
            let study = OpenFiringStudy::new(&family, &asked, weights).expect("stars");
            for page in [report::open_firing_answer(&study), report::open_firing_page(&study)] {
                let said = phrases(&page).into_iter().filter(|words| has_words(words));
                let unknown: Vec<&str> = said.filter(|words| !Language::De.knows(words)).collect();
                assert!(unknown.is_empty(), "no German for {unknown:#?}");
                for picture in page.pictures() {
                    let figure = Language::De.picture(picture).figure;
                    assert!(figure.overlaps().is_empty() && figure.leaving().is_empty(), "{text}");
                }
            }
        }
    }
}

#[test]
fn lengths_of_two_equal_parts_are_told_in_one_cosine() {
    let told = |layout: &str| {
        let family = open(layout);
        let study = OpenFiringStudy::new(&family, &orders([1, 2, 3, 6]), Weights::Rigid).expect("stars");
        let page = report::open_firing_answer(&study);
        page::write(&page, Format::PLAIN, &Options::default()).remove(0).text
    };
    for (layout, lengths) in [
        (V2, ["2 |sin(φ/4)|", "2 |cos(φ/2)|", "2 |sin(3φ/4)|", "2 |cos(3φ/2)|"]),
        (V6, ["0", "0", "6 |cos(3φ/4)|", "6 |cos(3φ/2)|"]),
    ] {
        let text = told(layout);
        let rows: Vec<&str> = text
            .lines()
            .filter(|line| {
                ["½", "1", "1½", "3"].iter().any(|order| line.trim_start().starts_with(&format!("{order} ")))
            })
            .collect();
        for (row, length) in rows.iter().zip(lengths) {
            assert!(row.trim_end().ends_with(length), "{row} for {length}");
        }
        assert_eq!(rows.len(), 4, "{text}");
    }
}
