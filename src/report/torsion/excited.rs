//! What torque excites the train? That of gas and inertia, or the harmonics of the layout.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::One;

use crate::engine::{CycleOrder, Engine, Shot, Torsion};
use crate::exact::{PhasorSum, Term, Turn};
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
}

#[derive(Clone, Debug)]
struct ExcitedOrder {
    order: CycleOrder,
    gas: Vec<Complex<f64>>,
    inertia: Vec<Complex<f64>>,
}

impl Excited {
    /// That of an engine; none where the layout has neither harmonics nor gas with a speed.
    pub fn new(engine: &Engine, torsion: &Torsion, train: &Train) -> Option<Self> {
        let disc = |cylinder: usize| torsion.pins[engine.cylinders()[cylinder].pin];
        let sense = |cylinder: usize| train.sense(disc(cylinder));
        let nothing = || vec![Complex::default(); torsion.inertias.len()];
        if !torsion.harmonics.is_empty() {
            let fires = |shot: &&Shot| engine.misfire() != Some(shot.cylinder);
            let shots: Vec<&Shot> = firing::firing_of(engine).ok()?.shots.iter().filter(fires).collect();
            let of_order = |harmonic: &crate::engine::Harmonic| {
                let own = numbers::direction(&Turn::new(harmonic.phase.clone())) * float(&harmonic.torque);
                let mut gas = nothing();
                for shot in &shots {
                    let pistons = engine.pistons_of(shot.cylinder);
                    let each =
                        own / pistons.clone().count() as f64 * numbers::direction(&harmonic.order.phase(&shot.angle));
                    pistons.for_each(|piston| gas[disc(piston)] += each * sense(piston));
                }
                ExcitedOrder { order: harmonic.order, gas, inertia: nothing() }
            };
            let orders: Vec<ExcitedOrder> = torsion.harmonics.iter().map(of_order).collect();
            let discs = |shot: &&Shot| engine.pistons_of(shot.cylinder).map(disc).collect::<Vec<_>>();
            let shots: Vec<_> =
                shots.iter().flat_map(|shot| discs(shot).into_iter().map(move |disc| (disc, &shot.angle))).collect();
            let twist_alone = orders.iter().map(|one| one.order).filter(|order| twists_alone(*order, &shots)).collect();
            return Some(Excited { orders, speed: None, twist_alone });
        }
        let speed = engine.dimensions().speed.as_ref().map(float)?;
        let (classes, bodies) = (torque::classes(engine).ok()?, torque::bodies(engine));
        let of_order = |order: CycleOrder| {
            let (mut gas, mut inertia) = (nothing(), nothing());
            for class in &classes {
                for (&cylinder, fires) in class.cylinders.iter().zip(&class.fires) {
                    let torque = class.harmonics.torque_at(order) * numbers::direction(&order.phase(fires));
                    gas[disc(cylinder)] += torque * sense(cylinder);
                }
            }
            for of in &bodies {
                let Some(own) = of.inertia.as_ref().map(|inertia| inertia.at(order)[0]) else { continue };
                for ((&cylinder, top), mass) in of.cylinders.iter().zip(&of.tops).zip(&of.weights) {
                    let torque = own * float(mass) * numbers::direction(&order.phase(top));
                    inertia[disc(cylinder)] += torque * sense(cylinder);
                }
            }
            ExcitedOrder { order, gas, inertia }
        };
        let all = (1..=2 * torque::HIGHEST).filter_map(CycleOrder::of_halves);
        let orders = all.filter(|order| engine.cycle().is_none_or(|cycle| order.exists_in(cycle)));
        let orders: Vec<ExcitedOrder> = orders.map(of_order).collect();
        let twist_alone = match classes.as_slice() {
            [class] if !engine.has_links() && class.masses.windows(2).all(|pair| pair[0] == pair[1]) => {
                let shots: Vec<_> = class.cylinders.iter().map(|&one| disc(one)).zip(&class.fires).collect();
                orders.iter().map(|one| one.order).filter(|order| twists_alone(*order, &shots)).collect()
            }
            _ => Vec::new(),
        };
        Some(Excited { orders, speed: Some(speed), twist_alone })
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

/// Whether the star of an order is zero, but not that of the cylinders on some disc: by the disc and the firing angle of each cylinder.
fn twists_alone(order: CycleOrder, shots: &[(usize, &BigRational)]) -> bool {
    let star = |on: &dyn Fn(usize) -> bool| {
        let terms = shots.iter().filter(|(disc, _)| on(*disc));
        let term = |(_, fires): &(usize, &BigRational)| Term { angle: order.phase(fires), weight: BigRational::one() };
        PhasorSum::new(terms.map(term).collect()).vanishes()
    };
    star(&|_| true) && shots.iter().any(|(disc, _)| !star(&|other| other == *disc))
}
