//! How do tests write a sum down? As `"1@0 -1/2@1/3"`: each term a weight, `@`, an angle in turns.

use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::proof::Vector;
use num_rational::BigRational;

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
