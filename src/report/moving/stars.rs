//! Which vectors turn in each order, what do they sum to, and how is that put?

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::super::engine_page::Weighed;
use super::super::star::{self, Star, WholeStars, short_names};
use super::super::{residual, typeset};
use super::open_angle::{OpenAngle, decimal};
use super::scene::{MovingOrder, MovingQuantity, MovingSense, Ray, ZERO};
use crate::engine::Engine;
use crate::exact::Turn;
use crate::numbers;
use crate::order::Source;
use crate::page::Units;
use crate::proof::{Planar, Sense};
use crate::verdict::{Judgement, OrderBalance, OrderVerdict, Verdict};

/// The orders that are decided; none of those whose parts have coefficients of their own that are not known.
pub(super) fn orders(
    engine: &Engine,
    judged: &Judgement,
    weighed: Option<&Weighed>,
    open: Option<&OpenAngle>,
) -> Vec<MovingOrder> {
    let whole = weighed.map(WholeStars::new);
    let of_order = |order: &OrderVerdict| match order.parts.as_slice() {
        [only] if only.class.is_none() => Some(of_one_sum(engine, order, only, weighed, open)),
        _ => Some(of_whole(engine, order, whole.as_ref()?, weighed?)),
    };
    judged.orders.iter().filter_map(of_order).collect()
}

/// An order that is one exact sum in each sense.
fn of_one_sum(
    engine: &Engine,
    order: &OrderVerdict,
    part: &OrderBalance,
    weighed: Option<&Weighed>,
    open: Option<&OpenAngle>,
) -> MovingOrder {
    let quantity = |quantity: Planar, left: String| {
        let balance = part.balance(quantity);
        let senses = balance.verdicts().map(|verdict| sense(engine, verdict, part.exists, open));
        let marks = open.filter(|_| part.exists).map(|open| open.marks(balance)).unwrap_or_default();
        let words = if part.exists && balance.is_balanced() { ZERO.to_owned() } else { left };
        MovingQuantity { words, most: most(order, quantity, weighed), senses, marks }
    };
    MovingOrder {
        order: part.order,
        coefficient: weighed.and_then(|weighed| coefficient(part, weighed)),
        exists: part.exists,
        force: quantity(Planar::Force, residual::force(part).plain()),
        moment: quantity(Planar::Moment, residual::moment(part).plain()),
    }
}

/// An order whose parts have coefficients of their own: its vectors have them.
fn of_whole(engine: &Engine, order: &OrderVerdict, whole: &WholeStars, weighed: &Weighed) -> MovingOrder {
    let exists = order.exists();
    let quantity = |quantity: Planar| {
        let outcome = order.whole(quantity);
        let senses = Sense::BOTH.map(|sense| {
            let (value, _) = whole.resultant(quantity, order.order, sense);
            let rays = whole.rays(quantity, order.order, sense);
            let zero = outcome.outcomes[usize::from(sense == Sense::Reverse)].vanishes() == Some(true);
            let words = if zero { ZERO.to_owned() } else { rounded(value) };
            let rays: Vec<Ray> = rays.iter().map(|one| of_drawn(engine, one)).collect();
            let [length, degrees] = if zero { [0.0, 0.0] } else { polar(2.0 * value) };
            MovingSense { words, zero, reach: reach(&rays, length, None), rays, length, degrees, zeros: None }
        });
        let most = most(order, quantity, Some(weighed));
        let words = match most {
            _ if exists && outcome.is_balanced() => ZERO.to_owned(),
            Some(_) => residual::beside_size(outcome).plain(),
            None => residual::whole_text(outcome).plain(),
        };
        MovingQuantity { words, most, senses, marks: Vec::new() }
    };
    let (force, moment) = (quantity(Planar::Force), quantity(Planar::Moment));
    MovingOrder { order: order.order, coefficient: Some([1.0, 0.0]), exists, force, moment }
}

/// A ray of a drawing, whose vectors are halved.
fn of_drawn(engine: &Engine, ray: &star::Ray) -> Ray {
    let [_, degrees] = polar(ray.direction);
    Ray {
        label: ray.name.clone().unwrap_or_else(|| short_names(engine, ray.members.iter().map(|(source, _)| *source))),
        degrees,
        turns: 0.0,
        lengths: ray.members.iter().map(|(_, length)| in_places(2.0 * length)).collect(),
        length: in_places(2.0 * ray.length()),
    }
}

