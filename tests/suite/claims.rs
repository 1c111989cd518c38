//! Are claims answered rightly, and is every answer proved?

use crankstar::claim::{Answer, Finding, Status, answer, parse_statement};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::proof::{Vector, check_certificate};

use crate::support::dice::Dice;

fn status(engine: &str, says: &str) -> Status {
    let layout = file::find(engine).expect("an engine").engine().expect("reads");
    let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
    let answer = answer(&layout, &statement, None);
    for evidence in &answer.evidence {
        let vector = |t: &crankstar::exact::Term| Vector { angle: t.angle.turns().clone(), weight: t.weight.clone() };
        let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
        check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
    }
    answer.status
}

#[test]
fn claims_are_answered() {
    let cases = [
        ("I4", "fourth-order force vanishes", "False"),
        ("I4", "order 2 force = 4", "True"),
        ("I3", "first-order couple = √3", "True"),
        ("I3", "first-order couple = 1.732", "TrueAsRounded"),
        ("I3", "first-order couple = 1.742", "False"),
        ("I2-270", "second-order moments vanish", "False"),
        ("I2-270", "every higher order vanishes", "False"),
        ("I5-15234", "second-order force vanishes", "True"),
        ("I5-12453", "first-order couple = ½√(50 − 22√5)", "True"),
        ("V8-crossplane", "first-order direct moment plane -18.43° ± 0.01°", "True"),
        ("V8-crossplane", "first-order moment = √10 at −arctan(1/3)", "True"),
        ("V8-crossplane", "first-order moment is rotating", "True"),
        ("V8-flatplane", "second-order moment vanishes", "TrueOnlyIf"),
        ("V6-60-shared", "first-order moment = 3√3/2", "True"),
        ("V6-60-shared", "first-order moment is planar", "False"),
        ("V10-72", "no free moment", "False"),
        ("boxer-2", "every order of the force vanishes", "True"),
        ("boxer-2", "no free moment", "False"),
        ("radial-4", "every higher order of the force vanishes", "True"),
        ("I6", "every order vanishes", "False"),
        ("I6", "no free moment", "True"),
        ("I6", "every order of the moment vanishes", "TrueOnlyIf"),
        ("I4", "no free moment", "True"),
        ("I1", "no free moment", "True"),
        ("I2-180", "no free moment", "False"),
        ("I2-360", "no free moment", "True"),
        ("radial-9", "no free moment", "True"),
        ("I5-12453", "no free moment", "False"),
        ("I8-242", "orders 1 and 2 vanish", "True"),
        ("I8-44", "fires evenly", "NotDecided"),
        ("I2-180", "fires evenly", "False"),
        // As a two-stroke engine it does, as a four-stroke one it does not.
        ("V6-60-shared", "does not fire evenly", "NotDecided"),
        ("I2-270", "fires evenly", "False"),
        // Decimals that no float tells apart.
        ("I4", "second-order force = 3.9999999999999999", "False"),
        ("I4", "second-order force ≈ 4.0000000000000001 ± 0", "False"),
        ("I4", "second-order force ≈ 3.9 ± 0.1", "True"),
        ("I4", "second-order force ≈ 3.9 ± 0.0999999999999999999", "False"),
        ("I3", "first-order couple = 1.73205080756887729", "TrueAsRounded"),
        ("I3", "first-order couple = 1.73205080756887730", "False"),
        ("V2-60", "first-order reverse force ≈ 0 ± 0.5", "True"),
        ("V8-crossplane", "first-order moment = √10 at -18.4349488229220106°", "TrueAsRounded"),
        ("V8-crossplane", "first-order moment = √10 at -18.4349488229220107°", "False"),
    ];
    for (engine, says, expected) in cases {
        let found = format!("{:?}", status(engine, says));
        assert_eq!(found.split([' ', '{']).next(), Some(expected), "{engine}: {says}: {found}");
    }
}

fn written(text: &str) -> Engine {
    file::parse("layout.toml", text).expect("it reads")
}

/// The answer to a claim, its certificates checked.
fn checked(layout: &Engine, says: &str) -> Answer {
    let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
    let answer = answer(layout, &statement, None);
    for evidence in &answer.evidence {
        let vector = |t: &crankstar::exact::Term| Vector { angle: t.angle.turns().clone(), weight: t.weight.clone() };
        let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
        check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
    }
    answer
}

#[test]
fn a_half_order_without_its_torque_is_told_that_it_is_of_the_gas_torque() {
    for says in ["order 1/2 vanishes", "orders 1/2 and 1 vanish", "order 1/2 needs nothing"] {
        let mistake = parse_statement(says).expect_err(says);
        assert_eq!(mistake.message, "`1/2` is not an order");
        assert!(mistake.right.contains("half orders are of the gas torque"), "{says}: {}", mistake.right);
    }
    assert!(parse_statement("order 1/2 of the gas torque vanishes").is_ok());
}

