//! `mark`: how did the class do?

use std::fs;
use std::path::{Path, PathBuf};

use crankstar::classroom::{self, Content, HandedIn, Outcome, Scheme, StudentResult};
use crankstar::page::{self, File};
use crankstar::{report, table};

use super::choice::Choices;
use super::exercise::KEY;
use super::failure::Failure;
use super::pages::{PageArgs, formats};
use super::{layouts, write};

/// Arguments of `mark`.
#[derive(clap::Args)]
pub struct Mark {
    /// The folder with the tables that were handed in, or one CSV or XLSX file with those of all students
    #[arg(value_name = "FOLDER|FILE")]
    handed_in: PathBuf,
    /// What `exercise` wrote for the lecturer [default: exercise.toml in the folder, or beside the file]
    #[arg(long, value_name = "FILE")]
    exercise: Option<PathBuf>,
    /// The points of each entry, a TOML file; the marks show the scheme used
    #[arg(long, value_name = "FILE")]
    scheme: Option<PathBuf>,
    /// What is printed, or written into the folder [default: the table of marks; into the folder markdown]
    #[arg(long, value_parser = every_format())]
    format: Option<Format>,
    #[command(flatten)]
    page: PageArgs,
}

/// Data, or pages in any of their formats.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Page(page::Format),
}

fn every_format() -> Choices<Format> {
    Choices::new([("csv", "One line a student", Format::Csv)]).and(formats().each(Format::Page))
}

/// The table of marks for a spreadsheet, beside the page.
const MARKS: &str = "marks.csv";
/// What `exercise` writes for the lecturer beside the exercise.
const SOLUTIONS: &str = "solutions";
/// Folders nest no deeper where tables are looked for.
const DEEPEST: usize = 5;

