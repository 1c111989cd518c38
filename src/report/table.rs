//! Which tables does the report of an engine hold?

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::engine_page::Weighed;
use super::firmness;
use super::residual;
use super::rising;
use super::star::WholeStars;
use super::typeset;
use crate::engine::{Cylinder, Engine, LengthUnit, Rotation};
use crate::exact::{Turn, fraction};
use crate::loads;
use crate::numbers;
use crate::order::{self, Factor, Source, TurningMass};
use crate::page::{Columns, Number, Piece, Table, Text, Unit, number, phrase};
use crate::proof::{Planar, Sense};
use crate::verdict::{OrderBalance, OrderVerdict, Theorem, Verdict, WholeOrder};

/// Orders × (force, moment): what is left, exactly, whether the moment is a couple, how firm the zeros of the pistons are.
///
/// An order of several sums has a row for the whole, and one for each.
pub(super) fn summary(
    engine: &Engine,
    orders: &[OrderVerdict],
    weighed: Option<&Weighed>,
    with_firmness: Firmness,
) -> Table {
    let firm = |order: &&OrderVerdict| match order.parts.as_slice() {
        [only] if only.class.is_none() => firmness::summary(engine, only),
        _ => "–".into(),
    };
    let table = of_orders(orders, weighed).column_if(with_firmness == Firmness::Shown, "Its zeros", firm);
    with_shared_rows(table.done(), &small(orders, weighed))
}

/// The exact sums of orders that are made of several: what is multiplied by one number each.
pub(super) fn sums(orders: &[OrderVerdict]) -> Option<Table> {
    let parts = orders.iter().filter(|order| order.parts.len() > 1).flat_map(|order| &order.parts);
    Table::of(parts)
        .column("Order", |part| residual::order_name(part))
        .column("Force", |part| residual::force(part))
        .column("Moment", |part| residual::moment(part))
        .done_if_any()
}

/// Order, and force and moment: how large, where that is known, and exactly.
fn of_orders<'a>(orders: &'a [OrderVerdict], weighed: Option<&Weighed>) -> Columns<&'a OrderVerdict> {
    let mut table = Table::of(orders).column("Order", |order| order.order);
    let named = [(Planar::Force, "Force", "Force in {}"), (Planar::Moment, "Moment", "Moment in {}")];
    for (place, (quantity, bare, in_unit)) in named.into_iter().enumerate() {
        if let Some((unit, cell)) = weighed.map(|weighed| weighed.column(quantity)) {
            table = table.column(phrase!(in_unit, unit.label()), |order| cell(order));
        }
        let exactly = if weighed.is_some() { "exactly" } else { bare };
        table = table.column(exactly, |order| match weighed.is_some() && order.parts.len() > 1 {
            true => residual::beside_size(order.whole(quantity)),
            false => residual::whole(order)[place].clone(),
        });
    }
    table
}

/// The same table; neighbouring orders that are small share a row, with what they have in common once.
pub(super) fn with_shared_rows(table: Table, small: &[bool]) -> Table {
    let rows: Vec<(&Vec<Text>, &bool)> = table.rows.iter().zip(small).collect();
    let share = |shared: &[(&Vec<Text>, &bool)]| {
        let cell = |column: usize| {
            let (first, of_each) = (&shared[0].0[column], shared.iter().map(|(row, _)| row[column].clone()));
            let is_one = of_each.clone().all(|cell| cell.plain() == first.plain());
            if is_one { first.clone() } else { Text::joined(of_each, "; ") }
        };
        (0..table.header.len()).map(cell).collect()
    };
    let rows = rows.chunk_by(|(_, one), (_, next)| **one && **next).map(share).collect();
    Table { header: table.header, rows }
}

/// Whether each order is reported together with others: something of it is left, and little.
fn small(orders: &[OrderVerdict], weighed: Option<&Weighed>) -> Vec<bool> {
    let is_small = |order: &OrderVerdict| {
        let has_others = order.torque.is_some() || order.roll.is_some();
        weighed.is_some_and(|weighed| {
            let wholes = || Planar::BOTH.into_iter().map(|of| order.whole(of));
            let is_known = wholes().flat_map(|whole| &whole.outcomes).all(|outcome| outcome.vanishes().is_some());
            let is_left = wholes().any(WholeOrder::is_left);
            is_known && is_left && !has_others && Planar::BOTH.into_iter().all(|of| !weighed.is_told(order.order, of))
        })
    };
    orders.iter().map(is_small).collect()
}

