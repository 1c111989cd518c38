//! Which table does a student fill in, and what is filled in? As TOML, or as lines of a spreadsheet.

use serde::Deserialize;
use serde_spanned::Spanned;

use super::convention::{Convention, KEYS, PLANE};
use super::csv;
use super::exercise::Pupil;
use super::vary::quoted;
use crate::claim::student::{Row, Sums, filled, kept, order};
use crate::claim::{Filled, SENSES, SUMS, WrittenAngle, WrittenLength};
use crate::engine::{Engine, HIGHEST_ORDER};
use crate::file::written::{Table, Text, place, read};
use crate::file::{LayoutError, comment};
use crate::proof::Quantity;
use crate::text::{Format, field};

const HOW: &str = "Write between the quotes, and hand this file in.
An angle is in degrees, \"240\", \"-30\", \"51.43\", or \"1/7 turn\"; a length is a number, \"3.16\", \"sqrt(10)\", \"2 sin 36 deg\".
Decimals are right where they are the true ones, rounded; a number without a point is taken as exact. What is 0 is 0.";
const OTHERWISE: &str =
    "Only if your convention is another than that of the sheet: sense = \"clockwise\", throws = \"reversed\",
vectors = \"swapped\" (direct and reverse), plane = the position that your moments are about.";

/// The table of a student, empty, in TOML.
pub fn toml_to_fill_in(pupil: &Pupil, orders: &[u32]) -> String {
    let mut text = comment(HOW);
    text.push_str(&format!("student = {}\nsheet = {}\n\n", quoted(pupil.name.written()), quoted(&pupil.file)));
    text.push_str(&(comment(OTHERWISE) + "[convention]\n"));
    KEYS.iter().for_each(|(key, [usual, _])| text.push_str(&format!("{key} = \"{usual}\"\n")));
    text.push_str(&format!("{PLANE} = \"\"\n"));
    for order in orders {
        text.push_str(&format!("\n[[table]]\norder = {order}\nrows = [\n"));
        for cylinder in pupil.engine.cylinders() {
            text.push_str(&format!("  {{ cylinder = {}, direct = \"\", reverse = \"\" }},\n", quoted(&cylinder.name)));
        }
        text.push_str("]\n[table.sums]\n");
        let keys = ["force_direct", "force_reverse", "moment_direct", "moment_reverse"];
        keys.iter().for_each(|key| text.push_str(&format!("{key} = \"\"\n")));
    }
    text
}

/// The columns of a table in lines.
const COLUMNS: [&str; 6] = ["sheet", "student", "order", "row", "direct", "reverse"];
/// What stands before the name of a cylinder, and before a key of the convention.
const CYLINDER: &str = "cylinder ";
const CONVENTION: &str = "convention ";

fn sum_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Moment => "sum of moments",
        Quantity::Force | Quantity::Torque | Quantity::Roll => "sum of forces",
    }
}

/// The same as lines for a spreadsheet.
pub fn csv_to_fill_in(pupil: &Pupil, orders: &[u32]) -> String {
    let mut lines = COLUMNS.join(",") + "\n";
    let mut line = |order: &str, row: &str, direct: &str| {
        let fields = [&pupil.file, &pupil.name.escaped(Format::Csv), order, row, direct, ""].map(field);
        lines.push_str(&(fields.join(",") + "\n"));
    };
    KEYS.iter().for_each(|(key, [usual, _])| line("", &format!("{CONVENTION}{key}"), usual));
    line("", &format!("{CONVENTION}{PLANE}"), "");
    for order in orders.iter().map(u32::to_string) {
        pupil.engine.cylinders().iter().for_each(|cylinder| line(&order, &format!("{CYLINDER}{}", cylinder.name), ""));
        SUMS.iter().for_each(|quantity| line(&order, sum_name(*quantity), ""));
    }
    lines
}

/// Whose table it is, as it says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Whose {
    pub sheet: Option<String>,
    pub student: Option<String>,
}

