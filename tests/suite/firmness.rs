//! Does a zero survive exactly the disturbances that it is said to survive?

use std::collections::BTreeMap;

use crankstar::engine::{Cylinder, Draft, Engine, ReferencePlane};
use crankstar::file::{catalogue, parse};
use crankstar::order;
use crankstar::proof::Planar::{self, Force, Moment};
use crankstar::verdict::Disturbance::{self, AnySpacing, BankMasses, BankOffset, CylinderMasses, SymmetricSpacing};
use crankstar::verdict::FirmnessOutcome::{self, Breaks, DoesNotApply, Survives};
use crankstar::verdict::{Balance, Reason, firmness, opposed_partners, reason};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::support::dice::Dice;
use crate::support::verdicts::pistons;
use crate::support::written::of_catalogue as engine;

fn balance(layout: &Engine, quantity: Planar, order: u32) -> Balance {
    pistons(layout, &[order]).remove(0).balance(quantity).clone()
}

fn outcome(layout: &Engine, quantity: Planar, order: u32, disturbance: Disturbance) -> FirmnessOutcome {
    firmness(layout, &balance(layout, quantity, order)).expect("a zero").outcome(disturbance)
}

#[test]
fn known_zeros_are_as_firm_as_they_are_known_to_be() {
    #[rustfmt::skip]
    let known = [
        // In-line engines: mirror symmetry across the shaft, whatever the distances.
        ("I4", Moment, 1, SymmetricSpacing, Survives), ("I4", Moment, 1, AnySpacing, Breaks),
        ("I6", Moment, 1, SymmetricSpacing, Survives), ("I6", Moment, 2, SymmetricSpacing, Survives),
        ("I6", Moment, 2, AnySpacing, Breaks), ("I6", Moment, 2, BankOffset, DoesNotApply),
        ("I6", Force, 2, BankMasses, DoesNotApply), ("I6", Force, 2, CylinderMasses, Breaks),
        ("I4", Force, 1, SymmetricSpacing, DoesNotApply),
        // Stabile 5.4.1: zero in one place, and with the bank offset b not zero in another.
        ("V8-flatplane", Moment, 2, BankOffset, Breaks), ("V8-flatplane", Moment, 1, BankOffset, Survives),
        // Each bank of the cross-plane is a star of four; at order 4 its vectors add up.
        ("V8-crossplane", Force, 2, BankMasses, Survives), ("V8-crossplane", Moment, 2, BankOffset, Survives),
        ("V8-crossplane", Moment, 4, BankOffset, Breaks),
        // A V12 is two balanced sixes.
        ("V12-60", Force, 2, BankMasses, Survives), ("V12-60", Moment, 2, BankOffset, Survives),
        ("V12-60", Moment, 1, BankMasses, Survives),
        // The two pistons of a boxer hold each other.
        ("boxer-2", Force, 1, CylinderMasses, Breaks), ("boxer-4", Force, 2, BankMasses, Breaks),
        // One row: every arm is zero.
        ("radial-9", Moment, 1, CylinderMasses, Survives), ("radial-9", Moment, 1, AnySpacing, DoesNotApply),
        ("radial-9", Force, 2, CylinderMasses, Breaks), ("radial-9", Force, 2, BankMasses, DoesNotApply),
        ("I1", Moment, 1, CylinderMasses, Survives),
    ];
    for (name, quantity, order, disturbance, expected) in known {
        let found = outcome(&engine(name), quantity, order, disturbance);
        assert_eq!(found, expected, "{name}, {quantity:?} of order {order}, {disturbance:?}");
    }
}

#[test]
fn what_is_left_has_no_firmness() {
    assert_eq!(firmness(&engine("I4"), &balance(&engine("I4"), Force, 2)), None);
}

#[test]
fn opposed_pairs_are_named_where_they_are_what_is_certified() {
    let flat = balance(&engine("I4"), Force, 1);
    assert_eq!(reason(&engine("I4"), &flat.direct), Reason::OpposedPairs);
    assert_eq!(opposed_partners(&flat.direct.sum), Some(vec![(0, 1), (2, 3)]));
    let boxer = balance(&engine("boxer-6"), Force, 2);
    // Every vector has its opposite, but two triangles are certified and drawn.
    assert!(opposed_partners(&boxer.direct.sum).is_some());
    assert_eq!(reason(&engine("boxer-6"), &boxer.direct), Reason::Rotation { fold: 6 });
    let radial = balance(&engine("radial-9"), Force, 2);
    assert_eq!(opposed_partners(&radial.direct.sum), None);
    assert_eq!(reason(&engine("radial-9"), &radial.direct), Reason::Rotation { fold: 9 });
}

/// From 1/12 to 10, so that no two are likely to agree.
fn amount(dice: &mut Dice) -> BigRational {
    BigRational::new((dice.below(120) + 1).into(), 12.into())
}

/// A random amount for each value of a key, the same for cylinders that share it.
fn amounts<K: Ord>(layout: &Engine, dice: &mut Dice, key: impl Fn(&Cylinder) -> K) -> Vec<BigRational> {
    let mut drawn: BTreeMap<K, BigRational> = BTreeMap::new();
    let mut draw = |cylinder| drawn.entry(key(cylinder)).or_insert_with(|| amount(dice)).clone();
    layout.cylinders().iter().map(&mut draw).collect()
}

