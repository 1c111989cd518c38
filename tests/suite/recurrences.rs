//! Is what is said class by class of every order true: with pin offsets, rods that differ, unequal masses, and long patterns?

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::order;
use crankstar::proof::{
    Certificate, Document, Fault, OrderClaim, Planar, Quantity, Sense, SumVerdict, WholeOutcome, Zeros, check_document,
};
use crankstar::verdict::{self, AtOrder, EveryOrderTheorem, FirstLeft, NoTheorem, Recurrence, Recurrences, Stars};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::second;
use crate::support::verdicts::{self, judged, theorem};

fn written(form: &str) -> Engine {
    file::parse("layout.toml", form).unwrap_or_else(|error| panic!("{error}\n{form}"))
}

fn stated(engine: &Engine) -> Recurrences {
    match theorem(engine).expect("a statement") {
        EveryOrderTheorem::Recurrences(all) => all,
        EveryOrderTheorem::Period(_) => panic!("one short period says it"),
    }
}

fn both(all: &Recurrences) -> [(Quantity, &[Recurrence; 2]); 2] {
    [(Quantity::FORCE, &all.force), (Quantity::MOMENT, &all.moment)]
}

/// Compares the statement at these orders with plain verdicts; how many are zero, left, and several classes left.
fn agrees(text: &str, engine: &Engine, all: &Recurrences, orders: impl Iterator<Item = u32>) -> [usize; 3] {
    let mut counts = [0; 3];
    let orders: Vec<u32> = orders.collect();
    for order in judged(engine, &orders, false) {
        for (quantity, both) in both(all) {
            for (place, one) in both.iter().enumerate() {
                let left = order.parts.iter().filter(|part| part.exists).filter(|part| {
                    let balance = if quantity == Quantity::FORCE { &part.force } else { &part.moment };
                    !balance.verdicts()[place].vanishes()
                });
                let (right, count) = match left.count() {
                    0 => (AtOrder::Zero, 0),
                    1 => (AtOrder::Left, 1),
                    _ => (AtOrder::SeveralLeft, 2),
                };
                assert_eq!(one.at(order.order), right, "{} {} {place}\n{text}", quantity.name(), order.order);
                counts[count] += 1;
            }
        }
    }
    counts
}

fn verified(engine: &Engine) -> Document {
    let every = theorem(engine).expect("a statement");
    let document = verdicts::document(engine, &judged(engine, &[1, 2, 3], false), false, Some(&every));
    let json = serde_json::to_string(&document).expect("JSON");
    let read: Document = serde_json::from_str(&json).expect("a document");
    assert_eq!(read, document);
    assert_eq!(check_document(&read).unwrap_or_else(|fault| panic!("{fault}")).theorems, 4);
    second::accepts(&[&document], &[]);
    document
}

fn list(count: u64, mut one: impl FnMut() -> String) -> String {
    (0..count).map(|_| one()).collect::<Vec<_>>().join(", ")
}

/// Offsets to either side, one |δ| or two, odd angles, masses of several weights.
fn random(dice: &mut Dice) -> String {
    let angle = |dice: &mut Dice| match dice.below(4) {
        0 => format!("'{}/7 turn'", dice.below(7)),
        1 => format!("'{}.5'", dice.below(360)),
        _ => format!("{}", dice.below(24) * 15),
    };
    let count = 1 + dice.below(4);
    let even = |count: u64| (0..count).map(|at| format!("'{at}/{count} turn'")).collect::<Vec<_>>().join(", ");
    let throws = if dice.below(2) == 0 { even(count) } else { list(count, || angle(dice)) };
    let (form, cylinders) = match dice.below(3) {
        0 => (format!("inline.throws = [{throws}]"), count),
        1 => (format!("vee = {{ bank_angle = {}, throws = [{throws}] }}", 15 * (1 + dice.below(11))), 2 * count),
        _ => (format!("fan = {{ banks = [-60, 0, 60], throws = [{throws}] }}"), 3 * count),
    };
    let offset = match dice.below(4) {
        0 => "0.1".to_owned(),
        1 => format!("[{}]", list(cylinders, || ["0.1", "-0.1"][dice.below(2) as usize].to_owned())),
        2 => format!("[{}]", list(cylinders, || ["0.1", "-0.1", "0", "0.05"][dice.below(4) as usize].to_owned())),
        _ => "'-0.1'".to_owned(),
    };
    let mass = match dice.below(2) {
        0 => "1".to_owned(),
        _ => format!("[{}]", list(cylinders, || format!("'{}/3'", 1 + dice.below(3)))),
    };
    format!(
        "title = 'random'\n{form}\n[mechanism]\nrod_ratio = 0.3\noffset_ratio = {offset}\nreciprocating_mass = {mass}\n"
    )
}

