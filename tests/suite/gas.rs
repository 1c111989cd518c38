//! Does the gas of one cylinder press as the theory says, and do the harmonics, the work and the mean torque agree?

use std::f64::consts::{PI, TAU};

use crankstar::engine::Engine;
use crankstar::file::{self, FileResolver};
use crankstar::gas::{CylinderGas, NoGas, Warning};

use crate::support::dice::Dice;
use crate::support::written::assert_near;

/// A single of the theory's spark-ignition example.
pub const SPARK: &str = "cycle = 'four-stroke'\nfiring_order = '1'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n\
    reciprocating_mass = '0.5 kg'\n[inline]\nthrows = [0]\n[gas]\nbore = '86 mm'\ncrankcase = '1 bar'\n\
    process = 'spark-ignition'\ncompression_ratio = 10\nheat = '1100 J'\n";

/// A single of its diesel.
pub const DIESEL: &str = "cycle = 'four-stroke'\n[mechanism]\nstroke = '110 mm'\nrod_length = '180 mm'\n[inline]\nthrows = [0]\n\
    [gas]\nbore = '100 mm'\ncrankcase = '1 bar'\nprocess = 'diesel'\ncompression_ratio = 17\nheat = '2900 J'\n";

pub fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn gas(text: &str) -> CylinderGas {
    CylinderGas::new(&engine(text), 0).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Index of the half order, a and b of `t_κ = a − ib` (theory of the gas, section 4).
const SPARK_ORDERS: [(usize, f64, f64); 8] = [
    (0, 39.1561356675, 0.0),
    (1, 68.9496069482, 48.0246057206),
    (2, 39.5949331957, 76.4923862330),
    (3, 11.6026736416, 80.0682679923),
    (4, -3.59240958089, 68.2912494261),
    (5, -10.1930855594, 53.9407222421),
    (6, -11.7835149858, 42.9611502366),
    (8, -15.2797254384, 25.7762382901),
];
const DIESEL_ORDERS: [(usize, f64, f64); 8] = [
    (0, 119.058451010, 0.0),
    (1, 198.497482363, 176.243891100),
    (2, 118.377944238, 325.327817182),
    (3, 36.6345906955, 311.109171854),
    (4, -15.6310583714, 285.764593638),
    (5, -33.8001429328, 234.059156513),
    (6, -41.7326371502, 194.972785586),
    (8, -51.7976109728, 127.451457759),
];

#[test]
fn the_torque_of_both_ideal_cycles_has_the_harmonics_of_the_theory() {
    for (text, orders, mean, digit) in
        [(SPARK, SPARK_ORDERS, 9.849732895858e5, 1e-10), (DIESEL, DIESEL_ORDERS, 17.317592874112e5, 1e-9)]
    {
        let gas = gas(text);
        assert_near(gas.mean_pressure(), mean, 1e-7 * 1.1);
        let harmonics = gas.harmonics(48);
        for (index, a, b) in orders {
            let t = harmonics.torque[index];
            assert_near(t.re, a, digit);
            assert_near(-t.im, b, digit);
        }
        let largest = harmonics.force[0].norm();
        assert!(harmonics.errors.iter().all(|error| *error < 1e-11 * largest), "{:?}", harmonics.errors);
    }
}

/// A table of a smooth pressure through 720°, this many rows, at angles that are not quite even.
fn table(dice: &mut Dice, rows: usize, cycle: f64) -> Vec<(f64, f64)> {
    let row = |index: usize| {
        let angle = (index as f64 + 0.5 * dice.below(1000) as f64 / 1000.0) * cycle / rows as f64 - 200.0;
        let pressure = 1.2 + 40.0 * (-(angle - 12.0) * (angle - 12.0) / 900.0).exp() + dice.below(100) as f64 / 200.0;
        ((angle * 1e4).round() / 1e4, (pressure * 1e4).round() / 1e4)
    };
    (0..rows).map(row).collect()
}

fn layout_of(rows: &[(f64, f64)], four_stroke: bool, offset: f64) -> String {
    let rows: Vec<String> = rows.iter().map(|(angle, bar)| format!("[{angle}, {bar}]")).collect();
    let cycle = if four_stroke { "four-stroke" } else { "two-stroke" };
    format!(
        "cycle = '{cycle}'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\npin_offset = '{offset} mm'\n\
         [inline]\nthrows = [0]\n[gas]\nbore = '86 mm'\nunit = 'bar'\ndead_centre = 'crank'\npressure = [{}]",
        rows.join(", ")
    )
}

#[test]
fn loop_area_indicated_work_and_mean_torque_agree_on_random_cycles_and_tables() {
    let mut dice = Dice::new(13);
    let mut between = |low: f64, high: f64| low + (high - low) * dice.below(10_000) as f64 / 10_000.0;
    let mut texts = Vec::new();
    for _ in 0..60 {
        let (starts, lasts) = (between(-25.0, 5.0), between(20.0, 90.0));
        let opens = starts + lasts + between(0.0, 30.0);
        texts.push(format!(
            "cycle = 'four-stroke'\n[mechanism]\nstroke = '90 mm'\nrod_ratio = {}\noffset_ratio = {}\n[inline]\nthrows = [0]\n\
             [gas]\nbore = '80 mm'\ndead_centre = '{}'\nprocess = 'spark-ignition'\ncompression_ratio = {}\nheat = {}\nwiebe_exponent = {}\n\
             combustion_starts = {starts}\ncombustion_lasts = {lasts}\nexhaust_opens = {opens}\nintake_closes = {}\n",
            between(0.0, 0.4),
            between(-0.2, 0.2),
            if between(0.0, 1.0) < 0.5 { "crank" } else { "piston" },
            between(5.0, 22.0),
            between(0.0, 3000.0),
            between(0.0, 3.0),
            between(-200.0, -100.0),
        ));
    }
    let mut dice = Dice::new(14);
    texts.extend([(720, true, 0.0), (144, true, 4.0), (90, false, -3.0)].map(|(rows, four_stroke, offset)| {
        layout_of(&table(&mut dice, rows, if four_stroke { 720.0 } else { 360.0 }), four_stroke, offset)
    }));
    for text in texts {
        let gas = gas(&text);
        let harmonics = gas.harmonics(8);
        let (work, mean) = (gas.work(), harmonics.torque[0].re * gas.period());
        // Where little is burnt the loop is thin: what it is measured by is what the gas moves back and forth.
        let scale = work.abs().max(gas.peak_pressure().0 * gas.geometry().swept());
        assert_near(mean, work, 1e-9 * scale);
        assert!(harmonics.errors[2] <= 1e-9 * scale, "{:?} {text}", harmonics.errors);
    }
}

#[test]
fn harmonics_of_a_table_are_those_of_its_lines_in_closed_form() {
    let rows = table(&mut Dice::new(7), 240, 720.0);
    let gas = gas(&layout_of(&rows, true, 5.0));
    let harmonics = gas.harmonics(24);
    let area = PI / 4.0 * 0.086 * 0.086;
    let slope = |index: usize| {
        let (from, to) = (rows[index % 240], rows[(index + 1) % 240]);
        (to.1 - from.1) * 1e5 * area / (to.0 - from.0).rem_euclid(720.0).to_radians()
    };
    for index in 1..=24 {
        let kappa = index as f64 / 2.0;
        // F'' are pulses at the rows: (iκ)² F̂ = (1/Ψ) Σ Δslope e^{−iκψ}.
        let (mut re, mut im) = (0.0, 0.0);
        for (row, (angle, _)) in rows.iter().enumerate() {
            let (jump, psi) = (slope(row) - slope(row + 239), angle.to_radians());
            re += jump * (kappa * psi).cos();
            im -= jump * (kappa * psi).sin();
        }
        let scale = -2.0 / (2.0 * TAU * kappa * kappa);
        assert_near(harmonics.force[index].re, scale * re, 1e-8);
        assert_near(harmonics.force[index].im, scale * im, 1e-8);
    }
}

#[test]
fn no_harmonic_is_above_its_bound_and_the_sum_comes_to_the_torque_within_the_rest() {
    for text in [SPARK, DIESEL] {
        let gas = gas(text);
        let harmonics = gas.harmonics(96);
        let order = |index: usize| index as f64 / f64::from(harmonics.revolutions);
        for index in 1..=96 {
            assert!(harmonics.torque[index].norm() <= harmonics.bound(order(index)));
        }
        for step in 0..720 {
            let psi = f64::from(step).to_radians();
            let phase = |index: usize| num_complex::Complex::cis(psi * order(index));
            let sum: f64 = (0..=96).map(|index| (harmonics.torque[index] * phase(index)).re).sum();
            assert_near(sum, gas.torque(psi), harmonics.rest());
        }
    }
}

#[test]
fn a_peak_or_a_mean_pressure_is_reached_by_the_heat_that_is_found() {
    let with = |key: &str| SPARK.replace("heat = '1100 J'", key);
    let by_mean = gas(&with("mean_pressure = '9.849732895858 bar'"));
    assert_near(by_mean.heat().expect("a heat"), 1100.0, 1e-7);
    let peak = gas(SPARK).peak_pressure().0;
    let by_peak = gas(&with(&format!("peak_pressure = '{peak} Pa'")));
    assert_near(by_peak.heat().expect("a heat"), 1100.0, 1e-7);
    let refused = |key: &str| CylinderGas::new(&engine(&with(key)), 0).expect_err("no heat gives it");
    assert!(matches!(refused("peak_pressure = '8 bar'"), NoGas::Peak(8.0, lowest) if lowest > 10.0));
    let charged = DIESEL.replace("heat = '2900 J'", "mean_pressure = '0.5 bar'\nintake_pressure = '4 bar'");
    assert!(matches!(CylinderGas::new(&engine(&charged), 0), Err(NoGas::Mean(..))));
}

#[test]
fn a_table_that_counts_from_the_pistons_dead_centre_is_turned_to_the_cranks() {
    let text = SPARK.replace("rod_length", "pin_offset = '20 mm'\nrod_length");
    let at = |dead_centre: &str| gas(&format!("{text}dead_centre = '{dead_centre}'\n"));
    let (crank, piston) = (at("crank"), at("piston"));
    let turned = (20.0_f64 / (43.0 + 143.0)).asin();
    assert_near(piston.zero(), turned, 1e-15);
    let closed = -180.0_f64.to_radians();
    assert_near(piston.pressure(closed + turned - 1e-9), 0.9e5, 1e-2);
    assert!(crank.mean_pressure() != piston.mean_pressure());
}

#[test]
fn a_compressor_takes_the_work_of_its_loop() {
    let text = "cycle = 'two-stroke'\n[mechanism]\nstroke = '70 mm'\nrod_length = '140 mm'\n[inline]\nthrows = [0]\n[gas]\nbore = '90 mm'\n\
        process = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '7 bar'\nclearance = 0.05\n";
    let gas = gas(text);
    // Without heat: p_s V_s n/(n−1) ((p_d/p_s)^((n−1)/n) − 1), V_s what is taken in.
    let swept = PI / 4.0 * 0.09 * 0.09 * 0.07;
    let taken_in = swept * (1.05 - 0.05 * 7.0_f64.powf(1.0 / 1.3));
    let wanted = -1e5 * taken_in * 1.3 / 0.3 * (7.0_f64.powf(0.3 / 1.3) - 1.0);
    assert_near(gas.work(), wanted, 1e-9 * wanted.abs());
    assert_near(gas.harmonics(4).torque[0].re * TAU, wanted, 1e-9 * wanted.abs());
    let never = text.replace("clearance = 0.05", "clearance = 1");
    assert!(matches!(CylinderGas::new(&engine(&never), 0), Err(NoGas::Delivery)));
}

#[test]
fn what_is_odd_is_told_and_what_is_not_is_not() {
    let warnings = |text: &str| {
        let engine = engine(text);
        let gas = CylinderGas::new(&engine, 0).expect("gas");
        let (cycle, laws) = (engine.cycle().expect("a cycle"), &engine.gas().expect("gas").laws);
        gas.warnings(&laws[0], cycle)
    };
    assert_eq!(warnings(SPARK), []);
    let smooth = |shift: f64, bar: f64, step: usize| {
        let pressure = |angle: f64| {
            bar * (-(angle / 30.0).powi(2)).exp() + bar * 0.3 * (-(angle / 60.0 - 1.0).powi(2)).exp() + 1.0
        };
        let rows: Vec<(f64, f64)> =
            (-360..360).step_by(step).map(|angle| (f64::from(angle) + shift, pressure(f64::from(angle)))).collect();
        warnings(&layout_of(&rows, true, 0.0))
    };
    assert_eq!(smooth(0.0, 50.0, 5), []);
    assert!(matches!(smooth(0.0, 50.0, 10)[..], [Warning::Coarse(step)] if step == 10.0));
    assert!(matches!(smooth(0.0, 2.0, 5)[..], [Warning::Peak(_)]));
    assert!(smooth(360.0, 50.0, 5).iter().any(|one| matches!(one, Warning::PeakAngle(_))));
    assert!(smooth(-60.0, 50.0, 5).iter().any(|one| matches!(one, Warning::TakesWork(_))));
}

#[test]
fn a_table_in_a_file_beside_the_layout_is_that_in_the_layout() {
    let rows = table(&mut Dice::new(3), 180, 720.0);
    let inline = engine(&layout_of(&rows, true, 0.0));
    let text = layout_of(&[], true, 0.0).replace("pressure = []", "table = 'data/indicator.csv'");
    for separator in [",", ";", "\t", " "] {
        let lines: Vec<String> = rows.iter().map(|(angle, bar)| format!("{angle}{separator}{bar}\r\n")).collect();
        let csv = format!("\u{feff}angle{separator}pressure\r\n# measured\r\n\r\n{}", lines.concat());
        let read =
            |path: &str| if path == "data/indicator.csv" { Ok(csv.clone()) } else { Err("no such file".to_owned()) };
        let beside = file::parse_layout_beside("layout.toml", &text, FileResolver::new(&read)).expect("it reads");
        let file::Layout::Known(beside, _) = beside else { panic!("an engine") };
        assert_eq!(beside.gas(), inline.gas());
    }
}

#[test]
fn hostile_sizes_end_in_numbers_or_a_message() {
    let changes = [
        ("bore = '86 mm'", "bore = '1e40 m'"),
        ("bore = '86 mm'", "bore = '1e-40 m'"),
        ("heat = '1100 J'", "heat = '1e40 J'"),
        ("heat = '1100 J'", "heat = '1e-40 J'"),
        ("heat = '1100 J'", "peak_pressure = '1e6 bar'"),
        ("heat = '1100 J'", "mean_pressure = '1e-40 Pa'"),
        ("heat = '1100 J'", "mean_pressure = '1e6 bar'"),
        ("ratio = 10", "ratio = 1000"),
        ("ratio = 10", "ratio = 1.001"),
        ("ratio = 10", "ratio = 10\nwiebe_exponent = 20\ncombustion_lasts = 0.1"),
        ("ratio = 10", "ratio = 10\nwiebe_exponent = 0.01\nintake_pressure = '1e-40 Pa'"),
        ("ratio = 10", "ratio = 10\ncombustion_starts = -180\nblowdown = 0.1"),
        ("rod_length = '143 mm'", "rod_ratio = 0"),
        ("rod_length = '143 mm'", "rod_ratio = 0.999999"),
        ("rod_length = '143 mm'", "rod_ratio = 0.5\noffset_ratio = 0.499999"),
        ("stroke = '86 mm'", "stroke = '1e40 m'"),
        ("stroke = '86 mm'", "stroke = '1e-40 m'"),
        ("crankcase = '1 bar'", "crankcase = '1e6 bar'"),
    ];
    for (from, to) in changes {
        let text = SPARK.replace("rod_length = '143 mm'", "rod_ratio = 0.3").replace(from, to);
        let text = if from.starts_with("rod") { SPARK.replace(from, to) } else { text };
        let text = format!("speed = 3000\n{text}dead_centre = 'piston'\n[flywheel]\ninertia = '1e-30'");
        if let Ok(study) = crankstar::report::TorqueStudy::new(&engine(&text)) {
            let (json, torque) = (crankstar::report::Question::json(&study).expect("a document"), &study.torque);
            assert!(torque.mean.is_finite() && torque.highest.value.is_finite(), "{text}\n{json}");
            assert!(torque.balance < 1e-6, "{} {text}", torque.balance);
        }
    }
}
