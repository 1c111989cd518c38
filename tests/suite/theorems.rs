//! Is what is said about every order true, the shortest way to say it, and proved by its document?

use std::collections::BTreeSet;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::order;
use crankstar::page::Format;
use crankstar::proof::{
    Certificate, Document, Fault, Quantity, RodClaim, RodStatement, Sense, Survivors, check_document,
};
use crankstar::verdict::{self, EveryOrder, EveryOrderTheorem, LONGEST_PERIOD, NoTheorem, Theorem};
use num_rational::BigRational;

use crate::support::pages;
use crate::support::verdicts::{self, judged, theorem};

fn named(name: &str) -> Engine {
    file::find(name).expect("a name of the catalogue").engine().expect("it reads")
}

/// The engines of the catalogue whose rods stand on the crankpins: of others no order is one sum.
fn concentric() -> impl Iterator<Item = Engine> {
    let all = file::catalogue().expect("it reads").into_iter();
    all.map(|(_, engine)| engine).filter(|engine| !engine.has_links())
}

fn written(form: &str) -> Engine {
    file::parse("layout.toml", &format!("title = 'engine'\n{form}")).expect("it reads")
}

fn proved(layout: &Engine) -> Theorem {
    match theorem(layout).expect("a short period") {
        EveryOrderTheorem::Period(theorem) => theorem,
        EveryOrderTheorem::Recurrences(_) => panic!("the rods are equal and centric"),
    }
}

fn survivors(order_one: bool, modulus: u32, residues: &[u32]) -> Survivors {
    Survivors { order_one, modulus, residues: residues.to_vec() }
}

fn senses(every: &EveryOrder) -> [Survivors; 2] {
    [&every.direct, &every.reverse].map(|verdicts| verdict::survivors(verdicts))
}

fn text(layout: &Engine, format: Format) -> String {
    pages::text(&pages::document(layout), format)
}

/// Each of these lines stands in the report.
fn says(layout: &Engine, lines: &[&str]) {
    let text = text(layout, pages::DOLLARS);
    for line in lines {
        assert!(text.lines().any(|found| found.contains(line)), "{}: no line {line}", layout.title().written());
    }
}

/// No order is left.
const NO_ORDER: Survivors = Survivors { order_one: false, modulus: 2, residues: Vec::new() };

#[test]
fn the_in_line_six_keeps_the_orders_that_six_divides() {
    let six = named("I6");
    let theorem = proved(&six);
    assert_eq!(senses(&theorem.force), [survivors(false, 6, &[0]), survivors(false, 6, &[0])]);
    assert_eq!((theorem.force.survivors(), theorem.moment.survivors()), (survivors(false, 6, &[0]), NO_ORDER));
    says(
        &six,
        &[
            "The next order with a force or moment is 12.",
            "- **Force.** Zero exactly at the orders $k$ that 6 does not divide ($6 \\nmid k$). This holds for both the direct and the reverse vector.",
            "- **Moment.** Zero at every order.",
            "| 2, 8, … | **0** | **0** | **0** | **0** |",
            "| 6, 12, … | not 0 | not 0 | **0** | **0** |",
        ],
    );
}

#[test]
fn the_radial_nine_keeps_order_1_and_two_classes() {
    let nine = named("radial-9");
    let theorem = proved(&nine);
    assert_eq!(senses(&theorem.force), [survivors(true, 18, &[10]), survivors(false, 18, &[8])]);
    assert_eq!(theorem.force.survivors(), survivors(true, 18, &[8, 10]));
    says(
        &nine,
        &[
            "The next order with a force or moment is 26.",
            "- **Force.** Nothing remains but order 1 (direct), orders 8, 26, … = $18j - 10$ (reverse) and orders 10, \
             28, … = $18j - 8$ (direct).",
        ],
    );
}

#[test]
fn the_flat_twelve_on_shared_pins_keeps_nothing() {
    let twelve = written("[flat]\nthrows = [0, 240, 120, 120, 240, 0]");
    let theorem = proved(&twelve);
    assert_eq!((theorem.force.survivors(), theorem.moment.survivors()), (NO_ORDER, NO_ORDER));
    assert!(theorem.force.first.is_none() && theorem.moment.first.is_none());
    says(&twelve, &["No other order remains."]);
    let offset = proved(&written("[flat]\nthrows = [0, 240, 120, 120, 240, 0]\nbank_offset = 0.2"));
    assert_eq!((offset.force.survivors(), offset.moment.survivors()), (NO_ORDER, survivors(false, 6, &[0])));
}

