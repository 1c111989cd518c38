//! What is asked of masses on a shaft? What balances them, or what they leave; of a locomotive what its reciprocating masses do.

mod data;
mod page;

use num_complex::Complex;

use super::question::question;
use crate::exact::PhasorSum;
use crate::file::Rotor;
use crate::numbers;
use crate::page::Text;
use crate::report::texts::rotor as text;
use crate::rotor::{self, Answer, Found, Locomotive, NotSolved, Secondary};

/// Masses on a shaft with what balances them.
#[derive(Clone, Debug)]
pub struct RotorStudy {
    /// The masses, as the file has them.
    pub rotor: Rotor,
    /// What balances them.
    pub answer: Answer,
    /// What a locomotive does, where its wheels carry the wanted masses.
    pub locomotive: Option<Locomotive>,
    /// What cranks leave in the second order, where the file asks for it and all masses are known or found.
    pub secondary: Option<Secondary>,
}

/// A star whose length matters: of forces, or of couples.
pub(in crate::report) struct LeftOver<'a> {
    /// Its name in the tables of data.
    pub column: &'static str,
    /// Its name on the page.
    pub name: Text,
    /// The star, in kilogram-metres or kilogram square metres; none where it is known in decimals alone.
    pub star: Option<&'a PhasorSum>,
    /// Its sum.
    pub sum: Complex<f64>,
    /// Whether it is of order 2, to be multiplied by c₂ as well.
    pub is_secondary: bool,
    /// Whether it is one of couples.
    pub is_couple: bool,
}

impl<'a> LeftOver<'a> {
    fn new(column: &'static str, name: impl Into<Text>, star: &'a PhasorSum) -> Self {
        LeftOver {
            column,
            name: name.into(),
            star: Some(star),
            sum: numbers::evaluate(star),
            is_couple: false,
            is_secondary: false,
        }
    }

    fn couple(self) -> Self {
        LeftOver { is_couple: true, ..self }
    }

    /// Whether it is proved to be 0.
    pub fn vanishes(&self) -> bool {
        self.star.is_some_and(PhasorSum::vanishes)
    }

    /// Its length; 0 where it is proved to be.
    pub fn length(&self) -> f64 {
        if self.vanishes() { 0.0 } else { numbers::length(self.sum) }
    }
}

impl RotorStudy {
    /// What balances these masses.
    ///
    /// # Errors
    /// Unknowns that are not solved for.
    pub fn new(rotor: Rotor) -> Result<Self, NotSolved> {
        let answer = rotor::balance(&rotor)?;
        // Mirrored solutions leave the same.
        let first = match &answer {
            Answer::Found(solutions) => solutions.first().map(Vec::as_slice),
            Answer::Balanced | Answer::Residual(_) => Some(&[][..]),
            Answer::Never(_) | Answer::Many(_) => None,
        };
        let secondary = first.filter(|_| rotor.secondary).and_then(|found| rotor::secondary(&rotor, found));
        Ok(RotorStudy { locomotive: rotor::locomotive(&rotor), answer, secondary, rotor })
    }

    /// All solutions.
    pub fn solutions(&self) -> &[Vec<Found>] {
        match &self.answer {
            Answer::Found(solutions) => solutions,
            Answer::Balanced | Answer::Residual(_) | Answer::Never(_) | Answer::Many(_) => &[],
        }
    }

    /// What is left of force and couple.
    pub(in crate::report) fn left(&self) -> Vec<LeftOver<'_>> {
        let Answer::Residual(sums) = &self.answer else { return Vec::new() };
        let [force, couple] = &**sums;
        vec![
            LeftOver::new("force", "Force", force),
            LeftOver::new("couple", "Couple about position 0", couple).couple(),
        ]
    }

    /// What is left in the second order.
    pub(in crate::report) fn of_second_order(&self) -> Vec<LeftOver<'_>> {
        let Some(Secondary { sums: [force, couple], exact }) = &self.secondary else { return Vec::new() };
        let row = |column, name: Text, sum: &Complex<f64>, index: usize| LeftOver {
            column,
            name,
            star: exact[index].as_ref(),
            sum: *sum,
            is_couple: index == 1,
            is_secondary: true,
        };
        vec![
            row("secondary_force", "Secondary force, times ω² c₂".into(), force, 0),
            row("secondary_couple", text::secondary_couple(), couple, 1),
        ]
    }

    /// What the reciprocating masses of a locomotive do.
    pub(in crate::report) fn of_locomotive(&self) -> Vec<LeftOver<'_>> {
        let Some(locomotive) = &self.locomotive else { return Vec::new() };
        let [one, other] = &locomotive.hammer_blow;
        let row = LeftOver::new;
        vec![
            row("hammer_blow_1", "Hammer blow of the first wheel", one),
            row("hammer_blow_2", "Hammer blow of the second wheel", other),
            row("tractive", "Variation of the tractive force", &locomotive.tractive),
            row("swaying", "Swaying couple", &locomotive.swaying).couple(),
        ]
    }

    /// ω² at the speed of the file.
    pub(in crate::report) fn omega_squared(&self) -> Option<f64> {
        self.rotor.speed.as_ref().map(|speed| numbers::angular_speed(numbers::float(speed)).powi(2))
    }
}

question!(RotorStudy, "rotor", |study| Some(&study.rotor.title));
