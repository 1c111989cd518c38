//! How does a train with damping vibrate: at a speed, at its resonances, over a range, with its dampers?

use std::f64::consts::TAU;

use num_complex::Complex;

use super::excited::Excited;
use super::study::TorsionStudy;
use super::vibration::{
    DamperStudy, Excess, FoundDamper, HeatPlace, LargestTorque, ResonanceOrder, TwistAtSpeed, Vibration,
    VibrationOrder, omega,
};
use crate::engine::{self, CycleOrder};
use crate::motion::golden_section;
use crate::numbers::float;
use crate::torsion::{
    self, DamperSetting, Excitation, HIGHEST_RATIO, Heat, Link, Mode, Resonance, StressLimit, Train, beside,
    first_of_largest, forced_twist, heat, highest, highest_among, mesh_torques, peaks, resonance, shaft_torques,
};

/// A range is divided into this many speeds.
const SPEEDS: usize = 120;
/// Beside a resonance speeds stand closer, at these parts of it.
const BESIDE: [f64; 9] = [-0.04, -0.02, -0.01, -0.005, 0.0, 0.005, 0.01, 0.02, 0.04];
/// The range begins at this part of its end, where the layout has none.
const BEGINS: f64 = 0.1;
/// A ring with a smaller part of the inertia of the first mode is not searched.
pub(super) const LEAST_RATIO: f64 = 1e-6;
/// Points of a frequency range between which a peak is looked for.
const POINTS: usize = 60;
/// With a damper a peak is refined if its point reaches this part of the highest: points are close beside resonances, where a peak is little
/// higher than its point.
const REFINED_FROM: f64 = 0.5;
/// The smallest distance of a point from a resonance, as a part of its frequency.
const NARROWEST: f64 = 1e-6;
/// The largest.
const WIDEST: f64 = 0.04;
/// Ratio of the distances of neighbouring points.
const FARTHER: f64 = 1.6;
/// The range in which a damper is looked for goes beyond the modes that it moves by this factor.
const BEYOND: f64 = 1.1;
/// So many golden sections find the largest torque of all orders.
const SECTIONS: u32 = 20;
/// A peak below this part of the highest computed value is not refined.
const LOWER: f64 = 0.8;
/// Halvings until a speed is found.
const HALVINGS: usize = 50;

/// Points on both sides of a resonance, at distances that grow by [`FARTHER`], from half of its half-width to [`WIDEST`].
fn around(middle: f64, half_width: f64) -> Vec<f64> {
    let first = (0.5 * half_width).max(NARROWEST);
    let beside = std::iter::successors(Some(first), |far| Some(FARTHER * far)).take_while(|far| *far < WIDEST);
    std::iter::once(middle).chain(beside.flat_map(|far| [middle * (1.0 - far), middle * (1.0 + far)])).collect()
}

/// The largest of these torques and its place, the first of equal ones.
pub(super) fn largest(torques: &[Complex<f64>]) -> (usize, f64) {
    first_of_largest(torques.iter().map(|torque| torque.norm()).enumerate(), |one| one.1).unwrap_or_default()
}

impl TorsionStudy {
    /// What excites a train that is damped.
    fn damped(&self) -> Option<&Excited> {
        self.excited().filter(|_| self.torsion().is_damped())
    }

    /// The twists by an order at a speed.
    pub(super) fn twists(&self, train: &Train, order: CycleOrder, speed: f64) -> Option<Vec<Complex<f64>>> {
        Some(self.twists_by(train, order, &self.excitation(order, speed)?))
    }

    /// What an order excites the discs with at a speed.
    fn excitation(&self, order: CycleOrder, speed: f64) -> Option<Excitation> {
        Some(Excitation { omega: omega(order, speed), torques: self.excited()?.torques(order, speed)? })
    }

    /// The twists by what an order excites the discs with: none where that cancels.
    fn twists_by(&self, train: &Train, order: CycleOrder, excitation: &Excitation) -> Vec<Complex<f64>> {
        match self.is_still_at(order) {
            true => vec![Complex::default(); train.discs.len()],
            false => forced_twist(train, excitation),
        }
    }

