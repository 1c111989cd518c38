//! What is said of cures that was false of engines that can be written: is it true of these now?

use crankstar::loads::loads;
use crankstar::page::Format;
use crankstar::report::engine_answer;

use crate::support::pages;
use crate::support::program::{call, scratch};
use crate::support::written::engine;
use crate::true_sentences::{checked, printed, said, written};

/// The short answer in Markdown, whose cells are on one line.
fn answer(layout: &str) -> String {
    let engine = engine(layout);
    pages::text(&engine_answer(&engine, &pages::judgement(&engine)), Format::GITHUB).replace('\u{202f}', " ")
}

const VEE: &str = "speed = '3000 rpm'\nvee = { bank_angle = 90, throws = [0] }\n[mechanism]\nstroke = '80 mm'\nrod_length = '130 mm'\n\
    reciprocating_mass = '1 kg'\nrotating_mass = '2 kg'\n";

/// What balances the V is 200 kg·mm in all: to 100 kg·mm that are there 100 are added, not 200.
#[test]
fn a_weight_that_is_there_is_resized_and_one_that_is_not_is_added() {
    assert!(answer(VEE).contains("Order 1: counterweights (200 kg·mm) leave nothing."));
    for there in ["2.5 kg", "7.5 kg"] {
        let weight = format!("[[counterweight]]\nthrow = 1\nmass = '{there}'\nradius = '40 mm'\n");
        let told = answer(&(VEE.to_owned() + &weight));
        assert!(told.contains("Order 1: counterweights (resized to 200 kg·mm) leave nothing."), "{told}");
    }
}

#[test]
fn the_first_order_of_a_faster_crankshaft_is_cured_as_that_of_any_other() {
    let geared = "speed = '3000 rpm'\n[mechanism]\ncrank_radius = ['40 mm', '10 mm']\nrod_length = ['150 mm', '60 mm']\n\
        reciprocating_mass = ['0.5 kg', '0.2 kg']\nrotating_mass = [0, '1 kg']\n\
        [[crankshaft]]\nname = 'main'\nsense = 'with'\noffset = '0 mm'\n\
        [[crankshaft]]\nname = 'fast'\nsense = 'against'\nspeed = 3\noffset = '200 mm'\n\
        [[cylinder]]\ncrankshaft = 'main'\nthrow = 0\nbank = 0\nposition = '0 mm'\n\
        [[cylinder]]\ncrankshaft = 'fast'\nthrow = 0\nbank = 0\nposition = '0 mm'\n";
    let told = answer(geared);
    assert!(
        told.contains("counterweights added on crankshaft fast (11.0 kg·mm)")
            && !told.contains("Usually uncorrected: order 3"),
        "{told}"
    );
    let told = said("classify", geared, &["--masses", "rotating"]);
    assert!(!told.contains("has order 1 and no other"), "{told}");
    let told = checked(geared, "order 3 needs counterweights alone");
    assert!(!told.contains("counterweights reach order 1 alone"), "{told}");
}

