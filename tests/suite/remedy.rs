//! Do the proposed weights balance the engine, exactly, and are they those of theory and thesis?
use std::f64::consts::TAU;

use crankstar::claim::{self, Status};
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::file::{catalogue, parse};
use crankstar::loads::{Outcome, loads};
use crankstar::motion::SliderCrank;
use crankstar::numbers::Direction;
use crankstar::proof::{RemedyDocument, Sense, Vector, check_certificate, check_remedy_document};
use crankstar::remedy::{
    ComparableEngine, Kind, PairRoll, Partial, Remedy, RemedyError, Request, corrected, cures, pair_height, remedy,
};
use crankstar::{page, report};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::support::program::{call, scratch};
use crate::support::weights::with_counterweights;
use crate::support::written::{engine as read, fraction, of_catalogue as engine};

const I3: &str = include_str!("../../reports/examples/thesis-i3/layout.toml");
const CROSS: &str = include_str!("../../reports/examples/thesis-v8-crossplane/layout.toml");

fn request(orders: &[u32]) -> Request {
    Request { orders: orders.to_vec(), ..Request::default() }
}

fn planes(first: BigRational, second: BigRational) -> Request {
    Request { orders: vec![1], planes: Some([first, second]), ..Request::default() }
}

/// Every sum of the corrected engine vanishes, and an independent checker accepts the evidence.
#[track_caller]
fn assert_balanced(name: &str, remedy: &Remedy) {
    assert!(!remedy.corrected.is_empty(), "{name}");
    // What is left out as slight stays.
    let slight = |order, sense| remedy.left_out.iter().any(|shaft| (shaft.order, shaft.sense) == (order, sense));
    for judged in remedy.corrected.iter().filter(|judged| !slight(judged.order, judged.sense)) {
        let vectors = judged.sum.terms().iter();
        let vectors: Vec<Vector> =
            vectors.map(|t| Vector { angle: t.angle.turns().clone(), weight: t.weight.clone() }).collect();
        let checked = check_certificate(&vectors, true, &judged.certificate);
        assert_eq!(checked, Ok(()), "{name}, order {}, {:?} {:?}", judged.order, judged.quantity, judged.sense);
    }
}

#[track_caller]
fn assert_near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-6 * expected.abs(), "{value} instead of {expected}");
}

#[test]
fn every_engine_of_the_catalogue_is_balanced_up_to_order_6_by_its_remedy() {
    for (entry, layout) in catalogue().expect("the catalogue") {
        let remedy = remedy(&layout, &request(&[1, 2, 4, 6])).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        assert_balanced(entry.name, &remedy);
    }
}

#[test]
fn the_planes_of_the_moment_stand_where_the_theory_says() {
    // Throws 0, 120, 240: the moment stands at 30°, the weights at 30° and 210°.
    let i3 = remedy(&read("inline.throws = [0, 120, 240]"), &request(&[1])).expect("a remedy");
    let weights = &i3.crankshaft.as_ref().expect("counterweights").weights;
    assert_eq!(weights[0].direction(), Some(Direction::Turn(Turn::fraction(7, 12))));
    assert_eq!(weights[1].direction(), Some(Direction::Turn(Turn::fraction(1, 12))));
    // The 60° V6 with throws 0, 120, 240 and pins that two rods share: 30° from the same throw.
    let v6 = remedy(&read("vee = { bank_angle = 60, throws = [0, 120, 240] }"), &request(&[1])).expect("a remedy");
    let weights = &v6.crankshaft.as_ref().expect("counterweights").weights;
    assert_eq!(weights[0].direction(), Some(Direction::Turn(Turn::fraction(7, 12))));
    for text in ["inline.throws = [0, 270, 90, 180]", "vee = { bank_angle = 90, throws = [0, 270, 90, 180] }"] {
        let cross = remedy(&read(text), &request(&[1])).expect("a remedy");
        let weights = &cross.crankshaft.as_ref().expect("counterweights").weights;
        let [first, second] = [0, 1].map(|at: usize| match weights[at].direction() {
            Some(Direction::Arctangent { tangent, opposite }) => (tangent.to_string(), opposite),
            other => panic!("{other:?}"),
        });
        assert_eq!([first, second], [("−1/3".to_owned(), true), ("−1/3".to_owned(), false)], "{text}");
    }
}

#[test]
fn the_outer_pair_of_the_thesis_weighs_0_5954_kg_on_the_three_and_1_3101_kg_on_the_cross_plane() {
    let cases = [(I3, fraction(12, 100), 0.595_392_5, 3.665_785), (CROSS, fraction(21, 100), 1.310_086_5, 8.420_173)];
    for (text, place, expected, shaft) in cases {
        let layout = read(text);
        let remedy = remedy(&layout, &planes(place.clone(), -place)).expect("a remedy");
        assert_balanced(text, &remedy);
        let weights = &remedy.crankshaft.as_ref().expect("counterweights").weights;
        assert_eq!(weights.len(), 2);
        for weight in weights {
            assert_near(weight.mass_at_crank_radius(&remedy.subject).expect("numbers"), expected);
        }
        assert_near(remedy.crankshaft_mass().expect("numbers"), shaft);
    }
}

