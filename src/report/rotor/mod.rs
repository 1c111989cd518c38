//! What is asked of masses on a shaft? What balances them, or what they leave; of a locomotive what its reciprocating masses do.

mod page;

use std::f64::consts::TAU;

use super::data;
use super::question::Question;
use crate::file::Rotor;
use crate::numbers;
use crate::page::Document;
use crate::rotor::{self, Answer, Found, Locomotive, NotSolved};
use crate::table::Table;
use crate::text::Untrusted;

/// Masses on a shaft with what balances them.
#[derive(Clone, Debug)]
pub struct RotorStudy {
    /// The masses, as the file has them.
    pub rotor: Rotor,
    /// What balances them.
    pub answer: Answer,
    /// What a locomotive does, where its wheels carry the wanted masses.
    pub locomotive: Option<Locomotive>,
}

impl RotorStudy {
    /// What balances these masses.
    ///
    /// # Errors
    /// Unknowns that are not solved for.
    pub fn new(rotor: Rotor) -> Result<Self, NotSolved> {
        Ok(RotorStudy { answer: rotor::balance(&rotor)?, locomotive: rotor::locomotive(&rotor), rotor })
    }

    /// All solutions.
    pub fn solutions(&self) -> &[Vec<Found>] {
        match &self.answer {
            Answer::Found(solutions) => solutions,
            Answer::Balanced | Answer::Left(_) | Answer::Never(_) | Answer::Many(_) => &[],
        }
    }

    /// ω² at the speed of the file.
    pub(in crate::report) fn omega_squared(&self) -> Option<f64> {
        self.rotor.speed.as_ref().map(|speed| (numbers::float(speed) / 60.0 * TAU).powi(2))
    }
}

impl Question for RotorStudy {
    fn command(&self) -> &'static str {
        "rotor"
    }

    fn title(&self) -> Option<&Untrusted> {
        Some(&self.rotor.title)
    }

    fn table(&self, name: &str) -> Option<Table> {
        data::rotor(self, name)
    }

    fn answer(&self) -> Document {
        page::answer(self)
    }

    fn page(&self) -> Document {
        page::page(self)
    }
}
