//! Does a file mean what its page of keys says? Offsets, leads, splits, and lists of masses, in every form.
//!
//! The model knows nothing of equivalent cranks: pins, cylinder axes and rods stand in the plane of the drawing, as the page of keys
//! places them, and the rod's fixed length gives the piston's place.

use std::f64::consts::TAU;

use crankstar::engine::{Cylinder, Engine, throws};
use crankstar::exact::Turn;
use crankstar::file::parse;
use crankstar::loads::loads_at;
use crankstar::proof::Sense;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

const CLOCKWISE: &str = "rotation = 'clockwise'\n";
/// With rods of 140 mm and an offset of 10 mm in every cylinder.
const OFFSET: &str =
    "\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\npin_offset = '10 mm'\nreciprocating_mass = '0.5 kg'\n";

/// Every form with several crankshafts, those against the first among them.
const GEARED: &[&str] = &[
    "[u]\nthrows = [0]\nsense = 'against'\ndistance = 5",
    "[u]\nthrows = [20, 90]\nsense = 'with'\ndistance = 5\nphase = 40",
    "[h]\nthrows = [30]\nsense = 'against'\ndistance = 5\nphase = 70",
    "[square_four]\nin_phase = 'sides'\nsense = 'against'\ndistance = 5",
    "[opposed_piston]\nthrows = [0, 100]\nlead = 11\nsense = 'against'\ndistance = 11",
    "[opposed_piston]\nthrows = [0]\nlead = 11\nsense = 'with'\ndistance = 11",
    "[delta]\nrows = [0, 50]\ncircumradius = 6",
    "[delta]\nrows = [10]\nagainst = ['B', 'C']\ncircumradius = 6",
    "[[crankshaft]]\nname = 'l'\nsense = 'with'\noffset = 2\n[[crankshaft]]\nname = 'r'\nsense = 'against'\noffset = -2\nspeed = 2\n\
     [[cylinder]]\ncrankshaft = 'l'\nthrow = 10\nbank = 20\nposition = 0\n[[cylinder]]\ncrankshaft = 'r'\nthrow = -70\nbank = 40\nposition = 0",
];

fn layout(text: &str) -> Engine {
    parse("conventions.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn float(number: &BigRational) -> f64 {
    number.to_f64().expect("a number")
}

fn direction(turn: &Turn) -> Complex<f64> {
    Complex::cis(float(turn.turns()) * TAU)
}

fn sign_of(engine: &Engine, cylinder: &Cylinder) -> f64 {
    if engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 }
}

/// The force of one order on the frame at θ, in multiples of m r ω², of pistons whose axes pass their shafts, by e in crank radii, on the
/// side to which their own pins go after dead centre.
fn of_order(engine: &Engine, order: u32, theta: f64, (rod, offset): (f64, f64)) -> Complex<f64> {
    const POINTS: u32 = 256;
    let mut force = Complex::new(0.0, 0.0);
    for cylinder in engine.cylinders() {
        let (axis, pin) = (direction(&cylinder.bank), direction(&engine.pin_angle(cylinder)));
        let turning = sign_of(engine, cylinder) * f64::from(engine.speed_of(cylinder));
        let place = |theta: f64| {
            let crankpin = pin * Complex::cis(turning * theta);
            // At dead centre the pin stands on the axis of the shaft along the cylinder, and moves so:
            let goes = axis * Complex::i() * turning.signum();
            // Of the piston pin `goes · e + axis · x` it stands one rod away.
            let across = (crankpin * goes.conj()).re - offset;
            (crankpin * axis.conj()).re + (rod * rod - across * across).sqrt()
        };
        let part: Complex<f64> = (0..POINTS)
            .map(|point| TAU * f64::from(point) / f64::from(POINTS))
            .map(|theta| Complex::cis(-f64::from(order) * theta) * place(theta))
            .sum();
        let amplitude = part * (2.0 / f64::from(POINTS));
        let acceleration = -f64::from(order * order) * (amplitude * Complex::cis(f64::from(order) * theta)).re;
        force += axis * -acceleration;
    }
    force
}

