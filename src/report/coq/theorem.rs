//! Which theorems does the file hold, and by what are they proved?

use super::engine::sense;
use crate::proof::{Quantity, Sense};

/// A theorem with its proof.
pub(super) struct Theorem {
    /// Letters, digits and `_`: nothing that a person wrote.
    pub name: String,
    /// All of it.
    pub text: String,
}

impl Theorem {
    /// A theorem that a lemma of Checker.v shows, once its premise is computed.
    pub fn new(name: String, statement: &str, lemma: &str) -> Self {
        let text = format!("Theorem {name} :\n  {statement}.\nProof. apply: {lemma}; vm_compute; reflexivity. Qed.\n");
        Theorem { name, text }
    }

    /// A theorem that one term proves.
    pub fn exact(name: String, statement: &str, term: &str) -> Self {
        let text = format!("Theorem {name} :\n  {statement}.\nProof. exact: ({term}). Qed.\n");
        Theorem { name, text }
    }
}

/// What a theorem is called: of letters alone.
pub(super) fn name(quantity: Quantity, sense: Option<Sense>) -> String {
    match sense {
        Some(sense) => format!("{}_{}", quantity.name(), sense.name()),
        None => quantity.name().to_owned(),
    }
}

pub(super) fn kind(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::FORCE => "Force",
        Quantity::MOMENT => "Moment",
        Quantity::Axial(_) => "Torque",
    }
}

/// The quantity as Engine.v calls it.
pub(super) fn vector(quantity: Quantity, of: Option<Sense>) -> String {
    match of {
        Some(of) => format!("({} {})", kind(quantity), sense(of)),
        None => kind(quantity).to_owned(),
    }
}
