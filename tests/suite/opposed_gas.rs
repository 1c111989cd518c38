//! Is the gas of opposed pistons that of one volume between them, and its torque that of virtual work on both cranks?
//!
//! The pistons here are plain triangles of crank and rod: they know nothing of classes, dead centres or harmonics.

use std::f64::consts::{PI, TAU};

use crankstar::engine::{CycleOrder, Draft, Engine, Mechanism};
use crankstar::file;
use crankstar::firing::{NoStar, Weights, firing_of, firing_stars};
use crankstar::gas::CylinderGas;
use crankstar::journal::{self, Instants};
use crankstar::torque::torque;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::gas::engine;
use crate::support::dice::Dice;
use crate::support::written::assert_near;

const BORE: f64 = 0.1;
const AREA: f64 = PI / 4.0 * BORE * BORE;
const STROKE: f64 = 0.12;
const AMBIENT: f64 = 1e5;

/// Processes and a table, with the key of the compression where the volume is not that of a table.
const LAWS: [&str; 4] = [
    "process = 'diesel'\ncompression_ratio = 16\nheat = '3000 J'\n",
    "process = 'spark-ignition'\ncompression_ratio = 9\nmean_pressure = '7 bar'\n",
    "process = 'diesel'\ncompression_ratio = 14\npeak_pressure = '80 bar'\n",
    "pressure = [[0, '40 bar'], [30, '55 bar'], [70, '12 bar'], [140, '2 bar'], [200, '1.2 bar'], [300, '6 bar']]\n",
];

/// An engine of opposed pistons, or a delta, of unequal strokes and rods in any second case.
fn any(dice: &mut Dice, four_stroke: bool) -> (String, Engine) {
    let law = if four_stroke { 1 } else { dice.below(4) as usize };
    let (cycle, order) = match four_stroke {
        true => ("four-stroke", "firing_order = '1a-2a'\n"),
        false => ("two-stroke", ""),
    };
    let lead = 24.0 * dice.below(1000) as f64 / 1000.0 - 8.0;
    let sense = if dice.below(2) == 0 { "with" } else { "against" };
    let throws = if four_stroke { "0, 0" } else { "0, 100, 230" };
    let form = match dice.below(3) {
        0 if !four_stroke => "[delta]\nrows = [0, 70]\ncircumradius = 7\n".to_owned(),
        _ => format!("[opposed_piston]\nthrows = [{throws}]\nlead = {lead}\nsense = '{sense}'\ndistance = 12\n"),
    };
    let rods = format!("stroke = '120 mm'\nrod_length = '{} mm'\nreciprocating_mass = '3 kg'\n", 170 + dice.below(200));
    let intake = if four_stroke || law == 3 { "" } else { "intake_pressure = '1.3 bar'\n" };
    let text = format!(
        "cycle = '{cycle}'\nspeed = 900\n{order}[mechanism]\n{rods}{form}[gas]\nbore = '100 mm'\ncrankcase = '1 bar'\n{}{intake}",
        LAWS[law]
    );
    let engine = engine(&text);
    if dice.below(2) == 0 {
        return (text, engine);
    }
    let radius = BigRational::new((80 + dice.below(50) as i64).into(), 100.into());
    let mut draft: Draft = engine.into_draft();
    for index in 0..draft.cylinders.len() {
        if draft.cylinders[index].shared.is_some_and(|shared| shared.is_second) {
            draft.cylinders[index].crank_radius = radius.clone();
            let Some(Mechanism::SliderCrank(rod)) = &mut draft.cylinders[index].mechanism else { panic!("a rod") };
            rod.ratio *= &radius;
        }
    }
    (text, draft.build().expect("an engine"))
}

/// A piston by its crank and its rod.
struct Piston {
    radius: f64,
    rod: f64,
    axis: f64,
    throw: f64,
}

