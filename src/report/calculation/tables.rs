//! Which tables hold the numbers? What is in the scene, the ellipse and the two vectors of each order, the torque.

use super::amounts::{self, Unit, axial_cell, share, waveform};
use super::words;
use crate::engine::Engine;
use crate::loads::{Arm, Loads, OrderLoads, Outcome, Peak, Torque};
use crate::numbers;
use crate::order::MassGroup;
use crate::page::{self, Number, Table, Text, phrase};
use crate::proof::{Axial, Planar, Quantity};
use crate::report::texts::loads as text;

/// What is in the scene and what is not, and what each group of masses adds to the peaks.
pub(super) fn effects(engine: &Engine, loads: &Loads, page: words::Sections) -> Table {
    let [force, moment] = Planar::BOTH.map(|of| (of, waveform(loads, of).peak(), Unit::as_read(engine, loads, of)));
    let share = |group: Option<MassGroup>, (of, peak, unit): &(Planar, Peak, Unit)| -> Text {
        let Some(loads) = loads.groups.iter().find(|loads| Some(loads.group) == group) else { return "–".into() };
        let waveform = of.choose(&loads.force, &loads.moment);
        match peak.value == 0.0 || unit.factor == 0.0 || waveform.harmonics().is_empty() {
            true => Text::zero(),
            false => phrase!("{} {}", Text::measured(share(waveform, peak) * unit.factor, unit.unit), unit.label()),
        }
    };
    Table::of(words::effects(engine, loads, page))
        .column("Effect", |row| row.name)
        .column("Included", |row| if row.inside { "yes" } else { "no" })
        .column("Why", |row| row.why.clone())
        .column("Share of peak force", |row| share(row.group, &force))
        .column("Share of peak moment", |row| share(row.group, &moment))
        .done()
}

/// The two rotating vectors of each order.
pub(super) fn vectors(engine: &Engine, loads: &Loads) -> Table {
    let (force, moment) = (Unit::of(engine, loads, Planar::Force), Unit::of(engine, loads, Planar::Moment));
    Table::of(&loads.orders)
        .column("Order", |order| order.order)
        .column("Force, direct", |order| amounts::vector(&order.force.direct, force))
        .column("Force, reverse", |order| amounts::vector(&order.force.reverse, force))
        .column("Moment, direct", |order| amounts::vector(&order.moment.direct, moment))
        .column("Moment, reverse", |order| amounts::vector(&order.moment.reverse, moment))
        .done()
}

/// The ellipse that force and moment of each order run through.
pub(super) fn ellipses(engine: &Engine, loads: &Loads) -> Table {
    let mut table =
        Table::new(["Order", "Quantity", "Largest", "Smallest", "Direction", "Along", "Across", "Largest / unit"]);
    for order in &loads.orders {
        for quantity in Planar::BOTH {
            table.push(ellipse(engine, loads, order, quantity));
        }
    }
    table
}

fn ellipse(engine: &Engine, loads: &Loads, order: &OrderLoads, quantity: Planar) -> Vec<Text> {
    let swing = order.swing(quantity);
    let unit = Unit::as_read(engine, loads, quantity);
    let mut row = vec![order.order.into(), quantity.name().into(), amounts::largest(swing, unit)];
    if swing.vanishes() {
        row.extend([Text::zero(), "–".into(), Text::zero(), Text::zero(), Text::zero()]);
        return row;
    }
    if !amounts::is_left(swing) {
        row.extend(["–"; 5].map(Text::from));
        return row;
    }
    let largest = swing.largest();
    // What is zero only as far as the decimals go is not said to be.
    let part = |value: f64, is_zero: bool| match is_zero {
        true => Text::zero(),
        false if value <= 1e-12 * largest => "≈ 0".into(),
        false => amounts::amount(value, unit),
    };
    row.push(part(swing.smallest(), swing.path.is_line));
    // At rest there is nothing that could point anywhere.
    let direction = swing.direction().filter(|_| unit.factor != 0.0);
    row.push(direction.map_or("–".into(), |degrees| phrase!("≈ {}°", Text::figures(degrees))));
    row.push(part(swing.along(), swing.path.nothing_along));
    row.push(part(swing.across(), swing.path.nothing_across));
    row.push(match (quantity, Arm::of(engine)) {
        (Planar::Moment, Arm::Metre) => Text::measured(largest, page::Unit::METRE),
        (Planar::Moment | Planar::Force, _) => Number::Decimal(largest).into(),
    });
    row
}

/// What the tables count in.
pub(super) fn units(engine: &Engine, loads: &Loads) -> Text {
    let (force, moment) = (Unit::as_read(engine, loads, Planar::Force), Unit::as_read(engine, loads, Planar::Moment));
    let first = match Arm::of(engine) {
        Arm::Metre => text::units(force.label(), moment.label(), page::Unit::METRE),
        Arm::Spacing => text::units_of_spacing(force.label(), moment.label()),
    };
    first.and(" ").and(text::amplitudes())
}

/// Orders of the torque or the roll moment: amplitude, phase, and the multiple that both are of.
pub(super) fn about_the_axis(engine: &Engine, loads: &Loads, quantity: Axial, all: &Torque) -> Table {
    let unit = Unit::as_read(engine, loads, Quantity::Axial(quantity));
    Table::of(&all.orders)
        .column("Order", |order| order.order)
        .column(phrase!("Amplitude in {}", unit.label()), |order| axial_cell(engine, quantity, order, unit))
        .column("Phase at θ = 0", |order| match order.vector.outcome {
            Outcome::Zero | Outcome::Undecided { .. } => "–".into(),
            Outcome::NotZero | Outcome::Computed => {
                phrase!("≈ {}°", Text::figures(numbers::degrees(order.vector.value)))
            }
        })
        .column("In m r² ω²", |order| match order.vector.outcome {
            Outcome::Zero => Text::zero(),
            Outcome::Undecided { .. } => "not decided".into(),
            Outcome::NotZero | Outcome::Computed => Number::Decimal(order.vector.value.norm()).into(),
        })
        .done()
}
