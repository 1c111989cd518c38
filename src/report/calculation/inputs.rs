//! What goes into a calculation? The values of the layout file, and what follows from them line by line.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::expression::{Expression, Line, fraction, power, quantity};
use super::given::{crank_radius, of_measure};
use super::links;
use crate::engine::{Engine, Given, Measure};
use crate::exact::Turn;
use crate::loads::{Loads, Scale};
use crate::page::number::{given_in, given_with};
use crate::page::{Piece, Table, Text, Unit, phrase};
use crate::proof::Sense;
use crate::report::table::{position, position_heading};
use crate::report::texts::loads as text;
use crate::report::typeset;

/// Lines are written for each cylinder only up to this many; beyond, the table of inputs holds the values.
const MOST_LINES: usize = 12;

/// In what a quantity of these is counted; none where it is a number alone, or a speed.
fn unit(measure: Measure) -> Option<Unit> {
    match words(measure).2 {
        "m" => Some(Unit::METRE),
        "kg" => Some(Unit::KILOGRAM),
        _ => None,
    }
}

/// Name, symbol in TeX and unit of a quantity.
pub(super) fn words(measure: Measure) -> (Text, &'static str, &'static str) {
    match measure {
        Measure::Speed => ("speed".into(), "n", "rpm"),
        Measure::Stroke => ("stroke".into(), "s", "m"),
        Measure::CrankRadius => ("crank radius".into(), "r", "m"),
        Measure::RodLength => ("rod length between centres".into(), "l", "m"),
        Measure::RodRatio => ("rod ratio".into(), "\\lambda", ""),
        Measure::PinOffset => ("offset of the cylinder axis".into(), "e", "m"),
        Measure::OffsetRatio => ("offset ratio".into(), "\\delta", ""),
        Measure::ReciprocatingMass => ("reciprocating mass per cylinder".into(), "m", "kg"),
        Measure::PistonMass => ("piston with rings".into(), "m_{\\mathrm{P}}", "kg"),
        Measure::PinMass => ("piston pin".into(), "m_{\\mathrm{B}}", "kg"),
        Measure::PistonRodMass => ("piston rod".into(), "m_{\\mathrm{S}}", "kg"),
        Measure::CrossheadMass => ("crosshead".into(), "m_{\\mathrm{K}}", "kg"),
        Measure::RodMass => ("rod".into(), "m_{\\mathrm{R}}", "kg"),
        Measure::RodCentre => (text::rod_centre(), "x_{\\mathrm{G}}", "m"),
        Measure::RotatingMass => (text::rotating_mass(), "m_{\\mathrm{rot}}", "kg"),
        Measure::KnuckleRadius => (text::knuckle_radius(), "a", "m"),
        Measure::KnuckleRatio => ("knuckle ratio a/l".into(), "\\kappa", ""),
        Measure::LinkLength => ("length of a link between centres".into(), "L", "m"),
        Measure::LinkRatio => ("link ratio".into(), "r/L", ""),
        Measure::KnuckleMass => (text::knuckle_mass(), "m_{\\mathrm{kn}}", "kg"),
    }
}

/// A value that was given, in the units of the reader.
fn value(given: &Given) -> Text {
    match (unit(given.quantity), given.quantity == Measure::Speed) {
        (Some(unit), _) => phrase!("{} {}", Piece::Shortly(given.value.clone(), unit), unit),
        (None, true) => phrase!("{} rpm", typeset::number(&given.value)),
        (None, false) => Text::label(typeset::number(&given.value)),
    }
}

/// The table of inputs: quantity, symbol, value in the units of the reader, as written, cylinder.
pub(in crate::report) fn table(engine: &Engine) -> Table {
    Table::of(&engine.dimensions().given)
        .column("Quantity", |given| words(given.quantity).0)
        .column("Symbol", |given| Text::formula(words(given.quantity).1))
        .column("Value", |given| value(given))
        .column("As written", |given| &given.written)
        .column("Cylinder", |given| match given.cylinder {
            Some(index) => engine.cylinders()[index].name.clone().into(),
            None if given.quantity.is_of_links() => Text::from("all links"),
            None => "all".into(),
        })
        .done()
}

/// The masses on the crankshaft and the balancer shafts: what, mass, radius, angle at θ = 0, position, speed.
pub(super) fn turning(engine: &Engine) -> Table {
    let mut table = Table::new([
        "Turning mass".into(),
        phrase!("Mass in {}", Unit::KILOGRAM),
        phrase!("Radius ({})", Unit::METRE),
        "Angle at θ = 0".into(),
        position_heading(engine),
        Text::from("Turns per revolution"),
    ]);
    let crankshaft = engine.crankshaft();
    let mut row = |name: Text, mass: Text, radius: Text, angle: &Turn, place: &BigRational, speed: Text| {
        table.push(vec![name, mass, radius, typeset::angle(angle).into(), position(engine, place), speed]);
    };
    let mass_of = |value: &BigRational| given_in(value, Unit::KILOGRAM);
    let radius_of = |value: &BigRational| given_in(value, Unit::METRE);
    let throws = crate::engine::throws(engine);
    for (index, (mass, throw)) in crankshaft.pins.iter().zip(&throws).enumerate() {
        let name = phrase!("pin, throw {}", index + 1);
        row(name, mass_of(mass), "r".into(), &throw.angle, &throw.position, 1_u32.into());
    }
    for (index, (web, throw)) in crankshaft.webs.iter().zip(&throws).enumerate() {
        let name = phrase!("webs, throw {}", index + 1);
        row(name, mass_of(&web.mass), radius_of(&web.radius), &throw.angle, &throw.position, 1_u32.into());
    }
    for weight in &crankshaft.counterweights {
        let name = weight.throw.map(|throw| phrase!("counterweight, throw {}", throw + 1));
        let name = name.unwrap_or_else(|| "counterweight".into());
        row(name, mass_of(&weight.mass), radius_of(&weight.radius), &weight.angle, &weight.position, 1_u32.into());
    }
    for shaft in &crankshaft.balancers {
        let speed = match shaft.sense {
            Sense::Direct => Text::from(shaft.order),
            Sense::Reverse => Text::label(format!("−{}", shaft.order)),
        };
        let product = || given_with(&shaft.mass_radius, Unit::KILOGRAM_METRE);
        let product = match shaft.coefficient_of.and_then(|index| engine.cylinders().get(index)) {
            Some(cylinder) => {
                let symbol = Text::formula(format!("c_{{{}}}", shaft.order));
                phrase!("{} × {} of cylinder {}", product(), symbol, cylinder.name.clone())
            }
            None => product(),
        };
        row("balancer shaft".into(), product, "–".into(), &shaft.angle, &shaft.position, speed);
    }
    table
}

