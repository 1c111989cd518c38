//! How is the answer printed? What a person wrote does nothing to the terminal, and a reader may leave.

use std::io::{ErrorKind, Write};

use crankstar::text::{self, harmless_but_colours};

use super::failure::Failure;
use super::{closed, progress};

/// Prints a text; a reader that has seen enough and closes the pipe is no failure.
pub fn to_stdout(text: &str) -> Result<(), Failure> {
    is_open()?;
    progress::end();
    let mut out = anstream::stdout().lock();
    match out.write_all(harmless_but_colours(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::new(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Standard output for a table, whose texts are harmless already; a reader that has seen enough takes the rest.
pub fn table_to_stdout() -> Result<impl Write + Send, Failure> {
    is_open()?;
    progress::end();
    Ok(PipeTolerant(Some(std::io::stdout())))
}

/// Nothing can be printed where the caller closed standard output.
fn is_open() -> Result<(), Failure> {
    if closed::is_closed() { Err(Failure::new("cannot write to standard output: it is closed")) } else { Ok(()) }
}

/// A reader that may leave.
struct PipeTolerant(Option<std::io::Stdout>);

impl Write for PipeTolerant {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match self.0.as_mut().map(|out| out.write_all(bytes)) {
            Some(Err(error)) if error.kind() == ErrorKind::BrokenPipe => self.0 = None,
            Some(Err(error)) => return Err(error),
            Some(Ok(())) | None => {}
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match self.0.as_mut().map(Write::flush) {
            Some(Err(error)) if error.kind() != ErrorKind::BrokenPipe => Err(error),
            Some(Err(_) | Ok(())) | None => Ok(()),
        }
    }
}

/// Tells what is odd about the input, unless nobody wants to know.
pub fn warn(text: &str) {
    if !progress::is_silent() {
        to_stderr(text);
    }
}

/// Tells why there is no answer; where nobody can be told, the exit status says it alone.
pub fn to_stderr(text: &str) {
    progress::end();
    let _ = writeln!(anstream::stderr().lock(), "{text}");
}

pub fn print_json(document: &impl serde::Serialize) -> Result<(), Failure> {
    to_stdout(&json(document)?)
}

/// A document as a text that does nothing to a terminal.
pub fn json(document: &impl serde::Serialize) -> Result<String, Failure> {
    written_json(serde_json::to_string_pretty(document))
}

/// The same of a document that is a text already.
pub fn written_json(json: serde_json::Result<String>) -> Result<String, Failure> {
    Ok(text::json(&json.map_err(Failure::new)?) + "\n")
}
