//! How is a shaft that twists drawn? Its first modes along the discs, and a Campbell diagram.

use super::super::figure::Ink;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::study::TorsionStudy;
use super::tables::MOST_MODES;
use super::{TwistAtSpeed, amounts};
use crate::page::{Picture, Unit};
use crate::report::texts::torsion as text;
use crate::torsion::Critical;

/// This many orders are drawn as rays.
const MOST_RAYS: usize = 5;
/// The diagram goes so far beyond the speed of the layout, or the range where that is asked for.
const BEYOND: f64 = 1.15;

/// A point that is not drawn: the curve begins again behind it.
const GAP: (f64, f64) = (f64::NAN, f64::NAN);

/// The deflections of the first modes, disc by disc.
pub(super) fn modes(study: &TorsionStudy) -> Picture {
    let discs = study.torsion().inertias.len();
    let shafts = &study.torsion().shafts;
    let ticks = (1..=discs).map(|disc| disc as f64).collect();
    let x = Axis { ticks: Some(ticks), ..Axis::linear("Disc, from the free end") };
    let shown = || study.modes.iter().take(MOST_MODES);
    let deflection = match shown().any(|speeds| speeds.mode.is_first_a_node()) {
        true => "Relative deflection",
        false => "Deflection, 1 at the first disc",
    };
    let mut plot = Plot::new("Modes of the shaft", x, Axis::linear(deflection));
    for (index, speeds) in shown().enumerate() {
        let at = |disc: usize| ((disc + 1) as f64, speeds.mode.shape[disc]);
        let points = match study.is_row() {
            true => (0..discs).map(at).collect(),
            // A line for each shaft, and a gap between them: gears and the order of the numbers join nothing.
            false => shafts.iter().flat_map(|shaft| [at(shaft.ends[0]), at(shaft.ends[1]), GAP]).collect(),
        };
        plot.curves.push(Curve::new(index, format!("mode {}", index + 1), points));
    }
    let caption = if study.is_row() { text::modes_of_shaft() } else { text::modes_of_train() };
    Picture::new("modes", caption, plot.figure())
}

/// Frequencies over the speed: the modes level, the orders rising, a dot where they meet.
pub(super) fn campbell(study: &TorsionStudy) -> Option<Picture> {
    let first = study.modes.first()?;
    let strongest: Vec<&Critical> = study.strongest(first).into_iter().take(MOST_RAYS).collect();
    let fastest = strongest.iter().map(|critical| critical.rpm).fold(0.0, f64::max);
    let end = BEYOND * study.highest_speed().unwrap_or(fastest).max(study.speed.unwrap_or_default());
    if end <= 0.0 {
        return None;
    }
    let x = Axis { range: Some((0.0, end)), ..Axis::linear("Speed in rpm") };
    let shown = || study.modes.iter().take(MOST_MODES);
    let top = shown().next_back().map_or(0.0, |speeds| speeds.mode.hertz()) * BEYOND;
    let mut plot =
        Plot::new("Campbell diagram", x, Axis { range: Some((0.0, top)), ..Axis::linear("Frequency in Hz") });
    for critical in &strongest {
        let slope = critical.order.hertz(1.0);
        let far = end.min(top / slope);
        let ray = Curve::new(0, format!("order {}", critical.order), vec![(0.0, 0.0), (far, far * slope)]);
        plot.curves.push(Curve { ink: Ink::Grey, width: 0.3, ..ray });
    }
    for (index, speeds) in shown().enumerate() {
        let level = speeds.mode.hertz();
        plot.curves.push(Curve::new(index, format!("mode {}", index + 1), vec![(0.0, level), (end, level)]));
        let met = |critical: &&Critical| strongest.iter().any(|ray| ray.order == critical.order) && critical.rpm <= end;
        for critical in speeds.orders.iter().filter(met) {
            plot.marks.push(PointMark::dot((critical.rpm, level), ""));
        }
    }
    Some(Picture::new("campbell", text::campbell(), plot.figure()))
}

/// Curves of the largest torques are drawn, this many.
const MOST_SHAFTS: usize = 3;

/// Amplitude, torque and stress over the range of speeds, where there is damping.
pub(super) fn over_range(study: &TorsionStudy) -> Vec<Picture> {
    let rows = study.over_range();
    if rows.is_empty() || study.is_still() {
        return Vec::new();
    }
    let points =
        |of: &dyn Fn(&TwistAtSpeed) -> f64| -> Vec<(f64, f64)> { rows.iter().map(|at| (at.speed, of(at))).collect() };
    let x = || Axis::linear("Speed in rpm");
    let most = |shaft: usize| rows.iter().map(|at| at.torques[shaft]).fold(0.0, f64::max);
    let mut shafts: Vec<usize> = (0..study.train.shafts).collect();
    shafts.sort_by(|one, other| most(*other).total_cmp(&most(*one)));
    let mut amplitude = Plot::new("Amplitude of the first disc", x(), Axis::amplitude("Amplitude in °"));
    amplitude.curves.push(Curve::new(0, "", points(&|at| at.first.to_degrees())));
    let mut torque = Plot::new("Vibration torque", x(), Axis::amplitude("Torque in {}").counted_in(Unit::NEWTON_METRE));
    for (number, &shaft) in shafts.iter().take(MOST_SHAFTS).enumerate() {
        torque.curves.push(Curve::new(number, amounts::shaft_drawn(study, shaft), points(&|at| at.torques[shaft])));
    }
    let mut pictures = vec![
        Picture::new("torsion-amplitude", text::amplitude(), amplitude.figure()),
        Picture::new("torsion-torque", text::torque(), torque.figure()),
    ];
    let stressed: Vec<usize> =
        shafts.into_iter().filter(|shaft| study.stress(*shaft, 1.0).is_some()).take(MOST_SHAFTS).collect();
    let mut stress = Plot::new("Vibration stress", x(), Axis::amplitude("Stress in {}").counted_in(Unit::MEGAPASCAL));
    for (number, &shaft) in stressed.iter().enumerate() {
        let of = |at: &TwistAtSpeed| 1e-6 * study.stress(shaft, at.torques[shaft]).unwrap_or(f64::NAN);
        stress.curves.push(Curve::new(number, amounts::shaft_drawn(study, shaft), points(&of)));
        if study.limit(shaft).is_some() {
            let limit = |at: &TwistAtSpeed| 1e-6 * study.permissible(shaft, at.speed).unwrap_or(f64::NAN);
            let curve = Curve::new(number, format!("permitted {}", amounts::shaft(study, shaft)), points(&limit));
            stress.curves.push(Curve { ink: Ink::Grey, ..curve });
        }
    }
    if !stressed.is_empty() {
        pictures.push(Picture::new("torsion-stress", text::stress(), stress.figure()));
    }
    pictures
}
