//! Is a length that nobody gave asked for where a result hangs on it, and given without it where none does?

use crankstar::engine::Engine;
use crankstar::file::parse;
use crankstar::loads::{Loads, loads_at};
use crankstar::order::{MissingArm, roll_lacks};
use crankstar::proof::Quantity;
use crankstar::report;
use crankstar::verdict::{self, Judgement};

use crate::geared::assert_feels_its_bodies;
use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::written::engine as layout;

const TORQUE: &str = "speed = '3000 rpm'\neffects = ['torque']\n";
const MECHANISM: &str = "\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n";
const TURNING: &str = "rotating_mass = '0.4 kg'\n";

fn loads(engine: &Engine) -> Loads {
    let orders: Vec<u32> = (1..=70).collect();
    loads_at(engine, &orders, &orders).expect("loads")
}

/// The answer and the page of an engine, in short and in newtons.
fn said(engine: &Engine) -> [String; 2] {
    let judged = Judgement::new(engine, &[1, 2], &verdict::quantities(engine, false)).expect("orders");
    let answer = pages::text(&report::engine_answer(engine, &judged), pages::DOLLARS);
    [answer, pages::text(&pages::document(engine), pages::DOLLARS)]
}

#[test]
fn the_roll_moment_of_opposed_pistons_asks_for_their_distance_where_it_counts() {
    let text = format!("{TORQUE}[opposed_piston]\nthrows = [0, 90]\nlead = 11");
    let engine = layout(&format!("{text}{MECHANISM}{TURNING}"));
    assert_eq!(roll_lacks(&engine), Some(MissingArm::Distance));
    assert!(loads(&engine).roll.is_none() && !verdict::quantities(&engine, true).contains(&Quantity::ROLL));
    for page in said(&engine) {
        assert!(page.contains("Give distance below [opposed_piston]"), "{page}");
    }
    // No number stands on a page that nobody gave.
    let [_, page] = said(&engine);
    assert!(page.contains("they are drawn 11 crank radii apart") && page.contains("not given"), "{page}");
    assert!(!page.contains("5.5 at") && !page.contains("11/2"), "{page}");
    let given = layout(&format!("{text}\ndistance = '1100 mm'{MECHANISM}{TURNING}"));
    assert!(loads(&given).roll.is_some() && roll_lacks(&given).is_none());
    assert_feels_its_bodies(&given, &(1..=70).collect::<Vec<_>>(), &text);
}

/// Given exactly where it is the same at every distance.
#[test]
fn the_roll_moment_of_random_opposed_pistons_is_given_exactly_where_no_distance_changes_it() {
    let mut dice = Dice::new(26);
    let (mut given, mut asked) = (0, 0);
    for _ in 0..40 {
        let count = 1 + dice.below(4);
        let even = dice.below(2) == 0;
        let throws = (0..count).map(|at| if even { 360 * at / count } else { 15 * dice.below(24) });
        let throws = throws.map(|throw| throw.to_string()).collect::<Vec<_>>().join(", ");
        let sense = ["with", "against"][dice.below(2) as usize];
        let turning =
            ["", TURNING, "rotating_mass = '0.2 kg'\n[crankshaft]\npin_mass = '0.1 kg'\n"][dice.below(3) as usize];
        let lead = dice.below(3) * 7;
        let form = format!("{TORQUE}[opposed_piston]\nthrows = [{throws}]\nlead = {lead}\nsense = '{sense}'");
        let engine = layout(&format!("{form}{MECHANISM}{turning}"));
        let at = |distance: u32| layout(&format!("{form}\ndistance = {distance}{MECHANISM}{turning}"));
        let [near, far] = [7, 19].map(|distance| loads(&at(distance)).roll.expect("there are arms").waveform);
        let thetas = || (0..9).map(|step| f64::from(step) * 0.7);
        let differs = thetas().any(|theta| (near.at(theta) - far.at(theta)).norm() > 1e-9);
        let found = loads(&engine).roll;
        assert_eq!(found.is_none(), differs, "{form}{turning}");
        match found {
            Some(roll) => {
                given += 1;
                assert!(thetas().all(|theta| (roll.waveform.at(theta) - near.at(theta)).norm() < 1e-9), "{form}");
            }
            None => asked += 1,
        }
    }
    assert!(given > 9 && asked > 9, "{given} given, {asked} asked for");
}

