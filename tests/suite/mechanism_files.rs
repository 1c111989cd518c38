//! Are crank, rods, masses and speed read as they are written, and every mistake in them told?

use crankstar::engine::{self, Engine, Rod};
use crankstar::file;
use num_rational::BigRational;

use crate::support::written::fraction;

fn engine(numbers: &str) -> Engine {
    file::parse("layout.toml", &text(numbers)).unwrap_or_else(|error| panic!("{error}"))
}

fn text(numbers: &str) -> String {
    format!("inline.throws = [0, 180]\n{numbers}")
}

#[test]
fn stroke_and_rod_length_give_radius_and_ratio_exactly() {
    let layout = engine("speed = '100 Hz'\n[mechanism]\nstroke = '90 mm'\nrod_length = '0.18'");
    assert_eq!(layout.dimensions().crank_radius, Some(fraction(45, 1000)));
    assert_eq!(layout.dimensions().speed, Some(fraction(6000, 1)));
    let rod = Rod { ratio: fraction(1, 4), offset: fraction(0, 1) };
    assert_eq!(layout.rods().collect::<Vec<_>>(), [&rod, &rod]);
}

#[test]
fn an_offset_is_divided_by_the_rod_length() {
    let by_length = engine("[mechanism]\ncrank_radius = '40 mm'\nrod_length = '160 mm'\npin_offset = '-3.2 mm'");
    let by_ratio = engine("[mechanism]\nrod_ratio = '1/4'\noffset_ratio = '-0.02'");
    assert!(by_length.rods().eq(by_ratio.rods()));
    assert_eq!(by_length.cylinders()[0].rod().expect("a rod").offset, fraction(-1, 50));
}

#[test]
fn a_rod_with_its_centre_of_gravity_is_split_in_two_masses_that_keep_its_mass() {
    let parts = "[mechanism]\nstroke = 1\nrod_length = 2\npiston_mass = '0.4'\npin_mass = '0.15'\nrod_mass = '0.6'\nrod_centre = '1/2'";
    let layout = engine(parts);
    // A quarter of the way from the big end: a quarter of the mass reciprocates.
    assert_eq!(layout.dimensions().mass, Some(fraction(7, 10)));
    assert!(layout.cylinders().iter().all(|cylinder| cylinder.rotating_mass == fraction(45, 100)));
    assert!(layout.cylinders().iter().all(|cylinder| cylinder.weight() == fraction(1, 1)));
}

#[test]
fn a_list_gives_each_cylinder_its_own_and_the_first_that_is_not_zero_is_the_unit() {
    let layout = engine("[mechanism]\ncrank_radius = [1, 2]\nrod_ratio = ['1/3', '1/4']\nreciprocating_mass = [0, 3]");
    let weights: Vec<BigRational> = layout.cylinders().iter().map(engine::Cylinder::weight).collect();
    assert_eq!(weights, [fraction(0, 1), fraction(2, 1)]);
    assert_eq!(
        (layout.dimensions().mass.clone(), layout.dimensions().crank_radius.clone()),
        (Some(fraction(3, 1)), Some(fraction(1, 1)))
    );
    assert_eq!(layout.cylinders()[1].rod().expect("a rod").ratio, fraction(1, 4));
}

#[test]
fn an_engine_without_masses_keeps_its_verdicts() {
    let layout = engine("[mechanism]\nreciprocating_mass = 0");
    assert_eq!(layout.dimensions().mass, Some(fraction(0, 1)));
    assert!(layout.has_unit_masses());
}

#[test]
fn the_title_block_keeps_what_was_written() {
    let block = engine("[document]\nnumber = 4711\nauthor = 'A. Person'\nassumptions = ['one']").title_block().clone();
    let rows: Vec<(&str, &str)> = block.rows.iter().map(|(name, text)| (*name, text.written())).collect();
    assert_eq!(rows, [("Document", "4711"), ("Author", "A. Person")]);
    assert_eq!(block.assumptions, ["one"]);
}

