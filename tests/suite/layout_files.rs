//! Does a layout file mean what a person wrote: forms, numbers, units, firing intervals, reference plane?

use crankstar::engine::{Cylinder, Engine, Form, LengthUnit};
use crankstar::exact::Turn;
use crankstar::file::find;
use crankstar::text::Untrusted;
use num_rational::BigRational;

use crate::support::written::engine as read;

fn fraction(text: &str) -> BigRational {
    text.parse().unwrap()
}

/// A file in the general form: throw, bank, position of each cylinder.
fn general(cylinders: &[(&str, &str, &str)]) -> Engine {
    let table = |(throw, bank, position): &(&str, &str, &str)| {
        format!("[[cylinder]]\nthrow = \"{throw}\"\nbank = \"{bank}\"\nposition = \"{position}\"\n")
    };
    read(&cylinders.iter().map(table).collect::<String>())
}

/// The short form comes to the same cylinders, in the same order, about the same plane; which pins they share, only the
/// short form knows (`tests/suite/crankshaft.rs`).
#[track_caller]
fn assert_same(short: &str, form: Form, cylinders: &[(&str, &str, &str)]) {
    let (short, long) = (read(short), general(cylinders));
    assert_eq!(short.form(), form);
    let on_the_pins_of_short = |(own, other): (&Cylinder, &Cylinder)| Cylinder { pin: own.pin, ..other.clone() };
    let same: Vec<Cylinder> = short.cylinders().iter().zip(long.cylinders()).map(on_the_pins_of_short).collect();
    assert_eq!((short.cylinders(), short.cylinders().len()), (same.as_slice(), long.cylinders().len()));
    assert_eq!(short.reference_plane(), long.reference_plane());
}

#[test]
fn in_line_is_throws_at_bank_0_evenly_spaced() {
    assert_same(
        "inline.throws = [0, 240, 120]",
        Form::Inline,
        &[("0", "0", "1"), ("240", "0", "0"), ("120", "0", "-1")],
    );
    assert_same("[inline]\nthrows = [0, 180]\nspacing = 3", Form::Inline, &[("0", "0", "3/2"), ("180", "0", "-3/2")]);
    assert_same(
        "[inline]\nthrows = [0, 180]\npositions = [7, -2]",
        Form::Inline,
        &[("0", "0", "7"), ("180", "0", "-2")],
    );
}

#[test]
fn in_line_throws_stand_behind_in_the_firing_order() {
    assert_same(
        "cycle = \"four-stroke\"\nfiring_order = \"1-3-2\"\n[inline]",
        Form::Inline,
        &[("0", "0", "1"), ("-480", "0", "0"), ("-240", "0", "-1")],
    );
    assert_same(
        "cycle = \"two-stroke\"\nfiring_order = [2, 1, 3]\n[inline]",
        Form::Inline,
        &[("0", "0", "1"), ("120", "0", "0"), ("-120", "0", "-1")],
    );
}

#[test]
fn vee_is_two_banks_about_the_bisector() {
    assert_same(
        "[vee]\nbank_angle = 90\nthrows = [0, 180]\npin_split = -30\nbank_offset = \"1/5\"",
        Form::Vee,
        &[("0", "-45", "6/10"), ("180", "-45", "-4/10"), ("-30", "45", "4/10"), ("150", "45", "-6/10")],
    );
    assert_same(
        "[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = \"by-pin\"",
        Form::Vee,
        &[("0", "-30", "1/2"), ("0", "30", "1/2"), ("120", "-30", "-1/2"), ("120", "30", "-1/2")],
    );
}

#[test]
fn flat_shares_pins_and_boxer_opposes_them() {
    assert_same(
        "[flat]\nthrows = [0, 180]\nbank_offset = \"1/2\"",
        Form::Flat,
        &[("0", "-90", "3/4"), ("180", "-90", "-1/4"), ("0", "90", "1/4"), ("180", "90", "-3/4")],
    );
    assert_same(
        "[boxer]\nthrows = [0, 180]\nstagger = 1",
        Form::Boxer,
        &[("0", "-90", "3/2"), ("180", "-90", "-1/2"), ("180", "90", "1/2"), ("0", "90", "-3/2")],
    );
}

