//! Are the largest values true? Those printed without any flag, against the motion itself sampled in time, for engines of every form.
use std::f64::consts::TAU;

use crankstar::accuracy::{self, Largest, LargestLoads, Method, Timing, largest};
use crankstar::claim;
use crankstar::engine::{Engine, NotAnOrder};
use crankstar::file::{self, Layout};
use crankstar::loads::{Missing, loads, needed_orders, usual_orders, vanishes_at_every_order};
use crankstar::order::Masses;
use crankstar::page::Format;
use crankstar::proof::{Planar, Quantity};
use crankstar::report::{self, Numbers};
use crankstar::verdict;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use proptest::prelude::*;

use crate::support::pages;
use crate::support::verdicts::pistons;
use crate::support::written::engine;

const QUANTITIES: [Quantity; 3] = [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE];

/// Force, moment and torque of the pistons at an angle, in m r ω², that times metres, and m r² ω²: written out once more, from the
/// position `cos ψ + √(1 − (λ sin ψ − δ)²)/λ`, without order or phasor.
fn at(layout: &Engine, theta: f64) -> [f64; 3] {
    let float = |number: &BigRational| number.to_f64().expect("a float");
    let mut sums = [[0.0; 2]; 2];
    let mut torque = 0.0;
    for cylinder in layout.cylinders() {
        let rod = cylinder.rod().expect("a rod");
        let (ratio, offset) = (float(&rod.ratio), float(&rod.offset));
        let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|turn| float(turn.turns()) * TAU);
        let (sin, cos) = (theta + throw - bank).sin_cos();
        let x = ratio * sin - offset;
        let root = (1.0 - x * x).sqrt();
        let velocity = -sin - x * cos / root;
        let acceleration = -cos + x * sin / root - ratio * cos * cos / root.powi(3);
        let (mass, radius, arm) =
            (float(&cylinder.reciprocating_mass), float(&cylinder.crank_radius), float(&layout.arm(cylinder)));
        let rotating = float(&cylinder.rotating_mass) / layout.dimensions().mass.as_ref().map_or(1.0, float);
        let force = [
            radius * (-mass * acceleration * bank.cos() + rotating * (theta + throw).cos()),
            radius * (-mass * acceleration * bank.sin() + rotating * (theta + throw).sin()),
        ];
        for axis in 0..2 {
            sums[0][axis] += force[axis];
            sums[1][axis] += force[axis] * arm;
        }
        torque -= mass * radius * radius * velocity * acceleration;
    }
    [sums[0][0].hypot(sums[0][1]), sums[1][0].hypot(sums[1][1]), torque.abs()]
}

/// The largest value that a cylinder's part of these sums has at many angles, at least 1: beside it their roundings count.
fn largest_part(layout: &Engine, steps: u32) -> f64 {
    let float = |number: &BigRational| number.to_f64().expect("a float").abs();
    let parts = layout.cylinders().iter().flat_map(|cylinder| {
        let rod = cylinder.rod().expect("a rod");
        let [ratio, offset] = [&rod.ratio, &rod.offset].map(|number| number.to_f64().expect("a float"));
        let size = (float(&cylinder.reciprocating_mass) + float(&cylinder.rotating_mass))
            * float(&cylinder.crank_radius).max(1.0).powi(2)
            * float(&layout.arm(cylinder)).max(1.0);
        (0..steps).map(move |step| {
            let x = ratio * (TAU * f64::from(step) / f64::from(steps)).sin() - offset;
            size * (1.0 - x * x).powf(-2.5)
        })
    });
    parts.fold(1.0, f64::max)
}

/// The largest values of many angles.
fn sampled(layout: &Engine, steps: u32) -> [f64; 3] {
    let mut largest = [0.0_f64; 3];
    for place in 0..steps {
        for (most, value) in largest.iter_mut().zip(at(layout, TAU * f64::from(place) / f64::from(steps))) {
            *most = most.max(value);
        }
    }
    largest
}

/// What a largest value has to be of what was sampled: not less, and hardly more.
fn is_true(text: &str, name: &str, found: Largest, sample: f64, roundings: f64) {
    match found {
        Largest::Zero => assert!(sample <= roundings, "{name} is not 0 but {sample}\n{text}"),
        Largest::Below(bound) => assert!(sample <= bound + roundings, "{name} below {bound}: {sample}\n{text}"),
        Largest::Known { value, error, .. } => {
            assert!(error <= 1e-3 * value, "{name} ≈ {value} within {error}\n{text}");
            assert!(sample <= value + error + roundings, "{name} {value} within {error}: {sample}\n{text}");
            // 20,000 samples miss a narrow top by a little.
            assert!(
                sample >= (value - error) * (1.0 - 2e-4) - roundings,
                "{name} {value} within {error}: {sample}\n{text}"
            );
        }
    }
}