    /// The largest torque of an order in a shaft at a speed.
    fn largest_torque(&self, train: &Train, order: CycleOrder, speed: f64) -> (usize, f64) {
        let twists = self.twists(train, order, speed).unwrap_or_else(|| vec![Complex::default(); train.discs.len()]);
        largest(&shaft_torques(train, omega(order, speed), &twists)[..train.shafts])
    }

    /// The vibration at the speed of the layout.
    pub fn at_speed(&self) -> Option<&Vibration> {
        self.cached.at_speed.get_or_init(|| self.vibration(self.speed?)).as_ref()
    }

    /// The vibration at a speed; none without damping, without a torque, and at rest.
    pub fn vibration(&self, speed: f64) -> Option<Vibration> {
        let excited = self.damped().filter(|_| speed > 0.0)?;
        let of_order = |order: CycleOrder| {
            let excitation = self.excitation(order, speed)?;
            let omega = excitation.omega;
            let twists = self.twists_by(&self.train, order, &excitation);
            let torques = shaft_torques(&self.train, omega, &twists);
            let meshes = mesh_torques(&self.train, &excitation, &twists, &torques);
            let heat = heat(&self.train, omega, &twists);
            Some(VibrationOrder { order, hertz: omega / TAU, twists, torques, meshes, heat })
        };
        Some(Vibration { speed, orders: excited.orders().filter_map(of_order).collect() })
    }

    /// The speeds over which it is shown: those of the layout, else up to 105 % of the rated speed or of the speed; none where it has none.
    pub fn range(&self) -> Option<[f64; 2]> {
        let torsion = self.torsion();
        if let Some(speeds) = &torsion.speeds {
            return Some([float(&speeds[0]), float(&speeds[1])]);
        }
        let end = HIGHEST_RATIO * torsion.rated_speed.as_ref().map(float).or(self.speed).filter(|end| *end > 0.0)?;
        Some([BEGINS * end, end])
    }

    /// The orders of the torque that meet a mode in the range, or have their peak beside one there, the modes rising, and then the speeds falling.
    pub fn resonances(&self) -> &[ResonanceOrder] {
        self.cached.resonances.get_or_init(|| self.find_resonances())
    }

    fn find_resonances(&self) -> Vec<ResonanceOrder> {
        let (Some(excited), Some(range)) = (self.damped(), self.range()) else { return Vec::new() };
        let modes = 0..self.modes.len();
        let met = modes.flat_map(|index| excited.orders().map(move |order| (index, order)));
        met.filter(|(_, order)| !excited.is_still(*order))
            .filter_map(|(index, order)| self.resonance(index, order, range))
            .collect()
    }

    /// An order that meets a mode in the range, or has its peak there: with damping that is at another speed.
    fn resonance(&self, index: usize, order: CycleOrder, [from, to]: [f64; 2]) -> Option<ResonanceOrder> {
        let hertz = |at: usize| self.modes.get(at).map(|speeds| speeds.mode.hertz());
        let own = hertz(index)?;
        let alike = &self.modes[index].mode.alike;
        let below = alike.start.checked_sub(1).and_then(hertz).map_or(0.5 * own, |other| 0.5 * (other + own));
        let above = hertz(alike.end).map_or(1.5 * own, |other| 0.5 * (other + own));
        let [low, rpm, high] = [below, own, above].map(|hertz| order.rpm(hertz));
        if high < from || low > to {
            return None;
        }
        let is_in_range = |speed: f64| (from..=to).contains(&speed);
        let of = |speed: f64| self.largest_torque(&self.train, order, speed).1;
        let sides = [[low, rpm], [rpm, high]].map(|[low, high]| highest(low, high, POINTS / 2, &of));
        let peak = if sides[0].1 > sides[1].1 { sides[0] } else { sides[1] };
        let is_inside = low + 1e-3 * (high - low) < peak.0 && peak.0 < high - 1e-3 * (high - low);
        let peak = is_inside.then_some(peak);
        let at_peak = peak.map(|(speed, _)| speed).filter(|speed| is_in_range(*speed));
        let at = at_peak.or_else(|| is_in_range(rpm).then_some(rpm))?;
        let (shaft, torque) = self.largest_torque(&self.train, order, rpm);
        let mode = &self.modes[index].mode;
        let exceeding = is_in_range(rpm).then(|| self.exceeding(rpm)).flatten();
        let rated = self.torsion().rated_speed.as_ref().map(float).filter(|_| exceeding.is_some());
        let may_be_barred = |rated: &f64| rpm < torsion::UNBARRED * rated;
        Some(ResonanceOrder {
            mode: index,
            order,
            rpm,
            energy: resonance(&self.train, mode, &self.excited()?.torques(order, rpm)?),
            first_is_node: mode.is_first_a_node(),
            first: self.twists(&self.train, order, rpm)?.first()?.norm(),
            shaft,
            torque,
            peak,
            largest: self.largest_at(order, at),
            barred: rated.filter(may_be_barred).and_then(|rated| self.barred(rpm, rated, exceeding?)),
            is_unbarred: rated.is_some_and(|rated| !may_be_barred(&rated)),
        })
    }

