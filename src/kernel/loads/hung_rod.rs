//! What do the knuckle pins of a master rod feel, and what do their links do to its piston and its crankpin?

use std::f64::consts::TAU;

use num_complex::Complex;
use num_traits::Zero;

use super::{Harmonic, Peak, Waveform};
use crate::engine::{Cylinder, Engine};
use crate::motion::{HungLink, SliderCrank, harmonic};
use crate::numbers;
use crate::order::{self, mass_radius};

/// A link that hangs on a master rod: what it hands on at a crank angle.
#[derive(Clone, Debug)]
pub struct HungRod {
    /// The cylinder whose rod it is, by its index.
    pub cylinder: usize,
    /// That whose rod it hangs on.
    pub master: usize,
    link: HungLink,
    axis: Complex<f64>,
    /// The angle θ at which ψ is 0, in radians.
    top: f64,
    /// `m r ω²` of the mass at the knuckle pin, in multiples of the engine's.
    weight: f64,
}

impl HungRod {
    /// Those of an engine, in the order of their cylinders.
    pub fn all(engine: &Engine) -> Vec<Self> {
        let cylinders = engine.cylinders();
        let rod = |(cylinder, own): (usize, &Cylinder)| {
            let link = own.link()?;
            Some(HungRod {
                cylinder,
                master: cylinders.iter().position(|other| other.is_master_of(own))?,
                link: link.hung(),
                axis: numbers::direction(&own.bank),
                top: numbers::float(own.top_dead_centre().turns()) * TAU,
                weight: numbers::float(&(&own.knuckle_mass * &own.crank_radius)),
            })
        };
        cylinders.iter().enumerate().filter_map(rod).collect()
    }

    fn psi(&self, theta: f64) -> f64 {
        theta - self.top
    }

    /// `s''/r` of its piston.
    pub fn acceleration(&self, theta: f64) -> f64 {
        self.link.acceleration(self.psi(theta))
    }

    /// tan β of the link, in its own cylinder.
    pub fn slope(&self, theta: f64) -> f64 {
        self.link.slope(self.psi(theta))
    }

    /// What the knuckle pin and what is fixed to it load the master rod with, seen from the engine: a force on the piston, outward along
    /// its cylinder, by the link, and the inertia of the mass at the knuckle pin. `unit` is what that is counted in, one m r ω².
    pub fn on_the_knuckle(&self, theta: f64, outward: f64, unit: f64) -> Complex<f64> {
        let [of_force, of_mass] = self.link.on_the_knuckle(self.psi(theta));
        (of_force * outward + of_mass * (self.weight * unit)) * self.axis
    }

    /// The force of the wall on the master's piston that this load of the knuckle pin calls for, a quarter turn anticlockwise from the
    /// axis of that cylinder outward.
    pub fn side(&self, theta: f64, knuckle: Complex<f64>) -> f64 {
        self.link.side(self.psi(theta), knuckle * self.axis.conj())
    }

    /// What the crankpin feels of this load of the knuckle pin, seen from the engine.
    pub fn on_the_crankpin(&self, theta: f64, knuckle: Complex<f64>) -> Complex<f64> {
        self.link.handed_on(self.psi(theta), knuckle * self.axis.conj()) * self.axis
    }

    /// The direction from the crankpin to the knuckle pin.
    pub fn outward(&self, theta: f64) -> Complex<f64> {
        self.link.outward(self.psi(theta)) * self.axis
    }
}

/// What links do by the masses alone, in multiples of m r ω².
#[derive(Clone, Debug)]
pub struct LinkLoads {
    /// The knuckle pins, in the order of their cylinders.
    pub knuckles: Vec<KnuckleLoad>,
    /// The master rods, likewise.
    pub masters: Vec<MasterLoad>,
}

/// What a knuckle pin loads the master rod with: the link along itself, and the mass at the pin.
#[derive(Clone, Debug)]
pub struct KnuckleLoad {
    /// The cylinder of the link, and that of its master, by their index.
    pub cylinder: usize,
    /// The master.
    pub master: usize,
    /// The largest load in a revolution, seen from the engine.
    pub peak: Peak,
    /// The load seen from the master rod: the real part is away from the crankpin.
    pub on_the_rod: Waveform,
    /// The largest side force that it puts on the master's piston.
    pub side: Peak,
}

/// What a master rod does with its links.
#[derive(Clone, Debug)]
pub struct MasterLoad {
    /// Its cylinder, by its index.
    pub cylinder: usize,
    /// The cylinders whose links hang on it.
    pub links: Vec<usize>,
    /// The largest load of the crankpin by all rods together, with the rotating part of the master rod.
    pub crankpin: Peak,
    /// The load of the crankpin seen from the crank: the real part is outward along the throw.
    pub on_the_crank: Waveform,
    /// The largest side force of the wall on its piston, with what the links put on it.
    pub side: Peak,
    /// The same without links: that of its own piston.
    pub own_side: Peak,
}