#[test]
fn the_engine_with_the_two_counterweights_on_it_has_no_direct_first_order_in_the_loads_either() {
    for text in [I3, CROSS] {
        let remedy = remedy(&read(text), &request(&[1])).expect("a remedy");
        let weights = remedy.crankshaft.as_ref().expect("counterweights").weights.clone();
        let layout = with_counterweights(&remedy.subject, &weights).expect("numbers");
        let order = &loads(&layout, &[1]).expect("numbers").orders[0];
        assert_eq!([&order.force.direct.outcome, &order.moment.direct.outcome], [&Outcome::Zero, &Outcome::Zero]);
    }
}

#[test]
fn balance_factor_1_leaves_no_direct_first_order_and_65_percent_leaves_35() {
    let layout = read(I3);
    let full = remedy(&layout, &Request { factors: vec![fraction(1, 1)], ..request(&[1]) }).expect("a remedy");
    assert!(full.crankshaft.is_none());
    assert_eq!(full.bays.len(), 3);
    let subject = ComparableEngine::new(&layout).expect("masses");
    let bare = subject.moment(1, Sense::Direct);
    let part = remedy(&layout, &Request { factors: vec![fraction(65, 100)], ..request(&[1]) }).expect("a remedy");
    let weights = &part.crankshaft.as_ref().expect("counterweights").weights;
    let added = weights.iter().map(|w| w.adds().scaled(&w.position)).reduce(|a, b| a.plus(&b)).expect("weights");
    assert!(added.plus(&bare.scaled(&fraction(35, 100))).vanishes());
    assert_balanced("0.65", &part);
}

#[test]
fn skewed_bays_are_corrected_too() {
    let skews = vec![Turn::fraction(1, 12), Turn::zero(), Turn::fraction(-1, 12)];
    let remedy =
        remedy(&read(I3), &Request { factors: vec![fraction(1, 1)], skews, ..request(&[1]) }).expect("a remedy");
    assert!(remedy.crankshaft.is_some());
    assert_balanced("skewed", &remedy);
}

#[test]
fn the_four_needs_one_lanchester_pair_and_nothing_else_up_to_order_2() {
    let remedy = remedy(&engine("I4"), &request(&[1, 2])).expect("a remedy");
    assert!(remedy.crankshaft.is_none());
    assert_eq!(remedy.shafts.len(), 2);
    for (shaft, sense) in remedy.shafts.iter().zip([Sense::Direct, Sense::Reverse]) {
        assert_eq!((shaft.order, shaft.sense, shaft.kind, shaft.lanchester), (2, sense, Kind::Force, true));
        let [weight] = shaft.weights.as_slice() else { panic!("one weight") };
        // |P| = 4 m r c_2, U = |P|/(2·2²), opposite at top dead centre.
        assert_eq!(weight.modulus().map(|form| form.to_string()).as_deref(), Some("1/2"));
        assert_eq!(weight.direction(), Some(Direction::Turn(Turn::fraction(1, 2))));
        assert!(weight.position.is_zero());
    }
}

#[test]
fn a_coefficient_below_zero_turns_the_weight_round() {
    let remedy = remedy(&engine("I4"), &request(&[4])).expect("a remedy");
    assert_eq!(remedy.shafts[0].weights[0].direction(), Some(Direction::Turn(Turn::zero())));
    assert_balanced("I4", &remedy);
}

#[test]
fn a_single_needs_a_counterweight_and_a_shaft_against_the_crank() {
    let single = remedy(&read("inline.throws = [0]"), &request(&[1])).expect("a remedy");
    let own = &single.crankshaft.as_ref().expect("a counterweight").weights;
    assert_eq!((own.len(), own[0].modulus().expect("a form").to_string()), (1, "1/2".to_owned()));
    assert_eq!(single.shafts.len(), 1);
    assert_eq!((single.shafts[0].sense, single.shafts[0].kind), (Sense::Reverse, Kind::Force));
    let twin = remedy(&read("vee = { bank_angle = 90, throws = [0] }"), &request(&[1])).expect("a remedy");
    assert!(twin.shafts.is_empty(), "the 90° twin needs its counterweight alone");
}

#[test]
fn a_three_needs_a_couple_shaft_against_the_crank_at_order_1() {
    let remedy = remedy(&read("inline.throws = [0, 120, 240]"), &request(&[1])).expect("a remedy");
    let [shaft] = remedy.shafts.as_slice() else { panic!("one shaft") };
    assert_eq!((shaft.sense, shaft.kind, shaft.weights.len()), (Sense::Reverse, Kind::Couple, 2));
    assert!(shaft.weights[0].vector.plus(&shaft.weights[1].vector).vanishes(), "opposite weights");
}

