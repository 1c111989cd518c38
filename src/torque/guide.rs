//! How do the crossheads or pistons rock and twist the frame, order by order? The guide-force moments H and X.
//!
//! Without an offset the couple of a cylinder's guide and crank forces is its torque, so H is the torque's order; X is the sum of the
//! couples, each times its distance from the middle, over the rod length (makers' project guides of large two-strokes, section 17.05).

use num_traits::ToPrimitive;

use super::order::Stars;
use super::{Class, EngineTorque};
use crate::engine::{CycleOrder, Engine};
use crate::loads::Arm;

/// The guide-force moments of an order, zero to peak, in newton-metres.
#[derive(Clone, Debug)]
pub struct GuideMoments {
    /// The order κ.
    pub order: CycleOrder,
    /// H, which rocks the frame; none where it vanishes exactly.
    pub rocking: Option<f64>,
    /// X, which twists it; none where it vanishes exactly.
    pub twisting: Option<f64>,
}

/// The moments of every order; none where an axis misses the crankshaft, or no distances in metres are known.
pub fn guide_moments(engine: &Engine, torque: &EngineTorque) -> Option<Vec<GuideMoments>> {
    if engine.has_offset() || Arm::of(engine) != Arm::Metre {
        return None;
    }
    let revolutions = torque.classes.first()?.harmonics.revolutions as usize;
    let length = |class: &Class| {
        let cylinder = &engine.cylinders()[class.cylinders[0]];
        let rod = cylinder.rod()?;
        let length = engine.dimensions().crank_radius.as_ref()? * &cylinder.crank_radius / &rod.ratio;
        length.to_f64().filter(|length| length.is_finite())
    };
    // An endless rod has no distance to its guide.
    let is_endless = engine.rods().any(|rod| *rod.ratio.numer() == 0.into());
    if is_endless || torque.classes.iter().any(|class| length(class).is_none()) {
        return None;
    }
    let moments = torque.orders.iter().zip(1..).map(|(order, index)| {
        let arm = |class: &Class, place: usize| engine.arm(&engine.cylinders()[class.cylinders[place]]);
        let gas = Stars::of_gas(&torque.classes, order.order, arm);
        let inertia = Stars::of_inertia(&torque.classes, order.order, arm);
        let of_gas = gas.sum(|class| Some(class.harmonics.torque[index] / length(class)?));
        let of_inertia = inertia.sum(|class| Some(class.inertia_at(index, revolutions)? / length(class)?));
        let vanishes = gas.vanish() && (of_inertia.is_none() || !order.order.is_whole() || inertia.vanish());
        GuideMoments {
            order: order.order,
            rocking: (!order.vanishes()).then(|| order.total().norm()),
            twisting: (!vanishes).then(|| (of_gas.unwrap_or_default() + of_inertia.unwrap_or_default()).norm()),
        }
    });
    Some(moments.collect())
}
