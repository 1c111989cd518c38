//! How is a shaft that twists written? `[torsion]`: discs, shafts, gears, dampers, and where the crankpins stand.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::quantities::{self, List, choice, known_angle, metres, misread, not_negative, positive, value, whole};
use super::units;
use super::written::{Table, Text, place};
use crate::engine::{
    Cycle, CycleOrder, Damper, DamperValue, ElasticShaft, Engine, Gear, Harmonic, NoShaft, Section, Steel, Torsion,
};
use crate::text::counted;

type Tables<T> = Option<Spanned<Vec<Spanned<Table<T>>>>>;

/// `[torsion]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    inertias: List,
    stiffnesses: Option<List>,
    crankpins_at: Option<List>,
    dampings: Option<List>,
    loss_factor: Option<Text>,
    magnifier: Option<Text>,
    shear_modulus: Option<Text>,
    rated_speed: Option<Text>,
    speed_range: Option<List>,
    shaft: Tables<ShaftKeys>,
    gear: Tables<GearKeys>,
    damper: Tables<DamperKeys>,
    harmonic: Tables<HarmonicKeys>,
}

/// `[[torsion.shaft]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShaftKeys {
    between: List,
    stiffness: Option<Text>,
    length: Option<Text>,
    outer_diameter: Option<Text>,
    inner_diameter: Option<Text>,
    shear_modulus: Option<Text>,
    damping: Option<Text>,
    loss_factor: Option<Text>,
    magnifier: Option<Text>,
    tensile_strength: Option<Text>,
    steel: Option<Text>,
    shape_factor: Option<Text>,
}

/// `[[torsion.gear]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GearKeys {
    between: List,
    ratio: Text,
}

/// `[[torsion.damper]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DamperKeys {
    disc: Text,
    inertia: Text,
    stiffness: Option<Text>,
    damping: Text,
}

/// `[[torsion.harmonic]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct HarmonicKeys {
    order: Text,
    torque: Text,
    phase: Option<Text>,
}

/// The shaft of an engine.
pub(super) fn read(table: &Spanned<Table<Keys>>, engine: &Engine) -> Result<Torsion, LayoutError> {
    let keys = &table.get_ref().0;
    if let Some(harmonics) = keys.harmonic.as_ref().filter(|_| engine.gas().is_some()) {
        let right = "the torque follows from [gas], or harmonics are given: leave out one of them";
        return Err(LayoutError::new("harmonics of the torque beside the gas", right, place(harmonics)));
    }
    let pins = engine.cylinders().iter().map(|cylinder| cylinder.pin + 1).max().unwrap_or(0);
    let at = match &keys.crankpins_at {
        None => (0..pins).collect(),
        Some(list) => list.get_ref().iter().map(disc).collect::<Result<_, _>>()?,
    };
    let torsion = Torsion {
        inertias: each(&keys.inertias, |text| positive(text, "moment of inertia", units::inertia))?,
        dampings: keys.dampings.as_ref().map_or(Ok(Vec::new()), |list| each(list, damping))?,
        shafts: keys.shafts()?,
        gears: all(&keys.gear, gear)?,
        dampers: all(&keys.damper, damper)?,
        pins: at,
        harmonics: keys.harmonics(engine.cycle())?,
        rated_speed: keys.rated_speed.as_ref().map(speed).transpose()?,
        speeds: keys.speed_range.as_ref().map(range).transpose()?,
    };
    match engine.pin_speeds().and_then(|speeds| torsion.check(&speeds)) {
        Ok(()) => Ok(torsion),
        Err(why) => {
            let right = match &why {
                NoShaft::Pins { given, pins } if given > pins => {
                    "a split pin counts once, and so do both pins of a pair of [boxer]; where each of them has a disc, write [[cylinder]] tables, each \
                     with a position or a pin of its own"
                }
                NoShaft::NoDisc { .. } | NoShaft::NoSuchDisc { .. } => {
                    "there are as many discs as inertias, numbered from 1 in their order"
                }
                _ => {
                    "inertias = one per disc from the free end on, stiffnesses = one between each two, crankpins_at = the disc of each crankpin, \
                     [1, 2, …] by default"
                }
            };
            Err(LayoutError::new(why.to_string(), right, keys.place(&why)))
        }
    }
}

