//! Do rods, crankpins, walls and main bearings feel what Newton's law says of each body, gas and masses together?
//!
//! The model knows a piston, a rod of two masses, a crank, a beam and a table of pressures: accelerations by the rod's fixed length, forces by
//! the equations of motion of each body, reactions by the stiffness method.

use std::f64::consts::{PI, TAU};

use crankstar::engine::Engine;
use crankstar::journal::{CycleBearing, CycleLoads, cycle_loads};
use crankstar::loads::Missing;
use crankstar::report::Question;
use crankstar::torque::torque;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use crate::support::dice::Dice;
use crate::support::gas_table::{self, AMBIENT, POINTS, pressure};
use crate::support::program::{call, scratch};
use crate::support::stiffness;
use crate::support::written::{engine as layout, float};

fn loads_of(engine: &Engine) -> CycleLoads {
    cycle_loads(engine).unwrap_or_else(|error| panic!("{error}"))
}

/// One cylinder: lengths in metres, angles in degrees, masses in kilograms.
struct Body {
    radius: f64,
    length: f64,
    offset: f64,
    piston: f64,
    big_end: f64,
    throw: f64,
    bank: f64,
    fires: f64,
    table: usize,
    position: BigRational,
}

/// What its bodies feel, seen from the engine.
struct Felt {
    /// The crankpin, of the rod.
    pin: Complex<f64>,
    /// Where it is.
    crank: Complex<f64>,
    /// The rod: how much it is pressed.
    rod: f64,
    /// The frame, of gas and piston: on the head, on the wall.
    head: Complex<f64>,
    wall: Complex<f64>,
    /// Where the piston is.
    piston: Complex<f64>,
    /// The side force of the wall on the piston, a quarter turn ahead of the axis.
    side: f64,
    /// Mass times acceleration of what moves, its sign changed: the shaking force.
    shaken: Complex<f64>,
    /// That of the piston alone, outward.
    inertia: f64,
}

const BORE: f64 = 0.08;

impl Body {
    fn felt(&self, theta: f64, omega: f64, tables: &[Vec<f64>]) -> Felt {
        let axis = Complex::cis(self.bank.to_radians());
        // In the frame of the axis: the pin at radius e^{iψ}, the piston at s + i e.
        let psi = theta + (self.throw - self.bank).to_radians();
        let pin = Complex::from_polar(self.radius, psi);
        let across = self.offset - pin.im;
        let along = (self.length * self.length - across * across).sqrt();
        // |P − C|² = l², differentiated once and twice; C' = i C ω, C'' = −C ω².
        let velocity = (across * pin.re) / along - pin.im;
        let relative = Complex::new(velocity + pin.im, -pin.re);
        let acceleration = (-(relative.norm_sqr() + across * pin.im) / along - pin.re) * omega * omega;
        let rod = Complex::new(along, across) / self.length;
        let gas = (pressure(&tables[self.table], theta.to_degrees() - self.fires) - AMBIENT) * PI / 4.0 * BORE * BORE;
        // The piston: m a = −gas + pressed · rod, along the axis; across it the wall holds it.
        let pressed = (self.piston * acceleration + gas) / rod.re;
        let side = -pressed * rod.im;
        // The big end: m a = −pressed · rod − (what the pin feels).
        let on_the_pin = -pressed * rod + self.big_end * omega * omega * pin;
        Felt {
            pin: on_the_pin * axis,
            crank: pin * axis,
            rod: pressed,
            head: gas * axis,
            wall: -side * Complex::i() * axis,
            piston: Complex::new(pin.re + along, self.offset) * axis,
            side,
            shaken: (-self.piston * acceleration + self.big_end * omega * omega * pin) * axis,
            inertia: -self.piston * acceleration,
        }
    }
}

struct Case {
    text: String,
    engine: Engine,
    bodies: Vec<Body>,
    /// Mass times radius, angle and position of what stands on the shaft.
    weights: Vec<(f64, f64, BigRational)>,
    tables: Vec<Vec<f64>>,
    omega: f64,
    cycle: f64,
}

fn list<T: std::fmt::Display>(values: impl Iterator<Item = T>) -> String {
    values.map(|value| value.to_string()).collect::<Vec<_>>().join(", ")
}

