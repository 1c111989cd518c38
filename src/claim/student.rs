//! Is a student's vector-star table right? The first wrong entry is told, and what it should be.

use num_rational::BigRational;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::file::{Find, engine};
use crate::engine::Engine;
use crate::exact::Turn;
use crate::file::written::{Table, Text, place};
use crate::file::{LayoutError, parse_number, units};
use crate::numbers::{self, Form};
use crate::order;
use crate::proof::{Quantity, Sense};
use crate::text::Untrusted;

/// A vector-star table of one order, as a student fills it in.
#[derive(Clone, Debug)]
pub struct StarTable {
    /// The engine's name or path, as written.
    pub engine: Untrusted,
    /// The engine.
    pub layout: Engine,
    /// The order k.
    pub order: u32,
    /// Phases: cylinder by index, sense, the angle written.
    pub phases: Vec<(usize, Sense, Turn)>,
    /// Lengths of sums: quantity, sense, what was written, and as a number.
    pub sums: Vec<(Quantity, Sense, String, Form)>,
}

/// The answer to a student's table.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// All entries are right; how many there are.
    Right(usize),
    /// The first wrong phase.
    WrongPhase {
        /// The cylinder by index.
        cylinder: usize,
        /// Direct or reverse.
        sense: Sense,
        /// What was written.
        written: Turn,
        /// What it should be.
        right: Turn,
    },
    /// The first wrong sum, all phases being right.
    WrongSum {
        /// Force or moment.
        quantity: Quantity,
        /// Direct or reverse.
        sense: Sense,
        /// What was written.
        written: String,
        /// The length in closed form, where there is one, and in decimals.
        right: (Option<Form>, f64),
    },
}

impl Verdict {
    /// Whether the table is right.
    pub fn holds(&self) -> bool {
        matches!(self, Verdict::Right(_))
    }
}

/// A `[[table]]` as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Written {
    layout: Text,
    order: Text,
    rows: Option<Vec<Spanned<Table<Row>>>>,
    sums: Option<Table<Sums>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    cylinder: Text,
    direct: Option<Text>,
    reverse: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sums {
    force_direct: Option<Text>,
    force_reverse: Option<Text>,
    moment_direct: Option<Text>,
    moment_reverse: Option<Text>,
}

pub(super) fn read(table: &Written, find: Find) -> Result<StarTable, LayoutError> {
    let layout = engine(&table.layout, find)?;
    if layout.faster_crank().is_some() {
        return Err(misread(
            "layout",
            &table.layout,
            "an engine whose crankshafts turn equally fast: the others have a star for each speed",
        ));
    }
    let order = table.order.get_ref().0.parse().ok().filter(|order| (1..=crate::engine::HIGHEST_ORDER).contains(order));
    let order = order.ok_or_else(|| {
        misread("order", &table.order, &format!("a whole number from 1 to {}", crate::engine::HIGHEST_ORDER))
    })?;
    let mut phases = Vec::new();
    for row in table.rows.iter().flatten().map(|row| &row.get_ref().0) {
        let name = &row.cylinder.get_ref().0;
        let index = layout.cylinders().iter().position(|cylinder| cylinder.name == *name);
        let index = index.ok_or_else(|| misread("cylinder", &row.cylinder, "the name of a cylinder of the engine"))?;
        for (sense, text) in [(Sense::Direct, &row.direct), (Sense::Reverse, &row.reverse)] {
            let Some(text) = text else { continue };
            let angle = units::angle(&text.get_ref().0).map_err(|right| misread("phase", text, &right))?;
            phases.push((index, sense, Turn::new(angle)));
        }
    }
    let mut sums = Vec::new();
    if let Some(Table(written)) = &table.sums {
        let entries = [
            (Quantity::Force, Sense::Direct, &written.force_direct),
            (Quantity::Force, Sense::Reverse, &written.force_reverse),
            (Quantity::Moment, Sense::Direct, &written.moment_direct),
            (Quantity::Moment, Sense::Reverse, &written.moment_reverse),
        ];
        for (quantity, sense, text) in entries {
            let Some(text) = text else { continue };
            let form = Form::parse(&text.get_ref().0);
            let form = form.ok_or_else(|| misread("length", text, "a number such as 4, 1.732 or \"2√3\""))?;
            sums.push((quantity, sense, text.get_ref().0.clone(), form));
        }
    }
    Ok(StarTable { engine: table.layout.get_ref().untrusted(), layout, order, phases, sums })
}

fn misread(what: &str, text: &Text, right: &str) -> LayoutError {
    LayoutError::new(format!("cannot read the {what} `{}`", text.get_ref().0), right, place(text))
}

/// Phases first, row by row, then the sums.
pub(super) fn judge(table: &StarTable) -> Verdict {
    for (cylinder, sense, written) in &table.phases {
        let right = order::phase(&table.layout.cylinders()[*cylinder], table.order, Some(*sense));
        if *written != right {
            return Verdict::WrongPhase { cylinder: *cylinder, sense: *sense, written: written.clone(), right };
        }
    }
    for (quantity, sense, written, form) in &table.sums {
        let sum = order::star(&table.layout, *quantity, table.order, Some(*sense));
        let right = match sum.vanishes() {
            true => (Some(Form::rational(BigRational::from_integer(0.into()))), 0.0),
            false => (numbers::modulus(&sum), numbers::evaluate(&sum).norm()),
        };
        if right.0.as_ref() != Some(form) && !is_rounded(written, right.1) {
            return Verdict::WrongSum { quantity: *quantity, sense: *sense, written: written.clone(), right };
        }
    }
    Verdict::Right(table.phases.len() + table.sums.len())
}

/// Whether decimals are those of a value that is not zero, rounded.
fn is_rounded(written: &str, value: f64) -> bool {
    let Some((_, places)) = written.split_once('.') else { return false };
    let Ok(number) = parse_number(written) else { return false };
    let places = i32::try_from(places.len()).unwrap_or(i32::MAX);
    let float = num_traits::ToPrimitive::to_f64(&number).unwrap_or(f64::NAN);
    value != 0.0 && float != 0.0 && (float - value).abs() <= 0.5 * 10_f64.powi(-places)
}
