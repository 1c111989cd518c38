//! How do the crossheads or pistons rock and twist the frame, order by order? The guide-force moments H and X.
//!
//! Without an offset the couple of a cylinder's guide and crank forces is its torque, so H is the torque's order; X is the sum of the
//! couples, each times its distance from the middle, over the rod length (makers' project guides of large two-strokes, section 17.05).

use num_complex::Complex;
use num_traits::ToPrimitive;

use super::EngineTorque;
use super::order::star;
use crate::engine::{CycleOrder, Engine};
use crate::loads::Arm;
use crate::numbers;

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
    let lengths = torque.classes.iter().map(|class| {
        let cylinder = &engine.cylinders()[class.cylinders[0]];
        let rod = cylinder.rod()?;
        let length = engine.dimensions().crank_radius.as_ref()? * &cylinder.crank_radius / &rod.ratio;
        length.to_f64().filter(|length| length.is_finite())
    });
    // An endless rod has no distance to its guide.
    let is_endless = engine.rods().any(|rod| *rod.ratio.numer() == 0.into());
    let lengths: Vec<f64> = if is_endless { return None } else { lengths.collect::<Option<_>>()? };
    let moments = torque.orders.iter().enumerate().map(|(place, order)| {
        let arms: Vec<_> = torque
            .classes
            .iter()
            .map(|class| star(class, order.order, |index| engine.arm(&engine.cylinders()[index])))
            .collect();
        let couple = |class: &super::Class| -> Complex<f64> {
            class.harmonics.torque[place + 1] + class.inertia_at(place + 1, revolutions).unwrap_or_default()
        };
        let sum: Complex<f64> = torque
            .classes
            .iter()
            .zip(&arms)
            .zip(&lengths)
            .map(|((class, star), length)| couple(class) * numbers::evaluate(star) / length)
            .sum();
        GuideMoments {
            order: order.order,
            rocking: (!order.vanishes).then(|| order.total().norm()),
            twisting: arms.iter().any(|star| !star.vanishes()).then(|| sum.norm()),
        }
    });
    Some(moments.collect())
}
