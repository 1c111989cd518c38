//! What follows from the lengths of links on a master rod? The ratios κ = a/l and r/L, line by line.

use super::expression::{Expression, Line, fraction, quantity};
use super::given::{crank_radius, of_measure};
use crate::engine::{Engine, Measure};

/// The lines of all links; once where the file says the same of all. `by_cylinder`: whether rods have a line for each cylinder.
pub(super) fn lines(engine: &Engine, by_cylinder: bool) -> Vec<Line> {
    let cylinders = engine.cylinders().iter().enumerate();
    let links = cylinders.filter(|(_, cylinder)| cylinder.link().is_some()).map(|(index, _)| index);
    let mut lines: Vec<Line> = Vec::new();
    for line in links.flat_map(|index| of_link(engine, index, by_cylinder)) {
        // What all links have in common bears no name of a cylinder, and stands once.
        if !lines.iter().any(|other| other.symbol == line.symbol) {
            lines.push(line);
        }
    }
    lines
}

fn of_link(engine: &Engine, index: usize, by_cylinder: bool) -> Vec<Line> {
    let differs = |measures: [Measure; 2]| {
        let given = &engine.dimensions().given;
        given.iter().any(|given| given.cylinder.is_some() && measures.contains(&given.quantity))
    };
    let of_pin = by_cylinder || differs([Measure::KnuckleRadius, Measure::KnuckleRatio]);
    let of_length = differs([Measure::LinkLength, Measure::LinkRatio]);
    let name = &engine.cylinders()[index].name;
    let named = |symbol: &str, has_own: bool| {
        if has_own { format!("{symbol}_{{{name}}}") } else { symbol.to_owned() }
    };
    let value = |measure: Measure| of_measure(engine, index, measure);
    let of = |measure: Measure, symbol: &str, has_own: bool| {
        value(measure).map(|value| quantity(named(symbol, has_own), value))
    };
    let line = |symbol: String, expression| Line { symbol, expression, unit: "" };
    let radius = crank_radius(engine, index);
    let ratio = match (value(Measure::RodRatio), radius, value(Measure::RodLength)) {
        (Some(ratio), ..) => Some(ratio),
        (None, Some(radius), Some(length)) => Some(radius / length),
        (None, ..) => None,
    };
    let [radius, ratio] = [("r", radius), ("\\lambda", ratio)]
        .map(|(symbol, value)| value.map(|value| quantity(named(symbol, by_cylinder), value)));
    let (distance, length) = (of(Measure::KnuckleRadius, "a", of_pin), of(Measure::RodLength, "l", by_cylinder));
    let knuckle = match (distance, length, &radius, &ratio) {
        (Some(distance), Some(length), ..) => Some(fraction(distance, length)),
        (Some(distance), None, Some(radius), Some(ratio)) => {
            Some(fraction(Expression::Product(vec![distance, ratio.clone()]), radius.clone()))
        }
        (Some(_), None, ..) | (None, ..) => None,
    };
    let knuckle = knuckle.map(|expression| line(named("\\kappa", of_pin), expression));
    let known = knuckle.as_ref().map(Line::value).or(value(Measure::KnuckleRatio));
    let link =
        match (of(Measure::LinkLength, "L", of_length || by_cylinder), value(Measure::LinkRatio), radius, ratio, known)
        {
            (Some(length), _, Some(radius), ..) => Some(fraction(radius, length)),
            // L is l − a by default.
            (None, None, _, Some(ratio), Some(known)) => {
                let rest = Expression::Minus(Box::new(quantity(named("\\kappa", of_pin), known)));
                Some(fraction(ratio, Expression::Sum(vec![Expression::Number(1), rest])))
            }
            (Some(_), _, None, ..) | (None, ..) => None,
        };
    let has_own = of_length || (of_pin && value(Measure::LinkLength).is_none()) || by_cylinder;
    let link = link.map(|expression| line(named("(r/L)", has_own), expression));
    knuckle.into_iter().chain(link).collect()
}
