//! Does a sum whose parts make two classes vanish where it is said, and nowhere else?
//!
//! `A(y) + e^{iv} B(y) = 0` with u and v on their own: a vector cannot cancel one of another length, so that `|A|² − |B|²` vanishes, which
//! is a real polynomial in y on the circle; and there `e^{iv} = −A/B` has one solution, or A = B = 0. Where A = B = 0 that polynomial has
//! a double zero, and none at a crossing.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::audit::{Audit, Reason, steps_of};
use super::check::certify;
use super::circle::CircleClaim;
use super::circle_check::check_undivided;
use super::collected::{Collected, collect};
use super::laurent::{left_of, of_powers};
use super::part::Part;
use super::plane::{ClassesClaim, MeetingClaim};
use super::unknown::{HIGHEST_EXPONENT, NOT_WHOLE, check_positive, product, turned, whole_times};

/// Checks that the parts make these classes, and where both are equally long.
pub(super) fn check_classes(claim: &ClassesClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let classes = Classes::of(claim, left, audit)?;
    let squares = classes.squares(audit)?;
    let coefficients = left_of(squares.into_iter(), &claim.squares, audit)?;
    let is_constant = coefficients.iter().all(|(m, _)| *m == 0);
    match &claim.circle {
        None if is_constant && claim.meetings.is_empty() => Ok(()),
        None if is_constant => Err("no meeting is called for".into()),
        None => Err("where the classes are equally long is not said".into()),
        Some(_) if is_constant => Err("there is no circle where the squares differ by a constant".into()),
        Some(circle) => {
            check_circle([&claim.phi, &claim.delta], circle, coefficients, audit)?;
            check_meetings(claim, circle, &classes, audit)
        }
    }
}

/// The parts of each class with the power of y before them.
struct Classes<'a>([Vec<(i64, &'a Collected)>; 2]);

impl<'a> Classes<'a> {
    fn of(claim: &ClassesClaim, left: &'a [Part<'a>], audit: &Audit) -> Result<Self, Reason> {
        let u = [&claim.phi, &claim.delta];
        check_positive(u)?;
        let is_place = |place: &usize| *place < left.len();
        if !claim.second.iter().all(is_place) || !claim.second.is_sorted_by(|a, b| a < b) {
            return Err("the second class is not a rising list of places of parts that do not vanish".into());
        }
        let is_second = |place: &usize| claim.second.contains(place);
        let (second, first): (Vec<usize>, Vec<usize>) = (0..left.len()).partition(is_second);
        let (Some(&start), Some(&other)) = (first.first(), second.first()) else {
            return Err("a class is empty".into());
        };
        let apart = left[other].turned_against(&left[start]);
        if &apart[0] * u[1] == &apart[1] * u[0] {
            return Err("the classes are not turned against each other by an angle on its own".into());
        }
        let of_class = |places: &[usize], start: usize| {
            let mut class = Vec::new();
            for &place in places {
                let apart = left[place].turned_against(&left[start]);
                audit.spend(steps_of(&apart[0]) + steps_of(&apart[1]))?;
                let times = whole_times(&apart, u).ok_or(NOT_WHOLE)?;
                let times = times.to_i64().filter(|times| (0..=HIGHEST_EXPONENT / 2).contains(times));
                let times = times.ok_or("u enters too many times, or parts do not rise")?;
                class.push((times, left[place].sum()));
            }
            Ok::<_, Reason>(class)
        };
        Ok(Classes([of_class(&first, start)?, of_class(&second, other)?]))
    }

    /// The coefficients of `y^m` in `|A|² − |B|²` for m from 0 on; those of `y^{−m}` are their conjugates.
    fn squares(&self, audit: &Audit) -> Result<BTreeMap<i64, Collected>, Reason> {
        let mut terms: BTreeMap<i64, Vec<(BigRational, BigRational)>> = BTreeMap::new();
        let one = BigRational::one();
        for (class, sign) in self.0.iter().zip([one.clone(), -one]) {
            for (low, other) in class {
                for (high, sum) in class.iter().filter(|(high, _)| high >= low) {
                    let signed = product(other, sum, audit)?.into_iter().map(|(angle, weight)| (angle, weight * &sign));
                    terms.entry(high - low).or_default().extend(signed);
                }
            }
        }
        terms.into_iter().map(|(m, terms)| Ok((m, collect(terms, audit)?))).collect()
    }

    /// A class at a turn of u.
    fn at(&self, class: usize, turn: &BigRational, audit: &Audit) -> Result<Vec<(BigRational, BigRational)>, Reason> {
        turned(self.0[class].iter().copied(), turn, audit)
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
    classes: &Classes<'_>,
    audit: &Audit,
) -> Result<(), Reason> {
    let rational = circle.rational();
    if rational.len() != claim.meetings.len() {
        return Err(format!("{} meetings for {} rational turns", claim.meetings.len(), rational.len()).into());
    }
    for (at, meeting) in rational.into_iter().zip(&claim.meetings) {
        let first = collect(classes.at(0, at, audit)?, audit)?;
        match meeting {
            MeetingClaim::All { certificates } => {
                let second = collect(classes.at(1, at, audit)?, audit)?;
                for (sum, certificate) in [first, second].iter().zip(certificates.iter()) {
                    certify(sum, true, certificate, audit)?;
                }
            }
            MeetingClaim::Rational { first: certificate, turn, certificate: together } => {
                certify(&first, false, certificate, audit)?;
                audit.spend(steps_of(turn))?;
                let second = classes.at(1, at, audit)?.into_iter().map(|(angle, weight)| (angle + turn, weight));
                certify(&collect(first.into_iter().chain(second), audit)?, true, together, audit)?;
            }
            MeetingClaim::Once { first: certificate } => certify(&first, false, certificate, audit)?,
        }
    }
    Ok(())
}
