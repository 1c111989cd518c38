//! How is a study shown? A page of its statements with what was found, its families in curves and tables.

mod checks;
mod flywheel;
mod page;
mod plots;

pub use page::{study_page, study_tables};
