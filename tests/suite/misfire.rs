//! Does an engine in which one cylinder does not fire twist as the sum of its cylinders, one of them changed?

use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file;
use crankstar::page::Format;
use crankstar::report::{Question, TorqueStudy, TorsionStudy};
use crankstar::torque::{torque, torque_up_to};
use num_complex::Complex;

use crate::damped::AUTOMOTIVE;
use crate::gas::SPARK;
use crate::support::dense;
use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::program::call;
use crate::torsion::said_in_german;

const I: Complex<f64> = Complex::new(0.0, 1.0);

fn engine(layout: &str) -> Engine {
    file::parse("six.toml", layout).unwrap_or_else(|error| panic!("{layout}\n{error}"))
}

fn random(dice: &mut Dice, low: f64, high: f64) -> f64 {
    low + (high - low) * dice.below(1000) as f64 / 1000.0
}

/// A row of discs with damped shafts: inertias, stiffnesses, loss factor.
struct Row(Vec<f64>, Vec<f64>, f64);

impl Row {
    fn random(dice: &mut Dice, discs: usize) -> Self {
        let inertias = (0..discs).map(|_| random(dice, 0.02, 0.4)).collect();
        Row(inertias, (1..discs).map(|_| random(dice, 2e5, 2e6)).collect(), random(dice, 0.01, 0.05))
    }

    fn keys(&self) -> String {
        format!("[torsion]\ninertias = {:?}\nstiffnesses = {:?}\nloss_factor = {:?}\n", self.0, self.1, self.2)
    }

    /// The torque in each shaft, by a dense matrix.
    fn torques(&self, omega: f64, on_discs: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let Row(inertias, stiffnesses, loss) = self;
        let count = inertias.len();
        let mut rows = vec![vec![Complex::default(); count]; count];
        for (disc, inertia) in inertias.iter().enumerate() {
            rows[disc][disc] -= omega * omega * inertia;
        }
        for (at, stiffness) in stiffnesses.iter().enumerate() {
            let stiffness = (1.0 + I * loss) * stiffness;
            for (one, other) in [(at, at + 1), (at + 1, at)] {
                rows[one][one] += stiffness;
                rows[one][other] -= stiffness;
            }
        }
        let twists = dense::solve(rows, on_discs.to_vec());
        stiffnesses.iter().zip(twists.windows(2)).map(|(k, two)| (two[0] - two[1]) * (1.0 + I * loss) * k).collect()
    }
}

/// Every order of the vibration of a study, against the torque that `of` says of each cylinder: by its number and the order.
fn assert_vibrates(study: &TorsionStudy, row: &Row, fires: &[f64], of: impl Fn(usize, CycleOrder) -> Complex<f64>) {
    let vibration = study.at_speed().expect("a vibration");
    for one in &vibration.orders {
        let omega = TAU * one.hertz;
        let mut on_discs = vec![Complex::default(); row.0.len()];
        for (cylinder, degrees) in fires.iter().enumerate() {
            on_discs[cylinder] = of(cylinder, one.order) * Complex::cis(-one.order.value() * degrees.to_radians());
        }
        let right = row.torques(omega, &on_discs);
        // To a millionth, and of high orders, which are slight, to a millionth of 1 N·m: the integrals here are no better.
        let size = right.iter().map(|torque| torque.norm()).fold(1.0, f64::max);
        for (found, right) in one.torques.iter().zip(&right) {
            assert!((found - right).norm() < 1e-6 * size, "order {}: {found} for {right}", one.order);
        }
    }
}

/// The usual six, its firing angles in degrees by cylinder.
const HEAD: &str = "cycle = 'four-stroke'\nfiring_order = '1-5-3-6-2-4'\n";
const SIX: &str = "[inline]\nthrows = [0, 240, 120, 120, 240, 0]\n";
const FIRES: [f64; 6] = [0.0, 480.0, 240.0, 600.0, 120.0, 360.0];

#[test]
fn of_harmonics_the_cylinder_gives_no_torque() {
    let mut dice = Dice::new(41);
    for _ in 0..12 {
        let row = Row::random(&mut dice, 7);
        let silent = dice.below(6) as usize;
        let of: Vec<(u32, f64, f64)> = (1..5)
            .map(|halves| (halves, random(&mut dice, 20.0, 200.0), random(&mut dice, 0.0, 360.0).round()))
            .collect();
        let harmonic = |(halves, torque, phase): &(u32, f64, f64)| {
            format!("[[torsion.harmonic]]\norder = '{halves}/2'\ntorque = {torque:?}\nphase = {phase:?}\n")
        };
        let harmonics: String = of.iter().map(harmonic).collect();
        let layout = format!("{HEAD}speed = 2400\n{SIX}{}{harmonics}", row.keys());
        let misfiring = engine(&layout).misfiring(&(silent + 1).to_string()).expect("it fires");
        let study = TorsionStudy::new(&misfiring, &[]).expect("a shaft");
        assert_vibrates(&study, &row, &FIRES, |cylinder, order| {
            let (_, torque, phase) = of.iter().find(|(halves, ..)| *halves == order.halves()).expect("an order");
            Complex::from_polar(if cylinder == silent { 0.0 } else { *torque }, phase.to_radians())
        });
    }
}

