//! What is said of a sweep in sentences? Each order in one, what vanishes in one, the firing in one.

use super::super::residual;
use super::amounts::{self, in_newtons, place, size, with_unit};
use super::findings::{Finding, listed};
use crate::page::{Text, number, phrase};
use crate::proof::Planar;
use crate::report::texts::sweep as text;
use crate::sweep::{Sweep, SweptEngine, ZeroSet};

impl Finding<'_> {
    /// In a sentence.
    pub fn sentence(&self, sweep: &Sweep) -> Text {
        let name = name(self.quantity, self.order);
        let most = with_unit(sweep, self.quantity, self.greatest.amplitude);
        // The same unit is behind the greatest.
        let least = match in_newtons(sweep) {
            true => with_unit(sweep, self.quantity, self.least.amplitude),
            false => size(sweep, self.quantity, self.least.amplitude),
        };
        let [at_most, at_least] = [&self.greatest, &self.least].map(|of| of.places(sweep));
        let zeros =
            self.set.map_or_else(Vec::new, |set| amounts::zeros(&sweep.parameters[0], &set.at, &set.irrational));
        match self.set {
            _ if self.greatest.is_everywhere(sweep) && self.least.is_everywhere(sweep) => text::everywhere(name, most),
            Some(ZeroSet { complete: true, .. }) if !zeros.is_empty() => {
                text::zeros_and_most(name, Text::zero(), listed(zeros), most, at_most)
            }
            Some(ZeroSet { complete: false, .. }) if !zeros.is_empty() => {
                text::some_zeros_and_most(name, Text::zero(), listed(zeros), most, at_most)
            }
            Some(ZeroSet { complete: true, .. }) => text::never_zero(name, least, at_least, most, at_most),
            Some(_) | None if !self.zeros.is_empty() => {
                let at = listed(self.zeros.iter().map(|point| place(sweep, point)).collect());
                text::zeros_at_points(name, Text::zero(), at, most, at_most)
            }
            Some(_) | None => text::from_to(name, least, at_least, most, at_most),
        }
    }
}

/// `Moment of order 2`.
fn name(quantity: Planar, order: u32) -> Text {
    match quantity {
        Planar::Force => phrase!("Force of order {}", order),
        Planar::Moment => phrase!("Moment of order {}", order),
    }
}

/// What vanishes at every value, in one sentence.
pub(super) fn gone_sentence(gone: &[(Planar, u32)]) -> Option<Text> {
    let list = |of: Planar| -> Vec<u32> {
        gone.iter().filter(|(quantity, _)| *quantity == of).map(|(_, order)| *order).collect()
    };
    let (forces, moments) = (list(Planar::Force), list(Planar::Moment));
    let named = residual::orders_in_words;
    match (forces.is_empty(), moments.is_empty()) {
        (true, true) => None,
        (false, true) => Some(text::force_vanishes(named(&forces))),
        (true, false) => Some(text::moment_vanishes(named(&moments))),
        (false, false) => Some(text::both_vanish(named(&forces), named(&moments))),
    }
}

/// Where the cylinders fire most evenly, in one sentence, where that changes over the sweep.
pub(super) fn firing_sentence(sweep: &Sweep) -> Option<Text> {
    let known = || sweep.points.iter().filter_map(|point| Some((point.evenness.as_ref()?, point)));
    let best = known().map(|(evenness, _)| evenness).min_by_key(|evenness| evenness.unevenness())?;
    let at: Vec<&SweptEngine> =
        known().filter(|(evenness, _)| evenness.unevenness() == best.unevenness()).map(|(_, point)| point).collect();
    if at.len() == sweep.points.len() {
        return None;
    }
    let at = listed(at.into_iter().map(|point| place(sweep, point)).collect());
    let [shortest, longest] = [&best.shortest, &best.longest].map(number::turns);
    Some(match shortest == longest {
        true => text::even_firing(shortest, at),
        false => text::most_even_firing(shortest, longest, at),
    })
}
