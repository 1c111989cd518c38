//! Which vectors turn in each order, what do they sum to, and how is that put?

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::super::{residual, typeset};
use super::bodies::decimal;
use super::open_angle::OpenAngle;
use super::scene::{MovingOrder, MovingQuantity, MovingSense, Ray, ZERO};
use crate::engine::Engine;
use crate::exact::Turn;
use crate::numbers;
use crate::order::Source;
use crate::verdict::{Balance, Judgement, OrderBalance, OrderVerdict, Verdict};

/// The orders that are judged, each of their sums by itself.
pub(super) fn orders(engine: &Engine, judged: &Judgement, open: Option<&OpenAngle>) -> Vec<MovingOrder> {
    let of_order = |order| move |part| moving_order(engine, order, part, open);
    judged.orders.iter().flat_map(|order| order.parts.iter().map(of_order(order))).collect()
}

fn moving_order(engine: &Engine, order: &OrderVerdict, part: &OrderBalance, open: Option<&OpenAngle>) -> MovingOrder {
    let whole = || (order.parts.len() > 1).then(|| residual::whole_summary(order));
    let [whole_force, whole_moment] = whole().map_or([None, None], |words| words.map(Some));
    let quantity = |balance: &Balance, left, whole| {
        let senses = balance.verdicts().map(|verdict| sense(engine, verdict, part.exists, open));
        let marks = open.filter(|_| part.exists).map(|open| open.marks(balance)).unwrap_or_default();
        let words = if part.exists && balance.is_balanced() { ZERO.to_owned() } else { left };
        MovingQuantity { words, whole, reach: reach(&senses, open), senses, marks }
    };
    MovingOrder {
        order: part.order,
        name: residual::order_name(part),
        exists: part.exists,
        force: quantity(&part.force, residual::force_summary(part), whole_force),
        moment: quantity(&part.moment, residual::moment_summary(part), whole_moment),
    }
}

fn sense(engine: &Engine, verdict: &Verdict, exists: bool, open: Option<&OpenAngle>) -> MovingSense {
    let sum = numbers::evaluate(&verdict.sum);
    let words = match verdict.vanishes() {
        true => ZERO.to_owned(),
        false => {
            let (length, angle) = (residual::modulus(verdict), residual::bearing(&verdict.sum));
            format!("length {}, angle {} at θ = 0", length.plain(), angle.plain())
        }
    };
    MovingSense {
        words,
        zero: verdict.vanishes(),
        rays: rays(engine, verdict, open),
        length: numbers::length(sum),
        degrees: numbers::degrees(sum),
        zeros: open.filter(|_| exists).and_then(|open| open.zeros_of(verdict)),
    }
}

/// The vectors that stay in one direction together, whatever the open angle is.
fn rays(engine: &Engine, verdict: &Verdict, open: Option<&OpenAngle>) -> Vec<Ray> {
    let mut together: BTreeMap<(Turn, BigRational), Vec<(Source, BigRational)>> = BTreeMap::new();
    let terms = verdict.sources.iter().zip(verdict.sum.terms());
    for (source, term) in terms.filter(|(_, term)| !term.weight.is_zero()) {
        let angle = if term.weight.is_negative() { term.angle.opposite() } else { term.angle.clone() };
        let turns = open.map(|open| open.enters_vector(*source, verdict)).unwrap_or_default();
        together.entry((angle, turns)).or_default().push((*source, term.weight.abs()));
    }
    let labelled = together.len() <= MOST_LABELS;
    let label = |members: &[(Source, BigRational)]| match labelled {
        true => label(engine, members.iter().map(|(source, _)| *source)),
        false => String::new(),
    };
    let ray = |((angle, turns), members): ((Turn, BigRational), Vec<(Source, BigRational)>)| Ray {
        label: label(&members),
        degrees: decimal(&angle.degrees()),
        turns: decimal(&turns),
        lengths: members.iter().map(|(_, length)| decimal(length)).collect(),
        length: decimal(&members.iter().map(|(_, length)| length).sum()),
    };
    together.into_iter().map(ray).collect()
}

/// Values of the open angle at which the longest sum is looked for.
const SAMPLES: u32 = 72;

/// The longest arrow of two stars; of sums that an open angle changes the longest that is found.
fn reach(senses: &[MovingSense; 2], open: Option<&OpenAngle>) -> f64 {
    let moved = |by: f64| {
        senses.iter().map(move |sense| {
            // With the same last digit on every machine, as all that stands in a page.
            let vector = |ray: &Ray| {
                let (sin, cos) = libm::sincos((ray.degrees + ray.turns * by).to_radians());
                Complex::new(cos, sin) * ray.length
            };
            numbers::length(sense.rays.iter().map(vector).sum())
        })
    };
    let samples = (0..SAMPLES).filter(|_| open.is_some()).map(|sample| f64::from(sample) * 720.0 / f64::from(SAMPLES));
    let rays = senses.iter().flat_map(|sense| sense.rays.iter().map(|ray| ray.length).chain([sense.length]));
    rays.chain(samples.flat_map(moved)).fold(0.0, f64::max)
}

/// More rays than this are drawn without labels.
const MOST_LABELS: usize = 36;
/// More masses that turn than this have no room beside a vector.
const MOST_LABELLED: usize = 2;

/// `1, 4–7`, `1, rod 1`, `1–4, +6`.
fn label(engine: &Engine, sources: impl Iterator<Item = Source>) -> String {
    let (pistons, others): (Vec<Source>, Vec<Source>) = sources.partition(|source| source.piston().is_some());
    let labels = |sources: &[Source]| -> Vec<String> { sources.iter().map(|source| source.label(engine)).collect() };
    let pistons = labels(&pistons);
    let pistons = typeset::names(&pistons.iter().map(String::as_str).collect::<Vec<_>>());
    let others = if others.len() > MOST_LABELLED { vec![format!("+{}", others.len())] } else { labels(&others) };
    (!pistons.is_empty()).then_some(pistons).into_iter().chain(others).collect::<Vec<_>>().join(", ")
}
