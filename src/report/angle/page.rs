//! What is on the page of values at crank angles, and on the terminal?

use super::super::torque::{double_acting, opposed, quantity};
use super::{AngleStudy, Instant, tables};
use crate::journal::PistonAt;
use crate::page::plot::{Axis, Curve, Plot, Rule};
use crate::page::{Block, Document, Picture, Text, Unit};
use crate::report::mechanism_words;
use crate::report::texts::angle as text;

/// The short answer.
pub(super) fn answer(study: &AngleStudy) -> Document {
    let mut answer = Document::new("angle", study.engine.title());
    answer.blocks.extend(values(study));
    answer
}

/// The page.
pub(super) fn page(study: &AngleStudy) -> Document {
    let said: Vec<Text> = study.instants.iter().take(3).filter_map(said).collect();
    text::Page {
        engine: study.engine.title().into(),
        answer: (!said.is_empty()).then_some(Block::Answer(said)).into(),
        drawn: Block::Pictures(pictures(study)).into(),
        values: values(study).into(),
        other_mechanisms_and_signs: other_mechanisms_and_signs(study).collect(),
    }
    .document()
}

/// What is said of pistons of other kinds, where they are there, and of signs.
fn other_mechanisms_and_signs(study: &AngleStudy) -> impl Iterator<Item = Text> {
    let engine = &study.engine;
    let others = double_acting(engine).into_iter().chain(opposed(engine));
    let others = others.chain(mechanism_words::at_angles(engine));
    let others = others.chain((!engine.geared_cranks().is_empty()).then(text::geared));
    let has_textbook = study.pistons().any(|(_, piston)| piston.textbook.is_some());
    others.chain([text::signs()]).chain(has_textbook.then(text::textbook))
}

fn said(instant: &Instant) -> Option<Text> {
    let torque = instant.sum(PistonAt::torque)?;
    Some(text::torque(tables::degrees(instant.theta), quantity(torque, Unit::NEWTON_METRE)))
}

/// The tables that have values.
fn values(study: &AngleStudy) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Motion of the pistons".into()), tables::motion(study).into()];
    if study.pistons().any(|(_, piston)| piston.effort().is_some()) {
        blocks.push(Block::Heading(1, "Forces".into()));
        blocks.push(tables::forces(study).into());
        if study.engine.cylinders().len() > 1 {
            blocks.push(Block::Heading(1, "Torque of all cylinders".into()));
            blocks.push(tables::torque(study).into());
        }
    } else {
        blocks.push(Block::Note(text::no_forces()));
    }
    if study.bearings().next().is_some() {
        blocks.push(Block::Heading(1, "Main bearings".into()));
        blocks.push(tables::bearings(study).into());
    }
    let rows: usize = study.instants.iter().map(|instant| instant.pistons.len().max(instant.bearings.len())).sum();
    if rows > tables::MOST_SHOWN {
        blocks.push(Block::Note(text::first_rows(tables::MOST_SHOWN)));
    }
    blocks
}

/// Motion and forces of the first cylinder through the cycle; lines at the angles where they are few.
fn pictures(study: &AngleStudy) -> Vec<Picture> {
    let last = study.law.period();
    let all: Vec<(f64, PistonAt)> = (0..=last as u32)
        .map(f64::from)
        .filter_map(|theta| Some((theta, study.law.pistons(theta).into_iter().next()?)))
        .collect();
    let rules: Vec<Rule> = match study.instants.as_slice() {
        few if few.len() <= 3 => {
            let at =
                |instant: &Instant| Rule { at: instant.theta.rem_euclid(last), upright: true, label: String::new() };
            few.iter().map(at).collect()
        }
        _ => Vec::new(),
    };
    let draw = |name: &str, title: &'static str, axis: Axis, curves: &[(&str, tables::Value)], caption: Text| {
        let mut plot = Plot::new(title, Axis::angle("Crank angle θ in °", 0.0, last, 90), axis);
        for (place, (label, of)) in curves.iter().enumerate() {
            let points: Vec<(f64, f64)> =
                all.iter().filter_map(|(theta, piston)| Some((*theta, of(piston)?))).collect();
            if !points.is_empty() {
                plot.curves.push(Curve::new(place, *label, points));
            }
        }
        plot.rules.clone_from(&rules);
        (!plot.curves.is_empty()).then(|| Picture::new(name, caption, plot.figure()))
    };
    let acceleration = draw(
        "angle-acceleration",
        "Acceleration of the first piston",
        Axis::linear("Acceleration in {}").counted_in(Unit::METRE_PER_SQUARE_SECOND),
        &[("mechanism", &|piston| piston.acceleration), ("textbook", &|piston| piston.textbook.map(|both| both[1]))],
        text::acceleration(all.iter().any(|(_, piston)| piston.textbook.is_some())),
    );
    let forces = draw(
        "angle-forces",
        "Forces on the first piston",
        Axis::linear("Force in {}").counted_in(Unit::NEWTON),
        &[
            ("effort", &PistonAt::effort),
            ("gas", &|piston| piston.gas),
            ("inertia", &|piston| piston.inertia),
            ("side force", &PistonAt::side),
        ],
        text::forces(),
    );
    acceleration.into_iter().chain(forces).collect()
}