#[test]
fn an_offset_above_0_lies_where_the_own_pin_goes_after_dead_centre_in_every_form_with_several_cranks() {
    for form in GEARED {
        for rotation in ["", CLOCKWISE] {
            let engine = layout(&format!("{rotation}{form}{OFFSET}"));
            for order in 1..=6 {
                let loads = loads_at(&engine, &[order], &[]).expect("loads");
                for theta in [0.3, 1.7, 4.1] {
                    let (found, right) = (loads.force.at(theta), of_order(&engine, order, theta, (3.5, 0.25)));
                    assert!((found - right).norm() < 1e-9, "{rotation}{form}, order {order}: {found} for {right}");
                }
            }
        }
    }
}

/// Two cranks that are mirror images of each other shake as one does, twice as much, and along their cylinders alone.
#[test]
fn two_mirror_images_with_one_offset_add_their_third_orders() {
    let single = layout(&format!("[inline]\nthrows = [0]{OFFSET}"));
    let twin = layout(&format!("[u]\nthrows = [0]\nsense = 'against'\ndistance = 5{OFFSET}"));
    let force = |engine: &Engine| loads_at(engine, &[3], &[]).expect("loads").force.at(0.8);
    let (one, both) = (force(&single), force(&twin));
    assert!(one.re.abs() > 1e-3 && (both.re - 2.0 * one.re).abs() < 1e-12 && both.im.abs() < 1e-12, "{both} of {one}");
}

/// A throw that is written is the throw of its pin, as drawn.
#[test]
fn throws_stand_as_they_are_written_in_every_form() {
    let two = |form: &str| format!("{form}\nthrows = [20, 250]");
    let crankshaft = "[[crankshaft]]\nname = 'a'\nsense = 'with'\noffset = 0\n[[crankshaft]]\nname = 'b'\nsense = 'against'\noffset = 3\n\
                      [[cylinder]]\ncrankshaft = 'b'\nthrow = 20\nbank = 10\nposition = 1\n\
                      [[cylinder]]\ncrankshaft = 'b'\nthrow = 250\nbank = 15\nposition = 0";
    let mut forms: Vec<String> = [
        "[inline]",
        "[vee]\nbank_angle = 80\npin_split = 25",
        "[flat]",
        "[boxer]\nstagger = 1",
        "[fan]\nbanks = [0, 50]\npin_splits = [0, 10]",
        "[vr]\nbank_angle = 15",
        "[w]\nbank_angle = 72\nnarrow_angle = 15\npin_split = 12",
        "[u]\nsense = 'against'\nphase = 40\ndistance = 5",
        "[h]\nsense = 'against'\nphase = 40\ndistance = 5",
        "[opposed_piston]\nlead = 12\nsense = 'with'",
        "[opposed_piston]\nlead = 12\nsense = 'against'",
        "[opposed_piston]\nlead = 12\nleading = 'lower'\nsense = 'with'",
        "[opposed_piston]\nlead = 12\nleading = 'lower'\nsense = 'against'",
    ]
    .map(two)
    .into();
    forms.push(crankshaft.to_owned());
    for form in &forms {
        for rotation in ["", CLOCKWISE] {
            let engine = layout(&format!("{rotation}{form}"));
            for (cylinder, written) in engine.cylinders().iter().zip([20, 250]) {
                let drawn = engine.convention().as_written(&engine.pin_angle(cylinder));
                assert_eq!(drawn, Turn::fraction(written, 360), "{rotation}{form}");
            }
        }
    }
}

