//! How well can counterweights alone do? They take from the direct vector of order 1 and leave the reverse one.
//!
//! Let the rotating masses be balanced, and a part f of the reciprocating ones. Then `P⁺(f) = (1 − 2f) P⁺`, P⁻ stays,
//! and the force of order 1 traces an ellipse with the semi-axes `½ |(|1−2f| |P⁺| ± |P⁻|)|` (theory, section 3). Its peak
//! is least at f = ½, and f does as well as 1 − f. On one pin at the V-angle V, with equal masses, `P⁺ = 2 m r` and
//! `P⁻ = 2 m r cos V`: the peak is `(|1 − 2f| + |cos V|) m r ω²`.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::engine::Engine;
use crate::exact::{PhasorSum, Term};
use crate::numbers::{self, Form};
use crate::order;
use crate::proof::Sense;

/// What is left of the first order over the balanced part f of the reciprocating masses.
#[derive(Clone, Debug)]
pub struct Partial {
    /// P⁺ of the reciprocating masses, in multiples of m r.
    pub direct: PhasorSum,
    /// P⁻.
    pub reverse: PhasorSum,
}

/// The path of the force of order 1, in multiples of m r ω².
#[derive(Clone, Debug, PartialEq)]
pub struct Ellipse {
    /// The longer semi-axis: the peak; in closed form where one is found.
    pub peak: Option<Form>,
    /// The same in decimals.
    pub peak_decimal: f64,
    /// The shorter semi-axis; in closed form where one is found: 0 where the force swings along a line.
    pub least: Option<Form>,
    /// The same in decimals.
    pub least_decimal: f64,
}

impl Partial {
    /// The first order of a layout; `None` with a pin offset or a corrected knuckle angle, whose c_1 is no longer 1, with masses at knuckle
    /// pins, of which a part moves as the master piston does, with a crankshaft that turns against the reference, whose counterweights change
    /// P⁻, and with balancer shafts of order 1.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::remedy::Partial;
    /// use num_rational::BigRational;
    /// let twin = "vee = { bank_angle = 90, throws = [0] }";
    /// let twin = Partial::new(&crankstar::file::parse("twin.toml", twin).unwrap()).unwrap();
    /// let half = BigRational::new(1.into(), 2.into());
    /// assert_eq!(twin.ellipse(&half).peak_decimal, 0.0);
    /// ```
    pub fn new(engine: &Engine) -> Option<Self> {
        let sum = |sense| {
            let term = |cylinder| Term {
                angle: order::phase(cylinder, 1, Some(sense)),
                weight: order::mass_radius(engine, cylinder),
            };
            // A crank that turns faster has no part in order 1.
            let cylinders = engine.cylinders().iter().filter(|cylinder| engine.own_order(cylinder, 1).is_some());
            PhasorSum::new(cylinders.map(term).collect()).tidied()
        };
        let has_knuckles = engine.cylinders().iter().any(|cylinder| !cylinder.knuckle_mass.is_zero());
        let has_shafts = engine.crankshaft().balancers.iter().any(|shaft| shaft.order == 1);
        let is_plain = engine.is_centric() && !has_knuckles && !has_shafts;
        (is_plain && !engine.has_crank_turning(1, Sense::Reverse))
            .then(|| Partial { direct: sum(Sense::Direct), reverse: sum(Sense::Reverse) })
    }

    /// The ellipse where this part of the reciprocating masses is balanced.
    pub fn ellipse(&self, part: &BigRational) -> Ellipse {
        let half = BigRational::new(1.into(), 2.into());
        let left = (BigRational::one() - part * BigRational::from_integer(2.into())).abs();
        let (direct, reverse) = (self.direct.scaled(&left), &self.reverse);
        let lengths = numbers::modulus(&direct).zip(numbers::modulus(reverse));
        let [long, short] = [numbers::evaluate(&direct).norm(), numbers::evaluate(reverse).norm()];
        let shorter = |(direct, reverse): &(Form, Form)| {
            let difference = direct.plus(&reverse.scaled(&-BigRational::one()));
            let half = if long < short { -half.clone() } else { half.clone() };
            difference.scaled(&half)
        };
        let least = match direct.is_as_long_as(reverse) {
            true => Some(Form::rational(BigRational::zero())),
            false => lengths.as_ref().map(shorter),
        };
        Ellipse {
            least,
            peak: lengths.map(|(direct, reverse)| direct.plus(&reverse).scaled(&half)),
            peak_decimal: (long + short) / 2.0,
            least_decimal: (long - short).abs() / 2.0,
        }
    }

    /// The curve: the ellipses at n + 1 even steps from 0 to 1.
    pub fn curve(&self, steps: u32) -> Vec<(BigRational, Ellipse)> {
        let part = |step: u32| BigRational::new(step.into(), steps.max(1).into());
        (0..=steps.max(1)).map(|step| (part(step), self.ellipse(&part(step)))).collect()
    }
}
