//! Do geared crankshafts twist as their discs do, each by itself, with a force between the teeth?
//!
//! The equations here are of the absolute angles of all discs, anticlockwise, with a torque between the teeth as one more unknown for each gear.

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::journal::Instants;
use crankstar::proof::Sense;
use crankstar::report::TorsionStudy;
use num_complex::Complex;

use crate::support::dice::Dice;

const GAS: &str = "[gas]\nbore = '100 mm'\nprocess = 'diesel'\ncompression_ratio = 15\nheat = '2000 J'\nintake_pressure = '1.3 bar'\n";

/// Rows of discs, one a crankshaft, and gears from the last of the first to the last of each other one.
struct Rows {
    inertias: Vec<f64>,
    shafts: Vec<([usize; 2], f64, f64)>,
    gears: Vec<([usize; 2], f64)>,
    text: String,
}

fn rows(dice: &mut Dice, senses: &[f64], throws: usize) -> Rows {
    let (mut inertias, mut shafts, mut gears) = (Vec::new(), Vec::new(), Vec::new());
    let mut pins = Vec::new();
    for (crank, sense) in senses.iter().enumerate() {
        // Behind the throws a wheel.
        let first = inertias.len();
        for disc in 0..=throws {
            inertias.push((20 + dice.below(200)) as f64 / 1000.0);
            if disc > 0 {
                let [stiffness, loss] = [(200 + dice.below(900)) as f64 * 1e3, (1 + dice.below(40)) as f64 / 1000.0];
                shafts.push(([first + disc - 1, first + disc], stiffness, loss));
            }
        }
        pins.extend((0..throws).map(|throw| (first + throw + 1).to_string()));
        if crank > 0 {
            gears.push(([throws, first + throws], *sense));
        }
    }
    let mut text = format!("[torsion]\ninertias = {inertias:?}\ncrankpins_at = [{}]\n", pins.join(", "));
    for ([from, to], stiffness, loss) in &shafts {
        text += &format!(
            "[[torsion.shaft]]\nbetween = [{}, {}]\nstiffness = {stiffness}\nloss_factor = {loss}\n",
            from + 1,
            to + 1
        );
    }
    for ([from, to], ratio) in &gears {
        text += &format!("[[torsion.gear]]\nbetween = [{}, {}]\nratio = {ratio}\n", from + 1, to + 1);
    }
    Rows { inertias, shafts, gears, text }
}

impl Rows {
    /// The absolute angles of the discs, then the torques between the teeth.
    fn twist(&self, omega: f64, torques: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let (discs, count) = (self.inertias.len(), self.inertias.len() + self.gears.len());
        let mut rows = vec![vec![Complex::new(0.0, 0.0); count + 1]; count];
        for (disc, inertia) in self.inertias.iter().enumerate() {
            rows[disc][disc] -= omega * omega * inertia;
            rows[disc][count] = torques[disc];
        }
        for ([from, to], stiffness, loss) in &self.shafts {
            let k = Complex::new(*stiffness, stiffness * loss);
            for (one, other) in [(*from, *to), (*to, *from)] {
                rows[one][one] += k;
                rows[one][other] -= k;
            }
        }
        for (gear, ([from, to], ratio)) in self.gears.iter().enumerate() {
            let at = discs + gear;
            // The teeth turn the second over the ratio less than they hold the first.
            (rows[*from][at], rows[*to][at]) = (Complex::from(*ratio), Complex::from(-1.0));
            (rows[at][*from], rows[at][*to]) = (Complex::from(*ratio), Complex::from(-1.0));
        }
        for column in 0..count {
            let largest = (column..count).max_by(|a, b| rows[*a][column].norm().total_cmp(&rows[*b][column].norm()));
            rows.swap(column, largest.expect("a row"));
            let pivot = rows[column].clone();
            for row in (0..count).filter(|row| *row != column) {
                let factor = rows[row][column] / pivot[column];
                rows[row].iter_mut().zip(&pivot).for_each(|(value, above)| *value -= factor * above);
            }
        }
        (0..count).map(|row| rows[row][count] / rows[row][row]).collect()
    }
}