/// A random engine: axes that miss the crankshaft, cylinders that differ, pressures of their own, weights anywhere.
fn random(dice: &mut Dice) -> Case {
    let four_stroke = dice.below(3) > 0;
    let cycle = if four_stroke { 720.0 } else { 360.0 };
    let count = 1 + dice.below(6) as usize;
    let tables = vec![gas_table::random(dice, cycle, 60), gas_table::random(dice, cycle, 30)];
    let (other, speed) = (dice.below(count as u64) as usize, 500 + dice.below(5000));
    // Some engines are alike all over, so that stars of several cylinders appear.
    let alike = dice.below(3) == 0;
    let first: [u64; 5] = [60 + dice.below(80), dice.below(90), dice.below(21), dice.below(2000), dice.below(1000)];
    let mut bodies: Vec<Body> = Vec::new();
    let (mut strokes, mut rods, mut offsets, mut masses, mut ends) = (vec![], vec![], vec![], vec![], vec![]);
    let (mut cylinders, mut fires) = (String::new(), Vec::new());
    for index in 0..count {
        let own = [60 + dice.below(80), dice.below(90), dice.below(21), dice.below(2000), dice.below(1000)];
        let [stroke, more, offset, piston, big_end] = if alike { first } else { own };
        let (rod, offset) = (stroke + more, offset as i64 - 10);
        let (throw, bank) = (dice.below(24) as i64 * 15, dice.below(360) as i64 - 180);
        let position = BigRational::new((index as i64).into(), 10.into());
        cylinders += &format!("[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{position}'\n");
        fires.push((bank - throw).rem_euclid(360) + 360 * dice.below(2) as i64 * i64::from(four_stroke));
        strokes.push(format!("'{stroke} mm'"));
        rods.push(format!("'{rod} mm'"));
        offsets.push(format!("'{offset} mm'"));
        masses.push(format!("'{piston} g'"));
        ends.push(format!("'{big_end} g'"));
        bodies.push(Body {
            radius: stroke as f64 / 2e3,
            length: rod as f64 / 1e3,
            offset: offset as f64 / 1e3,
            piston: piston as f64 / 1e3,
            big_end: big_end as f64 / 1e3,
            throw: throw as f64,
            bank: bank as f64,
            fires: fires[index] as f64,
            table: usize::from(index == other),
            position,
        });
    }
    // Two bearings about all of them, and some between.
    let bearings = (0..=count).filter(|place| *place == 0 || *place == count || dice.below(2) == 0);
    let bearings: Vec<String> = bearings.map(|place| format!("'{}/100'", 10 * place as i64 - 5)).collect();
    let mut weights = Vec::new();
    let mut on_the_shaft = String::new();
    for _ in 0..dice.below(4) {
        let (grams, angle, at) = (dice.below(900) + 1, dice.below(72) * 5, dice.below(81) as i64 - 20);
        on_the_shaft += &format!(
            "[[counterweight]]\nmass = '{grams} g'\nradius = '50 mm'\nangle = {angle}\nposition = '{at}/100'\n"
        );
        weights.push((grams as f64 * 5e-5, (angle as f64).to_radians(), BigRational::new(at.into(), 100.into())));
    }
    let shaft = if weights.is_empty() { "" } else { "[crankshaft]\nlength = 3\n" };
    let text = format!(
        "cycle = '{}'\nspeed = {speed}\nfiring_angles = [{}]\nbearings = [{}]\n[mechanism]\nstroke = [{}]\nrod_length = [{}]\n\
         pin_offset = [{}]\nreciprocating_mass = [{}]\nrotating_mass = [{}]\n{shaft}[gas]\nbore = '80 mm'\ndead_centre = 'crank'\n\
         unit = 'bar'\npressure = [{}]\n[[gas.cylinder]]\ncylinders = [{}]\npressure = [{}]\n{cylinders}{on_the_shaft}",
        if four_stroke { "four-stroke" } else { "two-stroke" },
        list(fires.iter()),
        list(bearings.iter()),
        list(strokes.iter()),
        list(rods.iter()),
        list(offsets.iter()),
        list(masses.iter()),
        list(ends.iter()),
        gas_table::rows(&tables[0]),
        other + 1,
        gas_table::rows(&tables[1]),
    );
    let engine = layout(&text);
    Case { text, engine, bodies, weights, tables, omega: speed as f64 / 60.0 * TAU, cycle: cycle.to_radians() }
}

