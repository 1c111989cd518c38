//! Are claims on articulated rods answered by what is proved of them, and do pages list the lengths of links as the file writes them?

use crankstar::claim::{self, Answer, Finding, Status};
use crankstar::engine::Engine;
use crankstar::loads;
use crankstar::proof::{Vector, check_certificate};
use num_complex::Complex;

use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::written::engine as read;

/// The answer to a claim, its certificates checked.
fn checked(engine: &Engine, says: &str) -> Answer {
    let statement = claim::parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
    let answer = claim::answer(engine, &statement, None);
    for evidence in &answer.evidence {
        let vector = |t: &crankstar::exact::Term| Vector { angle: t.angle.turns().clone(), weight: t.weight.clone() };
        let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
        check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
    }
    answer
}

const NINE: &str =
    "[radial]\ncylinders = 9\n[mechanism]\nrod_ratio = '1/3.8'\n[articulated]\nmaster = 1\nknuckle_ratio = '0.9/3.8'";

#[test]
fn order_one_of_a_radial_with_a_master_rod_is_compared_by_size_and_direction() {
    let nine = read(NINE);
    for (says, expected) in [
        ("first-order force = 9/2", Status::True),
        ("first-order force = 4.6", Status::False),
        ("first-order force ≈ 4.4 ± 0.2", Status::True),
        ("first-order direct force = 9/2", Status::True),
        ("first-order direct force plane 0°", Status::True),
        ("first-order direct force plane 1°", Status::False),
        ("first-order reverse force = 0", Status::True),
        ("first-order force = 9/2 at 0°", Status::True),
        ("first-order force is rotating", Status::True),
        // It does not exist.
        ("third-order force = 0", Status::True),
        ("third-order force = 1", Status::False),
        ("third-order force is balanced", Status::True),
        ("third-order force of all masses vanishes", Status::True),
        // Several sums have no one size.
        ("second-order force = 1", Status::NotDecided),
        ("second-order force = 0", Status::False),
        ("second-order force vanishes", Status::False),
        ("every order vanishes", Status::False),
        ("every order of the moment vanishes", Status::True),
        ("no free moment", Status::True),
    ] {
        assert_eq!(checked(&nine, says).status, expected, "{says}");
    }
}

#[test]
fn order_one_of_unequal_rods_is_compared_too_and_no_order_that_does_not_exist_is_called_left() {
    let three = read("inline.throws = [0, 120, 240]\n[mechanism]\ncrank_radius = 1\nrod_length = [4, 4, 5]");
    assert_eq!(checked(&three, "first-order couple = √3").status, Status::True);
    assert_eq!(checked(&three, "second-order couple = √3").status, Status::NotDecided);
    assert_eq!(checked(&three, "third-order force = 0").status, Status::True);
    // All vectors of order 3 point the same way, before the number 0.
    let alike = read("inline.throws = [0, 120, 240]\n[mechanism]\ncrank_radius = 1\nrod_length = 4");
    for says in ["third-order force vanishes", "third-order force of all masses vanishes"] {
        assert_eq!(checked(&alike, says).status, Status::True, "{says}");
    }
    assert_eq!(checked(&alike, "first-order force of the rotating masses vanishes").status, Status::True);
}

const UNEQUAL: &str = "[mechanism]\nrod_ratio = ['1/4', '1/4', '2/7', '2/7']\n";

/// Cylinders of throw, bank and position.
fn cylinders(list: &[[i64; 3]]) -> String {
    let one = |[throw, bank, at]: &[i64; 3]| format!("[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = {at}\n");
    list.iter().map(one).collect()
}

