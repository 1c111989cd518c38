//! Do links on a master rod move, shake and vanish as they have to? Against published tables, a closed motion, and the momentum of every body.

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::loads;
use crankstar::motion::Linkage;
use crankstar::proof::{RodStatement, Sense, Shape, check_document, read_document};
use crankstar::remedy::{Request, remedy};
use crankstar::report;
use crankstar::verdict::Outcome;
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::linked::{Body, Linked, assert_halves, assert_shakes_as_bodies, of_orders, order, read};
use crate::support::second;
use crate::support::verdicts::{document, judged};

fn radial(count: u32, [r, l, a]: [&str; 3], more: &str) -> Engine {
    read(&format!(
        "[radial]\ncylinders = {count}\n{more}\n[mechanism]\nrod_ratio = '{r}/{l}'\n[articulated]\nknuckle_ratio = '{a}/{l}'\nmaster = 1"
    ))
}

fn rows(masters: &str, rotation: &str) -> Engine {
    read(&format!(
        "[radial]\ncylinders = 9\nrows = 2\nrow_throw = 180\nrow_rotation = {rotation}\n[mechanism]\nrod_ratio = '1/3.8'\n[articulated]\nknuckle_ratio = '0.9/3.8'\nmaster = {masters}"
    ))
}

#[test]
fn rows_of_five_seven_and_nine_leave_what_the_theory_prints() {
    let typical = ["1", "3.8", "0.9"];
    let table = [
        (5, typical, [2.5, -0.42934, -0.00033, 0.00173, -0.02894, 0.00106, 0.00092]),
        (7, typical, [3.5, -0.60108, -0.00061, 0.00244, -0.00002, -0.00001, 0.00150]),
        (9, typical, [4.5, -0.77282, -0.00078, 0.00314, 0.000005, -0.00001, 0.000002]),
        (9, ["1", "4", "1"], [4.5, -0.78606, -0.00082, 0.00328, 0.00001, -0.00001, 0.000002]),
    ];
    for (count, ratios, expected) in table {
        let engine = radial(count, ratios, "");
        let loads = of_orders(&engine, &[1, 2, 3, 4, 5, 6]);
        let [first, rest @ ..] = expected;
        assert_halves(&order(&loads, 1).force, [first, 0.0], 9);
        assert!(order(&loads, 3).force.vanishes() && order(&loads, 5).force.vanishes());
        for (k, pair) in [2, 4, 6].into_iter().zip(rest.chunks(2)) {
            let swing = &order(&loads, k).force;
            for (vector, expected) in [&swing.direct, &swing.reverse].into_iter().zip(pair) {
                let half = vector.value / 2.0;
                // The direction theorem: along the axis of the master, and nothing across it.
                assert!((half.re - expected).abs() < 0.51e-5, "{count} order {k}: {half}, expected {expected}");
                assert!(half.im.abs() < 1e-15);
            }
        }
    }
    let jupiter = of_orders(&radial(9, ["2.75", "16", "3.5"], ""), &[2, 4]);
    assert_halves(&order(&jupiter, 2).force, [0.44165, 0.00014], 5);
    assert_halves(&order(&jupiter, 4).force, [0.00055, 0.0], 5);
}

#[test]
fn two_rows_with_masters_opposite_leave_no_force_of_even_order_and_prove_it() {
    let engine = rows("[1, 10]", "180");
    for order in judged(&engine, &[1, 2, 4, 6], false) {
        assert_eq!(order.force.shape, Shape::Balanced, "order {}", order.order);
        assert!(order.moment.is_left());
    }
    let loads = of_orders(&engine, &[1, 2]);
    assert_halves(&order(&loads, 1).moment, [4.5, 0.0], 9);
    assert_halves(&order(&loads, 2).moment, [0.7728, 0.0008], 4);
    assert!(loads::vanishes_at_every_order(&engine, crankstar::proof::Quantity::FORCE));
    assert!(!loads::vanishes_at_every_order(&engine, crankstar::proof::Quantity::MOMENT));
}

