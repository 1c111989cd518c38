//! Do energy and forces balance in engines of every form that have gas, and does a shared crankpin feel all its rods?

use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, Engine, throws};
use crankstar::exact::Turn;
use crankstar::file::parse;
use crankstar::journal::{CycleLoads, LoadPeak, bearing_peaks, cycle_loads};
use crankstar::loads::{Method, bearing_loads};
use crankstar::torque::{PeakMethod, torque};
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::gas_table::{self, POINTS};
use crate::support::written::float;

const ENGINES: usize = 24;

fn direction(angle: &Turn) -> Complex<f64> {
    Complex::cis(float(angle.turns()) * TAU)
}

#[track_caller]
fn assert_near(found: Complex<f64>, wanted: Complex<f64>, within: f64, about: &str) {
    assert!((found - wanted).norm() <= within, "{found} is not {wanted}, but {:e} off\n{about}", found - wanted);
}

/// A form with throws, banks and offsets as they happen.
fn form(dice: &mut Dice) -> String {
    let count = 1 + dice.below(4) as usize;
    let mut angles = |count: usize, step: u64| {
        (0..count).map(|_| (step * dice.below(360 / step)).to_string()).collect::<Vec<_>>().join(", ")
    };
    let throws = angles(count, 30);
    let (bank, split) = (15 * dice.below(12), 10 * dice.below(7));
    match dice.below(6) {
        0 => format!("[inline]\nthrows = [{throws}]\nspacing = '0.1 m'\n"),
        1 => format!("[vee]\nbank_angle = {bank}\nthrows = [{throws}]\nspacing = '0.1 m'\nbank_offset = '15 mm'\n"),
        2 => format!("[vee]\nbank_angle = {bank}\nthrows = [{throws}]\npin_split = {split}\nspacing = '0.1 m'\n"),
        3 => format!("[fan]\nbanks = [-{bank}, 0, {bank}]\nthrows = [{throws}]\nspacing = '0.1 m'\n"),
        4 => format!("[boxer]\nthrows = [{throws}]\nstagger = '40 mm'\nspacing = '0.1 m'\n"),
        _ => {
            "[radial]\ncylinders = 5\nrows = 2\nrow_rotation = 36\nrow_throw = 180\nrow_spacing = '0.1 m'\n".to_owned()
        }
    }
}

