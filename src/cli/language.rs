//! `--lang`: in which language is it said?

use clap::ValueEnum;
use crankstar::page::Language;

/// The argument.
#[derive(clap::Args)]
pub struct LanguageArgs {
    /// The language of page and answer
    #[arg(long, value_enum, value_name = "LANGUAGE", default_value = "en")]
    lang: Lang,
}

/// The language of page and answer.
#[derive(Clone, Copy, ValueEnum)]
enum Lang {
    /// English
    En,
    /// German, with decimal commas
    De,
}

impl LanguageArgs {
    /// The language.
    pub fn language(&self) -> Language {
        match self.lang {
            Lang::En => Language::En,
            Lang::De => Language::De,
        }
    }
}