/// Orders × (force, moment, torque, roll moment): what is left, exactly.
pub(super) fn verdicts(orders: &[OrderVerdict], weighed: Option<&Weighed>) -> Table {
    let with_torque = orders.iter().any(|order| order.torque.is_some());
    let with_roll = orders.iter().any(|order| order.roll.is_some());
    let table = of_orders(orders, weighed)
        .column_if(with_torque, "Torque", |order| order.torque.as_ref().map(residual::torque).unwrap_or_default())
        .column_if(with_roll, "Roll", |order| order.roll.as_ref().map(residual::roll).unwrap_or_default());
    with_shared_rows(table.done(), &small(orders, weighed))
}

/// Whether a summary says how firm the zeros are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Firmness {
    /// It has a column of its own.
    Shown,
    /// The verdicts are not on the pistons alone.
    NotShown,
}

/// One row per cylinder: throw, bank, position, and mass where they differ from 1; and the angles of a file that counts the
/// other way, as they are drawn there.
pub(super) fn cylinders(engine: &Engine) -> Table {
    let convention = engine.convention();
    let counts_otherwise = convention.rotation == Rotation::Clockwise;
    let bank = |angle: &Turn| typeset::degrees(&typeset::signed_degrees(angle));
    Table::of(engine.cylinders())
        .column("Cylinder", |cylinder| cylinder.name.clone())
        .column("Throw β", |cylinder| typeset::angle(&cylinder.throw))
        .column("Bank α", |cylinder| bank(&cylinder.bank))
        .column(position_heading(engine), |cylinder| position(engine, &cylinder.position))
        .column_if(!engine.has_unit_masses(), "Reciprocating mass / m", |one| Number::exact(&one.reciprocating_mass))
        .column_if(counts_otherwise, "Throw as drawn", |one| typeset::angle(&convention.as_written(&one.throw)))
        .column_if(counts_otherwise, "Bank as drawn", |cylinder| bank(&convention.as_written(&cylinder.bank)))
        .done()
}

/// A position along the crankshaft: in millimetres, or in multiples of the spacing.
pub(super) fn position(engine: &Engine, value: &BigRational) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => Piece::Exactly(value * BigRational::from_integer(1000.into()), Unit::MILLIMETRE).into(),
        LengthUnit::Spacing => Text::label(typeset::number(value)),
    }
}

/// The same with its unit.
pub(super) fn place(engine: &Engine, value: &BigRational) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => phrase!("{} {}", position(engine, value), Unit::MILLIMETRE),
        LengthUnit::Spacing => position(engine, value),
    }
}

/// What stands over positions along the crankshaft.
pub(super) fn position_heading(engine: &Engine) -> Text {
    heading(engine, "Position z ({})", "Position z")
}

/// What stands over the positions of loads.
pub(super) fn load_heading(engine: &Engine) -> Text {
    heading(engine, "Load at ({})", "Load at")
}

fn arm_heading(engine: &Engine) -> Text {
    heading(engine, "Arm z ({})", "Arm z")
}

/// The arm of a source: of a part of a cylinder, or of a mass that turns.
fn arm(engine: &Engine, turning: &[TurningMass], source: Source) -> Text {
    let at = source.position(engine);
    let at = at.or_else(|| turning.iter().find(|mass| mass.source == source).map(|mass| &mass.position));
    at.map(|at| position(engine, &(at - engine.reference_plane()))).unwrap_or_default()
}

/// Words with the unit of positions, or without where they are multiples of the spacing.
fn heading(engine: &Engine, in_unit: &'static str, bare: &'static str) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => phrase!(in_unit, Unit::MILLIMETRE),
        LengthUnit::Spacing => bare.into(),
    }
}

/// The name of a row of moments. Arms are shown in millimetres or inches; a moment's exact sum stays in metres, and says so.
fn sum_of_moments(engine: &Engine) -> &'static str {
    match engine.length_unit() {
        LengthUnit::Metre => "**Σ moment** in metres",
        LengthUnit::Spacing => "**Σ moment**",
    }
}

/// One period of orders: zero or not, direct and reverse.
pub(super) fn period(theorem: &Theorem) -> Table {
    let orders = |verdict: &Verdict| match verdict.order {
        1 => Text::label("1"),
        order => Text::label(format!("{order}, {}, …", order + theorem.period)),
    };
    let mut table = Table::of(theorem.force.direct.iter().enumerate()).column("Order", |(_, verdict)| orders(verdict));
    let columns = [
        ("Force, direct", &theorem.force.direct),
        ("Force, reverse", &theorem.force.reverse),
        ("Moment, direct", &theorem.moment.direct),
        ("Moment, reverse", &theorem.moment.reverse),
    ];
    for (heading, verdicts) in columns {
        table = table.column(heading, |(index, _)| match verdicts[*index].vanishes() {
            true => Text::zero(),
            false => "not 0".into(),
        });
    }
    table.done()
}

/// Multiples of an angle in degrees whose sum is a phase.
type Parts<'a> = [(i64, &'a BigRational); 2];

