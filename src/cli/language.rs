//! `--lang`: in which language is it said?

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use crankstar::page::Language;

/// The argument.
#[derive(clap::Args)]
pub struct LanguageArgs {
    /// The language of page and answer
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = of_code())]
    lang: Language,
}

fn of_code() -> impl TypedValueParser<Value = Language> {
    let codes = Language::ALL.map(|language| PossibleValue::new(language.code()).help(language.name()));
    PossibleValuesParser::new(codes).map(|code| Language::of_code(&code).unwrap_or_default())
}

impl LanguageArgs {
    /// The language.
    pub fn language(&self) -> Language {
        self.lang
    }
}
