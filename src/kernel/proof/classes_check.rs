//! Does a sum whose parts make two classes vanish where it is said, and nowhere else?
//!
//! `A(y) + e^{iv} B(y) = 0` with u and v on their own: a vector cannot cancel one of another length, so that `|A|² − |B|²` vanishes, which
//! is a real polynomial in y on the circle; and there `e^{iv} = −A/B` has one solution, or A = B = 0. Where A = B = 0 that polynomial has
//! a double zero, and none at a crossing.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::audit::{Audit, Reason, steps_of};
use super::check::certify;
use super::circle::CircleClaim;
use super::circle_check::check_undivided;
use super::collected::{Collected, collect};
use super::laurent::{Laurent, difference, left_of, of_powers, split, value};
use super::part::Part;
use super::plane::{ClassesClaim, MeetingClaim};
use super::unknown::HIGHEST_EXPONENT;

/// Checks that the parts make these classes, and where both are equally long.
pub(super) fn check_classes(claim: &ClassesClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let u = [&claim.phi, &claim.delta];
    let (first, [second]) = split([&claim.second], u, left, 0..=HIGHEST_EXPONENT / 2, audit)?;
    let squares = difference(&first, &second, audit)?;
    let coefficients = left_of(squares.into_iter(), &claim.squares, audit)?;
    let is_constant = coefficients.iter().all(|(m, _)| *m == 0);
    match &claim.circle {
        None if is_constant && claim.meetings.is_empty() => Ok(()),
        None if is_constant => Err("no meeting is called for".into()),
        None => Err("where the classes are equally long is not said".into()),
        Some(_) if is_constant => Err("there is no circle where the squares differ by a constant".into()),
        Some(circle) => {
            check_circle(u, circle, coefficients, audit)?;
            check_meetings(claim, circle, [&first, &second], audit)
        }
    }
}

/// Checks the arcs against a real polynomial in u, of which the coefficients that are not zero are known, from m = 0 on.
pub(super) fn check_circle(
    u: [&BigRational; 2],
    circle: &CircleClaim,
    coefficients: Vec<(i64, Collected)>,
    audit: &Audit,
) -> Result<(), Reason> {
    let degree = coefficients.last().map_or(0, |(m, _)| *m);
    let mut whole: BTreeMap<i64, Collected> = BTreeMap::new();
    for (m, sum) in coefficients {
        let conjugate = collect(sum.iter().map(|(angle, weight)| (-angle, weight.clone())), audit)?;
        whole.insert(degree - m, conjugate);
        whole.insert(degree + m, sum);
    }
    check_undivided(circle, u, &of_powers(&whole), audit)
}

/// One meeting for each rational turn.
fn check_meetings(
    claim: &ClassesClaim,
    circle: &CircleClaim,
    [first, second]: [&Laurent; 2],
    audit: &Audit,
) -> Result<(), Reason> {
    let rational = circle.rational();
    if rational.len() != claim.meetings.len() {
        return Err(format!("{} meetings for {} rational turns", claim.meetings.len(), rational.len()).into());
    }
    for (at, meeting) in rational.into_iter().zip(&claim.meetings) {
        let first = value(first, at, audit)?;
        match meeting {
            MeetingClaim::All { certificates } => {
                let second = value(second, at, audit)?;
                for (sum, certificate) in [first, second].iter().zip(certificates.iter()) {
                    certify(sum, true, certificate, audit)?;
                }
            }
            MeetingClaim::Rational { first: certificate, turn, certificate: together } => {
                certify(&first, false, certificate, audit)?;
                audit.spend(steps_of(turn))?;
                let second = value(second, at, audit)?.into_iter().map(|(angle, weight)| (angle + turn, weight));
                certify(&collect(first.into_iter().chain(second), audit)?, true, together, audit)?;
            }
            MeetingClaim::Once { first: certificate } => certify(&first, false, certificate, audit)?,
        }
    }
    Ok(())
}
