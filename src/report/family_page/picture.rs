//! How large is each order over an open angle, and where is it exactly zero? Curves in floats, zeros from the verdicts.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::super::typeset;
use super::sizes::Sizes;
use super::unknowns::only_open_angle;
use crate::engine::{Family, Linear, PHI};
use crate::exact::Turn;
use crate::family::{OpenOrder, OpenVerdict, Solutions, Zeros, phase};
use crate::numbers::float;
use crate::page::figure::Figure;
use crate::page::plot::{Axis, Curve, Plot, PointMark, stacked};
use crate::page::{Choice, Text};
use crate::proof::{Planar, Sense};
use crate::report::texts::family as text;

/// Steps of a turn of the open angle.
const STEPS: i64 = 720;
/// More orders of force, or of moment, than this are not drawn; and more than this stand not in one plot.
const MOST_ORDERS: usize = 9;
const MOST_CURVES: usize = 3;
/// More points than this at which one vector vanishes are not marked.
const MOST_DOTS: usize = 24;

/// The amplitude of each order over the one open angle, φ or δ, in 0° to 360°: plots of the force, then of the moment.
///
/// Rings on the axis are the exact zeros of the verdicts, dots the angles at which just one vector is exactly zero. Orders
/// that vanish for all angles are not drawn. `None` where no angle or two are open, or nothing is left to draw. The moment is
/// drawn where its arms are known, or multiples of one open length, which is the unit then.
pub fn amplitudes(family: &Family, orders: &[OpenOrder]) -> Option<Figure> {
    let unknown = only_open_angle(family)?;
    let axis_name = axis_name(family, unknown);
    let mut plots = Vec::new();
    let sizes = sizes(family, orders);
    for (quantity, curves) in shown(family, orders) {
        let unit = unit(family, sizes.as_ref(), quantity)?;
        let axis = match quantity {
            Planar::Force => format!("Force in {unit}"),
            Planar::Moment => format!("Moment in {unit}"),
        };
        // At their sizes all are in one plot; else as many plots as needed, with about as many curves in each.
        let in_each = match &sizes {
            Some(_) => curves.len().max(1),
            None => curves.len().div_ceil(curves.len().div_ceil(MOST_CURVES).max(1)).max(1),
        };
        for chunk in curves.chunks(in_each) {
            let x = Axis::angle(axis_name, 0.0, 360.0, 30);
            let mut plot = Plot::new(heading(quantity, chunk), x, Axis::amplitude(axis.clone()));
            for (order, verdicts) in chunk {
                let scale = sizes.as_ref().map_or(1.0, |sizes| sizes.coefficient(*order));
                add(&mut plot, family, unknown, (*order, scale), verdicts);
            }
            plots.push(plot.figure());
        }
    }
    (!plots.is_empty()).then(|| stacked(plots))
}

/// Which open angle it is, of bank angle φ, angle φ, pin split δ and angle δ: φ is the bank angle where it turns banks, δ a pin split
/// where it turns parts of a pin.
fn kind_of_angle(family: &Family, unknown: &str) -> usize {
    match unknown == PHI {
        true if family.has_open_banks() => 0,
        true => 1,
        false if family.has_open_splits() => 2,
        false => 3,
    }
}

/// For a place such as `{bank angle φ|angle φ|pin split δ|angle δ}`.
pub(in crate::report) fn which_angle(family: &Family, unknown: &str) -> Choice {
    Choice::of(kind_of_angle(family, unknown))
}

/// What the axis of an open angle is called.
pub(in crate::report) fn axis_name(family: &Family, unknown: &str) -> &'static str {
    ["Bank angle φ in °", "Angle φ in °", "Pin split δ in °", "Angle δ in °"][kind_of_angle(family, unknown)]
}

