//! What do students and their lecturer read? A sheet with its solutions, the table of marks, a page on what one student wrote.

mod marks;
mod sheet;
mod solutions;
mod student;

pub use marks::{marks_answer, marks_page};
pub use sheet::exercise_sheet;
pub use solutions::exercise_solutions;
pub use student::marked_page;

use crate::engine::{Engine, LengthUnit};
use crate::page::Text;
use crate::proof::Planar;

/// What the length of a sum is counted in.
fn unit_of(engine: &Engine, quantity: Planar) -> Text {
    match (quantity, engine.length_unit()) {
        (Planar::Moment, LengthUnit::Metre) => "length, in m r times metres".into(),
        (Planar::Moment, LengthUnit::Spacing) => "length, in m r times the unit of z".into(),
        (Planar::Force, _) => "length, in m r".into(),
    }
}
