//! What does a sweep find of one order: where it is zero, where greatest, where least?

use super::amounts::{ALIKE, place};
use super::plots::amplitudes;
use crate::page::Text;
use crate::proof::Planar;
use crate::sweep::{Amplitude, Sweep, SweptEngine, ZeroSet, Zeros};

/// More values than this are not listed in a sentence or a cell.
const MOST_LISTED: usize = 4;

/// What the points say of the largest force, or the largest moment, of one order.
pub(super) struct Finding<'a> {
    pub quantity: Planar,
    pub order: u32,
    pub greatest: Extreme<'a>,
    pub least: Extreme<'a>,
    /// The points at which it is proved to vanish.
    pub zeros: Vec<&'a SweptEngine>,
    /// The exact zeros, between the points too, where the parameter is an angle.
    pub set: Option<&'a ZeroSet>,
}

/// A greatest or a least amplitude, and where it is reached.
pub(super) struct Extreme<'a> {
    pub amplitude: Amplitude,
    at: Vec<&'a SweptEngine>,
}

/// What is found of each order, the force and the moment of an order beside each other; and those that vanish at every point.
pub(super) fn findings(sweep: &Sweep) -> (Vec<Finding<'_>>, Vec<(Planar, u32)>) {
    let (mut found, mut gone) = (Vec::new(), Vec::new());
    for (place, &order) in sweep.orders.iter().enumerate() {
        for quantity in Planar::BOTH {
            match finding(sweep, quantity, order, place) {
                Some(finding) => found.push(finding),
                None => gone.push((quantity, order)),
            }
        }
    }
    (found, gone)
}

/// None where it vanishes at every point.
fn finding(sweep: &Sweep, quantity: Planar, order: u32, index: usize) -> Option<Finding<'_>> {
    let at = |point| Some((amplitudes(point, index, quantity)?.largest, point));
    let points: Vec<(Amplitude, &SweptEngine)> = sweep.points.iter().filter_map(at).collect();
    let between = sweep.curve.iter().filter_map(at);
    if points.iter().copied().chain(between).all(|(part, _)| part.vanishes) {
        return None;
    }
    let [greatest, least] = Extreme::of(&points)?;
    let is_this = |set: &&ZeroSet| set.quantity == quantity && set.order == order && set.of == Zeros::Largest;
    Some(Finding {
        quantity,
        order,
        greatest,
        least,
        zeros: points.iter().filter(|(part, _)| part.vanishes).map(|(_, point)| *point).collect(),
        set: sweep.zeros.iter().flatten().find(is_this),
    })
}

impl<'a> Extreme<'a> {
    /// The greatest and the least of some amplitudes; none where there are none.
    pub fn of(points: &[(Amplitude, &'a SweptEngine)]) -> Option<[Self; 2]> {
        let by_value = |a: &&(Amplitude, &SweptEngine), b: &&(Amplitude, &SweptEngine)| a.0.value.total_cmp(&b.0.value);
        let greatest = points.iter().max_by(by_value)?.0;
        let least = points.iter().find(|(part, _)| part.vanishes).or_else(|| points.iter().min_by(by_value))?.0;
        let reached = |amplitude: Amplitude| {
            let alike = |part: &Amplitude| {
                let apart = (part.value - amplitude.value).abs();
                part.vanishes == amplitude.vanishes && apart <= ALIKE * greatest.value.abs()
            };
            Extreme { amplitude, at: points.iter().filter(|(part, _)| alike(part)).map(|(_, point)| *point).collect() }
        };
        Some([greatest, least].map(reached))
    }

    /// Where it is reached.
    pub fn places(&self, sweep: &Sweep) -> Text {
        if self.is_everywhere(sweep) { "every value".into() } else { self.listed(sweep) }
    }

    /// The points at which it is reached.
    pub fn listed(&self, sweep: &Sweep) -> Text {
        listed(self.at.iter().map(|point| place(sweep, point)).collect())
    }

    /// Whether it is reached at all of these points.
    pub fn is_at_all(&self, points: &[(Amplitude, &SweptEngine)]) -> bool {
        self.at.len() == points.len()
    }

    /// Whether it is reached at every value.
    pub fn is_everywhere(&self, sweep: &Sweep) -> bool {
        self.at.len() == sweep.points.len()
    }
}

/// A few of them, and dots where there are more.
pub(super) fn listed(places: Vec<Text>) -> Text {
    let has_more = places.len() > MOST_LISTED;
    let shown = Text::joined(places.into_iter().take(MOST_LISTED), ", ");
    if has_more { shown.and(", …") } else { shown }
}