/// Steps of a revolution, of which orders up to a quarter of them are kept.
const STEPS: usize = 1024;
const HIGHEST: u32 = 256;

/// What the links of an engine do by the masses alone; none where it has none.
pub fn link_loads(engine: &Engine) -> Option<LinkLoads> {
    let rods = HungRod::all(engine);
    if rods.is_empty() {
        return None;
    }
    let mass = |index: usize| numbers::float(&mass_radius(engine, &engine.cylinders()[index]));
    let knuckle =
        |rod: &HungRod, theta: f64| rod.on_the_knuckle(theta, -mass(rod.cylinder) * rod.acceleration(theta), 1.0);
    let knuckles = rods.iter().map(|rod| KnuckleLoad {
        cylinder: rod.cylinder,
        master: rod.master,
        peak: law(|theta| knuckle(rod, theta)).peak(),
        on_the_rod: law(|theta| knuckle(rod, theta) * rod.outward(theta).conj()),
        side: law(|theta| rod.side(theta, knuckle(rod, theta)).into()).real_peak(),
    });
    let master = |index: usize| {
        let cylinder = &engine.cylinders()[index];
        let crank = cylinder.mechanism.as_ref().and_then(order::crank)?;
        let links: Vec<&HungRod> = rods.iter().filter(|rod| rod.master == index).collect();
        let own = Own::new(engine, index, crank);
        let of_links = |theta: f64| links.iter().map(move |rod| rod.side(theta, knuckle(rod, theta))).sum::<f64>();
        let pin = |theta: f64| {
            let hung = links.iter().map(|rod| rod.on_the_crankpin(theta, knuckle(rod, theta)));
            own.pin(theta) + hung.sum::<Complex<f64>>()
        };
        let crankpin = law(pin);
        let on_the_crank = law(|theta| pin(theta) * (own.throw * Complex::cis(theta)).conj());
        Some(MasterLoad {
            cylinder: index,
            links: links.iter().map(|rod| rod.cylinder).collect(),
            crankpin: crankpin.peak(),
            on_the_crank,
            side: law(|theta| (own.side(theta) + of_links(theta)).into()).real_peak(),
            own_side: law(|theta| own.side(theta).into()).real_peak(),
        })
    };
    let mut masters: Vec<usize> = rods.iter().map(|rod| rod.master).collect();
    masters.sort_unstable();
    masters.dedup();
    Some(LinkLoads { knuckles: knuckles.collect(), masters: masters.into_iter().filter_map(master).collect() })
}

/// The piston of a master, and what turns with its rod.
struct Own {
    crank: SliderCrank,
    axis: Complex<f64>,
    throw: Complex<f64>,
    top: f64,
    mass: f64,
    rotating: f64,
}

impl Own {
    fn new(engine: &Engine, index: usize, crank: SliderCrank) -> Self {
        let cylinder = &engine.cylinders()[index];
        Own {
            crank,
            axis: numbers::direction(&cylinder.bank),
            throw: numbers::direction(&cylinder.throw),
            top: numbers::float(cylinder.top_dead_centre().turns()) * TAU,
            mass: numbers::float(&mass_radius(engine, cylinder)),
            rotating: numbers::float(&order::big_end(engine, cylinder)),
        }
    }

    fn inertia(&self, theta: f64) -> f64 {
        -self.mass * self.crank.acceleration(theta - self.top)
    }

    fn side(&self, theta: f64) -> f64 {
        -self.inertia(theta) * self.crank.rod_slope(theta - self.top)
    }

    fn pin(&self, theta: f64) -> Complex<f64> {
        Complex::new(self.inertia(theta), self.side(theta)) * self.axis
            + self.throw * Complex::cis(theta) * self.rotating
    }
}

/// A law of the crank angle by its harmonics.
fn law(value: impl Fn(f64) -> Complex<f64>) -> Waveform {
    let values: Vec<Complex<f64>> = (0..STEPS).map(|place| value(TAU * place as f64 / STEPS as f64)).collect();
    let largest = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let mean = |order: i64| {
        let mean = harmonic(&values, order.rem_euclid(STEPS as i64) as usize);
        // What is no more than roundings is no order.
        if mean.norm() > 1e-12 * largest { mean } else { Complex::zero() }
    };
    let mut harmonics: Vec<Harmonic> = Vec::new();
    for order in 0..HIGHEST {
        let reverse = if order == 0 { Complex::zero() } else { mean(-i64::from(order)) };
        let harmonic = Harmonic { order, direct: mean(order.into()), reverse };
        // They fall as a geometric series does; some of the first may be none.
        if order > 8 && harmonics.iter().rev().take(3).chain([&harmonic]).all(Harmonic::is_none) {
            break;
        }
        harmonics.push(harmonic);
    }
    Waveform::new(harmonics)
}