impl Case {
    fn felt(&self, theta: f64) -> Vec<Felt> {
        self.bodies.iter().map(|body| body.felt(theta, self.omega, &self.tables)).collect()
    }

    /// What the shaft's own weights pull with.
    fn weights(&self, theta: f64) -> impl Iterator<Item = (Complex<f64>, &BigRational)> {
        self.weights.iter().map(move |(mass_radius, angle, at)| {
            (Complex::from_polar(mass_radius * self.omega * self.omega, theta + angle), at)
        })
    }

    /// The part of a load at each place that each bearing carries, by the stiffness method.
    fn beam(&self) -> impl Fn(f64) -> Vec<Complex<f64>> + '_ {
        let mut bearings: Vec<BigRational> = self.engine.bearings().to_vec();
        bearings.sort();
        let own = self.bodies.iter().map(|body| &body.position);
        let mut places: Vec<&BigRational> = own.chain(self.weights.iter().map(|(_, _, at)| at)).collect();
        places.sort();
        places.dedup();
        let unit = stiffness::fixed(&BigRational::one());
        let parts: Vec<Vec<f64>> = stiffness::parts(&bearings, &places)
            .into_iter()
            .map(|row| row.into_iter().map(|part| float(&BigRational::new(part, unit.clone()))).collect())
            .collect();
        move |theta| {
            let pins = self.felt(theta).into_iter().zip(&self.bodies).map(|(felt, body)| (felt.pin, &body.position));
            let loads: Vec<(Complex<f64>, usize)> = pins
                .chain(self.weights(theta))
                .map(|(load, at)| (load, places.binary_search(&at).expect("a place")))
                .collect();
            parts.iter().map(|row| loads.iter().map(|(load, place)| load * row[*place]).sum()).collect()
        }
    }

    /// Angles through the cycle at which all is compared.
    fn angles(&self) -> impl Iterator<Item = f64> {
        (0..25).map(|step| f64::from(step) * self.cycle / 25.0 + 0.0123)
    }
}

/// The largest value of a function through a cycle: near each of the best of a fine grid that holds the kinks, by sections of three.
fn largest(cycle: f64, value: impl Fn(f64) -> f64) -> f64 {
    let steps = (cycle.to_degrees().round() * 2.0) as usize;
    let at = |step: usize| cycle * step as f64 / steps as f64;
    let values: Vec<f64> = (0..steps).map(|step| value(at(step))).collect();
    let top = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let range = top - values.iter().copied().fold(f64::INFINITY, f64::min);
    let near = (0..steps).filter(|&step| values[step] >= top - 0.01 * range);
    let refined = near.flat_map(|step| [at(step) - at(1), at(step)]).map(|from| {
        let (mut low, mut high) = (from, from + at(1));
        for _ in 0..60 {
            let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if value(left) < value(right) { low = left } else { high = right }
        }
        value((low + high) / 2.0)
    });
    refined.fold(top, f64::max)
}

#[track_caller]
fn assert_near(found: Complex<f64>, wanted: Complex<f64>, within: f64) {
    assert!((found - wanted).norm() <= within, "{found} is not {wanted}, but {:e} off", (found - wanted).norm());
}

const ENGINES: usize = 100;