impl Keys {
    /// The shafts of the row, and those of tables: of a shaft of the row they say more.
    fn shafts(&self) -> Result<Vec<ElasticShaft>, LayoutError> {
        let row = self.stiffnesses.as_ref();
        let row = row.map_or(Ok(Vec::new()), |list| each(list, stiffness))?;
        let mut shafts: Vec<(ElasticShaft, bool)> = Vec::new();
        for (index, stiffness) in row.into_iter().enumerate() {
            shafts.push((ElasticShaft::between([index, index + 1], stiffness), true));
        }
        for table in self.shaft.iter().flat_map(|tables| tables.get_ref()) {
            let keys = &table.get_ref().0;
            let ends = ends(&keys.between)?;
            let known = |(shaft, _): &&mut (ElasticShaft, bool)| ends == shaft.ends || [ends[1], ends[0]] == shaft.ends;
            let stiffness = keys.stiffness(self)?;
            match (shafts.iter_mut().find(known), stiffness) {
                (Some((shaft, is_bare)), None) if *is_bare => {
                    *is_bare = false;
                    keys.add_to(shaft, self)?;
                }
                (Some(_), _) => {
                    let right =
                        "a shaft has one stiffness, that of `stiffnesses` or that of its own table, and one table";
                    return Err(LayoutError::new("this shaft is written before", right, place(&keys.between)));
                }
                (None, Some(stiffness)) => {
                    let mut shaft = ElasticShaft::between(ends, stiffness);
                    keys.add_to(&mut shaft, self)?;
                    shafts.push((shaft, false));
                }
                (None, None) => {
                    let right = "give it stiffness = \"1 MN m/rad\", or length, outer_diameter and shear_modulus";
                    return Err(LayoutError::new("a shaft without a stiffness", right, place(&keys.between)));
                }
            }
        }
        let common = loss_factor(self.loss_factor.as_ref(), self.magnifier.as_ref())?;
        let mut shafts: Vec<ElasticShaft> = shafts.into_iter().map(|(shaft, _)| shaft).collect();
        if let Some(common) = common {
            let tables = || self.shaft.iter().flat_map(|tables| tables.get_ref()).map(|table| &table.get_ref().0);
            for shaft in &mut shafts {
                let own = tables().find(|keys| ends(&keys.between).is_ok_and(|ends| ends == shaft.ends));
                if own.is_none_or(|keys| keys.loss_factor.is_none() && keys.magnifier.is_none()) {
                    shaft.loss_factor.clone_from(&common);
                }
            }
        }
        Ok(shafts)
    }

    fn harmonics(&self, cycle: Option<Cycle>) -> Result<Vec<Harmonic>, LayoutError> {
        let tables = self.harmonic.as_ref().map_or(&[][..], |tables| tables.get_ref());
        let mut harmonics: Vec<Harmonic> = Vec::new();
        for table in tables {
            let keys = &table.get_ref().0;
            let written = &keys.order.get_ref().0;
            let refuse = |right: &str| misread(&keys.order, "order", right);
            let order: CycleOrder = written.parse().map_err(|error| refuse(&format!("{error}")))?;
            if cycle.is_some_and(|cycle| !order.exists_in(cycle)) {
                return Err(refuse("a two-stroke engine has whole orders alone"));
            }
            if harmonics.iter().any(|known| known.order == order) {
                return Err(refuse("each order once"));
            }
            let Some(phase) = keys.phase.as_ref().map(known_angle).transpose()? else {
                if tables.len() == 1 {
                    harmonics.push(Harmonic { order, torque: torque(&keys.torque)?, phase: BigRational::zero() });
                    continue;
                }
                let right = "phase = 30: the torque of a cylinder is torque · cos(order · ψ + phase), ψ its crank angle after firing";
                return Err(LayoutError::new("several orders are added, and one has no phase", right, place(table)));
            };
            harmonics.push(Harmonic { order, torque: torque(&keys.torque)?, phase });
        }
        harmonics.sort_by_key(|harmonic| harmonic.order);
        Ok(harmonics)
    }

