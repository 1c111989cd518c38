//! Which columns hold named values of several engines? A row an engine.

use crate::table::{Column, Single, Unit, Values};

/// A value that fits a column with the unit of `like`, or why there is none in it.
pub fn fitting<'a>(one: &'a Result<Single, String>, like: Option<&Single>) -> Result<&'a Single, String> {
    let single = one.as_ref().map_err(String::clone)?;
    match like {
        Some(like) if like.unit != single.unit => Err(match single.unit {
            Unit::NONE => "it has no unit, unlike the column".to_owned(),
            unit => format!("it is in {}, unlike the column", unit.name),
        }),
        Some(_) | None if single.value().is_none() => Err("its own table has none".to_owned()),
        Some(_) | None => Ok(single),
    }
}

/// Values of one name, and why some are missing; `like` has their unit and type, decimals where there is none.
pub fn columns(name: &str, like: Option<&Single>, all: &[&Result<Single, String>]) -> [Column; 2] {
    let values = match like {
        Some(like) => like.column(name, all.iter().map(|one| one.as_ref().ok())),
        None => {
            Column::named("{value}", &[name], Unit::NONE, "no engine has it", Values::Decimal(vec![None; all.len()]))
        }
    };
    let why = all.iter().map(|one| fitting(one, like).err()).collect();
    let about = "why the value is missing; empty where there is one";
    [values, Column::named("{value}_missing", &[name], Unit::NONE, about, Values::Words(why))]
}