impl Piston {
    fn of(engine: &Engine, index: usize) -> Self {
        let cylinder = &engine.cylinders()[index];
        let float = |number: &BigRational| number.to_f64().expect("a number");
        let radius = STROKE / 2.0 * float(&cylinder.crank_radius);
        let ratio = float(&cylinder.rod().expect("a rod").ratio);
        let [axis, throw] = [&cylinder.bank, &cylinder.throw].map(|turn| float(turn.turns()) * TAU);
        Piston { radius, rod: radius / ratio, axis, throw }
    }

    fn out(&self, theta: f64) -> f64 {
        let pin = self.radius * Complex::cis(theta + self.throw - self.axis);
        pin.re + (self.rod * self.rod - pin.im * pin.im).sqrt()
    }

    fn speed(&self, theta: f64) -> f64 {
        derivative(|at| self.out(at), theta)
    }

    fn acceleration(&self, theta: f64) -> f64 {
        derivative(|at| self.speed(at), theta)
    }
}

/// The derivative by differences of the sixth order.
fn derivative(f: impl Fn(f64) -> f64, at: f64) -> f64 {
    let h = 2e-3;
    let pair = |n: f64| f(at + n * h) - f(at - n * h);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
}

#[test]
fn the_torque_of_random_opposed_pistons_is_their_virtual_work_and_its_mean_the_area_of_the_loops() {
    let mut dice = Dice::new(41);
    for case in 0..16 {
        let (text, engine) = any(&mut dice, case % 4 == 3);
        let found = torque(&engine).unwrap_or_else(|error| panic!("{text}\n{error}"));
        let course = journal::course(&engine).expect("a course");
        let (pairs, period) = (engine.firing_pistons(), found.course.period());
        assert_eq!(pairs.len() * 2, engine.cylinders().len());
        let pistons: Vec<Piston> = (0..engine.cylinders().len()).map(|index| Piston::of(&engine, index)).collect();
        let ratio =
            text.split_once("compression_ratio = ").map(|(_, rest)| rest[..2].trim().parse::<f64>().expect("ε"));
        for &first in &pairs {
            let second = engine.partner(first).expect("another piston");
            let ways = |theta: f64| pistons[first].out(theta) + pistons[second].out(theta);
            let all: Vec<f64> = (0..8000).map(|step| ways(TAU * f64::from(step) / 8000.0)).collect();
            let [high, low] =
                [all.iter().copied().fold(f64::MIN, f64::max), all.iter().copied().fold(f64::MAX, f64::min)];
            let gas = CylinderGas::new(&engine, first).expect("gas");
            let clearance = ratio.map_or(0.0, |ratio| AREA * (high - low) / (ratio - 1.0));
            assert_near(gas.geometry().swept() / (AREA * (high - low)), 1.0, 1e-7);
            assert_near(gas.geometry().clearance * 1e3, clearance * 1e3, 1e-7);
            // Both feel one pressure, and where it is compressed it follows the volume between them.
            let pressure = |theta: f64| course.forces(first, theta).gas / AREA + AMBIENT;
            let volume = |theta: f64| clearance + AREA * (high - ways(theta));
            for step in 0..37 {
                let theta = period * f64::from(step) / 37.0;
                let [a, b] = [first, second].map(|index| course.forces(index, theta).gas);
                assert!((a - b).abs() < 1e-8 * (a.abs() + 1e3), "{text}\n{a} {b}");
            }
            let steps = 4000;
            let at = |step: usize| period * step as f64 / steps as f64;
            let area: f64 = (0..steps)
                .map(|step| {
                    (pressure(at(step)) + pressure(at(step + 1))) / 2.0 * (volume(at(step + 1)) - volume(at(step)))
                })
                .sum();
            assert!((gas.work() - area).abs() < 3e-4 * gas.work().abs(), "{text}\n{} {area}", gas.work());
            if ratio.is_some() {
                let nearest = (0..3600).map(|step| TAU * f64::from(step) / 3600.0);
                let nearest = nearest.max_by(|a, b| ways(*a).total_cmp(&ways(*b))).expect("a place");
                // The compression stroke of the two revolutions of a four-stroke is that with the higher pressure.
                let nearest = [nearest, nearest + TAU].into_iter().max_by(|a, b| pressure(*a).total_cmp(&pressure(*b)));
                let [from, to] = [80.0, 40.0].map(|before: f64| nearest.expect("a place") - before.to_radians());
                let exponent = (pressure(to) / pressure(from)).ln() / (volume(from) / volume(to)).ln();
                assert!((1.2..1.45).contains(&exponent), "{text}\n{exponent}");
                let middle = (from + to) / 2.0;
                let between = pressure(from) * (volume(from) / volume(middle)).powf(exponent);
                assert_near(pressure(middle) / between, 1.0, 1e-7);
            }
        }
        let omega = 900.0 * TAU / 60.0;
        let size = found.highest.value.abs().max(found.lowest.value.abs());
        for step in 0..61 {
            let theta = period * f64::from(step) / 61.0 + 0.01;
            let of_one = |(index, piston): (usize, &Piston)| {
                let mass = 3.0 * engine.cylinders()[index].reciprocating_mass.to_f64().expect("a mass");
                let outward = course.forces(index, theta).gas + mass * piston.acceleration(theta) * omega * omega;
                -outward * piston.speed(theta)
            };
            let each: f64 = pistons.iter().enumerate().map(of_one).sum();
            assert!((found.course.total(theta) - each).abs() < 1e-7 * size, "{text}\n{each}");
            for shaft in 0..engine.geared_cranks().len() {
                let own = pistons.iter().enumerate().filter(|(index, _)| engine.cylinders()[*index].crank == shaft);
                let own: f64 = own.map(of_one).sum();
                assert!((found.course.on_shaft(shaft, theta) - own).abs() < 1e-7 * size, "{text}\n{own}");
            }
        }
        let work: f64 = pairs.iter().map(|&first| CylinderGas::new(&engine, first).expect("gas").work()).sum();
        assert!((found.mean * period - work).abs() < 1e-7 * work.abs(), "{text}\n{}", found.mean);
        assert!(found.balance < 1e-7, "{}", found.balance);
    }
}

