//! What are the factors of the exact sums, in numbers? Each is enclosed once.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use num_rational::BigRational;

use super::{Missing, Swing, Vector, comparable, scale};
use crate::engine::{Engine, Rod};
use crate::motion::{Coefficient, Enclosure, SliderCrank};
use crate::order::{Factor, OrderSum};
use crate::proof::Sense;

/// Forces from here on are refused: their sums and squares would leave the range of decimals.
const LARGEST: f64 = 1e150;

/// The motions of the cylinders, and the coefficients that were asked of them.
pub(super) struct Motion {
    pub cranks: BTreeMap<Rod, SliderCrank>,
    known: RefCell<BTreeMap<(Factor, u32), Coefficient>>,
    pub computed: Cell<usize>,
}

impl Motion {
    pub fn new(layout: &Engine) -> Result<Self, Missing> {
        if scale(layout).is_some_and(|scale| !(scale.force() < LARGEST && scale.torque() < LARGEST)) {
            return Err(Missing::TooLarge);
        }
        let mechanism = &layout.mechanism;
        if mechanism.rods.is_empty() {
            return Err(Missing::Rods);
        }
        comparable(layout)?;
        let mut cranks = BTreeMap::new();
        for rod in &mechanism.rods {
            let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
            cranks.insert(rod.clone(), crank.map_err(|error| Missing::Motion(error.to_string()))?);
        }
        Ok(Motion { cranks, known: RefCell::default(), computed: Cell::new(0) })
    }

    /// The value of a factor: computed, and counted, once.
    pub fn coefficient(&self, factor: &Factor, order: u32) -> Coefficient {
        let key = (factor.clone(), order);
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let coefficient = match factor {
            Factor::One => return exactly_one(),
            Factor::Motion(rod) => self.crank(rod, |crank| crank.coefficient(order)),
            Factor::Torque(rod) => self.crank(rod, |crank| crank.torque_coefficient(order)),
            Factor::Open => unreachable!("loads are those of an engine that names its rods"),
        };
        self.computed.set(self.computed.get() + 1);
        self.known.borrow_mut().insert(key, coefficient.clone());
        coefficient
    }

    fn crank(&self, rod: &Rod, value: impl Fn(&SliderCrank) -> Coefficient) -> Coefficient {
        match self.cranks.get(rod) {
            Some(crank) => value(crank),
            // An offset below zero has its coefficients from its mirror image.
            None => match SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) {
                Ok(crank) => value(&crank),
                Err(_) => unreachable!("λ + |δ| is that of a crank that turns round"),
            },
        }
    }

    pub fn vector(&self, sum: &OrderSum, order: u32, sense: Sense) -> Vector {
        Vector::new(sum, |factor| match sense {
            Sense::Direct => self.coefficient(factor, order),
            Sense::Reverse => Vector::conjugated(self.coefficient(factor, order)),
        })
    }

    /// What the two sums of an order trace.
    pub fn swing(&self, [direct, reverse]: [OrderSum; 2], order: u32) -> Swing {
        let vectors = [self.vector(&direct, order, Sense::Direct), self.vector(&reverse, order, Sense::Reverse)];
        Swing::new(vectors, [&direct, &reverse])
    }

    /// The coefficient that all cylinders have in common, where a vector asked for it.
    pub fn common(&self, order: u32) -> Option<Coefficient> {
        let mut rods = self.cranks.keys();
        let (Some(rod), None) = (rods.next(), rods.next()) else { return None };
        let (factor, sign) = Factor::of_force(Some(rod), order)?;
        if factor == Factor::One {
            return Some(exactly_one());
        }
        let known = self.known.borrow().get(&(factor, order)).cloned()?;
        Some(Coefficient { re: known.re.times(&sign), im: known.im.times(&sign) })
    }
}

pub(super) fn exactly_one() -> Coefficient {
    Coefficient { re: Enclosure::point(BigRational::from_integer(1.into())), im: Enclosure::zero() }
}
