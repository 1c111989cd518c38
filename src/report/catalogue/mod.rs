//! What does the catalogue hold? Each engine with the orders that it leaves, by families: a list, pictures.

mod document;
mod gallery;
mod page;
mod small;
mod stamp;

pub use document::{CatalogueDocument, catalogue_document};
pub use gallery::pictures as catalogue_pictures;
pub use page::catalogue_answer;
pub(super) use stamp::Stamp;

use super::residual;
use crate::engine::{Engine, Form};
use crate::file::Entry;
use crate::loads;
use crate::order::Masses;
use crate::page::Text;
use crate::proof::{Planar, Shape};
use crate::report::texts::catalogue as text;
use crate::verdict::{
    self, EveryOrder, EveryOrderTheorem, FirstLeft, NoTheorem, OrderBalance, OrderVerdict, WholeOrder,
};

/// An engine of the catalogue, judged.
pub struct KnownEngine<'a> {
    /// Its name.
    pub name: &'static str,
    /// The engine.
    pub engine: &'a Engine,
    /// The statements on every order.
    pub theorem: Result<EveryOrderTheorem, NoTheorem>,
}

/// The engines of the catalogue that are built alike.
pub struct CatalogueFamily<'a> {
    /// The name of its picture.
    pub file: &'static str,
    /// What it is called.
    pub heading: &'static str,
    /// Its engines, in the order of the catalogue.
    pub engines: Vec<KnownEngine<'a>>,
}

/// The catalogue by families, in the order in which they come first.
pub fn catalogue_families(engines: &[(Entry, Engine)]) -> Vec<CatalogueFamily<'_>> {
    let mut families: Vec<CatalogueFamily> = Vec::new();
    for (entry, engine) in engines {
        let theorem = verdict::every_order(engine, Masses::Reciprocating);
        let known = KnownEngine { name: entry.name, engine, theorem };
        let (file, heading) = family(engine.form());
        match families.iter_mut().find(|family| family.file == file) {
            Some(family) => family.engines.push(known),
            None => families.push(CatalogueFamily { file, heading, engines: vec![known] }),
        }
    }
    families
}

fn family(form: Form) -> (&'static str, &'static str) {
    match form {
        Form::Inline => ("stars-in-line", "In line"),
        Form::Vee | Form::Vr => ("stars-v", "V engines"),
        Form::Flat | Form::Boxer => ("stars-boxer", "Boxer engines"),
        Form::Fan | Form::W => ("stars-w", "W engines"),
        Form::Radial => ("stars-radial", "Radial engines"),
        Form::OpposedPiston | Form::U | Form::H | Form::Delta => ("stars-geared", "Engines with several crankshafts"),
        Form::General => ("stars-other", "Other engines"),
    }
}

/// The lowest order of the force and of the moment that is left, with its shape; none of all where it is not known.
pub(super) fn first_left(theorem: &EveryOrderTheorem, engine: &Engine) -> Option<[Option<(u32, Shape)>; 2]> {
    let first = |quantity| match theorem.first_left(engine, quantity) {
        FirstLeft::Nothing => Some(None),
        FirstLeft::Order(order, shape) => Some(Some((order, shape))),
        FirstLeft::NotKnown => None,
    };
    Some([first(Planar::Force)?, first(Planar::Moment)?])
}

/// What is left first of the force, or of the moment.
pub struct FirstOrderLeft {
    /// The order.
    pub order: u32,
    /// What it traces.
    pub shape: Shape,
    /// How large it is, where one sum says it.
    pub size: Option<Text>,
}

