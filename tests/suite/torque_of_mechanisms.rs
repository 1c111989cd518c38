//! Is the torque of links on a master rod, and of several crankshafts, that of Newton's law for each body?
//!
//! The bodies know nothing of energies, classes or orders: each force goes from the piston through rods and pins to crank, wall and bearings.

use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file;
use crankstar::journal::{Instants, PistonAt};
use crankstar::loads::Missing;
use crankstar::mounts::excitation;
use crankstar::proof::Sense;
use crankstar::torque::{EngineTorque, guide_moments, torque};
use num_complex::Complex;
use num_traits::ToPrimitive;

use crate::geared::any_engine_at;
use crate::support::dice::Dice;
use crate::support::gas_table::{AMBIENT, POINTS};
use crate::support::linked::{read, second_derivative};
use crate::support::written::assert_near;

/// Degrees from row to row of the pressures.
const STEP: f64 = 12.0;
const AREA: f64 = std::f64::consts::PI / 4.0 * 0.08 * 0.08;

fn cross(a: Complex<f64>, b: Complex<f64>) -> f64 {
    (a.conj() * b).im
}

/// Pressures of a cycle in bar, and what the file says of them.
fn gas(dice: &mut Dice, cycle: i64) -> (Vec<f64>, String) {
    let rows = (cycle as f64 / STEP) as usize;
    let table: Vec<f64> = (0..rows)
        .map(|row| if row < 6 { 40.0 - 6.0 * row as f64 } else { 1.0 + dice.below(30) as f64 / 10.0 })
        .collect();
    let written: Vec<String> =
        table.iter().enumerate().map(|(row, bar)| format!("[{}, {bar}]", STEP * row as f64)).collect();
    let text =
        format!("[gas]\nbore = '80 mm'\ndead_centre = 'crank'\nunit = 'bar'\npressure = [{}]\n", written.join(", "));
    (table, text)
}

/// Force of the gas on a piston, towards the crank.
fn push(table: &[f64], degrees: f64) -> f64 {
    let place = degrees.rem_euclid(STEP * table.len() as f64) / STEP;
    let (row, part) = (place.floor() as usize % table.len(), place.fract());
    (1e5 * (table[row] * (1.0 - part) + table[(row + 1) % table.len()] * part) - AMBIENT) * AREA
}

fn found(text: &str) -> (Engine, EngineTorque) {
    let engine = read(text);
    let torque = torque(&engine).unwrap_or_else(|lack| panic!("{lack}\n{text}"));
    (engine, torque)
}

/// A link on a master rod: angle of its cylinder and of its knuckle pin from the master's, its length and masses.
struct Link {
    delta: f64,
    gamma: f64,
    length: f64,
    mass: f64,
    knuckle: f64,
    fires: f64,
}

/// A master rod with its links.
struct Star {
    radius: f64,
    rod: f64,
    knuckle: f64,
    throw: f64,
    bank: f64,
    mass: f64,
    fires: f64,
    links: Vec<Link>,
}

impl Star {
    fn pin(&self, theta: f64) -> Complex<f64> {
        self.radius * Complex::cis(theta + self.throw)
    }

    /// Where the piston of an axis is whose rod of this length begins there.
    fn piston(begin: Complex<f64>, bank: f64, length: f64) -> Complex<f64> {
        let seen = begin * Complex::cis(-bank);
        Complex::cis(bank) * (seen.re + (length * length - seen.im * seen.im).sqrt())
    }

    fn master(&self, theta: f64) -> Complex<f64> {
        Star::piston(self.pin(theta), self.bank, self.rod)
    }

    fn knuckle_pin(&self, link: &Link, theta: f64) -> Complex<f64> {
        let along = (self.master(theta) - self.pin(theta)) / self.rod;
        self.pin(theta) + self.knuckle * along * Complex::cis(link.gamma)
    }

    fn piston_of(&self, link: &Link, theta: f64) -> Complex<f64> {
        Star::piston(self.knuckle_pin(link, theta), self.bank + link.delta, link.length)
    }