    fn largest_at(&self, order: CycleOrder, rpm: f64) -> LargestTorque {
        let (shaft, torque) = self.largest_torque(&self.train, order, rpm);
        LargestTorque { order, rpm, shaft, torque }
    }

    /// The highest peak of the torque of one order inside the range: at a resonance, or a hump between others.
    pub fn strongest_peak(&self) -> Option<LargestTorque> {
        let (excited, speeds) = (self.damped()?, self.speeds());
        let torque = |order: CycleOrder, speed: f64| self.largest_torque(&self.train, order, speed).1;
        let peaks_of = |order: CycleOrder| {
            let values: Vec<f64> = speeds.iter().map(|speed| torque(order, *speed)).collect();
            let inside = peaks(&values, 0.0).filter(|place| (1..values.len().saturating_sub(1)).contains(place));
            inside.map(|place| (order, place, values[place])).collect::<Vec<_>>()
        };
        let all: Vec<_> = excited.orders().filter(|order| !excited.is_still(*order)).flat_map(peaks_of).collect();
        let highest = all.iter().map(|(.., torque)| *torque).fold(0.0, f64::max);
        let high = all.into_iter().filter(|(.., torque)| *torque >= LOWER * highest);
        let refined = high.map(|(order, place, _)| {
            let [low, high] = beside(&speeds, place);
            self.largest_at(order, golden_section(low, high, SECTIONS, |speed| torque(order, speed)))
        });
        first_of_largest(refined.filter(|one| one.torque > 0.0), |one| one.torque)
    }

    /// Where the vibration at a speed becomes heat, with the power there in watts.
    pub fn heat_places(&self, vibration: &Vibration) -> Vec<(HeatPlace, f64)> {
        let Heat { discs, links } = vibration.heat();
        let link = |link: usize| link.checked_sub(self.train.shafts).map_or(HeatPlace::Shaft(link), HeatPlace::Damper);
        let places = (0..discs.len()).map(HeatPlace::Disc).chain((0..links.len()).map(link));
        places.zip(discs.iter().chain(&links).copied()).filter(|(_, power)| *power > 0.0).collect()
    }

    /// The stress limit of a shaft, where its steel is given.
    pub fn limit(&self, shaft: usize) -> Option<StressLimit> {
        let shaft = &self.torsion().shafts[shaft];
        Some(StressLimit::new(shaft.section.as_ref()?, shaft.steel.as_ref()?))
    }

    /// The stress that a torque makes in a shaft, in pascals, where its section is given.
    pub fn stress(&self, shaft: usize, torque: f64) -> Option<f64> {
        Some(torsion::stress(self.torsion().shafts.get(shaft)?.section.as_ref()?, torque))
    }

    /// The permissible stress τ_C of a shaft at a speed.
    pub fn permissible(&self, shaft: usize, speed: f64) -> Option<f64> {
        self.limit(shaft)?.continuous(speed / float(self.torsion().rated_speed.as_ref()?))
    }

    /// By how much the stress of all orders is larger than τ_C.
    pub(super) fn over_limit(&self, shaft: usize, speed: f64, torque: f64) -> Option<f64> {
        Some(self.stress(shaft, torque)? - self.permissible(shaft, speed)?)
    }

