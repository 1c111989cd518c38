//! Which parts does the force of a piston have in an order? The rays of its motion, as numbers each with a part of the vector.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::corrected::Corrected;
use super::factor::Factor;
use super::link::{self, Linkage};
use super::turning::mass_radius;
use crate::engine::{Cylinder, Engine, Law, Link, Mechanism, Ray, Rod};
use crate::exact::{Term, Turn};
use crate::motion::Component;

/// What the masses of a cylinder that go up and down add, in multiples of m r: its piston, and the mass at the knuckle pin of its link, which
/// moves as the master's piston does.
pub fn rays(engine: &Engine, cylinder: &Cylinder) -> Vec<Ray> {
    let Some(mechanism) = &cylinder.mechanism else { return Vec::new() };
    let piston = mass_radius(engine, cylinder);
    let of_piston = Ray::of(mechanism).into_iter().map(|ray| Ray { weight: ray.weight * &piston, ..ray });
    let of_knuckle = link::knuckle(cylinder).into_iter().flat_map(|(link, mass_radius)| {
        Ray::of_knuckle(link).map(|ray| Ray { weight: &mass_radius * ray.weight, ..ray })
    });
    of_piston.chain(of_knuckle).collect()
}

impl Factor {
    /// What the force of a cylinder with this mechanism is multiplied by: numbers of the motion, each with a part of the vector in the
    /// direct star and the angle that this part is turned by; it is turned the other way in the reverse star.
    pub fn parts_of_force(engine: &Engine, mechanism: Option<&Mechanism>, order: u32) -> Vec<(Factor, Term)> {
        // A rod has one number in an order. Only where mechanisms differ are 1 and y of c_1 = 1 + iy apart.
        let is_one_number = |rod: &&Rod| order > 1 || rod.is_centric() || engine.mechanisms().len() == 1;
        let rod = mechanism.and_then(Mechanism::rod).filter(is_one_number);
        let Some(mechanism) = mechanism.filter(|_| rod.is_none()) else {
            let (factor, weight) = Factor::of_rod(rod, order);
            return vec![(factor, Term { angle: Turn::zero(), weight })];
        };
        let mut rays = Ray::of(mechanism);
        if rays.iter().any(|ray| ray.law.has_parity_of(order)) {
            rays.retain(|ray| ray.law.has_parity_of(order));
        } else {
            // Where none of the numbers is there, one stands for all.
            rays.retain(|ray| ray.law != Law::Crank);
            rays.truncate(1);
        }
        rays.iter().flat_map(|ray| of_ray(ray, order)).collect()
    }
}

fn of_ray(ray: &Ray, order: u32) -> impl Iterator<Item = (Factor, Term)> {
    let angle = &ray.ahead.times(order.into()) + &ray.turned;
    let part = move |(factor, part): (Factor, Term)| {
        (factor, Term { angle: &part.angle + &angle, weight: part.weight * &ray.weight })
    };
    numbers(&ray.law, order).into_iter().map(part)
}

/// The numbers of a law at an order, each with a part of the vector in the direct star and the angle that this part is turned by; in the
/// reverse star it is turned the other way.
fn numbers(law: &Law, order: u32) -> Vec<(Factor, Term)> {
    let plain = |factor, weight| (factor, Term { angle: Turn::zero(), weight });
    match law {
        Law::Crank => vec![plain(Factor::One, BigRational::one())],
        // c_1 = 1 + iy.
        Law::Rod(rod) if order == 1 => {
            let weight = if rod.offset.is_negative() { -BigRational::one() } else { BigRational::one() };
            vec![(Factor::Quadrature(rod.unsigned()), Term { angle: Turn::fraction(1, 4), weight })]
        }
        Law::Rod(rod) => {
            let (factor, weight) = Factor::of_rod(Some(rod), order);
            vec![plain(factor, weight)]
        }
        Law::Link(link) => of_link(link, order),
        Law::Corrected(link) => of_corrected(link, order),
    }
}

/// `g_k z^k`, with `z^k = Σ C(k,u) (−κ)^u e^{iuΔ}`.
fn of_link(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let own = Factor::Linkage(Linkage::of(link));
    let mut weight = BigRational::one();
    let powers = (0..=i64::from(order)).map(|u| {
        let term = Term { angle: link.angle.times(u), weight: weight.clone() };
        // C(k,u+1) = C(k,u) (k−u)/(u+1).
        weight *= -&link.knuckle * BigRational::new(BigInt::from(i64::from(order) - u), BigInt::from(u + 1));
        (own.clone(), term)
    });
    powers.collect()
}

/// The two parts of h_k.
fn of_corrected(link: &Link, order: u32) -> Vec<(Factor, Term)> {
    let own = Corrected::of(link);
    let (is_behind, is_taken_back) = (own.apart != link.angle, own.correction != link.correction);
    let is_opposite = is_behind != is_taken_back && !order.is_multiple_of(2);
    let weight = if is_opposite { -BigRational::one() } else { BigRational::one() };
    let quarter = if is_behind { Turn::fraction(3, 4) } else { Turn::fraction(1, 4) };
    let part = |component, angle| (Factor::Corrected(own.clone(), component), Term { angle, weight: weight.clone() });
    vec![part(Component::Real, Turn::zero()), part(Component::Imaginary, quarter)]
}