/// Crank radius, rod and bore in metres, reciprocating mass in kilograms.
const GEOMETRY: [f64; 4] = [0.043, 0.143, 0.086, 0.5];

/// An order of `T = −F s'`, F by the cycle angle in degrees: a sum over the four-stroke cycle.
fn order_of(force: impl Fn(f64) -> f64, order: CycleOrder) -> Complex<f64> {
    let [r, l, ..] = GEOMETRY;
    let points = 14_400;
    let at = |index: u32| {
        let degrees = (f64::from(index) + 0.5) * 720.0 / f64::from(points) - 180.0;
        let psi = degrees.to_radians();
        let slope = -r * psi.sin() - r * r * psi.sin() * psi.cos() / (l * l - (r * psi.sin()).powi(2)).sqrt();
        Complex::cis(-order.value() * psi) * (-force(degrees) * slope)
    };
    (0..points).map(at).sum::<Complex<f64>>() * (2.0 / f64::from(points))
}

/// `m s''`, by differences of the piston's place.
fn inertia(omega: f64) -> impl Fn(f64) -> f64 {
    let [r, l, _, mass] = GEOMETRY;
    let place = move |psi: f64| r * psi.cos() + (l * l - (r * psi.sin()).powi(2)).sqrt();
    let step = 1e-3;
    move |degrees| {
        let psi = degrees.to_radians();
        let [far, near] = [2.0, 1.0].map(|by| place(psi + by * step) + place(psi - by * step) - 2.0 * place(psi));
        mass * omega * omega * (16.0 * near - far) / (12.0 * step * step)
    }
}

/// Compression and expansion of the charge with one exponent, then the exchange of gas, as `F_g = (p − p_c) A`.
fn motored(ratio: f64, intake: f64, exhaust: f64, exponent: f64) -> impl Fn(f64) -> f64 {
    let [r, l, bore, _] = GEOMETRY;
    let area = std::f64::consts::PI / 4.0 * bore * bore;
    let volume = move |degrees: f64| {
        let psi = degrees.to_radians();
        area * (r + l - r * psi.cos() - (l * l - (r * psi.sin()).powi(2)).sqrt() + 2.0 * r / (ratio - 1.0))
    };
    let polytropic = move |degrees: f64| intake * (volume(-180.0) / volume(degrees)).powf(exponent);
    let ramp = |from: f64, to: f64, part: f64| to + (from - to) * 0.5 * (1.0 + (std::f64::consts::PI * part).cos());
    move |degrees| {
        let pressure = match degrees {
            ..130.0 => polytropic(degrees),
            ..180.0 => ramp(polytropic(130.0), exhaust, (degrees - 130.0) / 50.0),
            ..360.0 => exhaust,
            ..380.0 => ramp(exhaust, intake, (degrees - 360.0) / 20.0),
            _ => intake,
        };
        (pressure - 1e5) * area
    }
}

#[test]
fn an_ideal_cycle_is_motored_and_the_inertia_remains() {
    let mut dice = Dice::new(42);
    for _ in 0..4 {
        let row = Row::random(&mut dice, 7);
        let silent = dice.below(6) as usize;
        let (ratio, exponent) = (8.0 + dice.below(12) as f64, 1.25 + dice.below(15) as f64 / 100.0);
        let gas = format!(
            "[gas]\nbore = '86 mm'\ncrankcase = '1 bar'\nprocess = 'spark-ignition'\ncompression_ratio = {ratio}\nheat = '1100 J'\n\
             intake_pressure = '0.9 bar'\nexhaust_pressure = '1.1 bar'\ncompression_exponent = {exponent:?}\nexpansion_exponent = 1.31\n"
        );
        let mechanism = "[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\n";
        let layout = format!("{HEAD}speed = 3000\n{mechanism}{SIX}{gas}{}", row.keys());
        let firing = engine(&layout);
        let [class] = &torque_up_to(&firing, 24).expect("a torque").classes[..] else { panic!("one class") };
        let harmonics = class.harmonics.clone();
        let omega = 3000.0 * TAU / 60.0;
        let (masses, cold) = (inertia(omega), motored(ratio, 0.9e5, 1.1e5, exponent));
        let orders = || (1..=48).filter_map(CycleOrder::of_halves);
        let of_masses: Vec<_> = orders().map(|order| order_of(&masses, order)).collect();
        let unburnt: Vec<_> = orders().map(|order| order_of(&cold, order)).collect();
        let study = firing.misfiring(&(silent + 1).to_string()).expect("it fires");
        let study = TorsionStudy::new(&study, &[]).expect("a shaft");
        assert_vibrates(&study, &row, &FIRES, |cylinder, order| {
            let at = order.halves() as usize - 1;
            of_masses[at] + if cylinder == silent { unburnt[at] } else { harmonics.torque_at(order) }
        });
    }
}

