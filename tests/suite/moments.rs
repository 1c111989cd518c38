//! Are the tables of a project guide those of the theory, of a maker, and of forces that are sampled through a revolution?

use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file;
use crankstar::motion::coefficients_fast;
use crankstar::report::{Amplitude, MomentsRow, MomentsStudy, NoMoments, Question};
use crankstar::table::Value;
use crankstar::text::Untrusted;
use crankstar::torque::{Class, torque};
use num_complex::Complex;

use crate::support::dice::Dice;
use crate::support::program::{call, scratch};
use crate::support::written::assert_near;

/// The example of the theory: r 1 m, rod 2.05 m, spacing 0.85 m, 3000 kg, 127 rpm.
fn two_stroke(firing_order: &str) -> String {
    format!(
        "cycle = 'two-stroke'\nspeed = 127\nfiring_order = '{firing_order}'\n[inline]\nspacing = '0.85 m'\n[mechanism]\n\
         crank_radius = '1 m'\nrod_length = '2.05 m'\nreciprocating_mass = '3000 kg'\n{GAS}"
    )
}

const GAS: &str = "[gas]\nbore = '500 mm'\nprocess = 'diesel'\ncompression_ratio = 17\nintake_pressure = '3.4 bar'\n\
    crankcase = '3.4 bar'\nintake_closes = -110\ncompression_exponent = '1.36'\nexpansion_exponent = '1.28'\nheat = '1.6 MJ'\nwiebe_exponent = 1\n\
    combustion_starts = 0\ncombustion_lasts = 60\nexhaust_opens = 110\nblowdown = 40\n";

fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn study(text: &str) -> MomentsStudy {
    MomentsStudy::new(&[(Untrusted::new("it"), engine(text))]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// M1 with counterweights, as makers have it, M2V, M4V in kN·m.
fn sizes(row: &MomentsRow) -> [f64; 3] {
    [row.countered, row.moments[1].components[0], row.moments[2].components[0]].map(|one| one.unwrap_or(0.0) / 1e3)
}

const GUIDE: [(&str, [f64; 3]); 5] = [
    ("1-4-3-2-5", [101.262411, 1169.272630, 7.147695]),
    ("1-5-3-4-2-6", [0.0, 813.382463, 55.142093]),
    ("1-7-2-5-4-3-6", [60.269650, 236.117747, 156.708800]),
    ("1-8-3-4-7-2-5-6", [202.215214, 0.0, 63.672605]),
    ("1-8-12-4-2-9-10-5-3-7-11-6", [0.0, 0.0, 110.284186]),
];

#[test]
fn the_external_moments_of_five_engines_are_those_of_the_theory_and_zeros_are_proved() {
    for (order, wanted) in GUIDE {
        let study = study(&two_stroke(order));
        let row = &study.rows[0];
        for (found, wanted) in sizes(row).into_iter().zip(wanted) {
            assert_near(found, wanted, 5e-6);
        }
        for (place, wanted) in wanted.into_iter().enumerate() {
            assert_eq!(row.moments[place].components[0].is_none(), wanted == 0.0, "{order} {place}");
            assert_eq!(row.moments[place].components[1], None, "pistons in line shake in one plane");
        }
        assert!(row.forces.iter().all(|force| force.components == [None; 2]));
        // Counterweights against what turns with the crank leave half of it, either way.
        assert_near(row.countered.unwrap_or(0.0), row.moments[0].components[0].unwrap_or(0.0) / 2.0, 1e-6);
    }
}

#[test]
fn the_guide_force_moments_of_a_six_are_those_of_the_theory() {
    let study = study(&two_stroke("1-5-3-4-2-6"));
    let of = |order: u32| {
        let order = CycleOrder::of_halves(2 * order).expect("an order");
        let all = study.rows[0].guides.as_ref().expect("gas");
        all.0.iter().find(|moments| moments.order == order).expect("an order")
    };
    for (order, value) in [(6, 381.74), (12, 10.889)] {
        assert_near(of(order).rocking.expect("H") / 1e3, value, 5e-3);
    }
    for (order, value) in [(2, 80.04), (3, 217.97), (4, 186.29)] {
        assert_near(of(order).twisting.expect("X") / 1e3, value, 5e-3);
        assert_eq!(of(order).rocking, None);
    }
    for order in [1, 5, 6] {
        assert_eq!(of(order).twisting, None, "{order}");
    }
}

/// Order κ of the torque of the cylinder at this place of a class, by its own angle: of gas and piston, where that is known.
pub fn torque_of_one(class: &Class, place: usize, order: CycleOrder) -> Complex<f64> {
    let inertia = class.inertia.as_ref().map_or_else(Complex::default, |inertia| inertia.at(order)[0]);
    class.harmonics.torque_at(order) + inertia * crankstar::numbers::float(&class.masses[place])
}

/// A free check: M2V over `m r ω² c₂` and X₂ times the rod length over a cylinder's torque are the same star.
#[test]
fn external_and_guide_force_moments_share_their_stars() {
    for (order, _) in &GUIDE[..3] {
        let text = two_stroke(order);
        let (study, torque) = (study(&text), torque(&engine(&text)).expect("gas"));
        let (c2, omega) = (0.520_594_197_350, 127.0 / 60.0 * TAU);
        let second = CycleOrder::of_halves(4).expect("an order");
        let of_one = torque_of_one(&torque.classes[0], 0, second).norm();
        let row = &study.rows[0];
        let twisting = row.guides.as_ref().expect("gas").0[1].twisting.expect("X");
        let external = row.moments[1].components[0].expect("M2V") / (3000.0 * omega * omega * c2);
        assert_near(twisting * 2.05 / of_one, external, 1e-9 * external);
    }
}

/// `MAN` S80MC-C7: the ratios of a maker's tables are those of the stars to the third figure.
#[test]
fn the_ratios_of_a_makers_tables_are_those_of_the_stars() {
    let of = |order: &str| sizes(&study(&two_stroke(order)).rows[0]);
    let [six, seven, eight] = ["1-5-3-4-2-6", "1-7-2-5-4-3-6", "1-8-3-4-7-2-5-6"].map(of);
    let per_cylinder = |moment: f64, count: f64| moment / count;
    assert_near(per_cylinder(seven[1], 7.0) / per_cylinder(six[1], 6.0), 36.4 / 146.4, 5e-4);
    assert_near(per_cylinder(eight[0], 8.0) / per_cylinder(seven[0], 7.0), 27.3 / 9.3, 5e-3);
    // The rod that the maker's ratio of second to first order asks for: his engine's is 2050 mm long on a crank of 1000 mm.
    let stars = six[1] / COEFFICIENTS[2] / eight[0];
    let coefficient = 146.4 * 6.0 / (27.3 * 8.0) / stars;
    let ratio = (0..40).fold([0.3, 0.9], |[low, high]: [f64; 2], _| {
        let middle = f64::midpoint(low, high);
        if coefficients_fast(middle, 2)[2] < coefficient { [middle, high] } else { [low, middle] }
    });
    assert_near(ratio[0], 1000.0 / 2050.0, 1e-4);
}

/// c₁, c₂, c₃, c₄ of a rod 2.05 times as long as the crank, as the theory has them.
const COEFFICIENTS: [f64; 5] = [0.0, 1.0, 0.520_594_197_350, 0.0, -0.035_292_934_136];

#[test]
fn the_coefficients_of_the_example_are_those_of_the_theory() {
    let found = coefficients_fast(1.0 / 2.05, 4);
    for (found, wanted) in found.into_iter().zip(COEFFICIENTS).skip(1) {
        assert_near(found, wanted, 1e-12);
    }
}

/// The moment through a revolution by each piston's acceleration, sampled and taken apart.
#[test]
fn sampled_forces_of_random_engines_have_these_moments() {
    let mut dice = Dice::new(35);
    for _ in 0..40 {
        let count = 2 + dice.below(5) as usize;
        let throws: Vec<u64> = (0..count).map(|_| dice.below(24) * 15).collect();
        let banks: Vec<u64> = (0..count).map(|_| dice.below(6) * 30).collect();
        let cylinders: Vec<String> = (0..count)
            .map(|place| {
                let (throw, bank) = (throws[place], banks[place]);
                format!("[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{} mm'\n", 100 * place)
            })
            .collect();
        let mechanism = "[mechanism]\ncrank_radius = '50 mm'\nrod_length = '150 mm'\nreciprocating_mass = '1 kg'\n";
        let study = study(&format!("speed = 3000\n{}{mechanism}", cylinders.concat()));
        let omega = 100.0 * std::f64::consts::PI;
        let middle = (count - 1) as f64 * 0.05;
        let steps = 720;
        let step = TAU / f64::from(steps);
        let place = |psi: f64| 0.05 * psi.cos() + (0.15f64 * 0.15 - (0.05 * psi.sin()).powi(2)).sqrt();
        let h = 1e-3;
        let force = |psi: f64| {
            let five = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|n| place(psi + n * h));
            -(-five[0] + 16.0 * five[1] - 30.0 * five[2] + 16.0 * five[3] - five[4]) / (12.0 * h * h) * omega * omega
        };
        for (of_moment, externals) in [(false, &study.rows[0].forces), (true, &study.rows[0].moments)] {
            for external in externals {
                for (component, found) in external.components.into_iter().enumerate() {
                    let sum = |turn: fn(f64) -> f64| -> f64 {
                        let at = |n: i32| {
                            let theta = f64::from(n) * step;
                            let each = (0..count).map(|index| {
                                let axis = (banks[index] as f64).to_radians();
                                let arm = if of_moment { 0.1 * index as f64 - middle } else { 1.0 };
                                let along = if component == 0 { axis.cos() } else { axis.sin() };
                                force(theta + (throws[index] as f64).to_radians() - axis) * along * arm
                            });
                            each.sum::<f64>() * turn(f64::from(external.order) * theta)
                        };
                        (0..steps).map(at).sum::<f64>() * 2.0 / f64::from(steps)
                    };
                    let sampled = sum(f64::cos).hypot(sum(f64::sin));
                    assert_near(found.unwrap_or(0.0), sampled, 1e-3);
                    assert!(found != Some(0.0), "a zero is proved, or it is none");
                }
            }
        }
    }
}

#[test]
fn counterweights_are_left_out_in_a_row_of_its_own() {
    let weight = "[[counterweight]]\nangle = 90\nposition = '1.7 m'\nmass = '100 kg'\nradius = '1 m'\n";
    let with = study(&format!("{}{weight}", two_stroke("1-4-3-2-5")));
    assert_eq!(with.rows.iter().map(|row| row.is_bare).collect::<Vec<_>>(), [false, true]);
    assert_near(sizes(&with.rows[1])[0], GUIDE[0].1[0], 1e-6);
    assert!(with.rows[0].forces[0].components.iter().all(|one: &Amplitude| one.is_some()));
    assert_near(with.rows[0].countered.expect("a moment"), with.rows[1].countered.expect("a moment"), 1e-6);
}

#[test]
fn what_cannot_be_had_in_newton_metres_is_refused_and_a_layout_without_gas_has_no_guide_forces() {
    let text = two_stroke("1-4-3-2-5");
    let refused = |text: &str| MomentsStudy::new(&[(Untrusted::new("it"), engine(text))]).err();
    assert!(matches!(refused(&text.replace("speed = 127\n", "")), Some(NoMoments::Scale(_))));
    assert!(matches!(refused(&text.replace("spacing = '0.85 m'\n", "")), Some(NoMoments::Positions(_))));
    assert_eq!(MomentsStudy::new(&[]).err(), Some(NoMoments::Nothing));
    let silent = study(&text.replace(GAS, ""));
    assert!(silent.rows[0].guides.is_err() && silent.table("guides").is_none());
}

#[test]
fn a_value_of_one_engine_is_named_without_it() {
    let engine = engine(&two_stroke("1-5-3-4-2-6"));
    let names = ["moments.moments.built.moment_2_v", "moments.guides.6.h"].map(|name| name.parse().expect("a name"));
    let values = crankstar::report::values_of(&engine, &names);
    let [second, rocking] = [0, 1].map(|place: usize| match values[place].as_ref().expect("a value").value() {
        Some(Value::Decimal(value)) => value,
        other => panic!("{other:?}"),
    });
    assert_near(second, 813.382463, 5e-6);
    assert_near(rocking, 381.74, 5e-3);
}

#[test]
fn the_command_makes_a_row_of_each_firing_order() {
    let layout = scratch("moments").join("base.toml");
    std::fs::write(&layout, two_stroke("1-4-3-2-5")).expect("a file");
    let layout = layout.to_str().expect("UTF-8");
    let orders = GUIDE.map(|(order, _)| order).join(",");
    let out = call(&["moments", layout, "--firing-order", &orders, "--format", "csv"]);
    let csv = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(csv.lines().count(), 6, "{csv}{}", String::from_utf8_lossy(&out.stderr));
    assert!(
        csv.lines()
            .nth(5)
            .is_some_and(|line| line.contains("built,1-8-12-4-2-9-10-5-3-7-11-6,12,1-8-12-4-2-9-10-5-3-7-11-6,")),
        "{csv}"
    );
    let wrong = call(&["moments", layout, "--firing-order", "1-1-2"]);
    assert!(!wrong.status.success() && String::from_utf8_lossy(&wrong.stderr).contains("with the firing order 1-1-2"));
}

/// X of order κ times the rod length, over the torque of one cylinder and the spacing, is the sum of the firing angles with their arms: a number
/// of the firing order alone, as project guides of large two-strokes have it.
#[test]
fn the_twisting_moments_of_project_guides_are_the_arms_of_their_firing_orders() {
    let guides = |text: &str| {
        let one = study(text).rows[0].guides.clone().expect("gas").0;
        move |order: u32| one.iter().find(|moment| moment.order.halves() == 2 * order).expect("an order").clone()
    };
    let root = |inside: f64| inside.sqrt();
    let cases: [(&str, &[f64]); 7] = [
        ("1-4-3-2-5", &[0.449027977, 4.979796570]),
        ("1-5-3-4-2-6", &[0.0, 2.0 * root(3.0), 9.0]),
        ("1-7-2-5-4-3-6", &[0.267253751, 1.005598110, 9.844660880]),
        ("1-8-3-4-7-2-5-6", &[0.896683058, 0.0, root(80.0 + 56.0 * root(2.0)), 4.0]),
        ("1-6-7-3-5-8-2-4-9", &[0.921604985, 1.130515875, 9.0 * root(3.0), 4.987241530]),
        (
            "1-8-5-7-2-9-4-6-3-10",
            &[
                root(45.0 - 20.0 * root(5.0)),
                root(5.0 - 2.0 * root(5.0)),
                root(45.0 + 20.0 * root(5.0)),
                root(5.0 + 2.0 * root(5.0)),
                25.0,
            ],
        ),
        ("1-8-12-4-2-9-10-5-3-7-11-6", &[0.0, 0.0, 9.0 * root(10.0), 4.0 * root(3.0), 0.0, 0.0]),
    ];
    for (order, arms) in cases {
        let several = guides(&two_stroke(order));
        let of_all = torque(&engine(&two_stroke(order))).expect("gas");
        let of_one = |order: u32| {
            torque_of_one(&of_all.classes[0], 0, CycleOrder::of_halves(2 * order).expect("an order")).norm()
        };
        let count = order.split('-').count() as u32;
        for (kappa, arm) in (1..).zip(arms) {
            let found = several(kappa).twisting.unwrap_or(0.0) * 2.05 / (of_one(kappa) * 0.85);
            assert_near(found, *arm, 2e-9 * (1.0 + arm));
            assert_eq!(several(kappa).twisting.is_none(), *arm == 0.0, "{order}, order {kappa}");
            // The mirrored order has the same arms, and that of all cylinders none.
            if count - kappa <= 12 {
                let mirrored = several(count - kappa).twisting.unwrap_or(0.0);
                assert_near(mirrored * 2.05 / (of_one(count - kappa) * 0.85), *arm, 2e-9 * (1.0 + arm));
            }
        }
        if count <= 12 {
            assert_eq!(several(count).twisting, None, "{order}");
        }
    }
}

#[test]
fn the_answer_states_the_speed_and_each_reason_for_missing_guide_force_moments_once() {
    let folder = scratch("moments-without-gas");
    let layout = folder.join("low.toml");
    std::fs::write(&layout, two_stroke("1-4-3-2-5").replace(GAS, "")).expect("a file");
    let path = layout.display().to_string();
    let asked = |arguments: &[&str]| {
        let printed = String::from_utf8(call(arguments).stdout).expect("a text");
        printed.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let answer = asked(&["moments", &path, "--firing-order", "1-4-3-2-5,1-5-3-4-2-6"]);
    assert_eq!(answer.matches("says nothing of the gas").count(), 1, "{answer}");
    assert!(answer.contains("Without guide-force moments: 1-4-3-2-5, 1-5-3-4-2-6;"), "{answer}");
    assert!(answer.contains("Speed,") && answer.contains(" 127 "), "{answer}");
    let table = asked(&["moments", &path, "--format", "csv"]);
    assert!(table.contains(",speed_rpm,"), "{table}");
}

#[test]
fn a_firing_order_with_commas_is_one_order_and_not_six() {
    let folder = scratch("moments-commas");
    let layout = folder.join("low.toml");
    std::fs::write(&layout, two_stroke("1-4-3-2-5")).expect("a file");
    let path = layout.display().to_string();
    let asked = |order: &str| {
        let output = call(&["moments", &path, "--firing-order", order]);
        assert!(output.status.success(), "{order}: {}", String::from_utf8_lossy(&output.stderr));
        output.stdout
    };
    assert_eq!(asked("1,5,2,3,4"), asked("1-5-2-3-4"));
}
