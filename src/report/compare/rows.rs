//! Which rows does a comparison have? A column per engine: sizes and cures first, the exact verdicts below.

use super::super::calculation::percent_at_most;
use super::super::engine_page::{Rest, Weighed, Weighing, circumstances};
use super::super::{bearings, engine_cells, residual};
use super::{Compared, orders_of};
use crate::engine::{Engine, LengthUnit};
use crate::loads::Missing;
use crate::page::{self, Piece, Table, Text, phrase};
use crate::proof::{Planar, Quantity};
use crate::report::texts::compare as text;
use crate::sweep::dead_centre_intervals;
use crate::torque::GuideMoments;
use crate::verdict::OrderVerdict;

/// An engine that is compared, with the sizes of its orders where it has any.
pub(super) struct Sized<'a> {
    pub compared: &'a Compared,
    pub weighed: Option<Weighed<'a>>,
}

impl<'a> Sized<'a> {
    pub fn new(compared: &'a Compared) -> Self {
        let orders: Vec<u32> = compared.judged.orders.iter().map(|order| order.order).collect();
        let weighed = Weighed::new(&compared.engine, compared.judged.masses, &orders, Weighing::usual());
        Sized { compared, weighed: weighed.map(Weighed::beside_others) }
    }

    /// Whether the force or the moment of an order is worth a row: it is large beside the others, or its size is not known.
    fn is_told(&self, order: u32, quantity: Planar) -> bool {
        let Some(verdict) = self.compared.at(order) else { return false };
        let is_told = |weighed: &Weighed| weighed.is_told(order, quantity);
        !verdict.whole(quantity).is_balanced() && verdict.exists() && self.weighed.as_ref().is_none_or(is_told)
    }

    /// `1.17 m r ω², planar`; exactly where it has no size.
    fn size(&self, order: u32, quantity: Planar) -> Text {
        let Some(verdict) = self.compared.at(order) else { return Text::default() };
        let whole = verdict.whole(quantity);
        let weighed = self.weighed.as_ref().filter(|_| whole.is_left() && whole.is_decided());
        match weighed.and_then(|weighed| weighed.amount(weighed.size(order, quantity), quantity)) {
            Some(size) => phrase!("{}, {}", size, residual::shape_name(whole.shape)),
            None => engine_cells::cell(verdict, quantity),
        }
    }

    /// What the orders without a row, and all that are not compared, add up to at most.
    fn rest(&self, quantity: Planar) -> Text {
        match self.weighed.as_ref().and_then(|weighed| weighed.rest(quantity, &self.compared.judged.orders).1) {
            None => "–".into(),
            Some(Rest::Part(part)) => phrase!("{} % of the largest", percent_at_most(part)),
            Some(Rest::Amount(amount)) => amount,
        }
    }

    /// The largest order of the roll moment, or of the inertia torque.
    fn roll(&self) -> Option<Text> {
        let weighed = self.weighed.as_ref()?;
        let quantity = weighed.loads.rolling()?;
        let orders = weighed.about_the_axis(quantity).into_iter();
        let (order, size) = orders.max_by(|(_, one), (_, other)| one.total_cmp(other))?;
        if size == 0.0 {
            return Some("0".into());
        }
        Some(phrase!("{} (order {})", weighed.amount(size, Quantity::Axial(quantity))?, order))
    }
}

/// Why sizes in different units do not compare, and what would make them; none where all are in one.
pub(super) fn apart(all: &[Sized]) -> Option<Text> {
    let weighed = || all.iter().filter_map(|engine| Some((engine, engine.weighed.as_ref()?)));
    let names = |of: fn(&Weighed) -> bool| {
        let meant = weighed().filter(|(_, weighed)| of(weighed));
        Text::joined(meant.map(|(engine, _)| (&engine.compared.name).into()), ", ")
    };
    let differ = |of: fn(&Weighed) -> bool| {
        let first = weighed().next().map(|(_, weighed)| of(weighed));
        weighed().any(|(_, weighed)| Some(of(weighed)) != first)
    };
    if differ(in_multiples) {
        return Some(text::multiples_apart(names(in_multiples)));
    }
    differ(in_spacings).then(|| text::spacings_apart(names(in_spacings)))
}

fn in_multiples(weighed: &Weighed) -> bool {
    weighed.loads.scale.is_none()
}

fn in_spacings(weighed: &Weighed) -> bool {
    weighed.engine.length_unit() == LengthUnit::Spacing
}

