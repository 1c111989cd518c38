//! Are the counterweights of several crankshafts chosen as those of each would be?

use crankstar::engine::Engine;
use crankstar::file::{FileResolver, parse};
use crankstar::optimise::{Couple, Front, Residual, front};

use crate::optimise::{WEBS, assert_close, engine, request, solved, whole};
use crate::support::written::float;

/// A crankshaft of an engine as `engine` writes it, beside a second one: the form, and what is after it.
fn geared(form: &str, bearings: &str, more: &str) -> Engine {
    let text = format!(
        "speed = 6000\nbearings = {bearings}\norders = [1, 2]\n{form}\n[mechanism]\nreciprocating_mass = 0.65\n\
         rotating_mass = 0.5\ncrank_radius = '45 mm'\nrod_ratio = 0.25\n{more}"
    );
    parse("geared.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// An engine of two crankshafts with the same throws has the front of one of them, at twice the mass.
fn assert_twice(two: &Engine, one: &Front, couple: &Couple, what: &str) {
    let two = solved(two, couple.clone(), 3);
    assert_eq!((two.points.len(), two.places.len()), (one.points.len(), 2 * one.places.len()), "{what}");
    for (two, one) in two.points.iter().zip(&one.points) {
        assert_close(float(&two.design.mass), 2.0 * float(&one.design.mass), 1e-4, what);
        // As many steps of mass-radius are coarser beside half the mass of each.
        assert_close(two.design.peak(), one.design.peak(), 2e-3, what);
        // What is kept of a bounded couple for that differs as well.
        assert_close(two.least, one.least, 4e-3, what);
        assert_eq!((two.design.force, one.design.force), (Residual::Zero, Residual::Zero), "{what}");
        if *couple == Couple::Zero {
            assert_eq!(two.design.couple, Residual::Zero, "{what}");
        }
    }
    for (two, one) in two.uniform.iter().zip(&one.uniform) {
        assert_close(float(&two.design.mass), 2.0 * float(&one.design.mass), 1e-9, what);
        assert_close(two.design.peak(), one.design.peak(), 1e-9, what);
    }
}

#[test]
fn two_crankshafts_with_the_same_throws_have_the_front_of_one_at_twice_the_mass() {
    let beam = "[0.15, 0.05, -0.05, -0.15]";
    for throws in ["[0, 120, 240]", "[0, 180, 0]", "[0, 90, 225]"] {
        let one = engine(throws, beam, WEBS);
        for couple in [Couple::Zero, Couple::AtMost(whole(40))] {
            let one = solved(&one, couple.clone(), 3);
            for sense in ["with", "against"] {
                let form = format!("[u]\nthrows = {throws}\nspacing = 0.1\nsense = '{sense}'\ndistance = 0.2");
                assert_twice(&geared(&form, beam, WEBS), &one, &couple, &form);
            }
        }
    }
}

#[test]
fn a_crankshaft_that_turns_twice_as_fast_has_the_loads_of_twice_the_speed() {
    let beam = "[0.15, 0.05, -0.05, -0.15]";
    // Two weights a throw, written one by one: [crankshaft] is no table beside [[crankshaft]].
    let weights = |throws: usize| -> String {
        let at = |throw: usize, side: f64| {
            let position = [0.1, 0.0, -0.1][throw % 3] + side;
            format!("[[counterweight]]\nthrow = {}\nmass = 1\nradius = 0.05\nposition = {position:.2}\n", throw + 1)
        };
        (0..throws).flat_map(|throw| [at(throw, 0.02), at(throw, -0.02)]).collect()
    };
    let one = solved(&engine("[0, 120, 240]", beam, &weights(3)), Couple::Zero, 2);
    let cylinder = |crank: &str, index: usize| {
        let (throw, position) = ([0, 120, 240][index], ["0.1", "0", "-0.1"][index]);
        format!("[[cylinder]]\ncrankshaft = '{crank}'\nthrow = {throw}\nbank = 0\nposition = {position}\n")
    };
    let cylinders: String =
        ["slow", "fast"].iter().flat_map(|crank| (0..3).map(move |index| cylinder(crank, index))).collect();
    let cranks =
        "[[crankshaft]]\nname = 'slow'\nsense = 'with'\n[[crankshaft]]\nname = 'fast'\nsense = 'against'\nspeed = 2\n";
    let more = format!("{cranks}{cylinders}{}", weights(6));
    let text = format!(
        "speed = 6000\nbearings = {beam}\norders = [1, 2, 4]\n[mechanism]\nreciprocating_mass = 0.65\nrotating_mass = 0.5\n\
         crank_radius = '45 mm'\nrod_ratio = 0.25\n{more}"
    );
    let both = parse("fast.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let [lightest, calmest] = one.points.as_slice() else { panic!("{} points", one.points.len()) };
    let two = solved(&both, Couple::Zero, 2);
    let [light, calm] = two.points.as_slice() else { panic!("{} points", two.points.len()) };
    assert_close(float(&light.design.mass), 2.0 * float(&lightest.design.mass), 1e-4, "lightest");
    assert_close(light.design.peak(), 4.0 * lightest.design.peak(), 1e-4, "lightest");
    // The slow crankshaft needs no more than the least weights to stay below what the fast one cannot avoid.
    assert!(lightest.design.peak() < 4.0 * calmest.design.peak());
    assert_close(calm.design.peak(), 4.0 * calmest.design.peak(), 1e-4, "calmest");
    assert_close(float(&calm.design.mass), float(&lightest.design.mass) + float(&calmest.design.mass), 1e-3, "calmest");
    assert_eq!((calm.design.force, calm.design.couple), (Residual::Zero, Residual::Zero));
    assert_eq!(calm.design.bearings.len(), 8);
}

#[test]
fn a_crankshaft_without_planes_for_counterweights_is_named() {
    let one =
        "[[counterweight]]\nthrow = 1\nmass = 1\nradius = 0.05\n[[counterweight]]\nthrow = 2\nmass = 1\nradius = 0.05";
    let u = geared("[u]\nthrows = [0, 180]\nspacing = 0.1\ndistance = 0.3\nsense = 'with'", "[0.1, 0, -0.1]", one);
    let refused = front(&u, &request(&u, Couple::Zero, 1), FileResolver::nothing())
        .err()
        .map(|refused| refused.to_string())
        .unwrap_or_default();
    assert!(refused.contains("the crankshaft right has no counterweights"), "{refused}");
}
