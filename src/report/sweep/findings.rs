//! What does a sweep find of one order: where it is zero, where greatest, where least?

use num_rational::BigRational;

use super::amounts::{in_newtons, place, size, value, with_unit};
use super::plots::amplitudes;
use crate::page::{Text, phrase};
use crate::proof::Quantity;
use crate::sweep::{Amplitude, Sweep, SweptEngine, ZeroSet, Zeros};

/// More values than this are not listed in a sentence or a cell.
const MOST_LISTED: usize = 4;
/// Decimals that differ by less than this part are shown alike.
const ALIKE: f64 = 1e-9;

/// What the points say of the largest force, or the largest moment, of one order.
pub(super) struct Finding<'a> {
    pub quantity: Quantity,
    pub order: u32,
    pub greatest: Extreme<'a>,
    pub least: Extreme<'a>,
    /// The points at which it is proved to vanish.
    zeros: Vec<&'a SweptEngine>,
    /// The exact zeros, between the points too, where the parameter is an angle.
    set: Option<&'a ZeroSet>,
}

/// A greatest or a least amplitude, and where it is reached.
pub(super) struct Extreme<'a> {
    pub amplitude: Amplitude,
    at: Vec<&'a SweptEngine>,
}

/// What is found of each order, the force and the moment of an order beside each other; and those that vanish at every point.
pub(super) fn findings(sweep: &Sweep) -> (Vec<Finding<'_>>, Vec<(Quantity, u32)>) {
    let (mut found, mut gone) = (Vec::new(), Vec::new());
    for (place, &order) in sweep.orders.iter().enumerate() {
        for quantity in [Quantity::Force, Quantity::Moment] {
            match finding(sweep, quantity, order, place) {
                Some(finding) => found.push(finding),
                None => gone.push((quantity, order)),
            }
        }
    }
    (found, gone)
}

/// None where it vanishes at every point.
fn finding(sweep: &Sweep, quantity: Quantity, order: u32, index: usize) -> Option<Finding<'_>> {
    let at = |point| Some((amplitudes(point, index, quantity)?.largest, point));
    let points: Vec<(Amplitude, &SweptEngine)> = sweep.points.iter().filter_map(at).collect();
    let between = sweep.curve.iter().filter_map(at);
    if points.iter().copied().chain(between).all(|(part, _)| part.vanishes) {
        return None;
    }
    let by_value = |a: &&(Amplitude, &SweptEngine), b: &&(Amplitude, &SweptEngine)| a.0.value.total_cmp(&b.0.value);
    let greatest = points.iter().max_by(by_value)?.0;
    let least = points.iter().find(|(part, _)| part.vanishes).or_else(|| points.iter().min_by(by_value))?.0;
    let reached = |by: Amplitude| {
        let alike = |part: &Amplitude| {
            part.vanishes == by.vanishes && (part.value - by.value).abs() <= ALIKE * greatest.value.abs()
        };
        Extreme { amplitude: by, at: points.iter().filter(|(part, _)| alike(part)).map(|(_, point)| *point).collect() }
    };
    let is_this = |set: &&ZeroSet| set.quantity == quantity && set.order == order && set.of == Zeros::Largest;
    Some(Finding {
        quantity,
        order,
        greatest: reached(greatest),
        least: reached(least),
        zeros: points.iter().filter(|(part, _)| part.vanishes).map(|(_, point)| *point).collect(),
        set: sweep.zeros.iter().flatten().find(is_this),
    })
}

impl Extreme<'_> {
    /// Where it is reached.
    pub fn places(&self, sweep: &Sweep) -> Text {
        match self.is_everywhere(sweep) {
            true => "every value".into(),
            false => listed(self.at.iter().map(|point| place(sweep, point)).collect()),
        }
    }

    fn is_everywhere(&self, sweep: &Sweep) -> bool {
        self.at.len() == sweep.points.len()
    }
}