#[test]
fn every_body_of_a_hundred_random_engines_feels_what_newton_says() {
    let mut dice = Dice::new(720);
    for _ in 0..ENGINES {
        let case = random(&mut dice);
        let loads = loads_of(&case.engine);
        let course = &loads.course;
        let mut order: Vec<usize> = (0..case.engine.bearings().len()).collect();
        order.sort_by_key(|&index| &case.engine.bearings()[index]);
        let [continuous, determinate] = loads.bearings.as_ref().expect("bearings");
        let beam = case.beam();
        let size = loads.cylinders.iter().map(|cylinder| cylinder.peaks.pin.value).fold(0.0, f64::max);
        let within = 1e-9 * size.max(1.0);
        let roll = torque(&case.engine).expect("a torque").course;
        for theta in case.angles() {
            let felt = case.felt(theta);
            let reactions = beam(theta);
            let real = |number: f64| Complex::new(number, 0.0);
            for (index, felt) in felt.iter().enumerate() {
                let forces = course.forces(index, theta);
                assert_near(course.pin(index, theta), felt.pin, within);
                assert_near(
                    course.pin_on_the_crank(index, theta),
                    felt.pin * felt.crank.conj() / felt.crank.norm(),
                    within,
                );
                assert_near(real(forces.rod()), real(felt.rod), within);
                assert_near(real(forces.side()), real(felt.side), within);
                assert_near(real(forces.inertia), real(felt.inertia), within);
                let along = (felt.piston - felt.crank) / (felt.piston - felt.crank).norm();
                let pull = course.pull_of(index, theta, course.forces(index, theta));
                assert_near(real(pull), real((felt.pin * along.conj()).re), within);
            }
            for (place, &index) in order.iter().enumerate() {
                assert_near(course.carried(&continuous.bearings[index].carried, theta), reactions[place], within);
            }
            // Bearings carry the pins and the weights of the shaft: force and moment along it, both ways of sharing.
            let pulled: Complex<f64> = case.weights(theta).map(|(load, _)| load).sum();
            let tilted: Complex<f64> = case.weights(theta).map(|(load, at)| load * float(at)).sum();
            let pins: Complex<f64> = felt.iter().map(|felt| felt.pin).sum();
            let tilting: Complex<f64> =
                felt.iter().zip(&case.bodies).map(|(f, body)| f.pin * float(&body.position)).sum();
            for bearings in [continuous, determinate] {
                let carried = |arm: &dyn Fn(f64) -> f64| -> Complex<f64> {
                    let of = bearings.bearings.iter();
                    of.map(|bearing| course.carried(&bearing.carried, theta) * arm(float(&bearing.position))).sum()
                };
                assert_near(carried(&|_| 1.0), pins + pulled, 4.0 * within);
                assert_near(carried(&|at| at), tilting + tilted, 4.0 * within);
            }
            // Head, walls and bearings together feel the shaking force of the masses alone, the gas adds none.
            let frame: Complex<f64> = felt
                .iter()
                .enumerate()
                .map(|(index, felt)| {
                    let (forces, axis) = (course.forces(index, theta), felt.head / felt.head.norm());
                    let axis = if forces.gas < 0.0 { -axis } else { axis };
                    forces.gas * axis - forces.side() * Complex::i() * axis
                })
                .sum();
            let carried: Complex<f64> =
                continuous.bearings.iter().map(|bearing| course.carried(&bearing.carried, theta)).sum();
            let shaken: Complex<f64> = felt.iter().map(|felt| felt.shaken).sum();
            assert_near(frame + carried, shaken + pulled, 8.0 * within);
            // Their moment about the shaft, where the bearings have no arm, is −T − Σ e F_in.
            let moment: f64 = felt.iter().map(|f| (f.piston.conj() * (f.head + f.wall)).im).sum();
            let torque: f64 = felt.iter().map(|f| (f.crank.conj() * f.pin).im).sum();
            let aside: f64 = felt.iter().zip(&case.bodies).map(|(f, body)| body.offset * f.inertia).sum();
            assert_near(real(moment), real(-torque - aside), within);
            assert_near(real(roll.roll(theta).expect("one crankshaft")), real(moment), within);
        }
    }
}

/// What a bearing carries of the masses.
fn course_of_inertia(loads: &CycleLoads, bearing: &CycleBearing, theta: f64) -> Complex<f64> {
    let [inertia, _] = loads.course.carried_parts(&bearing.carried, theta);
    inertia
}

