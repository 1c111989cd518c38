//! What is on the page of a turning-moment diagram, and on the terminal?

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::super::torque::{angle, quantity};
use super::FlywheelStudy;
use crate::file::Torque;
use crate::flywheel::{TorqueCurve, WithPi};
use crate::numbers::float;
use crate::page::number::{Amount, Number, given, turns_in_decimals};
use crate::page::plot::{Axis, Curve, Plot};
use crate::page::{Block, Document, Picture, Piece, Table, Text, Unit, phrase};
use crate::report::texts::flywheel as text;

/// Steps of a turn in which a torque of harmonics is drawn.
const STEPS: i64 = 180;

/// The short answer.
pub(super) fn answer(study: &FlywheelStudy) -> Document {
    let mut answer = Document::new("flywheel", &study.diagram.title);
    for line in lines(study) {
        answer.push(Block::Paragraph(line));
    }
    answer.blocks.extend(tables(study));
    answer
}

/// The page.
pub(super) fn page(study: &FlywheelStudy) -> Document {
    let is_of_harmonics = matches!(study.diagram.torque, Torque::Harmonics(..));
    text::Page {
        diagram: (&study.diagram.title).into(),
        answer: Block::Answer(lines(study)).into(),
        drawn: picture(study).into(),
        tables: tables(study).into(),
        found: [text::areas()].into_iter().chain(is_of_harmonics.then(text::harmonics)).collect(),
    }
    .document()
}

/// A value with its closed form before it, where that can be read.
fn value(value: &WithPi, unit: Unit) -> Text {
    let decimal = match unit {
        Unit::NONE => Text::figures(value.decimal),
        unit => quantity(value.decimal, unit),
    };
    let before = |exact: Text| Text::from(Piece::InUnit(Box::new(exact), unit)).and(decimal.clone());
    let about = if unit == Unit::NONE { Number::Decimal(value.decimal).into() } else { decimal.clone() };
    let amount = value.form.clone().map(|form| Amount { decimal: form.to_float(), exact: Some(form) });
    match (amount.map(|amount| amount.number()), value.power, unit) {
        (Some(Number::Zero), ..) => Text::zero(),
        (Some(Number::Exact(exact)), 0, Unit::NONE) => Number::Exact(exact).into(),
        (Some(Number::Exact(exact)), 0, unit) => Text::from(Piece::Exactly(exact, unit)).and(" ").and(unit),
        (Some(Number::Closed(form, _)), 0, _) => before(phrase!("{} ≈ ", Piece::Form(form))),
        (Some(number), power @ (1 | -1 | -2), _) => {
            let form = match number {
                Number::Exact(_) | Number::Closed(..) => value.form.clone().map(Piece::Form),
                Number::Zero | Number::Decimal(_) => None,
            };
            match (form, power) {
                (Some(form), 1) => before(phrase!("π · {} ≈ ", form)),
                (Some(form), -1) => before(phrase!("1/π · {} ≈ ", form)),
                (Some(form), _) => before(phrase!("1/π² · {} ≈ ", form)),
                (None, _) => about,
            }
        }
        _ => about,
    }
}

/// The lines of the box.
fn lines(study: &FlywheelStudy) -> Vec<Text> {
    let (diagram, found) = (&study.diagram, &study.fluctuation);
    let mut lines = vec![text::fluctuation(value(&found.energy, Unit::JOULE))];
    let at = found.fastest_and_slowest.map(|both| both.map(angle));
    lines.extend(at.map(|[fastest, slowest]| text::fastest_and_slowest(fastest, slowest)));
    let mean_and_work = found.mean.as_ref().zip(found.work.as_ref());
    lines.extend(
        mean_and_work.map(|(mean, work)| text::mean_torque(value(mean, Unit::NEWTON_METRE), value(work, Unit::JOULE))),
    );
    lines.extend(found.energy_coefficient.as_ref().map(|part| text::energy_coefficient(value(part, Unit::NONE))));
    let Some(speed) = &diagram.speed else {
        lines.push(text::no_speed());
        return lines;
    };
    let kilowatts = found.power.as_ref().map(|power| quantity(power.decimal / 1e3, Unit::KILOWATT));
    lines.extend(kilowatts.map(|power| text::power(given(speed), power)));
    lines.extend(found.irregularity.as_ref().zip(diagram.inertia.as_ref()).map(|(part, inertia)| {
        let inertia = quantity(float(inertia), Unit::KILOGRAM_SQUARE_METRE);
        match part.decimal > 2.0 {
            true => text::stops(inertia, given(speed), value(part, Unit::NONE)),
            false => text::speed(inertia, given(speed), value(part, Unit::NONE), Text::figures(part.decimal * 50.0)),
        }
    }));
    lines.extend(found.inertia.as_ref().zip(diagram.irregularity.as_ref()).map(|(inertia, wanted)| {
        text::flywheel(given(wanted), given(speed), value(inertia, Unit::KILOGRAM_SQUARE_METRE))
    }));
    lines.extend(found.mass.as_ref().map(|mass| text::mass(quantity(mass.decimal, Unit::KILOGRAM))));
    lines
}

