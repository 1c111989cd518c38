//! What torque excites the train? That of gas and inertia, or the harmonics of the layout.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::engine::{CycleOrder, Engine, Shot, Torsion};
use crate::exact::{PhasorSum, Term, Turn, vanish_apart};
use crate::firing;
use crate::numbers::{self, float};
use crate::torque;
use crate::torsion::Train;

/// The torques of all orders on the discs.
#[derive(Clone, Debug)]
pub(super) struct Excited {
    orders: Vec<ExcitedOrder>,
    /// The speed at which the inertia is known, in revolutions a minute; none where harmonics are given.
    speed: Option<f64>,
    /// Orders whose torques add to nothing while they do not vanish on some disc, proved, where all cylinders give one torque.
    pub twist_alone: Vec<CycleOrder>,
    /// The crank angle θ of the layout at which the first cylinder fires, in turns, where angles count from that θ.
    first: BigRational,
}

#[derive(Clone, Debug)]
struct ExcitedOrder {
    order: CycleOrder,
    gas: Vec<Complex<f64>>,
    inertia: Vec<Complex<f64>>,
    /// Whether it twists nothing, proved: all that is alike cancels on each disc, or on those in mesh together.
    is_still: bool,
}

/// Cylinders that give one torque, on a disc: by when each gives it, in turns, and how much of it.
struct OnDisc {
    disc: usize,
    vectors: Vec<[BigRational; 2]>,
}

/// Cylinders that give one torque, disc by disc.
struct Alike(Vec<OnDisc>);

impl Alike {
    fn new(all: impl IntoIterator<Item = (usize, BigRational, BigRational)>) -> Self {
        let mut discs: Vec<OnDisc> = Vec::new();
        for (disc, fires, part) in all {
            match discs.iter_mut().find(|one| one.disc == disc) {
                Some(one) => one.vectors.push([fires, part]),
                None => discs.push(OnDisc { disc, vectors: vec![[fires, part]] }),
            }
        }
        Alike(discs)
    }

    /// The discs with their stars: 0 where that is proved.
    fn stars(&self, order: CycleOrder) -> impl Iterator<Item = (usize, Complex<f64>)> {
        self.0.iter().map(move |one| (one.disc, numbers::evaluate(&sum(order, &one.vectors))))
    }

    /// Whether discs in mesh, which turn as one, have a star of 0 together, and so does every other disc.
    fn is_still(&self, order: CycleOrder, train: &Train) -> bool {
        let of_disc = |one: &OnDisc| {
            let node = train.node(one.disc);
            one.vectors.iter().map(move |vector| (node, term(order, vector))).collect::<Vec<_>>()
        };
        vanish_apart(self.0.iter().flat_map(of_disc))
    }
}

fn sum<'a>(order: CycleOrder, vectors: impl IntoIterator<Item = &'a [BigRational; 2]>) -> PhasorSum {
    PhasorSum::new(vectors.into_iter().map(|vector| term(order, vector)).collect())
}

fn term(order: CycleOrder, [fires, part]: &[BigRational; 2]) -> Term {
    Term { angle: order.phase(fires), weight: part.clone() }
}

/// Orders whose star is zero, but not that of the cylinders on some disc.
fn twisting_alone(orders: &[ExcitedOrder], alike: &Alike) -> Vec<CycleOrder> {
    let twists = |order: &CycleOrder| {
        sum(*order, alike.0.iter().flat_map(|one| &one.vectors)).vanishes()
            && alike.0.iter().any(|one| !sum(*order, &one.vectors).vanishes())
    };
    orders.iter().map(|one| one.order).filter(twists).collect()
}

impl ExcitedOrder {
    /// One that has no torque yet.
    fn new(order: CycleOrder, discs: usize) -> Self {
        let nothing = || vec![Complex::default(); discs];
        ExcitedOrder { order, gas: nothing(), inertia: nothing(), is_still: true }
    }

    /// With a torque of these cylinders, of inertia or of gas.
    fn add(&mut self, train: &Train, alike: &Alike, torque: Complex<f64>, is_inertia: bool) {
        let to = if is_inertia { &mut self.inertia } else { &mut self.gas };
        alike.stars(self.order).for_each(|(disc, star)| to[disc] += torque * star * train.sense(disc));
        self.is_still &= torque.is_zero() || alike.is_still(self.order, train);
    }
}

/// Orders of gas and inertia are added up to this one, and to the first major order.
const HIGHEST: u32 = 24;

/// The highest order of gas and inertia that is added.
pub(super) fn highest(engine: &Engine) -> u32 {
    engine.firing().map_or(HIGHEST, |firing| HIGHEST.max(firing.first_major_order()))
}

