//! Which tables tell the torque? The cylinders, the orders, the flywheel, the guide-force moments.

use num_complex::Complex;

use super::super::residual;
use super::words::{angle, cylinders, quantity};
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::gas::CylinderGas;
use crate::page::{Number, Piece, Table, Text, Unit, number, phrase};
use crate::report::texts::torque as text;
use crate::torque::{EngineTorque, Evenness, GuideMoments, TorqueOrder};

/// Orders up to this one are shown even where they are zero.
const ALWAYS_SHOWN: u32 = 6;

/// A pascal in bar.
const BAR: f64 = 1e5;

/// What the gas of each class does in a cycle.
pub(super) fn classes(engine: &Engine, torque: &EngineTorque) -> Table {
    let peak_angle = |gas: &CylinderGas| {
        let half = gas.period() / 2.0;
        (gas.peak_pressure().1 - gas.zero() + half).rem_euclid(gas.period()) - half
    };
    let heat = |gas: &CylinderGas| match gas.heat().filter(|heat| *heat > 0.0) {
        Some(heat) => Text::measured(heat, Unit::JOULE),
        None => "–".into(),
    };
    let bar = |pascals: f64| Text::measured(pascals / BAR, Unit::BAR);
    Table::of(torque.classes.iter().enumerate())
        .column("Cylinders", |(index, _)| cylinders(engine, torque, *index))
        .column(phrase!("Peak pressure in {}", Unit::BAR), |(_, class)| bar(class.gas.peak_pressure().0))
        .column("at ψ", |(_, class)| angle(peak_angle(&class.gas).to_degrees()))
        .column(phrase!("Mean pressure in {}", Unit::BAR), |(_, class)| bar(class.gas.mean_pressure()))
        .column(phrase!("Work of a cycle in {}", Unit::JOULE), |(_, one)| Text::measured(one.gas.work(), Unit::JOULE))
        .column(phrase!("Heat of a cycle in {}", Unit::JOULE), |(_, class)| heat(&class.gas))
        .column(phrase!("Mean torque of each in {}", Unit::NEWTON_METRE), |(_, class)| {
            Text::measured(class.harmonics.torque[0].re, Unit::NEWTON_METRE)
        })
        .done()
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
    let inertia = |order: &TorqueOrder| amplitude(order.inertia_vanishes, order.inertia.unwrap_or_default());
    let shown = |order: &&TorqueOrder| order.order.halves() <= 2 * ALWAYS_SHOWN || !order.vanishes();
    Table::of(torque.orders.iter().filter(shown))
        .column("Order κ", |order| Text::label(order.order.to_string()))
        .column_if(one_class, "Firing star", |order| order.stars.first().map(star).unwrap_or_default())
        .column(phrase!("Gas in {}", Unit::NEWTON_METRE), |order| amplitude(order.gas_vanishes, order.gas))
        .column_if(with_inertia, phrase!("Inertia in {}", Unit::NEWTON_METRE), |order| inertia(order))
        .column_if(with_inertia, phrase!("Together in {}", Unit::NEWTON_METRE), |order| {
            amplitude(order.vanishes(), order.total())
        })
        .column("Angle at θ = 0", |order| match order.vanishes() || order.total().norm() == 0.0 {
            true => "–".into(),
            false => angle(order.total().arg().to_degrees()),
        })
        .done()
}

/// The torque on each of several crankshafts.
pub(super) fn shafts(engine: &Engine, torque: &EngineTorque) -> Table {
    let moment = |value: f64| Text::measured(value, Unit::NEWTON_METRE);
    Table::of(torque.shafts.iter())
        .column("Crankshaft", |one| Text::label(engine.geared_cranks()[one.shaft].name.clone()))
        .column(phrase!("Mean in {}", Unit::NEWTON_METRE), |one| moment(one.mean))
        .column(phrase!("Largest in {}", Unit::NEWTON_METRE), |one| moment(one.extremes[0].value))
        .column(phrase!("Smallest in {}", Unit::NEWTON_METRE), |one| moment(one.extremes[1].value))
        .done()
}

/// What the flywheel does, and how well that is known.
pub(super) fn flywheel(evenness: &Evenness) -> Table {
    let inertia = |value: f64| quantity(value, Unit::KILOGRAM_SQUARE_METRE);
    let mut table = Table::new(["", "Value"]);
    let mut row = |name: Text, value: Text| table.push(vec![name, value]);
    row("energy fluctuation ΔW".into(), quantity(evenness.energy, Unit::JOULE));
    row("the crank is fastest at θ".into(), angle(evenness.fastest.angle));
    row("and slowest at θ".into(), angle(evenness.slowest.angle));
    row(text::reciprocating(), inertia(evenness.reciprocating));
    let needed = evenness.needed;
    let wanted = || -> Text { Number::Decimal(needed.irregularity).into() };
    row(
        if needed.is_example {
            text::example_coefficient()
        } else {
            "required coefficient of fluctuation of speed δ".into()
        },
        wanted(),
    );
    row("inertia for it, J = ΔW/(δ ω²)".into(), inertia(needed.inertia));
    row("less that of the reciprocating masses".into(), inertia(needed.refined));
    if let Some(given) = evenness.given {
        row("given inertia J".into(), inertia(given.inertia));
        row("coefficient of fluctuation with it, δ = ΔW/(J ω²)".into(), Number::Decimal(given.irregularity).into());
        row("with that of the reciprocating masses".into(), Number::Decimal(given.refined).into());
        row(
            "by the balance of energy".into(),
            given.by_energy.map_or_else(|| "it stops within a cycle".into(), |value| Number::Decimal(value).into()),
        );
    }
    table
}

/// The guide-force moments of the orders that have any.
pub(super) fn guides(moments: &[GuideMoments]) -> Table {
    let size = |moment: Option<f64>| moment.map_or_else(Text::zero, |size| Text::measured(size, Unit::NEWTON_METRE));
    Table::of(moments.iter().filter(|moment| moment.rocking.is_some() || moment.twisting.is_some()))
        .column("Order κ", |moment| Text::label(moment.order.to_string()))
        .column(phrase!("H, rocking, in {}", Unit::NEWTON_METRE), |moment| size(moment.rocking))
        .column(phrase!("X, twisting, in {}", Unit::NEWTON_METRE), |moment| size(moment.twisting))
        .done()
}

/// What the orders that were omitted can add, and how well the others are known.
pub(super) fn accuracy(torque: &EngineTorque) -> Text {
    let each = |of: &dyn Fn(&crate::torque::Class) -> f64| -> f64 {
        torque.classes.iter().map(|class| of(class) * class.cylinders.len() as f64).sum()
    };
    let at_most = |value| Text::from(Piece::AtMost(value, Unit::NEWTON_METRE));
    let bound = each(&|class| class.harmonics.bound(f64::from(crate::torque::HIGHEST)));
    text::accuracy(
        Text::label(number::decimal(torque.balance.max(f64::EPSILON))),
        crate::torque::HIGHEST,
        at_most(torque.missed),
        at_most(bound),
        at_most(each(&|class| class.harmonics.errors[2])),
    )
}
