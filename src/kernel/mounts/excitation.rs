//! Which forces and moments does each order have about the centre of gravity, and which vanish exactly?

use num_complex::Complex;
use num_rational::BigRational;

use super::{NoExcitation, Phasors};
use crate::engine::{CycleOrder, Engine, Mechanism, Mounting, ReferencePlane};
use crate::loads::{Arm, Missing, Swing, loads_at, roll_moments, scale};
use crate::numbers;
use crate::order;
use crate::torque;

/// Orders up to this one are taken where none are asked for, in halves.
const USUAL_HALVES: u32 = 12;

/// What shakes an engine.
#[derive(Clone, Debug)]
pub struct Excitation {
    /// The orders, rising.
    pub orders: Vec<OrderExcitation>,
    /// Whether the torque of the gas is among it: the layout gives the gas.
    pub has_gas: bool,
}

/// One order, `Re(· e^{iκθ})`.
#[derive(Clone, Debug)]
pub struct OrderExcitation {
    /// The order κ.
    pub order: CycleOrder,
    /// Force of the masses over ω², in kilogram metres.
    pub force: Phasors,
    /// Moment of the masses about the centre of gravity over ω², in kilogram square metres.
    pub moment: Phasors,
    /// Roll moment of the gas on the frame, in newton-metres.
    pub gas: Complex<f64>,
    /// What of it is proved to vanish.
    pub still: Still,
}

/// Which sums of an order are proved to be zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Still {
    /// The shaking force.
    pub force: bool,
    /// Its moment about the reference plane.
    pub moment: bool,
    /// The roll moment, of masses and gas.
    pub roll: bool,
}

impl Still {
    /// Whether the order leaves the engine still on any mounts: all vanish.
    pub fn is_whole(self) -> bool {
        self.force && self.moment && self.roll
    }
}

impl OrderExcitation {
    /// Angular frequency at a speed in revolutions a minute, in radians a second.
    pub fn omega(&self, rpm: f64) -> f64 {
        self.order.value() * numbers::angular_speed(rpm)
    }

    /// Force in newtons and moment in newton-metres at a speed in revolutions a minute.
    pub fn at(&self, rpm: f64) -> [Phasors; 2] {
        let square = numbers::angular_speed(rpm).powi(2);
        let [x, y, z] = self.moment.map(|part| part * square);
        [self.force.map(|part| part * square), [x, y, z + self.gas]]
    }
}

/// The orders that are taken where none are asked for: those of forces and moments that matter, and with the gas all of its own, up to 6.
pub fn usual_orders(engine: &Engine) -> Vec<CycleOrder> {
    let halves: Vec<u32> = match (engine.gas(), engine.cycle()) {
        (Some(_), Some(cycle)) => {
            let all = (1..=USUAL_HALVES).filter(|halves| halves.is_multiple_of(cycle.lowest_order().halves()));
            all.collect()
        }
        _ => (1..=USUAL_HALVES / 2).map(|order| 2 * order).collect(),
    };
    halves.into_iter().filter_map(CycleOrder::of_halves).collect()
}

