//! How does the frame roll? With what answers the inertia torque, and with the balancer shafts beside the crankshaft.
//!
//! The torque T on the crankshaft turns the frame with −T. A shaft whose axis stands at `p = height + i·offset` pulls there
//! with its force F, and turns the frame with `Im(p̄ F)`: for a mass-radius U at angle γ of a shaft at +n that is
//! `n²Uω² Re(−i p̄ e^{iγ} e^{inθ})`, at −n `n²Uω² Re(i p e^{−iγ} e^{inθ})`.

use num_complex::Complex;
use num_rational::BigRational;

use super::{Harmonic, Motion, Torque, TorqueOrder, Vector, Waveform};
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term, Turn};
use crate::motion::Coefficient;
use crate::order::{self, OrderSum, unit_mass, unit_radius};
use crate::proof::Sense;

/// The roll moment on the frame at these orders, and at those of the shafts, in multiples of m r² ω².
pub(super) fn roll(engine: &Engine, motion: &Motion, orders: &[u32]) -> Torque {
    let shafts = engine.crankshaft().balancers.iter().map(|shaft| shaft.order);
    let mut all: Vec<u32> = orders.iter().copied().chain(shafts).collect();
    all.sort_unstable();
    all.dedup();
    let orders: Vec<TorqueOrder> = all.into_iter().map(|order| of_order(engine, motion, order)).collect();
    let zero = Complex::new(0.0, 0.0);
    let harmonics = orders.iter().map(|o| Harmonic { order: o.order, direct: o.vector.value, reverse: zero });
    Torque { waveform: Waveform::new(harmonics), orders }
}

fn of_order(engine: &Engine, motion: &Motion, order: u32) -> TorqueOrder {
    let minus = BigRational::from_integer((-1).into());
    let shafts = shafts(engine, order);
    let torque = order::torque(engine, order);
    let mut pairs: Vec<(Coefficient, &PhasorSum)> = torque
        .parts()
        .iter()
        .map(|(factor, sum)| {
            let t = motion.coefficient(factor, order);
            (Coefficient { re: t.re.times(&minus), im: t.im.times(&minus) }, sum)
        })
        .collect();
    pairs.extend(shafts.parts().iter().map(|(factor, sum)| (motion.coefficient(factor, order), sum)));
    TorqueOrder { order, coefficient: None, vector: Vector::of(&pairs, false) }
}

/// What the shafts of an order add, in multiples of m r²; their crank radius is known where there are any.
fn shafts(engine: &Engine, order: u32) -> OrderSum {
    let radius = unit_radius(engine);
    let square = BigRational::from_integer((u64::from(order) * u64::from(order)).into());
    let share = square / (unit_mass(engine) * &radius * &radius);
    let shafts = engine.crankshaft().balancers.iter().filter(|shaft| shaft.order == order);
    let terms = shafts.flat_map(|shaft| {
        let (angle, quarter) = match shaft.sense {
            Sense::Direct => (shaft.angle.clone(), Turn::fraction(3, 4)),
            Sense::Reverse => (-&shaft.angle, Turn::fraction(1, 4)),
        };
        let (factor, sign) = order::shaft_factor(engine, shaft);
        let size = &shaft.mass_radius * &share * sign;
        let high = Term { angle: &angle + &quarter, weight: &size * &shaft.height };
        let aside = Term { angle: angle.opposite(), weight: size * &shaft.offset };
        [(factor.clone(), high), (factor, aside)]
    });
    OrderSum::new(terms.filter(|(factor, _)| factor.exists(order)))
}
