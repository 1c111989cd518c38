//! What is on the page of masses on a shaft, and on the terminal?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::residual;
use super::super::torque::quantity;
use super::{LeftOver, RotorStudy};
use crate::exact::PhasorSum;
use crate::numbers::{self, Direction};
use crate::page::number::{Amount, Bearing, Number, given_in, given_with, turns};
use crate::page::{Block, Document, Table, Text, Unit, phrase};
use crate::report::texts::rotor as text;
use crate::rotor::{Answer, Found, Real, Reason};

/// The short answer.
pub(super) fn answer(study: &RotorStudy) -> Document {
    let mut answer = Document::new("rotor", &study.rotor.title);
    answer.push(Block::Paragraph(verdict(study)));
    answer.blocks.extend(found(study));
    answer
}

/// The page.
pub(super) fn page(study: &RotorStudy) -> Document {
    text::Page {
        shaft: (&study.rotor.title).into(),
        answer: Block::Answer(vec![verdict(study)]).into(),
        found: found(study).into(),
        masses: masses(study).into(),
        method: std::iter::once(text::equations()).chain(study.rotor.secondary.then(text::schlick)).collect(),
    }
    .document()
}

fn verdict(study: &RotorStudy) -> Text {
    match &study.answer {
        Answer::Balanced => text::balanced(),
        Answer::Residual(_) => text::not_balanced(),
        Answer::Found(solutions) => {
            // Where no angle is given the whole may be turned about the shaft.
            let is_turned = study.rotor.masses.iter().all(|mass| mass.angle.is_none());
            match (solutions.len(), is_turned) {
                (1, false) => text::one_solution(),
                (1, true) => text::one_solution_turned(),
                (_, false) => text::two_solutions(),
                (_, true) => text::two_solutions_turned(),
            }
        }
        Answer::Never(reason) => text::no_solution(why(*reason, true)),
        Answer::Many(reason) => text::many_solutions(why(*reason, false)),
    }
}

fn why(reason: Reason, is_never: bool) -> Text {
    match reason {
        Reason::OnePlane if is_never => text::couple_remains_about_plane(),
        Reason::OnePlane => text::only_sum_matters(),
        Reason::Couple => text::couple_remains(),
        Reason::Force => text::no_mass_in_direction(),
        Reason::CoupleAlone => text::no_planes(),
        Reason::NotParallel => text::not_in_one_plane(),
        Reason::OneLine => text::one_line(),
        Reason::NoTriangle => text::no_triangle(),
        Reason::BalancedAlready => text::nothing_to_balance(),
    }
}

fn found(study: &RotorStudy) -> Vec<Block> {
    let mut blocks = Vec::new();
    let left = study.left();
    if !left.is_empty() {
        blocks.push(lengths(study, &left).into());
    }
    blocks.extend(study.solutions().iter().map(|solution| Block::from(table(study, solution))));
    blocks.extend(opposite(study).map(Block::Paragraph));
    if study.solutions().iter().flatten().any(|one| one.cosine.is_some()) {
        blocks.push(Block::Note(text::cosine()));
    }
    for (heading, rows, about) in [
        ("Second order", study.of_second_order(), text::secondary()),
        ("Locomotive", study.of_locomotive(), text::locomotive()),
    ] {
        if !rows.is_empty() {
            blocks.extend([Block::Heading(1, heading.into()), lengths(study, &rows).into(), about.into()]);
        }
    }
    blocks
}

/// Which masses belong opposite to the directions of the file.
fn opposite(study: &RotorStudy) -> Option<Text> {
    let given = |one: &Found| study.rotor.masses[one.index].angle.as_ref();
    let is_opposite =
        |one: &&Found| given(one).is_some_and(|given| one.turn.as_ref().is_some_and(|turn| turn != given));
    let found = study.solutions().iter().flatten().filter(is_opposite);
    let named: Vec<Text> = found.map(|one| (&study.rotor.masses[one.index].name).into()).collect();
    (!named.is_empty()).then(|| text::opposite(Text::joined(named, ", ")))
}

/// An amount of a real number, `of` this many of it, in this unit.
fn amount(real: &Real, of: &BigRational, unit: Unit) -> Text {
    let exact = real.exact.as_ref().map(|form| form.scaled(of));
    Amount { exact, decimal: real.decimal * numbers::float(of) }.counted_in(unit)
}

/// The direction of a mass that was found: exact where it is a rational angle.
fn direction(one: &Found) -> Text {
    if one.vector.as_ref().is_some_and(PhasorSum::vanishes) {
        return "–".into();
    }
    if let Some(turn) = &one.turn {
        return Text::label(turns(turn.turns()));
    }
    let rational = one.vector.as_ref().and_then(|vector| match numbers::direction_of(vector)? {
        Direction::Turn(turn) => Some(turn),
        Direction::Arctangent { .. } | Direction::Turned { .. } => None,
    });
    match rational {
        Some(turn) => Text::label(turns(turn.turns())),
        None => super::super::torque::angle(one.angle),
    }
}

