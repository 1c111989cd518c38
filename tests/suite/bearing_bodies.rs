//! Do crankpins, knuckle pins, master pistons and main bearings feel what Newton's law says of each body?
//!
//! Nothing of the program's mechanics is used: places are geometry, accelerations their differences, forces the solution of the linear
//! equations of every piston, link and master rod. A rod is two masses at its ends; the moment of its inertia beyond that is not looked at.

use std::f64::consts::TAU;

use crankstar::beam::Beam;
use crankstar::engine::{Cylinder, Engine, Link};
use crankstar::exact::Turn;
use crankstar::journal::{carried_by_bearings, course, cycle_loads};
use crankstar::loads::{HungRod, Method, Peak, bearing_loads, link_loads, pin_loads};
use crankstar::proof::Sense;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::dice::Dice;
use crate::support::written::engine as layout;

type C = Complex<f64>;

fn float(number: &BigRational) -> f64 {
    number.to_f64().expect("a number")
}

fn direction(turn: &Turn) -> C {
    C::cis(float(turn.turns()) * TAU)
}

fn cross(a: C, b: C) -> f64 {
    (a.conj() * b).im
}

/// The second derivative, by differences of the sixth order.
fn acceleration(place: impl Fn(f64) -> C, theta: f64) -> C {
    let h = 2e-3;
    let at = |steps: i32| place(theta + h * f64::from(steps));
    let sum =
        (at(3) + at(-3)) * (1.0 / 90.0) - (at(2) + at(-2)) * 0.15 + (at(1) + at(-1)) * 1.5 - at(0) * (49.0 / 18.0);
    sum / (h * h)
}

/// The solution of linear equations, rows of coefficients with their right side.
fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for column in 0..count {
        let pivot = (column..count).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
        rows.swap(column, pivot.expect("a row"));
        let head = rows[column].clone();
        assert!(head[column].abs() > 1e-12, "the equations are those of no mechanism");
        for (index, row) in rows.iter_mut().enumerate().filter(|(index, _)| *index != column) {
            let _ = index;
            let factor = row[column] / head[column];
            row.iter_mut().zip(&head).for_each(|(value, head)| *value -= factor * head);
        }
    }
    (0..count).map(|row| rows[row][count] / rows[row][row]).collect()
}

/// Where things are at a crank angle, in crank radii of the engine; its crank turns with `sense · speed`.
struct Places<'a> {
    engine: &'a Engine,
}

impl Places<'_> {
    fn turns(&self, cylinder: &Cylinder) -> f64 {
        let sign = if self.engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 };
        sign * f64::from(self.engine.speed_of(cylinder))
    }

    fn crankpin(&self, cylinder: &Cylinder, theta: f64) -> C {
        let radius = float(&cylinder.crank_radius);
        direction(&self.engine.pin_angle(cylinder)) * C::cis(self.turns(cylinder) * theta) * radius
    }

    /// The piston that a rod of this length holds, from its other end, on an axis that the centre is `aside` of.
    fn piston(axis: C, aside: f64, end: C, length: f64) -> C {
        let own = end * axis.conj();
        let off = own.im - aside;
        axis * C::new(own.re + (length * length - off * off).sqrt(), aside)
    }

    /// The piston of a rod of its own.
    fn own_piston(&self, cylinder: &Cylinder, theta: f64) -> C {
        let rod = cylinder.rod().expect("a rod");
        let length = float(&cylinder.crank_radius) / float(&rod.ratio);
        let side = if self.engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 };
        let aside = side * float(&rod.offset) * length;
        Self::piston(direction(&cylinder.bank), aside, self.crankpin(cylinder, theta), length)
    }

    fn knuckle(&self, master: &Cylinder, link: &Link, theta: f64) -> C {
        let (pin, piston) = (self.crankpin(master, theta), self.own_piston(master, theta));
        pin + (piston - pin) * direction(&link.knuckle_angle()) * float(&link.knuckle)
    }

    fn link_piston(&self, cylinder: &Cylinder, master: &Cylinder, theta: f64) -> C {
        let link = cylinder.link().expect("a link");
        let length = float(&cylinder.crank_radius) / float(&link.ratio);
        Self::piston(direction(&cylinder.bank), 0.0, self.knuckle(master, link, theta), length)
    }
}

