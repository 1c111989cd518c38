//! How do the loads go through the cycle? Components over the crank angle, polar diagrams of bearings and crankpins.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::super::bearings::{farthest, largest_at, over_crank_angle, path, style, tip};
use super::super::torque::names;
use crate::engine::{Convention, Engine};
use crate::journal::{CycleBearing, CycleBearings, CycleLoads, ForceHistory, SharedPin};
use crate::page::plot::{Curve, Polar};
use crate::page::{Picture, Text, Unit};
use crate::report::rising;
use crate::report::texts::journal as text;

/// The tips of a force through the cycle, to the right and up.
type Tips = Vec<(f64, f64)>;

/// Steps of a revolution: a degree each.
const STEPS: usize = 360;
/// Pins of more cylinders than this are not drawn.
const MOST_PINS: usize = 3;
/// Of shared pins more are drawn, for each has firing intervals of its own, ...
const MOST_SHARED: usize = 8;
/// ... with the paths of its rods where they are no more than there are styles of line.
const MOST_RODS: usize = style::RODS.len();
/// Knuckle pins of a master rod that are drawn.
const MOST_LINKS: usize = style::LINKS.len();

/// Angles through the cycle, both ends among them.
fn angles(course: &ForceHistory) -> Vec<f64> {
    let steps = (course.period() / TAU * STEPS as f64).round() as usize;
    (0..=steps).map(|step| course.period() * step as f64 / steps as f64).collect()
}

/// Two drawings of each bearing, in the order of the file.
pub(super) fn bearings(convention: Convention, loads: &CycleLoads, bearings: &CycleBearings) -> Vec<[Picture; 2]> {
    let course = &loads.course;
    let angles = angles(course);
    let forces = |bearing: &CycleBearing| {
        let parts = |theta: &f64| course.carried_parts(&bearing.carried, *theta);
        let known: Vec<[Complex<f64>; 2]> = angles.iter().map(parts).collect();
        let all = known.iter().map(|[inertia, gas]| tip(inertia + gas)).collect();
        [all, known.iter().map(|[inertia, _]| tip(*inertia)).collect()]
    };
    let known: Vec<[Tips; 2]> = bearings.bearings.iter().map(forces).collect();
    let peaks = bearings.bearings.iter().map(|bearing| bearing.peak.value);
    let largest = peaks.fold(farthest(known.iter().flatten().flatten()), f64::max);
    let draw = |(index, (bearing, [all, inertia])): (usize, (&CycleBearing, [Tips; 2]))| {
        drawn(convention, (index + 1, bearing), &angles, [all, inertia], largest)
    };
    bearings.bearings.iter().zip(known).enumerate().map(draw).collect()
}

fn drawn(
    convention: Convention,
    (number, bearing): (usize, &CycleBearing),
    angles: &[f64],
    [all, inertia]: [Tips; 2],
    largest: f64,
) -> [Picture; 2] {
    let name = &bearing.name;
    let last = angles.last().map_or(360.0, |theta| theta.to_degrees().round());
    let at: Vec<(f64, (f64, f64))> = angles.iter().map(|theta| theta.to_degrees()).zip(all.iter().copied()).collect();
    let components = over_crank_angle(name, last, &at, largest, Unit::NEWTON);
    let curves =
        vec![Curve::new(style::WHOLE, "with gas", all), Curve::new(style::WITHOUT_GAS, "without gas", inertia)];
    let mut polar = path(name, curves, largest, Unit::NEWTON);
    polar.marks.push(largest_at(tip(bearing.peak.vector), bearing.peak.angle));
    let caption = text::path(name.clone(), convention.turns_anticlockwise_from());
    [
        Picture::new(format!("bearing-{number}-cycle"), text::components(name.clone()), components),
        Picture::new(format!("bearing-{number}-cycle-polar"), caption, polar.figure()),
    ]
}

