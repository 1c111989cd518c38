//! Which stars of a front keep limits of their moments? What beats a star that keeps them keeps them too, so these are the best of all that do.

use std::fmt;

use num_rational::BigRational;
use num_traits::Signed;

use super::answer::Front;
use super::found::Moment;
use super::problem::ProblemError;
use super::sizes::Sizes;
use crate::exact::{PhasorSum, Term, Turn};
use crate::file::units;
use crate::numbers;

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
}

impl Limit {
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

impl Front {
    /// The stars that keep these limits, with what turns moments into newton-metres.
    ///
    /// # Errors
    /// Limits of orders that are not compared; newton-metres without sizes.
    pub fn limited(mut self, limits: Vec<Limit>, sizes: Option<Sizes>) -> Result<Front, ProblemError> {
        if self.problem.bank_angle.is_some() && !(limits.is_empty() && sizes.is_none()) {
            return Err(ProblemError::new("limits and newton-metres are for engines in line"));
        }
        for limit in &limits {
            if !self.problem.orders.contains(&limit.order) {
                return Err(ProblemError::new(format!(
                    "a limit of order {}, which is not compared; give it with --orders",
                    limit.order
                )));
            }
            if limit.in_newton_metres && sizes.is_none() {
                return Err(ProblemError::new(
                    "a limit in newton-metres needs --sizes LAYOUT: masses, rod, spacing, speed",
                ));
            }
        }
        let of = self.stars.len();
        let keeps = |moment: &Moment| {
            let mut own = limits.iter().filter(|limit| limit.order == moment.order);
            own.all(|limit| is_within(moment, limit, sizes.as_ref()))
        };
        let kept: Vec<bool> = self.stars.iter().map(|star| star.moments.iter().all(keeps)).collect();
        let mut of_stars = kept.iter();
        self.stars.retain(|_| of_stars.next() == Some(&true));
        if self.points.len() == kept.len() {
            let mut of_points = kept.iter();
            self.points.retain(|_| of_points.next() == Some(&true));
        }
        self.limits = Limits { limits, sizes, of };
        Ok(self)
    }
}

/// Whether a moment is no longer than a limit: exactly in multiples, in decimals in newton-metres.
fn is_within(moment: &Moment, limit: &Limit, sizes: Option<&Sizes>) -> bool {
    if let Some(sizes) = sizes.filter(|_| limit.in_newton_metres) {
        let size = if moment.sum.vanishes() { 0.0 } else { moment.decimal * sizes.newton_metres(moment.order) };
        return size <= numbers::float(&limit.most);
    }
    let square = Term { angle: Turn::zero(), weight: &limit.most * &limit.most };
    let excess = moment.sum.times(&moment.sum.conjugate()).minus(&PhasorSum::new(vec![square]));
    excess.vanishes() || numbers::evaluate(&excess).re < 0.0
}
