//! Are engines with narrow banks and displaced axes those of the theory, and does their motion in time say the same?

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file::parse;
use crankstar::loads::loads;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::dice::Dice;

/// The VW engine of the theory (section 2, row 27), in fewer than 20 lines.
const VR6: &str = "\
title = 'VR6'
cycle = 'four-stroke'
orders = [1, 2, 3, 4, 5, 6]
[mechanism]
stroke = '90.3 mm'
rod_length = '164 mm'
[vr]
bank_angle = 15
throws = [0, 240, 120, 120, 240, 0]
pin_splay = 22
pin_offset = '12.5 mm'
";

#[track_caller]
fn read(text: &str) -> Engine {
    parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn float(value: &BigRational) -> f64 {
    value.to_f64().expect("a float")
}

/// Largest force and moment of each order by the motion of the pistons: no phasors, a period of accelerations and its harmonics.
fn peaks(engine: &Engine, order: u32) -> [f64; 2] {
    const STEPS: u32 = 720;
    let mut sums = [[Complex::new(0.0, 0.0); 2]; 2];
    for step in 0..STEPS {
        let theta = TAU * f64::from(step) / f64::from(STEPS);
        let [mut force, mut moment] = [Complex::new(0.0, 0.0); 2];
        for cylinder in engine.cylinders() {
            let rod = cylinder.rod().expect("a rod");
            let (ratio, offset) = (float(&rod.ratio), float(&rod.offset));
            let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|angle| float(angle.turns()) * TAU);
            // The height of the piston over the shaft, in crank radii, twice differenced.
            let height = |theta: f64| {
                let psi = theta + throw - bank;
                let slant = ratio * psi.sin() - offset;
                psi.cos() + (1.0 - slant * slant).sqrt() / ratio
            };
            let h = 1e-3;
            let fourth = -height(theta + 2.0 * h) + 16.0 * height(theta + h) - 30.0 * height(theta)
                + 16.0 * height(theta - h)
                - height(theta - 2.0 * h);
            let push = -fourth / (12.0 * h * h) * Complex::cis(bank);
            force += push;
            moment += push * float(&engine.arm(cylinder));
        }
        for (sum, value) in sums.iter_mut().zip([force, moment]) {
            sum[0] += value * Complex::cis(-f64::from(order) * theta);
            sum[1] += value * Complex::cis(f64::from(order) * theta);
        }
    }
    sums.map(|[direct, reverse]| (direct.norm() + reverse.norm()) / f64::from(STEPS))
}

#[test]
fn the_narrow_six_is_that_of_the_theory() {
    let engine = read(VR6);
    assert!(VR6.lines().count() <= 20);
    let loads = loads(&engine, &[1, 2, 3, 4, 5, 6]).expect("numbers");
    let force = [0.0, 0.0, 0.0077, 0.0, 0.0, 0.0008];
    let moment = [0.907, 0.254, 0.021, 0.0096];
    for (order, expected) in loads.orders.iter().zip(force) {
        let peak = (order.force.direct.value.norm() + order.force.reverse.value.norm()) / 2.0;
        assert!((peak - expected).abs() < 5.1e-5, "force {}: {peak} instead of {expected}", order.order);
        assert_eq!(peak == 0.0, expected == 0.0, "force {}", order.order);
    }
    for (order, (expected, digits)) in loads.orders.iter().zip(moment.into_iter().zip([5e-4, 5e-4, 5e-4, 5e-5])) {
        let peak = (order.moment.direct.value.norm() + order.moment.reverse.value.norm()) / 2.0;
        assert!((peak - expected).abs() < 1.01 * digits, "moment {}: {peak} instead of {expected}", order.order);
    }
}

#[test]
fn narrow_banks_are_the_cylinders_that_one_would_write_by_hand() {
    let engine = read(VR6);
    let mut text = "[mechanism]\nstroke = '90.3 mm'\nrod_length = '164 mm'\n".to_owned();
    text += "pin_offset = ['-12.5 mm', '12.5 mm', '-12.5 mm', '12.5 mm', '-12.5 mm', '12.5 mm']\n";
    for (index, throw) in [-11, 251, 109, 131, 229, 11].into_iter().enumerate() {
        let bank = if index % 2 == 0 { "-7.5" } else { "7.5" };
        text += &format!(
            "[[cylinder]]\nthrow = {throw}\nbank = {bank}\npin = {}\nposition = '{}/2'\n",
            index + 1,
            5 - 2 * index as i64
        );
    }
    assert_eq!(engine.cylinders(), read(&text).cylinders());
}

