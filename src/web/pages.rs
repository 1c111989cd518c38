//! How does the report come out of the page: in which format, in which language?

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};

use super::judged::Judged;
use crate::page::{self, Document, File, Format, Language, Options};
use crate::report::{self, Contents};

/// The format of a name.
pub(super) fn format<'de, D: Deserializer<'de>>(from: D) -> Result<Format, D::Error> {
    Format::of_name(&String::deserialize(from)?).map_err(D::Error::custom)
}

/// The language of a code.
pub(super) fn language<'de, D: Deserializer<'de>>(from: D) -> Result<Language, D::Error> {
    let code = String::deserialize(from)?;
    Language::of_code(&code).ok_or_else(|| D::Error::custom(format!("no reports are written in `{code}`")))
}

/// The files of the report, the main one first, as `crankstar report` writes them.
pub(super) fn report(judged: &Judged, format: Format, language: Language, moving: bool) -> Value {
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
