//! Which ring damps best? By the formulas of the textbooks for one mode, and by a search on the train itself.
//!
//! J. P. Den Hartog, Mechanical Vibrations, chapter 3: μ is the inertia of the ring over that of the mode, `ΣJΔ²` with Δ = 1 at the
//! damper; ζ = c / (2 J_d ω₁), and f is the frequency of the ring alone over ω₁. With the frequency of the ring in place of ω₁ the
//! formula of a tuned damper is √(3μ / 8(1+μ)): both are in use. Theory, section 13.

use super::peak::LOWER;
use super::{Disc, Link, Mode, Train, evenly, half_width, highest, highest_among, modes};
use crate::engine::{self, DamperValue, Torsion};
use crate::numbers::float;

/// The values of a damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamperSetting {
    /// Stiffness in N m per radian; 0 of a viscous one.
    pub stiffness: f64,
    /// Damping in N m s per radian.
    pub damping: f64,
}

/// A damper in the first mode of the train without dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperInMode {
    /// Inertia of the ring over that of the mode; 0 where the disc of the damper is at rest in it.
    pub mass_ratio: f64,
    /// Angular frequency of the mode.
    pub omega: f64,
    /// The same with the ring held fast to its disc.
    pub held: f64,
    /// The best setting by the formula.
    pub best: DamperSetting,
    /// Its peak over the static deflection: exact of a viscous damper, at the fixed points of a tuned one, which is a little less.
    pub peak: f64,
}

/// The best by the formula: ζ, f (0 of a viscous damper) and the peak over the static deflection.
pub fn formula(mass_ratio: f64, is_tuned: bool) -> (f64, f64, f64) {
    let mu = mass_ratio;
    match is_tuned {
        true => ((3.0 * mu / (8.0 * (1.0 + mu).powi(3))).sqrt(), 1.0 / (1.0 + mu), (1.0 + 2.0 / mu).sqrt()),
        false => (1.0 / (2.0 * (1.0 + mu) * (2.0 + mu)).sqrt(), 0.0, (2.0 + mu) / mu),
    }
}

/// A damper of an engine in the first mode of the train without dampers; none where that has no mode.
pub fn in_first_mode(bare: &Train, damper: &engine::Damper) -> Option<DamperInMode> {
    let modes_of_bare = modes(bare);
    let first = modes_of_bare.first()?;
    let ring = float(&damper.inertia);
    // Of modes of equal frequency, the sum of them in which the disc moves most.
    let part = |mode: &Mode| mode.shape[damper.disc].powi(2) / bare.inertia_of(&mode.shape);
    let mass_ratio = ring * modes_of_bare[first.alike.clone()].iter().map(part).sum::<f64>();
    let (zeta, f, peak) = formula(mass_ratio, damper.stiffness.is_some());
    let best = DamperSetting { stiffness: ring * (f * first.omega).powi(2), damping: 2.0 * ring * first.omega * zeta };
    let mut held = bare.clone();
    held.discs[damper.disc].inertia += ring;
    let held = modes(&held.joined()).first().map_or(first.omega, |mode| mode.omega);
    Some(DamperInMode { mass_ratio, omega: first.omega, held, best, peak })
}

/// The values of each damper, the best ones put in.
fn settings(bare: &Train, dampers: &[engine::Damper]) -> Vec<DamperSetting> {
    let of_one = |damper: &engine::Damper| {
        let best = in_first_mode(bare, damper).map_or(DamperSetting { stiffness: 0.0, damping: 0.0 }, |one| one.best);
        let value = |setting: &DamperValue, best: f64| match setting {
            DamperValue::Given(value) => float(value),
            DamperValue::Best => best,
        };
        DamperSetting {
            stiffness: damper.stiffness.as_ref().map_or(0.0, |setting| value(setting, best.stiffness)),
            damping: value(&damper.damping, best.damping),
        }
    };
    dampers.iter().map(of_one).collect()
}

/// By so much the search goes beyond the damping of the formula, up and down: what a page says of it.
const DAMPING: f64 = 100.0;
/// The same of the stiffness.
const STIFFNESS: f64 = 10.0;
/// Beside the stiffness of the formula points begin at this part of the width of the ring's own resonance, each twice as far as the last.
const BEGINS: f64 = 0.25;
/// No nearer than this: a narrower resonance of a ring is none that a damper is built for.
const NEAREST: f64 = 1e-3;
/// Points of the range of dampings, evenly on a logarithmic scale, between which the best is looked for.
const DAMPINGS: usize = 16;
/// The same of the stiffnesses.
const STIFFNESSES: usize = 12;

