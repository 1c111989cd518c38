//! Are claims in newtons, on torques and on unequal rods answered by what decides them?

use crankstar::claim::{self, Condition, Status};
use crankstar::engine::{Engine, Rod};
use crankstar::{file, loads};
use num_rational::BigRational;
use num_traits::Zero;

fn status(layout: &Engine, says: &str) -> Status {
    claim::answer(layout, &claim::parse_statement(says).unwrap_or_else(|_| panic!("not read: {says}")), None).status
}

/// A flat four that leaves a sixth-order couple of 0.2418 N·m.
fn flat_four() -> Engine {
    file::parse("layout.toml", include_str!("../../reports/examples/boxer-4-ej25/layout.toml")).expect("it reads")
}

#[test]
fn newtons_that_are_left_are_not_nothing_and_nothing_is_no_newtons() {
    assert_eq!(status(&flat_four(), "sixth-order moment = 0 N·m"), Status::False);
    assert_eq!(status(&flat_four(), "sixth-order moment = 0.24 N·m"), Status::True);
    assert_eq!(status(&flat_four(), "sixth-order force = 0 N"), Status::True);
    assert_eq!(status(&flat_four(), "sixth-order force = 1 N"), Status::False);
}

#[test]
fn newtons_are_not_compared_with_fractions_and_roots() {
    for says in ["sixth-order moment = 1/5 N·m", "sixth-order moment = √2/2 N·m"] {
        assert!(!matches!(status(&flat_four(), says), Status::True | Status::False), "{says}");
    }
}

#[test]
fn no_claim_on_every_order_of_the_torque_is_called_true() {
    let four = file::find("I4").expect("known").engine().expect("reads");
    for says in ["every order of the torque vanishes", "orders 2 and 4 of the torque vanish"] {
        assert!(!matches!(status(&four, says), Status::True), "{says}");
    }
    assert_eq!(status(&four, "second-order torque vanishes"), Status::False);
    // The forces of these orders vanish, the torque of order 3 does not.
    let six =
        "inline.throws = [0, 120, 240, 240, 120, 0]\n[mechanism]\ncrank_radius = 1\nrod_length = [4, 4, 4, 5, 5, 5]\n";
    let six = file::parse("x.toml", six).expect("it reads");
    assert_eq!(status(&six, "orders 1 and 3 of the force vanish"), Status::True);
    assert!(!matches!(status(&six, "orders 1 and 3 of the torque vanish"), Status::True));
}

#[test]
fn orders_of_unequal_rods_are_decided_by_all_of_their_classes_together() {
    let text = "[inline]\nthrows = [0, 120, 240, 240, 120, 0]\n[mechanism]\ncrank_radius = 1\nrod_length = [4, 4, 5, 5, 4, 4]\n";
    let six = file::parse("x.toml", text).expect("it reads");
    // Two cylinders with the longer rod leave what four with the shorter one do not take away; without the rods all cancels.
    assert_eq!(status(&six, "second-order force vanishes"), Status::False);
    assert_eq!(status(&six, "first-order force vanishes"), Status::True);
    assert_eq!(status(&six, "orders 1 and 3 of the force vanish"), Status::True);
    // No single number but 0 is the size of several sums.
    assert_eq!(status(&six, "second-order force = 0"), Status::False);
    assert_eq!(status(&six, "second-order force = 1"), Status::NotDecided);
}

#[test]
fn forces_beyond_the_decimals_are_refused_with_words() {
    let text = "speed = 1e99\ninline.throws = [0]\n[mechanism]\ncrank_radius = 1e99\nrod_ratio = 0.25\nreciprocating_mass = 1e99\n";
    let refused = file::parse("x.toml", text).expect_err("refused").to_string();
    assert!(refused.contains("between 10^-40 and 10^40"), "{refused}");
    let largest = text.replace("1e99", "1e30");
    let loads = crankstar::loads::loads(&file::parse("x.toml", &largest).expect("it reads"), &[1, 2]).expect("numbers");
    assert!(loads.scale.expect("newtons").force().is_finite());
}