    /// Torque on the crank and moment on the frame, from the pistons on: each body is in balance with its inertia.
    fn moments(&self, theta: f64, omega: f64, table: &[f64]) -> [f64; 2] {
        let degrees = theta.to_degrees();
        let accelerated = |way: &dyn Fn(f64) -> Complex<f64>| second_derivative(way, theta) * omega * omega;
        let (pin, master) = (self.pin(theta), self.master(theta));
        let (mut on_master, mut turning, mut roll) = (Complex::new(0.0, 0.0), 0.0, 0.0);
        for link in &self.links {
            let axis = Complex::cis(self.bank + link.delta);
            let (knuckle, piston) = (self.knuckle_pin(link, theta), self.piston_of(link, theta));
            let outward = (accelerated(&|at| self.piston_of(link, at)) * axis.conj()).re * link.mass
                + push(table, degrees - link.fires);
            let along = (piston - knuckle) / link.length;
            let thrust = along * outward / (along * axis.conj()).re;
            roll += cross(piston, axis * Complex::new(0.0, (thrust * axis.conj()).im));
            let at_knuckle = -thrust - accelerated(&|at| self.knuckle_pin(link, at)) * link.knuckle;
            on_master += at_knuckle;
            turning += cross(knuckle - pin, at_knuckle);
        }
        let axis = Complex::cis(self.bank);
        let outward =
            (accelerated(&|at| self.master(at)) * axis.conj()).re * self.mass + push(table, degrees - self.fires);
        let lever = master - pin;
        let across = (turning - outward * cross(lever, axis)) / cross(lever, axis * Complex::i());
        let thrust = axis * Complex::new(outward, across);
        roll += cross(master, axis * Complex::new(0.0, across));
        [cross(pin, on_master - thrust), roll]
    }
}

/// Random crankpins, each with a master rod and one to four links, some with corrected knuckle pins, some with masses there.
fn random_stars(dice: &mut Dice) -> (String, Vec<Star>, Vec<f64>, f64) {
    let four_stroke = dice.below(2) == 0;
    let cycle = if four_stroke { 720 } else { 360 };
    let (table, gas) = gas(dice, cycle);
    let (radius, rod, knuckle) = (40 + dice.below(10), 150 + dice.below(40), 25 + dice.below(15));
    let (corrected, speed) = (dice.below(2) == 0, 600 + dice.below(4000));
    let fires = |dice: &mut Dice, bank: i64, throw: i64| {
        (bank - throw).rem_euclid(360) + 360 * dice.below(2) as i64 * i64::from(four_stroke)
    };
    let (mut cylinders, mut angles, mut masses, mut stars) = (String::new(), vec![], vec![], Vec::new());
    let (mut corrections, mut lengths, mut knuckles, mut names) = (vec![], vec![], vec![], vec![]);
    for place in 1..=1 + dice.below(2) {
        let (throw, bank) = (15 * dice.below(24) as i64, 15 * dice.below(24) as i64);
        let mut cylinder = |dice: &mut Dice, bank: i64| {
            cylinders += &format!(
                "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{} mm'\npin = {place}\n",
                100 * place
            );
            let grams = 100 + dice.below(1500);
            masses.push(format!("'{grams} g'"));
            angles.push(fires(dice, bank, throw));
            (grams as f64 / 1e3, angles[angles.len() - 1] as f64)
        };
        let (mass, fired) = cylinder(dice, bank);
        let mut star = Star {
            radius: radius as f64 / 1e3,
            rod: rod as f64 / 1e3,
            knuckle: knuckle as f64 / 1e3,
            throw: (throw as f64).to_radians(),
            bank: (bank as f64).to_radians(),
            mass,
            fires: fired,
            links: Vec::new(),
        };
        let count = 1 + dice.below(4) as i64;
        for index in 1..=count {
            let delta = 360 * index / (count + 1) / 15 * 15;
            let (mass, fires) = cylinder(dice, bank + delta);
            let epsilon = if corrected { dice.below(7) as i64 - 3 } else { 0 };
            let (length, grams) = (rod - knuckle + dice.below(20), 50 * dice.below(6));
            corrections.push(epsilon.to_string());
            lengths.push(format!("'{length} mm'"));
            knuckles.push(format!("'{grams} g'"));
            star.links.push(Link {
                delta: (delta as f64).to_radians(),
                gamma: ((delta + epsilon) as f64).to_radians(),
                length: length as f64 / 1e3,
                mass,
                knuckle: grams as f64 / 1e3,
                fires,
            });
        }
        names.push((angles.len() as i64 - count).to_string());
        stars.push(star);
    }
    let angles: Vec<String> = angles.iter().map(ToString::to_string).collect();
    let text = format!(
        "cycle = '{}'\nspeed = {speed}\nfiring_angles = [{}]\n[mechanism]\ncrank_radius = '{radius} mm'\nrod_length = '{rod} mm'\n\
         reciprocating_mass = [{}]\n[articulated]\nmaster = [{}]\nknuckle_radius = '{knuckle} mm'\nlink_length = [{}]\n\
         knuckle_correction = [{}]\nknuckle_mass = [{}]\n{gas}{cylinders}",
        if four_stroke { "four-stroke" } else { "two-stroke" },
        angles.join(", "),
        masses.join(", "),
        names.join(", "),
        lengths.join(", "),
        corrections.join(", "),
        knuckles.join(", "),
    );
    (text, stars, table, speed as f64 / 60.0 * TAU)
}