#[test]
fn every_order_of_rods_that_differ_is_decided_as_single_orders_are() {
    // Two opposed pairs, each of one rod; a row of four with the rods of a mirrored pair alike or not; yokes with slots of several slopes.
    let pairs = cylinders(&[[0, 0, 0], [180, 180, 0], [90, 0, 1], [270, 180, 1]]);
    let row = cylinders(&[[0, 0, 0], [180, 0, 1], [180, 0, 2], [0, 0, 3]]);
    let (mirrored, crossed) = (UNEQUAL.replace("'1/4', '2/7', '2/7'", "'2/7', '2/7', '1/4'"), UNEQUAL);
    let yokes = "[mechanism]\nrod_ratio = 0\noffset_ratio = ['1/10', '1/5', '1/10', '-1/5']\n";
    let offset = "[mechanism]\nrod_ratio = '1/4'\noffset_ratio = '1/20'\n";
    let geared = "[[crankshaft]]\nname = 'A'\nsense = 'with'\n[[crankshaft]]\nname = 'B'\nsense = 'with'\nspeed = 2\n[mechanism]\nrod_ratio = '1/4'\n";
    let on = |shaft: &str, list: &[[i64; 3]]| {
        cylinders(list).replace("[[cylinder]]\n", &format!("[[cylinder]]\ncrankshaft = '{shaft}'\n"))
    };
    let opposed = [[0, 0, 0], [180, 180, 0]];
    let geared = format!("{geared}{}{}", on("A", &opposed), on("B", &opposed));
    let (yes, no, open) = (Status::True, Status::False, Status::NotDecided);
    for (text, [every, force, higher, moment, free]) in [
        (format!("{UNEQUAL}{pairs}"), [&yes, &yes, &yes, &yes, &yes]),
        (format!("{mirrored}{row}"), [&no, &no, &no, &yes, &yes]),
        (format!("{crossed}{row}"), [&no, &no, &no, &no, &open]),
        (format!("{yokes}{row}"), [&no, &no, &yes, &no, &open]),
        (format!("{yokes}{pairs}"), [&no, &no, &yes, &no, &open]),
        (format!("{offset}{pairs}"), [&yes, &yes, &yes, &yes, &yes]),
        (format!("{offset}{row}"), [&no, &no, &no, &yes, &yes]),
        (format!("inline.throws = [0, 120, 240]\n{offset}"), [&no, &no, &no, &no, &no]),
        (geared, [&yes, &yes, &yes, &yes, &yes]),
    ] {
        let engine = read(&text);
        for (says, expected) in [
            ("every order vanishes", every),
            ("every order of the force vanishes", force),
            ("every higher order of the force vanishes", higher),
            ("every order of the moment vanishes", moment),
            ("no free moment", free),
        ] {
            let answer = checked(&engine, says);
            assert_eq!(answer.status == Status::NotDecided, *expected == Status::NotDecided, "{says}: {text}");
            assert_eq!(answer.status.holds(), expected.holds(), "{says}: {text}");
        }
    }
}

/// A radial whose piston of the master weighs more, perhaps with masses at knuckle pins and at the crankpin.
fn random_radial(dice: &mut Dice) -> Engine {
    let count = 3 + dice.below(7);
    let master = dice.below(count);
    let list = |own: u64, other: u64| {
        let masses = (0..count).map(|index| if index == master { own } else { other }.to_string());
        masses.collect::<Vec<_>>().join(", ")
    };
    let piston = 1 + dice.below(4);
    read(&format!(
        "speed = 1000\n[radial]\ncylinders = {count}\n[mechanism]\ncrank_radius = '0.1 m'\nrod_length = '0.{} m'\nreciprocating_mass = [{}]\nrotating_mass = [{}]\n[articulated]\nmaster = {}\nknuckle_radius = '{} mm'\nknuckle_mass = '0.{} kg'",
        32 + dice.below(20),
        list(piston + 1 + dice.below(2), piston),
        list(dice.below(5), 0),
        master + 1,
        60 + dice.below(50),
        dice.below(10),
    ))
}