/// The pistons of the leading crankshaft reach their dead centre before the others, by the lead.
#[test]
fn the_crankshaft_that_leads_is_ahead_by_the_lead() {
    for sense in ["with", "against"] {
        for rotation in ["", CLOCKWISE] {
            let between = |leading: &str| {
                let engine = layout(&format!(
                    "{rotation}[opposed_piston]\nthrows = [50]\nlead = 12\nleading = '{leading}'\nsense = '{sense}'"
                ));
                // When the pin of each crank stands in line with its cylinder, as the crank goes round in its own sense.
                let centre = |cylinder: &Cylinder| {
                    let way = sign_of(&engine, cylinder);
                    let degrees = float(&(cylinder.bank.degrees() - engine.pin_angle(cylinder).degrees()));
                    (way * degrees).rem_euclid(360.0)
                };
                let [lower, upper] = engine.cylinders() else { panic!("two pistons") };
                (centre(lower) - centre(upper)).rem_euclid(360.0)
            };
            assert!((between("upper") - 12.0).abs() < 1e-9, "{rotation}{sense}");
            assert!((between("lower") - 348.0).abs() < 1e-9, "{rotation}{sense}");
        }
    }
}

/// Anticlockwise as drawn: ahead where the crank turns so, behind where the drawing has it turn clockwise.
#[test]
fn a_pin_split_above_0_turns_the_pin_of_bank_2_anticlockwise_in_the_drawing() {
    for (split, rotation, ahead) in [(76, "", 76), (-76, "", -76), (76, CLOCKWISE, -76), (-76, CLOCKWISE, 76)] {
        let engine = layout(&format!("{rotation}[vee]\nbank_angle = 90\nthrows = [10]\npin_split = {split}"));
        let [one, two] = engine.cylinders() else { panic!("two") };
        let drawn = |cylinder: &Cylinder| engine.convention().as_written(&cylinder.throw);
        assert_eq!(drawn(one), Turn::fraction(10, 360), "{rotation}");
        assert_eq!(drawn(two), Turn::fraction(10 + split, 360), "{rotation}");
        // The crank turns by +θ: which pin passes a mark first?
        assert_eq!(&two.throw - &one.throw, Turn::fraction(ahead, 360), "{rotation}");
        let page =
            crate::support::pages::text(&crate::support::pages::document(&engine), crate::support::pages::DOLLARS);
        let words = if ahead > 0 {
            "the pin of 2 is 76° ahead of the pin of 1"
        } else {
            "the pin of 2 is 76° behind the pin of 1"
        };
        assert!(page.contains(words), "{rotation}{split}: {page}");
    }
}

/// A form with lists: the keys, and its cylinders in the order of the list, each with its angle as drawn and its crankshaft, as the page of
/// keys says them.
const LISTED: &[(&str, &str, &str)] = &[
    ("`[inline]`", "[inline]\nthrows = [0, 120]", "1 2"),
    ("`[vee]`", "[vee]\nbank_angle = 60\nthrows = [0, 120]", "−30: 1 2, 30: 3 4"),
    ("`[flat]`", "[flat]\nthrows = [0, 120]", "−90: 1 2, 90: 3 4"),
    ("`[boxer]`", "[boxer]\nstagger = 1\nthrows = [0, 120]", "−90: 1 2, 90: 3 4"),
    ("`[fan]`", "[fan]\nbanks = [40, -40, 0]\nthrows = [0, 120]", "40: 1 2, −40: 3 4, 0: 5 6"),
    ("`[vr]`", "[vr]\nbank_angle = 20\nthrows = [0, 120, 240]", "−10: 1, 10: 2, −10: 3"),
    ("`[w]`", "[w]\nbank_angle = 60\nnarrow_angle = 20\nthrows = [0, 120]", "−40: 1, −20: 2, 20: 3, 40: 4"),
    (
        "`[radial]`",
        "[radial]\ncylinders = 3\nrows = 2\nrow_rotation = 60\nrow_throw = 180",
        "0: 1, 120: 2, −120: 3, 60: 4, 180: 5, −60: 6",
    ),
    ("`[u]`", "[u]\nthrows = [0, 120]\nsense = 'against'\ndistance = 5", "left 0: 1 2, right 0: 3 4"),
    (
        "`[square_four]`",
        "[square_four]\nin_phase = 'sides'\nsense = 'against'\ndistance = 5",
        "left 0: 1 2, right 0: 3 4",
    ),
    (
        "`[h]`",
        "[h]\nthrows = [0, 120]\nsense = 'against'\ndistance = 5",
        "upper −90: 1 2, upper 90: 3 4, lower −90: 5 6, lower 90: 7 8",
    ),
    ("`[opposed_piston]`", "[opposed_piston]\nthrows = [0, 120]\nlead = 11", "lower 0: 1a 2a, upper 180: 1b 2b"),
    (
        "`[delta]`",
        "[delta]\nrows = [0, 120]\ncircumradius = 6",
        "A −30: 1ABe 2ABe, A 30: 1CAi 2CAi, B 90: 1BCe 2BCe, B 150: 1ABi 2ABi, C −150: 1CAe 2CAe, C −90: 1BCi 2BCi",
    ),
];

