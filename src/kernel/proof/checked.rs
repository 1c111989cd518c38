//! What was checked of a document, and what is not covered by it?

use std::collections::BTreeSet;

use num_rational::BigRational;

use super::audit::Counts;
use super::document::Document;
use super::engine::{Masses, RodStatement, TurningMassClaim};
use super::firing::FiringDocument;
use super::open::OpenDocument;
use super::quantity::Quantity;
use super::remedy::{RemedyDocument, TurningClaim};
use super::whole_sum::{WholeClaim, WholeOutcome};

/// What a check that found nothing wrong was about.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Checked {
    /// Whose masses; of several documents all, each once.
    pub masses: Vec<Masses>,
    /// The orders; of firing stars half ones too.
    pub orders: Vec<BigRational>,
    /// The quantities.
    pub quantities: Vec<Quantity>,
    /// Certificates and decimals.
    pub counts: Counts,
    /// Statements on whole orders that have several sums.
    pub wholes: usize,
    /// How many of them are left open: what is not decided, or whose rods are not known.
    pub open_wholes: usize,
    /// Shapes of the residuals.
    pub shapes: usize,
    /// Statements on every order.
    pub theorems: usize,
    /// What the document does not say, though a reader may think of it.
    pub not_covered: Vec<&'static str>,
}

const COEFFICIENTS: &str =
    "the coefficients c_k of the motion: that those of orders that exist are not zero is a theorem (src/kernel/motion)";
const FORMS: &str = "closed forms of the residual, and how robust a zero is (neither is in the document)";
const OTHER_ORDERS: &str = "the masses that turn at orders not asked for: no sum of the document is about them";
const EQUAL_RODS: &str = "that the rods are equal and centric: the document names none";
const SAME_RODS: &str = "that the rods are equal, so that each sum is one of the engine: families name none";
const NOT_SOLVED: &str = "the sums that are said to be `not-solved` or `equal-lengths`, and arcs and boxes that are `open`: no angles are claimed for them";
const WEIGHTS: &str = "weights in kilograms and metres, heights of shafts, partial balance (none is in the document)";

const LEFT_OUT: &str = "that the sums in `left_out` are zero: they are not, and all of an order together are below a millionth of the load";
const ONE_LAW: &str =
    "the pressure: a star that vanishes is about every law that all its cylinders share, with pistons of one size";
const TWIST: &str = "the twist of the crankshaft, which is taken to be rigid";
const MODE_SHAPE: &str = "the mode shape that weighs the stars: no layout gives one, so --engine compares none";
const EQUAL_RODS_OF_FIRING: &str = "that the rods are equal: the document names none";

impl Checked {
    pub(super) const OUTSIDE_OF_LOADS: &str = "the numbers that the document names in `not_checked`, but whether the values of `peaks` are 0, and that `largest` is not 0 where something is left";
    pub(super) const OUTSIDE_OF_COMPARISON: &str = "the numbers that the document names in `not_checked`";

    pub(super) fn classify(document: &Document, counts: Counts) -> Self {
        let rods_known = document.rods().is_ok_and(|rods| rods.is_some());
        let unknown = (!rods_known).then_some(EQUAL_RODS);
        // Of the roll moment nothing is said of every order.
        let is_idle = |mass: &TurningMassClaim| {
            !document.orders.contains(&mass.order) && (!document.all_orders || !mass.axis.is_empty())
        };
        let other = document.turning_masses.iter().any(is_idle).then_some(OTHER_ORDERS);
        let is_open = |whole: &&WholeClaim| match whole.outcome {
            WholeOutcome::NotDecided { .. } | WholeOutcome::Open => true,
            WholeOutcome::Zero | WholeOutcome::NotZero | WholeOutcome::NotZeroByEnclosure { .. } => false,
        };
        Checked {
            masses: vec![document.masses],
            orders: exact(&document.orders),
            quantities: document.quantities.clone(),
            counts,
            wholes: document.wholes.len(),
            open_wholes: document.wholes.iter().filter(is_open).count(),
            shapes: document.shapes.len(),
            theorems: document.theorems.len() + document.recurrences.len(),
            not_covered: [COEFFICIENTS, FORMS].into_iter().chain(other).chain(unknown).collect(),
        }
    }

    pub(super) fn family(document: &OpenDocument, all_solved: bool, counts: Counts) -> Self {
        let open = (!all_solved).then_some(NOT_SOLVED);
        Checked {
            masses: vec![document.masses],
            orders: exact(&document.orders),
            quantities: document.quantities.clone(),
            not_covered: [COEFFICIENTS, SAME_RODS].into_iter().chain(open).collect(),
            counts,
            ..Checked::default()
        }
    }

    pub(super) fn remedy(document: &RemedyDocument, rods_known: bool, counts: Counts) -> Self {
        let left_out = (!document.left_out.is_empty()).then_some(LEFT_OUT);
        let unknown = (!rods_known).then_some(EQUAL_RODS);
        let is_idle = |mass: &TurningClaim| !document.orders.contains(&mass.order);
        let other = document.turning_masses.iter().any(is_idle).then_some(OTHER_ORDERS);
        Checked {
            masses: vec![document.masses],
            orders: exact(&document.orders),
            quantities: document.quantities.clone(),
            not_covered: [WEIGHTS].into_iter().chain(left_out).chain(other).chain(unknown).collect(),
            counts,
            ..Checked::default()
        }
    }

    pub(super) fn firing(document: &FiringDocument, counts: Counts) -> Self {
        let rods_known = document.cylinders.iter().all(|cylinder| cylinder.rod != RodStatement::Unknown);
        let unknown = (!rods_known).then_some(EQUAL_RODS_OF_FIRING);
        let twist = if document.has_mode_shape() { MODE_SHAPE } else { TWIST };
        Checked {
            orders: document.orders.clone(),
            theorems: usize::from(document.pattern.is_some()),
            not_covered: [ONE_LAW, twist].into_iter().chain(unknown).collect(),
            counts,
            ..Checked::default()
        }
    }

    /// Of a document that holds others as its evidence.
    pub(super) fn evidence(documents: &[Document], outside: &'static str, counts: Counts) -> Self {
        let each: Vec<Checked> = documents.iter().map(|document| Checked::classify(document, counts)).collect();
        let total = |number: fn(&Checked) -> usize| each.iter().map(number).sum();
        Checked {
            masses: once(each.iter().flat_map(|one| one.masses.clone())),
            orders: once(each.iter().flat_map(|one| one.orders.clone())),
            quantities: once(each.iter().flat_map(|one| one.quantities.clone())),
            counts,
            wholes: total(|one| one.wholes),
            open_wholes: total(|one| one.open_wholes),
            shapes: total(|one| one.shapes),
            theorems: total(|one| one.theorems),
            not_covered: once(each.iter().flat_map(|one| one.not_covered.clone()).chain([outside])),
        }
    }
}

fn exact(orders: &[u32]) -> Vec<BigRational> {
    orders.iter().map(|&order| BigRational::from_integer(order.into())).collect()
}

fn once<T: Ord>(all: impl Iterator<Item = T>) -> Vec<T> {
    all.collect::<BTreeSet<T>>().into_iter().collect()
}