#[test]
fn two_rows_with_masters_a_hundred_degrees_apart_are_those_of_the_double_wasp() {
    // The second row stands 20° on; its cylinder 12 stands 100° from cylinder 1.
    let engine = rows("[1, 12]", "20");
    let loads = of_orders(&engine, &[1, 2, 4]);
    assert!(order(&loads, 1).force.vanishes());
    assert_halves(&order(&loads, 2).force, [0.9935, 0.0014], 4);
    assert_halves(&order(&loads, 4).force, [0.0054, 0.0], 4);
    assert_halves(&order(&loads, 1).moment, [4.5, 0.0], 9);
    assert_halves(&order(&loads, 2).moment, [0.5920, 0.0004], 4);
    let cured = remedy(&engine, &Request { orders: vec![1, 2, 4], ..Request::default() }).expect("a remedy");
    let second: Vec<f64> = cured
        .weights()
        .iter()
        .filter(|weight| (weight.order, weight.sense) == (2, Sense::Direct))
        .map(|weight| weight.decimals(&cured.subject).expect("numbers")[0])
        .collect();
    // One shaft at twice crank speed at each row, |P₂⁺|/8 of a row.
    assert_eq!(second.len(), 2);
    assert!(second.iter().all(|size| (size - 2.0 * 0.77282 / 8.0).abs() < 2e-6), "{second:?}");
}

fn vee(bank_angle: u32, throws: &str, masters: &str) -> Engine {
    read(&format!(
        "[vee]\nbank_angle = {bank_angle}\nthrows = [{throws}]\n[mechanism]\nrod_ratio = '1/3.6'\n[articulated]\nknuckle_ratio = '0.9/3.6'\nmaster = [{masters}]"
    ))
}

#[test]
fn a_linked_v12_leaves_order_six_alone_and_a_linked_cross_plane_v8_order_four() {
    let twelve = vee(60, "0, 120, 240, 240, 120, 0", "1, 2, 3, 4, 5, 6");
    let loads = of_orders(&twelve, &[1, 2, 3, 4, 6]);
    for one in &loads.orders {
        assert!(one.moment.vanishes());
        assert_eq!(one.force.vanishes(), one.order != 6);
    }
    assert_halves(&order(&loads, 6).force, [0.0013, 0.0007], 4);
    let eight = of_orders(&vee(90, "0, 90, 270, 180", "1, 2, 3, 4"), &[1, 2, 4, 6]);
    for one in &eight.orders {
        assert_eq!(one.force.vanishes(), one.order != 4);
        assert_eq!(one.moment.vanishes(), one.order != 1);
    }
    assert_halves(&order(&eight, 4).force, [0.0434, 0.0258], 4);
    assert_halves(&order(&eight, 1).moment, [10_f64.sqrt(), 0.0], 9);
}

#[test]
fn the_harmonics_of_random_links_are_those_of_the_closed_motion() {
    let mut dice = Dice::new(14);
    for _ in 0..40 {
        let (l, a) = (280 + dice.below(300), 30 + dice.below(150));
        let long = l - a + dice.below(40);
        let degrees = 1 + dice.below(359);
        let linked = Linked {
            rod: l as f64 / 100.0,
            radius: a as f64 / 100.0,
            delta: TAU * degrees as f64 / 360.0,
            correction: 0.0,
            link: long as f64 / 100.0,
        };
        // The link alone has a mass, so that its order k is c_k.
        let engine = read(&format!(
            "orders = [1, 2, 3, 4, 5, 6, 8]\n[fan]\nbanks = [0, {degrees}]\nthrows = [0]\n[mechanism]\nrod_ratio = '100/{l}'\nreciprocating_mass = [0, 1]\n[articulated]\nmaster = 1\nknuckle_ratio = '{a}/{l}'\nlink_ratio = '100/{long}'"
        ));
        let loads = of_orders(&engine, &[1, 2, 3, 4, 5, 6, 8]);
        for one in &loads.orders {
            let (k, c) = (f64::from(one.order), linked.coefficient(one.order));
            let turned = |by: f64| Complex::cis(by * linked.delta);
            let (harmonic, mirrored) = (c * turned(1.0 - k), c.conj() * turned(1.0 + k));
            for (found, expected) in [(&one.force.direct, harmonic), (&one.force.reverse, mirrored)] {
                assert!((found.value - expected).norm() < 1e-12, "order {}: {} and {expected}", one.order, found.value);
            }
        }
    }
}

