//! How is what accuracy costs shown? Each load by all methods: tables, plots, a section of a report, pages.

mod case;
mod data;
mod further;
pub(super) mod methods;
mod page;
mod plots;
mod study;
mod tables;
mod words;

pub use case::AccuracyCase;
pub use further::{Further, FurtherLoad};
pub use page::accuracy_section;
pub use study::AccuracyStudy;