/// What shakes an engine on its mounts, at these orders.
///
/// # Errors
/// What the layout lacks.
pub fn excitation(engine: &Engine, mounting: &Mounting, orders: &[CycleOrder]) -> Result<Excitation, NoExcitation> {
    let scale = scale(engine).ok_or(NoExcitation::Scale)?;
    if Arm::of(engine) != Arm::Metre {
        return Err(NoExcitation::Positions);
    }
    if let Some(arm) = order::roll_lacks(engine) {
        return Err(NoExcitation::Arm(arm));
    }
    let gas = engine.gas().map(|_| torque::classes(engine)).transpose()?;
    let is_numerical = gas.is_some() || !engine.has_judged_torque();
    if let Some(&beyond) = orders.iter().find(|order| is_numerical && order.halves() > 2 * torque::HIGHEST) {
        return Err(NoExcitation::Order(beyond));
    }
    let whole: Vec<u32> = orders.iter().filter(|order| order.is_whole()).map(|order| order.halves() / 2).collect();
    let planar = loads_at(engine, &whole, &[])?.orders;
    let linked = (!engine.has_judged_torque()).then(|| torque::bodies(engine));
    let turning = linked.as_ref().map(|_| without_pistons(engine)).transpose()?;
    let rolls = roll_moments(turning.as_ref().unwrap_or(engine), &whole)?;
    let [mass, radius] = [&scale.mass, &scale.crank_radius].map(numbers::float);
    let centre = Centre::new(engine, mounting);
    let of_order = |&order: &CycleOrder| {
        let fired = gas.as_ref().and_then(|classes| torque::roll_of_gas(engine, classes, order));
        let mut excitation = OrderExcitation {
            order,
            force: Default::default(),
            moment: Default::default(),
            gas: fired.unwrap_or_default(),
            still: Still { force: true, moment: true, roll: fired.is_none() },
        };
        let is_this = |number: u32| order.halves() == 2 * number;
        if let Some(loads) = planar.iter().find(|loads| is_this(loads.order)) {
            let force = components(&loads.force).map(|part| part * (mass * radius));
            let [cx, cy] = components(&loads.moment).map(|part| part * (mass * radius));
            // C = Σ z F is arm times force; the axial vector is that, turned by 90°.
            let roll = rolls.iter().find(|roll| is_this(roll.order));
            let mut about_axis =
                roll.map_or_else(Complex::default, |roll| roll.vector.value * (mass * radius * radius));
            if let Some(roll) = linked.as_ref().map(|bodies| torque::roll_of(bodies, order)) {
                about_axis += roll.unwrap_or_default();
                excitation.still.roll &= roll.is_none();
            }
            excitation.force = [force[0], force[1], Complex::default()];
            excitation.moment = centre.moved([-cy, cx, about_axis], force);
            excitation.still.force = loads.force.vanishes();
            excitation.still.moment = loads.moment.vanishes();
            excitation.still.roll &= roll.is_none_or(|roll| roll.vector.vanishes());
        }
        excitation
    };
    Ok(Excitation { orders: orders.iter().map(of_order).collect(), has_gas: gas.is_some() })
}

/// The engine with the masses that turn alone, which have a roll moment of closed form: that of links is numerical.
fn without_pistons(engine: &Engine) -> Result<Engine, NoExcitation> {
    let mut draft = engine.clone().into_draft();
    draft.reference_plane = ReferencePlane::Named(engine.reference_plane().clone());
    (draft.gas, draft.torsion, draft.bearings) = (None, None, Vec::new());
    for cylinder in &mut draft.cylinders {
        cylinder.mechanism =
            cylinder.mechanism.as_ref().map(|mechanism| Mechanism::SliderCrank(mechanism.rod_on_the_pin()));
        cylinder.reciprocating_mass = BigRational::default();
        cylinder.knuckle_mass = BigRational::default();
    }
    draft.build().map_err(|why| NoExcitation::Missing(Missing::Motion(why.to_string())))
}

/// Both vectors as phasors along x and y: `½(P⁺ + P̄⁻)` and `−½i(P⁺ − P̄⁻)`.
fn components(swing: &Swing) -> [Complex<f64>; 2] {
    let [direct, reverse] = swing.amplitudes();
    let back = reverse.conj();
    [direct + back, (direct - back) * -Complex::<f64>::i()]
}

/// The centre of gravity, from the axis of the crankshaft and the reference plane of the moments.
struct Centre([f64; 3]);

impl Centre {
    fn new(engine: &Engine, mounting: &Mounting) -> Self {
        let [x, y, z] = mounting.block.centre.clone();
        Centre([x, y, z - engine.reference_plane()].each_ref().map(numbers::float))
    }

    /// A moment about it, of one about the reference plane and a force across the crankshaft: `M − r × F`.
    fn moved(&self, [mx, my, mz]: Phasors, [fx, fy]: [Complex<f64>; 2]) -> Phasors {
        let Centre([x, y, z]) = *self;
        [mx + fy * z, my - fx * z, mz - (fy * x - fx * y)]
    }
}
