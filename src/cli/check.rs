//! `check`: do the claims of a file hold?

use std::path::{Path, PathBuf};

use crankstar::claim::{Claim, Claims, TableVerdict, readable_claims};
use crankstar::engine::Engine;
use crankstar::file::{self, FileResolver};
use crankstar::report;

use super::failure::Failure;
use super::layouts;
use super::pages::Pages;

/// Arguments of `check`.
#[derive(clap::Args)]
pub struct Check {
    /// The claims file (TOML)
    file: PathBuf,
    #[command(flatten)]
    pages: Pages,
}

impl Check {
    /// Prints each claim with its answer, and writes the page into the folder; the exit status is 1 where one does not hold or cannot be read.
    pub fn run(&self) -> Result<u8, Failure> {
        let name = layouts::shown(&self.file);
        let text = layouts::read_text(&self.file)?;
        let folder = self.file.parent().unwrap_or(Path::new(""));
        let (claims, unread) = readable_claims(&name, &text, &|engine| find(folder, engine))?;
        self.pages.show(&report::claims_answer(&claims), || report::claims_page(&claims), Vec::new)?;
        unread.map_or_else(|| Ok(u8::from(!all_hold(&claims))), |mistakes| Err(mistakes.into()))
    }
}

fn all_hold(claims: &Claims) -> bool {
    let claimed = claims.statements.iter().flat_map(|statement| &statement.claims);
    let all_true = claimed.map(Claim::answer).all(|answer| answer.status.holds());
    all_true && claims.judged_tables().iter().all(TableVerdict::holds)
}

/// An engine of the catalogue, or a layout file beside the claims file.
fn find(folder: &Path, engine: &str) -> Result<Engine, String> {
    if let Some(entry) = file::find(engine) {
        return entry.engine().map_err(|error| error.to_string());
    }
    let path = folder.join(engine);
    let text = layouts::read_text(&path).map_err(|failure| failure.message().to_owned())?;
    let read = |name: &str| layouts::beside(&path, name);
    let engine_of = file::parse_beside(&layouts::shown(&path), &text, FileResolver::new(&read));
    engine_of.map_err(|error| format!("in `{engine}`: {}", error.message()))
}