/// The vector-star table of order k: how each phase comes about, and the sums.
pub(super) fn vector_star(engine: &Engine, order: &OrderBalance) -> Table {
    let is_turned = order.class.as_ref().is_some_and(|class| matches!(class.factor, Factor::Quadrature(_)));
    if is_turned || !engine.has_one_vector_per_order() || engine.faster_crank().is_some() {
        return term_by_term(engine, order);
    }
    let k = i64::from(order.order);
    let has_banks = engine.cylinders().iter().any(|cylinder| cylinder.bank != Turn::zero());
    let pistons_alone =
        order.force.verdicts().iter().all(|verdict| verdict.sources.iter().all(|one| one.piston().is_some()));
    // As the sums have it: an offset below 0 changes the sign of odd orders.
    let direct = &order.force.direct;
    let weights: BTreeMap<Source, &BigRational> =
        direct.sources.iter().copied().zip(direct.sum.terms().iter().map(|term| &term.weight)).collect();
    let has_negative = weights.values().any(|weight| weight.is_negative());
    let with_mass = !(engine.has_unit_masses() && pistons_alone) || has_negative;
    let phases = Sense::BOTH.map(|sense| phase_formula(k, sense, has_banks));
    let [direct, reverse] = phases.map(Text::label);
    let of = if pistons_alone { "Cylinder" } else { "Source" };
    let mut header: Vec<Text> = vec![of.into(), "Throw β".into()];
    header.extend(has_banks.then(|| "Bank α".into()));
    header.push(arm_heading(engine));
    header.extend(with_mass.then(|| "Weight in m r".into()));
    header.extend([phrase!("Direct phase {}", direct), phrase!("Reverse phase {}", reverse)]);
    let mut table = Table::new(header);
    let mut add = |[name, throw, bank]: [Text; 3], arm: &BigRational, weight: Text, phases: [String; 2]| {
        let mut cells = vec![name, throw];
        cells.extend(has_banks.then_some(bank));
        cells.push(position(engine, arm));
        cells.extend(with_mass.then_some(weight));
        cells.extend(phases.map(Text::label));
        table.push(cells);
    };
    let masses = order::turning_masses(engine);
    for source in sources(order) {
        if let Source::Piston(index) = source {
            let cylinder = &engine.cylinders()[index];
            let bank = typeset::degrees(&typeset::signed_degrees(&cylinder.bank)).into();
            let names = [cylinder.name.clone().into(), typeset::angle(&cylinder.throw).into(), bank];
            let weight = weights.get(&source).map(|weight| Number::exact(weight).into()).unwrap_or_default();
            let phases = Sense::BOTH.map(|sense| working(cylinder, order.order, sense));
            add(names, &engine.arm(cylinder), weight, phases);
        }
        // What turns adds to one of the two sums, at the angle of its weight.
        for mass in masses.iter().filter(|mass| mass.source == source) {
            let angle = |sense| if mass.sense == sense { typeset::angle(&mass.angle) } else { "–".to_owned() };
            let names = [source.label(engine).into(), Text::default(), Text::default()];
            let arm = &mass.position - engine.reference_plane();
            add(names, &arm, Number::exact(&mass.weight()).into(), Sense::BOTH.map(angle));
        }
    }
    let blank = table.header.len() - 3;
    for (name, balance) in [("**Σ force**", &order.force), (sum_of_moments(engine), &order.moment)] {
        let mut add = |name: &'static str, cell: fn(&Verdict) -> Text| {
            let cells = balance.verdicts().map(cell);
            table.push([Text::from(name)].into_iter().chain(vec![Text::default(); blank]).chain(cells).collect());
        };
        add(name, |verdict| residual::modulus(verdict).into());
        if !balance.is_balanced() {
            add("angle", angle_cell);
        }
    }
    table
}

/// The same where a cylinder may have several vectors: each term of both sums.
fn term_by_term(engine: &Engine, order: &OrderBalance) -> Table {
    let mut table =
        Table::new(["Source".into(), arm_heading(engine), "Sense".into(), "Weight in m r".into(), "Phase".into()]);
    let masses = order::turning_masses(engine);
    for (balance, sense) in [(&order.force.direct, "direct"), (&order.force.reverse, "reverse")] {
        for (source, term) in balance.sources.iter().zip(balance.sum.terms()) {
            table.push(vec![
                source.label(engine).into(),
                arm(engine, &masses, *source),
                sense.into(),
                Number::exact(&term.weight).into(),
                typeset::angle(&term.angle).into(),
            ]);
        }
    }
    for (name, balance) in [("**Σ force**", &order.force), (sum_of_moments(engine), &order.moment)] {
        for (verdict, sense) in balance.verdicts().into_iter().zip(["direct", "reverse"]) {
            let angle = if verdict.vanishes() { Text::default() } else { angle_cell(verdict) };
            table.push(vec![name.into(), Text::default(), sense.into(), residual::modulus(verdict).into(), angle]);
        }
    }
    table
}

