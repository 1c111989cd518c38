//! Which number does the motion of a rod put before an order? Enclosed by the mean over points of a turn.
//!
//! With `φ = ψ − 90°` and `y = λ cos φ − δ` the root `f = √(1 − y²)` is even in φ, so that
//! `c_k = [k=1] + (−i)^k · 2k²/λ · mean(f cos kφ)` (theory, section 2). The square of the velocity,
//! `(s'/r)² = (cos φ − y sin φ/f)²`, has an even and an odd part, and `T/(m r²ω²) = −½ d/dψ (s'/r)²` makes
//! `t_k = k (−i)^{k+1} (mean(even · cos kφ) − i mean(odd · sin kφ))`.

use std::cell::RefCell;
use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::audit::Audit;
use super::ball::{Ball, Complex};
use super::coefficient::Coefficient;
use super::quantity::Quantity;
use super::refusal::Refusal;
use super::rod::{RodClaim, Strip, finer};

/// The coefficients that one check came across.
pub(super) struct Motion<'a> {
    audit: &'a Audit,
    known: RefCell<BTreeMap<(Coefficient, u32, u32), Complex>>,
}

impl<'a> Motion<'a> {
    pub fn new(audit: &'a Audit) -> Self {
        Motion { audit, known: RefCell::default() }
    }

    pub fn audit(&self) -> &'a Audit {
        self.audit
    }

    /// The coefficient of an order, in units of `2^−bits`; that of rods which are not named is not known.
    pub fn coefficient(&self, coefficient: &Coefficient, order: u32, bits: u32) -> Result<Option<Complex>, Refusal> {
        let key = (coefficient.clone(), order, bits);
        if let Some(known) = self.known.borrow().get(&key) {
            return Ok(Some(known.clone()));
        }
        let found = match coefficient {
            Coefficient::Geared(geared) => return self.coefficient(&geared.of, geared.own_order(order), bits),
            Coefficient::One => return Ok(Some(one(bits))),
            Coefficient::Common | Coefficient::CommonTorque => return Ok(None),
            Coefficient::Torque(rod) => torque(rod, order, bits, self.audit)?,
            Coefficient::Rod(rod) => force(rod, order, bits, self.audit)?,
            Coefficient::Quadrature(rod) => Complex::real(force(rod, 1, bits, self.audit)?.im),
            Coefficient::Linkage(linkage) => Complex::real(linkage.number(order, bits, self.audit)?),
            Coefficient::Corrected(linkage) => Complex::real(linkage.number(order, bits, self.audit)?),
        };
        self.known.borrow_mut().insert(key, found.clone());
        Ok(Some(found))
    }
}

/// Bounds of the real and of the imaginary part of a rod's c_k, or of its t_k for the torque, to about this many bits behind
/// the point: what an enclosure of a whole order computes with.
///
/// # Errors
/// Where that would take too many points.
pub fn coefficient_bounds(
    rod: &RodClaim,
    quantity: Quantity,
    order: u32,
    bits: u32,
) -> Result<[[BigRational; 2]; 2], Refusal> {
    let audit = Audit::new();
    let number = match quantity {
        Quantity::Planar(_) => force(rod, order, bits, &audit),
        Quantity::Axial(_) => torque(rod, order, bits, &audit),
    }?;
    let bounds = |Ball { middle, doubt }: &Ball| {
        [middle - doubt, middle + doubt].map(|bound| BigRational::new(bound, BigInt::one() << bits))
    };
    Ok([bounds(&number.re), bounds(&number.im)])
}

/// About how many bits below 1 a coefficient stands: enclosures start from there, and nothing rests on it.
pub(super) fn smallness(coefficient: &Coefficient, order: u32, audit: &Audit) -> Result<u64, Refusal> {
    let strip = match coefficient {
        Coefficient::Rod(rod) if rod.ratio.is_positive() => Strip::of_root(rod, audit),
        Coefficient::Torque(rod) if rod.ratio.is_positive() => Strip::of_velocity(rod, audit),
        Coefficient::Linkage(linkage) => return linkage.smallness(order, audit),
        Coefficient::Geared(geared) => return smallness(&geared.of, geared.own_order(order), audit),
        Coefficient::Corrected(linkage) => return linkage.smallness(order, audit),
        Coefficient::Rod(_) | Coefficient::Quadrature(_) | Coefficient::Torque(_) => return Ok(0),
        Coefficient::One | Coefficient::Common | Coefficient::CommonTorque => return Ok(0),
    };
    Ok(strip?.decay(order))
}

fn one(bits: u32) -> Complex {
    Complex::real(Ball::exact(BigInt::one() << bits))
}

/// c_k.
fn force(rod: &RodClaim, order: u32, bits: u32, audit: &Audit) -> Result<Complex, Refusal> {
    let (unit, k) = (BigRational::one(), BigInt::from(order));
    let harmonic = if rod.ratio.is_positive() {
        let strip = Strip::of_root(rod, audit)?;
        let factor = BigRational::from_integer(&k * &k * 2) / &rod.ratio;
        let fine = finer(bits, &factor)?;
        let root = |cos: &Ball, _: &Ball| {
            let y = cos.scaled(&rod.ratio).minus(&Ball::rational(&rod.offset, fine));
            let root = Ball::exact(BigInt::one() << fine).minus(&y.times(&y, fine)).root(fine)?;
            Some([root, Ball::exact(0.into())])
        };
        let [even, _] = strip.harmonic(order, fine, audit, root)?;
        even.scaled(&factor).rounded(fine - bits)
    } else {
        // The infinitely long rod keeps its slope δ/√(1−δ²), in order 1 alone.
        let root = Ball::rational(&(&unit - &rod.offset * &rod.offset), bits).root(bits);
        let slope = root.and_then(|root| Ball::rational(&rod.offset, bits).over(&root, bits));
        match order {
            1 => slope.ok_or(Refusal::TooManySteps)?,
            _ => Ball::exact(0.into()),
        }
    };
    let rod = Complex::real(harmonic).turned_back(order);
    Ok(if order == 1 { rod.plus(&one(bits)) } else { rod })
}

/// t_k.
fn torque(rod: &RodClaim, order: u32, bits: u32, audit: &Audit) -> Result<Complex, Refusal> {
    let strip = Strip::of_velocity(rod, audit)?;
    let k = BigRational::from_integer(order.into());
    let fine = finer(bits, &(&k * BigRational::from_integer(strip.most.clone())))?;
    let square = |cos: &Ball, sin: &Ball| {
        let y = cos.scaled(&rod.ratio).minus(&Ball::rational(&rod.offset, fine));
        let root = Ball::exact(BigInt::one() << fine).minus(&y.times(&y, fine)).root(fine)?;
        let swing = y.times(sin, fine).over(&root, fine)?;
        let even = cos.times(cos, fine).plus(&swing.times(&swing, fine));
        let odd = cos.times(&swing, fine).scaled(&BigRational::from_integer((-2).into()));
        Some([even, odd])
    };
    let [even, odd] = strip.harmonic(order, fine, audit, square)?;
    let part = |ball: &Ball| ball.scaled(&k).rounded(fine - bits);
    Ok(Complex { re: part(&even), im: part(&odd).negated() }.turned_back(order.wrapping_add(1)))
}
