//! Which part of a load does each main bearing carry?
//!
//! The crankshaft is taken as one straight beam of constant EI on rigid supports that do not clamp it (theory, section 8).
//! The parts are then rational: found here without rounding, by the equation of three moments (Clapeyron 1857).

mod error;
mod load;
mod spans;

pub use error::BeamError;

use load::Load;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use spans::Spans;

/// A straight beam of constant EI on two or more supports, at exact positions in any one unit of length.
#[derive(Clone, Debug)]
pub struct Beam {
    /// Indices of the supports as given, in the order of their positions.
    order: Vec<usize>,
    /// Position of the first of them.
    origin: BigRational,
    /// The greatest length of which every span is a whole multiple.
    unit: BigRational,
    /// Positions in that unit from the first support, in order.
    places: Vec<BigInt>,
    spans: Spans,
}

impl Beam {
    /// A beam on these supports, given in any order; the answers keep the order.
    ///
    /// It reaches as far beyond the outer supports as a load asks for.
    ///
    /// # Errors
    ///
    /// Fewer than two supports, or two at one position.
    pub fn new(supports: Vec<BigRational>) -> Result<Self, BeamError> {
        let mut order: Vec<usize> = (0..supports.len()).collect();
        // The sort is stable: of two supports at one position the one given first stays first.
        order.sort_by(|&a, &b| supports[a].cmp(&supports[b]));
        let (Some(&first), true) = (order.first(), supports.len() > 1) else {
            return Err(BeamError::FewerThanTwoSupports(supports.len()));
        };
        if let Some(pair) = order.windows(2).find(|pair| supports[pair[0]] == supports[pair[1]]) {
            let at = supports[pair[0]].clone();
            return Err(BeamError::CoincidingSupports { first: pair[0], second: pair[1], at });
        }
        let origin = supports[first].clone();
        let distances: Vec<_> = order.iter().map(|&support| &supports[support] - &origin).collect();
        let unit = spans::common_unit(&distances);
        let places: Vec<_> = distances.iter().map(|distance| (distance / &unit).to_integer()).collect();
        let spans = Spans::new(places.windows(2).map(|ends| &ends[1] - &ends[0]).collect());
        Ok(Beam { order, origin, unit, places, spans })
    }

    /// The part of a load at this position that each support carries, in the order in which the supports were given.
    ///
    /// A part is the force that the bearing feels, positive in the direction of the load: the parts sum to 1, and their
    /// moments to that of the load. A support from which the beam would lift has a negative part. The load may overhang the
    /// outer supports.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::beam::Beam;
    /// use num_rational::BigRational;
    ///
    /// let whole = |n: i64| BigRational::from_integer(n.into());
    /// let beam = Beam::new(vec![whole(0), whole(2), whole(4)]).unwrap();
    /// let parts = |position| beam.influence(&whole(position)).iter().map(ToString::to_string).collect::<Vec<_>>();
    /// assert_eq!(parts(1), ["13/32", "11/16", "-3/32"]);
    /// assert_eq!(parts(2), ["0", "1", "0"]);
    /// ```
    pub fn influence(&self, position: &BigRational) -> Vec<BigRational> {
        let place = self.place(position);
        let load = Load::new(&place, &self.places);
        let parts = self.spans.reactions(&load);
        if !self.balance(&parts, &place, &self.spans.denominator(&load)) {
            unreachable!("the forces of the bearings and their moments balance the load")
        }
        self.as_given(parts)
    }

    /// The same by the statically determinate approximation: each span a simply supported beam of its own, so that only
    /// the two supports beside the load carry it, by the law of the lever.
    ///
    /// An overhanging load is carried by the outer span. Order and sign as of [`Beam::influence`].
    pub fn determinate(&self, position: &BigRational) -> Vec<BigRational> {
        let place = self.place(position);
        let span = load::span_of(&place, &self.places);
        let [left, right] = [&self.places[span], &self.places[span + 1]];
        let part = (place - left) / (right - left);
        let mut parts = vec![BigRational::zero(); self.places.len()];
        parts[span] = BigRational::one() - &part;
        parts[span + 1] = part;
        self.as_given(parts)
    }

    /// A position in units from the first support.
    fn place(&self, position: &BigRational) -> BigRational {
        (position - &self.origin) / &self.unit
    }

    /// Whether parts over divisors of one common denominator have the force and the moment of a unit load.
    fn balance(&self, parts: &[BigRational], place: &BigRational, common: &BigInt) -> bool {
        let forces = || parts.iter().map(|part| part.numer() * (common / part.denom()));
        let force: BigInt = forces().sum();
        let moment: BigInt = forces().zip(&self.places).map(|(force, place)| force * place).sum();
        force == *common && moment * place.denom() == place.numer() * common
    }

    fn as_given(&self, parts: Vec<BigRational>) -> Vec<BigRational> {
        let mut given = vec![BigRational::zero(); parts.len()];
        for (&support, part) in self.order.iter().zip(parts) {
            given[support] = part;
        }
        given
    }
}