/// A radial with masses as it happens, and its bodies: pistons, masses at knuckle pins, rotating masses.
fn random_radial(dice: &mut Dice) -> (String, Vec<Body>) {
    let count = 3 + dice.below(7);
    let (l, a) = (320 + dice.below(200), 60 + dice.below(60));
    let (piston, knuckle, big_end) = (1 + dice.below(4), dice.below(3), dice.below(5));
    let master = dice.below(count);
    let mass_of = |index: u64| if index == master { piston + 1 } else { piston };
    let masses: Vec<String> = (0..count).map(|index| mass_of(index).to_string()).collect();
    let rotating: Vec<String> =
        (0..count).map(|index| if index == master { big_end.to_string() } else { "0".to_owned() }).collect();
    let text = format!(
        "[radial]\ncylinders = {count}\n[mechanism]\ncrank_radius = 1\nrod_ratio = '100/{l}'\nreciprocating_mass = [{}]\nrotating_mass = [{}]\n[articulated]\nmaster = {}\nknuckle_ratio = '{a}/{l}'\nknuckle_mass = '0.{knuckle}'",
        masses.join(", "),
        rotating.join(", "),
        master + 1
    );
    let base = TAU * master as f64 / count as f64;
    let mut bodies: Vec<Body> = Vec::new();
    for index in 0..count {
        let bank = TAU * index as f64 / count as f64;
        let (rod, radius) = (l as f64 / 100.0, a as f64 / 100.0);
        let linked = Linked { rod, radius, delta: bank - base, correction: 0.0, link: rod - radius };
        let mass = mass_of(index) as f64;
        if index == master {
            bodies.push((mass, Box::new(move |theta| Complex::cis(bank) * linked.master(theta - base))));
            bodies.push((big_end as f64, Box::new(Complex::cis)));
        } else {
            bodies.push((mass, Box::new(move |theta| Complex::cis(bank) * linked.piston(theta - base))));
            let pin = move |theta: f64| Complex::cis(base) * linked.knuckle(theta - base);
            bodies.push((knuckle as f64 / 10.0, Box::new(pin)));
        }
    }
    (text, bodies)
}

#[test]
fn random_radials_shake_as_the_momentum_of_every_body_changes() {
    let mut dice = Dice::new(1830);
    for _ in 0..12 {
        let (text, bodies) = random_radial(&mut dice);
        let orders: Vec<u32> = [1].into_iter().chain((2..=26).step_by(2)).collect();
        assert_shakes_as_bodies(&text, &bodies, &orders);
    }
}

#[test]
fn documents_of_random_radials_with_master_rods_verify() {
    let mut dice = Dice::new(2800);
    for _ in 0..6 {
        let (text, _) = random_radial(&mut dice);
        let engine = read(&text);
        let verdicts = judged(&engine, &[1, 2, 3, 4], false);
        let all = document(&engine, &verdicts, false, None);
        second::accepts(&[&all], &[]);
        let mut cheat = all.clone();
        for cylinder in &mut cheat.cylinders {
            if let RodStatement::Link(link) = &mut cylinder.rod {
                link.ratio = BigRational::from_integer(5.into());
            }
        }
        check_document(&cheat).expect_err("links that cannot turn round");
        second::refuses(&[("links that cannot turn round", cheat)]);
        let cured = remedy(&engine, &Request { orders: vec![1, 2, 4], ..Request::default() }).expect("a remedy");
        for bytes in [
            serde_json::to_vec(&all).expect("JSON"),
            serde_json::to_vec(&report::remedy_document(&cured)).expect("JSON"),
        ] {
            let read = read_document(&bytes).unwrap_or_else(|error| panic!("{error}\n{text}"));
            if let Err(fault) = read.check() {
                panic!("{fault}\n{text}");
            }
        }
    }
}

#[test]
fn the_checker_encloses_the_number_of_a_link_where_the_program_does() {
    let whole = |number: i64| BigRational::from_integer(number.into());
    // Δ = 0: z = 1 − κ, and g_k z^k is (1−κ) times the c_k of a centric crank of ratio (1−κ) r/L.
    let (ratio, knuckle) = (BigRational::new(2.into(), 5.into()), BigRational::new(1.into(), 4.into()));
    let z = whole(1) - &knuckle;
    let linkage = Linkage::new(ratio.clone(), knuckle, whole(0)).expect("a linkage");
    let crank = crankstar::motion::SliderCrank::new(&ratio * &z, whole(0)).expect("a crank");
    for order in [2, 4, 6, 8, 40] {
        let power = num_traits::pow(z.clone(), order as usize - 1);
        let expected = crank.coefficient(order).re.times(&power.recip());
        let found = linkage.number(order);
        assert!(found.low <= expected.high && expected.low <= found.high, "order {order}");
        assert!(found.width() < BigRational::new(1.into(), (1_u64 << 60).into()) * found.high.clone().max(-&found.low));
    }
}

