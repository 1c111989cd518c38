//! Where do the cylinders of a V stand? Banks, split pins, offset banks, and the orders that these settle for every star.

use num_rational::BigRational;
use num_traits::Zero;

use super::problem::Problem;
use crate::exact::Turn;
use crate::order;
use crate::proof::Sense;

/// One bank: its axis, how far ahead its pins stand, and how far its cylinders stand towards the free end.
#[derive(Clone, Debug)]
pub(super) struct Bank {
    pub axis: Turn,
    pub split: Turn,
    pub offset: BigRational,
}

impl Problem {
    /// The banks: one for an engine in line; of a V at −φ/2 and φ/2, half the offset before and behind the middle.
    pub(super) fn banks(&self) -> Vec<Bank> {
        let Some(angle) = &self.bank_angle else {
            return vec![Bank { axis: Turn::zero(), split: Turn::zero(), offset: BigRational::zero() }];
        };
        let half = |length: &BigRational| length / BigRational::from_integer(2.into());
        let axis = half(angle.turns());
        let offset = self.bank_offset.as_ref().map_or_else(BigRational::zero, half);
        let split = self.pin_split.clone().unwrap_or_else(Turn::zero);
        let first = Bank { axis: Turn::new(-&axis), split: Turn::zero(), offset: offset.clone() };
        vec![first, Bank { axis: Turn::new(axis), split, offset: -offset }]
    }

    /// Whether the moment of an order is the same in a V whatever its star is.
    pub(super) fn is_settled(&self, order: u32) -> bool {
        self.banks_cancel(order) && !self.is_entangled()
    }

    /// Whether the forces of an order of both cylinders of a throw add up to nothing, whatever its direction is; else those of the pins have to.
    pub(super) fn banks_cancel(&self, order: u32) -> bool {
        let banks = self.banks();
        let [first, second] = banks.as_slice() else { return false };
        let phase = |bank: &Bank, sense| order::phase_of(&bank.split, &bank.axis, order, Some(sense));
        let apart = |sense| &phase(second, sense) - &phase(first, sense);
        Sense::BOTH.into_iter().all(|sense| apart(sense) == Turn::fraction(1, 2))
    }

    /// Whether the moment of the V is no multiple of that of its pins: banks are offset, and forces of the pins may be left (README).
    pub(super) fn is_entangled(&self) -> bool {
        self.grid.is_some() && self.bank_offset.as_ref().is_some_and(|offset| !offset.is_zero())
    }

    /// The crank angles of top dead centre, bank after bank, of cylinders on these throws: `τ = α − β` (theory, section 1).
    pub(super) fn dead_centres_of(&self, throws: &[Turn]) -> Vec<Turn> {
        let of_bank = |bank: Bank| {
            let first = &bank.axis - &bank.split;
            throws.iter().map(move |throw| &first - throw)
        };
        self.banks().into_iter().flat_map(of_bank).collect()
    }

    /// The same for each bank and direction, after that of cylinder 1, whose direction is 0.
    pub(super) fn dead_centres(&self, directions: u32) -> Vec<Vec<Turn>> {
        let throws: Vec<Turn> = (0..directions).map(|d| Turn::fraction(d.into(), directions.into())).collect();
        let all = self.dead_centres_of(&throws);
        let after_first = |bank: &[Turn]| bank.iter().map(|angle| angle - &all[0]).collect();
        all.chunks(throws.len().max(1)).map(after_first).collect()
    }
}