#[test]
fn what_another_crankshaft_carries_counts_as_no_shaft_and_forces_stand_before_couples() {
    let twin = "speed = '3000 rpm'\n[u]\nthrows = [0, 180]\nsense = 'against'\nphase = 0\ndistance = '120 mm'\nspacing = '100 mm'\n\
        [mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n";
    let folder = scratch("true-cures");
    let output = call(&["remedy", &written(twin), "--output", folder.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = std::fs::read_to_string(folder.join("remedy.md")).expect("a page");
    assert!(
        page.contains(
            "| 1 | couple | two counterweights on crankshaft left, two counterweights on crankshaft right | 0 |"
        ),
        "{page}"
    );
    // With a length or without, the order of the rows is the same.
    let pair = "speed = 6000\ninline = { throws = [0, 180] }\n[mechanism]\nstroke = '70 mm'\nrod_length = '120 mm'\nreciprocating_mass = '0.4 kg'\n";
    for layout in [pair.to_owned(), pair.replace("180] }", "180], spacing = '100 mm' }")] {
        let output = call(&["remedy", &written(&layout), "--output", folder.to_str().expect("UTF-8")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let page = std::fs::read_to_string(folder.join("remedy.md")).expect("a page");
        let row = |begin: &str| page.find(begin).unwrap_or_else(|| panic!("{begin} in {page}"));
        assert!(row("| 2 | force |") < row("| 1 | couple |"), "{page}");
    }
}

/// The cross-plane eight needs counterweights, and leaves less than the flat-plane one.
#[test]
fn engines_are_compared_by_what_counterweights_leave() {
    let told = printed(&["compare", "V8-crossplane", "V8-flatplane"]);
    assert!(told.contains(
        "No free force or moment below order 4 but for what counterweights on the crank cancel: V8-crossplane."
    ));
}

/// Four throws lose the couple where they are not in evenly spread directions, or all in one plane.
#[test]
fn no_theorem_on_evenly_spread_stars_is_said_of_others() {
    let told = said("classify", "[inline]\nthrows = [0, 120, 240]\npositions = ['100 mm', '100 mm', '100 mm']\n", &[]);
    assert!(!told.contains("is free of the first-order couple"), "{told}");
}

/// A force without a shaft of its own does not get that of the moment, and what the first step leaves of the moment is shown.
#[test]
fn each_step_of_a_cure_stands_where_it_leaves_something() {
    let vee = "speed = 6000\nvee = { bank_angle = '53.13°', throws = [0], pin_split = '-73.74°', bank_offset = '40 mm' }\n\
        [mechanism]\nstroke = '72 mm'\nrod_length = '120 mm'\nreciprocating_mass = '0.35 kg'\nrotating_mass = '0.3 kg'\n";
    let told = said("classify", vee, &[]);
    assert!(told.contains("the same 99.49 N·m"), "{told}");
}

#[test]
fn a_claim_on_counterweights_that_is_false_shows_none_that_are_suitable() {
    let told = checked(
        "inline = { throws = [0] }\n",
        "counterweights at 0.5 can balance the direct first-order force and moment",
    );
    assert!(told.contains("false. No counterweights at these"), "{told}");
}

/// Nothing has order 3 in a four whose axes pass through the shaft, whatever its masses and spacings are.
#[test]
fn an_order_that_does_not_exist_is_neither_robust_nor_accidental() {
    let page = pages::text(
        &pages::document(&engine("orders = [1, 2, 3]\ninline = { throws = [0, 180, 180, 0] }\n")),
        Format::GITHUB,
    );
    assert!(page.contains("| force, order 1 |") && !page.contains("| force, order 3 |"), "{page}");
    assert!(!page.contains("| moment, order 3 |"), "{page}");
}

/// What the first shaft of order 2 leaves is the vector that turns the other way: of the force one part, of the moment another.
#[test]
fn the_first_of_two_shafts_leaves_its_own_part_of_the_force_and_of_the_moment() {
    let mut unlike = 0;
    for (bank, split, offset) in [(90, 45, 30), (60, 30, 20), (72, 18, 25), (120, 40, 10)] {
        let text = format!(
            "[vee]\nbank_angle = {bank}\npin_split = {split}\nthrows = [0]\nbank_offset = '{offset} mm'\nspacing = '0.1 m'\n[mechanism]\nrod_ratio = 0.3\n"
        );
        let loads = loads(&engine(&text), &[2]).expect("loads");
        let of = [&loads.orders[0].force, &loads.orders[0].moment].map(|swing| {
            let [direct, reverse] = [&swing.direct, &swing.reverse].map(|vector| vector.value.norm());
            [direct / (direct + reverse), reverse / (direct + reverse)]
        });
        let told = answer(&text).replace('\u{a0}', " ");
        let sense = usize::from(told.contains("Order 2: a shaft at twice crank speed with the crank"));
        let percents = of.map(|parts| format!("{:.0} %", 100.0 * parts[sense]));
        let [force, moment] = &percents;
        unlike += usize::from(force != moment);
        let both =
            if force == moment { force.clone() } else { format!("{force} of the force and {moment} of the moment") };
        assert!(told.contains(&format!(") leaves {both}; with one the other way")), "{both}: {told}");
    }
    assert!(unlike > 2);
}

#[test]
fn weights_stand_apart_in_millimetres_where_masses_are_in_kilograms() {
    let layout = |spacing: &str, masses: &str| {
        answer(&format!(
            "speed = 3000\n[mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\n{masses}[inline]\nthrows = [0, 240, 120]\nspacing = {spacing}\n"
        ))
    };
    for spacing in ["0.1", "'0.1 m'", "'100 mm'"] {
        let told = layout(spacing, "reciprocating_mass = '0.6 kg'\n");
        assert!(told.replace('\u{a0}', " ").contains("200 mm apart"), "{spacing}: {told}");
    }
    assert!(layout("0.1", "").contains("0.2 a apart"));
}

/// A shaft that the layout has is resized: what rolls the engine is all of it, as that of a layout without shafts.
#[test]
fn a_resized_shaft_rolls_the_engine_with_its_whole_force() {
    let twin = "speed = 9000\ninline = { throws = [0, 90], spacing = '88 mm' }\n[mechanism]\nstroke = '68.6 mm'\nrod_length = '120 mm'\n\
        reciprocating_mass = '0.3 kg'\nrotating_mass = '0.4 kg'\n";
    let shaft = "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = '6 kg mm'\nangle = 135\nposition = '40 mm'\nheight = '-40 mm'\noffset = '90 mm'\n";
    let force = |layout: &str| {
        let told = said("remedy", layout, &["--orders", "1"]);
        told.split_once("shaft 1 with ").map(|(_, rest)| rest.split('.').next().unwrap_or_default().to_owned())
    };
    let bare = force(twin).expect("a force");
    let resized = force(&format!("{twin}{shaft}")).expect("a force");
    assert!(bare.ends_with(" N") && bare == resized, "{bare} {resized}");
}
