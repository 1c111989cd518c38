//! `verify`: does all that documents say hold?

use std::io::Read;
use std::path::{Path, PathBuf};

use crankstar::file::Layout;
use crankstar::order::masses_as_built;
use crankstar::page;
use crankstar::proof::{AnyDocument, Checked, Counts, Difference, LARGEST_DOCUMENT, Unreadable, read_document};
use crankstar::report::{self, Question};
use crankstar::text::counted;

use serde_json::Value;

use super::failure::Failure;
use super::{layouts, write};

/// Arguments of `verify`.
#[derive(clap::Args)]
pub struct Verify {
    /// The JSON files, or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Compare the document's engine with this layout: a name of the catalogue, or the path of a layout file; of a comparison once for each engine, in their order
    #[arg(long, value_name = "LAYOUT")]
    engine: Vec<PathBuf>,
}

impl Verify {
    /// Checks a document that `classify`, `remedy`, `loads` or `compare` printed as JSON.
    pub fn run(&self) -> Result<(), Failure> {
        layouts::read_once(self.files.iter().chain(&self.engine))?;
        if let [only] = self.files.as_slice() {
            return write::to_stdout(&self.checked(only)?);
        }
        let mut refused = 0;
        for file in &self.files {
            match self.checked(file) {
                Ok(summary) => write::to_stdout(&format!("{}: {summary}", file.display()))?,
                Err(failure) => {
                    write::to_stderr(&failure.to_string());
                    refused += 1;
                }
            }
        }
        match refused {
            0 => Ok(()),
            _ => Err(Failure::new(format!("{refused} of {} documents are refused", self.files.len()))),
        }
    }

    /// What holds of one document.
    fn checked(&self, file: &Path) -> Result<String, Failure> {
        let name = if layouts::is_standard_input(file) {
            "standard input".to_owned()
        } else {
            format!("`{}`", file.display())
        };
        let json = read(file).map_err(|error| Failure::new(format!("cannot read {name}: {error}")))?;
        let is_layout = file.extension().is_some_and(|ending| ending == "toml");
        let document = read_document(&json).map_err(|error| match is_layout {
            true => Failure::new(format!(
                "{name} is named as a layout file; what is verified is a document, such as the output of `classify {} --json`",
                layouts::shown(file)
            )),
            false => unreadable(&name, &error),
        })?;
        let checked = document.check().map_err(|fault| Failure::new(format!("{name}: {fault}")))?;
        let engine = match self.engine.as_slice() {
            [] => "the engine: the document's own; --engine LAYOUT compares it with one that you trust".to_owned(),
            layouts => {
                compare_each(&name, &document, layouts)?;
                let shown: Vec<String> = layouts.iter().map(|layout| layouts::shown(layout)).collect();
                format!("the engine: that of {}", shown.join(", "))
            }
        };
        Ok(summary(&document, &checked, &engine))
    }
}

/// One byte more than is read of a document tells that it is too large.
fn read(file: &Path) -> std::io::Result<Vec<u8>> {
    let mut json = Vec::new();
    let most = LARGEST_DOCUMENT as u64 + 1;
    match layouts::is_standard_input(file) {
        true => std::io::stdin().take(most).read_to_end(&mut json)?,
        false => std::fs::File::open(file)?.take(most).read_to_end(&mut json)?,
    };
    Ok(json)
}

fn unreadable(name: &str, error: &Unreadable) -> Failure {
    match error {
        Unreadable::TooLarge(_) => Failure::new(format!("{name} is larger than 4 MiB, the limit")),
        error => Failure::new(format!(
            "{name} is not an output of `classify --json`, `remedy --json`, `loads --json`, `compare --json` or `firing --format json`: {error}"
        )),
    }
}

/// Refuses a document whose engines are not those of the layouts, one each.
fn compare_each(name: &str, document: &AnyDocument, layouts: &[PathBuf]) -> Result<(), Failure> {
    let engines = match document {
        AnyDocument::Evidence(document) => document.evidence.iter().cloned().map(AnyDocument::Classify).collect(),
        own => vec![own.clone()],
    };
    if engines.len() != layouts.len() {
        let count = counted(engines.len(), "engine");
        return Err(Failure::new(format!(
            "{name} is about {count}, and --engine names {}; name one for each, in their order",
            layouts.len()
        )));
    }
    let mut each = engines.iter().zip(layouts).enumerate();
    each.try_for_each(|(index, (engine, layout))| compare(name, engine, layout, (document, index)))
}

/// Refuses a document whose engine is not that of the layout, nor what is said of it beside the verdicts.
fn compare(name: &str, engine: &AnyDocument, layout: &Path, beside: (&AnyDocument, usize)) -> Result<(), Failure> {
    let shown = layouts::shown(layout);
    let other = |kind: &str| Failure::new(format!("{name} is about {kind}, and {shown} is not"));
    let mut beside_differs = None;
    let right = match (engine, layouts::read(layout)?) {
        (AnyDocument::Classify(own), Layout::Known(layout, _)) => {
            let mut masses = own.masses;
            if let (AnyDocument::Evidence(document), index) = beside {
                beside_differs = document.numbers_difference(index, &report::numbers_of(&layout));
                // Numbers are those of the engine as it is built; verdicts may be on some of its masses.
                masses = masses_as_built(&layout);
            }
            AnyDocument::Classify(report::document(&layout, masses, &[], &own.quantities, None))
        }
        (AnyDocument::Remedy(_), Layout::Known(layout, _)) => {
            AnyDocument::Remedy(report::remedy_engine(&layout).map_err(Failure::new)?)
        }
        (AnyDocument::Firing(own), Layout::Known(layout, _)) => {
            AnyDocument::Firing(report::firing_engine(&layout, own).map_err(Failure::new)?)
        }
        (AnyDocument::Family(_), Layout::Open(family)) => AnyDocument::Family(report::open_document(&family, &[])),
        (AnyDocument::Evidence(_), _) => unreachable!("each engine of the evidence is compared by itself"),
        (AnyDocument::Family(_), Layout::Known(..)) => return Err(other("a family with open angles or lengths")),
        (_, Layout::Open(_)) => return Err(other("an engine without unknowns")),
    };
    match engine.engine_difference(&right).or(beside_differs) {
        None => Ok(()),
        Some(Difference { place, found, right }) => {
            let said = |value: Option<Value>| value.map_or("nothing".to_owned(), |value| value.to_string());
            let words = format!("{place} is {}, in {shown} it is {}", said(found), said(right));
            Err(Failure::new(format!("{name}: the engine is not that of {shown}: {words}")))
        }
    }
}