#[test]
fn a_row_of_even_number_leaves_every_even_order_direct_and_reverse() {
    for count in [4, 6, 8] {
        for order in judged(&radial(count, ["1", "3.8", "0.9"], ""), &[2, 4, 6, 8, 10], false) {
            for outcome in &order.force.outcomes {
                assert!(matches!(outcome, Outcome::NotZeroByEnclosure { .. } | Outcome::NotZero), "{count}");
            }
        }
    }
}

#[test]
fn what_links_have_no_numbers_for_is_told_and_not_computed() {
    let row = "[radial]\ncylinders = 5\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2";
    let error = file::parse("engine.toml", &format!("effects = ['torque']\n{row}")).expect_err("a mistake").to_string();
    assert!(error.contains("articulated rods") && error.contains("the exact inertia torque"), "{error}");
}

#[test]
fn every_mistake_in_the_table_of_articulated_rods_is_told() {
    let row = |mechanism: &str, keys: &str| {
        format!("[radial]\ncylinders = 5\n[mechanism]\n{mechanism}\n[articulated]\n{keys}")
    };
    let rod = "rod_ratio = 0.25";
    for (mechanism, keys, words) in [
        (rod, "master = 6\nknuckle_ratio = 0.2", "there is no cylinder `6`"),
        (rod, "master = [1, 2]\nknuckle_ratio = 0.2", "share a crankpin"),
        (rod, "master = 1", "no knuckle radius"),
        (rod, "master = 1\nknuckle_ratio = 0", "above 0"),
        (rod, "master = 1\nknuckle_radius = '50 mm'", "without a crank radius"),
        (rod, "master = 1\nknuckle_ratio = 0.2\nknuckle_radius = '50 mm'", "one of them is enough"),
        (rod, "master = 1\nknuckle_ratio = [0.2, 0.3]", "2 values for 4 links"),
        (rod, "master = 1\nknuckle_ratio = 1.5", "farther out than the master rod is long"),
        (rod, "master = 1\nknuckle_ratio = 0.2\nlink_ratio = 0.9", "too short for its crank to turn round"),
        (rod, "master = 1\nknuckle_ratio = 0.2\nknuckle_mass = '0.2'", "masses that are not known"),
        ("rod_ratio = [0.25, 0.3, 0.25, 0.25, 0.25]", "master = 1\nknuckle_ratio = 0.2", "differ in crank or rod"),
        ("rod_ratio = 0.25\noffset_ratio = 0.01", "master = 1\nknuckle_ratio = 0.2", "has an offset"),
        (
            "rod_ratio = 0.25\nreciprocating_mass = 1\nrotating_mass = 1",
            "master = 1\nknuckle_ratio = 0.2",
            "yet a rotating mass",
        ),
    ] {
        let error = file::parse("engine.toml", &row(mechanism, keys)).expect_err("a mistake").to_string();
        assert!(error.contains(words), "{error}\nexpected {words}");
    }
    let open = "[vee]\nbank_angle = 'phi'\nthrows = [0]\n[mechanism]\nrod_ratio = 0.25\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2";
    let error = file::parse_layout("engine.toml", open).expect_err("a mistake").to_string();
    assert!(error.contains("unknown angles or positions"), "{error}");
}

#[test]
fn a_scotch_yoke_has_order_one_of_the_force_and_order_two_of_the_torque() {
    let engine = read("effects = ['torque']\ninline.throws = [0]\n[mechanism]\nscotch_yoke = true");
    let loads = of_orders(&engine, &[1, 2, 4]);
    let existing: Vec<u32> = loads.orders.iter().filter(|one| one.exists(&engine)).map(|one| one.order).collect();
    assert_eq!(existing, [1]);
    let torque = loads.torque.expect("a torque");
    let left: Vec<u32> =
        torque.orders.iter().filter(|one| one.vector.value.norm() > 0.0).map(|one| one.order).collect();
    assert_eq!(left, [2]);
    let left_out = loads::left_out(&engine, &[1], &[2]).expect("numbers");
    assert!(left_out.force.is_none() && left_out.torque.is_none(), "nothing is left out: {left_out:?}");
    let with_rod = "inline.throws = [0]\n[mechanism]\nscotch_yoke = true\nrod_ratio = 0.3";
    let error = file::parse("engine.toml", with_rod).expect_err("a mistake").to_string();
    assert!(error.contains("a Scotch yoke with a connecting rod"), "{error}");
}
