//! Which cure removes most for each shaft and for each weight, and what does it leave? With the place of a pair that cancels the roll too.

use num_traits::ToPrimitive;

use super::super::calculation::Unit as Counted;
use crate::engine::Engine;
use crate::loads::scale;
use crate::numbers;
use crate::page::{Block, Piece, Table, Text, Unit, number, phrase};
use crate::proof::{Quantity, Sense};
use crate::remedy::{Cure, Kind, PairHeight, PairRoll, Remedy, Shaft, cures};
use crate::report::texts::remedy as text;

/// The cures of the orders asked for, and where a pair belongs; nothing where no order needs one.
pub(super) fn blocks(remedy: &Remedy) -> Vec<Block> {
    let all = cures(&remedy.subject, &remedy.orders);
    let pairs = pairs(remedy);
    let mut blocks = Vec::new();
    if !all.is_empty() {
        blocks.extend([text::ranking().into(), table(remedy, all).into()]);
    }
    blocks.extend((!pairs.is_empty()).then_some(Block::List(pairs)));
    blocks
}

fn name(engine: &Engine, cure: &Cure) -> Text {
    let is_force = cure.kind == Kind::Force;
    let one = |sense: &Sense| match engine.crank_turning(cure.order, *sense) {
        Some(crank) => text::cure_on_crankshaft(is_force, crank.name.clone()),
        None if engine.has_crank_turning(cure.order, *sense) => text::cure_counterweight(is_force),
        None => text::cure_shaft(*sense),
    };
    match (cure.senses.as_slice(), cure.shafts) {
        ([_, _], 2) => "two shafts, one each way".into(),
        (senses, _) => Text::joined(senses.iter().map(one), ", "),
    }
}

fn table(remedy: &Remedy, all: Vec<Cure>) -> Table {
    let engine = remedy.subject.engine();
    let scale = scale(engine);
    let amount = |cure: &Cure, value: f64| -> Text {
        let quantity = if cure.kind == Kind::Force { Quantity::FORCE } else { Quantity::MOMENT };
        let Counted { unit, factor } = Counted::at(engine, scale.as_ref(), quantity);
        Piece::Quantity(value * factor, unit).into()
    };
    let weight = |cure: &Cure| -> Text {
        match (cure.kind == Kind::Force, remedy.cure_mass_radius(cure)) {
            (true, Some(mass_radius)) => Piece::Quantity(mass_radius * 1e3, Unit::KILOGRAM_MILLIMETRE).into(),
            (true, None) => Piece::Quantity(cure.mass_radius, Unit::MASS_RADIUS).into(),
            // A couple is mass times radius times distance; the planes say how far apart the weights are.
            (false, _) => "–".into(),
        }
    };
    let per_kilogram = |cure: &Cure| -> Text {
        let mass = remedy.cure_mass(cure);
        mass.map_or_else(|| "–".into(), |mass| amount(cure, cure.removes() / mass))
    };
    Table::of(all)
        .column("Order", |cure| cure.order)
        .column("Cancels", |cure| if cure.kind == Kind::Force { "force" } else { "couple" })
        .column("Cure", |cure| name(engine, cure))
        .column("Shafts", |cure| cure.shafts)
        .column("Mass × radius", weight)
        .column("Removes", |cure| -> Text {
            match cure.is_exact {
                true => phrase!("{} %, proved", (100.0 * cure.removed).round() as u32),
                false => Piece::Quantity(100.0 * cure.removed, Unit::PERCENT).into(),
            }
        })
        .column("Residual", |cure| match cure.peak[1] {
            0.0 => Text::zero(),
            left => amount(cure, left),
        })
        .column("Removed per shaft", |cure| cure.per_shaft().map_or_else(|| "–".into(), |value| amount(cure, value)))
        // A mass is told where the layout or the user says at which radius.
        .column_if(remedy.radius.is_some(), "Removed per kilogram", per_kilogram)
        .done()
}