#[test]
fn kilonewtons_are_a_thousand_newtons_with_their_digits_and_tolerances() {
    // The couple is 0.24183… N·m.
    for (says, wanted) in [
        ("sixth-order moment = 0.00024 kN·m", Status::True),
        ("sixth-order moment ≈ 0.00024 kN m", Status::True),
        ("sixth-order moment ≈ 0.00025 kNm", Status::False),
        ("sixth-order moment = 0.0003 kN·m ± 0.0001", Status::True),
        ("sixth-order moment = 0.0003 kN·m ± 0.0001 kN·m", Status::True),
        ("sixth-order moment = 0.0003 kN·m ± 0.01 N·m", Status::False),
        ("sixth-order moment = 0.00025 kN·m ± 5 %", Status::True),
        ("sixth-order moment = 0.24 kN·m", Status::False),
        ("sixth-order force = 0 kN", Status::True),
    ] {
        assert_eq!(status(&flat_four(), says), wanted, "{says}");
    }
    assert!(claim::parse_statement("sixth-order moment = 1 kN").is_err());
    // A whole number of kilonewtons is a rounded one.
    for (says, wanted) in [("F2 = 11 kN", Status::True), ("F2 = 12 kN", Status::False)] {
        assert_eq!(status(&in_line_four(), says), wanted, "{says}");
    }
}

#[test]
fn an_engine_at_rest_has_no_newtons_and_a_crank_that_turns_alone_has_its_own() {
    let single =
        "inline.throws = [0]\n[mechanism]\nstroke = '80 mm'\nrod_length = '150 mm'\nreciprocating_mass = '0.5 kg'\n";
    let at = |speed: &str| file::parse("single.toml", &format!("speed = {speed}\n{single}")).expect("it reads");
    assert_eq!(status(&at("0"), "first-order force = 0 N"), Status::True);
    assert_eq!(status(&at("1"), "first-order force = 0 N"), Status::False);
    // Order 1 is that of the slow crankshaft alone.
    let rods = single.split_once('\n').expect("two parts").1;
    let geared = format!(
        "speed = 1000\n[[crankshaft]]\nname = 'A'\nsense = 'with'\n[[crankshaft]]\nname = 'B'\nsense = 'against'\nspeed = 2\n{rods}\
         [[cylinder]]\ncrankshaft = 'A'\nthrow = 0\nbank = 0\nposition = 0\n[[cylinder]]\ncrankshaft = 'B'\nthrow = 0\nbank = 0\nposition = 0\n"
    );
    let geared = file::parse("geared.toml", &geared).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(status(&geared, "first-order force = 219.3 N"), Status::True);
    assert_eq!(status(&geared, "first-order force = 1"), Status::True);
    assert_eq!(status(&geared, "second-order force = 1"), Status::NotDecided);
}

