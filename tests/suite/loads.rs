//! Are the newtons right: the seeds' examples, random engines against sums over their pistons, the orders that an accuracy needs?
use std::f64::consts::TAU;
use std::fmt::Write;

use crankstar::engine::{Cylinder, Engine, Rod};
use crankstar::file;
use crankstar::loads::{Harmonic, Loads, Missing, Outcome, Waveform, loads, needed_orders};
use crankstar::motion::SliderCrank;
use crankstar::order::MassGroup;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;

use crate::support::written::engine;

fn example(name: &str) -> Engine {
    let path = format!("{}/reports/examples/{name}/layout.toml", env!("CARGO_MANIFEST_DIR"));
    engine(&std::fs::read_to_string(path).expect("the example"))
}

fn computed(layout: &Engine, orders: &[u32]) -> Loads {
    loads(layout, orders).expect("numbers")
}

/// Largest force and moment of an order, in newtons and newton-metres.
fn newtons(layout: &Engine, order: u32) -> [f64; 2] {
    let loads = computed(layout, &[order]);
    let unit = loads.scale.as_ref().expect("mass, radius and speed").force();
    [&loads.orders[0].force, &loads.orders[0].moment].map(|swing| swing.largest() * unit)
}

#[track_caller]
fn is_near(value: f64, wanted: f64, relative: f64) {
    assert!((value - wanted).abs() <= relative * wanted.abs(), "{value} instead of {wanted}");
}

/// The pistons of an engine as floats: no order, no phasor.
struct Pistons(Vec<Piston>);

struct Piston {
    crank: SliderCrank,
    throw: f64,
    bank: f64,
    arm: f64,
    mass: f64,
    rotating: f64,
    radius: f64,
}

impl Pistons {
    fn of(layout: &Engine) -> Self {
        let float = |number: &BigRational| number.to_f64().expect("a float");
        let mechanism = layout.dimensions();
        let piston = |cylinder: &Cylinder| {
            let Rod { ratio, offset } = cylinder.rod().expect("a rod").clone();
            let unit = mechanism.mass.as_ref().expect("a mass");
            Piston {
                crank: SliderCrank::new(ratio, offset).expect("a crank"),
                throw: float(cylinder.throw.turns()) * TAU,
                bank: float(cylinder.bank.turns()) * TAU,
                arm: float(&layout.arm(cylinder)),
                mass: float(&cylinder.reciprocating_mass),
                rotating: float(&(&cylinder.rotating_mass / unit)),
                radius: float(&cylinder.crank_radius),
            }
        };
        Pistons(layout.cylinders().iter().map(piston).collect())
    }

    /// Force, moment and torque of all pistons at once, from the closed form of each, in m r ω² and m r² ω².
    fn at(&self, theta: f64) -> [Complex<f64>; 3] {
        let mut sums = [Complex::zero(); 3];
        for Piston { crank, throw, bank, arm, mass, rotating, radius } in &self.0 {
            let psi = theta + throw - bank;
            let force = radius
                * (rotating * Complex::cis(theta + throw) - mass * crank.acceleration(psi) * Complex::cis(*bank));
            sums[0] += force;
            sums[1] += force * arm;
            sums[2] += mass * radius * radius * crank.torque(psi);
        }
        sums
    }
}

