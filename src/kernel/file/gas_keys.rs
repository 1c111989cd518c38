//! How is the gas written? `[gas]`, and `[[gas.cylinder]]` for what differs in some cylinders.

use num_rational::BigRational;
use num_traits::Zero;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::file_resolver::FileResolver;
use super::gas_layers::{Keys, Layers};
use super::gas_process::{self, Settings};
use super::gas_table::{self, Reading};
use super::quantities::{choice, misread, positive_metres};
use super::units;
use super::written::{Table, Text, place};
use crate::engine::{At, Below, Chamber, Cycle, Cylinder, DeadCentre, Gas, GasMistake, Linear, PressureLaw};

/// What is taken for ambient pressure where none is given, in pascals.
const ATMOSPHERE: i64 = 101_325;

/// Reads the tables for these cylinders.
pub(super) fn read(
    table: &Spanned<Table<Keys>>,
    cylinders: &[Cylinder<Linear, Linear>],
    cycle: Option<Cycle>,
    has_links: bool,
    beside: FileResolver<'_>,
) -> Result<Gas, LayoutError> {
    let all = &table.get_ref().0;
    let Some(cycle) = cycle else {
        let right = "add cycle = \"four-stroke\" or \"two-stroke\" above the tables; a compressor works in two-strokes";
        return Err(LayoutError::new("pressures repeat with the cycle, which is missing", right, place(table)));
    };
    if let Some(list) = &all.cylinders {
        let right = "[gas] is of all cylinders; for some of them write [[gas.cylinder]]";
        return Err(LayoutError::new("cylinders are named in [gas]", right, place(list)));
    }
    let unlike = all.cylinder.as_ref().map_or(&[][..], |list| list.get_ref());
    // A form leaves its cylinders without names, which are their numbers then.
    let name = |(index, name): (usize, &String)| if name.is_empty() { (index + 1).to_string() } else { name.clone() };
    let names: Vec<String> = cylinders.iter().map(|cylinder| &cylinder.name).enumerate().map(name).collect();
    let owners = owners(unlike, &names)?;
    let mut laws: Vec<PressureLaw> = Vec::new();
    let mut known: Vec<Option<Vec<Chamber>>> = vec![None; unlike.len() + 1];
    let mut chambers = Vec::new();
    for (index, (cylinder, owner)) in cylinders.iter().zip(owners).enumerate() {
        let own = owner.map(|index| &unlike[index]);
        let layers =
            Layers { own: own.map(|table| &table.get_ref().0), all, span: own.map_or_else(|| place(table), place) };
        let slot = owner.map_or(0, |index| index + 1);
        let of_table = match &known[slot] {
            Some(of_table) => of_table,
            None => known[slot].insert(layers.chambers((cycle, &names), beside, &mut laws)?),
        };
        let is_offset = cylinder.mechanism.as_ref().is_some_and(|mechanism| !mechanism.is_centric());
        if layers.pick(|keys| &keys.dead_centre).is_none() && (has_links || is_offset) {
            let right = "dead_centre = \"crank\", where the crank points along the axis, or \"piston\", where the piston is farthest out";
            let what = if has_links { "articulated rods the crank and a" } else { "an offset the crank and the" };
            let message =
                format!("with {what} piston have dead centres of their own, and angles count from one of them");
            return Err(LayoutError::new(message, right, layers.span));
        }
        // A table of pressures may have a column of each cylinder.
        let mut chamber = of_table[index % of_table.len()].clone();
        if cylinder.shared.is_some() {
            if layers.pick(|keys| &keys.dead_centre).is_none() {
                // Those of two cranks are apart by the lead; what both pistons compress is least between them.
                chamber.zero = DeadCentre::Piston;
            }
            if chamber.below.is_some() {
                let right = "leave the pressure below the piston and piston_rod out: opposed pistons work between them";
                return Err(LayoutError::new("double-acting pistons in a shared cylinder", right, layers.span));
            }
            let number = |cylinder: &Cylinder<Linear, Linear>| cylinder.shared.map(|shared| shared.number);
            let first = cylinders[..index].iter().position(|other| number(other) == number(cylinder));
            if let Some(first) = first.filter(|&first| chambers[first] != chamber) {
                let message =
                    format!("pistons {} and {} share a cylinder, and its gas differs", names[first], names[index]);
                let right = "one bore and one pressure: name both in one [[gas.cylinder]], or neither";
                return Err(LayoutError::new(message, right, layers.span));
            }
        }
        chambers.push(chamber);
    }
    Ok(Gas { laws, chambers })
}

