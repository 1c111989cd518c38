//! Which columns hold the answer to each question? Tables of the same values that pages and documents show.
//!
//! A question has one table or several, the main one first. `docs/data.md` lists every column of every table, which a test holds it to.
//! Amplitudes are zero to peak. Where a number is proved to be 0 it is 0, and the column beside it that ends in `vanishes` is true.

mod accuracy;
mod angle;
mod bearings;
mod cells;
mod classify;
mod compare;
mod filling;
mod firing;
mod gas_loads;
mod loads;
mod moments;
#[cfg(feature = "optimise")]
mod optimise;
mod remedy;
mod rotor;
mod search;
mod sentences;
mod sweep;
mod torque;
mod torsion;
mod values;
mod verdicts;
mod zeros;

pub use accuracy::accuracy;
pub use angle::angle;
pub use bearings::bearings;
pub use cells::exact_number;
pub use classify::classify;
pub use compare::compare;
pub use firing::firing;
pub use loads::loads;
pub use moments::moments;
#[cfg(feature = "optimise")]
pub use optimise::optimise;
pub use remedy::remedy;
pub use rotor::rotor;
pub use search::search;
pub use sweep::{points as sweep_points, sweep};
pub use torque::torque;
pub use torsion::torsion;
pub use values::values;

/// The questions that have tables, each with the names of all tables that its answer may have, the main one first.
pub const TABLES: [(&str, &[&str]); 16] = [
    ("classify", &["orders", "sums", "torque", "roll"]),
    ("loads", &["orders", "torque", "roll", "theta", "largest"]),
    (
        "bearings",
        &[
            "bearings",
            "worst",
            "orders",
            "terms",
            "theta",
            "pins",
            "pin_orders",
            "parts",
            "gas_bearings",
            "gas_cylinders",
            "gas_pins",
            "gas_orders",
            "gas_pin_orders",
            "gas_theta",
        ],
    ),
    ("firing", &["orders"]),
    ("torque", &["orders", "cycle", "flywheel", "classes", "guides", "theta"]),
    ("angle", &["pistons", "torque", "bearings"]),
    ("moments", &["moments", "guides"]),
    ("rotor", &["masses", "left"]),
    ("values", &["values"]),
    ("torsion", &["modes", "critical", "discs", "shapes", "cylinders", "forced"]),
    ("accuracy", &["methods", "peaks"]),
    ("remedy", &["weights"]),
    ("optimise", &["points", "counterweights", "bearings", "uniform"]),
    ("compare", &["orders", "engines"]),
    ("search", &["stars", "question", "firing_orders"]),
    ("sweep", &["points", "zeros", "firing_zeros"]),
];

/// The names of the tables of a question, the main one first; none where it has none.
pub fn tables_of(question: &str) -> &'static [&'static str] {
    TABLES.iter().find(|(name, _)| *name == question).map_or(&[], |(_, tables)| *tables)
}
