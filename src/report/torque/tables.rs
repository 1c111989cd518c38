//! Which tables tell the torque? The cylinders, the orders, the flywheel, the guide-force moments.

use num_complex::Complex;

use super::super::residual;
use super::words::{angle, cylinders, quantity};
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::page::{Number, Table, Text, Unit, number, phrase};
use crate::torque::{EngineTorque, Evenness, GuideMoments};

/// Orders up to this one are shown even where they are zero.
const ALWAYS_SHOWN: u32 = 6;

/// A pascal in bar.
const BAR: f64 = 1e5;

/// What the gas of each class does in a cycle.
pub(super) fn classes(engine: &Engine, torque: &EngineTorque) -> Table {
    let mut table = Table::new([
        Text::from("Cylinders"),
        phrase!("Peak pressure in {}", Unit::BAR),
        "at ψ".into(),
        phrase!("Mean pressure in {}", Unit::BAR),
        phrase!("Work of a cycle in {}", Unit::JOULE),
        phrase!("Heat of a cycle in {}", Unit::JOULE),
        phrase!("Mean torque of each in {}", Unit::NEWTON_METRE),
    ]);
    for (index, class) in torque.classes.iter().enumerate() {
        let (peak, at) = class.gas.peak_pressure();
        let half = class.gas.period() / 2.0;
        let at = (at + half).rem_euclid(class.gas.period()) - half;
        table.push(vec![
            cylinders(engine, torque, index),
            Text::measured(peak / BAR, Unit::BAR),
            angle(at.to_degrees()),
            Text::measured(class.gas.mean_pressure() / BAR, Unit::BAR),
            Text::measured(class.gas.work(), Unit::JOULE),
            class
                .gas
                .heat()
                .filter(|heat| *heat > 0.0)
                .map_or_else(|| "–".into(), |heat| Text::measured(heat, Unit::JOULE)),
            Text::measured(class.harmonics.torque[0].re, Unit::NEWTON_METRE),
        ]);
    }
    table
}

/// A vector that rotates: 0 where that is proved, else how long it is.
fn amplitude(vanishes: bool, value: Complex<f64>) -> Text {
    if vanishes { Text::zero() } else { Text::measured(value.norm(), Unit::NEWTON_METRE) }
}

/// The firing star of an order, where all cylinders are alike.
fn star(star: &PhasorSum) -> Text {
    if star.vanishes() { Text::zero() } else { residual::modulus_of(star).into() }
}

/// The orders of gas, inertia and both; above order 6 only those that do not vanish.
pub(super) fn orders(torque: &EngineTorque) -> Table {
    let one_class = torque.classes.len() == 1;
    let with_inertia = torque.has_inertia();
    let mut header: Vec<Text> = vec!["Order κ".into()];
    header.extend(one_class.then(|| "Firing star".into()));
    header.push(phrase!("Gas in {}", Unit::NEWTON_METRE));
    if with_inertia {
        header.extend([phrase!("Inertia in {}", Unit::NEWTON_METRE), phrase!("Together in {}", Unit::NEWTON_METRE)]);
    }
    header.push("Angle at θ = 0".into());
    let mut table = Table::new(header);
    for order in torque.orders.iter().filter(|order| order.order.halves() <= 2 * ALWAYS_SHOWN || !order.vanishes()) {
        let mut row: Vec<Text> = vec![Text::label(order.order.to_string())];
        if one_class {
            row.extend(order.stars.first().map(star));
        }
        row.push(amplitude(order.gas_vanishes, order.gas));
        if let Some(inertia) = order.inertia.filter(|_| with_inertia) {
            row.push(amplitude(order.inertia_vanishes, inertia));
            row.push(amplitude(order.vanishes(), order.total()));
        }
        row.push(match order.vanishes() {
            true => "–".into(),
            false => angle(order.total().arg().to_degrees()),
        });
        table.push(row);
    }
    table
}

/// What the flywheel does, and how well that is known.
pub(super) fn flywheel(evenness: &Evenness) -> Table {
    let inertia = |value: f64| quantity(value, Unit::KILOGRAM_SQUARE_METRE);
    let mut table = Table::new(["", "Value"]);
    let mut row = |name: &'static str, value: Text| table.push(vec![name.into(), value]);
    row("largest less smallest work above the mean torque, ΔW", quantity(evenness.energy, Unit::JOULE));
    row("the crank is fastest at θ", angle(evenness.fastest.angle));
    row("and slowest at θ", angle(evenness.slowest.angle));
    row("mean of Σ m s'², the inertia of what goes back and forth", inertia(evenness.reciprocating));
    let needed = evenness.needed;
    let wanted = || -> Text { Number::Decimal(needed.irregularity).into() };
    row(if needed.is_example { "irregularity δ, as an example" } else { "wanted irregularity δ" }, wanted());
    row("inertia for it, J = ΔW/(δ ω²)", inertia(needed.inertia));
    row("less what goes back and forth", inertia(needed.refined));
    if let Some(given) = evenness.given {
        row("given inertia J", inertia(given.inertia));
        row("irregularity with it, δ = ΔW/(J ω²)", Number::Decimal(given.irregularity).into());
        row("with what goes back and forth", Number::Decimal(given.refined).into());
        row(
            "by the balance of energy",
            given.by_energy.map_or_else(|| "it stops within a cycle".into(), |value| Number::Decimal(value).into()),
        );
    }
    table
}

/// The guide-force moments of the orders that have any.
pub(super) fn guides(moments: &[GuideMoments]) -> Table {
    let mut table = Table::new([
        Text::from("Order κ"),
        phrase!("H, rocking, in {}", Unit::NEWTON_METRE),
        phrase!("X, twisting, in {}", Unit::NEWTON_METRE),
    ]);
    let size =
        |moment: Option<f64>| moment.map_or_else(Text::zero, |moment| Text::measured(moment, Unit::NEWTON_METRE));
    for moment in moments.iter().filter(|moment| moment.rocking.is_some() || moment.twisting.is_some()) {
        table.push(vec![Text::label(moment.order.to_string()), size(moment.rocking), size(moment.twisting)]);
    }
    table
}

/// What the orders that were left out can add, and how well the others are known.
pub(super) fn accuracy(torque: &EngineTorque) -> Text {
    let each = |of: &dyn Fn(&crate::torque::Class) -> f64| -> f64 {
        torque.classes.iter().map(|class| of(class) * class.cylinders.len() as f64).sum()
    };
    let bound = each(&|class| class.harmonics.bound(f64::from(crate::torque::HIGHEST)));
    phrase!(
        "Mean torque and area of the loops agree to {} of the work. The orders up to {} miss at most {} of the torque; no order of the gas above them is larger than {}, by the total variation of the torque's slope. The harmonics of the gas are off by at most {}, the last change of their quadrature and its roundings.",
        Text::label(number::decimal(torque.balance.max(f64::EPSILON))),
        crate::torque::HIGHEST,
        quantity(torque.missed, Unit::NEWTON_METRE),
        quantity(bound, Unit::NEWTON_METRE),
        quantity(each(&|class| class.harmonics.errors[2]), Unit::NEWTON_METRE)
    )
}
