//! What is a rational number times a power of π?

use std::f64::consts::PI;

use num_rational::BigRational;
use num_traits::Zero;

use crate::numbers::{self, Form};

/// A number with a power of π: exact where its form is known.
#[derive(Clone, Debug)]
pub struct WithPi {
    /// The number but for π, in closed form.
    pub form: Option<Form>,
    /// The power of π that it is multiplied by.
    pub power: i32,
    /// All of it in decimals.
    pub decimal: f64,
}

impl WithPi {
    pub(super) fn new(form: Form, power: i32) -> Self {
        WithPi { decimal: form.to_float() * PI.powi(power), form: Some(form), power }
    }

    pub(super) fn rational(value: BigRational, power: i32) -> Self {
        WithPi::new(Form::rational(value), power)
    }

    pub(super) fn decimal(decimal: f64) -> Self {
        WithPi { form: None, power: 0, decimal }
    }

    /// Times a rational number and a power of π.
    pub(super) fn times(&self, by: &BigRational, power: i32) -> Self {
        let decimal = self.decimal * numbers::float(by) * PI.powi(power);
        WithPi { form: self.form.as_ref().map(|form| form.scaled(by)), power: self.power + power, decimal }
    }

    pub(super) fn over(&self, other: &WithPi) -> Self {
        let form = self.form.as_ref().zip(other.form.as_ref()).and_then(|(above, below)| {
            let below = below.as_rational().filter(|below| !below.is_zero())?;
            Some(above.scaled(&below.recip()))
        });
        WithPi { form, power: self.power - other.power, decimal: self.decimal / other.decimal }
    }
}