#[test]
fn the_roll_moment_asks_for_the_axes_of_crankshafts_and_shafts_that_stand_nowhere() {
    let cranks = |axis: &str| {
        let cylinder = |of: &str| format!("[[cylinder]]\ncrankshaft = '{of}'\nthrow = 0\nbank = 0\nposition = 0\n");
        let [a, b] = ["a", "b"].map(cylinder);
        format!(
            "{TORQUE}[[crankshaft]]\nname = 'a'\nsense = 'with'\n{axis}[[crankshaft]]\nname = 'b'\nsense = 'against'\noffset = 3\n{a}{b}{MECHANISM}"
        )
    };
    let shaft = |axis: &str| {
        let shaft = "[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '0.002'\nangle = 0\nposition = 0\n";
        format!("{TORQUE}[inline]\nthrows = [0, 180]\nspacing = '0.1 m'{MECHANISM}{shaft}{axis}")
    };
    for (text, right, words) in [
        (cranks(""), Some(MissingArm::Crankshaft(0)), "on the position of crankshaft a"),
        (cranks("offset = 0\n"), None, ""),
        (cranks("distance = 2\nangle = 45\n"), None, ""),
        (shaft(""), Some(MissingArm::Balancer(0)), "on the position of balancer shaft 1"),
        (shaft("height = 0\n"), None, ""),
        (shaft("offset = '-60 mm'\n"), None, ""),
    ] {
        let engine = layout(&text);
        let found = loads(&engine);
        assert_eq!(
            (roll_lacks(&engine), found.roll_lacks, found.roll.is_some()),
            (right, right, right.is_none()),
            "{text}"
        );
        let [_, page] = said(&engine);
        assert_eq!(page.contains("The roll moment is not given"), right.is_some(), "{text}");
        assert!(page.contains(words), "{page}");
    }
}

/// A length with a unit among cylinders of which nobody says how far apart they stand: what is one spacing in metres?
#[test]
fn lengths_with_a_unit_ask_for_the_spacing_in_every_form() {
    let planes = [
        "[inline]\nthrows = [0, 180]",
        "[vee]\nbank_angle = 60\nthrows = [0, 180]",
        "[flat]\nthrows = [0, 180]",
        "[fan]\nbanks = [0, 60]\nthrows = [0, 180]",
        "[vr]\nbank_angle = 15\nthrows = [0, 180]",
        "[w]\nbank_angle = 72\nnarrow_angle = 15\nthrows = [0, 180]",
        "[radial]\ncylinders = 3\nrows = 2\nrow_rotation = 60\nrow_throw = 180",
        "[u]\nthrows = [0, 180]\nsense = 'with'\ndistance = 4",
        "[h]\nthrows = [0, 180]\nsense = 'with'\ndistance = 4",
        "[square_four]\nin_phase = 'sides'\nsense = 'with'\ndistance = 4",
        "[opposed_piston]\nthrows = [0, 180]\nlead = 11",
        "[delta]\nrows = [0, 180]\ncircumradius = 6",
    ];
    let offsets = [
        "[vee]\nbank_angle = 60\nthrows = [0, 180]\nbank_offset = '22 mm'",
        "[flat]\nthrows = [0, 180]\nbank_offset = '22 mm'",
        "[fan]\nbanks = [0, 60]\nthrows = [0, 180]\nbank_offsets = ['22 mm', 0]",
        "[w]\nbank_angle = 72\nnarrow_angle = 15\nthrows = [0, 180]\nbank_offset = '13 mm'",
        "values = { b = '22 mm' }\n[vee]\nbank_angle = 60\nthrows = [0, 180]\nbank_offset = 'b'",
    ];
    let files =
        planes.map(|form| format!("reference_plane = '50 mm'\n{form}")).into_iter().chain(offsets.map(str::to_owned));
    for text in files {
        let error = parse("silent.toml", &text).expect_err(&text).to_string();
        assert!(
            error.contains("one spacing apart") && error.contains("give the engine its spacing"),
            "{text}\n{error}"
        );
        // The length is named where it stands.
        let said = ["50 mm", "22 mm", "13 mm"].into_iter().find(|said| text.contains(said)).expect("a length");
        let line = text.lines().position(|line| line.contains(said)).expect("a line") + 1;
        assert!(
            error.contains(&format!("the length `{said}`")) && error.contains(&format!("silent.toml:{line}:")),
            "{text}\n{error}"
        );
        let key = if text.contains("radial") { "row_spacing" } else { "spacing" };
        layout(&format!("{text}\n{key} = '100 mm'"));
    }
}

#[test]
fn a_value_of_no_unknown_is_told_before_its_unit() {
    let text = "values = { a = '5 mm' }\n[inline]\nthrows = [0, 180]\n";
    let error = parse("value.toml", text).expect_err("no unknown").to_string();
    assert!(error.contains("no unknown `a`") && error.contains("value.toml:1:"), "{error}");
}

#[test]
fn the_snippets_of_forms_with_offsets_are_read_as_printed() {
    let page = include_str!("../../src/kernel/file/README.md");
    for form in ["[vee]\nbank_angle = 90", "[vr]\nbank_angle = 15", "[w]\nbank_angle = 72"] {
        let start = page.find(&format!("```toml\n{form}")).unwrap_or_else(|| panic!("no {form}"));
        let text = page[start..].lines().skip(1).take_while(|line| *line != "```").collect::<Vec<_>>().join("\n");
        parse("printed.toml", &text).unwrap_or_else(|error| panic!("{text}\n{error}"));
    }
}
