//! How do the crossheads or pistons rock and twist the frame, order by order? The guide-force moments H and X.
//!
//! Without an offset the couple of a cylinder's guide and crank forces is its torque, so H is the torque's order; X is the sum of the
//! couples, each times its distance from the middle, over the rod length (makers' project guides of large two-strokes, section 17.05).

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::order::Stars;
use super::{Bodies, EngineTorque};
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

/// The moments of every order; none where an axis misses the crankshaft, or no distances in metres are known, and for several crankshafts,
/// whose guides stand about axes of their own.
pub fn guide_moments(engine: &Engine, torque: &EngineTorque) -> Option<Vec<GuideMoments>> {
    if engine.has_offset() || Arm::of(engine) != Arm::Metre || !engine.geared_cranks().is_empty() {
        return None;
    }
    // Links and their master rod stand at one place along the shaft: the couples of their guides together are counted there.
    let length = |cylinder: usize| {
        let cylinder = &engine.cylinders()[cylinder];
        let ratio = cylinder.mechanism.as_ref()?.rod_on_the_pin().ratio;
        // An endless rod has no distance to its guide.
        let length = engine.dimensions().crank_radius.as_ref().filter(|_| !ratio.is_zero())? * &cylinder.crank_radius;
        (length / ratio).to_f64().filter(|length| length.is_finite())
    };
    if (0..engine.cylinders().len()).any(|cylinder| length(cylinder).is_none()) {
        return None;
    }
    let moments = torque.orders.iter().zip(1..).map(|(order, index)| {
        let arm = |cylinder: usize| engine.arm(&engine.cylinders()[cylinder]);
        let gas = Stars::of_gas(&torque.classes, order.order, arm);
        let inertia = Stars::of_inertia(&torque.bodies, order.order, arm);
        let couple = |of: &Bodies| Some(of.inertia.as_ref()?.at(order.order).iter().sum::<Complex<f64>>());
        let of_gas = gas.sum(|class| Some(class.harmonics.torque[index] / length(class.cylinders[0])?));
        let of_inertia = inertia.sum(|of| Some(couple(of)? / length(of.cylinders[0])?));
        let vanishes = gas.vanish() && (of_inertia.is_none() || !order.order.is_whole() || inertia.vanish());
        let once = Stars::of_inertia(&torque.bodies, order.order, |_| BigRational::one());
        let rocking = order.gas + once.sum(couple).unwrap_or_default();
        GuideMoments {
            order: order.order,
            rocking: (!order.vanishes()).then(|| rocking.norm()),
            twisting: (!vanishes).then(|| (of_gas.unwrap_or_default() + of_inertia.unwrap_or_default()).norm()),
        }
    });
    Some(moments.collect())
}
