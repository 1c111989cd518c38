//! Which order is the first that is left, of all there are, or beside those that are reported?

use super::{AtOrder, ClassPattern, EveryOrderTheorem, Recurrences};
use crate::engine::Engine;
use crate::order::{Coefficients, Sources};
use crate::proof::{Planar, Shape};
use crate::verdict::of_order;

/// So many orders are looked through, class by class, for one that is left.
const MOST_LOOKED_THROUGH: u32 = 1000;

/// What is left first of all orders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstLeft {
    /// Nothing is, at any order.
    Nothing,
    /// This order, and what it traces.
    Order(u32, Shape),
    /// An order is not decided before any that is left, or the first thousand vanish and not all do.
    NotKnown,
}

/// The next order that is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NextLeft {
    /// None is.
    None,
    /// This one.
    Order(u32),
    /// These rods may make an order before it cancel, or it is none of the first thousand.
    NotKnown,
}

impl EveryOrderTheorem {
    /// The lowest order of force or moment that is left.
    pub fn first_left(&self, engine: &Engine, quantity: Planar) -> FirstLeft {
        match self {
            EveryOrderTheorem::Period(theorem) => quantity
                .choose(&theorem.force, &theorem.moment)
                .first
                .as_ref()
                .map_or(FirstLeft::Nothing, |first| FirstLeft::Order(first.direct.order, first.shape)),
            EveryOrderTheorem::Recurrences(all) => all.first_left(engine, quantity),
        }
    }

    /// The lowest order that is left of these quantities beside the orders that are reported.
    pub fn next_left(&self, quantities: &[Planar], told: &[u32]) -> NextLeft {
        let last = told.iter().copied().max().unwrap_or(1);
        match self {
            EveryOrderTheorem::Period(theorem) => {
                let of = |quantity: &Planar| quantity.choose(&theorem.force, &theorem.moment).survivors();
                let every: Vec<_> = quantities.iter().map(of).collect();
                let beyond = last.max(theorem.period) + theorem.period + 2;
                let mut orders = (1..=beyond).filter(|order| *order == 1 || order % 2 == 0);
                let is_left = |order: u32| every.iter().any(|survivors| survivors.contains(order));
                orders.find(|order| !told.contains(order) && is_left(*order)).map_or(NextLeft::None, NextLeft::Order)
            }
            EveryOrderTheorem::Recurrences(all) => all.next_left(quantities, last, told),
        }
    }
}

impl Recurrences {
    fn first_left(&self, engine: &Engine, quantity: Planar) -> FirstLeft {
        let both = quantity.choose(&self.force, &self.moment);
        let (sources, known) = (Sources::new(engine, self.masses), Coefficients::default());
        for order in 1..=MOST_LOOKED_THROUGH {
            if order > 1 && both.iter().all(|one| one.at(order) == AtOrder::Zero) {
                continue;
            }
            let judged = if order == 1 { self.first.clone() } else { of_order(&sources, order, &[], &known) };
            let whole = judged.whole(quantity);
            if whole.is_left() {
                return FirstLeft::Order(order, whole.shape);
            }
            if !whole.is_balanced() {
                return FirstLeft::NotKnown;
            }
        }
        match both.iter().flat_map(|one| one.even.iter().chain(&one.odd)).all(vanishes_always) {
            true => FirstLeft::Nothing,
            false => FirstLeft::NotKnown,
        }
    }

    fn next_left(&self, quantities: &[Planar], last: u32, told: &[u32]) -> NextLeft {
        let all = || quantities.iter().flat_map(|quantity| quantity.choose(&self.force, &self.moment));
        if !told.contains(&1) {
            let mut whole = quantities.iter().map(|quantity| self.first.whole(*quantity));
            if whole.clone().any(|whole| whole.is_left()) {
                return NextLeft::Order(1);
            }
            if !whole.all(|whole| whole.is_balanced()) {
                return NextLeft::NotKnown;
            }
        }
        for order in (2..=last.saturating_add(MOST_LOOKED_THROUGH)).filter(|order| !told.contains(order)) {
            let known: Vec<AtOrder> = all().map(|one| one.at(order)).collect();
            if known.contains(&AtOrder::Left) {
                return NextLeft::Order(order);
            }
            if known.contains(&AtOrder::SeveralLeft) {
                return NextLeft::NotKnown;
            }
        }
        match all().flat_map(|one| one.even.iter().chain(&one.odd)).all(vanishes_always) {
            true => NextLeft::None,
            false => NextLeft::NotKnown,
        }
    }
}

fn vanishes_always(class: &ClassPattern) -> bool {
    class.stars.factors().iter().any(|factor| factor.vanishes_always())
}