fn table(study: &RotorStudy, solution: &[Found]) -> Table {
    let of = |one: &Found| &study.rotor.masses[one.index];
    let has_position = solution.iter().any(|one| one.position.is_some());
    let has_cosine = solution.iter().any(|one| one.cosine.is_some());
    let thousand = BigRational::from_integer(1000.into());
    let mass = |one: &Found| match (&of(one).mass, &of(one).radius) {
        (Some(mass), _) => Some(given_in(mass, Unit::KILOGRAM)),
        (None, Some(radius)) => Some(amount(&one.mass_radius, &radius.recip(), Unit::KILOGRAM)),
        (None, None) => None,
    };
    let radius = |one: &Found| match (&of(one).radius, &of(one).mass) {
        (Some(radius), _) => Some(given_in(&(radius * &thousand), Unit::MILLIMETRE)),
        (None, Some(mass)) if mass.is_positive() => {
            Some(amount(&one.mass_radius, &(&thousand / mass), Unit::MILLIMETRE))
        }
        (None, _) => None,
    };
    Table::of(solution)
        .column("Mass", |one| &of(one).name)
        .column(phrase!("Mass in {}", Unit::KILOGRAM), |one| Text::or_dash(mass(one)))
        .column(phrase!("Radius ({})", Unit::MILLIMETRE), |one| Text::or_dash(radius(one)))
        .column(phrase!("Mass times radius in {}", Unit::KILOGRAM_METRE), |one| {
            amount(&one.mass_radius, &BigRational::one(), Unit::KILOGRAM_METRE)
        })
        .column("Angle", |one| direction(one))
        .column_if(has_cosine, "cos", |one| Text::or_dash(one.cosine.as_ref().map(Number::exact)))
        .column_if(has_position, phrase!("Position ({})", Unit::MILLIMETRE), |one| {
            Text::or_dash(one.position.as_ref().map(|position| amount(position, &thousand, Unit::MILLIMETRE)))
        })
        .done()
}

/// Lengths of stars by name: with their exact values, and at the speed of the file.
fn lengths(study: &RotorStudy, rows: &[LeftOver]) -> Table {
    let omega_squared = study.omega_squared().filter(|_| rows.iter().all(|one| !one.is_secondary));
    let head = ["", "Mass times radius", "Direction at θ = 0"].map(Text::from);
    let mut table = Table::new(head.into_iter().chain(omega_squared.map(|_| Text::from("At the speed of the file"))));
    for one in rows {
        let [unit, at_speed] = match one.is_couple {
            true => [Unit::KILOGRAM_SQUARE_METRE, Unit::NEWTON_METRE],
            false => [Unit::KILOGRAM_METRE, Unit::NEWTON],
        };
        let zero = one.vanishes();
        let modulus = || one.star.map_or(Amount { exact: None, decimal: one.length() }, residual::modulus_of);
        let length = if zero { Text::zero() } else { phrase!("{} {}", modulus().counted_in(unit), unit) };
        let bearing =
            || one.star.map_or(Bearing { exact: None, decimal: numbers::degrees(one.sum) }, residual::bearing);
        let towards = if zero { "–".into() } else { bearing().into() };
        let mut row = vec![one.name.clone(), length, towards];
        if let Some(omega_squared) = omega_squared {
            row.push(if zero { Text::zero() } else { quantity(one.length() * omega_squared, at_speed) });
        }
        table.push(row);
    }
    table
}

/// The masses as the file has them; what is wanted is a question mark.
fn masses(study: &RotorStudy) -> Table {
    let reciprocating = study.rotor.masses.iter().any(|mass| mass.reciprocating > BigRational::zero());
    let thousand = BigRational::from_integer(1000.into());
    let or_wanted = |value: Option<Text>| value.unwrap_or_else(|| Text::label("?"));
    let length = |value: &BigRational| given_with(&(value * &thousand), Unit::MILLIMETRE);
    Table::of(&study.rotor.masses)
        .column("Mass", |mass| &mass.name)
        .column("turning", |mass| or_wanted(mass.mass.as_ref().map(|mass| given_with(mass, Unit::KILOGRAM))))
        .column_if(reciprocating, "reciprocating", |mass| given_with(&mass.reciprocating, Unit::KILOGRAM))
        .column("Radius", |mass| or_wanted(mass.radius.as_ref().map(length)))
        .column("Angle", |mass| or_wanted(mass.angle.as_ref().map(|angle| Text::label(turns(angle.turns())))))
        .column("Position", |mass| or_wanted(mass.position.as_ref().map(length)))
        .done()
}
