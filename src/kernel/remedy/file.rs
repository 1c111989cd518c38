//! How is the layout file of the corrected engine written? The file as it stands, the weights of the remedy behind it, exact.
//!
//! A weight is a sum of vectors at rational angles, each before 1 or a coefficient c_k of some piston: each is a table of its own,
//! a counterweight where it turns with the crank and is a plain number, else a balancer shaft. What is written is read back and
//! judged anew, so that it is the engine that was promised.

use super::rounded::{is_of_link, leaves_little, rounded};
use super::tables::{Kept, with_tables};
use super::{Corrected, Remedy, Weight};
use crate::engine::{Counterweight, Engine};
use crate::file::{FileResolver, LayoutError, parse_beside};
use crate::order::{self, Factor};

/// What would be right where the file does not take the weights.
const RIGHT: &str = "write [crankshaft], [[counterweight]] and [[balancer]] as tables of their own, one key per line";

/// Why no file can be written.
#[derive(Clone, Debug, thiserror::Error)]
pub enum FileError {
    /// The engine was not read from a layout file.
    #[error("the engine was not read from a layout file, to which weights could be added")]
    NoFile,
    /// A weight against what links leave cannot be written in decimals that leave little enough.
    #[error(
        "shafts against what links on a master rod leave have no exact size, and no decimals leave less than 10^-6 of the load"
    )]
    OfLinks,
    /// A shaft is multiplied by a number of a crank that turns faster than the reference, which no key of a file names.
    #[error(
        "shafts against what pistons of a crankshaft leave that turns faster than the reference are sums with coefficients of its own orders, which a layout file has no key for"
    )]
    OfFasterCrank,
    /// The file with the weights behind it is not read.
    #[error("the layout file does not take the weights of the remedy; {RIGHT}: {0}")]
    Layout(Box<LayoutError>),
    /// It is read as an engine that is not the corrected one.
    #[error("the layout file does not take the weights of the remedy; {RIGHT}")]
    AnotherEngine,
}

/// A layout file with the weights of a remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CorrectedFile {
    /// What is written.
    pub text: String,
    /// Whether weights in it are decimals, as those against what links leave are; else all of them are exact.
    pub is_rounded: bool,
}

/// The layout file of the engine with the counterweights and balancer shafts of the remedy; `name` is what messages call it.
///
/// # Errors
/// Why the file cannot be written.
pub fn corrected_file(remedy: &Remedy, name: &str, beside: FileResolver<'_>) -> Result<CorrectedFile, FileError> {
    let engine = remedy.subject.engine();
    let source = engine.file().written();
    if source.trim().is_empty() {
        return Err(FileError::NoFile);
    }
    let built = &remedy.built;
    let of_links: Vec<Weight> = built.iter().map(|plane| plane.becomes.clone()).filter(is_of_link).collect();
    if of_links.iter().any(|weight| rounded(&remedy.subject, weight).is_none()) {
        return Err(FileError::OfLinks);
    }
    if built.iter().any(|plane| plane.becomes.vector.parts().keys().any(Factor::is_geared)) {
        return Err(FileError::OfFasterCrank);
    }
    let text = with_tables(remedy, source);
    let read = parse_beside(name, &text, beside).map_err(|error| FileError::Layout(Box::new(error)))?;
    match (is_meant(remedy, &read, &of_links), leaves_little(remedy, &read)) {
        (true, true) => Ok(CorrectedFile { text, is_rounded: !of_links.is_empty() }),
        (true, false) => Err(FileError::OfLinks),
        (false, _) => Err(FileError::AnotherEngine),
    }
}

/// Whether it is the corrected engine: the same but for the weights, and each sum is zero that was proved to be, unless its weights
/// were rounded.
fn is_meant(remedy: &Remedy, read: &Engine, of_links: &[Weight]) -> bool {
    let engine = remedy.subject.engine();
    let same = read.cylinders() == engine.cylinders()
        && read.dimensions() == engine.dimensions()
        && read.reference_plane() == engine.reference_plane()
        && read.geared_cranks() == engine.geared_cranks()
        && read.bearings() == engine.bearings();
    let kept = Kept::of(remedy);
    let has = |weight: &Counterweight| {
        let same = |own: &&Counterweight| {
            (&own.angle, &own.position, own.crank) == (&weight.angle, &weight.position, weight.crank)
                && own.mass_radius() == weight.mass_radius()
        };
        read.crankshaft().counterweights.iter().any(|own| same(&own))
    };
    let same = same
        && kept.counterweights.iter().all(has)
        && kept.balancers.iter().all(|shaft| read.crankshaft().balancers.contains(shaft));
    let sum = |judged: &Corrected| {
        let whole = order::all_masses(read, judged.quantity, judged.order, judged.sense);
        whole.parts().contains_key(&judged.factor) != judged.vanishes()
    };
    let is_rounded =
        |judged: &Corrected| of_links.iter().any(|weight| (weight.order, weight.sense) == (judged.order, judged.sense));
    same && remedy.corrected.iter().filter(|judged| !is_rounded(judged)).all(sum)
}
