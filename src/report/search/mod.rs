//! How are the best crank stars shown? A table with a row a star, the front as a picture, and pictures of the first stars.

pub(super) mod data;
mod front;
mod page;
mod pictures;
mod study;
mod table;
mod torsion;

pub use front::search_layouts;
pub use page::{search_answer, search_page, search_theorems};
pub(in crate::report) use pictures::pictures_at as star_pictures;
pub use study::SearchStudy;
pub use torsion::search_torsion;