#[test]
fn peaks_are_those_of_the_model_through_the_whole_cycle() {
    let mut dice = Dice::new(721);
    for _ in 0..ENGINES / 4 {
        let case = random(&mut dice);
        let loads = loads_of(&case.engine);
        let size = loads.cylinders.iter().map(|cylinder| cylinder.peaks.pin.value).fold(1.0, f64::max);
        let near =
            |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-9 * size, "{found} {wanted}\n{}", case.text);
        let [continuous, determinate] = loads.bearings.as_ref().expect("bearings");
        for (index, cylinder) in loads.cylinders.iter().enumerate() {
            let of = |value: fn(&Felt) -> f64, sign: f64| {
                sign * largest(case.cycle, |theta| {
                    sign * value(&case.bodies[index].felt(theta, case.omega, &case.tables))
                })
            };
            near(cylinder.peaks.pin.value, of(|felt| felt.pin.norm(), 1.0));
            near(cylinder.peaks.rod[0].value, of(|felt| felt.rod, 1.0));
            near(cylinder.peaks.rod[1].value, of(|felt| felt.rod, -1.0));
            near(cylinder.peaks.side[0].value, of(|felt| felt.side, 1.0));
            near(cylinder.peaks.side[1].value, of(|felt| felt.side, -1.0));
            let at = cylinder.peaks.pin.angle.to_radians();
            assert!((0.0..=case.cycle.to_degrees()).contains(&cylinder.peaks.pin.angle));
            near(loads.course.pin(index, at).norm(), cylinder.peaks.pin.value);
        }
        let beam = case.beam();
        let mut order: Vec<usize> = (0..continuous.bearings.len()).collect();
        order.sort_by_key(|&index| &continuous.bearings[index].position);
        for (place, &index) in order.iter().enumerate() {
            let bearing = &continuous.bearings[index];
            near(bearing.peak.value, largest(case.cycle, |theta| beam(theta)[place].norm()));
            let there = beam(bearing.peak.angle.to_radians())[place];
            near(there.norm(), bearing.peak.value);
            let of_masses = |theta: f64| course_of_inertia(&loads, bearing, theta).norm();
            near(bearing.inertia.value, largest(case.cycle, of_masses));
            assert!(continuous.bearings[continuous.worst[0]].peak.value >= bearing.peak.value * (1.0 - 1e-9));
            // Gas and masses along the direction of the peak make it up.
            let inertia = course_of_inertia(&loads, bearing, bearing.peak.angle.to_radians());
            let of_inertia = (inertia * bearing.peak.vector.conj()).re / bearing.peak.value.max(1e-300);
            near(of_inertia + bearing.peak.gas_along(), bearing.peak.value);
        }
        assert_eq!(determinate.bearings.len(), continuous.bearings.len());
    }
}

/// What a link hands on has no harmonics of its own: the straight lines of a table of pressures make kinks, which samples alone step over.
#[test]
fn orders_of_links_are_the_harmonics_of_their_loads() {
    let radial = "speed = 5710\ncycle = 'two-stroke'\neffects = ['gas']\nbearings = [0.1, -0.1]\n[radial]\ncylinders = 3\n\
        [mechanism]\nstroke = '47.94 mm'\nrod_length = '68.27 mm'\nreciprocating_mass = 0.4\nrotating_mass = [0.5, 0, 0]\n\
        [articulated]\nmaster = 1\nknuckle_radius = '14.59 mm'\nknuckle_mass = 0.1\n\
        [gas]\nbore = '82.1 mm'\ndead_centre = 'piston'\nunit = 'bar'\npressure = [[-170.3, 1.2], [-61.7, 1.9], [-9.11, 21.3], [3.77, 50.1], [31.3, 22.9], [97.7, 4.1]]\n";
    let loads = loads_of(&crankstar::parse("radial.toml", radial).expect("it reads"));
    let bearing = &loads.bearings.as_ref().expect("bearings")[0].bearings[0];
    let steps = 1 << 16;
    let samples: Vec<Complex<f64>> = (0..steps)
        .map(|step| loads.course.carried(&bearing.carried, TAU * f64::from(step) / f64::from(steps)))
        .collect();
    for order in &bearing.series.orders {
        let turning = |step: usize| Complex::cis(-order.order.value() * TAU * step as f64 / f64::from(steps));
        let direct = samples.iter().enumerate().map(|(step, load)| load * turning(step)).sum::<Complex<f64>>();
        let off = (direct / f64::from(steps) - order.total()[0]).norm();
        assert!(off < 3e-8 * bearing.peak.value, "order {}: off by {off} N", order.order);
    }
}