/// For each cylinder, which of the tables `[[gas.cylinder]]` it is named in.
fn owners(unlike: &[Spanned<Table<Keys>>], names_of: &[String]) -> Result<Vec<Option<usize>>, LayoutError> {
    let mut owners = vec![None; names_of.len()];
    for (index, table) in unlike.iter().enumerate() {
        let keys = &table.get_ref().0;
        if let Some(list) = &keys.cylinder {
            return Err(LayoutError::new(
                "a table of a cylinder within one",
                "[[gas.cylinder]] below [gas]",
                place(list),
            ));
        }
        let Some(names) = keys.cylinders.as_ref().filter(|names| !names.get_ref().is_empty()) else {
            let right = "add cylinders = [2, 3]: the names of those it is about";
            return Err(LayoutError::new("a table of cylinders that it does not name", right, place(table)));
        };
        for name in names.get_ref() {
            let Some(cylinder) = names_of.iter().position(|known| *known == name.get_ref().0) else {
                let names: Vec<&str> = names_of.iter().take(24).map(String::as_str).collect();
                return Err(misread(name, "cylinder", format!("one of {}", names.join(", "))));
            };
            if owners[cylinder].replace(index).is_some() {
                let message = format!("two tables of cylinder {}", names_of[cylinder]);
                return Err(LayoutError::new(message, "one table says all that differs in it", place(name)));
            }
        }
    }
    Ok(owners)
}