/// The table of sizes of some of the engines that are compared: a column per engine, a row for each thing that any of all has.
pub(super) fn sizes(all: &[Sized], shown: &[Sized]) -> Table {
    let mut table = with_names(shown);
    let mut add = |name: Text, cell: &dyn Fn(&Sized) -> Text| {
        table.push([name].into_iter().chain(shown.iter().map(cell)).collect());
    };
    add("Title".into(), &|engine| engine.compared.engine.title().into());
    add("Cylinders".into(), &|engine| engine_cells::cylinders(&engine.compared.engine));
    add("Sizes".into(), &|engine| circumstances(engine.weighed.as_ref()).unwrap_or_else(|| "–".into()));
    for order in orders_of(all.iter().map(|engine| engine.compared)) {
        for (name, quantity) in [("Force, order {}", Planar::Force), ("Moment, order {}", Planar::Moment)] {
            if all.iter().any(|engine| engine.is_told(order, quantity)) {
                add(phrase!(name, order), &|engine| engine.size(order, quantity));
            }
        }
    }
    add("Other forces, at most".into(), &|engine| engine.rest(Planar::Force));
    add("Other moments, at most".into(), &|engine| engine.rest(Planar::Moment));
    if all.iter().any(|engine| engine.roll().is_some()) {
        add("Roll moment".into(), &|engine| engine.roll().unwrap_or_else(|| "–".into()));
    }
    let of_guides: [(&str, OfGuides); 2] =
        [("H, rocking", |moments| moments.rocking), ("X, twisting", |moments| moments.twisting)];
    for (name, of) in of_guides {
        if all.iter().any(|engine| !engine.compared.guides.is_empty()) {
            add(name.into(), &|engine| guide(engine.compared, of));
        }
    }
    add("Firing".into(), &|engine| firing(&engine.compared.engine));
    if all.iter().any(|engine| engine.compared.engine.firing().is_some()) {
        add("Firing order".into(), &|engine| engine_cells::firing_order(&engine.compared.engine));
    }
    add("Cures".into(), &|engine| engine_cells::remedy(&engine.compared.cures));
    if all.iter().any(|engine| engine.compared.bearings.as_ref().err() != Some(&Missing::Bearings)) {
        add("Worst main bearing".into(), &|engine| worst_bearing(engine.compared));
        add("Its other orders".into(), &|engine| Text::or_dash(other_orders(engine.compared)));
    }
    if all.iter().any(|engine| engine.compared.with_gas.is_some()) {
        add("Worst main bearing with gas".into(), &|engine| worst_with_gas(engine.compared));
    }
    table
}

/// One of the guide-force moments of an order.
type OfGuides = fn(&GuideMoments) -> Option<f64>;

/// The largest order of a guide-force moment.
fn guide(engine: &Compared, of: OfGuides) -> Text {
    let sizes = engine.guides.iter().map(|moments| (of(moments), moments.order));
    match sizes.max_by(|(one, _), (other, _)| one.unwrap_or(0.0).total_cmp(&other.unwrap_or(0.0))) {
        None => "–".into(),
        Some((None, _)) => Text::zero(),
        Some((Some(size), order)) => {
            phrase!("{} (order {})", Text::from(Piece::Quantity(size, page::Unit::NEWTON_METRE)), order.to_string())
        }
    }
}

/// A table with a column per engine.
fn with_names(shown: &[Sized]) -> Table {
    let names = shown.iter().map(|engine| (&engine.compared.name).into());
    Table::new([Text::default()].into_iter().chain(names))
}

/// The exact verdicts of some of the engines that are compared.
pub(super) fn verdicts(all: &[Sized], shown: &[Sized]) -> Table {
    let mut table = with_names(shown);
    let mut add = |name: Text, cell: &dyn Fn(&Compared) -> Text| {
        table.push([name].into_iter().chain(shown.iter().map(|engine| cell(engine.compared))).collect());
    };
    for order in orders_of(all.iter().map(|engine| engine.compared)) {
        for (name, alone, quantity) in [
            ("Force {}", "Force {}, pistons alone", Planar::Force),
            ("Moment {}", "Moment {}, pistons alone", Planar::Moment),
        ] {
            let words = |judged: Option<&OrderVerdict>| {
                judged.map_or_else(Text::default, |judged| engine_cells::cell(judged, quantity))
            };
            add(phrase!(name, order), &|engine| words(engine.at(order)));
            if all.iter().any(|engine| engine.compared.pistons_at(order).is_some()) {
                add(phrase!(alone, order), &|engine| words(engine.pistons_at(order).or(engine.at(order))));
            }
        }
    }
    let first = |engine: &Compared| engine_cells::first_left(&engine.engine, &engine.theorem, &engine.judged.orders);
    add("Force from order".into(), &|engine| first(engine)[0].clone());
    add("Moment from order".into(), &|engine| first(engine)[1].clone());
    add("All cures".into(), &|engine| engine_cells::remedy(&engine.remedy));
    table
}

/// Firing intervals are those of crankpins in line with their cylinders; where offsets move the top dead centres, theirs are beside them.
fn firing(engine: &Engine) -> Text {
    let firing = engine_cells::firing(engine.firing());
    match dead_centre_intervals(engine).map(|ends| ends.map(Text::figures)) {
        Some([least, most]) => phrase!("{}; top dead centres: ≈ {}° to ≈ {}°", firing, least, most),
        None => firing,
    }
}

/// What the orders that are not counted add at most to the load of a bearing.
fn other_orders(engine: &Compared) -> Option<Text> {
    bearings::left_out_in_short(&engine.engine, engine.bearings.as_ref().ok()?).map(|most| phrase!("at most {}", most))
}

fn worst_bearing(engine: &Compared) -> Text {
    match &engine.bearings {
        Ok(loads) => bearings::worst(loads).unwrap_or_else(|| "0 in all".into()),
        Err(Missing::Bearings) => "none given".into(),
        Err(Missing::Rods) => "not computed: no rods".into(),
        Err(_) => "not computed".into(),
    }
}

fn worst_with_gas(engine: &Compared) -> Text {
    match (&engine.with_gas, engine.worst_with_gas()) {
        (None, _) => "no gas loads".into(),
        (Some(Err(Missing::Bearings)), _) => "none given".into(),
        (Some(Err(_)), _) => "not computed".into(),
        (Some(Ok(_)), None) => "none given".into(),
        (Some(Ok(_)), Some((worst, peak))) => {
            let numbers: Vec<String> = worst.iter().map(|index| (index + 1).to_string()).collect();
            phrase!(
                "{} with {} {}",
                bearings::called(&numbers),
                Text::measured(peak.value, page::Unit::NEWTON),
                page::Unit::NEWTON
            )
        }
    }
}
