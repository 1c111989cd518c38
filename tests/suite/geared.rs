//! Do engines with several crankshafts balance as the theory's table says, and as Newton's law for each body?
//!
//! The model of the second half knows nothing of orders, of equivalent cranks or of arms: at one crank angle the rod's fixed length gives
//! the piston's place and acceleration, its equation of motion the force of the massless rod and of the wall, and the frame feels the
//! walls at the pistons, and at each shaft what its pins hand on.

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::file::parse;
use crankstar::loads::loads_at;
use crankstar::numbers::evaluate;
use crankstar::order::{Factor, Masses};
use crankstar::proof::{Quantity, check_document};
use crankstar::verdict::{self, OrderVerdict, TorqueVerdict};
use crankstar::{order, report};
use num_complex::Complex;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::written::{engine as layout, float};

fn judged(engine: &Engine) -> Vec<OrderVerdict> {
    let quantities = verdict::quantities(engine, true);
    verdict::classify(engine, &[1, 2, 4, 6], Masses::Reciprocating, &quantities).expect("orders")
}

/// Halves of the direct and the reverse vector; exactly 0 where that is proved.
fn halves(balance: &verdict::Balance) -> [f64; 2] {
    balance.verdicts().map(|one| if one.vanishes() { 0.0 } else { evaluate(&one.sum).norm() / 2.0 })
}

/// The amplitudes of a torque or a roll moment that are left.
fn left(torque: &Option<TorqueVerdict>) -> Vec<f64> {
    let parts = torque.iter().flat_map(|torque| &torque.parts).map(|part| &part.verdict);
    parts.filter(|one| !one.vanishes()).map(|one| evaluate(&one.sum).norm()).collect()
}

/// What is right of an engine at orders 1, 2, 4 and 6: halves of the force and of the moment, and what is left of the roll moment by its
/// arms and by its torques; none where the table says nothing.
struct Row {
    engine: &'static str,
    force: [[f64; 2]; 4],
    moment: Option<[[f64; 2]; 4]>,
    roll: [Vec<f64>; 4],
}

const NOTHING: [[f64; 2]; 4] = [[0.0; 2]; 4];

fn planar(peaks: [f64; 4]) -> [[f64; 2]; 4] {
    peaks.map(|peak| [peak / 2.0; 2])
}