    /// Where in the file a shaft is wrong.
    fn place(&self, why: &NoShaft) -> Option<std::ops::Range<usize>> {
        let item = |list: &List, number: usize| list.get_ref().get(number - 1).map_or_else(|| place(list), place);
        let discs = || place(&self.inertias);
        fn table<T>(tables: &Tables<T>, number: usize) -> Option<std::ops::Range<usize>> {
            let tables = tables.as_ref()?;
            tables.get_ref().get(number - 1).map_or_else(|| place(tables), place)
        }
        fn key<T>(
            tables: &Tables<T>,
            number: usize,
            of: fn(&T) -> Option<std::ops::Range<usize>>,
        ) -> Option<std::ops::Range<usize>> {
            let named = tables.as_ref().and_then(|tables| of(&tables.get_ref().get(number - 1)?.get_ref().0));
            named.or_else(|| table(tables, number))
        }
        let row = self.stiffnesses.as_ref().map_or(0, |list| list.get_ref().len());
        let shaft = |number: usize| match &self.stiffnesses {
            Some(list) if number <= row => item(list, number),
            _ => table(&self.shaft, number.saturating_sub(row).max(1)).or_else(discs),
        };
        match why {
            NoShaft::Stiffnesses { .. } => self.stiffnesses.as_ref().map_or_else(discs, place),
            NoShaft::Dampings { .. } => self.dampings.as_ref().map_or_else(discs, place),
            NoShaft::NotPositive("stiffness of shaft", number) | NoShaft::Ring("shaft", number) => shaft(*number),
            NoShaft::NotPositive("moment of inertia of disc", number) => item(&self.inertias, *number),
            NoShaft::Negative("damping of disc", number) => self.dampings.as_ref().and_then(|list| item(list, *number)),
            NoShaft::Hollow(_) => self.shaft.as_ref().map_or_else(discs, place),
            NoShaft::Negative(_, number) | NoShaft::NotPositive(_, number) => table(&self.damper, *number),
            NoShaft::NoRatio(number) => key(&self.gear, *number, |keys| place(&keys.ratio)),
            NoShaft::Ring(_, number) => table(&self.gear, *number),
            NoShaft::NoDisc { what: ("shaft", number), .. } => shaft(*number),
            NoShaft::NoDisc { what: ("gear", number), .. } => key(&self.gear, *number, |keys| place(&keys.between)),
            NoShaft::NoDisc { what: (_, number), .. } => key(&self.damper, *number, |keys| place(&keys.disc)),
            NoShaft::Apart(number) => item(&self.inertias, *number),
            NoShaft::Discs(_) => discs(),
            NoShaft::Pins { .. } | NoShaft::NoSuchDisc { .. } | NoShaft::Geared { .. } | NoShaft::OfTwoCranks(_) => {
                self.crankpins_at.as_ref().map_or_else(discs, place)
            }
        }
    }
}

