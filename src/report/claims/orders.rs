//! What is said of many orders at once? Which are left, the first of them, and over how many it is known.

use super::super::residual;
use crate::claim::{Statement, Topic};
use crate::page::{Choice, Text, phrase};
use crate::proof::Quantity;
use crate::report::texts::claims as text;
use crate::verdict::OrderBalance;

/// More orders than this are not named.
const MOST_NAMED: usize = 6;

/// Of the orders that were asked, those that are left.
pub(super) struct Asked<'a> {
    pub surviving: &'a [u32],
    pub judged: usize,
    /// After this many orders everything repeats; none where single orders were asked.
    pub period: Option<u32>,
    pub first: Option<&'a OrderBalance>,
}

impl Asked<'_> {
    /// What is the case of them.
    pub fn finding(&self, statement: &Statement) -> Text {
        let Some(first) = self.first else { return self.nothing_left(statement) };
        let named = Text::joined(self.surviving.iter().take(MOST_NAMED).map(|&order| order.into()), ", ");
        let named = if self.surviving.len() > MOST_NAMED { phrase!("{}, …", named) } else { named };
        let what = what_is_left(first, statement);
        let is_lowest = self.surviving.iter().all(|order| *order >= first.order);
        let is_one = self.surviving.len() == 1;
        match self.period {
            Some(period) => text::orders_left(period, is_one, named, is_lowest, first.order, what),
            None if self.judged == 1 => text::only_order_left(first.order, what),
            None => text::asked_orders_left(self.judged, is_one, named, is_lowest, first.order, what),
        }
    }

    fn nothing_left(&self, statement: &Statement) -> Text {
        let of_free_moment = statement.topic() == Topic::FreeMoment;
        match self.period {
            Some(period) if of_free_moment => text::no_free_moment(period),
            Some(period) => text::all_vanish(period),
            None => text::all_asked_vanish(Choice::one_or_more(self.judged)),
        }
    }
}

/// The force and the moment of an order, as far as the statement is about them.
fn what_is_left(order: &OrderBalance, statement: &Statement) -> Text {
    let with_moment = match statement {
        Statement::Vanish { quantities, .. } => quantities.contains(&Quantity::MOMENT),
        other => matches!(other, Statement::NoFreeMoment),
    };
    let force = (!order.force.is_balanced()).then(|| phrase!("force {}", residual::force(order)));
    let moment = (with_moment && !order.moment.is_balanced()).then(|| residual::moment(order));
    Text::joined([force, moment].into_iter().flatten(), ", ")
}
