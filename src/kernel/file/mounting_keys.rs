//! How is an engine on its mounts written? `[block]`: mass, inertia, centre of gravity; `[[mount]]`: place, stiffness, damping.

use std::ops::Range;

use num_rational::BigRational;
use num_traits::Zero;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities::{List, known_angle, mass, metres, plain, texts, value};
use super::units;
use super::written::{Column, Table, Text, Values, place};
use crate::engine::{Block, Convention, Mount, Mounting, NoMounting};

/// `[block]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BlockKeys {
    mass: Text,
    inertia: List,
    products_of_inertia: Option<List>,
    tensor_entries: Option<List>,
    centre: List,
    point: Option<List>,
}

/// `[[mount]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MountKeys {
    place: List,
    stiffness: Column,
    damping: Option<Column>,
    loss_factor: Option<Text>,
    turned: Option<List>,
}

type Three = [BigRational; 3];
type Mounts = Spanned<Vec<Spanned<Table<MountKeys>>>>;

/// Body and mounts, in the sense of rotation; none where the file has neither.
pub(super) fn read(
    block: Option<&Spanned<Table<BlockKeys>>>,
    mounts: Option<&Mounts>,
    convention: Convention,
) -> Result<Option<Mounting>, LayoutError> {
    let (block, mounts) = match (block, mounts) {
        (None, None) => return Ok(None),
        (Some(block), None) => {
            let right = "add a table [[mount]] for each mount, with place and stiffness";
            return Err(LayoutError::new("a [block] without mounts", right, place(block)));
        }
        (None, Some(mounts)) => {
            let right = "add [block] with mass, inertia and centre";
            return Err(LayoutError::new("mounts without a [block]", right, place(mounts)));
        }
        (Some(block), Some(mounts)) => (block, mounts),
    };
    let keys = &block.get_ref().0;
    let tables = mounts.get_ref();
    let mounting = Mounting {
        block: keys.read(convention)?,
        mounts: tables.iter().map(|table| table.get_ref().0.read(convention)).collect::<Result<_, _>>()?,
    };
    mounting.check().map_err(|why| {
        let why = as_drawn(why, convention);
        LayoutError::new(why.to_string(), right(&why), span(&why, keys, mounts))
    })?;
    Ok(Some(mounting))
}

/// With a direction as the file counts it.
fn as_drawn(why: NoMounting, convention: Convention) -> NoMounting {
    let NoMounting::OneLine(line) = why else { return why };
    let [x, y, z] = *line;
    let line = [x, convention.in_the_sense_of_rotation(y), z];
    // Its longest part, 1 or −1 now, is 1.
    let turned = line.iter().any(|part| *part == BigRational::from_integer((-1).into()));
    NoMounting::OneLine(Box::new(if turned { line.map(|part| -part) } else { line }))
}

fn right(why: &NoMounting) -> &'static str {
    match why {
        NoMounting::Mounts(_) => "one table [[mount]] for each mount",
        NoMounting::Mass => "the mass of all that stands on the mounts",
        NoMounting::NotPositiveDefinite | NoMounting::Triangle(_) => {
            "inertia = [I_xx, I_yy, I_zz] about the centre of gravity; z is along the crankshaft"
        }
        NoMounting::Products => "are the products about the centre of gravity, and in the unit of the moments?",
        NoMounting::Stiffness(_) => {
            "a stiffness above 0 along each of the three axes of the mount, such as \"220 kN/m\""
        }
        NoMounting::Damping(_) => "0 or more",
        NoMounting::OnePlace | NoMounting::OneLine(_) => {
            "add a mount beside that line: all six motions of the engine have to be held"
        }
    }
}

fn span(why: &NoMounting, keys: &BlockKeys, mounts: &Mounts) -> Option<Range<usize>> {
    let mount = |number: &usize| &mounts.get_ref()[number - 1].get_ref().0;
    match why {
        NoMounting::Mounts(_) | NoMounting::OnePlace | NoMounting::OneLine(_) => {
            mounts.get_ref().first().and_then(place)
        }
        NoMounting::Mass => place(&keys.mass),
        NoMounting::NotPositiveDefinite | NoMounting::Triangle(_) => place(&keys.inertia),
        NoMounting::Products => keys
            .products_of_inertia
            .as_ref()
            .or(keys.tensor_entries.as_ref())
            .map_or_else(|| place(&keys.inertia), place),
        NoMounting::Stiffness(number) => place(&mount(number).stiffness),
        NoMounting::Damping(number) => {
            let keys = mount(number);
            keys.damping.as_ref().and_then(place).or_else(|| keys.loss_factor.as_ref().and_then(place))
        }
    }
}