impl KnownEngine<'_> {
    /// What is left first of the force and of the moment; none where nothing is known of every order.
    pub fn first(&self) -> Option<[Option<FirstOrderLeft>; 2]> {
        let theorem = match &self.theorem {
            Ok(EveryOrderTheorem::Period(theorem)) => theorem,
            Ok(several @ EveryOrderTheorem::Recurrences(_)) => return self.first_of_classes(several),
            Err(_) => return self.first_of_links(),
        };
        Some([&theorem.force, &theorem.moment].map(|every: &EveryOrder| {
            let first = every.first.as_ref()?;
            Some(FirstOrderLeft {
                order: first.direct.order,
                shape: first.shape,
                size: Some(residual::largest(first).into()),
            })
        }))
    }

    /// The same where every order is reported class by class.
    fn first_of_classes(&self, theorem: &EveryOrderTheorem) -> Option<[Option<FirstOrderLeft>; 2]> {
        let first = |(order, shape)| FirstOrderLeft { order, shape, size: None };
        Some(first_left(theorem, self.engine)?.map(|left| left.map(first)))
    }

    /// The same of an engine with articulated rods: at the orders that it asks for, or proved to be zero at every order.
    fn first_of_links(&self) -> Option<[Option<FirstOrderLeft>; 2]> {
        let wanted = self.engine.only_rods().is_err().then(|| self.engine.orders())?;
        let judged = verdict::classify(self.engine, wanted, Masses::Reciprocating, &[]).ok()?;
        let first = |whole: &dyn Fn(&OrderVerdict) -> WholeOrder| {
            let mut orders = judged.iter().filter(|order| order.exists()).map(|order| (order.order, whole(order)));
            let left = orders.find(|(_, whole)| !whole.is_balanced());
            left.map(|(order, whole)| FirstOrderLeft { order, shape: whole.shape, size: None })
        };
        let found = [
            (Planar::Force, first(&|order| order.force.clone())),
            (Planar::Moment, first(&|order| order.moment.clone())),
        ];
        // That nothing is left at these orders says nothing of all, unless that is proved.
        let is_known = |(quantity, first): &(Planar, Option<FirstOrderLeft>)| {
            first.is_some() || loads::vanishes_at_every_order(self.engine, (*quantity).into())
        };
        found.iter().all(is_known).then(|| found.map(|(_, first)| first))
    }

    /// The lowest order that is left; none where nothing is, and where nothing is known of every order.
    pub fn lowest(&self) -> Option<u32> {
        self.first()?.into_iter().flatten().map(|first| first.order).min()
    }

    /// The verdicts on the lowest order that is left; on order 1 where nothing is.
    pub fn drawn(&self) -> Option<OrderBalance> {
        let order = self.lowest().unwrap_or(1);
        let judged = verdict::classify(self.engine, &[order], Masses::Reciprocating, &[]).ok()?;
        judged.into_iter().next()?.parts.into_iter().next()
    }
}

/// What is said of the whole catalogue: which engines leave nothing of orders 1 and 2, and which nothing at all.
pub fn catalogue_summary(families: &[CatalogueFamily]) -> Vec<Text> {
    let names = |of: &dyn Fn(&KnownEngine) -> bool| {
        let engines = families.iter().flat_map(|family| &family.engines);
        Text::joined(engines.filter(|known| of(known)).map(|known| Text::label(known.name)), ", ")
    };
    let is_known = |known: &KnownEngine| known.theorem.is_ok();
    let never = names(&|known| is_known(known) && known.lowest().is_none());
    let late = names(&|known| known.lowest().is_some_and(|order| order > 2));
    let mut lines = Vec::new();
    if !never.is_empty() {
        lines.push(text::every_order(never));
    }
    if !late.is_empty() {
        lines.push(text::orders_1_and_2(late));
    }
    let rotating = names(&|known| known.drawn().is_some_and(|order| order.order == 1 && turns_with_crank(&order)));
    if !rotating.is_empty() {
        lines.push(text::order_1_removed(rotating));
    }
    lines
}

/// Whether what is left of an order turns with the crank, and something is.
fn turns_with_crank(order: &OrderBalance) -> bool {
    let balances = [&order.force, &order.moment];
    balances.iter().all(|balance| balance.reverse.vanishes())
        && balances.iter().any(|balance| !balance.direct.vanishes())
}
