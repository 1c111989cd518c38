//! Which cosines does a textbook list? Those of whole multiples of 15° and of 36°, as sums of at most two roots.

use num_rational::BigRational;
use num_traits::One;

use super::form::{Form, in_first_quarter};
use crate::exact::Turn;

/// The cosine of a whole multiple of 15° or of 36°; none of any other angle.
pub fn known_cosine(angle: &Turn) -> Option<Form> {
    let (angle, sign) = in_first_quarter(angle);
    let of_a_quarter = |a: i64, d: i64, b: i64, e: i64| {
        let root = |coefficient: i64, radicand: i64| {
            let root = Form::rational(BigRational::from_integer(radicand.into())).square_root();
            root.scaled(&BigRational::new(coefficient.into(), 4.into()))
        };
        Some(root(a, d).plus(&root(b, e)))
    };
    let known = [(1, 24), (1, 10), (1, 5), (5, 24)].map(|(part, of)| Turn::fraction(part, of));
    let value = match known.iter().position(|known| *known == angle) {
        Some(0) => of_a_quarter(1, 6, 1, 2),
        Some(1) => of_a_quarter(1, 1, 1, 5),
        Some(2) => of_a_quarter(-1, 1, 1, 5),
        Some(_) => of_a_quarter(1, 6, -1, 2),
        // Multiples of 30° and 45° have one root.
        None if [1, 2, 4, 8, 6, 12, 3].iter().any(|parts| angle.denominator() == &(*parts).into()) => {
            Some(Form::cosine(BigRational::one(), angle))
        }
        None => None,
    };
    value.map(|form| form.scaled(&sign))
}
