//! How is a layout file written with other counterweights? The file as it stands, its counterweights replaced.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::error::OptimiseError;
use crate::engine::{Counterweight, Engine};
use crate::file::parse;

/// The engine with these counterweights, read back from its own file: what is written is what is measured.
///
/// # Errors
/// [`OptimiseError::File`] where the file names its counterweights in a way that this writer does not find.
pub(super) fn with_counterweights(
    engine: &Engine,
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
            text += &table(part);
        }
    }
    let advice = match engine.gas() {
        None => "write [crankshaft] and [[counterweight]] as tables of their own, one key per line",
        Some(_) => {
            "write [crankshaft] and [[counterweight]] as tables of their own, one key per line, and a table of pressures into the layout file itself, as pressure"
        }
    };
    let read = parse("the new file", &text).map_err(|_| OptimiseError::File(advice.to_owned()))?;
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

fn comment(text: &str) -> String {
    text.lines().map(|line| format!("# {line}\n")).collect()
}

fn table(weight: &Counterweight) -> String {
    format!(
        "[[counterweight]]\nangle = {}\nmass = {}\nradius = {}\nposition = {}\n",
        number(&weight.angle.degrees()),
        number(&weight.mass),
        number(&weight.radius),
        number(&weight.position),
    )
}

/// A decimal where it ends, else a fraction in quotes.
fn number(value: &BigRational) -> String {
    let ten = BigRational::from_integer(10.into());
    let mut scaled = value.abs();
    let mut places = 0;
    while !scaled.is_integer() && places < 12 {
        scaled *= &ten;
        places += 1;
    }
    if !scaled.is_integer() {
        return format!("\"{value}\"");
    }
    let sign = if value.is_negative() { "-" } else { "" };
    let digits = format!("{:0>width$}", scaled.to_integer().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    match (fraction.is_empty() || scaled.is_zero(), whole.len() > 18) {
        (_, true) => format!("\"{value}\""),
        (true, _) => format!("{sign}{whole}"),
        (false, _) => format!("{sign}{whole}.{fraction}"),
    }
}

/// The text without `[[counterweight]]` tables and the keys of `[crankshaft]` that make counterweights.
fn without_counterweights(text: &str) -> String {
    const MAKERS: [&str; 3] = ["balance_factor", "counterweight_radius", "web_offset"];
    let mut kept = Vec::new();
    let (mut table, mut open) = (String::new(), 0_i32);
    for line in text.lines() {
        let bare = line.split('#').next().unwrap_or(line).trim();
        if open > 0 {
            // The rest of a list that is left out.
            open += brackets(bare);
            continue;
        }
        if bare.starts_with('[') {
            table = bare.to_owned();
        }
        let key = bare.split('=').next().unwrap_or_default().trim();
        let makes = table == "[crankshaft]" && MAKERS.contains(&key);
        let dotted = key.strip_prefix("crankshaft.").is_some_and(|key| MAKERS.contains(&key.trim()));
        if makes || dotted {
            open = brackets(bare);
        } else if table != "[[counterweight]]" {
            kept.push(line);
        }
    }
    kept.join("\n")
}

fn brackets(text: &str) -> i32 {
    text.chars().map(|letter| i32::from(letter == '[') - i32::from(letter == ']')).sum()
}
