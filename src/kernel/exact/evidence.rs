//! What proves the decision? Polygons where the sum is zero; a residue, or a splitting, where it is not.

use super::collected::IntegerSum;
use super::decide::{collect, vanishes};
use super::sum::PhasorSum;
use super::terms::{Exponent, Weight};
use super::words::Words;
use super::{fewest, polygons, residue, splitting};
use crate::proof::Certificate;

impl PhasorSum {
    /// Decides whether the sum is zero and writes down the evidence.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::exact::{PhasorSum, Term, Turn};
    /// use num_rational::BigRational;
    /// let unit = |angle| Term { angle, weight: BigRational::from_integer(1.into()) };
    /// let triangle = PhasorSum::new((0..3).map(|i| unit(Turn::fraction(i, 3))).collect());
    /// let json = serde_json::to_string(&triangle.certificate()).unwrap();
    /// assert_eq!(json, r#"{"kind":"polygons","polygons":[{"sides":3,"rotation":"0","weight":"1"}]}"#);
    /// ```
    pub fn certificate(&self) -> Certificate {
        match Words::of(self.terms()).filter(Words::leave_room) {
            Some(sum) => prove(&sum.conductor, &sum.scale, &collect(sum.terms.into_iter())),
            None => {
                let sum = IntegerSum::collect(self.terms());
                prove(&sum.conductor, &sum.scale, &sum.terms)
            }
        }
    }

    /// The least number of regular polygons that make up the sum, each with any weight, proved to be the least; none where the sum is not zero, and where that was not
    /// proved: of up to twelve vectors it is.
    pub fn fewest_polygons(&self) -> Option<usize> {
        let sum = IntegerSum::collect(self.terms());
        let fewest = fewest::find(&sum.conductor, &sum.terms).filter(|fewest| fewest.is_proved)?;
        Some(fewest.polygons.len())
    }
}

/// The evidence on a sum whose directions are collected.
fn prove<E: Exponent, W: Weight>(conductor: &E, scale: &W, terms: &[(E, W)]) -> Certificate {
    if vanishes(conductor, terms) {
        Certificate::Polygons { polygons: polygons::find(conductor, scale, terms) }
    } else if let Some(residue) = residue::find(conductor, scale, terms) {
        Certificate::Residue(residue)
    } else {
        Certificate::Splitting { steps: splitting::find(conductor, terms) }
    }
}