#[test]
fn no_set_with_a_shaft_less_balances() {
    for name in ["I4", "I3", "V6-60-shared", "I5-15234"] {
        let whole = remedy(&engine(name), &request(&[1, 2, 4])).expect("a remedy");
        assert!(whole.shafts.len() > 1, "{name}");
        for left_out in &whole.shafts {
            let rest: Vec<_> = whole.weights().into_iter().filter(|w| !left_out.weights.contains(w)).collect();
            assert!(corrected(&whole.subject, &[1, 2, 4], &rest).iter().any(|sum| !sum.vanishes()), "{name}");
        }
    }
}

#[test]
fn a_force_that_acts_in_one_plane_needs_one_weight_there() {
    let at = |throw: &str, position: &str, mass: u32| {
        format!(
            "[[cylinder]]\nthrow = '{throw} turn'\nbank = 0\nposition = '{position}'\nreciprocating_mass = {mass}\n"
        )
    };
    // All in one plane, whatever the angles; like throws in two planes; a force and a moment that no one plane fits.
    let one = at("1/1000003", "7", 1) + &at("5/1000003", "7", 2);
    let like = at("1/8", "0", 1) + &at("1/8", "3", 2) + &at("3/8", "2", 1);
    let both = at("0", "0", 1) + &at("1/4", "3", 2);
    let weights = |text: &str| {
        let found = remedy(&read(text), &request(&[1])).expect("a remedy").crankshaft.expect("counterweights");
        (found.kind, found.weights.iter().map(|weight| weight.position.to_string()).collect::<Vec<_>>())
    };
    assert_eq!(weights(&one), (Kind::Force, vec!["7".to_owned()]));
    assert_eq!(weights(&like), (Kind::Force, vec!["2".to_owned()]));
    assert_eq!(weights(&both), (Kind::ForceAndMoment, vec!["3".to_owned(), "0".to_owned()]));
    // Triangles: 1 + e^{120°} at 1 and e^{60°} at 0 act as e^{60°} does, at a place between.
    let hidden = at("0", "1", 2) + &at("1/3", "1", 2) + &at("1/6", "0", 1);
    assert_eq!(weights(&hidden), (Kind::Force, vec!["2/3".to_owned()]));
    // With e^{240°} at 0 that place is z = 2, beyond the cylinders.
    let beyond = at("0", "1", 2) + &at("1/3", "1", 2) + &at("2/3", "0", 1);
    assert_eq!(weights(&beyond), (Kind::ForceAndMoment, vec!["1".to_owned(), "0".to_owned()]));
}

#[test]
fn planes_that_coincide_are_refused() {
    let refused = remedy(&read(I3), &planes(fraction(1, 10), fraction(2, 20)));
    assert_eq!(refused.err(), Some(RemedyError::PlanesCoincide("100 mm".to_owned())));
    let without_bearings: Vec<&str> = I3.lines().filter(|line| !line.starts_with("bearings")).collect();
    let short = format!("{}\n[crankshaft]\nlength = '0.2 m'", without_bearings.join("\n"));
    let refused = remedy(&read(&short), &planes(fraction(1, 10), fraction(-11, 100))).err();
    assert_eq!(
        refused,
        Some(RemedyError::BeyondTheShaft("-110 mm".to_owned(), Box::new(["-100 mm", "100 mm"].map(str::to_owned))))
    );
    let many = remedy(&read(I3), &Request { factors: vec![fraction(1, 1); 4], ..request(&[1]) });
    assert!(matches!(many.err(), Some(RemedyError::TooMany { given: 4, throws: 3, .. })));
}

/// `|1−2f| + |cos V|`, exactly: P⁺ is 2(1−2f), and P⁻ is `e^{iV} + e^{−iV}`.
#[test]
fn one_pin_of_v_angle_v_peaks_at_1_less_2f_and_cos_v_for_every_angle_and_part() {
    for degrees in (0..360).step_by(5) {
        let twin = Partial::new(&read(&format!("vee = {{ bank_angle = {degrees}, throws = [0] }}"))).expect("centric");
        let angle = Turn::fraction(degrees, 360);
        let unit = |angle: Turn| Term { angle, weight: BigRational::one() };
        let twice_cosine = PhasorSum::new(vec![unit(angle.clone()), unit(-&angle)]);
        assert!(twin.reverse.minus(&twice_cosine).vanishes(), "{degrees}°");
        let direct = PhasorSum::new(vec![Term { angle: Turn::zero(), weight: fraction(2, 1) }]);
        assert!(twin.direct.minus(&direct).vanishes(), "{degrees}°");
        let cosine = (f64::from(degrees as i32).to_radians()).cos().abs();
        for percent in [0, 35, 50, 65, 100] {
            let ellipse = twin.ellipse(&fraction(percent, 100));
            let expected = (1.0 - percent as f64 / 50.0).abs() + cosine;
            assert!((ellipse.peak_decimal - expected).abs() < 1e-14, "{degrees}°, {percent} %");
        }
        assert_eq!(twin.ellipse(&fraction(35, 100)), twin.ellipse(&fraction(65, 100)), "{degrees}°");
        let least = twin.ellipse(&fraction(1, 2));
        assert!(twin.curve(4).iter().all(|(_, ellipse)| ellipse.peak_decimal >= least.peak_decimal));
    }
}