/// Four in line whose second-order force is 11248 N along 0°, 10999 N by the first term of c_2.
fn in_line_four() -> Engine {
    let text = "speed = 6000\nbearings = ['-190 mm', '190 mm']\ninline = { throws = [0, 180, 180, 0], spacing = '96 mm' }\n\
                [mechanism]\nstroke = '86 mm'\nrod_length = '146 mm'\nreciprocating_mass = '0.55 kg'\n";
    file::parse("four.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn catalogued(name: &str) -> Engine {
    file::find(name).expect("known").engine().expect("reads")
}

/// Holds only as textbooks take c_k.
fn by_the_first_term() -> Status {
    Status::TrueOnlyIf { conditions: vec![Condition::FirstTermAlone], met: true }
}

#[track_caller]
fn refused(says: &str) {
    let told = claim::parse_statement(says).expect_err(says);
    assert!(!told.message.is_empty() && !told.right.is_empty(), "{says}");
}

#[test]
fn a_direction_beside_newtons_is_compared_too() {
    for (says, wanted) in [
        ("second-order force = 11248 N at 0°", Status::True),
        ("second-order force = 11248 N at 180° ± 1°", Status::True),
        ("second-order force = 11248 N at 90°", Status::False),
        ("second-order force = 11.2 kN at 1° ± 0.5°", Status::False),
        ("second-order direct force = 5624 N ± 1 % at 33°", Status::False),
        ("second-order direct force = 5624 N ± 1 % at 0°", Status::True),
        ("second-order force = 10999 N at 0°", by_the_first_term()),
        ("second-order force = 10999 N at 10°", Status::False),
        // Nothing points nowhere.
        ("first-order force = 0 N at 10°", Status::False),
        ("third-order force = 0 N at 10°", Status::False),
    ] {
        assert_eq!(status(&in_line_four(), says), wanted, "{says}");
    }
}

#[test]
fn newtons_of_the_first_term_alone_hold_only_if_it_is_taken_alone() {
    for (says, wanted) in [
        ("second-order force = 11248 N", Status::True),
        ("second-order force = 10999 N", by_the_first_term()),
        ("second-order force ≈ 11.0 kN", by_the_first_term()),
        // Both are within these.
        ("second-order force = 11000 N ± 5 %", Status::True),
        ("second-order force = 11123 N", Status::False),
    ] {
        assert_eq!(status(&in_line_four(), says), wanted, "{says}");
    }
    let statement = claim::parse_statement("second-order force = 10999 N").expect("a claim");
    let told = crankstar::report::claim_status(&claim::answer(&in_line_four(), &statement, None));
    let told = crankstar::page::text_in(&told, crankstar::page::Format::PLAIN);
    assert!(told.contains("first term"), "{told}");
}

#[test]
fn a_unit_behind_a_tolerance_alone_is_that_of_the_value() {
    for (says, wanted) in [
        ("second-order force = 100 ± 1 kN", Status::False),
        ("F2 = 20 ± 1 kN", Status::False),
        ("F2 = 11 ± 1 kN", Status::True),
        ("second-order force = 11248 ± 10 N", Status::True),
        ("second-order force = 11 kN ± 300 N", Status::True),
        ("largest main-bearing load = 10 ± 1 kN", Status::False),
        ("second-order force plane 1 ± 2°", Status::True),
        ("second-order force plane 0.1 ± 0.05 turn", Status::False),
    ] {
        assert_eq!(status(&in_line_four(), says), wanted, "{says}");
    }
    for says in [
        "second-order force = 5 N ± 12 kN·m",
        "second-order force = 5 ± 12 kN·m",
        "second-order moment = 5 N·m ± 12 N",
        "second-order force plane 30° ± 1 kN",
        "second-order force plane 30° ± 1 %",
        "second-order force plane 30° ± -1°",
        "second-order force = 11 kN ± 0.1 m r ω² c_2",
        "second-order moment = 5 N·m ± 0.1 a",
        "second-order force = 11 kN ± 3 kN %",
        "crankshaft mass = 4 kg ± 1 kN",
        "crankshaft mass = 4",
        "largest main-bearing load = 10 kN ± 1 N·m",
    ] {
        refused(says);
    }
    assert_eq!(
        claim::parse_statement("crankshaft mass = 4.08 ± 0.01 kg"),
        claim::parse_statement("crankshaft mass = 4.08 kg ± 0.01 kg")
    );
}

#[test]
fn a_moment_in_a_counts_the_spacing_whatever_the_positions_are_in() {
    let two = |positions: &str| {
        let text = format!(
            "inline = {{ throws = [0, 180], {positions} }}\n[mechanism]\ncrank_radius = '40 mm'\nreciprocating_mass = ['2 kg', '1 kg']\n"
        );
        file::parse("two.toml", &text).unwrap_or_else(|error| panic!("{error}"))
    };
    // In metres where nothing is said, 0.075 m of 0.1 m.
    for (says, wanted) in [
        ("first-order moment = 0.75 m r ω² a", Status::True),
        ("first-order moment = 0.075 m r ω² a", Status::False),
        ("first-order moment = 3/4 a", Status::True),
        ("M1 ≈ 0.7 ± 0.06 a", Status::True),
        ("M1 ≈ 0.7 a ± 0.04", Status::False),
        ("M1 = 0.8 a", Status::TrueAsRounded),
        ("first-order moment = 0.075", Status::True),
        ("first-order moment = 0.075 m r ω²", Status::True),
        ("first-order moment = 0.75", Status::False),
    ] {
        assert_eq!(status(&two("spacing = '100 mm'"), says), wanted, "{says}");
    }
    for says in ["first-order moment = 0.75 a", "first-order moment = 0.75"] {
        assert_eq!(status(&two("spacing = 1"), says), Status::True, "{says}");
    }
    // Three that are not equally far apart have no a.
    let text = "inline = { throws = [0, 120, 240], positions = ['0 mm', '100 mm', '250 mm'] }";
    let uneven = file::parse("three.toml", text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(status(&uneven, "first-order moment = 1.732 a"), Status::NotDecided);
}

#[test]
fn zero_is_no_rounding_of_what_is_left() {
    let five = catalogued("I5-12453");
    for says in ["M1 = 0", "M1 = 0.0", "M1 = 0.0 a", "first-order moment ≈ 0", "first-order moment ≈ 0.0"] {
        assert_eq!(status(&five, says), Status::False, "{says}");
    }
    for says in ["second-order force = 0 N", "second-order force ≈ 0 N", "second-order force = 0.0 kN"] {
        assert_eq!(status(&in_line_four(), says), Status::False, "{says}");
    }
    for says in
        ["M1 = 0.0", "M1 ≈ 0", "first-order force ≈ 0 N", "third-order force = 0.0", "first-order moment = 0.0 kN·m"]
    {
        assert_eq!(status(&in_line_four(), says), Status::True, "{says}");
    }
    // What is known in decimals alone is not said to be nothing.
    assert_eq!(status(&in_line_four(), "largest main-bearing load = 0 N"), Status::NotDecided);
}

#[test]
fn a_tolerance_decides_of_zero_as_of_other_values() {
    for (says, wanted) in [
        ("second-order force = 0 ± 5", Status::True),
        ("second-order force = 0 ± 3", Status::False),
        ("second-order force ≈ 0 N ± 20000 N", Status::True),
        ("second-order force ≈ 0 N ± 10000 N", Status::False),
        ("first-order moment ≈ 1 N·m ± 5 N·m", Status::True),
        ("first-order moment ≈ 6 N·m ± 5 N·m", Status::False),
        ("first-order force ≈ 0.001 ± 0.01", Status::True),
        ("third-order force ≈ 0.001 ± 0.01", Status::True),
        ("third-order force ≈ 0.1 ± 0.01", Status::False),
        ("third-order force ≈ 1 N ± 5 N", Status::True),
        ("third-order force ≈ 1 N ± 50 %", Status::False),
    ] {
        assert_eq!(status(&in_line_four(), says), wanted, "{says}");
    }
}

#[test]
fn tolerances_and_digits_of_angles_are_in_the_unit_of_the_angle() {
    // −arctan(1/3), −0.0512082 turn.
    let eight = catalogued("V8-crossplane");
    for (angle, wanted) in [
        ("-0.0512 turn ± 0.0001", Status::True),
        ("-0.0512 ± 0.0001 turn", Status::True),
        ("-5.12e-2 turn ± 1e-4", Status::True),
        ("-0.0512 turn ± 1e-6", Status::False),
        ("-0.0512 turn ± 0.01°", Status::True),
        ("-0.0512 turn ± 0.001°", Status::False),
        ("-0.0512 turn ± 0.000001 turn", Status::False),
        ("-0.0512 turn", Status::TrueAsRounded),
        ("-0.0513 turn", Status::False),
        ("-0.1024 pi rad", Status::TrueAsRounded),
        ("-18.43°", Status::TrueAsRounded),
        ("-18.43° ± 0.01", Status::True),
        ("-18.43° ± 0.00002 turn", Status::True),
        ("-18.43° ± 0.00001 turn", Status::False),
        ("−arctan(1/3) ± 0.01°", Status::True),
    ] {
        assert_eq!(status(&eight, &format!("first-order moment = √10 at {angle}")), wanted, "{angle}");
    }
}

/// One to three in line of 0.4 kg and 40 mm, their rods as given.
fn of_rods(throws: &str, rods: &str) -> Engine {
    let text = format!(
        "speed = 5000\ninline = {{ throws = {throws}, spacing = '90 mm' }}\n[mechanism]\ncrank_radius = '40 mm'\n\
         reciprocating_mass = '0.4 kg'\n{rods}\n"
    );
    file::parse("rods.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn newtons_of_offset_and_endless_rods_are_those_of_their_loads() {
    for throws in ["[0]", "[0, 180]", "[0, 120, 240]"] {
        for rods in [
            "rod_length = '140 mm'\npin_offset = '12.5 mm'",
            "rod_length = '140 mm'\npin_offset = '-30 mm'",
            "rod_length = '140 mm'",
            "scotch_yoke = true",
        ] {
            let engine = of_rods(throws, rods);
            let loads = loads::loads(&engine, &[1, 2, 3, 4]).expect("numbers");
            let unit = loads::scale(&engine).expect("a scale").force();
            for order in &loads.orders {
                for (name, unit_name, swing) in [("force", "N", &order.force), ("moment", "N·m", &order.moment)] {
                    let size = swing.largest() * unit;
                    let says = |size: f64| format!("order {} {name} = {size:.4} {unit_name}", order.order);
                    assert!(status(&engine, &says(size)).holds(), "{rods} {throws}: {}", says(size));
                    assert_eq!(status(&engine, &says(size + 3.0)), Status::False, "{rods} {throws}: {}", says(size));
                }
            }
        }
    }
}

#[test]
fn numbers_of_a_claim_which_know_no_offset_decide_nothing_of_offset_rods() {
    let numbers = || claim::Numbers {
        reciprocating_mass: BigRational::new(2.into(), 5.into()),
        crank_radius: BigRational::new(1.into(), 25.into()),
        rod: Rod { ratio: BigRational::new(2.into(), 7.into()), offset: BigRational::zero() },
        speed: BigRational::from_integer(5000.into()),
        spacing: None,
    };
    let answer = |rods: &str, says: &str| {
        let statement = claim::parse_statement(says).expect("a claim");
        claim::answer(&of_rods("[0]", rods), &statement, Some(&numbers())).status
    };
    let centric = "order 1 force = 4386.5 N";
    assert_eq!(answer("rod_length = '140 mm'", centric), Status::True);
    assert_eq!(answer("rod_length = '140 mm'\npin_offset = '30 mm'", centric), Status::NotDecided);
}

#[test]
fn a_multiple_of_m_r_omega_squared_alone_is_no_multiple_of_the_c_1_of_an_offset_rod() {
    let offset = "rod_length = '140 mm'\npin_offset = '30 mm'";
    for (rods, says, wanted) in [
        (offset, "first-order force = 1 m r ω²", Status::NotDecided),
        (offset, "first-order direct force = 1/2 m r ω²", Status::NotDecided),
        (offset, "first-order force = 1 m r ω² c_1", Status::True),
        ("rod_length = '140 mm'", "first-order force = 1 m r ω²", Status::True),
        ("rod_length = '140 mm'", "first-order direct force = 1/2 m r ω²", Status::True),
    ] {
        assert_eq!(status(&of_rods("[0]", rods), says), wanted, "{rods}: {says}");
    }
    // Nothing is nothing in every multiple.
    assert_eq!(status(&of_rods("[0, 180]", offset), "first-order force = 0 m r ω²"), Status::True);
}

#[test]
fn newtons_of_masses_that_turn_know_no_coefficient_of_the_rods() {
    let turning = 0.3 * 0.04 * (5000.0 * std::f64::consts::PI / 30.0_f64).powi(2);
    for rods in ["rod_length = '140 mm'\npin_offset = '30 mm'", "rod_length = '140 mm'", "scotch_yoke = true"] {
        let engine = of_rods("[0]", &format!("{rods}\nrotating_mass = '0.3 kg'"));
        let says = format!("first-order force of the rotating masses = {turning:.1} N");
        assert_eq!(status(&engine, &says), Status::True, "{rods}: {says}");
    }
}
