//! Which columns hold named values of several engines? A row an engine.

use crate::table::{Column, Single, Unit, Values};

/// Values of one name, and why some are missing; `like` has their unit and type, decimals where there is none.
pub fn columns(name: &str, like: Option<&Single>, all: &[&Result<Single, String>]) -> [Column; 2] {
    let values = match like {
        Some(like) => like.column(name, all.iter().map(|one| one.as_ref().ok())),
        None => {
            Column::named("{value}", &[name], Unit::NONE, "no engine has it", Values::Decimal(vec![None; all.len()]))
        }
    };
    let why = all.iter().map(|one| one.as_ref().err().cloned()).collect();
    let about = "why the value is missing; empty where there is one";
    [values, Column::named("{value}_missing", &[name], Unit::NONE, about, Values::Words(why))]
}
