//! How are the numbers of an engine shown, so that a reader can work them out again? A calculation report.
//!
//! `inputs → equations → lines (symbol = formula = figures = result) → tables and plots → limits`

mod amounts;
mod equations;
mod expression;
mod inputs;
mod largest;
mod plots;
mod results;
mod summary;
mod words;

use serde::Serialize;

pub(super) use amounts::{Unit, largest, plain, vector};
pub use largest::Numbers;
pub(super) use plots::figures;
pub use summary::{Rows, loads_lines, loads_rows};

use super::dialect::Dialect;
use super::loads_document::share;
use super::page::NamedFigure;
use super::table::Table;
use crate::engine::Engine;
use crate::loads::{Loads, Missing, Needed, Peak, Waveform};
use crate::numbers;
use crate::order::MassGroup;
use crate::proof::Quantity;
use expression::Line;
use results::Group;

/// The section with the numbers, as finished strings.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Calculation {
    missing: Option<String>,
    results: Option<Results>,
}

/// What a calculation report holds besides title block and layout file.
#[derive(Clone, Debug, Serialize)]
struct Results {
    effects: Table,
    shares: String,
    inputs: Table,
    turning: Option<Table>,
    source: Option<String>,
    assumptions: Vec<String>,
    nomenclature: Table,
    equations: Vec<Equation>,
    derived: Vec<String>,
    vectors: Table,
    ellipses: Table,
    units: String,
    orders: Vec<Lines>,
    peaks: Vec<Lines>,
    torque: Option<TorqueSection>,
    bearings: Option<BearingSection>,
    needed: Option<String>,
    plots: Vec<super::page::Drawing>,
    limits: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct Equation {
    words: String,
    formula: String,
}

#[derive(Clone, Debug, Serialize)]
struct Lines {
    heading: String,
    words: String,
    lines: Vec<String>,
}

/// What the main bearings feel.
#[derive(Clone, Debug, Serialize)]
struct BearingSection {
    words: Vec<String>,
    peaks: Table,
    orders: Table,
    assumptions: Vec<String>,
    plots: Vec<super::page::Drawing>,
}

#[derive(Clone, Debug, Serialize)]
struct TorqueSection {
    table: Table,
    lines: Vec<String>,
    peak: String,
}

/// The loads of a layout that holds numbers; none where the file gives none.
pub(super) fn numbers_of(engine: &Engine, orders: &[u32], needed: Option<&Needed>) -> Option<Result<Numbers, Missing>> {
    let asks = engine.dimensions().given.iter().any(|given| given.quantity != crate::engine::Measure::Speed);
    asks.then(|| Numbers::new(engine, orders, needed))
}

impl Calculation {
    /// Sets the numbers of an engine; `plots` are the drawings of [`figures`].
    pub fn new(
        engine: &Engine,
        numbers: &Result<Numbers, Missing>,
        needed: Option<&Needed>,
        plots: Vec<super::page::Drawing>,
        dialect: Dialect,
    ) -> Self {
        match numbers {
            Err(missing) => {
                Calculation { missing: Some(dialect.prose(&format!("No numbers: {missing}."))), results: None }
            }
            Ok(numbers) => {
                Calculation { missing: None, results: Some(Results::new(engine, numbers, needed, plots, dialect)) }
            }
        }
    }
}

impl Results {
    fn new(
        engine: &Engine,
        numbers: &Numbers,
        needed: Option<&Needed>,
        plots: Vec<super::page::Drawing>,
        dialect: Dialect,
    ) -> Self {
        let loads = &numbers.loads;
        let display = |line: &Line| dialect.display(&line.tex());
        let lines = |group: Group, words: String| Lines {
            heading: group.heading,
            words: dialect.prose(&words),
            lines: group.lines.iter().map(display).collect(),
        };
        let prose = |lines: Vec<String>| lines.iter().map(|line| dialect.prose(line)).collect::<Vec<_>>();
        let largest = largest::largest_lines(engine, numbers);
        let mut largest = largest.into_iter();
        let mut peak = |quantity: Quantity, waveform: &Waveform| {
            let words = largest.next().unwrap_or_default();
            match results::peak(engine, loads, quantity) {
                None => lines(Group { heading: String::new(), lines: Vec::new() }, words),
                Some(group) => {
                    let listed = summary::peak(&waveform.peak(), Unit::of(engine, loads, quantity));
                    lines(group, format!("{words} The orders listed come to {listed}:"))
                }
            }
        };
        let peaks = vec![peak(Quantity::Force, &loads.force), peak(Quantity::Moment, &loads.moment)];
        let torque = torque_section(engine, loads, largest.next(), dialect);
        let equation =
            |(words, tex): (&str, String)| Equation { words: dialect.prose(words), formula: dialect.display(&tex) };
        Results {
            effects: effects_table(engine, loads, dialect),
            shares: dialect.prose(
                "The share is what the effect adds, along the direction of the peak, where the peak stands; the shares of a column sum to the peak.",
            ),
            inputs: Table::new(dialect, &["Quantity", "Symbol", "Value", "As written", "Cylinder"], quoted(inputs::rows(engine), 3)),
            turning: turning_table(engine, dialect),
            source: engine.dimensions().source.as_ref().map(|source| dialect.quoted(source)),
            assumptions: prose(words::assumptions(engine, loads))
                .into_iter()
                .chain(engine.title_block().assumptions.iter().map(|assumption| dialect.quoted(assumption)))
                .collect(),
            nomenclature: Table::new(dialect, &["Symbol", "Meaning", "Unit"], words::nomenclature(engine, loads)),
            equations: equations::equations(engine, loads).into_iter().map(equation).collect(),
            derived: inputs::lines(engine, loads).iter().map(display).collect(),
            vectors: vectors_table(engine, loads, dialect),
            ellipses: ellipses_table(engine, loads, dialect),
            units: dialect.prose(&units(engine, loads)),
            orders: results::orders(engine, loads).into_iter().map(|group| lines(group, String::new())).collect(),
            peaks,
            torque,
            bearings: None,
            needed: Some(largest::chosen_lines(engine, numbers, needed).join(" ")).filter(|words| !words.is_empty()).map(|words| dialect.prose(&words)),
            plots,
            limits: prose(words::limits(engine, loads)),
        }
    }
}

/// The masses on the crankshaft and the balancer shafts, where there are any.
fn turning_table(engine: &Engine, dialect: Dialect) -> Option<Table> {
    let header = ["Turning mass", "Mass in kg", "Radius in m", "Angle at θ = 0", "Position z", "Turns a revolution"];
    let rows = inputs::turning(engine);
    (!rows.is_empty()).then(|| Table::new(dialect, &header, rows))
}

/// The table of inputs with a person's words in the given column: nothing in them is markup.
fn quoted(mut rows: Vec<Vec<String>>, column: usize) -> Vec<Vec<String>> {
    for row in &mut rows {
        row[column] = row[column].replace(['$', '*', '|', '`'], " ");
    }
    rows
}

fn effects_table(engine: &Engine, loads: &Loads, dialect: Dialect) -> Table {
    let peaks: [(Peak, Unit); 2] = [
        (loads.force.peak(), Unit::of(engine, loads, Quantity::Force)),
        (loads.moment.peak(), Unit::of(engine, loads, Quantity::Moment)),
    ];
    let shares = |group: MassGroup| {
        let loads = loads.groups.iter().find(|loads| loads.group == group);
        let cell = |place: usize| {
            let (peak, unit) = &peaks[place];
            match loads.map(|loads| [&loads.force, &loads.moment][place]) {
                Some(waveform) if peak.value == 0.0 || waveform.harmonics().is_empty() => "0".to_owned(),
                Some(waveform) => format!("≈ {} {}", amounts::digits(share(waveform, peak) * unit.factor), unit.name),
                None => "–".to_owned(),
            }
        };
        [cell(0), cell(1)]
    };
    let row = |row: words::EffectRow| {
        let inside = if row.inside { "yes" } else { "no" };
        let shares = row.group.map_or_else(|| ["–".to_owned(), "–".to_owned()], shares);
        [row.name.to_owned(), inside.to_owned(), row.why].into_iter().chain(shares).collect()
    };
    let rows = words::effects(engine, loads).into_iter().map(row);
    let header = ["Effect", "In the scene", "Why", "Share of peak force", "Share of peak moment"];
    Table::new(dialect, &header, rows.collect())
}

fn vectors_table(engine: &Engine, loads: &Loads, dialect: Dialect) -> Table {
    let (force, moment) = (Unit::of(engine, loads, Quantity::Force), Unit::of(engine, loads, Quantity::Moment));
    let row = |order: &crate::loads::OrderLoads| {
        vec![
            order.order.to_string(),
            plain(amounts::vector(&order.force.direct, force)),
            plain(amounts::vector(&order.force.reverse, force)),
            plain(amounts::vector(&order.moment.direct, moment)),
            plain(amounts::vector(&order.moment.reverse, moment)),
        ]
    };
    let header = ["Order", "Force, direct", "Force, reverse", "Moment, direct", "Moment, reverse"];
    Table::new(dialect, &header, loads.orders.iter().map(row).collect())
}

fn ellipses_table(engine: &Engine, loads: &Loads, dialect: Dialect) -> Table {
    let mut rows = Vec::new();
    for order in &loads.orders {
        for (name, quantity, swing) in
            [("force", Quantity::Force, &order.force), ("moment", Quantity::Moment, &order.moment)]
        {
            let unit = Unit::of(engine, loads, quantity);
            let mut row = vec![order.order.to_string(), name.to_owned(), plain(amounts::largest(swing, unit))];
            if swing.vanishes() {
                row.extend(["0", "–", "0", "0", "0"].map(str::to_owned));
            } else {
                let largest = swing.largest();
                // What is zero only as far as the decimals go is not said to be.
                let part = |value: f64, is_zero: bool| match is_zero {
                    true => "0".to_owned(),
                    false if value <= 1e-12 * largest => "≈ 0".to_owned(),
                    false => plain(amounts::amount(value, unit)),
                };
                row.push(part(swing.smallest(), swing.path.is_line));
                row.push(
                    swing.direction().map_or("–".to_owned(), |degrees| format!("≈ {}°", amounts::digits(degrees))),
                );
                row.push(part(swing.along(), swing.path.nothing_along));
                row.push(part(swing.across(), swing.path.nothing_across));
                row.push(format!("≈ {}", amounts::digits(largest)));
            }
            rows.push(row);
        }
    }
    let header = ["Order", "Quantity", "Largest", "Smallest", "Direction", "Along", "Across", "Largest / unit"];
    Table::new(dialect, &header, rows)
}

fn units(engine: &Engine, loads: &Loads) -> String {
    let (force, moment) = (Unit::of(engine, loads, Quantity::Force), Unit::of(engine, loads, Quantity::Moment));
    let arm = if crate::loads::Arm::of(engine) == crate::loads::Arm::Metre { "1 m" } else { "the spacing a" };
    format!(
        "Forces in {}, moments in {}; the last column counts forces in m r ω² and moments in that times {arm}. All amplitudes are \
         zero-to-peak. 0 is exact and proved, ≈ stands before decimals. Along: the component in the reference direction, the bisector of the banks \
         of a V; across: at right angles to it. The moment of the forces along it is the pitching moment, that of the forces across it the \
         yawing moment. Angles of the vectors are those at θ = 0.",
        force.name, moment.name
    )
}

fn torque_section(engine: &Engine, loads: &Loads, largest: Option<String>, dialect: Dialect) -> Option<TorqueSection> {
    let torque = loads.torque.as_ref()?;
    let unit = Unit::of(engine, loads, Quantity::Torque);
    let row = |order: &crate::loads::TorqueOrder| {
        let angle = match order.vector.outcome {
            crate::loads::Outcome::Zero => "–".to_owned(),
            _ => format!("≈ {}°", amounts::digits(numbers::degrees(order.vector.value))),
        };
        let dimensionless = match order.vector.outcome {
            crate::loads::Outcome::Zero => "0".to_owned(),
            _ => format!("≈ {}", amounts::digits(order.vector.value.norm())),
        };
        vec![order.order.to_string(), summary::torque_cell(engine, order, unit), angle, dimensionless]
    };
    let header = [
        "Order".to_owned(),
        format!("Amplitude in {}", unit.name),
        "Phase at θ = 0".to_owned(),
        "In m r² ω²".to_owned(),
    ];
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    Some(TorqueSection {
        table: Table::new(dialect, &header, torque.orders.iter().map(row).collect()),
        lines: results::torque(engine, loads)
            .into_iter()
            .flat_map(|group| group.lines)
            .map(|line| dialect.display(&line.tex()))
            .collect(),
        peak: dialect.prose(&largest.unwrap_or_default()),
    })
}