/// An engine with gas, and its text.
fn random(dice: &mut Dice) -> (Engine, String) {
    let four_stroke = dice.below(2) == 0;
    let (form, speed) = (form(dice), 500 + dice.below(5000));
    let plain = parse("plain.toml", &form).unwrap_or_else(|error| panic!("{error}\n{form}"));
    let full = BigRational::from_integer(360.into());
    let fires = plain.cylinders().iter().map(|cylinder| {
        let dead_centre = cylinder.top_dead_centre().turns() * &full;
        let later = 360 * dice.below(2) as i64 * i64::from(four_stroke);
        format!("'{}'", dead_centre + BigRational::from_integer(later.into()))
    });
    let fires: Vec<String> = fires.collect();
    let table = gas_table::rows(&gas_table::random(dice, if four_stroke { 720.0 } else { 360.0 }, 50));
    let counterweights = dice.below(2) == 0;
    let crankshaft = if counterweights {
        "[crankshaft]\nlength = '3 m'\npin_mass = '0.3 kg'\nbalance_factor = 0.7\ncounterweight_radius = '60 mm'\n"
    } else {
        ""
    };
    let text = format!(
        "cycle = '{}'\nspeed = {speed}\neffects = ['gas']\nfiring_angles = [{}]\nbearings = ['0.6 m', '0.05 m', '-0.05 m', '-0.6 m']\n{form}\
         [mechanism]\nstroke = '80 mm'\nrod_length = '{} mm'\npin_offset = '{} mm'\nreciprocating_mass = '0.6 kg'\nrotating_mass = '0.4 kg'\n\
         {crankshaft}[gas]\nbore = '80 mm'\ndead_centre = 'crank'\nunit = 'bar'\npressure = [{table}]\n",
        if four_stroke { "four-stroke" } else { "two-stroke" },
        fires.join(", "),
        100 + dice.below(90),
        dice.below(2) * dice.below(9),
    );
    let engine = parse("gas.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    (engine, text)
}

fn size_of(loads: &CycleLoads) -> f64 {
    loads.cylinders.iter().map(|cylinder| cylinder.peaks.pin.value).sum()
}

#[test]
fn the_work_of_the_gas_is_the_mean_torque_times_the_cycle_and_that_of_the_crankpins() {
    let mut dice = Dice::new(1500);
    for _ in 0..ENGINES {
        let (engine, text) = random(&mut dice);
        let (loads, torque) = (cycle_loads(&engine).expect("loads"), torque(&engine).expect("a torque"));
        let period = loads.course.period();
        let indicated: f64 = torque.classes.iter().map(|class| class.gas.work() * class.cylinders.len() as f64).sum();
        let swung = size_of(&loads) * 0.04 * period;
        assert!(
            (torque.mean * period - indicated).abs() < 1e-9 * swung,
            "{} {indicated}\n{text}",
            torque.mean * period
        );
        // On each crank the pin's load turns the shaft: what the gas does comes out there, and inertia gives nothing in a cycle.
        // Halves of a degree: tables have kinks at whole ones of their own cylinder, and axes stand at halves.
        let halves = (2.0 * period.to_degrees()).round() as usize;
        let mut work = 0.0;
        for (half, (point, weight)) in (0..halves).flat_map(|half| POINTS.map(|point| (half, point))) {
            let theta = (half as f64 + point).to_radians() / 2.0;
            let of_pin = |index: usize| 0.04 * loads.course.pin_on_the_crank(index, theta).im;
            let turned: f64 = (0..loads.cylinders.len()).map(of_pin).sum();
            if half % 90 == 7 {
                assert!((turned - torque.course.total(theta)).abs() < 1e-9 * swung, "{text}");
            }
            work += turned * weight * 0.5_f64.to_radians();
        }
        assert!((work - indicated).abs() < 1e-9 * swung, "{work} {indicated}\n{text}");
    }
}

#[test]
fn what_the_frame_feels_is_the_shaking_force_and_what_bearings_carry_is_what_the_shaft_bears() {
    let mut dice = Dice::new(1501);
    for _ in 0..ENGINES {
        let (engine, text) = random(&mut dice);
        let loads = cycle_loads(&engine).expect("loads");
        let course = &loads.course;
        let within = 1e-9 * size_of(&loads).max(1.0);
        let omega = float(engine.dimensions().speed.as_ref().expect("a speed")) / 60.0 * TAU;
        let [continuous, determinate] = loads.bearings.as_ref().expect("bearings");
        // The masses of the shaft itself, of the layout's own words.
        let shaft: Complex<f64> = {
            let crankshaft = engine.crankshaft();
            let weights = crankshaft.counterweights.iter().map(|one| direction(&one.angle) * float(&one.mass_radius()));
            let pins = throws(&engine).into_iter().map(|throw| {
                let has_pin = if crankshaft.counterweights.is_empty() { 0.0 } else { 0.3 };
                direction(&throw.angle) * has_pin * 0.04
            });
            weights.chain(pins).sum::<Complex<f64>>() * omega * omega
        };
        for step in 0..23 {
            let theta = f64::from(step) * course.period() / 23.0 + 0.017;
            let pins: Complex<f64> = (0..loads.cylinders.len()).map(|index| course.pin(index, theta)).sum();
            for bearings in [continuous, determinate] {
                let carried: Complex<f64> =
                    bearings.bearings.iter().map(|bearing| course.carried(&bearing.carried, theta)).sum();
                assert_near(carried, pins + shaft * Complex::cis(theta), within, &text);
            }
            // Head and wall of each cylinder with its pin: the piston's inertia and that of the rod's rotating mass, and no gas.
            for (index, cylinder) in engine.cylinders().iter().enumerate() {
                let forces = course.forces(index, theta);
                let axis = direction(&cylinder.bank);
                let felt = Complex::new(forces.gas, -forces.side()) * axis + course.pin(index, theta);
                let turning = direction(&cylinder.throw) * Complex::cis(theta) * 0.4 * 0.04 * omega * omega;
                assert_near(felt, axis * forces.inertia + turning, within, &text);
            }
        }
    }
}

#[test]
fn a_crankpin_feels_the_sum_of_its_rods_and_never_more_than_all_their_largest_loads() {
    let mut dice = Dice::new(1502);
    let mut shared = 0;
    for _ in 0..ENGINES {
        let (engine, text) = random(&mut dice);
        let loads = cycle_loads(&engine).expect("loads");
        let course = &loads.course;
        let of_several = throws(&engine).into_iter().enumerate().filter(|(_, throw)| throw.cylinders.len() > 1);
        let of_several: Vec<_> = of_several.collect();
        assert_eq!(loads.shared_pins.len(), of_several.len());
        for (pin, (index, throw)) in loads.shared_pins.iter().zip(of_several) {
            shared += 1;
            assert_eq!((pin.throw, &pin.cylinders, &pin.position), (index, &throw.cylinders, &throw.position));
            let sum = |theta: f64| -> Complex<f64> { throw.cylinders.iter().map(|&rod| course.pin(rod, theta)).sum() };
            let within = 1e-9 * size_of(&loads);
            for step in 0..400 {
                let theta = f64::from(step) * course.period() / 400.0;
                assert_near(pin.load(course, theta), sum(theta), within, &text);
                assert!(sum(theta).norm() <= pin.peak.value + within, "{text}");
                let turned = pin.load_on_the_crank(course, theta) * direction(&throw.angle) * Complex::cis(theta);
                assert_near(turned, sum(theta), within, &text);
            }
            assert_near(sum(pin.peak.angle.to_radians()), pin.peak.vector, within, &text);
            let each: f64 = throw.cylinders.iter().map(|&rod| loads.cylinders[rod].peaks.pin.value).sum();
            assert!(pin.peak.value <= each + within, "{text}");
            let (rod, alone) = pin.largest_of_a_rod(&loads).expect("rods");
            assert!(throw.cylinders.contains(&rod) && alone == loads.cylinders[rod].peaks.pin);
        }
    }
    assert!(shared > ENGINES / 2, "{shared} shared pins");
}

#[test]
fn largest_bearing_loads_are_the_same_with_and_without_their_orders() {
    let mut dice = Dice::new(1503);
    for _ in 0..ENGINES / 2 {
        let (engine, text) = random(&mut dice);
        let loads = cycle_loads(&engine).expect("loads");
        let [continuous, _] = loads.bearings.as_ref().expect("bearings");
        let whole: Vec<[_; 2]> = continuous.bearings.iter().map(|bearing| [bearing.peak, bearing.inertia]).collect();
        assert_eq!(bearing_peaks(&engine).expect("peaks"), whole, "{text}");
        // Without gas they are those of the masses, which the loads by orders approach.
        let orders: Vec<u32> = (1..=40).collect();
        let masses = bearing_loads(&engine, &orders, Method::Continuous).expect("loads");
        let newtons = masses.scale.as_ref().expect("newtons").force();
        for (bearing, masses) in continuous.bearings.iter().zip(&masses.bearings) {
            let by_orders = masses.peak.value * newtons;
            assert!((bearing.inertia.value - by_orders).abs() < 1e-6 * by_orders.max(1.0), "{by_orders}\n{text}");
        }
    }
}

#[test]
fn orders_of_the_gas_and_samples_come_to_the_largest_bearing_load() {
    let mut dice = Dice::new(1504);
    for _ in 0..6 {
        let (engine, text) = random(&mut dice);
        let (peak, loads) =
            (LoadPeak::new(&engine).expect("loads").expect("bearings"), cycle_loads(&engine).expect("loads"));
        let [bearings, _] = loads.bearings.as_ref().expect("bearings");
        let largest = bearings.bearings[bearings.worst[0]].peak.value;
        assert!((peak.largest - largest).abs() <= 1e-9 * largest, "{text}");
        for method in peak.methods() {
            let (value, far) = (peak.value(method), peak.farthest(method));
            let off = (value - largest).abs();
            match method {
                // The orders up to 12 are those of the series, with its masses in closed form.
                PeakMethod::Orders(_) => {
                    assert!(off <= far.expect("orders") * (1.0 + 1e-9) + 1e-9 * largest, "{method:?}\n{text}")
                }
                PeakMethod::Samples(_) => assert!(value <= largest * (1.0 + 1e-9), "{method:?}\n{text}"),
                PeakMethod::Refined => assert!(off <= 1e-9 * largest, "{text}"),
            }
        }
        let far = |halves: u32| {
            let order = CycleOrder::of_halves(halves).expect("an order");
            peak.farthest(PeakMethod::Orders(order)).expect("orders")
        };
        assert!(far(96) < 0.02 * largest && far(96) <= far(24) && far(24) <= far(8), "{text}");
    }
}
