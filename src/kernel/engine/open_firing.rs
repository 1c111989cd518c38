//! When do the cylinders of a family fire? At angles with the unknowns in them, which a firing order says for some values alone.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::cycle::Cycle;
use super::cylinder::Cylinder;
use super::firing::{Firing, not_one_each};
use super::linear::Linear;

/// What a layout whose angles or positions are open says of its firing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OpenFiring {
    /// The cylinders, counted from 0, in the order of their firing.
    Order(Vec<usize>),
    /// The crank angle in turns at which each cylinder fires.
    Angles(Vec<Linear>),
}

impl OpenFiring {
    /// The firings at given crank angles, one per cylinder, with the unknowns in them; the error says what is wrong, and what would
    /// be right.
    pub fn from_angles(angles: Vec<Linear>, cylinders: &[Cylinder<Linear, Linear>]) -> Result<Self, (String, String)> {
        if angles.len() != cylinders.len() {
            return Err(not_one_each(angles.len(), cylinders.len()));
        }
        for (angle, cylinder) in angles.iter().zip(cylinders) {
            let (angle, right) = (angle.minus(&angles[0]), dead_centre(cylinder).minus(&dead_centre(&cylinders[0])));
            if !angle.minus(&right).as_known().is_some_and(BigRational::is_integer) {
                let message = format!("cylinder {} cannot fire {}° after the first", cylinder.name, angle.in_degrees());
                let right = format!("it reaches top dead centre at {}°, and every 360°", right.in_degrees());
                return Err((message, right));
            }
        }
        Ok(OpenFiring::Angles(angles))
    }

    /// The firings of an engine whose angles are known; none where it cannot fire so.
    pub(super) fn known(&self, cycle: Cycle, cylinders: &[Cylinder]) -> Option<Firing> {
        match self {
            OpenFiring::Order(order) => Firing::from_order(order, cycle, cylinders).ok(),
            OpenFiring::Angles(angles) => {
                let known: Option<Vec<BigRational>> = angles.iter().map(|angle| angle.as_known().cloned()).collect();
                Firing::from_angles(&known?, cycle, cylinders).ok()
            }
        }
    }

    /// The same with some unknowns known, in turns.
    pub(super) fn with(&self, values: &BTreeMap<String, BigRational>) -> Self {
        match self {
            OpenFiring::Order(order) => OpenFiring::Order(order.clone()),
            OpenFiring::Angles(angles) => OpenFiring::Angles(angles.iter().map(|angle| angle.with(values)).collect()),
        }
    }
}

/// Crank angle of a top dead centre, in turns.
pub(super) fn dead_centre(cylinder: &Cylinder<Linear, Linear>) -> Linear {
    cylinder.bank.minus(&cylinder.throw)
}
