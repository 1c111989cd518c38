//! Do masses on the crankshaft and balancer shafts add what the theory says, and does the thesis's arithmetic hold?
use crankstar::engine::{Engine, throws};
use crankstar::file::find;
use crankstar::loads::{Loads, Missing, Outcome, loads};
use crankstar::order::{MassGroup, NotComparable};
use crankstar::page::Format;
use crankstar::proof::Quantity;
use crankstar::verdict::Judgement;

use crate::support::pages;
use crate::support::written::{engine as read, fraction};

const I3: &str = include_str!("../../reports/examples/thesis-i3/layout.toml");
const CROSS: &str = include_str!("../../reports/examples/thesis-v8-crossplane/layout.toml");
const FLAT: &str = include_str!("../../reports/examples/thesis-v8-flatplane/layout.toml");

/// The engine with these keys in its table [crankshaft].
fn with_keys(engine: &str, keys: &str) -> Engine {
    const HEAD: &str = "[crankshaft]\n";
    let engine = if engine.contains(HEAD) { engine.to_owned() } else { format!("{engine}\n{HEAD}") };
    read(&engine.replace(HEAD, &format!("{HEAD}{keys}\n")))
}

fn with_factor(engine: &str, factor: &str, web_offset: &str) -> Engine {
    with_keys(
        engine,
        &format!("balance_factor = {factor}\ncounterweight_radius = '45 mm'\nweb_offset = '{web_offset}'"),
    )
}

fn computed(layout: &Engine) -> Loads {
    loads(layout, &[1, 2]).expect("numbers")
}

/// Largest direct moment of order 1 in newton-metres.
fn direct_moment(loads: &Loads) -> f64 {
    let factor = loads.scale.as_ref().expect("masses, crank and speed").force();
    loads.orders[0].moment.direct.value.norm() / 2.0 * factor
}

#[track_caller]
fn assert_near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-5 * expected.abs(), "{value} instead of {expected}");
}

#[test]
fn cylinders_that_share_a_pin_make_one_throw() {
    let angles = |name: &str| {
        let layout = find(name).unwrap_or_else(|| panic!("{name}")).engine().expect("a layout");
        throws(&layout)
            .into_iter()
            .map(|throw| (throw.angle.degrees().to_string(), throw.cylinders))
            .collect::<Vec<_>>()
    };
    let throw = |angle: &str, cylinders: &[usize]| (angle.to_owned(), cylinders.to_vec());
    assert_eq!(
        angles("V8-crossplane"),
        [throw("0", &[0, 4]), throw("270", &[1, 5]), throw("90", &[2, 6]), throw("180", &[3, 7])]
    );
    assert_eq!(angles("I4").len(), 4);
    let split = read("[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\npin_split = -60");
    assert_eq!(
        throws(&split).iter().map(|throw| throw.cylinders.clone()).collect::<Vec<_>>(),
        [vec![0], vec![3], vec![1], vec![4], vec![2], vec![5]]
    );
    let radial = read("[radial]\ncylinders = 9\nrows = 2\nrow_rotation = 20\nrow_throw = 180");
    assert_eq!(throws(&radial).iter().map(|throw| throw.cylinders.len()).collect::<Vec<_>>(), [9, 9]);
}

#[test]
fn a_throw_stands_in_the_middle_of_its_cylinders() {
    let positions: Vec<String> = throws(&read(CROSS)).iter().map(|throw| throw.position.to_string()).collect();
    assert_eq!(positions, ["9/50", "3/50", "-3/50", "-9/50"]);
}

#[test]
fn cylinders_of_single_tables_share_a_pin_where_they_say_so_or_stand_together() {
    let cylinder =
        |position: &str, rest: &str| format!("[[cylinder]]\nthrow = 0\nbank = 0\nposition = {position}\n{rest}\n");
    let count = |text: String| throws(&read(&text)).len();
    assert_eq!(count(cylinder("1", "") + &cylinder("1", "")), 1);
    assert_eq!(count(cylinder("1", "") + &cylinder("2", "")), 2);
    assert_eq!(count(cylinder("1", "pin = 1") + &cylinder("2", "pin = 1")), 1);
    assert_eq!(count(cylinder("1", "pin = 1") + &cylinder("1", "pin = 2")), 2);
}

