//! How is it shown? Reports in Markdown and LaTeX with their diagrams, and the JSON document.
//!
//! `verdicts → page (finished strings, drawings) → template → files`

mod argument;
mod bearings;
mod calculation;
mod claim_page;
mod claim_words;
mod dialect;
mod document;
pub mod figure;
mod firmness;
mod folder;
mod left;
mod loads_document;
mod open_document;
mod open_page;
mod open_table;
mod open_words;
mod page;
pub mod plot;
mod render;
mod star;
mod svg;
mod sweep;
mod table;
mod theorem;
mod tikz;
mod typeset;
mod views;

pub use bearings::{
    BearingsDocument, bearings_document, bearings_lines, bearings_page, bearings_rows, bearings_tables,
};
pub use calculation::{Rows, loads_lines, loads_rows};
pub use claim_page::claims_page;
pub use claim_words::{claim_finding, claim_status, table_finding};
pub use dialect::Dialect;
pub use document::{document, theorem_claims};
pub use folder::{File, index, open_report, report};
pub use left::{LEGEND, force_summary, moment_summary, order_name, torque_summary};
pub use loads_document::{LoadsDocument, loads_document};
pub use open_document::open_document;
pub use open_words::{even_firing_words, open_summary};
pub use page::Subject;
pub use svg::svg;
pub use sweep::{SweepDocument, study_page, sweep_csv, sweep_document, sweep_page};
pub use tikz::tikz;
