//! Are the newtons right: the seeds' examples, random engines against sums over their pistons, the orders that an accuracy needs?
#![allow(clippy::disallowed_types)]

use std::f64::consts::TAU;
use std::fmt::Write;

use crankstar::layout::{self, Layout};
use crankstar::loads::{Effect, Harmonic, Loads, Missing, Outcome, Waveform, loads, needed_orders};
use crankstar::motion::SliderCrank;
use num_complex::Complex;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;

fn engine(text: &str) -> Layout {
    layout::parse("engine.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn example(name: &str) -> Layout {
    let path = format!("{}/reports/examples/{name}/layout.toml", env!("CARGO_MANIFEST_DIR"));
    engine(&std::fs::read_to_string(path).expect("the example"))
}

fn computed(layout: &Layout, orders: &[u32]) -> Loads {
    loads(layout, orders).expect("numbers")
}

/// Largest force and moment of an order, in newtons and newton-metres.
fn newtons(layout: &Layout, order: u32) -> [f64; 2] {
    let loads = computed(layout, &[order]);
    let unit = loads.scale.as_ref().expect("mass, radius and speed").force();
    [&loads.orders[0].force, &loads.orders[0].moment].map(|swing| swing.largest() * unit)
}

#[track_caller]
fn is_near(value: f64, wanted: f64, relative: f64) {
    assert!((value - wanted).abs() <= relative * wanted.abs(), "{value} instead of {wanted}");
}

/// Force, moment and torque of all pistons at once, from the closed form of each: no order, no phasor. In m r ω² and m r² ω².
fn by_pistons(layout: &Layout, theta: f64) -> [Complex<f64>; 3] {
    let float = |number: &num_rational::BigRational| number.to_f64().expect("a float");
    let mut sums = [Complex::zero(); 3];
    let mechanism = &layout.mechanism;
    for (index, cylinder) in layout.cylinders.iter().enumerate() {
        let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|turn| float(turn.turns()) * TAU);
        let rod = &mechanism.rods[index];
        let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).expect("a crank");
        let (psi, radius, arm) = (theta + throw - bank, float(&cylinder.crank_radius), float(&layout.arm(cylinder)));
        let mass = float(&cylinder.reciprocating_mass);
        let mut force = -mass * radius * crank.acceleration(psi) * Complex::cis(bank);
        if let Some(rotating) = mechanism.rotating_masses.get(index) {
            let unit = mechanism.mass.as_ref().expect("a mass");
            force += float(&(rotating / unit)) * radius * Complex::cis(theta + throw);
        }
        sums[0] += force;
        sums[1] += force * arm;
        sums[2] += mass * radius * radius * crank.torque(psi);
    }
    sums
}

/// What order k of a quantity has at `e^{ikθ}` and at `e^{−ikθ}`, by a mean over a revolution.
fn by_fourier(layout: &Layout, quantity: usize, order: u32) -> [Complex<f64>; 2] {
    const STEPS: usize = 512;
    let mut sums = [Complex::zero(); 2];
    for j in 0..STEPS {
        let theta = TAU * j as f64 / STEPS as f64;
        let value = by_pistons(layout, theta)[quantity] / STEPS as f64;
        let turning = Complex::cis(-f64::from(order) * theta);
        sums[0] += value * turning;
        sums[1] += value * turning.conj();
    }
    sums
}

#[test]
fn marine_four_has_10966_newtons_with_lambda_alone_and_11143_with_the_whole_series() {
    let layout = example("marine-i4");
    let [force, moment] = newtons(&layout, 2);
    is_near(force, 11142.785224621486, 1e-12);
    assert_eq!(moment, 0.0);
    let loads = computed(&layout, &[1, 2, 4]);
    let c2 = loads.orders[1].coefficient.as_ref().expect("c_2").re.to_float();
    is_near(force / c2 * 0.25, 10966.227112321509, 1e-12);
    assert!(loads.orders[0].force.vanishes() && loads.orders[0].moment.vanishes() && loads.orders[2].moment.vanishes());
    // The pistons themselves say the same.
    let [ahead, behind] = by_fourier(&layout, 0, 2);
    is_near((ahead.norm() + behind.norm()) * loads.scale.expect("a scale").force(), force, 1e-12);
}

