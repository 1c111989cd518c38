//! Which forces do pistons, rods, crankpins and main bearings feel through the cycle, of gas and masses together?
//!
//! Each piston pushes its rod with `F = F_g − F_in` towards the crank, and the wall with the side force `F tan β`; the rod pushes its crankpin
//! with `−F (1 − i tan β) e^{iα}` and its rotating mass, and the main bearings carry the pins in fixed parts (theory, section 12). Largest
//! values are those of the forces themselves, through the whole cycle; the orders are a series, halves in a four-stroke engine.

mod carried;
mod force_history;
mod instant;
mod largest;
mod order;
mod peak;
mod shared;

pub use carried::Carried;
pub use force_history::{ForceHistory, PistonForces};
pub use instant::{Instants, PistonAt};
pub use largest::{CyclePeak, CylinderPeaks};
pub use order::{CycleMean, JournalOrder, Series};
pub use peak::LoadPeak;
pub use shared::SharedPin;

use num_rational::BigRational;
use num_traits::Zero;

use crate::engine::Engine;
use crate::gas::Warning;
use crate::loads::{self, Method, Missing, Scale, Shares, bearing_loads, pin_loads};
use crate::torque::{self, Class, HIGHEST};
use largest::Samples;
use order::HandedOn;

/// The complete loads of an engine through its cycle, in newtons.
#[derive(Clone, Debug)]
pub struct CycleLoads {
    /// The forces at any crank angle.
    pub course: ForceHistory,
    /// What each cylinder loads its wall, its rod and its crankpin with, in the order of the layout.
    pub cylinders: Vec<CylinderLoads>,
    /// What the knuckle pins of links feel, in the order of their cylinders.
    pub knuckles: Vec<KnuckleLoads>,
    /// What crankpins feel on which several rods work, in the order of the throws.
    pub shared_pins: Vec<SharedPin>,
    /// What the main bearings feel, as a continuous beam and by the determinate approximation; none where the file gives no bearings.
    pub bearings: Option<[CycleBearings; 2]>,
    /// What is odd about a pressure: the cylinders, and what.
    pub warnings: Vec<(Vec<usize>, Warning)>,
}

/// What one cylinder does.
#[derive(Clone, Debug)]
pub struct CylinderLoads {
    /// The largest forces.
    pub peaks: CylinderPeaks,
    /// The load of its crankpin by orders.
    pub pin: Series,
}

/// What the knuckle pin of a link feels.
#[derive(Clone, Debug)]
pub struct KnuckleLoads {
    /// The cylinder of the link, by its index.
    pub cylinder: usize,
    /// That whose rod it hangs on.
    pub master: usize,
    /// The largest load in a cycle, seen from the engine.
    pub peak: CyclePeak,
    /// The largest load of the masses alone.
    pub inertia: CyclePeak,
}

/// What all main bearings feel.
#[derive(Clone, Debug)]
pub struct CycleBearings {
    /// The bearings, in the order of the file.
    pub bearings: Vec<CycleBearing>,
    /// Indices of those with the largest peak.
    pub worst: Vec<usize>,
}

/// What one main bearing feels: the force in the direction of the load, not the one that it answers with.
#[derive(Clone, Debug)]
pub struct CycleBearing {
    /// What it is called: its number, beside the name of its crankshaft where there are several.
    pub name: String,
    /// Which crankshaft it carries, where several are geared together; else 0.
    pub crank: usize,
    /// Where it stands, in the unit of the layout's positions.
    pub position: BigRational,
    /// What it carries of a unit load on each crankpin in decimals, and the force of the masses of the shaft itself at θ = 0.
    pub carried: Carried,
    /// The largest force in a cycle.
    pub peak: CyclePeak,
    /// The largest force of the masses alone.
    pub inertia: CyclePeak,
    /// The load by orders.
    pub series: Series,
}

