//! Do the arcs of a circle say rightly how often a sum vanishes on each?
//!
//! On an arc about s₀ with half-width r a curve `Σ C_j e^{2πi m_j s}` is within `½ (2πr)² Σ m_j² |C_j|` of its tangent there. Where a
//! line keeps all of that away from 0 the curve is **free**, and its part across that line does not change its sign. So a sum whose
//! m-th derivative is free has m zeros at most on an arc (Rolle), and a centred sum, which stays on one line, has none or one where its
//! first derivative is free, by the sides of its ends (theory, section 16).

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::audit::{Audit, Reason, demand, refuse_if, steps_of};
use super::ball::Complex;
use super::certificate::Certificate;
use super::check::certify;
use super::circle::{ArcClaim, CircleClaim};
use super::decimals::{enclose, scale};
use super::divided_check::{check_divided, of_coefficients};
use super::enclosure::check_bits;
use super::part::Part;
use super::unknown::Unknown;

/// Checks the arcs against the parts.
pub(super) fn check_circle(claim: &CircleClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let u = [&claim.phi, &claim.delta];
    check_whole(claim, u, &Unknown::of(left, u[0], u[1], audit)?, audit)
}

/// Checks the arcs against a polynomial, or against the factor of it that they are about: a crossing is a zero, once or several times.
pub(super) fn check_whole(
    claim: &CircleClaim,
    u: [&BigRational; 2],
    unknown: &Unknown<'_>,
    audit: &Audit,
) -> Result<(), Reason> {
    check_unknown(claim, u)?;
    match &claim.divided {
        None => check_arcs(claim, unknown, audit),
        Some(divided) => check_arcs(claim, &of_coefficients(&check_divided(divided, u, unknown, audit)?), audit),
    }
}

fn check_unknown(claim: &CircleClaim, u: [&BigRational; 2]) -> Result<(), Reason> {
    Ok(demand([&claim.phi, &claim.delta] == u, "the circle is not that of u")?)
}

/// Checks the arcs against a polynomial, whatever it is divided by.
fn check_arcs(claim: &CircleClaim, unknown: &Unknown<'_>, audit: &Audit) -> Result<(), Reason> {
    check_bits(claim.bits)?;
    check_mirrored(claim, unknown, audit)?;
    let ground = Evaluator::new(unknown, claim.bits, audit)?;
    let mut from = &claim.from;
    for arc in &claim.arcs {
        audit.spend(1 + steps_of(from) + steps_of(arc.to()))?;
        refuse_if(from >= arc.to(), "an arc does not end behind its beginning")?;
        let ends = [from, arc.to()];
        ground.check_arc(arc, ends).map_err(|reason| reason.within(format!("the arc from {from} to {}", arc.to())))?;
        from = arc.to();
    }
    Ok(demand(*from == &claim.from + BigRational::one(), "the arcs do not make one turn")?)
}

/// Checks the arcs against a polynomial itself: a crossing of them is a simple zero of it.
pub(super) fn check_undivided(
    claim: &CircleClaim,
    u: [&BigRational; 2],
    unknown: &Unknown<'_>,
    audit: &Audit,
) -> Result<(), Reason> {
    check_unknown(claim, u)?;
    match claim.divided {
        None => check_arcs(claim, unknown, audit),
        Some(_) => Err("here the arcs are about the whole sum".into()),
    }
}

/// Checks that a polynomial vanishes nowhere on any of these arcs, their ends among them.
pub(super) fn check_free<'a>(
    mut arcs: impl Iterator<Item = [&'a BigRational; 2]>,
    bits: u32,
    unknown: &Unknown<'_>,
    audit: &Audit,
) -> Result<(), Reason> {
    let ground = Evaluator::new(unknown, bits, audit)?;
    let curve = ground.derivative(0);
    arcs.try_for_each(|ends| ground.demand_free(&curve, ends))
}

/// Evidence that the centred sum stays on one line is there where an arc rests on it, and only there.
fn check_mirrored(claim: &CircleClaim, unknown: &Unknown<'_>, audit: &Audit) -> Result<(), Reason> {
    let rests_on_it = claim.arcs.iter().any(|arc| match arc {
        ArcClaim::Monotone { .. } | ArcClaim::Crossing { .. } => true,
        ArcClaim::Free { .. } | ArcClaim::Rational { .. } | ArcClaim::Open { .. } => false,
    });
    if !rests_on_it {
        return match claim.mirrored.is_empty() {
            true => Ok(()),
            false => Err("no arc rests on the mirror image, so that no evidence for it belongs here".into()),
        };
    }
    let differences = unknown.against_mirror(audit)?;
    if differences.len() != claim.mirrored.len() {
        return Err(format!("{} certificates for {} coefficients", claim.mirrored.len(), differences.len()).into());
    }
    for (difference, certificate) in differences.iter().zip(&claim.mirrored) {
        certify(difference, true, certificate, audit)?;
    }
    Ok(())
}

/// The sum with its coefficients enclosed.
struct Evaluator<'a> {
    unknown: &'a Unknown<'a>,
    sums: Vec<Complex>,
    moduli: Vec<BigInt>,
    bits: u32,
    audit: &'a Audit,
}

/// A curve `Σ C_j e^{2πi m_j s}`: each `2m_j` with its `C_j`.
type Curve = Vec<(i64, Complex)>;

impl<'a> Evaluator<'a> {
    fn new(unknown: &'a Unknown<'a>, bits: u32, audit: &'a Audit) -> Result<Self, Reason> {
        let scale = scale(unknown.sums.iter().copied(), audit)?;
        let circle = audit.circle(bits);
        let sums = unknown.sums.iter().map(|sum| Ok(enclose(sum, &scale, &circle, audit)?));
        let sums = sums.collect::<Result<Vec<_>, Reason>>()?;
        Ok(Evaluator { unknown, sums, moduli: unknown.moduli(audit)?, bits, audit })
    }