/// All on one crankpin, whose force acts off the reference plane; two on pins of their own, whose couple turns.
#[test]
fn a_moment_is_free_where_no_plane_takes_it_away_wherever_moments_are_taken_about() {
    for plane in ["-3", "0", "1/7", "12"] {
        let single = |rest: &str| written(&format!("reference_plane = \"{plane}\"\n{rest}"));
        let one_force = [
            "inline.throws = [0]\n",
            "inline.throws = [40, 40, 40]\n",
            "inline.throws = [0, 180, 180, 0]\n",
            "vee = { bank_angle = 70, throws = [0] }\n",
        ];
        for text in one_force {
            assert!(checked(&single(text), "no free moment").status.holds(), "{plane}: {text}");
        }
        for text in ["inline.throws = [0, 90]\n", "inline.throws = [0, 180]\n", "inline.throws = [0, 120, 250]\n"] {
            assert_eq!(checked(&single(text), "no free moment").status, Status::False, "{plane}: {text}");
        }
    }
}

const NUMBERS: &str = "speed = 1000\n[mechanism]\ncrank_radius = \"50 mm\"\nrod_ratio = 0.25\nreciprocating_mass = 1\nrotating_mass = 1\n";

#[test]
fn what_counterweights_can_do_is_answered_with_the_counterweights() {
    let three = written(&format!("inline = {{ throws = [0, 120, 240], spacing = \"0.1 m\" }}\n{NUMBERS}"));
    let can = |rest: &str| checked(&three, &format!("counterweights at {rest}"));
    // 4.5 kg at the throws; a couple of √3 · 1.5 kg · 0.1 m takes two of √3 · 0.75 kg at ±0.1 m, 2.598 kg together.
    for (rest, expected) in [
        ("0.1 m and -0.1 m can balance the direct first-order force and moment", Status::True),
        ("0.1 m and −0.1 m can balance the direct first-order moment", Status::True),
        (
            "0.1 m and -0.1 m can balance the direct first-order force and moment with a crankshaft lighter than 7.0981 kg",
            Status::True,
        ),
        (
            "0.1 m and -0.1 m can balance the direct first-order force and moment with a crankshaft lighter than 7.098 kg",
            Status::False,
        ),
        (
            "100 mm and 20 mm can balance the direct first-order force and moment with a crankshaft lighter than 7.1 kg",
            Status::False,
        ),
        // Another couple might: one of these planes is nearer to the middle.
        (
            "100 mm and 20 mm can balance the direct first-order moment with a crankshaft lighter than 7.1 kg",
            Status::NotDecided,
        ),
        ("0 can balance the direct first-order force and moment", Status::False),
    ] {
        let answer = can(rest);
        assert_eq!(answer.status, expected, "{rest}");
        assert!(matches!(answer.finding, Finding::Witness(_)), "{rest}");
    }
    for wrong in [
        "counterweights at 1 and 1 can balance the direct first-order moment",
        "counterweights at 1, 2 can balance the direct first-order moment",
        "counterweights at 0 can balance the direct first-order moment",
        "counterweights at 1 and -1 can balance the second-order moment",
        "counterweights at 1 and -1 can balance the direct first-order moment with a crankshaft lighter than a feather",
        "counterweights at 1 and 2 and 3 can balance the direct first-order force and moment",
    ] {
        assert!(parse_statement(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn any_engine_without_pin_offset_can_have_its_direct_first_order_balanced_in_two_planes() {
    let mut dice = Dice::new(20_261_121);
    for _ in 0..200 {
        let throws: Vec<String> = (0..dice.below(6) + 1).map(|_| dice.below(360).to_string()).collect();
        let (bank, offset) = (dice.below(180) + 1, dice.below(3));
        let forms = [
            format!("inline.throws = [{}]\n", throws.join(", ")),
            format!(
                "vee = {{ bank_angle = {bank}, throws = [{}], bank_offset = \"{offset}/10\" }}\n",
                throws.join(", ")
            ),
        ];
        for text in forms {
            let answer = checked(
                &written(&text),
                "counterweights at 2 and -1/3 can balance the direct first-order force and moment",
            );
            assert_eq!(answer.status, Status::True, "{text}");
        }
    }
}

#[test]
fn one_cylinder_fires_evenly_in_whichever_cycle() {
    let single = written("inline = { throws = [0] }");
    assert_eq!(checked(&single, "fires evenly").status, Status::True);
    assert_eq!(checked(&single, "does not fire evenly").status, Status::False);
}
