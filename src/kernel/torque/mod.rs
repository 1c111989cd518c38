//! Which torque does the engine give, how evenly does it turn, and what flywheel does it need?
//!
//! Each cylinder gives the torque of its gas and of its inertia, by its own angle ψ = θ − φ_j, φ_j where it fires. Equal cylinders
//! are one class: the order κ of a class is `Re t_κ S_κ e^{iκθ}`, its star `S_κ = Σ e^{−iκφ_j}` exact (theory, section 12).

mod bodies;
mod class;
mod curve;
mod evenness;
mod extreme;
mod guide;
mod order;
mod peak;

pub use crate::loads::PeakMethod;
pub use bodies::{Bodies, HIGHEST, Inertia, bodies, up_to as bodies_up_to};
pub use class::{Class, classes, up_to as classes_up_to, warnings};
pub use curve::TorqueCurve;
pub use evenness::{Evenness, evenness};
pub use extreme::{Extreme, angles, angles_with, extremes, largest};
pub use guide::{GuideMoments, guide_moments};
pub use order::{TorqueOrder, orders, roll_of, roll_of_gas};
pub use peak::Peak;

use crate::engine::Engine;
use crate::gas::{CylinderGas, Warning};
use crate::loads::Missing;

/// The torque of an engine through its cycle and by orders.
#[derive(Clone, Debug)]
pub struct EngineTorque {
    /// The classes of equal cylinders.
    pub classes: Vec<Class>,
    /// The masses that move, by their motion.
    pub bodies: Vec<Bodies>,
    /// Through the cycle.
    pub course: TorqueCurve,
    /// Orders of the cycle, rising; halves in a four-stroke.
    pub orders: Vec<TorqueOrder>,
    /// Mean torque in newton-metres.
    pub mean: f64,
    /// How far the mean of the series and the area of the loops are apart, as a part of the mean work of the gas.
    pub balance: f64,
    /// The largest torque.
    pub highest: Extreme,
    /// The smallest, which may be negative.
    pub lowest: Extreme,
    /// The largest and the smallest roll moment on the frame, without that of masses that turn; none where an arm is not known.
    pub roll: Option<[Extreme; 2]>,
    /// The torque on each of several crankshafts that are geared together; none where there is one.
    pub shafts: Vec<ShaftTorque>,
    /// How much the series up to the highest order misses of the torque, at most, by the search that finds the largest torque.
    pub missed: f64,
    /// Power at the speed in watts; none where no speed is given.
    pub power: Option<f64>,
    /// How evenly it turns; none where no speed is given.
    pub evenness: Option<Evenness>,
    /// What is odd about a pressure, by class.
    pub warnings: Vec<(usize, Warning)>,
}

/// The torque on one of several crankshafts, positive in the sense in which it turns. With the flywheel at the first crankshaft the gears
/// carry that of the others to it; where each has a flywheel of its own, their means alone.
#[derive(Clone, Debug)]
pub struct ShaftTorque {
    /// Which of them.
    pub shaft: usize,
    /// Its mean in newton-metres.
    pub mean: f64,
    /// The largest and the smallest.
    pub extremes: [Extreme; 2],
}

/// The torque of an engine, gas and inertia.
///
/// # Errors
/// What the layout lacks.
pub fn torque(engine: &Engine) -> Result<EngineTorque, Missing> {
    torque_up_to(engine, HIGHEST)
}

/// The torque of an engine with its orders up to this one.
///
/// # Errors
/// What the layout lacks.
pub fn torque_up_to(engine: &Engine, highest_order: u32) -> Result<EngineTorque, Missing> {
    let classes = class::up_to(engine, highest_order)?;
    let bodies = bodies::up_to(engine, highest_order);
    let course = TorqueCurve::new(engine, &classes, &bodies);
    let orders = orders(&classes, &bodies);
    let each = |of: &dyn Fn(&Class) -> f64| -> f64 {
        classes.iter().map(|class| of(class) * class.cylinders.len() as f64).sum()
    };
    let work = each(&|class| class.gas.work() / f64::from(class.gas.pistons()));
    let mean = each(&|class| class.harmonics.torque[0].re);
    // Cylinders that work against each other leave a mean that is none.
    let mean = if mean.abs() <= each(&|class| class.harmonics.errors[2]) { 0.0 } else { mean };
    // Roundings are those of the reciprocating mass within a cycle.
    let moved = |gas: &CylinderGas| (gas.peak_pressure().0 + gas.crankcase()) * gas.geometry().swept();
    let moved: f64 = classes.iter().map(|class| moved(&class.gas)).sum();
    let omega = bodies::omega(engine);
    let warnings = warnings(engine, &classes);
    let [highest, lowest] = course.extremes(|theta| course.total(theta));
    let [most, least] = course.extremes(|theta| course.total(theta) - mean - series(&orders, theta));
    let missed = most.value.max(-least.value);
    Ok(EngineTorque {
        mean,
        balance: (mean * course.period() - work).abs() / work.abs().max(1e-3 * moved),
        highest,
        lowest,
        roll: course.roll(0.0).map(|_| course.extremes(|theta| course.roll(theta).unwrap_or_default())),
        shafts: (0..engine.geared_cranks().len()).map(|shaft| on_shaft(&course, shaft)).collect(),
        bodies,
        missed,
        power: omega.map(|omega| mean * omega),
        evenness: omega.filter(|omega| *omega > 0.0).map(|omega| evenness(engine, &course, omega)),
        classes,
        course,
        orders,
        warnings,
    })
}

fn on_shaft(course: &TorqueCurve, shaft: usize) -> ShaftTorque {
    ShaftTorque { shaft, mean: course.mean_on(shaft), extremes: course.extremes(|theta| course.on_shaft(shaft, theta)) }
}

/// The sum of the orders at an angle.
fn series(orders: &[TorqueOrder], theta: f64) -> f64 {
    let at = |order: &TorqueOrder| {
        let kappa = order.order.value();
        (order.total() * num_complex::Complex::cis(kappa * theta)).re
    };
    orders.iter().filter(|order| !order.vanishes()).map(at).sum()
}

impl EngineTorque {
    /// How uneven the torque is: the largest less the smallest, over the size of the mean; none where the mean is zero.
    pub fn unevenness(&self) -> Option<f64> {
        let part = (self.highest.value - self.lowest.value) / self.mean.abs();
        part.is_finite().then_some(part)
    }

    /// The torque that is largest in size: the highest, or the lowest.
    pub fn largest(&self) -> Extreme {
        if self.lowest.value.abs() > self.highest.value.abs() { self.lowest } else { self.highest }
    }

    /// Whether the masses' inertia is in it.
    pub fn has_inertia(&self) -> bool {
        self.bodies.iter().all(|of| of.inertia.is_some())
    }
}