/// What each source adds to a whole order at θ = 0, with its coefficient: half of each vector and its angle, and what they sum to.
pub(super) fn whole_star(engine: &Engine, stars: &WholeStars, order: u32) -> Table {
    let vectors = ["½ direct in m r ω²", "½ reverse in m r ω²"].map(Text::from);
    let mut table = Table::new([["Source".into(), arm_heading(engine)], vectors].concat());
    let vector = |vector: Complex<f64>| {
        let [length, angle] = [vector.norm(), numbers::degrees(vector)].map(number::sensible);
        phrase!("≈ {} at ≈ {}", Text::label(length), Text::label(format!("{angle}°")))
    };
    let mut sources: BTreeMap<Source, [Text; 2]> = BTreeMap::new();
    for (place, sense) in Sense::BOTH.into_iter().enumerate() {
        for (source, value) in stars.vectors(Planar::Force, order, sense) {
            sources.entry(source).or_insert_with(|| [Text::label("–"), Text::label("–")])[place] = vector(value);
        }
    }
    let masses = order::turning_masses(engine);
    for (source, [direct, reverse]) in sources {
        table.push(vec![source.label(engine).into(), arm(engine, &masses, source), direct, reverse]);
    }
    for (name, quantity) in [("**Σ force**", Planar::Force), (sum_of_moments(engine), Planar::Moment)] {
        let sum = |sense| match stars.resultant(quantity, order, sense) {
            (_, loads::Outcome::Zero) => Text::zero(),
            (value, loads::Outcome::NotZero | loads::Outcome::Computed) => vector(value),
            (_, loads::Outcome::Undecided { .. }) => "not decided".into(),
        };
        table.push(vec![name.into(), Text::default(), sum(Sense::Direct), sum(Sense::Reverse)]);
    }
    table
}

/// All sources of the sums of an order, each once.
pub(super) fn sources(order: &OrderBalance) -> Vec<Source> {
    rising(order.force.verdicts().into_iter().flat_map(|verdict| verdict.sources.iter().copied()))
}

fn angle_cell(verdict: &Verdict) -> Text {
    if verdict.vanishes() { Text::default() } else { residual::bearing(&verdict.sum).into() }
}

/// `2β − α`, `−2β + 3α`; without the bank where all banks are at 0.
pub(super) fn phase_formula(k: i64, sense: Sense, has_banks: bool) -> String {
    let times = |factor: i64, symbol: &str| match factor {
        1 => symbol.to_owned(),
        _ => format!("{factor}{symbol}"),
    };
    let bank = |sign: &str, factor: i64| match factor {
        0 => String::new(),
        _ if !has_banks => String::new(),
        _ => format!(" {sign} {}", times(factor, "α")),
    };
    match sense {
        Sense::Direct => format!("{}{}", times(k, "β"), bank("−", k - 1)),
        Sense::Reverse => format!("−{}{}", times(k, "β"), bank("+", k + 1)),
    }
}

/// The phase of a cylinder in the star of order k, worked out.
pub(super) fn working(cylinder: &Cylinder, order: u32, sense: Sense) -> String {
    phase(&parts(order, sense, &cylinder.throw.degrees(), &typeset::signed_degrees(&cylinder.bank)))
}

/// How often throw and bank enter a phase, with their degrees.
fn parts<'a>(order: u32, sense: Sense, throw: &'a BigRational, bank: &'a BigRational) -> Parts<'a> {
    let [of_throw, of_bank] = order::multiples(order, Some(sense));
    [(of_throw, throw), (of_bank, bank)]
}

/// A phase worked out: `2·270° + 45° = 585° ≡ 225°`; the phase alone where its angles are too long to be read.
fn phase(parts: &Parts) -> String {
    let mut text = String::new();
    for (negative, product) in parts.iter().filter_map(|(factor, degrees)| typeset::multiple(*factor, degrees)) {
        text.push_str(match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        text.push_str(&product);
    }
    let sum = phase_sum(parts);
    let (value, reduced) = (typeset::degrees(&sum), typeset::angle(&Turn::from_degrees(&sum)));
    if text.is_empty() || parts.iter().any(|(_, degrees)| typeset::is_rounded(degrees)) || typeset::is_rounded(&sum) {
        return reduced;
    }
    let working = if text == value { text } else { format!("{text} = {value}") };
    if value == reduced { working } else { format!("{working} ≡ {reduced}") }
}

fn phase_sum(parts: &Parts) -> BigRational {
    let products =
        parts.iter().map(|(factor, degrees)| fraction::times(degrees, &BigRational::from_integer((*factor).into())));
    products.fold(BigRational::zero(), |sum, product| fraction::plus(&sum, &product))
}
