//! `mark`: how did the class do?

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use clap::ValueEnum;
use clap::builder::PossibleValue;

use crankstar::classroom::{self, HandedIn, Outcome, Scheme, StudentResult};
use crankstar::page::File;
use crankstar::{report, table};

use super::exercise::KEY;
use super::failure::Failure;
use super::pages::{self, Look};
use super::{layouts, write};

/// Arguments of `mark`.
#[derive(clap::Args)]
pub struct Mark {
    /// The folder with the tables that were handed in, or one CSV file with those of all students
    #[arg(value_name = "FOLDER|CSV")]
    handed_in: PathBuf,
    /// What `exercise` wrote for the lecturer [default: exercise.toml in the folder, or beside the CSV file]
    #[arg(long, value_name = "FILE")]
    exercise: Option<PathBuf>,
    /// The points of each entry, a TOML file; the marks tell the scheme that is used
    #[arg(long, value_name = "FILE")]
    scheme: Option<PathBuf>,
    /// What is printed, or written into the folder [default: the table of marks; into the folder markdown]
    #[arg(long, value_enum)]
    format: Option<Format>,
    #[command(flatten)]
    look: Look,
}

/// Data, or pages in any of their formats.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Page(pages::Format),
}

impl ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<Format>> = LazyLock::new(|| {
            let pages = pages::Format::value_variants().iter().copied().map(Format::Page);
            [Format::Csv].into_iter().chain(pages).collect()
        });
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Format::Csv => Some(PossibleValue::new("csv").help("One line a student")),
            Format::Page(format) => format.to_possible_value(),
        }
    }
}

/// The table of marks for a spreadsheet, beside the page.
const MARKS: &str = "marks.csv";
/// Folders nest no deeper where tables are looked for.
const DEEPEST: usize = 5;

impl Mark {
    /// Prints the table of marks, and writes the pages into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let beside = if self.handed_in.is_dir() { Some(self.handed_in.as_path()) } else { self.handed_in.parent() };
        let key = self.exercise.clone().unwrap_or_else(|| beside.unwrap_or(Path::new("")).join(KEY));
        if self.exercise.is_none() && !key.is_file() {
            let name = layouts::shown(&key);
            return Err(Failure::new(format!(
                "`{name}`, which `exercise` writes, is not there; name it with --exercise"
            )));
        }
        let exercise = classroom::parse_exercise(&layouts::shown(&key), &layouts::read_text(&key)?)?;
        let scheme = match &self.scheme {
            None => Scheme::default(),
            Some(path) => classroom::parse_scheme(&layouts::shown(path), &layouts::read_text(path)?)?,
        };
        let results = classroom::mark_class(&exercise, self.handed_in(&key)?, &scheme);
        let csv = || File { name: MARKS.to_owned(), text: table::csv(&classroom::marks_table(&results)) };
        match self.format {
            Some(Format::Csv) if self.look.folder().is_none() => return write::to_stdout(&csv().text),
            Some(Format::Page(format)) if self.look.folder().is_none() => {
                let page = report::marks_page(&exercise, &results, &scheme);
                return write::to_stdout(&self.look.files(&page, format)?[0].text);
            }
            Some(_) | None => {}
        }
        let written = self.look.write(|| match self.format {
            Some(Format::Csv) => Ok(vec![csv()]),
            format => {
                let format = match format {
                    Some(Format::Page(format)) => format,
                    Some(Format::Csv) | None => pages::Format::Markdown,
                };
                let mut files = self.look.files(&report::marks_page(&exercise, &results, &scheme), format)?;
                files.push(csv());
                files.extend(self.pages_of_students(&results, &scheme, format)?);
                Ok(files)
            }
        })?;
        write::to_stdout(&(self.look.shown(&report::marks_answer(&results, &scheme))? + &written))
    }

    /// A page for each sheet that is marked, named as the student's files are.
    fn pages_of_students(
        &self,
        results: &[StudentResult],
        scheme: &Scheme,
        format: pages::Format,
    ) -> Result<Vec<File>, Failure> {
        let mut files = Vec::new();
        for result in results {
            let (Some(pupil), Outcome::Marked(sheet)) = (result.pupil, &result.outcome) else { continue };
            let page = self.look.files(&report::marked_page(pupil, sheet, scheme), format)?;
            let ending = |file: &File| file.name.rsplit('.').next().unwrap_or_default().to_owned();
            let named = |file: File| File { name: format!("students/{}.{}", pupil.file, ending(&file)), ..file };
            files.extend(page.into_iter().map(named));
        }
        Ok(files)
    }

    /// What was handed in: every TOML and CSV file but the exercise, the scheme and earlier marks.
    fn handed_in(&self, key: &Path) -> Result<Vec<HandedIn>, Failure> {
        if !self.handed_in.is_dir() {
            let is_csv = self.handed_in.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
            if !is_csv {
                let name = layouts::shown(&self.handed_in);
                return Err(Failure::new(format!("`{name}` is neither a folder nor a CSV file")));
            }
            return Ok(vec![HandedIn {
                name: layouts::shown(&self.handed_in),
                text: Ok(layouts::read_text(&self.handed_in)?),
            }]);
        }
        let mut paths = Vec::new();
        tables(&self.handed_in, DEEPEST, &mut paths)?;
        let real = |path: &Path| path.canonicalize().ok();
        let others = [Some(key), self.scheme.as_deref()].map(|path| path.and_then(real));
        paths.retain(|path| {
            !others.contains(&real(path)) && path.file_name().is_none_or(|name| name != MARKS && name != KEY)
        });
        paths.sort();
        let handed_in = |path: PathBuf| HandedIn {
            name: layouts::shown(path.strip_prefix(&self.handed_in).unwrap_or(&path)),
            text: layouts::read_text(&path).map_err(|failure| failure.message().to_owned()),
        };
        Ok(paths.into_iter().map(handed_in).collect())
    }
}

/// TOML and CSV files below a folder, those of solutions left out; links are not followed.
fn tables(folder: &Path, deepest: usize, found: &mut Vec<PathBuf>) -> Result<(), Failure> {
    let fail =
        |error: std::io::Error| Failure::new(format!("cannot read the folder `{}`: {error}", layouts::shown(folder)));
    for entry in fs::read_dir(folder).map_err(fail)? {
        let entry = entry.map_err(fail)?;
        let (kind, path, name) = (entry.file_type().map_err(fail)?, entry.path(), entry.file_name());
        let is_table = path
            .extension()
            .is_some_and(|ending| ["toml", "csv"].iter().any(|known| ending.eq_ignore_ascii_case(known)));
        let is_hidden = name.to_string_lossy().starts_with('.');
        match (kind.is_dir(), kind.is_file() && is_table) {
            (true, _) if deepest > 0 && name != "solutions" && !is_hidden => tables(&path, deepest - 1, found)?,
            (false, true) if !is_hidden => found.push(path),
            _ => {}
        }
    }
    Ok(())
}
