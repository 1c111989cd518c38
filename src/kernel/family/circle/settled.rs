//! At each irrational zero of a circle, which sign has a real polynomial? Where it is free on the arc, one end tells.

use super::arcs::{Arc, Circle, Kind, crossed, joined};
use super::curve::Evaluator;
use super::polynomial::Polynomial;
use num_rational::BigRational;
use num_traits::Zero;

impl Circle {
    /// With a sign for every crossing, in their order; a crossing on which the polynomial may vanish is opened.
    ///
    /// `number`: a polynomial that is real up to a power of y. `sign`: its sign at a turn.
    pub(in super::super) fn settled<S>(
        mut self,
        number: &Polynomial,
        sign: impl Fn(&BigRational) -> Option<S>,
    ) -> (Circle, Vec<S>) {
        let line = Evaluator::new(&self.polynomial, self.bits);
        let slope = line.slope();
        let ground = (!number.total().is_zero()).then(|| Evaluator::new(number, self.bits));
        let curve = ground.as_ref().map(|ground| ground.derivative(0));
        let known = |ends: [&BigRational; 2]| curve.as_ref().filter(|curve| curve.is_free(ends)).and(sign(ends[0]));
        let mut from = self.from.clone();
        let (mut arcs, mut signs) = (Vec::new(), Vec::new());
        for arc in std::mem::take(&mut self.arcs) {
            let ends = [std::mem::replace(&mut from, arc.to.clone()), arc.to.clone()];
            let Kind::Crossing { near } = &arc.kind else {
                arcs.push(arc);
                continue;
            };
            if let Some(sign) = known(ends.each_ref()) {
                arcs.push(arc);
                signs.push(sign);
            } else if let Some((pieces, sign)) =
                crossed(ends.each_ref(), near.clone(), arc.kind.clone(), &slope).zip(known(near.each_ref()))
            {
                arcs.extend(pieces);
                signs.push(sign);
            } else {
                arcs.push(Arc { kind: Kind::Open, ..arc });
            }
        }
        let rests = |arc: &Arc| matches!(arc.kind, Kind::Monotone | Kind::Crossing { .. });
        if !arcs.iter().any(rests) {
            self.mirrored.clear();
        }
        (Circle { arcs: joined(arcs), ..self }, signs)
    }
}