impl Excited {
    /// That of an engine; none where the layout has neither harmonics nor gas with a speed above 0.
    pub fn new(engine: &Engine, torsion: &Torsion, train: &Train) -> Option<Self> {
        let disc = |cylinder: usize| torsion.pins[engine.cylinders()[cylinder].pin];
        let discs = torsion.inertias.len();
        if !torsion.harmonics.is_empty() {
            let fires = |shot: &&Shot| engine.misfire() != Some(shot.cylinder);
            let shots: Vec<&Shot> = firing::firing_of(engine).ok()?.shots.iter().filter(fires).collect();
            let each = |shot: &&Shot| {
                let pistons = engine.pistons_of(shot.cylinder);
                let part = BigRational::new(1.into(), pistons.clone().count().into());
                pistons.map(|piston| (disc(piston), shot.angle.clone(), part.clone())).collect::<Vec<_>>()
            };
            let alike = Alike::new(shots.iter().flat_map(each));
            let of_order = |harmonic: &crate::engine::Harmonic| {
                let own = numbers::direction(&Turn::new(harmonic.phase.clone())) * float(&harmonic.torque);
                let mut one = ExcitedOrder::new(harmonic.order, discs);
                one.add(train, &alike, own, false);
                one
            };
            let orders: Vec<ExcitedOrder> = torsion.harmonics.iter().map(of_order).collect();
            let twist_alone = twisting_alone(&orders, &alike);
            return Some(Excited { orders, speed: None, twist_alone, first: BigRational::zero() });
        }
        let speed = engine.dimensions().speed.as_ref().map(float).filter(|speed| *speed > 0.0)?;
        let highest = highest(engine);
        let (classes, bodies) = (torque::classes_up_to(engine, highest).ok()?, torque::bodies_up_to(engine, highest));
        let of_class = |class: &torque::Class| {
            let cylinders = class.cylinders.iter().zip(&class.fires);
            Alike::new(cylinders.map(|(&cylinder, fires)| (disc(cylinder), fires.clone(), BigRational::one())))
        };
        let of_bodies = |of: &torque::Bodies| {
            let cylinders = of.cylinders.iter().zip(&of.tops).zip(&of.weights);
            Alike::new(cylinders.map(|((&cylinder, top), mass)| (disc(cylinder), top.clone(), mass.clone())))
        };
        let gases: Vec<_> = classes.iter().map(|class| (&class.harmonics, of_class(class))).collect();
        let inertias: Vec<_> = bodies.iter().filter_map(|of| Some((of.inertia.as_ref()?, of_bodies(of)))).collect();
        let of_order = |order: CycleOrder| {
            let mut one = ExcitedOrder::new(order, discs);
            gases.iter().for_each(|(own, alike)| one.add(train, alike, own.torque_at(order), false));
            inertias.iter().for_each(|(own, alike)| one.add(train, alike, own.at(order)[0], true));
            one
        };
        let all = (1..=2 * highest).filter_map(CycleOrder::of_halves);
        let orders = all.filter(|order| engine.cycle().is_none_or(|cycle| order.exists_in(cycle)));
        let orders: Vec<ExcitedOrder> = orders.map(of_order).collect();
        let twist_alone = match classes.as_slice() {
            [class] if engine.only_rods().is_ok() && class.masses.windows(2).all(|pair| pair[0] == pair[1]) => {
                twisting_alone(&orders, &of_class(class))
            }
            _ => Vec::new(),
        };
        let shot = engine.firing().and_then(|firing| firing.shots.first());
        let own = shot.map_or(0, |shot| shot.cylinder);
        let first = classes.iter().flat_map(|class| class.cylinders.iter().zip(&class.fires)).find(|one| *one.0 == own);
        let first = first.map_or_else(BigRational::zero, |(_, angle)| match shot {
            Some(shot) => angle - &shot.angle,
            None => angle.clone(),
        });
        Some(Excited { orders, speed: Some(speed), twist_alone, first })
    }

    /// Whether an order twists nothing, proved.
    pub fn is_still(&self, order: CycleOrder) -> bool {
        self.orders.iter().any(|one| one.order == order && one.is_still)
    }

    /// What turns a value of an order, so that its angle counts from where the first cylinder fires.
    pub fn after_firing(&self, order: CycleOrder) -> Complex<f64> {
        numbers::direction(&order.phase(&self.first)).conj()
    }

    /// The orders that it has.
    pub fn orders(&self) -> impl Iterator<Item = CycleOrder> + '_ {
        self.orders.iter().map(|one| one.order)
    }

    /// The torque of an order on each disc at a speed; none where it has no such order.
    pub fn torques(&self, order: CycleOrder, speed: f64) -> Option<Vec<Complex<f64>>> {
        let one = self.orders.iter().find(|one| one.order == order)?;
        let faster = self.speed.map_or(1.0, |given| speed / given);
        Some(one.gas.iter().zip(&one.inertia).map(|(gas, inertia)| gas + inertia * (faster * faster)).collect())
    }
}
