//! How is the layout file of the corrected engine written? The file as it stands, the weights of the remedy behind it, exact.
//!
//! A weight is a sum of vectors at rational angles, each before 1 or a coefficient c_k of some piston: each is a table of its own,
//! a counterweight where it turns with the crank and is a plain number, else a balancer shaft. What is written is read back and
//! judged anew, so that it is the engine that was promised.

use std::fmt;

use num_rational::BigRational;
use num_traits::Signed;

use super::rounded::{is_of_link, leaves_little, rounded};
use super::{Corrected, Remedy, Shaft, Weight};
use crate::engine::{Balancer, Counterweight, Cylinder, Engine};
use crate::exact::{Term, Turn};
use crate::file::{
    Beside, LayoutError, balancer_table, comment, counterweight_in_multiples, counterweight_table, parse_beside,
    without_counterweights,
};
use crate::order::{self, Factor};
use crate::proof::Sense;

/// Why no file can be written.
#[derive(Clone, Debug)]
pub enum FileError {
    /// The engine was not read from a layout file.
    NoFile,
    /// A weight against what links leave cannot be written in decimals that leave little enough.
    OfLinks,
    /// A shaft stands before a number of a crank that turns faster than the reference, which no key of a file names.
    OfFasterCrank,
    /// The file with the weights behind it is not read.
    Layout(Box<LayoutError>),
    /// It is read as an engine that is not the corrected one.
    AnotherEngine,
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const RIGHT: &str =
            "write [crankshaft], [[counterweight]] and [[balancer]] as tables of their own, one key per line";
        match self {
            FileError::NoFile => {
                f.write_str("the engine was not read from a layout file, to which weights could be added")
            }
            FileError::OfLinks => f.write_str(
                "shafts against what links on a master rod leave have no exact size, and no decimals leave less than 10^-6 of the load",
            ),
            FileError::OfFasterCrank => f.write_str(
                "shafts against what pistons of a crankshaft leave that turns faster than the reference are sums before numbers of its own orders, which a layout file has no key for",
            ),
            FileError::Layout(error) => {
                write!(f, "the layout file does not take the weights of the remedy; {RIGHT}: {error}")
            }
            FileError::AnotherEngine => write!(f, "the layout file does not take the weights of the remedy; {RIGHT}"),
        }
    }
}

