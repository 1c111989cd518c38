//! Which part of a force does each main bearing carry, and do all of them together balance it?

use std::cell::RefCell;
use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::One;

use super::Missing;
use crate::beam::Beam;
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::order::{OrderSum, by_factor};

/// How a load is shared among the bearings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One continuous beam of constant EI: [`crate::beam::Beam::influence`].
    Continuous,
    /// Each span a beam of its own, which is statically determinate: [`crate::beam::Beam::determinate`].
    Determinate,
}

/// The parts that the bearings carry of a load, by its position; each position is solved once.
#[derive(Clone, Debug)]
pub struct Shares {
    beam: Beam,
    method: Method,
    known: RefCell<BTreeMap<BigRational, Vec<BigRational>>>,
}

impl Shares {
    /// Those of the bearings of an engine.
    ///
    /// # Errors
    /// No bearings, or some that hold no shaft.
    pub fn of(engine: &Engine, method: Method) -> Result<Self, Missing> {
        if engine.bearings().is_empty() {
            return Err(Missing::Bearings);
        }
        let beam = Beam::new(engine.bearings().to_vec()).map_err(Missing::Beam)?;
        Ok(Shares { beam, method, known: RefCell::default() })
    }

    /// What one bearing carries of a unit load.
    pub fn part(&self, bearing: usize, position: &BigRational) -> BigRational {
        let mut known = self.known.borrow_mut();
        if let Some(parts) = known.get(position) {
            return parts[bearing].clone();
        }
        let parts = self.solve(position);
        let part = parts[bearing].clone();
        known.insert(position.clone(), parts);
        part
    }

    /// All that was solved.
    pub(super) fn into_known(self) -> BTreeMap<BigRational, Vec<BigRational>> {
        self.known.into_inner()
    }

    fn solve(&self, position: &BigRational) -> Vec<BigRational> {
        match self.method {
            Method::Continuous => self.beam.influence(position),
            Method::Determinate => self.beam.determinate(position),
        }
    }
}

/// Whether the reactions sum to the force, and their moments about position 0 to its moment; all are exact sums.
pub(super) fn in_equilibrium(
    positions: &[BigRational],
    reactions: &[OrderSum],
    [force, moment]: &[OrderSum; 2],
) -> bool {
    let balances = |load: &OrderSum, arm: &dyn Fn(&BigRational) -> BigRational| {
        let weighed = reactions.iter().zip(positions).flat_map(|(reaction, at)| reaction.terms_scaled(arm(at)));
        let left = weighed.chain(load.terms_scaled(-BigRational::one()));
        by_factor(left).values().all(PhasorSum::vanishes)
    };
    balances(force, &|_| BigRational::one()) && balances(moment, &Clone::clone)
}
