//! Which columns hold the best crankshafts? A row a point of the front, a counterweight, a bearing, a uniform balance factor.

use num_traits::ToPrimitive;

use super::cells::exact_number;
use super::filling::Filling;
use crate::numbers;
use crate::optimise::{Design, Optimum, PlacedWeight, Residual, Uniform};
use crate::report::OptimiseStudy;
use crate::table::{Table, Unit};

/// A table of the best crankshafts.
pub fn optimise(study: &OptimiseStudy, name: &str) -> Option<Table> {
    Some(match name {
        "points" => points(study),
        "counterweights" => counterweights(study),
        "bearings" => bearings(study),
        "uniform" => uniform(study)?,
        _ => return None,
    })
}

const POINT: &str = "its number, from the lightest crankshaft to the one with the least load";

fn points(study: &OptimiseStudy) -> Table {
    let rows: Vec<(usize, &Optimum)> = study.front.points.iter().enumerate().collect();
    let mut table = Filling::new("points", "one of the best crankshafts", &rows);
    table.whole("point", POINT, |(index, _)| index + 1);
    of_design(&mut table, study, |(_, point)| &point.design);
    let units = study.units();
    let about =
        "no crankshaft of this mass that keeps the conditions has a lower largest load: weak duality, in floats";
    table.decimal("largest_load_at_least_{unit}", units.force, about, |(_, point)| Some(point.least * units.newtons));
    table.words("layout", "the engine as a layout file", |(_, point)| Some(point.engine.file().written().to_owned()));
    table.done()
}

/// The columns that every crankshaft has.
fn of_design<R>(table: &mut Filling<R>, study: &OptimiseStudy, of: impl Fn(&R) -> &Design) {
    let units = study.units();
    table.decimal("mass_{unit}", Unit::KILOGRAM, "mass of the crankshaft", |row| of(row).mass.to_f64());
    let about = "the same, exact";
    table.exact("mass_exact_{unit}", Unit::KILOGRAM, about, |row| Some(exact_number(&of(row).mass)));
    let about = "largest load of any main bearing, zero to peak";
    table.decimal("largest_load_{unit}", units.force, about, |row| Some(of(row).peak() * units.newtons));
    table.words("worst_bearings", "the bearings with that load, from 1", |row| {
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
        let about = "residual of order 1 that turns with the crank: at most this";
        table.decimal(("{part}_1_direct_zero_to_peak_{unit}", part), unit, about, |row| Some(ends(row)[1]));
        let about = "at least this";
        table.decimal(("{part}_1_direct_at_least_{unit}", part), unit, about, |row| Some(ends(row)[0]));
        let about = "whether it is proved to be 0";
        table.truth(("{part}_1_direct_vanishes", part), about, |row| Some(residual(of(row)) == Residual::Zero));
    }
}

fn counterweights(study: &OptimiseStudy) -> Table {
    let all = study.front.points.iter().enumerate();
    let rows: Vec<(usize, usize, &PlacedWeight)> = all
        .flat_map(|(point, best)| {
            best.design.weights.iter().enumerate().map(move |(weight, placed)| (point + 1, weight + 1, placed))
        })
        .collect();
    let mut table = Filling::new("counterweights", "a counterweight of one of the best crankshafts", &rows).keyed(2);
    table.whole("point", POINT, |(point, ..)| *point);
    table.whole("counterweight", "its number, by the order of their planes", |(_, weight, _)| *weight);
    table.maybe_whole("throw", "the throw it belongs to, from 1", |(.., placed)| placed.place.throw.map(|t| t + 1));
    let about = "its position along the crankshaft, in the unit of the layout";
    table.exact("position", Unit::NONE, about, |(.., placed)| Some(exact_number(&placed.place.position)));
    let about = "radius of its centre of gravity";
    table.exact("radius_{unit}", Unit::METRE, about, |(.., placed)| Some(exact_number(&placed.place.radius)));
    table.decimal("mass_{unit}", Unit::KILOGRAM, "its mass", |(.., placed)| placed.mass.to_f64());
    let about = "its mass times radius";
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, about, |(.., placed)| Some(placed.mass_radius.norm()));
    let about = "its direction at a crank angle of 0; empty without a weight";
    table.decimal("angle_{unit}", Unit::DEGREE, about, |(.., placed)| {
        (placed.mass_radius.norm() > 0.0).then(|| numbers::degrees(placed.mass_radius))
    });
    let about = "its part of the balance factor of its throw";
    table.decimal("balance_factor", Unit::NONE, about, |(.., placed)| placed.factor);
    let about = "how far it is turned on from opposite to its throw";
    table.decimal("skew_{unit}", Unit::DEGREE, about, |(.., placed)| placed.skew);
    table.done()
}

fn bearings(study: &OptimiseStudy) -> Table {
    let units = study.units();
    let all = study.front.points.iter().enumerate();
    let rows: Vec<(usize, usize, f64)> = all
        .flat_map(|(point, best)| {
            best.design.peaks.iter().enumerate().map(move |(bearing, load)| (point + 1, bearing + 1, *load))
        })
        .collect();
    let mut table = Filling::new("bearings", "a main bearing with one of the best crankshafts", &rows).keyed(2);
    table.whole("point", POINT, |(point, ..)| *point);
    table.whole("bearing", "its number, from 1", |(_, bearing, _)| *bearing);
    let about = "its largest load, zero to peak";
    table.decimal("largest_load_{unit}", units.force, about, |(.., load)| Some(load * units.newtons));
    table.done()
}

fn uniform(study: &OptimiseStudy) -> Option<Table> {
    let rows: Vec<&Uniform> = study.front.uniform.iter().collect();
    if rows.is_empty() {
        return None;
    }
    let units = study.units();
    let about = "one balance factor for all throws, and the best crankshafts beside it";
    let mut table = Filling::new("uniform", about, &rows);
    table.exact("balance_factor", Unit::NONE, "the factor", |row| Some(exact_number(&row.factor)));
    of_design(&mut table, study, |row| &row.design);
    let about = "largest load of the best crankshaft of the same mass; empty where none is so light";
    table.decimal("best_of_that_mass_{unit}", units.force, about, |row| {
        row.best.as_ref().map(|best| best.design.peak() * units.newtons)
    });
    let about = "mass of the lightest crankshaft with no larger a load; empty where there is none";
    table.decimal("lightest_with_that_load_{unit}", Unit::KILOGRAM, about, |row| {
        row.lightest.as_ref().and_then(|lightest| lightest.design.mass.to_f64())
    });
    Some(table.done())
}
