//! Are the values at a crank angle those of the theory, of a point mass on a rod, and of the questions beside it?

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::journal::{Instants, cycle_loads};
use crankstar::loads::Missing;
use crankstar::report::{self, AngleStudy, AnglesAsked, NoAngles, Question};
use crankstar::torque::torque;

use crate::gas::SPARK;
use crate::support::dice::Dice;
use crate::support::program::{call, scratch};
use crate::support::written::assert_near;

const V8_GAS: &str = include_str!("../../reports/examples/v8-gas/layout.toml");

fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn asked(at: &[f64]) -> AnglesAsked {
    AnglesAsked { at: at.to_vec(), ..AnglesAsked::default() }
}

/// The steam engine of the theory, section 4: over the pressure of the crankcase 30 kPa above its piston and 1.5 kPa below, and a rod of 50 mm.
pub fn steam_engine() -> String {
    "cycle = 'two-stroke'\nspeed = 200\n[inline]\nthrows = [0]\n[mechanism]\ncrank_radius = '225 mm'\nrod_length = '1200 mm'\n\
     reciprocating_mass = '225 kg'\n[gas]\nbore = '300 mm'\nreading = 'gauge'\nunit = 'kPa'\npressure = [[0, 30], [360, 30]]\n\
     below_pressure = [[0, 1.5], [360, 1.5]]\npiston_rod = '50 mm'\n"
        .to_owned()
}

#[test]
fn the_steam_engine_of_the_theory_has_its_values_at_125_degrees() {
    let wanted = AnglesAsked { gravity: Some(9.81), ..asked(&[125.0]) };
    let study = AngleStudy::new(&engine(&steam_engine()), &wanted).expect("values");
    let piston = &study.instants[0].pistons[0];
    let known = |value: Option<f64>| value.expect("a value");
    let [v, a] = piston.textbook.expect("a centric crank");
    let crank = piston.pin_on_the_crank.expect("a load");
    for (found, value) in [
        (known(piston.velocity), 3.440034552),
        (v, 3.445019584),
        (known(piston.acceleration), -62.86612711),
        (a, -62.93898179),
        (known(piston.gas), 2017.491532),
        (known(piston.effort()), 18369.62013),
        (known(piston.rod()), 18590.20206),
        (known(piston.side()), 2855.287879),
        (crank.im, 13409.78604),
        (-crank.re, -12875.29616),
        (known(piston.torque()), 3017.201859),
    ] {
        assert_near(found, value, 1e-9 * value.abs());
    }
}

/// The force on a crankpin by Newton's law alone: the piston's place by Pythagoras, its acceleration by differences.
#[test]
fn a_point_mass_on_a_rod_gives_the_same_forces_for_random_engines() {
    let mut dice = Dice::new(30);
    for _ in 0..60 {
        let (r, l, e) = (30 + dice.below(40), 120 + dice.below(100), dice.below(20) as i64 - 10);
        let (mass, speed, bank) = (1 + dice.below(30), 500 + dice.below(5000), dice.below(360));
        let text = format!(
            "speed = {speed}\n[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = 0\n[mechanism]\ncrank_radius = '{r} mm'\nrod_length = '{l} mm'\n\
             pin_offset = '{e} mm'\nreciprocating_mass = '{mass} kg'\n",
            throw = dice.below(360),
        );
        let engine = engine(&text);
        let (r, l, e, mass) = (r as f64 / 1e3, l as f64 / 1e3, e as f64 / 1e3, mass as f64);
        let omega = speed as f64 / 60.0 * std::f64::consts::TAU;
        let theta = dice.below(36_000) as f64 / 100.0;
        let study = AngleStudy::new(&engine, &asked(&[theta])).expect("values");
        let piston = &study.instants[0].pistons[0];
        let psi = piston.psi.to_radians();
        let place = |psi: f64| r * psi.cos() + (l * l - (r * psi.sin() - e) * (r * psi.sin() - e)).sqrt();
        let step = 1e-4;
        let acceleration = (place(psi + step) - 2.0 * place(psi) + place(psi - step)) / (step * step) * omega * omega;
        let size = mass * r * omega * omega;
        // The rod carries force along itself alone, and the wall what is left across the axis.
        let (along, across) = (place(psi) - r * psi.cos(), r * psi.sin() - e);
        let rod = mass * acceleration * l / along;
        assert_near(piston.rod().expect("masses"), rod, 1e-6 * size);
        assert_near(piston.side().expect("masses"), rod * across / l, 1e-6 * size);
        let slope = (place(psi + step) - place(psi - step)) / (2.0 * step);
        assert_near(piston.torque().expect("masses"), -mass * acceleration * slope, 2e-6 * size * r);
        let way =
            (0..=36_000).map(|at| place(f64::from(at).to_radians() / 100.0)).fold(f64::MIN, f64::max) - place(psi);
        assert_near(piston.way, way, 1e-8);
    }
}

