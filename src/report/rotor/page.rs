//! What is on the page of masses on a shaft, and on the terminal?

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::residual;
use super::super::torque::quantity;
use super::{LeftOver, RotorStudy};
use crate::exact::PhasorSum;
use crate::numbers::{self, Direction};
use crate::page::number::{Amount, Bearing, Number, given_with, turns};
use crate::page::{Block, Document, Table, Text, Unit, phrase};
use crate::rotor::{Answer, Found, Real, Reason};

const FOUND: &str = "With $U = m r e^{i\\beta}$ the shaft is balanced where $\\sum U = 0$ and $\\sum z U = 0$: four real equations. Whether they hold, and whether a solution exists, is decided by exact sums; \
    a value after = is exact, after ≈ a decimal.";

const SECONDARY: &str = "Every mass reciprocates on its crank, so that it adds its mass times radius at twice its angle; times ω² and the coefficient c₂ of the connecting rod, nearly crank radius over rod length, these are force and couple of the second order.";

const SCHLICK: &str = "Four cranks whose outer masses are equal, in planes symmetric about the middle, have no force and couple of the first order where the outer cranks stand at $\\pm\\alpha$ and the inner ones at $180^\\circ \\pm \\beta$; the force of the second order vanishes too where $2\\cos\\alpha\\cos\\beta = 1$ (Schlick). With the ratio $\\rho$ of the outer distance to the inner one, $x = \\cos^2\\alpha$ is the positive root of $4x^2 + (\\rho^2-1)x - \\rho^2 = 0$, and the inner masses are $2x$ times the outer ones.";

const LOCOMOTIVE: &str = "The shaft is balanced with this share of the reciprocating masses counted as if it turned. The vertical component of this share is the hammer blow. The rest varies the tractive force, and about the middle between the wheels it is the swaying couple. Only the first order is included, for a long rod; secondary forces are neglected.";

/// The short answer.
pub(super) fn answer(study: &RotorStudy) -> Document {
    let mut answer = Document::new("rotor", &study.rotor.title);
    answer.push(Block::Paragraph(verdict(study)));
    answer.blocks.extend(found(study));
    answer
}

/// The page.
pub(super) fn page(study: &RotorStudy) -> Document {
    let mut page = Document::new("rotor", phrase!("{}: masses on a shaft", &study.rotor.title));
    page.push(Block::Answer(vec![verdict(study)]));
    page.blocks.extend(found(study));
    page.section("The masses", masses(study));
    page.section("How it was found", FOUND);
    if study.rotor.secondary {
        page.push(SCHLICK);
    }
    page
}

fn verdict(study: &RotorStudy) -> Text {
    match &study.answer {
        Answer::Balanced => "The shaft is balanced: force and couple vanish, proved.".into(),
        Answer::Residual(_) => "The shaft is not balanced, proved.".into(),
        Answer::Found(solutions) => {
            // Where no angle is given the whole may be turned about the shaft.
            let is_turned = study.rotor.masses.iter().all(|mass| mass.angle.is_none());
            match (solutions.len(), is_turned) {
                (1, false) => "One solution balances the shaft, and no other does.",
                (1, true) => "One solution balances the shaft; all others are the same, turned about the shaft.",
                (_, false) => "Two solutions balance the shaft, mirror images of each other, and no other does.",
                (_, true) => {
                    "Two solutions balance the shaft, mirror images of each other; all others are these, turned about the shaft."
                }
            }
            .into()
        }
        Answer::Never(reason) => phrase!("No solution, proved: {}", why(*reason, true)),
        Answer::Many(reason) => phrase!("Many solutions: {}", why(*reason, false)),
    }
}

