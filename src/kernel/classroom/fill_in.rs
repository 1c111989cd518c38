//! Which table is a student given to fill in? As TOML, or as lines of a spreadsheet.

use super::convention::{KEYS, PLANE};
use super::exercise::Pupil;
use super::lines::{COLUMNS, CONVENTION, CYLINDER, sum_name};
use super::vary::quoted;
use crate::claim::SUMS;
use crate::file::comment;
use crate::text::{Format, field};

const HOW: &str = "Write between the quotes, and hand this file in.\nAn angle is in degrees, \"240\", \"-30\", \"51.43\", or \"1/7 turn\"; a length is a number, \"3.16\", \"sqrt(10)\", \"2 sin 36 deg\".\nDecimals are right if they are the true value, rounded; a number without a decimal point is taken as exact.\nHow many digits a rounded number needs is on the sheet.";
const OTHERWISE: &str = "Only if your convention is not that of the sheet: sense = \"clockwise\", throws = \"reversed\",\nvectors = \"swapped\" (direct and reverse), plane = the position that your moments are about.";

/// The table of a student, empty, in TOML.
pub fn toml_to_fill_in(pupil: &Pupil, orders: &[u32]) -> String {
    let mut text = comment(HOW);
    text.push_str(&format!("student = {}\nsheet = {}\n\n", quoted(pupil.name.written()), quoted(&pupil.file)));
    text.push_str(&(comment(OTHERWISE) + "[convention]\n"));
    KEYS.iter().for_each(|(key, [usual, _])| text.push_str(&format!("{key} = \"{usual}\"\n")));
    text.push_str(&format!("{PLANE} = \"\"\n"));
    for order in orders {
        text.push_str(&format!("\n[[table]]\norder = {order}\nrows = [\n"));
        for cylinder in pupil.engine.cylinders() {
            text.push_str(&format!("  {{ cylinder = {}, direct = \"\", reverse = \"\" }},\n", quoted(&cylinder.name)));
        }
        text.push_str("]\n[table.sums]\n");
        let keys = ["force_direct", "force_reverse", "moment_direct", "moment_reverse"];
        keys.iter().for_each(|key| text.push_str(&format!("{key} = \"\"\n")));
    }
    text
}

/// The same as lines for a spreadsheet.
pub fn csv_to_fill_in(pupil: &Pupil, orders: &[u32]) -> String {
    let mut lines = COLUMNS.join(",") + "\n";
    let mut line = |order: &str, row: &str, direct: &str| {
        let fields = [&pupil.file, &pupil.name.escaped(Format::Csv), order, row, direct, ""].map(field);
        lines.push_str(&(fields.join(",") + "\n"));
    };
    KEYS.iter().for_each(|(key, [usual, _])| line("", &format!("{CONVENTION}{key}"), usual));
    line("", &format!("{CONVENTION}{PLANE}"), "");
    for order in orders.iter().map(u32::to_string) {
        pupil.engine.cylinders().iter().for_each(|cylinder| line(&order, &format!("{CYLINDER}{}", cylinder.name), ""));
        SUMS.iter().for_each(|quantity| line(&order, sum_name(*quantity), ""));
    }
    lines
}
