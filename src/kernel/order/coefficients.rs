//! What are the factors of the exact sums, in numbers? Each is enclosed once.

use std::cell::RefCell;
use std::collections::BTreeMap;

use num_rational::BigRational;

use super::corrected::Corrected;
use super::crank::crank_of;
use super::factor::Factor;
use crate::engine::{Link, Rod};
use crate::motion::{Coefficient, CorrectedLinkage, Enclosure, HungLink, SliderCrank};
use crate::proof::Sense;

/// The values of factors that were asked for.
#[derive(Debug, Default)]
pub struct Coefficients {
    cranks: RefCell<BTreeMap<Rod, SliderCrank>>,
    corrected: RefCell<BTreeMap<Corrected, CorrectedLinkage>>,
    hung: RefCell<BTreeMap<Link, HungLink>>,
    known: RefCell<BTreeMap<(Factor, u32), Coefficient>>,
}

impl Coefficients {
    /// The value of a factor in an order: computed once; none where nothing is known of the mechanism, and for what a link has no
    /// number of: its motion is that of a [`Factor::Linkage`] or [`Factor::Corrected`], and its torque is not judged.
    pub fn of(&self, factor: &Factor, order: u32) -> Option<Coefficient> {
        let key = (factor.clone(), order);
        if let Some(known) = self.known.borrow().get(&key) {
            return Some(known.clone());
        }
        let coefficient = match factor {
            Factor::One => return Some(exactly_one()),
            Factor::Geared(..) => {
                let (own, order) = factor.own(order);
                return self.of(own, order);
            }
            Factor::Open | Factor::OpenTorque | Factor::DecimalTorque(_) => return None,
            Factor::Motion(rod) => self.crank(rod, |crank| crank.coefficient(order)),
            Factor::Quadrature(rod) => {
                let first = self.crank(rod, |crank| crank.coefficient(1));
                Coefficient { re: first.im, im: Enclosure::zero() }
            }
            Factor::Side(rod) => self.crank(rod, |crank| crank.side_part(order)),
            Factor::Torque(rod) => self.crank(rod, |crank| crank.torque_coefficient(order)),
            Factor::Linkage(linkage) => Coefficient { re: linkage.motion().number(order), im: Enclosure::zero() },
            Factor::OnPin(link, mass, sense) => {
                let mut links = self.hung.borrow_mut();
                links.entry(link.clone()).or_insert_with(|| link.hung()).number(*mass, order, *sense == Sense::Reverse)
            }
            Factor::Corrected(corrected, component) => {
                let mut corrected_ones = self.corrected.borrow_mut();
                let motion = corrected_ones.entry(corrected.clone()).or_insert_with(|| corrected.motion());
                Coefficient { re: motion.component(order, *component), im: Enclosure::zero() }
            }
        };
        self.known.borrow_mut().insert(key, coefficient.clone());
        Some(coefficient)
    }

    /// The same in a sum of this sense: conjugated in a reverse one.
    pub fn in_sense(&self, factor: &Factor, order: u32, sense: Option<Sense>) -> Option<Coefficient> {
        let coefficient = self.of(factor, order)?;
        Some(match sense {
            Some(Sense::Reverse) => conjugate(coefficient),
            Some(Sense::Direct) | None => coefficient,
        })
    }

    /// The value of a factor, if it was asked for before.
    pub fn known(&self, factor: &Factor, order: u32) -> Option<Coefficient> {
        let (own, order) = factor.own(order);
        self.known.borrow().get(&(own.clone(), order)).cloned()
    }

    /// How many values were computed.
    pub fn computed(&self) -> usize {
        self.known.borrow().len()
    }

    fn crank(&self, rod: &Rod, value: impl Fn(&SliderCrank) -> Coefficient) -> Coefficient {
        value(self.cranks.borrow_mut().entry(rod.clone()).or_insert_with(|| crank_of(rod)))
    }
}

/// 1, as a coefficient.
pub fn exactly_one() -> Coefficient {
    Coefficient { re: Enclosure::point(BigRational::from_integer(1.into())), im: Enclosure::zero() }
}

fn conjugate(coefficient: Coefficient) -> Coefficient {
    let minus = BigRational::from_integer((-1).into());
    Coefficient { im: coefficient.im.times(&minus), ..coefficient }
}