/// What the sums of an order are multiplied by: read from one that is left; of an order without any it does not matter.
fn coefficient(part: &OrderBalance, weighed: &Weighed) -> Option<[f64; 2]> {
    for quantity in Planar::BOTH {
        let (balance, swing) = (part.balance(quantity), weighed.swing(part.order, quantity)?);
        let value = match (balance.direct.vanishes(), balance.reverse.vanishes()) {
            (false, _) => swing.direct.value / numbers::evaluate(&balance.direct.sum),
            (true, false) => (swing.reverse.value / numbers::evaluate(&balance.reverse.sum)).conj(),
            (true, true) => continue,
        };
        return Some(polar(value));
    }
    Some([0.0, 0.0])
}

/// Length, and direction in degrees.
fn polar(value: Complex<f64>) -> [f64; 2] {
    let degrees = in_places(numbers::degrees(value));
    [in_places(numbers::length(value)), if degrees == -180.0 { 180.0 } else { degrees }]
}

/// Sines differ in their last digit between machines, and pages do not.
fn in_places(value: f64) -> f64 {
    (value * 1e9).round() / 1e9 + 0.0
}

/// `together at most 1.17 m r ω²`.
fn most(order: &OrderVerdict, quantity: Planar, weighed: Option<&Weighed>) -> Option<String> {
    weighed?.together(order.order, quantity, Units::Si).map(|[plain, _]| plain)
}

/// The resultant in decimals.
fn rounded(value: Complex<f64>) -> String {
    let (length, angle) = (numbers::length(value), numbers::degrees(value));
    format!("resultant {}, angle {}° at θ = 0", typeset::approximate(length), typeset::approximate(angle))
}

fn sense(engine: &Engine, verdict: &Verdict, exists: bool, open: Option<&OpenAngle>) -> MovingSense {
    let sum = numbers::evaluate(&verdict.sum);
    let words = match verdict.vanishes() {
        true => ZERO.to_owned(),
        false => {
            let half = residual::modulus_of(&verdict.sum.scaled(&star::part_felt(verdict.quantity)));
            format!("resultant {}, angle {} at θ = 0", half.plain(), residual::bearing(&verdict.sum).plain())
        }
    };
    let (rays, length) = (rays(engine, verdict, open), numbers::length(sum));
    MovingSense {
        words,
        zero: verdict.vanishes(),
        reach: reach(&rays, length, open),
        rays,
        length,
        degrees: numbers::degrees(sum),
        zeros: open.filter(|_| exists).and_then(|open| open.zeros_of(verdict)),
    }
}

/// The vectors that stay in one direction together, whatever the open angle is.
fn rays(engine: &Engine, verdict: &Verdict, open: Option<&OpenAngle>) -> Vec<Ray> {
    let star = Star::of(engine, verdict);
    if star.by_crank && open.is_none() {
        return star.rays.iter().map(|one| of_drawn(engine, one)).collect();
    }
    let mut together: BTreeMap<(Turn, BigRational), Vec<(Source, BigRational)>> = BTreeMap::new();
    let terms = verdict.sources.iter().zip(verdict.sum.terms());
    for (source, term) in terms.filter(|(_, term)| !term.weight.is_zero()) {
        let angle = if term.weight.is_negative() { term.angle.opposite() } else { term.angle.clone() };
        let turns = open.map(|open| open.enters_vector(*source, verdict)).unwrap_or_default();
        together.entry((angle, turns)).or_default().push((*source, term.weight.abs()));
    }
    let labelled = together.len() <= MOST_LABELS;
    let label = |members: &[(Source, BigRational)]| match labelled {
        true => short_names(engine, members.iter().map(|(source, _)| *source)),
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

/// The longest arrow of a star; of a sum that an open angle changes the longest that is found.
fn reach(rays: &[Ray], length: f64, open: Option<&OpenAngle>) -> f64 {
    let moved = |by: f64| {
        // With the same last digit on every machine, as all that is in a page.
        let vector = |ray: &Ray| {
            let (sin, cos) = libm::sincos((ray.degrees + ray.turns * by).to_radians());
            Complex::new(cos, sin) * ray.length
        };
        numbers::length(rays.iter().map(vector).sum())
    };
    let samples = (0..SAMPLES).filter(|_| open.is_some()).map(|sample| f64::from(sample) * 720.0 / f64::from(SAMPLES));
    rays.iter().map(|ray| ray.length).chain([length]).chain(samples.map(moved)).fold(0.0, f64::max)
}

/// More rays than this are drawn without labels.
const MOST_LABELS: usize = 36;
