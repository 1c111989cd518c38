//! What does `remedy` show on a terminal? The weights, a row each, and what they come to.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::super::old::Rows;
use super::super::typeset::{decimal, number};
use super::words;
use crate::engine::LengthUnit;
use crate::remedy::{Partial, Remedy};

/// A row a weight.
pub fn remedy_rows(remedy: &Remedy) -> Rows {
    let in_numbers = remedy.subject.scale().is_some();
    let metres = remedy.subject.engine().length_unit() == LengthUnit::Metre;
    let position = if metres { "Position in m" } else { "Position" };
    let mut header: Vec<String> =
        ["Weight", "Turns", position, "Mass-radius U", "Angle at θ = 0"].map(str::to_owned).into();
    header.extend(in_numbers.then(|| "U in kg·m".to_owned()));
    let row = |part: words::Part<'_>| {
        let weight = part.weight;
        let mut cells = vec![
            part.name.to_owned(),
            words::speed(weight),
            number(&weight.position),
            words::size(remedy, weight),
            words::direction(remedy, weight),
        ];
        cells.extend(in_numbers.then(|| {
            weight.mass_radius(&remedy.subject).map_or_else(String::new, |size| format!("≈ {}", significant(size)))
        }));
        cells
    };
    Rows { header, rows: words::parts(remedy).into_iter().map(row).collect() }
}

/// What follows the table.
pub fn remedy_lines(remedy: &Remedy) -> Vec<String> {
    let mut lines = Vec::new();
    let orders = remedy.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    lines.push(match (remedy.holds(), remedy.weights().is_empty()) {
        (true, true) => format!("Nothing is left of force and moment at the orders {orders}: no weight is needed."),
        (true, false) => format!(
            "With these weights force and moment vanish at the orders {orders}: {} sums of the corrected engine, each proved zero.",
            remedy.corrected.len()
        ),
        (false, _) => {
            let left = remedy.corrected.iter().filter(|sum| !sum.vanishes()).count();
            format!("{left} sums of the corrected engine do not vanish.")
        }
    });
    if !remedy.shafts.is_empty() {
        lines.push(format!(
            "{} the least: a shaft adds to the vector of its own order and sense alone. Half-speed shafts are none of them: they turn once in two revolutions, and no inertia force of the cranks has order 1/2.",
            if remedy.shafts.len() == 1 { "One balancer shaft is".to_owned() } else { format!("{} balancer shafts are", remedy.shafts.len()) }
        ));
    }
    for height in &remedy.heights {
        let metres = height.metres.map_or_else(String::new, |metres| format!(" ≈ {} m", significant(metres.abs())));
        lines.push(format!(
            "Lanchester pair of order {}: where the shaft that turns with the crank lies {} r{metres} {} than the other, the pair takes the inertia torque of the order away too, not the torque of the gas; half the height takes half.",
            height.order,
            decimal_after(height.in_crank_radii.abs()),
            if height.in_crank_radii < 0.0 { "lower" } else { "higher" }
        ));
    }
    lines.extend(partial_line(remedy));
    lines.extend(crankshaft_lines(remedy));
    lines
}

/// What counterweights alone can do, where the first order of the force has a reverse vector.
fn partial_line(remedy: &Remedy) -> Option<String> {
    let partial = Partial::new(remedy.subject.engine())?;
    let (_, least) = partial.minimum().filter(|_| remedy.orders.contains(&1) && !partial.reverse.vanishes())?;
    let bare = partial.ellipse(&num_traits::Zero::zero());
    Some(format!(
        "Counterweights alone: with the part f of the reciprocating masses balanced the first-order force peaks at ½(|1 − 2f|·|P⁺| + |P⁻|), {} m r ω² at f = 0 and least, {} m r ω², at f = ½; f and 1 − f are alike.",
        decimal_after(bare.peak_decimal),
        decimal_after(least.peak_decimal)
    ))
}

/// Mass, balance factors and bob weights, where the layout gives numbers.
fn crankshaft_lines(remedy: &Remedy) -> Vec<String> {
    let engine = remedy.subject.engine();
    let mut lines = Vec::new();
    if engine.crankshaft().counterweights.iter().any(|weight| weight.throw.is_some()) {
        let factors = engine.balance_factors();
        let factors = factors.iter().map(|factor| factor.as_ref().map_or_else(|| "none".to_owned(), number));
        let factors = factors.collect::<Vec<_>>().join(", ");
        lines.push(format!("Balance factors of the throws, by the counterweights in the layout file: {factors}."));
    }
    if let (Some(bare), Some(with)) = (engine.crankshaft_mass(), remedy.crankshaft_mass()) {
        let bare = bare.to_f64().unwrap_or(f64::NAN);
        lines.push(format!(
            "Mass in the balance equations (throws with rotating and half the reciprocating masses, and counterweights): ≈ {} kg, with the remedy's counterweights at the crank radius ≈ {} kg.",
            significant(bare),
            significant(with)
        ));
    }
    let half = BigRational::new(1.into(), 2.into());
    if let Some(bob) = engine.bob_weight(0, &half) {
        let one = bob.per_cylinder.first().map_or(f64::NAN, |mass| mass.to_f64().unwrap_or(f64::NAN));
        let all = bob.per_throw.to_f64().unwrap_or(f64::NAN);
        lines.push(format!(
            "Bob weight of throw 1 with half the reciprocating masses: ≈ {} kg a cylinder, ≈ {} kg for the throw.",
            significant(one),
            significant(all)
        ));
    }
    lines
}

fn decimal_after(value: f64) -> String {
    format!("≈ {}", decimal(value))
}

/// Six digits.
pub(super) fn significant(value: f64) -> String {
    let places = if value == 0.0 { 5.0 } else { 5.0 - value.abs().log10().floor() };
    let places = places.to_usize().unwrap_or(0).min(12);
    format!("{value:.places$}").replace('-', "−")
}