/// `theory-mechanisms`, section 2, rows 1 to 20.
#[test]
fn engines_of_the_theory_leave_what_its_table_says() {
    let root = 3.0_f64.sqrt();
    let lead = |degrees: f64| planar([1.0, 2.0, 4.0, 6.0].map(|k| 2.0 * (k * degrees / 2.0).to_radians().sin()));
    let sine = |degrees: f64| degrees.to_radians().sin();
    // The torques of both pistons turn the frame the same way.
    let sums = |lead: f64| [1.0, 2.0, 4.0, 6.0].map(|k| vec![2.0 * (k * lead / 2.0).to_radians().cos()]);
    let six = planar([0.0, 0.0, 0.0, 12.0 * sine(33.0)]);
    let none = || [(); 4].map(|()| Vec::new());
    let each = |value: f64| [(); 4].map(|()| vec![value]);
    let even = |value: f64| [vec![], vec![value], vec![value], vec![value]];
    let rows = [
        Row {
            engine: "[u]\nthrows = [0]\nsense = 'against'\ndistance = 4",
            force: planar([2.0; 4]),
            moment: Some(NOTHING),
            roll: none(),
        },
        Row {
            engine: "[u]\nthrows = [0]\nsense = 'with'\ndistance = 4",
            force: planar([2.0; 4]),
            moment: Some(NOTHING),
            roll: each(2.0),
        },
        Row {
            engine: "[u]\nthrows = [0]\nsense = 'against'\ndistance = 4\nphase = 180",
            force: planar([0.0, 2.0, 2.0, 2.0]),
            moment: Some(NOTHING),
            // The arm of both together, and the torques, which both turn the same way at odd orders.
            roll: [vec![4.0, 2.0], vec![], vec![], vec![]],
        },
        Row {
            engine: "[square_four]\nin_phase = 'diagonals'\nsense = 'against'\ndistance = 4",
            force: planar([0.0, 4.0, 4.0, 4.0]),
            moment: Some(NOTHING),
            roll: none(),
        },
        Row {
            engine: "[square_four]\nin_phase = 'diagonals'\nsense = 'with'\ndistance = 4",
            force: planar([0.0, 4.0, 4.0, 4.0]),
            moment: Some(NOTHING),
            roll: even(4.0),
        },
        Row {
            engine: "[square_four]\nin_phase = 'sides'\nsense = 'with'\ndistance = 4",
            force: planar([0.0, 4.0, 4.0, 4.0]),
            moment: Some(planar([2.0, 0.0, 0.0, 0.0])),
            roll: even(4.0),
        },
        Row {
            engine: "[opposed_piston]\nthrows = [0]\nlead = 9",
            force: lead(9.0),
            moment: Some(NOTHING),
            roll: sums(9.0),
        },
        Row {
            engine: "[opposed_piston]\nthrows = [0]\nlead = 11",
            force: lead(11.0),
            moment: Some(NOTHING),
            roll: sums(11.0),
        },
        Row {
            engine: "[opposed_piston]\nthrows = [0]\nlead = 12",
            force: lead(12.0),
            moment: Some(NOTHING),
            roll: sums(12.0),
        },
        Row {
            engine: "[opposed_piston]\nthrows = [0]\nlead = 20",
            force: lead(20.0),
            moment: Some(NOTHING),
            roll: sums(20.0),
        },
        Row {
            engine: "[opposed_piston]\nthrows = [0, 120, 240, 60, 180, 300]\nlead = 11\nsense = 'against'",
            force: six,
            moment: Some(planar([6.0 * sine(5.5), 2.0 * root * sine(11.0), 2.0 * root * sine(22.0), 0.0])),
            roll: [vec![], vec![], vec![], vec![12.0 * sine(33.0)]],
        },
        Row {
            engine: "[h]\nthrows = [0]\nsense = 'against'\ndistance = 4",
            force: planar([4.0, 0.0, 0.0, 0.0]),
            moment: Some(NOTHING),
            roll: none(),
        },
        Row {
            engine: "[h]\nthrows = [0]\nsense = 'with'\ndistance = 4\nphase = 180",
            force: NOTHING,
            moment: Some(NOTHING),
            roll: [vec![8.0], vec![4.0], vec![4.0], vec![4.0]],
        },
        Row {
            engine: "[h]\nthrows = [0, 120, 240, 240, 120, 0]\nsense = 'with'\ndistance = 4",
            force: NOTHING,
            moment: Some(NOTHING),
            roll: [vec![], vec![], vec![], vec![24.0]],
        },
        Row {
            engine: "[delta]\nrows = [0, 120, 240]\ncircumradius = 1",
            force: [[0.0; 2], [0.0; 2], [0.0; 2], [9.0 * root / 2.0, 0.0]],
            moment: None,
            roll: [vec![], vec![], vec![], vec![12.0]],
        },
        Row {
            engine: "[delta]\nrows = [0, 240, 120, 60, 300, 180]\ncircumradius = 1",
            force: [[0.0; 2], [0.0; 2], [0.0; 2], [9.0 * root, 0.0]],
            moment: None,
            roll: [vec![], vec![], vec![], vec![24.0]],
        },
    ];
    for Row { engine: text, force, moment, roll } in rows {
        let engine = layout(text);
        for (place, order) in judged(&engine).iter().enumerate() {
            let [part] = &order.parts[..] else { panic!("{text}: one sum of the force") };
            let of_moment = moment.map(|moment| (halves(&part.moment), moment[place]));
            for (found, right) in [(halves(&part.force), force[place])].into_iter().chain(of_moment) {
                for (found, right) in found.into_iter().zip(right) {
                    assert!((found - right).abs() < 1e-6, "{text}, order {}: {found} for {right}", order.order);
                    assert_eq!(found == 0.0, right == 0.0, "{text}, order {}", order.order);
                }
            }
            let found = left(&order.roll);
            assert_eq!(found.len(), roll[place].len(), "{text}, order {}: {found:?}", order.order);
            for (found, right) in found.into_iter().zip(&roll[place]) {
                assert!((found - right).abs() < 1e-6, "{text}, order {}: {found} for {right}", order.order);
            }
        }
    }
}