#[test]
fn the_thesis_weighs_its_crankshafts_so() {
    let mass = |layout: Engine| layout.crankshaft_mass().expect("masses");
    assert_eq!(mass(read(I3)), fraction(2475, 1000));
    assert_eq!(mass(with_factor(I3, "0.65", "20 mm")), fraction(408_375, 100_000));
    assert_eq!(mass(with_factor(I3, "1", "20 mm")), fraction(495, 100));
    for v8 in [FLAT, CROSS] {
        assert_eq!(mass(read(v8)), fraction(58, 10));
        assert_eq!(mass(with_factor(v8, "0.65", "30 mm")), fraction(957, 100));
        assert_eq!(mass(with_factor(v8, "1", "30 mm")), fraction(116, 10));
    }
}

#[test]
fn a_balance_factor_makes_the_counterweights_of_the_thesis() {
    let i3 = with_factor(I3, "0.65", "20 mm");
    let weights = &i3.crankshaft().counterweights;
    let positions: Vec<String> = weights.iter().map(|weight| weight.position.to_string()).collect();
    assert_eq!(positions, ["3/25", "2/25", "1/50", "-1/50", "-2/25", "-3/25"]);
    assert!(weights.iter().all(|weight| weight.mass == fraction(268_125, 1_000_000)));
    assert_eq!(i3.balance_factors(), vec![Some(fraction(65, 100)); 3]);
    let v8 = with_factor(CROSS, "1", "30 mm");
    assert!(v8.crankshaft().counterweights.iter().all(|weight| weight.mass == fraction(725, 1000)));
    let listed = with_factor(I3, "[0, 1, 0.5]", "0 m");
    assert_eq!(listed.balance_factors(), vec![Some(fraction(0, 1)), Some(fraction(1, 1)), Some(fraction(1, 2))]);
    assert_eq!(listed.crankshaft().counterweights.len(), 3);
}

#[test]
fn a_balance_factor_scales_the_direct_moment_and_the_factor_1_removes_it_exactly() {
    for (engine, offset, bare) in [(I3, "20 mm", 2538.56), (CROSS, "30 mm", 9775.11)] {
        assert_near(direct_moment(&computed(&read(engine))), bare);
        assert_near(direct_moment(&computed(&with_factor(engine, "0.65", offset))), 0.35 * bare);
        let balanced = computed(&with_factor(engine, "1", offset));
        assert_eq!(balanced.orders[0].moment.direct.outcome, Outcome::Zero);
        assert_eq!(balanced.orders[0].force.direct.outcome, Outcome::Zero);
        assert!(balanced.groups.iter().any(|group| group.group == MassGroup::Counterweights));
    }
}

#[test]
fn the_skewed_counterweights_of_table_6_7_leave_7328_newtons_at_300_degrees_and_235_newton_metres() {
    let rows =
        [(1, 210, "0.12"), (1, 180, "0.08"), (2, 180, "0.02"), (2, 180, "-0.02"), (3, 180, "-0.08"), (3, 150, "-0.12")];
    let weights = rows.map(|(throw, angle, position)| {
        format!("[[counterweight]]\nthrow = {throw}\nangle = {angle}\nmass = 0.4125\nradius = 0.045\nposition = {position}\n")
    });
    let layout = read(&format!("{I3}\n{}", weights.concat()));
    let loads = computed(&layout);
    let force = loads.orders[0].force.direct.value;
    assert_near(force.norm() / 2.0 * loads.scale.as_ref().expect("a scale").force(), 7328.18);
    assert_near(force.arg().to_degrees(), -60.0);
    assert_near(direct_moment(&loads), 235.63);
    assert_near(loads.orders[0].moment.direct.value.arg().to_degrees(), -150.0);
}

