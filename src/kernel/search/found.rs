//! What is known of a star that was found? Throws, firing order, exact moments, and the engine as a layout file.

use std::cmp::Ordering;
use std::fmt::Write;

use num_rational::BigRational;

use super::front::StarValues;
use super::problem::Problem;
use super::vee::Bank;
use super::{firing, mode_shape};
use crate::engine::{self, BuildError, Cycle, CycleOrder, Cylinder, Draft, Engine, Firing};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{self, Form};
use crate::order;
use crate::proof::Sense;

/// The moment of one order: a vector `|C|`, in m r ω² c_k times the spacing, of the direct and of the reverse sense.
#[derive(Clone, Debug)]
pub struct Moment {
    /// The order.
    pub order: u32,
    /// Direct or reverse; `None` for an in-line engine, where both are equally long.
    pub sense: Option<Sense>,
    /// The sum itself, `Σ z e^{iφ}`.
    pub sum: PhasorSum,
    /// Its length in decimals.
    pub decimal: f64,
}

impl Moment {
    /// Its length in closed form, where one is short enough to read.
    pub fn modulus(&self) -> Option<Form> {
        numbers::modulus(&self.sum)
    }
}

/// A star on the front, with all that share its values counted.
#[derive(Clone, Debug)]
pub struct FoundStar {
    /// Angles of the throws along the shaft, from the free end.
    pub throws: Vec<Turn>,
    /// Cylinders, counted from 0, in the order in which they fire; `None` where the engine cannot fire evenly.
    pub firing_order: Option<Vec<usize>>,
    /// Pairs of neighbours in a bank that fire in succession, the least where the star leaves a choice; `None` where it cannot fire evenly
    /// and the question does not ask for them.
    pub neighbours: Option<usize>,
    /// The moments of the orders asked for.
    pub moments: Vec<Moment>,
    /// The phase-vector sums of the minor orders that are compared, in this firing order.
    pub minor: Vec<(CycleOrder, PhasorSum)>,
    /// Stars with exactly these values, up to rotation, mirror and reversal; `None` where a theorem gave the star and nobody counted them.
    pub classes: Option<u64>,
    /// Stars with exactly these values and cylinder 1 at 0; `None` as there.
    pub stars: Option<u64>,
    pub(super) by_theorem: bool,
}

impl FoundStar {
    pub(super) fn new(problem: &Problem, point: &StarValues) -> Self {
        let (directions, _) = problem.supply();
        let throws: Vec<Turn> =
            point.throws.iter().map(|&throw| Turn::fraction(throw.into(), directions.into())).collect();
        let banks = problem.banks();
        let fired = match &point.firing_order {
            Some(order) => Some((order.clone(), firing::in_succession(order, throws.len()))),
            None => firing::even_steps(&problem.dead_centres_of(&throws), problem)
                .map(|steps| firing::best_order(&steps.iter().map(Vec::as_slice).collect::<Vec<_>>(), throws.len())),
        };
        // Uneven stars have neighbours too, but no firing order.
        let asked = problem.neighbours.then_some(point.neighbours);
        let neighbours = fired.as_ref().map(|(_, count)| *count).or(asked);
        let shape = mode_shape::deflections(problem, problem.mode_shape.clone()).unwrap_or_default();
        let sum =
            |order: &CycleOrder| fired.as_ref().map(|(fired, _)| mode_shape::sum(fired, problem.cycle, &shape, *order));
        let minor = problem.minor_orders.iter().filter_map(|order| Some((*order, sum(order)?))).collect();
        let moments = problem.orders.iter().flat_map(|&order| moments(&throws, &banks, order)).collect();
        let firing_order = fired.map(|(order, _)| order);
        let counted = |count: u64| (point.classes > 0).then_some(count);
        let (classes, stars) = (counted(point.classes), counted(point.stars));
        FoundStar { throws, firing_order, neighbours, moments, minor, classes, stars, by_theorem: false }
    }

    /// The engine as the text of a layout file, which every other command reads.
    pub fn layout_file(&self, problem: &Problem) -> String {
        let quoted: Vec<String> = self.throws.iter().map(|throw| format!("\"{} turn\"", throw.turns())).collect();
        let form = if problem.bank_angle.is_some() { "vee" } else { "inline" };
        let mut text = format!("title = \"{}\"\ncycle = \"{}\"\n", self.title(problem), problem.cycle.word());
        if let Some(order) = &self.firing_order {
            let _ = writeln!(text, "firing_order = \"{}\"", dashed(order));
        }
        let _ = writeln!(text, "\n[{form}]\nthrows = [{}]", quoted.join(", "));
        if let Some(angle) = &problem.bank_angle {
            let _ = writeln!(text, "bank_angle = \"{} turn\"", angle.turns());
        }
        if let Some(split) = &problem.pin_split {
            let _ = writeln!(text, "pin_split = \"{} turn\"", split.turns());
        }
        if let Some(offset) = &problem.bank_offset {
            let _ = writeln!(text, "bank_offset = \"{offset}\"");
        }
        text
    }