/// Kinks that stand close to a place of the grid: between two of them the load rises above all others, and both are lower than what is beyond.
#[test]
fn a_peak_between_kinks_that_are_lower_than_their_neighbours_is_found() {
    let text = "speed = 19478.6\ncycle = 'four-stroke'\neffects = ['gas']\nbearings = [0.1, -0.1]\n[inline]\nthrows = [346]\npositions = [0]\n\
        [mechanism]\ncrank_radius = 0.05309\nrod_length = 0.20449\nreciprocating_mass = 0.91476\nrotating_mass = 1.3878\n\
        [gas]\nbore = 0.1132\nunit = 'bar'\npressure = [[0, 40], [90, 1.2], [270, 1.2], [350.494, 1.703], [360.089, 1.652], [365.001, 1.388], \
        [450, 1.2], [630, 1.2], [700, 9.5]]\n";
    let loads = loads_of(&crankstar::parse("one.toml", text).expect("it reads"));
    let peak = loads.cylinders[0].peaks.pin;
    let size = |place: u32| loads.course.pin(0, (f64::from(place) / 100.0).to_radians()).norm();
    let highest = (0..72_000).map(size).fold(0.0, f64::max);
    assert!(peak.value >= highest && peak.value <= highest * (1.0 + 1e-6), "{} of {highest}", peak.value);
    assert!((peak.angle - 374.27).abs() < 0.1, "{}", peak.angle);
}

#[test]
fn orders_are_the_harmonics_of_the_model_and_the_torque_does_the_work_of_the_gas() {
    let mut dice = Dice::new(722);
    for _ in 0..ENGINES / 4 {
        let case = random(&mut dice);
        let loads = loads_of(&case.engine);
        let [continuous, _] = loads.bearings.as_ref().expect("bearings");
        let beam = case.beam();
        let mut places: Vec<usize> = (0..continuous.bearings.len()).collect();
        places.sort_by_key(|&index| &continuous.bearings[index].position);
        let revolutions = (case.cycle / TAU).round();
        let (degrees, last) = (case.cycle.to_degrees().round() as usize, 7_usize);
        let zero = Complex::new(0.0, 0.0);
        let mut sums = vec![vec![[zero; 2]; last]; places.len()];
        let mut pins = vec![vec![[zero; 2]; last]; case.bodies.len()];
        let mut work = 0.0;
        for degree in 0..degrees {
            for (point, weight) in POINTS {
                let theta = (degree as f64 + point).to_radians();
                let turning: Vec<_> = (0..last).map(|n| Complex::cis(theta * n as f64 / revolutions)).collect();
                let add = |sums: &mut Vec<[Complex<f64>; 2]>, load: Complex<f64>| {
                    for (sum, turning) in sums.iter_mut().zip(&turning) {
                        sum[0] += load * turning.conj() * weight / degrees as f64;
                        sum[1] += load * turning * weight / degrees as f64;
                    }
                };
                beam(theta).into_iter().zip(&mut sums).for_each(|(load, sums)| add(sums, load));
                for ((index, _), sums) in case.bodies.iter().enumerate().zip(&mut pins) {
                    let load = loads.course.pin(index, theta);
                    add(sums, load);
                    // The torque of the pin loads the program finds, on the crank of the model.
                    let crank = case.bodies[index].felt(theta, case.omega, &case.tables).crank;
                    work += (crank.conj() * load).im * weight * 1_f64.to_radians();
                }
            }
        }
        let size = loads.cylinders.iter().map(|cylinder| cylinder.peaks.pin.value).fold(1.0, f64::max);
        let series = places.iter().map(|&index| &continuous.bearings[index].series).zip(&sums);
        for (series, sums) in series.chain(loads.cylinders.iter().map(|cylinder| &cylinder.pin).zip(&pins)) {
            assert_near(series.mean.total(), sums[0][0], 1e-9 * size);
            for (index, sums) in sums.iter().enumerate().skip(1) {
                let order = &series.orders[index - 1];
                let [direct, reverse] = order.total();
                assert_near(direct, sums[0], 1e-9 * size);
                assert_near(reverse, sums[1], 1e-9 * size);
                assert_eq!(f64::from(order.order.halves()) / 2.0, index as f64 / revolutions);
                assert!(!order.vanishes() || order.largest() == 0.0);
            }
        }
        let torque = torque(&case.engine).expect("a torque");
        let indicated: f64 = torque.classes.iter().map(|class| class.gas.work() * class.cylinders.len() as f64).sum();
        assert!((work - indicated).abs() < 1e-9 * size, "{work} {indicated}\n{}", case.text);
    }
}