#[test]
fn the_torque_and_roll_of_random_engines_with_links_are_those_of_their_bodies() {
    let mut dice = Dice::new(4711);
    for _ in 0..40 {
        let (text, stars, table, omega) = random_stars(&mut dice);
        let (engine, torque) = found(&text);
        let model = |theta: f64, omega: f64| -> [f64; 2] {
            let all: Vec<[f64; 2]> = stars.iter().map(|star| star.moments(theta, omega, &table)).collect();
            [0, 1].map(|place| all.iter().map(|one| one[place]).sum())
        };
        let cycle = torque.course.period();
        let angles: Vec<f64> = (0..24).map(|step| f64::from(step) * cycle / 24.0 + 0.0123).collect();
        let scale = angles.iter().map(|&theta| model(theta, omega)[0].abs()).fold(1.0, f64::max);
        for &theta in &angles {
            let [turned, rolled] = model(theta, omega);
            assert_near(torque.course.total(theta), turned, 1e-7 * scale);
            assert_near(torque.course.roll(theta).expect("one crankshaft"), rolled, 1e-7 * scale);
        }
        let law = Instants::new(&engine, None).expect("values at an angle");
        let pistons = law.pistons(angles[5].to_degrees());
        assert_near(pistons.iter().filter_map(PistonAt::torque).sum(), torque.course.total(angles[5]), 1e-9 * scale);
        assert!(pistons.iter().all(|piston| piston.rod().is_some() && piston.pin.is_some()));
        // The orders of the inertia by its own mean over a turn, without the gas, which is that at rest.
        let points = 128;
        for order in torque.orders.iter().filter(|order| order.order.is_whole() && order.order.halves() <= 10) {
            let k = f64::from(order.order.halves() / 2);
            let sum: Complex<f64> = (0..points)
                .map(|point| TAU * f64::from(point) / f64::from(points))
                .map(|theta| {
                    let inertia = model(theta, omega)[0] - model(theta, 0.0)[0];
                    Complex::cis(-k * theta) * inertia * 2.0 / f64::from(points)
                })
                .sum();
            assert_near((order.inertia.expect("masses") - sum).norm(), 0.0, 1e-6 * scale);
            assert!(!order.inertia_vanishes || sum.norm() < 1e-6 * scale);
        }
        assert!(torque.balance < 1e-9, "{}\n{text}", torque.balance);
        // H is what the frame feels, torque and knuckle pins together.
        let guides = guide_moments(&engine, &torque).expect("metres and rods");
        let roll = |order: CycleOrder| -> f64 {
            let steps = 2880;
            let step = cycle / f64::from(steps);
            let sum: Complex<f64> = (0..steps)
                .map(|at| (f64::from(at) + 0.5) * step)
                .map(|theta| {
                    Complex::cis(f64::from(order.halves()) * -0.5 * theta) * torque.course.roll(theta).expect("known")
                })
                .sum();
            2.0 * sum.norm() / f64::from(steps)
        };
        let second = guides.iter().find(|guide| guide.order.halves() == 4).expect("order 2");
        assert_near(second.rocking.unwrap_or(0.0), roll(second.order), 1e-3 * scale);
    }
}