#[test]
fn two_narrow_vs_are_a_fan_of_four_banks_whose_throws_take_turns() {
    let numbers = "[mechanism]\nstroke = '90.2 mm'\nrod_length = '164 mm'\n";
    let w8 = read(&format!(
        "{numbers}[w]\nbank_angle = 72\nnarrow_angle = 15\nthrows = [0, 180]\npin_split = -18\npin_splay = 20\npin_offset = '12.5 mm'\nbank_offset = '1/5'"
    ));
    let degrees = |turn: &crankstar::Turn| turn.degrees().to_string();
    let banks: Vec<String> = w8.cylinders().iter().map(|cylinder| degrees(&cylinder.bank)).collect();
    assert_eq!(banks, ["633/2", "663/2", "57/2", "87/2"]);
    let throws: Vec<String> = w8.cylinders().iter().map(|cylinder| degrees(&cylinder.throw)).collect();
    assert_eq!(throws, ["350", "190", "332", "172"]);
    let signs: Vec<bool> = w8.cylinders().iter().map(|c| float(&c.rod().expect("a rod").offset) > 0.0).collect();
    assert_eq!(signs, [false, true, false, true]);
    let fan = read(&format!(
        "{numbers}[fan]\nbanks = [43.5, 28.5, -28.5, -43.5]\nthrows = [0, 240, 120]\npin_offsets = ['1 cm', '-1 cm', '1 cm', '-1 cm']"
    ));
    let offset = BigRational::new(10.into(), 164.into());
    for cylinder in fan.cylinders() {
        let outer = ["87/2", "663/2"].contains(&degrees(&cylinder.bank).as_str());
        let expected = if outer { offset.clone() } else { -offset.clone() };
        assert_eq!(cylinder.rod().expect("a rod").offset, expected);
    }
}

#[test]
fn the_motion_in_time_of_random_narrow_engines_says_the_same() {
    let mut dice = Dice::new(0x5652);
    for _ in 0..24 {
        let count = dice.below(5) + 2;
        let throws: Vec<String> = (0..count).map(|_| (dice.below(24) * 15).to_string()).collect();
        let (narrow, splay, offset) = (dice.below(30) + 1, dice.below(40), dice.below(20));
        let head = format!("[mechanism]\nstroke = '90 mm'\nrod_length = '{} mm'\n", 140 + dice.below(60));
        let keys = format!("throws = [{}]\npin_splay = {splay}\npin_offset = '{offset} mm'\n", throws.join(", "));
        let text = match dice.below(2) {
            0 => format!("{head}[vr]\nbank_angle = {narrow}\n{keys}"),
            _ => format!(
                "{head}[w]\nbank_angle = {}\nnarrow_angle = {narrow}\npin_split = {}\n{keys}",
                40 + dice.below(60),
                dice.below(30)
            ),
        };
        let engine = read(&text);
        let loads = loads(&engine, &[1, 2, 3, 4]).expect("numbers");
        for order in &loads.orders {
            let found = [&order.force, &order.moment]
                .map(|whole| (whole.direct.value.norm() + whole.reverse.value.norm()) / 2.0);
            for (found, expected) in found.into_iter().zip(peaks(&engine, order.order)) {
                assert!((found - expected).abs() < 1e-6, "order {}: {found} and {expected} in\n{text}", order.order);
            }
        }
    }
}

#[test]
fn mistakes_in_narrow_banks_are_told() {
    let numbers = "[mechanism]\nstroke = '90 mm'\nrod_length = '164 mm'\n";
    let mistakes = [
        ("[vr]\nbank_angle = 15\nthrows = [0]\npin_offset = '1 cm'", "an offset without a rod"),
        ("[mechanism]\nrod_ratio = 0.3\n[vr]\nbank_angle = 15\nthrows = [0]\npin_offset = '1 cm'", "add a stroke"),
        ("[vr]\nbank_angle = 0\nthrows = [0]", "above 0 and below 180"),
        ("[vr]\nbank_angle = -15\nthrows = [0]", "above 0 and below 180"),
        ("[w]\nbank_angle = 72\nthrows = [0]", "narrow_angle"),
        ("[vee]\nbank_angle = 60\nthrows = [0]\npin_offset = ['1 cm']", "1 pin offsets for 2 banks"),
    ];
    for (text, words) in mistakes {
        let error = parse("layout.toml", text).expect_err(text).to_string();
        assert!(error.contains(words), "{error}\n{text}");
    }
    let twice = format!("{numbers}pin_offset = '1 cm'\n[vr]\nbank_angle = 15\nthrows = [0]\npin_offset = '1 cm'");
    let error = parse("layout.toml", &twice).expect_err("two offsets").to_string();
    assert!(error.contains("given twice"), "{error}");
    let displaced = format!("{numbers}[vr]\nbank_angle = 15\nthrows = [0, 0]\npin_offset = '-12.5 mm'");
    let first = read(&displaced).cylinders()[0].rod().expect("a rod").offset.clone();
    assert_eq!(first, BigRational::new(125.into(), 1640.into()));
}
