//! Which tables tell what the best crankshafts are? The front, their counterweights, and uniform balance factors beside them.

use super::super::old::Rows;
use super::super::typeset;
use super::amounts::{self, Units};
use crate::engine::{Engine, LengthUnit};
use crate::loads::Arm;
use crate::numbers;
use crate::optimise::{Front, PlacedWeight};

/// What the figures of a front are counted in.
pub(super) fn units(layout: &Engine, front: &Front) -> Units {
    let scale = front.points.first().and_then(|point| point.design.scale.as_ref());
    Units::of(scale, Arm::of(layout) == Arm::Metre)
}

/// The front: a row a point.
pub fn optimise_rows(layout: &Engine, front: &Front) -> Rows {
    let units = units(layout, front);
    let header = vec![
        "Point".to_owned(),
        "Crankshaft in kg".into(),
        format!("Largest bearing load in {}", units.force),
        "Bearings".into(),
        "Least within".into(),
        "First-order force, direct".into(),
        format!("Couple, direct, in {}", units.couple),
    ];
    let row = |(index, point): (usize, &crate::optimise::Optimum)| {
        vec![
            (index + 1).to_string(),
            amounts::kilograms(&point.design.mass),
            amounts::load(&point.design, units),
            amounts::worst(&point.design),
            amounts::within(point),
            amounts::left(point.design.force),
            amounts::left(point.design.couple),
        ]
    };
    Rows { header, rows: front.points.iter().enumerate().map(row).collect() }
}

/// Uniform balance factors, and the best crankshaft of the same mass beside each.
pub fn optimise_compared(layout: &Engine, front: &Front) -> Rows {
    let units = units(layout, front);
    let header = vec![
        "Uniform balance factor".to_owned(),
        "Crankshaft in kg".into(),
        format!("Largest bearing load in {}", units.force),
        format!("Couple, direct, in {}", units.couple),
        format!("Best of that mass, in {}", units.force),
        "Less by".into(),
        "Lightest with that load, in kg".into(),
        "Their couples".into(),
    ];
    let row = |uniform: &crate::optimise::Uniform| {
        let mut row = vec![
            amounts::factor(&uniform.factor),
            amounts::kilograms(&uniform.design.mass),
            amounts::load(&uniform.design, units),
            amounts::left(uniform.design.couple),
        ];
        row.extend(match &uniform.best {
            None => ["none so light".to_owned(), "–".into()],
            Some(best) => {
                let less = 100.0 * (1.0 - best.design.peak() / uniform.design.peak());
                let less = if less < 0.05 { "0 %".to_owned() } else { format!("≈ {less:.0} %") };
                [amounts::load(&best.design, units), less]
            }
        });
        let lightest = uniform.lightest.as_ref();
        row.push(lightest.map_or("none".to_owned(), |lightest| amounts::kilograms(&lightest.design.mass)));
        let mut couples: Vec<String> =
            uniform.best.iter().chain(lightest).map(|point| amounts::left(point.design.couple)).collect();
        couples.dedup();
        row.push(if couples.is_empty() { "–".to_owned() } else { couples.join(", ") });
        row
    };
    Rows { header, rows: front.uniform.iter().map(row).collect() }
}

/// The counterweights of each point: their balance factor and skew, by plane.
pub(super) fn weights(layout: &Engine, front: &Front) -> Rows {
    let unit = if layout.length_unit() == LengthUnit::Metre { " m" } else { "" };
    let place = |place: &crate::optimise::Place| {
        let throw = place.throw.map_or_else(String::new, |throw| format!(", throw {}", throw + 1));
        format!("z = {}{unit}{throw}", typeset::number(&place.position))
    };
    let header = ["Point".to_owned()].into_iter().chain(front.places.iter().map(place)).collect();
    let row = |(index, point): (usize, &crate::optimise::Optimum)| {
        let cells = point.design.weights.iter().map(cell);
        [(index + 1).to_string()].into_iter().chain(cells).collect()
    };
    Rows { header, rows: front.points.iter().enumerate().map(row).collect() }
}

/// `0.5403, −6.9°`, or the mass-radius and its direction for a weight of no throw.
fn cell(weight: &PlacedWeight) -> String {
    if weight.mass_radius.norm() == 0.0 {
        return "none".to_owned();
    }
    let degrees = |value: f64| {
        let text = format!("{value:.1}").replace('-', "−");
        if text == "−0.0" { "0.0".to_owned() } else { text }
    };
    match (weight.factor, weight.skew) {
        (Some(factor), Some(skew)) => format!("{}, {}°", amounts::four(factor), degrees(skew)),
        _ => {
            let [size, angle] = [weight.mass_radius.norm(), numbers::degrees(weight.mass_radius)];
            format!("{} kg·m at {}°", amounts::four(size), degrees(angle))
        }
    }
}