/// What order k of force, moment and torque has at `e^{ikθ}` and at `e^{−ikθ}`, by a mean over a revolution.
fn by_fourier(pistons: &Pistons, order: u32) -> [[Complex<f64>; 2]; 3] {
    const STEPS: usize = 256;
    let mut sums = [[Complex::zero(); 2]; 3];
    for j in 0..STEPS {
        let theta = TAU * j as f64 / STEPS as f64;
        let turning = Complex::cis(-f64::from(order) * theta) / STEPS as f64;
        for (sums, value) in sums.iter_mut().zip(pistons.at(theta)) {
            sums[0] += value * turning;
            sums[1] += value * turning.conj();
        }
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
    let [ahead, behind] = by_fourier(&Pistons::of(&layout), 2)[0];
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
    let rotating = loads.groups.iter().find(|group| group.group == MassGroup::Rotating).expect("rotating masses");
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

/// A random engine, one table per cylinder: up to six of them, some with rods and offsets of their own, some with rotating masses.
fn random_engine() -> impl Strategy<Value = String> {
    let cylinder = (0..24_i64, 0..24_i64, -5..=5_i64, 1..=4_i64, 1..=3_i64, 0..4_usize, 0..3_usize);
    (prop::collection::vec(cylinder, 1..=6), 0..3_i64, any::<bool>()).prop_map(|(cylinders, rotating, torque)| {
        let (ratios, offsets) = (["0.1", "0.25", "0.3", "0.55"], ["0", "0.02", "-0.1"]);
        let list = |texts: Vec<String>| format!("[{}]", texts.join(", "));
        let column = |text: &dyn Fn(usize) -> String| list((0..cylinders.len()).map(text).collect());
        let mut file =
            format!("speed = 3000\norders = [1, 2]\n{}", if torque { "effects = [\"torque\"]\n" } else { "" });
        for (throw, bank, position, ..) in &cylinders {
            let place = format!("throw = \"{throw}/24 turn\"\nbank = \"{bank}/24 turn\"\nposition = \"{position}/10\"");
            writeln!(file, "[[cylinder]]\n{place}").expect("a string");
        }
        file += "[mechanism]\n";
        for (key, values) in [
            ("reciprocating_mass", column(&|j| format!("\"{}/2\"", cylinders[j].3))),
            ("crank_radius", column(&|j| format!("\"{}/20\"", cylinders[j].4))),
            ("rod_ratio", column(&|j| format!("\"{}\"", ratios[cylinders[j].5]))),
            ("offset_ratio", column(&|j| format!("\"{}\"", offsets[cylinders[j].6]))),
        ] {
            writeln!(file, "{key} = {values}").expect("a string");
        }
        if rotating > 0 {
            writeln!(file, "rotating_mass = \"{rotating}/3\"").expect("a string");
        }
        file
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Vectors, ellipse and components of each order against what the motion of the pistons has of it.
    #[test]
    fn orders_are_those_of_the_moving_pistons(text in random_engine()) {
        let layout = engine(&text);
        let pistons = Pistons::of(&layout);
        let orders = [1, 2, 3, 4, 5, 6, 8];
        let loads = computed(&layout, &orders);
        for (place, quantity) in ["force", "moment"].iter().enumerate() {
            let size = pistons.at(0.3)[place].norm() + 1.0;
            for of_order in &loads.orders {
                let swing = [&of_order.force, &of_order.moment][place];
                let [ahead, behind] = by_fourier(&pistons, of_order.order)[place];
                let [direct, reverse] = swing.amplitudes();
                let what = format!("{quantity} of order {}: {text}", of_order.order);
                prop_assert!((direct - ahead).norm() < 1e-12 * size && (reverse - behind).norm() < 1e-12 * size, "{}", what);
                prop_assert_eq!(swing.direct.outcome == Outcome::Zero, direct.norm() == 0.0, "{}", what);
                // The path, point by point.
                let path: Vec<Complex<f64>> = (0..720)
                    .map(|j| Complex::cis(TAU * f64::from(j) / 720.0))
                    .map(|z| ahead * z + behind * z.conj())
                    .collect();
                let largest = |part: &dyn Fn(&Complex<f64>) -> f64| path.iter().map(part).fold(0.0, f64::max);
                let smallest = path.iter().map(|value| value.norm()).fold(f64::INFINITY, f64::min);
                // 720 points miss a top by 10⁻⁵ of it, and the bottom by at most half a step of the largest.
                for (ours, theirs, missed) in [
                    (swing.largest(), largest(&|value| value.norm()), 1e-5),
                    (swing.smallest(), smallest, 5e-3),
                    (swing.along(), largest(&|value| value.re.abs()), 1e-5),
                    (swing.across(), largest(&|value| value.im.abs()), 1e-5),
                ] {
                    let allowed = missed * swing.largest() + 1e-12 * size;
                    prop_assert!((ours - theirs).abs() < allowed, "{}: {} {}", what, ours, theirs);
                }
                if let Some(direction) = swing.direction().filter(|_| swing.smallest() < 0.9 * swing.largest()) {
                    let on_axis = path.iter().map(|value| (value * Complex::cis(-direction.to_radians())).re.abs());
                    let reached = on_axis.fold(0.0, f64::max);
                    prop_assert!((reached - swing.largest()).abs() < 1e-5 * swing.largest() + 1e-12 * size, "{}: {} {}", what, reached, swing.largest());
                    prop_assert!(-90.0 < direction && direction <= 90.0);
                }
            }
        }
    }

    #[test]
    fn torque_is_that_of_the_moving_pistons_and_computed_only_where_asked_for(text in random_engine()) {
        let layout = engine(&text);
        let pistons = Pistons::of(&layout);
        let loads = computed(&layout, &[1, 2, 6]);
        prop_assert_eq!(loads.torque.is_some(), layout.effects().torque);
        let Some(torque) = loads.torque else { return Ok(()) };
        prop_assert!([1, 2, 3, 4, 6].iter().all(|order| torque.orders.iter().any(|torque| torque.order == *order)));
        for order in &torque.orders {
            let [ahead, _] = by_fourier(&pistons, order.order)[2];
            let size = layout.cylinders().iter().map(|c| (c.weight() * &c.crank_radius).to_f64().expect("a float")).sum::<f64>();
            prop_assert!((order.vector.value - 2.0 * ahead).norm() < 1e-12 * size, "order {}: {text}", order.order);
            if order.vector.outcome == Outcome::Zero {
                prop_assert_eq!(order.vector.value, Complex::zero());
            }
        }
    }

    /// Whatever the phases, no point of the path lies above the peak: also where two tops differ by less than a sample shows.
    #[test]
    fn no_point_of_a_waveform_lies_above_its_peak(
        harmonics in prop::collection::vec((1..=40_u32, -1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64), 1..5)
    ) {
        let harmonics = harmonics.into_iter().map(|(order, a, b, c, d)| Harmonic {
            order,
            direct: Complex::new(a, b),
            reverse: Complex::new(c, d),
        });
        let waveform = Waveform::new(harmonics);
        let (peak, real) = (waveform.peak(), waveform.real_peak());
        for j in 0..10_000 {
            let value = waveform.at(TAU * f64::from(j) / 10_000.0);
            prop_assert!(value.norm() <= peak.value * (1.0 + 1e-13), "{j}: {value}, {peak:?}");
            prop_assert!(value.re.abs() <= real.value * (1.0 + 1e-13), "{j}: {value}, {real:?}");
        }
    }
}

proptest! {
    // Twenty-four orders of six rods take long to enclose.
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// The sum of 24 orders is the motion itself, and no point of it lies above the peak.
    #[test]
    fn peak_of_many_orders_is_the_largest_force_of_the_moving_pistons(text in random_engine()) {
        let layout = engine(&text);
        let pistons = Pistons::of(&layout);
        let orders: Vec<u32> = (1..=24).collect();
        let loads = computed(&layout, &orders);
        let path: Vec<_> = (0..2000).map(|j| pistons.at(TAU * f64::from(j) / 2000.0)).collect();
        for (place, waveform) in [&loads.force, &loads.moment].into_iter().enumerate() {
            let largest = path.iter().map(|values| values[place].norm()).fold(0.0, f64::max);
            let peak = waveform.peak();
            prop_assert!(peak.value >= largest - 1e-9 && peak.value <= largest * (1.0 + 1e-4) + 1e-9, "{} {}", peak.value, largest);
            if let Some(angle) = peak.angle {
                let there = pistons.at(angle.to_radians())[place];
                prop_assert!((there - peak.vector).norm() < 1e-7 * (1.0 + peak.value), "{} {}", there, peak.vector);
            }
        }
    }
}

/// `cos 7θ` and a little of `cos (θ − 360°/7)`: the highest of the seven tops stands between samples, a lower one on a sample.
#[test]
fn peak_is_the_higher_of_two_tops_though_a_sample_stands_on_the_lower() {
    // 720 samples and seven tops: that at 0 stands on a sample, the others do not. The first order lifts that near 51.43°.
    let small = 1e-5;
    let harmonic = |order, value: Complex<f64>| Harmonic { order, direct: value / 2.0, reverse: value.conj() / 2.0 };
    let lift = Complex::cis(-TAU / 7.0) * small;
    let waveform = Waveform::new([harmonic(7, Complex::new(1.0, 0.0)), harmonic(1, lift)]);
    let peak = waveform.peak();
    is_near(peak.value, 1.0 + small, 1e-12);
    is_near(peak.angle.expect("a place"), 360.0 / 7.0, 1e-6);
}

/// The same engine with hostile rods: cylinders 1 and 2 pull one way at order 2, cylinders 3 and 4 the other.
fn four_with_rods(ratios: &str) -> Engine {
    engine(&format!(
        "inline = {{ throws = [0, 0, 90, 90], spacing = 1 }}\nmechanism = {{ rod_ratio = {ratios}, reciprocating_mass = 1 }}"
    ))
}

#[test]
fn rods_of_two_kinds_make_classes_that_vanish_each_for_itself_or_not() {
    // Each class has one pull each way.
    let balanced = computed(&four_with_rods("[0.25, 0.3, 0.25, 0.3]"), &[2]);
    assert_eq!(balanced.orders[0].force.direct.outcome, Outcome::Zero);
    assert_eq!((balanced.orders[0].force.largest(), balanced.coefficients), (0.0, 2));
    // Each class pulls one way: not zero by an enclosure.
    let split = computed(&four_with_rods("[0.25, 0.25, 0.3, 0.3]"), &[2]);
    assert_eq!(split.orders[0].force.direct.outcome, Outcome::NotZero);
    let crank = |ratio| SliderCrank::new(BigRational::new(ratio, 20.into()), BigRational::zero()).expect("a crank");
    let [five, six] = [5, 6].map(|ratio: i32| crank(ratio.into()).coefficient(2).re.to_float());
    is_near(split.orders[0].force.largest(), 2.0 * (six - five), 1e-13);
    assert!(split.orders[0].coefficient.is_none());
}

#[test]
fn rods_that_differ_by_ten_to_the_minus_sixty_leave_an_order_undecided() {
    let less = format!("0.24{}", "9".repeat(58));
    let undecided = computed(&four_with_rods(&format!("[0.25, 0.25, \"{less}\", \"{less}\"]")), &[1, 2]);
    for vector in [&undecided.orders[1].force.direct, &undecided.orders[1].force.reverse] {
        match vector.outcome {
            Outcome::Undecided { below } => assert!(below > 0.0 && below < 1e-18 && vector.value.norm() <= below),
            ref other => panic!("{other:?}"),
        }
    }
    assert!(!undecided.orders[1].force.vanishes());
    // The first order has no coefficient, so nothing about it is open.
    assert_eq!(undecided.orders[0].force.direct.outcome, Outcome::NotZero);
    // With rods that differ in the fifteenth place it is decided.
    let decided = computed(&four_with_rods("[0.25, 0.25, \"0.250000000000001\", \"0.250000000000001\"]"), &[2]);
    assert_eq!(decided.orders[0].force.direct.outcome, Outcome::NotZero);
}

#[test]
fn offsets_of_either_sign_are_one_class_for_even_orders_and_opposite_for_odd_ones() {
    let two = |throws: &str| {
        engine(&format!(
            "inline = {{ throws = {throws} }}\nmechanism = {{ rod_ratio = 0.25, offset_ratio = [0.02, -0.02], reciprocating_mass = 1 }}"
        ))
    };
    let together = computed(&two("[0, 0]"), &[2, 3]);
    assert!(together.orders[1].force.vanishes() && !together.orders[0].force.vanishes());
    let apart = computed(&two("[0, 90]"), &[2, 3]);
    assert!(apart.orders[0].force.vanishes() && !apart.orders[1].force.vanishes());
}

#[test]
fn zero_speed_and_zero_mass_give_zero_newtons_and_keep_the_verdicts() {
    let text = |speed: u32, mass: u32| {
        format!(
            "speed = {speed}\neffects = [\"torque\"]\ninline = {{ throws = [0, 180, 180, 0], spacing = \"0.1 m\" }}\n\
             mechanism = {{ crank_radius = 0.05, rod_ratio = 0.25, reciprocating_mass = {mass} }}"
        )
    };
    let still = engine(&text(0, 1));
    assert_eq!(newtons(&still, 2), [0.0, 0.0]);
    assert_eq!(computed(&still, &[2]).orders[0].force.direct.outcome, Outcome::NotZero);
    let weightless = computed(&engine(&text(3000, 0)), &[1, 2]);
    assert!(weightless.orders.iter().all(|order| order.force.vanishes() && order.moment.vanishes()));
    let torque = weightless.torque.expect("a torque");
    assert!(torque.orders.iter().all(|order| order.vector.outcome == Outcome::Zero));
    assert_eq!((weightless.coefficients, torque.waveform.real_peak().value), (0, 0.0));
    assert_eq!(loads(&file::find("I4").expect("an engine").engine().expect("reads"), &[1]).err(), Some(Missing::Rods));
}

#[test]
fn no_coefficient_is_computed_but_for_what_is_left_and_asked_for() {
    let six = |effects: &str| {
        format!(
            "{effects}\ninline = {{ throws = [0, 120, 240, 240, 120, 0] }}\n\
             mechanism = {{ rod_ratio = 0.25, reciprocating_mass = 1 }}"
        )
    };
    let orders = [1, 2, 3, 4, 6, 8, 10];
    let plain = computed(&engine(&six("")), &orders);
    assert_eq!(plain.coefficients, 1, "c_6 alone");
    let asked: Vec<u32> =
        plain.orders.iter().filter(|o| o.coefficient.is_some() && o.order > 1).map(|o| o.order).collect();
    assert_eq!(asked, [6]);
    assert!(plain.torque.is_none() && plain.groups.len() == 1);
    // The torque asks for t_3 and t_6, which are left of its own star.
    let turning = computed(&engine(&six("effects = [\"torque\"]")), &orders);
    assert_eq!(turning.coefficients, 1 + 2);
    // Nothing that moves to and fro is computed for rotating masses: their coefficient is 1.
    let text =
        "inline = { throws = [0, 120] }\nmechanism = { rod_ratio = 0.25, reciprocating_mass = 0, rotating_mass = 1 }";
    assert_eq!(computed(&engine(text), &orders).coefficients, 0);
}

/// The largest distance between the motion itself and the orders that were kept.
fn true_error(layout: &Engine, kept: &[u32], place: usize) -> f64 {
    let loads = computed(layout, kept);
    let waveform = [&loads.force, &loads.moment][place];
    let pistons = Pistons::of(layout);
    let places = (0..4000).map(|j| TAU * f64::from(j) / 4000.0);
    places.map(|theta| (pistons.at(theta)[place] - waveform.at(theta)).norm()).fold(0.0, f64::max)
}

#[test]
fn dropped_orders_err_by_less_than_the_bound_says() {
    let mechanism = |ratio: &str| format!("mechanism = {{ rod_ratio = {ratio}, reciprocating_mass = 1 }}\n");
    let v4 = "vee = { bank_angle = 75, throws = [0, 180] }";
    let cases = [
        (mechanism("0.25") + v4, 1e-3),
        (mechanism("0.25") + v4, 1e-6),
        (mechanism("0.6") + "inline = { throws = [0] }", 1e-4),
        (mechanism("0.9") + "inline = { throws = [0] }", 1e-4),
        (mechanism("0.25, offset_ratio = 0.02") + "inline = { throws = [0, 120, 240] }", 1e-3),
        (mechanism("[0.25, 0.3, 0.35]") + "inline = { throws = [0, 120, 240] }", 1e-4),
        (mechanism("0.25") + "inline = { throws = [0, 120, 240, 240, 120, 0] }", 1e-3),
    ];
    for (text, accuracy) in cases {
        let layout = engine(&text);
        let needed = needed_orders(&layout, accuracy).expect("numbers");
        assert!(needed.reached, "{text}: {needed:?}");
        assert!(needed.kept.iter().all(|order| !needed.dropped.contains(order)));
        let all = computed(&layout, &(1..=needed.looked_at).collect::<Vec<_>>());
        let left = all.orders.iter().filter(|order| !order.force.vanishes() || !order.moment.vanishes());
        assert_eq!(left.count(), needed.kept.len() + needed.dropped.len(), "{text}: {needed:?}");
        for (place, bound) in [&needed.left.force, &needed.left.moment].into_iter().enumerate() {
            let bound = bound.map(|bound| bound.part().expect("a part of the peak"));
            let error = true_error(&layout, &needed.kept, place);
            let path = (0..4000).map(|j| Pistons::of(&layout).at(TAU * f64::from(j) / 4000.0)[place].norm());
            let peak = path.fold(0.0, f64::max);
            match bound {
                Some(bound) => {
                    assert!(bound <= accuracy && error <= (bound + 1e-12) * peak, "{text}: {error} {bound} {needed:?}");
                }
                None => assert!(peak < 1e-13, "{text}: {peak}"),
            }
        }
    }
}

#[test]
fn auto_keeps_just_the_orders_that_a_thousandth_needs() {
    let six = engine(
        "mechanism = { rod_ratio = 0.25, reciprocating_mass = 1 }\ninline = { throws = [0, 120, 240, 240, 120, 0] }",
    );
    let needed = needed_orders(&six, 1e-3).expect("numbers");
    assert_eq!((needed.kept, needed.dropped), (vec![6], vec![12]));
    assert_eq!(needed.left.moment, None);
    let four =
        engine("mechanism = { rod_ratio = 0.25, reciprocating_mass = 1 }\ninline = { throws = [0, 180, 180, 0] }");
    assert_eq!(needed_orders(&four, 1e-3).expect("numbers").kept, [2, 4]);
    assert_eq!(needed_orders(&four, 0.05).expect("numbers").kept, [2]);
}

#[test]
fn auto_finds_a_force_that_begins_above_the_first_orders_it_looks_at() {
    // 27 even throws leave orders 54, 108, …
    let throws: Vec<String> = (0..27).map(|j| format!("\"{j}/27 turn\"")).collect();
    let mechanism = "mechanism = { rod_ratio = 0.25, reciprocating_mass = 1 }";
    let engine =
        engine(&format!("{mechanism}\ninline = {{ throws = [{}], positions = {:?} }}", throws.join(", "), [0; 27]));
    let needed = needed_orders(&engine, 1e-3).expect("numbers");
    assert_eq!((needed.kept.as_slice(), needed.looked_at > 24), ([54].as_slice(), true), "{needed:?}");
}

#[test]
fn auto_says_nothing_of_pistons_without_mass() {
    let text = "inline = { throws = [0] }\nmechanism = { rod_ratio = 0.25, reciprocating_mass = 0, rotating_mass = 1 }";
    let needed = needed_orders(&engine(text), 1e-3).expect("numbers");
    assert!(needed.left.force.is_none_or(|bound| bound.most < 1e-9), "{needed:?}");
    assert_eq!((needed.kept, needed.dropped, needed.reached), (vec![1], vec![], true));
}

#[test]
fn a_force_too_short_to_be_squared_has_its_peak_all_the_same() {
    let text = "speed = 6000\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\n[mechanism]\nreciprocating_mass = 0.65\n\
                crank_radius = 0.045\nrod_ratio = 1e-99\noffset_ratio = 0.01\n";
    let needed = needed_orders(&engine(text), 1e-3).expect("orders");
    assert!(needed.reached);
    assert_eq!(needed.looked_at, 12);
    assert!(needed.left.force.is_none_or(|force| force.peak > 0.0));
}
