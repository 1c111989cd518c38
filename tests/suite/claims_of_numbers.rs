//! Are claims in newtons, on torques and on unequal rods answered by what decides them?

use crankstar::claim::{self, Status};
use crankstar::engine::Engine;
use crankstar::file;

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
    // No single number is the size of several sums.
    assert_eq!(status(&six, "second-order force = 0"), Status::NotDecided);
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
}
