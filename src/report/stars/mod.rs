//! What can crank stars lose, and what never? The sentences of the theorems, and the page of all numbers of cylinders.

mod atlas;
mod cited;
mod drawn;
mod page;
mod study;
mod tables;
mod words;

pub use atlas::{StarAtlas, StarredEngine, star_atlas_answer, star_atlas_page};
pub(super) use cited::cited;
pub use page::{stars_answer, stars_layouts, stars_page};
pub use study::StarsStudy;
pub(super) use words::told;
