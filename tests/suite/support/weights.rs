//! How does an engine stand with weights on its crankshaft?

use crankstar::engine::{Counterweight, Engine};
use crankstar::exact::{PhasorSum, Turn};
use crankstar::order::Factor;
use crankstar::proof::Sense;
use crankstar::remedy::{ComparableEngine, Weight};
use num_rational::BigRational;

/// The layout with these weights on its crankshaft, each as the rational counterweights that it is the sum of.
///
/// `None` where a weight turns at another speed or holds a coefficient, or where the layout gives no numbers.
pub fn with_counterweights(subject: &ComparableEngine, weights: &[Weight]) -> Option<Engine> {
    let [unit, radius] = subject.scale()?;
    let mut crankshaft = subject.engine().crankshaft().clone();
    for weight in weights {
        let on_the_crank = (weight.order, weight.sense) == (1, Sense::Direct);
        for (factor, sum) in weight.vector.parts() {
            if *factor != Factor::One || !on_the_crank {
                return None;
            }
            crankshaft.counterweights.extend(rational_weights(sum, &unit, &radius, &weight.position));
        }
    }
    subject.engine().with_crankshaft(crankshaft).ok()
}

/// The terms of a sum as counterweights of positive mass.
fn rational_weights<'a>(
    sum: &'a PhasorSum,
    unit: &'a BigRational,
    radius: &'a BigRational,
    position: &'a BigRational,
) -> impl Iterator<Item = Counterweight> + 'a {
    sum.terms().iter().map(move |term| {
        let negative = term.weight < BigRational::from_integer(0.into());
        let angle: Turn = if negative { term.angle.opposite() } else { term.angle.clone() };
        let mass = &term.weight * unit / radius;
        let mass = if negative { -mass } else { mass };
        Counterweight { throw: None, angle, mass, radius: radius.clone(), position: position.clone(), crank: 0 }
    })
}
