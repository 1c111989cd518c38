//! What does an engine do in an order to which its parts come with coefficients of their own? One star, of vectors with their coefficients.

use std::collections::BTreeMap;

use num_complex::Complex;
use num_traits::{ToPrimitive, Zero};

use super::legend::legend;
use super::panel::{heading, rounded_sum};
use super::scale::{SAME, Scale};
use super::sheet::{Sheet, in_both_units};
use super::{Panel, Ray, Star};
use crate::loads::Outcome;
use crate::numbers;
use crate::order::{Coefficients, Source, Sources};
use crate::page::figure::Figure;
use crate::page::{Text, Units};
use crate::proof::{Masses, Planar, Sense};
use crate::report::engine_page::Weighed;
use crate::report::texts::star as text;

/// The stars of an engine whose sizes are known, in multiples of m r ω².
pub(in crate::report) struct WholeStars<'a> {
    weighed: &'a Weighed<'a>,
    sources: Sources<'a>,
    coefficients: Coefficients,
}

impl<'a> WholeStars<'a> {
    /// The stars of the masses that are weighed.
    pub fn new(weighed: &'a Weighed<'a>) -> Self {
        let sources = Sources::new(&weighed.engine, Masses::All);
        WholeStars { weighed, sources, coefficients: Coefficients::default() }
    }

    /// What each source adds to the force or the moment, as the engine feels it at θ = 0: half of its vector, with its coefficient.
    pub fn vectors(&self, quantity: Planar, order: u32, sense: Sense) -> Vec<(Source, Complex<f64>)> {
        let mut vectors: BTreeMap<Source, Complex<f64>> = BTreeMap::new();
        for (source, factor, term) in self.sources.terms(quantity.into(), order, Some(sense)) {
            let coefficient = self.coefficients.in_sense(&factor, order, Some(sense));
            let coefficient = coefficient.map(|coefficient| coefficient.to_complex()).unwrap_or_default();
            let weight = term.weight.to_f64().filter(|weight| weight.is_finite()).unwrap_or(0.0);
            *vectors.entry(source).or_default() += coefficient * numbers::direction(&term.angle) * weight / 2.0;
        }
        let largest = vectors.values().map(|vector| vector.norm()).fold(0.0, f64::max);
        vectors.into_iter().filter(|(_, vector)| vector.norm() > SAME * largest).collect()
    }

    /// The resultant of these, and whether it is proved to be zero, or not to be.
    pub fn resultant(&self, quantity: Planar, order: u32, sense: Sense) -> (Complex<f64>, Outcome) {
        let swing = self.weighed.swing(order, quantity);
        let vector = swing.map(|swing| if sense == Sense::Direct { &swing.direct } else { &swing.reverse });
        vector.map_or((Complex::zero(), Outcome::Zero), |vector| (vector.value / 2.0, vector.outcome.clone()))
    }

    /// The rows that are drawn: the moment only where an arm is not zero.
    fn rows(&self, order: u32) -> Vec<(Planar, [Star; 2])> {
        let rows = Planar::BOTH.map(|quantity| (quantity, Sense::BOTH.map(|sense| self.star(quantity, order, sense))));
        let is_drawn = |(quantity, stars): &(Planar, [Star; 2])| {
            *quantity == Planar::Force || stars.iter().any(|star| !star.rays.is_empty())
        };
        rows.into_iter().filter(is_drawn).collect()
    }

    /// The vectors, those of one direction together.
    pub fn rays(&self, quantity: Planar, order: u32, sense: Sense) -> Vec<Ray> {
        let mut rays: Vec<Ray> = Vec::new();
        for (source, vector) in self.vectors(quantity, order, sense) {
            let (direction, length) = (vector / vector.norm(), vector.norm());
            match rays.iter_mut().find(|ray| (ray.direction - direction).norm() < SAME) {
                Some(ray) => ray.members.push((source, length)),
                None => rays.push(Ray { direction, members: vec![(source, length)], name: None }),
            }
        }
        rays
    }

    /// The star that tells most of an order: the first that is left of force and moment, direct and reverse; else the direct force.
    pub fn told(&self, order: u32) -> Star {
        let mut stars: Vec<Star> = self.rows(order).into_iter().flat_map(|(_, row)| row).collect();
        let left = stars.iter().position(|star| star.resultant.is_some()).unwrap_or(0);
        stars.swap_remove(left)
    }

    fn star(&self, quantity: Planar, order: u32, sense: Sense) -> Star {
        let rays = self.rays(quantity, order, sense);
        let (value, outcome) = self.resultant(quantity, order, sense);
        let resultant = (outcome == Outcome::NotZero).then_some(value);
        Star { rays, polygons: Vec::new(), resultant, has_turned: false, by_crank: false }
    }
}

/// What the vectors of a star sum to.
fn sum((value, outcome): (Complex<f64>, Outcome)) -> (String, String) {
    let words = match outcome {
        Outcome::Zero => "sum = 0",
        Outcome::NotZero | Outcome::Computed => return rounded_sum(value.norm()),
        Outcome::Undecided { .. } => "sum not decided",
    };
    (words.to_owned(), words.to_owned())
}

/// The stars of a whole order, direct beside reverse, and below each row what both make together.
pub(in crate::report) fn whole_star_figure(stars: &WholeStars, order: u32) -> Figure {
    let rows = stars.rows(order);
    let engine = &stars.weighed.engine;
    let draw = |units: Units| {
        let mut sheet = Sheet::new(2);
        for (quantity, row) in &rows {
            let panel = |(star, sense): (&Star, Sense)| {
                let heading = heading((*quantity).into(), order, Some(sense));
                let sum = sum(stars.resultant(*quantity, order, sense));
                Panel::headed(heading, engine, sum, star, Scale::of_whole(star, *quantity, engine))
            };
            sheet.row(row.iter().zip(Sense::BOTH).map(panel).collect(), true);
            if let Some(words) = stars.weighed.together(order, *quantity, units) {
                sheet.words(words);
            }
        }
        sheet.finish()
    };
    in_both_units(draw, |quantity, units| stars.weighed.together(order, quantity, units))
}

/// What is below them.
pub(in crate::report) fn whole_legend(stars: &WholeStars, order: u32) -> Text {
    let rows = stars.rows(order).into_iter();
    let scaled = rows.flat_map(|(quantity, row)| {
        row.map(|star| {
            let scale = Scale::of_whole(&star, quantity, &stars.weighed.engine);
            (quantity.into(), star, scale)
        })
    });
    text::own_coefficients().and(" ").and(legend(&stars.weighed.engine, &scaled.collect::<Vec<_>>()))
}
