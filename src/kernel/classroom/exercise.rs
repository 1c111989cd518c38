//! What is an exercise, as far as its marking goes? Orders, students, and the engine of each, in one file for the lecturer.

use serde::Deserialize;
use serde_spanned::Spanned;

use super::draw::Draw;
use super::students::{FILE_NAMES, Student, is_file_name};
use super::vary::{Vary, escaped, quoted, varied};
use crate::engine::Engine;
use crate::file::written::{Table, Text, place, read};
use crate::file::{LayoutError, comment, parse};
use crate::text::Untrusted;

/// An exercise: the same question for everybody, each with numbers of one's own.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// The seed that the numbers were drawn with.
    pub seed: u64,
    /// The orders whose tables are asked for, rising.
    pub orders: Vec<u32>,
    /// The students.
    pub pupils: Vec<Pupil>,
}

/// A student with an engine.
#[derive(Clone, Debug)]
pub struct Pupil {
    /// The name.
    pub name: Untrusted,
    /// What the files are called.
    pub file: String,
    /// The engine.
    pub engine: Engine,
}

impl Exercise {
    /// Draws an engine for each student. The same student and seed have the same engine, whoever else is in the list.
    ///
    /// The layout is one that [`can_be_set`](super::can_be_set).
    ///
    /// # Errors
    /// What is wrong with an engine that was drawn, with its layout.
    pub fn draw(
        engine: &Engine,
        orders: &[u32],
        students: &[Student],
        seed: u64,
        vary: Vary,
    ) -> Result<Self, LayoutError> {
        let pupil = |student: &Student| {
            let draw = Draw::of(student.name.written(), seed);
            let layout = varied(engine, orders, vary, draw);
            let engine = parse(&format!("{}/layout.toml", student.file), &layout)?;
            Ok(Pupil { name: student.name.clone(), file: student.file.clone(), engine })
        };
        let pupils = students.iter().map(pupil).collect::<Result<_, LayoutError>>()?;
        Ok(Exercise { seed, orders: orders.to_vec(), pupils })
    }

    /// The file that `mark` reads.
    pub fn to_toml(&self) -> String {
        let orders: Vec<String> = self.orders.iter().map(u32::to_string).collect();
        let mut text = comment(HEAD) + &format!("seed = \"{}\"\norders = [{}]\n", self.seed, orders.join(", "));
        for pupil in &self.pupils {
            let layout: Vec<String> = pupil.engine.file().written().lines().map(escaped).collect();
            text.push_str(&format!(
                "\n[[student]]\nname = {}\nfile = {}\nlayout = \"\"\"\n{}\n\"\"\"\n",
                quoted(pupil.name.written()),
                quoted(&pupil.file),
                layout.join("\n"),
            ));
        }
        text
    }
}

const HEAD: &str = "Who has which engine: what `crankstar mark` needs besides the tables that are handed in.\nFor the lecturer, not for students.";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    seed: Text,
    orders: Vec<Text>,
    student: Option<Vec<Spanned<Table<StudentTable>>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StudentTable {
    name: Text,
    file: Text,
    layout: Text,
}

/// Reads the file of an exercise.
///
/// # Errors
/// The first mistake, with its place and what would be right.
pub fn parse_exercise(name: &str, source: &str) -> Result<Exercise, LayoutError> {
    read::<File>(source).and_then(exercise).map_err(|error| error.in_file(name, source))
}

fn exercise(file: File) -> Result<Exercise, LayoutError> {
    let seed = file.seed.get_ref().0.parse();
    let seed =
        seed.map_err(|_| LayoutError::new("cannot read the seed", "a whole number, 0 or more", place(&file.seed)))?;
    let mut orders = file.orders.iter().map(crate::claim::student::order).collect::<Result<Vec<_>, _>>()?;
    orders.sort_unstable();
    orders.dedup();
    let mut pupils: Vec<Pupil> = Vec::new();
    for table in file.student.iter().flatten().map(|table| &table.get_ref().0) {
        let file = table.file.get_ref().0.clone();
        if !is_file_name(&file) {
            let message = format!("`{file}` is not a name of a student's files");
            return Err(LayoutError::new(message, FILE_NAMES, place(&table.file)));
        }
        if pupils.iter().any(|pupil| pupil.file == file) {
            let right = "each student has files of another name";
            return Err(LayoutError::new(format!("the file `{file}` comes before"), right, place(&table.file)));
        }
        let engine =
            parse("the layout", &table.layout.get_ref().0).and_then(|engine| match super::can_be_set(&engine) {
                Ok(()) => Ok(engine),
                Err(why) => {
                    Err(LayoutError::new(format!("no vector-star table: {why}"), "the layout of the exercise", None))
                }
            });
        let engine = engine.map_err(|error| {
            let right = error.right().to_owned();
            LayoutError::new(format!("in the layout of `{file}`: {}", error.message()), right, place(&table.layout))
        })?;
        pupils.push(Pupil { name: table.name.get_ref().untrusted(), file, engine });
    }
    match (orders.is_empty(), pupils.is_empty()) {
        (true, _) => Err(LayoutError::new("the exercise asks for no order", "orders = [1, 2]", None)),
        (_, true) => Err(LayoutError::new("the exercise has no students", "add a [[student]]", None)),
        (false, false) => Ok(Exercise { seed, orders, pupils }),
    }
}
