//! Do links whose knuckle pins stand elsewhere than at the angles of their cylinders shake as they have to? Against published tables, a closed
//! motion, and the momentum of every body; and are their documents checked?

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::loads::{self, Tails};
use crankstar::motion::{Component, CorrectedLinkage};
use crankstar::page::Format;
use crankstar::proof::{
    Coefficient, Document, Quantity, RodStatement, Shape, WholeOutcome, check_document, read_document,
};
use crankstar::remedy::{Request, remedy};
use crankstar::report;
use crankstar::verdict::Outcome;
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::linked::{Body, Linked, assert_halves, assert_shakes_as_bodies, of_orders, order, read};
use crate::support::pages;
use crate::support::second;
use crate::support::verdicts::{document, judged};

fn vee(bank_angle: u32, throws: &str, masters: &str, more: &str) -> Engine {
    read(&format!(
        "[vee]\nbank_angle = {bank_angle}\nthrows = [{throws}]\n[mechanism]\nrod_ratio = '1/3.6'\n[articulated]\nknuckle_ratio = '0.9/3.6'\nmaster = [{masters}]\n{more}"
    ))
}

fn twelve(more: &str) -> Engine {
    vee(60, "0, 120, 240, 240, 120, 0", "1, 2, 3, 4, 5, 6", more)
}

fn cross_plane_eight(more: &str) -> Engine {
    vee(90, "0, 90, 270, 180", "1, 2, 3, 4", more)
}

#[test]
fn a_correction_of_three_degrees_gives_a_v12_order_three_and_a_cross_plane_v8_a_reverse_first_couple() {
    let twelve = of_orders(&twelve("knuckle_correction = 3"), &[1, 2, 3, 4, 5, 6]);
    for one in &twelve.orders {
        assert!(one.moment.vanishes());
        assert_eq!(one.force.vanishes(), one.order % 3 != 0, "order {}", one.order);
    }
    assert_halves(&order(&twelve, 3).force, [0.0104, 0.0104], 4);
    assert_halves(&order(&twelve, 6).force, [0.0013, 0.0007], 4);
    let eight = of_orders(&cross_plane_eight("knuckle_correction = 3"), &[1, 2, 3, 4, 5, 6]);
    for one in &eight.orders {
        assert_eq!(one.force.vanishes(), one.order != 4, "order {}", one.order);
        assert_eq!(one.moment.vanishes(), one.order % 2 == 0, "order {}", one.order);
    }
    assert_halves(&order(&eight, 4).force, [0.0435, 0.0259], 4);
    assert_halves(&order(&eight, 1).moment, [3.1902, 0.0401], 4);
    assert_halves(&order(&eight, 3).moment, [0.0077, 0.0077], 4);
}

fn degrees(degrees: f64) -> f64 {
    TAU * degrees / 360.0
}

/// A master at 0 without mass, and a link with mass 1: its order k is c_k.
fn alone([l, a, long]: [u64; 3], delta: u64, correction: &str, more: &str) -> Engine {
    read(&format!(
        "{more}\n[fan]\nbanks = [0, {delta}]\nthrows = [0]\n[mechanism]\nrod_ratio = '100/{l}'\nreciprocating_mass = [0, 1]\n[articulated]\nmaster = 1\nknuckle_ratio = '{a}/{l}'\nlink_ratio = '100/{long}'\n{correction}"
    ))
}

#[test]
fn the_link_of_the_theory_has_its_first_and_third_harmonic() {
    // .05 rad are 9/π degrees; this many digits of it are enough for those that are printed.
    let engine = alone([380, 90, 290], 80, "knuckle_correction = 2.86479", "");
    let loads = of_orders(&engine, &[1, 3]);
    for (k, size) in [(1, 1.0155), (3, 0.0035)] {
        assert_halves(&order(&loads, k).force, [size / 2.0, size / 2.0], 4);
    }
}