#[test]
fn torque_pins_and_bearings_are_those_of_the_questions_beside_it() {
    let engine = engine(V8_GAS);
    let (torque, loads) = (torque(&engine).expect("a torque"), cycle_loads(&engine).expect("loads"));
    let study = AngleStudy::new(&engine, &AnglesAsked { every: Some(7.0), ..AnglesAsked::default() }).expect("values");
    assert_eq!(study.instants.len(), 103);
    let bearings = loads.bearings.as_ref().expect("bearings");
    for instant in &study.instants {
        let theta = instant.theta.to_radians();
        let sum = instant.sum(|piston| piston.torque()).expect("a torque");
        assert_near(sum, torque.course.total(theta), 1e-9 * torque.highest.value);
        for (index, piston) in instant.pistons.iter().enumerate() {
            let pin = loads.course.pin(index, theta);
            assert!((piston.pin.expect("a load") - pin).norm() < 1e-9 * loads.cylinders[index].peaks.pin.value);
        }
        for (force, bearing) in instant.bearings.iter().zip(&bearings[0].bearings) {
            let known = loads.course.carried(&bearing.carried, theta);
            assert!((force - known).norm() < 1e-9 * bearing.peak.value);
        }
    }
}

/// Gas and masses of rods on a master rod, and of several crankshafts: their loads obey Newton's law (`bearing_bodies.rs`).
const BY_RODS: [[&str; 2]; 4] = [
    [
        "firing_order = '1-3-5-7-2-4-6'\n[radial]\ncylinders = 7\n[articulated]\nmaster = 1\nknuckle_ratio = 0.22\nknuckle_mass = 0.2\n",
        "[0.6, 0, 0, 0, 0, 0, 0]",
    ],
    [
        "firing_order = '1-3-5-2-4'\n[radial]\ncylinders = 5\n[articulated]\nmaster = 2\nknuckle_ratio = 0.2\nknuckle_correction = 3\n",
        "0",
    ],
    [
        "firing_angles = [0, 180, 540, 360]\n[u]\nthrows = [0, 180]\nsense = 'against'\nphase = 180\ndistance = 6\nspacing = 0.1\n",
        "0.6",
    ],
    [
        "firing_angles = [0, 540, 450, 270]\n[vee]\nbank_angle = 90\nthrows = [0, 180]\nspacing = 0.1\n[articulated]\nmaster = [1, 2]\nknuckle_ratio = 0.25\n",
        "0",
    ],
];

fn by_rods([form, rotating]: [&str; 2]) -> Engine {
    engine(&format!(
        "speed = 2000\neffects = ['gas']\ncycle = 'four-stroke'\nbearings = [0.3, 0.05, -0.31]\n{form}\
         [mechanism]\ncrank_radius = '50 mm'\nrod_ratio = 0.26\nreciprocating_mass = 0.8\nrotating_mass = {rotating}\n\
         [gas]\nbore = '90 mm'\ndead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nheat = '900 J'\n"
    ))
}

#[test]
fn links_master_rods_and_bearings_of_several_crankshafts_feel_at_an_angle_what_they_feel_through_the_cycle() {
    for form in BY_RODS {
        let engine = by_rods(form);
        let loads = cycle_loads(&engine).expect("loads");
        let course = &loads.course;
        let study =
            AngleStudy::new(&engine, &AnglesAsked { every: Some(11.0), ..AnglesAsked::default() }).expect("values");
        let bearings = &loads.bearings.as_ref().expect("bearings")[0].bearings;
        let largest = loads.cylinders.iter().map(|one| one.peaks.pin.value).fold(0.0, f64::max);
        for instant in &study.instants {
            let theta = instant.theta.to_radians();
            for (index, piston) in instant.pistons.iter().enumerate() {
                let side = course.side_of(index, theta, course.forces(index, theta));
                assert_near(piston.side().expect("a side force"), side, 1e-9 * largest);
                let whole = match course.knuckle_parts(index, theta) {
                    Some([inertia, gas]) => inertia + gas,
                    None => course.links_of(index).chain([index]).map(|rod| course.pin(rod, theta)).sum(),
                };
                let pin = piston.pin.expect("a load");
                assert!((pin - whole).norm() < 1e-9 * largest, "{form:?}{theta}: {pin} {whole}");
                assert_near(piston.pin_on_the_crank.expect("a load").norm(), pin.norm(), 1e-9 * largest);
                // The rod is pressed by what the piston hands on: effort and side force, seen along it.
                let slope = course.forces(index, theta).slope;
                let along = (course.forces(index, theta).effort() + side * slope) / slope.hypot(1.0);
                assert_near(piston.rod().expect("a thrust"), along, 1e-9 * largest);
            }
            assert_eq!(instant.bearings.len(), bearings.len());
            for (force, bearing) in instant.bearings.iter().zip(bearings) {
                assert!(
                    (force - course.carried(&bearing.carried, theta)).norm() < 1e-9 * bearing.peak.value,
                    "{form:?}"
                );
            }
        }
    }
}