/// The force of a rod on its piston and of the wall on it, in multiples of m r ω²: the rod pushes along itself, and `outward` acts on the
/// piston besides.
fn piston_forces([piston, end]: [C; 2], axis: C, needed: C) -> (C, f64) {
    let wall = axis * C::i();
    let along = end - piston;
    // R + N = what is needed; the rod has no moment: along × R = 0.
    let solved = solve(vec![
        vec![1.0, 0.0, wall.re, needed.re],
        vec![0.0, 1.0, wall.im, needed.im],
        vec![-along.im, along.re, 0.0, 0.0],
    ]);
    (C::new(solved[0], solved[1]), solved[2])
}

/// What each cylinder's rod, with all that hangs on it, loads its crankpin with, the loads of the knuckle pins by cylinder, and the side
/// forces on the pistons, all in multiples of m r ω²; the gas presses each piston towards the crank.
fn by_newton(engine: &Engine, theta: f64, gas: &[f64]) -> (Vec<C>, Vec<C>, Vec<f64>) {
    let places = Places { engine };
    let cylinders = engine.cylinders();
    let (mut pins, mut knuckles, mut sides) =
        (vec![C::default(); cylinders.len()], vec![C::default(); cylinders.len()], vec![0.0; cylinders.len()]);
    for (index, master) in cylinders.iter().enumerate().filter(|(_, one)| one.rod().is_some()) {
        let axis = direction(&master.bank);
        let (pin, piston) = (places.crankpin(master, theta), places.own_piston(master, theta));
        let mass = float(&master.reciprocating_mass);
        let needed = acceleration(|theta| places.own_piston(master, theta), theta) * mass + axis * gas[index];
        // What hangs on the rod: places and loads.
        let mut hung: Vec<(C, C)> = Vec::new();
        for (of, other) in cylinders.iter().enumerate() {
            let Some(link) = other.link() else { continue };
            if other.pin != master.pin {
                continue;
            }
            let knuckle = places.knuckle(master, link, theta);
            let place = |theta: f64| places.link_piston(other, master, theta);
            let pressed = direction(&other.bank) * gas[of];
            let needed = acceleration(place, theta) * float(&other.reciprocating_mass) + pressed;
            let (rod, side) = piston_forces([place(theta), knuckle], direction(&other.bank), needed);
            let held = acceleration(|theta| places.knuckle(master, link, theta), theta) * float(&other.knuckle_mass);
            knuckles[of] = -rod - held;
            sides[of] = side;
            hung.push((knuckle, knuckles[of]));
        }
        // The rod pushes its piston with S, the wall with N, the crankpin pushes the rod with P.
        let wall = axis * C::i();
        let load: C = hung.iter().map(|(_, load)| load).sum();
        let moment: f64 = hung.iter().map(|(at, load)| cross(*at, *load)).sum();
        let solved = solve(vec![
            vec![1.0, 0.0, wall.re, 0.0, 0.0, needed.re],
            vec![0.0, 1.0, wall.im, 0.0, 0.0, needed.im],
            vec![-1.0, 0.0, 0.0, 1.0, 0.0, -load.re],
            vec![0.0, -1.0, 0.0, 0.0, 1.0, -load.im],
            vec![piston.im, -piston.re, 0.0, -pin.im, pin.re, -moment],
        ]);
        sides[index] = solved[2];
        let rotating = acceleration(|theta| places.crankpin(master, theta), theta) * rotating(engine, master);
        pins[index] = -C::new(solved[3], solved[4]) - rotating;
    }
    (pins, knuckles, sides)
}

/// No gas.
fn still(engine: &Engine) -> Vec<f64> {
    vec![0.0; engine.cylinders().len()]
}

/// The rotating mass of a rod in multiples of m.
fn rotating(engine: &Engine, cylinder: &Cylinder) -> f64 {
    float(&cylinder.rotating_mass) / engine.dimensions().mass.as_ref().map_or(1.0, float)
}

fn close(found: C, expected: C, size: f64, what: &str) {
    assert!((found - expected).norm() < 2e-7 * size, "{what}: {found}, expected {expected}");
}