#[test]
fn the_harmonics_of_random_corrected_links_are_those_of_the_closed_motion() {
    let mut dice = Dice::new(41);
    let orders = [1, 2, 3, 4, 5, 6, 7, 8, 11];
    for _ in 0..25 {
        let (l, a) = (300 + dice.below(300), 30 + dice.below(120));
        let (long, delta) = (l - a + dice.below(40), dice.below(360));
        let tenths = dice.below(161) as i64 - 80;
        let linked = Linked {
            rod: l as f64 / 100.0,
            radius: a as f64 / 100.0,
            delta: degrees(delta as f64),
            correction: degrees(tenths as f64 / 10.0),
            link: long as f64 / 100.0,
        };
        // The angle itself, or how far it is corrected.
        let key = match dice.below(2) {
            0 => format!("knuckle_correction = '{tenths}/10'"),
            _ => format!("knuckle_angle = '{}/10'", 10 * delta as i64 + tenths),
        };
        let loads = of_orders(&alone([l, a, long], delta, &key, ""), &orders);
        for one in &loads.orders {
            let (k, bank) = (f64::from(one.order), linked.delta);
            let (c, turned) = (linked.coefficient(one.order), |by: f64| Complex::cis(by * bank));
            let [direct, reverse] = [c * turned(1.0 - k), c.conj() * turned(1.0 + k)];
            for (found, expected) in [(&one.force.direct, direct), (&one.force.reverse, reverse)] {
                assert!((found.value - expected).norm() < 1e-11, "order {k}: {} and {expected}, {key}", found.value);
            }
        }
    }
}

fn listed<T: ToString>(values: impl IntoIterator<Item = T>) -> String {
    values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(", ")
}

/// A radial or a V with corrected knuckle angles, masses as it happens, and its bodies: pistons, masses at knuckle pins, rotating masses.
fn random_engine(dice: &mut Dice) -> (String, Vec<Body>) {
    let (l, a) = (340 + dice.below(200), 60 + dice.below(60));
    let (piston, knuckle, big_end) = (1 + dice.below(4), dice.below(3), dice.below(5));
    // The throw and the bank of each cylinder in degrees, and the master of its crankpin.
    let (form, cylinders): (String, Vec<(f64, f64, usize)>) = match dice.below(2) {
        0 => {
            let (count, master) = (3 + dice.below(5), dice.below(3));
            let place = |index: u64| (0.0, 360.0 * index as f64 / count as f64, master as usize);
            (format!("[radial]\ncylinders = {count}"), (0..count).map(place).collect())
        }
        _ => {
            let (bank, pins) = (20 + 2 * dice.below(50), 1 + dice.below(3));
            let throws: Vec<u64> = (0..pins).map(|_| 15 * dice.below(24)).collect();
            let half = bank as f64 / 2.0;
            let row = |sign: f64| {
                let of_pin = throws.iter().enumerate();
                of_pin.map(move |(pin, throw)| (*throw as f64, sign * half, pin)).collect::<Vec<_>>()
            };
            (format!("[vee]\nbank_angle = {bank}\nthrows = [{}]", listed(&throws)), [row(-1.0), row(1.0)].concat())
        }
    };
    let is_master = |index: usize| cylinders[index].2 == index;
    let mass_of = |index: usize| if is_master(index) { piston + 1 } else { piston };
    let (mut corrections, mut bodies) = (Vec::new(), Vec::<Body>::new());
    for (index, &(throw, bank, master)) in cylinders.iter().enumerate() {
        let base = cylinders[master].1;
        let tenths = dice.below(141) as i64 - 70;
        let linked = Linked {
            rod: l as f64 / 100.0,
            radius: a as f64 / 100.0,
            delta: degrees(bank - base),
            correction: degrees(tenths as f64 / 10.0),
            link: (l - a) as f64 / 100.0,
        };
        let (mass, axis) = (mass_of(index) as f64, degrees(bank));
        // The crank angle after dead centre of the master's cylinder.
        let (ahead, base) = (degrees(throw - base), degrees(base));
        if is_master(index) {
            bodies.push((mass, Box::new(move |theta| Complex::cis(axis) * linked.master(theta + ahead))));
            bodies.push((big_end as f64, Box::new(move |theta| Complex::cis(theta + degrees(throw)))));
        } else {
            corrections.push(format!("'{tenths}/10'"));
            bodies.push((mass, Box::new(move |theta| Complex::cis(axis) * linked.piston(theta + ahead))));
            let pin = move |theta: f64| Complex::cis(base) * linked.knuckle(theta + ahead);
            bodies.push((knuckle as f64 / 10.0, Box::new(pin)));
        }
    }
    let indices = || 0..cylinders.len();
    let mut masters: Vec<usize> = cylinders.iter().map(|(_, _, master)| master + 1).collect();
    masters.sort_unstable();
    masters.dedup();
    let text = format!(
        "{form}\n[mechanism]\ncrank_radius = 1\nrod_ratio = '100/{l}'\nreciprocating_mass = [{}]\nrotating_mass = [{}]\n[articulated]\nmaster = [{}]\nknuckle_ratio = '{a}/{l}'\nknuckle_mass = '0.{knuckle}'\nknuckle_correction = [{}]",
        listed(indices().map(mass_of)),
        listed(indices().map(|index| if is_master(index) { big_end } else { 0 })),
        listed(masters),
        corrections.join(", ")
    );
    (text, bodies)
}

