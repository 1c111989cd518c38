//! How does the force on a bearing go through a revolution? Its components over the crank angle, and its polar diagram.

use super::super::calculation::Unit;
use super::super::plot::{Axis, Curve, Plot, PointMark, Polar};
use super::amounts::unit_of;
use crate::engine::Convention;
use crate::loads::{BearingLoad, BearingLoads, Circle};
use crate::page::{Picture, phrase};

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
        // Seen from the free end: y upwards in direction 0, x to the right.
        let tips =
            bearing.waveform.sample(&circle).into_iter().map(|force| (-force.im * unit.factor, force.re * unit.factor));
        let mut tips: Vec<(f64, f64)> = tips.collect();
        tips.extend(tips.first().copied());
        tips
    };
    let all: Vec<Tips> = loads.bearings.iter().map(tips).collect();
    let largest_of_all = loads.bearings.iter().map(|bearing| bearing.peak.value * unit.factor);
    let largest = largest_of_all.fold(farthest(all.iter().flatten()), f64::max);
    let draw = |(index, (bearing, tips)): (usize, (&BearingLoad, Tips))| {
        let over_angle = over_crank_angle((index + 1, bearing), &tips, largest, unit);
        [over_angle, polar(convention, (index + 1, bearing), tips, largest, unit)]
    };
    loads.bearings.iter().zip(all).enumerate().map(draw).collect()
}

/// The largest of the forces of all bearings, which are drawn to one scale.
pub(in crate::report) fn farthest<'a>(tips: impl Iterator<Item = &'a (f64, f64)>) -> f64 {
    tips.map(|(right, up)| right.hypot(*up)).fold(0.0, f64::max)
}

fn over_crank_angle(
    (number, bearing): (usize, &BearingLoad),
    tips: &[(f64, f64)],
    largest: f64,
    unit: Unit,
) -> Picture {
    let caption = phrase!(
        "Bearing {}: components of the force through a revolution, y upwards in direction 0 (solid), x to the right (dashed)",
        bearing.name.clone()
    );
    let x = Axis::angle("Crank angle θ in °", 0.0, 360.0, 90);
    let y = Axis::linear("Force in {}").counted_in(unit.unit).covering(&[-largest, largest]);
    let mut plot = Plot::new(format!("Main bearing {}", bearing.name), x, y);
    let curve = |place: usize, name: &str, value: fn(&(f64, f64)) -> f64| {
        let point = |(step, tip): (usize, &(f64, f64))| (step as f64 * 360.0 / STEPS as f64, value(tip));
        Curve::new(place, name, tips.iter().enumerate().map(point).collect())
    };
    plot.curves = vec![
        curve(style::ALONG, "y, along direction 0", |tip| tip.1),
        curve(style::ACROSS, "x, to the right", |tip| tip.0),
    ];
    Picture { name: format!("bearing-{number}"), caption, figure: plot.figure() }
}

const PATH: &str = "Bearing {}: path of the tip of the force through a revolution, seen from the {free end|flywheel}, direction 0 upwards. Rings mark crank angles, the dot the largest force.";

fn polar(
    convention: Convention,
    (number, bearing): (usize, &BearingLoad),
    tips: Vec<(f64, f64)>,
    largest: f64,
    unit: Unit,
) -> Picture {
    let caption = phrase!(PATH, bearing.name.clone(), convention.turns_anticlockwise_from());
    let label = "Force in {}; 0° is the reference direction";
    let mut polar =
        Polar::new(format!("Main bearing {}", bearing.name), label, vec![Curve::new(style::WHOLE, "", tips.clone())])
            .counted_in(unit.unit);
    polar.reach = largest;
    polar.mark_quarters(&tips, STEPS);
    let tip = bearing.peak.vector * unit.factor;
    if let Some(angle) = bearing.peak.angle {
        polar.marks.push(PointMark::dot((-tip.im, tip.re), format!("largest, θ ≈ {angle:.0}°")));
    }
    Picture { name: format!("bearing-{number}-polar"), caption, figure: polar.figure() }
}