#[test]
fn offsets_odd_angles_and_unequal_masses_agree_with_plain_verdicts_order_by_order() {
    let (mut dice, mut counts, mut stated) = (Dice::new(16), [0; 3], 0);
    for _ in 0..30 {
        let text = random(&mut dice);
        let engine = written(&text);
        let all = match theorem(&engine) {
            Ok(EveryOrderTheorem::Recurrences(all)) => all,
            // Beyond the budget, and said to be.
            Err(NoTheorem::TooManyCandidates(_)) => continue,
            other => panic!("{other:?}\n{text}"),
        };
        stated += 1;
        let found = agrees(&text, &engine, &all, 2..=40);
        counts.iter_mut().zip(found).for_each(|(count, found)| *count += found);
        verified(&engine);
    }
    assert!(stated > 20 && counts.iter().all(|count| *count > 100), "{stated} {counts:?}");
}

/// The coefficients of the motion of all pistons at orders k and −k, by the mean over a turn.
fn fourier(engine: &Engine, order: u32) -> [f64; 2] {
    const POINTS: u32 = 512;
    let float = |number: &BigRational| number.to_f64().expect("a float");
    let mut sums = [Complex::new(0.0, 0.0); 2];
    for point in 0..POINTS {
        let theta = TAU * f64::from(point) / f64::from(POINTS);
        let mut whole = Complex::new(0.0, 0.0);
        for cylinder in engine.cylinders() {
            let rod = cylinder.rod().expect("a rod");
            let (ratio, offset) = (float(&rod.ratio), float(&rod.offset));
            let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|turn| float(turn.turns()) * TAU);
            let psi = theta + throw - bank;
            let position = psi.cos() + (1.0 - (ratio * psi.sin() - offset).powi(2)).sqrt() / ratio;
            whole += Complex::from_polar(float(&cylinder.reciprocating_mass) * position, bank);
        }
        for (sum, sign) in sums.iter_mut().zip([-1.0, 1.0]) {
            *sum += whole * Complex::from_polar(1.0 / f64::from(POINTS), sign * f64::from(order) * theta);
        }
    }
    sums.map(|sum| sum.norm())
}

