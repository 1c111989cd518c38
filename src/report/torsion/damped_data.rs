//! Which columns hold how a train vibrates with damping? A row a shaft, an order of a disc or a shaft, a resonance, a speed, a damper.

use num_traits::ToPrimitive;

use super::HeatPlace;
use super::study::TorsionStudy;
use crate::report::data::Filling;
use crate::table::{Table, Unit};

/// A stress that is known in pascals.
pub(super) fn megapascals(pascals: Option<f64>) -> Option<f64> {
    pascals.map(|pascals| 1e-6 * pascals)
}

pub(super) fn shafts(study: &TorsionStudy) -> Table {
    let vibration = study.at_speed();
    let mut table = Filling::new("torsion.shafts", study.torsion().shafts.iter().enumerate());
    table.whole("shaft", |(index, _)| index + 1);
    table.whole("from_disc", |(_, one)| one.ends[0] + 1);
    table.whole("to_disc", |(_, one)| one.ends[1] + 1);
    table.decimal("stiffness_{unit}", Unit::NEWTON_METRE_PER_RADIAN, |(_, one)| one.stiffness.to_f64());
    table.decimal("loss_factor", Unit::NONE, |(_, one)| one.loss_factor.to_f64());
    table.decimal("damping_{unit}", Unit::NEWTON_METRE_SECOND, |(_, one)| one.damping.to_f64());
    let torque = |index: usize| vibration.map(|vibration| vibration.torque(index));
    table.decimal("torque_half_range_{unit}", Unit::NEWTON_METRE, |(index, _)| torque(*index));
    let stress = |index: usize| megapascals(study.stress(index, torque(index)?));
    table.decimal("stress_half_range_{unit}", Unit::MEGAPASCAL, |(index, _)| stress(*index));
    let speed = study.speed.unwrap_or(f64::NAN);
    table.decimal("permitted_stress_{unit}", Unit::MEGAPASCAL, |(index, _)| {
        megapascals(study.permissible(*index, speed))
    });
    table.done()
}

pub(super) fn resonances(study: &TorsionStudy) -> Option<Table> {
    let mut table = Filling::new("torsion.resonances", study.resonances().iter()).keyed(2);
    table.whole("mode", |one| one.mode + 1);
    table.exact("order", Unit::NONE, |one| Some(one.order.exact().to_string()));
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |one| Some(one.rpm));
    table.decimal("first_disc_zero_to_peak_{unit}", Unit::DEGREE, |one| Some(one.first.to_degrees()));
    table.decimal("energy_zero_to_peak_{unit}", Unit::DEGREE, |one| {
        Some(one.at_first(one.energy.amplitude).to_degrees())
    });
    table.decimal("equilibrium_{unit}", Unit::DEGREE, |one| Some(one.at_first(one.energy.equilibrium).to_degrees()));
    table.decimal("magnifier", Unit::NONE, |one| one.energy.magnifier());
    table.whole("shaft", |one| one.shaft + 1);
    table.decimal("torque_zero_to_peak_{unit}", Unit::NEWTON_METRE, |one| Some(one.torque));
    table.decimal("peak_speed_{unit}", Unit::PER_MINUTE, |one| one.peak.map(|peak| peak.0));
    table.decimal("peak_torque_{unit}", Unit::NEWTON_METRE, |one| one.peak.map(|peak| peak.1));
    table.decimal("barred_from_{unit}", Unit::PER_MINUTE, |one| one.barred.as_ref().map(|barred| barred.speeds[0]));
    table.decimal("barred_to_{unit}", Unit::PER_MINUTE, |one| one.barred.as_ref().map(|barred| barred.speeds[1]));
    table.done_if_any()
}

pub(super) fn response(study: &TorsionStudy) -> Option<Table> {
    let (vibration, excited) = (study.at_speed()?, study.excited()?);
    let discs = 0..study.train.discs.len();
    let rows = vibration.orders.iter().flat_map(|order| discs.clone().map(move |disc| (order, disc)));
    let mut table = Filling::new("torsion.response", rows).keyed(2);
    table.exact("order", Unit::NONE, |(one, _)| Some(one.order.exact().to_string()));
    table.whole("disc", |(_, disc)| disc + 1);
    table.decimal("twist_zero_to_peak_{unit}", Unit::DEGREE, |(one, disc)| Some(one.twists[*disc].norm().to_degrees()));
    table.decimal("phase_{unit}", Unit::DEGREE, |(one, disc)| {
        let twist = one.twists[*disc] * excited.after_firing(one.order);
        (!excited.is_still(one.order)).then(|| twist.arg().to_degrees())
    });
    Some(table.done())
}