fn tables(study: &FlywheelStudy) -> Vec<Block> {
    let found = &study.fluctuation;
    let mut blocks = Vec::new();
    if !found.lobes.is_empty() {
        let has_angles = found.lobes.iter().any(|lobe| lobe.from.is_some());
        let work = |work: &WithPi| value(work, Unit::JOULE);
        blocks.push(Block::Heading(1, "Areas between torque and load".into()));
        blocks.push(
            Table::of(found.lobes.iter().enumerate())
                .column("Area", |(index, _)| Text::label((index + 1).to_string()))
                .column_if(has_angles, "from θ", |(_, lobe)| {
                    lobe.from.as_ref().map_or_else(Text::default, exact_angle)
                })
                .column("Work", |(_, lobe)| work(&lobe.work))
                .column("Sum up to its end", |(_, lobe)| work(&lobe.sum))
                .done()
                .into(),
        );
    }
    if !found.angles.is_empty() {
        blocks.push(Block::Heading(1, "Values at an angle".into()));
        let torque = |newton_metres: f64| quantity(newton_metres, Unit::NEWTON_METRE);
        let accelerates = found.angles.iter().any(|at| at.acceleration.is_some());
        blocks.push(
            Table::of(found.angles.iter())
                .column(Text::label("θ"), |at| exact_angle(&at.angle))
                .column("Torque", |at| torque(at.torque))
                .column("Load", |at| torque(at.load))
                .column_if(accelerates, "Angular acceleration in rad/s²", |at| {
                    at.acceleration.map_or_else(Text::default, |alpha| Number::Decimal(alpha).into())
                })
                .done()
                .into(),
        );
        let has_step = TorqueCurve::new(&study.diagram)
            .is_ok_and(|curve| found.angles.iter().any(|at| has_step(&curve, &at.angle)));
        blocks.extend(has_step.then(|| Block::Note(text::at_a_step())));
    }
    blocks
}

/// Whether torque or load has two values at an angle.
fn has_step(curve: &TorqueCurve, angle: &BigRational) -> bool {
    let TorqueCurve::Lines(torque, load, _) = curve else { return false };
    [torque, load].into_iter().any(|lines| {
        let Some(end) = lines.last() else { return false };
        let angle = angle - (angle / &end.to).floor() * &end.to;
        let before = [end].into_iter().chain(lines);
        before.zip(lines).any(|(before, behind)| behind.from == angle && before.last != behind.first)
    })
}

/// An angle in turns that is known exactly.
fn exact_angle(turns: &BigRational) -> Text {
    Text::label(turns_in_decimals(turns))
}

/// Torque and load over a cycle; none of areas, which do not tell them.
fn picture(study: &FlywheelStudy) -> Option<Picture> {
    let diagram = &study.diagram;
    let cycle = study.fluctuation.cycle.as_ref()?;
    let mut turns: Vec<BigRational> = match &diagram.torque {
        // Beside a corner or a step on both sides.
        Torque::Lines(lines) if diagram.cylinders.0 == 1 => {
            let near = BigRational::new(1.into(), 1_000_000.into());
            let ends = lines.iter().flat_map(|line| [line.from.clone(), (&line.to - &near).max(line.from.clone())]);
            ends.collect()
        }
        _ => {
            let step = BigRational::new(1.into(), STEPS.into());
            let count = (cycle / &step).floor().to_integer().to_i64()?;
            (0..count).map(|index| &step * BigRational::from_integer(index.into())).collect()
        }
    };
    turns.push(cycle - BigRational::new(1.into(), 1_000_000.into()));
    turns.retain(|at| *at >= BigRational::zero());
    turns.sort();
    let degrees = |turns: &BigRational| float(turns) * 360.0;
    let course = TorqueCurve::new(diagram).ok()?;
    let values: Vec<(f64, [f64; 2])> = turns.iter().map(|at| (degrees(at), course.at(at))).collect();
    let curve = |index: usize| values.iter().map(|(at, both)| (*at, both[index])).collect();
    let x = Axis { range: Some((0.0, degrees(cycle))), ..Axis::linear("Crank angle θ in °") };
    let mut plot = Plot::new("Torque", x, Axis::amplitude("Torque in {}").counted_in(Unit::NEWTON_METRE));
    plot.curves.push(Curve::new(0, "torque", curve(0)));
    plot.curves.push(Curve::new(1, "load", curve(1)));
    Some(Picture::new("turning-moment", text::torque_and_load(), plot.figure()))
}
