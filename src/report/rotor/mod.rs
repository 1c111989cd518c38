//! What is asked of masses on a shaft? What balances them, or what they leave; of a locomotive what its reciprocating masses do.

mod data;
mod page;

use super::question::Question;
use crate::exact::PhasorSum;
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

/// A star whose length matters: of forces, or of couples.
pub(in crate::report) struct LeftOver<'a> {
    /// Its name in the tables of data.
    pub column: &'static str,
    /// Its name on the page.
    pub name: &'static str,
    /// The star, in kilogram-metres or kilogram square metres.
    pub star: &'a PhasorSum,
    /// Whether it is one of couples.
    pub is_couple: bool,
}

impl LeftOver<'_> {
    /// Its length; 0 where it is proved to be.
    pub fn length(&self) -> f64 {
        if self.star.vanishes() { 0.0 } else { numbers::length(numbers::evaluate(self.star)) }
    }
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

    /// What is left of force and couple.
    pub(in crate::report) fn left(&self) -> Vec<LeftOver<'_>> {
        let Answer::Left(sums) = &self.answer else { return Vec::new() };
        let [force, couple] = &**sums;
        vec![
            LeftOver { column: "force", name: "Force", star: force, is_couple: false },
            LeftOver { column: "couple", name: "Couple about position 0", star: couple, is_couple: true },
        ]
    }

    /// What the reciprocating masses of a locomotive do.
    pub(in crate::report) fn of_locomotive(&self) -> Vec<LeftOver<'_>> {
        let Some(locomotive) = &self.locomotive else { return Vec::new() };
        let [one, other] = &locomotive.hammer_blow;
        let row = |column, name, star| LeftOver { column, name, star, is_couple: false };
        vec![
            row("hammer_blow_1", "Hammer blow of the first wheel", one),
            row("hammer_blow_2", "Hammer blow of the second wheel", other),
            row("tractive", "Variation of the tractive force", &locomotive.tractive),
            LeftOver { is_couple: true, ..row("swaying", "Swaying couple", &locomotive.swaying) },
        ]
    }

    /// ω² at the speed of the file.
    pub(in crate::report) fn omega_squared(&self) -> Option<f64> {
        self.rotor.speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)).powi(2))
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
        data::table(self, name)
    }

    fn answer(&self) -> Document {
        page::answer(self)
    }

    fn page(&self) -> Document {
        page::page(self)
    }
}
