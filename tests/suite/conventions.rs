//! Does a file mean what its page of keys says? Throws, offsets, leads and splits, in every form.
//!
//! The model knows nothing of equivalent cranks: pins, cylinder axes and rods stand in the plane of the drawing, as the page of keys
//! places them, and the rod's fixed length gives the piston's place.

use std::f64::consts::TAU;

use crankstar::engine::{Cylinder, Engine};
use crankstar::exact::Turn;
use crankstar::loads::loads_at;
use crankstar::proof::Sense;
use num_complex::Complex;

use crate::support::written::{engine as layout, float};

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

/// The pictures of the page of keys; `CRANKSTAR_RENEW=1 cargo test --test suite conventions` draws them anew.
#[test]
fn the_pictures_of_the_page_of_keys_are_those_of_the_program() {
    let offsets = format!("title = \"Two cranks that turn against each other, one offset\"\n{PICTURED_OFFSET}");
    let split = format!("title = \"pin_split = 76\"\n{PICTURED_SPLIT}");
    let page = include_str!("../../src/kernel/file/README.md");
    let mut files = std::collections::BTreeMap::new();
    for (name, text) in [("pin-offset", offsets), ("pin-split", split)] {
        let engine = layout(&text);
        let picture = crankstar::page::svg(&crankstar::report::end_view(&engine), engine.title().written());
        assert!(page.contains(&format!("docs/conventions/{name}.svg")), "{name}");
        files.extend([(format!("{name}.svg"), picture), (format!("{name}.toml"), text)]);
    }
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/conventions");
    crate::support::golden::compare_all(&folder, &files);
}

const PICTURED_OFFSET: &str = "[u]\nthrows = [40]\nsense = \"against\"\ndistance = \"220 mm\"\n\n[mechanism]\nstroke = \"80 mm\"\nrod_length = \"140 mm\"\npin_offset = \"10 mm\"\n";
const PICTURED_SPLIT: &str = "[vee]\nbank_angle = 90\nthrows = [-100]\npin_split = 76\n";