/// Pins and bearings of every crankshaft at some angles, by all orders up to this one.
fn agrees(engine: &Engine, text: &str, highest: u32) {
    let orders: Vec<u32> = (1..=highest).collect();
    let pins = pin_loads(engine, &orders).unwrap_or_else(|missing| panic!("{missing}\n{text}"));
    let links = HungRod::all(engine);
    let bearings =
        bearing_loads(engine, &orders, Method::Continuous).unwrap_or_else(|missing| panic!("{missing}\n{text}"));
    let beam = Beam::new(engine.bearings().to_vec()).expect("a beam");
    let at_bearings = engine.bearings().len();
    for theta in [0.3, 1.7, 2.9, 4.4, 5.8] {
        let (expected, knuckles, _) = by_newton(engine, theta, &still(engine));
        let size = expected.iter().map(|load| load.norm()).fold(1.0, f64::max);
        for (index, master) in engine.cylinders().iter().enumerate().filter(|(_, one)| one.rod().is_some()) {
            // What all that hangs on a rod hands on, each by its own cylinder.
            let own =
                |of: &usize| *of == index || links.iter().any(|link| (link.cylinder, link.master) == (*of, index));
            let found: C = (0..pins.pins.len()).filter(own).map(|of| pins.pins[of].waveform.at(theta)).sum();
            close(found, expected[index], size, &format!("crankpin of {} at {theta}\n{text}", master.name));
        }
        for link in &links {
            let mass = float(&engine.cylinders()[link.cylinder].reciprocating_mass);
            let load = link.on_the_knuckle(theta, -mass * link.acceleration(theta), 1.0);
            close(load, knuckles[link.cylinder], size, &format!("knuckle at {theta}\n{text}"));
        }
        for (place, bearing) in bearings.bearings.iter().enumerate() {
            let part = |at: &BigRational| float(&beam.influence(at)[place % at_bearings]);
            let cylinders = engine.cylinders().iter().zip(&expected).filter(|(one, _)| one.crank == bearing.crank);
            let of_pins: C = cylinders.map(|(one, load)| load * part(&one.position)).sum();
            let weights = engine.crankshaft().counterweights.iter().filter(|weight| weight.crank == bearing.crank);
            let unit = engine.dimensions().mass.as_ref().map_or(1.0, float)
                * engine.dimensions().crank_radius.as_ref().map_or(1.0, float);
            let turns = match engine.geared_cranks().get(bearing.crank) {
                Some(crank) if crank.sense == Sense::Reverse => -f64::from(crank.speed),
                Some(crank) => f64::from(crank.speed),
                None => 1.0,
            };
            let of_weights: C = weights
                .map(|weight| {
                    let size = float(&weight.mass_radius()) / unit * turns * turns;
                    direction(&weight.angle) * C::cis(turns * theta) * size * part(&weight.position)
                })
                .sum();
            close(
                bearing.waveform.at(theta),
                of_pins + of_weights,
                size,
                &format!("bearing {} at {theta}\n{text}", bearing.name),
            );
        }
    }
}

/// What is told largest is what Newton's law gives there, and more than it gives nearby.
fn largest_agree(engine: &Engine, text: &str) {
    let Some(links) = link_loads(engine) else { panic!("links in\n{text}") };
    type Value<'a> = &'a dyn Fn(f64) -> f64;
    let is_largest = |peak: Peak, value: Value<'_>| {
        let theta = peak.angle.expect("an angle").to_radians();
        assert!((value(theta) - peak.value).abs() < 1e-6 * peak.value.max(1.0), "{peak:?}, {}\n{text}", value(theta));
        assert!(
            (1..24).all(|step| value(theta + 0.26 * f64::from(step)) <= peak.value * (1.0 + 1e-6)),
            "{peak:?}\n{text}"
        );
    };
    for master in &links.masters {
        is_largest(master.crankpin, &|theta| by_newton(engine, theta, &still(engine)).0[master.cylinder].norm());
        is_largest(master.side, &|theta| by_newton(engine, theta, &still(engine)).2[master.cylinder].abs());
    }
    let knuckle = &links.knuckles[0];
    is_largest(knuckle.peak, &|theta| by_newton(engine, theta, &still(engine)).1[knuckle.cylinder].norm());
}