impl CycleLoads {
    /// How much of the load of any bearing the orders miss at most, by the search that finds the largest loads; none without bearings.
    pub fn missed(&self, bearings: &CycleBearings) -> f64 {
        let period = self.course.period();
        let grid = torque::angles_with(self.course.kinks(), period);
        let of_one = |bearing: &CycleBearing| {
            let miss = |theta: f64| (self.course.carried(&bearing.carried, theta) - bearing.series.at(theta)).norm();
            let known: Vec<f64> = grid.iter().map(|&theta| miss(theta)).collect();
            torque::largest(period, &grid, &known, miss).value
        };
        bearings.bearings.iter().map(of_one).fold(0.0, f64::max)
    }
}

impl SharedPin {
    /// Whether one of its rods is a link, on the knuckle pin of another: that one loads the crankpin for all.
    pub fn has_links(&self, loads: &CycleLoads) -> bool {
        loads.knuckles.iter().any(|knuckle| self.cylinders.contains(&knuckle.cylinder))
    }

    /// The largest load of one of its rods alone, and the cylinder of that rod, by index; none where there are links.
    pub fn largest_of_a_rod(&self, loads: &CycleLoads) -> Option<(usize, CyclePeak)> {
        if self.has_links(loads) {
            return None;
        }
        let rods = self.cylinders.iter().map(|&cylinder| (cylinder, loads.cylinders[cylinder].peaks.pin));
        // Of loads that are equal but for roundings the first is named.
        rods.reduce(|most, rod| if rod.1.value > most.1.value * (1.0 + 1e-9) { rod } else { most })
    }
}

/// The classes of equal cylinders, with masses and speed, and the unit of the forces.
fn classes(engine: &Engine) -> Result<(Vec<Class>, Scale), Missing> {
    let classes = torque::classes(engine)?;
    let scale = loads::scale(engine).filter(|_| classes.iter().all(|class| class.inertia.is_some()));
    Ok((classes, scale.ok_or(Missing::MassesOrSpeed)?))
}

/// The forces of an engine at any crank angle, without their largest values and orders.
///
/// # Errors
/// What the layout lacks.
pub fn course(engine: &Engine) -> Result<ForceHistory, Missing> {
    let (classes, scale) = classes(engine)?;
    Ok(ForceHistory::new(engine, classes, scale.force()))
}

/// The complete loads of an engine.
///
/// # Errors
/// What the layout lacks.
pub fn cycle_loads(engine: &Engine) -> Result<CycleLoads, Missing> {
    let (classes, scale) = classes(engine)?;
    let whole: Vec<u32> = (1..=HIGHEST).collect();
    let pins = pin_loads(engine, &whole)?;
    let warnings = torque::warnings(engine, &classes);
    let warnings = warnings.into_iter().map(|(class, warning)| (classes[class].cylinders.clone(), warning)).collect();
    let course = ForceHistory::new(engine, classes, scale.force());
    let samples = Samples::new(&course);
    let handed = order::handed_on(engine, &course);
    let cylinders = pins.pins.iter().enumerate().map(|(index, pin)| {
        let own = |of: usize| BigRational::from_integer(i32::from(of == index).into());
        let inertia = pin.orders.iter().map(|order| (order.order, &order.swing));
        CylinderLoads {
            peaks: CylinderPeaks::new(&course, &samples, index),
            pin: order::series(engine, &handed, own, inertia, scale.force()),
        }
    });
    let cylinders = cylinders.collect();
    let bearings = match engine.bearings().is_empty() {
        true => None,
        false => {
            let solve = |method| bearings(engine, &course, (&samples, &handed), (method, scale.force()));
            Some([solve(Method::Continuous)?, solve(Method::Determinate)?])
        }
    };
    let shared_pins = SharedPin::of(engine, &course, &samples);
    let knuckle = |cylinder: usize| {
        let [peak, inertia] = samples.knuckle_peaks(&course, cylinder)?;
        Some(KnuckleLoads { cylinder, master: course.master_of(cylinder)?, peak, inertia })
    };
    let knuckles = (0..course.cylinders()).filter_map(knuckle).collect();
    Ok(CycleLoads { cylinders, knuckles, shared_pins, bearings, course, warnings })
}