pub(super) fn torques(study: &TorsionStudy) -> Option<Table> {
    let vibration = study.at_speed()?;
    let shafts = 0..study.train.shafts;
    let rows = vibration.orders.iter().flat_map(|order| shafts.clone().map(move |shaft| (order, shaft)));
    let mut table = Filling::new("torsion.torques", rows).keyed(2);
    table.exact("order", Unit::NONE, |(one, _)| Some(one.order.exact().to_string()));
    table.whole("shaft", |(_, shaft)| shaft + 1);
    table.decimal("torque_zero_to_peak_{unit}", Unit::NEWTON_METRE, |(one, shaft)| Some(one.torques[*shaft].norm()));
    table.decimal("stress_zero_to_peak_{unit}", Unit::MEGAPASCAL, |(one, shaft)| {
        megapascals(study.stress(*shaft, one.torques[*shaft].norm()))
    });
    Some(table.done())
}

pub(super) fn speeds(study: &TorsionStudy) -> Option<Table> {
    let rows = study.over_range().iter().flat_map(|at| (0..at.torques.len()).map(move |shaft| (at, shaft)));
    let mut table = Filling::new("torsion.speeds", rows).keyed(2);
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |(at, _)| Some(at.speed));
    table.whole("shaft", |(_, shaft)| shaft + 1);
    table.decimal("torque_half_range_{unit}", Unit::NEWTON_METRE, |(at, shaft)| Some(at.torques[*shaft]));
    table.decimal("stress_half_range_{unit}", Unit::MEGAPASCAL, |(at, shaft)| {
        megapascals(study.stress(*shaft, at.torques[*shaft]))
    });
    table.decimal("permitted_stress_{unit}", Unit::MEGAPASCAL, |(at, shaft)| {
        megapascals(study.permissible(*shaft, at.speed))
    });
    table.decimal("first_disc_half_range_{unit}", Unit::DEGREE, |(at, _)| Some(at.first.to_degrees()));
    table.done_if_any()
}

pub(super) fn excesses(study: &TorsionStudy) -> Option<Table> {
    let mut table = Filling::new("torsion.excesses", study.excesses().iter().enumerate());
    table.whole("range", |(index, _)| index + 1);
    table.whole("shaft", |(_, one)| one.shaft + 1);
    table.decimal("from_{unit}", Unit::PER_MINUTE, |(_, one)| Some(one.speeds[0]));
    table.decimal("to_{unit}", Unit::PER_MINUTE, |(_, one)| Some(one.speeds[1]));
    table.done_if_any()
}

pub(super) fn heat(study: &TorsionStudy) -> Option<Table> {
    let place = |place: HeatPlace| match place {
        HeatPlace::Disc(disc) => ("disc", disc),
        HeatPlace::Shaft(shaft) => ("shaft", shaft),
        HeatPlace::Damper(damper) => ("damper", damper),
    };
    let mut table = Filling::new("torsion.heat", study.heat_places(study.at_speed()?)).keyed(2);
    table.words("place", |(at, _)| Some(place(*at).0.to_owned()));
    table.whole("number", |(at, _)| place(*at).1 + 1);
    table.decimal("heat_{unit}", Unit::WATT, |(_, power)| Some(*power));
    Some(table.done())
}

pub(super) fn dampers(study: &TorsionStudy) -> Option<Table> {
    let (stiff, damped) = (Unit::NEWTON_METRE_PER_RADIAN, Unit::NEWTON_METRE_SECOND);
    let mut table = Filling::new("torsion.dampers", study.dampers().iter().enumerate());
    table.whole("damper", |(index, _)| index + 1);
    table.whole("disc", |(index, _)| study.torsion().dampers[*index].disc + 1);
    table.decimal("mass_ratio", Unit::NONE, |(_, one)| Some(one.in_mode.mass_ratio));
    table.decimal("stiffness_{unit}", stiff, |(_, one)| Some(one.setting.stiffness));
    table.decimal("damping_{unit}", damped, |(_, one)| Some(one.setting.damping));
    table.decimal("formula_stiffness_{unit}", stiff, |(_, one)| Some(one.in_mode.best.stiffness));
    table.decimal("formula_damping_{unit}", damped, |(_, one)| Some(one.in_mode.best.damping));
    table.exact("order", Unit::NONE, |(_, one)| one.found.as_ref().map(|found| found.order.exact().to_string()));
    table.decimal("best_stiffness_{unit}", stiff, |(_, one)| one.found.as_ref().map(|found| found.best.stiffness));
    table.decimal("best_damping_{unit}", damped, |(_, one)| one.found.as_ref().map(|found| found.best.damping));
    for (name, at) in [("best_torque_{unit}", 0), ("torque_{unit}", 1)] {
        table.decimal(name, Unit::NEWTON_METRE, |(_, one)| one.found.as_ref().map(|found| found.peaks[at]));
    }
    table.decimal("torque_without_{unit}", Unit::NEWTON_METRE, |(_, one)| one.found.as_ref()?.without);
    table.done_if_any()
}
