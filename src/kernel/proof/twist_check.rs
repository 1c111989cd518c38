//! Has a real polynomial the sign at each crossing of a circle that is said?

use num_rational::BigRational;

use super::audit::{Audit, Reason, refuse_if};
use super::circle::{ArcClaim, CircleClaim};
use super::circle_check::check_free;
use super::laurent::{Laurent, of_powers, value};
use super::plane::TriangleShape;
use super::triangle_check::check_sign;

/// It has the sign where the arc begins, and vanishes nowhere on it.
pub(super) fn check_signs(
    signs: &[TriangleShape],
    circle: &CircleClaim,
    number: &Laurent,
    audit: &Audit,
) -> Result<(), Reason> {
    let starts = [&circle.from].into_iter().chain(circle.arcs.iter().map(ArcClaim::to));
    let crossings = starts.zip(&circle.arcs).filter_map(|(from, arc)| match arc {
        ArcClaim::Crossing { to } => Some([from, to]),
        ArcClaim::Free { .. } | ArcClaim::Monotone { .. } | ArcClaim::Rational { .. } | ArcClaim::Open { .. } => None,
    });
    let crossings: Vec<[&BigRational; 2]> = crossings.collect();
    refuse_if(crossings.len() != signs.len(), format!("{} signs for {} crossings", signs.len(), crossings.len()))?;
    for ([from, _], sign) in crossings.iter().zip(signs) {
        let there = value(number, from, audit)?;
        match sign {
            TriangleShape::Never { bits } => check_sign(&there, false, *bits, audit)?,
            TriangleShape::Two { bits } => check_sign(&there, true, *bits, audit)?,
            TriangleShape::Flat { .. } => return Err("at an irrational turn no sum is shown to be zero".into()),
        }
    }
    check_free(crossings.into_iter(), circle.bits, &of_powers(number), audit)
}