/// The engine with one thing changed at random.
fn disturbed(layout: &Engine, disturbance: Disturbance, dice: &mut Dice) -> Engine {
    let plane = layout.reference_plane();
    let bank = |cylinder: &Cylinder| cylinder.bank.clone();
    let drawn = match disturbance {
        SymmetricSpacing => amounts(layout, dice, |cylinder| layout.arm(cylinder).abs()),
        AnySpacing => amounts(layout, dice, |cylinder| cylinder.position.clone()),
        BankOffset | BankMasses => amounts(layout, dice, bank),
        CylinderMasses => amounts(layout, dice, |cylinder| cylinder.name.clone()),
    };
    let banks: BTreeMap<_, _> = layout.cylinders().iter().map(bank).zip(drawn.iter().cloned()).collect();
    let middle = banks.values().sum::<BigRational>() / BigRational::from_integer(banks.len().into());
    let reference_plane = ReferencePlane::Named(plane.clone());
    let mut changed = Draft { reference_plane, ..layout.clone().into_draft() };
    for (cylinder, drawn) in changed.cylinders.iter_mut().zip(drawn) {
        match disturbance {
            SymmetricSpacing => cylinder.position = plane + layout.arm(cylinder).signum() * drawn,
            AnySpacing => cylinder.position = drawn,
            BankOffset => cylinder.position += drawn - &middle,
            BankMasses | CylinderMasses => cylinder.reciprocating_mass *= drawn,
        }
    }
    changed.build().expect("it holds together")
}

/// Disturbs every zero of an engine at random and compares with what is said of it; returns how many outcomes it met.
fn check(layout: &Engine, dice: &mut Dice) -> [usize; 3] {
    let mut met = [0; 3];
    for order in pistons(layout, layout.orders()) {
        for balance in [&order.force, &order.moment] {
            let Some(firmness) = firmness(layout, balance) else { continue };
            for disturbance in Disturbance::ALL {
                let quantity = balance.direct.quantity;
                let mut stays_zero = || {
                    let changed = disturbed(layout, disturbance, dice);
                    let verdicts = balance.verdicts().into_iter();
                    verdicts.map(|v| order::star(&changed, quantity, v.order, v.sense)).all(|sum| sum.vanishes())
                };
                let outcome = firmness.outcome(disturbance);
                let holds = match outcome {
                    Survives => (0..3).all(|_| stays_zero()),
                    Breaks => (0..4).any(|_| !stays_zero()),
                    DoesNotApply => true,
                };
                assert!(
                    holds,
                    "{}: {quantity:?} of order {}, {disturbance:?} {outcome:?}",
                    layout.title().written(),
                    order.order
                );
                met[outcome as usize] += 1;
            }
        }
    }
    met
}

#[test]
fn random_disturbances_of_every_engine_break_what_is_said_to_break_and_nothing_else() {
    let mut dice = Dice::new(5);
    // A link that is moved apart from its master is none.
    let catalogue = catalogue().unwrap().into_iter().filter(|(_, layout)| !layout.has_links());
    let met = catalogue.map(|(_, layout)| check(&layout, &mut dice));
    let total = met.fold([0; 3], |sum, one| [0, 1, 2].map(|index| sum[index] + one[index]));
    assert!(total.iter().all(|&outcomes| outcomes > 100), "hardly a law: {total:?}");
}

#[test]
fn so_do_random_disturbances_of_unusual_engines() {
    let unusual = [
        "[flat]\nthrows = [0]",
        "[flat]\nthrows = [0, 180, 180, 0]\nbank_offset = \"1/3\"",
        "[vee]\nbank_angle = 90\nthrows = [0, 180, 180, 0]\nbank_offset = \"1/4\"",
        "[vee]\nbank_angle = 60\nthrows = [0, 120, 240, 240, 120, 0]\npositions = [5, 3, 1, 0, -2, -4]",
        "reference_plane = 3\n[inline]\nthrows = [0, 120, 240, 240, 120, 0]",
        "[radial]\ncylinders = 7\nrows = 2\nrow_rotation = 0\nrow_throw = 180",
    ];
    let mut dice = Dice::new(7);
    for text in unusual {
        let layout =
            parse("unusual", &format!("title = 'unusual'\n{text}")).unwrap_or_else(|error| panic!("{error:?}"));
        let met = check(&layout, &mut dice);
        assert!(met.iter().sum::<usize>() > 0, "no zero in {text}");
    }
}

#[test]
fn moving_both_banks_apart_about_their_middle_leaves_a_flat_twin_on_one_pin_without_moment() {
    let flat = parse("flat", "title = 'flat'\n[flat]\nthrows = [0]").unwrap();
    assert!(flat.cylinders().iter().all(|cylinder| flat.arm(cylinder).is_zero()));
    assert_eq!(outcome(&flat, Moment, 1, BankOffset), Survives);
    assert_eq!(outcome(&flat, Moment, 2, BankOffset), Breaks);
}