/// What the drawing of [`amplitudes`] shows.
pub fn amplitudes_caption(family: &Family, orders: &[OpenOrder]) -> Option<Text> {
    let unknown = only_open_angle(family)?;
    let drawn = shown(family, orders);
    let mut words = vec![text::largest_over_angle(which_angle(family, unknown))];
    let sizes = sizes(family, orders);
    words.extend(sizes.as_ref().map(|sizes| text::sizes(sizes.circumstances())));
    words.push(text::marks(MOST_DOTS));
    let is_rounded = |place: &Place| !place.is_exact();
    let rounded = |(_, verdicts): &OfOrder| {
        let (full, single) = zeros(verdicts, unknown);
        full.iter().any(is_rounded) || single.len() <= MOST_DOTS && single.iter().any(is_rounded)
    };
    if drawn.iter().flat_map(|(_, curves)| curves).any(rounded) {
        words.push(text::irrational_marks());
    }
    for quantity in Planar::BOTH {
        let of = of_quantity(orders, quantity);
        let is_always = |(_, verdicts): &&OfOrder| verdicts.iter().all(OpenVerdict::always);
        let (always, left): (Vec<&OfOrder>, Vec<&OfOrder>) = of.iter().partition(is_always);
        let open = |verdict: &OpenVerdict| !is_solved(verdict, unknown);
        let unsolved: Vec<&OfOrder> = of.iter().filter(|(_, verdicts)| verdicts.iter().any(open)).collect();
        let curves = drawn.iter().find(|(other, _)| *other == quantity).map_or(0, |(_, curves)| curves.len());
        words.extend((!always.is_empty()).then(|| text::zero_for_all(quantity, numbers(&always))));
        words.extend((!unsolved.is_empty()).then(|| text::unsolved(quantity, numbers(&unsolved))));
        let sized = sizes.as_ref().filter(|_| unit(family, sizes.as_ref(), quantity).is_some());
        let small = sized.map_or_else(Vec::new, |sizes| sizes.told(quantity, orders).1);
        words.extend((!small.is_empty()).then(|| text::too_small(quantity, typeset::listed(&small))));
        if unit(family, sizes.as_ref(), quantity).is_none() {
            // A force has no arms.
            words.push(text::several_lengths());
        } else if curves + small.len() < left.len() {
            words.push(text::not_drawn(quantity, numbers(&left[curves..])));
        }
    }
    (!drawn.is_empty()).then(|| Text::joined(words, " "))
}

fn numbers(orders: &[&OfOrder]) -> String {
    typeset::listed(orders.iter().map(|(order, _)| order))
}

type OfOrder<'a> = (u32, &'a [OpenVerdict; 2]);

fn of_quantity(orders: &[OpenOrder], quantity: Planar) -> Vec<OfOrder<'_>> {
    orders.iter().map(|order| (order.order, order.verdicts(quantity))).collect()
}

fn sizes<'a>(family: &'a Family, orders: &[OpenOrder]) -> Option<Sizes<'a>> {
    Sizes::new(family, orders.iter().map(|order| order.order).max()?)
}

/// What is drawn: the orders that do not always vanish, of quantities whose weights are numbers.
fn shown<'a>(family: &Family, orders: &'a [OpenOrder]) -> Vec<(Planar, Vec<OfOrder<'a>>)> {
    let sizes = sizes(family, orders);
    let left = |quantity| {
        let small = sizes.as_ref().map_or_else(Vec::new, |sizes| sizes.told(quantity, orders).1);
        let curves = of_quantity(orders, quantity).into_iter().filter(|(order, _)| !small.contains(order));
        let curves = curves.filter(|(_, verdicts)| !verdicts.iter().all(OpenVerdict::always));
        (quantity, curves.take(MOST_ORDERS).collect::<Vec<_>>())
    };
    let drawable =
        |(quantity, curves): &(Planar, Vec<_>)| unit(family, sizes.as_ref(), *quantity).is_some() && !curves.is_empty();
    Planar::BOTH.map(left).into_iter().filter(drawable).collect()
}