/// A few of them, and dots where there are more.
fn listed(places: Vec<Text>) -> Text {
    let has_more = places.len() > MOST_LISTED;
    let shown = Text::joined(places.into_iter().take(MOST_LISTED), ", ");
    if has_more { shown.and(", …") } else { shown }
}

impl Finding<'_> {
    /// `Moment of order 2`.
    fn name(&self) -> Text {
        name(self.quantity, self.order)
    }

    /// In a sentence.
    pub fn sentence(&self, sweep: &Sweep) -> Text {
        let name = self.name();
        let most = with_unit(sweep, self.quantity, self.greatest.amplitude);
        // The same unit stands behind the greatest.
        let least = match in_newtons(sweep) {
            true => with_unit(sweep, self.quantity, self.least.amplitude),
            false => size(self.least.amplitude),
        };
        let [at_most, at_least] = [&self.greatest, &self.least].map(|of| of.places(sweep));
        let exact = |at: &[BigRational]| listed(at.iter().map(|at| value(&sweep.parameters[0], at, true)).collect());
        match self.set {
            _ if self.greatest.is_everywhere(sweep) && self.least.is_everywhere(sweep) => {
                phrase!("**{}:** {} at every value.", name, most)
            }
            Some(ZeroSet { at, complete: true, .. }) if !at.is_empty() => phrase!(
                "**{}:** exactly {} at {} and nowhere else in the range; at most {}, at {}.",
                name,
                Text::zero(),
                exact(at),
                most,
                at_most
            ),
            Some(ZeroSet { at, complete: false, .. }) if !at.is_empty() => phrase!(
                "**{}:** exactly {} at {}, perhaps elsewhere too; at most {}, at {}.",
                name,
                Text::zero(),
                exact(at),
                most,
                at_most
            ),
            Some(ZeroSet { complete: true, .. }) => {
                phrase!("**{}:** nowhere 0; from {} at {} up to {} at {}.", name, least, at_least, most, at_most)
            }
            Some(_) | None if !self.zeros.is_empty() => {
                let at = listed(self.zeros.iter().map(|point| place(sweep, point)).collect());
                phrase!("**{}:** exactly {} at {}; at most {}, at {}.", name, Text::zero(), at, most, at_most)
            }
            Some(_) | None => {
                phrase!("**{}:** from {} at {} up to {} at {}.", name, least, at_least, most, at_most)
            }
        }
    }
}

/// `Moment of order 2`.
fn name(quantity: Quantity, order: u32) -> Text {
    match quantity {
        Quantity::Force => phrase!("Force of order {}", order),
        Quantity::Moment => phrase!("Moment of order {}", order),
        Quantity::Torque => phrase!("Torque of order {}", order),
    }
}

/// What vanishes at every value, in one sentence.
pub(super) fn gone_sentence(gone: &[(Quantity, u32)]) -> Option<Text> {
    let list = |of: Quantity| -> Text {
        let orders = gone.iter().filter(|(quantity, _)| *quantity == of).map(|(_, order)| Text::from(*order));
        Text::joined(orders, ", ")
    };
    let (forces, moments) = (list(Quantity::Force), list(Quantity::Moment));
    match (forces.is_empty(), moments.is_empty()) {
        (true, true) => None,
        (false, true) => Some(phrase!("**Exactly zero at every value:** the force of these orders: {}.", forces)),
        (true, false) => Some(phrase!("**Exactly zero at every value:** the moment of these orders: {}.", moments)),
        (false, false) => Some(phrase!(
            "**Exactly zero at every value:** the force of these orders: {}; the moment of these: {}.",
            forces,
            moments
        )),
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
    let [shortest, longest] = [&best.shortest, &best.longest].map(crate::page::number::turns);
    Some(match shortest == longest {
        true => phrase!("**Firing:** even at {}, every {}.", at, shortest),
        false => phrase!("**Firing:** most even at {}, at intervals from {} to {}.", at, shortest, longest),
    })
}
