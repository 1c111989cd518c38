//! How does the report come out of the page: in which format, in which language?

use serde::Deserialize;
use serde_json::{Value, json};

use super::Judged;
use crate::page::{self, Document, File, Language, Math, Options};
use crate::report::{self, Contents};

/// What a report is written in.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Format {
    Markdown,
    Latex,
    Html,
    Typst,
    Text,
}

/// The language of a report.
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Spoken {
    #[default]
    En,
    De,
}

/// The files of the report, the main one first, as `crankstar report` writes them.
pub(super) fn report(judged: &Judged, format: Format, language: Spoken, moving: bool) -> Value {
    let format = match format {
        Format::Markdown => page::Format::Markdown(Math::Github),
        Format::Latex => page::Format::Latex,
        Format::Html => page::Format::Html,
        Format::Typst => page::Format::Typst,
        Format::Text => page::Format::PLAIN,
    };
    let language = match language {
        Spoken::En => Language::En,
        Spoken::De => Language::De,
    };
    let files = page::write(&document(judged, moving), format, &Options { language, ..Options::default() });
    let files = files.iter().map(|File { name, text }| json!({ "name": name, "text": text }));
    json!({ "files": files.collect::<Vec<_>>() })
}

fn document(judged: &Judged, in_motion: bool) -> Document {
    match judged {
        Judged::Known { engine, judged, family } => report::engine_page(Contents {
            engine,
            judged,
            family: family.as_ref().map(|(family, orders)| (family.as_ref(), orders.as_slice())),
            needed: None,
            in_motion,
            accuracy: None,
            weighing: report::Weighing::usual(),
        }),
        Judged::Open { family, orders } => report::family_page(family, orders, in_motion),
    }
}
