//! What is said of an engine on its mounts? Modes, what each order does at a speed and over a range, what vanishes on any mounts.

mod data;
mod page;
mod plots;
mod range;
mod tables;
mod words;

use std::sync::OnceLock;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::question::question;
use super::rising;
use crate::engine::{CycleOrder, Dimensions, Draft, Engine, Mounting};
use crate::mounts::{
    Body, Excitation, Mode, Motion, NoExcitation, OrderExcitation, Phasors, RollAxis, excitation, roll_axis,
    usual_orders,
};

/// A range begins at this part of its end where no beginning is asked for.
const BEGINNING: f64 = 0.1;
/// Faster than this, in revolutions a minute, nothing is asked.
const FASTEST: f64 = 1e6;
/// Mounts so soft that no frequency reaches this, in Hz, are those of no engine.
const SOFTEST: f64 = 0.5;

/// What is asked of an engine on its mounts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MountsAsked {
    /// Orders; the usual ones where there are none.
    pub orders: Vec<CycleOrder>,
    /// The speed in revolutions a minute, in place of that of the layout.
    pub speed: Option<f64>,
    /// Where a range of speeds begins; a tenth of its end where it is left out.
    pub from: Option<f64>,
    /// Where it ends; at the speed where it is left out.
    pub to: Option<f64>,
}

/// Why there is no study.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoMounts {
    /// The layout has no mounts.
    #[error(
        "the layout gives no mounts; add [block] with mass = \"180 kg\", inertia = [13, 11, 6.5] in kg m² and centre = [0.1, 0, 0] in metres, and a table [[mount]] with place and stiffness for each mount"
    )]
    Nothing,
    /// A speed that is none.
    #[error("{0} is no speed; write revolutions a minute above 0 and up to {FASTEST}, such as 3000")]
    Speed(f64),
    /// The layout has a speed that is none.
    #[error(
        "the speed of the layout, {0} rpm, is none to shake at; write revolutions a minute above 0 and up to {FASTEST} there, such as speed = 3000, or ask at another speed"
    )]
    SpeedOfLayout(f64),
    /// A range that does not rise.
    #[error("from {0} to {1} is no range of speeds; its beginning is above 0 and below its end")]
    Range(f64, f64),
    /// What the layout lacks.
    #[error("{0}")]
    Excitation(NoExcitation),
}

/// What one order does at the speed.
#[derive(Clone, Debug)]
pub struct OrderMotion {
    /// What shakes.
    pub excitation: OrderExcitation,
    /// Force and moment about the centre of gravity, in newtons and newton-metres.
    pub load: [Phasors; 2],
    /// How the body moves; none at a natural frequency of an undamped one.
    pub motion: Option<Motion>,
}

/// A place of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The centre of gravity.
    Centre,
    /// The point that the file names.
    Point,
    /// The seat of a mount, by its index.
    Mount(usize),
}

/// One order at one speed of the range.
#[derive(Clone, Debug)]
pub struct AtSpeed {
    /// In revolutions a minute.
    pub rpm: f64,
    /// Its place among the orders.
    pub order: usize,
    /// The largest component of the velocity of the watched place, in metres a second, zero to peak; none where it has no bound: at a
    /// natural frequency without damping.
    pub velocity: Option<f64>,
    /// The largest component of a mount force in newtons, zero to peak.
    pub force: Option<f64>,
}

/// An engine on its mounts.
#[derive(Clone, Debug)]
pub struct MountsStudy {
    /// The engine, at the speed.
    pub engine: Engine,
    /// The speed in revolutions a minute.
    pub speed: f64,
    /// The body.
    pub body: Body,
    /// Its modes, rising.
    pub modes: Vec<Mode>,
    /// Its torque-roll axis.
    pub axis: Option<RollAxis>,
    /// Whether the torque of the gas shakes it too.
    pub has_gas: bool,
    /// The orders, rising.
    pub orders: Vec<OrderMotion>,
    /// The ends of the range of speeds.
    ends: [f64; 2],
    /// The orders over it, once they are asked for.
    over_range: OnceLock<Vec<AtSpeed>>,
}

/// Length of a component, the same on every machine.
fn peak(part: &num_complex::Complex<f64>) -> f64 {
    crate::numbers::length(*part)
}

fn largest(parts: &Phasors) -> f64 {
    parts.iter().map(peak).fold(0.0, f64::max)
}