/// The cylinders of an engine in their order, as [`LISTED`] writes them.
fn listed(engine: &Engine) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (index, cylinder) in engine.cylinders().iter().enumerate() {
        let drawn = float(&engine.convention().as_written(&cylinder.bank).degrees());
        let angle = if drawn > 180.0 { drawn - 360.0 } else { drawn };
        let crank = engine.crank_of(cylinder).map_or_else(String::new, |crank| format!("{} ", crank.name));
        let head = format!("{crank}{angle}").replace('-', "−");
        let name = if cylinder.name.is_empty() { (index + 1).to_string() } else { cylinder.name.clone() };
        match groups.last_mut() {
            Some((last, names)) if *last == head => names.push(name),
            _ => groups.push((head, vec![name])),
        }
    }
    let one = |(head, names): &(String, Vec<String>)| format!("{head}: {}", names.join(" "));
    groups.iter().map(one).collect::<Vec<_>>().join(", ")
}

#[test]
fn a_list_with_one_value_per_cylinder_follows_the_order_that_the_page_of_keys_tells() {
    let page = include_str!("../../src/file/README.md");
    for (form, text, order) in LISTED {
        let engine = layout(text);
        let found = listed(&engine);
        assert_eq!(found.strip_prefix("0: ").filter(|_| *form == "`[inline]`").unwrap_or(&found), *order, "{form}");
        assert!(page.contains(&format!("| {form} |")), "{form} is not in the table of the page of keys");
        let values: Vec<String> = (1..=engine.cylinders().len()).map(|value| value.to_string()).collect();
        let weighed = layout(&format!("{text}\n[mechanism]\nreciprocating_mass = [{}]", values.join(", ")));
        for (index, cylinder) in weighed.cylinders().iter().enumerate() {
            assert_eq!(float(&cylinder.reciprocating_mass), (index + 1) as f64, "{form}");
            assert_eq!(
                (&cylinder.bank, cylinder.crank),
                (&engine.cylinders()[index].bank, engine.cylinders()[index].crank)
            );
        }
    }
    // Whichever corner is the reference.
    let delta =
        |against: &str| listed(&layout(&format!("[delta]\nrows = [0]\ncircumradius = 6\nagainst = [{against}]")));
    assert!(["", "'A'", "'B'", "'C'", "'A', 'B'"].iter().all(|against| delta(against) == delta("'A'")));
    // Banks as drawn, also where the crank turns clockwise.
    for (form, text, order) in LISTED.iter().filter(|(form, ..)| !["`[delta]`", "`[radial]`"].contains(form)) {
        let found = listed(&layout(&format!("{CLOCKWISE}{text}")));
        assert_eq!(found.strip_prefix("0: ").filter(|_| *form == "`[inline]`").unwrap_or(&found), *order, "{form}");
    }
}

