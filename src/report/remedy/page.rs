//! What does a report say about remedies? A section of prose with a table, in the dialect of the report.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::super::dialect::Dialect;
use super::super::figure::Figure;
use super::super::folder::File;
use super::super::plot::{Axis, Curve, Plot};
use super::super::typeset::{Amount, number};
use super::super::{svg, tikz};
use super::{remedy_lines, remedy_rows};
use crate::numbers::Form;
use crate::remedy::{Ellipse, Partial, Remedy};

/// The name of the drawing of [`remedy_figure`], without its ending.
const FIGURE: &str = "partial-balance";
/// Steps of its curves.
const STEPS: u32 = 40;

/// The section, its heading two marks deep in Markdown; in LaTeX a `\section`. Markdown shows the drawing of
/// [`remedy_figure`] by its file name, LaTeX holds it.
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
    if let Some(partial) = partial(remedy) {
        parts.push(dialect.prose("The ellipse of the first-order force in multiples of $m r \\omega^2$:"));
        parts.push(partial_table(&partial, dialect));
        parts.extend(remedy_figure(remedy).map(|(name, figure)| match dialect {
            Dialect::Latex => tikz(&figure),
            Dialect::GithubMarkdown | Dialect::DollarMarkdown => format!("![{CAPTION}]({name}.svg)"),
        }));
    }
    parts.join("\n\n") + "\n"
}

const CAPTION: &str = "Semi-axes of the first-order force over the balanced part of the reciprocating masses";

/// The files of a remedy alone: `remedy.md` with its drawing, or `remedy.tex`, a piece of a document.
pub fn remedy_files(remedy: &Remedy, dialect: Dialect) -> Vec<File> {
    let section = remedy_section(remedy, dialect);
    if dialect == Dialect::Latex {
        return vec![File { name: "remedy.tex".into(), text: section }];
    }
    let title = dialect.quoted(remedy.subject.engine().title());
    let mut files = vec![File { name: "remedy.md".into(), text: format!("# {title}\n\n{section}") }];
    let drawing =
        remedy_figure(remedy).map(|(name, figure)| File { name: format!("{name}.svg"), text: svg(&figure, CAPTION) });
    files.extend(drawing);
    files
}

/// The semi-axes of the first-order force over the balanced part, with the name of the drawing, where counterweights
/// change it.
pub fn remedy_figure(remedy: &Remedy) -> Option<(&'static str, Figure)> {
    let curve = partial(remedy)?.curve(STEPS);
    let points = |axis: fn(&Ellipse) -> f64| -> Vec<(f64, f64)> {
        curve.iter().map(|(part, ellipse)| (part.to_f64().unwrap_or(f64::NAN), axis(ellipse))).collect()
    };
    let mut plot = Plot::new(
        "First-order force",
        Axis::linear("Balanced part f of the reciprocating masses"),
        Axis::linear("m r ω²"),
    );
    plot.curves.push(Curve::new(0, "peak", points(|ellipse| ellipse.peak_decimal)));
    plot.curves.push(Curve::new(1, "shorter semi-axis", points(|ellipse| ellipse.least_decimal)));
    Some((FIGURE, plot.figure()))
}

/// The partial balance, where the first order is asked for and counterweights change it but leave a reverse vector, or
/// one throw carries all.
fn partial(remedy: &Remedy) -> Option<Partial> {
    let engine = remedy.subject.engine();
    let partial = Partial::new(engine)?;
    let tells = crate::engine::throws(engine).len() == 1 || !partial.reverse.vanishes();
    (tells && remedy.orders.contains(&1) && !partial.direct.vanishes()).then_some(partial)
}

fn partial_table(partial: &Partial, dialect: Dialect) -> String {
    let parts = [0, 20, 35, 50, 65, 80, 100].map(|percent| BigRational::new(percent.into(), 100.into()));
    let rows = parts.iter().map(|part| {
        let ellipse = partial.ellipse(part);
        let exact = |form: Option<Form>, decimal: f64| Amount { exact: form, decimal }.plain();
        let zero = ellipse.least_decimal.is_zero().then(|| Form::rational(BigRational::zero()));
        vec![number(part), exact(ellipse.peak, ellipse.peak_decimal), exact(zero, ellipse.least_decimal)]
    });
    let header = ["Part f balanced", "Longer semi-axis (peak)", "Shorter semi-axis"].map(str::to_owned);
    table(dialect, &header, &rows.collect::<Vec<_>>())
}

fn heading(dialect: Dialect, words: &str) -> String {
    match dialect {
        Dialect::Latex => format!("\\section{{{words}}}"),
        Dialect::GithubMarkdown | Dialect::DollarMarkdown => format!("## {words}"),
    }
}

/// Cells hold plain text.
fn table(dialect: Dialect, header: &[String], rows: &[Vec<String>]) -> String {
    let quoted = |cells: &[String]| cells.iter().map(|cell| dialect.literal(cell)).collect::<Vec<_>>();
    let markdown = |cells: &[String]| format!("| {} |", quoted(cells).join(" | "));
    match dialect {
        Dialect::Latex => {
            let lines = rows.iter().map(|cells| format!("{} \\\\", quoted(cells).join(" & ")));
            let lines = lines.collect::<Vec<_>>().join("\n");
            // The closed forms of the table of weights need columns that break lines.
            let ragged = |widths: &[u32]| -> String {
                widths.iter().map(|width| format!(">{{\\raggedright\\arraybackslash}}p{{{width}mm}}")).collect()
            };
            let columns = match header.len() {
                5 => ragged(&[22, 22, 20, 42, 44]),
                6 => ragged(&[20, 21, 20, 33, 32, 21]),
                count => "l".repeat(count),
            };
            let head = quoted(header).join(" & ");
            format!(
                "{{\\footnotesize\n\\begin{{longtable}}{{@{{}}{columns}@{{}}}}\n\\toprule\n{head} \\\\\n\\midrule\n\\endhead\n{lines}\n\\bottomrule\n\\end{{longtable}}}}"
            )
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
