//! Do the main bearings feel what a beam on supports hands on, order by order and through a revolution?

use crankstar::beam::Beam;
use crankstar::engine::Engine;
use crankstar::file::parse;
use crankstar::loads::{BearingLoads, Harmonic, Method, Missing, Waveform, bearing_loads, left_out_of_pins, pin_loads};
use crankstar::motion::SliderCrank;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use std::process::{Command, Output};

use crate::support::dice::Dice;
use crate::support::program::scratch;
use crate::support::written::engine as layout;

fn crankstar(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_crankstar")).args(arguments).output().expect("the program starts")
}

/// A layout file of its own for one test.
fn file(name: &str, text: &str) -> String {
    let path = scratch(name).join(name);
    std::fs::write(&path, text).expect("a file");
    path.to_str().expect("a path in UTF-8").to_owned()
}

/// The in-line three of the thesis, without counterweights.
const I3: &str = "speed = 6000
bearings = [0.15, 0.05, -0.05, -0.15]
[inline]
throws = [0, 120, 240]
spacing = 0.1
[mechanism]
reciprocating_mass = 0.65
rotating_mass = 0.5
crank_radius = '45 mm'
rod_ratio = 0.25
";

fn solved(layout: &Engine, orders: &[u32], method: Method) -> BearingLoads {
    bearing_loads(layout, orders, method).unwrap_or_else(|missing| panic!("{missing}"))
}

fn newtons(loads: &BearingLoads) -> f64 {
    loads.scale.as_ref().expect("an engine with mass, crank and speed").force()
}