#[test]
fn a_single_peaks_at_the_larger_of_f_and_1_less_f() {
    let single = Partial::new(&read("inline.throws = [0]")).expect("centric");
    for percent in 0..=100 {
        let part = fraction(percent, 100);
        let expected = if percent > 50 { part.clone() } else { BigRational::one() - &part };
        assert_eq!(single.ellipse(&part).peak.and_then(|form| form.as_rational()), Some(expected));
    }
}

#[test]
fn partial_balance_is_told_of_centric_rods_alone_and_masses_that_are_there() {
    let rods = |keys: &str| Partial::new(&read(&format!("inline.throws = [0]\n[mechanism]\nrod_ratio = 0.25\n{keys}")));
    assert!(rods("offset_ratio = 0.01").is_none());
    assert!(rods("").is_some_and(|partial| !partial.direct.vanishes()));
    assert!(rods("reciprocating_mass = 0").is_some_and(|partial| partial.direct.vanishes()));
}

/// The moment on the frame of pistons that push sideways on their cylinders, and of the pair, in multiples of m r² ω²:
/// no term of the program's torque enters.
#[test]
fn a_lanchester_pair_at_its_height_takes_the_roll_moment_of_order_2_away() {
    let layout = read(
        "inline.throws = [0, 180, 180, 0]\n[mechanism]\nrod_ratio = 0.3\ncrank_radius = 0.05\nreciprocating_mass = 1",
    );
    let pair = pair_height(&layout, 2).expect("a height");
    assert_near(pair.metres.expect("a crank radius"), pair.in_crank_radii * 0.05);
    assert!((pair.in_crank_radii - 1.0 / 0.3).abs() < 0.15, "nearly the rod length: {}", pair.in_crank_radii);
    let crank = SliderCrank::new(fraction(3, 10), BigRational::zero()).expect("a crank");
    let balanced = remedy(&layout, &request(&[2])).expect("a remedy");
    let lengths = balanced.shafts.iter().map(|s| s.weights[0].decimals(&balanced.subject).expect("decimals"));
    let [with, against] = lengths.collect::<Vec<_>>()[..] else { panic!("a pair") };
    let roll = |theta: f64, height: f64| {
        let piston = |psi: f64| {
            // On the wall of its cylinder: m s̈ along the axis makes m s̈ tan of the rod's slope across it, at the height s.
            let (s, acceleration) = (1.0 + 1.0 / 0.3 + crank.position(psi), crank.acceleration(psi));
            -acceleration * s * psi.sin() / (s - psi.cos())
        };
        let pistons: f64 = [0.0, 0.5, 0.5, 0.0].iter().map(|throw| piston(theta + throw * TAU)).sum();
        let shaft = |[size, degrees]: [f64; 2], sign: f64, height: f64| {
            4.0 * size * height * (degrees.to_radians() + sign * 2.0 * theta).sin()
        };
        pistons + shaft(with, 1.0, height / 2.0) + shaft(against, -1.0, -height / 2.0)
    };
    let order_2 = |height: f64| {
        let steps = 720;
        let sum: f64 = (0..steps).map(|j| f64::from(j) / 720.0 * TAU).map(|t| roll(t, height) * (2.0 * t).sin()).sum();
        sum * 2.0 / f64::from(steps)
    };
    assert!(order_2(0.0).abs() > 1.9);
    assert!(order_2(pair.in_crank_radii).abs() < 1e-9, "{}", order_2(pair.in_crank_radii));
    let part = 0.4 * pair.in_crank_radii;
    assert_near(order_2(part) / order_2(0.0), 0.6);
}

/// `theory-trade`, section 2: rod ratios, an in-line four of r 50 mm, l 143 mm where nothing else is said.
#[test]
fn heights_of_a_pair_come_out_for_masses_alone() {
    for (ratio, right) in [("0.3", 0.977_580_413), ("0.25", 0.984_411_096)] {
        let text = format!("inline.throws = [0, 180, 180, 0]\nmechanism.rod_ratio = {ratio}\n");
        let pair = pair_height(&read(&text), 2).expect("a height");
        let ratio: f64 = ratio.parse().expect("a ratio");
        assert!((pair.in_crank_radii * ratio - right).abs() < 1e-9, "{} for {right}", pair.in_crank_radii * ratio);
    }
}

const FOUR: &str = "cycle = 'four-stroke'\nspeed = 6000\ninline = { throws = [0, 180, 180, 0], spacing = '94 mm' }\n\
    [mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\n";
const GAS: &str = "[gas]\nbore = '86 mm'\ncrankcase = '1 bar'\nintake_pressure = '0.9 bar'\nexhaust_pressure = '1.1 bar'\n\
    process = 'spark-ignition'\ncompression_ratio = 10\nheat = '1100 J'\n";