impl MountsStudy {
    /// Modes, motions and mount forces.
    ///
    /// # Errors
    /// See [`NoMounts`].
    pub fn new(engine: &Engine, asked: &MountsAsked) -> Result<Self, NoMounts> {
        let mounting = engine.mounting().ok_or(NoMounts::Nothing)?;
        let given = [asked.speed, asked.from, asked.to].into_iter().flatten();
        if let Some(wrong) = given.into_iter().find(|speed| !(*speed > 0.0 && *speed <= FASTEST)) {
            return Err(NoMounts::Speed(wrong));
        }
        let engine = match asked.speed.and_then(BigRational::from_float) {
            None => engine.clone(),
            Some(speed) => {
                let dimensions = Dimensions { speed: Some(speed), ..engine.dimensions().clone() };
                let draft = Draft { dimensions, ..engine.clone().into_draft() };
                draft.build().map_err(|_| NoMounts::Speed(asked.speed.unwrap_or_default()))?
            }
        };
        let known = engine.dimensions().speed.as_ref().and_then(ToPrimitive::to_f64);
        let speed = known.ok_or(NoMounts::Excitation(NoExcitation::Scale))?;
        if !(speed > 0.0 && speed <= FASTEST) {
            return Err(NoMounts::SpeedOfLayout(speed));
        }
        let to = asked.to.unwrap_or(speed);
        let from = asked.from.unwrap_or(BEGINNING * to);
        if from >= to {
            return Err(NoMounts::Range(from, to));
        }
        let orders = rising(if asked.orders.is_empty() { usual_orders(&engine) } else { asked.orders.clone() });
        let Excitation { orders, has_gas } = excitation(&engine, mounting, &orders).map_err(NoMounts::Excitation)?;
        let body = Body::new(mounting);
        let at_speed = |excitation: OrderExcitation| {
            let load = excitation.at(speed);
            let motion = body.motion(excitation.omega(speed), load[0], load[1]);
            OrderMotion { excitation, load, motion }
        };
        Ok(MountsStudy {
            speed,
            modes: body.modes(),
            axis: roll_axis(&body),
            has_gas,
            orders: orders.into_iter().map(at_speed).collect(),
            ends: [from, to],
            over_range: OnceLock::new(),
            engine,
            body,
        })
    }

    fn mounting(&self) -> &Mounting {
        self.engine.mounting().unwrap_or_else(|| unreachable!("a study of mounts has mounts"))
    }

    /// Centre of gravity, the point of the file, the mounts.
    pub fn places(&self) -> Vec<Place> {
        let point = self.mounting().block.point.as_ref().map(|_| Place::Point);
        let mounts = (0..self.body.mounts()).map(Place::Mount);
        std::iter::once(Place::Centre).chain(point).chain(mounts).collect()
    }

    /// The place that is watched over the range: the point of the file, else the centre of gravity.
    pub fn watched(&self) -> Place {
        if self.mounting().block.point.is_some() { Place::Point } else { Place::Centre }
    }

    /// How far a place moves, in metres.
    pub fn displacement(&self, place: Place, motion: &Motion) -> Phasors {
        match (place, &self.mounting().block.point) {
            (Place::Mount(mount), _) => self.body.at_mount(mount, motion),
            (Place::Point, Some(point)) => self.body.at_point(point, motion),
            (Place::Point | Place::Centre, _) => motion.centre,
        }
    }

    /// The largest component of the velocity of the watched place, in metres a second, zero to peak.
    fn velocity(&self, motion: &Motion) -> f64 {
        largest(&self.displacement(self.watched(), motion)) * motion.omega
    }

    /// `√(½ Σ (Ω^n q_k)²)` over the orders along x, y and z, whatever the phases are: displacement for n = 0, velocity, acceleration. None
    /// where an order meets a natural frequency without damping.
    pub fn rms(&self, place: Place, derivative: i32) -> Option<[f64; 3]> {
        let mut squares = [0.0; 3];
        for order in &self.orders {
            let motion = order.motion.as_ref()?;
            let parts = self.displacement(place, motion);
            for (sum, part) in squares.iter_mut().zip(&parts) {
                let one = peak(part) * motion.omega.powi(derivative);
                *sum += one * one / 2.0;
            }
        }
        Some(squares.map(f64::sqrt))
    }

    /// The orders that leave the engine still on any mounts, proved.
    fn still(&self) -> impl Iterator<Item = CycleOrder> {
        self.orders.iter().filter(|order| order.excitation.still.is_whole()).map(|order| order.excitation.order)
    }

    /// The others, with their places among all.
    fn moving(&self) -> impl Iterator<Item = (usize, &OrderMotion)> {
        self.orders.iter().enumerate().filter(|(_, order)| !order.excitation.still.is_whole())
    }
}

question!(MountsStudy, "mounts", |study| Some(study.engine.title()));
