//! Which symmetries has an engine, or a star? Mirror planes, opposed pairs, turns, mirror lines.

use num_traits::Zero;

use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term, Turn};

/// For each cylinder its mirror image across the reference plane: equal throw, bank, mass, rod and speed, opposite arm.
///
/// `None` where some cylinder has none. A cylinder in the plane is its own image.
pub fn mirror_partners(engine: &Engine) -> Option<Vec<usize>> {
    let mut partners: Vec<Option<usize>> = vec![None; engine.cylinders().len()];
    let is_image = |a: &Cylinder, b: &Cylinder| {
        engine.arm(a) == -engine.arm(b)
            && (&a.throw, &a.bank, a.weight()) == (&b.throw, &b.bank, b.weight())
            && (&a.mechanism, &a.knuckle_mass) == (&b.mechanism, &b.knuckle_mass)
            && engine.speed_of(a) == engine.speed_of(b)
    };
    for (index, cylinder) in engine.cylinders().iter().enumerate() {
        if partners[index].is_some() {
            continue;
        }
        let in_plane = is_image(cylinder, cylinder);
        let image = (index + 1..engine.cylinders().len())
            .find(|&other| !in_plane && partners[other].is_none() && is_image(cylinder, &engine.cylinders()[other]));
        let image = if in_plane { index } else { image? };
        partners[index] = Some(image);
        partners[image] = Some(index);
    }
    partners.into_iter().collect()
}

/// The vectors of a sum in pairs that are equally long and opposite, by index; those of length zero are omitted.
///
/// `None` where some vector has no partner.
pub fn opposed_partners(sum: &PhasorSum) -> Option<Vec<(usize, usize)>> {
    let mut alone: Vec<(usize, Term)> = Vec::new();
    let mut pairs = Vec::new();
    for (index, term) in sum.terms().iter().enumerate().filter(|(_, term)| !term.weight.is_zero()) {
        match alone.iter().position(|(_, other)| cancel(term, other)) {
            Some(place) => pairs.push((alone.remove(place).0, index)),
            None => alone.push((index, term.clone())),
        }
    }
    pairs.sort_unstable();
    alone.is_empty().then_some(pairs)
}

fn cancel(a: &Term, b: &Term) -> bool {
    let turn = &a.angle - &b.angle;
    (turn == Turn::zero() && a.weight == -&b.weight) || (turn == Turn::fraction(1, 2) && a.weight == b.weight)
}

/// The largest `n ≥ 2` such that the star maps to itself when turned by `1/n`.
pub(super) fn fold(collected: &[Term]) -> Option<u32> {
    let count = u32::try_from(collected.len()).ok()?;
    (2..=count).rev().find(|&fold| {
        let turned = PhasorSum::new(collected.to_vec()).turned(&Turn::fraction(1, i64::from(fold)));
        turned.collected() == collected
    })
}

/// The direction in `[0, ½)` of a line in which this star, as [`PhasorSum::on_lines`] gives it, is its own mirror image, where
/// there is one: the sum lies on that line.
pub fn mirror_axis(vectors: &[Term]) -> Option<Turn> {
    let first = vectors.first()?;
    // A mirror line carries the first vector to one of the star, itself perhaps: it halves the angle between them.
    let halves = vectors.iter().flat_map(|other| {
        let double = &first.angle + &other.angle;
        let axis = Turn::new(double.turns() / num_rational::BigRational::from_integer(2.into()));
        let across = &axis + &Turn::fraction(1, 2);
        [axis, across]
    });
    let half = Turn::fraction(1, 2);
    let mut lines: Vec<Turn> = halves.filter(|axis| *axis < half).collect();
    lines.sort_unstable();
    lines.into_iter().find(|axis| {
        let image =
            vectors.iter().map(|term| Term { angle: &axis.times(2) - &term.angle, weight: term.weight.clone() });
        PhasorSum::new(image.collect()).collected() == vectors
    })
}
