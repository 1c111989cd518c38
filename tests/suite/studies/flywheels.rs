//! How uneven is the torque of each engine of a family, and what do its flywheel and its counterweights weigh?
//!
//! The flywheel is a ring of the radius ρ with all the inertia J that turns with the crank, `m = J/ρ²`: crankshaft and clutch would make it
//! lighter by the same amount at each engine of a family that shares them.

use crankstar::engine::{CycleOrder, Engine, Firing};
use crankstar::exact::PhasorSum;
use crankstar::file::{Template, parse_length};
use crankstar::sweep::{self, Amplitude, Geometry, Parameter};
use crankstar::torque::{self, TorqueOrder};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use serde::Deserialize;

use super::check::Weighs;
use super::study::Word;

/// Masses closer than this part of them are one, by roundings.
const ALIKE: f64 = 1e-9;

/// Engines with gas, and what evens them out.
#[derive(Clone, Debug)]
pub struct Flywheels {
    /// Radius of the ring of the flywheel in metres.
    pub flywheel_radius: BigRational,
    /// Radius of the centre of mass of each counterweight in metres.
    pub counterweight_radius: BigRational,
    /// The engine in line, for the value 0.
    pub in_line: Option<Evened>,
    /// One engine for each value of the family.
    pub points: Vec<Evened>,
}

/// One engine with its flywheel.
#[derive(Clone, Debug)]
pub struct Evened {
    /// The value of the family's parameter.
    pub at: BigRational,
    /// When its cylinders fire: by its file, or in the most even order that its throws allow, of several in that with the least ΔW.
    pub firing: Firing,
    /// The orders of its torque, with their exact firing stars.
    pub orders: Vec<TorqueOrder>,
    /// ΔW, the largest less the smallest work above the mean torque, in joules.
    pub energy: f64,
    /// The irregularity δ that the flywheel leaves.
    pub irregularity: f64,
    /// Speed in revolutions a minute.
    pub speed: BigRational,
    /// The inertia `J = ΔW/(δ ω²)`, in kilograms times square metres.
    pub inertia: f64,
    /// Mass of the flywheel in kilograms.
    pub flywheel: f64,
    /// Mass of two counterweights in the planes of the outermost throws, in kilograms; none where one plane would have to hold a couple.
    pub counterweights: Option<Amplitude>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FlywheelTable {
    layout: Word,
    in_line: Option<Word>,
    flywheel_radius: Word,
    counterweight_radius: Word,
}

impl FlywheelTable {
    /// The engines of a family with their flywheels; `read_file` gives the text of a file beside the study.
    pub fn flywheels(
        &self,
        name: &str,
        parameter: &Parameter,
        read_file: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Flywheels, String> {
        let [flywheel_radius, counterweight_radius] =
            [radius(&self.flywheel_radius)?, radius(&self.counterweight_radius)?];
        let text = read_file(&self.layout.0)?;
        let template = Template::new(name, &text).map_err(|error| error.to_string())?;
        let evened = |at: BigRational, template: &Template, engine: Engine| {
            evened(at, template, engine, [&flywheel_radius, &counterweight_radius])
        };
        let points = parameter.range.values().map(|value| {
            let engine = super::study::known(&template, &[(&parameter.key, &value.to_string())])?;
            evened(value, &template, engine)
        });
        let points = points.collect::<Result<Vec<_>, String>>()?;
        let in_line = |file: &Word| {
            let text = read_file(&file.0)?;
            let template = Template::new(name, &text).map_err(|error| error.to_string())?;
            evened(BigRational::zero(), &template, super::study::known(&template, &[])?)
        };
        let in_line = self.in_line.as_ref().map(in_line).transpose()?;
        Ok(Flywheels { in_line, points, flywheel_radius, counterweight_radius })
    }
}

fn radius(text: &Word) -> Result<BigRational, String> {
    let written = &text.0;
    match parse_length(written)?.0 {
        value if value.is_positive() => Ok(value),
        _ => Err(format!("a radius of `{written}` holds no mass; a length above 0, such as \"120 mm\"")),
    }
}

/// The engine with the least ΔW of those that fire most evenly.
fn evened(at: BigRational, template: &Template, engine: Engine, radii: [&BigRational; 2]) -> Result<Evened, String> {
    let mut best: Option<Evened> = None;
    for firing in sweep::most_even_firings(&engine, template.cycle()) {
        let mut draft = engine.clone().into_draft();
        draft.firing = Some(firing.clone());
        let fired = draft.build().map_err(|error| error.to_string())?;
        let fired = with_flywheel(at.clone(), firing, &fired, radii)?;
        if best.as_ref().is_none_or(|best| fired.energy < best.energy * (1.0 - ALIKE)) {
            best = Some(fired);
        }
    }
    best.ok_or_else(|| "the cycle of an engine with a flywheel is not given".to_owned())
}

fn with_flywheel(at: BigRational, firing: Firing, engine: &Engine, radii: [&BigRational; 2]) -> Result<Evened, String> {
    let torque = torque::torque(engine).map_err(|lack| lack.to_string())?;
    let (Some(evenness), Some(speed)) = (torque.evenness, engine.dimensions().speed.clone()) else {
        return Err("a flywheel needs an engine with a speed above 0".to_owned());
    };
    let [ring, centre] = radii.map(|radius| radius.to_f64().unwrap_or(f64::NAN));
    let unit = (engine.unit_mass() * engine.unit_radius()).to_f64().unwrap_or(f64::NAN);
    let needed = evenness.needed;
    Ok(Evened {
        at,
        firing,
        orders: torque.orders,
        energy: evenness.energy,
        irregularity: needed.irregularity,
        speed,
        inertia: needed.inertia,
        flywheel: needed.inertia / (ring * ring),
        counterweights: sweep::judge(engine, None, &[1], &Geometry::default())
            .map_err(|lack| lack.to_string())?
            .counterweight
            .map(|larger| Amplitude { value: 2.0 * larger.value * unit / centre, ..larger }),
    })
}

impl Evened {
    /// The firing star of an order of engines whose cylinders are all alike.
    pub fn star(&self, order: CycleOrder) -> Option<&PhasorSum> {
        match self.orders.iter().find(|own| own.order == order)?.stars.as_slice() {
            [only] => Some(only),
            _ => None,
        }
    }