impl std::error::Error for FileError {}

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
pub fn corrected_file(remedy: &Remedy, name: &str, beside: Beside<'_>) -> Result<CorrectedFile, FileError> {
    let engine = remedy.subject.engine();
    let source = engine.file().written();
    if source.trim().is_empty() {
        return Err(FileError::NoFile);
    }
    let of_links: Vec<Weight> = remedy.weights().into_iter().filter(is_of_link).collect();
    if of_links.iter().any(|weight| rounded(&remedy.subject, weight).is_none()) {
        return Err(FileError::OfLinks);
    }
    if remedy.weights().iter().any(|weight| weight.vector.parts().keys().any(is_of_faster_crank)) {
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

fn is_of_faster_crank(factor: &Factor) -> bool {
    match factor {
        Factor::Geared(..) => true,
        Factor::One
        | Factor::Motion(_)
        | Factor::Torque(_)
        | Factor::Side(_)
        | Factor::Open
        | Factor::OpenTorque
        | Factor::Linkage(_)
        | Factor::Corrected(..) => false,
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
    let sum = |judged: &Corrected| {
        let whole = order::all_masses(read, judged.quantity, judged.order, judged.sense);
        whole.parts().contains_key(&judged.factor) != judged.vanishes()
    };
    let is_rounded =
        |judged: &Corrected| of_links.iter().any(|weight| (weight.order, weight.sense) == (judged.order, judged.sense));
    same && remedy.corrected.iter().filter(|judged| !is_rounded(judged)).all(sum)
}

fn with_tables(remedy: &Remedy, source: &str) -> String {
    let engine = remedy.subject.engine();
    // Counterweights that a balance factor makes stand beside no others: they are listed.
    let (mut text, listed) = match engine.crankshaft().balance_factors.is_empty() {
        true => (source.trim_end().to_owned() + "\n", &[][..]),
        false => (without_counterweights(source).trim_end().to_owned() + "\n", &engine.crankshaft().counterweights[..]),
    };
    if !listed.is_empty() {
        text += &format!("\n{}", comment("The counterweights that the balance factor of the file makes."));
        text.extend(listed.iter().map(|weight| counterweight_of_throw(engine, weight)));
    }
    let orders = remedy.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    let head = format!(
        "What takes away force and moment of these orders: {orders}. Tables at one position are parts of one weight."
    );
    if !remedy.weights().is_empty() {
        text += &format!("\n{}", comment(&head));
    }
    if remedy.weights().iter().any(is_of_link) {
        text += &comment(ROUNDED);
    }
    let bays = remedy.bays.iter().flat_map(|weight| tables(remedy, weight));
    text.extend(bays);
    for shaft in remedy.crankshaft.iter().chain(&remedy.shafts) {
        text += &format!("\n{}", comment(&heading(shaft)));
        text.extend(shaft.weights.iter().flat_map(|weight| tables(remedy, weight)));
    }
    text
}

/// What is said of weights that are not exact.
const ROUNDED: &str = "Against what links on a master rod leave there is no exact size: those weights are decimals, and leave less than 10^-6 of the load.";

fn heading(shaft: &Shaft) -> String {
    match (shaft.order, shaft.sense) {
        (1, Sense::Direct) => "On the crankshaft.".to_owned(),
        (order, Sense::Direct) => format!("A shaft at {order} times crank speed, with the crank."),
        (order, Sense::Reverse) => format!("A shaft at {order} times crank speed, against the crank."),
    }
}

/// One that a balance factor made, with the throw that it belongs to.
fn counterweight_of_throw(engine: &Engine, weight: &Counterweight) -> String {
    let throws = crate::engine::throws(engine);
    let Some((index, throw)) = weight.throw.and_then(|index| Some((index, throws.get(index)?))) else {
        return counterweight_table(weight, engine.convention());
    };
    let turned = Counterweight { angle: &weight.angle - &throw.angle, ..weight.clone() };
    counterweight_table(&turned, engine.convention()).replacen('\n', &format!("\nthrow = {}\n", index + 1), 1)
}

/// A table for each vector of a weight.
fn tables(remedy: &Remedy, weight: &Weight) -> Vec<String> {
    let engine = remedy.subject.engine();
    let (radius, unit) = (engine.unit_radius(), engine.unit_mass() * engine.unit_radius());
    let is_known = remedy.subject.scale().is_some();
    let table = |coefficient_of: Option<usize>, size: BigRational, angle: Turn| {
        if (weight.order, weight.sense, coefficient_of) == (1, Sense::Direct, None) {
            let mass = &size / &radius;
            let weight = Counterweight {
                throw: None,
                angle,
                mass,
                radius: radius.clone(),
                position: weight.position.clone(),
                crank: 0,
            };
            return match is_known {
                true => counterweight_table(&weight, engine.convention()),
                false => counterweight_in_multiples(&weight, engine.convention(), &unit),
            };
        }
        let shaft = Balancer {
            order: weight.order,
            sense: weight.sense,
            mass_radius: size,
            coefficient_of,
            angle,
            position: weight.position.clone(),
            axis: None,
        };
        balancer_table(engine, &shaft, (!is_known).then_some(&unit))
    };
    if is_of_link(weight) {
        let as_written = |size: BigRational| if is_known { size } else { size * &unit };
        let rounded = rounded(&remedy.subject, weight);
        return rounded.map(|(size, angle)| table(None, as_written(size), angle)).into_iter().collect();
    }
    let parts = weight.vector.parts().iter();
    let terms = parts.flat_map(|(factor, sum)| sum.terms().iter().map(move |term| (factor, term)));
    let exact = terms.map(|(factor, term): (&Factor, &Term)| {
        let (coefficient_of, sign) = coefficient(engine, factor, weight.order);
        let size = &term.weight * &unit * sign;
        let angle = if size.is_negative() { term.angle.opposite() } else { term.angle.clone() };
        table(coefficient_of, size.abs(), angle)
    });
    exact.collect()
}

/// The cylinder whose coefficient a factor is, and the sign between the two; none for 1.
fn coefficient(engine: &Engine, factor: &Factor, order: u32) -> (Option<usize>, BigRational) {
    let one = BigRational::from_integer(1.into());
    match factor {
        // Weights against what links leave are not written by their terms, and against what faster cranks leave not at all.
        Factor::One | Factor::Linkage(_) | Factor::Corrected(..) | Factor::Geared(..) => (None, one),
        Factor::Motion(_) | Factor::Torque(_) | Factor::Side(_) | Factor::Open | Factor::OpenTorque => {
            let is_plain = |cylinder: &Cylinder| cylinder.link().is_none() && engine.speed_of(cylinder) == 1;
            let cylinders = engine.cylinders().iter().enumerate().filter(|(_, cylinder)| is_plain(cylinder));
            let found = cylinders.map(|(index, cylinder)| (index, Factor::of_rod(cylinder.rod(), order)));
            let found = found.into_iter().find(|(_, (own, _))| own == factor);
            found.map_or((None, one), |(index, (_, sign))| (Some(index), sign))
        }
    }
}
