//! How does the force on a bearing go through a revolution? Its components over the crank angle, and its polar diagram.

use num_complex::Complex;

use super::super::calculation::Unit;
use super::super::plot::{Axis, Curve, Plot, PointMark, Polar};
use super::amounts::unit_of;
use crate::engine::Convention;
use crate::loads::{BearingLoad, BearingLoads, Circle};
use crate::page::figure::Figure;
use crate::page::{self, Picture};
use crate::report::texts::bearings as text;

/// The tips of a force through a revolution, to the right and up.
type Tips = Vec<(f64, f64)>;

/// Steps of a revolution: half a degree each.
const STEPS: usize = 720;

/// What a style of line means in every drawing of bearings and pins: numbers of [`Curve::new`].
pub(in crate::report) mod style {
    /// The path of a whole load.
    pub const WHOLE: usize = 0;
    /// Its component across direction 0.
    pub const ACROSS: usize = 1;
    /// The path of the load of the masses alone.
    pub const WITHOUT_GAS: usize = 2;
    /// Its component along direction 0.
    pub const ALONG: usize = 4;
    /// The paths of the rods of a crankpin that share it, all broken lines.
    pub const RODS: [usize; 3] = [3, 5, 6];
    /// The paths of the links of a master rod.
    pub const LINKS: [usize; 4] = [7, 9, 10, 11];
}

/// The two drawings of each bearing, in the order of the file.
pub(in crate::report) fn drawings(convention: Convention, loads: &BearingLoads) -> Vec<[Picture; 2]> {
    let unit = unit_of(loads);
    let circle = Circle::new(STEPS);
    let tips = |bearing: &BearingLoad| {
        let forces = bearing.waveform.sample(&circle).into_iter();
        let mut tips: Tips = forces.map(|force| tip(force * unit.factor)).collect();
        tips.extend(tips.first().copied());
        tips
    };
    let all: Vec<Tips> = loads.bearings.iter().map(tips).collect();
    let largest_of_all = loads.bearings.iter().map(|bearing| bearing.peak.value * unit.factor);
    let largest = largest_of_all.fold(farthest(all.iter().flatten()), f64::max);
    let draw = |(index, (bearing, tips)): (usize, (&BearingLoad, Tips))| {
        drawn(convention, (index + 1, bearing), tips, largest, unit)
    };
    loads.bearings.iter().zip(all).enumerate().map(draw).collect()
}

/// The largest of the forces of all bearings, which are drawn to one scale.
pub(in crate::report) fn farthest<'a>(tips: impl Iterator<Item = &'a (f64, f64)>) -> f64 {
    tips.map(|(right, up)| right.hypot(*up)).fold(0.0, f64::max)
}

/// Seen from the free end, or along a throw: upwards in direction 0, to the right across it.
pub(in crate::report) fn tip(force: Complex<f64>) -> (f64, f64) {
    (-force.im, force.re)
}

/// A dot at a largest force, with its crank angle.
pub(in crate::report) fn largest_at(tip: (f64, f64), degrees: f64) -> PointMark {
    PointMark::dot(tip, format!("largest, θ ≈ {degrees:.0}°"))
}

/// The components of the force on a bearing over the crank angle: its tips, each behind its angle in degrees.
pub(in crate::report) fn over_crank_angle(
    bearing: &str,
    last: f64,
    tips: &[(f64, (f64, f64))],
    largest: f64,
    unit: page::Unit,
) -> Figure {
    let x = Axis::angle("Crank angle θ in °", 0.0, last, 90);
    let y = Axis::linear("Force in {}").counted_in(unit).covering(&[-largest, largest]);
    let mut plot = Plot::new(format!("Main bearing {bearing}"), x, y);
    let curve = |place: usize, name: &str, value: fn(&(f64, f64)) -> f64| {
        Curve::new(place, name, tips.iter().map(|(degrees, tip)| (*degrees, value(tip))).collect())
    };
    plot.curves = vec![
        curve(style::ALONG, "y, along direction 0", |tip| tip.1),
        curve(style::ACROSS, "x, to the right", |tip| tip.0),
    ];
    plot.figure()
}

/// The path of the tip of the force on a bearing, to the scale of all.
pub(in crate::report) fn path(bearing: &str, curves: Vec<Curve>, largest: f64, unit: page::Unit) -> Polar {
    let label = "Force in {}; 0° is the reference direction";
    let mut polar = Polar::new(format!("Main bearing {bearing}"), label, curves).counted_in(unit);
    polar.reach = largest;
    polar
}

fn drawn(
    convention: Convention,
    (number, bearing): (usize, &BearingLoad),
    tips: Tips,
    largest: f64,
    unit: Unit,
) -> [Picture; 2] {
    let name = &bearing.name;
    let degrees = |step: usize| step as f64 * 360.0 / STEPS as f64;
    let at: Vec<(f64, (f64, f64))> = tips.iter().enumerate().map(|(step, tip)| (degrees(step), *tip)).collect();
    let components = over_crank_angle(name, 360.0, &at, largest, unit.unit);
    let mut polar = path(name, vec![Curve::new(style::WHOLE, "", tips.clone())], largest, unit.unit);
    polar.mark_quarters(&tips, STEPS);
    let peak = &bearing.peak;
    polar.marks.extend(peak.angle.map(|angle| largest_at(tip(peak.vector * unit.factor), angle)));
    let caption = text::path(name.clone(), convention.turns_anticlockwise_from());
    [
        Picture::new(format!("bearing-{number}"), text::components(name.clone()), components),
        Picture::new(format!("bearing-{number}-polar"), caption, polar.figure()),
    ]
}
