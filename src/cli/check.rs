//! `check`: do the claims of a file hold?

use std::path::Path;
use std::process::ExitCode;

use crankstar::claim::{Claims, parse_claims};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::report;
use crankstar::text::{Format, Untrusted};

use super::failure::Failure;
use super::{layouts, write};

/// Prints each claim with its answer; the exit status is 1 where one does not hold.
pub fn run(file: &Path) -> Result<ExitCode, Failure> {
    let name = layouts::shown(file);
    let text = layouts::read_text(file)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let claims = parse_claims(&name, &text, &|engine| find(folder, engine))?;
    let (lines, all_hold) = answers(&claims);
    write::to_stdout(&lines)?;
    Ok(if all_hold { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// An engine of the catalogue, or a layout file beside the claims file.
fn find(folder: &Path, engine: &str) -> Result<Engine, String> {
    if let Some(entry) = file::find(engine) {
        return entry.engine().map_err(|error| error.to_string());
    }
    let path = folder.join(engine);
    let text = layouts::read_text(&path).map_err(|failure| failure.message().to_owned())?;
    file::parse(&layouts::shown(&path), &text).map_err(|error| format!("in `{engine}`: {}", error.message()))
}

fn answers(claims: &Claims) -> (String, bool) {
    let plain = |text: &Untrusted| text.escaped(Format::Plain);
    let mut lines = String::new();
    let mut all_hold = true;
    for claim in claims.statements.iter().flat_map(|statement| &statement.claims) {
        let answer = claim.answer();
        all_hold &= answer.status.holds();
        let (status, finding) = (report::claim_status(&answer), report::claim_finding(&claim.statement, &answer));
        lines += &format!("{}: {}\n  {status}. {finding}\n", plain(&claim.engine), plain(&claim.says));
    }
    for (table, verdict) in claims.tables.iter().zip(claims.judged_tables()) {
        all_hold &= verdict.holds();
        let finding = report::table_finding(table, &verdict);
        lines += &format!("{}: vector-star table of order {}\n  {finding}\n", plain(&table.engine), table.order);
    }
    (lines, all_hold)
}
