//! How do torque and pressure go through the cycle? The torque of gas and inertia, the pressure over the angle, the loop.

use std::f64::consts::TAU;

use crate::engine::Engine;
use crate::page::plot::{Axis, Curve, Plot, Rule};
use crate::page::{Picture, Unit};
use crate::report::texts::torque as text;
use crate::torque::{Class, EngineTorque};

/// Steps of a revolution.
const STEPS: usize = 360;
/// More curves than this are not drawn in one plot.
const MOST_CURVES: usize = 3;

/// The torque through the cycle.
pub(super) fn torque(torque: &EngineTorque) -> Picture {
    let course = &torque.course;
    let last = course.period().to_degrees().round();
    let steps = (course.period() / TAU * STEPS as f64).round() as usize;
    let points = |value: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=steps)
            .map(|step| course.period() * step as f64 / steps as f64)
            .map(|theta| (theta.to_degrees(), value(theta)))
            .collect()
    };
    let x = Axis::angle("Crank angle θ in °", 0.0, last, 90);
    let mut plot = Plot::new("Torque", x, Axis::amplitude("Torque in {}").counted_in(Unit::NEWTON_METRE));
    if torque.has_inertia() {
        plot.curves.push(Curve::new(1, "gas", points(&|theta| course.gas(theta))));
        plot.curves.push(Curve::new(2, "inertia", points(&|theta| course.inertia(theta))));
    }
    plot.curves.push(Curve::new(0, "torque", points(&|theta| course.total(theta))));
    plot.rules.push(Rule { at: torque.mean, upright: false, label: "mean".to_owned() });
    Picture::new("gas-torque", text::cycle(), plot.figure())
}

/// The pressure over the angle, and over the volume.
pub(super) fn pressure(engine: &Engine, torque: &EngineTorque) -> [Picture; 2] {
    let name = |class: &Class| {
        let names: Vec<&str> = class.cylinders.iter().map(|&index| engine.cylinders()[index].name.as_str()).collect();
        if torque.classes.len() == 1 { String::new() } else { names.join(", ") }
    };
    let half = torque.course.period() / 2.0;
    let last = half.to_degrees().round();
    let steps = (torque.course.period() / TAU * STEPS as f64).round() as usize;
    let angle = |step: usize| -half + 2.0 * half * step as f64 / steps as f64;
    let step = if last > 200.0 { 90 } else { 60 };
    let mut over_angle = Plot::new(
        "Pressure over the crank angle",
        Axis::angle("Angle ψ after the firing dead centre in °", -last, last, step),
        Axis::amplitude("Pressure in {}").counted_in(Unit::BAR),
    );
    let mut loops = Plot::new(
        "Pressure over the volume",
        Axis::amplitude("Volume in {}").counted_in(Unit::CUBIC_CENTIMETRE),
        Axis::amplitude("Pressure in {}").counted_in(Unit::BAR),
    );
    for (index, class) in torque.classes.iter().take(MOST_CURVES).enumerate() {
        let gas = &class.gas;
        // The angles of the gas count from where it has its own zero.
        let zero = gas.zero();
        let mut draw =
            |number: usize, name: String, pascals: &dyn Fn(f64) -> Option<f64>, volume: &dyn Fn(f64) -> f64| {
                let points = |x: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
                    (0..=steps).map(angle).filter_map(|psi| Some((x(psi), pascals(psi)? / 1e5))).collect()
                };
                over_angle.curves.push(Curve::new(number, name.clone(), points(&f64::to_degrees)));
                loops.curves.push(Curve::new(number, name, points(volume)));
            };
        draw(index, name(class), &|psi| Some(gas.pressure(zero + psi)), &|psi| gas.geometry().volume(zero + psi) * 1e6);
        if gas.pressure_below(0.0).is_some() {
            let name = if torque.classes.len() == 1 { "below".to_owned() } else { format!("below {}", name(class)) };
            let number = index + torque.classes.len().min(MOST_CURVES);
            draw(number, name, &|psi| gas.pressure_below(zero + psi), &|psi| gas.volume_below(zero + psi) * 1e6);
        }
    }
    [
        Picture::new("pressure", text::pressure_over_angle(), over_angle.figure()),
        Picture::new("loop", text::pressure_over_volume(), loops.figure()),
    ]
}