/// `theory-trade`, section 2: the in-line four at 6000 rpm, masses alone.
#[test]
fn a_pair_upside_down_doubles_the_roll_and_a_lower_one_leaves_part_of_it() {
    let engine = read(FOUR);
    let roll = PairRoll::new(&engine, 2).expect("a pair");
    let [height, sideways] = roll.place(6000.0);
    assert!((height * 1e3 - 139.779_101_8).abs() < 1e-6 && sideways == 0.0, "{height}");
    for (at, right) in [(0.0, 730.365_558), (height, 0.0), (-height, 1_460.731_117), (0.7 * 0.143, 207.328_914)] {
        let found = roll.peak(6000.0, [at, 0.0]);
        assert!((found - right).abs() < 2e-6, "{found} for {right}");
    }
    let pair = remedy(&engine, &request(&[2])).expect("a remedy");
    let size = pair.shafts[0].weights[0].mass_radius(&pair.subject).expect("kilograms");
    assert!((size - 3.308_859_385e-3).abs() < 1e-12, "{size}");
}

/// `theory-trade`, section 2: full load, heights that cancel at a speed, and the best for several speeds.
#[test]
fn heights_with_gas_come_out_at_a_speed_and_for_several() {
    let roll = PairRoll::new(&read(&format!("{FOUR}{GAS}")), 2).expect("a pair");
    for (speed, right) in [(2000.0, -330.732), (3672.0, 0.199), (4000.0, 22.151), (6000.0, 87.500)] {
        let place = roll.place(speed);
        assert!((place[0] * 1e3 - right).abs() < 6e-4, "{} for {right}", place[0] * 1e3);
        assert!(roll.peak(speed, place) < 1e-9, "{speed}");
    }
    // A full height leaves the gas at every speed: at 1500 rpm more than no height.
    let full = 0.139_779_101_8;
    for speed in [1500.0, 6000.0] {
        assert!((roll.peak(speed, [full, 0.0]) - 273.543).abs() < 1e-3, "{}", roll.peak(speed, [full, 0.0]));
    }
    assert!((roll.peak(1500.0, [0.0; 2]) - 227.970).abs() < 1e-3);
    let best = roll.best_place(&[2000.0, 3000.0, 4000.0, 6000.0]).expect("a place");
    assert!((best[0] * 1e3 - 65.593_058).abs() < 1e-6, "{}", best[0] * 1e3);
    assert_eq!(roll.best_place(&[0.0]), None);
    let squares =
        |place: [f64; 2]| [2e3, 3e3, 4e3, 6e3].map(|speed| roll.peak(speed, place).powi(2)).iter().sum::<f64>();
    for (up, sideways) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
        assert!(squares([best[0] + up, best[1] + sideways]) > squares(best));
    }
}

/// `theory-trade`, section 2: V twins on a common pin, the part of the second-order peak that one shaft cancels.
#[test]
fn one_shaft_cancels_the_longer_vector_and_leaves_the_other() {
    let best = |angle: f64| {
        let text = format!("vee = {{ bank_angle = {angle}, throws = [0] }}\nmechanism.rod_ratio = 0.3\n");
        let subject = ComparableEngine::new(&read(&text)).expect("an engine");
        cures(&subject, &[2]).into_iter().find(|cure| cure.shafts == 1).expect("one shaft")
    };
    // 97 % is cured at two angles beside 60°.
    let cases = [
        (54.0, 85.0651),
        (58.9715, 97.0),
        (61.0179, 97.0),
        (66.0, 84.2796),
        (72.0, 72.3607),
        (90.0, 50.0),
        (120.0, 66.6667),
    ];
    for (angle, right) in cases {
        let cure = best(angle);
        assert!((100.0 * cure.removed - right).abs() < 3e-4, "{angle}: {} for {right}", 100.0 * cure.removed);
        assert_eq!(cure.is_exact, angle == 90.0, "{angle}");
        assert_eq!(cure.senses == [Sense::Reverse], angle == 120.0, "{angle}");
    }
    let sixty = best(60.0);
    assert!(sixty.is_exact && sixty.removed == 1.0 && sixty.peak[1] == 0.0);
    // In line the force swings along a line: half, proved, at every order; both shafts remove all.
    let subject = ComparableEngine::new(&read(FOUR)).expect("an engine");
    let all = cures(&subject, &[2, 4]);
    assert_eq!(all.len(), 4);
    for cure in all {
        assert!(cure.is_exact);
        assert_eq!(cure.removed, f64::from(cure.shafts as u32) / 2.0);
    }
}

/// What a cure leaves is the peak of the engine with its shaft, by the loads of a file that has it.
#[test]
fn the_residual_of_one_shaft_is_that_of_an_engine_that_has_it() {
    let vee = "speed = 3000\nvee = { bank_angle = 72, throws = [0], spacing = '0.1 m' }\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.4 kg'\n";
    let bare = read(vee);
    let subject = ComparableEngine::new(&bare).expect("an engine");
    let cure = cures(&subject, &[2]).into_iter().find(|cure| cure.shafts == 1).expect("one shaft");
    let size = cure.mass_radius * 0.4 * 0.04;
    let peak = |text: &str| crankstar::loads::loads(&read(text), &[2]).expect("loads").orders[0].force.largest();
    let with = |angle: u32| {
        format!("{vee}[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = {size}\nangle = {angle}\nposition = 0\n")
    };
    assert!((peak(vee) - cure.peak[0]).abs() < 1e-9);
    assert!((peak(&with(180)) - cure.peak[1]).abs() < 1e-9, "{} for {}", peak(&with(180)), cure.peak[1]);
    assert!(peak(&with(0)) > cure.peak[0]);
}