#[test]
fn pistons_without_a_lead_are_twice_an_engine_in_line_of_the_same_pressure() {
    let rest = "stroke = '120 mm'\nrod_length = '200 mm'\nreciprocating_mass = '2 kg'\n[gas]\nbore = '100 mm'\n\
        crankcase = '1 bar'\nprocess = 'diesel'\ncompression_ratio = 14\npeak_pressure = '90 bar'\nintake_pressure = '1.2 bar'\n";
    let head = "cycle = 'two-stroke'\nspeed = 1000\n";
    let both = torque(&engine(&format!("{head}[opposed_piston]\nthrows = [0, 120]\nlead = 0\n[mechanism]\n{rest}")))
        .expect("torque");
    let one = torque(&engine(&format!("{head}[inline]\nthrows = [0, 120]\n[mechanism]\n{rest}"))).expect("torque");
    assert_eq!(both.classes.len(), 1);
    for step in 0..90 {
        let theta = TAU * f64::from(step) / 90.0;
        assert!((both.course.total(theta) - 2.0 * one.course.total(theta)).abs() < 1e-9 * one.highest.value);
    }
    assert_near(both.mean, 2.0 * one.mean, 1e-9);
}

#[test]
fn the_firing_stars_of_opposed_pistons_tell_which_orders_of_their_torque_vanish() {
    let text = |throws: &str| {
        format!(
            "cycle = 'two-stroke'\nspeed = 700\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\nreciprocating_mass = '2 kg'\n\
             [opposed_piston]\nthrows = [{throws}]\nlead = 11\nsense = 'against'\n[gas]\nbore = '100 mm'\n{}intake_pressure = '1.5 bar'\n",
            LAWS[0]
        )
    };
    for throws in ["0, 120, 240", "0, 240, 120", "0, 90, 270, 180", "0, 100, 230", "0"] {
        let engine = engine(&text(throws));
        assert_eq!(firing_of(&engine).expect("it fires").shots.len(), throws.split(',').count());
        let orders: Vec<CycleOrder> = (1..=8).filter_map(|order| CycleOrder::of_halves(2 * order)).collect();
        let stars = firing_stars(&engine, &orders, &Weights::Rigid).expect("stars");
        let found = torque(&engine).expect("torque");
        for star in stars {
            let count = 1440;
            let sum: Complex<f64> = (0..count)
                .map(|step| TAU * f64::from(step) / f64::from(count))
                .map(|theta| found.course.gas(theta) * Complex::cis(-star.order.value() * theta))
                .sum();
            let amplitude = sum.norm() / f64::from(count) / found.highest.value;
            assert_eq!(star.vanishes(), amplitude < 1e-9, "{throws} {} {amplitude}", star.order);
            let own = found.orders.iter().find(|order| order.order == star.order).expect("an order");
            assert_eq!(own.gas_vanishes, star.vanishes());
        }
    }
}

