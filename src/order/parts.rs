//! Which parts does the force of a piston have in an order? Numbers of the motion, each with a part of the vector.
//!
//! A link of knuckle angle Δ has two of them in an even order, as [`link`](super::link) tells; one with a corrected knuckle angle those of
//! [`corrected`](super::corrected).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::corrected::Corrected;
use super::factor::Factor;
use super::link::Linkage;
use crate::engine::{Engine, Link, Mechanism, Rod};
use crate::exact::{Term, Turn};
use crate::motion::Component;

impl Factor {
    /// What the force of a cylinder with this mechanism is multiplied by: numbers of the motion, each with a part of the vector in the
    /// direct star and the angle that this part is turned by; it is turned the other way in the reverse star.
    pub fn parts_of_force(engine: &Engine, mechanism: Option<&Mechanism>, order: u32) -> Vec<(Factor, Term)> {
        match mechanism {
            None => Factor::parts_of_rod(engine, None, order),
            Some(Mechanism::SliderCrank(rod)) => Factor::parts_of_rod(engine, Some(rod), order),
            Some(Mechanism::Link(link)) => of_link(link, order),
        }
    }

    /// The same of a piston that has a rod on the crankpin.
    pub fn parts_of_rod(engine: &Engine, rod: Option<&Rod>, order: u32) -> Vec<(Factor, Term)> {
        if let Some(rod) = rod.filter(|rod| order == 1 && !rod.offset.is_zero())
            && engine.mechanisms().len() > 1
        {
            let one = BigRational::one();
            let weight = if rod.offset.is_negative() { -one.clone() } else { one.clone() };
            return vec![
                (Factor::One, Term { angle: Turn::zero(), weight: one }),
                (Factor::Quadrature(rod.unsigned()), Term { angle: Turn::fraction(1, 4), weight }),
            ];
        }
        let (factor, weight) = Factor::of_rod(rod, order);
        vec![(factor, Term { angle: Turn::zero(), weight })]
    }
}

/// What the vector of a link's piston in the direct star is multiplied by: numbers of the motion, each with a part and the angle it is
/// turned by; the other way in the reverse star.
fn of_link(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    if link.is_corrected() {
        return of_corrected(link, order);
    }
    let one = BigRational::one();
    if order == 1 {
        return vec![(Factor::One, Term { angle: Turn::zero(), weight: one })];
    }
    let master = Factor::Motion(link.master_rod());
    let with_the_master = Term { angle: link.angle.times(order.into()), weight: link.knuckle.clone() };
    if !order.is_multiple_of(2) {
        // Neither number is there: one stands for both.
        return vec![(master, with_the_master)];
    }
    let own = Factor::Linkage(Linkage::of(link));
    let mut weight = one;
    let powers = (0..=i64::from(order)).map(|u| {
        let term = Term { angle: link.angle.times(u), weight: weight.clone() };
        // C(k,u+1) = C(k,u) (k−u)/(u+1).
        weight *= -&link.knuckle * BigRational::new(BigInt::from(i64::from(order) - u), BigInt::from(u + 1));
        (own.clone(), term)
    });
    std::iter::once((master, with_the_master)).chain(powers).collect()
}

/// What the vector of a link's piston in the direct star is multiplied by: numbers of the motion, each with a part and the angle it
/// is turned by; the other way in the reverse star.
fn of_corrected(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let one = BigRational::one();
    let half = &link.knuckle / BigRational::from_integer(2.into());
    let term = |angle: Turn, weight: &BigRational| Term { angle, weight: weight.clone() };
    let mut parts = Vec::new();
    if order == 1 {
        parts.push((Factor::One, term(Turn::zero(), &one)));
        parts.push((Factor::One, term(&link.angle - &link.correction, &half)));
        parts.push((Factor::One, term(&link.angle + &link.correction, &-&half)));
    } else if order.is_multiple_of(2) {
        let master = Factor::Motion(link.master_rod());
        let with_it = link.angle.times(order.into());
        parts.push((master.clone(), term(&with_it + &link.correction, &half)));
        parts.push((master, term(&with_it - &link.correction, &half)));
    }
    let own = Corrected::of(link);
    let (is_behind, is_taken_back) = (own.apart != link.angle, own.correction != link.correction);
    let sign = if is_behind != is_taken_back && !order.is_multiple_of(2) { -one } else { one };
    let quarter = if is_behind { Turn::fraction(3, 4) } else { Turn::fraction(1, 4) };
    parts.push((Factor::Corrected(own.clone(), Component::Real), term(Turn::zero(), &sign)));
    parts.push((Factor::Corrected(own, Component::Imaginary), term(quarter, &sign)));
    parts
}
