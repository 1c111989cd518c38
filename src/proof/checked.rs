//! What was checked of a document, and what is not covered by it?

use super::audit::Counts;
use super::document::Document;
use super::engine::{Masses, Quantity};
use super::open::OpenDocument;
use super::remedy::RemedyDocument;

/// What a check that found nothing wrong was about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// Whose masses.
    pub masses: Masses,
    /// The orders.
    pub orders: Vec<u32>,
    /// The quantities.
    pub quantities: Vec<Quantity>,
    /// Certificates and decimals.
    pub counts: Counts,
    /// Shapes of what is left.
    pub shapes: usize,
    /// Statements on every order.
    pub theorems: usize,
    /// What the document does not say, though a reader may think of it.
    pub not_covered: Vec<&'static str>,
}

const COEFFICIENTS: &str = "the coefficients c_k of the motion, and whether an order exists in the engine";
const FORMS: &str = "closed forms of what is left, and how firm a zero is (neither is in the document)";
const EQUAL_RODS: &str = "that the rods are equal and centric: the document names none";
const SAME_RODS: &str = "that the rods are equal, so that each sum is one of the engine: families name none";
const NOT_SOLVED: &str = "the sums that are said to be `not-solved` or `equal-lengths`: no angles are claimed for them";
const WEIGHTS: &str = "weights in kilograms and metres, heights of shafts, partial balance (none is in the document)";

impl Checked {
    pub(super) fn classify(document: &Document, rods_known: bool, counts: Counts) -> Self {
        let unknown = (!rods_known).then_some(EQUAL_RODS);
        Checked {
            masses: document.masses,
            orders: document.orders.clone(),
            quantities: document.quantities.clone(),
            counts,
            shapes: document.shapes.len(),
            theorems: document.theorems.len(),
            not_covered: [COEFFICIENTS, FORMS].into_iter().chain(unknown).collect(),
        }
    }

    pub(super) fn family(document: &OpenDocument, all_solved: bool, counts: Counts) -> Self {
        let open = (!all_solved).then_some(NOT_SOLVED);
        Checked {
            masses: document.masses,
            orders: document.orders.clone(),
            quantities: document.quantities.clone(),
            counts,
            shapes: 0,
            theorems: 0,
            not_covered: [COEFFICIENTS, SAME_RODS].into_iter().chain(open).collect(),
        }
    }

    pub(super) fn remedy(document: &RemedyDocument, rods_known: bool, counts: Counts) -> Self {
        let unknown = (!rods_known).then_some(EQUAL_RODS);
        Checked {
            masses: document.masses,
            orders: document.orders.clone(),
            quantities: document.quantities.clone(),
            counts,
            shapes: 0,
            theorems: 0,
            not_covered: [WEIGHTS].into_iter().chain(unknown).collect(),
        }
    }
}