#[test]
fn worked_five_has_couples_of_69_34_and_61_55_newton_metres() {
    let layout = example("worked-i5");
    let [first, second] = [1, 2].map(|order| newtons(&layout, order));
    assert_eq!([first[0], second[0]], [0.0, 0.0]);
    is_near(first[1], 69.34287796227913, 1e-12);
    is_near(second[1], 61.55436220228602, 1e-12);
    let loads = computed(&layout, &[2]);
    let c2 = loads.orders[0].coefficient.as_ref().expect("c_2").re.to_float();
    is_near(second[1] / c2 * (50.0 / 175.0), 60.274824752365255, 1e-12);
}

#[test]
fn radial_of_three_has_5684_9_newtons_and_1421_2_with_lambda_alone() {
    let layout = example("radial-3");
    let [first, second] = [1, 2].map(|order| newtons(&layout, order)[0]);
    is_near(first, 5684.89213502747, 1e-12);
    is_near(second, 1444.1049651109447, 1e-12);
    let c2 = computed(&layout, &[2]).orders[0].coefficient.as_ref().expect("c_2").re.to_float();
    is_near(second / c2 * 0.25, 1421.2230337568676, 1e-12);
    // Both are circles.
    for order in &computed(&layout, &[1, 2]).orders {
        is_near(order.force.smallest(), order.force.largest(), 1e-15);
    }
}

#[test]
fn thesis_engines_have_their_moments() {
    // K = r ω² = 17765.2879 m/s². The rotating moment of the three is √3 a m K; its reciprocating one half of it direct, half reverse.
    let acceleration = 0.045 * (TAU * 100.0) * (TAU * 100.0);
    let three = example("thesis-i3");
    let loads = computed(&three, &[1, 2]);
    let unit = loads.scale.as_ref().expect("a scale").force();
    let rotating = loads.effects.iter().find(|effect| effect.effect == Effect::Rotating).expect("rotating masses");
    is_near(rotating.moment.peak().value * unit, 3.0_f64.sqrt() * 0.1 * 0.5 * acceleration, 1e-12);
    let first = &loads.orders[0].moment;
    is_near(first.reverse.value.norm() / 2.0 * unit, 1000.04, 1e-5);
    is_near(first.direct.value.norm() / 2.0 * unit, 1000.04 + 1538.53, 1e-5);
    // Without the offset of the banks the flat-plane V8 would have no moment of order 2: it is 2√2 b m λ K, c_2 for λ.
    let flat = example("thesis-v8-flatplane");
    let loads = computed(&flat, &[2]);
    let c2 = loads.orders[0].coefficient.as_ref().expect("c_2").re.to_float();
    let [_, moment] = newtons(&flat, 2);
    is_near(moment / c2 * 0.25, 130.64, 1e-4);
    let cross = newtons(&example("thesis-v8-crossplane"), 2);
    assert_eq!(cross, [0.0, 0.0]);
}

#[test]
fn six_with_an_offset_has_a_third_order_force_above_its_sixth() {
    let layout = example("i6-offset");
    let loads = computed(&layout, &[1, 2, 3, 4, 6]);
    let forces: Vec<f64> = loads.orders.iter().map(|order| order.force.largest()).collect();
    assert_eq!([forces[0], forces[1], forces[3]], [0.0; 3]);
    // 6 |c_3| and 6 |c_6| at λ = 0.25 and δ = 0.02.
    is_near(forces[2], 6.0 * 1.4950348935348897e-3, 1e-12);
    is_near(forces[4], 6.0 * 7.493566556418305e-5, 1e-12);
    assert!(forces[2] > 19.0 * forces[4]);
    assert!(loads.orders.iter().all(|order| order.moment.vanishes()));
}