fn angle() -> impl Strategy<Value = Turn> {
    (0..72_i64, prop::sample::select(vec![1_i64, 3, 4, 5, 7, 8, 12, 24, 72])).prop_map(|(n, d)| Turn::fraction(n, d))
}

prop_compose! {
    fn cylinder()(throw in angle(), bank in angle(), position in -40..40_i64, mass in 0..5_i64) -> String {
        let (throw, bank) = (throw.turns().clone(), bank.turns().clone());
        format!("[[cylinder]]\nthrow = '{throw} turn'\nbank = '{bank} turn'\nposition = '{position}/4'\nreciprocating_mass = '{mass}/2'\n")
    }
}

/// A file with everything that turns; each line is a place where it may be spoiled.
const FULL: &str = "speed = 6000
effects = ['torque']
[vee]
bank_angle = 90
throws = [0, 270, 90, 180]
spacing = '0.12 m'
bank_offset = '16 mm'
[mechanism]
reciprocating_mass = '0.65 kg'
rotating_mass = '0.3 kg'
crank_radius = '45 mm'
rod_ratio = 0.25
offset_ratio = 0.01
[crankshaft]
pin_mass = 0.1
web_mass = [0.2, 0.3, 0.2, 0.3]
web_radius = '-15 mm'
length = 0.6
[[counterweight]]
throw = 2
angle = 162
mass = 0.4
radius = 0.045
[[counterweight]]
angle = 77
mass = 0.4
radius = 0.045
position = 0.2
[[balancer]]
order = 1
sense = 'against'
mass_radius = '12 kg mm'
angle = 10
position = 0.05
height = -0.02
offset = 0.03
";

fn piece() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![
        "",
        "0",
        "-1",
        "1e99",
        "1e-99",
        "1/3",
        "9999999999999999999999",
        "[1, 2]",
        "[]",
        "'x'",
        "180",
        "0.5",
        "1/7 turn",
        "'1/7'",
    ])
}

/// The file with the values of some keys replaced, and some lines left out.
fn spoiled(changes: &[(usize, Option<&str>)]) -> String {
    let mut lines: Vec<String> = FULL.lines().map(str::to_owned).collect();
    for (at, piece) in changes {
        let at = at % lines.len();
        match (piece, lines[at].split_once('=')) {
            (Some(piece), Some((key, _))) => lines[at] = format!("{key}= {piece}"),
            _ => lines[at].clear(),
        }
    }
    lines.join("\n")
}

/// Everything that is asked of a layout is answered or refused, and what is answered holds.
fn answered(text: &str) -> Result<(), TestCaseError> {
    let Ok(layout) = parse("layout.toml", text) else { return Ok(()) };
    let _ = loads(&layout, &[1, 2]);
    let factors = vec![fraction(1, 2)];
    let Ok(found) = remedy(&layout, &Request { factors, ..request(&[1, 2, 3]) }) else { return Ok(()) };
    prop_assert!(found.holds());
    for document in [report::remedy_answer(&found), report::remedy_page(&found)] {
        let written = page::write(&document, page::Format::Latex, &page::Options::default());
        prop_assert!(!written[0].text.contains("NaN"));
    }
    prop_assert!(!report::remedy_section(&found).is_empty() && !report::remedy_cures(&found).is_empty());
    let json = serde_json::to_string(&report::remedy_document(&found)).expect("JSON");
    let document: RemedyDocument = serde_json::from_str(&json).expect("the document reads");
    prop_assert_eq!(check_remedy_document(&document).map(|_| ()), Ok(()));
    Ok(())
}

#[test]
fn the_full_file_is_answered() {
    assert!(parse("layout.toml", FULL).is_ok_and(|layout| loads(&layout, &[1]).is_ok()));
    answered(FULL).expect("an answer");
    let bare = "inline.throws = [0, 100]";
    answered(bare).expect("an answer");
}

#[test]
fn a_weight_just_past_half_a_turn_has_an_angle_that_the_checker_takes() {
    let nearly = FULL.replacen("angle = 10", "angle = 1e-99", 1);
    answered(&nearly).expect("an answer");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_spoiled_file_is_answered_or_refused(
        changes in prop::collection::vec((0..100_usize, prop::option::weighted(0.8, piece())), 1..4),
    ) {
        answered(&spoiled(&changes))?;
    }

    #[test]
    fn weights_in_two_planes_leave_exactly_nothing_of_any_engine(
        cylinders in prop::collection::vec(cylinder(), 1..7),
        first in -50..50_i64,
        apart in 1..50_i64,
    ) {
        let layout = read(&cylinders.concat());
        let request = Request { orders: vec![1, 2, 4], planes: Some([fraction(first, 7), fraction(first + apart, 7)]), ..Request::default() };
        let remedy = remedy(&layout, &request).expect("a remedy");
        prop_assert!(remedy.holds());
    }

    #[test]
    fn any_bays_are_corrected_to_exactly_nothing_in_the_usual_planes(
        cylinders in prop::collection::vec(cylinder(), 1..7),
        percent in 0..150_i64,
        skew in angle(),
    ) {
        let layout = read(&cylinders.concat());
        let request = Request { orders: vec![1, 2], factors: vec![fraction(percent, 100)], skews: vec![skew], ..Request::default() };
        let remedy = remedy(&layout, &request).expect("a remedy");
        prop_assert!(remedy.holds());
    }
}

