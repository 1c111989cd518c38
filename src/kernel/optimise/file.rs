//! How is a layout file written with other counterweights? The file as it stands, its counterweights replaced.

use super::error::OptimiseError;
use crate::engine::{Counterweight, Engine};
use crate::file::{
    FileResolver, comment, counted_from_its_throw, counterweight_table, parse_beside, without_counterweights,
};

/// The engine with these counterweights, read back from its own file: what is written is what is measured.
///
/// # Errors
/// [`OptimiseError::File`] where the file names its counterweights in a way that this writer does not find.
pub(super) fn with_counterweights(
    (engine, beside): (&Engine, FileResolver<'_>),
    weights: &[Vec<Counterweight>],
    head: &str,
    notes: &[String],
) -> Result<Engine, OptimiseError> {
    let mut text = format!("{}{}\n", comment(head), without_counterweights(engine.file().written()).trim_end());
    for (parts, note) in weights.iter().zip(notes) {
        if !parts.is_empty() {
            text += &format!("\n{}", comment(note));
        }
        for part in parts {
            text += &counted_from_its_throw(engine, part, |part| counterweight_table(part, engine.convention()));
        }
    }
    let advice = "write [crankshaft] and [[counterweight]] as tables of their own, one key per line";
    let read = parse_beside("the new file", &text, beside).map_err(|_| OptimiseError::File(advice.to_owned()))?;
    let meant: Vec<&Counterweight> = weights.iter().flatten().collect();
    let is_meant = read.crankshaft().counterweights.iter().eq(meant)
        && read.cylinders() == engine.cylinders()
        && read.dimensions() == engine.dimensions()
        && read.bearings() == engine.bearings()
        && read.gas() == engine.gas()
        && (&read.crankshaft().pins, &read.crankshaft().webs, &read.crankshaft().balancers)
            == (&engine.crankshaft().pins, &engine.crankshaft().webs, &engine.crankshaft().balancers);
    if is_meant { Ok(read) } else { Err(OptimiseError::File(advice.to_owned())) }
}
