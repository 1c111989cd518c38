//! What does a report say about remedies? A section of prose with a table, in the dialect of the report.

use num_rational::BigRational;
use num_traits::Zero;

use super::super::dialect::Dialect;
use super::super::typeset::{Amount, number};
use super::{remedy_lines, remedy_rows};
use crate::remedy::{Partial, Remedy};

/// The section, its heading two marks deep in Markdown; in LaTeX a `\section*`.
pub fn remedy_section(remedy: &Remedy, dialect: Dialect) -> String {
    let mut parts = vec![heading(dialect, "Remedies")];
    parts.push(dialect.prose(
        "A mass-radius $U$ in the direction $\\gamma$ on a shaft at $n$ times the crank speed adds $2 n^2 U e^{i\\gamma}$ \
         to the direct vector of order $n$, or to the reverse one where the shaft turns against the crank. Each weight is \
         an exact sum, so that the sums of the corrected engine are formed anew and judged.",
    ));
    let rows = remedy_rows(remedy);
    if !rows.rows.is_empty() {
        parts.push(table(dialect, &rows.header, &rows.rows));
    }
    parts.extend(remedy_lines(remedy).iter().map(|line| dialect.prose(line)));
    parts.extend(partial_table(remedy, dialect));
    parts.join("\n\n") + "\n"
}

/// The first-order force over the balanced part, where one throw carries all.
fn partial_table(remedy: &Remedy, dialect: Dialect) -> Option<String> {
    let layout = remedy.subject.layout();
    let one_throw = crate::layout::throws(layout).len() == 1;
    let partial = Partial::new(layout);
    if !one_throw || !remedy.orders.contains(&1) || partial.direct.vanishes() {
        return None;
    }
    let parts = [0, 20, 35, 50, 65, 80, 100].map(|percent| BigRational::new(percent.into(), 100.into()));
    let rows = parts.iter().map(|part| {
        let ellipse = partial.ellipse(part);
        let peak = Amount { exact: ellipse.peak, decimal: ellipse.peak_decimal };
        let least = Amount {
            exact: ellipse.least_decimal.is_zero().then(|| Amount::zero().exact).flatten(),
            decimal: ellipse.least_decimal,
        };
        vec![number(part), peak.plain(), least.plain()]
    });
    let header = ["Part f balanced", "Longer semi-axis (peak)", "Shorter semi-axis"].map(str::to_owned);
    let words = dialect.prose("The ellipse of the first-order force in multiples of $m r \\omega^2$:");
    Some(format!("{words}\n\n{}", table(dialect, &header, &rows.collect::<Vec<_>>())))
}

fn heading(dialect: Dialect, words: &str) -> String {
    match dialect {
        Dialect::Latex => format!("\\section*{{{words}}}"),
        Dialect::GithubMarkdown | Dialect::DollarMarkdown => format!("## {words}"),
    }
}

/// Cells hold plain text.
fn table(dialect: Dialect, header: &[String], rows: &[Vec<String>]) -> String {
    let quoted = |cells: &[String]| cells.iter().map(|cell| dialect.quoted(cell)).collect::<Vec<_>>();
    let markdown = |cells: &[String]| format!("| {} |", quoted(cells).join(" | "));
    match dialect {
        Dialect::Latex => {
            let lines = rows.iter().map(|cells| format!("{} \\\\", quoted(cells).join(" & ")));
            let lines = lines.collect::<Vec<_>>().join("\n");
            let columns = "l".repeat(header.len());
            let head = quoted(header).join(" & ");
            format!("\\begin{{tabular}}{{{columns}}}\n{head} \\\\\n\\hline\n{lines}\n\\end{{tabular}}")
        }
        Dialect::GithubMarkdown | Dialect::DollarMarkdown => {
            let line = format!("|{}", " --- |".repeat(header.len()));
            [markdown(header), line]
                .into_iter()
                .chain(rows.iter().map(|row| markdown(row)))
                .collect::<Vec<_>>()
                .join("\n")
        }
    }
}