/// A mass at 3.5 in is the mass times radius over 0.0889 m, in the table of data, on the page and in the terminal.
#[test]
fn masses_are_told_at_the_radius_that_is_asked_for() {
    let layout = read(I3);
    let radius = crankstar::file::parse_radius("3.5 in").expect("a length");
    let asked = Request { radius: Some(radius), ..request(&[1, 2]) };
    let cured = remedy(&layout, &asked).expect("a remedy");
    for weight in cured.weights() {
        let expected = weight.mass_radius(&cured.subject).expect("masses") / 0.0889;
        assert_near(cured.mass(&weight).expect("a radius"), expected);
    }
    let text =
        page::write(&report::remedy_answer(&cured), page::Format::PLAIN, &page::Options::default()).remove(0).text;
    assert!(text.contains("Mass at") && text.contains("88.9 mm"), "{text}");
    assert_eq!(remedy(&layout, &request(&[1])).expect("a remedy").mass(&cured.weights()[0]), None);
    assert!(crankstar::file::parse_radius("3.5").is_err() && crankstar::file::parse_radius("-1 in").is_err());
    assert_eq!(remedy(&engine("I3"), &asked).expect_err("no masses"), RemedyError::NoMass);
}

/// The best height over four speeds is told in the terminal, where speeds are asked for.
#[test]
fn the_height_of_a_pair_over_several_speeds_is_told_where_it_is_asked_for() {
    let engine = read(&format!("{FOUR}{GAS}"));
    let speeds = [2000, 3000, 4000, 6000].map(|speed| BigRational::from_integer(speed.into())).to_vec();
    let told = |speeds: Vec<BigRational>| {
        let cured = remedy(&engine, &Request { speeds, ..request(&[2]) }).expect("a remedy");
        let text = page::write(&report::remedy_answer(&cured), page::Format::PLAIN, &page::Options::default());
        text[0].text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert!(told(speeds).contains("lies 65.6 mm higher than the other"));
    assert!(!told(Vec::new()).contains("sum of squares"));
}

/// The twin of the walkthrough: half of √2 m r ω² turns against the crank, 0.33 kg at 33 mm and 8000 rpm.
#[test]
fn a_shaft_rolls_the_engine_with_its_force_times_its_distance() {
    let text = include_str!("../../examples/twin.toml");
    let omega = std::f64::consts::TAU * 8000.0 / 60.0;
    let force = std::f64::consts::SQRT_2 / 2.0 * 0.33 * 0.033 * omega * omega;
    let folder = scratch("rolling-shaft");
    let (layout, fixed) = (folder.join("twin.toml"), folder.join("fixed.toml"));
    std::fs::write(&layout, text).expect("a file");
    let out = call(&[
        "remedy".as_ref(),
        layout.as_os_str(),
        "--orders".as_ref(),
        "1".as_ref(),
        "--write".as_ref(),
        fixed.as_os_str(),
    ]);
    let printed = String::from_utf8(out.stdout).expect("a text");
    let told = printed.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains(&format!("shaft 1 with {force:.0} N.")), "{force}: {told}");
    // So it does where loads adds it up, the inertia torque of order 1 aside.
    let roll = |distance: &str| {
        let placed = std::fs::read_to_string(&fixed)
            .expect("it is written")
            .replace("sense = \"against\"", &format!("sense = \"against\"\nheight = \"{distance}\""));
        let engine = read(&placed.replace("cycle = ", "effects = [\"torque\"]\ncycle = "));
        let found = loads(&engine, &[1]).expect("numbers");
        let roll = found.roll.as_ref().expect("a height");
        let first = roll.orders.iter().find(|order| order.order == 1).expect("order 1");
        first.vector.value * found.scale.as_ref().expect("a speed").force() * 0.033
    };
    let grown = (roll("2 m") - roll("1 m")).norm();
    assert!((grown - force).abs() < 1e-6 * force, "{grown} instead of {force}");
}