/// `theory-mechanisms`, row 18: halves of the force, and the roll moment by the arms in circumradii.
#[test]
fn one_row_of_a_delta_leaves_ellipses() {
    let engine = layout("[delta]\nrows = [0]\ncircumradius = 1");
    let right = [([0.153, 0.234], 0.440), ([0.301, 0.866], 0.461), ([0.866, 1.628], 0.565), ([2.598, 0.0], 0.0)];
    for (order, (force, arms)) in judged(&engine).iter().zip(right) {
        for (found, right) in halves(&order.parts[0].force).into_iter().zip(force) {
            assert!((found - right).abs() < 5e-4, "order {}: {found} for {right}", order.order);
        }
        let parts = &order.roll.as_ref().expect("judged").parts;
        let of_arms = parts
            .iter()
            .filter(|part| part.class.as_ref().is_some_and(|class| matches!(class.factor, Factor::One | Factor::Open)));
        let found: f64 = of_arms.map(|part| evaluate(&part.verdict.sum).norm()).sum();
        assert!((found - arms).abs() < 5e-4, "order {}: {found} for {arms}", order.order);
    }
}

/// `theory-mechanisms`, row 20: the couple of the second order of six rows.
#[test]
fn six_rows_of_a_delta_leave_an_elliptical_couple() {
    let engine = layout("[delta]\nrows = [0, 240, 120, 60, 300, 180]\ncircumradius = 1");
    let [direct, reverse] = halves(&judged(&engine)[1].parts[0].moment);
    assert!((direct - 0.520_945).abs() < 1e-6 && (reverse - 1.5).abs() < 1e-6, "{direct} {reverse}");
}

/// A layout of cranks and cylinders as it happens, with rods, offsets and masses that turn.
pub(crate) fn any_engine(dice: &mut Dice) -> String {
    any_engine_at(dice, 1)
}

/// The same, whose crankshafts turn up to this many times while the first turns once.
pub(crate) fn any_engine_at(dice: &mut Dice, fastest: u64) -> String {
    let part = |dice: &mut Dice, most: u64| dice.below(most) as i64 - (most / 2) as i64;
    let cranks = 2 + dice.below(2);
    let mut text = String::from("effects = ['torque']\n");
    for crank in 0..cranks {
        let sense = if crank > 0 && dice.below(2) == 0 { "against" } else { "with" };
        let axis = match dice.below(3) {
            0 => format!("height = {}\noffset = '{}/3'", part(dice, 9), part(dice, 9)),
            1 => format!("distance = {}\nangle = {}", 1 + dice.below(5), dice.below(24) * 15),
            _ => format!("offset = '{} mm'", 10 * part(dice, 20)),
        };
        let phase = dice.below(12) * 30;
        let speed = match fastest {
            1 => String::new(),
            _ if crank == 0 => "speed = 1\n".to_owned(),
            _ => format!("speed = {}\n", 1 + dice.below(fastest)),
        };
        text += &format!("[[crankshaft]]\nname = 'c{crank}'\nsense = '{sense}'\n{speed}{axis}\nphase = {phase}\n");
    }
    let cylinders = 1 + dice.below(5);
    for cylinder in 0..cylinders {
        let (crank, throw, bank) = (dice.below(cranks), dice.below(24) * 15, dice.below(24) * 15);
        text += &format!(
            "[[cylinder]]\ncrankshaft = 'c{crank}'\nthrow = {throw}\nbank = {bank}\nposition = '{} mm'\npin = {}\n",
            20 * part(dice, 9),
            cylinder + 1
        );
    }
    let lists = |dice: &mut Dice, one: &dyn Fn(&mut Dice) -> String| {
        (0..cylinders).map(|_| one(dice)).collect::<Vec<_>>().join(", ")
    };
    let offsets = if dice.below(2) == 0 {
        "0".to_owned()
    } else {
        format!("[{}]", lists(dice, &|dice| format!("'{} mm'", dice.below(11) as i64 - 5)))
    };
    let masses = lists(dice, &|dice| format!("'0.{} kg'", 1 + dice.below(9)));
    text += &format!(
        "[mechanism]\nstroke = '80 mm'\nrod_length = '{} mm'\npin_offset = {offsets}\nreciprocating_mass = [{masses}]\nrotating_mass = '0.{} kg'\n",
        130 + dice.below(50),
        dice.below(5)
    );
    text += &format!("[[counterweight]]\nthrow = 1\nmass = '0.3 kg'\nradius = '{} mm'\n", 10 + dice.below(30));
    if dice.below(2) == 0 {
        text += "[[balancer]]\norder = 2\nsense = 'against'\nmass_radius = '0.002'\nangle = 30\nposition = '40 mm'\nheight = '30 mm'\noffset = '-20 mm'\n";
    }
    text
}

