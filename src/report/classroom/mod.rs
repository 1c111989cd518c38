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
use crate::proof::Quantity;

/// What the length of a sum is counted in.
fn unit_of(engine: &Engine, quantity: Quantity) -> Text {
    match (quantity, engine.length_unit()) {
        (Quantity::Moment, LengthUnit::Metre) => "length, in m r times metres".into(),
        (Quantity::Moment, LengthUnit::Spacing) => "length, in m r times the unit of z".into(),
        (Quantity::Force | Quantity::Torque | Quantity::Roll, _) => "length, in m r".into(),
    }
}