/// A four whose only remainder of order 1 is the shaft itself.
#[test]
fn a_shaft_of_the_engine_that_is_not_needed_is_taken_away_and_counts_as_none() {
    let four = "speed = 3000\ninline = { throws = [0, 180, 180, 0], spacing = '0.1 m' }\n[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\nreciprocating_mass = '1 kg'\n";
    let shaft = "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '0.001 kg m'\nangle = 0\nposition = '0 m'\n";
    let [bare, with] = [read(four), read(&format!("{four}{shaft}"))].map(|engine| {
        let remedy = remedy(&engine, &request(&[1, 2])).expect("a remedy");
        assert_balanced("the four", &remedy);
        let told = report::remedy_cures(&remedy).iter().map(page::Text::plain).collect::<Vec<_>>().join(" ");
        (engine, remedy, told)
    });
    assert_eq!(bare.1.shafts_built().count(), 2);
    assert_eq!(with.1.shafts_built().count(), 2, "{:?}", with.1.shafts);
    assert!(!bare.2.contains("now nothing") && with.2.contains("now nothing"), "{}", with.2);
    let alone = remedy(&with.0, &request(&[1])).expect("a remedy");
    let told = report::remedy_cures(&alone).iter().map(page::Text::plain).collect::<Vec<_>>().join(" ");
    assert!(alone.shafts_built().next().is_none() && !told.contains("these shafts"), "{told}");
    // What it needs beside a shaft that is to go is said in no such words.
    for (says, of_bare) in [
        ("order 1 needs nothing", Status::True),
        ("order 1 needs one balancer shaft against the crank", Status::False),
        ("order 2 needs a Lanchester pair", Status::True),
    ] {
        let statement = claim::parse_statement(says).expect("a claim");
        assert_eq!(claim::answer(&bare.0, &statement, None).status, of_bare, "{says}");
        let of_with = if says.starts_with("order 1") { Status::NotDecided } else { of_bare };
        assert_eq!(claim::answer(&with.0, &statement, None).status, of_with, "{says}");
    }
}

/// Written into the file, the height and the offsets that are told leave nothing of the roll moment, however the engine is drawn.
#[test]
fn the_place_of_a_pair_is_told_as_the_file_counts_it() {
    let folder = scratch("pair-place");
    let [layout, fixed] =
        ["four.toml", "fixed.toml"].map(|name| folder.join(name).to_str().expect("a path").to_owned());
    for rotation in ["clockwise", "anticlockwise"] {
        let block = "block = { mass = 180, inertia = [13, 11, 6.5], centre = [0, 0, 0] }\n";
        let mounts = "[[mount]]\nplace = [0, '300 mm', 0]\nstiffness = 9e4\n[[mount]]\nplace = [0, '-300 mm', 0]\nstiffness = 9e4\n\
                      [[mount]]\nplace = ['90 mm', 0, '300 mm']\nstiffness = 9e4\n";
        let four = FOUR.replace("speed = 6000", "speed = 3000\nfiring_order = '1-3-4-2'");
        let text = format!("rotation = '{rotation}'\n{block}{four}{GAS}{mounts}");
        std::fs::write(&layout, &text).expect("a file");
        let out = call(&["remedy", &layout, "--format", "text", "--orders", "2", "--write", &fixed]);
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        let told = String::from_utf8(out.stdout).expect("a text").split_whitespace().collect::<Vec<_>>().join(" ");
        let after = |words: &str| {
            let (_, rest) = told.split_once(words).unwrap_or_else(|| panic!("{words} is not in {told}"));
            rest.split(' ').next().expect("a number").replace('−', "-")
        };
        let place = [
            after("moment of its order where the shaft that turns with the crank lies "),
            after("layout file, add up to "),
        ];
        let roll = |axis: String| {
            let text = std::fs::read_to_string(&fixed).expect("it is written");
            let text = text.replace("sense = \"with\"", &format!("sense = \"with\"\n{axis}"));
            let text = text.replace("sense = \"against\"", "sense = \"against\"\nheight = 0");
            let mounted = crankstar::report::MountsStudy::new(&read(&text), &crankstar::report::MountsAsked::default());
            let mounted = mounted.unwrap_or_else(|why| panic!("{why}"));
            let second = mounted.orders.iter().find(|one| one.excitation.order.halves() == 4).expect("order 2");
            second.load[1][2].norm()
        };
        let [level, placed] = [
            roll("height = 0".to_owned()),
            roll(format!("height = \"{} mm\"\noffset = \"{} mm\"", place[0], place[1])),
        ];
        assert!(level > 10.0 && placed < 0.01 * level, "{placed} of {level} with {place:?}, {rotation}");
    }
}

/// One symbol would stand for the coefficients of two rods.
#[test]
fn multiples_of_different_rods_are_those_of_m_r() {
    let layout = "speed = 4321\nvee = { bank_angle = 75.5, throws = [33], bank_offset = '12 mm', spacing = '90 mm' }\n[mechanism]\n\
        stroke = '81.5 mm'\nrod_length = ['140 mm', '151 mm']\nreciprocating_mass = ['0.5 kg', '0.61234 kg']\n";
    let path = scratch("two-rods").join("layout.toml");
    std::fs::write(&path, layout).expect("a file");
    let out = call(&["remedy", path.to_str().expect("a path"), "--format", "text"]);
    let told = String::from_utf8(out.stdout).expect("a text");
    assert!(told.contains("multiples"), "{told}");
    assert!(!told.contains("|c₂|"), "{told}");
}