#[test]
fn random_corrected_engines_shake_as_the_momentum_of_every_body_changes() {
    let mut dice = Dice::new(1820);
    for _ in 0..6 {
        let (text, bodies) = random_engine(&mut dice);
        assert_shakes_as_bodies(&text, &bodies, &(1..=26).collect::<Vec<u32>>());
    }
}

fn checked(bytes: &[u8], text: &str) {
    let read = read_document(bytes).unwrap_or_else(|error| panic!("{error}\n{text}"));
    if let Err(fault) = read.check() {
        panic!("{fault}\n{text}");
    }
}

#[test]
fn documents_of_random_corrected_engines_verify() {
    let mut dice = Dice::new(1821);
    for _ in 0..3 {
        let (text, _) = random_engine(&mut dice);
        let engine = read(&text);
        let verdicts = judged(&engine, &[1, 2, 3, 4], false);
        let all = document(&engine, &verdicts, false, None);
        checked(&serde_json::to_vec(&all).expect("JSON"), &text);
        second::accepts(&[&all], &[]);
        let cured = remedy(&engine, &Request { orders: vec![1, 2, 3], ..Request::default() }).expect("a remedy");
        checked(&serde_json::to_vec(&report::remedy_document(&cured)).expect("JSON"), &text);
    }
}

#[test]
fn a_correction_of_zero_written_out_makes_the_document_of_none() {
    let json = |more: &str| {
        let engine = twelve(more);
        serde_json::to_string(&document(&engine, &judged(&engine, &[1, 2, 6], false), false, None)).expect("JSON")
    };
    let plain = json("");
    for zero in ["knuckle_correction = 0", "knuckle_correction = [0, 0, 0, 0, 0, 0]", "knuckle_angle = 60"] {
        assert_eq!(json(zero), plain, "{zero}");
    }
    assert_ne!(json("knuckle_correction = 1"), plain);
    assert!(!plain.contains("correction"));
}

#[test]
fn knuckle_angles_are_corrections_of_the_angles_of_their_cylinders() {
    let row = |keys: &str| {
        read(&format!(
            "[radial]\ncylinders = 5\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\n{keys}"
        ))
    };
    let angles = row("knuckle_angle = [75, 144, 216, 285]");
    assert_eq!(angles.cylinders(), row("knuckle_correction = [3, 0, 0, -3]").cylinders());
    assert_eq!(
        angles.cylinders()[1].link().expect("a link").knuckle_angle(),
        Turn::from_degrees(&BigRational::from_integer(75.into()))
    );
    // They count with the crank, whichever way it is drawn.
    let drawn = |rotation: &str, bank: i32| {
        read(&format!(
            "rotation = '{rotation}'\n[vee]\nbank_angle = {bank}\nthrows = [0]\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\nknuckle_angle = 57"
        ))
    };
    assert_eq!(drawn("anticlockwise", 60).cylinders(), drawn("clockwise", -60).cylinders());
}

#[test]
fn mistakes_in_knuckle_angles_are_told() {
    let row = |keys: &str| {
        let text = format!(
            "[radial]\ncylinders = 5\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\n{keys}"
        );
        file::parse("engine.toml", &text).expect_err("a mistake").to_string()
    };
    for (keys, words) in [
        ("knuckle_angle = 72\nknuckle_correction = 1", "both knuckle_angle and knuckle_correction"),
        ("knuckle_angle = [75, 144]", "2 values for 4 links"),
        ("knuckle_correction = 'wide'", "cannot read the angle"),
        ("knuckle_correction = 90", "is 90° ahead of its cylinder"),
        ("knuckle_angle = [-72, 144, 216, 288]", "where this cylinder is at 72°"),
        ("knuckle_correction = 60\nlink_ratio = 0.7", "or within a hundredth of that"),
    ] {
        let error = row(keys);
        assert!(error.contains(words), "{error}\nexpected {words}");
    }
}

/// A row whose links stand in mirror pairs about the master, κ and ε of each pair its own.
fn mirror_pairs() -> Engine {
    read(
        "orders = [1, 2, 3, 4]\n[radial]\ncylinders = 5\n[mechanism]\nrod_ratio = '1/3.8'\n[articulated]\nmaster = 1\nknuckle_ratio = '0.9/3.8'\nknuckle_correction = [2, -1.5, 1.5, -2]",
    )
}