fn read(text: &str) -> Engine {
    file::parse("geared.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Random engines on two crankshafts or three: rows side by side, opposed pistons, deltas.
fn any(dice: &mut Dice, case: usize) -> (Engine, Rows) {
    let against = dice.below(2) == 0;
    let sense = if against { "against" } else { "with" };
    let lead = dice.below(16);
    let (cycle, form, senses, throws): (_, _, Vec<f64>, usize) = match case % 3 {
        0 => (
            "cycle = 'two-stroke'\n",
            format!("[u]\nthrows = [0, 90, 200]\nsense = '{sense}'\nphase = {}\ndistance = 5\n", dice.below(90)),
            vec![1.0, if against { -1.0 } else { 1.0 }],
            3,
        ),
        1 => (
            "cycle = 'two-stroke'\n",
            format!("[opposed_piston]\nthrows = [0, 120]\nlead = {lead}\nsense = '{sense}'\ndistance = 12\n"),
            vec![1.0, if against { -1.0 } else { 1.0 }],
            2,
        ),
        // The corners in their order, of which the first turns against the reference.
        _ => ("cycle = 'two-stroke'\n", "[delta]\nrows = [0, 60]\ncircumradius = 7\n".into(), vec![1.0, -1.0, -1.0], 2),
    };
    let rows = rows(dice, &senses, throws);
    let text = format!(
        "{cycle}speed = {}\n[mechanism]\nstroke = '120 mm'\nrod_length = '220 mm'\nreciprocating_mass = '2 kg'\n{form}{GAS}{}",
        600 + dice.below(900),
        rows.text
    );
    (read(&text), rows)
}

/// The harmonic of each piston's torque at an order, in the sense in which its crank turns.
fn torques(engine: &Engine, order: f64) -> Vec<Complex<f64>> {
    let instants = Instants::new(engine, None).expect("instants");
    let steps = 7200;
    let mut sums = vec![Complex::new(0.0, 0.0); engine.cylinders().len()];
    for step in 0..steps {
        let theta = 360.0 * step as f64 / steps as f64;
        for (sum, piston) in sums.iter_mut().zip(instants.pistons(theta)) {
            *sum += piston.torque().expect("a torque") * Complex::cis(-order * theta.to_radians()) * 2.0 / steps as f64;
        }
    }
    sums
}

#[test]
fn geared_crankshafts_twist_as_their_discs_with_a_torque_between_the_teeth() {
    let mut dice = Dice::new(23);
    for case in 0..9 {
        let (engine, rows) = any(&mut dice, case);
        let study = TorsionStudy::new(&engine, &[]).expect("a study");
        // The views draw each crankshaft by itself.
        assert!((0..engine.geared_cranks().len()).all(|crank| engine.crankshaft_alone(crank).is_some()), "case {case}");
        let vibration = study.at_speed().expect("a vibration");
        let torsion = engine.torsion().expect("a shaft");
        let disc = |cylinder: usize| torsion.pins[engine.cylinders()[cylinder].pin];
        let sense =
            |cylinder: usize| if engine.sense_of(&engine.cylinders()[cylinder]) == Sense::Direct { 1.0 } else { -1.0 };
        // The page counts angles in the sense of the first crankpin.
        let first =
            sense((0..engine.cylinders().len()).find(|index| engine.cylinders()[*index].pin == 0).expect("a pin"));
        for order in vibration.orders.iter().filter(|order| order.order.is_whole() && order.order.value() <= 8.0) {
            let kappa = order.order.value();
            let mut on_discs = vec![Complex::new(0.0, 0.0); rows.inertias.len()];
            for (cylinder, torque) in torques(&engine, kappa).into_iter().enumerate() {
                on_discs[disc(cylinder)] += torque * sense(cylinder);
            }
            let omega = kappa * study.speed.expect("a speed") * TAU / 60.0;
            let found = rows.twist(omega, &on_discs);
            let largest = found[..rows.inertias.len()].iter().map(|twist| twist.norm()).fold(0.0, f64::max);
            for (own, right) in order.twists.iter().zip(&found) {
                assert!(
                    (own * first - right).norm() < 1e-4 * largest + 1e-12,
                    "case {case}, order {kappa}: {own} {right}"
                );
            }
            let teeth: Vec<f64> = found[rows.inertias.len()..].iter().map(|torque| torque.norm()).collect();
            let most = teeth.iter().copied().fold(0.0, f64::max).max(1e-3);
            for (own, right) in order.meshes.iter().zip(&teeth) {
                assert!((own.norm() - right).abs() < 1e-3 * most, "case {case}, order {kappa}: {own} {right}");
            }
        }
    }
}

#[test]
fn the_modes_of_geared_crankshafts_satisfy_the_equations_of_each_disc() {
    let mut dice = Dice::new(31);
    for case in 0..12 {
        let (engine, rows) = any(&mut dice, case);
        let study = TorsionStudy::new(&engine, &[]).expect("a study");
        assert_eq!(study.modes.len(), rows.inertias.len() - rows.gears.len() - 1);
        for speeds in &study.modes {
            let (mode, square) = (&speeds.mode, speeds.mode.omega * speeds.mode.omega);
            let mut left: Vec<f64> =
                rows.inertias.iter().zip(&mode.shape).map(|(inertia, shape)| -square * inertia * shape).collect();
            for ([from, to], stiffness, _) in &rows.shafts {
                let torque = stiffness * (mode.shape[*from] - mode.shape[*to]);
                left[*from] += torque;
                left[*to] -= torque;
            }
            let size = square * rows.inertias.iter().zip(&mode.shape).map(|(j, shape)| (j * shape).abs()).sum::<f64>();
            for ([from, to], ratio) in &rows.gears {
                assert!((mode.shape[*to] - ratio * mode.shape[*from]).abs() < 1e-9);
                left[*from] += ratio * left[*to];
                left[*to] = 0.0;
            }
            assert!(left.iter().all(|torque| torque.abs() < 1e-8 * size), "case {case}: {left:?} {size}");
            // Each vector has the deflection of its disc, in the sense of its crank.
            for (index, deflection) in speeds.deflections.iter().enumerate() {
                let disc = engine.torsion().expect("a shaft").pins[engine.cylinders()[index].pin];
                assert!((deflection.abs() - mode.shape[disc].abs()).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn harmonics_of_a_cylinder_with_two_pistons_are_shared_by_both() {
    let mut dice = Dice::new(3);
    let rows = rows(&mut dice, &[1.0, -1.0], 1);
    let harmonic = "[[torsion.harmonic]]\norder = 3\ntorque = '600 N m'\n";
    let text = |form: &str| format!("cycle = 'two-stroke'\nspeed = 900\n{form}{}{harmonic}", rows.text);
    let both = read(&text("[opposed_piston]\nthrows = [0]\nlead = 0\nsense = 'against'\n"));
    let study = TorsionStudy::new(&both, &[]).expect("a study");
    let vibration = study.at_speed().expect("a vibration");
    let mut on_discs = vec![Complex::new(0.0, 0.0); 4];
    (on_discs[0], on_discs[2]) = (Complex::from(300.0), Complex::from(-300.0));
    let found = rows.twist(3.0 * 900.0 * TAU / 60.0, &on_discs);
    let ratio = vibration.orders[0].twists[0] / found[0];
    for (own, right) in vibration.orders[0].twists.iter().zip(&found) {
        assert!((own - ratio * right).norm() < 1e-9 * right.norm(), "{own} {right}");
    }
    assert!((ratio.norm() - 1.0).abs() < 1e-9);
}

#[test]
fn a_pin_on_a_disc_that_turns_otherwise_than_its_crankshaft_is_refused() {
    let mut dice = Dice::new(5);
    let text = rows(&mut dice, &[1.0, 1.0], 2).text;
    let form = "cycle = 'two-stroke'\n[u]\nthrows = [0, 180]\nsense = 'against'\ndistance = 5\n";
    let why = file::parse("geared.toml", &format!("{form}{text}")).expect_err("a mistake").to_string();
    assert!(why.contains("crankpin 3 is on disc 4") && why.contains("sense"), "{why}");
    let shared = "[[crankshaft]]\nname = 'a'\nsense = 'with'\n[[crankshaft]]\nname = 'b'\nsense = 'against'\n\
        [[cylinder]]\ncrankshaft = 'a'\nthrow = 0\nbank = 0\nposition = 0\npin = 1\n\
        [[cylinder]]\ncrankshaft = 'b'\nthrow = 0\nbank = 0\nposition = 0\npin = 1\n[torsion]\ninertias = [1, 1]\nstiffnesses = [1000]\n";
    let why = file::parse("geared.toml", shared).expect_err("a mistake").to_string();
    assert!(why.contains("of two crankshafts"), "{why}");
}
