//! How are crank, rods, masses and speed written? `[mechanism]` and `speed`.

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::measured::{Column, Reading};
use super::quantities::{misread, not_negative, twice, value};
use super::rewritten::exact_number;
use super::units;
use super::written::{self, Text, Values, Written, place};
use crate::engine::{Cylinder, Dimensions, Given, Linear, Measure, Mechanism, Rod};
use crate::text::Untrusted;

/// `[mechanism]`: each key holds one value for all cylinders, or a list with one per cylinder.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    source: Option<Text>,
    stroke: Option<written::Column>,
    crank_radius: Option<written::Column>,
    rod_length: Option<written::Column>,
    rod_ratio: Option<written::Column>,
    scotch_yoke: Option<Spanned<bool>>,
    pin_offset: Option<written::Column>,
    offset_ratio: Option<written::Column>,
    reciprocating_mass: Option<written::Column>,
    piston_mass: Option<written::Column>,
    pin_mass: Option<written::Column>,
    piston_rod_mass: Option<written::Column>,
    crosshead_mass: Option<written::Column>,
    rod_mass: Option<written::Column>,
    rod_centre: Option<written::Column>,
    rotating_mass: Option<written::Column>,
}

impl Keys {
    /// Reads the table for these cylinders, whose masses and crank radii it sets.
    pub fn read(
        &self,
        cylinders: &mut [Cylinder<Linear, Linear>],
        masses_given: bool,
        offsets_of_form: Option<&written::Column>,
    ) -> Result<Dimensions, LayoutError> {
        let mut table = Reading::new(cylinders.len());
        let half = BigRational::new(1.into(), 2.into());
        let radii = match (&self.stroke, &self.crank_radius) {
            (Some(_), Some(radius)) => return Err(twice("stroke", "crank_radius", radius)),
            (Some(_), None) => {
                let strokes = table.column(&self.stroke, Measure::Stroke)?;
                strokes.map(|strokes| strokes.values.iter().map(|stroke| stroke * &half).collect::<Vec<_>>())
            }
            (None, _) => table.column(&self.crank_radius, Measure::CrankRadius)?.map(|radii| radii.values),
        };
        let lengths = table.column(&self.rod_length, Measure::RodLength)?;
        let pin_offset = match (&self.pin_offset, offsets_of_form) {
            (Some(list), Some(_)) => {
                let right = "the form gives one to each bank already";
                return Err(LayoutError::new("the pin offsets are given twice", right, place(list)));
            }
            (Some(list), None) | (None, Some(list)) => Some(list.clone()),
            (None, None) => None,
        };
        let rods = self.rods(&mut table, radii.as_deref(), lengths.as_ref(), &pin_offset)?;
        let (masses, rotating) = self.masses(&mut table, lengths.as_ref(), masses_given)?;
        let crank_radius = radii.as_ref().and_then(|radii| radii.first().cloned());
        for (index, cylinder) in cylinders.iter_mut().enumerate() {
            if let (Some(radii), Some(unit)) = (&radii, &crank_radius) {
                cylinder.crank_radius = &radii[index] / unit;
            }
            cylinder.mechanism = rods.get(index).cloned();
            if let Some(rotating) = &rotating {
                cylinder.rotating_mass = rotating[index].clone();
            }
        }
        let mut mass = masses_given.then(BigRational::one);
        if let Some(masses) = masses {
            // The first mass that is not zero is the unit; where all are zero, all are once nothing.
            let unit = masses.iter().find(|mass| !mass.is_zero()).cloned();
            for (cylinder, mass) in cylinders.iter_mut().zip(&masses) {
                cylinder.reciprocating_mass = unit.as_ref().map_or_else(BigRational::one, |unit| mass / unit);
            }
            mass = Some(unit.unwrap_or_else(BigRational::zero));
        }
        Ok(Dimensions {
            speed: None,
            crank_radius,
            mass,
            given: table.given,
            source: self.source.as_ref().map(|source| source.get_ref().untrusted()),
        })
    }

