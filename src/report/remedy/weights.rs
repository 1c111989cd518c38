//! What are the weights of a remedy called, how large are they, and in which direction do they stand?

use super::super::engine_page::assumed_ratio;
use super::super::residual;
use super::super::table::position_heading;
use super::super::typeset::short;
use crate::engine::{Engine, LengthUnit, Rod, Rods};
use crate::numbers;
use crate::order::{Coefficients, Factor};
use crate::page::number::{Amount, Bearing, given, given_with};
use crate::page::{Number, Piece, Table, Text, Unit, phrase};
use crate::proof::Sense;
use crate::remedy::{Built, Remedy, Weight};
use crate::report::texts::remedy as text;
use num_rational::BigRational;
use num_traits::Zero;

/// Letters of the longest closed form of a mass-radius that is shown.
const LONGEST_FORM: usize = 24;

/// A row a weight; none where no weight is needed.
pub(super) fn table(remedy: &Remedy) -> Option<Table> {
    let in_numbers = remedy.subject.scale().is_some();
    let position = position_heading(remedy.subject.engine());
    let mut rows: Vec<(Text, Weight)> = Vec::new();
    let mut add = |name: Text, weight: &Weight| {
        // Several parts of a remedy resize a weight together.
        let weight = remedy.as_built(weight).filter(|weight| rows.iter().all(|(_, told)| told != weight));
        rows.extend(weight.map(|weight| (name, weight)));
    };
    remedy.bays.iter().for_each(|weight| add("counterweight by balance factor".into(), weight));
    let on_the_crankshaft = remedy.crankshaft.iter().flat_map(|shaft| &shaft.weights);
    on_the_crankshaft.for_each(|weight| add("counterweight".into(), weight));
    for (index, shaft) in remedy.shafts_built().enumerate() {
        shaft.weights.iter().for_each(|weight| add(phrase!("shaft {}", index + 1), weight));
    }
    let mut table = Table::of(rows)
        .column("Weight", |(name, _)| name.clone())
        .column("Turns", |(_, weight)| turns(weight))
        .column(position, |(_, weight)| position_of(remedy.subject.engine(), weight))
        .column_if(in_numbers, "Mass × radius", |(_, weight)| in_short(remedy, weight))
        .column(if in_numbers { "In multiples" } else { "Mass × radius" }, |(_, weight)| size(remedy, weight));
    if let Some(radius) = &remedy.radius {
        let radius = given_with(&(radius * BigRational::from_integer(1000.into())), Unit::MILLIMETRE);
        let mass = |weight: &Weight| Some(Piece::Quantity(remedy.mass(weight)?, Unit::KILOGRAM).into());
        table = table.column(phrase!("Mass at {}", radius), |(_, weight)| -> Text { mass(weight).unwrap_or_default() });
    }
    table.column("Angle at θ = 0", |(_, weight)| direction(remedy, weight)).done_if_any()
}

fn turns(weight: &Weight) -> Text {
    match weight.sense {
        Sense::Direct => phrase!("{}×, with the crank", weight.order),
        Sense::Reverse => phrase!("{}×, against the crank", weight.order),
    }
}

/// Along the crankshaft: in millimetres where the layout gives lengths in units, else in the unit of its positions.
fn position_of(engine: &Engine, weight: &Weight) -> Text {
    match engine.length_unit() {
        LengthUnit::Metre => {
            Piece::Shortly(&weight.position * BigRational::from_integer(1000.into()), Unit::MILLIMETRE).into()
        }
        LengthUnit::Spacing => given(&weight.position),
    }
}

/// The same with its unit.
fn place_of(remedy: &Remedy, weight: &Weight) -> Text {
    let engine = remedy.subject.engine();
    match engine.length_unit() {
        LengthUnit::Metre => phrase!("{} {}", position_of(engine, weight), Unit::MILLIMETRE),
        LengthUnit::Spacing => position_of(engine, weight),
    }
}

/// What the engine has in a plane, and what it becomes: `at z = 0 from 0.3 m r at 180° to 0.25 m r at 180°`.
pub(super) fn resized(remedy: &Remedy, plane: &Built) -> Text {
    let turns = turns(&plane.was);
    let at = place_of(remedy, &plane.was);
    let size = |weight: &Weight| match weight.vector.vanishes() {
        true => "nothing".into(),
        false => phrase!("{} at {}", in_short(remedy, weight), direction(remedy, weight)),
    };
    phrase!("z = {}, {}: {}, now {}", at, turns, size(&plane.was), size(&plane.becomes))
}

/// Weights in a row: how large, and where.
pub(super) fn listed(remedy: &Remedy, weights: &[Weight]) -> Text {
    let weights: Vec<Weight> = weights.iter().filter_map(|weight| remedy.as_built(weight)).collect();
    let one = |weight: &Weight| phrase!("{} at z = {}", in_short(remedy, weight), place_of(remedy, weight));
    Text::joined(weights.iter().map(one), ", ")
}

