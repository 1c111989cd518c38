//! What does `torsion --json` hold? The modes with their shapes, and the critical speeds.

use serde::Serialize;

use super::TorsionStudy;
use crate::torsion::CriticalSpeeds;

/// A shaft that twists, as data.
#[derive(Clone, Debug, Serialize)]
pub struct TorsionDocument {
    title: String,
    speed_rpm: Option<f64>,
    modes: Vec<ModeEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct ModeEntry {
    frequency_hz: f64,
    nodes: usize,
    /// Deflection of each disc, 1 at the first.
    shape: Vec<f64>,
    /// Deflection at each cylinder.
    cylinders: Vec<f64>,
    /// The longest star that the mode can have.
    longest_star: f64,
    critical: Vec<CriticalEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct CriticalEntry {
    order: String,
    rpm: f64,
    star: f64,
}

/// The study as data.
pub fn torsion_document(study: &TorsionStudy<'_>) -> TorsionDocument {
    let mode = |speeds: &CriticalSpeeds| ModeEntry {
        frequency_hz: speeds.mode.hertz(),
        nodes: speeds.mode.nodes(),
        shape: speeds.mode.shape.clone(),
        cylinders: speeds.deflections.clone(),
        longest_star: speeds.longest,
        critical: speeds
            .orders
            .iter()
            .map(|one| CriticalEntry { order: one.order.exact().to_string(), rpm: one.rpm, star: one.star.norm() })
            .collect(),
    };
    TorsionDocument {
        title: study.engine.title().written().to_owned(),
        speed_rpm: study.speed,
        modes: study.modes.iter().map(mode).collect(),
    }
}
