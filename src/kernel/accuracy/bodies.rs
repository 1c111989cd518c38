//! What is the load of an engine at a crank angle, from the closed form of its motion, in any kind of number?

use num_rational::BigRational;
use num_traits::One;

use super::real::Real;
use crate::engine::{Engine, Rod};
use crate::exact::Turn;
use crate::order::{self, TurningMass};
use crate::proof::Quantity;

/// A crank: λ, δ and the gaps `1 ± δ − λ`, which near the end of its reach decide.
#[derive(Clone, Debug)]
struct Crank<T> {
    one: T,
    ratio: T,
    offset: T,
    gap_above: T,
    gap_below: T,
}

/// What a cylinder adds: its crank, and how much its load counts along each direction.
#[derive(Clone, Debug)]
struct Piston<T> {
    crank: Crank<T>,
    parts: Vec<T>,
}

/// An engine in numbers of one kind, for one quantity: the force and the moment have two parts, the torque has one.
#[derive(Clone, Debug)]
pub(super) struct Bodies<T> {
    quantity: Quantity,
    pistons: Vec<Piston<T>>,
    /// The masses that turn with the crank: the vector `Σ U e^{iβ}`, weighed, at crank angle 0; none where there are none.
    rotating: Option<[T; 2]>,
}

/// Crank angle of each cylinder less that of the crankshaft, `β − α`.
pub(super) fn phases(engine: &Engine) -> Vec<Turn> {
    engine.cylinders().iter().map(|cylinder| &cylinder.throw - &cylinder.bank).collect()
}

impl<T: Real> Bodies<T> {
    /// The numbers of an engine that has rods, one per cylinder.
    pub fn new(
        engine: &Engine,
        quantity: Quantity,
        number: &dyn Fn(&BigRational) -> T,
        direction: &dyn Fn(&Turn) -> [T; 2],
    ) -> Self {
        let one = BigRational::one();
        let with_rod = engine.moved().filter_map(|(cylinder, mechanism)| Some((cylinder, mechanism.rod()?)));
        let pistons = with_rod.map(|(cylinder, Rod { ratio, offset })| {
            let mass_radius = order::mass_radius(engine, cylinder);
            let axis = || direction(&cylinder.bank);
            let along = |weight: BigRational| axis().iter().map(|part| part.times(&number(&weight))).collect();
            let parts = match quantity {
                Quantity::Planar(planar) => along(mass_radius * order::lever(engine, planar, &cylinder.position)),
                Quantity::Axial(_) => vec![number(&(mass_radius * &cylinder.crank_radius))],
            };
            let crank = Crank {
                one: number(&one),
                ratio: number(ratio),
                offset: number(offset),
                gap_above: number(&(&one + offset - ratio)),
                gap_below: number(&(&one - offset - ratio)),
            };
            Piston { crank, parts }
        });
        Bodies { quantity, pistons: pistons.collect(), rotating: rotating(engine, quantity, number, direction) }
    }

    /// The same engine in other numbers.
    pub fn map<U>(&self, change: &impl Fn(&T) -> U) -> Bodies<U> {
        let pistons = self.pistons.iter().map(|Piston { crank, parts }| Piston {
            crank: Crank {
                one: change(&crank.one),
                ratio: change(&crank.ratio),
                offset: change(&crank.offset),
                gap_above: change(&crank.gap_above),
                gap_below: change(&crank.gap_below),
            },
            parts: parts.iter().map(change).collect(),
        });
        let rotating = self.rotating.as_ref().map(|[x, y]| [change(x), change(y)]);
        Bodies { quantity: self.quantity, pistons: pistons.collect(), rotating }
    }

    /// The squared length of the load where the crankshaft and the cylinders are in these directions.
    ///
    /// None for an engine without cylinders.
    pub fn squared_load(&self, crankshaft: &[T; 2], cylinders: impl Iterator<Item = [T; 2]>) -> Option<T> {
        let mut sums: Vec<T> = self.pistons.first()?.parts.iter().map(T::zero_like).collect();
        for (piston, direction) in self.pistons.iter().zip(cylinders) {
            let Motion { shaking, velocity } = piston.crank.motion(&direction);
            let load = match self.quantity {
                Quantity::Axial(_) => velocity.times(&shaking),
                Quantity::Planar(_) => shaking,
            };
            for (sum, part) in sums.iter_mut().zip(&piston.parts) {
                *sum = sum.plus(&part.times(&load));
            }
        }
        if let (Some([u, v]), [x, y]) = (&self.rotating, sums.as_mut_slice()) {
            let [cos, sin] = crankshaft;
            *x = x.plus(&u.times(cos).minus(&v.times(sin)));
            *y = y.plus(&u.times(sin).plus(&v.times(cos)));
        }
        sums.iter().map(Real::squared).reduce(|sum, square| sum.plus(&square))
    }
}

/// The masses that turn with the crank, with their weights in the force or the moment, in multiples of m r.
pub(super) fn turning(engine: &Engine, quantity: Quantity) -> Vec<(Turn, BigRational)> {
    let Quantity::Planar(planar) = quantity else { return Vec::new() };
    let weight = |mass: TurningMass| {
        let lever = order::lever(engine, planar, &mass.position);
        (mass.angle, mass.mass_radius * lever)
    };
    order::turning_masses(engine).into_iter().filter(TurningMass::turns_with_the_crank).map(weight).collect()
}

fn rotating<T: Real>(
    engine: &Engine,
    quantity: Quantity,
    number: &dyn Fn(&BigRational) -> T,
    direction: &dyn Fn(&Turn) -> [T; 2],
) -> Option<[T; 2]> {
    let vectors = turning(engine, quantity).into_iter().map(|(angle, weight)| {
        let weight = number(&weight);
        direction(&angle).map(|part| part.times(&weight))
    });
    vectors.reduce(|[x, y], [u, v]| [x.plus(&u), y.plus(&v)])
}

/// Shaking force in `m r ω²`, outward, and velocity in `r ω`, outward.
struct Motion<T> {
    shaking: T,
    velocity: T,
}

impl<T: Real> Crank<T> {
    /// The closed form: with `x = λ sin ψ − δ` and `f = √(1 − x²)` the velocity is `−sin ψ − x cos ψ/f`, the shaking force
    /// `cos ψ + λ cos²ψ/f³ − x sin ψ/f` (theory, section 2).
    fn motion(&self, [cos, sin]: &[T; 2]) -> Motion<T> {
        let slant = self.ratio.times(sin).minus(&self.offset);
        let above = self.gap_above.plus(&self.ratio.times(&self.one.minus(sin)));
        let below = self.gap_below.plus(&self.ratio.times(&self.one.plus(sin)));
        let inverse = above.times(&below).root().inverse();
        let (swing, tilt) = (cos.times(&inverse), slant.times(&inverse));
        let rod = self.ratio.times(&swing.squared()).times(&inverse);
        let shaking = cos.plus(&rod).minus(&tilt.times(sin));
        let velocity = sin.zero_like().minus(sin).minus(&tilt.times(cos));
        Motion { shaking, velocity }
    }
}