#[test]
fn each_kind_of_statement_has_its_sentence() {
    let alike = "This holds for both the direct and the reverse vector.";
    for (name, line) in [
        ("I1", format!("- **Force.** Zero at no order. {alike}")),
        ("I4", format!("- **Force.** Zero at order 1 and at no other. {alike}")),
        (
            "I2-270",
            format!(
                "- **Force.** Zero exactly at the orders $k$ other than 1 that 4 does not divide ($4 \\nmid k$). {alike}"
            ),
        ),
        ("I2-270", format!("- **Moment.** Zero exactly at the orders $k$ that 4 divides ($4 \\mid k$). {alike}")),
        (
            "I6-two-stroke",
            format!(
                "- **Moment.** Zero exactly at order 1 and at the orders $k$ that 6 divides ($6 \\mid k$). {alike}"
            ),
        ),
        ("I2-180", "- **Moment.** Nothing remains but order 1.".to_owned()),
        ("V8-crossplane", "- **Moment.** Nothing remains but order 1 (direct).".to_owned()),
        (
            "V2-60",
            "- **Force.** Zero at no order. The direct vector: Zero at orders 4, 10, … = $6j - 2$ and at no \
             other. The reverse vector: Zero at orders 2, 8, … = $6j - 4$ and at no other."
                .to_owned(),
        ),
    ] {
        says(&named(name), &[&line]);
    }
}

/// Three pins in steps of 40°, and the three again 45° further: the sum is zero where 40°k is a third of a turn, or 45°k half a turn.
#[test]
fn many_classes_are_listed_by_their_residues() {
    let engine = written("[inline]\nthrows = [0, 40, 80, 45, 85, 125]");
    let theorem = proved(&engine);
    agrees(&engine, &theorem);
    let is_left = |k: &u32| k % 8 != 4 && ![3, 6].contains(&(k % 9));
    let left: Vec<u32> = (0..72).step_by(2).filter(is_left).collect();
    assert_eq!(theorem.force.survivors(), survivors(true, 72, &left));
    let section = text(&engine, pages::DOLLARS);
    let line = "Zero at the orders that are 4, 6, 12, 20, 24, 28, 30, 36, 42, 44, 48, 52, 60, 66, 68 modulo 72, and \
                at no other. This holds for both the direct and the reverse vector.";
    assert!(section.contains(line) && !section.contains("Force, direct"), "no table of 37 rows");
}

#[test]
fn the_formula_needs_no_bar_in_a_table_and_compiles_as_latex() {
    let latex = text(&named("I6"), Format::Latex);
    assert!(latex.contains("\\section{Every order}") && latex.contains("$6 \\nmid k$"));
    assert!(latex.contains("amssymb"), "the sign for `does not divide` is there");
}

fn sum_vanishes(layout: &Engine, quantity: Quantity, order: u32, sense: Sense) -> bool {
    order::star(layout, quantity, order, Some(sense)).vanishes()
}

/// Compares the statements with direct verdicts at order 1 and the even orders up to 200.
fn agrees(layout: &Engine, theorem: &Theorem) {
    for (quantity, every) in [(Quantity::FORCE, &theorem.force), (Quantity::MOMENT, &theorem.moment)] {
        let ([direct, reverse], both) = (senses(every), every.survivors());
        let mut lowest = None;
        for order in std::iter::once(1).chain((2..=200).step_by(2)) {
            let left = [Sense::Direct, Sense::Reverse].map(|sense| !sum_vanishes(layout, quantity, order, sense));
            let said = [&direct, &reverse].map(|one| one.contains(order));
            assert_eq!(said, left, "{}: {} {order}", layout.title().written(), quantity.name());
            assert_eq!(both.contains(order), left[0] || left[1]);
            lowest = lowest.or((left[0] || left[1]).then_some(order));
        }
        assert_eq!(every.first.as_ref().map(|first| first.direct.order), lowest);
    }
}

#[test]
fn every_statement_on_the_catalogue_agrees_with_direct_verdicts_up_to_order_200() {
    for layout in concentric() {
        agrees(&layout, &proved(&layout));
    }
}

