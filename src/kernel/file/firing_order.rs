//! How is it written when the cylinders fire?

use std::collections::BTreeMap;
use std::ops::Range;

use num_rational::BigRational;
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities;
use super::written::{Text, Written, place};
use crate::engine::{Cylinder, Family, OpenFiring, firing_pistons};

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
            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<FiringOrder, A::Error> {
                let names: Vec<Written> = Vec::deserialize(SeqAccessDeserializer::new(list))?;
                Ok(FiringOrder(names.into_iter().map(|Written(name)| name).collect()))
            }
        }
        deserializer.deserialize_any(Names)
    }
}

impl FiringOrder {
    /// The cylinders by index; each has to fire once.
    pub fn indices<A, L>(
        &self,
        cylinders: &[Cylinder<A, L>],
        span: Option<Range<usize>>,
    ) -> Result<Vec<usize>, LayoutError> {
        let fired = firing_pistons(cylinders);
        let names: Vec<&str> = fired.iter().map(|&index| cylinders[index].name.as_str()).collect();
        Ok(self.permutation(&names, span)?.into_iter().map(|place| fired[place]).collect())
    }

    /// How many cylinders it names.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    fn permutation(&self, names: &[&str], span: Option<Range<usize>>) -> Result<Vec<usize>, LayoutError> {
        if self.0.is_empty() {
            return Err(LayoutError::new("the firing order is empty", "such as \"1-3-4-2\" or [1, 3, 4, 2]", span));
        }
        let hyphens = if self.0.len() == 1 && names.len() > 1 { ", with hyphens between them" } else { "" };
        let mistake = |message: String| {
            LayoutError::new(message, format!("each of the {} cylinders once{hyphens}", names.len()), span.clone())
        };
        let mut order = Vec::with_capacity(names.len());
        for name in &self.0 {
            let index = names.iter().position(|known| known == name);
            let index =
                index.ok_or_else(|| mistake(format!("the firing order names `{name}`, which is not a cylinder")))?;
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

/// What a file whose angles or positions are open says of its firing.
pub(super) fn open_firing(
    order: Option<&Spanned<FiringOrder>>,
    angles: Option<&Spanned<Vec<Text>>>,
    values: &BTreeMap<String, BigRational>,
    family: &Family,
) -> Result<Option<OpenFiring>, LayoutError> {
    if family.cycle().is_none() {
        return without_cycle(order, angles).map(|()| None);
    }
    if let Some(span) =
        order.and_then(place).or_else(|| angles.and_then(place)).filter(|_| family.has_opposed_pistons())
    {
        let message =
            "when the cylinders fire, in an engine with two pistons in each whose angles or positions are open";
        return Err(LayoutError::new(message, "give the unknowns values below [values]", Some(span)));
    }
    match (order, angles) {
        (None, None) => Ok(None),
        (Some(order), None) => {
            order.get_ref().indices(family.cylinders(), place(order)).map(OpenFiring::Order).map(Some)
        }
        (None, Some(list)) => {
            let angle = |text| Ok(quantities::angle(text)?.with(values));
            let angles = list.get_ref().iter().map(angle).collect::<Result<_, LayoutError>>()?;
            OpenFiring::from_angles(angles, family.cylinders())
                .map(Some)
                .map_err(|(message, right)| LayoutError::new(message, right, place(list)))
        }
        (Some(_), Some(list)) => Err(both_given(list)),
    }
}

/// An angle that may be written with unknowns that have values.
pub(super) fn known_angle(text: &Text, values: &BTreeMap<String, BigRational>) -> Result<BigRational, LayoutError> {
    match quantities::angle(text)?.with(values).as_known() {
        Some(known) => Ok(known.clone()),
        None => quantities::known_angle(text),
    }
}

/// A file that says when the cylinders fire, and not in which cycle.
pub(super) fn without_cycle(
    order: Option<&Spanned<FiringOrder>>,
    angles: Option<&Spanned<Vec<Text>>>,
) -> Result<(), LayoutError> {
    match order.and_then(place).or_else(|| angles.and_then(place)) {
        None => Ok(()),
        span => Err(LayoutError::new(
            "when the cylinders fire depends on the cycle, which is missing",
            "add cycle = \"four-stroke\" or \"two-stroke\"",
            span,
        )),
    }
}

pub(super) fn both_given(angles: &Spanned<Vec<Text>>) -> LayoutError {
    LayoutError::new(
        "both a firing order and firing angles are given",
        "one of them is enough: the angles say the order",
        place(angles),
    )
}