/// Two polar diagrams of a crankpin of each kind, seen from the engine and from the crank.
pub(super) fn pins(engine: &Engine, loads: &CycleLoads) -> Vec<Picture> {
    let course = &loads.course;
    let angles = angles(course);
    let draw = |group: &Vec<usize>| {
        let index = group[0];
        let name = engine.cylinders()[index].name.as_str();
        let picture = |end: &str, label: &str, caption: Text, law: &dyn Fn(f64) -> Complex<f64>| {
            let tips: Tips = angles.iter().map(|theta| tip(law(*theta))).collect();
            let curve = Curve::new(style::WHOLE, "", tips.clone());
            let mut polar = Polar::new(format!("Crankpin of cylinder {name}"), label, vec![curve]);
            polar.mark_quarters(&tips, STEPS);
            let figure = polar.counted_in(Unit::NEWTON).figure();
            Picture::new(format!("pin-{}-{end}", index + 1), caption, figure)
        };
        let from_engine = text::crankpin(names(engine, &[index]));
        let from_crank = match group.len() {
            1 => text::seen_from_crank(),
            _ => text::same_for_others(text::seen_from_crank(), names(engine, group)),
        };
        let turning = |theta| course.pin_on_the_crank(index, theta);
        [
            picture("engine", "Force in {}; 0° is the reference direction", from_engine, &|theta| {
                course.pin(index, theta)
            }),
            picture("crank", "Force in {}; 0° is outward along the throw", from_crank, &turning),
        ]
    };
    let alike = course.alike();
    alike.iter().filter(|group| engine.has_plain_rod(group[0])).take(MOST_PINS).flat_map(draw).collect()
}

/// The paths of the loads of the knuckle pins of every master rod, seen from it, as many as are told apart.
pub(super) fn knuckles(engine: &Engine, loads: &CycleLoads) -> Vec<Picture> {
    let course = &loads.course;
    let angles = angles(course);
    let masters = rising(loads.knuckles.iter().map(|knuckle| knuckle.master));
    let draw = |master: usize| {
        let path = |link: usize| {
            let seen = |theta: &f64| {
                let [inertia, gas] = course.knuckle_parts(link, *theta)?;
                Some(tip((inertia + gas) * course.knuckle_direction(link, *theta)?.conj()))
            };
            angles.iter().filter_map(seen).collect::<Vec<_>>()
        };
        let name = |index: usize| engine.cylinders()[index].name.clone();
        let links = style::LINKS.into_iter().zip(course.links_of(master));
        let curves = links.map(|(style, link)| Curve::new(style, format!("link {}", name(link)), path(link))).collect();
        let label = "Force in {}; 0° is away from the crankpin";
        let polar = Polar::new(format!("Knuckle pins of master rod {}", name(master)), label, curves);
        Picture::new(
            format!("master-{}-knuckles-cycle", master + 1),
            text::knuckle_pins(name(master), MOST_LINKS),
            polar.counted_in(Unit::NEWTON).figure(),
        )
    };
    masters.into_iter().map(draw).collect()
}

/// The path of the load of every crankpin that rods share, seen from the crank, with those of its rods where they are few and none is a link.
pub(super) fn shared_pins(engine: &Engine, loads: &CycleLoads) -> Vec<Picture> {
    let course = &loads.course;
    let angles = angles(course);
    let draw = |pin: &SharedPin| {
        let path = |law: &dyn Fn(f64) -> Complex<f64>| angles.iter().map(|theta| tip(law(*theta))).collect::<Vec<_>>();
        let number = pin.throw + 1;
        let are_drawn = pin.cylinders.len() <= MOST_RODS && !pin.has_links(loads);
        let few = if are_drawn { pin.cylinders.as_slice() } else { &[] };
        let mut curves =
            vec![Curve::new(style::WHOLE, "all rods", path(&|theta| pin.load_on_the_crank(course, theta)))];
        curves.extend(style::RODS.into_iter().zip(few).map(|(style, &index)| {
            let name = format!("cylinder {}", engine.cylinders()[index].name);
            Curve::new(style, name, path(&|theta| course.pin_on_the_crank(index, theta)))
        }));
        let label = "Force in {}; 0° is outward along the throw";
        let mut polar = Polar::new(format!("Crankpin {number}"), label, curves).counted_in(Unit::NEWTON);
        let largest = pin.load_on_the_crank(course, pin.peak.angle.to_radians());
        polar.marks.push(largest_at(tip(largest), pin.peak.angle));
        Picture::new(
            format!("shared-pin-{number}-crank"),
            text::shared_pin(number, names(engine, &pin.cylinders), pin.has_links(loads)),
            polar.figure(),
        )
    };
    loads.shared_pins.iter().take(MOST_SHARED).map(draw).collect()
}