/// The setting of the damper on a link, its start at the formula's with a damping above 0, at which a peak of the train is least; with that peak.
pub fn search(train: &Train, link: usize, start: DamperSetting, peak: &dyn Fn(&Train) -> f64) -> (DamperSetting, f64) {
    let at = |stiffness: f64, damping: f64| {
        let mut train = train.clone();
        (train.links[link].stiffness, train.links[link].damping) = (stiffness, damping);
        peak(&train)
    };
    let best_damping = |stiffness: f64| {
        let [low, high] = [start.damping / DAMPING, start.damping * DAMPING].map(f64::ln);
        let (damping, least) = highest(low, high, DAMPINGS, &|value| -at(stiffness, value.exp()));
        (damping.exp(), -least)
    };
    let stiffness = match start.stiffness {
        0.0 => 0.0,
        tuned => {
            let [low, high] = [tuned / STIFFNESS, tuned * STIFFNESS].map(f64::ln);
            let mut places = evenly(low, high, STIFFNESSES);
            // A light ring does something in a narrow range alone.
            let ring = train.discs[train.links[link].ends[1]].inertia;
            let width = start.damping / (tuned * ring).sqrt();
            let first = (BEGINS * width).max(NEAREST);
            let beside = std::iter::successors(Some(first), |distance| Some(2.0 * distance));
            let beside = beside.take_while(|distance| *distance < places[1] - places[0]);
            let beside: Vec<f64> = beside.flat_map(|far| [tuned.ln() - far, tuned.ln() + far]).collect();
            places.extend(beside);
            places.sort_by(f64::total_cmp);
            highest_among(&places, LOWER, &|value| -best_damping(value.exp()).1).0.exp()
        }
    };
    let (damping, peak) = best_damping(stiffness);
    (DamperSetting { stiffness, damping }, peak)
}

/// The train with the ring on a link held fast to its disc; the ring without a spring beside it has no part in anything. What the
/// oil then still takes is as an absolute damping of the disc.
fn with_held_ring(train: &Train, link: usize, omega: f64) -> Train {
    let mut held = train.clone();
    let Link { ends: [disc, ring], damping, .. } = train.links[link];
    let inertia = train.discs[ring].inertia;
    let taken = omega * inertia;
    held.discs[disc].inertia += inertia;
    held.discs[disc].damping += damping * taken * taken / (damping * damping + taken * taken);
    (held.links[link].stiffness, held.links[link].damping) = (0.0, 0.0);
    held.joined()
}

/// Angular frequencies at which a train may have narrow resonances, with half of their widths as parts: those of its modes, and those
/// with the ring on a link held fast. A setting of the damper moves the peaks from the first to the second, the wider the farther they are from both.
pub fn narrow_resonances(train: &Train, modes_of_train: &[Mode], link: usize) -> Vec<[f64; 2]> {
    let of = |train: &Train, modes: &[Mode]| -> Vec<[f64; 2]> {
        modes.iter().map(|mode| [mode.omega, half_width(train, mode)]).collect()
    };
    let mut places = of(train, modes_of_train);
    if let (true, Some(first)) = (link < train.links.len(), modes_of_train.first()) {
        let held = with_held_ring(train, link, first.omega);
        places.extend(of(&held, &modes(&held)));
    }
    places
}

impl Train {
    /// The shaft of an engine with its dampers, in decimals.
    pub fn new(torsion: &Torsion) -> Self {
        let bare = Train::bare(torsion);
        let settings = settings(&bare, &torsion.dampers);
        let mut train = bare;
        for (damper, setting) in torsion.dampers.iter().zip(settings) {
            let (ratio, ring) = (train.discs[damper.disc].ratio, train.discs.len());
            train.discs.push(Disc { inertia: float(&damper.inertia), damping: 0.0, ratio, node: train.inertias.len() });
            train.inertias.push(0.0);
            let [stiffness, damping] = [setting.stiffness, setting.damping];
            train.links.push(Link { ends: [damper.disc, ring], stiffness, loss_factor: 0.0, damping });
        }
        train.joined()
    }
}
