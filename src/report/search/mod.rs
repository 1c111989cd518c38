//! How are the best crank stars shown? A table with a row a star, and pictures of the first of them.

mod page;
mod pictures;
mod table;
mod torsion;

pub use page::{search_answer, search_page};
pub use torsion::search_torsion;