#[test]
fn of_a_table_no_pressure_difference_remains_and_the_torque_says_so_without_a_warning() {
    let (head, _) = SPARK.split_once("process").expect("a process");
    let table = "unit = 'bar'\npressure = [[0, 40], [20, 60], [90, 5], [180, 2], [360, 1], [540, 1], [700, 20]]\n";
    let four = head.replace("throws = [0]", "throws = [0, 180, 180, 0]").replace("'1'", "'1-3-4-2'") + table;
    let four = format!("speed = 3000\n{four}");
    let firing = torque(&engine(&four)).expect("a torque");
    let misfire = engine(&four).misfiring("3").expect("it fires");
    let found = torque(&misfire).expect("a torque");
    assert!((found.mean - 0.75 * firing.mean).abs() < 1e-9 * firing.mean);
    assert!(found.orders.iter().all(|order| !order.gas_vanishes), "a single vector is never zero");
    for (order, whole) in found.orders.iter().zip(&firing.orders) {
        let one = firing.classes[0].harmonics.torque_at(order.order);
        let right = if whole.gas_vanishes { one.norm() } else { 3.0 * one.norm() };
        assert!((order.gas.norm() - right).abs() < 1e-9 * firing.mean, "{}", order.order);
        assert_eq!((order.inertia, order.inertia_vanishes), (whole.inertia, whole.inertia_vanishes));
    }
    assert!(found.warnings.iter().all(|(class, _)| found.classes[*class].cylinders[0] != 2), "{:?}", found.warnings);
    let study = TorqueStudy { engine: misfire, torque: found };
    let page = study.page();
    let text = pages::text(&page, Format::GITHUB);
    assert!(
        text.contains("Cylinder 3 does not fire: no pressure difference") && text.contains("that of the crankcase")
    );
    crate::languages::assert_known(&[page, study.answer()]);
}

#[test]
fn the_pages_name_the_cylinder_in_both_languages() {
    let study = TorsionStudy::new(&engine(AUTOMOTIVE).misfiring("2").expect("it fires"), &[]).expect("a shaft");
    let [page, answer] = said_in_german(&study);
    let text = pages::text(&page, Format::GITHUB);
    assert!(text.contains("not decided for a misfire") && !text.contains("The firing star is zero at"), "{text}");
    assert!(pages::text(&answer, Format::PLAIN).contains("Cylinder 2 does not fire: it gives no torque"));
    let motored = engine(SPARK).misfiring("1").expect("it fires");
    let study = TorqueStudy::new(&motored).expect("a torque");
    let page = study.page();
    assert!(pages::text(&page, Format::GITHUB).contains("expands with the same exponent"));
    assert!(study.torque.mean.abs() < 5.0, "no work of compression: {}", study.torque.mean);
    crate::languages::assert_known(&[page]);
}

#[test]
fn a_cylinder_that_cannot_misfire_is_refused() {
    let why = |layout: &str, name: &str| engine(layout).misfiring(name).expect_err("refused").to_string();
    assert_eq!(why(AUTOMOTIVE, "7"), "there is no cylinder `7` to misfire; the cylinders are 1, 2, 3, 4, 5, 6");
    let (silent, _) = AUTOMOTIVE.split_once("[[torsion.harmonic]]").expect("a harmonic");
    assert!(why(silent, "1").contains("add [gas]"));
    let compressor = "cycle = 'two-stroke'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n[inline]\nthrows = [0]\n[gas]\n\
        bore = '86 mm'\nprocess = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '7 bar'\nclearance = 0.05\n";
    assert!(why(compressor, "1").contains("a stage of a compressor"));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/i6-damper/layout.toml");
    let refused = call(&["torsion", path, "--misfire", "0"]);
    assert!(!refused.status.success() && String::from_utf8_lossy(&refused.stderr).contains("no cylinder `0`"));
    let answer = call(&["torsion", path, "--misfire", "2"]);
    assert!(String::from_utf8_lossy(&answer.stdout).contains("Cylinder 2 does not fire"));
}
