//! What follows from the lengths of links on a master rod? The ratios κ = a/l and r/L, line by line.

use num_traits::ToPrimitive;

use super::expression::{Expression, Line, fraction, quantity};
use crate::engine::{Engine, Given, Measure};

/// The lines of all links; once where the file says the same of all.
pub(super) fn lines(engine: &Engine, by_cylinder: bool) -> Vec<Line> {
    let cylinders = engine.cylinders().iter().enumerate();
    let links: Vec<usize> =
        cylinders.filter(|(_, cylinder)| cylinder.link().is_some()).map(|(index, _)| index).collect();
    let of_links = |given: &Given| given.cylinder.is_some() && given.quantity.is_of_links();
    let each = by_cylinder || engine.dimensions().given.iter().any(of_links);
    let shown = if each { links.len() } else { links.len().min(1) };
    links.into_iter().take(shown).flat_map(|index| of_link(engine, index, each)).collect()
}

fn of_link(engine: &Engine, index: usize, each: bool) -> Vec<Line> {
    let subscript = if each { format!("_{{{}}}", engine.cylinders()[index].name) } else { String::new() };
    let named = |symbol: &str| format!("{symbol}{subscript}");
    let value = |measure: Measure| {
        let of = |given: &&Given| given.quantity == measure && given.cylinder.is_none_or(|of| of == index);
        engine.dimensions().given.iter().find(of).and_then(|given| given.value.to_f64())
    };
    let of = |measure: Measure, symbol: &str| value(measure).map(|value| quantity(named(symbol), value));
    let line = |symbol: String, expression| Line { symbol, expression, unit: "" };
    let radius = value(Measure::CrankRadius).or(value(Measure::Stroke).map(|stroke| stroke / 2.0));
    let ratio = match (value(Measure::RodRatio), radius, value(Measure::RodLength)) {
        (Some(ratio), ..) => Some(ratio),
        (None, Some(radius), Some(length)) => Some(radius / length),
        (None, ..) => None,
    };
    let [radius, ratio] =
        [("r", radius), ("\\lambda", ratio)].map(|(symbol, value)| value.map(|value| quantity(named(symbol), value)));
    let knuckle = match (of(Measure::KnuckleRadius, "a"), of(Measure::RodLength, "l"), &radius, &ratio) {
        (Some(distance), Some(length), ..) => Some(fraction(distance, length)),
        (Some(distance), None, Some(radius), Some(ratio)) => {
            Some(fraction(Expression::Product(vec![distance, ratio.clone()]), radius.clone()))
        }
        (Some(_), None, ..) | (None, ..) => None,
    };
    let knuckle = knuckle.map(|expression| line(named("\\kappa"), expression));
    let known = knuckle.as_ref().map(Line::value).or(value(Measure::KnuckleRatio));
    let link = match (of(Measure::LinkLength, "L"), value(Measure::LinkRatio), radius, ratio, known) {
        (Some(length), _, Some(radius), ..) => Some(fraction(radius, length)),
        // L is l − a where it is left out.
        (None, None, _, Some(ratio), Some(known)) => {
            let rest = Expression::Minus(Box::new(quantity(named("\\kappa"), known)));
            Some(fraction(ratio, Expression::Sum(vec![Expression::Number(1), rest])))
        }
        (Some(_), _, None, ..) | (None, ..) => None,
    };
    let link = link.map(|expression| line(format!("(r/L){subscript}"), expression));
    knuckle.into_iter().chain(link).collect()
}