#[test]
fn mirror_pairs_leave_nothing_across_the_line_of_their_master() {
    let engine = mirror_pairs();
    for one in &of_orders(&engine, &[1, 2, 3, 4, 5, 6]).orders {
        for vector in [&one.force.direct, &one.force.reverse] {
            assert!(vector.value.im.abs() < 1e-15, "order {}: {}", one.order, vector.value);
            assert!(vector.value.norm() > 1e-9, "order {}", one.order);
        }
    }
    let page = pages::text(&pages::document(&engine), Format::PLAIN);
    assert!(page.contains("The vectors of orders 2, 3, 4, direct and reverse, lie"), "{page}");
}

#[test]
fn two_rows_with_throws_and_masters_opposite_leave_no_force_at_any_order() {
    let rows = |corrections: &str| {
        read(&format!(
            "[radial]\ncylinders = 3\nrows = 2\nrow_throw = 180\nrow_rotation = 180\n[mechanism]\nrod_ratio = '1/3.8'\n[articulated]\nknuckle_ratio = '0.9/3.8'\nmaster = [1, 4]\nknuckle_correction = {corrections}"
        ))
    };
    let copies = rows("[2, -1.3, 2, -1.3]");
    assert!(loads::vanishes_at_every_order(&copies, Quantity::FORCE));
    assert!(!loads::vanishes_at_every_order(&copies, Quantity::MOMENT));
    for order in judged(&copies, &[1, 2, 3, 5], false) {
        assert_eq!(order.force.shape, Shape::Balanced, "order {}", order.order);
        assert!(order.moment.is_left());
    }
    let unlike = rows("[2, -1.3, 2, -1.4]");
    assert!(!loads::vanishes_at_every_order(&unlike, Quantity::FORCE));
}

#[test]
fn a_link_in_line_with_its_master_has_real_even_and_imaginary_odd_harmonics() {
    let turns = |numerator: i64, denominator: i64| BigRational::new(numerator.into(), denominator.into());
    let lengths = [turns(1, 3), turns(1, 4), turns(1, 4)];
    let linkage = |angle: BigRational, correction: BigRational| {
        CorrectedLinkage::new(lengths.each_ref(), [&angle, &correction]).expect("a linkage")
    };
    let one = linkage(turns(1, 2), turns(1, 100));
    for order in 1..=9 {
        let zero = if order % 2 == 0 { Component::Imaginary } else { Component::Real };
        let found = one.component(order, zero);
        assert!(found.contains_zero() && found.width() < turns(1, 1 << 62), "order {order}");
        let other = if order % 2 == 0 { Component::Real } else { Component::Imaginary };
        assert!(!one.component(order, other).contains_zero());
    }
    // The other theorems on h_k.
    let [here, mirrored, back] = [(1, 1), (-1, -1), (1, -1)].map(|(a, b)| linkage(turns(2 * a, 9), turns(b, 90)));
    for order in 1..=8 {
        let [here, mirrored, back] = [&here, &mirrored, &back].map(|one| one.number(order).to_complex());
        let sign = if order % 2 == 0 { 1.0 } else { -1.0 };
        assert!((here.conj() - mirrored).norm() < 1e-17 && (here * sign - back).norm() < 1e-17, "order {order}");
    }
}

#[test]
fn no_orders_above_one_add_more_than_their_bound() {
    let mut dice = Dice::new(7);
    for _ in 0..4 {
        let (text, _) = random_engine(&mut dice);
        let engine = read(&text);
        let tails = Tails::new(&engine).expect("numbers");
        for first in [2, 3, 6, 12] {
            let orders: Vec<u32> = (first + 1..first + 14).collect();
            let loads = of_orders(&engine, &orders);
            let sum: f64 = loads.orders.iter().map(|one| one.force.largest()).sum();
            let bound = tails.above(&engine, Quantity::FORCE, first);
            assert!(sum <= bound, "{sum} above order {first}, bound {bound}\n{text}");
            assert!(first < 12 || bound < 1e-2, "{bound}\n{text}");
        }
    }
}

fn honest() -> Document {
    let engine = alone([380, 90, 290], 80, "knuckle_correction = 3", "");
    document(&engine, &judged(&engine, &[1, 2, 3], false), false, None)
}

