//! Which throws make the cylinders fire as the file says? β = α − τ, the first cylinder at 0 (theory of mechanisms, section 4).

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::contradiction;
use super::error::LayoutError;
use super::forms::Expanded;
use super::geared_keys::{Geared, equivalent};
use super::pin_split::{neighbours, reduced, signed, throws_of};
use super::shared_keys::{SharedKeys, Throws};
use crate::engine::{Cylinder, Linear};

/// Sets the throws that the file omits.
///
/// # Errors
/// A firing that the form cannot have, or that the same form with its banks exchanged could have with pins nearer together.
pub(super) fn follow(expanded: &mut Expanded, above: &SharedKeys<'_>) -> Result<(), LayoutError> {
    let (splits_given, splays) = match &expanded.throws {
        Throws::Listed => return Ok(()),
        Throws::Follow { splits_given, splays } => (*splits_given, splays.as_slice()),
    };
    let geared = &expanded.geared;
    let mut aligned = expanded.cylinders.clone();
    // A pin that is splayed beyond its bank meets the dead centre of an offset axis: as if the bank stood there, and met the shaft.
    for (cylinder, splay) in aligned.iter_mut().zip(splays) {
        cylinder.bank = cylinder.bank.plus(&splay.beyond);
    }
    let cylinders = &mut aligned;
    for (index, cylinder) in cylinders.iter_mut().enumerate().filter(|(_, cylinder)| cylinder.name.is_empty()) {
        cylinder.name = (index + 1).to_string();
    }
    let fires = above.fires(cylinders)?;
    let throws = throws_of(cylinders, &fires);
    let place = || above.firing_place();
    if splits_given && let Some([one, other]) = first_misfit(cylinders, &throws) {
        let apart = |throws: &[&Linear; 2]| signed(throws[1].minus(throws[0])).in_degrees();
        let needed = apart(&[&throws[one], &throws[other]]);
        let written = apart(&[&cylinders[one].throw, &cylinders[other].throw]);
        let message = format!(
            "with these banks this order needs the pins of cylinders {} and {} {needed}° apart, and they are {written}°",
            cylinders[one].name, cylinders[other].name
        );
        let fits = |others: &[Cylinder<Linear, Linear>]| {
            let fires = above.fires(others).ok()?;
            first_misfit(others, &throws_of(others, &fires)).is_none().then_some(true)
        };
        let negated = |angle: &Linear| angle.scaled(&-BigRational::one());
        let right = contradiction::what_would_fit(cylinders, above.convention, negated, fits)
            .unwrap_or_else(|| "neither with the banks exchanged nor in another numbering would it fit".to_owned());
        return Err(LayoutError::new(message, right, place()));
    }
    if !splits_given {
        let exchanged: Vec<Cylinder<Linear, Linear>> =
            contradiction::banks_exchanged(cylinders, |angle: &Linear| angle.scaled(&-BigRational::one()));
        let here = pins(geared, cylinders, &throws);
        let there = pins(geared, &exchanged, &throws_of(&exchanged, &fires));
        if let (Some(now), Some(then)) = (spread(cylinders, &here), spread(cylinders, &there))
            && then < now
            && let Some([one, two]) = first_apart(cylinders, &here)
        {
            let between = |pins: &[Linear]| signed(pins[two].minus(&pins[one])).in_degrees();
            let (now, then) = (between(&here), between(&there));
            return Err(LayoutError::new(
                format!("with these banks this order needs pins {now}° apart"),
                format!(
                    "with the banks exchanged they are {then}° apart: it turns the other way ({}), or bank 1 is the other bank (bank_angle, \
                     or each bank, with the other sign); where it is meant so, say it: pin_split = {now} in a vee, pin_splits in a \
                     fan, throws elsewhere",
                    contradiction::rotation_other_than(above.convention)
                ),
                place(),
            ));
        }
    }
    // Of a narrow V it is the throw that counts from the first, as one would list it, and not the splayed pin.
    let first = splays.first().map_or_else(Linear::default, |splay| splay.pin.clone());
    for ((cylinder, aligned), throw) in expanded.cylinders.iter_mut().zip(aligned).zip(throws) {
        *cylinder = Cylinder { throw: reduced(throw.plus(&first)), name: aligned.name, ..cylinder.clone() };
    }
    Ok(())
}

/// Where the pins stand: at the throws, and on a crankshaft against the reference at those of the cranks that they are equivalent to.
fn pins(geared: &[Geared], cylinders: &[Cylinder<Linear, Linear>], throws: &[Linear]) -> Vec<Linear> {
    let pin = |(cylinder, throw): (&Cylinder<Linear, Linear>, &Linear)| match geared.get(cylinder.crank) {
        Some(crank) => reduced(equivalent(throw, &cylinder.bank, crank.sense)),
        None => throw.clone(),
    };
    cylinders.iter().zip(throws).map(pin).collect()
}

/// The first two cylinders of a pin whose throws stand otherwise to each other than the form has them.
fn first_misfit(cylinders: &[Cylinder<Linear, Linear>], throws: &[Linear]) -> Option<[usize; 2]> {
    neighbours(cylinders).find(|&[one, other]| {
        let needed = throws[other].minus(&throws[one]);
        let has = cylinders[other].throw.minus(&cylinders[one].throw);
        !needed.minus(&has).as_known().is_some_and(BigRational::is_integer)
    })
}

fn first_apart(cylinders: &[Cylinder<Linear, Linear>], throws: &[Linear]) -> Option<[usize; 2]> {
    neighbours(cylinders).find(|&[one, other]| throws[one] != throws[other])
}

/// How far the throws of one pin stand from each other, all pins together; none where that is open.
fn spread(cylinders: &[Cylinder<Linear, Linear>], throws: &[Linear]) -> Option<BigRational> {
    let apart = |[one, other]: [usize; 2]| Some(signed(throws[other].minus(&throws[one])).as_known()?.abs());
    neighbours(cylinders).map(apart).sum()
}