/// A four-stroke in-line four with five bearings, at a speed.
pub fn four() -> String {
    let four = crate::gas::SPARK
        .replace("throws = [0]", "throws = [0, 180, 180, 0]\nspacing = '0.1 m'")
        .replace("'1'", "'1-3-4-2'");
    let four = four.replace("[mechanism]\n", "[mechanism]\nrotating_mass = '0.4 kg'\n");
    format!(
        "title = 'Four'\nspeed = 3000\neffects = ['gas']\nbearings = ['200 mm', '100 mm', 0, '-100 mm', '-200 mm']\n{four}"
    )
}

#[test]
fn a_load_order_vanishes_where_its_stars_do_whatever_the_pressure_is() {
    let loads = loads_of(&layout(&four()));
    let [bearings, _] = loads.bearings.as_ref().expect("bearings");
    let vanish = |index: usize| -> Vec<String> {
        let orders = bearings.bearings[index].series.orders.iter();
        orders.filter(|order| order.vanishes()).map(|order| order.order.to_string()).take(6).collect()
    };
    // The middle bearing carries pins 2 and 3 alike, and 1 and 4 alike, which fire a revolution apart: no half orders.
    assert_eq!(vanish(2), ["½", "1½", "2½", "3½", "4½", "5½"]);
    assert!(vanish(0).is_empty() && vanish(1).is_empty());
    // Cylinders in line: what turns with the crank and against it are as long as each other.
    let half = &bearings.bearings[0].series.orders[0];
    assert!((half.gas[0].norm() - half.gas[1].norm()).abs() > 1e-6 * half.largest(), "the side force tells them apart");
    assert!(half.inertia_vanishes && half.inertia.iter().all(|one| one.norm() == 0.0));
}

#[test]
fn a_single_in_two_bearings_bears_the_gas_at_its_dead_centre() {
    let text = crate::gas::SPARK.replace("throws = [0]", "throws = [0]\nspacing = '0.1 m'");
    let text = format!("speed = 0\nbearings = ['0.05 m', '-0.05 m']\n{text}");
    let loads = loads_of(&layout(&text));
    let cylinder = &loads.cylinders[0];
    let gas = loads.course.forces(0, 0.0).gas;
    // At rest, at the dead centre, the rod stands upright: half of the gas force on each bearing, towards the crank.
    let [continuous, determinate] = loads.bearings.as_ref().expect("bearings");
    for bearings in [continuous, determinate] {
        for bearing in &bearings.bearings {
            assert_near(loads.course.carried(&bearing.carried, 0.0), Complex::new(-gas / 2.0, 0.0), 1e-9 * gas);
            assert_eq!(bearing.inertia.value, 0.0);
            assert!((bearing.peak.gas_along() - bearing.peak.value).abs() < 1e-12 * gas);
        }
    }
    assert_near(loads.course.pin(0, 0.0), Complex::new(-gas, 0.0), 1e-9 * gas);
    assert!(cylinder.peaks.rod[0].value >= gas && cylinder.peaks.pin.gas_along() > 0.0);
}

#[test]
fn what_a_layout_lacks_for_its_complete_loads_is_told() {
    let lacks = |text: &str| cycle_loads(&layout(text)).expect_err("it lacks something");
    assert_eq!(lacks(&four().replace("speed = 3000\n", "")), Missing::MassesOrSpeed);
    let told = lacks(&four().replace("reciprocating_mass = '0.5 kg'\n", "").replace("rotating_mass = '0.4 kg'\n", ""));
    assert!(told == Missing::MassesOrSpeed && told.to_string().contains("reciprocating_mass"));
    let (before, _) = crate::gas::SPARK.split_once("[gas]").expect("gas");
    assert!(lacks(before).to_string().contains("add [gas]"));
    let no_bearings = four().replace("bearings = ['200 mm', '100 mm', 0, '-100 mm', '-200 mm']\n", "");
    let loads = loads_of(&layout(&no_bearings));
    assert!(loads.bearings.is_none() && loads.cylinders.len() == 4);
}