#[test]
fn a_single_sum_before_a_number_that_may_be_zero_takes_an_enclosure() {
    // Mirror pairs about a master without mass: one part of h_k is left in each order of each sense.
    let engine = read(
        "[fan]\nbanks = [0, 80, -80]\nthrows = [0]\n[mechanism]\nrod_ratio = '1/3.8'\nreciprocating_mass = [0, 1, 1]\n[articulated]\nmaster = 1\nknuckle_ratio = '0.9/3.8'\nknuckle_correction = [3, 3]",
    );
    let verdicts = judged(&engine, &[3], false);
    for outcome in &verdicts[0].force.outcomes {
        assert!(matches!(outcome, Outcome::NotZeroByEnclosure { .. }), "{outcome:?}");
    }
    let honest = document(&engine, &verdicts, false, None);
    assert!(check_document(&honest).is_ok());
    let mut cheat = honest.clone();
    cheat.wholes[0].outcome = WholeOutcome::NotZero;
    let fault = check_document(&cheat).expect_err("a cheat").to_string();
    assert!(fault.contains("enclosure"), "{fault}");
    second::accepts(&[honest], &[]);
    second::refuses(&[("not zero, by a theorem", cheat)]);
}

#[test]
fn cheats_with_corrected_angles_are_refused() {
    check_document(&honest()).expect("an honest document");
    let with_link = |change: &dyn Fn(&mut crankstar::proof::LinkClaim)| {
        let mut cheat = honest();
        for cylinder in &mut cheat.cylinders {
            if let RodStatement::Link(link) = &mut cylinder.rod {
                change(link);
            }
        }
        cheat
    };
    let turn = |numerator: i64, denominator: i64| BigRational::new(numerator.into(), denominator.into());
    let whole = |outcome: WholeOutcome| {
        let mut cheat = honest();
        cheat.wholes[0].outcome = outcome;
        cheat
    };
    let below = |below: f64| whole(WholeOutcome::NotDecided { below });
    let cheats: Vec<(&str, Document)> = vec![
        ("another correction", with_link(&|link| link.correction = turn(1, 119))),
        ("its other sign", with_link(&|link| link.correction = turn(-1, 120))),
        ("none", with_link(&|link| link.correction = turn(0, 1))),
        ("another angle", with_link(&|link| link.angle = turn(1, 4))),
        ("another master rod", with_link(&|link| link.master = turn(1, 4))),
        ("a correction that is not acute", with_link(&|link| link.correction = turn(1, 4))),
        ("a link that is too short", with_link(&|link| link.ratio = turn(1, 1))),
        ("zero", whole(WholeOutcome::Zero)),
        ("not zero, by a theorem", whole(WholeOutcome::NotZero)),
        ("open", whole(WholeOutcome::Open)),
        ("too few bits", whole(WholeOutcome::NotZeroByEnclosure { bits: 8 })),
        ("not decided where it is", below(1e-30)),
        ("not decided, and large", below(2.0)),
    ];
    for (what, cheat) in &cheats {
        assert!(check_document(cheat).is_err(), "{what}");
    }
    second::accepts(&[honest()], &[]);
    second::refuses(&cheats);
    let json = serde_json::to_string(&honest()).expect("JSON");
    assert!(json.contains("\"correction\":\"1/120\""), "{json}");
    assert!(read_document(json.replace("\"correction\"", "\"corection\"").as_bytes()).is_err());
}

#[test]
fn numbers_of_links_in_a_remedy_are_named_by_what_tells_them() {
    let engine = mirror_pairs();
    let cured = remedy(&engine, &Request { orders: vec![1, 2], ..Request::default() }).expect("a remedy");
    let document = report::remedy_document(&cured);
    let coefficients = document.weights.iter().flat_map(|weight| &weight.parts).map(|part| &part.coefficient);
    assert!(coefficients.clone().any(|one| matches!(one, Coefficient::Corrected(_))));
    let mut cheat = document.clone();
    for part in cheat.weights.iter_mut().flat_map(|weight| &mut weight.parts) {
        if let Coefficient::Corrected(linkage) = &mut part.coefficient {
            linkage.correction = BigRational::new(1.into(), 50.into());
        }
    }
    let json = |document| serde_json::to_vec(document).expect("JSON");
    checked(&json(&document), "the remedy");
    second::accepts(&[&document], &[]);
    second::refuses(&[("another number", &cheat)]);
    let cheat = read_document(&json(&cheat));
    assert!(cheat.is_err() || cheat.expect("a document").check().is_err());
}