#[test]
fn fan_is_any_number_of_banks() {
    assert_same(
        "[fan]\nbanks = [-60, 0, 60]\nthrows = [0]\npin_splits = [0, 10, 20]\nbank_offsets = [1, 0, -1]",
        Form::Fan,
        &[("0", "-60", "1"), ("10", "0", "0"), ("20", "60", "-1")],
    );
}

#[test]
fn radial_is_rows_of_cylinders_round_a_throw() {
    assert_same(
        "[radial]\ncylinders = 3\nrows = 2\nrow_rotation = 60\nrow_throw = 180\nrow_spacing = 4",
        Form::Radial,
        &[
            ("0", "0", "2"),
            ("0", "120", "2"),
            ("0", "240", "2"),
            ("180", "60", "-2"),
            ("180", "180", "-2"),
            ("180", "300", "-2"),
        ],
    );
}

/// One cylinder whose position is written so, quotes and all.
fn cylinder(key: &str, written: &str) -> Cylinder {
    let mut text = String::from("[[cylinder]]\n");
    for known in ["throw", "bank", "position", "reciprocating_mass"] {
        text += &format!("{known} = {}\n", if known == key { written } else { "1" });
    }
    read(&text).cylinders()[0].clone()
}

#[test]
fn numbers_are_taken_exactly_as_written() {
    let forty = "1234567890123456789012345678901234567891";
    for (written, value) in [
        ("0.1", "1/10"),
        ("\"0.1\"", "1/10"),
        (forty, forty),
        (&format!("\"{forty}\""), forty),
        (&format!("-{forty}"), &format!("-{forty}")),
        ("\"3/2\"", "3/2"),
        ("\" -2 / 6 \"", "-1/3"),
        ("\"0.5/0.75\"", "2/3"),
        ("1_000", "1000"),
        ("1_000.000_1", "10000001/10000"),
        ("1e-3", "1/1000"),
        ("2.50E+2", "250"),
        ("+7", "7"),
        ("\"−1.5\"", "-3/2"),
        ("-0.0", "0"),
        (
            "0.1000000000000000055511151231257827",
            "1000000000000000055511151231257827/10000000000000000000000000000000000",
        ),
    ] {
        assert_eq!(cylinder("position", written).position, fraction(value), "{written}");
    }
}

#[test]
fn every_unit_means_what_it_says() {
    for (written, turns) in [
        ("45", (1, 8)),
        ("\"22.5 deg\"", (1, 16)),
        ("\"22.5°\"", (1, 16)),
        ("\"30 degrees\"", (1, 12)),
        ("\"1/12 turn\"", (1, 12)),
        ("\"1/3 turns\"", (1, 3)),
        ("\"2/3 pi rad\"", (1, 3)),
        ("\"π/3 rad\"", (1, 6)),
        ("\"-pi rad\"", (1, 2)),
        ("\"1/2 π rad\"", (1, 4)),
        ("-90", (3, 4)),
        ("\"25/12turn\"", (1, 12)),
    ] {
        assert_eq!(cylinder("throw", written).throw, Turn::fraction(turns.0, turns.1), "{written}");
    }
    for (written, metres) in [
        ("\"120 mm\"", "12/100"),
        ("\"12 cm\"", "12/100"),
        ("\"0.12 m\"", "12/100"),
        ("\"10 in\"", "254/1000"),
        ("\"120mm\"", "12/100"),
    ] {
        assert_eq!(cylinder("position", written).position, fraction(metres), "{written}");
    }
    for (written, kilograms) in
        [("0.65", "65/100"), ("\"650 g\"", "65/100"), ("\"2 kg\"", "2"), ("\"1 lb\"", "45359237/100000000"), ("0", "0")]
    {
        assert_eq!(cylinder("reciprocating_mass", written).reciprocating_mass, fraction(kilograms), "{written}");
    }
}

#[test]
fn a_unit_anywhere_makes_the_layout_metric() {
    assert_eq!(read("inline.throws = [0, 0]").length_unit(), LengthUnit::Spacing);
    assert_eq!(read("[inline]\nthrows = [0, 0]\nspacing = \"1 cm\"").length_unit(), LengthUnit::Metre);
    assert_eq!(
        read("reference_plane = \"1 mm\"\n[inline]\nthrows = [0, 0]\nspacing = 0.01").length_unit(),
        LengthUnit::Metre
    );
}

