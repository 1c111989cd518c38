//! What does the table of a sweep hold? A row a point; 0 is proved, every other number rounded to ten digits.

use num_rational::BigRational;

use super::firing;
use super::words::{amount, digits, exact, named, quantities, quantity_name};
use crate::loads::Arm;
use crate::page::File;
use crate::proof::Quantity;
use crate::sweep::{Sweep, SweptEngine};

/// The points as `sweep.csv`.
///
/// After the parameters each order has, for force and moment, the largest and the smallest length in a revolution, the
/// amplitudes along and across the reference direction, and those of the two rotating vectors; in multiples of m r ω², or of
/// m r ω² c_k without rods, and again in newtons where mass, crank radius and speed are given. Then the firing intervals in
/// degrees, the counterweights, the envelope in crank radii, and the lengths of firing stars in crank radii where they are asked for.
pub fn sweep_csv(sweep: &Sweep) -> File {
    let stars =
        sweep.firing.iter().flat_map(|firing| (0..firing.orders.len()).map(|place| firing::name(firing, place)));
    let header = header(sweep).into_iter().chain(stars.map(|order| format!("firing_star_{order}_r")));
    let mut text = header.collect::<Vec<_>>().join(",") + "\n";
    for (index, point) in sweep.points.iter().enumerate() {
        let stars = sweep.firing.iter().flat_map(|firing| &firing.points[index]);
        let row = row(sweep, point).into_iter().chain(stars.map(|star| star.map(amount).unwrap_or_default()));
        text += &(row.collect::<Vec<_>>().join(",") + "\n");
    }
    File { name: "sweep.csv".into(), text }
}

fn in_newtons(sweep: &Sweep) -> bool {
    sweep.points.iter().any(|point| point.newtons.is_some())
}

fn header(sweep: &Sweep) -> Vec<String> {
    let mut header: Vec<String> = sweep.parameters.iter().map(|parameter| parameter.column()).collect();
    let newtons = in_newtons(sweep);
    for order in sweep.points.iter().take(1).flat_map(|point| &point.orders) {
        for (quantity, amplitudes) in quantities(order) {
            let name = format!("{}_{}", quantity_name(quantity), order.order);
            header.extend(named(amplitudes).map(|(part, _)| format!("{name}_{part}")));
            if newtons {
                let unit = newtons_name(sweep, quantity);
                header.extend(named(amplitudes).map(|(part, _)| format!("{name}_{part}_{unit}")));
            }
        }
    }
    let rest = [
        "longest_firing_interval_deg",
        "shortest_firing_interval_deg",
        "firing_unevenness_deg",
        "counterweight_m_r",
        "counterweight_kg_at_crank_radius",
        "length_r",
        "breadth_r",
        "height_r",
    ];
    header.extend(rest.map(str::to_owned));
    header
}

fn newtons_name(sweep: &Sweep, quantity: Quantity) -> &'static str {
    match (quantity, sweep.arm) {
        (Quantity::Moment, Arm::Spacing) => "N_a",
        (Quantity::Moment, Arm::Metre) => "N_m",
        _ => "N",
    }
}

fn row(sweep: &Sweep, point: &SweptEngine) -> Vec<String> {
    let mut row: Vec<String> = point.values.iter().map(exact).collect();
    let newtons = in_newtons(sweep);
    for order in &point.orders {
        for (_, amplitudes) in quantities(order) {
            row.extend(named(amplitudes).map(|(_, part)| amount(part)));
            if newtons {
                let scaled = |(_, part): (_, crate::sweep::Amplitude)| match point.newtons {
                    _ if part.vanishes => "0".to_owned(),
                    Some(newtons) => digits(part.value * newtons),
                    None => String::new(),
                };
                row.extend(named(amplitudes).map(scaled));
            }
        }
    }
    let degrees = |turns: &BigRational| exact(&(turns * BigRational::from_integer(360.into())));
    let evenness = point.evenness.as_ref();
    let intervals = evenness.map(|e| [degrees(&e.longest), degrees(&e.shortest), degrees(&e.unevenness())]);
    row.extend(intervals.unwrap_or_default());
    row.push(point.counterweight.map(amount).unwrap_or_default());
    let mass = point.counterweight.zip(point.kilograms);
    row.push(
        mass.map(|(part, kilograms)| if part.vanishes { "0".into() } else { digits(part.value * kilograms) })
            .unwrap_or_default(),
    );
    let box_of = point.envelope;
    row.push(box_of.and_then(|envelope| envelope.length).map(digits).unwrap_or_default());
    row.extend([box_of.map(|e| e.breadth), box_of.map(|e| e.height)].map(|side| side.map(digits).unwrap_or_default()));
    row
}