/// Torque on each crankshaft in its own sense, and the moment on the frame about the middle of the engine, from the pistons on.
fn of_shafts(engine: &Engine, fires: &[f64], table: &[f64], theta: f64, omega: f64) -> (Vec<f64>, f64) {
    let float = |number: &num_rational::BigRational| number.to_f64().expect("a float");
    let direction = |turn: &crankstar::exact::Turn| Complex::cis(float(turn.turns()) * TAU);
    let unit = float(engine.dimensions().crank_radius.as_ref().expect("a stroke"));
    let mass = float(engine.dimensions().mass.as_ref().expect("masses"));
    let mut on_shafts = vec![0.0; engine.geared_cranks().len()];
    let mut roll = 0.0;
    for (cylinder, fires) in engine.cylinders().iter().zip(fires) {
        let crank = engine.crank_of(cylinder).expect("a crankshaft");
        let sign = if crank.sense == Sense::Direct { 1.0 } else { -1.0 };
        let shaft: Complex<f64> =
            crank.axis.iter().map(|term| direction(&term.angle) * float(&term.weight) * unit).sum();
        let up = direction(&cylinder.bank);
        let rod = cylinder.rod().expect("a rod");
        let radius = unit * float(&cylinder.crank_radius);
        let length = radius / float(&rod.ratio);
        // Of the file, on the side of ψ = 90° of the crank as it stands.
        let aside = up * Complex::new(0.0, sign * float(&rod.offset) * length);
        let pin = |theta: f64| radius * Complex::cis(sign * theta) * direction(&engine.pin_angle(cylinder));
        let piston = |theta: f64| {
            let seen = (pin(theta) - aside) * up.conj();
            aside + up * (seen.re + (length * length - seen.im * seen.im).sqrt())
        };
        let gas = push(table, theta.to_degrees() - fires);
        let accelerated = (second_derivative(&piston, theta) * up.conj()).re * omega * omega;
        let outward = accelerated * mass * float(&cylinder.reciprocating_mass) + gas;
        let along = (piston(theta) - pin(theta)) / length;
        let thrust = along * outward / (along * up.conj()).re;
        on_shafts[cylinder.crank] += sign * cross(pin(theta), -thrust);
        // Wall and head at the piston, bearings at the axis of the crankshaft.
        let wall = up * Complex::new(gas, (thrust * up.conj()).im);
        roll += cross(shaft + piston(theta), wall) + cross(shaft, -thrust);
    }
    (on_shafts, roll)
}

#[test]
fn the_torque_of_each_of_several_crankshafts_and_the_roll_are_those_of_their_bodies() {
    let mut dice = Dice::new(815);
    let mut against = 0;
    for _ in 0..40 {
        let bare = any_engine_at(&mut dice, 1);
        let engine = read(&bare);
        let cycle = if dice.below(2) == 0 { 720 } else { 360 };
        let fires: Vec<f64> = engine
            .cylinders()
            .iter()
            .map(|cylinder| cylinder.top_dead_centre().turns().to_f64().expect("a float") * 360.0)
            .map(|top| (top + 360.0 * (dice.below(2) as f64) * f64::from(u8::from(cycle == 720))).round())
            .collect();
        let (table, gas) = gas(&mut dice, cycle);
        let written: Vec<String> = fires.iter().map(ToString::to_string).collect();
        let (speed, named) = (500 + dice.below(4000), if cycle == 720 { "four-stroke" } else { "two-stroke" });
        let text = format!("cycle = '{named}'\nspeed = {speed}\nfiring_angles = [{}]\n{bare}{gas}", written.join(", "));
        let (engine, torque) = found(&text);
        let omega = speed as f64 / 60.0 * TAU;
        let shafts = engine.geared_cranks().len();
        assert_eq!(torque.shafts.len(), shafts);
        // Kinks stand at whole multiples of 3°, for throws and banks do at those of 15°.
        let mut means = vec![0.0; shafts];
        let mut scale = 1.0_f64;
        let cells = (cycle / 3) as usize;
        for cell in 0..cells {
            for (point, weight) in POINTS {
                let theta = (3.0 * (cell as f64 + point)).to_radians();
                let (own, _) = of_shafts(&engine, &fires, &table, theta, omega);
                means.iter_mut().zip(&own).for_each(|(mean, own)| *mean += own * weight / cells as f64);
                scale = own.iter().fold(scale, |scale, own| scale.max(own.abs()));
            }
        }
        for (shaft, mean) in torque.shafts.iter().zip(&means) {
            assert_near(shaft.mean, *mean, 1e-7 * scale);
        }
        assert_near(torque.mean, means.iter().sum(), 1e-7 * scale);
        let senses = engine.geared_cranks().iter().map(|crank| crank.sense);
        // With a flywheel on each, the gears carry the means to the first, where they leave.
        let carried: f64 =
            senses.zip(&means).filter(|(sense, _)| *sense == Sense::Reverse).map(|(_, mean)| 2.0 * mean).sum();
        against += u32::from(carried != 0.0);
        for theta in (0..24).map(|step| f64::from(step * cycle as i32 / 24).to_radians() + 0.0123) {
            let (own, rolled) = of_shafts(&engine, &fires, &table, theta, omega);
            for (shaft, own) in own.iter().enumerate() {
                assert_near(torque.course.on_shaft(shaft, theta), *own, 1e-7 * scale);
            }
            // The power of all shafts, which turn equally fast, leaves at the first.
            assert_near(torque.course.total(theta), own.iter().sum(), 1e-7 * scale);
            assert_near(torque.course.roll(theta).expect("places"), rolled - carried, 1e-7 * scale);
        }
        let law = Instants::new(&engine, None).expect("values at an angle");
        let pistons = law.pistons(33.0);
        let all = pistons.iter().filter_map(PistonAt::torque).sum();
        assert_near(all, torque.course.total(33.0_f64.to_radians()), 1e-9 * scale);
        for piston in &pistons {
            // A crank against the first is pushed across in its own sense.
            let (own, radius) = (piston.pin_on_the_crank.expect("forces"), engine.dimensions().crank_radius.as_ref());
            let radius = radius.and_then(ToPrimitive::to_f64).expect("a stroke");
            assert_near(own.im * radius, piston.torque().expect("forces"), 1e-9 * scale);
        }
        assert!(torque.balance < 1e-9, "{}\n{text}", torque.balance);
    }
    assert!(against > 10, "{against}");
}