/// Letters of a line, less what broken ones stand in by.
const WIDTH: usize = 76;

/// What holds, what it is about, and what is not covered.
fn summary(document: &AnyDocument, checked: &Checked, engine: &str) -> String {
    let Counts { polygons, residues, splittings, decimals } = checked.counts;
    let titles = document.titles();
    let title = crankstar::text::harmless(&titles.join(", "));
    let orders: Vec<String> = checked.orders.iter().map(ToString::to_string).collect();
    let quantities: Vec<&str> = checked.quantities.iter().map(|quantity| quantity.name()).collect();
    let masses: Vec<&str> = checked.masses.iter().map(|masses| masses.name()).collect();
    let about = match document {
        AnyDocument::Firing(_) => "firing stars".to_owned(),
        AnyDocument::Classify(_) | AnyDocument::Family(_) | AnyDocument::Evidence(_) => {
            format!("{} of {}", quantities.join(", "), masses.join(", "))
        }
        AnyDocument::Remedy(_) => {
            format!("{} of {}, with the weights of the remedy", quantities.join(", "), masses.join(", "))
        }
    };
    let wholes = match (checked.wholes, checked.open_wholes) {
        (0, _) => String::new(),
        (wholes, 0) => format!("{wholes} whole orders, "),
        (wholes, open) => format!("{wholes} whole orders ({open} of them not decided), "),
    };
    let mut lines = vec![
        format!("{title}: all {} certificates hold", checked.counts.certificates()),
        format!("  about: {about}"),
        format!("  orders: {}, each with all its verdicts", orders.join(", ")),
        format!("  zero: {polygons}, by polygons; not zero: {residues} by a residue, {splittings} by a splitting"),
        format!(
            "  besides: {decimals} decimals, {wholes}{} shapes, {} statements on every order",
            checked.shapes, checked.theorems
        ),
        format!("  {engine}"),
    ];
    lines.extend(checked.not_covered.iter().map(|what| format!("  not covered: {what}")));
    let wrapped = |line: &String| page::wrapped(line, WIDTH).replace('\n', "\n    ");
    lines[1..].iter_mut().for_each(|line| *line = wrapped(line));
    lines.join("\n") + "\n"
}

/// The text of a document that the checker accepts.
///
/// # Errors
/// Where it is too large for `verify`, and where it does not hold, which is a fault of this program.
pub fn proved(document: &impl serde::Serialize) -> Result<String, Failure> {
    let json = write::json(document)?;
    accepted(&json)?.map(|()| json).map_err(|why| too_large(&why))
}

fn too_large(why: &str) -> Failure {
    Failure::new(format!("the proof is larger than `verify` takes, so it is not printed: {why}; ask for fewer orders"))
}

/// The document of an answer, checked where it has certificates; without its evidence where that is too large for `verify`.
///
/// # Errors
/// See [`proved`].
pub fn checked(question: &impl Question) -> Result<String, Failure> {
    let json = write::written_json(question.json())?;
    if !question.is_certified() {
        return Ok(json);
    }
    match (accepted(&json)?, question.json_without_evidence()) {
        (Ok(()), _) => Ok(json),
        (Err(why), Some(bare)) => {
            write::warn(&format!(
                "note: the proof is larger than `verify` takes, so the document has no evidence and `verify` refuses it: {why}; ask for fewer orders"
            ));
            write::written_json(bare)
        }
        (Err(why), None) => Err(too_large(&why)),
    }
}

/// Whether `verify` takes a document, or why it is too large for it.
fn accepted(json: &str) -> Result<Result<(), String>, Failure> {
    let fault = |why: &dyn std::fmt::Display| {
        Failure::new(format!(
            "this is a fault of crankstar, so nothing is printed: its checker rejects the proof: {why}"
        ))
    };
    let read = match read_document(json.as_bytes()) {
        Ok(read) => read,
        Err(error @ (Unreadable::TooLarge(_) | Unreadable::TooManyDigits(_))) => return Ok(Err(error.to_string())),
        Err(
            error @ (Unreadable::NotJson(_) | Unreadable::NoFormat | Unreadable::Format(_) | Unreadable::Malformed(_)),
        ) => {
            return Err(fault(&error));
        }
    };
    match read.check() {
        Ok(_) => Ok(Ok(())),
        Err(error) => match error.reason {
            crankstar::proof::Reason::TooManySteps => Ok(Err(error.to_string())),
            crankstar::proof::Reason::Wrong(_) => Err(fault(&error)),
        },
    }
}
