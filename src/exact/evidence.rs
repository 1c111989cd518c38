//! What proves the decision? Polygons where the sum is zero; a residue, or a splitting, where it is not.

use super::collected::IntegerSum;
use super::sum::PhasorSum;
use super::{polygons, residue, splitting};
use crate::proof::Certificate;

impl PhasorSum {
    /// Decides whether the sum is zero and writes down the evidence.
    ///
    /// ```standalone_crate
    /// use crankstar::exact::{PhasorSum, Term, Turn};
    /// use num_rational::BigRational;
    /// let unit = |angle| Term { angle, weight: BigRational::from_integer(1.into()) };
    /// let triangle = PhasorSum::new((0..3).map(|i| unit(Turn::fraction(i, 3))).collect());
    /// let json = serde_json::to_string(&triangle.certificate()).unwrap();
    /// assert_eq!(json, r#"{"kind":"polygons","polygons":[{"sides":3,"rotation":"0","weight":"1"}]}"#);
    /// ```
    pub fn certificate(&self) -> Certificate {
        if self.vanishes() {
            Certificate::Polygons { polygons: polygons::find(&IntegerSum::collect(self.terms())) }
        } else if let Some(residue) = residue::find(self.terms()) {
            Certificate::Residue(residue)
        } else {
            Certificate::Splitting { steps: splitting::find(&IntegerSum::collect(self.terms())) }
        }
    }
}
