//! Does a sum whose parts make three classes vanish where it is said, and nowhere else?
//!
//! `f = A + B x + C x²` with `|x| = 1`. With `D = |A|² − |C|²` and `E = conj(A) B − C conj(B)`, `conj(A) f − C x² conj(f) = D + E x`. So f = 0
//! needs D² = |E|², which is a real polynomial in y. Where that holds and D ≠ 0, `x = −D/E` is on the circle, and
//! `|A| |f| = |C| |f|` leaves f = 0. Where D = 0, so that E = 0 too, and A ≠ 0, `f/x` turned stays on one line and is `2|A| cos ξ ± |B|`. At a
//! simple zero of the polynomial D is not 0. Where D = 0 for every y the polynomial is `−|E|²`, and the arcs are about E: where `4|A|² > |B|²` two x
//! are left, A not being 0, and where `4|A|² < |B|²` none, be A zero or not.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::audit::{Audit, Reason, steps_of};
use super::certificate::Certificate;
use super::check::certify;
use super::circle::CircleClaim;
use super::circle_check::check_whole;
use super::classes_check::check_circle;
use super::collected::{Collected, collect, difference_of_squares};
use super::laurent::{Laurent, combined, doubled, of_powers, twice, value};
use super::part::Part;
use super::plane::TriangleShape;
use super::quadratic::{QuadraticClaim, RootClaim, RootsClaim};
use super::triangle_check::check_sign;
use super::twist_check::check_signs;

/// u may enter this many times in one class.
const HIGHEST_TIMES: i64 = 512;

/// Checks that the parts make these classes, and where they cancel.
pub(super) fn check_quadratic(claim: &QuadraticClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let classes = classes(claim, left, audit)?;
    let [difference, twist, polynomial] = polynomials(&classes, audit)?;
    let coefficients = left_of(half(polynomial), &claim.coefficients, audit)?;
    let is_constant = coefficients.iter().all(|(power, _)| *power == 0);
    if is_constant && claim.twist.is_some() {
        return Err("the polynomial is constant, so that no twist belongs here".into());
    }
    if coefficients.is_empty() {
        // The certificates say of each coefficient of D whether it is zero; D + E x = 0 says the rest.
        left_of(half(difference), &claim.lengths, audit)?;
        return match claim.circle.is_none() && claim.roots.is_empty() {
            true => Ok(()),
            false => Err("there is no circle, and there are no roots, where every coefficient is zero".into()),
        };
    }
    if claim.twist.is_some() {
        if !left_of(half(difference), &claim.lengths, audit)?.is_empty() {
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
            let u = [&claim.phi, &claim.delta];
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

/// A, B and C.
fn classes(claim: &QuadraticClaim, left: &[Part<'_>], audit: &Audit) -> Result<[Laurent; 3], Reason> {
    let (phi, delta) = (&claim.phi, &claim.delta);
    if !(phi.is_positive() || phi.is_zero() && delta.is_positive()) {
        return Err("u takes φ a positive number of times, or not at all and δ so".into());
    }
    for class in [&claim.second, &claim.third] {
        if !class.iter().all(|place| *place < left.len()) || !class.is_sorted_by(|a, b| a < b) {
            return Err("a class is not a rising list of places of parts that do not vanish".into());
        }
    }
    if claim.second.iter().any(|place| claim.third.contains(place)) {
        return Err("a part is in two classes".into());
    }
    let is_first = |place: &usize| !claim.second.contains(place) && !claim.third.contains(place);
    let first: Vec<usize> = (0..left.len()).filter(is_first).collect();
    let (Some(&start), Some(&other), Some(_)) = (first.first(), claim.second.first(), claim.third.first()) else {
        return Err("a class is empty".into());
    };
    let v = left[other].turned_against(&left[start]);
    if &v[0] * delta == &v[1] * phi {
        return Err("the classes are not turned against each other by an angle on its own".into());
    }
    let of_class = |places: &[usize], turns: i64| -> Result<Laurent, Reason> {
        let mut class = Laurent::new();
        let turns = BigRational::from_integer(turns.into());
        for &place in places {
            let apart = left[place].turned_against(&left[start]);
            audit.spend(steps_of(&apart[0]) + steps_of(&apart[1]))?;
            let [by_phi, by_delta] = [&apart[0] - &v[0] * &turns, &apart[1] - &v[1] * &turns];
            let times = if phi.is_zero() { &by_delta / delta } else { &by_phi / phi };
            if [by_phi, by_delta] != [phi * &times, delta * &times] || !times.is_integer() {
                return Err("a part is not turned against its class by a whole multiple of u".into());
            }
            let times = times.to_integer().to_i64().filter(|times| times.abs() <= HIGHEST_TIMES);
            let times = times.ok_or_else(|| format!("u enters more than {HIGHEST_TIMES} times"))?;
            if class.insert(times, left[place].sum().clone()).is_some() {
                return Err("two parts of a class are turned alike".into());
            }
        }
        Ok(class)
    };
    Ok([of_class(&first, 0)?, of_class(&claim.second, 1)?, of_class(&claim.third, 2)?])
}

/// The coefficients of `y^m` in a real polynomial, m from 0 on.
fn half(polynomial: Laurent) -> impl ExactSizeIterator<Item = (i64, Collected)> {
    let half: Vec<(i64, Collected)> = polynomial.into_iter().filter(|(power, _)| *power >= 0).collect();
    half.into_iter()
}

/// The coefficients that are not zero.
fn left_of(
    coefficients: impl ExactSizeIterator<Item = (i64, Collected)>,
    certificates: &[Certificate],
    audit: &Audit,
) -> Result<Vec<(i64, Collected)>, Reason> {
    if coefficients.len() != certificates.len() {
        return Err(format!("{} certificates for {} coefficients", certificates.len(), coefficients.len()).into());
    }
    let mut left = Vec::new();
    for ((power, sum), certificate) in coefficients.zip(certificates) {
        certify(&sum, certificate.claims_zero(), certificate, audit)?;
        if !certificate.claims_zero() {
            left.push((power, sum));
        }
    }
    Ok(left)
}

/// D, E and `D² − |E|²`.
fn polynomials([first, second, third]: &[Laurent; 3], audit: &Audit) -> Result<[Laurent; 3], Reason> {
    let difference = combined([(first, first), (third, third)], audit)?;
    let twist = combined([(first, second), (second, third)], audit)?;
    let polynomial = combined([(&difference, &difference), (&twist, &twist)], audit)?;
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
        let [a, b, c] =
            [value(&classes[0], turn, audit)?, value(&classes[1], turn, audit)?, value(&classes[2], turn, audit)?];
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
                let most = match shape {
                    TriangleShape::Never { bits } => check_sign(&number, false, *bits, audit).map(|()| 0)?,
                    TriangleShape::Flat { certificate } => certify(&number, true, certificate, audit).map(|()| 1)?,
                    TriangleShape::Two { bits } => check_sign(&number, true, *bits, audit).map(|()| 2)?,
                };
                check_turns([&a, &b, &c], at, most, audit)?;
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
    if at.len() > most {
        return Err(format!("{} turns are named, and there are {most}", at.len()).into());
    }
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
