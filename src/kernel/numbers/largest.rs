//! How large is half the sum of two lengths, `½(|P⁺| + |P⁻|)`? One product where two banks are alike, one root where it can be.
//!
//! With the direct sum `(1 + e(c))·M`, the reverse one `(1 + e(d))·M'` and |M| = |M'| it is `2|M| cos ½(x+y) cos ½(x−y)`, where x and y
//! are the halves of c and d, turned by half a turn into (−90°, 90°]: the length of the sum `½ (1 + e(x+y)) (1 + e(x−y)) M`
//! (theory, section 6).

use num_rational::BigRational;
use num_traits::One;

use super::closed::{modulus, plainer, plainest, real};
use super::form::Form;
use super::radicals::as_sum;
use crate::exact::{PhasorSum, Term, Turn};

/// Stars of more vectors are not taken apart into banks.
const MOST_VECTORS: usize = 64;

/// `½(|direct| + |reverse|)`; the terms of both sums are in the order of their sources. None where a length has no closed form.
pub fn half_of_lengths(direct: &PhasorSum, reverse: &PhasorSum) -> Option<Form> {
    let half = BigRational::new(1.into(), 2.into());
    let of = |sum: &PhasorSum| {
        if sum.vanishes() { Some(Form::rational(BigRational::from_integer(0.into()))) } else { modulus(sum) }
    };
    let lengths = of(direct).zip(of(reverse));
    let sum = lengths.as_ref().map(|(a, b)| plainer(a.plus(b).scaled(&half)));
    // One length alone, or equal ones, or two that are one root together: as plain as can be.
    if sum.as_ref().is_some_and(|sum| sum.terms().len() <= 1 && !sum.terms().iter().any(|(root, _)| root.has_cosine()))
    {
        return sum;
    }
    let banks = || of_banks(direct, reverse).and_then(|product| modulus(&product));
    let root = || as_root(direct, reverse);
    plainest([sum, banks(), root()].into_iter().flatten().collect(), &BigRational::one())
}

/// `½ (1 + e(x+y)) (1 + e(x−y)) M`, where the sources are two banks alike.
fn of_banks(direct: &PhasorSum, reverse: &PhasorSum) -> Option<PhasorSum> {
    let (first, [c, d]) = banks(direct.terms(), reverse.terms())?;
    let star = |sum: &PhasorSum| PhasorSum::new(first.iter().map(|&place| sum.terms()[place].clone()).collect());
    let (bank, other) = (star(direct), star(reverse));
    if !bank.is_as_long_as(&other) {
        return None;
    }
    let [x, y] = [c, d].map(|turn| half_into_the_right(&turn));
    let doubled = |turn: Turn| {
        PhasorSum::new([Turn::zero(), turn].map(|angle| Term { angle, weight: BigRational::one() }).into())
    };
    let product = doubled(&x + &y).times(&doubled(&x - &y)).times(&bank);
    Some(product.scaled(&BigRational::new(1.into(), 2.into())))
}

/// Half of an angle, or half a turn from there, where its cosine is not negative.
fn half_into_the_right(turn: &Turn) -> Turn {
    let half = Turn::new(turn.turns() / BigRational::from_integer(2.into()));
    let is_left = half > Turn::fraction(1, 4) && half < Turn::fraction(3, 4);
    if is_left { half.opposite() } else { half }
}

/// The places of the first bank, and by which turns the direct and the reverse vectors of the second one are off, where each has a
/// partner of its weight.
fn banks(direct: &[Term], reverse: &[Term]) -> Option<(Vec<usize>, [Turn; 2])> {
    let count = direct.len();
    if count != reverse.len() || count % 2 == 1 || count > MOST_VECTORS {
        return None;
    }
    let steps =
        |from: usize, to: usize| [&direct[to].angle - &direct[from].angle, &reverse[to].angle - &reverse[from].angle];
    let weights = |place: usize| [&direct[place].weight, &reverse[place].weight];
    let matched = |step: &[Turn; 2]| {
        let (mut taken, mut first) = (vec![false; count], Vec::new());
        for place in 0..count {
            if taken[place] {
                continue;
            }
            let free = |other: &usize| *other > place && !taken[*other] && weights(place) == weights(*other);
            let partner = (0..count).filter(free).find_map(|other| {
                if steps(place, other) == *step {
                    Some((place, other))
                } else {
                    (steps(other, place) == *step).then_some((other, place))
                }
            });
            let (of_first, of_second) = partner?;
            (taken[of_first], taken[of_second]) = (true, true);
            first.push(of_first);
        }
        Some(first)
    };
    let partners = (1..count).filter(|other| weights(0) == weights(*other)).map(|other| steps(0, other));
    partners.into_iter().find_map(|step| Some((matched(&step)?, step)))
}

/// `√((A + B + 2√(AB))/4)`, A and B the squared lengths, where `√(AB)` is a number of the field.
fn as_root(direct: &PhasorSum, reverse: &PhasorSum) -> Option<Form> {
    let product = as_sum(&modulus(&direct.times(reverse))?)?;
    let [a, b] = [direct, reverse].map(PhasorSum::squared_modulus);
    let two = BigRational::from_integer(2.into());
    let square = a.plus(&b).plus(&product.scaled(&two)).scaled(&BigRational::new(1.into(), 4.into()));
    Some(real(&square)?.square_root())
}