impl Mark {
    /// Prints the table of marks, and writes the pages into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let page_format = match self.format {
            Some(Format::Csv) => None,
            Some(Format::Page(format)) => Some(format),
            None => self.page.written(None),
        };
        self.page.is_said_of(page_format)?;
        if self.format == Some(Format::Csv) && self.page.folder().is_none() {
            self.page.is_said_of_data()?;
        }
        if !self.handed_in.exists() {
            return Err(Failure::new(format!("there is no file or folder `{}`", layouts::shown(&self.handed_in))));
        }
        let beside = if self.handed_in.is_dir() { Some(self.handed_in.as_path()) } else { self.handed_in.parent() };
        let key = self.exercise.clone().unwrap_or_else(|| beside.unwrap_or(Path::new("")).join(KEY));
        if self.exercise.is_none() && !key.is_file() {
            let name = layouts::shown(&key);
            return Err(Failure::new(format!(
                "`{name}`, which `exercise` writes, is not there; name it with --exercise"
            )));
        }
        let exercise = classroom::parse_exercise(&layouts::shown(&key), &layouts::read_text(&key)?)?;
        let scheme = layouts::scheme(self.scheme.as_deref())?;
        let results = classroom::mark_class(&exercise, self.handed_in(&key)?, &scheme);
        let csv = || File { name: MARKS.to_owned(), text: table::csv(&classroom::marks_table(&results)) };
        let answer = || report::marks_answer(&results, &scheme);
        match page_format {
            Some(format) => {
                let page = || report::marks_page(&exercise, &results, &scheme);
                let of_students = || self.pages_of_students(&results, &scheme, format);
                let beside = || Ok(std::iter::once(csv()).chain(of_students()?).collect());
                self.page.give(Some(format), &answer(), page, beside)
            }
            None if self.format.is_none() => write::to_stdout(&self.page.shown(&answer())?),
            None if self.page.folder().is_none() => write::to_stdout(&csv().text),
            None => {
                let written = self.page.write(|| Ok(vec![csv()]))?;
                write::to_stdout(&(self.page.shown(&answer())? + &written))
            }
        }
    }

    /// A page for each sheet that is marked, named as the student's files are.
    fn pages_of_students(
        &self,
        results: &[StudentResult],
        scheme: &Scheme,
        format: page::Format,
    ) -> Result<Vec<File>, Failure> {
        let mut files = Vec::new();
        for result in results {
            let (Some(pupil), Outcome::Marked(sheet)) = (result.pupil, &result.outcome) else { continue };
            let page = self.page.files(&report::marked_page(pupil, sheet, scheme), format)?;
            let ending = |file: &File| file.name.rsplit('.').next().unwrap_or_default().to_owned();
            let named = |file: File| File { name: format!("students/{}.{}", pupil.file, ending(&file)), ..file };
            files.extend(page.into_iter().map(named));
        }
        Ok(files)
    }

    /// What was handed in: every file of the folder but the exercise, the scheme and the pages of `mark` itself.
    fn handed_in(&self, key: &Path) -> Result<Vec<HandedIn>, Failure> {
        if !self.handed_in.is_dir() {
            let is_table =
                |ending: &str| self.handed_in.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
            let name = layouts::shown(&self.handed_in);
            if !self.handed_in.is_file() || !["csv", "xlsx"].into_iter().any(is_table) {
                return Err(Failure::new(format!("`{name}` is neither a folder nor a CSV or XLSX file")));
            }
            return Ok(vec![HandedIn { name, content: Content::Bytes(layouts::read_bytes(&self.handed_in)?) }]);
        }
        let real = |path: &Path| path.canonicalize().ok();
        let solutions = key.parent().map(|folder| folder.join(SOLUTIONS));
        let ours = [Some(key), self.scheme.as_deref(), self.page.folder()];
        let ours: Vec<PathBuf> = ours.into_iter().flatten().filter_map(real).collect();
        let mut found = Vec::new();
        files(&self.handed_in, DEEPEST, &ours, &mut found)?;
        found.sort_by(|(one, _), (other, _)| one.cmp(other));
        // A student may be called so: what is a table there is read.
        let is_solution = |path: &Path| solutions.as_ref().is_some_and(|folder| path.starts_with(folder));
        let handed_in = |(path, left_out): (PathBuf, Option<&'static str>)| {
            let name = layouts::shown(path.strip_prefix(&self.handed_in).unwrap_or(&path));
            let named = |content| HandedIn { name, content };
            let file = match left_out {
                Some(why) => named(Content::LeftOut(why)),
                None => named(Content::Bytes(Vec::new())),
            };
            match file.is_table() {
                false => (!is_solution(&path)).then_some(file),
                true => Some(HandedIn { content: content(&path), ..file }),
            }
        };
        Ok(found.into_iter().filter_map(handed_in).collect())
    }
}

/// The bytes of a table.
fn content(path: &Path) -> Content {
    match layouts::read_bytes(path) {
        Ok(bytes) => Content::Bytes(bytes),
        Err(failure) => Content::Unreadable(failure.message().to_owned()),
    }
}

/// Files below a folder but those of ours, each with why it is not looked at, where that is so.
fn files(
    folder: &Path,
    deepest: usize,
    ours: &[PathBuf],
    found: &mut Vec<(PathBuf, Option<&'static str>)>,
) -> Result<(), Failure> {
    let fail =
        |error: std::io::Error| Failure::new(format!("cannot read the folder `{}`: {error}", layouts::shown(folder)));
    for entry in fs::read_dir(folder).map_err(fail)? {
        let entry = entry.map_err(fail)?;
        let (kind, path) = (entry.file_type().map_err(fail)?, entry.path());
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        let left_out = match (kind.is_symlink(), is_hidden, kind.is_dir()) {
            (true, ..) => Some("links are not followed"),
            (false, ..) if path.canonicalize().is_ok_and(|path| ours.contains(&path)) => continue,
            (false, true, _) => Some("hidden files are not read"),
            (false, false, true) if deepest == 0 => Some("folders nested this deeply are not read"),
            (false, false, true) => {
                files(&path, deepest - 1, ours, found)?;
                continue;
            }
            (false, false, false) => (!kind.is_file()).then_some("it is not a file"),
        };
        found.push((path, left_out));
    }
    Ok(())
}
