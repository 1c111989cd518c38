//! Which of all orders vanish, where the rods differ or have offsets, or the pattern is long? Told class by class, even and odd orders apart.
//!
//! Of the cylinders whose rods have one λ and one |δ| every order from 2 on is one sum times a number that is not zero where
//! the order exists, the weights of negative offsets reversed in odd orders (theory, section 2).

mod candidates;
mod factor;
mod next;
mod rays;

use std::collections::BTreeMap;

use super::theorem::{NoTheorem, Theorem, theorem};
use super::{OrderVerdict, of_order};
use crate::engine::Engine;
use crate::order::{Coefficients, Factor, Masses, Source, Sources, multiples};
use crate::proof::{Planar, Sense};

pub use candidates::MOST_CANDIDATES;
pub use factor::FactorPattern;
pub use next::{FirstLeft, NextLeft};
use rays::{Factors, Ray};

/// What is true of every order: one statement where every order is a single sum of a short pattern, else one for each class.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "an engine has one of them")]
pub enum EveryOrderTheorem {
    /// The rods are equal and centric, the period is short.
    Period(Theorem),
    /// Class by class.
    Recurrences(Recurrences),
}

impl EveryOrderTheorem {
    /// Whose masses it is about.
    pub fn masses(&self) -> Masses {
        match self {
            EveryOrderTheorem::Period(theorem) => theorem.masses,
            EveryOrderTheorem::Recurrences(all) => all.masses,
        }
    }
}

/// The statements on every order, class by class.
#[derive(Clone, Debug)]
pub struct Recurrences {
    /// Whose masses they are about.
    pub masses: Masses,
    /// Order 1, judged as any other.
    pub first: OrderVerdict,
    /// The force: direct, reverse.
    pub force: [Recurrence; 2],
    /// The moment: direct, reverse.
    pub moment: [Recurrence; 2],
}

/// One vector at every order from 2 on.
#[derive(Clone, Debug)]
pub struct Recurrence {
    /// Force or moment.
    pub quantity: Planar,
    /// Direct or reverse.
    pub sense: Sense,
    /// The classes that have the even orders.
    pub even: Vec<ClassPattern>,
    /// Those that have the odd orders.
    pub odd: Vec<ClassPattern>,
}

/// The cylinders that are multiplied by one number at all orders of a parity.
#[derive(Clone, Debug)]
pub struct ClassPattern {
    /// The cylinders.
    pub sources: Vec<Source>,
    /// Their sum.
    pub stars: Stars,
}

/// A sum at all orders of a parity.
#[derive(Clone, Debug)]
pub enum Stars {
    /// By itself.
    One(FactorPattern),
    /// The banks are alike: it is the product of two, each with a period of its own.
    Banks {
        /// The star of one bank.
        bank: FactorPattern,
        /// The star of the banks.
        banks: FactorPattern,
    },
}

impl Stars {
    /// The factors of the sum.
    pub fn factors(&self) -> Vec<&FactorPattern> {
        match self {
            Stars::One(star) => vec![star],
            Stars::Banks { bank, banks } => vec![bank, banks],
        }
    }
}

/// What is known of one vector at an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtOrder {
    /// It is zero, whatever the rods are.
    Zero,
    /// It is left, whatever the rods are.
    Left,
    /// Several classes are left, which these rods could make cancel: the order has to be judged by itself.
    SeveralLeft,
}

impl ClassPattern {
    /// Whether the sum is zero at an order of its parity.
    pub fn vanishes(&self, order: u32) -> bool {
        self.stars.factors().iter().any(|factor| factor.claim.zeros.contains(order))
    }
}

impl Recurrence {
    /// The classes that have an order above 1.
    pub fn classes(&self, order: u32) -> &[ClassPattern] {
        if order.is_multiple_of(2) { &self.even } else { &self.odd }
    }

    /// What is known of an order above 1.
    pub fn at(&self, order: u32) -> AtOrder {
        match self.classes(order).iter().filter(|class| !class.vanishes(order)).count() {
            0 => AtOrder::Zero,
            1 => AtOrder::Left,
            _ => AtOrder::SeveralLeft,
        }
    }
}

/// What is true of every order of these masses.
///
/// # Errors
/// Where links or crankshafts of several speeds add sums of other kinds, a shaft turns faster than the crank, or the pattern is longer than
/// what is gone through.
pub fn every_order(engine: &Engine, masses: Masses) -> Result<EveryOrderTheorem, NoTheorem> {
    if !engine.has_one_vector_per_order() {
        return Err(NoTheorem::RodsDiffer);
    }
    if let Some(crank) = engine.faster_crank() {
        return Err(NoTheorem::FasterCrank(crank.speed));
    }
    let sources = Sources::new(engine, masses);
    if let Some(mass) = sources.turning().iter().find(|mass| mass.order > 1) {
        return Err(NoTheorem::Shaft(mass.order));
    }
    if let Some(theorem) = theorem(engine, &sources) {
        return Ok(EveryOrderTheorem::Period(theorem));
    }
    let first = of_order(&sources, 1, &[], &Coefficients::default());
    let both = |quantity| -> Result<[Recurrence; 2], NoTheorem> {
        Ok([recurrence(&sources, quantity, Sense::Direct)?, recurrence(&sources, quantity, Sense::Reverse)?])
    };
    let (force, moment) = (both(Planar::Force)?, both(Planar::Moment)?);
    Ok(EveryOrderTheorem::Recurrences(Recurrences { masses, first, force, moment }))
}

fn recurrence(sources: &Sources, quantity: Planar, sense: Sense) -> Result<Recurrence, NoTheorem> {
    let even = classes(sources, quantity, sense, 2)?;
    let odd = classes(sources, quantity, sense, 3)?;
    Ok(Recurrence { quantity, sense, even, odd })
}

/// The classes of all orders with the parity of this one, in the order of their first cylinder.
fn classes(
    sources: &Sources,
    quantity: Planar,
    sense: Sense,
    first_order: u32,
) -> Result<Vec<ClassPattern>, NoTheorem> {
    let mut places: BTreeMap<Factor, usize> = BTreeMap::new();
    let mut classes: Vec<(Vec<Source>, Vec<Ray>)> = Vec::new();
    for (source, factor, term) in sources.terms(quantity.into(), first_order, Some(sense)) {
        let Some(piston) = source.piston().filter(|_| factor.exists(first_order)) else { continue };
        let place = *places.entry(factor).or_insert(classes.len());
        if place == classes.len() {
            classes.push((Vec::new(), Vec::new()));
        }
        let cylinder = &sources.engine().cylinders()[piston];
        let [of_throw, _] = multiples(1, Some(sense));
        let per_order = (&cylinder.throw - &cylinder.bank).times(of_throw);
        classes[place].0.push(source);
        classes[place].1.push(Ray { per_order, fixed: cylinder.bank.clone(), weight: term.weight });
    }
    let judge = |(sources, rays): (Vec<Source>, Vec<Ray>)| {
        let of = |rays| FactorPattern::new(rays, first_order);
        let stars = match rays::factors(rays) {
            Factors::One(rays) => Stars::One(of(rays)?),
            Factors::Banks { bank, banks } => Stars::Banks { bank: of(bank)?, banks: of(banks)? },
        };
        Ok(ClassPattern { sources, stars })
    };
    classes.into_iter().map(judge).collect()
}