fn why(reason: Reason, is_never: bool) -> Text {
    match reason {
        Reason::OnePlane if is_never => "both wanted masses are in one plane, and a couple about it remains.",
        Reason::OnePlane => "both wanted masses are in one plane, where only their sum matters.",
        Reason::Couple => "the wanted masses balance the force, but a couple remains.",
        Reason::Force => "no mass in the given direction balances the force.",
        Reason::CoupleAlone => "a couple remains in a direction in which the wanted masses balance no force, so no planes for them balance it.",
        Reason::NotParallel => {
            "force and couple do not lie in one plane through the shaft, so that no single mass balances both."
        }
        Reason::OneLine => {
            "both wanted masses are in one line with the shaft, so that they cannot be distinguished by their forces."
        }
        Reason::NoTriangle => {
            "of the three moments about the plane of the wanted mass one is larger than the two others together."
        }
        Reason::BalancedAlready => {
            "one wanted mass has nothing to balance: it is 0 and may be anywhere."
        }
    }
    .into()
}

fn found(study: &RotorStudy) -> Vec<Block> {
    let mut blocks = Vec::new();
    let left = study.left();
    if !left.is_empty() {
        blocks.push(lengths(study, &left).into());
    }
    blocks.extend(study.solutions().iter().map(|solution| Block::from(table(study, solution))));
    if study.solutions().iter().flatten().any(|one| one.cosine.is_some()) {
        blocks.push(Block::Note(
            "cos is that of the angle from the first mass whose angle is wanted, or whose angle alone is given: exact."
                .into(),
        ));
    }
    for (heading, rows, about) in
        [("Second order", study.of_second_order(), SECONDARY), ("Locomotive", study.of_locomotive(), LOCOMOTIVE)]
    {
        if !rows.is_empty() {
            blocks.extend([Block::Heading(1, heading.into()), lengths(study, &rows).into(), about.into()]);
        }
    }
    blocks
}

/// An amount of a real number, `of` this many of it.
fn amount(real: &Real, of: &BigRational) -> Text {
    let exact = real.exact.as_ref().map(|form| form.scaled(of));
    Amount { exact, decimal: real.decimal * numbers::float(of) }.into()
}

/// The direction of a mass that was found: exact where it is a rational angle.
fn direction(one: &Found) -> Text {
    if one.vector.as_ref().is_some_and(PhasorSum::vanishes) {
        return "–".into();
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
        (Some(mass), _) => Some(Number::exact(mass).into()),
        (None, Some(radius)) => Some(amount(&one.mass_radius, &radius.recip())),
        (None, None) => None,
    };
    let radius = |one: &Found| match (&of(one).radius, &of(one).mass) {
        (Some(radius), _) => Some(Number::exact(&(radius * &thousand)).into()),
        (None, Some(mass)) if mass.is_positive() => Some(amount(&one.mass_radius, &(&thousand / mass))),
        (None, _) => None,
    };
    Table::of(solution)
        .column("Mass", |one| &of(one).name)
        .column(phrase!("Mass in {}", Unit::KILOGRAM), |one| Text::or_dash(mass(one)))
        .column(phrase!("Radius in {}", Unit::MILLIMETRE), |one| Text::or_dash(radius(one)))
        .column(phrase!("Mass times radius in {}", Unit::KILOGRAM_METRE), |one| {
            amount(&one.mass_radius, &BigRational::one())
        })
        .column("Angle", |one| direction(one))
        .column_if(has_cosine, "cos", |one| Text::or_dash(one.cosine.as_ref().map(Number::exact)))
        .column_if(has_position, phrase!("Position in {}", Unit::MILLIMETRE), |one| {
            Text::or_dash(one.position.as_ref().map(|position| amount(position, &thousand)))
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
        let length = if zero { Text::zero() } else { phrase!("{} {}", Text::from(modulus()), unit) };
        let bearing =
            || one.star.map_or(Bearing { exact: None, decimal: numbers::degrees(one.sum) }, residual::bearing);
        let towards = if zero { "–".into() } else { bearing().into() };
        let mut row = vec![one.name.into(), length, towards];
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