/// Force, moment, torque at the reference crank and roll moment on the frame at a crank angle, in multiples of m r ω² and m r² ω².
pub(crate) fn bodies(engine: &Engine, theta: f64) -> (Complex<f64>, Complex<f64>, f64, f64) {
    let zero = Complex::new(0.0, 0.0);
    let (mut force, mut moment, mut output, mut roll) = (zero, zero, 0.0, 0.0);
    let cross = |a: Complex<f64>, b: Complex<f64>| (a.conj() * b).im;
    let direction = |turn: &crankstar::exact::Turn| Complex::cis(float(turn.turns()) * TAU);
    let axis = |terms: &[crankstar::exact::Term]| -> Complex<f64> {
        terms.iter().map(|term| direction(&term.angle) * float(&term.weight)).sum()
    };
    for cylinder in engine.cylinders() {
        let crank = engine.crank_of(cylinder).expect("a crankshaft");
        let sign = if crank.sense == crankstar::proof::Sense::Direct { 1.0 } else { -1.0 };
        // How fast it turns, beside the reference.
        let speed = f64::from(crank.speed);
        let (shaft, up) = (axis(&crank.axis), direction(&cylinder.bank));
        let rod = cylinder.rod().expect("a rod");
        let length = 1.0 / float(&rod.ratio);
        // The file's offset, on the side of ψ = 90° of the crank as it stands.
        let aside = sign * float(&rod.offset) * length;
        let pin = Complex::cis(sign * speed * theta) * direction(&engine.pin_angle(cylinder));
        let local = pin * up.conj();
        // The rod's length fixes the piston; its acceleration by the crank's own angle, which grows so fast.
        let (cos, sin) = (local.re, local.im);
        let x = sin - aside;
        let root = (length * length - x * x).sqrt();
        let place = cos + root;
        let acceleration = -cos - (cos * cos - x * sin) / root - (x * cos) * (x * cos) / (root * root * root);
        let mass = float(&order::mass_radius(engine, cylinder));
        let inertia = up * (-mass * acceleration * speed * speed);
        let piston = shaft + up * (place + Complex::i() * aside);
        let along_rod = (piston - (shaft + pin)) / length;
        // Inertia, rod and wall are in balance at the piston.
        let thrust = inertia * up.conj();
        let rod_force = along_rod * (-thrust.re / (along_rod * up.conj()).re);
        let wall = -inertia - rod_force;
        // The rod is massless: it hands the opposite of what it does to the piston on to its pin.
        let on_pin = -rod_force;
        let torque = cross(pin, on_pin);
        force += inertia;
        moment += inertia * float(&engine.arm(cylinder));
        // The gears hand on power.
        output += sign * speed * torque;
        // Walls at the pistons, shafts in their bearings.
        roll += cross(piston, -wall) + cross(shaft, on_pin);
    }
    for mass in order::turning_masses(engine) {
        let turns = f64::from(mass.order) * if mass.sense == crankstar::proof::Sense::Direct { theta } else { -theta };
        let square = f64::from(mass.order) * f64::from(mass.order);
        let pull = Complex::cis(turns) * direction(&mass.angle) * (square * float(&mass.mass_radius));
        force += pull;
        moment += pull * float(&(&mass.position - engine.reference_plane()));
        roll += cross(axis(&mass.axis), pull);
    }
    (force, moment, output, roll)
}

