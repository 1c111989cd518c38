//! How is a page written for Python: in which format, in which language?

use pyo3::prelude::*;

use super::error::told;
use crate::page::{Alone, Document, Format, Language, Math, Options, write};
use crate::report;

/// The format of this name.
pub(super) fn format(name: &str) -> PyResult<Format> {
    Ok(match Format::of_name(name).map_err(told)? {
        // As notebooks read it.
        Format::Markdown(_) => Format::Markdown(Math::Dollars),
        format => format,
    })
}

/// The options of this language.
pub(super) fn options(language: &str) -> PyResult<Options> {
    let known = Language::of_code(language);
    let codes = || Language::ALL.map(Language::code).join(" or ");
    let language = known.ok_or_else(|| told(format!("language `{language}`; {} are written", codes())))?;
    Ok(Options { language, ..Options::default() })
}

/// The files of a page, the page itself first.
pub(super) fn files(page: &Document, format: Format, options: &Options) -> Vec<(String, String)> {
    write(page, format, options).into_iter().map(|file| (file.name, file.text)).collect()
}

/// A page as one text.
pub(super) fn text(page: &Document, format: Format, options: &Options) -> String {
    files(page, format, options).swap_remove(0).1
}

/// The drawing of this name on a page, as SVG.
pub(super) fn figure(page: &Document, name: &str) -> PyResult<String> {
    let figures = report::figures(std::slice::from_ref(page));
    match figures.iter().find(|figure| figure.name == name) {
        Some(figure) => Ok(Alone::Svg.write(&figure.picture, &Options::default())),
        None => {
            let names: Vec<&str> = figures.iter().map(|figure| figure.name.as_str()).collect();
            Err(told(format!("there is no figure `{name}`; available are {}", names.join(", "))))
        }
    }
}