#[test]
fn the_motion_itself_has_the_orders_that_are_left_and_no_others() {
    let mut dice = Dice::new(61);
    let mut counts = [0; 2];
    for _ in 0..30 {
        let text = random(&mut dice);
        let engine = written(&text);
        let Ok(EveryOrderTheorem::Recurrences(all)) = theorem(&engine) else { continue };
        for order in 2..=7 {
            for (one, length) in all.force.iter().zip(fourier(&engine, order)) {
                match one.at(order) {
                    AtOrder::Zero => assert!(length < 1e-13, "order {order}: {length}\n{text}"),
                    AtOrder::Left => assert!(length > 1e-9, "order {order}: {length}\n{text}"),
                    AtOrder::SeveralLeft => continue,
                }
                counts[usize::from(one.at(order) == AtOrder::Zero)] += 1;
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 50), "{counts:?}");
}

#[test]
fn a_v_whose_angles_have_no_common_divisor_is_judged_by_its_bank_and_its_banks() {
    let engine = written(
        "title = 'V14'\n[vee]\nbank_angle = 77\nthrows = ['0 turn', '1/7 turn', '2/7 turn', '3/7 turn', '4/7 turn', '5/7 turn', '6/7 turn']\n",
    );
    let all = stated(&engine);
    let [direct, _] = &all.force;
    let [class] = direct.even.as_slice() else { panic!("one class") };
    let Stars::Banks { bank, banks } = &class.stars else { panic!("the banks are alike") };
    assert_eq!((&bank.claim.period, &banks.claim.period), (&14.into(), &360.into()));
    assert_eq!(bank.claim.zeros, Zeros { modulus: 14, residues: vec![2, 4, 6, 8, 10, 12] });
    let counts = agrees("V14", &engine, &all, (2..=300).step_by(2));
    assert!(counts[0] > 200 && counts[1] > 50 && counts[2] == 0, "{counts:?}");
    verified(&engine);
    assert_eq!(theorem(&engine).expect("a statement").first_left(&engine, Planar::Moment).to_owned(), {
        let order = judged(&engine, &[1], false).remove(0);
        FirstLeft::Order(1, order.moment.shape)
    });
}

#[test]
fn a_long_pattern_is_judged_where_it_may_be_zero_and_left_elsewhere() {
    // 5,005 steps of a turn, and 997 with two pairs.
    for throws in ["'1/5 turn', '2/7 turn', '3/11 turn', '5/13 turn'", "0, '1/997 turn', '1/2 turn', '999/1994 turn'"] {
        for mechanism in ["", "[mechanism]\nrod_ratio = 0.25\noffset_ratio = [0.1, '-0.1', 0.1, '-0.1']\n"] {
            let text = format!("title = 'long'\ninline.throws = [{throws}]\n{mechanism}");
            let engine = written(&text);
            let all = match theorem(&engine) {
                Ok(EveryOrderTheorem::Recurrences(all)) => all,
                other => panic!("{other:?}"),
            };
            let sieved = all.force[0].even.iter().flat_map(|class| class.stars.factors()).all(|of| of.sieved.is_some());
            assert!(sieved, "{text}");
            agrees(&text, &engine, &all, (2..=40).chain((41..=1000).step_by(17)));
            verified(&engine);
        }
    }
}

#[test]
fn zeros_of_long_patterns_are_those_of_every_residue() {
    let mut dice = Dice::new(5);
    let (mut zeros, mut long) = (0, 0);
    for _ in 0..12 {
        // Two triangles, moved against each other by a prime part of a turn.
        let (prime, count) = ([131_u64, 211, 331][dice.below(3) as usize], 3);
        let shift = 1 + dice.below(prime - 1);
        let first = (0..count).map(|at| format!("'{at}/{count} turn'"));
        let second = (0..count).map(|at| format!("'{}/{} turn'", at * prime + shift * count, count * prime));
        let throws: Vec<String> = first.chain(second).collect();
        let text = format!("title = 'long'\ninline.throws = [{}]\n", throws.join(", "));
        let engine = written(&text);
        let Ok(EveryOrderTheorem::Recurrences(all)) = theorem(&engine) else { continue };
        long += 1;
        for order in (2..=1000).step_by(2) {
            let is_zero = order::star(&engine, Quantity::FORCE, order, Some(Sense::Direct)).vanishes();
            assert_eq!(all.force[0].at(order) == AtOrder::Zero, is_zero, "{order}\n{text}");
            zeros += usize::from(is_zero);
        }
    }
    assert!(zeros > 100 && long > 5, "{zeros} {long}");
}

#[test]
fn too_many_orders_that_may_be_zero_are_said_to_be_too_many() {
    let engine = written("title = 'pairs'\ninline.throws = [0, 180, '1/5001 turn', '5003/10002 turn']\n");
    assert_eq!(theorem(&engine).expect_err("too many"), NoTheorem::TooManyCandidates(10_002));
    let text = pages::text(&pages::document(&engine), pages::DOLLARS);
    let line = "the pattern repeats only after 10002 orders, of which more than 1000 may be zero, too many to decide.";
    assert!(text.contains(line), "{text}");
}

/// Two pistons 180° apart whose axes pass the shaft on opposite sides.
const OPPOSITE: &str =
    "title = 'two'\ninline.throws = [0, 180]\n[mechanism]\nrod_ratio = 0.25\noffset_ratio = [0.1, '-0.1']\n";

#[test]
fn an_offset_to_the_other_side_turns_the_odd_orders_round() {
    let text = |layout: &str| pages::text(&pages::document(&written(layout)), pages::DOLLARS);
    let same = text(&OPPOSITE.replace("[0.1, '-0.1']", "0.1"));
    let line = "- **Force.** Order 1 vanishes. Even orders: none vanishes, in both vectors. Odd orders from 3 on: all vanish, in both vectors.";
    assert!(same.contains(line), "{same}");
    let opposite = text(OPPOSITE);
    let line = "Even orders: none vanishes, in both vectors. Odd orders from 3 on: none vanishes, in both vectors.";
    assert!(opposite.contains("- **Force.** Order 1 remains, ") && opposite.contains(line), "{opposite}");
    assert!(same.contains("The next order with a force or moment is"), "{same}");
}

#[test]
fn classes_of_rods_are_told_apart_and_both_left_is_no_verdict() {
    let two = "title = 'two rods'\ninline.throws = [0, 180, 0, 180]\n[mechanism]\nrod_ratio = [0.25, 0.25, 0.3, 0.3]\n";
    let engine = written(two);
    let all = stated(&engine);
    assert_eq!(all.force[0].even.len(), 2);
    assert_eq!(all.force[0].at(2), AtOrder::SeveralLeft);
    assert!(all.force[0].odd.is_empty() && all.first.force.is_balanced());
    let cells = theorem(&engine).expect("a statement");
    // Order 2 by itself is decided: both numbers have one sign.
    let order = judged(&engine, &[2], false).remove(0);
    assert_eq!(cells.first_left(&engine, Planar::Force), FirstLeft::Order(2, order.force.shape));
    verified(&engine);
}

const PLACE: &str = "recurrences[0] (force, direct)";

/// Where a changed document on these pistons fails, and why.
fn fault(change: impl FnOnce(&mut Document)) -> String {
    let mut document = verified(&written(OPPOSITE));
    change(&mut document);
    let Fault { place, reason } = check_document(&document).expect_err("a cheat");
    second::refuses(&[(place.as_str(), &document)]);
    assert!(place.starts_with("recurrences"), "{place}: {reason}");
    format!("{place}: {reason}")
}

#[test]
fn a_statement_left_out_twice_or_beside_a_theorem_is_refused() {
    let left_out = fault(|document| drop(document.recurrences.pop()));
    assert_eq!(left_out, "recurrences[3] (moment, reverse): this recurrence is missing");
    let twice = fault(|document| document.recurrences[1] = document.recurrences[0].clone());
    assert_eq!(twice, "recurrences[1] (force, reverse): another recurrence stands here");
    let not_asked = fault(|document| document.all_orders = false);
    assert_eq!(not_asked, "recurrences: there are more than were asked for");
    let twin = written("title = 'twin'\nvee = { bank_angle = 60, throws = [0] }\n");
    let mut both = verified(&twin);
    both.recurrences = verified(&written(OPPOSITE)).recurrences;
    assert_eq!(check_document(&both).expect_err("a cheat").place, "theorems");
    second::refuses(&[("beside a theorem", &both)]);
}

#[test]
fn order_1_with_another_outcome_or_a_sum_less_is_refused() {
    let zero = fault(|document| document.recurrences[0].first.outcome = Some(WholeOutcome::Zero));
    assert!(zero.starts_with(&format!("{PLACE}: order 1: ")), "{zero}");
    let none = fault(|document| document.recurrences[0].first.outcome = None);
    assert_eq!(none, format!("{PLACE}: order 1: `outcome` is missing: there are several sums"));
    let less = fault(|document| drop(document.recurrences[0].first.sums.pop()));
    assert_eq!(less, format!("{PLACE}: order 1: 1 sums here, the engine has 2"));
    let polygons = Certificate::Polygons { polygons: Vec::new() };
    let forged = SumVerdict { vanishes: true, certificate: polygons };
    let forged = fault(|document| document.recurrences[0].first.sums[0] = forged);
    assert!(forged.starts_with(&format!("{PLACE}: order 1: at angle ")), "{forged}");
}

#[test]
fn a_class_less_or_of_other_cylinders_or_factors_is_refused() {
    let less = fault(|document| document.recurrences[0].odd.clear());
    assert_eq!(less, format!("{PLACE}: odd orders: 0 classes here, the engine has 1"));
    let even = format!("{PLACE}: even orders, class 0");
    let other = fault(|document| drop(document.recurrences[0].even[0].of.pop()));
    assert_eq!(other, format!("{even}: its cylinders are [\"1\", \"2\"]"));
    let none = fault(|document| document.recurrences[0].even[0].factors.clear());
    assert_eq!(none, format!("{even}: a class has one factor at least"));
    // The signs of odd orders are others than those of even ones.
    let odd = fault(|document| {
        let factors = document.recurrences[0].odd[0].factors.clone();
        document.recurrences[0].even[0].factors = factors;
    });
    assert_eq!(odd, format!("{even}: the factors multiplied out are not the terms of the class"));
    let heavier = fault(|document| {
        let weight = &mut document.recurrences[0].even[0].factors[0].terms[0].weight;
        *weight = &*weight * BigRational::from_integer(2.into());
    });
    assert_eq!(heavier, odd);
}

#[test]
fn a_period_an_order_or_zeros_that_are_not_so_are_refused() {
    let factor = format!("{PLACE}: even orders, class 0: factor 0");
    let change = |change: &dyn Fn(&mut crankstar::proof::FactorClaim)| {
        fault(|document| change(&mut document.recurrences[0].even[0].factors[0]))
    };
    for wrong in [0, -2, 3] {
        let said = change(&|factor| factor.period = wrong.into());
        assert_eq!(said, format!("{factor}: the period {wrong} is not a positive even number"));
    }
    let left_out = change(&|factor| drop(factor.judged.pop()));
    assert_eq!(left_out, format!("{factor}: order 2 is missing"));
    let other = change(&|factor| factor.judged[0].order = 4);
    assert_eq!(other, format!("{factor}: order 4 is in the place of order 2"));
    let flipped = change(&|factor| factor.judged[0].vanishes = true);
    assert!(flipped.starts_with(&format!("{factor}: order 2: ")), "{flipped}");
    let zeros = |modulus: u32, residues: &[u32]| {
        change(&|factor| factor.zeros = Zeros { modulus, residues: residues.to_vec() })
    };
    assert_eq!(zeros(2, &[0]), format!("{factor}: order 2: the statement contradicts the verdict"));
    assert_eq!(zeros(2, &[1]), format!("{factor}: the residues are not rising even numbers below 2"));
    assert_eq!(zeros(4, &[]), format!("{factor}: the modulus 4 is not an even divisor of the period 2"));
    assert_eq!(zeros(0, &[]), format!("{factor}: the modulus 0 is not an even divisor of the period 2"));
}

#[test]
fn an_order_that_may_be_zero_cannot_be_left_out_of_a_long_pattern() {
    // Two vectors 1/1532 of a turn apart are opposite at order 766 for the first time, and so are the other two.
    let text = "title = 'long'\ninline.throws = [0, '1/1532 turn', '1/5 turn', '1537/7660 turn']\n";
    let genuine = verified(&written(text));
    let factor = |document: &mut Document| document.recurrences[0].even[0].factors[0].clone();
    let found = factor(&mut genuine.clone());
    assert_eq!((found.period.to_u32(), &found.zeros), (Some(7660), &Zeros { modulus: 1532, residues: vec![766] }));
    assert!(found.judged.len() < 1000, "{}", found.judged.len());
    let refused = |change: &dyn Fn(&mut crankstar::proof::FactorClaim)| {
        let mut document = genuine.clone();
        change(&mut document.recurrences[0].even[0].factors[0]);
        let reason = check_document(&document).expect_err("a cheat").reason.to_string();
        second::refuses(&[(reason.as_str(), &document)]);
        reason
    };
    let left_out = refused(&|factor| factor.judged.retain(|verdict| verdict.order != 766));
    assert!(left_out.contains("in the place of order 766"), "{left_out}");
    // An order that cannot be zero does not belong there.
    let added = refused(&|factor| {
        let more = OrderClaim { order: 4, ..factor.judged[0].clone() };
        factor.judged.insert(0, more);
    });
    assert!(added.contains("order 4 is in the place of order 10"), "{added}");
    let more = refused(&|factor| {
        factor.zeros = Zeros { modulus: 7660, residues: vec![2, 766, 2298, 3830, 5362, 6894] };
    });
    assert!(more.contains("the statement has zeros among the residual orders"), "{more}");
    let long = refused(&|factor| factor.period = 7_660_000.into());
    assert!(long.contains("a period of 7660000 orders is too long, at most 1000000"), "{long}");
}

#[test]
fn rods_that_are_links_and_shafts_have_no_statement_class_by_class() {
    let single = "title = 'single'\ninline.throws = [0]\n[mechanism]\nrod_ratio = 0.25\noffset_ratio = 0.1\nreciprocating_mass = 1\n";
    let engine = written(&format!(
        "{single}[[balancer]]\norder = 2\nsense = 'with'\nposition = 0\nangle = 0\nmass_radius = '1/10'\n"
    ));
    assert_eq!(verdict::every_order(&engine, order::Masses::All).err(), Some(NoTheorem::Shaft(2)));
    assert!(verdict::every_order(&engine, order::Masses::Reciprocating).is_ok());
}
