//! Which limits can the moments of a front be given?

use std::fmt;

use num_rational::BigRational;
use num_traits::Signed;

use super::sizes::Sizes;
use crate::file::units;

/// The largest moment of an order that is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The order.
    pub order: u32,
    /// The largest length: in m r ω² c_k times the spacing, or in newton-metres.
    pub most: BigRational,
    /// Whether it is in newton-metres.
    pub in_newton_metres: bool,
}

impl Limit {
    /// Reads `2=1.5`, in m r ω² c_k times the spacing, or `2=30 kN m`.
    ///
    /// # Errors
    /// What would be right.
    pub fn parse(text: &str) -> Result<Self, String> {
        let right = "an order with the largest moment of it, such as 2=1.5 in m r ω² c a, or \"2=30 kN m\"";
        let (order, most) = text.split_once('=').ok_or(right)?;
        let order = order.trim().parse().map_err(|_| right)?;
        let (most, in_newton_metres) = units::moment(most)?;
        if most.is_negative() { Err(right.to_owned()) } else { Ok(Limit { order, most, in_newton_metres }) }
    }

    /// The order, and the largest moment as it is read again.
    pub fn parts(&self) -> (u32, String) {
        (self.order, format!("{}{}", self.most, if self.in_newton_metres { " N m" } else { "" }))
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (order, most) = self.parts();
        write!(f, "{order}={most}")
    }
}

/// What was asked of the sizes of moments.
#[derive(Clone, Debug, Default)]
pub struct Limits {
    /// The limits.
    pub limits: Vec<Limit>,
    /// The sizes that turn moments into newton-metres.
    pub sizes: Option<Sizes>,
    /// How many stars the front has without limits.
    pub of: usize,
}