#[test]
fn pairs_that_move_unlike_have_a_torque_and_no_common_star() {
    let base = "cycle = 'two-stroke'\nspeed = 700\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\nreciprocating_mass = '2 kg'\n\
        [opposed_piston]\nthrows = [0, 120]\nlead = 11\n[gas]\nbore = '100 mm'\nprocess = 'diesel'\ncompression_ratio = 16\n\
        heat = '3000 J'\nintake_pressure = '1.3 bar'\n";
    let mut draft = engine(base).into_draft();
    draft.cylinders[3].crank_radius = BigRational::new(9.into(), 10.into());
    let unlike = draft.build().expect("an engine");
    let order = [CycleOrder::of_halves(2).expect("an order")];
    assert_eq!(firing_stars(&unlike, &order, &Weights::Rigid).expect_err("no star"), NoStar::OpposedPistons);
    assert_eq!(torque(&unlike).expect("torque").classes.len(), 4);
    let shape = Weights::ModeShape(vec![BigRational::from_integer(1.into()); 4]);
    assert!(firing_stars(&engine(base), &order, &shape).is_err());
}

#[test]
fn at_an_angle_both_pistons_feel_the_pressure_of_their_cylinder() {
    let mut dice = Dice::new(7);
    for _ in 0..6 {
        let (text, engine) = any(&mut dice, false);
        let instants = Instants::new(&engine, None).unwrap_or_else(|error| panic!("{text}\n{error}"));
        for theta in [0.0, 13.0, 100.0, 300.0] {
            let pistons = instants.pistons(theta);
            for first in engine.firing_pistons() {
                let [a, b] =
                    [first, engine.partner(first).expect("another")].map(|index| pistons[index].gas.expect("gas"));
                assert!((a - b).abs() < 1e-7 * (a.abs() + 1e3), "{text}\n{a} {b}");
            }
        }
    }
}

#[test]
fn without_dead_centre_angles_count_from_the_least_volume_and_with_crank_from_the_first_piston() {
    let read = |key: &str| {
        engine(&format!(
            "cycle = 'two-stroke'\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\n[opposed_piston]\nthrows = [0]\nlead = 12\n\
             [gas]\nbore = '100 mm'\n{key}pressure = [[0, '50 bar'], [1, '1 bar'], [350, '1 bar'], [359.5, '1 bar']]\n"
        ))
    };
    let peak =
        |engine: &Engine, index: usize| CylinderGas::new(engine, index).expect("gas").peak_pressure().1.to_degrees();
    let (volume, crank) = (read(""), read("dead_centre = 'crank'\n"));
    // With equal strokes and rods the least volume is midway between the dead centres.
    assert_near(peak(&volume, 0), -6.0, 1e-9);
    assert_near(peak(&volume, 1), 6.0, 1e-9);
    assert_eq!(peak(&crank, 0), 0.0);
    assert_near(peak(&crank, 1), 12.0, 1e-9);
    assert_eq!(volume.gas(), read("dead_centre = 'piston'\n").gas());
}

