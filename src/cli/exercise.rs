//! `exercise`: which sheet has each student of a class, and what is right on it?

use std::path::PathBuf;

use clap::ValueEnum;

use crankstar::classroom::{self, Pupil, Scheme, Student, Vary};
use crankstar::engine::Engine;
use crankstar::page::{File, Units};
use crankstar::proof::Quantity;
use crankstar::report::{self, rising};
use crankstar::text::{Untrusted, counted};

use super::failure::Failure;
use super::orders::whole_order;
use super::pages::Pages;
use super::{layouts, progress, write};

/// Arguments of `exercise`.
#[derive(clap::Args)]
pub struct Exercise {
    /// A name of the catalogue, or the path of a layout file
    layout: PathBuf,
    /// The students: a text with one name a line
    #[arg(long, value_name = "LIST")]
    students: Option<PathBuf>,
    /// What the numbers are drawn with; another seed is another exercise
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// The orders whose tables are asked for
    #[arg(long, value_delimiter = ',', default_value = "1,2", value_parser = whole_order)]
    orders: Vec<u32>,
    /// What differs from student to student
    #[arg(long, value_enum, value_delimiter = ',', default_value = "throws,banks,spacing,masses")]
    vary: Vec<What>,
    /// What the table to fill in is written as
    #[arg(long, value_enum, default_value = "toml")]
    table: Written,
    /// The scheme that `mark` will count by, a TOML file; the sheets say how many digits it asks for
    #[arg(long, value_name = "FILE")]
    scheme: Option<PathBuf>,
    #[command(flatten)]
    pages: Pages,
}

/// What differs from student to student.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    /// The throws, dealt to the pins anew, and the crankshaft turned
    Throws,
    /// The angle between two banks
    Banks,
    /// The spacing of the cylinders
    Spacing,
    /// The mass of all pistons
    Masses,
    /// Nothing: everybody has the engine of the layout
    Nothing,
}

/// What a table to fill in is written as.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Written {
    /// TOML
    Toml,
    /// Lines for a spreadsheet
    Csv,
}

impl Written {
    fn ending(self) -> &'static str {
        match self {
            Written::Toml => "toml",
            Written::Csv => "csv",
        }
    }
}

/// The file that `mark` reads.
pub const KEY: &str = "exercise.toml";

impl Exercise {
    /// Writes sheets, solutions and tables into the folder; without one prints a sheet.
    pub fn run(&self) -> Result<(), Failure> {
        if self.pages.measures().units() != Units::Si {
            return Err(Failure::misuse("a sheet gives lengths exactly, in millimetres or spacings; omit --units"));
        }
        let vary = self.vary()?;
        let engine = &layouts::known(&self.layout, "an exercise needs")?;
        classroom::can_be_set(engine).map_err(|why| Failure::new(format!("no vector-star table: {why}")))?;
        let orders = self.orders(engine)?;
        let students = self.students()?;
        if self.pages.folder().is_none() && self.students.is_some() {
            return Err(Failure::misuse("sheets of a class need a folder; name it with --output"));
        }
        let scheme = layouts::scheme(self.scheme.as_deref())?;
        let exercise = classroom::Exercise::draw(engine, &orders, &students, self.seed, vary)?;
        if self.pages.folder().is_none() {
            let [pupil, ..] = exercise.pupils.as_slice() else { unreachable!("a list names somebody") };
            let sheet = report::exercise_sheet(pupil, &orders, &self.table_of(pupil), &scheme);
            return write::to_stdout(&self.pages.files(&sheet)?[0].text);
        }
        progress::doing("writing sheets and solutions");
        let written = self.files(&exercise, &scheme).and_then(|files| self.pages.write_files(&files));
        let namesakes = students.iter().filter(|student| student.is_namesake);
        namesakes.for_each(|student| write::warn(&namesake(student)));
        let sheets = counted(students.len(), "sheet");
        write::to_stdout(&format!("{sheets}, with solutions. Seed {}.\n{}", self.seed, written?))
    }

    fn vary(&self) -> Result<Vary, Failure> {
        let has = |what: What| self.vary.contains(&what);
        match has(What::Nothing) {
            true if self.vary.len() > 1 => Err(Failure::misuse("--vary nothing is given alone")),
            true => Ok(Vary::NOTHING),
            false => Ok(Vary {
                throws: has(What::Throws),
                banks: has(What::Banks),
                spacing: has(What::Spacing),
                masses: has(What::Masses),
            }),
        }
    }

    fn orders(&self, engine: &Engine) -> Result<Vec<u32>, Failure> {
        let orders = rising(self.orders.clone());
        match orders.iter().find(|order| !engine.pistons_have_order(Quantity::FORCE, **order)) {
            Some(order) => Err(Failure::misuse(format!(
                "order {order} does not exist: the orders of an engine whose axes meet the crankshaft are 1 and the even ones, \
                 with infinitely long rods 1 alone"
            ))),
            None => Ok(orders),
        }
    }

    /// Those of the list, or one for a sheet without a list.
    fn students(&self) -> Result<Vec<Student>, Failure> {
        let Some(list) = &self.students else {
            return Ok(vec![Student { name: Untrusted::new("sheet"), file: "sheet".to_owned(), is_namesake: false }]);
        };
        if !list.exists() && !layouts::is_standard_input(list) {
            return Err(Failure::new(format!("there is no list of students `{}`", layouts::shown(list))));
        }
        let text = layouts::read_any_text(list)?;
        classroom::students(&text).map_err(|why| Failure::new(format!("in `{}`: {why}", layouts::shown(list))))
    }

    fn table_of(&self, pupil: &Pupil) -> String {
        format!("{}.{}", pupil.file, self.table.ending())
    }

    /// The file for `mark` first, then those of each student: the sheet with its table, and the solutions apart from it.
    fn files(&self, exercise: &classroom::Exercise, scheme: &Scheme) -> Result<Vec<File>, Failure> {
        let mut files = vec![File { name: KEY.to_owned(), text: exercise.to_toml() }];
        for pupil in &exercise.pupils {
            let table = self.table_of(pupil);
            let sheet = report::exercise_sheet(pupil, &exercise.orders, &table, scheme);
            let solutions = report::exercise_solutions(pupil, &exercise.orders).map_err(Failure::new)?;
            for (folder, document) in [("sheets", sheet), ("solutions", solutions)] {
                let inside = self.pages.files(&document)?.into_iter();
                files
                    .extend(inside.map(|file| File { name: format!("{folder}/{}/{}", pupil.file, file.name), ..file }));
            }
            let text = match self.table {
                Written::Toml => classroom::toml_to_fill_in(pupil, &exercise.orders),
                Written::Csv => classroom::csv_to_fill_in(pupil, &exercise.orders),
            };
            files.push(File { name: format!("sheets/{}/{table}", pupil.file), text });
        }
        Ok(files)
    }
}

/// Two students of one name have the same numbers.
fn namesake(student: &Student) -> String {
    format!(
        "note: `{}` is in the list before; both have the same numbers, and files of other names: here `{}`",
        student.name.escaped(crankstar::text::Format::Plain),
        student.file
    )
}
