//! How are the largest values said, with how sure they are, and what the orders shown omit?

use super::super::typeset;
use super::amounts::{self, Unit, UnitOf, digits, in_digits};
use crate::accuracy::{Largest, LargestLoads};
use crate::engine::Engine;
use crate::loads::{self, Bound, LeftOut, Loads, Missing, Needed};
use crate::page::{Text, phrase};
use crate::proof::Quantity;
use crate::report::texts::loads as text;

/// The numbers of an engine, as pages and tables show them.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// Order by order.
    pub loads: Loads,
    /// Of all orders.
    pub largest: LargestLoads,
    /// What the orders that are not shown add at most.
    pub left: LeftOut,
}

impl Numbers {
    /// The loads at these orders, or at those that an accuracy needs.
    ///
    /// # Errors
    /// What the layout lacks.
    pub fn new(engine: &Engine, orders: &[u32], needed: Option<&Needed>) -> Result<Self, Missing> {
        let loads = match needed {
            Some(needed) => loads::loads_at(engine, &needed.kept, &needed.torque_kept)?,
            None => loads::loads(engine, orders)?,
        };
        let left = match needed {
            Some(needed) => needed.left.clone(),
            None => {
                let torque = loads.torque.iter().flat_map(|torque| &torque.orders);
                loads::left_out(engine, orders, &torque.map(|order| order.order).collect::<Vec<_>>())?
            }
        };
        Ok(Numbers { loads, largest: LargestLoads::new(engine)?, left })
    }
}

/// `Largest force: ≈ 204.1 N at θ ≈ 12°, within 0.01 %; …`, a line a load.
pub(super) fn largest_lines(engine: &Engine, Numbers { loads, largest, .. }: &Numbers, unit_of: UnitOf) -> Vec<Text> {
    let value = |largest: &Largest, quantity: Quantity| value(largest, unit_of(engine, loads, quantity));
    let mut lines = vec![
        text::largest_force(value(&largest.force, Quantity::FORCE)),
        text::largest_moment(value(&largest.moment, Quantity::MOMENT)),
    ];
    lines.extend(largest.torque.as_ref().map(|torque| text::largest_torque(value(torque, Quantity::TORQUE))));
    lines
}

fn value(largest: &Largest, unit: Unit) -> Text {
    match largest {
        Largest::Zero => text::zero(),
        _ if unit.factor == 0.0 => Text::zero(),
        Largest::Known { value, angle, error } => {
            let (size, part) = (in_digits(value * unit.factor, unit), percent_at_most(error / value));
            match angle {
                Some(angle) => text::largest_at(size, unit.label(), digits(*angle), part),
                None => text::largest_always(size, unit.label(), part),
            }
        }
        Largest::Below(bound) => text::below(amounts::bound(*bound, unit), unit.label()),
    }
}

/// What the orders that are shown come to by themselves, where that is not the largest value of all.
pub(super) fn shown_line(engine: &Engine, Numbers { loads, largest, .. }: &Numbers) -> Option<Text> {
    let torque = loads.torque.as_ref().zip(largest.torque.as_ref());
    let swings = [
        ("force {}", loads.force.peak(), largest.force, Quantity::FORCE),
        ("moment {}", loads.moment.peak(), largest.moment, Quantity::MOMENT),
    ];
    let torque =
        torque.map(|(torque, largest)| ("inertia torque {}", torque.waveform.real_peak(), *largest, Quantity::TORQUE));
    let differ = swings.into_iter().chain(torque).filter_map(|(words, peak, largest, quantity)| {
        let Largest::Known { value, error, .. } = largest else { return None };
        let unit = Unit::of(engine, loads, quantity);
        ((peak.value - value).abs() > error + NOTICED * value && unit.factor != 0.0)
            .then(|| phrase!(words, amounts::peak(&peak, unit)))
    });
    let differ: Vec<Text> = differ.collect();
    (!differ.is_empty()).then(|| text::listed_alone(Text::joined(differ, ", ")))
}

/// A difference of this part is shown.
const NOTICED: f64 = 1e-3;

/// Which orders were kept for an accuracy and whether it is reached, and what those that are not listed add at most.
pub(super) fn chosen_lines(
    engine: &Engine,
    Numbers { loads, left, .. }: &Numbers,
    needed: Option<&Needed>,
    unit_of: UnitOf,
) -> Vec<Text> {
    let list = |orders: &[u32]| match orders {
        [] => Text::from("none"),
        orders => typeset::listed(orders).into(),
    };
    let mut lines = Vec::new();
    if let Some(needed) = needed {
        lines.push(text::kept(
            percent_at_most(needed.accuracy),
            list(&needed.kept),
            list(&needed.dropped),
            needed.looked_at,
        ));
        let of_torque = || text::kept_of_torque(list(&needed.torque_kept), list(&needed.torque_dropped));
        lines.extend(loads.torque.as_ref().map(|_| of_torque()));
        lines.push(if needed.reached { text::reached() } else { text::not_reached() });
    }
    let said = |bound: Option<Bound>, quantity, of_peak: fn(String) -> Text, alone: fn(Text, Text) -> Text| {
        let (bound, unit) = (bound?, unit_of(engine, loads, quantity));
        Some(match bound.part() {
            Some(part) => of_peak(percent_at_most(part)),
            None => alone(amounts::bound(bound.most, unit), unit.label()),
        })
    };
    let bounds = [
        said(left.force, Quantity::FORCE, text::part_of_force, text::bound_of_force),
        said(left.moment, Quantity::MOMENT, text::part_of_moment, text::bound_of_moment),
        said(left.torque, Quantity::TORQUE, text::part_of_torque, text::bound_of_torque),
    ];
    let bounds: Vec<Text> = bounds.into_iter().flatten().collect();
    if !bounds.is_empty() {
        lines.push(text::omitted(Text::joined(bounds, ", ")));
    }
    lines
}

/// A part in percent, rounded to two digits.
pub(in crate::report) fn percent(part: f64) -> String {
    let percent = part * 100.0;
    digits(format!("{percent:.1e}").parse().unwrap_or(percent))
}

/// A bound in percent, rounded up to two digits.
pub(in crate::report) fn percent_at_most(part: f64) -> String {
    let percent = part * 100.0;
    if percent == 0.0 { "0".to_owned() } else { digits(typeset::raised_to(percent * (1.0 - 1e-12), 2)) }
}
