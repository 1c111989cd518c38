//! Do engines whose crankshafts turn at different speeds balance as the theory says, and as Newton's law for each body?
//!
//! The bodies are those of [`crate::geared`], whose model knows nothing of orders: each crank turns as fast as its gear says.

use crankstar::engine::{Engine, Mechanism};
use crankstar::file::parse;
use crankstar::loads::{loads_at, needed_orders, vanishes_at_every_order};
use crankstar::numbers::evaluate;
use crankstar::order::{Factor, Masses};
use crankstar::proof::{Document, Quantity, Sense, Shape, check_document, check_remedy_document};
use crankstar::remedy::{Request, corrected_file, remedy};
use crankstar::verdict::{self, NoTheorem, OrderVerdict};
use crankstar::{file, report};
use num_rational::BigRational;

use crate::geared::{any_engine_at, assert_feels_its_bodies, bodies};
use crate::support::dice::Dice;
use crate::support::written::engine as layout;

fn judged(engine: &Engine, orders: &[u32], masses: Masses) -> Vec<OrderVerdict> {
    verdict::classify(engine, orders, masses, &verdict::quantities(engine, true)).expect("orders")
}

fn document(engine: &Engine, orders: &[u32], masses: Masses) -> Document {
    let quantities = verdict::quantities(engine, true);
    report::document(engine, masses, &judged(engine, orders, masses), &quantities, None)
}

/// The sums of the force of an order, direct and reverse: before which number they stand, where that is not c_k of the order, and how
/// long they are.
fn force(order: &OrderVerdict) -> Vec<(Option<Factor>, [f64; 2])> {
    let part = |part: &verdict::OrderBalance| {
        let factor = part.class.as_ref().map(|class| class.factor.clone());
        let lengths = part.force.verdicts().map(|one| if one.vanishes() { 0.0 } else { evaluate(&one.sum).norm() });
        part.exists.then_some((factor, lengths))
    };
    order.parts.iter().filter_map(part).collect()
}

const TWO: &str = "[[crankshaft]]\nname = 'slow'\nsense = 'with'\noffset = 0\n[[crankshaft]]\nname = 'fast'\nsense = 'with'\nspeed = 2\noffset = 4\n";

fn single(crank: &str, throw: u32) -> String {
    format!("[[cylinder]]\ncrankshaft = '{crank}'\nthrow = {throw}\nbank = 0\nposition = 0\n")
}

/// Two singles side by side, one at twice the speed: order k of the fast one is order 2k, four times as large.
#[test]
fn a_single_at_twice_the_speed_adds_four_times_its_order_at_twice_the_order() {
    let engine = layout(&format!("{TWO}{}{}[mechanism]\nrod_ratio = 0.25\n", single("slow", 0), single("fast", 0)));
    let orders = judged(&engine, &[1, 2, 3, 4, 6, 8], Masses::Reciprocating);
    let own = |order: u32| force(orders.iter().find(|one| one.order == order).expect("judged"));
    let Some(rod) = engine.cylinders()[0].mechanism.as_ref().and_then(Mechanism::rod).cloned() else { panic!("a rod") };
    let [slow, fast] = [Factor::Motion(rod.clone()), Factor::Geared(2, Box::new(Factor::Motion(rod)))].map(Some);
    assert_eq!(own(1), [(None, [1.0; 2])]);
    assert_eq!(own(2), [(slow.clone(), [1.0; 2]), (Some(Factor::One), [4.0; 2])]);
    assert_eq!(own(3), []);
    assert_eq!(own(4), [(slow.clone(), [1.0; 2]), (fast.clone(), [4.0; 2])]);
    // Order 3 of its own is none of a centric crank.
    assert_eq!(own(6), [(slow.clone(), [1.0; 2])]);
    assert_eq!(own(8), [(slow, [1.0; 2]), (fast, [4.0; 2])]);
    assert!(!orders[2].exists());
}

/// An even fire of two on a crank at twice the speed has none of the engine's order 2, and all of its order 4.
#[test]
fn throws_opposed_on_a_fast_crank_cancel_its_own_odd_orders() {
    let engine = layout(&format!("{TWO}{}{}", single("fast", 0), single("fast", 180)));
    let orders = judged(&engine, &[1, 2, 4], Masses::Reciprocating);
    assert!(!orders[0].exists() && orders[1].exists());
    assert!(orders[1].force.is_balanced());
    assert_eq!(orders[2].force.shape, Shape::Planar);
    assert_eq!(force(&orders[2]), [(Some(Factor::Geared(2, Box::new(Factor::Open))), [8.0; 2])]);
    assert!(matches!(verdict::every_order(&engine, Masses::Reciprocating), Err(NoTheorem::FasterCrank(2))));
}

