//! How is a shaft that twists drawn? Its first modes along the discs, and a Campbell diagram.

use super::super::figure::Ink;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::TorsionStudy;
use super::tables::MOST_MODES;
use crate::page::{Picture, phrase};
use crate::torsion::Critical;

/// So many orders are drawn as rays.
const MOST_RAYS: usize = 5;
/// The diagram goes so far beyond the speed of the layout.
const BEYOND: f64 = 1.15;

/// The deflections of the first modes, disc by disc.
pub(super) fn modes(study: &TorsionStudy) -> Picture {
    let ticks = (1..=study.torsion().inertias.len()).map(|disc| disc as f64).collect();
    let x = Axis { ticks: Some(ticks), ..Axis::linear("Disc, from the free end") };
    let mut plot = Plot::new("Modes of the shaft", x, Axis::linear("Deflection, 1 at the first disc"));
    for (index, speeds) in study.modes.iter().take(MOST_MODES).enumerate() {
        let points = speeds.mode.shape.iter().enumerate().map(|(disc, value)| ((disc + 1) as f64, *value));
        plot.curves.push(Curve::new(index, format!("mode {}", index + 1), points.collect()));
    }
    let caption = phrase!(
        "The first modes of the shaft: how far each disc is turned. A mode has a node where its curve crosses zero."
    );
    Picture { name: "modes".to_owned(), caption, figure: plot.figure() }
}

/// Frequencies over the speed: the modes level, the orders rising, a dot where they meet.
pub(super) fn campbell(study: &TorsionStudy) -> Option<Picture> {
    let first = study.modes.first()?;
    let strongest: Vec<&Critical> = study.strongest(first).into_iter().take(MOST_RAYS).collect();
    let fastest = strongest.iter().map(|critical| critical.rpm).fold(0.0, f64::max);
    let end = BEYOND * study.speed.unwrap_or(fastest);
    if end <= 0.0 {
        return None;
    }
    let x = Axis { range: Some((0.0, end)), ..Axis::linear("Speed in 1/min") };
    let shown = || study.modes.iter().take(MOST_MODES);
    let top = shown().next_back().map_or(0.0, |speeds| speeds.mode.hertz()) * BEYOND;
    let mut plot =
        Plot::new("Campbell diagram", x, Axis { range: Some((0.0, top)), ..Axis::linear("Frequency in Hz") });
    for critical in &strongest {
        let slope = f64::from(critical.order.halves()) / 120.0;
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
    let caption = phrase!(
        "Campbell diagram: the modes are level lines, the orders with the longest stars in the first mode rise with the speed. A dot is a critical speed."
    );
    Some(Picture { name: "campbell".to_owned(), caption, figure: plot.figure() })
}