impl BlockKeys {
    fn read(&self, convention: Convention) -> Result<Block, LayoutError> {
        if self.inertia.get_ref().len() == 6 {
            let right = "inertia = [I_xx, I_yy, I_zz], and products_of_inertia (the integrals of xy, xz, yz over the mass) or tensor_entries = [xy, xz, yz]";
            let message = "products of inertia or tensor entries? their signs differ";
            return Err(LayoutError::new(message, right, place(&self.inertia)));
        }
        let products = match (&self.products_of_inertia, &self.tensor_entries) {
            (Some(_), Some(second)) => {
                let right = "products_of_inertia, or tensor_entries of the opposite sign: one of them is enough";
                return Err(LayoutError::new("the products of inertia are given twice", right, place(second)));
            }
            (Some(list), None) => three(list, "product of inertia", inertia)?,
            (None, Some(list)) => three(list, "tensor entry", inertia)?.map(|entry| -entry),
            (None, None) => Default::default(),
        };
        let [xy, xz, yz] = products;
        let turn = |value| convention.in_the_sense_of_rotation(value);
        Ok(Block {
            mass: mass(&self.mass)?,
            moments: three(&self.inertia, "moment of inertia", inertia)?,
            products: [turn(xy), xz, turn(yz)],
            centre: point(&self.centre, "centre", convention)?,
            point: self.point.as_ref().map(|list| point(list, "point", convention)).transpose()?,
        })
    }
}

impl MountKeys {
    fn read(&self, convention: Convention) -> Result<Mount, LayoutError> {
        let loss_factor = |text: &Text| value(text, "loss factor", |text| plain(text, "0.1"));
        let turned = match &self.turned {
            None => Default::default(),
            Some(list) => three(list, "angle", known_angle)?,
        };
        let [x, y, z] = turned;
        let turn = |value| convention.in_the_sense_of_rotation(value);
        Ok(Mount {
            place: point(&self.place, "place", convention)?,
            stiffness: along(&self.stiffness, "stiffness", units::stiffness)?,
            damping: match &self.damping {
                None => Default::default(),
                Some(column) => along(column, "damping", units::damping)?,
            },
            loss_factor: self.loss_factor.as_ref().map_or_else(|| Ok(BigRational::zero()), loss_factor)?,
            // A mirror turns the sense of the angles about axes in its plane, x and z.
            turned: [turn(x), y, turn(z)],
        })
    }
}

fn inertia(text: &Text) -> Result<BigRational, LayoutError> {
    value(text, "moment of inertia", units::inertia)
}

/// x, y, z of a drawing, in the sense of rotation.
fn point(list: &List, what: &str, convention: Convention) -> Result<Three, LayoutError> {
    let [x, y, z] = three(list, what, metres)?;
    Ok([x, convention.in_the_sense_of_rotation(y), z])
}

/// Three values, along x, y and z.
fn three(
    list: &List,
    what: &str,
    read: impl Fn(&Text) -> Result<BigRational, LayoutError>,
) -> Result<Three, LayoutError> {
    let values = list.get_ref().iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let count = values.len();
    values.try_into().map_err(|_| {
        let of = if what == "product of inertia" || what == "tensor entry" { "xy, xz and yz" } else { "x, y and z" };
        LayoutError::new(format!("{count} values: {what}"), format!("three values: of {of}"), place(list))
    })
}

/// One value for all three axes of a mount, or three.
fn along(
    column: &Column,
    what: &'static str,
    unit: fn(&str) -> Result<BigRational, String>,
) -> Result<Three, LayoutError> {
    let texts = texts(column);
    let along = match column.get_ref() {
        Values::One(_) => texts.into_iter().cycle().take(3).collect(),
        Values::Each(_) => texts,
    };
    three(&List::new(column.span(), along), what, |text| value(text, what, unit))
}