fn all_are_true(text: &str) {
    let layout = engine(text);
    let samples = sampled(&layout, 20_000);
    let roundings = 1e-10 * largest_part(&layout, 720);
    for (quantity, sample) in QUANTITIES.into_iter().zip(samples) {
        let found = largest(&layout, quantity).unwrap_or_else(|missing| panic!("{text}\n{missing}"));
        is_true(text, &format!("{quantity:?}"), found, sample, roundings);
        if vanishes_at_every_order(&layout, quantity) {
            assert!(sample < roundings, "{quantity:?}: {sample}\n{text}");
        }
    }
}

/// Layouts of every form.
fn form() -> impl Strategy<Value = (String, usize)> {
    let step = || prop::sample::select(vec![45_i64, 60, 72, 90, 120, 144, 180]);
    let evenly = |count: usize, step: i64| {
        (0..count as i64).map(|place| (place * step % 360).to_string()).collect::<Vec<_>>().join(", ")
    };
    prop_oneof![
        (1..=7_usize, step()).prop_map(move |(n, step)| (format!("[inline]\nthrows = [{}]\n", evenly(n, step)), n)),
        (1..=4_usize, step(), 1..18_i64, -3..3_i64).prop_map(move |(n, step, bank, split)| {
            let throws = evenly(n, step);
            (format!("[vee]\nbank_angle = {}\nthrows = [{throws}]\npin_split = {}\n", bank * 10, split * 15), 2 * n)
        }),
        (1..=4_usize, step()).prop_map(move |(n, step)| (format!("[flat]\nthrows = [{}]\n", evenly(n, step)), 2 * n)),
        (1..=3_usize, step()).prop_map(move |(n, step)| (
            format!("[boxer]\nthrows = [{}]\nstagger = \"0.3\"\n", evenly(n, step)),
            2 * n
        )),
        (3..=9_usize).prop_map(|n| (format!("[radial]\ncylinders = {n}\n"), n)),
        prop::collection::vec((0..360_i64, 0..24_i64, -5..=5_i64), 1..=5).prop_map(|cylinders| {
            let table = |(throw, bank, at): &(i64, i64, i64)| {
                format!("[[cylinder]]\nthrow = {throw}\nbank = {}\nposition = \"{at}/10\"\n", bank * 15)
            };
            (cylinders.iter().map(table).collect::<String>(), cylinders.len())
        }),
    ]
}