    /// Speeds of the range, close beside resonances.
    pub fn speeds(&self) -> Vec<f64> {
        let Some([from, to]) = self.damped().and_then(|_| self.range()) else { return Vec::new() };
        let even = (0..=SPEEDS).map(|index| from + (to - from) * index as f64 / SPEEDS as f64);
        let resonances = self.resonances();
        let peaks = resonances.iter().flat_map(|one| [Some(one.rpm), one.peak.map(|peak| peak.0)]).flatten();
        let beside = peaks.flat_map(|peak| BESIDE.map(|part| peak * (1.0 + part)));
        let mut speeds: Vec<f64> = even.chain(beside).filter(|speed| (from..=to).contains(speed)).collect();
        speeds.sort_by(f64::total_cmp);
        speeds.dedup_by(|one, other| (*one - *other).abs() < 1e-9 * to);
        speeds
    }

    /// The vibration over the range, all orders together, at the largest torque of each shaft and gear too; nothing without damping.
    pub fn over_range(&self) -> &[TwistAtSpeed] {
        self.cached.range.get_or_init(|| {
            let mut range: Vec<TwistAtSpeed> = self.speeds().into_iter().filter_map(|rpm| self.twist_at(rpm)).collect();
            let speeds: Vec<f64> = range.iter().map(|at| at.speed).collect();
            let top = |found: &dyn Fn(&TwistAtSpeed) -> f64, of: &dyn Fn(&Vibration) -> f64| {
                let largest = |most: (usize, f64), one: (usize, f64)| if one.1 > most.1 { one } else { most };
                let (place, _) = range.iter().map(found).enumerate().fold((0, 0.0), largest);
                let [low, high] = beside(&speeds, place);
                golden_section(low, high, SECTIONS, |rpm| self.vibration(rpm).map_or(0.0, |at| of(&at)))
            };
            let mut tops: Vec<f64> = Vec::new();
            if !range.is_empty() {
                let (shafts, gears) = (0..self.train.shafts, 0..self.train.gears.len());
                tops.extend(shafts.map(|shaft| top(&|at| at.torques[shaft], &|at| at.torque(shaft))));
                tops.extend(gears.map(|gear| top(&|at| at.meshes[gear], &|at| at.mesh(gear))));
            }
            range.extend(tops.into_iter().filter_map(|rpm| self.twist_at(rpm)));
            range.sort_by(|one, other| one.speed.total_cmp(&other.speed));
            range.dedup_by(|one, other| one.speed == other.speed);
            range
        })
    }

    fn twist_at(&self, speed: f64) -> Option<TwistAtSpeed> {
        let vibration = self.vibration(speed)?;
        let torques = (0..self.train.shafts).map(|shaft| vibration.torque(shaft)).collect();
        let meshes = (0..self.train.gears.len()).map(|gear| vibration.mesh(gear)).collect();
        Some(TwistAtSpeed { speed, first: vibration.twist(0), torques, meshes })
    }

    /// Where stresses of all orders are larger than τ_C, shaft by shaft, the ends found by halving.
    pub fn excesses(&self) -> &[Excess] {
        self.cached.excesses.get_or_init(|| self.find_excesses())
    }