impl ShaftKeys {
    /// Its stiffness, given or `G π (d⁴ − d_i⁴) / 32 L`; none where neither it nor a length is given.
    fn stiffness(&self, of_all: &Keys) -> Result<Option<BigRational>, LayoutError> {
        let given = self.stiffness.as_ref();
        let given = given.map(stiffness).transpose()?;
        let Some(length) = &self.length else { return Ok(given) };
        if given.is_some() {
            let right = "a shaft has a stiffness, or a length from which it follows";
            return Err(LayoutError::new("a length beside a stiffness", right, place(length)));
        }
        let Some(section) = self.section()? else {
            let right = "outer_diameter, and inner_diameter of a bore";
            return Err(LayoutError::new("a length without a diameter", right, place(length)));
        };
        let modulus = self.shear_modulus.as_ref().or(of_all.shear_modulus.as_ref()).ok_or_else(|| {
            let right = "shear_modulus = \"80 GPa\": steels have 79 to 83, which moves a frequency by 2.5 %";
            LayoutError::new("a length without the shear modulus", right, place(length))
        })?;
        let modulus = positive(modulus, "shear modulus", units::stress)?;
        let metres = positive(length, "length", units::metres)?;
        let fourth = |length: &BigRational| length * length * length * length;
        let over = BigRational::from_integer(BigInt::from(32)) * metres;
        let hollow = fourth(&section.outer) - fourth(&section.inner);
        Ok(Some(modulus * units::pi() * hollow / over))
    }

    fn section(&self) -> Result<Option<Section>, LayoutError> {
        let inner = self.inner_diameter.as_ref().map(metres).transpose()?;
        match (&self.outer_diameter, &self.inner_diameter) {
            (Some(outer), _) => {
                let outer = positive(outer, "diameter", units::metres)?;
                Ok(Some(Section { outer, inner: inner.unwrap_or_default() }))
            }
            (None, Some(inner)) => {
                Err(LayoutError::new("a bore without an outer diameter", "add outer_diameter", place(inner)))
            }
            (None, None) => Ok(None),
        }
    }

    fn add_to(&self, shaft: &mut ElasticShaft, of_all: &Keys) -> Result<(), LayoutError> {
        shaft.section = self.section()?;
        shaft.steel = self.steel(of_all)?;
        if let Some(factor) = loss_factor(self.loss_factor.as_ref(), self.magnifier.as_ref())? {
            shaft.loss_factor = factor;
        }
        if let Some(text) = &self.damping {
            shaft.damping = damping(text)?;
        }
        Ok(())
    }

    /// The steel of a shaft whose permissible stress is asked for.
    fn steel(&self, of_all: &Keys) -> Result<Option<Steel>, LayoutError> {
        let given = [&self.tensile_strength, &self.steel, &self.shape_factor];
        let (Some(strength), Some(steel), Some(shape)) = (&self.tensile_strength, &self.steel, &self.shape_factor)
        else {
            let right = "tensile_strength = \"560 MPa\", steel = \"carbon\" or \"alloy\", and shape_factor, the c_K of IACS UR M68: 1 with \
                         forged flanges, 0.6 with a keyway, 0.55 of a propeller shaft";
            return match given.into_iter().flatten().next() {
                None => Ok(None),
                Some(one) => Err(LayoutError::new("a permissible stress needs three keys", right, place(one))),
            };
        };
        if self.outer_diameter.is_none() {
            let right = "add outer_diameter, on which the permissible stress depends";
            return Err(LayoutError::new("a steel without a diameter", right, place(strength)));
        }
        if of_all.rated_speed.is_none() {
            let right =
                "add rated_speed = \"127 rpm\" below [torsion]: the permissible stress depends on the speed over that";
            return Err(LayoutError::new("a permissible stress without the rated speed", right, place(strength)));
        }
        let words = [("carbon", false), ("alloy", true)];
        let is_alloy = choice(steel, "steel", "\"carbon\" or \"alloy\"", &words)?;
        Ok(Some(Steel {
            tensile_strength: positive(strength, "tensile strength", units::stress)?,
            is_alloy,
            shape_factor: positive(shape, "shape factor", plain)?,
        }))
    }
}

fn gear(keys: &GearKeys) -> Result<Gear, LayoutError> {
    Ok(Gear { ends: ends(&keys.between)?, ratio: value(&keys.ratio, "ratio", plain)? })
}

