//! What is on the page of values at crank angles, and on the terminal?

use super::super::torque::{double_acting, opposed, quantity};
use super::{AngleStudy, Instant, tables};
use crate::journal::PistonAt;
use crate::page::plot::{Axis, Curve, Plot, Rule};
use crate::page::{Block, Document, Picture, Text, Unit, phrase};

const DIRECTIONS: &str = "Displacements, velocities, accelerations and forces are positive towards the crankshaft, the side force of the wall on the piston a quarter turn \
    anticlockwise from the axis outward; the torque is positive in the sense of rotation. ψ is the crank angle after the dead centre at which the cylinder fires, \
    or after its dead centre where there is no gas.";

const FOUND: &str = "The piston is at $s = r\\cos\\psi + l\\sqrt{1-(\\lambda\\sin\\psi-\\delta)^2}$, the prime $d/d\\psi$: velocity $-s'\\omega$, acceleration \
    $-s''\\omega^2$, the closed forms without a series. The effort $F$ is the gas $(p-p_c)A$, the inertia $m\\,s''\\omega^2$ and the weight where it is asked for; the rod feels $F/\\cos\\beta$, the wall \
    $F\\tan\\beta$, the crank $-F s'$, and the crankpin the rod with its rotating mass. All values are decimals.";

const LINKS: &str = "A piston on a link is at $s = \\mathrm{Re}\\,K + \\sqrt{L^2 - \\mathrm{Im}^2 K}$, K its knuckle pin on the master rod, seen along the axis. Its torque is again $-F s'$, and the mass μ at the knuckle pin adds $-\\tfrac12 \\mu\\,(|K'|^2)'\\,\\omega^2$. A link loads its knuckle pin along itself, and the mass there with its inertia; the wall at the piston of the master rod bears the moment of these loads about the crankpin, so that its side force is not $F\\tan\\beta$ alone. The thrust of a rod on which links hang is that in its small end; the pin of a link is its knuckle pin, and the crankpin feels the master rod with all its links.";

const GEARED: &str = "The torque of each piston is positive in the sense in which its own crankshaft turns; that of all cylinders is the torque at the first crankshaft, to which the others are geared.";

const TEXTBOOK: &str = "By the textbook: $v \\approx r\\omega(\\sin\\psi+\\tfrac{\\lambda}{2}\\sin 2\\psi)$ and $a \\approx r\\omega^2(\\cos\\psi+\\lambda\\cos 2\\psi)$, the first terms of series in λ, beside \
    the values of the mechanism itself.";

/// The short answer.
pub(super) fn answer(study: &AngleStudy) -> Document {
    let mut answer = Document::new("angle", study.engine.title());
    answer.blocks.extend(values(study));
    answer
}

/// The page.
pub(super) fn page(study: &AngleStudy) -> Document {
    let mut page = Document::new("angle", phrase!("{}: values at crank angles", study.engine.title()));
    let said: Vec<Text> = study.instants.iter().take(3).filter_map(said).collect();
    if !said.is_empty() {
        page.push(Block::Answer(said));
    }
    page.push(Block::Pictures(pictures(study)));
    page.blocks.extend(values(study));
    page.push(Block::Heading(1, "How it was found".into()));
    page.push(Block::Paragraph(FOUND.into()));
    page.blocks.extend(double_acting(&study.engine).map(Block::Paragraph));
    page.blocks.extend(opposed(&study.engine).map(Block::Paragraph));
    page.blocks.extend(study.engine.has_links().then(|| Block::Paragraph(LINKS.into())));
    page.blocks.extend((!study.engine.geared_cranks().is_empty()).then(|| Block::Paragraph(GEARED.into())));
    page.push(Block::Paragraph(DIRECTIONS.into()));
    if study.pistons().any(|(_, piston)| piston.textbook.is_some()) {
        page.push(Block::Paragraph(TEXTBOOK.into()));
    }
    page
}

fn said(instant: &Instant) -> Option<Text> {
    let torque = instant.sum(PistonAt::torque)?;
    let theta = tables::degrees(instant.theta);
    Some(phrase!("At θ = {} the torque on the crankshaft is {}.", theta, quantity(torque, Unit::NEWTON_METRE)))
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
        blocks.push(Block::Note("Forces need masses and a speed, or [gas].".into()));
    }
    if study.bearings().next().is_some() {
        blocks.push(Block::Heading(1, "Main bearings".into()));
        blocks.push(tables::bearings(study).into());
    }
    let rows: usize = study.instants.iter().map(|instant| instant.pistons.len().max(instant.bearings.len())).sum();
    if rows > tables::MOST_SHOWN {
        blocks.push(Block::Note(phrase!(
            "A table shows its first {} rows; those of data, with --format csv or xlsx, have all.",
            tables::MOST_SHOWN
        )));
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
        (!plot.curves.is_empty()).then(|| Picture { name: name.to_owned(), caption, figure: plot.figure() })
    };
    let acceleration = draw(
        "angle-acceleration",
        "Acceleration of the first piston",
        Axis::linear("Acceleration in {}").counted_in(Unit::METRE_PER_SQUARE_SECOND),
        &[("mechanism", &|piston| piston.acceleration), ("textbook", &|piston| piston.textbook.map(|both| both[1]))],
        "The acceleration of the first piston towards the crankshaft, of the mechanism and by the textbook's two terms. Upright lines are the angles that are asked for, where they are few.".into(),
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
        "The forces on the first piston: of the gas, of its inertia, both together, which is the effort, and the side force of the wall.".into(),
    );
    acceleration.into_iter().chain(forces).collect()
}
