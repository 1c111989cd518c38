//! How is a judged piece written down, and what is believed of one that is read?

use num_bigint::BigUint;
use serde::{Deserialize, Serialize};

use super::front::StarValues;
use super::judged;
use super::plan::Plan;
use super::problem::Problem;
use super::space::Space;
use super::tables::Tables;
use super::walk::Counts;
use crate::shard::Question;

/// A judged piece.
#[derive(Clone, Debug, Default)]
pub(super) struct Done {
    /// The stars it adds to the front, with their counts.
    pub points: Vec<StarValues>,
    /// What it came to.
    pub counts: Counts,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenPiece {
    judged: u64,
    cut: u64,
    stars: Vec<WrittenStar>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenStar {
    throws: Vec<u16>,
    /// Where minor orders are compared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    firing_order: Option<Vec<usize>>,
    classes: u64,
    stars: u64,
}

/// What a piece is a part of: files of other questions, and of other ways to cut them into pieces, are refused.
pub(super) fn question(problem: &Problem, plan: &Plan) -> Question {
    let vee = problem.bank_angle.as_ref().map_or(String::new(), |angle| format!(", V {} turn", angle.turns()));
    let directions = problem.directions.map_or(String::new(), |count| format!(", {count} directions"));
    let grid = problem.grid.map_or(String::new(), |grid| format!(", grid {grid}"));
    let neighbours = if problem.neighbours { ", neighbours" } else { "" };
    let (cycle, cylinders, orders) = (problem.cycle.word(), problem.cylinders, &problem.orders);
    let (way, pieces) = (plan.name(), plan.len());
    let split = problem.pin_split.as_ref().map_or(String::new(), |split| format!(", split {} turn", split.turns()));
    let offset = problem.bank_offset.as_ref().map_or(String::new(), |offset| format!(", offset {offset}"));
    let (split, minor) = (split + &offset, minor(problem));
    let words = format!(
        "search 4: {cylinders} cylinders, {cycle}{vee}{split}{directions}{grid}{neighbours}{minor}, orders {orders:?}, by {way}"
    );
    Question { words, pieces }
}

/// The minor orders that are compared, and the mode that weighs them.
fn minor(problem: &Problem) -> String {
    if problem.minor_orders.is_empty() {
        return String::new();
    }
    let listed = |values: &mut dyn Iterator<Item = String>| values.collect::<Vec<_>>().join(" ");
    let orders = listed(&mut problem.minor_orders.iter().map(|order| order.exact().to_string()));
    let shape = problem.mode_shape.iter().flatten().map(ToString::to_string);
    format!(", minor orders {orders} by [{}]", listed(&mut shape.into_iter()))
}

/// A piece as it was written, if it can have come of this piece.
pub(super) fn read(text: &[u8], number: usize, plan: &Plan, space: &Space, tables: &Tables) -> Option<Done> {
    let written: WrittenPiece = serde_json::from_slice(text).ok()?;
    let counts = Counts { judged: written.judged, cut: written.cut };
    let mut points: Vec<StarValues> = Vec::new();
    let mut classes = 0_u64;
    for star in &written.stars {
        let is_here = space.holds(&star.throws) && plan.holds(number, space, &star.throws);
        // A class of rotation, mirror and reversal holds up to four stars with cylinder 1 at 0.
        let is_counted = star.classes > 0 && (star.classes..=star.classes.checked_mul(4)?).contains(&star.stars);
        let of_star = is_here.then(|| judged::judge(space, tables, &star.throws))?;
        let point = of_star.into_iter().find(|point| point.firing_order == star.firing_order)?;
        let is_new = points.iter().all(|known| known.compare(&point).is_none());
        points.push((is_counted && is_new).then_some(StarValues {
            classes: star.classes,
            stars: star.stars,
            ..point
        })?);
        // By its firing orders, or those of its images, a star may be at several points.
        classes =
            if space.gives_one_point() { classes.checked_add(star.classes)? } else { classes.max(star.classes / 4) };
    }
    (classes <= counts.judged && is_possible(counts, space)).then_some(Done { points, counts })
}

/// Whether this many stars and starts exist.
pub(super) fn is_possible(counts: Counts, space: &Space) -> bool {
    let all = space.count();
    BigUint::from(counts.judged) <= all && BigUint::from(counts.cut) <= all * (space.pairs() + 1)
}

/// A piece as text.
pub(super) fn text(done: &Done) -> Result<String, serde_json::Error> {
    let star = |point: &StarValues| WrittenStar {
        throws: point.throws.clone(),
        firing_order: point.firing_order.clone(),
        classes: point.classes,
        stars: point.stars,
    };
    let stars = done.points.iter().map(star).collect();
    serde_json::to_string(&WrittenPiece { judged: done.counts.judged, cut: done.counts.cut, stars })
}