/// Force, moment, torque and roll are those of the bodies, at crank angles all round.
pub(crate) fn assert_feels_its_bodies(engine: &Engine, orders: &[u32], text: &str) {
    let loads = loads_at(engine, orders, orders).expect("loads");
    let (torque, roll) = (loads.torque.expect("asked for"), loads.roll.expect("there are arms"));
    for step in 0..7 {
        let theta = f64::from(step) * 0.9 + 0.1;
        let (force, moment, output, frame) = bodies(engine, theta);
        let near = |found: f64, right: f64| (found - right).abs() < 1e-9 * (1.0 + right.abs());
        assert!((loads.force.at(theta) - force).norm() < 1e-9 * (1.0 + force.norm()), "force\n{text}");
        assert!((loads.moment.at(theta) - moment).norm() < 1e-9 * (1.0 + moment.norm()), "moment\n{text}");
        assert!(near(torque.waveform.at(theta).re, output), "torque\n{text}");
        let found = roll.waveform.at(theta).re;
        // A mean is no shaking moment: pistons beside the shaft have none, for their force has none.
        assert!(near(found, frame), "roll: {found} for {frame}\n{text}");
    }
}

#[test]
fn random_geared_engines_feel_what_newtons_law_says_of_each_body() {
    let mut dice = Dice::new(14);
    let orders: Vec<u32> = (1..=70).collect();
    for _ in 0..30 {
        let text = any_engine(&mut dice);
        assert_feels_its_bodies(&layout(&text), &orders, &text);
    }
}

#[test]
fn documents_of_random_geared_engines_hold() {
    let mut dice = Dice::new(15);
    for _ in 0..40 {
        let text = any_engine(&mut dice);
        let engine = layout(&text);
        let quantities = verdict::quantities(&engine, true);
        for masses in [Masses::Reciprocating, Masses::All] {
            let verdicts = verdict::classify(&engine, &[1, 2, 3, 4], masses, &quantities).expect("orders");
            let document = report::document(&engine, masses, &verdicts, &quantities, None);
            check_document(&document).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        }
    }
}

/// A document whose axis, sense or place of a mass is another is one on another engine: its terms are not those.
#[test]
fn cheats_with_cranks_and_axes_are_refused() {
    let text = "[u]\nthrows = [0, 90]\nsense = 'against'\ndistance = 4\n[mechanism]\nstroke = 0.08\nrod_ratio = 0.3\npin_offset = 0.002\nreciprocating_mass = 1\nrotating_mass = 1\n";
    let engine = layout(text);
    let quantities = verdict::quantities(&engine, true);
    let verdicts = verdict::classify(&engine, &[1, 2], Masses::All, &quantities).expect("orders");
    let honest = report::document(&engine, Masses::All, &verdicts, &quantities, None);
    check_document(&honest).expect("it holds");
    let refuse = |what: &str, change: &dyn Fn(&mut crankstar::proof::Document)| {
        let mut cheat = honest.clone();
        change(&mut cheat);
        assert!(check_document(&cheat).is_err(), "{what}");
    };
    let crank = |document: &mut crankstar::proof::Document, index: usize| {
        document.cylinders[index].crankshaft.take().expect("it has one")
    };
    refuse("a crank that turns the other way", &|document| {
        let mut own = crank(document, 2);
        own.sense = crankstar::proof::Sense::Direct;
        document.cylinders[2].crankshaft = Some(own);
    });
    refuse("an axis farther out", &|document| {
        let mut own = crank(document, 0);
        own.axis[0].weight *= BigRational::from_integer(2.into());
        document.cylinders[0].crankshaft = Some(own);
    });
    refuse("an axis elsewhere", &|document| {
        let mut own = crank(document, 0);
        own.axis[0].angle += BigRational::new(1.into(), 8.into());
        document.cylinders[0].crankshaft = Some(own);
    });
    refuse("no crankshaft", &|document| drop(crank(document, 1)));
    refuse("a mass in the middle", &|document| document.turning_masses[0].axis.clear());
    refuse("no roll moment, and axes all the same", &|document| {
        document.quantities.retain(|quantity| *quantity != Quantity::ROLL);
        document.verdicts.retain(|verdict| verdict.quantity != Quantity::ROLL);
        document.wholes.retain(|whole| whole.quantity != Quantity::ROLL);
    });
    refuse("a roll verdict less", &|document| {
        let index = document.verdicts.iter().position(|verdict| verdict.quantity == Quantity::ROLL).expect("one");
        document.verdicts.remove(index);
    });
}