/// What the weights of a quantity are multiples of; none where they hold several lengths.
pub(super) fn unit(family: &Family, sizes: Option<&Sizes>, quantity: Planar) -> Option<String> {
    let force = if sizes.is_some() { "m r ω²" } else { "m r ω² c_k" };
    if quantity == Planar::Force {
        return Some(force.to_owned());
    }
    let arms: Vec<Linear> = family.cylinders().iter().map(|cylinder| family.arm(cylinder)).collect();
    let symbols: BTreeSet<&String> = arms.iter().flat_map(|arm| arm.symbols().keys()).collect();
    let is_known = arms.iter().any(|arm| !arm.known().is_zero());
    match (symbols.first(), symbols.len(), is_known) {
        (None, ..) => Some(match family.length_unit() {
            crate::engine::LengthUnit::Metre => format!("{force} · m"),
            crate::engine::LengthUnit::Spacing => format!("{force} a"),
        }),
        (Some(symbol), 1, false) => Some(format!("{force} · {symbol}")),
        _ => None,
    }
}

fn heading(quantity: Planar, chunk: &[OfOrder]) -> String {
    let orders = typeset::listed(chunk.iter().map(|(order, _)| order));
    match (quantity, chunk.len()) {
        (Planar::Force, 1) => format!("Force, order {orders}"),
        (Planar::Force, _) => format!("Force, orders {orders}"),
        (Planar::Moment, 1) => format!("Moment, order {orders}"),
        (Planar::Moment, _) => format!("Moment, orders {orders}"),
    }
}

/// Adds the curve of an order with its zeros, which are points of the curve too.
fn add(plot: &mut Plot, family: &Family, unknown: &str, (order, scale): (u32, f64), verdicts: &[OpenVerdict; 2]) {
    let quantity = verdicts[0].quantity;
    let terms = Sense::BOTH.map(|sense| terms(family, unknown, quantity, order, sense));
    let at = |angle: f64| terms.iter().map(|terms| length(terms, angle)).sum::<f64>() / 2.0 * scale;
    let (full, single) = zeros(verdicts, unknown);
    let grid = (0..=STEPS).map(|step| step as f64 * 360.0 / STEPS as f64);
    let mut points: Vec<(f64, f64)> = grid.map(|angle| (angle, at(angle / 360.0))).collect();
    points.extend(full.iter().map(|zero| (zero.degrees(), 0.0)));
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let curve = Curve::new(plot.curves.len(), format!("order {order}"), points);
    for zero in &full {
        let series = if zero.is_exact() { "exact zero" } else { "zero, irrational" };
        plot.ring_zero(zero.degrees(), zero.label(), curve.ink, series);
    }
    if single.len() <= MOST_DOTS {
        for zero in &single {
            let mark = PointMark::dot((zero.degrees(), at(zero.degrees() / 360.0)), "");
            let series = if zero.is_exact() { "one vector exactly zero" } else { "one vector zero, irrational" };
            plot.marks.push(PointMark { ink: curve.ink, ..mark.of(series) });
        }
    }
    plot.curves.push(curve);
}

/// An angle at which something vanishes.
enum Place {
    Exact(Turn),
    /// In degrees, rounded.
    Irrational(f64),
}

impl Place {
    fn degrees(&self) -> f64 {
        match self {
            Place::Exact(turn) => float(&turn.degrees()),
            Place::Irrational(degrees) => *degrees,
        }
    }

    fn label(&self) -> String {
        match self {
            Place::Exact(turn) => typeset::angle(turn),
            Place::Irrational(degrees) => format!("≈ {}°", typeset::decimal(*degrees)),
        }
    }

    fn is_exact(&self) -> bool {
        matches!(self, Place::Exact(_))
    }
}

