//! Are formulas about the forces of one cylinder answered rightly, and largest loads with gas?

use crankstar::claim::{Finding, Statement, Status, answer, parse_statement};
use crankstar::engine::Engine;
use crankstar::file::parse;
use crankstar::journal::cycle_loads;

use crate::journal::four;
use crate::support::dice::Dice;

fn status(engine: &Engine, says: &str) -> Status {
    let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
    answer(engine, &statement, None).status
}

/// One cylinder of random sizes with gas.
fn cylinder(dice: &mut Dice) -> Engine {
    let (stroke, offset) = (60 + dice.below(60), dice.below(3) * 4);
    let text = format!(
        "cycle = 'four-stroke'\nspeed = {}\n[inline]\nthrows = [0]\nspacing = '0.1 m'\n[mechanism]\nstroke = '{stroke} mm'\nrod_length = '{} mm'\n\
         pin_offset = '{offset} mm'\nreciprocating_mass = '{} g'\nrotating_mass = '{} g'\n[gas]\nbore = '{} mm'\ncrankcase = '1 bar'\n\
         dead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nheat = '1000 J'\n",
        500 + dice.below(6000),
        stroke + dice.below(100),
        200 + dice.below(900),
        100 + dice.below(900),
        60 + dice.below(60),
    );
    parse("cylinder.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

const TRUE: [&str; 17] = [
    "sine of the rod angle = λ sin θ − δ",
    "piston displacement = (L + r) √(1 − (δ/(1 + λ))²) − L cos β − r cos θ",
    "piston velocity = omega r [sin theta + cos theta (lambda sin theta - delta) / sqrt(1 - (lambda sin theta - delta)^2)]",
    "piston acceleration = −F_ALT/m_ALT",
    "gas force = (p − p_0) π D² / 4",
    "inertia force = F − F_g",
    "centrifugal force = m_ROT ω² r",
    "piston effort = F_g + F_ALT",
    "Side force = F tan β",
    "side force = F_b·sin β",
    "rod force = F/cos β",
    "radial force = F/cos β · cos(θ + β)",
    "crank effort = F (sin θ + cos θ tan β)",
    "force on the frame along the axis = −F_ALT + F_ROT cos θ",
    "force on the frame across the axis = F_ROT sin θ",
    "cylinder torque = F_t r",
    "reaction torque = F_L h + δ L F_g",
];

const FALSE: [&str; 8] = [
    "sine of the rod angle = λ cos θ",
    "side force = F sin β",
    "side force = -F tan β",
    "rod force = F cos β",
    "force on the frame along the axis = F_ALT + F_ROT cos θ",
    "radial force = F cos(θ + β)",
    "cylinder torque = F r sin θ",
    "gas force = p π D² / 4",
];

#[test]
fn the_formulas_of_the_slider_crank_hold_of_random_cylinders_and_wrong_ones_do_not() {
    let mut dice = Dice::new(2300);
    for _ in 0..12 {
        let engine = cylinder(&mut dice);
        for says in TRUE {
            assert_eq!(status(&engine, says), Status::True, "{says}\n{}", engine.file().written());
        }
        for says in FALSE {
            assert_eq!(status(&engine, says), Status::False, "{says}\n{}", engine.file().written());
        }
        // Far off on one side, within on the other.
        assert_eq!(status(&engine, "cylinder torque ≈ F r (sin θ + λ/2 sin 2θ) ± 40 %"), Status::True);
        assert_eq!(status(&engine, "piston velocity ≈ ω r sin θ ± 1 %"), Status::False);
    }
}

#[test]
fn a_formula_is_read_as_on_paper() {
    let engine = cylinder(&mut Dice::new(2301));
    let equal = [
        ("2 sin² θ", "1 − cos 2θ"),
        ("2 sin θ cos θ", "sin 2θ"),
        ("sin(θ + β)", "sin θ cos β + cos θ sin β"),
        ("−r^2", "0 − r²"),
        ("6/2·3", "9"),
        ("1/2 r", "r/2"),
        ("√(r²)", "r"),
        ("[r (1 + λ)] / (1 + λ)", "r"),
        ("tan β cos β", "sin β"),
        ("2 π r", "2 r pi"),
    ];
    for (one, other) in equal {
        assert_eq!(status(&engine, &format!("rod length = L + ({one}) − ({other})")), Status::True, "{one} = {other}");
    }
    assert_eq!(status(&engine, "rod length = L + r^2 − r^3"), Status::False);
}

#[test]
fn what_is_no_formula_is_told_and_nothing_panics() {
    for (says, word) in [
        ("side force = F tan", "ends too early"),
        ("side force = F tan β)", "cannot read the formula at `)`"),
        ("side force = (F tan β", "not closed"),
        ("side force = F × β", "not a letter"),
        ("side force = Q", "not a letter"),
        ("side force ≈ F", "not a formula that can be checked"),
        ("side force ≈ F ± 3", "not a part of the largest value"),
        ("side force is large", "not a formula that can be checked"),
        ("side force = r^5", "exponent"),
        ("side force", "not a formula that can be checked"),
        ("rod length = 146 mm", "`146 mm` has a unit"),
        ("piston displacement = 0.1 m", "`0.1 m` has a unit"),
        ("largest side force with gas = 3", "in N"),
        ("largest side force with gas = 3 N·m", "another quantity"),
        ("largest rod force with gas is 3 N", "not understood"),
    ] {
        let mistake = parse_statement(says).expect_err(says);
        assert!(mistake.message.contains(word), "{says}: {}", mistake.message);
    }
    assert!(parse_statement(&format!("side force = {}r{}", "(".repeat(5000), ")".repeat(5000))).is_err());
    let pieces =
        ["(", ")", "√", "sin", "r", "F_b", "2", ".", "²", "^", "/", "−", "·", "β", "θ", " ", "é", "F", "%", "±"];
    let (mut dice, engine) = (Dice::new(2302), cylinder(&mut Dice::new(2303)));
    for _ in 0..3000 {
        let count = 1 + dice.below(12);
        let text: String = (0..count).map(|_| pieces[dice.below(pieces.len() as u64) as usize]).collect();
        if let Ok(statement @ Statement::Formula(_)) = parse_statement(&format!("side force = {text}")) {
            // Whatever it says is answered.
            let _ = answer(&engine, &statement, None);
        }
    }
}

#[test]
fn without_gas_or_masses_or_a_value_nothing_is_decided() {
    let engine = |text: &str| parse("some.toml", text).expect("a layout");
    for text in ["[inline]\nthrows = [0]", "cycle = 'four-stroke'\n[inline]\nthrows = [0, 180]"] {
        for says in ["side force = F tan β", "largest main-bearing load with gas = 5 N"] {
            assert_eq!(status(&engine(text), says), Status::NotDecided, "{says}");
        }
    }
    let one = cylinder(&mut Dice::new(2304));
    assert_eq!(status(&one, "side force = F / (r − r)"), Status::NotDecided);
    assert_eq!(status(&one, "largest main-bearing load with gas = 5 N"), Status::NotDecided);
}

#[test]
fn largest_loads_with_gas_are_those_of_the_bearings_page() {
    let engine = parse("four.toml", &four()).expect("a layout");
    let loads = cycle_loads(&engine).expect("loads");
    let [bearings, _] = loads.bearings.as_ref().expect("bearings");
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let peaks = || loads.cylinders.iter().map(|cylinder| &cylinder.peaks);
    for (what, value) in [
        ("main-bearing load", bearings.bearings[bearings.worst[0]].peak.value),
        ("crankpin load", most(&mut peaks().map(|peaks| peaks.pin.value))),
        ("rod force", most(&mut peaks().map(|peaks| peaks.rod[0].value))),
        ("side force", most(&mut peaks().map(|peaks| peaks.side[0].value.max(-peaks.side[1].value)))),
    ] {
        let says = |value: f64| format!("largest {what} with gas ≈ {value:.1} N");
        assert_eq!(status(&engine, &says(value)), Status::True, "{what}");
        assert_eq!(status(&engine, &says(value + 1.0)), Status::False, "{what}");
        let statement = parse_statement(&says(value)).expect("a claim");
        let Finding::Largest(found) = answer(&engine, &statement, None).finding else { panic!("{what}") };
        assert!((found.peak.value - value).abs() < 1e-12 * value, "{what}: {} is not {value}", found.peak.value);
    }
}

#[test]
fn what_moves_needs_no_gas_and_what_the_gas_moves_asks_for_it() {
    let cold = "speed = 3000\n[inline]\nthrows = [0]\n[mechanism]\ncrank_radius = 0.05\nrod_ratio = 0.3\n";
    let masses = "reciprocating_mass = 0.5\nrotating_mass = 0.2\n";
    let answered = |layout: &str, says: &str| {
        let engine = parse("cold.toml", layout).expect("it reads");
        let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
        answer(&engine, &statement, None)
    };
    for (says, holds) in [
        ("piston acceleration = ω² r (cos θ + λ cos 2θ)", false),
        ("piston acceleration ≈ ω² r (cos θ + λ cos 2θ) ± 2 %", true),
        ("piston displacement = r + L − h", true),
        ("piston velocity = ω r (sin θ + λ sin θ cos θ/√(1 − λ² sin² θ))", true),
        ("sine of the rod angle = λ sin θ", true),
        ("rod length = r/λ", true),
    ] {
        let found = answered(cold, says);
        assert_eq!(found.status, if holds { Status::True } else { Status::False }, "{says}: {found:?}");
    }
    let heavy = format!("{cold}{masses}");
    for says in ["inertia force = −m r ω² (cos θ)", "centrifugal force = m_ROT r ω²", "reciprocating mass = m_ALT"]
    {
        let found = answered(&heavy, says);
        assert!(matches!(found.status, Status::True | Status::False), "{says}: {found:?}");
        let bare = answered(cold, says);
        assert!(format!("{bare:?}").contains("masses"), "{says}: {bare:?}");
    }
    for says in ["piston effort = F", "piston acceleration = F_g/m", "gas force = 0"] {
        let found = answered(&heavy, says);
        assert!(!matches!(found.status, Status::True | Status::False), "{says}: {found:?}");
        assert!(format!("{found:?}").contains("[gas]"), "{says}: {found:?}");
    }
    // Without a speed there is no acceleration, but a way.
    let still = cold.replace("speed = 3000\n", "");
    assert_eq!(answered(&still, "piston displacement = r + L − h").status, Status::True);
    assert!(format!("{:?}", answered(&still, "piston velocity = ω r")).contains("speed"));
}