/// A single with a pair of crankshafts at ±2 beside it, whose rotating masses are the Lanchester pair that `remedy` proposes for it.
#[test]
fn crankshafts_at_twice_the_speed_are_the_lanchester_pair_of_the_remedy() {
    let mass = "reciprocating_mass = ['1 kg', '0 kg', '0 kg']\n";
    let mechanism = "[mechanism]\nstroke = '80 mm'\nrod_ratio = 0.25\n";
    let plain = layout(&format!("inline.throws = [0]\n{mechanism}reciprocating_mass = '1 kg'\n"));
    let request = Request { orders: vec![2], ..Request::default() };
    let shafts = remedy(&plain, &request).expect("a remedy").shafts;
    assert!(shafts.iter().all(|shaft| shaft.lanchester) && shafts.len() == 2);
    // Before c_2 in the remedy: U = c_2/8 in each sense, which is no rational number; here 8U is written as c_2 in decimals.
    let crank = plain.cylinders()[0].mechanism.as_ref().and_then(crankstar::order::crank).expect("a rod");
    let size = crank.coefficient(2).re.to_float() / 8.0;
    let cranks = "[[crankshaft]]\nname = 'one'\nsense = 'with'\noffset = 0\n[[crankshaft]]\nname = 'plus'\nsense = 'with'\nspeed = 2\noffset = 3\n[[crankshaft]]\nname = 'minus'\nsense = 'against'\nspeed = 2\noffset = -3\n";
    let cylinders = [single("one", 0), single("plus", 180), single("minus", 180)].concat();
    let rotating = format!("rotating_mass = ['0 kg', '{size:.17} kg', '{size:.17} kg']\n");
    let geared = layout(&format!("{cranks}{cylinders}{mechanism}{mass}{rotating}"));
    let loads = loads_at(&geared, &[1, 2, 4], &[]).expect("loads");
    let left: Vec<f64> = loads.orders.iter().map(|order| order.force.largest()).collect();
    assert!((left[0] - 1.0).abs() < 1e-12 && left[1] < 1e-15 && left[2] > 0.001, "{left:?}");
    // The same weights as those of the remedy: opposite to the throw, of that size.
    for weight in shafts.iter().flat_map(|shaft| &shaft.weights) {
        let [own, degrees] =
            weight.decimals(&crankstar::remedy::ComparableEngine::new(&plain).expect("masses")).expect("rods");
        assert!((own - size).abs() < 1e-15 && (degrees.abs() - 180.0).abs() < 1e-9, "{own} {degrees}");
    }
}

/// The remedy of an engine with a fast crank proves what it proposes, and writes it into the file where keys can say it.
#[test]
fn remedies_of_engines_with_fast_cranks_hold() {
    let mut dice = Dice::new(23);
    let mut written = 0;
    for _ in 0..12 {
        let text = any_engine_at(&mut dice, 3);
        let engine = layout(&text);
        let remedy = remedy(&engine, &Request { orders: vec![1, 2, 3], ..Request::default() }).expect("a remedy");
        assert!(remedy.holds(), "{text}");
        check_remedy_document(&report::remedy_document(&remedy)).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        match corrected_file(&remedy, "speeds.toml", file::FileResolver::nothing()) {
            Ok(file) => {
                written += 1;
                let corrected = layout(&file.text);
                let orders = judged(&corrected, &[1, 2, 3], Masses::All);
                for order in orders.iter().filter(|order| order.exists()) {
                    assert!(order.force.is_balanced() && order.moment.is_balanced(), "{}", file.text);
                }
            }
            Err(why) => assert!(why.to_string().contains("faster than the reference"), "{why}\n{text}"),
        }
    }
    assert!(written > 3, "{written}");
}

