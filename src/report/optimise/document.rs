//! What does `optimise --json` hold? The points with their counterweights and layout files, and uniform balance factors.

use num_traits::ToPrimitive;
use serde::Serialize;

use super::amounts::Units;
use crate::engine::Engine;
use crate::numbers;
use crate::optimise::{Couple, Design, Front, Optimum, PlacedWeight, Residual, Uniform};
use crate::page::Unit;

/// The best crankshafts, as data.
#[derive(Clone, Debug, Serialize)]
pub struct OptimiseDocument {
    title: String,
    /// Largest couple allowed, in newton-metres; 0 for none.
    couple_at_most: f64,
    /// What the loads are made least of: the masses, or gas and masses.
    loads_of: &'static str,
    load_unit: &'static str,
    couple_unit: &'static str,
    points: Vec<PointEntry>,
    uniform: Vec<UniformEntry>,
}

#[derive(Clone, Debug, Serialize)]
struct PointEntry {
    #[serde(flatten)]
    design: DesignEntry,
    /// No crankshaft of this mass has a lower largest load: weak duality, in floats.
    largest_load_at_least: f64,
    counterweights: Vec<WeightEntry>,
    /// The layout file.
    layout: String,
}

#[derive(Clone, Debug, Serialize)]
struct DesignEntry {
    mass_kg: f64,
    /// The same, exact.
    mass: String,
    largest_load: f64,
    worst_bearings: Vec<usize>,
    loads: Vec<f64>,
    direct_first_order_force: LeftEntry,
    direct_first_order_couple: LeftEntry,
}

#[derive(Clone, Debug, Serialize)]
struct LeftEntry {
    /// Decided exactly.
    vanishes: bool,
    at_least: f64,
    at_most: f64,
}

#[derive(Clone, Debug, Serialize)]
struct WeightEntry {
    position: String,
    radius_m: String,
    throw: Option<usize>,
    mass_kg: f64,
    mass_radius_kg_m: f64,
    angle_deg: f64,
    balance_factor: Option<f64>,
    skew_deg: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct UniformEntry {
    balance_factor: String,
    #[serde(flatten)]
    design: DesignEntry,
    /// None where no crankshaft so light keeps the conditions.
    best_of_that_mass: Option<PointEntry>,
    /// None where no crankshaft that keeps the conditions has so small a load.
    lightest_with_that_load: Option<PointEntry>,
}

/// The best crankshafts as data.
pub fn optimise_document(layout: &Engine, front: &Front, couple: &Couple) -> OptimiseDocument {
    let units = Units::of(layout, front);
    OptimiseDocument {
        title: layout.title().written().to_owned(),
        couple_at_most: match couple {
            Couple::Zero => 0.0,
            Couple::AtMost(most) => most.to_f64().unwrap_or(f64::NAN),
        },
        loads_of: if layout.effects().gas { "gas and masses" } else { "masses" },
        load_unit: units.force.name,
        couple_unit: match units.couple == Unit::NEWTON_METRE {
            true => Unit::NEWTON_METRE.name,
            false => "m r ω² times the unit of the positions",
        },
        points: front.points.iter().map(|entry| point(entry, units)).collect(),
        uniform: front.uniform.iter().map(|entry| uniform(entry, units)).collect(),
    }
}

fn point(point: &Optimum, units: Units) -> PointEntry {
    PointEntry {
        design: design(&point.design, units),
        largest_load_at_least: point.least * units.newtons,
        counterweights: point.design.weights.iter().map(weight).collect(),
        layout: point.engine.file().written().to_owned(),
    }
}

fn uniform(uniform: &Uniform, units: Units) -> UniformEntry {
    UniformEntry {
        balance_factor: uniform.factor.to_string(),
        design: design(&uniform.design, units),
        best_of_that_mass: uniform.best.as_ref().map(|best| point(best, units)),
        lightest_with_that_load: uniform.lightest.as_ref().map(|lightest| point(lightest, units)),
    }
}

fn design(design: &Design, units: Units) -> DesignEntry {
    DesignEntry {
        mass_kg: design.mass.to_f64().unwrap_or(f64::NAN),
        mass: design.mass.to_string(),
        largest_load: design.peak() * units.newtons,
        worst_bearings: design.worst.iter().map(|index| index + 1).collect(),
        loads: design.peaks.iter().map(|peak| peak * units.newtons).collect(),
        direct_first_order_force: left(design.force),
        direct_first_order_couple: left(design.couple),
    }
}

fn left(left: Residual) -> LeftEntry {
    match left {
        Residual::Zero => LeftEntry { vanishes: true, at_least: 0.0, at_most: 0.0 },
        Residual::Between(low, high) => LeftEntry { vanishes: false, at_least: low, at_most: high },
    }
}

fn weight(weight: &PlacedWeight) -> WeightEntry {
    WeightEntry {
        position: weight.place.position.to_string(),
        radius_m: weight.place.radius.to_string(),
        throw: weight.place.throw.map(|throw| throw + 1),
        mass_kg: weight.mass.to_f64().unwrap_or(f64::NAN),
        mass_radius_kg_m: weight.mass_radius.norm(),
        angle_deg: numbers::degrees(weight.mass_radius),
        balance_factor: weight.factor,
        skew_deg: weight.skew,
    }
}