    /// What the engine is called.
    fn title(&self, problem: &Problem) -> String {
        let name = name(problem);
        if self.by_theorem { format!("{name}, by a theorem") } else { format!("{name} found by search") }
    }

    /// The engine: the one that [`FoundStar::layout_file`] describes.
    ///
    /// # Errors
    /// What does not fit, where the star is none of the question.
    pub fn engine(&self, problem: &Problem) -> Result<Engine, BuildError> {
        let mut draft = Draft::new(&self.title(problem));
        draft.form = if problem.bank_angle.is_some() { engine::Form::Vee } else { engine::Form::Inline };
        for bank in &problem.banks() {
            let pins = self.throws.iter().enumerate();
            let cylinder = |(pin, throw): (usize, &Turn)| {
                Cylinder::new(throw + &bank.split, bank.axis.clone(), arm(pin, self.throws.len()) + &bank.offset, pin)
            };
            draft.cylinders.extend(pins.map(cylinder));
        }
        draft.positions_given = self.throws.len() == 1;
        draft.cycle = Some(problem.cycle);
        draft.firing = match &self.firing_order {
            Some(order) => Some(firing::even(order, problem.cycle)),
            None if problem.cycle == Cycle::TwoStroke => Some(Firing::two_stroke(&draft.cylinders)),
            None => None,
        };
        draft.build()
    }
}

/// Distance of a throw from the middle of this many, one spacing apart, the first at the free end.
fn arm(place: usize, throws: usize) -> BigRational {
    BigRational::new((throws as i64 - 1 - 2 * place as i64).into(), 2.into())
}

/// `1-3-4-2`.
pub(super) fn dashed(order: &[usize]) -> String {
    order.iter().map(|cylinder| (cylinder + 1).to_string()).collect::<Vec<_>>().join("-")
}

/// An angle of up to half a turn either way, in degrees.
fn signed(angle: &Turn) -> BigRational {
    let degrees = angle.degrees();
    let half = BigRational::from_integer(180.into());
    if degrees > half { degrees - half * BigRational::from_integer(2.into()) } else { degrees }
}

/// `In-line 6` or `V8, 90°`, with split and offset where there are any.
pub(super) fn name(problem: &Problem) -> String {
    match &problem.bank_angle {
        Some(angle) => {
            let split = problem.pin_split.as_ref().map(|split| format!(", pins split by {}°", signed(split)));
            let offset = problem.bank_offset.as_ref().map(|offset| format!(", banks offset by {offset}"));
            let more = [split, offset].into_iter().flatten().collect::<String>();
            format!("V{}, {}°{more}", problem.cylinders, angle.degrees())
        }
        None => format!("In-line {}", problem.cylinders),
    }
}

/// The vectors of an order: one for an in-line engine, direct and reverse for a V.
fn moments(throws: &[Turn], banks: &[Bank], order: u32) -> Vec<Moment> {
    let moment = |sense: Option<Sense>| {
        // Without banks both vectors are alike.
        let angle = |throw: &Turn, bank: &Bank| {
            order::phase_of(&(throw + &bank.split), &bank.axis, order, sense.or(Some(Sense::Direct)))
        };
        let places = throws.iter().enumerate();
        let terms = places.flat_map(|(place, throw)| {
            let term =
                move |bank: &Bank| Term { angle: angle(throw, bank), weight: arm(place, throws.len()) + &bank.offset };
            banks.iter().map(term).collect::<Vec<_>>()
        });
        let sum = PhasorSum::new(terms.collect());
        let decimal = numbers::evaluate(&sum).norm();
        Moment { order, sense, sum, decimal }
    };
    match banks.len() {
        1 => vec![moment(None)],
        _ => vec![moment(Some(Sense::Direct)), moment(Some(Sense::Reverse))],
    }
}

/// How a star stands to a front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// It shares the values of a star of the front.
    On,
    /// A star of the front is no worse in anything and better in something.
    Beaten,
}

/// The place of a star among those of a front: on it, if one of its firing orders is.
pub(super) fn standing(front: &[StarValues], points: &[StarValues]) -> Standing {
    let is_there = |point: &StarValues| front.iter().any(|other| other.compare(point) == Some(Ordering::Equal));
    if points.iter().any(is_there) { Standing::On } else { Standing::Beaten }
}
