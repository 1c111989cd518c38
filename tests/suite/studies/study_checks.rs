//! How are the checks of a statement shown? A table for each place that is quoted, then what is computed beside it.

use crankstar::claim::{Provenance, Quote};
use crankstar::page::number::{self, Amount};
use crankstar::page::{Block, Number, Table, Text};
use crankstar::report::{claim_finding, claim_status};
use crankstar::text::Untrusted;
use num_rational::BigRational;

use super::phrase;
use super::study::{Checked, Found};

/// The checks of what the source says, each place with its words; then those of nobody's.
pub(super) fn checks(checks: &[Checked], above: &Untrusted) -> Vec<Block> {
    let (claimed, own): (Vec<&Checked>, Vec<&Checked>) = checks.iter().partition(|check| check.provenance.is_claimed());
    let groups = claimed.chunk_by(|one, other| one.provenance == other.provenance);
    let groups = groups.chain((!own.is_empty()).then_some(&own[..]));
    let told = groups.flat_map(|group| {
        let about = group.first().map(|check| Block::Paragraph(said(&check.provenance, above)));
        about.into_iter().chain([table(group).into()])
    });
    told.collect()
}

/// Where it is said, with its source where that is not the one that stands above.
fn said(provenance: &Provenance, above: &Untrusted) -> Text {
    match provenance {
        Provenance::Quoted(Quote { source, place, words }) if source == above => {
            phrase!("Said in {}: “{}”", place, words)
        }
        Provenance::Quoted(Quote { source, place, words }) => phrase!("Said in {}, {}: “{}”", source, place, words),
        Provenance::Folklore => "A common claim; no source was found:".into(),
        Provenance::Own => "Our own cross-check:".into(),
    }
}

fn table(checks: &[&Checked]) -> Table {
    let mut table = Table::new(["Engine", "Claim", "Answer", "Finding"]);
    for check in checks {
        table.push(vec![(&check.engine).into(), (&check.claim).into(), answer(check), found(&check.found)]);
    }
    table
}

fn answer(check: &Checked) -> Text {
    match &check.found {
        Found::Claim(pair) => phrase!("**{}**", claim_status(&pair.1)),
        Found::Values { .. } | Found::Firing { .. } | Found::Counterweight(_) | Found::Volume(_) | Found::Grid(_) => {
            match check.holds {
                true => "**true**".into(),
                false => "**false**".into(),
            }
        }
    }
}

/// What is the case.
pub(super) fn found(found: &Found) -> Text {
    match found {
        Found::Claim(pair) => claim_finding(&pair.0, &pair.1),
        Found::Values { everywhere: true, .. } => "At every angle.".into(),
        Found::Values { at, complete, .. } => match (at.is_empty(), *complete) {
            (true, true) => "At no angle of the range; this is proved.".into(),
            (true, false) => "At no angle that was found; there may be others.".into(),
            (false, true) => phrase!("At {}, and proved: nowhere else in the range.", degrees(at)),
            (false, false) => phrase!("At {}, and perhaps elsewhere.", degrees(at)),
        },
        Found::Firing { at, .. } | Found::Grid(at) if at.is_empty() => "Nowhere on the grid.".into(),
        Found::Firing { difference: None, at } | Found::Grid(at) => phrase!("At {}.", degrees(at)),
        Found::Firing { difference: Some(difference), at } => phrase!(
            "At {}: the longest and the shortest interval differ by {}.",
            degrees(at),
            number::turns(difference)
        ),
        Found::Counterweight(Some(form)) => {
            let amount = Amount { exact: Some(form.clone()), decimal: form.to_float() };
            phrase!("$m_{cw} \\rho b$ is {} times $m r a$.", amount)
        }
        Found::Counterweight(None) => "No closed form.".into(),
        Found::Volume(part) => {
            phrase!("The largest is {} times that in line, in the geometry below.", Number::Decimal(*part))
        }
    }
}

fn degrees(values: &[BigRational]) -> Text {
    Text::joined(values.iter().map(|at| number::degrees(at).into()), ", ")
}
