//! Which columns hold named values of several engines? A row an engine.

use super::filling::Filling;
use crate::report::ValuesStudy;
use crate::table::{Column, Single, Table, Unit, Values};

/// The values, and beside each why an engine has none.
pub fn values(study: &ValuesStudy) -> Table {
    let mut table = Filling::new("values.values", &study.rows);
    table.person("engine", |(name, _)| Some(name.clone()));
    let mut table = table.done();
    values_into(&mut table, study);
    table
}

/// The columns of the values behind those of a table with the same rows.
pub fn values_into(table: &mut Table, study: &ValuesStudy) {
    for (place, name) in study.names.iter().enumerate() {
        let all: Vec<&Result<Single, String>> = study.rows.iter().map(|(_, values)| &values[place]).collect();
        let first = all.iter().find_map(|one| one.as_ref().ok());
        columns(&name.column(), first, &all).into_iter().for_each(|column| table.push(column));
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
    let why = all.iter().map(|one| one.as_ref().err().cloned()).collect();
    let about = "why the value is missing; empty where there is one";
    [values, Column::named("{value}_missing", &[name], Unit::NONE, about, Values::Words(why))]
}