#[test]
fn random_engines_with_fast_cranks_feel_what_newtons_law_says_of_each_body() {
    let mut dice = Dice::new(19);
    let orders: Vec<u32> = (1..=66).collect();
    let mut faster = 0;
    for _ in 0..16 {
        let text = any_engine_at(&mut dice, 3);
        let engine = layout(&text);
        faster += usize::from(engine.faster_crank().is_some());
        assert_feels_its_bodies(&engine, &orders, &text);
    }
    assert!(faster > 8, "{faster} of 16");
}

/// The orders that an accuracy needs keep the largest force of all orders within its bound, by the bodies.
#[test]
fn the_largest_force_of_all_orders_holds_what_fast_cranks_add() {
    let mut dice = Dice::new(29);
    for _ in 0..10 {
        let text = any_engine_at(&mut dice, 3);
        let engine = layout(&text);
        let needed = needed_orders(&engine, 1e-3).expect("orders");
        let kept = loads_at(&engine, &needed.kept, &needed.torque_kept).expect("loads");
        let most = needed.left.force.map_or(0.0, |bound| bound.most);
        for step in 0..60 {
            let theta = f64::from(step) * 0.104;
            let (force, ..) = bodies(&engine, theta);
            let missed = (kept.force.at(theta) - force).norm();
            assert!(missed <= most + 1e-9 * (1.0 + force.norm()), "{missed} of at most {most} at {theta}\n{text}");
        }
    }
}

/// Proved to vanish at every order where each speed does by itself; where a fast crank leaves something, not.
#[test]
fn a_load_vanishes_at_every_order_only_if_it_does_at_every_speed() {
    let yoke = "[mechanism]\nscotch_yoke = true\n";
    let pair = |crank: &str| [single(crank, 0), single(crank, 180)].concat();
    let rods = "[mechanism]\nrod_ratio = 0.25\n";
    let vanishes = |text: String| vanishes_at_every_order(&layout(&text), Quantity::FORCE);
    assert!(vanishes(format!("{TWO}{}{}{yoke}", pair("slow"), pair("fast"))));
    assert!(!vanishes(format!("{TWO}{}{}{yoke}", pair("slow"), single("fast", 0))));
    assert!(!vanishes(format!("{TWO}{}{}{rods}", pair("slow"), pair("fast"))));
}

#[test]
fn documents_of_random_engines_with_fast_cranks_hold() {
    let mut dice = Dice::new(31);
    for _ in 0..20 {
        let text = any_engine_at(&mut dice, 3);
        let engine = layout(&text);
        for masses in [Masses::Reciprocating, Masses::All] {
            let document = document(&engine, &[1, 2, 3, 4, 6], masses);
            check_document(&document).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        }
    }
}

/// A document that says another speed, or leaves a cylinder out of an order that its speed divides, is refused.
#[test]
fn cheats_with_speeds_are_refused() {
    let rods = "[mechanism]\nrod_ratio = 0.25\n";
    let engine = layout(&format!("{TWO}{}{}{rods}", single("slow", 0), single("fast", 90)));
    let honest = document(&engine, &[1, 2, 3, 4, 6], Masses::Reciprocating);
    check_document(&honest).expect("it holds");
    let speeds: Vec<u32> = honest.cylinders.iter().map(|cylinder| cylinder.speed).collect();
    assert_eq!(speeds, [1, 2]);
    let refuse = |what: &str, change: &dyn Fn(&mut Document)| {
        let mut cheat = honest.clone();
        change(&mut cheat);
        assert!(check_document(&cheat).is_err(), "{what}");
    };
    for speed in [0, 1, 3, 4, u32::MAX] {
        refuse("another speed", &move |document| document.cylinders[1].speed = speed);
    }
    refuse("the other cylinder is fast", &|document| document.cylinders[0].speed = 2);
    // As if 3 divided the order and 2 did not: the fast cylinder is told to have no part in order 4.
    refuse("an order without the fast cylinder", &|document| {
        document.verdicts.retain(|verdict| verdict.order != 4 || verdict.of != ["2"]);
    });
    refuse("a zero of an order that it has part in", &|document| {
        let index = document.verdicts.iter().position(|verdict| verdict.order == 2).expect("one");
        document.verdicts[index].terms.clear();
        document.verdicts[index].vanishes = true;
    });
    refuse("a whole that is zero", &|document| {
        let whole = document.wholes.iter_mut().find(|whole| whole.order == 4 && whole.quantity == Quantity::FORCE);
        whole.expect("one").outcome = crankstar::proof::WholeOutcome::Zero;
    });
    refuse("a factor of the square less", &|document| {
        let of_fast = |verdict: &&mut crankstar::proof::VerdictClaim| verdict.order == 2 && verdict.of == ["2"];
        let verdict = document.verdicts.iter_mut().find(of_fast).expect("one");
        verdict.terms[0].weight /= BigRational::from_integer(4.into());
        verdict.modulus /= 4.0;
    });
    // The speed stands in the document, and is left out where it is 1.
    let json = serde_json::to_string(&honest).expect("data");
    assert_eq!(json.matches("\"speed\"").count(), 1);
}

