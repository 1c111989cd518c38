//! How are the firing stars of a sweep shown? What is zero and what is longest, where each vanishes, every point.

use super::super::firing::plot_of_stars;
use super::super::plot::Curve;
use super::super::plot::stack::stacked;
use super::super::typeset;
use super::amounts::{self, number_of, place_cells, place_headings};
use super::findings::{Extreme, listed};
use super::plots::over;
use super::tables::places_of_zeros;
use crate::engine::CycleOrder;
use crate::numbers::float;
use crate::page::figure::Figure;
use crate::page::{Block, Picture, Table, Text, phrase};
use crate::report::texts::sweep as text;
use crate::sweep::{Amplitude, FiringSweep, FiringZeros, StarLength, Sweep, SweptEngine};

/// More points than this are left to the table in CSV.
const MOST_ROWS: usize = 200;
/// More curves than this stand not in one plot.
const MOST_CURVES: usize = 3;
/// More exact zeros of an order than this are not marked.
const MOST_MARKS: usize = 60;

/// A sentence per order, and the table of zeros.
pub(super) fn answer(sweep: &Sweep) -> Vec<Block> {
    let Some(firing) = &sweep.firing else { return Vec::new() };
    let sentences = (0..firing.orders.len()).map(|place| Block::Paragraph(sentence(sweep, firing, place)));
    sentences.chain(zeros(sweep, firing).map(Block::from)).collect()
}

/// All that a page tells of them.
pub(super) fn section(sweep: &Sweep) -> Vec<Block> {
    let Some(firing) = &sweep.firing else { return Vec::new() };
    let mut blocks = answer(sweep);
    blocks.push(text::firing_star().into());
    blocks.extend(picture(sweep, firing).map(Block::from));
    if sweep.points.len() <= MOST_ROWS {
        let summary = text::firing_stars_at_points(sweep.points.len());
        blocks.push(Block::folded(summary, vec![points(sweep, firing).into()]));
    }
    blocks
}

fn sentence(sweep: &Sweep, firing: &FiringSweep, place_of: usize) -> Text {
    let order = firing.orders[place_of].to_string();
    let known = firing.points.iter().zip(&sweep.points);
    let lengths: Vec<(Amplitude, &SweptEngine)> =
        known.filter_map(|(stars, point)| Some((stars[place_of].amplitude()?, point))).collect();
    let count = |of: StarLength| firing.points.iter().filter(|stars| stars[place_of] == of).count();
    let (several, open) = (count(StarLength::OfSeveralRods), count(StarLength::NotDecided));
    if open > 0 {
        return text::torque_undecided(order, open, firing.points.len());
    }
    if several > 0 {
        let vanishing = lengths.iter().filter(|(length, _)| length.vanishes).count();
        return text::torque_of_several_rods(order, Text::zero(), several, firing.points.len(), vanishing);
    }
    let set = firing.zeros.as_ref().map(|zeros| &zeros[place_of]);
    let Some([greatest, least]) = Extreme::of(&lengths) else {
        return match set {
            Some(FiringZeros { everywhere: true, .. }) => everywhere(firing.orders[place_of]),
            _ => text::torque_never_fired(order),
        };
    };
    let exact = |set: &FiringZeros| listed(amounts::zeros(&sweep.parameters[0], &set.at, &set.irrational));
    match set {
        Some(FiringZeros { everywhere: true, .. }) => everywhere(firing.orders[place_of]),
        None if greatest.amplitude.vanishes => everywhere(firing.orders[place_of]),
        Some(set) if set.complete && greatest.amplitude.vanishes => {
            text::torque_zeros_alone(order, Text::zero(), exact(set))
        }
        Some(set) if set.complete && !(set.at.is_empty() && set.irrational.is_empty()) => {
            text::torque_zeros(order, Text::zero(), exact(set), number_of(greatest.amplitude), greatest.listed(sweep))
        }
        _ if greatest.is_at_all(&lengths) && least.is_at_all(&lengths) => {
            let is_everywhere = greatest.is_everywhere(sweep);
            text::torque_alike(order, number_of(greatest.amplitude), is_everywhere)
        }
        _ => text::torque_from_to(
            order,
            number_of(least.amplitude),
            least.listed(sweep),
            number_of(greatest.amplitude),
            greatest.listed(sweep),
        ),
    }
}

fn everywhere(order: CycleOrder) -> Text {
    match order.is_whole() {
        true => text::torque_vanishes(order.to_string(), Text::zero()),
        false => text::torque_vanishes_where_fired(order.to_string(), Text::zero()),
    }
}

/// Where each star vanishes, for one angle.
fn zeros(sweep: &Sweep, firing: &FiringSweep) -> Option<Table> {
    let parameter = sweep.parameters.first()?;
    let mut table = Table::new(["Order κ", "The firing star vanishes at"]);
    for zeros in firing.zeros.as_ref()? {
        let places = amounts::zeros(parameter, &zeros.at, &zeros.irrational);
        let cell = match zeros.fires {
            true => places_of_zeros(places, zeros.everywhere, zeros.complete),
            false => "cannot be fired".into(),
        };
        table.push(vec![zeros.order.to_string().into(), cell]);
    }
    Some(table)
}

/// The length of each star at every point.
fn points(sweep: &Sweep, firing: &FiringSweep) -> Table {
    let orders = firing.orders.iter().map(|order| phrase!("Order {}", order.to_string()));
    let mut table = Table::new(place_headings(sweep).chain(orders));
    for (point, stars) in sweep.points.iter().zip(&firing.points) {
        let cells = stars.iter().map(|star| match star {
            StarLength::NotFired => "–".into(),
            StarLength::NotDecided => "not decided".into(),
            StarLength::OfSeveralRods => "not 0".into(),
            StarLength::Of(amplitude) => number_of(*amplitude),
        });
        table.push(place_cells(point).chain(cells).collect());
    }
    table
}

/// The stars over one parameter, those that do not vanish everywhere.
fn picture(sweep: &Sweep, firing: &FiringSweep) -> Option<Picture> {
    let is_left = |place: &usize| {
        firing.curve.iter().any(|(_, stars)| stars[*place].amplitude().is_some_and(|star| !star.vanishes))
    };
    let drawn: Vec<usize> = (0..firing.orders.len()).filter(is_left).collect();
    if sweep.points.len() < 2 || drawn.is_empty() {
        return None;
    }
    let plots = drawn.chunks(MOST_CURVES).map(|chunk| plot(sweep, firing, chunk)).collect();
    Some(Picture::new("firing-stars", text::firing_stars_drawn(), stacked(plots)))
}

fn plot(sweep: &Sweep, firing: &FiringSweep, orders: &[usize]) -> Figure {
    let names: Vec<String> = orders.iter().map(|&place| firing.orders[place].to_string()).collect();
    let mut plot = plot_of_stars(&names, over(sweep, &sweep.parameters[0]));
    let height = |star: StarLength| star.amplitude().map_or(f64::NAN, |star| star.value);
    for (number, (&place, name)) in orders.iter().zip(names).enumerate() {
        let points = firing.curve.iter().map(|(at, stars)| (float(at), height(stars[place]))).collect();
        let curve = Curve::new(number, format!("order {name}"), points);
        let zeros = firing.zeros.iter().flat_map(|zeros| &zeros[place].at);
        for zero in zeros.take(MOST_MARKS) {
            plot.ring_zero(float(zero), typeset::degrees(zero), curve.ink, "exact zero");
        }
        plot.curves.push(curve);
    }
    plot.figure()
}
