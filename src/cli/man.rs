//! `man`: what does the manual say? A page for the program, and one for each command.

use std::path::PathBuf;

use clap::Command;

use super::failure::Failure;
use super::layouts::shown;
use super::{folder, write};

/// Arguments of `man`.
#[derive(clap::Args)]
pub struct Man {
    /// The folder for the pages
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl Man {
    /// Writes the pages of this program.
    pub fn run(&self, program: Command) -> Result<(), Failure> {
        let mut program = program.disable_help_subcommand(true);
        program.build();
        let commands = program.get_subcommands().cloned();
        let commands: Vec<Command> = std::iter::once(program.clone()).chain(commands).collect();
        let pages = commands.into_iter().map(page).collect::<Result<Vec<_>, Failure>>()?;
        let files: Vec<(&str, &[u8])> = pages.iter().map(|(name, text)| (name.as_str(), text.as_bytes())).collect();
        folder::write_contents(&self.folder, &files)?;
        write::to_stdout(&format!("{} pages of the manual are in {}\n", pages.len(), shown(&self.folder)))
    }
}

/// The page of a command: its file, and its text.
fn page(command: Command) -> Result<(String, String), Failure> {
    let manual = clap_mangen::Man::new(command).source(concat!("crankstar ", env!("CARGO_PKG_VERSION")));
    let mut text = Vec::new();
    manual.render(&mut text).map_err(Failure::new)?;
    Ok((manual.get_filename(), with_examples(&String::from_utf8_lossy(&text))))
}

/// The examples keep their lines, which a reader of manuals would fill otherwise.
fn with_examples(page: &str) -> String {
    let Some((before, rest)) = page.split_once(".SH EXTRA\n") else { return page.to_owned() };
    let (examples, after) = rest.find("\n.SH ").map_or((rest, ""), |at| rest.split_at(at + 1));
    format!("{before}.SH EXAMPLES\n.nf\n{examples}.fi\n{after}")
}