#[test]
fn no_two_rows_of_a_table_have_the_same_keys() {
    // A vector of a sum and the stars of classes share the key of what they make up.
    let shared =
        ["classify.orders", "classify.sums", "classify.torque", "classify.roll", "firing.orders", "bearings.terms"];
    let mut count = 0;
    for engine in BY_RODS.map(by_rods).into_iter().chain([engine(V8_GAS)]) {
        for question in ["loads", "bearings", "firing", "torque", "angle", "moments", "remedy", "accuracy"] {
            let Some(Ok(answer)) = report::ask(question, &engine, &[]) else { continue };
            for table in answer.tables() {
                if shared.contains(&format!("{question}.{}", table.name()).as_str()) || table.keys() == 0 {
                    continue;
                }
                let key = |row: usize| -> Vec<String> {
                    let values = table.columns()[..table.keys()].iter().map(|column| column.values().get(row));
                    values.map(|value| value.map(|value| value.to_string()).unwrap_or_default()).collect()
                };
                let mut keys: Vec<_> = (0..table.rows()).map(key).collect();
                keys.sort();
                let twice = keys.windows(2).find(|pair| pair[0] == pair[1]);
                assert!(twice.is_none(), "{question}.{}: {twice:?}", table.name());
                count += keys.len();
            }
        }
    }
    assert!(count > 5000, "{count}");
}

#[test]
fn what_the_layout_leaves_out_is_left_out_and_what_is_senseless_is_refused() {
    let slow = engine("[inline]\nthrows = [0]\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n");
    let study = AngleStudy::new(&slow, &asked(&[90.0])).expect("ways");
    let piston = &study.instants[0].pistons[0];
    assert!(piston.velocity.is_none() && piston.effort().is_none() && piston.pin.is_none() && piston.way > 0.043);
    assert!(study.table("bearings").is_none());
    let gas_alone = engine(&SPARK.replace("reciprocating_mass = '0.5 kg'\n", ""));
    let law = Instants::new(&gas_alone, None).expect("gas");
    assert!(law.pistons(10.0)[0].gas.is_some_and(|gas| gas > 1e4) && law.pistons(10.0)[0].inertia.is_none());
    for wrong in [f64::NAN, f64::INFINITY, 1e7] {
        assert!(matches!(AngleStudy::new(&slow, &asked(&[wrong])), Err(NoAngles::Angle(_))));
    }
    for wrong in [0.0, -1.0, f64::NAN, 1e-4] {
        let every = AnglesAsked { every: Some(wrong), ..AnglesAsked::default() };
        assert!(matches!(AngleStudy::new(&slow, &every), Err(NoAngles::Step(_))), "{wrong}");
    }
    let down = AnglesAsked { gravity: Some(-9.81), ..AnglesAsked::default() };
    assert!(matches!(AngleStudy::new(&slow, &down), Err(NoAngles::Gravity(_))));
    let weighed = AnglesAsked { gravity: Some(9.81), ..asked(&[30.0]) };
    assert!(matches!(AngleStudy::new(&slow, &weighed), Err(NoAngles::NoMass)));
    let star = crate::support::written::of_catalogue("radial-9-master");
    assert!(
        matches!(AngleStudy::new(&star, &asked(&[0.0])), Err(NoAngles::Missing(Missing::Gas(_)))),
        "no crank radius"
    );
}

#[test]
fn a_dead_centre_has_no_velocity_at_all() {
    let study = AngleStudy::new(&engine(&steam_engine()), &asked(&[0.0, 180.0, 360.0, -180.0])).expect("values");
    for instant in &study.instants {
        let piston = &instant.pistons[0];
        assert_eq!((piston.velocity, piston.torque(), piston.side()), (Some(0.0), Some(0.0), Some(0.0)));
    }
}

#[test]
fn the_command_prints_the_angles_in_the_order_in_which_they_are_asked_for() {
    let layout = scratch("angle").join("steam.toml");
    std::fs::write(&layout, steam_engine()).expect("a file");
    let layout = layout.to_str().expect("UTF-8");
    let out = call(&[
        "angle",
        layout,
        "--at",
        "-30,125",
        "--every",
        "180",
        "--gravity",
        "9.81",
        "--format",
        "csv",
        "--table",
        "torque",
    ]);
    let csv = String::from_utf8_lossy(&out.stdout).into_owned();
    let angles: Vec<&str> = csv.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    assert_eq!(angles, ["-30", "125", "0", "180"], "{csv} {}", String::from_utf8_lossy(&out.stderr));
    assert!(csv.contains("3017.2018"), "{csv}");
}