#[test]
fn no_statement_on_the_catalogue_holds_with_a_smaller_modulus() {
    for layout in concentric() {
        let theorem = proved(&layout);
        for every in [&theorem.force, &theorem.moment] {
            for found in senses(every).into_iter().chain([every.survivors()]) {
                assert!(theorem.period.is_multiple_of(found.modulus) && found.modulus.is_multiple_of(2));
                for smaller in (2..found.modulus).step_by(2) {
                    let mut classes = (2..=theorem.period * smaller).step_by(2);
                    assert!(
                        classes.any(|order| found.contains(order) != found.contains(order + smaller)),
                        "{}: {found:?} repeats after {smaller}",
                        layout.title().written()
                    );
                }
            }
        }
    }
}

#[test]
fn a_period_too_long_is_named() {
    let longest = written("[inline]\nthrows = [0, 0.5]");
    assert_eq!((proved(&longest).period, LONGEST_PERIOD), (720, 720));
    let huge = written("[inline]\nthrows = [0, '360/1000003', 90]");
    let reason = theorem(&huge).expect_err("a long period");
    assert_eq!(reason.to_string(), "the pattern repeats only after 4000012 orders; at most 1000000 are examined");
    let line = "No statement is made on every order at once: the pattern repeats only after 4000012 orders, and at most 1000000 are examined.";
    says(&huge, &[line]);
    assert!(!text(&huge, Format::Latex).contains("The next order that remains"));
    let huge = written(&format!("[inline]\nthrows = [0, '360/1{}7']", "0".repeat(40)));
    let NoTheorem::PeriodTooLong(period) = theorem(&huge).expect_err("a long period") else {
        panic!("another reason");
    };
    assert_eq!(period.to_string().len(), 42);
    let digits = "No statement is made on every order at once: the pattern repeats only after a number of orders that has 42 digits, and at most 1000000 are examined.";
    says(&huge, &[digits]);
}

/// The verdicts on order 1 with the theorems: force direct, reverse, moment direct, reverse.
fn document(layout: &Engine) -> Document {
    let orders = judged(layout, &[1], false);
    verdicts::document(layout, &orders, false, Some(&theorem(layout).expect("a short period")))
}

#[test]
fn every_theorem_on_the_catalogue_passes_the_checker_as_json() {
    for layout in concentric() {
        let document = document(&layout);
        let subjects: BTreeSet<_> = document.theorems.iter().map(|claim| (claim.quantity, claim.sense)).collect();
        assert_eq!((document.theorems.len(), subjects.len()), (4, 4));
        let json = serde_json::to_string(&document).expect("JSON");
        let read: Document = serde_json::from_str(&json).expect("a document");
        assert_eq!(read.theorems, document.theorems);
        let counted = check_document(&read).expect("it holds").counts.certificates();
        let proved: usize = document.theorems.iter().map(|claim| claim.verdicts.len()).sum();
        assert!(counted >= proved + 4);
    }
}

const PLACE: &str = "theorems[0] (force, direct)";

/// Where a changed document on the 60° V-twin fails, and why.
fn fault(change: impl FnOnce(&mut Document)) -> [String; 2] {
    let mut document = document(&named("V2-60"));
    change(&mut document);
    let Fault { place, reason } = check_document(&document).expect_err("a cheat");
    [place, reason.to_string()]
}

#[test]
fn a_theorem_on_rods_that_differ_or_stand_off_is_refused() {
    let rod = |offset: i64| {
        let fraction = |numerator: i64| BigRational::new(numerator.into(), 4.into());
        RodStatement::Known(RodClaim { ratio: fraction(1), offset: fraction(offset) / fraction(40) })
    };
    let off = fault(|document| document.cylinders.iter_mut().for_each(|cylinder| cylinder.rod = rod(1)));
    assert_eq!(off, [PLACE, "a statement on every order needs rods that are equal and centric"]);
    let mut equal = document(&named("V2-60"));
    equal.cylinders.iter_mut().for_each(|cylinder| cylinder.rod = rod(0));
    check_document(&equal).expect("equal centric rods");
    let unequal = fault(|document| {
        document.cylinders[0].rod = rod(0);
        document.cylinders[1].rod = rod(1);
    });
    assert!(unequal[1].starts_with("here stands a verdict on"), "{}", unequal[1]);
}

