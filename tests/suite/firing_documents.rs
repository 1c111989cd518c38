//! Does the checker of firing stars accept what is honest, and refuse what does not hold, whatever is changed?

use crankstar::engine::{Cycle, CycleOrder, Cylinder, Draft, Engine, Firing};
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::firing::Weights;
use crankstar::proof::{
    AnyDocument, Certificate, CycleClaim, FiringDocument, Format, RodClaim, RodStatement, check_firing_document,
    read_document,
};
use crankstar::report::{FiringStudy, firing_document};
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::second;
use crate::support::written::{fraction, of_catalogue as engine};

fn document_of(engine: &Engine, weights: Weights) -> FiringDocument {
    firing_document(&FiringStudy::new(engine, &[], weights).expect("stars"), true)
}

fn document() -> FiringDocument {
    document_of(&engine("V2-90"), Weights::Rigid)
}

#[track_caller]
fn assert_refused(cheat: impl Fn(&mut FiringDocument), words: &str) {
    let mut cheated = document();
    cheat(&mut cheated);
    assert_ne!(cheated, document(), "nothing was changed");
    let fault = check_firing_document(&cheated).expect_err("the cheat is seen").to_string();
    assert!(words.split('|').any(|words| fault.contains(words)), "{fault}");
}

/// Written, read and written again: the same, and it holds.
fn assert_travels(document: &FiringDocument) {
    let json = serde_json::to_string(document).expect("JSON");
    let read = read_document(json.as_bytes()).unwrap_or_else(|error| panic!("{error}: {json}"));
    assert_eq!(read, AnyDocument::Firing(document.clone()));
    read.check().unwrap_or_else(|fault| panic!("{fault}: {json}"));
}

#[test]
fn the_stars_of_the_catalogue_hold_in_both_cycles() {
    for (entry, engine) in file::catalogue().expect("the catalogue reads") {
        for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
            let Ok(engine) = crankstar::report::run_in_cycle(&engine, cycle) else { continue };
            let document = document_of(&engine, Weights::Rigid);
            assert!(document.pattern.is_some(), "{} repeats soon", entry.name);
            assert_travels(&document);
        }
    }
}

/// Any throws, any revolution of four-strokes, any deflections, any radii: nothing is honest and refused.
#[test]
fn the_stars_of_random_engines_hold() {
    let mut dice = Dice::new(31);
    for _ in 0..150 {
        let mut draft = Draft::new("random");
        let denominator = [4_i64, 7, 12, 36, 100, 360][dice.below(6) as usize];
        let count = dice.below(10) as usize + 1;
        let mut turn = || Turn::fraction(dice.below(400) as i64, denominator);
        for place in 0..count {
            let cylinder = Cylinder::new(turn(), turn(), fraction(place as i64, 1), place);
            draft.cylinders.push(cylinder);
        }
        for cylinder in &mut draft.cylinders {
            cylinder.crank_radius = fraction(dice.below(5) as i64 + 1, 3);
        }
        let cycle = if dice.below(2) == 0 { Cycle::TwoStroke } else { Cycle::FourStroke };
        let centre = |cylinder: &Cylinder| (&cylinder.bank - &cylinder.throw).turns().clone();
        let first = centre(&draft.cylinders[0]);
        let angles: Vec<BigRational> = draft
            .cylinders
            .iter()
            .map(|cylinder| centre(cylinder) - &first + fraction(dice.below(2) as i64, 1))
            .collect();
        let cylinders = draft.cylinders.clone();
        draft.cycle = Some(cycle);
        draft.firing = Some(Firing::from_angles(&angles, cycle, &cylinders).expect("they fire at their dead centres"));
        let engine = draft.build().expect("an engine");
        let shape: Vec<BigRational> = (0..count).map(|_| fraction(dice.below(9) as i64 - 4, 7)).collect();
        if shape.iter().any(|deflection| *deflection != fraction(0, 1)) {
            assert_travels(&document_of(&engine, Weights::ModeShape(shape)));
        }
        assert_travels(&document_of(&engine, Weights::Rigid));
    }
}

#[test]
fn a_changed_engine_is_refused() {
    let angle = "top dead centre|within the cycle|angle of|0, from where";
    assert_refused(|d| d.cylinders[1].throw = fraction(1, 7), angle);
    assert_refused(|d| d.cylinders[1].bank = fraction(1, 7), angle);
    assert_refused(|d| d.cylinders[1].firing_angle = fraction(1, 7), angle);
    assert_refused(|d| d.cylinders[1].firing_angle = fraction(1, 4), angle);
    assert_refused(|d| d.cylinders[1].firing_angle = fraction(-3, 4), angle);
    assert_refused(|d| d.cylinders[1].firing_angle = fraction(13, 4), angle);
    assert_refused(|d| d.cycle = CycleClaim::TwoStroke, "within the cycle|no order");
    assert_refused(|d| d.cylinders[1].crank_radius = fraction(2, 1), "weight");
    assert_refused(|d| d.cylinders[1].deflection = fraction(2, 1), "weight");
    assert_refused(|d| d.cylinders[1].name = "1".into(), "two cylinders");
    let rod = RodStatement::Known(RodClaim { ratio: fraction(1, 4), offset: fraction(0, 1) });
    assert_refused(|d| d.cylinders[1].rod = rod.clone(), "all are, or none");
    assert_refused(
        |d| {
            d.cylinders[0].rod = RodStatement::Known(RodClaim { ratio: fraction(1, 3), offset: fraction(0, 1) });
            d.cylinders[1].rod = rod.clone();
        },
        "another verdict|missing",
    );
}