#[test]
fn a_speed_of_one_is_written_or_left_out_with_the_same_documents_and_pages() {
    let mut dice = Dice::new(37);
    for _ in 0..10 {
        // Crank 0 has its speed of 1 written in any case; the others here, too.
        let text = any_engine_at(&mut dice, 1);
        let written = text.replace("name = 'c1'\n", "name = 'c1'\nspeed = 1\n");
        assert_ne!(text, written);
        let [one, other] = [&text, &written].map(|text| {
            let engine = layout(text);
            let document = document(&engine, &[1, 2, 3, 4], Masses::All);
            serde_json::to_string(&document).expect("data")
        });
        assert_eq!(one, other);
    }
}

/// Clockwise, as drawn, or mirrored: lengths and shapes are the same.
#[test]
fn drawn_clockwise_an_engine_with_fast_cranks_leaves_mirror_images() {
    let mut dice = Dice::new(41);
    for _ in 0..10 {
        let text = any_engine_at(&mut dice, 3);
        let [one, other] = [&text, &format!("rotation = 'clockwise'\n{text}")]
            .map(|text| judged(&layout(text), &[1, 2, 3, 4], Masses::Reciprocating));
        for (one, other) in one.iter().zip(&other) {
            assert_eq!(one.force.shape, other.force.shape, "{text}");
            assert_eq!(one.moment.shape, other.moment.shape, "{text}");
        }
    }
}

#[test]
fn mistakes_about_speeds_get_a_message_at_their_place() {
    let cylinders = [single("slow", 0), single("fast", 0)].concat();
    for (text, words) in [
        (format!("{}{cylinders}", TWO.replace("speed = 2", "speed = 1.5")), "take the slowest crankshaft as the first"),
        (
            format!("{}{cylinders}", TWO.replace("speed = 2", "speed = '1/2'")),
            "take the slowest crankshaft as the first",
        ),
        (format!("{}{cylinders}", TWO.replace("speed = 2", "speed = 0")), "a whole number from 1"),
        (format!("{}{cylinders}", TWO.replace("speed = 2", "speed = -2")), "a whole number from 1"),
        (format!("{}{cylinders}", TWO.replace("speed = 2", "speed = 1001")), "a whole number from 1"),
        (
            format!("{}{cylinders}", TWO.replace("name = 'slow'", "name = 'slow'\nspeed = 2")),
            "take the slowest as the first",
        ),
        (format!("cycle = 'four-stroke'\nfiring_order = '1-2'\n{TWO}{cylinders}"), "when cylinders fire"),
        (format!("cycle = 'two-stroke'\nfiring_angles = [0, 0]\n{TWO}{cylinders}"), "when cylinders fire"),
        (format!("{TWO}{}", cylinders.replace("bank = 0", "bank = 'phi'")), "whose angles or positions are open"),
        (
            format!("{TWO}{cylinders}[values]\nphi = 30\n").replace("bank = 0", "bank = 'phi'"),
            "whose angles or positions are open",
        ),
        (
            format!(
                "{TWO}{cylinders}[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '1 m r'\nangle = 0\nposition = 0\ncoefficient_of = 2\n"
            ),
            "a cylinder on the faster one",
        ),
    ] {
        let error = parse("speeds.toml", &text).expect_err(&text).to_string();
        assert!(error.contains(words), "{text}\n{error}");
    }
    // A cycle by itself says nothing that is not known.
    assert!(layout(&format!("cycle = 'two-stroke'\n{TWO}{cylinders}")).firing().is_none());
    assert!(layout(&format!("{TWO}{cylinders}")).cylinders().iter().all(|one| one.crank < 2));
    let direct = layout(&format!("{TWO}{cylinders}")).geared_cranks().iter().all(|crank| crank.sense == Sense::Direct);
    assert!(direct);
}