    fn rods(
        &self,
        table: &mut Reading,
        radii: Option<&[BigRational]>,
        lengths: Option<&Column>,
        pin_offset: &Option<written::Column>,
    ) -> Result<Vec<Mechanism>, LayoutError> {
        if let Some(yoke) = self.scotch_yoke.as_ref().filter(|yoke| *yoke.get_ref()) {
            return self.yokes(table.count, yoke);
        }
        let ratios = table.column(&self.rod_ratio, Measure::RodRatio)?;
        let (ratios, places) = match (ratios, lengths, radii, &self.rod_length) {
            (Some(_), Some(_), _, Some(length)) => return Err(twice("rod_ratio", "rod_length", length)),
            (Some(ratios), ..) => (ratios.values, ratios.places),
            (None, Some(lengths), Some(radii), _) => {
                let ratios = radii.iter().zip(&lengths.values).map(|(radius, length)| radius / length);
                (ratios.collect(), lengths.places.clone())
            }
            (None, Some(lengths), None, _) => {
                let right = "add a stroke or crank_radius";
                return Err(LayoutError::new("a rod length without a crank radius", right, place(&lengths.places[0])));
            }
            (None, None, ..) => {
                let offset = pin_offset.as_ref().or(self.offset_ratio.as_ref());
                return offset.map_or(Ok(()), no_offset_without_rod).map(|()| Vec::new());
            }
        };
        let offsets = self.offsets(table, radii, &ratios, pin_offset)?;
        let rods: Vec<Rod> = ratios.into_iter().zip(offsets).map(|(ratio, offset)| Rod { ratio, offset }).collect();
        let mechanisms: Vec<Mechanism> = rods.iter().cloned().map(Mechanism::SliderCrank).collect();
        match mechanisms.iter().position(|mechanism| !mechanism.turns_round()) {
            None => Ok(mechanisms),
            Some(index) => {
                let Rod { ratio, offset } = &rods[index];
                let size = ratio + offset.abs();
                let digits = size.to_integer().to_string().len();
                let shown = match exact_number(&size) {
                    // A number in so many digits is seen by its power of ten.
                    _ if digits > 15 => format!("≥ 10^{}", digits - 1),
                    fraction if fraction.starts_with('"') => {
                        let tens = BigRational::from_integer(10_000.into());
                        format!("≈ {}", exact_number(&((&size * &tens).round() / &tens)))
                    }
                    decimal => format!("= {decimal}"),
                };
                let message = format!("cylinder {} cannot turn round: λ + |δ| {shown}", index + 1);
                let right = match (offset.is_zero(), &self.rod_ratio) {
                    (true, Some(_)) => {
                        "rod_ratio is λ = r/l, crank radius over rod length, below 1; l/r = 3.5 is written \"1/3.5\""
                    }
                    (true, None) => "the rod has to be longer than the crank radius: λ < 1",
                    (false, _) => {
                        "the rod has to be longer than crank radius and offset together, by a millionth: λ + |δ| ≤ 0.999999"
                    }
                };
                Err(LayoutError::new(message, right, place(&places[index])))
            }
        }
    }

    /// Scotch yokes, whose pistons move, and load their cranks, as with an infinitely long rod.
    fn yokes(&self, count: usize, yoke: &Spanned<bool>) -> Result<Vec<Mechanism>, LayoutError> {
        let rods = [&self.rod_length, &self.rod_ratio, &self.rod_mass, &self.pin_offset, &self.offset_ratio];
        if rods.iter().any(|keys| keys.is_some()) {
            let message = "a Scotch yoke with a connecting rod";
            return Err(LayoutError::new(message, "omit the rod and its offset, or the yoke", place(yoke)));
        }
        let endless = Rod { ratio: BigRational::zero(), offset: BigRational::zero() };
        Ok(vec![Mechanism::SliderCrank(endless); count])
    }

    /// Offsets δ = e/l; 0 where the file names none.
    fn offsets(
        &self,
        table: &mut Reading,
        radii: Option<&[BigRational]>,
        ratios: &[BigRational],
        pin_offset: &Option<written::Column>,
    ) -> Result<Vec<BigRational>, LayoutError> {
        match (pin_offset, &self.offset_ratio) {
            (None, None) => Ok(vec![BigRational::zero(); ratios.len()]),
            (Some(_), Some(ratio)) => Err(twice("pin_offset", "offset_ratio", ratio)),
            (None, Some(_)) => {
                let column = table.column(&self.offset_ratio, Measure::OffsetRatio)?;
                Ok(column.map(|column| column.values).unwrap_or_default())
            }
            (Some(list), None) => {
                let Some(radii) = radii.filter(|_| ratios.iter().all(Signed::is_positive)) else {
                    let right = "add a stroke or crank_radius, or write offset_ratio = e/l";
                    return Err(LayoutError::new("an offset in metres without a rod length", right, place(list)));
                };
                let column = table.column(pin_offset, Measure::PinOffset)?;
                let offsets = column.map(|column| column.values).unwrap_or_default();
                Ok(offsets.iter().zip(radii).zip(ratios).map(|((offset, r), ratio)| offset * ratio / r).collect())
            }
        }
    }

