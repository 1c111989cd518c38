//! Which columns hold the best crankshafts? A row a point of the front, a counterweight, a bearing, a uniform balance factor.

use num_traits::ToPrimitive;

use crate::numbers;
use crate::optimise::{Design, Residual};
use crate::report::OptimiseStudy;
use crate::report::data::Filling;
use crate::report::data::exact_number;
use crate::table::{Table, Unit};

/// A table of the best crankshafts.
pub fn table(study: &OptimiseStudy, name: &str) -> Option<Table> {
    Some(match name {
        "points" => points(study),
        "counterweights" => counterweights(study),
        "bearings" => bearings(study),
        "uniform" => uniform(study)?,
        _ => return None,
    })
}

fn points(study: &OptimiseStudy) -> Table {
    let mut table = Filling::new("optimise.points", study.front.points.iter().enumerate());
    table.whole("point", |(index, _)| index + 1);
    of_design(&mut table, study, |(_, point)| &point.design);
    let units = study.units();
    table.decimal("largest_load_at_least_{unit}", units.force, |(_, point)| Some(point.least * units.newtons));
    table.words("layout", |(_, point)| Some(point.engine.file().written().to_owned()));
    table.done()
}

/// The columns that every crankshaft has.
fn of_design<R>(table: &mut Filling<R>, study: &OptimiseStudy, of: impl Fn(&R) -> &Design) {
    let units = study.units();
    table.decimal("mass_{unit}", Unit::KILOGRAM, |row| of(row).mass.to_f64());
    table.exact("mass_exact_{unit}", Unit::KILOGRAM, |row| Some(exact_number(&of(row).mass)));
    table.decimal("largest_load_{unit}", units.force, |row| Some(of(row).peak() * units.newtons));
    table.words("worst_bearings", |row| {
        Some(of(row).worst.iter().map(|index| (index + 1).to_string()).collect::<Vec<_>>().join(" "))
    });
    type Part = fn(&Design) -> Residual;
    let parts: [(&str, Unit, Part); 2] =
        [("force", units.force, |design| design.force), ("couple", units.couple, |design| design.couple)];
    for (part, unit, residual) in parts {
        let ends = |row: &R| match residual(of(row)) {
            Residual::Zero => [0.0; 2],
            Residual::Between(low, high) => [low, high],
        };
        table.decimal(("{part}_1_direct_zero_to_peak_{unit}", part), unit, |row| Some(ends(row)[1]));
        table.decimal(("{part}_1_direct_at_least_{unit}", part), unit, |row| Some(ends(row)[0]));
        table.truth(("{part}_1_direct_vanishes", part), |row| Some(residual(of(row)) == Residual::Zero));
    }
}

fn counterweights(study: &OptimiseStudy) -> Table {
    let all = study.front.points.iter().enumerate();
    let rows = all.flat_map(|(point, best)| {
        best.design.weights.iter().enumerate().map(move |(weight, placed)| (point + 1, weight + 1, placed))
    });
    let mut table = Filling::new("optimise.counterweights", rows).keyed(2);
    table.whole("point", |(point, ..)| *point);
    table.whole("counterweight", |(_, weight, _)| *weight);
    table.maybe_whole("throw", |(.., placed)| placed.place.throw.map(|t| t + 1));
    table.exact("position", Unit::NONE, |(.., placed)| Some(exact_number(&placed.place.position)));
    table.exact("radius_{unit}", Unit::METRE, |(.., placed)| Some(exact_number(&placed.place.radius)));
    table.decimal("mass_{unit}", Unit::KILOGRAM, |(.., placed)| placed.mass.to_f64());
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |(.., placed)| Some(placed.mass_radius.norm()));
    table.decimal("angle_{unit}", Unit::DEGREE, |(.., placed)| {
        (placed.mass_radius.norm() > 0.0).then(|| numbers::degrees(placed.mass_radius))
    });
    table.decimal("balance_factor", Unit::NONE, |(.., placed)| placed.factor);
    table.decimal("skew_{unit}", Unit::DEGREE, |(.., placed)| placed.skew);
    table.done()
}

fn bearings(study: &OptimiseStudy) -> Table {
    let units = study.units();
    let all = study.front.points.iter().enumerate();
    let rows = all.flat_map(|(point, best)| {
        best.design.peaks.iter().enumerate().map(move |(bearing, load)| (point + 1, bearing + 1, *load))
    });
    let mut table = Filling::new("optimise.bearings", rows).keyed(2);
    table.whole("point", |(point, ..)| *point);
    table.whole("bearing", |(_, bearing, _)| *bearing);
    table.decimal("largest_load_{unit}", units.force, |(.., load)| Some(load * units.newtons));
    table.done()
}

fn uniform(study: &OptimiseStudy) -> Option<Table> {
    let units = study.units();
    let mut table = Filling::new("optimise.uniform", study.front.uniform.iter());
    table.exact("balance_factor", Unit::NONE, |row| Some(exact_number(&row.factor)));
    of_design(&mut table, study, |row| &row.design);
    table.decimal("best_of_that_mass_{unit}", units.force, |row| {
        row.best.as_ref().map(|best| best.design.peak() * units.newtons)
    });
    table.decimal("lightest_with_that_load_{unit}", Unit::KILOGRAM, |row| {
        row.lightest.as_ref().and_then(|lightest| lightest.design.mass.to_f64())
    });
    table.done_if_any()
}