/// A table that was handed in, not read yet beyond whose it is.
pub(super) enum Handed {
    Toml(String),
    Lines(Vec<Record>),
}

/// A line of a spreadsheet about one row.
pub(super) struct Record {
    line: usize,
    order: String,
    row: String,
    values: [String; 2],
}

/// What is filled in: the convention, and the tables by their orders.
pub(super) struct Answers {
    pub convention: Convention,
    pub tables: Vec<(u32, Filled)>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    student: Option<Text>,
    sheet: Option<Text>,
    convention: Option<Table<ConventionTable>>,
    table: Option<Vec<Spanned<Table<TableKeys>>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ConventionTable {
    sense: Option<Text>,
    throws: Option<Text>,
    vectors: Option<Text>,
    plane: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TableKeys {
    order: Text,
    rows: Option<Vec<Spanned<Table<Row>>>>,
    sums: Option<Table<Sums>>,
}

/// The table of a TOML file, with whose it is; what is wrong is told with its line.
pub(super) fn in_toml(source: String) -> Result<(Whose, Handed), String> {
    let file: File = read(&source).map_err(|error| told(&error, &source))?;
    let words =
        |text: Option<Text>| text.map(|text| text.get_ref().0.trim().to_owned()).filter(|words| !words.is_empty());
    Ok((Whose { sheet: words(file.sheet), student: words(file.student) }, Handed::Toml(source)))
}

/// The tables in the lines of a spreadsheet, by whose they are, in the order of their first lines.
pub(super) fn in_lines(source: &str) -> Result<Vec<(Whose, Handed)>, String> {
    let mut lines = csv::lines(source).into_iter();
    let (number, header) = lines.next().ok_or("the file is empty")?;
    let columns = COLUMNS.map(|name| header.iter().position(|column| column.eq_ignore_ascii_case(name)));
    let [sheet, student, order, row, direct, reverse] = columns;
    let (Some(order), Some(row), Some(direct), Some(reverse), true) =
        (order, row, direct, reverse, sheet.is_some() || student.is_some())
    else {
        return Err(format!("line {number}: the columns are to be {}", COLUMNS.join(", ")));
    };
    let mut tables: Vec<(Whose, Vec<Record>)> = Vec::new();
    for (line, fields) in lines {
        let value = |column: usize| fields.get(column).cloned().unwrap_or_default();
        let words = |column: Option<usize>| column.map(value).filter(|words| !words.is_empty());
        let whose = Whose { sheet: words(sheet), student: words(student) };
        let record = Record { line, order: value(order), row: value(row), values: [value(direct), value(reverse)] };
        match tables.iter_mut().find(|(there, _)| *there == whose) {
            Some((_, records)) => records.push(record),
            None => tables.push((whose, vec![record])),
        }
    }
    Ok(tables.into_iter().map(|(whose, records)| (whose, Handed::Lines(records))).collect())
}

impl Handed {
    /// Whether nothing is filled in.
    pub fn is_empty(&self) -> bool {
        let is_blank = |text: &str| text.trim().is_empty();
        match self {
            Handed::Toml(source) => read::<File>(source).is_ok_and(|file| {
                file.table.iter().flatten().map(|table| &table.get_ref().0).all(|table| {
                    let rows = table.rows.iter().flatten().all(|row| row.get_ref().0.is_empty());
                    rows && table.sums.as_ref().is_none_or(|sums| sums.0.is_empty())
                })
            }),
            Handed::Lines(records) => {
                let rows = records.iter().filter(|record| !record.row.starts_with(CONVENTION));
                rows.flat_map(|record| &record.values).all(|value| is_blank(value))
            }
        }
    }

    /// What is filled in, of this engine.
    pub fn answers(&self, engine: &Engine) -> Result<Answers, String> {
        match self {
            Handed::Toml(source) => of_toml(source, engine).map_err(|error| told(&error, source)),
            Handed::Lines(records) => of_lines(records, engine),
        }
    }
}

fn of_toml(source: &str, engine: &Engine) -> Result<Answers, LayoutError> {
    let file: File = read(source)?;
    let mut convention = Convention::default();
    if let Some(Table(declared)) = &file.convention {
        let values = [&declared.sense, &declared.throws, &declared.vectors, &declared.plane];
        let keys = KEYS.map(|(key, _)| key).into_iter().chain([PLANE]);
        for (key, text) in keys.zip(values).filter_map(|(key, text)| Some((key, text.as_ref()?))) {
            let written = &text.get_ref().0;
            let declared = convention.declare(key, written, engine);
            declared
                .map_err(|right| LayoutError::new(format!("cannot read the {key} `{written}`"), right, place(text)))?;
        }
    }
    let mut tables: Vec<(u32, Filled)> = Vec::new();
    for table in file.table.iter().flatten().map(|table| &table.get_ref().0) {
        let order = order(&table.order)?;
        if tables.iter().any(|(there, _)| *there == order) {
            let message = format!("order {order} has a table before");
            return Err(LayoutError::new(message, "one table per order", place(&table.order)));
        }
        tables.push((order, filled(engine, table.rows.iter().flatten(), table.sums.as_ref())?));
    }
    Ok(Answers { convention, tables })
}

fn of_lines(records: &[Record], engine: &Engine) -> Result<Answers, String> {
    let mut answers = Answers { convention: Convention::default(), tables: Vec::new() };
    for Record { line, order, row, values } in records {
        let wrong = |message: String, right: &str| format!("line {line}: {message}; {right}");
        if let Some(key) = row.strip_prefix(CONVENTION) {
            let declared = answers.convention.declare(key.trim(), &values[0], engine);
            declared.map_err(|right| wrong(format!("cannot read the {key} `{}`", values[0]), &right))?;
            continue;
        }
        let number = order.parse().ok().filter(|number| (1..=HIGHEST_ORDER).contains(number));
        let number =
            number.ok_or_else(|| wrong(format!("cannot read the order `{order}`"), "a whole number, such as 1"))?;
        let place = answers.tables.iter().position(|(there, _)| *there == number);
        let place = place.unwrap_or_else(|| {
            answers.tables.push((number, Filled::default()));
            answers.tables.len() - 1
        });
        let table = &mut answers.tables[place].1;
        let name = row.strip_prefix(CYLINDER).unwrap_or(row).trim();
        let index = engine.cylinders().iter().position(|cylinder| cylinder.name == name);
        let quantity = SUMS.into_iter().find(|quantity| sum_name(*quantity) == row);
        let twice = || wrong(format!("`{row}` of order {number} has a line before"), "one line per row");
        match (quantity, index) {
            (Some(quantity), _) if table.sums.iter().any(|(there, ..)| *there == quantity) => return Err(twice()),
            (None, Some(index)) if table.phases.iter().any(|(there, ..)| *there == index) => return Err(twice()),
            _ => {}
        }
        for (sense, words) in SENSES.into_iter().zip(values).filter(|(_, words)| !words.is_empty()) {
            match (quantity, index) {
                (Some(quantity), _) => table.sums.push((quantity, sense, kept(words, WrittenLength::read(words)))),
                (None, Some(index)) => table.phases.push((index, sense, kept(words, WrittenAngle::read(words)))),
                (None, None) => {
                    let right = "cylinder and its name, sum of forces, or sum of moments";
                    return Err(wrong(format!("`{row}` is no row of the table"), right));
                }
            }
        }
    }
    Ok(answers)
}

/// A mistake in one line, with the number of the line where it stands.
fn told(error: &LayoutError, source: &str) -> String {
    let line = error.span().and_then(|span| source.get(..span.start)).map(|before| before.matches('\n').count() + 1);
    let line = line.map(|line| format!("line {line}: ")).unwrap_or_default();
    format!("{line}{}; {}", error.message(), error.right())
}