#[test]
fn main_bearings_stand_where_the_file_says_in_its_order() {
    let layout = read("bearings = [0.15, '-5 cm', '1/20']\n[inline]\nthrows = [0, 120]\nspacing = 0.1");
    assert_eq!(layout.bearings(), ["3/20", "-1/20", "1/20"].map(fraction));
    assert_eq!(layout.length_unit(), LengthUnit::Metre);
    let family = "bearings = [1, 0]\nvalues = { a = '2' }\n[inline]\nthrows = [0, 120]\nspacing = 'a'";
    assert_eq!(read(family).bearings(), ["1", "0"].map(fraction));
    assert!(read("inline.throws = [0]").bearings().is_empty());
}

#[test]
fn the_reference_plane_is_the_middle_unless_given() {
    let middle = read("[inline]\nthrows = [0, 0, 0]\npositions = [5, 0, 1]");
    assert_eq!((middle.reference_plane().clone(), middle.reference_plane_given()), (fraction("5/2"), false));
    assert_eq!(middle.arm(&middle.cylinders()[1]), fraction("-5/2"));
    let given = read("reference_plane = \"-1/3\"\ninline.throws = [0]");
    assert_eq!((given.reference_plane().clone(), given.reference_plane_given()), (fraction("-1/3"), true));
    assert_eq!(given.arm(&given.cylinders()[0]), fraction("1/3"));
}

#[test]
fn the_file_may_name_its_orders_title_and_source() {
    let layout = read("title = \"Mine\"\nsource = \"a book\"\norders = [6, 1, 6, \"2\"]\ninline.throws = [0]");
    assert_eq!((layout.title().written(), layout.source().map(Untrusted::written)), ("Mine", Some("a book")));
    assert_eq!(layout.orders(), [1, 2, 6]);
    let plain = read("inline.throws = [0]");
    assert_eq!((plain.title().written(), plain.source()), ("layout.toml", None));
    assert_eq!(plain.orders(), [1, 2, 4, 6]);
}

/// Firing intervals in degrees.
fn intervals(layout: &Engine) -> Vec<BigRational> {
    let firing = layout.firing().unwrap();
    firing.intervals().iter().map(|turns| turns * fraction("360")).collect()
}

#[test]
fn firing_intervals_come_out_exactly() {
    for (name, degrees, even) in [
        ("I1", "720", true),
        ("I2-180", "180 540", false),
        ("I2-270", "450 270", false),
        ("I4", "180 180 180 180", true),
        ("I4-crossplane", "270 180 90 180", false),
        ("I6-two-stroke", "60 60 60 60 60 60", true),
        ("V2-45", "405 315", false),
        ("V6-90-split", "120 120 120 120 120 120", true),
        ("V8-crossplane", "90 90 90 90 90 90 90 90", true),
        ("radial-7", "720/7 720/7 720/7 720/7 720/7 720/7 720/7", true),
        ("radial-9", "80 80 80 80 80 80 80 80 80", true),
    ] {
        let layout = find(name).unwrap().engine().unwrap();
        let expected: Vec<BigRational> = degrees.split(' ').map(fraction).collect();
        assert_eq!(intervals(&layout), expected, "{name}");
        assert_eq!(layout.firing().unwrap().is_even(), even, "{name}");
    }
}

#[test]
fn a_two_stroke_engine_fires_at_every_top_dead_centre() {
    let together = read("cycle = \"two-stroke\"\ninline.throws = [0, 90, 90]");
    assert_eq!(intervals(&together), ["270", "0", "90"].map(fraction));
    assert!(read("cycle = \"four-stroke\"\ninline.throws = [0, 90]").firing().is_none());
}

#[test]
fn firing_order_and_firing_angles_say_the_same() {
    let file = |key: &str| {
        read(&format!("cycle = \"four-stroke\"\n{key}\ninline.throws = [0, 180, 180, 0]")).firing().cloned()
    };
    let order = file("firing_order = \"1-3-4-2\"");
    assert_eq!(order, file("firing_order = [1, 3, 4, 2]"));
    assert_eq!(order, file("firing_order = \"1, 3, 4, 2\""));
    assert_eq!(order, file("firing_angles = [0, 540, 180, 360]"));
    assert_eq!(order, file("firing_angles = [0, -180, \"1/2 turn\", 1080]"));
}