#[test]
fn random_radials_have_the_first_order_that_their_loads_have() {
    let mut dice = Dice::new(1943);
    for _ in 0..12 {
        let engine = random_radial(&mut dice);
        let loads = loads::loads(&engine, &[1]).expect("numbers");
        let first = loads.force.harmonics().iter().find(|one| one.order == 1).cloned().expect("an order");
        let newtons = loads.scale.as_ref().expect("newtons").force();
        for (sense, vector) in [("direct", first.direct), ("reverse", first.reverse)] {
            let size = vector.norm();
            for (off, expected) in [(0.0, Status::True), (0.01, Status::False)] {
                let says = format!("first-order {sense} force of all masses ≈ {:.6} ± 0.00001", size + off);
                assert_eq!(checked(&engine, &says).status, expected, "{says}");
                let says = format!("first-order {sense} force of all masses = {:.1} N ± 0.1 N", (size + off) * newtons);
                assert_eq!(checked(&engine, &says).status, expected, "{says}");
            }
            if size > 1e-6 {
                let angle = vector.arg().to_degrees();
                let says = format!("first-order {sense} force of all masses plane {angle:.4}° ± 0.001°");
                assert_eq!(checked(&engine, &says).status, Status::True, "{says}");
            }
        }
        assert!(first.direct != Complex::default());
    }
}

const LENGTHS: &str = "speed = 2000\n[radial]\ncylinders = 5\n[mechanism]\nstroke = '5.5 in'\nrod_length = '10.5 in'\nreciprocating_mass = '2 kg'\n[articulated]\nmaster = 1\nknuckle_radius = '2.4 in'";

fn page(text: &str) -> String {
    pages::text(&pages::document(&read(text)), pages::DOLLARS).replace('\u{a0}', " ")
}

#[test]
fn the_inputs_of_a_calculation_list_the_lengths_of_links_as_written() {
    let text = page(LENGTHS);
    for words in ["knuckle radius, from crankpin to knuckle pin", "2.4 in", "all links", "\\kappa", "(r/L)"] {
        assert!(text.contains(words), "{words} is not on the page");
    }
    assert!(!text.contains("no articulated rods"));
    let each = page(&format!("{LENGTHS}\nlink_length = ['8.1 in', '8 in', '8 in', '8.1 in']\nknuckle_mass = '0.4 kg'"));
    for words in [
        "8.1 in",
        "length of a link between centres",
        "mass at a knuckle pin, with the big end of its link",
        "(r/L)_{5}",
    ] {
        assert!(each.contains(words), "{words} is not on the page");
    }
    // One knuckle radius makes one line.
    assert!(each.contains("\\kappa &=") && !each.contains("\\kappa_{5}"));
    // What the file says of a link does not make the lines of the rods a line for each cylinder.
    assert!(!each.contains("r_{1}"));
}

#[test]
fn a_claim_on_a_linked_engine_shows_the_order_that_decides_it() {
    let answer = checked(&read(NINE), "first-order force = 9/2");
    assert!(matches!(answer.finding, Finding::Order(_)));
    assert!(!answer.evidence.is_empty());
}

#[test]
fn masses_beside_offset_rods_are_two_sums_of_which_vanishing_and_shape_are_decided() {
    let text = |masses: &str| {
        let rods = "rod_ratio = 0.25, offset_ratio = 0.1, reciprocating_mass = 1";
        read(&format!("inline = {{ throws = [0, 180] }}\nmechanism = {{ {rods}, rotating_mass = {masses} }}"))
    };
    let (unlike, alike) = (text("[0.5, 0.25]"), text("0.5"));
    for (engine, says, expected) in [
        (&unlike, "first-order force of all masses vanishes", Status::False),
        (&unlike, "first-order force of all masses does not vanish", Status::True),
        (&unlike, "first-order force of all masses is rotating", Status::True),
        (&unlike, "first-order force of all masses is elliptical", Status::False),
        (&unlike, "first-order direct force of all masses = 0", Status::False),
        (&unlike, "first-order reverse force of all masses = 0", Status::True),
        (&unlike, "first-order moment of all masses is elliptical", Status::True),
        (&unlike, "first-order moment of all masses = 2", Status::NotDecided),
        (&alike, "first-order force of all masses vanishes", Status::True),
        (&alike, "first-order moment of all masses vanishes", Status::False),
        (&alike, "second-order force of all masses = 2", Status::True),
    ] {
        assert_eq!(checked(engine, says).status, expected, "{says}");
    }
}