/// What follows from the inputs before any order: radius, ratios, masses, ω and m r ω².
pub(super) fn lines(engine: &Engine, loads: &Loads) -> Vec<Line> {
    let of_cylinders = |given: &Given| given.cylinder.is_some() && !given.quantity.is_of_links();
    let by_cylinder = engine.dimensions().given.iter().any(of_cylinders);
    let cylinders = if by_cylinder { engine.cylinders().len() } else { 1 };
    let mut lines = Vec::new();
    if cylinders <= MOST_LINES {
        for index in 0..cylinders {
            lines.extend(of_cylinder(engine, index, by_cylinder));
        }
    }
    if engine.cylinders().len() <= MOST_LINES {
        lines.extend(links::lines(engine, by_cylinder));
    }
    if let Some(scale) = &loads.scale {
        lines.extend(of_engine(scale));
    }
    lines
}

fn of_cylinder(engine: &Engine, index: usize, by_cylinder: bool) -> Vec<Line> {
    let value = |measure: Measure| of_measure(engine, index, measure);
    let subscript = if by_cylinder { format!("_{{{}}}", engine.cylinders()[index].name) } else { String::new() };
    let named = |symbol: &str| match symbol.split_once('_') {
        Some((letter, below)) if by_cylinder => {
            let below = below.trim_matches(['{', '}']).replace("\\mathrm{", "");
            format!("{letter}_{{{below},{}}}", engine.cylinders()[index].name)
        }
        _ => format!("{symbol}{subscript}"),
    };
    let of = |measure: Measure| value(measure).map(|value| quantity(named(words(measure).1), value));
    let line = |symbol: &str, expression, unit| Line { symbol: named(symbol), expression, unit };
    let mut lines = Vec::new();
    if let Some(stroke) = of(Measure::Stroke) {
        lines.push(line("r", fraction(stroke, Expression::Number(2)), "m"));
    }
    let radius = crank_radius(engine, index).map(|radius| quantity(named("r"), radius));
    if let (Some(radius), Some(length)) = (radius.clone(), of(Measure::RodLength)) {
        lines.push(line("\\lambda", fraction(radius, length), ""));
    }
    if let Some(offset) = of(Measure::PinOffset) {
        match (of(Measure::RodLength), radius, of(Measure::RodRatio)) {
            (Some(length), ..) => lines.push(line("\\delta", fraction(offset, length), "")),
            (None, Some(radius), Some(ratio)) => {
                lines.push(line("\\delta", fraction(Expression::Product(vec![offset, ratio]), radius), ""));
            }
            _ => {}
        }
    }
    lines.extend(masses(&of, &line));
    lines
}

/// The rod as two masses (theory, section 7).
fn masses(
    of: &impl Fn(Measure) -> Option<Expression>,
    line: &impl Fn(&str, Expression, &'static str) -> Line,
) -> Vec<Line> {
    let Some(piston) = of(Measure::PistonMass) else { return Vec::new() };
    let mut terms = vec![piston];
    terms.extend([Measure::PinMass, Measure::PistonRodMass, Measure::CrossheadMass].into_iter().filter_map(of));
    let mut lines = Vec::new();
    if let (Some(rod), Some(centre), Some(length)) =
        (of(Measure::RodMass), of(Measure::RodCentre), of(Measure::RodLength))
    {
        let part = |numerator| fraction(Expression::Product(vec![rod.clone(), numerator]), length.clone());
        terms.push(part(centre.clone()));
        let rest = Expression::Sum(vec![length.clone(), Expression::Minus(Box::new(centre))]);
        lines.push(line("m_{\\mathrm{rot}}", part(rest), "kg"));
    }
    let sum = if terms.len() == 1 { terms.remove(0) } else { Expression::Sum(terms) };
    lines.insert(0, line("m", sum, "kg"));
    lines
}

fn of_engine(scale: &Scale) -> Vec<Line> {
    let float = |value: &BigRational| value.to_f64().unwrap_or(f64::INFINITY);
    let speed = quantity("n", float(&scale.speed));
    let omega =
        fraction(Expression::Product(vec![Expression::Number(2), Expression::Pi, speed]), Expression::Number(60));
    let force = Expression::Product(vec![
        quantity("m", float(&scale.mass)),
        quantity("r", float(&scale.crank_radius)),
        power(quantity("\\omega", scale.omega()), 2),
    ]);
    let mut lines = vec![
        Line { symbol: "\\omega".to_owned(), expression: omega, unit: "rad\\,s^{-1}" },
        Line { symbol: "K".to_owned(), expression: force, unit: "N" },
    ];
    // An engine without reciprocating masses is counted in multiples of one kilogram.
    if scale.mass.is_zero() {
        lines.clear();
    }
    lines
}