fn damper(keys: &DamperKeys) -> Result<Damper, LayoutError> {
    let setting = |text: &Text, read: fn(&Text) -> Result<BigRational, LayoutError>| match text.get_ref().0.trim() {
        "best" => Ok(DamperValue::Best),
        _ => read(text).map(DamperValue::Given).map_err(|error| {
            let right = format!("{}; or \"best\", by the textbook's formula", error.right());
            LayoutError::new(error.message(), right, error.span())
        }),
    };
    Ok(Damper {
        disc: disc(&keys.disc)?,
        inertia: positive(&keys.inertia, "moment of inertia", units::inertia)?,
        stiffness: keys.stiffness.as_ref().map(|text| setting(text, stiffness)).transpose()?,
        damping: setting(&keys.damping, damping)?,
    })
}

/// η, or 1 over the magnifier.
fn loss_factor(factor: Option<&Text>, magnifier: Option<&Text>) -> Result<Option<BigRational>, LayoutError> {
    match (factor, magnifier) {
        (Some(_), Some(text)) => {
            let right = "one of them: the magnifier is 1 over the loss factor";
            Err(LayoutError::new("a loss factor and a magnifier", right, place(text)))
        }
        (Some(text), None) => not_negative(value(text, "loss factor", plain)?, "loss factor", text).map(Some),
        (None, Some(text)) => positive(text, "magnifier", plain).map(|magnifier| Some(magnifier.recip())),
        (None, None) => Ok(None),
    }
}

fn range(list: &List) -> Result<[BigRational; 2], LayoutError> {
    let [from, to] = list.get_ref().as_slice() else {
        let message = format!("{} for a range of speeds", counted(list.get_ref().len(), "value"));
        return Err(LayoutError::new(message, "two, such as [\"40 rpm\", \"127 rpm\"]", place(list)));
    };
    let (from, to) = (speed(from)?, speed(to)?);
    match from < to {
        true => Ok([from, to]),
        false => Err(LayoutError::new("a range of speeds that does not rise", "[lowest, highest]", place(list))),
    }
}

fn stiffness(text: &Text) -> Result<BigRational, LayoutError> {
    positive(text, "stiffness", units::torsional_stiffness)
}

fn damping(text: &Text) -> Result<BigRational, LayoutError> {
    not_negative(value(text, "damping", units::torsional_damping)?, "damping", text)
}

fn speed(text: &Text) -> Result<BigRational, LayoutError> {
    positive(text, "speed", units::speed)
}

fn torque(text: &Text) -> Result<BigRational, LayoutError> {
    positive(text, "torque", units::torque)
}

fn plain(text: &str) -> Result<BigRational, String> {
    quantities::plain(text, "0.02")
}

/// The numbers of two discs, from 1 in the file.
fn ends(list: &List) -> Result<[usize; 2], LayoutError> {
    let [from, to] = list.get_ref().as_slice() else {
        let message = format!("{} for the discs at two ends", counted(list.get_ref().len(), "value"));
        return Err(LayoutError::new(message, "two, such as between = [6, 7]", place(list)));
    };
    Ok([disc(from)?, disc(to)?])
}

/// The number of a disc, from 1 in the file.
fn disc(text: &Text) -> Result<usize, LayoutError> {
    Ok(whole(text, "number of the disc")? as usize - 1)
}

fn each(list: &List, read: fn(&Text) -> Result<BigRational, LayoutError>) -> Result<Vec<BigRational>, LayoutError> {
    list.get_ref().iter().map(read).collect()
}

fn all<T, U>(tables: &Tables<T>, of: fn(&T) -> Result<U, LayoutError>) -> Result<Vec<U>, LayoutError> {
    tables.iter().flat_map(|tables| tables.get_ref()).map(|table| of(&table.get_ref().0)).collect()
}
