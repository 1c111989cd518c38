//! How do the templates of a format set a block?

use std::sync::LazyLock;

use serde::Serialize;
use tera::{Context, Delimiters, Kwargs, State, Tera};

use super::super::Language;

/// The templates of one format.
pub(super) type Set = LazyLock<Tera>;

/// The templates are part of the program, so that a mistake in one is a mistake of ours.
const OURS: &str = "a template of the program";

/// One template per kind of block, one for the document, and what a format has besides, out of a folder.
macro_rules! set {
    ($folder:literal, $delimiters:expr $(, $more:literal)*) => {{
        static SET: $crate::page::write::templates::Set = std::sync::LazyLock::new(|| {
            $crate::page::write::templates::load(
                &[
                    ("answer", include_str!(concat!("../../../templates/", $folder, "/answer"))),
                    ("document", include_str!(concat!("../../../templates/", $folder, "/document"))),
                    ("folded", include_str!(concat!("../../../templates/", $folder, "/folded"))),
                    ("heading", include_str!(concat!("../../../templates/", $folder, "/heading"))),
                    ("list", include_str!(concat!("../../../templates/", $folder, "/list"))),
                    ("note", include_str!(concat!("../../../templates/", $folder, "/note"))),
                    ("paragraph", include_str!(concat!("../../../templates/", $folder, "/paragraph"))),
                    ("pictures", include_str!(concat!("../../../templates/", $folder, "/pictures"))),
                    ("table", include_str!(concat!("../../../templates/", $folder, "/table"))),
                    ("verbatim", include_str!(concat!("../../../templates/", $folder, "/verbatim"))),
                    $(($more, include_str!(concat!("../../../templates/", $folder, "/", $more))),)*
                ],
                $delimiters,
            )
        });
        &SET
    }};
}

pub(super) use set;

/// Delimiters that TeX does not use.
pub(super) fn angles() -> Delimiters {
    Delimiters {
        block_start: "<%".into(),
        block_end: "%>".into(),
        variable_start: "<<".into(),
        variable_end: ">>".into(),
        comment_start: "<#".into(),
        comment_end: "#>".into(),
    }
}

pub(super) fn load(templates: &[(&'static str, &'static str)], delimiters: Option<Delimiters>) -> Tera {
    let mut tera = Tera::default();
    tera.autoescape_on(Vec::<&str>::new());
    if let Some(delimiters) = delimiters {
        tera.set_delimiters(delimiters).expect(OURS);
    }
    tera.register_filter("say", say);
    tera.add_raw_templates(templates.iter().copied()).expect(OURS);
    tera
}

/// Fills a template with finished strings.
pub(super) fn fill(set: &Set, template: &str, values: &impl Serialize) -> String {
    set.render(template, &Context::from_serialize(values).expect(OURS)).expect(OURS)
}

/// Words in a template, in the language of the page: `{{ "Contents" | say(language=language) }}`.
pub(crate) fn say(words: &str, arguments: Kwargs, _: &State) -> tera::TeraResult<String> {
    let language = Language::of_code(arguments.must_get("language")?).unwrap_or_default();
    Ok(language.fixed(words).to_owned())
}