    fn find_excesses(&self) -> Vec<Excess> {
        let mut rows = Vec::new();
        for shaft in (0..self.train.shafts).filter(|shaft| self.limit(*shaft).is_some()) {
            let over = |speed: f64| {
                self.vibration(speed).and_then(|at| self.over_limit(shaft, speed, at.torque(shaft))) > Some(0.0)
            };
            let edge = |mut low: f64, mut high: f64| {
                let at_low = over(low);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if over(middle) == at_low { low = middle } else { high = middle }
                }
                0.5 * (low + high)
            };
            let at = |at: &TwistAtSpeed| (at.speed, self.over_limit(shaft, at.speed, at.torques[shaft]) > Some(0.0));
            let range: Vec<(f64, bool)> = self.over_range().iter().map(at).collect();
            let mut begin = range.first().filter(|(_, is_over)| *is_over).map(|(speed, _)| *speed);
            for pair in range.windows(2) {
                let [(low, at_low), (high, at_high)] = [pair[0], pair[1]];
                match (at_low, at_high, begin) {
                    (false, true, _) => begin = Some(edge(low, high)),
                    (true, false, Some(from)) => {
                        rows.push(Excess { shaft, speeds: [from, edge(low, high)] });
                        begin = None;
                    }
                    _ => {}
                }
            }
            if let (Some(from), Some((to, _))) = (begin, range.last()) {
                rows.push(Excess { shaft, speeds: [from, *to] });
            }
        }
        rows
    }

    /// The dampers with their best settings.
    pub fn dampers(&self) -> &[DamperStudy] {
        self.cached.dampers.get_or_init(|| {
            let bare = Train::bare(self.torsion());
            let dampers = self.torsion().dampers.iter().enumerate();
            dampers.filter_map(|(index, damper)| self.damper(&bare, index, damper)).collect()
        })
    }

    fn damper(&self, bare: &Train, index: usize, damper: &engine::Damper) -> Option<DamperStudy> {
        let in_mode = torsion::in_first_mode(bare, damper)?;
        let link = self.train.shafts + index;
        let Link { stiffness, damping, .. } = self.train.links[link];
        let most_work = self.most_work(bare).filter(|_| in_mode.mass_ratio >= LEAST_RATIO);
        let found = most_work.map(|(order, is_bounded)| {
            let middle = order.rpm(in_mode.omega / TAU);
            let above = torsion::modes(bare)
                .into_iter()
                .find(|mode| mode.alike.start > 0)
                .map_or(1.5, |second| 0.5 * (1.0 + second.omega / in_mode.omega));
            // The damper moves the mode, and a ring on a spring makes two of it: both are in the range.
            let near = |train: &Train, modes: &[Mode]| {
                let part = |at: usize| modes.get(at).map_or(1.0, |mode| mode.omega / in_mode.omega);
                let lowest = part(0).min(in_mode.held / in_mode.omega);
                let is_sprung = train.links.get(link).is_some_and(|spring| spring.stiffness > 0.0);
                let upper = if is_sprung { BEYOND * part(1) } else { 1.0 };
                [0.5_f64.min(lowest / BEYOND), above.min(1.5).max(upper)]
            };
            let peak = |train: &Train| {
                let modes = torsion::modes(train);
                let torque = |part: f64| self.largest_torque(train, order, part * middle).1;
                let [low, high] = near(train, &modes);
                // A wider range has as many more points.
                let points = (POINTS as f64 * (high - low) / (above.min(1.5) - 0.5)).round() as usize;
                let mut places = torsion::evenly(low, high, points);
                let narrow = torsion::narrow_resonances(train, &modes, link);
                places.extend(narrow.into_iter().flat_map(|[omega, width]| around(omega / in_mode.omega, width)));
                places.retain(|place| (low..=high).contains(place));
                places.sort_by(f64::total_cmp);
                highest_among(&places, REFINED_FROM, &torque).1
            };
            let (best, least) = torsion::search(&self.train, link, in_mode.best, &peak);
            FoundDamper { order, best, peaks: [least, peak(&self.train)], without: is_bounded.then(|| peak(bare)) }
        });
        Some(DamperStudy { in_mode, setting: DamperSetting { stiffness, damping }, found })
    }

    /// The order of the torque with the most work in the first mode of the train without dampers, in the range where there is one, and
    /// whether something else damps that mode. Modes of equal frequency count together.
    fn most_work(&self, bare: &Train) -> Option<(CycleOrder, bool)> {
        let modes = torsion::modes(bare);
        let first = modes.first()?;
        let excited = self.damped()?;
        let range = self.range().unwrap_or([0.0, f64::INFINITY]);
        let work = |order: CycleOrder| {
            let rpm = order.rpm(first.hertz());
            let is_met = (range[0]..=range[1]).contains(&rpm) && !excited.is_still(order);
            let torques = excited.torques(order, rpm).filter(|_| is_met)?;
            let alike = modes[first.alike.clone()].iter().map(|mode| (mode, resonance(bare, mode, &torques)));
            let part = |(mode, at): &(&Mode, Resonance)| bare.inertia_of(&mode.shape) * at.equilibrium.powi(2);
            let work: f64 = alike.clone().map(|one| part(&one)).sum();
            let is_bounded = alike.into_iter().all(|(_, at)| at.amplitude.is_finite());
            (work > 0.0).then_some(((order, is_bounded), work))
        };
        first_of_largest(excited.orders().filter_map(work), |one| one.1).map(|(order, _)| order)
    }
}
