//! The program: reads the command line, answers, and ends with the exit status that scripts rely on.

#[allow(clippy::disallowed_types)]
mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
