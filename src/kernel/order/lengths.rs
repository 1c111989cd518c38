//! By how much do the squared lengths of the two vectors of an order differ? By a quadratic form in the numbers that their sums are multiplied by.
//!
//! With real numbers x_a the vectors are `P⁺ = Σ x_a D_a` and `P⁻ = Σ x_a R_a` (theory, section 3), and
//! `|P⁺|² − |P⁻|² = Σ_a Σ_b x_a x_b Re(D_a D̄_b − R_a R̄_b)`. It is zero for all values of the numbers exactly where each coefficient is.

use super::factor::Factor;
use super::sum::OrderSum;
use crate::exact::PhasorSum;

/// The coefficients of `|P⁺|² − |P⁻|²`: that of each number with itself and, twice, with those after it. A part is a factor with its direct and its
/// reverse sum, before which the factor is conjugated.
pub fn difference_of_squares<'a>(
    parts: impl IntoIterator<Item = (&'a Factor, [PhasorSum; 2])>,
    order: u32,
) -> Vec<PhasorSum> {
    let mut real: Vec<(Factor, [PhasorSum; 2])> = Vec::new();
    for (factor, [direct, reverse]) in parts {
        for (number, turn) in factor.real_parts(order) {
            let turned = [direct.turned(&turn), reverse.turned(&-&turn)];
            match real.iter_mut().find(|(known, _)| *known == number) {
                Some((_, sums)) => *sums = [sums[0].plus(&turned[0]), sums[1].plus(&turned[1])],
                None => real.push((number, turned)),
            }
        }
    }
    let mut coefficients = Vec::new();
    for (place, (_, [direct, reverse])) in real.iter().enumerate() {
        coefficients.push(direct.squared_modulus().minus(&reverse.squared_modulus()).tidied());
        for (_, [other_direct, other_reverse]) in &real[place + 1..] {
            let half = direct.times(&other_direct.conjugate()).minus(&reverse.times(&other_reverse.conjugate()));
            coefficients.push(half.plus(&half.conjugate()).tidied());
        }
    }
    coefficients
}

impl OrderSum {
    /// Whether this direct vector of an order and a reverse one are proved to be equally long, whatever the factors are.
    pub fn is_as_long_as(&self, reverse: &Self, order: u32) -> bool {
        let sum =
            |of: &Self, factor: &Factor| of.parts().get(factor).cloned().unwrap_or_else(|| PhasorSum::new(Vec::new()));
        let mut factors: Vec<&Factor> = self.parts().keys().chain(reverse.parts().keys()).collect();
        factors.sort_unstable();
        factors.dedup();
        let parts = factors.into_iter().map(|factor| (factor, [sum(self, factor), sum(reverse, factor)]));
        difference_of_squares(parts, order).iter().all(PhasorSum::vanishes)
    }
}