    /// Flywheel and counterweights together, in kilograms.
    pub fn mass(&self) -> Option<f64> {
        Some(self.flywheel + self.counterweights?.value)
    }
}

impl Flywheels {
    /// All engines, the one in line first.
    pub fn all(&self) -> impl Iterator<Item = &Evened> {
        self.in_line.iter().chain(&self.points)
    }

    /// ΔW over that of the engine in line, or, without one, over the least of the family.
    pub fn ratio(&self, point: &Evened) -> f64 {
        let least = || self.points.iter().map(|point| point.energy).fold(f64::INFINITY, f64::min);
        point.energy / self.in_line.as_ref().map_or_else(least, |in_line| in_line.energy)
    }

    /// Where on the grid the flywheel weighs as is said.
    pub(super) fn weigh(&self, how: Weighs) -> Vec<BigRational> {
        let masses = || self.points.iter().map(|point| point.flywheel);
        let near = |mass: f64, bound: f64| (mass - bound).abs() <= ALIKE * bound;
        let at = |kept: &dyn Fn(usize, &Evened) -> bool| {
            let kept = self.points.iter().enumerate().filter(|(index, point)| kept(*index, point));
            kept.map(|(_, point)| point.at.clone()).collect()
        };
        match how {
            Weighs::Least => at(&|_, point| near(point.flywheel, masses().fold(f64::INFINITY, f64::min))),
            Weighs::Most => at(&|_, point| near(point.flywheel, masses().fold(0.0, f64::max))),
            Weighs::LessThanBefore => at(&|index, point| {
                let before = index.checked_sub(1).map(|before| self.points[before].flywheel);
                before.is_some_and(|before| point.flywheel < before && !near(point.flywheel, before))
            }),
        }
    }

    /// Where on the grid an order of the torque vanishes for every pressure that the cylinders share: exactly.
    pub(super) fn vanishing(&self, order: CycleOrder) -> Vec<BigRational> {
        let vanishes = |point: &&Evened| point.orders.iter().any(|own| own.order == order && own.vanishes());
        self.points.iter().filter(vanishes).map(|point| point.at.clone()).collect()
    }
}