/// Throws by what stands on them: crankshaft after crankshaft, pin after pin from the free end, the parts of a split pin likewise, and where
/// these stand at one place in the order of their cylinders.
#[test]
fn a_list_with_one_value_per_throw_follows_the_pins_from_the_free_end() {
    for (text, right) in [
        ("[inline]\nthrows = [0, 120]", "1, 2"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]", "1 3, 2 4"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30", "1, 3, 2, 4"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30\nbank_offset = '-1/5'", "3, 1, 4, 2"),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = [3, 4, 1, 2]\npin_split = 30", "1, 3, 2, 4"),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]", "1, 3, 2, 4"),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]\nnumbering = [2, 1, 4, 3]", "2, 4, 1, 3"),
        ("[fan]\nbanks = [-60, 0, 60]\nthrows = [0, 120]\npin_splits = [0, 0, 30]", "1 3, 5, 2 4, 6"),
        ("[h]\nthrows = [0, 180]\nsense = 'against'\ndistance = 5", "1 3, 2 4, 5 7, 6 8"),
        ("[opposed_piston]\nthrows = [0, 180]\nlead = 11", "1a, 2a, 1b, 2b"),
        ("[delta]\nrows = [0]\ncircumradius = 6", "1ABe 1CAi, 1BCe 1ABi, 1CAe 1BCi"),
        ("[delta]\nrows = [0]\ncircumradius = 6\nagainst = ['B']", "1ABe 1CAi, 1BCe 1ABi, 1CAe 1BCi"),
    ] {
        let engine = layout(text);
        let names = |index: &usize| engine.cylinders()[*index].name.clone();
        let one = |throw: &crankstar::engine::Throw| throw.cylinders.iter().map(names).collect::<Vec<_>>().join(" ");
        let all = throws(&engine);
        assert_eq!(all.iter().map(one).collect::<Vec<_>>().join(", "), right, "{text}");
        let values: Vec<String> = (1..=all.len()).map(|value| value.to_string()).collect();
        let weighed = layout(&format!("{text}\n[crankshaft]\npin_mass = [{}]", values.join(", ")));
        let masses: Vec<f64> = weighed.crankshaft().pins.iter().map(float).collect();
        assert!(masses.iter().enumerate().all(|(index, mass)| *mass == (index + 1) as f64), "{text}");
    }
}

/// The parts of a split pin stand on one disc.
#[test]
fn the_discs_of_crankpins_are_listed_pin_by_pin_a_split_one_once() {
    let torsion = "\n[torsion]\ninertias = [1, 1, 1, 1]\nstiffnesses = [1, 1, 1]\ncrankpins_at = [3, 1]";
    for (text, of_cylinders) in [
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\npin_split = 30", [3, 1, 3, 1]),
        ("[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = 'alternating'\npin_split = 30", [3, 3, 1, 1]),
        ("[boxer]\nstagger = 1\nthrows = [0, 180]", [3, 1, 3, 1]),
        ("[flat]\nthrows = [0, 180]", [3, 1, 3, 1]),
    ] {
        let engine = layout(&format!("{text}{torsion}"));
        let shaft = engine.torsion().expect("a shaft");
        let discs: Vec<usize> = engine.cylinders().iter().map(|cylinder| shaft.pins[cylinder.pin] + 1).collect();
        assert_eq!(discs, of_cylinders, "{text}");
    }
}

/// The pictures of the page of keys; `CRANKSTAR_RENEW=1 cargo test --test suite conventions` draws them anew.
#[test]
fn the_pictures_of_the_page_of_keys_are_those_of_the_program() {
    let offsets = format!("title = \"Two cranks that turn against each other, one offset\"\n{PICTURED_OFFSET}");
    let split = format!("title = \"pin_split = 76\"\n{PICTURED_SPLIT}");
    let page = include_str!("../../src/file/README.md");
    let mut files = std::collections::BTreeMap::new();
    for (name, text) in [("pin-offset", offsets), ("pin-split", split)] {
        let engine = layout(&text);
        let picture = crankstar::page::svg(&crankstar::report::end_view(&engine), engine.title().written());
        assert!(page.contains(&format!("docs/conventions/{name}.svg")), "{name}");
        files.extend([(format!("{name}.svg"), picture), (format!("{name}.toml"), text)]);
    }
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/conventions");
    crate::reports::compare(&folder, &files);
}

const PICTURED_OFFSET: &str = "[u]\nthrows = [40]\nsense = \"against\"\ndistance = \"220 mm\"\n\n[mechanism]\nstroke = \"80 mm\"\nrod_length = \"140 mm\"\npin_offset = \"10 mm\"\n";
const PICTURED_SPLIT: &str = "[vee]\nbank_angle = 90\nthrows = [-100]\npin_split = 76\n";