const TWIN: &str = "cycle = 'four-stroke'\nspeed = 3000\nfiring_order = '1-2'\n[u]\nthrows = [0]\nsense = 'against'\ndistance = '120 mm'\nspacing = '100 mm'\n\
    [mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n\
    [gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nheat = '900 J'\n";

/// Two singles side by side in phase, against each other (theory of several crankshafts, row 1): the inertia torques cancel on the frame
/// and add at the output.
#[test]
fn inertia_torques_of_contra_rotating_singles_cancel_on_the_frame_and_add_at_the_output() {
    let (_, torque) = found(TWIN);
    let second = torque.orders.iter().find(|order| order.order.halves() == 4).expect("order 2");
    let one = torque.bodies[0].inertia.as_ref().expect("masses").at(second.order)[0];
    assert_near((second.inertia.expect("masses") - one * 2.0).norm(), 0.0, 1e-9 * one.norm());
    for theta in [0.3, 1.7, 4.0, 9.1] {
        let gas: f64 =
            [1.0, -1.0].iter().enumerate().map(|(shaft, sign)| sign * torque.course.on_shaft(shaft, theta)).sum();
        let [left, right] = [0, 1].map(|shaft| torque.course.on_shaft(shaft, theta));
        assert_near(gas, left - right, 1e-9);
        // The pistons move alike, so that the arms of their forces cancel: what rolls is the gas of one after the other.
        let carried = 2.0 * torque.shafts[1].mean;
        assert_near(
            torque.course.roll(theta).expect("a distance"),
            -(left - right) - carried,
            1e-8 * left.abs().max(right.abs()),
        );
    }
}

/// A V of twelve, and what makes its second bank hang on the first.
const TWELVE: &str = "cycle = 'four-stroke'\nspeed = 2200\nfiring_order = '1-12-5-8-3-10-6-7-2-11-4-9'\n[vee]\nbank_angle = 60\n\
    throws = [0, 240, 120, 120, 240, 0]\nspacing = '150 mm'\n[mechanism]\ncrank_radius = '80 mm'\nrod_length = '304 mm'\n\
    reciprocating_mass = '3 kg'\nLINKS[gas]\nbore = '150 mm'\ndead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 6.5\nheat = '6000 J'\n";
const LINKS: &str = "[articulated]\nmaster = [1, 2, 3, 4, 5, 6]\nknuckle_radius = '72 mm'\nknuckle_mass = '0.7 kg'\n";

