//! What is said of a sweep in sentences? Each order in one, what vanishes in one, the firing in one.

use num_rational::BigRational;

use super::super::residual;
use super::amounts::{self, in_newtons, place, size, with_unit};
use super::findings::{Finding, listed};
use crate::numbers::float;
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

/// Where the cylinders fire most evenly; where offsets move the top dead centres, by what that is counted, and where these are most even.
pub(super) fn firing_sentences(sweep: &Sweep) -> impl Iterator<Item = Text> {
    let counted = sweep.dead_centres_apart.then(|| match most_even_centres(sweep) {
        Some((at, [least, most])) => text::firing_beside_dead_centres(at, least, most),
        None => text::firing_in_line(),
    });
    firing_sentence(sweep).into_iter().chain(counted)
}

/// Unevennesses that differ by fewer degrees are one value.
const ALIKE_DEGREES: f64 = 1e-9;

/// Where the top dead centres in firing order come most evenly, and at which intervals; none where the layout gives no firing order.
fn most_even_centres(sweep: &Sweep) -> Option<(Text, [Text; 2])> {
    let known: Vec<(f64, [f64; 2], &SweptEngine)> = sweep
        .points
        .iter()
        .filter_map(|point| dead_centres(point).map(|[least, most]| (most - least, [least, most], point)))
        .collect();
    let (uneven, ends, _) = known.iter().min_by(|one, other| one.0.total_cmp(&other.0))?;
    let best = known.iter().filter(|(other, ..)| other - uneven <= ALIKE_DEGREES);
    let at: Vec<Text> = best.map(|(.., point)| place(sweep, point)).collect();
    let at = if at.len() == sweep.points.len() { "every value".into() } else { listed(at) };
    Some((at, ends.map(Text::figures)))
}

/// The shortest and the longest interval from one top dead centre to the next in the file's firing order, in degrees.
pub(super) fn dead_centres(point: &SweptEngine) -> Option<[f64; 2]> {
    let firing = point.evenness.as_ref().filter(|evenness| evenness.of_the_file && !point.dead_centres_apart);
    let degrees = |turns: &BigRational| 360.0 * float(turns);
    point.dead_centres.or_else(|| firing.map(|one| [degrees(&one.shortest), degrees(&one.longest)]))
}

/// Where the cylinders fire most evenly, in one sentence, where that changes over the sweep.
fn firing_sentence(sweep: &Sweep) -> Option<Text> {
    let fires = |point: &SweptEngine| point.evenness.as_ref().is_some_and(|evenness| evenness.of_the_file);
    let of_the_file = sweep.points.iter().any(fires);
    let known = || {
        let known = sweep.points.iter().filter_map(|point| Some((point.evenness.as_ref()?, point)));
        known.filter(|(evenness, _)| evenness.of_the_file == of_the_file)
    };
    let best = known().map(|(evenness, _)| evenness).min_by_key(|evenness| evenness.unevenness())?;
    let at: Vec<&SweptEngine> =
        known().filter(|(evenness, _)| evenness.unevenness() == best.unevenness()).map(|(_, point)| point).collect();
    if at.len() == sweep.points.len() {
        return None;
    }
    let at = listed(at.into_iter().map(|point| place(sweep, point)).collect());
    let [shortest, longest] = [&best.shortest, &best.longest].map(number::turns);
    let in_line = sweep.dead_centres_apart;
    Some(match shortest == longest {
        true => text::even_firing(in_line, shortest, at, of_the_file),
        false => text::most_even_firing(in_line, shortest, longest, at, of_the_file),
    })
}
