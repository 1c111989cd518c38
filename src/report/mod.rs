//! How is it shown? Reports in Markdown and LaTeX with their diagrams, and the JSON document.
//!
//! `verdicts → page (finished strings, drawings) → template → files`

mod accuracy;
mod argument;
mod atlas;
mod bearings;
mod calculation;
mod claim_page;
mod claim_words;
mod compare;
mod dialect;
mod document;
mod engine_cells;
mod firmness;
mod folder;
mod loads_document;
mod multiples;
mod open_document;
mod open_page;
mod open_table;
mod open_words;
#[cfg(feature = "optimise")]
mod optimise;
mod page;
mod remedy;
mod render;
mod residual;
mod sections;
mod star;
mod sweep;
mod table;
mod theorem;
mod views;

use crate::page::{figure, number as typeset, plot, svg, tikz};

pub use accuracy::{
    AccuracyCase, AccuracyDocument, accuracy_answer, accuracy_document, accuracy_errors_page, accuracy_page,
    accuracy_section,
};
pub use atlas::{ATLAS_CYLINDERS, atlas};
pub use bearings::{BearingsDocument, bearings_answer, bearings_document, bearings_page};
pub use calculation::{Numbers, Rows, loads_lines, loads_rows};
pub use claim_page::claims_page;
pub use claim_words::{claim_finding, claim_status, table_finding};
pub use compare::{CompareDocument, Compared, compare_document, compare_lines, compare_page, compare_rows};
pub use dialect::Dialect;
pub use document::document;
pub use folder::{File, index, open_report, report};
pub use loads_document::{LoadsDocument, loads_document};
pub use open_document::open_document;
pub use open_words::{even_firing_words, open_summary};
#[cfg(feature = "optimise")]
pub use optimise::{
    OptimiseDocument, optimise_answer, optimise_document, optimise_layouts, optimise_page, optimise_summary,
};
pub use page::Contents;
pub use remedy::{remedy_answer, remedy_cures, remedy_document, remedy_engine, remedy_page, remedy_section};
pub use residual::{
    AS_BUILT, LEGEND, PISTONS_ALONE, force_summary, moment_summary, order_name, torque_summary, turning_unit,
    whole_summary, whose_masses, why_not,
};
pub use sweep::{SweepDocument, study_page, sweep_csv, sweep_document, sweep_page};