/// The mass-radius in kilogram-millimetres, else in multiples of m r.
pub(super) fn in_short(remedy: &Remedy, weight: &Weight) -> Text {
    match weight.mass_radius(&remedy.subject) {
        Some(size) => Piece::Quantity(size * 1000.0, Unit::KILOGRAM_MILLIMETRE).into(),
        None => size(remedy, weight),
    }
}

/// The mass-radius in multiples of m r or of m r |c_k|: `√3/4 ≈ 0.4330 m r`.
fn size(remedy: &Remedy, weight: &Weight) -> Text {
    // A form whose digits only repeat those of the layout's masses and lengths says nothing more than its decimals.
    let exact = weight.modulus().filter(|form| form.to_string().chars().count() <= LONGEST_FORM);
    let amount = |decimal: f64| Text::from(Amount { exact: exact.clone(), decimal });
    match (weight.vector.only(), weight.decimals(&remedy.subject)) {
        (Some((factor, sum)), _) => {
            let amount = amount(residual::modulus_of(sum).decimal);
            let (own, order) = factor.own(weight.order);
            let times = |letter: char| {
                phrase!("{} {}", amount.clone(), Text::formula(format!("m\\,r\\,\\lvert {letter}_{{{order}}}\\rvert")))
            };
            // One letter would stand for the coefficients of several rods.
            let differ = matches!(remedy.subject.engine().all_rods(), Rods::Differ) && own.letter().is_some();
            match own {
                Factor::Quadrature(_) => phrase!("{} $m\\,r\\,\\lvert \\mathrm{Im}\\, c_1 \\rvert$", amount),
                Factor::Corrected(..) => in_decimals(remedy, weight),
                _ if differ => in_decimals(remedy, weight),
                other => match other.letter() {
                    Some(letter) => times(letter),
                    None => phrase!("{} $m\\,r$", amount),
                },
            }
        }
        (None, Some([size, _])) => phrase!("{} $m\\,r$", amount(size)),
        (None, None) => depends(weight),
    }
}

fn in_decimals(remedy: &Remedy, weight: &Weight) -> Text {
    match weight.decimals(&remedy.subject) {
        Some([size, _]) => phrase!("{} $m\\,r$", Number::Decimal(size)),
        None => depends(weight),
    }
}

/// How large each `|c_k|` is that multiplies m r, so that the sizes compare with those of the other pages; none where kilograms are known, or none occurs.
pub(super) fn coefficients(remedy: &Remedy) -> Option<Text> {
    if remedy.subject.scale().is_some() || matches!(remedy.subject.engine().all_rods(), Rods::Differ) {
        return None;
    }
    let weights = remedy.shafts.iter().flat_map(|shaft| &shaft.weights);
    let mut found: Vec<(Factor, u32)> = Vec::new();
    for weight in weights {
        let Some((factor, _)) = weight.vector.only() else { continue };
        let (own, order) = factor.own(weight.order);
        let is_named = matches!(own, Factor::Motion(_) | Factor::Open);
        if is_named && !found.iter().any(|(known, of)| known == own && *of == order) {
            found.push((own.clone(), order));
        }
    }
    let known = Coefficients::default();
    let assumed = Factor::Motion(Rod { ratio: assumed_ratio(), offset: BigRational::zero() });
    let is_open = found.iter().any(|(factor, _)| *factor == Factor::Open);
    let sizes = found.iter().filter_map(|(factor, order)| {
        let factor = if *factor == Factor::Open { &assumed } else { factor };
        let size = known.of(factor, *order)?.to_complex().norm();
        Some(phrase!("{} {}", Text::formula(format!("\\lvert c_{{{order}}}\\rvert")), Number::Decimal(size)))
    });
    let sizes: Vec<Text> = sizes.collect();
    let sizes = (!sizes.is_empty()).then(|| Text::joined(sizes, ", "))?;
    Some(if is_open { text::factors_assumed(short(&assumed_ratio()), sizes) } else { text::factors(sizes) })
}

fn depends(weight: &Weight) -> Text {
    phrase!("depends on {}", Text::formula(format!("c_{{{}}}", weight.order)))
}

/// The direction at θ = 0.
fn direction(remedy: &Remedy, weight: &Weight) -> Text {
    let of_sum = || {
        let (factor, sum) = weight.vector.only()?;
        let value = numbers::evaluate(sum);
        let value = if factor.is_negative(weight.order)? { -value } else { value };
        Some(numbers::degrees(value))
    };
    let of_value = weight.decimals(&remedy.subject).map(|[_, degrees]| degrees);
    match of_value.or_else(of_sum) {
        Some(decimal) => Bearing { exact: weight.direction(), decimal }.into(),
        None => depends(weight),
    }
}