#[test]
fn pins_and_webs_weigh_what_a_rotating_mass_at_the_rods_does() {
    // 0.2 kg a throw at 45 mm: at the pin, as webs of 0.6 kg at 15 mm, or shared by two rods of 0.3 kg.
    const RODS: &str = "rotating_mass = \"0.3 kg\"";
    const PIN: &str = "pin_mass = \"0.2 kg\"";
    assert!(CROSS.contains(RODS) && CROSS.contains(PIN));
    let pins = read(CROSS);
    let webs = read(&CROSS.replace(PIN, "web_mass = '0.6 kg'\nweb_radius = '15 mm'"));
    let rods = read(&CROSS.replace(PIN, "").replace(RODS, "rotating_mass = '0.4 kg'"));
    assert_eq!(pins.crankshaft_mass(), rods.crankshaft_mass());
    assert_eq!(webs.crankshaft_mass(), rods.crankshaft_mass());
    let [pins, webs, rods] = [pins, webs, rods].map(|layout| computed(&layout));
    assert_near(direct_moment(&pins), direct_moment(&rods));
    assert_near(direct_moment(&webs), direct_moment(&rods));
    let has = |loads: &Loads| loads.groups.iter().any(|group| group.group == MassGroup::Crankshaft);
    assert_eq!([has(&pins), has(&webs), has(&rods)], [true, true, false]);
}

#[test]
fn a_lanchester_pair_is_a_term_of_order_2_direct_and_reverse() {
    let engine = "speed = 1000\n[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\nreciprocating_mass = 1\ncrank_radius = 0.05\nrod_ratio = 0.25\n";
    // 2·2²·U = ¼·4 m r: the part of the second order that c_2 ≈ ¼ leaves over is small.
    let pair = ["with", "against"].map(|sense| {
        format!("[[balancer]]\norder = 2\nsense = '{sense}'\nmass_radius = '6.25 kg mm'\nangle = 180\nposition = 0\n")
    });
    let loads = computed(&read(&format!("{engine}{}", pair.concat())));
    let c2 = loads.orders[1].coefficient.as_ref().expect("a common rod").to_complex().re;
    for vector in [&loads.orders[1].force.direct, &loads.orders[1].force.reverse] {
        assert_near(vector.value.re, 4.0 * c2 - 1.0);
    }
    assert!(loads.groups.iter().any(|group| group.group == MassGroup::Balancers));
}

/// The frame rolls with −T; at half the height a pair takes half of order 2, at the whole height all of it.
#[test]
fn the_height_of_a_pair_counts_in_the_roll_moment() {
    let engine = "speed = 1000\neffects = ['torque']\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = '0.1 m'\n[mechanism]\nreciprocating_mass = 1\ncrank_radius = 0.05\nrod_ratio = 0.25\n";
    let order_2 = |height: f64, offset: f64| {
        let shafts = [("with", 0.5), ("against", -0.5)].map(|(sense, side)| {
            format!(
                "[[balancer]]\norder = 2\nsense = '{sense}'\nmass_radius = 0.00635\nangle = 180\nposition = 0\nheight = {:.12}\noffset = {offset:.12}\n",
                side * height
            )
        });
        let loads = computed(&read(&format!("{engine}{}", shafts.concat())));
        let roll = loads.roll.expect("a roll moment");
        let torque = loads.torque.expect("a torque");
        let of = |torque: &[crankstar::loads::TorqueOrder]| {
            torque.iter().find(|order| order.order == 2).expect("order 2").vector.value
        };
        (of(&roll.orders), of(&torque.orders))
    };
    let (level, torque) = order_2(0.0, 0.0);
    assert_near((level + torque).norm() + 1.0, 1.0);
    // (h₊ − h₋) n² U = 2 m r² takes all of T ≈ −2 m r² ω² sin 2θ.
    let height = torque.norm() * 0.05 * 0.05 / (4.0 * 0.00635);
    assert_near(order_2(height, 0.0).0.norm() + 1.0, 1.0);
    assert_near(order_2(height / 2.0, 0.0).0.norm(), torque.norm() / 2.0);
    assert!(order_2(-height, 0.0).0.norm() > 1.9 * torque.norm());
    // Both axes on the same side pull with a moment of their own, 2 n² U e ω² cos 2θ.
    let aside = 2.0 * 4.0 * 0.00635 * 0.03 / (0.05 * 0.05);
    assert_near(order_2(height, 0.03).0.norm(), aside);
}

