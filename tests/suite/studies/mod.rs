//! Pages of `reports/` that the program does not write: of several engines, or of a source that is checked.

pub mod accuracy_errors;
pub mod catalogue;
mod check;
mod checked;
mod flywheels;
pub mod section;
pub mod study;
mod study_checks;
mod study_flywheels;
pub mod study_page;
mod study_plots;
pub mod world;

/// Words with values, as a page of the program has them.
macro_rules! phrase {
    ($words:expr $(, $value:expr)* $(,)?) => {
        crankstar::page::Text::phrase($words, vec![$(crankstar::page::Text::from($value)),*])
    };
}

use phrase;
