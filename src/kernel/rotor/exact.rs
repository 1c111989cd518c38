//! What is the quotient of two real sums, in closed form where one is known?

use num_integer::Integer;
use num_traits::ToPrimitive;

use crate::exact::{PhasorSum, Turn, fraction};
use crate::numbers::{self, Form};

/// A real number: exact where a closed form is known, and in decimals.
#[derive(Clone, Debug)]
pub struct Real {
    /// Its closed form.
    pub exact: Option<Form>,
    /// Its decimals.
    pub decimal: f64,
}

/// Among more powers of a root no second conjugate is looked for.
const MOST_POWERS: i64 = 1000;

impl Real {
    /// The length of a sum.
    pub fn length(sum: &PhasorSum) -> Self {
        if sum.vanishes() {
            return Real { exact: numbers::real(&PhasorSum::new(Vec::new())), decimal: 0.0 };
        }
        Real { exact: numbers::modulus(sum), decimal: numbers::length(numbers::evaluate(sum)) }
    }

    /// The quotient of two real sums, the second not zero.
    pub(super) fn quotient(above: &PhasorSum, below: &PhasorSum) -> Self {
        let decimal = if above.vanishes() { 0.0 } else { numbers::evaluate(above).re / numbers::evaluate(below).re };
        Real { exact: closed(above, below), decimal }
    }

    /// A closed form with its decimals.
    pub(super) fn of(form: Form) -> Self {
        Real { decimal: form.to_float(), exact: Some(form) }
    }
}

/// The quotient where the divisor is rational or has one other conjugate.
fn closed(above: &PhasorSum, below: &PhasorSum) -> Option<Form> {
    if let Some(divisor) = numbers::real(below)?.as_rational() {
        return Some(numbers::real(above)?.scaled(&divisor.recip()));
    }
    let conductor = fraction::common_denominator(below.terms().iter().map(|term| term.angle.turns())).to_i64()?;
    let powers = (2..conductor.min(MOST_POWERS)).filter(|power| power.gcd(&conductor) == 1);
    let other = powers.map(|power| below.galois(power)).find(|other| other != below)?;
    let norm = numbers::real(&below.times(&other))?.as_rational()?;
    Some(numbers::real(&above.times(&other))?.scaled(&norm.recip()))
}

/// `2 Re(a b̄)`, a real sum.
pub(super) fn along(a: &PhasorSum, b: &PhasorSum) -> PhasorSum {
    let product = a.times(&b.conjugate());
    product.plus(&product.conjugate())
}

/// `2 Im(a b̄)`, a real sum.
pub(super) fn across(a: &PhasorSum, b: &PhasorSum) -> PhasorSum {
    let product = a.times(&b.conjugate());
    product.minus(&product.conjugate()).turned(&Turn::fraction(3, 4))
}
