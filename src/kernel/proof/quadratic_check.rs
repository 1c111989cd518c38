//! Does a sum whose parts make three classes vanish where it is said, and nowhere else?
//!
//! `f = A + B x + C x²` with `|x| = 1`. With `D = |A|² − |C|²` and `E = conj(A) B − C conj(B)`, `conj(A) f − C x² conj(f) = D + E x`. So f = 0
//! needs D² = |E|², which is a real polynomial in y. Where that holds and D ≠ 0, `x = −D/E` is on the circle, and
//! `|A| |f| = |C| |f|` leaves f = 0. Where D = 0, so that E = 0 too, and A ≠ 0, `f/x` turned stays on one line and is `2|A| cos ξ ± |B|`. At a
//! simple zero of the polynomial D is not 0. Where D = 0 for every y the polynomial is `−|E|²`, and the arcs are about E: where `4|A|² > |B|²` two x
//! are left, A not being 0, and where `4|A|² < |B|²` none, be A zero or not.

use num_rational::BigRational;

use super::audit::{Audit, Reason, refuse_if, steps_of};
use super::certificate::Certificate;
use super::check::certify;
use super::circle::CircleClaim;
use super::circle_check::check_whole;
use super::classes_check::check_circle;
use super::collected::{Collected, collect, difference_of_squares};
use super::laurent::{self, Laurent, combined, doubled, left_of, of_powers, split, twice, value};
use super::part::Part;
use super::quadratic::{QuadraticClaim, RootClaim, RootsClaim};
use super::triangle_check::check_count;
use super::twist_check::check_signs;

/// u may enter this many times in one class.
const HIGHEST_TIMES: i64 = 512;

/// Checks that the parts make these classes, and where they cancel.
pub(super) fn check_quadratic(claim: &QuadraticClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let u = [&claim.phi, &claim.delta];
    let others = [&claim.second[..], &claim.third];
    let (first, [second, third]) = split(others, u, left, -HIGHEST_TIMES..=HIGHEST_TIMES, audit)?;
    let classes = [first, second, third];
    let [mut difference, twist, polynomial] = polynomials(&classes, audit)?;
    let coefficients = left_of(polynomial.into_iter(), &claim.coefficients, audit)?;
    let is_constant = coefficients.iter().all(|(power, _)| *power == 0);
    refuse_if(is_constant && claim.twist.is_some(), "the polynomial is constant, so that no twist belongs here")?;
    if coefficients.is_empty() {
        // The certificates say of each coefficient of D whether it is zero; D + E x = 0 says the rest.
        left_of(difference.split_off(&0).into_iter(), &claim.lengths, audit)?;
        return match claim.circle.is_none() && claim.roots.is_empty() {
            true => Ok(()),
            false => Err("there is no circle, and there are no roots, where every coefficient is zero".into()),
        };
    }
    if claim.twist.is_some() {
        if !left_of(difference.split_off(&0).into_iter(), &claim.lengths, audit)?.is_empty() {
            return Err("first and third class are not equally long for every angle".into());
        }
    } else if !claim.lengths.is_empty() {
        return Err("only on a curve, or with a twist, are all lengths compared".into());
    }
    match &claim.circle {
        None if is_constant && claim.roots.is_empty() => Ok(()),
        None if is_constant => Err("no roots are called for".into()),
        None => Err("where the polynomial vanishes is not said".into()),
        Some(_) if is_constant => Err("there is no circle where the polynomial is constant".into()),
        Some(circle) => {
            match &claim.twist {
                None => check_circle(u, circle, coefficients, audit)?,
                Some(claim) => {
                    let left = left_of(twist.into_iter(), &claim.coefficients, audit)?.into_iter().collect();
                    check_whole(circle, u, &of_powers(&left), audit)?;
                    let double = doubled(&classes[0]);
                    let number = combined([(&double, &double), (&classes[1], &classes[1])], audit)?;
                    check_signs(&claim.signs, circle, &number, audit)?;
                }
            }
            check_roots(claim, circle, &classes, audit)
        }
    }
}

/// D, E and `D² − |E|²`.
fn polynomials([first, second, third]: &[Laurent; 3], audit: &Audit) -> Result<[Laurent; 3], Reason> {
    let difference = combined([(first, first), (third, third)], audit)?;
    let twist = combined([(first, second), (second, third)], audit)?;
    let polynomial = laurent::difference(&difference, &twist, audit)?;
    Ok([difference, twist, polynomial])
}

/// What stands for each rational turn of u.
fn check_roots(
    claim: &QuadraticClaim,
    circle: &CircleClaim,
    classes: &[Laurent; 3],
    audit: &Audit,
) -> Result<(), Reason> {
    let rational = circle.rational();
    if rational.len() != claim.roots.len() {
        return Err(format!("{} entries in `roots` for {} rational turns", claim.roots.len(), rational.len()).into());
    }
    for (turn, roots) in rational.into_iter().zip(&claim.roots) {
        let [a, b, c] = classes.each_ref().map(|class| value(class, turn, audit));
        let [a, b, c] = [a?, b?, c?];
        match roots {
            RootsClaim::All { certificates } => check_each([&a, &b, &c], [true; 3], certificates, audit)?,
            RootsClaim::None { certificates } => check_each([&a, &b, &c], [true, false, true], certificates, audit)?,
            RootsClaim::One { lengths, at } => {
                certify(&difference_of_squares(&a, &c, audit)?, false, lengths, audit)?;
                check_turns([&a, &b, &c], at, 1, audit)?;
            }
            RootsClaim::Mirror { lengths, first, shape, at } => {
                certify(&difference_of_squares(&a, &c, audit)?, true, lengths, audit)?;
                certify(&a, false, first, audit)?;
                let number = difference_of_squares(&twice(&a), &b, audit)?;
                check_turns([&a, &b, &c], at, check_count(&number, shape, audit)?, audit)?;
            }
        }
    }
    Ok(())
}

fn check_each(
    sums: [&Collected; 3],
    zero: [bool; 3],
    certificates: &[Certificate; 3],
    audit: &Audit,
) -> Result<(), Reason> {
    for ((sum, zero), certificate) in sums.into_iter().zip(zero).zip(certificates) {
        certify(sum, zero, certificate, audit)?;
    }
    Ok(())
}

/// At each turn of x the sum vanishes, and there are no more than there can be.
fn check_turns(sums: [&Collected; 3], at: &[RootClaim], most: usize, audit: &Audit) -> Result<(), Reason> {
    refuse_if(at.len() > most, format!("{} turns are named, and there are {most}", at.len()))?;
    for root in at {
        audit.spend(steps_of(&root.turn))?;
        let turned = |(times, sum): (i64, &Collected)| {
            let by = &root.turn * BigRational::from_integer(times.into());
            sum.iter().map(|(angle, weight)| (angle + &by, weight.clone())).collect::<Vec<_>>()
        };
        let terms = (0..).zip(sums).flat_map(turned);
        certify(&collect(terms, audit)?, true, &root.certificate, audit)?;
    }
    match at {
        [one, other] if (&one.turn - &other.turn).is_integer() => Err("the two turns are the same".into()),
        _ => Ok(()),
    }
}