#[test]
fn the_command_shows_the_gas_only_where_it_is_asked_for() {
    let folder = scratch("journal-page");
    let layout = folder.join("four.toml");
    let run = |text: &str, more: &[&str]| {
        std::fs::write(&layout, text).expect("a file");
        let arguments: Vec<&str> = ["bearings", layout.to_str().expect("a path")].iter().chain(more).copied().collect();
        let output = call(&arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("a text")
    };
    let with = four();
    let without = with.replace("effects = ['gas']\n", "");
    let text = run(&with, &[]);
    for words in
        ["Largest load: ", "Without gas the largest load is", "Rods. The rod of cylinder 1 is in compression up to"]
    {
        assert!(text.contains(words), "{words:?} in {text}");
    }
    let masses = run(&without, &[]);
    assert!(!masses.contains(" gas") && masses.contains("Largest force: bearing"), "{masses}");
    let document: serde_json::Value = serde_json::from_str(&run(&with, &["--json"])).expect("a document");
    let loads = loads_of(&self::layout(&with));
    let [bearings, _] = loads.bearings.as_ref().expect("bearings");
    let told = &document["gas_bearings"][2];
    assert_eq!((&told["method"], &told["bearing"]), (&"continuous".into(), &3.into()));
    assert_eq!(told["force_zero_to_peak_N"].as_f64(), Some(bearings.bearings[2].peak.value));
    let orders = document["gas_orders"].as_array().expect("orders");
    let first = orders.iter().find(|order| order["bearing"] == 3).expect("an order");
    assert_eq!(first["force_vanishes"], true);
    let plain: serde_json::Value = serde_json::from_str(&run(&without, &["--json"])).expect("a document");
    assert!(plain.get("gas_bearings").is_none() && plain["bearings"] == document["bearings"]);
    // A layout that lacks something keeps the loads of its masses, and is told.
    let slow = run(&with.replace("speed = 3000\n", ""), &[]);
    assert!(
        slow.contains("Gas loads were asked for, but are missing") && slow.contains("Largest force: bearing"),
        "{slow}"
    );
    let page = folder.join("page");
    for format in ["markdown", "latex", "html", "typst", "text"] {
        run(&with, &["--format", format, "--output", page.to_str().expect("a path")]);
    }
    let markdown = std::fs::read_to_string(page.join("bearings.md")).expect("the page");
    for picture in ["bearing-3-cycle.svg", "bearing-3-cycle-polar.svg", "pin-1-engine.svg", "pin-1-crank.svg"] {
        assert!(markdown.contains(picture) && page.join(picture).is_file(), "{picture}");
    }
    // What is said of the masses alone is not said of all.
    assert!(
        !markdown.contains("Gas force and weight are neglected")
            && markdown.contains("The loads are those of gas and masses")
    );
}

/// A boxer four whose opposite pins cancel in the middle, all of them or those of the masses alone.
#[test]
fn a_bearing_whose_loads_cancel_feels_nothing() {
    let boxer = |angles: &str| {
        format!(
            "cycle = 'four-stroke'\nfiring_angles = {angles}\nspeed = 5000\nbearings = ['130 mm', '52 mm', 0, '-52 mm', '-130 mm']\n\
             effects = ['gas']\n[boxer]\nthrows = [0, 0]\nstagger = '52 mm'\n[mechanism]\nstroke = '79 mm'\nrod_length = '130 mm'\n\
             pin_offset = '1 mm'\nreciprocating_mass = '0.55 kg'\nrotating_mass = '0.4 kg'\n[gas]\nbore = '99 mm'\n\
             dead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 10\nmean_pressure = '9 bar'\n"
        )
    };
    let middle = |angles: &str| {
        let loads = loads_of(&layout(&boxer(angles)));
        let both = loads.bearings.as_ref().expect("bearings");
        both.iter()
            .for_each(|all| assert!(all.bearings[1].peak.value > 100.0 && all.bearings[1].inertia.value > 100.0));
        [0, 1].map(|method| {
            let bearing = &both[method].bearings[2];
            let still = (0..72).all(|step| loads.course.carried(&bearing.carried, f64::from(step) / 9.0).norm() == 0.0);
            [bearing.peak.value == 0.0, bearing.inertia.value == 0.0, still]
        })
    };
    assert_eq!(middle("[0, 360, 360, 0]"), [[true; 3]; 2]);
    assert_eq!(middle("[0, 360, 0, 0]"), [[false, true, false]; 2]);
    let answer = crate::support::pages::text(
        &crankstar::report::BearingsStudy::new(&layout(&boxer("[0, 360, 360, 0]")), &[1, 2]).expect("loads").answer(),
        crate::support::pages::DOLLARS,
    );
    assert!(answer.contains("| 3 | 0 | **0** | – | **0** | **0** | **0** |"), "{answer}");
}
