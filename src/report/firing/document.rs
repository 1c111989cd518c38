//! What does `firing --format json` hold? Every star with its terms and its certificate.

use num_rational::BigRational;

use super::super::document::{decimals, rod_statement, vectors};
use super::FiringStudy;
use crate::engine::{Cycle, Engine, Shot};
use crate::firing::{FiringPattern, FiringStar, NoStar, StarOrder, Weights};
use crate::proof::{CycleClaim, FiringClaim, FiringCylinder, FiringDocument, Format, PatternClaim, PatternVerdict};

/// The engine of a document of firing stars, as this layout has it, weighed as there.
///
/// # Errors
/// A layout that does not say when the cylinders fire.
pub fn firing_engine(engine: &Engine, own: &FiringDocument) -> Result<FiringDocument, NoStar> {
    let deflections: Vec<_> = own.cylinders.iter().map(|cylinder| cylinder.deflection.clone()).collect();
    let weights = match deflections.len() == engine.cylinders().len() {
        true => Weights::ModeShape(deflections),
        false => Weights::Rigid,
    };
    Ok(firing_document(&FiringStudy::of_engine(engine, weights)?, false))
}

/// The stars as data: what `verify` reads. The stars of one period are in it where they are asked for and can be had.
pub fn firing_document(study: &FiringStudy, with_pattern: bool) -> FiringDocument {
    let engine = &study.engine;
    let firing = engine.firing().unwrap_or_else(|| unreachable!("a study needs an engine that fires"));
    let cylinder = |Shot { cylinder: index, angle }: &Shot| {
        let cylinder = &engine.cylinders()[*index];
        let claim = FiringCylinder {
            name: cylinder.name.clone(),
            throw: cylinder.throw.turns().clone(),
            bank: cylinder.bank.turns().clone(),
            firing_angle: angle.clone(),
            crank_radius: cylinder.crank_radius.clone(),
            deflection: study.weights.of(*index),
            rod: rod_statement(cylinder),
        };
        (*index, claim)
    };
    let mut cylinders: Vec<(usize, FiringCylinder)> = firing.shots.iter().map(cylinder).collect();
    cylinders.sort_by_key(|(index, _)| *index);
    let pattern = with_pattern.then(|| study.pattern().ok()).flatten();
    FiringDocument {
        format: Format::Firing,
        title: engine.title().written().to_owned(),
        cycle: match firing.cycle {
            Cycle::TwoStroke => CycleClaim::TwoStroke,
            Cycle::FourStroke => CycleClaim::FourStroke,
        },
        cylinders: cylinders.into_iter().map(|(_, claim)| claim).collect(),
        orders: study.orders.iter().map(|order| order.order.exact()).collect(),
        verdicts: study
            .orders
            .iter()
            .flat_map(|order| order.stars.iter().map(|star| claim(study, order, star)))
            .collect(),
        pattern: pattern.map(pattern_claim),
    }
}

fn claim(study: &FiringStudy, order: &StarOrder, star: &FiringStar) -> FiringClaim {
    let (modulus, angle_deg) = decimals(star.into());
    let names = || star.sources.iter().map(|source| source.name(&study.engine)).collect();
    FiringClaim {
        order: order.order.exact(),
        of: if order.stars.len() > 1 { names() } else { Vec::new() },
        vanishes: star.vanishes(),
        terms: vectors(star.sum.terms()),
        modulus,
        angle_deg,
        certificate: star.certificate.clone(),
    }
}

fn pattern_claim(pattern: &FiringPattern) -> PatternClaim {
    let verdict = |order: BigRational, star: &FiringStar| PatternVerdict {
        order,
        vanishes: star.vanishes(),
        certificate: star.certificate.clone(),
    };
    let of_order = |order: &StarOrder| -> Vec<PatternVerdict> {
        order.stars.iter().map(|star| verdict(order.order.exact(), star)).collect()
    };
    PatternClaim {
        period: u32::try_from(pattern.orders.len()).unwrap_or(u32::MAX),
        verdicts: pattern.orders.iter().flat_map(of_order).collect(),
    }
}
