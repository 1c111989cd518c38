//! How do tests write a sum, a number, an engine down? A sum as `"1@0 -1/2@1/3"`: each term a weight, `@`, an angle in turns.

use crankstar::engine::Engine;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::file;
use crankstar::proof::Vector;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// The engine of a layout file.
#[track_caller]
pub fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The engine of this name.
pub fn of_catalogue(name: &str) -> Engine {
    file::find(name).unwrap_or_else(|| panic!("{name} is not in the catalogue")).engine().expect("it reads")
}

pub fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

pub fn float(number: &BigRational) -> f64 {
    number.to_f64().expect("a number")
}

#[track_caller]
pub fn assert_near(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{found} is not {wanted}, but {:e} off", found - wanted);
}

pub fn ratio(text: &str) -> BigRational {
    text.parse().expect("a whole number or a fraction")
}

pub fn sum(text: &str) -> PhasorSum {
    let term = |word: &str| {
        let (weight, angle) = word.split_once('@').expect("weight@angle");
        Term { angle: Turn::new(ratio(angle)), weight: ratio(weight) }
    };
    PhasorSum::new(text.split_whitespace().map(term).collect())
}

pub fn vectors(sum: &PhasorSum) -> Vec<Vector> {
    let vector = |term: &Term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() };
    sum.terms().iter().map(vector).collect()
}