#[test]
fn a_piston_that_misfires_is_its_whole_cylinder() {
    let base = "cycle = 'two-stroke'\nspeed = 700\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\nreciprocating_mass = '2 kg'\n\
        [opposed_piston]\nthrows = [0, 180]\nlead = 11\n[gas]\nbore = '100 mm'\nprocess = 'diesel'\ncompression_ratio = 16\n\
        heat = '3000 J'\nintake_pressure = '1.3 bar'\n";
    let whole = torque(&engine(base)).expect("torque");
    let of = |name: &str| torque(&engine(base).misfiring(name).expect("a misfire")).expect("torque");
    let (first, second) = (of("2a"), of("2b"));
    assert_near(first.mean, second.mean, 1e-12);
    assert!(first.mean < 0.6 * whole.mean, "{} {}", first.mean, whole.mean);
}

#[test]
fn gas_that_opposed_pistons_cannot_have_is_told() {
    let text = |form: &str, gas: &str| {
        format!(
            "cycle = 'two-stroke'\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\n{form}\n[gas]\nbore = '100 mm'\n{gas}"
        )
    };
    let opposed = "[opposed_piston]\nthrows = [0, 180]\nlead = 11";
    let refused = |gas: &str| file::parse("layout.toml", &text(opposed, gas)).expect_err("a mistake").to_string();
    let differs = refused(
        "process = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '5 bar'\nclearance = 0.05\n[[gas.cylinder]]\ncylinders = ['1a']\nbore = '90 mm'\n",
    );
    assert!(differs.contains("share a cylinder"), "{differs}");
    let double = refused(
        "pressure = [[0, '5 bar'], [180, '1 bar'], [360, '5 bar']]\npiston_rod = '30 mm'\nbelow_pressure = [[0, '1 bar'], [180, '5 bar'], [360, '1 bar']]\n",
    );
    assert!(double.contains("double-acting"), "{double}");
    let still = engine(
        &text("[opposed_piston]\nthrows = [0]\nlead = 180", LAWS[3]).replace("rod_length = '220 mm'", "rod_ratio = 0"),
    );
    let why = torque(&still).expect_err("no torque").to_string();
    assert!(why.contains("move together"), "{why}");
}

#[test]
fn pistons_of_tables_that_name_each_other_are_those_of_the_short_form() {
    let rest = "[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\nreciprocating_mass = '2 kg'\n[gas]\nbore = '100 mm'\n\
        process = 'diesel'\ncompression_ratio = 16\nheat = '3000 J'\nintake_pressure = '1.3 bar'\n";
    let head = "cycle = 'two-stroke'\nspeed = 700\n";
    let form = format!("{head}[opposed_piston]\nthrows = [0, 120]\nlead = 11\nsense = 'with'\ndistance = 12\n{rest}");
    let cylinder = |name: &str, crank: &str, [throw, bank]: [i32; 2], position: &str, more: &str| {
        format!(
            "[[cylinder]]\nname = '{name}'\ncrankshaft = '{crank}'\nthrow = {throw}\nbank = {bank}\nposition = '{position}'\n{more}"
        )
    };
    let tables = |second: &str| {
        let crank =
            |name: &str, height: &str| format!("[[crankshaft]]\nname = '{name}'\nsense = 'with'\nheight = {height}\n");
        [
            head.to_owned(),
            crank("lower", "-6") + &crank("upper", "6"),
            cylinder("1a", "lower", [0, 0], "1/2", "") + &cylinder("2a", "lower", [120, 0], "-1/2", ""),
            cylinder("1b", "upper", [191, 180], "1/2", "opposed_to = '1a'\n"),
            cylinder("2b", "upper", [311, 180], "-1/2", second),
            rest.to_owned(),
        ]
        .concat()
    };
    let [short, long] = [form, tables("opposed_to = '2a'\n")].map(|text| torque(&engine(&text)).expect("torque"));
    for step in 0..60 {
        let theta = TAU * f64::from(step) / 60.0;
        assert!((short.course.total(theta) - long.course.total(theta)).abs() < 1e-9 * short.highest.value);
    }
    for wrong in ["opposed_to = '1a'\n", "opposed_to = '2b'\n", "opposed_to = '3'\n", "opposed_to = '1b'\n"] {
        let why = file::parse("layout.toml", &tables(wrong)).expect_err("a mistake").to_string();
        assert!(why.contains("cannot share") || why.contains("the name of another"), "{why}");
    }
}
