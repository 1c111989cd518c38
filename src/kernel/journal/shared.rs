//! What does a crankpin feel of all its rods together?

use num_complex::Complex;
use num_rational::BigRational;

use super::carried::{Carried, nothing};
use super::force_history::ForceHistory;
use super::largest::{CyclePeak, Samples};
use crate::engine::{Engine, Throw, throws};
use crate::numbers;

/// The load of a crankpin that several rods share: the sum of what each of them loads it with.
#[derive(Clone, Debug)]
pub struct SharedPin {
    /// Its throw, from 0, as the throws of the crankshaft are counted.
    pub throw: usize,
    /// The cylinders whose rods work on it, by index.
    pub cylinders: Vec<usize>,
    /// Where it stands: the middle of its rods, in the unit of the layout's positions.
    pub position: BigRational,
    /// The largest load of all its rods together.
    pub peak: CyclePeak,
    /// The largest load by the masses alone.
    pub inertia: CyclePeak,
    /// All of each of its rods.
    carried: Carried,
}

impl SharedPin {
    /// The pins of an engine on which two rods or more work.
    pub(super) fn of(engine: &Engine, course: &ForceHistory, samples: &Samples) -> Vec<Self> {
        let shared = throws(engine).into_iter().enumerate().filter(|(_, throw)| throw.cylinders.len() > 1);
        let pin = |(index, throw): (usize, Throw)| {
            let of = |cylinder: usize| BigRational::from_integer(i32::from(throw.cylinders.contains(&cylinder)).into());
            let parts: Vec<BigRational> = (0..course.cylinders()).map(of).collect();
            let nothing = nothing(engine, course.classes(), &parts, &[]);
            let parts = parts.iter().map(numbers::float).collect();
            let carried = Carried { parts, shaft: Complex::new(0.0, 0.0), turns: 1.0, nothing };
            let [peak, inertia] = samples.peaks_of(course, &carried);
            SharedPin { throw: index, cylinders: throw.cylinders, position: throw.position, peak, inertia, carried }
        };
        shared.map(pin).collect()
    }

    /// Its load, seen from the engine.
    pub fn load(&self, course: &ForceHistory, theta: f64) -> Complex<f64> {
        course.carried(&self.carried, theta)
    }

    /// The same seen from the crank: the real part is outward along the throw, the imaginary part in the sense of rotation.
    pub fn load_on_the_crank(&self, course: &ForceHistory, theta: f64) -> Complex<f64> {
        match self.cylinders.first() {
            Some(&first) => course.seen_from_the_crank(first, self.load(course, theta), theta),
            None => Complex::new(0.0, 0.0),
        }
    }
}