/// The angles at which both vectors vanish, and those at which just one does.
fn zeros(verdicts: &[OpenVerdict; 2], unknown: &str) -> (Vec<Place>, Vec<Place>) {
    let [direct, reverse] = verdicts.each_ref().map(|verdict| within_a_turn(verdict, unknown));
    match (verdicts[0].always(), verdicts[1].always()) {
        (true, _) => (places(&reverse, None), Vec::new()),
        (_, true) => (places(&direct, None), Vec::new()),
        _ => {
            let full = direct.exact.intersection(&reverse.exact).map(|at| Place::Exact(Turn::new(at.clone())));
            let mut single = places(&direct, Some(&reverse));
            single.extend(places(&reverse, Some(&direct)));
            single.sort_by(|a, b| a.degrees().total_cmp(&b.degrees()));
            (full.collect(), single)
        }
    }
}

/// Where a vector vanishes; those omitted where the other one may vanish too.
fn places(of: &Solutions, other: Option<&Solutions>) -> Vec<Place> {
    let is_near = |[low, high]: [&BigRational; 2], all: &[[BigRational; 2]]| {
        all.iter().any(|[from, to]| from <= high && low <= to)
    };
    let alone = |at: [&BigRational; 2]| other.is_none_or(|other| !is_near(at, &other.open));
    let exact = of.exact.iter().filter(|at| other.is_none_or(|other| !other.exact.contains(*at)) && alone([at; 2]));
    let apart = |ends: &&[BigRational; 2]| {
        let ends = ends.each_ref();
        alone(ends) && other.is_none_or(|other| !is_near(ends, &other.irrational))
    };
    let middle = |[low, high]: &[BigRational; 2]| {
        let degrees = (low + high) * BigRational::from_integer(180.into());
        Place::Irrational(float(&degrees))
    };
    let exact = exact.map(|at| Place::Exact(Turn::new(at.clone())));
    exact.chain(of.irrational.iter().filter(apart).map(middle)).collect()
}

/// Where a verdict is known to vanish between 0° and 360°, and where it may.
fn within_a_turn(verdict: &OpenVerdict, unknown: &str) -> Solutions {
    let ends = [BigRational::zero(), BigRational::one()];
    match verdict.zeros(unknown, ends.each_ref()) {
        Zeros::At(mut found) => {
            found.exact.retain(|at| !ends.contains(at));
            found
        }
        Zeros::Everywhere | Zeros::NotSolved => Solutions::default(),
    }
}

/// Whether all its zeros are known.
fn is_solved(verdict: &OpenVerdict, unknown: &str) -> bool {
    match verdict.zeros(unknown, [&BigRational::zero(), &BigRational::one()]) {
        Zeros::Everywhere => true,
        Zeros::At(found) => found.open.is_empty(),
        Zeros::NotSolved => false,
    }
}

/// The vectors of an order: multiple of the open angle, known angle in turns, weight; those of one angle together.
fn terms(family: &Family, unknown: &str, quantity: Planar, order: u32, sense: Sense) -> Vec<(f64, f64, f64)> {
    let mut sums: BTreeMap<(BigRational, Turn), BigRational> = BTreeMap::new();
    for cylinder in family.cylinders() {
        let phase = phase(cylinder, order, sense);
        let arm = family.arm(cylinder);
        let arm = arm.symbols().values().fold(arm.known().clone(), |sum, coefficient| sum + coefficient);
        let arm = if quantity == Planar::Moment { arm } else { BigRational::one() };
        let key = (phase.coefficient(unknown), Turn::new(phase.known().clone()));
        *sums.entry(key).or_insert_with(BigRational::zero) += cylinder.weight() * arm;
    }
    let term = |((times, angle), weight): (&(BigRational, Turn), &BigRational)| {
        (float(times), float(angle.turns()), float(weight))
    };
    sums.iter().map(term).collect()
}

/// The length of the sum at an angle in turns.
fn length(terms: &[(f64, f64, f64)], angle: f64) -> f64 {
    let vector = |(times, known, weight): &(f64, f64, f64)| {
        num_complex::Complex::from_polar(1.0, TAU * (known + times * angle)) * weight
    };
    terms.iter().map(vector).sum::<num_complex::Complex<f64>>().norm()
}