/// What is above adds less than a ten-thousandth of a newton to the engines of the thesis.
const EXACT: [u32; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

#[test]
fn rotating_loads_of_the_flat_four_are_25_56_9_28_minus_43_28_9_28_25_56() {
    let text = "bearings = [2, 1, 0, -1, -2]
        [inline]
        throws = [0, 180, 180, 0]
        [mechanism]
        rod_ratio = 0.25
        reciprocating_mass = 0
        rotating_mass = 1";
    let loads = solved(&layout(text), &[1, 2], Method::Continuous);
    // Twice the mass-radius of a crankpin stands in P⁺; the middle pins point the other way.
    let half = BigRational::new(1.into(), 2.into());
    let direct = |order: usize| -> Vec<String> {
        let sums = loads.bearings.iter().map(|bearing| &bearing.orders[order].sums[0]);
        sums.map(|parts| {
            let terms = parts.parts().values().flat_map(|sum| sum.collected());
            let along = terms.map(|term| {
                let degrees = term.angle.degrees();
                let sign = if degrees.is_zero() { 1 } else { -1 };
                assert!(degrees.is_zero() || degrees == BigRational::from_integer(180.into()));
                term.weight * BigRational::from_integer(sign.into()) * &half
            });
            along.sum::<BigRational>().to_string()
        })
        .collect()
    };
    assert_eq!(direct(0), ["25/56", "9/28", "-43/28", "9/28", "25/56"]);
    assert_eq!(direct(1), ["0"; 5]);
    assert_eq!(loads.worst, [2]);
    for (bearing, size) in loads.bearings.iter().zip([25.0 / 56.0, 9.0 / 28.0, 43.0 / 28.0, 9.0 / 28.0, 25.0 / 56.0]) {
        assert!((bearing.peak.value - size).abs() < 1e-15, "{}", bearing.peak.value);
        assert_eq!(bearing.peak.angle, None);
        assert!(bearing.orders[1].swing.vanishes());
    }
}

/// A crank of the thesis (chapter 6): throws at these angles and positions, cylinders, masses at the pins' middles.
struct Crank {
    /// Angle in degrees, position in millimetres.
    pins: Vec<(i64, i64)>,
    /// Bank angles, and how far each rod stands from the middle of its pin.
    rods: Vec<(i64, i64)>,
    /// Mass at the middle of a pin, and of each rod's big end, in grams.
    pin_mass: i64,
    big_end: i64,
    bearings: Vec<i64>,
    /// From the middle of a pin to its webs, which carry the counterweights.
    web: i64,
}

impl Crank {
    fn i3() -> Self {
        let pins = vec![(0, 100), (120, 0), (240, -100)];
        Crank { pins, rods: vec![(0, 0)], pin_mass: 500, big_end: 0, bearings: vec![150, 50, -50, -150], web: 20 }
    }

    fn v8(throws: [i64; 4]) -> Self {
        let pins = throws.into_iter().zip([180, 60, -60, -180]).collect();
        let bearings = vec![240, 120, 0, -120, -240];
        Crank { pins, rods: vec![(-45, 8), (45, -8)], pin_mass: 200, big_end: 300, bearings, web: 30 }
    }

    fn flat_plane() -> Self {
        Crank::v8([0, 180, 180, 0])
    }

    fn cross_plane() -> Self {
        Crank::v8([0, 270, 90, 180])
    }

    /// The layout, with two counterweights opposite to each pin for a balance factor in hundredths. Pins and
    /// counterweights are cylinders without a reciprocating mass.
    fn layout(&self, balance_factor: i64) -> Engine {
        self.with_counterweights(balance_factor, &vec![180; 2 * self.pins.len()])
    }

    /// The same with the angle of each counterweight to its pin.
    fn with_counterweights(&self, balance_factor: i64, angles: &[i64]) -> Engine {
        let bearings: Vec<String> = self.bearings.iter().map(|at| format!("'{at} mm'")).collect();
        let (mut tables, mut masses) = (String::new(), Vec::new());
        let mut add = |throw: i64, bank: i64, at: i64, reciprocating: i64, rotating: String| {
            tables += &format!(
                "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{at} mm'\nreciprocating_mass = '{reciprocating} g'\n"
            );
            masses.push(format!("'{rotating}'"));
        };
        let count = self.rods.len() as i64;
        let turning = self.pin_mass + count * self.big_end + count * 650 / 2;
        for (index, &(throw, at)) in self.pins.iter().enumerate() {
            for &(bank, aside) in &self.rods {
                add(throw, bank, at + aside, 650, format!("{} g", self.big_end));
            }
            add(throw, 0, at, 0, format!("{} g", self.pin_mass));
            for (side, aside) in [self.web, -self.web].into_iter().enumerate() {
                // A balance factor in hundredths of grams, shared by two.
                let mass = format!("{}/200000", balance_factor * turning);
                add(throw + angles[2 * index + side], 0, at + aside, 0, mass);
            }
        }
        layout(&format!(
            "speed = 6000\nbearings = [{}]\n{tables}\n[mechanism]\ncrank_radius = '45 mm'\nrod_ratio = 0.25\nrotating_mass = [{}]",
            bearings.join(", "),
            masses.join(", "),
        ))
    }
}

/// Peaks of |R|, |R_y| and |R_x| in newtons by the model of the thesis: orders 1 and 2 of the forces along the cylinder axes, c_2 = λ.
fn as_in_the_thesis(layout: &Engine, method: Method) -> Vec<[f64; 3]> {
    let beam = Beam::new(layout.bearings().to_vec()).expect("a beam");
    let float = |number: &BigRational| number.to_f64().expect("a number");
    let unit = float(&layout.unit_mass());
    let newtons = unit * 0.045 * (200.0 * std::f64::consts::PI).powi(2);
    let mut harmonics = vec![Vec::new(); layout.bearings().len()];
    for cylinder in layout.cylinders() {
        let parts = match method {
            Method::Continuous => beam.influence(&cylinder.position),
            Method::Determinate => beam.determinate(&cylinder.position),
        };
        let turn = |degrees: BigRational| float(&degrees).to_radians();
        let (throw, bank) = (turn(cylinder.throw.degrees()), turn(cylinder.bank.degrees()));
        let (to_and_fro, rotating) = (float(&cylinder.reciprocating_mass), float(&cylinder.rotating_mass) / unit);
        for (of_bearing, part) in harmonics.iter_mut().zip(parts) {
            let part = float(&part) * newtons;
            let half = |angle: f64| Complex::from_polar(to_and_fro * part / 2.0, angle);
            let first = half(throw) + Complex::from_polar(rotating * part, throw);
            of_bearing.push(Harmonic { order: 1, direct: first, reverse: half(2.0 * bank - throw) });
            let (direct, reverse) = (half(2.0 * throw - bank) * 0.25, half(3.0 * bank - 2.0 * throw) * 0.25);
            of_bearing.push(Harmonic { order: 2, direct, reverse });
        }
    }
    let peaks = harmonics.into_iter().map(|harmonics| {
        let waveform = Waveform::new(harmonics);
        let across = waveform.turned(Complex::new(0.0, -1.0));
        [waveform.peak().value, waveform.real_peak().value, across.real_peak().value]
    });
    peaks.collect()
}

#[track_caller]
fn assert_near(found: &[f64], printed: &[f64]) {
    assert_eq!(found.len(), printed.len());
    for (found, printed) in found.iter().zip(printed) {
        assert!((found - printed).abs() <= 0.06, "{found} for {printed}");
    }
}

fn column(peaks: &[[f64; 3]], place: usize) -> Vec<f64> {
    peaks.iter().map(|peak| peak[place]).collect()
}

#[test]
fn peaks_with_the_model_of_the_thesis_are_those_of_an_independent_computation() {
    // Continuous beam, |R|, |R_y|, |R_x| from the first bearing on; in the last column the determinate |R|.
    type Case = (fn() -> Crank, i64, [&'static [f64]; 4]);
    let cases: [Case; 9] = [
        (
            Crank::i3,
            0,
            [
                &[9978.7, 18736.0, 18736.0, 9978.7],
                &[9969.1, 18724.5, 18724.5, 9969.1],
                &[3852.7, 7199.2, 7199.2, 3852.7],
                &[11658.5; 4],
            ],
        ),
        (
            Crank::i3,
            65,
            [
                &[5765.1, 11510.4, 11510.4, 5765.1],
                &[5764.2, 11509.8, 11509.8, 5764.2],
                &[395.4, 128.2, 128.2, 395.4],
                &[6895.2; 4],
            ],
        ),
        (
            Crank::i3,
            100,
            [
                &[3517.5, 7645.2, 7645.2, 3517.5],
                &[3507.7, 7635.2, 7635.2, 3507.7],
                &[2646.4, 3940.7, 3940.7, 2646.4],
                &[4330.3; 4],
            ],
        ),
        (
            Crank::flat_plane,
            0,
            [
                &[13610.3, 13879.9, 42208.1, 13879.9, 13610.3],
                &[11606.3, 8334.3, 39348.0, 8334.3, 11606.3],
                &[12053.2, 12314.3, 39999.6, 12314.3, 12053.2],
                &[15379.8, 5305.5, 28991.3, 5305.5, 15379.8],
            ],
        ),
        (
            Crank::flat_plane,
            65,
            [
                &[5929.5, 9987.3, 18800.4, 9987.3, 5929.5],
                &[4062.6, 4464.8, 15876.8, 4464.8, 4062.6],
                &[4954.9, 9134.8, 17268.0, 9134.8, 4954.9],
                &[7046.6, 5305.5, 12380.1, 5305.5, 7046.6],
            ],
        ),
        (
            Crank::flat_plane,
            100,
            [
                &[2314.3, 7973.1, 6424.9, 7973.1, 2314.3],
                &[1150.1, 2600.8, 3238.5, 2600.8, 1150.1],
                &[2248.4, 7538.8, 6098.0, 7538.8, 2248.4],
                &[2718.8, 5305.5, 4082.6, 5305.5, 2718.8],
            ],
        ),
        (
            Crank::cross_plane,
            0,
            [
                &[13007.9, 27018.6, 7864.7, 27632.5, 13269.3],
                &[11084.2, 26946.4, 1978.4, 24157.9, 10799.7],
                &[11663.6, 24835.7, 7770.7, 27624.1, 12218.5],
                &[15379.8, 19847.9, 5305.5, 19337.8, 15379.8],
            ],
        ),
        (
            Crank::cross_plane,
            65,
            [
                &[5725.0, 11865.6, 7864.7, 12466.5, 6055.2],
                &[4091.2, 11777.1, 1978.4, 8988.7, 3523.2],
                &[4715.6, 9666.4, 7770.7, 12454.8, 5572.1],
                &[7046.6, 8008.2, 5305.5, 7502.1, 7046.6],
            ],
        ),
        (
            Crank::cross_plane,
            100,
            [
                &[2621.5, 3794.8, 7864.7, 4315.3, 3291.7],
                &[1798.4, 3609.6, 1978.4, 822.4, 838.3],
                &[2353.4, 1498.9, 7770.7, 4286.9, 3283.6],
                &[2718.8, 1633.1, 5305.5, 1633.1, 2718.8],
            ],
        ),
    ];
    for (crank, balance_factor, printed) in cases {
        let layout = crank().layout(balance_factor);
        let peaks = as_in_the_thesis(&layout, Method::Continuous);
        for (place, printed) in printed[..3].iter().enumerate() {
            assert_near(&column(&peaks, place), printed);
        }
        let peaks = as_in_the_thesis(&layout, Method::Determinate);
        assert_near(&column(&peaks, 0), printed[3]);
    }
}

#[test]
fn peaks_with_the_skewed_counterweights_of_the_in_line_three() {
    let layout = Crank::i3().with_counterweights(100, &[210, 180, 180, 180, 180, 150]);
    let peaks = as_in_the_thesis(&layout, Method::Continuous);
    assert_near(&column(&peaks, 0), &[5653.5, 7156.2, 7156.2, 5653.5]);
}

/// Sampled apart from this program: the force along each rod that its piston's acceleration asks for, on a beam by the force method.
#[test]
fn worst_peaks_with_exact_kinematics_and_side_forces_and_of_the_first_order_alone() {
    type Case = (fn() -> Crank, i64, f64, f64);
    let cases: [Case; 9] = [
        (Crank::i3, 0, 18745.69, 16558.14),
        (Crank::i3, 65, 11513.49, 9321.66),
        (Crank::i3, 100, 7633.99, 5442.19),
        (Crank::flat_plane, 0, 43602.60, 39925.97),
        (Crank::flat_plane, 65, 20153.19, 16454.78),
        (Crank::flat_plane, 100, 8206.10, 3816.44),
        (Crank::cross_plane, 0, 28315.07, 26660.19),
        (Crank::cross_plane, 65, 13146.11, 11490.64),
        (Crank::cross_plane, 100, 7824.46, 3322.43),
    ];
    for (crank, balance_factor, exact, first) in cases {
        let layout = crank().layout(balance_factor);
        let worst = |orders: &[u32]| {
            let loads = solved(&layout, orders, Method::Continuous);
            loads.bearings[loads.worst[0]].peak.value * newtons(&loads)
        };
        assert_near(&[worst(&[1])], &[first]);
        assert_near(&[worst(&EXACT)], &[exact]);
    }
}

#[test]
fn the_worst_bearings_are_those_of_the_largest_peak_and_equal_ones_share_the_place() {
    let worst = |crank: Crank, balance_factor| solved(&crank.layout(balance_factor), &EXACT, Method::Continuous).worst;
    assert_eq!(worst(Crank::i3(), 0), [1, 2]);
    assert_eq!(worst(Crank::flat_plane(), 0), [2]);
    assert_eq!(worst(Crank::flat_plane(), 65), [2]);
    assert_eq!(worst(Crank::flat_plane(), 100), [1, 3]);
    assert_eq!(worst(Crank::cross_plane(), 0), [3]);
    assert_eq!(worst(Crank::cross_plane(), 65), [3]);
    assert_eq!(worst(Crank::cross_plane(), 100), [2]);
}

/// A random engine on random bearings, some cylinders beyond the outer ones.
fn random(dice: &mut Dice) -> Engine {
    let cylinders = dice.below(7) + 1;
    let mut tables = String::new();
    let (mut ratios, mut radii, mut masses) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..cylinders {
        tables += &format!(
            "[[cylinder]]\nthrow = '{}/7 turn'\nbank = {}\nposition = '{}/11'\nreciprocating_mass = '{}/3'\n",
            dice.below(28),
            dice.below(24) * 15,
            dice.below(90) as i64 - 45,
            dice.below(4),
        );
        ratios.push(format!("'{}/40'", dice.below(3) * 3 + 8));
        radii.push(format!("'{}/100'", dice.below(3) + 4));
        masses.push(format!("'{}/7'", dice.below(4)));
    }
    let mut bearings = vec![-3.5];
    for _ in 0..=dice.below(6) {
        bearings.push(bearings[bearings.len() - 1] + (dice.below(20) + 1) as f64 / 8.0);
    }
    if dice.below(2) == 0 {
        bearings.reverse();
    }
    layout(&format!(
        "speed = {}\nbearings = {bearings:?}\n{tables}\n[mechanism]\nrod_ratio = [{}]\ncrank_radius = [{}]\nrotating_mass = [{}]",
        dice.below(5000) + 1,
        ratios.join(", "),
        radii.join(", "),
        masses.join(", "),
    ))
}

#[test]
fn reactions_sum_to_the_pin_loads_and_their_moments_order_by_order_and_at_every_angle() {
    let mut dice = Dice::new(11);
    for _ in 0..12 {
        let layout = random(&mut dice);
        let whole = pin_loads(&layout, &[1, 2, 3, 4]).expect("the loads of the pins");
        for method in [Method::Continuous, Method::Determinate] {
            let loads = solved(&layout, &[1, 2, 3, 4], method);
            let largest = loads.bearings.iter().map(|bearing| bearing.peak.value).fold(1e-12, f64::max);
            for step in 0..12 {
                let theta = f64::from(step) * 0.55;
                let arm = |at: &BigRational| (at - layout.reference_plane()).to_f64().expect("a position");
                let reactions =
                    || loads.bearings.iter().map(|bearing| (bearing.waveform.at(theta), arm(&bearing.position)));
                let pins = || whole.pins.iter().map(|pin| (pin.waveform.at(theta), arm(&pin.position)));
                let force = reactions().map(|(force, _)| force).sum::<Complex<f64>>();
                let moment = reactions().map(|(force, arm)| force * arm).sum::<Complex<f64>>();
                let pin_force = pins().map(|(force, _)| force).sum::<Complex<f64>>();
                let pin_moment = pins().map(|(force, arm)| force * arm).sum::<Complex<f64>>();
                assert!((force - pin_force).norm() < 1e-12 * largest);
                assert!((moment - pin_moment).norm() < 1e-11 * largest);
            }
        }
    }
}

#[test]
fn the_sum_of_orders_is_what_the_closed_form_of_the_motion_gives() {
    let mut dice = Dice::new(5);
    let orders: Vec<u32> = (1..=30).collect();
    for _ in 0..5 {
        let layout = random(&mut dice);
        let beam = Beam::new(layout.bearings().to_vec()).expect("a beam");
        let loads = solved(&layout, &orders, Method::Continuous);
        let float = |number: &BigRational| number.to_f64().expect("a number");
        // The unit is m r, or one kilogram times r where every reciprocating mass is zero.
        let mechanism = layout.dimensions();
        let unit = mechanism.mass.as_ref().map(float).filter(|mass| *mass > 0.0).unwrap_or(1.0);
        let has_mass = mechanism.mass.as_ref().is_some_and(|mass| !mass.is_zero());
        for step in 0..9 {
            let theta = 0.7 * f64::from(step);
            let mut reactions = vec![Complex::new(0.0, 0.0); layout.bearings().len()];
            for cylinder in layout.cylinders() {
                let rod = cylinder.rod().expect("a rod");
                let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).expect("a crank");
                let turn = |degrees: BigRational| float(&degrees).to_radians();
                let (throw, bank) = (turn(cylinder.throw.degrees()), turn(cylinder.bank.degrees()));
                let mass = if has_mass { float(&cylinder.reciprocating_mass) } else { 0.0 };
                let psi = theta + throw - bank;
                let sine = float(&rod.ratio) * psi.sin() - float(&rod.offset);
                let along_the_rod = Complex::new(1.0, -sine / (1.0 - sine * sine).sqrt());
                let piston = along_the_rod * -mass * crank.acceleration(psi) * Complex::cis(bank);
                let rotating = float(&cylinder.rotating_mass) / unit;
                let force = piston + Complex::from_polar(rotating, theta + throw);
                let force = force * float(&cylinder.crank_radius);
                for (sum, part) in reactions.iter_mut().zip(beam.influence(&cylinder.position)) {
                    *sum += force * float(&part);
                }
            }
            for (bearing, expected) in loads.bearings.iter().zip(&reactions) {
                let found = bearing.waveform.at(theta);
                assert!((found - expected).norm() < 1e-9 * (1.0 + expected.norm()), "{found} for {expected}");
            }
        }
    }
}

#[test]
fn bearings_are_answered_in_the_order_of_the_file() {
    let text = |bearings: &str| {
        let rest = "[inline]\nthrows = [0, 120, 240]\npositions = [3, 2, 1.1]\n[mechanism]\nrod_ratio = 0.3";
        format!("bearings = {bearings}\n{rest}")
    };
    let rising = solved(&layout(&text("[1, 2.5, 4]")), &[1, 2], Method::Continuous);
    let mixed = solved(&layout(&text("[2.5, 4, 1]")), &[1, 2], Method::Continuous);
    let peaks = |loads: &BearingLoads, order: [usize; 3]| order.map(|index| loads.bearings[index].peak.value);
    assert_eq!(peaks(&rising, [1, 2, 0]), peaks(&mixed, [0, 1, 2]));
}

#[test]
fn a_load_over_a_bearing_is_felt_there_alone() {
    let text = "bearings = [3, 2, 1]\n[inline]\nthrows = [0]\npositions = [2]\n[mechanism]\nrod_ratio = 0.3";
    let loads = solved(&layout(text), &[1, 2, 4], Method::Continuous);
    assert_eq!(loads.worst, [1]);
    for outer in [0, 2] {
        assert!(loads.bearings[outer].orders.iter().all(|order| order.swing.vanishes()));
        assert_eq!(loads.bearings[outer].peak.value, 0.0);
    }
    // The side force of the piston stands across the axis.
    assert!(loads.bearings[1].across.value > 0.1);
    let [one] = &pin_loads(&layout(text), &[1, 2, 4]).expect("the load of the pin").pins[..] else { panic!("one pin") };
    assert_eq!(one.waveform, loads.bearings[1].waveform);
}

#[test]
fn a_layout_without_bearings_or_rods_has_no_bearing_loads() {
    let asked = |text: &str| bearing_loads(&layout(text), &[1], Method::Continuous).expect_err("something is missing");
    assert_eq!(asked("[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.3"), Missing::Bearings);
    assert_eq!(asked("bearings = [1, 0]\n[inline]\nthrows = [0]"), Missing::Rods);
}

#[test]
fn the_command_prints_peaks_beside_the_determinate_ones_and_marks_the_worst() {
    let file = file("bearings-table.toml", I3);
    let output = crankstar(&["bearings", &file, "--orders", "1"]);
    let text = String::from_utf8(output.stdout).expect("a text");
    assert!(output.status.success(), "{text}");
    let row = |number: &str, text: &str| {
        let starts = |line: &&str| line.trim_start().starts_with(number);
        text.lines().find(starts).unwrap_or_else(|| panic!("no row {number} in {text}")).to_owned()
    };
    assert!(row("2 ", &text).contains("≈ 16558,") && text.contains("worst"), "{text}");
    assert!(row("1 ", &text).contains("≈ 8861 "), "{text}");
    assert!(text.contains("Largest force: bearings 2, 3 with ≈ 16558 N"), "{text}");
}

#[test]
fn the_page_has_two_drawings_a_bearing_and_the_exact_parts() {
    let file = file("bearings-page.toml", I3);
    let folder = scratch("bearings-page").join("new");
    let output = crankstar(&["bearings", &file, "--output", folder.to_str().expect("a path in UTF-8")]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = std::fs::read_to_string(folder.join("bearings.md")).expect("the page");
    for number in 1..=4 {
        for name in [format!("bearing-{number}.svg"), format!("bearing-{number}-polar.svg")] {
            assert!(page.contains(&format!("({name})")) && folder.join(&name).is_file(), "{name}");
        }
    }
    assert!(page.contains("| 0.1 | 0.4 | 0.725 | −0.15 | 0.025 |"), "{page}");
    let rows = page.lines().filter(|line| line.starts_with('|'));
    let widths: std::collections::BTreeSet<usize> = rows.map(|row| row.matches('|').count()).collect();
    assert_eq!(widths, [4, 6, 7, 8].into(), "columns of numbers, parts and pins, vectors, peaks and orders");
}

#[test]
fn the_document_holds_the_exact_sums_that_its_amplitudes_come_from() {
    let file = file("bearings-json.toml", I3);
    let output = crankstar(&["bearings", &file, "--orders", "1,2,3", "--json"]);
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("a document");
    let engine = parse("i3.toml", I3).expect("it reads");
    let newtons = crankstar::loads::scale(&engine).expect("a scale").force();
    let fraction = |value: &serde_json::Value| {
        let number: BigRational = value.as_str().expect("a fraction").parse().expect("a fraction");
        number.to_f64().expect("a number")
    };
    let rows = |table: &str| document[table].as_array().expect("rows").clone();
    let (terms, mut compared) = (rows("terms"), 0);
    for order in rows("orders").iter().filter(|order| order["method"] == "continuous" && order["order"] == 1) {
        for sense in ["direct", "reverse"] {
            // n_1 = 1 − 1/√(1−λ²), beside the 1 of the force along the axis.
            let n_1 = 1.0 - 1.0 / (1.0_f64 - 0.0625).sqrt();
            let is_of = |term: &&serde_json::Value| {
                term["bearing"] == order["bearing"] && term["order"] == 1 && term["sense"] == sense
            };
            let vector = terms.iter().filter(is_of).map(|term| {
                let number = match term["coefficient"].as_str() {
                    Some("1") => 1.0,
                    Some("n_k of λ = 1/4, δ = 0") => n_1,
                    other => panic!("{other:?}"),
                };
                let turn = fraction(&term["angle_turns"]) * std::f64::consts::TAU;
                Complex::from_polar(fraction(&term["weight"]) * number, turn)
            });
            let length = vector.sum::<Complex<f64>>().norm() / 2.0 * newtons;
            let told = order[format!("{sense}_zero_to_peak_N")].as_f64().expect("a number");
            assert!((length - told).abs() < 1e-9 * newtons, "{length} {told}");
            compared += 1;
        }
    }
    assert_eq!(compared, 8);
    let third = terms.iter().filter(|term| term["order"] == 3);
    assert!(third.clone().count() > 0 && third.clone().all(|term| term["coefficient"] == "n_k of λ = 1/4, δ = 0"));
    let pins = rows("pins");
    let peak = |pin: &serde_json::Value| pin["force_zero_to_peak_N"].as_f64().expect("newtons");
    assert!(pins.len() == 3 && pins.iter().all(|pin| (peak(pin) - peak(&pins[0])).abs() < 1e-6));
    let bearings = rows("bearings");
    let is_worst = |row: &&serde_json::Value| row["method"] == "continuous" && row["worst"] == true;
    let worst: Vec<_> = bearings.iter().filter(is_worst).map(|row| row["bearing"].as_u64()).collect();
    assert_eq!(worst, [Some(2), Some(3)]);
    assert_eq!(document["worst"]["bearing"], 2);
    assert!(bearings.iter().all(|row| row["left_out_N"].as_f64().expect("newtons") > 0.0));
}

#[test]
fn a_layout_without_bearings_or_with_unknowns_gets_its_message() {
    let message = |text: &str, name: &str| {
        let output = crankstar(&["bearings", &file(name, text)]);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8(output.stderr).expect("a text")
    };
    assert!(message("inline.throws = [0]", "bearings-none.toml").contains("bearings = ["));
    let open = "[vee]\nbank_angle = 'phi'\nthrows = [0]";
    assert!(message(open, "bearings-open.toml").contains("[values]"));
    assert!(message("bearings = [1]\ninline.throws = [0]", "bearings-one.toml").contains("1 main bearing"));
}

/// What is not shown of a crankpin load is bounded: the load of all orders is no further from that of those shown.
#[test]
fn the_orders_that_a_crankpin_load_lacks_are_bounded() {
    let text = "speed = 6000\n[inline]\nthrows = [0, 180]\nspacing = '0.1 m'\n[mechanism]\nstroke = '80 mm'\nrod_length = '90 mm'\n\
        reciprocating_mass = '0.5 kg'\nrotating_mass = '0.3 kg'\n";
    let engine = crate::support::written::engine(text);
    let whole = pin_loads(&engine, &(1..=60).collect::<Vec<_>>()).expect("loads");
    for orders in [&[1][..], &[1, 2], &[1, 2, 4], &[2], &[1, 2, 3, 4, 5, 6, 7, 8]] {
        let shown = pin_loads(&engine, orders).expect("loads");
        let bounds = left_out_of_pins(&engine, &shown).expect("bounds");
        for ((shown, whole), bound) in shown.pins.iter().zip(&whole.pins).zip(bounds) {
            let apart = |step: u32| {
                let theta = f64::from(step).to_radians();
                (shown.waveform.at(theta) - whole.waveform.at(theta)).norm()
            };
            let most = (0..360).map(apart).fold(0.0, f64::max);
            assert!(most <= bound && bound < 3.0 * most + 1e-9, "{orders:?}: {most} beyond {bound}");
        }
    }
    let yoke = crate::support::written::engine(&text.replace("rod_length = '90 mm'", "rod_ratio = 0"));
    let shown = pin_loads(&yoke, &[1]).expect("loads");
    assert_eq!(left_out_of_pins(&yoke, &shown).expect("bounds"), [0.0, 0.0]);
}
