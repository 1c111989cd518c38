//! How did the class do? A line for each student, whatever became of the sheet.

use super::exercise::{Exercise, Pupil};
use super::handed_in::HandedIn;
use super::marking::{MarkedSheet, mark_sheet};
use super::scheme::Scheme;
use super::submission::{Owner, Submission};
use crate::text::{Format, Untrusted};

/// What became of a student's sheet.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It is marked.
    Marked(Box<MarkedSheet>),
    /// It cannot be read, for this reason.
    Unreadable(Untrusted),
    /// Nothing was handed in.
    NotHandedIn,
    /// It was handed in more than once, and which one counts is not said.
    HandedInTwice,
    /// It is no table, and was not read, for this reason.
    NotRead(&'static str),
}

/// A line of the table of marks.
#[derive(Clone, Debug)]
pub struct StudentResult<'a> {
    /// The student; none of a sheet that belongs to nobody.
    pub pupil: Option<&'a Pupil>,
    /// The files that were handed in.
    pub files: Vec<Untrusted>,
    /// What became of it.
    pub outcome: Outcome,
}

/// What was found in a file, and whose it is; an index, or why it is nobody's.
struct Found {
    file: String,
    whose: Result<usize, String>,
    handed: Result<Submission, String>,
}

impl Found {
    fn is_empty(&self) -> bool {
        self.handed.as_ref().is_ok_and(Submission::is_empty)
    }
}

/// Marks all that was handed in: students in the order of the exercise, then sheets that belong to nobody, then files that are no tables.
pub fn mark_class<'a>(exercise: &'a Exercise, handed_in: Vec<HandedIn>, scheme: &Scheme) -> Vec<StudentResult<'a>> {
    let left_out = handed_in.iter().filter_map(|file| Some((file.name.clone(), file.left_out()?)));
    let left_out: Vec<(String, &'static str)> = left_out.collect();
    let handed_in = handed_in.into_iter().filter(HandedIn::is_table);
    let mut of_pupils: Vec<Vec<Found>> = exercise.pupils.iter().map(|_| Vec::new()).collect();
    let mut of_nobody = Vec::new();
    for found in handed_in.flat_map(|file| read(exercise, file)) {
        match &found.whose {
            Ok(index) => of_pupils[*index].push(found),
            Err(_) => of_nobody.push(found),
        }
    }
    let files = |found: &[Found]| found.iter().map(|found| Untrusted::new(found.file.as_str())).collect();
    let of_pupil = |(pupil, mut found): (&'a Pupil, Vec<Found>)| {
        // The table as it was given out, beside one that is filled in, is no second answer.
        if found.iter().any(|found| !found.is_empty()) {
            found.retain(|found| !found.is_empty());
        }
        let outcome = match found.as_slice() {
            [] => Outcome::NotHandedIn,
            [only] => marked(exercise, pupil, only, scheme),
            _ => Outcome::HandedInTwice,
        };
        StudentResult { pupil: Some(pupil), files: files(&found), outcome }
    };
    let mut results: Vec<StudentResult> = exercise.pupils.iter().zip(of_pupils).map(of_pupil).collect();
    results.extend(of_nobody.into_iter().map(|found| {
        let why = found.whose.as_ref().err().cloned().unwrap_or_default();
        StudentResult { pupil: None, files: files(&[found]), outcome: Outcome::Unreadable(Untrusted::new(why)) }
    }));
    results.extend(left_out.into_iter().map(|(name, why)| StudentResult {
        pupil: None,
        files: vec![Untrusted::new(name)],
        outcome: Outcome::NotRead(why),
    }));
    results
}

fn marked(exercise: &Exercise, pupil: &Pupil, found: &Found, scheme: &Scheme) -> Outcome {
    let answers =
        found.handed.as_ref().map_err(String::clone).and_then(|handed| handed.answers(&pupil.engine, &exercise.orders));
    match answers {
        Ok(answers) => Outcome::Marked(Box::new(mark_sheet(pupil, &exercise.orders, answers, scheme))),
        Err(why) => Outcome::Unreadable(Untrusted::new(why)),
    }
}

/// The tables of a file.
fn read(exercise: &Exercise, file: HandedIn) -> Vec<Found> {
    let name = file.name.clone();
    let tables = file.tables();
    match tables {
        Ok(tables) => {
            let found = |(whose, handed): (Owner, Submission)| Found {
                whose: pupil_of(exercise, &whose, &name),
                file: name.clone(),
                handed: Ok(handed),
            };
            tables.into_iter().map(found).collect()
        }
        // Whose it is its name may tell.
        Err(why) => {
            let whose = named(exercise, &name).ok_or_else(|| why.clone());
            vec![Found { file: name, whose, handed: Err(why) }]
        }
    }
}

/// The student that a table says it is of; by the name of the file where it says nothing.
fn pupil_of(exercise: &Exercise, whose: &Owner, file: &str) -> Result<usize, String> {
    let pupils = &exercise.pupils;
    let is_named = |index: usize, name: &str| {
        let pupil = &pupils[index];
        pupil.name == name || pupil.name.escaped(Format::Csv) == name
    };
    match (&whose.sheet, &whose.student) {
        (Some(sheet), student) => {
            let index = pupils.iter().position(|pupil| pupil.file == *sheet);
            let index = index.ok_or_else(|| format!("the exercise has no sheet `{sheet}`"))?;
            match student {
                Some(name) if !is_named(index, name) => {
                    Err(format!("the sheet `{sheet}` is not that of `{name}`: it has other numbers"))
                }
                Some(_) | None => Ok(index),
            }
        }
        (None, Some(name)) => {
            let named: Vec<usize> = (0..pupils.len()).filter(|index| is_named(*index, name)).collect();
            match named.as_slice() {
                [] => Err(format!("the exercise has no student `{name}`")),
                [only] => Ok(*only),
                _ => Err(format!("several students are called `{name}`; the name of the sheet distinguishes them")),
            }
        }
        (None, None) => {
            named(exercise, file).ok_or_else(|| "the table names neither its sheet nor its student".to_owned())
        }
    }
}

/// The student whose files are called like this one.
fn named(exercise: &Exercise, file: &str) -> Option<usize> {
    let last = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = last.rsplit_once('.').map_or(last, |(stem, _)| stem);
    exercise.pupils.iter().position(|pupil| pupil.file == stem)
}