/// A V of twelve whose second bank hangs on the first: what the star cancels in each bank alone is zero of both, proved; order 3, which the
/// banks of equal rods cancel together, is not.
#[test]
fn orders_that_each_bank_cancels_alone_vanish_with_links_and_order_3_does_not() {
    let of = |links: &str| found(&TWELVE.replace("LINKS", links)).1;
    let left = |torque: &EngineTorque| -> Vec<u32> {
        torque.orders.iter().filter(|order| !order.vanishes()).map(|order| order.order.halves()).collect()
    };
    assert_eq!(left(&of("")), [12, 24]);
    let linked = of(LINKS);
    assert_eq!(left(&linked), [6, 12, 18, 24]);
    assert!(linked.orders[5].total().norm() > 100.0);
}

#[test]
fn angles_of_pressures_ask_for_their_dead_centre_where_rods_are_articulated() {
    let text = "cycle = 'four-stroke'\nfiring_order = '1-3-2'\n[radial]\ncylinders = 3\n[mechanism]\nstroke = '80 mm'\nrod_length = '160 mm'\n\
        [articulated]\nmaster = 1\nknuckle_radius = '40 mm'\n[gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 6\nheat = '900 J'\n";
    let told = file::parse("engine.toml", text).expect_err("no dead centre").to_string();
    assert!(told.contains("with articulated rods the crank and a piston have dead centres of their own"), "{told}");
    let piston = found(&text.replace("[gas]\n", "[gas]\ndead_centre = 'piston'\n")).1;
    // Farthest out the volume is the clearance, a fifth of what is swept.
    for class in &piston.classes {
        let geometry = class.gas.geometry();
        assert_near(geometry.volume(class.gas.zero()), geometry.swept() / 5.0, 1e-9 * geometry.swept());
        assert_near(geometry.lever(class.gas.zero()), 0.0, 1e-9);
    }
}

#[test]
fn a_faster_crankshaft_is_refused_in_one_clear_message() {
    let fast = "[[crankshaft]]\nname = 'a'\nsense = 'with'\noffset = 0\n[[crankshaft]]\nname = 'b'\nsense = 'with'\nspeed = 2\noffset = 4\n\
        [[cylinder]]\ncrankshaft = 'a'\nthrow = 0\nbank = 0\nposition = 0\n[[cylinder]]\ncrankshaft = 'b'\nthrow = 0\nbank = 0\nposition = 0\n\
        [mechanism]\nstroke = '80 mm'\nrod_length = '160 mm'\n[gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 6\nheat = '900 J'\n";
    let why = torque(&read(&format!("cycle = 'four-stroke'\n{fast}"))).expect_err("two speeds");
    assert_eq!(why, Missing::FasterCrank("the torque of the gas"));
}

/// On mounts the roll of an order is that of the curve, and an order that each bank cancels alone leaves the engine still, proved.
#[test]
fn on_mounts_an_engine_with_links_rolls_as_its_torque_says() {
    let block = "[block]\nmass = '800 kg'\ninertia = [100, 90, 60]\ncentre = [0, 0, 0]\n[[mount]]\nplace = [0, 0.3, 0.2]\nstiffness = [2e5, 1e5, 9e4]\n\
        [[mount]]\nplace = [0.1, -0.3, 0]\nstiffness = [2e5, 1e5, 9e4]\n[[mount]]\nplace = [-0.1, 0, -0.4]\nstiffness = [2e5, 1e5, 9e4]\n";
    let (engine, torque) = found(&(TWELVE.replace("LINKS", LINKS) + block));
    let orders: Vec<CycleOrder> = [1, 4, 6, 12].into_iter().filter_map(CycleOrder::of_halves).collect();
    let mounting = engine.mounting().expect("mounts");
    let shaken = excitation(&engine, mounting, &orders).expect("numbers").orders;
    let steps = 1440;
    for (order, is_still) in shaken.iter().zip([true, true, false, false]) {
        let kappa = f64::from(order.order.halves()) / 2.0;
        let sum: Complex<f64> = (0..steps)
            .map(|step| (f64::from(step) + 0.5) * 2.0 * TAU / f64::from(steps))
            .map(|theta| Complex::cis(-kappa * theta) * torque.course.roll(theta).expect("one crankshaft"))
            .sum();
        let [_, moment] = order.at(2200.0);
        assert_near((moment[2] - sum * 2.0 / f64::from(steps)).norm(), 0.0, 0.05);
        assert_eq!((order.still.roll, moment[2].norm() < 1e-9), (is_still, is_still), "{}", order.order);
    }
    let far = CycleOrder::of_halves(26).expect("order 13");
    assert!(excitation(&engine, mounting, &[far]).is_err());
}