/// Endless rods of several slopes have motions made of the same two: neither one star of all nor one of each slope tells what vanishes.
#[test]
fn endless_rods_of_two_slopes_have_no_stars() {
    let sloped = |offset: i64| RodStatement::Known(RodClaim { ratio: fraction(0, 1), offset: fraction(offset, 5) });
    let mut of_one_slope = document();
    for cylinder in &mut of_one_slope.cylinders {
        cylinder.rod = sloped(3);
    }
    assert_travels(&of_one_slope);
    let mut cheat = of_one_slope;
    cheat.cylinders[1].rod = sloped(-3);
    let fault = check_firing_document(&cheat).expect_err("the cheat is seen").to_string();
    assert!(fault.contains("infinitely long rods"), "{fault}");
    second::refuses(&[("two slopes", cheat)]);
}

#[test]
fn every_cylinder_fires_later_is_another_engine() {
    assert_refused(
        |d| {
            for cylinder in &mut d.cylinders {
                cylinder.throw = &cylinder.throw - fraction(1, 8);
                cylinder.firing_angle = &cylinder.firing_angle + fraction(1, 8);
            }
        },
        "0, from where",
    );
}

#[test]
fn changed_orders_and_verdicts_are_refused() {
    assert_refused(|d| d.orders[0] = fraction(1, 3), "not an order of the cycle");
    assert_refused(|d| d.orders[0] = fraction(-1, 2), "not an order of the cycle");
    assert_refused(|d| d.orders[0] = fraction(0, 1), "not an order of the cycle");
    assert_refused(|d| d.orders.swap(0, 1), "rise");
    assert_refused(|d| drop(d.orders.pop()), "not asked for");
    assert_refused(|d| drop(d.verdicts.pop()), "missing");
    assert_refused(|d| d.verdicts.swap(0, 1), "another verdict");
    assert_refused(|d| d.verdicts[0].order = fraction(3, 2), "another verdict");
    assert_refused(|d| d.verdicts[0].of = vec!["1".into()], "another verdict");
    assert_refused(|d| d.verdicts.push(d.verdicts[0].clone()), "not asked for");
    assert_refused(|d| d.verdicts[0].vanishes = true, "kind|verdict");
    assert_refused(|d| d.verdicts[0].terms[1].angle = fraction(1, 7), "angle of");
    assert_refused(|d| d.verdicts[0].terms[1].weight = fraction(1, 7), "weight of");
    assert_refused(|d| drop(d.verdicts[0].terms.pop()), "terms for");
    assert_refused(|d| d.verdicts[0].modulus *= 1.000_001, "modulus");
    assert_refused(|d| d.verdicts[0].angle_deg = d.verdicts[0].angle_deg.map(|angle| angle + 0.001), "angle_deg");
    assert_refused(|d| d.verdicts[0].angle_deg = None, "angle_deg");
    // Order 2 vanishes.
    assert_refused(|d| d.verdicts[3].vanishes = false, "kind|verdict");
    assert_refused(|d| d.verdicts[3].modulus = 1.0, "modulus");
    assert_refused(|d| d.verdicts[3].certificate = Certificate::Polygons { polygons: Vec::new() }, "polygons");
    assert_refused(|d| d.format = Format::Classify, "firing 1");
}

#[test]
fn a_changed_pattern_is_refused() {
    let pattern = |change: fn(&mut crankstar::proof::PatternClaim)| {
        move |d: &mut FiringDocument| change(d.pattern.as_mut().expect("a pattern"))
    };
    assert_refused(pattern(|p| p.period = 4), "does not repeat");
    assert_refused(pattern(|p| p.period = 16), "missing");
    assert_refused(pattern(|p| p.period = 0), "nothing repeats");
    assert_refused(pattern(|p| p.verdicts.swap(0, 1)), "another verdict");
    assert_refused(pattern(|p| drop(p.verdicts.pop())), "missing");
    assert_refused(pattern(|p| p.verdicts.push(p.verdicts[0].clone())), "beyond the period");
    assert_refused(pattern(|p| p.verdicts[0].vanishes = true), "kind|verdict");
    assert_refused(
        pattern(|p| p.verdicts[0].certificate = p.verdicts[1].certificate.clone()),
        "conductor|residue|root",
    );
    assert_refused(
        |d| {
            d.orders.clear();
            d.verdicts.clear();
            d.pattern = None;
        },
        "nothing to check",
    );
}

/// A document says each number in one way, and has no key that means nothing.
#[test]
fn other_keys_and_spellings_are_refused() {
    let json = serde_json::to_string(&document()).expect("JSON");
    for (from, to) in [
        ("\"orders\":[\"1/2\"", "\"orders\":[\"2/4\""),
        ("\"deflection\":\"1\"", "\"deflection\":\"1\",\"colour\":\"red\""),
        ("\"cycle\":\"four-stroke\"", "\"cycle\":\"six-stroke\""),
        ("crankstar firing 1", "crankstar firing 2"),
    ] {
        let cheated = json.replacen(from, to, 1);
        assert_ne!(cheated, json, "{from} is in it");
        assert!(read_document(cheated.as_bytes()).is_err(), "{to}");
    }
}

#[test]
fn a_long_period_is_said_and_the_orders_are_judged_all_the_same() {
    let layout = "title = \"Two\"\ncycle = \"four-stroke\"\nfiring_angles = [0, \"100.001\"]\n[inline]\nthrows = [0, \"-100.001\"]\n";
    let engine = file::parse("two.toml", layout).expect("it reads");
    let order = CycleOrder::of_halves(1).expect("an order");
    let study = FiringStudy::new(&engine, &[order], Weights::Rigid).expect("stars");
    assert!(study.pattern().is_err());
    assert_travels(&firing_document(&study, true));
}