#[test]
fn a_theorem_on_the_torque_or_listed_twice_or_left_out_is_refused() {
    let stands = "another theorem stands here";
    let torque = fault(|document| document.theorems[0].quantity = Quantity::TORQUE);
    assert_eq!(torque, [PLACE, stands]);
    let twice = fault(|document| document.theorems[1] = document.theorems[0].clone());
    assert_eq!(twice, ["theorems[1] (force, reverse)", stands]);
    let left_out = fault(|document| drop(document.theorems.pop()));
    assert_eq!(left_out, ["theorems[3] (moment, reverse)", "this theorem is missing"]);
    let not_asked = fault(|document| document.all_orders = false);
    assert_eq!(not_asked, ["theorems", "there are more than were asked for"]);
}

#[test]
fn a_wrong_period_is_refused() {
    let period = |period: i32| fault(|document| document.theorems[0].period = period.into());
    for wrong in [0, -12, 9] {
        assert_eq!(period(wrong), [PLACE, &format!("the period {wrong} is not a positive even number")]);
    }
    assert_eq!(period(6)[1], "the period 6 times the angle 11/12 of cylinder 1 is not whole");
    assert_eq!(period(24)[1], "order 14 is missing");
}

#[test]
fn an_order_of_the_period_left_out_or_listed_twice_is_refused() {
    let left_out = fault(|document| drop(document.theorems[0].verdicts.pop()));
    assert_eq!(left_out, [PLACE, "order 12 is missing"]);
    let without_one = fault(|document| drop(document.theorems[0].verdicts.remove(0)));
    assert_eq!(without_one, [PLACE, "order 2 is in the place of order 1"]);
    for (index, again) in [(1, 2), (1, 14), (0, 1)] {
        let twice = fault(|document| {
            let mut copy = document.theorems[0].verdicts[index].clone();
            copy.order = again;
            document.theorems[0].verdicts.push(copy);
        });
        assert_eq!(twice, [PLACE, &format!("order {again} is beyond the period 12")]);
    }
    for order in [0, 3, 26] {
        let other = fault(|document| document.theorems[0].verdicts[1].order = order);
        assert_eq!(other, [PLACE, &format!("order {order} is in the place of order 2")]);
    }
}

#[test]
fn a_certificate_of_another_order_or_engine_is_refused() {
    let none = Certificate::Polygons { polygons: Vec::new() };
    let forged = fault(|document| {
        let verdict = &mut document.theorems[0].verdicts[1];
        (verdict.vanishes, verdict.certificate) = (true, none);
    });
    assert_eq!(forged[0], PLACE);
    assert!(forged[1].starts_with("order 2: at angle "), "{}", forged[1]);
    let flipped = fault(|document| document.theorems[0].verdicts[1].vanishes = true);
    assert_eq!(flipped[1], "order 2: `vanishes` and the kind of the certificate contradict each other");
    let swapped = fault(|document| {
        let claims = &mut document.theorems[0].verdicts;
        let (first, second) = (claims[1].certificate.clone(), claims[3].certificate.clone());
        (claims[1].certificate, claims[3].certificate) = (second, first);
    });
    assert!(swapped[1].starts_with("order 2: "), "{}", swapped[1]);
}

#[test]
fn a_statement_that_the_verdicts_do_not_bear_out_is_refused() {
    let stated = |survivors: Survivors| fault(|document| document.theorems[0].survivors = survivors)[1].clone();
    let [direct, _] = senses(&proved(&named("V2-60")).force);
    assert_eq!(direct, survivors(true, 6, &[0, 2]));
    assert_eq!(stated(survivors(false, 6, &[0, 2])), "order 1: the statement contradicts the verdict");
    assert_eq!(stated(survivors(true, 6, &[0])), "order 2: the statement contradicts the verdict");
    assert_eq!(stated(survivors(true, 6, &[0, 4])), "order 2: the statement contradicts the verdict");
    assert_eq!(stated(survivors(true, 2, &[0])), "order 4: the statement contradicts the verdict");
    for (modulus, residues) in [(6, &[0, 2, 4][..]), (12, &[0, 2, 6, 8]), (6, &[])] {
        let reason = format!("the same is said with a smaller modulus than {modulus}");
        assert_eq!(stated(survivors(true, modulus, residues)), reason);
    }
    for modulus in [0, 3, 8, 24] {
        let reason = format!("the modulus {modulus} is not an even divisor of the period 12");
        assert_eq!(stated(survivors(true, modulus, &[0, 2])), reason);
    }
    for residues in [&[2, 0][..], &[0, 0, 2], &[0, 2, 6], &[0, 1, 2]] {
        assert_eq!(stated(survivors(true, 6, residues)), "the residues are not rising even numbers below 6");
    }
}
