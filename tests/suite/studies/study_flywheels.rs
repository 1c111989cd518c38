//! How is the torque of a family shown? Which orders vanish at each value, and what flywheel and counterweights weigh.

use crankstar::engine::{CycleOrder, Firing};
use crankstar::numbers::{self, float};
use crankstar::page::number::Amount;
use crankstar::page::plot::{Axis, Curve, Plot, PointMark};
use crankstar::page::{Block, Number, Picture, Piece, Table, Text, Unit, number};
use crankstar::sweep::Amplitude;
use crankstar::text::Format;

use super::flywheels::{Evened, Flywheels};
use super::phrase;
use super::study::Studied;
use super::study_plots::axis;

const STARS: &str = "Firing stars by order of the torque: the exact length of $S_\\kappa = \\sum_j e^{-i\\kappa\\varphi_j}$, $\\varphi_j$ the crank angle at which cylinder j fires. Where it is **0**, proved, the order vanishes for every pressure common to all cylinders.";
const MASSES: &str = "ΔW is the largest less the smallest work of the torque, gas and inertia, above its mean; the flywheel has the inertia $J = \\Delta W/(\\delta\\,\\omega^2)$ \
    in a ring of the radius ρ and weighs $J/\\rho^2$. The counterweights are two, in the planes of the outermost throws, for all masses of the first order that turn with the crank.";
const CAPTION: &str = "What the flywheel and the two counterweights weigh, each and together; dots are the engine in line itself. The main part of the engine is not in it.";

/// Orders of the torque up to this one are looked at: 6.
const HIGHEST: u32 = 12;

/// What is said of the torque of a family; nothing where the study does not ask for it.
pub(super) fn blocks(family: &Studied) -> Vec<Block> {
    let Some(flywheels) = &family.flywheels else { return Vec::new() };
    let Some(first) = flywheels.points.first() else { return Vec::new() };
    let label = &family.sweep.parameters[0].label;
    let mut blocks = vec![Block::Heading(2, "Torque, flywheel and counterweights".into())];
    blocks.push(Block::Paragraph(STARS.into()));
    let (everywhere, shown): (Vec<CycleOrder>, Vec<CycleOrder>) = first
        .orders
        .iter()
        .map(|order| order.order)
        .filter(|order| order.halves() <= HIGHEST)
        .partition(|order| flywheels.all().all(|point| vanishes(point, *order)));
    if !everywhere.is_empty() {
        let orders = Text::joined(everywhere.iter().map(|order| Text::label(order.to_string())), ", ");
        blocks.push(Block::Paragraph(phrase!("Zero for every engine of the table: the orders {}.", orders)));
    }
    blocks.push(stars(label, flywheels, &shown).into());
    blocks.push(Block::Paragraph(MASSES.into()));
    blocks.push(masses(label, flywheels).into());
    blocks.push(Block::Note(phrase!(
        "Assumed: δ {}, {} revolutions a minute, ρ {} of the flywheel and {} of the counterweights, and the cylinders of the layout.",
        Number::Decimal(first.irregularity),
        Number::exact(&first.speed),
        Text::from(Piece::Quantity(float(&flywheels.flywheel_radius), Unit::METRE)),
        Text::from(Piece::Quantity(float(&flywheels.counterweight_radius), Unit::METRE))
    )));
    blocks
}

fn vanishes(point: &Evened, order: CycleOrder) -> bool {
    point.orders.iter().any(|own| own.order == order && own.vanishes())
}

fn stars(label: &str, flywheels: &Flywheels, shown: &[CycleOrder]) -> Table {
    let orders = shown.iter().map(|order| phrase!("Order {}", Text::label(order.to_string())));
    let mut table = Table::new([Text::label(label), "Intervals".into()].into_iter().chain(orders));
    for point in flywheels.all() {
        let star = |order: &CycleOrder| match point.star(*order) {
            Some(star) if star.vanishes() => Text::zero(),
            Some(star) => {
                Amount { exact: numbers::modulus(star), decimal: numbers::length(numbers::evaluate(star)) }.into()
            }
            None if vanishes(point, *order) => Text::zero(),
            None => "–".into(),
        };
        table.push([value(point), intervals(&point.firing)].into_iter().chain(shown.iter().map(star)).collect());
    }
    table
}

/// The shortest run of intervals that repeats through the cycle.
fn intervals(firing: &Firing) -> Text {
    let all = firing.intervals();
    let repeats =
        |length: &usize| all.len().is_multiple_of(*length) && all.chunks(*length).all(|run| run == &all[..*length]);
    let length = (1..=all.len()).find(repeats).unwrap_or(all.len());
    Text::joined(all[..length].iter().map(|each| number::turns(each).into()), ", ")
}

fn value(point: &Evened) -> Text {
    number::degrees(&point.at).into()
}

fn masses(label: &str, flywheels: &Flywheels) -> Table {
    let mut table = Table::new([
        Text::label(label),
        phrase!("ΔW in {}", Unit::JOULE),
        "ΔW over that in line".into(),
        phrase!("J in {}", Unit::KILOGRAM_SQUARE_METRE),
        phrase!("Flywheel in {}", Unit::KILOGRAM),
        phrase!("Counterweights in {}", Unit::KILOGRAM),
        phrase!("Together in {}", Unit::KILOGRAM),
    ]);
    let weights = |point: &Evened| match point.counterweights {
        Some(Amplitude { vanishes: true, .. }) => Text::zero(),
        Some(Amplitude { value, vanishes: false, .. }) => Text::measured(value, Unit::KILOGRAM),
        None => "–".into(),
    };
    for point in flywheels.all() {
        table.push(vec![
            value(point),
            Text::measured(point.energy, Unit::JOULE),
            decimal(flywheels.ratio(point)),
            Text::measured(point.inertia, Unit::KILOGRAM_SQUARE_METRE),
            Text::measured(point.flywheel, Unit::KILOGRAM),
            weights(point),
            point.mass().map_or_else(|| "–".into(), |mass| Text::measured(mass, Unit::KILOGRAM)),
        ]);
    }
    table
}

fn decimal(value: f64) -> Text {
    Number::Decimal(value).into()
}

/// One of the masses of an engine.
type Mass = fn(&Evened) -> Option<f64>;

/// The drawing of a family's flywheels; none where the study does not ask for them.
pub(super) fn picture(family: &Studied) -> Option<Picture> {
    let flywheels = family.flywheels.as_ref()?;
    let parameter = &family.sweep.parameters[0];
    let x = Axis::angle(axis(parameter), 0.0, float(&parameter.range.last()), 30);
    let title = format!("{}: flywheel, counterweights", family.sweep.title.escaped(Format::Plain));
    let mut plot = Plot::new(title, x, Axis::amplitude("Mass in {}").counted_in(Unit::KILOGRAM));
    let kinds: [(&str, Mass); 3] = [
        ("flywheel", |point| Some(point.flywheel)),
        ("counterweights", |point| Some(point.counterweights?.value)),
        ("together", Evened::mass),
    ];
    for (name, mass) in kinds {
        let at = |point: &Evened| Some((float(&point.at), mass(point)?));
        plot.curves.push(Curve::new(plot.curves.len(), name, flywheels.points.iter().filter_map(at).collect()));
        plot.marks.extend(flywheels.in_line.iter().filter_map(at).map(|at| PointMark::dot(at, "").of("in line")));
    }
    Some(Picture { name: format!("{}-flywheel", family.name), caption: CAPTION.into(), figure: plot.figure() })
}
