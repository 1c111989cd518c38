//! Is it true, what is said of the engine on the page?

use serde_json::{Value, json};

use super::look::html;
use super::mistake::Mistake;
use super::written::Written;
use crate::claim::{self, Status};
use crate::file::Layout;
use crate::page::{Block, Format, text_in};
use crate::report;

/// The answer of the room of claims, with what is the case and the certificates that it rests on.
pub(super) fn claim(layout: &Written, says: &str) -> Result<Value, Mistake> {
    let says = says.trim();
    // Among sentences a claim begins as a sentence does.
    let says = ["The ", "the "].iter().find_map(|article| says.strip_prefix(article)).unwrap_or(says);
    let statement = claim::parse_statement(says).map_err(|error| Mistake::plain(&error.message, &error.right))?;
    let engine = match layout.read()? {
        Layout::Known(engine, _) => engine,
        Layout::Open(_) => {
            let right = "give the unknowns values, as in values = { phi = 90 } above the first table";
            return Err(Mistake::plain("claims are about an engine without unknowns", right));
        }
    };
    let answer = claim::answer(&engine, &statement, None);
    let finding = report::claim_finding_on((&engine, None), &statement, &answer);
    let evidence = report::claim_evidence(&answer);
    let kind = match &answer.status {
        Status::NotDecided => "open",
        status if status.holds() => "holds",
        Status::True | Status::TrueAsRounded | Status::TrueOnlyIf { .. } | Status::False => "fails",
    };
    let evidence = if evidence.is_empty() { Vec::new() } else { vec![Block::List(evidence)] };
    Ok(json!({
        "status": text_in(&report::claim_status(&answer), Format::PLAIN),
        "kind": kind,
        "finding": html(&[Block::Paragraph(finding.clone())]),
        "spoken": text_in(&finding, Format::PLAIN),
        "evidence": html(&evidence),
    }))
}