#[test]
fn all_but_endless_rods_of_a_nine_leave_half_of_the_pistons_and_the_knuckle_masses_on_the_crankpin() {
    // Pistons move as cos ψ: nine of them turn with the crank as 9/2 m. Of knuckle masses μ at κ = a/l the sums over the links, with
    // Σ e^{iΔ} = −1, give 8 μ along the master's axis and μ (8 + 2 κ + 8 κ²) across it; μ = 1/10, κ = 1/5.
    let text = "bearings = [1, -1]\n[radial]\ncylinders = 9\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\nknuckle_mass = 0.1\n\
                [mechanism]\nrod_ratio = '1/100000000'\nreciprocating_mass = 1\n";
    let loads = bearing_loads(&layout(text), &[1, 2, 3], Method::Continuous).expect("loads");
    for bearing in &loads.bearings {
        assert!((bearing.waveform.at(0.0) - C::new(5.3 / 2.0, 0.0)).norm() < 1e-6);
        assert!((bearing.waveform.at(TAU / 4.0) - C::new(0.0, 5.372 / 2.0)).norm() < 1e-6);
    }
    let links = link_loads(&layout(text)).expect("links");
    assert!((links.masters[0].crankpin.value - 5.372).abs() < 1e-6);
    assert!(links.masters[0].own_side.value < 1e-6);
}

/// Pins, knuckle pins, side forces and bearings of gas and masses; the pressures are the program's.
fn agrees_with_gas(text: &str) {
    let engine = &layout(text);
    let course = course(engine).unwrap_or_else(|missing| panic!("{missing}\n{text}"));
    let carried = carried_by_bearings(engine).expect("bearings");
    let unit = crankstar::loads::scale(engine).expect("newtons").force();
    let beam = Beam::new(engine.bearings().to_vec()).expect("a beam");
    for theta in [0.2, 2.1, 4.0, 5.9, 8.3, 11.7] {
        let gas: Vec<f64> = (0..course.cylinders()).map(|index| course.forces(index, theta).gas / unit).collect();
        assert!(gas.iter().any(|force| *force != 0.0));
        let (pins, knuckles, sides) = by_newton(engine, theta, &gas);
        let size = pins.iter().chain(&knuckles).map(|load| load.norm()).fold(1.0, f64::max);
        for (index, cylinder) in engine.cylinders().iter().enumerate() {
            let what = format!("cylinder {} at {theta}\n{text}", cylinder.name);
            let side = course.side_of(index, theta, course.forces(index, theta));
            close(side.into(), (sides[index] * unit).into(), size * unit, &what);
            if let Some([inertia, gas]) = course.knuckle_parts(index, theta) {
                close(inertia + gas, knuckles[index] * unit, size * unit, &what);
                continue;
            }
            let all: C = course.links_of(index).chain([index]).map(|of| course.pin(of, theta)).sum();
            close(all, pins[index] * unit, size * unit, &what);
        }
        for (place, load) in carried.iter().enumerate() {
            let count = engine.bearings().len();
            let own = engine.cylinders().iter().zip(&pins).filter(|(one, _)| one.crank == place / count);
            let expected: C = own.map(|(one, load)| load * float(&beam.influence(&one.position)[place % count])).sum();
            close(
                course.carried(load, theta),
                expected * unit,
                size * unit,
                &format!("bearing {place} at {theta}\n{text}"),
            );
        }
    }
    let loads = cycle_loads(engine).expect("loads");
    assert_eq!(loads.knuckles.len(), HungRod::all(engine).len());
    // The series is that of the forces.
    let [continuous, _] = loads.bearings.as_ref().expect("bearings");
    let largest = continuous.bearings.iter().map(|bearing| bearing.peak.value).fold(0.0, f64::max);
    assert!(loads.missed(continuous) < 0.1 * largest, "{} of {largest}\n{text}", loads.missed(continuous));
}

#[test]
fn gas_and_masses_of_links_and_of_several_crankshafts_obey_newton() {
    let gas = "[gas]\nbore = '90 mm'\ndead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nheat = '900 J'\n";
    let head = "speed = 2000\neffects = ['gas']\ncycle = 'four-stroke'\nbearings = [0.3, 0.05, -0.31]\n";
    let mechanism = "[mechanism]\ncrank_radius = '50 mm'\nrod_ratio = 0.26\nreciprocating_mass = 0.8\n";
    for form in [
        "firing_order = '1-3-5-7-2-4-6'\n[radial]\ncylinders = 7\n[articulated]\nmaster = 1\nknuckle_ratio = 0.22\nknuckle_mass = 0.2\n",
        "firing_order = '1-3-5-2-4'\n[radial]\ncylinders = 5\n[articulated]\nmaster = 2\nknuckle_ratio = 0.2\nknuckle_correction = 3\n",
        "firing_angles = [0, 180, 540, 360]\n[u]\nthrows = [0, 180]\nsense = 'against'\nphase = 180\ndistance = 6\nspacing = 0.1\n",
    ] {
        agrees_with_gas(&format!("{head}{form}{mechanism}{gas}"));
    }
}