#[test]
fn bob_weights_are_those_of_the_workshop() {
    let half = fraction(1, 2);
    let bob = read(CROSS).bob_weight(0, &half).expect("masses");
    // 0.3 kg of the rod and half of 0.65 kg; the pin of 0.2 kg turns on the machine itself.
    assert_eq!(bob.per_cylinder, vec![fraction(625, 1000); 2]);
    assert_eq!(bob.per_throw, fraction(125, 100));
    assert_eq!(read("inline.throws = [0]").bob_weight(0, &half), None);
}

/// Workshops hang the whole big end of a master rod on the pin, with its knuckle pins and the big ends of the links, and half of all pistons.
#[test]
fn the_bob_weight_of_a_radial_holds_its_knuckle_masses() {
    let nine = "[radial]\ncylinders = 9\n[articulated]\nmaster = 1\nknuckle_radius = '70 mm'\nknuckle_mass = '0.8 kg'\n\
        [mechanism]\nstroke = '160 mm'\nrod_length = '320 mm'\nreciprocating_mass = '3 kg'\nrotating_mass = ['5 kg', 0, 0, 0, 0, 0, 0, 0, 0]\n";
    let engine = read(nine);
    let bob = engine.bob_weight(0, &fraction(1, 2)).expect("masses");
    assert_eq!(bob.per_throw, fraction(5000 + 8 * 800 + 9 * 1500, 1000));
    assert_eq!(engine.crankshaft_mass().as_ref(), Some(&bob.per_throw), "no pin, no webs");
    // What half the reciprocating masses leave of the exact counterweight hangs on the obliquity of the rods alone: below 1 %.
    let weighed = read(&format!(
        "{nine}[crankshaft]\ncounterweights = {{ rotating = 1, reciprocating = 0.5 }}\ncounterweight_radius = '150 mm'\n"
    ));
    let first = |engine: &Engine| loads(engine, &[1]).expect("numbers").orders[0].force.largest();
    assert!(first(&weighed) < 0.01 * first(&engine), "{} of {}", first(&weighed), first(&engine));
}

#[test]
fn what_cannot_be_compared_is_missing() {
    let weight = "[[counterweight]]\nthrow = 1\nmass = 1\nradius = 0.05\n";
    let missing = |mechanism: &str| {
        let layout = read(&format!("inline.throws = [0]\n[mechanism]\nrod_ratio = 0.25\n{mechanism}\n{weight}"));
        loads(&layout, &[1]).err()
    };
    assert_eq!(missing(""), Some(Missing::NotComparable(NotComparable::Masses)));
    assert_eq!(missing("reciprocating_mass = 1"), Some(Missing::NotComparable(NotComparable::CrankRadius)));
    assert_eq!(missing("reciprocating_mass = 1\ncrank_radius = 0.05"), None);
}

#[test]
fn the_page_of_an_engine_with_masses_that_turn_says_whose_masses_its_verdicts_are_about() {
    let bare = read("[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.25\n");
    let whose = |engine: &Engine| {
        let judged = Judgement::new(engine, &[1, 2], &Quantity::PLANAR).expect("orders");
        pages::text(&crankstar::report::engine_answer(engine, &judged), Format::PLAIN)
    };
    assert!(!whose(&bare).contains("As built"));
    assert!(whose(&read(I3)).contains("As built: reciprocating masses, "));
}
