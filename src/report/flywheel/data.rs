//! Which columns hold what a turning-moment diagram tells? A row for all of it, one for each area, one for each angle that is asked for.

use num_traits::ToPrimitive;

use super::FlywheelStudy;
use crate::flywheel::WithPi;
use crate::report::data::Filling;
use crate::table::{Table, Unit};

/// A table of a turning-moment diagram.
pub fn table(study: &FlywheelStudy, name: &str) -> Option<Table> {
    match name {
        "values" => Some(values(study)),
        "areas" => Some(areas(study)),
        "angles" => Some(angles(study)),
        _ => None,
    }
}

/// Its closed form with the power of π.
fn exact(value: &WithPi) -> Option<String> {
    let form = value.form.as_ref()?;
    Some(match value.power {
        0 => form.to_string(),
        1 => format!("π·({form})"),
        -1 => format!("1/π·({form})"),
        power => format!("π^{power}·({form})"),
    })
}

fn values(study: &FlywheelStudy) -> Table {
    let mut table = Filling::new("flywheel.values", [&study.fluctuation]).keyed(0);
    let decimal = |value: &Option<WithPi>| value.as_ref().map(|value| value.decimal);
    let closed = |value: &Option<WithPi>| value.as_ref().and_then(exact);
    table.decimal("mean_torque_{unit}", Unit::NEWTON_METRE, |row| decimal(&row.mean));
    table.decimal("work_{unit}", Unit::JOULE, |row| decimal(&row.work));
    table.decimal("energy_{unit}", Unit::JOULE, |row| Some(row.energy.decimal));
    table.exact("energy_exact", Unit::NONE, |row| exact(&row.energy));
    table.decimal("energy_coefficient", Unit::NONE, |row| decimal(&row.energy_coefficient));
    table.decimal("fastest_{unit}", Unit::DEGREE, |row| row.fastest_and_slowest.map(|[fastest, _]| fastest));
    table.decimal("slowest_{unit}", Unit::DEGREE, |row| row.fastest_and_slowest.map(|[_, slowest]| slowest));
    table.decimal("irregularity", Unit::NONE, |row| decimal(&row.irregularity));
    table.exact("irregularity_exact", Unit::NONE, |row| closed(&row.irregularity));
    table.decimal("inertia_{unit}", Unit::KILOGRAM_SQUARE_METRE, |row| decimal(&row.inertia));
    table.exact("inertia_exact", Unit::NONE, |row| closed(&row.inertia));
    table.decimal("mass_{unit}", Unit::KILOGRAM, |row| decimal(&row.mass));
    table.decimal("power_{unit}", Unit::WATT, |row| decimal(&row.power));
    table.done()
}

fn areas(study: &FlywheelStudy) -> Table {
    let mut table = Filling::new("flywheel.areas", &study.fluctuation.lobes);
    table.decimal("from_{unit}", Unit::DEGREE, |row| row.from.as_ref()?.to_f64().map(degrees));
    table.decimal("work_{unit}", Unit::JOULE, |row| Some(row.work.decimal));
    table.exact("work_exact", Unit::NONE, |row| exact(&row.work));
    table.decimal("sum_{unit}", Unit::JOULE, |row| Some(row.sum.decimal));
    table.exact("sum_exact", Unit::NONE, |row| exact(&row.sum));
    table.done()
}

fn degrees(turns: f64) -> f64 {
    turns * 360.0
}

fn angles(study: &FlywheelStudy) -> Table {
    let mut table = Filling::new("flywheel.angles", &study.fluctuation.angles);
    table.decimal("angle_{unit}", Unit::DEGREE, |row| row.angle.to_f64().map(degrees));
    table.decimal("torque_{unit}", Unit::NEWTON_METRE, |row| Some(row.torque));
    table.decimal("load_{unit}", Unit::NEWTON_METRE, |row| Some(row.load));
    table.decimal("acceleration_rad_per_s2", Unit::NONE, |row| row.acceleration);
    table.done()
}