fn mechanism(dice: &mut Dice, offset: bool) -> String {
    let offset = if offset { "pin_offset = ['5 mm', '-7 mm']\n" } else { "" };
    format!(
        "[mechanism]\ncrank_radius = '50 mm'\nrod_ratio = 0.{}\nreciprocating_mass = 0.{}\n{offset}",
        20 + dice.below(12),
        4 + dice.below(5)
    )
}

#[test]
fn pins_and_bearings_of_several_crankshafts_obey_newton_at_forty_random_engines() {
    let mut dice = Dice::new(30);
    for round in 0..45 {
        let sense = if dice.below(2) == 0 { "with" } else { "against" };
        let lead = dice.below(30);
        let form = match round % 6 {
            0 => format!("[opposed_piston]\nthrows = [0, 120, 240]\nlead = {lead}\nsense = '{sense}'\nspacing = 0.2"),
            1 => format!(
                "[u]\nthrows = [0, 180]\nsense = '{sense}'\nphase = {}\ndistance = 6\nspacing = 0.1",
                dice.below(360)
            ),
            2 => format!("[h]\nthrows = [0, 180]\nsense = '{sense}'\ndistance = 5\nspacing = 0.1"),
            3 => format!("[square_four]\nin_phase = 'diagonals'\nsense = '{sense}'\ndistance = 5\nspacing = 0.1"),
            4 => format!(
                "[[crankshaft]]\nname = 'A'\nsense = 'with'\n[[crankshaft]]\nname = 'B'\nsense = '{sense}'\nspeed = {}\ndistance = 6\nangle = 90\n\
                 [[cylinder]]\ncrankshaft = 'A'\nthrow = {}\nbank = 10\nposition = 0.1\n\
                 [[cylinder]]\ncrankshaft = 'B'\nthrow = 40\nbank = {}\nposition = -0.1\n\
                 [[counterweight]]\nthrow = 2\nangle = 200\nmass = 0.3\nradius = '40 mm'\nposition = 0.05",
                1 + dice.below(3),
                dice.below(360),
                dice.below(360)
            ),
            _ => format!("[delta]\nrows = [0, {}]\ncircumradius = 6\nspacing = 0.3", dice.below(360)),
        };
        let text = format!(
            "speed = 2000\nbearings = [0.3, 0.0{}, -0.31]\n{form}\n{}rotating_mass = 0.{}\n",
            dice.below(9),
            mechanism(&mut dice, round % 6 == 4),
            dice.below(9)
        );
        agrees(&layout(&text), &text, if round % 6 == 4 { 60 } else { 24 });
    }
}

#[test]
fn pins_knuckles_and_bearings_of_articulated_rods_obey_newton_at_forty_random_engines() {
    let mut dice = Dice::new(31);
    for round in 0..45 {
        let (form, count) = match round % 3 {
            0 => ("[radial]\ncylinders = 7".to_owned(), 7),
            1 => (format!("[vee]\nbank_angle = {}\nthrows = [0, 120, 240]\nspacing = 0.1", 40 + dice.below(60)), 6),
            _ => (
                format!(
                    "[radial]\ncylinders = 5\nrows = 2\nrow_throw = {}\nrow_rotation = 36\nrow_spacing = 0.1",
                    150 + dice.below(60)
                ),
                10,
            ),
        };
        let masters = match round % 3 {
            0 => vec![1 + dice.below(7)],
            1 => vec![1, 2, 3],
            _ => vec![1, 6],
        };
        let masters_text = masters.iter().map(u64::to_string).collect::<Vec<_>>().join(", ");
        let rotating =
            (1..=count).map(|name| if masters.contains(&name) { "0.6" } else { "0" }).collect::<Vec<_>>().join(", ");
        let correction =
            if dice.below(2) == 0 { String::new() } else { format!("knuckle_correction = {}\n", dice.below(5)) };
        let text = format!(
            "speed = 2000\nbearings = [0.3, 0.0{}, -0.31]\n{form}\n[articulated]\nmaster = [{masters_text}]\nknuckle_ratio = 0.2{}\n{correction}knuckle_mass = 0.{}\n{}rotating_mass = [{rotating}]\n",
            dice.below(9),
            dice.below(5),
            dice.below(9),
            mechanism(&mut dice, false),
        );
        agrees(&layout(&text), &text, 20);
        if round < 12 {
            largest_agree(&layout(&text), &text);
        }
    }
}