impl Layers<'_> {
    /// That of all cylinders of the table, or those of all cylinders of the engine.
    fn chambers(
        &self,
        (cycle, names): (Cycle, &[String]),
        beside: FileResolver<'_>,
        laws: &mut Vec<PressureLaw>,
    ) -> Result<Vec<Chamber>, LayoutError> {
        let Some(bore) = self.pick(|keys| &keys.bore) else {
            let right = "add bore = \"86 mm\"";
            return Err(LayoutError::new("gas in a cylinder without a bore", right, self.span.clone()));
        };
        let ambient = self.pressure(|keys| &keys.ambient)?;
        let crankcase = self.pressure(|keys| &keys.crankcase)?.or_else(|| ambient.clone());
        let assumed = BigRational::from_integer(ATMOSPHERE.into());
        let ambient = ambient.unwrap_or_else(|| assumed.clone());
        let chamber = Chamber {
            bore: positive_metres(bore)?,
            crankcase_assumed: crankcase.is_none(),
            crankcase: crankcase.unwrap_or(assumed),
            law: 0,
            zero: self.pick(|keys| &keys.dead_centre).map_or(Ok(DeadCentre::Crank), dead_centre)?,
            below: None,
        };
        let mut known = |law: PressureLaw| {
            law.check(cycle).map_err(|mistake| self.told(mistake))?;
            let index = laws.iter().position(|known| *known == law).unwrap_or(laws.len());
            if index == laws.len() {
                laws.push(law);
            }
            Ok::<_, LayoutError>(index)
        };
        let above = self.laws((cycle, names), beside, &ambient)?;
        let above = above.into_iter().map(&mut known).collect::<Result<Vec<_>, _>>()?;
        let below = self.below((cycle, names), beside, &ambient, &chamber.bore)?;
        let below = below.into_iter().map(|(rod, law)| Ok(Below { law: known(law)?, rod }));
        let below = below.collect::<Result<Vec<_>, LayoutError>>()?;
        let one = |index: usize| Chamber {
            law: above[index % above.len()],
            below: (!below.is_empty()).then(|| below[index % below.len()].clone()),
            ..chamber.clone()
        };
        Ok((0..above.len().max(below.len())).map(one).collect())
    }

    /// The diameter of the piston rod with the pressure below the piston: none of a single-acting cylinder, one of all, or one of each.
    fn below(
        &self,
        of: (Cycle, &[String]),
        beside: FileResolver<'_>,
        ambient: &BigRational,
        bore: &BigRational,
    ) -> Result<Vec<(BigRational, PressureLaw)>, LayoutError> {
        let (keys, rod) = (self.says(is_double_acting), self.pick(|keys| &keys.piston_rod));
        let (Some(keys), Some(rod)) = (keys, rod) else {
            let right = "a double-acting cylinder has both: piston_rod = \"50 mm\", and below_table or below_pressure = [[0, \"1.5 bar\"], [360, \"1.5 bar\"]]";
            return match (keys, rod) {
                (Some(_), _) => Err(LayoutError::new(
                    "a pressure below the piston without the diameter of the piston rod",
                    right,
                    self.span.clone(),
                )),
                (_, Some(rod)) => {
                    Err(LayoutError::new("a piston rod without a pressure below the piston", right, place(rod)))
                }
                (None, None) => Ok(Vec::new()),
            };
        };
        let metres = positive_metres(rod)?;
        if metres >= *bore {
            return Err(misread(rod, "piston rod", "a diameter below that of the bore"));
        }
        let reading = self.reading(ambient)?;
        let tables = match (&keys.below_table, &keys.below_pressure) {
            (Some(path), None) => gas_table::beside(path, beside, &reading, of)?,
            (None, Some(rows)) => vec![gas_table::inline(rows, &reading, of.0)?],
            (_, rows) => {
                let right = "one of below_table and below_pressure is enough";
                let span = rows.as_ref().and_then(place);
                return Err(LayoutError::new("the pressure below the piston is given twice", right, span));
            }
        };
        Ok(tables.into_iter().map(|table| (metres.clone(), PressureLaw::Table(table))).collect())
    }

    fn laws(
        &self,
        (cycle, names): (Cycle, &[String]),
        beside: FileResolver<'_>,
        ambient: &BigRational,
    ) -> Result<Vec<PressureLaw>, LayoutError> {
        let says = |keys: &Keys| keys.table.is_some() || keys.pressure.is_some() || keys.process.is_some();
        let Some(keys) = self.says(says) else {
            let right = "add process = \"spark-ignition\", \"diesel\" or \"compressor\", table = \"indicator.csv\", or pressure = [[angle, pressure], …]";
            return Err(LayoutError::new("gas without a pressure", right, self.span.clone()));
        };
        let twice = |span| {
            let right = "one of table, pressure and process is enough";
            Err(LayoutError::new("the pressure is given twice", right, span))
        };
        match (&keys.table, &keys.pressure, &keys.process) {
            (Some(path), None, None) => {
                let reading = self.reading(ambient)?;
                self.only_of_a_table()?;
                let tables = gas_table::beside(path, beside, &reading, (cycle, names))?;
                Ok(tables.into_iter().map(PressureLaw::Table).collect())
            }
            (None, Some(rows), None) => {
                let reading = self.reading(ambient)?;
                self.only_of_a_table()?;
                Ok(vec![PressureLaw::Table(gas_table::inline(rows, &reading, cycle)?)])
            }
            (None, None, Some(process)) => {
                for (key, text) in [("unit", self.pick(|k| &k.unit)), ("reading", self.pick(|k| &k.reading))] {
                    if let Some(text) = text.filter(|_| self.says(is_double_acting).is_none()) {
                        let message = format!("{key} beside a process");
                        let right = "it is of tables; the pressures of a process are absolute, each with its unit";
                        return Err(LayoutError::new(message, right, place(text)));
                    }
                }
                Ok(vec![gas_process::read(process, &Settings(self), cycle)?])
            }
            (_, Some(rows), _) => twice(place(rows)),
            (Some(path), _, _) => twice(place(path)),
            (None, None, None) => unreachable!("one of the three is there"),
        }
    }

    /// Values of a process beside a table would be without effect.
    fn only_of_a_table(&self) -> Result<(), LayoutError> {
        match gas_process::KEYS.iter().find_map(|(name, key)| Some((name, self.pick(*key)?))) {
            None => Ok(()),
            Some((name, text)) => {
                let message = format!("{name} beside a table of pressures");
                Err(LayoutError::new(
                    message,
                    "it is of a process; the table has the pressures themselves",
                    place(text),
                ))
            }
        }
    }

    fn reading(&self, ambient: &BigRational) -> Result<Reading, LayoutError> {
        let unit = self
            .pick(|keys| &keys.unit)
            .map(|text| units::pressure_unit(&text.get_ref().0).map_err(|right| misread(text, "unit", right)));
        let words = [("absolute", false), ("gauge", true)];
        let is_gauge = |text| choice(text, "reading", "\"absolute\" or \"gauge\"", &words);
        let added = match self.pick(|keys| &keys.reading).map_or(Ok(false), is_gauge)? {
            true => ambient.clone(),
            false => BigRational::zero(),
        };
        Ok(Reading { unit: unit.transpose()?, added })
    }

    /// A mistake with its place.
    pub fn told(&self, mistake: GasMistake) -> LayoutError {
        let span = match mistake.at {
            // An event of the cycle that is not written is too early for one before it.
            At::Setting(setting) => {
                let at = gas_process::KEYS.iter().position(|(name, _)| *name == setting.key());
                let written = |at: usize| gas_process::KEYS[at.min(gas_process::FIRST_EVENT)..=at].iter().rev();
                at.and_then(|at| written(at).find_map(|(_, key)| self.pick(*key))).and_then(place)
            }
            At::All | At::Row(_) => None,
        };
        LayoutError::new(mistake.message, mistake.right, span.or_else(|| self.span.clone()))
    }
}

/// Whether it says what presses on the inner side of the piston.
fn is_double_acting(keys: &Keys) -> bool {
    keys.below_table.is_some() || keys.below_pressure.is_some()
}

fn dead_centre(text: &Text) -> Result<DeadCentre, LayoutError> {
    let words = [("crank", DeadCentre::Crank), ("piston", DeadCentre::Piston)];
    choice(text, "dead centre", "\"crank\" or \"piston\"", &words)
}
