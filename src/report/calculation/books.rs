//! What do textbooks have for order 2, who take the first term of `c_2` alone?

use num_traits::{ToPrimitive, Zero};

use super::amounts::{Unit, UnitOf};
use crate::engine::Engine;
use crate::loads::{Loads, OrderLoads, Swing};
use crate::order;
use crate::page::{Setting, Text, number};
use crate::proof::Planar;
use crate::report::texts::loads as text;

/// The second order with `c_2 = λ`; none where nothing is left of it, or where not all of it has one coefficient.
pub(in crate::report) fn books_line(engine: &Engine, loads: &Loads, unit_of: UnitOf) -> Option<Text> {
    let order = loads.orders.iter().find(|order| order.order == 2)?;
    let [first_term, whole] = second_coefficient(engine, order)?;
    let part = first_term / whole;
    let of = |quantity: Planar| size(unit_of(engine, loads, quantity.into()), order.swing(quantity), part);
    let sizes = Planar::BOTH.into_iter().filter_map(of);
    let sizes: Vec<Text> = sizes.collect();
    let less = number::sensible(100.0 * (1.0 - part));
    (!sizes.is_empty()).then(|| text::textbook(Text::joined(sizes, ", "), less))
}

/// The first term of `|c_2|` and all of it; none where masses that turn have a part in the order, which neither is a part of.
pub(super) fn second_coefficient(engine: &Engine, order: &OrderLoads) -> Option<[f64; 2]> {
    let rod = engine.rods().next().filter(|rod| rod.offset.is_zero() && !rod.ratio.is_zero())?;
    if order.order != 2 || order::turning_masses(engine).iter().any(|mass| mass.order == 2) {
        return None;
    }
    Some([rod.ratio.to_f64()?, order.coefficient.as_ref()?.to_complex().norm()])
}

fn size(unit: Unit, swing: &Swing, part: f64) -> Option<Text> {
    let is_left = !swing.vanishes() && unit.factor != 0.0;
    is_left.then(|| unit.sized(swing.largest() * part, Setting::Usual(number::sensible)))
}
