//! Does an engine shake on its mounts as a rigid body on springs does?

use std::f64::consts::TAU;

use crankstar::engine::{CycleOrder, Engine, Mounting};
use crankstar::file;
use crankstar::mounts::{Body, Motion, Phasors, excitation, roll_axis};
use crankstar::report::{AtSpeed, MountsAsked, MountsStudy, Place};
use num_complex::Complex;
use num_traits::ToPrimitive;

use super::true_sentences::said;
use crate::support::dice::Dice;

/// An in-line four of 86 by 86 mm, rods 143 mm, spark ignition (`theory-gas`, section 2).
const FOUR: &str = "title = 'Four'\ncycle = 'four-stroke'\nfiring_order = '1-3-4-2'\nspeed = SPEED\n\
    [inline]\nthrows = [0, 180, 180, 0]\nspacing = '94 mm'\n\
    [mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\nreciprocating_mass = '0.5 kg'\n\
    [gas]\nbore = '86 mm'\ncrankcase = '1 bar'\nintake_pressure = '0.9 bar'\nexhaust_pressure = '1.1 bar'\n\
    process = 'spark-ignition'\ncompression_ratio = 10\nheat = '1100 J'\n";

/// Three mounts of `theory-trade`, section 1.
const MOUNTS: &str = "[block]\nmass = '180 kg'\ninertia = [13, 11, 6.5]\ntensor_entries = [0.3, 0.4, -1.1]\n\
    centre = ['100 mm', '15 mm', '-60 mm']\npoint = [0.42, 0, 0.30]\n\
    [[mount]]\nplace = [0.05, 0.32, 0.20]\nstiffness = ['220 kN/m', '110 N/mm', 90000]\ndamping = ['350 N s/m', 180, 150]\n\
    [[mount]]\nplace = [0.08, -0.34, 0.05]\nstiffness = [260e3, 120e3, 100e3]\ndamping = [400, 200, 160]\nturned = [0, 0, 30]\n\
    [[mount]]\nplace = [-0.15, 0.05, -0.45]\nstiffness = [150e3, 70e3, 80e3]\ndamping = [250, 120, 120]\n";

