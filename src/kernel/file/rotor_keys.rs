//! How are masses on a shaft written? A file of `[[mass]]` tables, in which what is wanted is omitted.

use num_rational::BigRational;
use num_traits::{One, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::kind::Kind;
use super::number::parse_number;
use super::quantities::{known_angle, mass, metres, misread, not_negative, positive_metres, value};
use super::units;
use super::written::{Table, Text, place};
use crate::exact::Turn;
use crate::text::Untrusted;

/// More masses than this are on no shaft.
const MOST_MASSES: usize = 100;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Option<Text>,
    speed: Option<Text>,
    share: Option<Text>,
    secondary: Option<bool>,
    mass: Option<Spanned<Vec<Spanned<Table<Keys>>>>>,
}

/// `[[mass]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    name: Option<Text>,
    mass: Option<Text>,
    reciprocating_mass: Option<Text>,
    radius: Option<Text>,
    angle: Option<Text>,
    position: Option<Text>,
}

/// A mass that turns with a shaft; what is omitted is wanted.
#[derive(Clone, Debug)]
pub struct RotorMass {
    /// Its name, or its number.
    pub name: Untrusted,
    /// Mass in kilograms.
    pub mass: Option<BigRational>,
    /// The reciprocating mass at it, in kilograms; 0 where the file says nothing of it.
    pub reciprocating: BigRational,
    /// Distance of its centre of gravity from the axis in metres.
    pub radius: Option<BigRational>,
    /// Its direction.
    pub angle: Option<Turn>,
    /// Where it stands along the shaft, in metres.
    pub position: Option<BigRational>,
}

/// Masses on a shaft.
#[derive(Clone, Debug)]
pub struct Rotor {
    /// The title; the name of the file where it has none.
    pub title: Untrusted,
    /// Speed in revolutions a minute.
    pub speed: Option<BigRational>,
    /// Which part of the reciprocating masses counts as if it turned.
    pub share: BigRational,
    /// Whether the masses reciprocate on cranks, so that those of the second order count as well.
    pub secondary: bool,
    /// The masses, in the order of the file.
    pub masses: Vec<RotorMass>,
}

/// Reads a file of masses on a shaft.
///
/// # Errors
/// The first mistake, with its place and what would be right.
pub fn parse_rotor(name: &str, source: &str) -> Result<Rotor, LayoutError> {
    let file = Kind::Shaft.read::<File>(source);
    file.and_then(|file| rotor(name, file)).map_err(|error| error.in_file(name, source))
}

fn rotor(name: &str, file: File) -> Result<Rotor, LayoutError> {
    let right = "tables [[mass]] with position, mass, radius and angle each; what is to be found is omitted";
    let Some(tables) = &file.mass else { return Err(LayoutError::new("no masses on the shaft", right, None)) };
    if tables.get_ref().len() > MOST_MASSES {
        return Err(LayoutError::new("too many masses", format!("up to {MOST_MASSES} on a shaft"), place(tables)));
    }
    let masses: Vec<RotorMass> = tables
        .get_ref()
        .iter()
        .enumerate()
        .map(|(index, table)| one(index, &table.get_ref().0))
        .collect::<Result<_, _>>()?;
    if masses.is_empty() {
        return Err(LayoutError::new("no masses on the shaft", right, place(tables)));
    }
    for (index, table) in tables.get_ref().iter().enumerate() {
        let name = &masses[index].name;
        if let (Some(other), Some(text)) =
            (masses[..index].iter().position(|mass| mass.name == *name), &table.get_ref().0.name)
        {
            let message = format!("masses {} and {} have the same name `{}`", other + 1, index + 1, text.get_ref().0);
            return Err(LayoutError::new(message, "a name for one mass alone", place(text)));
        }
    }
    let reciprocating = tables.get_ref().iter().find_map(|table| table.get_ref().0.reciprocating_mass.as_ref());
    let share = match (&file.share, reciprocating) {
        (Some(text), Some(_)) => share(text)?,
        (Some(text), None) => {
            share(text)?;
            let right = "add reciprocating_mass to the masses that have one, or omit the share";
            return Err(LayoutError::new("a share without reciprocating masses", right, place(text)));
        }
        (None, None) => BigRational::zero(),
        (None, Some(text)) => {
            let right = "above the first table, which part of them is balanced: share = \"2/3\"; 0 for none";
            return Err(LayoutError::new("reciprocating masses without a share", right, place(text)));
        }
    };
    if let (Some(true), Some(text)) = (file.secondary, reciprocating) {
        let right = "with secondary = true every mass reciprocates: write it as mass, without a share";
        return Err(LayoutError::new("a reciprocating mass beside masses that reciprocate", right, place(text)));
    }
    let speed = file
        .speed
        .as_ref()
        .map(|text| value(text, "speed", units::speed).and_then(|speed| not_negative(speed, "speed", text)));
    Ok(Rotor {
        title: file.title.map_or_else(|| Untrusted::new(name), |title| title.get_ref().untrusted()),
        speed: speed.transpose()?,
        share,
        secondary: file.secondary.unwrap_or_default(),
        masses,
    })
}

fn share(text: &Text) -> Result<BigRational, LayoutError> {
    let value = parse_number(&text.get_ref().0).map_err(|error| misread(text, "share", error.to_string()))?;
    let fits = value >= BigRational::zero() && value <= BigRational::one();
    let right = "the part of the reciprocating masses that is balanced, from 0 to 1";
    if fits { Ok(value) } else { Err(misread(text, "share", right)) }
}

fn one(index: usize, keys: &Keys) -> Result<RotorMass, LayoutError> {
    let reciprocating = keys.reciprocating_mass.as_ref().map(mass).transpose()?;
    if let (Some(_), None, Some(text)) = (&reciprocating, &keys.mass, &keys.reciprocating_mass) {
        let right = "its mass that turns besides, mass = 0 where there is none";
        return Err(LayoutError::new("a reciprocating mass at a mass that is wanted", right, place(text)));
    }
    Ok(RotorMass {
        name: keys
            .name
            .as_ref()
            .map_or_else(|| Untrusted::new((index + 1).to_string()), |name| name.get_ref().untrusted()),
        mass: keys.mass.as_ref().map(mass).transpose()?,
        reciprocating: reciprocating.unwrap_or_else(BigRational::zero),
        radius: keys.radius.as_ref().map(positive_metres).transpose()?,
        angle: keys.angle.as_ref().map(known_angle).transpose()?.map(Turn::new),
        position: keys.position.as_ref().map(metres).transpose()?,
    })
}