fn random_engine() -> impl Strategy<Value = String> {
    let ratio = prop::sample::select(vec!["0", "0.1", "0.25", "0.3", "0.55", "0.8", "0.95"]);
    let offset = prop::sample::select(vec!["0", "0", "0.02", "-0.03", "0.0499"]);
    (form(), ratio, offset, 0..3_u32, any::<bool>()).prop_map(|((form, count), ratio, offset, rotating, alike)| {
        let ratios = match alike {
            true => format!("\"{ratio}\""),
            false => {
                let all: Vec<_> =
                    (0..count).map(|j| if j % 3 == 1 { "\"0.2\"".into() } else { format!("\"{ratio}\"") }).collect();
                format!("[{}]", all.join(", "))
            }
        };
        let rotating = if rotating == 0 { String::new() } else { format!("rotating_mass = \"{rotating}/4\"\n") };
        let mechanism =
            format!("rod_ratio = {ratios}\noffset_ratio = \"{offset}\"\nreciprocating_mass = 1\ncrank_radius = 1\n");
        format!("effects = [\"torque\"]\n{form}[mechanism]\n{mechanism}{rotating}")
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn largest_values_are_those_of_the_motion_itself(text in random_engine()) {
        all_are_true(&text);
    }

    /// What the orders that are shown leave out is within the bound, and the orders are there that matter.
    #[test]
    fn orders_shown_by_default_leave_what_their_bound_says(text in random_engine()) {
        let layout = engine(&text);
        let numbers = Numbers::new(&layout, &usual_orders(&layout), None).expect("numbers");
        let left = [&numbers.left.force, &numbers.left.moment, &numbers.left.torque];
        let torque = numbers.loads.torque.as_ref().expect("a torque");
        let shown = [numbers.loads.force.peak(), numbers.loads.moment.peak(), torque.waveform.real_peak()];
        for ((quantity, left), shown) in QUANTITIES.into_iter().zip(left).zip(shown) {
            let Largest::Known { value, error, .. } = largest(&layout, quantity).expect("numbers") else { continue };
            let bound = left.map_or(0.0, |bound| bound.most);
            prop_assert!((shown.value - value).abs() <= bound + error + 1e-10, "{quantity:?} {shown:?} {value} {bound}\n{text}");
        }
    }

    /// An accuracy is reached or is said not to be.
    #[test]
    fn an_accuracy_is_reached_or_said_not_to_be(text in random_engine(), digits in 1..5_i32) {
        let layout = engine(&text);
        let accuracy = 10_f64.powi(-digits);
        let needed = needed_orders(&layout, accuracy).expect("numbers");
        let numbers = Numbers::new(&layout, &[], Some(&needed)).expect("numbers");
        let torque = numbers.loads.torque.as_ref().expect("a torque");
        let kept = [numbers.loads.force.peak(), numbers.loads.moment.peak(), torque.waveform.real_peak()];
        for (quantity, kept) in QUANTITIES.into_iter().zip(kept) {
            let Largest::Known { value, error, .. } = largest(&layout, quantity).expect("numbers") else { continue };
            let off = (kept.value - value).abs();
            prop_assert!(!needed.reached || off <= 1.01 * accuracy * value + error + 1e-10, "{quantity:?} {off} {needed:?}\n{text}");
        }
        let lines = pages::text(&report::loads_answer(&layout, &numbers, Some(&needed), None), Format::PLAIN);
        let mut words = lines.split(|letter: char| !letter.is_alphanumeric());
        prop_assert!(!words.any(|word| ["inf", "NaN"].contains(&word)), "{lines}");
        prop_assert_eq!(lines.contains("The accuracy is reached."), needed.reached);
    }
}

const MECHANISM: &str =
    "[mechanism]\ncrank_radius = \"50 mm\"\nrod_length = \"175 mm\"\nreciprocating_mass = \"0.5 kg\"\n";

#[test]
fn five_in_line_and_radial_of_seven_have_a_torque_that_is_not_zero() {
    for (form, order) in [("[inline]\nthrows = [0, 144, 216, 288, 72]\n", 5), ("[radial]\ncylinders = 7\n", 7)] {
        let layout = engine(&format!("speed = 6000\neffects = [\"torque\"]\n{form}{MECHANISM}"));
        let numbers = Numbers::new(&layout, &usual_orders(&layout), None).expect("numbers");
        let torque = numbers.loads.torque.as_ref().expect("a torque");
        assert!(torque.orders.iter().any(|of| of.order == order && !of.vector.vanishes()), "{form}");
        let [.., sample] = sampled(&layout, 20_000);
        is_true(form, "torque", numbers.largest.torque.expect("a torque"), sample, 1e-12);
        assert!(sample > 1e-5);
    }
}

#[test]
fn near_the_end_of_the_reach_the_closed_form_tells() {
    let single = |rods: &str| {
        format!("effects = [\"torque\"]\n[inline]\nthrows = [0]\n[mechanism]\n{rods}\nreciprocating_mass = 1\n")
    };
    all_are_true(&single("rod_ratio = \"0.95\""));
    all_are_true(&single("rod_ratio = \"0.99\""));
    all_are_true(&single("rod_ratio = \"0.9\"\noffset_ratio = \"0.09\""));
    let layout = engine(&single("rod_ratio = \"0.9\"\noffset_ratio = \"0.099999\""));
    let LargestLoads { force, .. } = LargestLoads::new(&layout).expect("numbers");
    let Largest::Known { value, error, .. } = force else { panic!("{force:?}") };
    // The dead point: λ + |δ| over the root of 1 less its square, and the crank's own part.
    let reach: f64 = 0.999_999;
    let dead_point = reach / ((1.0 - reach) * (1.0 + reach)).sqrt();
    assert!(error <= 1e-3 * value && (value - dead_point).abs() < error + 3.0, "{value} {dead_point}");
}

#[test]
fn a_force_that_begins_at_a_high_order_is_found_and_is_not_zero() {
    let throws: Vec<String> = (0..23).map(|j| format!("\"{j}/23 turn\"")).collect();
    let positions = ["0"; 23].join(", ");
    let text = format!(
        "[inline]\nthrows = [{}]\npositions = [{positions}]\n[mechanism]\nrod_ratio = 0.25\nreciprocating_mass = 1\n",
        throws.join(", ")
    );
    let layout = engine(&text);
    let Largest::Known { value, error, .. } = largest(&layout, Quantity::FORCE).expect("numbers") else {
        panic!("known")
    };
    let c = crankstar::motion::SliderCrank::new(
        layout.rods().next().expect("a rod").ratio.clone(),
        BigRational::from_integer(0.into()),
    );
    let c = c.expect("a crank").coefficient(46).re.to_float().abs();
    assert!(error < 1e-3 * value && (value / (23.0 * c) - 1.0).abs() < 1e-6, "{value} {c}");
    assert_eq!(largest(&layout, Quantity::MOMENT).expect("numbers"), Largest::Zero);
}

fn loads_table(engine: &Engine, orders: &[u32]) -> Vec<Vec<String>> {
    let numbers = Numbers::new(engine, orders, None).expect("numbers");
    pages::tables(&report::loads_answer(engine, &numbers, None, None)).remove(0)
}

#[test]
fn with_an_offset_the_odd_orders_are_judged_and_without_one_they_do_not_exist() {
    let text =
        |more: &str| format!("speed = 6000\n[inline]\nthrows = [0, 120, 240]\nspacing = \"0.1 m\"\n{MECHANISM}{more}");
    let offset = engine(&text("pin_offset = \"10 mm\"\n"));
    assert!([3, 5].iter().all(|order| usual_orders(&offset).contains(order)));
    assert!(
        loads(&offset, &usual_orders(&offset))
            .expect("numbers")
            .orders
            .iter()
            .any(|of| of.order == 3 && !of.force.vanishes())
    );
    let centric = engine(&text(""));
    let judged = pistons(&centric, &[3]);
    assert_eq!(
        [report::force_left(&judged[0]).plain(), report::moment_left(&judged[0]).plain()],
        ["does not exist", "does not exist"]
    );
    let rows = loads_table(&centric, &[3]);
    assert_eq!(rows[0][1..], ["does not exist", "does not exist"]);
    for (says, holds) in [
        ("third-order force vanishes", true),
        ("third-order force = 3", false),
        ("third-order moment vanishes", true),
        ("third-order force does not vanish", false),
    ] {
        let statement = claim::parse_statement(says).expect("a claim");
        assert_eq!(claim::answer(&centric, &statement, None).status.holds(), holds, "{says}");
    }
}

#[test]
fn nothing_is_judged_of_order_0_and_no_cell_is_blank() {
    let layout =
        engine(&format!("speed = 6000\neffects = [\"torque\"]\n[inline]\nthrows = [0, 120, 240]\n{MECHANISM}"));
    let both = [Quantity::FORCE, Quantity::MOMENT];
    assert_eq!(verdict::classify(&layout, &[1, 0], Masses::All, &both).err(), Some(NotAnOrder(0)));
    assert_eq!(verdict::torque(&layout, &[1001]).err(), Some(NotAnOrder(1001)));
    assert_eq!(loads(&layout, &[0]).err(), Some(Missing::Order(NotAnOrder(0))));
    assert_eq!(loads(&layout, &[1001]).err(), Some(Missing::Order(NotAnOrder(1001))));
    let rows = loads_table(&layout, &[1]);
    assert!(rows.iter().flatten().all(|cell| !cell.is_empty()), "{rows:?}");
    assert!(
        rows.iter().any(|row| row[1] == "not computed") && rows.iter().any(|row| row[1] == "does not exist"),
        "{rows:?}"
    );
}

#[test]
fn no_method_is_compared_with_a_reference_that_is_worse_than_itself() {
    let cases = [
        "[inline]\nthrows = [0, 120, 240, 240, 120, 0]\n[mechanism]\nrod_ratio = 0.25\nreciprocating_mass = 1\n",
        "[inline]\nthrows = [0, 90, 180, 270, 270, 180, 90, 0]\n[mechanism]\nrod_ratio = 0.2\nreciprocating_mass = 1\n",
        "[inline]\nthrows = [0, 144, 216, 288, 72]\n[mechanism]\nrod_ratio = 0.3\nreciprocating_mass = 1\n",
    ];
    for text in cases {
        let study = accuracy::study(&engine(text), Quantity::FORCE, Timing::Off).expect("a study");
        for row in &study.rows {
            // Bounds leave out the roundings of doubles.
            let bound = row.bound.unwrap_or(f64::INFINITY);
            assert!(study.doubt <= bound.max(study.rounding), "{:?} {bound} {}\n{text}", row.method, study.doubt);
            if let Method::Orders(_) = row.method {
                assert!(row.error <= bound + study.rounding, "{row:?}\n{text}");
            }
        }
    }
}

#[test]
fn sweep_says_of_a_force_that_vanishes_everywhere_that_it_does() {
    // Rotating masses of three even throws cancel at every bank angle, as the pistons do.
    let text = format!(
        "speed = 6000\n[vee]\nbank_angle = 60\nthrows = [0, 120, 240]\nspacing = \"0.1 m\"\n{MECHANISM}rotating_mass = 1\n"
    );
    let template = file::Template::new("vee.toml", &text).expect("a template");
    let parameter = crankstar::sweep::Parameter::parse("vee.bank_angle=0..180:30").expect("a range");
    let sweep = crankstar::sweep::sweep(&template, &[parameter], &[1, 2, 3], &Default::default()).expect("a sweep");
    let sets = sweep.zeros.expect("angles");
    let force = |order: u32| sets.iter().filter(move |set| set.quantity == Planar::Force && set.order == order);
    assert!(force(1).all(|set| set.everywhere && set.exists), "{sets:?}");
    assert!(force(3).all(|set| !set.exists), "{sets:?}");
    assert!(matches!(file::parse_layout("vee.toml", &text), Ok(Layout::Known(..))));
}
