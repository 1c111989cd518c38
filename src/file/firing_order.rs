//! How is a firing order written, and which throws make an in-line engine fire in it?

use std::ops::Range;

use num_rational::BigRational;
use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use super::error::LayoutError;
use super::written::Written;
use crate::engine::{Cycle, Cylinder, MOST_CYLINDERS};
use crate::exact::Turn;

/// A firing order as written: `"1-3-4-2"` or `[1, 3, 4, 2]`.
pub(super) struct FiringOrder(Vec<String>);

impl<'de> Deserialize<'de> for FiringOrder {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Names;
        impl<'de> Visitor<'de> for Names {
            type Value = FiringOrder;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a firing order such as \"1-3-4-2\" or [1, 3, 4, 2]")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<FiringOrder, E> {
                Ok(FiringOrder(
                    text.split(['-', ',', ' ', '–']).filter(|name| !name.is_empty()).map(str::to_owned).collect(),
                ))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<FiringOrder, A::Error> {
                let mut names = Vec::new();
                while let Some(Written(name)) = list.next_element()? {
                    names.push(name);
                }
                Ok(FiringOrder(names))
            }
        }
        deserializer.deserialize_any(Names)
    }
}

impl FiringOrder {
    /// The cylinders by index; each has to fire once.
    pub fn indices(&self, cylinders: &[Cylinder], span: Option<Range<usize>>) -> Result<Vec<usize>, LayoutError> {
        let names: Vec<&str> = cylinders.iter().map(|cylinder| cylinder.name.as_str()).collect();
        self.permutation(&names, span)
    }

    /// The throws of an in-line engine that fires evenly in this order; cylinder 1 stands at 0.
    pub fn even_throws(&self, cycle: Cycle, span: Option<Range<usize>>) -> Result<Vec<Turn>, LayoutError> {
        if self.0.len() > MOST_CYLINDERS {
            let message = format!("a firing order of {} cylinders", self.0.len());
            return Err(LayoutError::new(message, format!("up to {MOST_CYLINDERS} are read"), span));
        }
        let names: Vec<String> = (1..=self.0.len()).map(|number| number.to_string()).collect();
        let order = self.permutation(&names.iter().map(String::as_str).collect::<Vec<_>>(), span)?;
        let interval = cycle.turns() / BigRational::from_integer(order.len().into());
        let mut throws = vec![Turn::zero(); order.len()];
        for (position, &cylinder) in order.iter().enumerate() {
            throws[cylinder] = Turn::new(-&interval * BigRational::from_integer(position.into()));
        }
        let first = throws.first().cloned().unwrap_or_else(Turn::zero);
        Ok(throws.iter().map(|throw| throw - &first).collect())
    }

    fn permutation(&self, names: &[&str], span: Option<Range<usize>>) -> Result<Vec<usize>, LayoutError> {
        if self.0.is_empty() {
            return Err(LayoutError::new("the firing order is empty", "such as \"1-3-4-2\" or [1, 3, 4, 2]", span));
        }
        let mistake = |message: String| {
            LayoutError::new(message, format!("each of the {} cylinders once", names.len()), span.clone())
        };
        let mut order = Vec::with_capacity(names.len());
        for name in &self.0 {
            let index = names.iter().position(|known| known == name);
            let index =
                index.ok_or_else(|| mistake(format!("the firing order names `{name}`, which is no cylinder")))?;
            if order.contains(&index) {
                return Err(mistake(format!("cylinder {name} fires twice in the firing order")));
            }
            order.push(index);
        }
        match names.iter().enumerate().find(|(index, _)| !order.contains(index)) {
            Some((_, name)) => Err(mistake(format!("cylinder {name} is missing from the firing order"))),
            None => Ok(order),
        }
    }
}
