//! How does a student of a test fill in a table? From the forces of the pistons in the time domain, without the phasors of the program.

use crankstar::classroom::{
    Content, Exercise, HandedIn, MarkedSheet, Outcome, Pupil, StudentResult, Vary, csv_to_fill_in, students,
};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::proof::Planar;
use num_complex::Complex;
use num_traits::ToPrimitive;

/// What a student writes for one order, to some decimals: phases by cylinder, then the sums of forces and of moments, each direct
/// and reverse.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    pub order: u32,
    pub phases: Vec<[String; 2]>,
    pub sums: [[String; 2]; 2],
}

fn degrees(turn: &crankstar::Turn) -> f64 {
    turn.degrees().to_f64().expect("a float")
}

/// `P⁺` and `P⁻` of the force, or of the moment, of the cylinders, whose phases may be off by this many degrees: twice the mean of the
/// force along and across, turned back and on, over one revolution.
pub fn vectors(engine: &Engine, order: u32, quantity: Planar, off: impl Fn(usize) -> [f64; 2]) -> [Complex<f64>; 2] {
    const STEPS: u32 = 64;
    let k = f64::from(order);
    let float = |number: &crankstar::BigRational| number.to_f64().expect("a float");
    let cylinders: Vec<(f64, f64, f64, [f64; 2])> = (engine.cylinders().iter().enumerate())
        .map(|(index, cylinder)| {
            let arm = if quantity == Planar::Moment { float(&engine.arm(cylinder)) } else { 1.0 };
            let angles = [&cylinder.throw, &cylinder.bank].map(|angle| degrees(angle).to_radians());
            (angles[0], angles[1], float(&cylinder.weight()) * arm, off(index).map(f64::to_radians))
        })
        .collect();
    [1.0, -1.0].map(|sense: f64| {
        let at = |step: u32| {
            let theta = f64::from(step) / f64::from(STEPS) * std::f64::consts::TAU;
            let forces = cylinders.iter().map(|(throw, bank, weight, [direct, reverse])| {
                let along = weight * (k * (theta + throw - bank)).cos();
                Complex::from_polar(along, *bank)
                    * Complex::from_polar(1.0, if sense > 0.0 { *direct } else { *reverse })
            });
            forces.sum::<Complex<f64>>() * Complex::from_polar(1.0, -sense * k * theta)
        };
        (0..STEPS).map(at).sum::<Complex<f64>>() * 2.0 / f64::from(STEPS)
    })
}

/// Decimals of a length, 0 where it is none.
pub fn decimals(value: f64, places: usize) -> String {
    if value.abs() < 1e-9 { "0".to_owned() } else { format!("{value:.places$}") }
}

/// What a student without a mistake writes.
pub fn right(engine: &Engine, order: u32, places: usize) -> Answer {
    with_wrong_phases(engine, order, places, |_| [0.0, 0.0])
}

/// What a student writes whose phases are off by this many degrees, and whose sums are those of these phases.
pub fn with_wrong_phases(engine: &Engine, order: u32, places: usize, off: impl Fn(usize) -> [f64; 2]) -> Answer {
    let k = f64::from(order);
    let phase = |(index, cylinder): (usize, &crankstar::Cylinder)| {
        let (throw, bank) = (degrees(&cylinder.throw), degrees(&cylinder.bank));
        let [direct, reverse] = off(index);
        let phases = [k * throw - (k - 1.0) * bank + direct, -k * throw + (k + 1.0) * bank + reverse];
        phases.map(|phase| format!("{:.5}", phase.rem_euclid(360.0)))
    };
    let phases = engine.cylinders().iter().enumerate().map(phase).collect();
    let length = |quantity| vectors(engine, order, quantity, &off).map(|vector| decimals(vector.norm(), places));
    Answer { order, phases, sums: [length(Planar::Force), length(Planar::Moment)] }
}

/// The mirror image: every phase has the other sign.
pub fn mirrored(answer: &Answer) -> Answer {
    let negative = |phase: &String| phase.strip_prefix('-').map_or_else(|| format!("-{phase}"), str::to_owned);
    Answer { phases: answer.phases.iter().map(|phases| phases.each_ref().map(negative)).collect(), ..answer.clone() }
}

/// The table as a student hands it in.
pub fn toml(pupil: &Pupil, convention: &str, answers: &[Answer]) -> String {
    let mut text = format!("sheet = \"{}\"\n[convention]\n{convention}\n", pupil.file);
    for Answer { order, phases, sums } in answers {
        text.push_str(&format!("[[table]]\norder = {order}\nrows = [\n"));
        for (cylinder, [direct, reverse]) in pupil.engine.cylinders().iter().zip(phases) {
            text.push_str(&format!(
                "{{ cylinder = '{}', direct = '{direct}', reverse = '{reverse}' }},\n",
                cylinder.name
            ));
        }
        let [[a, b], [c, d]] = sums;
        text.push_str(&format!("]\n[table.sums]\nforce_direct = '{a}'\nforce_reverse = '{b}'\nmoment_direct = '{c}'\nmoment_reverse = '{d}'\n"));
    }
    text
}

/// The rows of a student without a mistake, as a spreadsheet writes them.
pub fn rows(pupil: &Pupil, orders: &[u32]) -> Vec<String> {
    let answers: Vec<_> = orders.iter().map(|order| right(&pupil.engine, *order, 4)).collect();
    let mut lines = Vec::new();
    for (place, line) in csv_to_fill_in(pupil, orders).lines().enumerate() {
        let Some((head, row)) = line.strip_suffix(",,").and_then(|line| line.rsplit_once(',')).filter(|_| place > 0)
        else {
            lines.push(line.to_owned());
            continue;
        };
        let order: Option<u32> = head.rsplit(',').next().and_then(|order| order.parse().ok());
        let answer = answers.iter().find(|answer| Some(answer.order) == order);
        let values = answer.map(|answer| match row.strip_prefix("cylinder ") {
            Some(name) => {
                let place = pupil.engine.cylinders().iter().position(|cylinder| cylinder.name == name);
                answer.phases[place.expect("a cylinder")].clone()
            }
            None => answer.sums[usize::from(row == "sum of moments")].clone(),
        });
        lines.push(values.map_or_else(|| line.to_owned(), |[a, b]| format!("{head},{row},{a},{b}")));
    }
    lines
}

/// One file of all students.
pub fn class_file(exercise: &Exercise) -> Vec<String> {
    let of = |(place, pupil): (usize, &Pupil)| rows(pupil, &exercise.orders).split_off(usize::from(place > 0));
    exercise.pupils.iter().enumerate().flat_map(of).collect()
}

pub fn draw(layout: &str, names: &str, orders: &[u32]) -> Exercise {
    let engine = file::find(layout).expect("a name of the catalogue").engine().expect("it reads");
    Exercise::draw(&engine, orders, &students(names).expect("a list"), 1, Vary::ALL).expect("engines")
}

pub fn bytes(name: &str, content: impl Into<Vec<u8>>) -> HandedIn {
    HandedIn { name: name.to_owned(), content: Content::Bytes(content.into()) }
}

pub fn sheet<'a>(results: &'a [StudentResult], student: usize) -> &'a MarkedSheet {
    match &results[student].outcome {
        Outcome::Marked(sheet) => sheet,
        other => panic!("{other:?}"),
    }
}