#[test]
fn mistakes_about_crankshafts_get_a_message_at_their_place() {
    let two = "[[crankshaft]]\nname = 'a'\nsense = 'with'\n[[crankshaft]]\nname = 'b'\nsense = 'against'\noffset = 4\n";
    let cylinder = |of: &str| format!("[[cylinder]]\n{of}\nthrow = 0\nbank = 0\nposition = 0\n");
    for (text, words) in [
        (format!("{two}{}", cylinder("")), "does not say which crankshaft"),
        (format!("{two}{}", cylinder("crankshaft = 'c'")), "one of a, b"),
        (cylinder("crankshaft = 'c'"), "no crankshaft is called c"),
        (two.replace("'b'", "'a'") + &cylinder("crankshaft = 'a'"), "a name of its own"),
        (two.replace("'b'", "'a b'") + &cylinder("crankshaft = 'a'"), "letters or digits"),
        (two.replace("'with'", "'against'") + &cylinder("crankshaft = 'a'"), "the first crankshaft"),
        (two.replace("'with'", "'backwards'") + &cylinder("crankshaft = 'a'"), "against"),
        (two.replace("offset = 4", "offset = '40 mm'") + &cylinder("crankshaft = 'a'"), "crank radius is not known"),
        (
            "cycle = 'four-stroke'\nfiring_order = '1'\n".to_owned()
                + &two.replace("offset = 4", "offset = 4\nphase = 30")
                + "[[cylinder]]\ncrankshaft = 'a'\nbank = 0\nposition = 0\n",
            "whose throws are not written",
        ),
        (two.replace("offset = 4", "distance = 4") + &cylinder("crankshaft = 'a'"), "not given in one way"),
        (format!("{two}[inline]\nthrows = [0]"), "short form has its own"),
        (
            "cycle = 'two-stroke'\nfiring_order = '1-2'\n[opposed_piston]\nthrows = [0]\nlead = 9".into(),
            "which is not a cylinder",
        ),
        ("[delta]\nrows = [0]\ncircumradius = 6\nagainst = ['D']".into(), "\"B\" or \"C\""),
        ("[delta]\nrows = [0]\ncircumradius = 6\nagainst = ['A', 'B', 'C']".into(), "leave one corner out"),
        ("[delta]\nrows = [0]\ncircumradius = 6\nagainst = ['A', 'A']".into(), "the corner `A` is named before"),
        ("[opposed_piston]\nthrows = [0]\nlead = 9\nleading = 'left'".into(), "\"upper\" or \"lower\""),
        ("[square_four]\nin_phase = 'rows'\nsense = 'with'\ndistance = 4".into(), "diagonals"),
        ("[h]\nthrows = [0]\nsense = 'with'".into(), "distance"),
    ] {
        let error = parse("geared.toml", &text).expect_err(&text).to_string();
        assert!(error.contains(words), "{text}\n{error}");
    }
}

/// A short form and the same engine pin by pin.
#[test]
fn short_forms_are_the_engines_of_their_tables() {
    let short = layout("[u]\nthrows = [0, 90]\nsense = 'against'\ndistance = 4\nphase = 30");
    let mut text = String::from(
        "[[crankshaft]]\nname = 'l'\nsense = 'with'\noffset = 2\n[[crankshaft]]\nname = 'r'\nsense = 'against'\noffset = -2\n",
    );
    // On the right the pins run the other way.
    for (crank, throw, position) in [("l", 0, "1/2"), ("l", 90, "-1/2"), ("r", -30, "1/2"), ("r", -120, "-1/2")] {
        text += &format!("[[cylinder]]\ncrankshaft = '{crank}'\nthrow = {throw}\nbank = 0\nposition = '{position}'\n");
    }
    let long = layout(&text);
    for (one, other) in short.cylinders().iter().zip(long.cylinders()) {
        assert_eq!(
            (&one.throw, &one.bank, &one.position, one.crank),
            (&other.throw, &other.bank, &other.position, other.crank)
        );
        assert_eq!(short.pin_angle(one), long.pin_angle(other));
    }
    assert_eq!(
        short.geared_cranks().iter().map(|crank| &crank.axis).collect::<Vec<_>>(),
        long.geared_cranks().iter().map(|crank| &crank.axis).collect::<Vec<_>>()
    );
}
