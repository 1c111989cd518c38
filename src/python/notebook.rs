//! How does an answer look in a notebook?

use super::pages;
use super::verdict::Verdict;
use crate::page::{Document, Format, Options, Text, text_in};

/// A page as a piece of HTML.
pub(super) fn html(page: &Document) -> String {
    pages::text(page, Format::Html, &Options { fragment: true, ..Options::default() })
}

/// What is left in a cell of a formula.
pub(super) fn tex(text: &Text) -> String {
    match text.is_zero() {
        true => "\\mathbf{0}".to_owned(),
        // MathJax would show a tie as it is.
        false => format!("\\text{{{}}}", text_in(text, Format::Latex).replace('~', " ")),
    }
}

/// The verdicts as one formula in TeX, with what MathJax knows: a row an order, a column a quantity.
pub(super) fn latex(verdicts: &[Verdict]) -> String {
    let mut quantities: Vec<&str> = Vec::new();
    let mut orders: Vec<u32> = Vec::new();
    for verdict in verdicts {
        if !quantities.contains(&verdict.quantity.as_str()) {
            quantities.push(verdict.quantity.as_str());
        }
        if !orders.contains(&verdict.order) {
            orders.push(verdict.order);
        }
    }
    let cell = |order: u32, quantity: &str| {
        let of = verdicts.iter().find(|verdict| verdict.order == order && verdict.quantity == quantity);
        of.map(|verdict| verdict.tex.as_str()).unwrap_or_default()
    };
    let heading: Vec<String> = quantities.iter().map(|quantity| format!("\\text{{{quantity}}}")).collect();
    let row = |&order: &u32| {
        let cells: Vec<&str> = quantities.iter().map(|quantity| cell(order, quantity)).collect();
        format!("{order} & {}", cells.join(" & "))
    };
    let rows: Vec<String> = orders.iter().map(row).collect();
    format!(
        "$$\\begin{{array}}{{r{}}}\n\\text{{order}} & {} \\\\\n\\hline\n{}\n\\end{{array}}$$",
        "l".repeat(quantities.len()),
        heading.join(" & "),
        rows.join(" \\\\\n")
    )
}
