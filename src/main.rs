//! The program: reads the command line, answers, and ends with the exit status that scripts rely on.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
