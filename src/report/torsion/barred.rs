//! Which speeds are barred around a critical one, do stresses hold their limit at the ends of that range, and may it be passed through?

use super::ResonanceOrder;
use super::amounts::{range, rpm, shaft};
use super::study::TorsionStudy;
use super::vibration::Barred;
use crate::engine::CycleOrder;
use crate::numbers::float;
use crate::page::{Text, Unit, phrase};
use crate::report::texts::torsion as text;
use crate::torsion::{self, first_of_largest};

impl TorsionStudy {
    /// The order with the largest part of the torque at a speed, in the shaft whose stress of all orders is farthest above its limit; none where
    /// all are permitted.
    pub(super) fn exceeding(&self, rpm: f64) -> Option<CycleOrder> {
        let limited: Vec<usize> = (0..self.train.shafts).filter(|shaft| self.limit(*shaft).is_some()).collect();
        if limited.is_empty() {
            return None;
        }
        let vibration = self.vibration(rpm)?;
        let over = limited.into_iter().filter_map(|shaft| {
            let over = self.over_limit(shaft, rpm, vibration.torque(shaft))?;
            (over > 0.0).then_some((shaft, over))
        });
        let (shaft, _) = first_of_largest(over, |one| one.1)?;
        first_of_largest(&vibration.orders, |one| one.torques[shaft].norm()).map(|one| one.order)
    }

    /// What the formula bars around a critical speed at which a stress is above its limit, by this order most.
    pub(super) fn barred(&self, rpm: f64, rated: f64, largest_part: CycleOrder) -> Option<Barred> {
        let speeds = torsion::barred(rpm, rated);
        // Outside of the range that is asked for the engine does not run.
        let [low, high] = self.range()?;
        let mut ends = speeds.iter().filter(|speed| (low..=high).contains(speed));
        let suffices = ends.all(|speed| self.exceeding(*speed).is_none());
        Some(Barred { speeds, suffices, largest_part })
    }

    /// Where in a barred range a stress of all orders is farthest above τ_T; none where it may be passed through.
    pub(super) fn impassable(&self, barred: &Barred) -> Option<Impassable> {
        let [from, to] = barred.speeds;
        let rated = float(self.torsion().rated_speed.as_ref()?);
        let inside = self.over_range().iter().filter(|at| (from..=to).contains(&at.speed));
        let above = inside.flat_map(|at| {
            at.torques.iter().enumerate().filter_map(move |(shaft, torque)| {
                let stress = self.stress(shaft, *torque)?;
                let permitted = self.limit(shaft)?.transient(at.speed / rated)?;
                (stress > permitted).then_some(Impassable { speed: at.speed, shaft, stress, permitted })
            })
        });
        above.max_by(|one, other| (one.stress - one.permitted).total_cmp(&(other.stress - other.permitted)))
    }

    /// The range that is barred around a critical speed, where that is a cure: the stress is below τ_C at its ends and below τ_T within it.
    pub(super) fn cure<'a>(&self, one: &'a ResonanceOrder) -> Option<&'a Barred> {
        one.barred.as_ref().filter(|barred| barred.suffices && self.impassable(barred).is_none())
    }
}

/// A stress that is too large even for passing through quickly.
pub(super) struct Impassable {
    speed: f64,
    shaft: usize,
    /// In pascals, as the next.
    stress: f64,
    permitted: f64,
}

/// The barred range around a critical speed; where it is none that may be passed through, or the stress exceeds the limit at its ends, why.
pub(super) fn said(study: &TorsionStudy, one: &ResonanceOrder, barred: &Barred) -> Text {
    let [from, to] = range(barred.speeds);
    if let Some(worst) = study.impassable(barred) {
        let stress = |pascals: f64| Text::measured_in(1e-6 * pascals, Unit::MEGAPASCAL);
        return text::no_barred_range_possible(
            rpm(one.rpm),
            one.order.to_string(),
            rpm(worst.speed),
            shaft(study, worst.shaft),
            stress(worst.stress),
            stress(worst.permitted),
        );
    }
    if barred.suffices {
        return text::barred(rpm(one.rpm), one.order.to_string(), from, to);
    }
    let excesses = exceeded(study, barred.speeds).into_iter().map(|ends| {
        let [from, to] = range(ends);
        phrase!("{} to {}", from, to)
    });
    text::barred_too_little(
        rpm(one.rpm),
        one.order.to_string(),
        from,
        to,
        Text::joined(excesses, ", "),
        barred.largest_part.to_string(),
    )
}

/// Where any stress exceeds its limit, as far as that meets these speeds: the ranges of all shafts together, rising.
fn exceeded(study: &TorsionStudy, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    let ranges = study.excesses().iter().map(|excess| excess.speeds);
    let mut ranges: Vec<[f64; 2]> = ranges.filter(|[low, high]| *low <= to && from <= *high).collect();
    ranges.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for range in ranges {
        match joined.last_mut() {
            Some(last) if range[0] <= last[1] => last[1] = last[1].max(range[1]),
            _ => joined.push(range),
        }
    }
    joined
}
