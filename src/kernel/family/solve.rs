//! When does `S_1 e^{ix_1} + S_2 e^{ix_2} + … = 0`, with x linear in φ and δ?
//!
//! One part never vanishes. Two do iff |S_1| = |S_2| and `x_2 − x_1 ≡ arg S_1 − arg S_2 + 180°`. Three of equal length do
//! iff they stand 120° apart. Of three, two may be mirror images of each other about the third: then a cosine decides. All
//! else in one unknown is solved on the circle ([`circle`]); two unknowns that enter on their own, as a triangle or as two classes
//! ([`plane`](super::plane)), and where neither fits it is said so.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::angles::{Angles, alternative};
use super::circle::{self, Solved};
use super::part::Part;
use super::plane::{boxes, classes, product, quadratic, triangle};
use super::remaining::ratio;
use super::when::{Never, Product, When};
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction};
use crate::proof::{Certificate, CosineClaim, TriangleShape};

/// When the parts sum to zero.
pub(super) fn when(parts: &[&Part]) -> When {
    match parts {
        [] => When::Always,
        [_] => When::Never(Never::OnePart),
        [first, second] => two(first, second),
        [first, second, third] => three(first, second, third),
        more => general(more),
    }
}

/// Any number of parts.
fn general(parts: &[&Part]) -> When {
    match circle::solve(parts) {
        Some(Solved::Never(coprime)) => When::Never(Never::Coprime(coprime)),
        Some(Solved::Circle(circle)) if circle.is_free() => When::Never(Never::Circle(circle)),
        Some(Solved::Circle(circle)) => When::Circle(circle),
        None => in_plane(parts).unwrap_or(When::NotSolved(parts.len())),
    }
}

/// Three parts at least that do not lie on one line; `None` where that is not solved.
fn in_plane(parts: &[&Part]) -> Option<When> {
    if let [first, second, third] = parts {
        let found = Box::new(triangle::solve([first, second, third])?);
        let is_never = matches!(found.shape, TriangleShape::Never { .. });
        return Some(if is_never { When::Never(Never::Triangle(found)) } else { When::Triangle(found) });
    }
    if let Some(product) = in_product(parts) {
        return Some(product);
    }
    if let Some(found) = classes::solve(parts).map(Box::new) {
        return Some(if found.is_never() { When::Never(Never::Classes(found)) } else { When::Classes(found) });
    }
    if let Some(found) = quadratic::solve(parts).map(Box::new) {
        return Some(if found.is_never() { When::Never(Never::Quadratic(found)) } else { When::Quadratic(found) });
    }
    let found = Box::new(boxes::solve(parts)?);
    Some(if found.is_never() { When::Never(Never::Boxes(found)) } else { When::Boxes(found) })
}

/// When a product vanishes; `None` where the sum is none.
fn in_product(parts: &[&Part]) -> Option<When> {
    let (groups, certificates) = product::groups(parts)?;
    let of_places = |places: Vec<usize>| when(&places.into_iter().map(|at| parts[at]).collect::<Vec<_>>());
    let group = of_places(groups.first()?.clone());
    let firsts = of_places(groups.iter().filter_map(|group| group.first().copied()).collect());
    let is_never = |when: &When| matches!(when, When::Never(_));
    let never = is_never(&group) && is_never(&firsts);
    let product = Box::new(Product { groups, certificates, group, firsts });
    Some(if never { When::Never(Never::Product(product)) } else { When::Product(product) })
}

fn length_difference(a: &PhasorSum, b: &PhasorSum) -> Certificate {
    a.squared_modulus().minus(&b.squared_modulus()).tidied().certificate()
}

fn two(first: &Part, second: &Part) -> When {
    let comparison = length_difference(&first.sum, &second.sum);
    if !comparison.claims_zero() {
        return When::Never(Never::UnequalLengths(comparison));
    }
    let quotient = first.sum.times(&second.sum.conjugate());
    match numbers::direction_of(&quotient) {
        Some(Direction::Turn(turn)) => {
            let alternatives = vec![alternative(first, &[(second, turn.opposite())])];
            When::Where(Angles { alternatives, equal_lengths: Vec::new() })
        }
        Some(Direction::Arctangent { .. } | Direction::Turned { .. }) | None => match circle::arcs_of(&[first, second])
        {
            // An angle beyond the digits of the arcs is named without them.
            Some(circle) if circle.is_complete() => When::Circle(Box::new(circle)),
            Some(_) | None => irrational(first, second, &quotient, comparison),
        },
    }
}

fn irrational(first: &Part, second: &Part, quotient: &PhasorSum, equal_lengths: Certificate) -> When {
    When::Irrational {
        phi: &second.phi - &first.phi,
        delta: &second.delta - &first.delta,
        degrees: numbers::evaluate(quotient).arg().to_degrees() + 180.0,
        equal_lengths,
    }
}

/// Three vectors of equal length sum to zero iff they stand 120° apart, in either order.
fn three(first: &Part, second: &Part, third: &Part) -> When {
    let equal_lengths = [second, third].map(|part| length_difference(&first.sum, &part.sum)).to_vec();
    let relative = |part: &Part| match numbers::direction_of(&first.sum.times(&part.sum.conjugate())) {
        Some(Direction::Turn(turn)) => Some(turn),
        _ => None,
    };
    let equal = equal_lengths.iter().all(Certificate::claims_zero);
    let (true, Some(to_second), Some(to_third)) = (equal, relative(second), relative(third)) else {
        let middles = [(first, [second, third]), (second, [first, third]), (third, [first, second])];
        let mut found = middles.iter().enumerate().filter_map(|(at, (middle, others))| mirrored(at, middle, *others));
        return found.next().map_or_else(|| general(&[first, second, third]), |cosine| When::Cosine(Box::new(cosine)));
    };
    let alternatives = [1, 2].map(|thirds| {
        let turned = |relative: &Turn, thirds: i64| relative + &Turn::fraction(thirds, 3);
        alternative(first, &[(second, turned(&to_second, thirds)), (third, turned(&to_third, -thirds))])
    });
    When::Where(Angles { alternatives: alternatives.to_vec(), equal_lengths })
}

/// Two parts that turn against the one in the middle by opposite angles, and are mirror images about it: `S (1 + 2q cos x)`.
fn mirrored(at: usize, middle: &Part, [one, other]: [&Part; 2]) -> Option<CosineClaim> {
    let (phi, delta) = (&one.phi - &middle.phi, &one.delta - &middle.delta);
    if &other.phi - &middle.phi != -&phi || &other.delta - &middle.delta != -&delta {
        return None;
    }
    let turn = match numbers::direction_of(&one.sum.times(&middle.sum.conjugate()))? {
        // Half a turn is the sign of the multiple.
        Direction::Turn(turn) if turn.times(2) == Turn::zero() => Turn::zero(),
        Direction::Turn(turn) => turn,
        _ => return None,
    };
    let back = &Turn::zero() - &turn;
    let [forward, backward] = [one.sum.turned(&back), other.sum.turned(&turn)];
    let multiple = ratio(&forward, &middle.sum).filter(|multiple| !multiple.is_zero())?;
    let cosine = -(&multiple + &multiple).recip();
    let angle_is_rational = (&cosine + &cosine).is_integer();
    if angle_is_rational || cosine.abs() > BigRational::one() || ratio(&backward, &middle.sum)? != multiple {
        return None;
    }
    let scaled = middle.sum.scaled(&multiple);
    let multiples = [forward, backward].map(|sum| sum.minus(&scaled).tidied().certificate());
    Some(CosineClaim { middle: at, phi, delta, turn: turn.turns().clone(), cosine, multiples })
}
