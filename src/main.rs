//! The program: answers the command line, and ends with the exit status that scripts rely on.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(crankstar::cli::run(std::env::args_os()))
}
