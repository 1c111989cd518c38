//! Does it follow from the parts of a sum that are left, when it vanishes?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::alternative::AlternativeClaim;
use super::audit::{Audit, Reason, refuse_if, steps_of};
use super::boxes_check::check_boxes;
use super::certificate::Certificate;
use super::check::certify;
use super::circle_check::check_circle;
use super::classes_check::check_classes;
use super::collected::{collect, difference_of_squares};
use super::coprime_check::check_coprime;
use super::open::{CosineClaim, ProductClaim, WhenClaim};
use super::part::{Part, check_alternative};
use super::quadratic_check::check_quadratic;
use super::triangle_check::check_triangle;
use super::unknown::times;

/// Checks the claim on when a sum vanishes against its parts that do not vanish.
pub(super) fn check_when(when: &WhenClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let contradiction = || Err(format!("{} parts do not vanish, which contradicts `when`", left.len()).into());
    match when {
        WhenClaim::Always => match left {
            [] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::Never => match left {
            [_] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::NotSolved => match left {
            [_, _, _, ..] => Ok(()),
            _ => contradiction(),
        },
        WhenClaim::UnequalLengths { certificate } => match left {
            [first, second] => check_lengths(first, second, false, certificate, audit),
            _ => contradiction(),
        },
        WhenClaim::EqualLengths { certificate } => match left {
            [first, second] => check_lengths(first, second, true, certificate, audit),
            _ => contradiction(),
        },
        WhenClaim::Coprime(claim) => check_coprime(claim, left, audit),
        WhenClaim::Circle(claim) => check_circle(claim, left, audit),
        WhenClaim::Triangle(claim) => check_triangle(claim, left, audit),
        WhenClaim::Classes(claim) => check_classes(claim, left, audit),
        WhenClaim::Quadratic(claim) => check_quadratic(claim, left, audit),
        WhenClaim::Boxes(claim) => check_boxes(claim, left, audit),
        WhenClaim::Product(claim) => check_product(claim, left, audit),
        WhenClaim::Cosine(claim) => match (left, claim.middle) {
            ([first, second, third], 0) => mirrored(first, [second, third], claim, audit),
            ([first, second, third], 1) => mirrored(second, [first, third], claim, audit),
            ([first, second, third], 2) => mirrored(third, [first, second], claim, audit),
            ([_, _, _], _) => Err("there are three parts, so that 0, 1 or 2 is the middle one".into()),
            _ => contradiction(),
        },
        WhenClaim::Where { alternatives, equal_lengths } => match left {
            [first, second] => two(first, second, alternatives, equal_lengths, audit),
            [first, second, third] => three([first, second, third], alternatives, equal_lengths, audit),
            _ => contradiction(),
        },
    }
}

/// `e^{i(x_2 − x_1)} = −S_1/S_2` has one solution: one congruence is all.
fn two(
    first: &Part<'_>,
    second: &Part<'_>,
    alternatives: &[AlternativeClaim],
    equal_lengths: &[Certificate],
    audit: &Audit,
) -> Result<(), Reason> {
    if !equal_lengths.is_empty() {
        return Err("two parts that cancel are equally long, so that no evidence for it belongs here".into());
    }
    match alternatives {
        [only] => check_alternative(first, &[second], only, audit),
        _ => Err("two parts cancel at one turn, so there is one alternative".into()),
    }
}

/// Three vectors of equal length sum to zero iff they stand 120° apart: in one order or the other.
fn three(
    [first, second, third]: [&Part<'_>; 3],
    alternatives: &[AlternativeClaim],
    equal_lengths: &[Certificate],
    audit: &Audit,
) -> Result<(), Reason> {
    let ([one, other], [with_second, with_third]) = (alternatives, equal_lengths) else {
        return Err("three parts need two alternatives, and evidence that they are equally long".into());
    };
    check_lengths(first, second, true, with_second, audit)?;
    check_lengths(first, third, true, with_third, audit)?;
    check_alternative(first, &[second, third], one, audit)?;
    check_alternative(first, &[second, third], other, audit)?;
    match one.conditions.iter().zip(&other.conditions).any(|(a, b)| (&a.turn - &b.turn).is_integer()) {
        true => Err("the two alternatives are the same".into()),
        false => Ok(()),
    }
}

/// `S + q S (e^{ix} + e^{−ix}) = S (1 + 2q cos x)` with `q = −1/(2 cosine)`: zero exactly where `cos x` is the cosine.
fn mirrored(middle: &Part<'_>, others: [&Part<'_>; 2], claim: &CosineClaim, audit: &Audit) -> Result<(), Reason> {
    if claim.cosine.is_zero() || claim.cosine.abs() >= BigRational::one() {
        return Err("the cosine is not between -1 and 1, or is 0".into());
    }
    let multiple = (&claim.cosine + &claim.cosine).recip();
    let one = BigRational::one();
    for ((part, sign), certificate) in others.into_iter().zip([one.clone(), -one]).zip(&claim.multiples) {
        let [phi, delta] = [&part.claim.phi - &middle.claim.phi, &part.claim.delta - &middle.claim.delta];
        if phi != &claim.phi * &sign || delta != &claim.delta * &sign {
            return Err("the parts do not turn against the middle one as the condition says".into());
        }
        // The part turned back, less q of the middle one.
        let back = &claim.turn * &sign;
        audit.spend(steps_of(&back).max(steps_of(&multiple)))?;
        let turned = part.sum.iter().map(|(angle, weight)| (angle - &back, weight.clone()));
        let less = middle.sum.iter().map(|(angle, weight)| (angle.clone(), weight * &multiple));
        let terms: Vec<(BigRational, BigRational)> = turned.chain(less).collect();
        certify(&collect(terms, audit)?, true, certificate, audit)?;
    }
    Ok(())
}

fn check_lengths(
    a: &Part<'_>,
    b: &Part<'_>,
    equal: bool,
    certificate: &Certificate,
    audit: &Audit,
) -> Result<(), Reason> {
    let difference = difference_of_squares(&a.sum, &b.sum, audit)?;
    Ok(certify(&difference, equal, certificate, audit)?)
}

/// A sum that is the product of two vanishes where one of them does: checks the groups, and when both factors vanish.
///
/// With `S_{gj} S_{00} = S_{g0} S_{0j}` and each group turned within itself as the first, `S_{00} Σ_g Σ_j S_{gj} e^{i(y_g + x_j)}` is
/// `(Σ_g S_{g0} e^{iy_g}) (Σ_j S_{0j} e^{ix_j})`, and `S_{00}` is not zero.
pub(super) fn check_product(claim: &ProductClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let mut places: Vec<usize> = claim.groups.iter().flatten().copied().collect();
    places.sort_unstable();
    refuse_if(!places.into_iter().eq(0..left.len()), "the groups do not hold each part that does not vanish once")?;
    let (Some(first), [_, _, ..]) = (claim.groups.first(), claim.groups.as_slice()) else {
        return Err("there are two groups at least".into());
    };
    // So that both factors have fewer parts than the whole.
    if first.len() < 2 || claim.groups.iter().any(|group| group.len() != first.len()) {
        return Err("the groups have equally many parts, two at least".into());
    }
    let others = claim.groups.iter().skip(1);
    let pairs: Vec<[usize; 3]> = others
        .flat_map(|group| group.iter().zip(first).skip(1).map(|(&place, &like)| [group[0], place, like]))
        .collect();
    if pairs.len() != claim.certificates.len() {
        return Err(format!("{} certificates for {} parts", claim.certificates.len(), pairs.len()).into());
    }
    let start = &left[first[0]];
    for ([group, place, like], certificate) in pairs.into_iter().zip(&claim.certificates) {
        let [part, base, other] = [place, group, like].map(|at| &left[at]);
        if part.turned_against(base) != other.turned_against(start) {
            return Err("a group is not turned within itself as the first".into());
        }
        let mut terms = times(part.sum(), start.sum(), |s, t| s + t, audit)?;
        terms.extend(
            times(base.sum(), other.sum(), |s, t| s + t, audit)?.into_iter().map(|(angle, weight)| (angle, -weight)),
        );
        certify(&collect(terms, audit)?, true, certificate, audit)?;
    }
    let parts = |places: &mut dyn Iterator<Item = usize>| places.map(|at| left[at].clone()).collect::<Vec<_>>();
    check_when(&claim.group, &parts(&mut first.iter().copied()), audit)?;
    check_when(&claim.firsts, &parts(&mut claim.groups.iter().map(|group| group[0])), audit)
}