/// With which force each shaft, as it is built, rolls the engine, times the distance of its axis; of a pair its heights are told, where
/// they are known. Nothing without a speed.
pub(super) fn rolling_shafts(remedy: &Remedy) -> Option<Text> {
    let engine = remedy.subject.engine();
    let (scale, speed) = (scale(engine)?, engine.dimensions().speed.as_ref()?);
    if !engine.geared_cranks().is_empty() {
        return None;
    }
    let is_placed = |shaft: &Shaft| shaft.lanchester && remedy.heights.iter().any(|of| of.order == shaft.order);
    let pulls = |(index, shaft): (usize, &Shaft)| {
        let built = shaft.weights.iter().filter_map(|weight| remedy.as_built(weight));
        let sum = built.map(|weight| weight.adds()).reduce(|sum, one| sum.plus(&one))?;
        let vector = remedy.subject.value(&sum, shaft.order, shaft.sense)?;
        let newtons = Piece::Quantity(numbers::length(vector) / 2.0 * scale.force(), Unit::NEWTON);
        let is_one = !is_placed(shaft) && shaft.kind != Kind::Couple && remedy.axes(shaft).len() < 2;
        is_one.then(|| phrase!("shaft {} with {}", index + 1, newtons))
    };
    let all: Vec<Text> = remedy.shafts.iter().enumerate().filter_map(pulls).collect();
    (!all.is_empty())
        .then(|| text::rolling_shafts(number::given_with(speed, Unit::PER_MINUTE), Text::joined(all, ", ")))
}

/// Where the shafts of a pair belong so that the roll moment of its order vanishes too, at the speed of the layout, with the gas.
fn pairs(remedy: &Remedy) -> Vec<Text> {
    at_its_speed(remedy).into_iter().chain(over_speeds(remedy)).collect()
}

/// Where they stand best over the speeds that are asked for, the moment of each counted alike.
pub(super) fn over_speeds(remedy: &Remedy) -> Vec<Text> {
    let speeds: Vec<f64> = remedy.speeds.iter().map(numbers::float).collect();
    let place = |height: &PairHeight| {
        let roll = PairRoll::new(remedy.subject.engine(), height.order)?;
        let [up, sideways] = roll.best_place(&speeds)?;
        let millimetres = |value: f64| Piece::Quantity(without_rounding(value, up) * 1e3, Unit::MILLIMETRE);
        let peak = |place: [f64; 2]| speeds.iter().map(|rpm| roll.peak(*rpm, place)).fold(0.0, f64::max);
        let largest =
            |place: [f64; 2]| Piece::Quantity(without_rounding(peak(place), peak([0.0; 2])), Unit::NEWTON_METRE);
        Some(text::pair_place_over_speeds(
            Text::joined(remedy.speeds.iter().map(number::given), ", "),
            height.order,
            millimetres(up),
            millimetres(remedy.subject.engine().convention().in_the_sense_of_rotation(sideways)),
            largest([up, sideways]),
            largest([height.metres?, 0.0]),
            largest([0.0; 2]),
        ))
    };
    let placed: Vec<Text> = remedy.heights.iter().filter_map(place).collect();
    if placed.is_empty() && !speeds.is_empty() { vec![text::no_pair()] } else { placed }
}

/// A value without what is left of 0 by the roundings of numbers as large as another.
fn without_rounding(value: f64, beside: f64) -> f64 {
    if value.abs() <= 1e-9 * beside.abs() { 0.0 } else { value }
}

fn at_its_speed(remedy: &Remedy) -> Vec<Text> {
    let engine = remedy.subject.engine();
    let speed = engine.dimensions().speed.as_ref().and_then(ToPrimitive::to_f64).filter(|speed| *speed > 0.0);
    let Some(speed) = speed.filter(|_| engine.gas().is_some()) else { return Vec::new() };
    let place = |height: &PairHeight| {
        let roll = PairRoll::new(engine, height.order)?;
        let metres = height.metres?;
        let [up, sideways] = roll.place(speed);
        let millimetres = |value: f64| Piece::Quantity(value * 1e3, Unit::MILLIMETRE);
        let moment = |value: f64| Piece::Quantity(value, Unit::NEWTON_METRE);
        Some(text::pair_place_with_gas(
            Piece::Quantity(speed, Unit::PER_MINUTE),
            height.order,
            millimetres(up),
            millimetres(remedy.subject.engine().convention().in_the_sense_of_rotation(sideways)),
            millimetres(metres),
            moment(roll.peak(speed, [metres, 0.0])),
            moment(roll.peak(speed, [0.0; 2])),
        ))
    };
    remedy.heights.iter().filter_map(place).collect()
}