    /// The i-th derivative of the sum along the circle, up to a factor.
    fn derivative(&self, i: u32) -> Curve {
        let factor = |exponent: i64| BigRational::from_integer(BigInt::from(exponent).pow(i));
        let each = self.unknown.exponents.iter().zip(&self.sums);
        each.map(|(&exponent, sum)| (2 * exponent, sum.scaled(&factor(exponent)))).collect()
    }

    /// The sum turned back by half of its degree.
    fn centred(&self) -> Curve {
        let degree = self.unknown.degree();
        self.unknown.exponents.iter().zip(&self.sums).map(|(n, sum)| (2 * n - degree, sum.clone())).collect()
    }

    /// The derivative of that, up to a factor.
    fn slope(&self) -> Curve {
        let turning = |(twice, sum): (i64, Complex)| (twice, sum.scaled(&BigRational::from_integer(twice.into())));
        self.centred().into_iter().map(turning).collect()
    }

    fn check_arc(&self, arc: &ArcClaim, ends: [&BigRational; 2]) -> Result<(), Reason> {
        match arc {
            ArcClaim::Open { .. } => Ok(()),
            ArcClaim::Free { .. } => self.demand_free(&self.derivative(0), ends),
            ArcClaim::Monotone { .. } => {
                self.demand_free(&self.slope(), ends)?;
                Ok(demand(self.same_side(ends)?, "the ends are on both sides of 0")?)
            }
            ArcClaim::Crossing { .. } => {
                self.demand_free(&self.slope(), ends)?;
                refuse_if(self.same_side(ends)?, "the ends are on one side of 0")?;
                match self.moduli.iter().any(|modulus| holds_multiple(ends, modulus)) {
                    true => Err("a rational turn in it may be the zero".into()),
                    false => Ok(()),
                }
            }
            ArcClaim::Rational { at, certificates, .. } => self.check_rational(at, certificates, ends),
        }
    }

    /// The zero takes all that the derivative allows.
    fn check_rational(
        &self,
        at: &BigRational,
        certificates: &[Certificate],
        ends: [&BigRational; 2],
    ) -> Result<(), Reason> {
        self.audit.spend(steps_of(at))?;
        refuse_if(at < ends[0] || ends[1] < at, "its zero is not on it")?;
        // So many parts vanish fewer times at one turn.
        if certificates.is_empty() || certificates.len() >= self.sums.len() {
            return Err(format!("{} certificates for a zero of {} parts", certificates.len(), self.sums.len()).into());
        }
        for (i, certificate) in (0..).zip(certificates) {
            certify(&self.unknown.derivative(i, at, self.audit)?, true, certificate, self.audit)?;
        }
        self.demand_free(&self.derivative(certificates.len() as u32), ends)
    }

    /// Each vector of a curve at a turn.
    fn vectors(&self, curve: &Curve, at: &BigRational) -> Result<Vec<(i64, Complex)>, Reason> {
        let (circle, half) = (self.audit.circle(self.bits), at / BigRational::from_integer(2.into()));
        let turned = curve.iter().map(|(twice, vector)| {
            let angle = &half * BigRational::from_integer((*twice).into());
            self.audit.spend(circle.steps() + steps_of(&angle) + 4)?;
            Ok((*twice, vector.times(&circle.direction(&angle), self.bits)))
        });
        turned.collect()
    }

    /// Whether the centred sum, which stays on a line, is on one side of 0 at both ends.
    fn same_side(&self, ends: [&BigRational; 2]) -> Result<bool, Reason> {
        let [low, high] = ends.map(|end| {
            let vectors = self.vectors(&self.centred(), end)?;
            Ok::<Complex, Reason>(vectors.iter().fold(Complex::zero(), |sum, (_, vector)| sum.plus(vector)))
        });
        // In units of 2^(−2 bits): near a zero the product of both is small.
        let across = low?.conjugate().times(&high?, 0).re;
        match across.excludes_zero() {
            true => Ok(across.middle.is_positive()),
            false => Err("on which side of 0 its ends are this many bits leave open".into()),
        }
    }

    fn demand_free(&self, curve: &Curve, [low, high]: [&BigRational; 2]) -> Result<(), Reason> {
        let two = BigRational::from_integer(2.into());
        let (middle, half) = ((low + high) / &two, (high - low) / two);
        let (mut at, mut along) = (Complex::zero(), Complex::zero());
        for (twice, vector) in self.vectors(curve, &middle)? {
            at = at.plus(&vector);
            along = along.plus(&vector.scaled(&BigRational::from_integer(twice.into())));
        }
        // A quarter turn on, and away from the scale of turns: the derivative is πi Σ 2m_j C_j e^{…}, and π < 355/113.
        let along = along.turned_back(3);
        let reach = &half * BigRational::new(355.into(), 113.into());
        // ½ (2π)² m² = ½ π² (2m)², and ½ π² < 5.
        let bend: BigInt = curve.iter().map(|(twice, vector)| vector.longest() * (BigInt::from(*twice) * *twice)).sum();
        let bend = (&half * &half * BigRational::from_integer(bend * 5)).ceil().to_integer();
        Ok(demand(at.keeps_away(&[(&along, &reach)], &bend), "no line keeps it away from 0")?)
    }
}

/// Whether a multiple of `1/modulus` is between two turns, or one of them.
fn holds_multiple([low, high]: [&BigRational; 2], modulus: &BigInt) -> bool {
    let first = (low.numer() * modulus).div_ceil(low.denom());
    first * high.denom() <= high.numer() * modulus
}
