//! At each irrational zero of a circle, which sign has a real polynomial? Where it is free on the arc, one end tells.

use num_rational::BigRational;
use num_traits::Zero;

use super::arcs::{Circle, crossed, joined, rests_on_line};
use super::curve::Evaluator;
use super::polynomial::Polynomial;
use crate::proof::ArcClaim;

impl Circle {
    /// With a sign for every crossing, in their order; a crossing on which the polynomial may vanish is opened.
    ///
    /// `number`: a polynomial that is real up to a power of y. `sign`: its sign at a turn.
    pub(in super::super) fn settled<S>(
        mut self,
        number: &Polynomial,
        sign: impl Fn(&BigRational) -> Option<S>,
    ) -> (Circle, Vec<S>) {
        let line = Evaluator::new(&self.polynomial, self.claim.bits);
        let slope = line.slope();
        let ground = (!number.total().is_zero()).then(|| Evaluator::new(number, self.claim.bits));
        let curve = ground.as_ref().map(|ground| ground.derivative(0));
        let known = |ends: [&BigRational; 2]| curve.as_ref().filter(|curve| curve.is_free(ends)).and(sign(ends[0]));
        let (mut from, mut near) = (self.claim.from.clone(), std::mem::take(&mut self.near).into_iter());
        let (mut arcs, mut signs) = (Vec::new(), Vec::new());
        for arc in std::mem::take(&mut self.claim.arcs) {
            let ends = [std::mem::replace(&mut from, arc.to().clone()), arc.to().clone()];
            let is_crossing = matches!(arc, ArcClaim::Crossing { .. });
            let Some(zero) = is_crossing.then(|| near.next()).flatten() else {
                arcs.push(arc);
                continue;
            };
            let cut = || crossed(ends.each_ref(), zero.clone(), &slope).zip(known(zero.each_ref()));
            match known(ends.each_ref()).map(|sign| (vec![arc], sign)).or_else(cut) {
                Some((pieces, sign)) => {
                    arcs.extend(pieces);
                    signs.push(sign);
                    self.near.push(zero);
                }
                None => arcs.push(ArcClaim::Open { to: ends[1].clone() }),
            }
        }
        if !arcs.iter().any(rests_on_line) {
            self.claim.mirrored.clear();
        }
        self.claim.arcs = joined(arcs);
        (self, signs)
    }
}
