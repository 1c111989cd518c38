//! Which parts does the force of a piston have in an order? Numbers of the motion, each with a part of the vector.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::factor::Factor;
use super::ray::{Law, Ray};
use crate::engine::{Engine, Link, Mechanism, Rod};
use crate::exact::{Term, Turn};

impl Factor {
    /// What the force of a cylinder with this mechanism is multiplied by: numbers of the motion, each with a part of the vector in the
    /// direct star and the angle that this part is turned by; it is turned the other way in the reverse star.
    pub fn parts_of_force(engine: &Engine, mechanism: Option<&Mechanism>, order: u32) -> Vec<(Factor, Term)> {
        match mechanism {
            None => Factor::parts_of_rod(engine, None, order),
            Some(Mechanism::SliderCrank(rod)) => Factor::parts_of_rod(engine, Some(rod), order),
            Some(Mechanism::Link(link)) if order == 1 => first_of_link(link),
            Some(mechanism) => {
                let mut rays = Ray::of(mechanism);
                // Where none of the numbers is there, one stands for all.
                if rays.iter().any(|ray| ray.law.has_parity_of(order)) {
                    rays.retain(|ray| ray.law.has_parity_of(order));
                } else {
                    rays.truncate(1);
                }
                rays.iter().flat_map(|ray| of_ray(ray, order)).collect()
            }
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

fn of_ray(ray: &Ray, order: u32) -> impl Iterator<Item = (Factor, Term)> {
    let angle = &ray.ahead.times(order.into()) + &ray.turned;
    let part = move |(factor, part): (Factor, Term)| {
        (factor, Term { angle: &part.angle + &angle, weight: part.weight * &ray.weight })
    };
    ray.law.parts(order).into_iter().map(part)
}

/// The first order of a link: 1, as of every centric rod. With a corrected knuckle angle two parts more, and h_1.
fn first_of_link(link: &Link) -> Vec<(Factor, Term)> {
    let one = |angle, weight| (Factor::One, Term { angle, weight });
    let mut parts = vec![one(Turn::zero(), BigRational::one())];
    if link.is_corrected() {
        let half = &link.knuckle / BigRational::from_integer(2.into());
        parts.push(one(&link.angle - &link.correction, half.clone()));
        parts.push(one(&link.angle + &link.correction, -half));
        parts.extend(Law::Corrected(link.clone()).parts(1));
    }
    parts
}