    /// Reciprocating and rotating masses, given or from piston, pin and rod.
    #[expect(clippy::type_complexity, reason = "two lists of masses, each of which may be missing")]
    fn masses(
        &self,
        table: &mut Reading,
        lengths: Option<&Column>,
        masses_given: bool,
    ) -> Result<(Option<Vec<BigRational>>, Option<Vec<BigRational>>), LayoutError> {
        let whole = self.reciprocating_mass.as_ref().or(self.piston_mass.as_ref());
        if let (Some(list), true) = (whole, masses_given) {
            return Err(LayoutError::new(
                "the reciprocating masses are given twice",
                "the tables [[cylinder]] give them already",
                place(list),
            ));
        }
        if let (Some(_), Some(list)) = (&self.reciprocating_mass, &self.piston_mass) {
            return Err(twice("reciprocating_mass", "piston_mass", list));
        }
        if let (Some(_), Some(list)) = (&self.reciprocating_mass, &self.rod_mass) {
            let message = "rod_mass contradicts reciprocating_mass, which has the rod's part at the piston already";
            let right = "omit rod_mass, with reciprocating_mass and rotating_mass; or write piston_mass in place of reciprocating_mass, with rod_mass, rod_length and rod_centre";
            return Err(LayoutError::new(message, right, place(list)));
        }
        let parts = [
            (&self.pin_mass, "pin_mass"),
            (&self.piston_rod_mass, "piston_rod_mass"),
            (&self.crosshead_mass, "crosshead_mass"),
            (&self.rod_mass, "rod_mass"),
            (&self.rod_centre, "rod_centre"),
        ];
        for (list, name) in parts {
            if let (Some(list), None) = (list, &self.piston_mass) {
                let message = format!("{name} without a piston_mass");
                return Err(LayoutError::new(message, "piston, pin and rod are given together", place(list)));
            }
        }
        let given = table.column(&self.reciprocating_mass, Measure::ReciprocatingMass)?.map(|column| column.values);
        let rotating = table.column(&self.rotating_mass, Measure::RotatingMass)?.map(|column| column.values);
        let Some(pistons) = table.column(&self.piston_mass, Measure::PistonMass)? else {
            return Ok((given, rotating));
        };
        let mut masses = pistons.values;
        // All that moves with the piston along its cylinder.
        let beside = [
            (&self.pin_mass, Measure::PinMass),
            (&self.piston_rod_mass, Measure::PistonRodMass),
            (&self.crosshead_mass, Measure::CrossheadMass),
        ];
        for (list, measure) in beside {
            if let Some(parts) = table.column(list, measure)? {
                masses.iter_mut().zip(parts.values).for_each(|(mass, part)| *mass += part);
            }
        }
        let Some(rods) = table.column(&self.rod_mass, Measure::RodMass)? else {
            return match &self.rod_centre {
                None => Ok((Some(masses), rotating)),
                Some(list) => Err(LayoutError::new("rod_centre without a rod_mass", "add the rod's mass", place(list))),
            };
        };
        if let Some(list) = &self.rotating_mass {
            let message = "rotating_mass contradicts rod_mass, whose part at the crankpin it is";
            let right = "omit rotating_mass, with rod_mass, rod_length and rod_centre; or omit rod_mass and rod_centre, and add the rod's other part to piston_mass";
            return Err(LayoutError::new(message, right, place(list)));
        }
        let (Some(lengths), Some(centres)) = (lengths, table.column(&self.rod_centre, Measure::RodCentre)?) else {
            let right = match lengths {
                Some(_) => "add rod_centre, the distance of its centre of gravity from the big end",
                None if self.rod_ratio.is_some() => {
                    "give rod_length in place of rod_ratio, and rod_centre, the distance of its centre of gravity from the big end"
                }
                None => "add rod_length and rod_centre, the distance of its centre of gravity from the big end",
            };
            let list = self.rod_mass.as_ref().and_then(place);
            return Err(LayoutError::new("a rod mass that cannot be split in two masses", right, list));
        };
        let mut rotating = Vec::new();
        for (index, rod) in rods.values.iter().enumerate() {
            let part = &centres.values[index] / &lengths.values[index];
            if part > BigRational::one() {
                let text = &centres.places[index];
                let right = "it lies between the eyes: from 0 to the rod length";
                return Err(misread(text, "distance of the centre of gravity", right));
            }
            masses[index] += rod * &part;
            rotating.push(rod * (BigRational::one() - part));
        }
        Ok((Some(masses), Some(rotating)))
    }
}

/// Offsets where no rod is known: 0, which is what they are where they are left out.
pub(super) fn no_offset_without_rod(offset: &written::Column) -> Result<(), LayoutError> {
    let is_zero = |text: &Written| units::length(&text.0).is_ok_and(|length| length.value.is_zero());
    let are_zero = match offset.get_ref() {
        Values::One(one) => is_zero(one),
        Values::Each(list) => list.iter().all(|one| is_zero(one.get_ref())),
    };
    let right = "add a rod_length or rod_ratio below [mechanism]";
    if are_zero { Ok(()) } else { Err(LayoutError::new("an offset without a rod", right, place(offset))) }
}

/// Speed in revolutions a minute.
pub(super) fn speed(text: &Text) -> Result<(BigRational, Given), LayoutError> {
    let written = &text.get_ref().0;
    let value = not_negative(value(text, "speed", units::speed)?, "speed", text)?;
    let given = Given {
        quantity: Measure::Speed,
        cylinder: None,
        value: value.clone(),
        written: Untrusted::new(written.as_str()),
    };
    Ok((value, given))
}
