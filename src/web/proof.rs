//! Why is it so? The proofs in words, and the certificates as `classify --json` prints them, checked once more.

use serde::Serialize;
use serde_json::{Value, json};

use super::judged::Judged;
use super::look::html;
use super::mistake::Mistake;
use crate::proof::{Counts, read_document};
use crate::{report, text, verdict};

/// The proofs as parts of the page, the JSON, and what its check found.
pub(super) fn proof(judged: &Judged) -> Result<Value, Mistake> {
    let (blocks, json) = match judged {
        Judged::Known { engine, judged, .. } => {
            let quantities = verdict::quantities(engine, false);
            let document = report::document(engine, judged.masses, &judged.orders, &quantities, None);
            (report::engine_proofs(engine, judged), printed(&document)?)
        }
        Judged::Open { family, orders } => {
            (report::family_proofs(family, orders), printed(&report::open_document(family, orders))?)
        }
    };
    let [checked, by] = checked(&json)?;
    Ok(json!({ "html": html(&blocks), "json": json, "checked": checked, "by": by }))
}

/// The document as the program prints it.
fn printed(document: &impl Serialize) -> Result<String, Mistake> {
    let json = serde_json::to_string_pretty(document).map_err(Mistake::of)?;
    Ok(text::json(&json) + "\n")
}

/// What the checker says of it, which knows nothing of how the verdicts were found: that it holds, and by which evidence.
fn checked(json: &str) -> Result<[String; 2], Mistake> {
    let fault = |why: String| Mistake::plain("the checker rejects the proof, so it is not shown", &why);
    let document = read_document(json.as_bytes()).map_err(|error| fault(error.to_string()))?;
    let checked = document.check().map_err(|error| fault(error.to_string()))?;
    let Counts { polygons, residues, splittings, .. } = checked.counts;
    let kinds = [
        (polygons, "by polygons (zero)"),
        (residues, "by a residue (not zero)"),
        (splittings, "by a splitting (not zero)"),
    ];
    let kinds = kinds.iter().filter(|(count, _)| *count > 0).map(|(count, by)| format!("{count} {by}"));
    let by = format!("{}.", kinds.collect::<Vec<_>>().join(", "));
    Ok([format!("All {} certificates hold.", checked.counts.certificates()), by])
}