fn read(text: &str) -> Engine {
    file::parse("mounted.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn four(speed: u32) -> Engine {
    read(&(FOUR.replace("SPEED", &speed.to_string()) + MOUNTS))
}

fn mounting(engine: &Engine) -> &Mounting {
    engine.mounting().expect("mounts")
}

/// The motion of an order, with its excitation.
fn moved(engine: &Engine, halves: u32) -> ([Phasors; 2], Motion) {
    let order = CycleOrder::of_halves(halves).expect("an order");
    let shaken = excitation(engine, mounting(engine), &[order]).unwrap_or_else(|why| panic!("{why}"));
    let rpm = engine.dimensions().speed.as_ref().and_then(ToPrimitive::to_f64).expect("a speed");
    let order = &shaken.orders[0];
    let [force, moment] = order.at(rpm);
    let motion = Body::new(mounting(engine)).motion(order.omega(rpm), force, moment).expect("damped");
    ([force, moment], motion)
}

fn assert_peaks(what: &str, found: Phasors, unit: f64, right: [f64; 3]) {
    for (found, right) in found.iter().zip(right) {
        let found = found.norm() / unit;
        assert!((found - right).abs() < 6e-7 * right.max(1.0), "{what}: {found} for {right}");
    }
}

/// `theory-trade`, section 1: two eigensolvers.
#[test]
fn six_frequencies_of_the_four_on_three_mounts_come_out() {
    let body = Body::new(mounting(&four(3000)));
    let right = [5.856_231_193, 6.534_214_826, 8.697_158_042, 9.003_257_162, 10.737_075_926, 14.615_521_018];
    let modes = body.modes();
    assert_eq!(modes.len(), 6);
    for (mode, right) in modes.iter().zip(right) {
        assert!((mode.hertz() - right).abs() < 1e-9 * right, "{} for {right}", mode.hertz());
        let sum: f64 = mode.shares.iter().sum();
        assert!((sum - 1.0).abs() < 1e-12, "shares add up to {sum}");
    }
    assert!(modes.iter().any(|mode| mode.shares.iter().any(|share| *share < 0.0)), "no share is below 0 here");
}

/// `theory-trade`, section 1: peaks of order 2 along x, y and z.
#[test]
fn the_second_order_of_the_four_moves_centre_point_and_mount_as_the_theory_has_it() {
    type Row = (u32, [f64; 3], [f64; 3], [f64; 3], [f64; 3]);
    let rows: [Row; 2] = [
        (
            800,
            [41.134184, 1.685526, 1.278497],
            [123.537850, 200.495587, 2053.727202],
            [20.135469, 117.338388, 10.258303],
            [130.813962, 8.199440, 2.555358],
        ),
        (
            3000,
            [37.086298, 0.046735, 0.020852],
            [2.275181, 39.710659, 46.402029],
            [32.525331, 9.854900, 7.956802],
            [12.512328, 0.270382, 0.189711],
        ),
    ];
    for (rpm, centre, turned, speed, force) in rows {
        let engine = four(rpm);
        let body = Body::new(mounting(&engine));
        let (_, motion) = moved(&engine, 4);
        assert_peaks("centre of gravity", motion.centre, 1e-6, centre);
        assert_peaks("rotation", motion.turned, 1e-6, turned);
        let point = mounting(&engine).block.point.as_ref().expect("a point");
        assert_peaks("velocity", body.at_point(point, &motion), 1e-3 / motion.omega, speed);
        assert_peaks("mount 1", body.mount_force(0, &motion), 1.0, force);
    }
}

/// `theory-trade`, section 1: η = 0.1 in place of the dampers.
#[test]
fn loss_factors_in_place_of_dampers_move_the_centre_as_the_theory_has_it() {
    let text: String = MOUNTS
        .lines()
        .map(|line| if line.starts_with("damping") { "loss_factor = 0.1\n".to_owned() } else { format!("{line}\n") })
        .collect();
    let (_, motion) = moved(&read(&(FOUR.replace("SPEED", "3000") + &text)), 4);
    let found = motion.centre[0].norm() * 1e6;
    assert!((found - 37.090_949).abs() < 1e-6, "{found}");
}

/// An engine of cylinders, block and mounts that nothing is special about.
fn random(dice: &mut Dice) -> String {
    let mut number = |low: i64, high: i64| low + dice.below((high - low + 1) as u64) as i64;
    let mut text = format!("speed = {}\n", number(400, 3000));
    text += &format!("[mechanism]\nstroke = '{} mm'\nrod_length = '{} mm'\n", number(60, 100), number(130, 200));
    text += &format!(
        "[block]\nmass = {}\ninertia = [{}, {}, {}]\nproducts_of_inertia = [0.{}, -0.{}, 0.{}]\ncentre = ['{} mm', '{} mm', '{} mm']\n",
        number(80, 300),
        number(9, 13),
        number(9, 13),
        number(5, 7),
        number(1, 9),
        number(1, 9),
        number(1, 9),
        number(-100, 100),
        number(-50, 50),
        number(-90, 90)
    );
    for _ in 0..number(3, 5) {
        text += "[[mount]]\n";
        let place: Vec<String> = (0..3).map(|_| format!("'{} mm'", number(-400, 400))).collect();
        let springs: Vec<String> = (0..3).map(|_| format!("'{} kN/m'", number(60, 300))).collect();
        let dampers: Vec<String> = (0..3).map(|_| format!("{}", number(1500, 4000))).collect();
        let turned: Vec<String> = (0..3).map(|_| format!("{}", number(-90, 90))).collect();
        text += &format!(
            "place = [{}]\nstiffness = [{}]\ndamping = [{}]\nturned = [{}]\n",
            place.join(", "),
            springs.join(", "),
            dampers.join(", "),
            turned.join(", ")
        );
    }
    for _ in 0..number(1, 4) {
        let (throw, bank, at) = (15 * number(0, 23), 15 * number(-6, 6), number(-250, 250));
        let mass = number(300, 900);
        text += &format!(
            "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{at} mm'\nreciprocating_mass = '{mass} g'\n"
        );
    }
    text
}

/// Σ mount forces = F + Ω²m q: what the mounts pass on and the body's inertia hold the shaking force in balance.
#[test]
fn mount_forces_of_random_engines_hold_force_and_inertia_in_balance() {
    let mut dice = Dice::new(30);
    for _ in 0..40 {
        let engine = read(&random(&mut dice));
        let body = Body::new(mounting(&engine));
        for halves in [2, 4, 8] {
            let ([force, _], motion) = moved(&engine, halves);
            let mass = mounting(&engine).block.mass.to_f64().expect("a mass");
            let scale: f64 =
                (0..body.mounts()).map(|mount| body.mount_force(mount, &motion)[0].norm()).sum::<f64>() + 1.0;
            for (axis, force) in force.into_iter().enumerate() {
                let mounts: Complex<f64> = (0..body.mounts()).map(|mount| body.mount_force(mount, &motion)[axis]).sum();
                let right = force + motion.centre[axis] * (mass * motion.omega * motion.omega);
                assert!((mounts - right).norm() < 1e-9 * scale, "{mounts} for {right}");
            }
        }
    }
}

type Six = [f64; 6];

/// A mount: place, axes, stiffnesses, dampings.
type Held = ([f64; 3], [[f64; 3]; 3], [f64; 3], [f64; 3]);

/// What pistons do to a body, integrated in time: no phasors, stars or matrices of the program.
struct TimeLaw {
    engine: Engine,
    omega: f64,
    mass: f64,
    inverse_inertia: [[f64; 3]; 3],
    centre: [f64; 3],
    mounts: Vec<Held>,
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn times(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

/// Turned about a fixed axis, by Rodrigues' formula.
fn turned(vector: [f64; 3], axis: usize, turns: f64) -> [f64; 3] {
    let mut about = [0.0; 3];
    about[axis] = 1.0;
    let (sin, cos) = (turns * TAU).sin_cos();
    let beside = cross(about, vector);
    std::array::from_fn(|k| vector[k] * cos + beside[k] * sin + about[k] * vector[axis] * (1.0 - cos))
}

impl TimeLaw {
    fn new(engine: Engine) -> Self {
        let float = |value: &crankstar::BigRational| value.to_f64().expect("a float");
        let mounting = mounting(&engine);
        let block = &mounting.block;
        let [a, b, c] = block.moments.each_ref().map(float);
        let [d, e, f] = block.products.each_ref().map(|product| -float(product));
        // Rows of the inverse of a symmetric matrix: cross products of its columns over its determinant.
        let columns = [[a, d, e], [d, b, f], [e, f, c]];
        let [p, q, r] = [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])];
        let determinant: f64 = (0..3).map(|k| columns[0][k] * p[k]).sum();
        let mount = |mount: &crankstar::engine::Mount| {
            let axes = std::array::from_fn(|own| {
                let mut axis = [0.0; 3];
                axis[own] = 1.0;
                (0..3).fold(axis, |axis, about| turned(axis, about, float(&mount.turned[about])))
            });
            (
                mount.place.each_ref().map(float),
                axes,
                mount.stiffness.each_ref().map(float),
                mount.damping.each_ref().map(float),
            )
        };
        TimeLaw {
            omega: float(engine.dimensions().speed.as_ref().expect("a speed")) / 60.0 * TAU,
            mass: float(&block.mass),
            inverse_inertia: [p, q, r].map(|row| row.map(|part| part / determinant)),
            centre: block.centre.each_ref().map(float),
            mounts: mounting.mounts.iter().map(mount).collect(),
            engine,
        }
    }

    /// Force and moment about the centre of gravity at a crank angle: d'Alembert's on each piston, and what its wall and bearings turn.
    fn load(&self, theta: f64) -> [[f64; 3]; 2] {
        let dimensions = self.engine.dimensions();
        let unit = dimensions.crank_radius.as_ref().and_then(ToPrimitive::to_f64).expect("a radius");
        let kilogram = dimensions.mass.as_ref().and_then(ToPrimitive::to_f64).expect("a mass");
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for cylinder in self.engine.cylinders() {
            let radius = unit * cylinder.crank_radius.to_f64().expect("a radius");
            let mass = kilogram * cylinder.reciprocating_mass.to_f64().expect("a mass");
            let ratio = cylinder.rod().expect("a rod").ratio.to_f64().expect("a ratio");
            let bank = cylinder.bank.turns().to_f64().expect("an angle") * TAU;
            let psi = theta + cylinder.throw.turns().to_f64().expect("an angle") * TAU - bank;
            let root = (1.0 - (ratio * psi.sin()).powi(2)).sqrt();
            let first = -radius * (psi.sin() + ratio * psi.sin() * psi.cos() / root);
            let second = -radius
                * (psi.cos()
                    + ratio * ((2.0 * psi).cos() / root + (ratio * psi.sin() * psi.cos()).powi(2) / root.powi(3)));
            let along = -mass * second * self.omega * self.omega;
            let own = [along * bank.cos(), along * bank.sin(), 0.0];
            let place = [0.0, 0.0, cylinder.position.to_f64().expect("a position")];
            let arm = std::array::from_fn(|axis| place[axis] - self.centre[axis]);
            let about = cross(arm, own);
            // The torque on the crank −m s̈ ds/dθ turns the frame the other way.
            let torque = -mass * first * second * self.omega * self.omega;
            for axis in 0..3 {
                force[axis] += own[axis];
                moment[axis] += about[axis];
            }
            moment[2] -= torque;
        }
        [force, moment]
    }

    fn slope(&self, time: f64, [place, speed]: [Six; 2]) -> [Six; 2] {
        let [mut force, mut moment] = self.load(self.omega * time);
        let [to, on] = [place, speed].map(|six| ([six[0], six[1], six[2]], [six[3], six[4], six[5]]));
        for (at, axes, springs, dampers) in &self.mounts {
            let arm = std::array::from_fn(|axis| at[axis] - self.centre[axis]);
            let [shift, velocity] = [to, on].map(|(moved, turned)| {
                let swept = cross(turned, arm);
                std::array::from_fn::<f64, 3, _>(|axis| moved[axis] + swept[axis])
            });
            for (own, axis) in axes.iter().enumerate() {
                let dot = |vector: &[f64; 3]| (0..3).map(|k| vector[k] * axis[k]).sum::<f64>();
                let held = -springs[own] * dot(&shift) - dampers[own] * dot(&velocity);
                let answer = axis.map(|part| part * held);
                let about = cross(arm, answer);
                for k in 0..3 {
                    force[k] += answer[k];
                    moment[k] += about[k];
                }
            }
        }
        let turn = times(&self.inverse_inertia, moment);
        [speed, [force[0] / self.mass, force[1] / self.mass, force[2] / self.mass, turn[0], turn[1], turn[2]]]
    }

    /// The phasors of orders after many revolutions, by the method of Runge and Kutta.
    fn orders(&self, orders: [u32; 2], revolutions: u32) -> [[Complex<f64>; 6]; 2] {
        const STEPS: u32 = 240;
        let step = TAU / self.omega / f64::from(STEPS);
        let add = |one: [Six; 2], slope: [Six; 2], by: f64| -> [Six; 2] {
            std::array::from_fn(|half| std::array::from_fn(|k| one[half][k] + by * slope[half][k]))
        };
        let mut state = [[0.0; 6]; 2];
        let mut phasors = [[Complex::default(); 6]; 2];
        for number in 0..revolutions * STEPS {
            let time = f64::from(number) * step;
            if number >= (revolutions - 1) * STEPS {
                for (phasors, order) in phasors.iter_mut().zip(orders) {
                    let turn = Complex::cis(-f64::from(order) * self.omega * time) * (2.0 / f64::from(STEPS));
                    for (phasor, place) in phasors.iter_mut().zip(state[0]) {
                        *phasor += turn * place;
                    }
                }
            }
            let one = self.slope(time, state);
            let two = self.slope(time + step / 2.0, add(state, one, step / 2.0));
            let three = self.slope(time + step / 2.0, add(state, two, step / 2.0));
            let four = self.slope(time + step, add(state, three, step));
            state = add(add(add(add(state, one, step / 6.0), two, step / 3.0), three, step / 3.0), four, step / 6.0);
        }
        phasors
    }
}

#[test]
fn a_random_engine_moves_as_pistons_springs_and_dampers_integrated_in_time() {
    let engine = read(&random(&mut Dice::new(31)));
    let law = TimeLaw::new(engine.clone());
    // Eight seconds: by then the beginning has died away.
    let orders = [1, 2];
    for (order, right) in orders.into_iter().zip(law.orders(orders, (8.0 * law.omega / TAU) as u32)) {
        let found = moved(&engine, 2 * order).1.all();
        for half in [0..3, 3..6] {
            let size: f64 = right[half.clone()].iter().map(|part| part.norm()).sum();
            for axis in half {
                let off = (found[axis] - right[axis]).norm();
                assert!(off < 1e-6 * size, "order {order}, {axis}: {} for {}", found[axis], right[axis]);
            }
        }
    }
}

/// `theory-trade`, section 1: body and four mounts with two planes of symmetry.
#[test]
fn four_mounts_with_two_planes_of_symmetry_have_the_frequencies_of_the_formulas() {
    let text = "[inline]\nthrows = [0]\n[block]\nmass = 150\ninertia = [9, 8, 5]\ncentre = [0.05, 0, 0]\n".to_owned()
        + &[[0.3, 0.25], [0.3, -0.25], [-0.3, 0.25], [-0.3, -0.25]]
            .map(|[z, y]| format!("[[mount]]\nplace = [-0.07, {y}, {z}]\nstiffness = [150e3, 80e3, 60e3]\n"))
            .concat();
    let engine = read(&text);
    assert_eq!(mounting(&engine).mirrors(), [false, true, true]);
    let (m, [ix, iy, iz], [kx, ky, kz]) = (150.0, [9.0, 8.0, 5.0], [150e3, 80e3, 60e3]);
    let (a, b, g): (f64, f64, f64) = (0.3, 0.25, 0.12);
    // Mounts stand at x = −g below G; a pair [[p, q], [q, r]] on (m, i) has the roots of a quadratic.
    let pair = |p: f64, q: f64, r: f64, i: f64| {
        let (sum, product) = (p / m + r / i, (p * r - q * q) / (m * i));
        let root = (sum * sum / 4.0 - product).sqrt();
        [sum / 2.0 - root, sum / 2.0 + root]
    };
    let mut right = vec![4.0 * kx / m, 4.0 * (ky * a * a + kz * b * b) / ix];
    right.extend(pair(4.0 * ky, -4.0 * ky * g, 4.0 * (kx * b * b + ky * g * g), iz));
    right.extend(pair(4.0 * kz, 4.0 * kz * g, 4.0 * (kx * a * a + kz * g * g), iy));
    right.sort_by(f64::total_cmp);
    for (mode, right) in Body::new(mounting(&engine)).modes().iter().zip(right) {
        assert!((mode.omega - right.sqrt()).abs() < 1e-9 * right.sqrt(), "{} for {}", mode.omega, right.sqrt());
    }
}

/// `theory-trade`, section 1: `I d` is along the crankshaft; on decoupled mounts the roll moment makes a pure turn.
#[test]
fn roll_turns_a_body_about_the_torque_roll_axis_where_the_mounts_are_decoupled() {
    let engine = four(3000);
    let axis = roll_axis(&Body::new(mounting(&engine))).expect("an inertia");
    assert!(axis.coupling > 0.01, "these mounts are not decoupled: {axis:?}");
    let unit: f64 = axis.direction.iter().map(|part| part * part).sum();
    assert!((unit - 1.0).abs() < 1e-12 && axis.direction[2] > 0.0);
    // I d is along the crankshaft.
    let tensor = mounting(&engine).block.tensor();
    let along: Vec<f64> = tensor
        .iter()
        .map(|row| row.iter().zip(axis.direction).map(|(i, d)| i.to_f64().expect("a float") * d).sum())
        .collect();
    assert!(along[0].abs() < 1e-12 * along[2] && along[1].abs() < 1e-12 * along[2], "{along:?}");

    let upright = "[inline]\nthrows = [0]\n[block]\nmass = 150\ninertia = [9, 8, 5]\ncentre = [0, 0, 0]\n".to_owned()
        + &[[0.3, 0.25], [0.3, -0.25], [-0.3, 0.25], [-0.3, -0.25]]
            .map(|[z, y]| format!("[[mount]]\nplace = [0, {y}, {z}]\nstiffness = [150e3, 80e3, 60e3]\ndamping = 100\n"))
            .concat();
    let body = Body::new(mounting(&read(&upright)));
    let axis = roll_axis(&body).expect("an inertia");
    assert!(axis.coupling < 1e-7 && axis.from_crankshaft < 1e-7, "{axis:?}");
    let zero = Complex::default();
    let motion = body.motion(40.0, [zero; 3], [zero, zero, Complex::new(100.0, 0.0)]).expect("damped");
    let turn = motion.turned[2].norm();
    assert!(motion.all()[..5].iter().all(|part| part.norm() < 1e-12 * turn), "{motion:?}");
}

/// Each with a part of the message, and of the place that it points to.
#[test]
fn bodies_and_mounts_that_are_none_are_refused_in_one_clear_message() {
    let file = FOUR.replace("SPEED", "3000") + MOUNTS;
    let second = "[[mount]]\nplace = [0.08, -0.34, 0.05]\n";
    let cases = [
        ("[13, 11, 6.5]", "[13, 11, 0]", "the inertia tensor is not positive definite"),
        ("[13, 11, 6.5]", "[13, 11, 25]", "I_xx + I_yy < I_zz: no body has that"),
        ("[13, 11, 6.5]", "[20, 11, 6.5]", "I_yy + I_zz < I_xx: no body has that"),
        ("[13, 11, 6.5]", "[13, 20, 6.5]", "I_xx + I_zz < I_yy: no body has that"),
        ("[0.3, 0.4, -1.1]", "[3.5, 0, 0]", "no body has these products of inertia"),
        ("[13, 11, 6.5]", "[13, 11, 6.5, 0.3, 0.4, -1.1]", "products of inertia or tensor entries? their signs differ"),
        ("[13, 11, 6.5]", "[13, 11]", "2 values: moment of inertia"),
        ("centre = ['100 mm', '15 mm', '-60 mm']", "centre = ['1 mm', 0]", "2 values: centre"),
        (
            "tensor_entries",
            "products_of_inertia = [0, 0, 0]\ntensor_entries",
            "the products of inertia are given twice",
        ),
        ("mass = '180 kg'", "mass = 0", "the mass of the block is not above 0"),
        ("mass = '180 kg'", "mass = -1", "mass"),
        ("110 N/mm", "0 N/mm", "a stiffness of mount 1 is not above 0"),
        ("110 N/mm", "110 N", "cannot read the stiffness `110 N`"),
        ("180, 150]", "-180, 150]", "the damping or the loss factor of mount 1 is below 0"),
        ("damping = [250, 120, 120]", "loss_factor = -1", "the damping or the loss factor of mount 3 is below 0"),
        ("damping = [250, 120, 120]", "loss_factor = 1e50", "cannot read the loss factor"),
        ("turned = [0, 0, 30]", "turned = [0, 0]", "2 values: angle"),
        ("centre = ['100 mm', '15 mm', '-60 mm']\n", "", "the key `centre` is missing"),
        (second, "[[mount]]\nplace = [-0.05, 0.185, -0.125]\n", "all mounts lie on one line"),
    ];
    for (from, to, message) in cases {
        assert!(file.contains(from), "{from}");
        let Err(error) = file::parse("mounted.toml", &file.replacen(from, to, 1)) else { panic!("read: {message}") };
        let error = error.to_string();
        assert!(error.contains(message), "{message}: {error}");
        assert!(error.contains("mounted.toml:"), "no place: {error}");
    }
    let (block, mounts) = MOUNTS.split_at(MOUNTS.find("[[mount]]").expect("mounts"));
    let one: String = mounts.split_inclusive("[[mount]]").take(2).collect::<String>();
    for (text, message) in [
        (block.to_owned(), "a [block] without mounts"),
        (mounts.to_owned(), "mounts without a [block]"),
        (block.to_owned() + one.trim_end_matches("[[mount]]"), "all mounts are at one place"),
    ] {
        let error =
            file::parse("mounted.toml", &(FOUR.replace("SPEED", "3000") + &text)).expect_err(message).to_string();
        assert!(error.contains(message), "{message}: {error}");
    }
}

#[test]
fn what_an_engine_on_its_mounts_lacks_is_named() {
    let ask = |text: &str, asked: MountsAsked| match MountsStudy::new(&read(text), &asked) {
        Ok(_) => panic!("an answer"),
        Err(why) => why.to_string(),
    };
    let file = FOUR.replace("SPEED", "3000") + MOUNTS;
    let usual = MountsAsked::default;
    assert!(ask(&FOUR.replace("SPEED", "3000"), usual()).contains("[[mount]]"));
    assert!(ask(&file.replace("speed = 3000\n", ""), usual()).contains("speed"));
    assert!(ask(&file.replace("spacing = '94 mm'\n", ""), usual()).contains("spacing"));
    assert!(ask(&file.replace("firing_order = '1-3-4-2'\n", ""), usual()).contains("firing"));
    for speed in [0.0, -3.0, f64::NAN, f64::INFINITY, 1e7] {
        assert!(ask(&file, MountsAsked { speed: Some(speed), ..usual() }).contains("is no speed"));
    }
    let at_rest = ask(&file.replace("speed = 3000", "speed = '0 rpm'"), usual());
    assert!(at_rest.contains("the speed of the layout, 0 rpm, is none to shake at"), "{at_rest}");
    assert!(ask(&file, MountsAsked { from: Some(3000.0), ..usual() }).contains("is no range"));
    let orders = vec!["13".parse().expect("an order")];
    assert!(ask(&file, MountsAsked { orders, ..usual() }).contains("up to order 12"));
    let shaft = "[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 0.003\nangle = 180\nposition = 0\n";
    assert!(ask(&(file + shaft), usual()).contains("height"));
}

/// Force, moment and roll of an order vanish where the exact sums do: a boxer six without gas rolls in its third order alone.
#[test]
fn an_order_leaves_the_engine_still_exactly_where_force_moment_and_roll_vanish() {
    let orders = |engine: &Engine| -> Vec<(String, [bool; 3])> {
        let study = MountsStudy::new(engine, &MountsAsked::default()).expect("a study");
        let still = |one: &crankstar::report::OrderMotion| {
            let still = one.excitation.still;
            (one.excitation.order.to_string(), [still.force, still.moment, still.roll])
        };
        study.orders.iter().map(still).collect()
    };
    let four = orders(&four(3000));
    let moving: Vec<&str> = four.iter().filter(|one| one.1 != [true; 3]).map(|one| one.0.as_str()).collect();
    assert_eq!(moving, ["2", "4", "6"]);
    let six = "cycle = 'four-stroke'\nfiring_order = '1-5-3-6-2-4'\nspeed = 3000\n[inline]\nthrows = [0, 240, 120, 120, 240, 0]\nspacing = '100 mm'\n".to_owned()
        + &FOUR[FOUR.find("[mechanism]").expect("a mechanism")..]
        + MOUNTS;
    for (order, still) in orders(&read(&six)) {
        let rolls = ["3", "6"].contains(&order.as_str());
        // Forces and moments vanish below the sixth order; the roll moment does not in the firing orders.
        assert_eq!(still, [order != "6", true, !rolls], "order {order}");
    }
}

/// `√(½ Σ v²)` over the orders is the rms of the sum of their time courses.
#[test]
fn rms_over_the_orders_is_that_of_the_motion_through_the_cycle() {
    let engine = four(800);
    let study = MountsStudy::new(&engine, &MountsAsked::default()).expect("a study");
    const STEPS: u32 = 720;
    let course = |step: u32, axis: usize| -> f64 {
        let theta = 2.0 * TAU * f64::from(step) / f64::from(STEPS);
        let at = |one: &crankstar::report::OrderMotion| {
            let motion = one.motion.as_ref().expect("damped");
            let kappa = f64::from(one.excitation.order.halves()) / 2.0;
            (Complex::i() * motion.omega * motion.centre[axis] * Complex::cis(kappa * theta)).re
        };
        study.orders.iter().map(at).sum()
    };
    let found = study.rms(Place::Centre, 1).expect("damped");
    for (axis, found) in found.into_iter().enumerate() {
        let square: f64 = (0..STEPS).map(|step| course(step, axis).powi(2)).sum::<f64>() / f64::from(STEPS);
        assert!((found - square.sqrt()).abs() < 1e-9 * found, "{found} for {}", square.sqrt());
    }
}

/// A drawing in which the crank turns clockwise is the mirror image: all amplitudes and frequencies are those of the other.
#[test]
fn an_engine_drawn_from_the_other_end_moves_as_its_mirror_image() {
    let text = FOUR.replace("SPEED", "900") + MOUNTS;
    let mirrored = "rotation = 'clockwise'\n".to_owned()
        + &text
            .replace("0.32, 0.20", "-0.32, 0.20")
            .replace("-0.34, 0.05", "0.34, 0.05")
            .replace("0.05, -0.45", "-0.05, -0.45")
            .replace("'15 mm'", "'-15 mm'")
            .replace("[0.3, 0.4, -1.1]", "[-0.3, 0.4, 1.1]")
            .replace("[0, 0, 30]", "[0, 0, -30]");
    let [one, other] = [text, mirrored].map(|text| moved(&read(&text), 4).1.all());
    for (one, other) in one.iter().zip(other) {
        assert!((one.norm() - other.norm()).abs() < 1e-9 * one.norm(), "{one} for {other}");
    }
}

/// A fine scan, of engines on mounts with little damping: their peaks are narrow.
#[test]
fn nothing_in_a_range_of_speeds_is_larger_than_what_its_table_tells() {
    let mut dice = Dice::new(52);
    for _ in 0..12 {
        let text = random(&mut dice).replace("damping = [", "damping = [2e1, 3e1, 1e1] # [");
        let asked = MountsAsked { from: Some(200.0), to: Some(3000.0), ..MountsAsked::default() };
        let study = MountsStudy::new(&read(&text), &asked).unwrap_or_else(|why| panic!("{why}"));
        for (place, order) in study.orders.iter().enumerate() {
            let told = |of: fn(&AtSpeed) -> Option<f64>| {
                let sizes = study.range().iter().filter(|at| at.order == place).filter_map(of);
                sizes.fold(0.0, f64::max)
            };
            let [velocity, force] = [told(|at| at.velocity), told(|at| at.force)];
            for step in 0..=4000 {
                let rpm = 200.0 + 0.7 * f64::from(step);
                let [load, moment] = order.excitation.at(rpm);
                let motion = study.body.motion(order.excitation.omega(rpm), load, moment).expect("damped");
                let largest = |parts: Phasors| parts.iter().map(|part| part.norm()).fold(0.0, f64::max);
                let moved = largest(study.displacement(study.watched(), &motion)) * motion.omega;
                let passed = (0..study.body.mounts()).map(|mount| largest(study.body.mount_force(mount, &motion)));
                let passed = passed.fold(0.0, f64::max);
                assert!(moved <= velocity * (1.0 + 1e-6), "{moved} at {rpm}, {velocity} told\n{text}");
                assert!(passed <= force * (1.0 + 1e-6), "{passed} at {rpm}, {force} told\n{text}");
            }
        }
    }
}

#[test]
fn an_order_that_meets_a_mode_without_damping_has_no_largest_value() {
    let text = random(&mut Dice::new(53)).replace("damping = [", "# damping = [");
    let asked = MountsAsked { from: Some(60.0), to: Some(6000.0), ..MountsAsked::default() };
    let study = MountsStudy::new(&read(&text), &asked).unwrap_or_else(|why| panic!("{why}"));
    let first = &study.orders[0].excitation.order;
    for mode in &study.modes {
        let rpm = first.rpm(mode.hertz());
        let at = study.range().iter().find(|at| at.order == 0 && at.rpm == rpm).expect("the speed is in the range");
        assert!(at.velocity.is_none() && at.force.is_none(), "{at:?}");
    }
}

#[test]
fn every_speed_without_a_bound_is_told() {
    let text = random(&mut Dice::new(53)).replace("damping = [", "# damping = [");
    let asked = MountsAsked { from: Some(60.0), to: Some(6000.0), ..MountsAsked::default() };
    let study = MountsStudy::new(&read(&text), &asked).unwrap_or_else(|why| panic!("{why}"));
    let page = crate::support::pages::text(&crankstar::report::Question::page(&study), crate::support::pages::DOLLARS);
    let endless = study.range().iter().filter(|at| at.order == 0 && at.velocity.is_none()).count();
    let row = page.lines().find(|line| line.starts_with("| ") && line.contains("no bound")).expect("a row");
    assert!(endless > 1 && row.matches("rpm").count() == 2 * endless, "{endless} in {row}");
}

/// The page tells the largest force through a revolution, as the loads do, not the larger of its components.
#[test]
fn the_force_that_shakes_an_engine_is_that_of_its_loads() {
    let layout = "title = 'Inclined'\nspeed = 2400\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.6 kg'\n\
        rotating_mass = '0.5 kg'\n[[cylinder]]\nthrow = 10\nbank = 30\nposition = '5 mm'\n"
        .to_owned()
        + MOUNTS;
    let shaken = said("mounts", &layout, &["--orders", "1,2", "--format", "markdown"]);
    let (_, shaken) = shaken.split_once("## What shakes").expect("a heading");
    let loads = said("loads", &layout, &["--orders", "1,2", "--format", "markdown"]);
    let force = |page: &str, order: &str| {
        let row = page.split(&format!("| {order} | ≈ ")).nth(1).unwrap_or_else(|| panic!("{page}"));
        row.split(" |").next().expect("a number").to_owned()
    };
    for order in ["1", "2"] {
        assert_eq!(force(shaken, order), force(&loads, order), "order {order}");
    }
}
