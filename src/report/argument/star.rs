//! Which vectors has a star, direction by direction, exactly? What the argument is about, and drawings show.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::exact::Turn;
use crate::order::Source;
use crate::proof::Polygon;
use crate::verdict::{JudgedStar, drawn_polygons};

/// The vectors of one sum, all of positive length, those of negative weight turned by 180°.
pub(in crate::report) struct ExactStar {
    /// The directions, angles rising.
    pub rays: Vec<ExactRay>,
    /// Where the sum vanishes: the polygons that the rays are made of.
    pub polygons: Vec<Polygon>,
    /// Whether some vector was turned because its weight is negative.
    pub has_turned: bool,
}

/// The vectors of one direction.
pub(in crate::report) struct ExactRay {
    /// The direction.
    pub angle: Turn,
    /// Sources with the lengths of their vectors.
    pub members: Vec<(Source, BigRational)>,
}

impl ExactRay {
    /// Length of the vectors together.
    pub fn total(&self) -> BigRational {
        self.members.iter().map(|(_, length)| length).sum()
    }
}

impl ExactStar {
    /// The star of a sum.
    pub fn new(judged: JudgedStar<'_>) -> Self {
        let mut by_angle: BTreeMap<Turn, Vec<(Source, BigRational)>> = BTreeMap::new();
        let terms = judged.sources.iter().zip(judged.sum.terms());
        for (source, term) in terms.filter(|(_, term)| !term.weight.is_zero()) {
            let angle = if term.weight.is_negative() { term.angle.opposite() } else { term.angle.clone() };
            by_angle.entry(angle).or_default().push((*source, term.weight.abs()));
        }
        ExactStar {
            rays: by_angle.into_iter().map(|(angle, members)| ExactRay { angle, members }).collect(),
            polygons: drawn_polygons(judged),
            has_turned: judged.sum.terms().iter().any(|term| term.weight.is_negative()),
        }
    }
}