/// Mistakes: what is added to the file, the line of the whole file, words of the message.
#[rustfmt::skip]
const MISTAKES: &[(&str, usize, &str)] = &[
    ("speed = -1",                                                          2, "0 or more"),
    ("speed = 'fast'",                                                      2, "6000 rpm"),
    ("speed = '100 kmh'",                                                   2, "rpm"),
    ("effects = ['noise']",                                                 2, "`noise`"),
    ("effects = 'torque'",                                                  2, "list"),
    ("[mechanism]\nstroke = 1\ncrank_radius = 1",                           4, "both stroke and crank_radius"),
    ("[mechanism]\nstroke = 0",                                             3, "above 0"),
    ("[mechanism]\nrod_length = 1",                                         3, "without a crank radius"),
    ("[mechanism]\nstroke = 2\nrod_length = 1",                             4, "λ < 1"),
    ("[mechanism]\nrod_ratio = 1",                                          3, "cannot turn round"),
    ("[mechanism]\nrod_ratio = -0.1",                                       3, "from 0 up to 1"),
    ("[mechanism]\nrod_ratio = '0.5'\nrod_length = 1\nstroke = 1",          4, "both rod_ratio and rod_length"),
    ("[mechanism]\nrod_ratio = '0.9'\noffset_ratio = '0.1'",                3, "λ + |δ|"),
    ("[mechanism]\nrod_ratio = '0.9'\noffset_ratio = '0.0999999'",          3, "0.999999"),
    ("[mechanism]\nrod_ratio = '0.3'\noffset_ratio = '2e36/7'",             3, "λ + |δ| ≥ 10^35\n"),
    ("[mechanism]\noffset_ratio = '0.1'",                                   3, "without a rod"),
    ("[mechanism]\nrod_ratio = '0.3'\npin_offset = '1 mm'",                 4, "offset_ratio = e/l"),
    ("[mechanism]\npin_mass = 1",                                           3, "without a piston_mass"),
    ("[mechanism]\npiston_mass = 1\nrod_mass = 1",                          4, "rod_centre"),
    ("[mechanism]\npiston_mass = 1\nrod_mass = 1\nrod_centre = 1\nstroke = '0.2'\nrod_length = '0.5'", 5, "between the eyes"),
    ("[mechanism]\npiston_mass = 1\nreciprocating_mass = 1",                3, "both reciprocating_mass and piston_mass"),
    ("[mechanism]\nreciprocating_mass = '-1 g'",                            3, "0 or more"),
    ("[mechanism]\nreciprocating_mass = [1, 2, 3]",                         3, "3 values for 2 cylinders"),
    ("[mechanism]\nreciprocating_mass = [1]",                               3, "1 value for 2 cylinders"),
    ("[mechanism]\nreciprocating_mass = []",                                3, "0 values for 2 cylinders"),
    ("[mechanism]\nreciprocating_mass = true",                              3, "is in the wrong place"),
    ("[mechanism]\nreciprocating_mass = [[1], 2]",                          3, "is in the wrong place"),
    ("[mechanism]\nmass = 1",                                               3, "unknown key `mass`"),
    ("[document]\ntitle = 'x'",                                             3, "unknown key `title`"),
    ("mechanism = 3",                                                       2, "expected one table"),
];

#[test]
fn every_mistake_is_told_with_its_line() {
    for (numbers, line, words) in MISTAKES {
        let error = file::parse("layout.toml", &text(numbers)).err().unwrap_or_else(|| panic!("accepted: {numbers}"));
        let error = error.to_string();
        assert!(error.contains(words), "no {words:?} for\n{numbers}\n{error}");
        assert!(error.contains(&format!("layout.toml:{line}:")), "not in line {line}:\n{numbers}\n{error}");
    }
}

#[test]
fn masses_that_the_cylinders_give_are_not_given_again() {
    let cylinder = "[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\nreciprocating_mass = 2\n";
    let error = file::parse("x.toml", &format!("{cylinder}[mechanism]\nreciprocating_mass = 1"));
    assert!(error.expect_err("twice").to_string().contains("given twice"));
    let layout = file::parse("x.toml", &format!("{cylinder}[mechanism]\nrod_ratio = 0.25")).expect("once");
    assert_eq!(layout.dimensions().mass, Some(fraction(1, 1)));
}