/// What each main bearing carries of a unit load on each crankpin, and of all forces.
fn carried(
    engine: &Engine,
    classes: &[Class],
    (method, newtons): (Method, f64),
) -> Result<Vec<(Vec<BigRational>, Carried)>, Missing> {
    let shares = Shares::of(engine, method)?;
    let bearing = |crank: usize, index: usize| {
        let part = |position: &BigRational| shares.part(index, position);
        // A bearing carries its own crankshaft.
        let parts = engine.cylinders().iter().map(|cylinder| match cylinder.crank == crank {
            true => part(&cylinder.position),
            false => BigRational::zero(),
        });
        let parts: Vec<BigRational> = parts.collect();
        let carried = carried::carried_by((engine, classes), crank, &parts, part, newtons);
        (parts, carried)
    };
    let cranks = 0..engine.crankshafts();
    Ok(cranks
        .flat_map(|crank| (0..engine.bearings().len()).map(move |index| (crank, index)))
        .map(|(crank, index)| bearing(crank, index))
        .collect())
}

/// What the main bearings carry of the forces, in the order of the file, as a continuous beam.
///
/// # Errors
/// What the layout lacks.
pub fn carried_by_bearings(engine: &Engine) -> Result<Vec<Carried>, Missing> {
    let (classes, scale) = classes(engine)?;
    let all = carried(engine, &classes, (Method::Continuous, scale.force()))?;
    Ok(all.into_iter().map(|(_, carried)| carried).collect())
}

/// The largest load of each main bearing as in [`CycleLoads`], on a continuous beam, without its orders: of gas and masses, and of the
/// masses alone.
///
/// # Errors
/// What the layout lacks.
pub fn bearing_peaks(engine: &Engine) -> Result<Vec<[CyclePeak; 2]>, Missing> {
    let carried = carried_by_bearings(engine)?;
    let course = course(engine)?;
    let samples = Samples::new(&course);
    Ok(carried.iter().map(|carried| samples.peaks_of(&course, carried)).collect())
}

/// Those with the largest peak, by their indices; none where nothing loads. Peaks closer than this are equal: the roundings of decimals
/// could not tell them apart.
pub fn worst(peaks: impl Iterator<Item = f64> + Clone) -> Vec<usize> {
    let largest = peaks.clone().fold(0.0, f64::max);
    let is_worst = |(_, peak): &(usize, f64)| largest > 0.0 && *peak >= largest * (1.0 - 1e-9);
    peaks.enumerate().filter(is_worst).map(|(index, _)| index).collect()
}

fn bearings(
    engine: &Engine,
    course: &ForceHistory,
    (samples, handed): (&Samples, &[HandedOn]),
    (method, newtons): (Method, f64),
) -> Result<CycleBearings, Missing> {
    let whole: Vec<u32> = (1..=HIGHEST).collect();
    let moving = bearing_loads(engine, &whole, method)?;
    let all = carried(engine, course.classes(), (method, newtons))?;
    let bearing = |(moving, (parts, carried)): (&loads::BearingLoad, (Vec<BigRational>, Carried))| {
        let inertia = moving.orders.iter().map(|order| (order.order, &order.swing));
        let [peak, inertia_alone] = samples.peaks_of(course, &carried);
        CycleBearing {
            name: moving.name.clone(),
            crank: moving.crank,
            position: moving.position.clone(),
            peak,
            inertia: inertia_alone,
            series: order::series(engine, handed, |of| parts[of].clone(), inertia, newtons),
            carried,
        }
    };
    let bearings: Vec<CycleBearing> = moving.bearings.iter().zip(all).map(bearing).collect();
    let worst = worst(bearings.iter().map(|bearing| bearing.peak.value));
    Ok(CycleBearings { bearings, worst })
}
