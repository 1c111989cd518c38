//! How is a class taught and marked: a vector star of one's own for each student, and every entry of what is handed in judged?
//!
//! `layout → varied engines → sheets`, and `tables handed in → readings → marks → points`. What an entry is worth is decided in the
//! room `claim`; the pages are made in the room of reports.

mod answers;
mod convention;
mod csv;
mod distribution;
mod draw;
mod exercise;
mod fill_in;
mod handed_in;
mod lines;
mod marking;
mod marks;
mod results;
mod scheme;
mod students;
mod submission;
mod vary;

pub use convention::{Convention, KEYS, PLANE};
pub use distribution::Distribution;
pub use draw::Draw;
pub use exercise::{Exercise, Pupil, parse_exercise};
pub use fill_in::{csv_to_fill_in, toml_to_fill_in};
pub use handed_in::{Content, HandedIn};
pub use marking::{Counts, MarkedSheet, MarkedTable};
pub use marks::marks_table;
pub use results::{Outcome, StudentResult, mark_class};
pub use scheme::{Scheme, parse_scheme};
pub use students::{Student, students};
pub use vary::{Vary, can_be_set, varied};
