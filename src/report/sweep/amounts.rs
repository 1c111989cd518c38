//! How are the amounts of a sweep shown on a page? In newtons where the file gives them, else in multiples; 0 where it is proved.

use num_rational::BigRational;

use crate::loads::Arm;
use crate::numbers::float;
use crate::page::plot::Axis;
use crate::page::{Number, Piece, Text, Unit, number, phrase};
use crate::proof::Planar;
use crate::report::texts::sweep as text;
use crate::sweep::{Amplitude, Amplitudes, Envelope, Multiples, Parameter, Sweep, SweptEngine};

/// Decimals that differ by less than this part are shown alike.
pub(super) const ALIKE: f64 = 1e-9;

/// A side of what an engine fits into.
pub(super) type Side = fn(&Envelope) -> Option<f64>;

/// Whether the file gives mass, crank radius, speed and rods, so that every point is known in newtons. At rest there are none to show.
pub(super) fn in_newtons(sweep: &Sweep) -> bool {
    let points = || sweep.points.iter().chain(&sweep.curve);
    points().all(|point| point.newtons.is_some()) && points().any(|point| point.newtons != Some(0.0))
}

/// The sweep with its amplitudes in what a page counts in, which [`unit`] names.
pub(super) fn counted(sweep: &Sweep) -> Sweep {
    let mut counted = sweep.clone();
    if in_newtons(sweep) {
        counted.points.iter_mut().chain(&mut counted.curve).for_each(multiply);
    }
    counted
}

fn multiply(point: &mut SweptEngine) {
    let factor = point.newtons.unwrap_or(1.0);
    for amplitudes in point.orders.iter_mut().flat_map(|order| [&mut order.force, &mut order.moment]) {
        match factor {
            // At rest.
            0.0 => *amplitudes = Amplitudes::ZERO,
            _ => amplitudes.scale(factor),
        }
    }
}

/// What amplitudes are counted in on a page.
pub(super) fn unit(sweep: &Sweep, quantity: Planar) -> Text {
    let is_moment = quantity == Planar::Moment;
    match (in_newtons(sweep), sweep.rods_known, is_moment, sweep.arm) {
        (true, ..) => newtons(sweep, quantity).into(),
        (false, true, false, _) => "$m r \\omega^2$".into(),
        (false, false, false, _) => "$m r \\omega^2 c_k$".into(),
        (false, true, true, Arm::Spacing) => "$m r \\omega^2 a$".into(),
        (false, false, true, Arm::Spacing) => "$m r \\omega^2 c_k a$".into(),
        (false, true, true, Arm::Metre) => "$m r \\omega^2 \\cdot \\mathrm{m}$".into(),
        (false, false, true, Arm::Metre) => "$m r \\omega^2 c_k \\cdot \\mathrm{m}$".into(),
    }
}

/// The one unit of all multiples, where the points have different ones of their own and something is counted in multiples.
pub(super) fn one_unit(sweep: &Sweep) -> Option<Text> {
    let Multiples { mass, radius } = sweep.multiples.as_ref()?;
    let thousand = BigRational::from_integer(1000.into());
    let mass = mass.as_ref().map(|mass| phrase!("{} = {}", "$m$", number::given_with(mass, Unit::KILOGRAM)));
    let millimetres = |metres: &BigRational| number::given_with(&(metres * &thousand), Unit::MILLIMETRE);
    let radius = radius.as_ref().map(|metres| phrase!("{} = {}", "$r$", millimetres(metres)));
    let is_counted = !in_newtons(sweep) || sweep.firing.is_some();
    is_counted.then(|| text::one_unit(Text::joined(mass.into_iter().chain(radius), ", ")))
}

/// What forces, or moments, are counted in where they are known in newtons.
pub(super) fn newtons(sweep: &Sweep, quantity: Planar) -> Unit {
    match (quantity, sweep.arm) {
        (Planar::Force, _) => Unit::NEWTON,
        (Planar::Moment, Arm::Metre) => Unit::NEWTON_METRE,
        (Planar::Moment, Arm::Spacing) => Unit::NEWTON_SPACING,
    }
}

/// The axis of these amplitudes.
pub(super) fn axis(sweep: &Sweep, quantity: Planar) -> Axis {
    let name = if quantity == Planar::Moment { "Moment" } else { "Force" };
    match in_newtons(sweep) {
        true => Axis::amplitude(format!("{name} in {{}}")).counted_in(newtons(sweep, quantity)),
        false => Axis::amplitude(format!("{name} in {}", unit(sweep, quantity).plain())),
    }
}

/// What is as small as roundings, of several sums.
const NOT_DECIDED: &str = "not decided";

/// An amplitude in a table: a decimal in what [`unit`] names, or 0.
pub(super) fn size(sweep: &Sweep, quantity: Planar, part: Amplitude) -> Text {
    match (part.vanishes, in_newtons(sweep)) {
        _ if part.is_undecided => NOT_DECIDED.into(),
        (true, _) => Text::zero(),
        (false, true) => Text::measured(part.value, newtons(sweep, quantity)),
        (false, false) => number_of(part),
    }
}

/// A decimal, or 0, of what has no unit.
pub(super) fn number_of(part: Amplitude) -> Text {
    match part.is_zero() {
        None => NOT_DECIDED.into(),
        Some(true) => Text::zero(),
        Some(false) => Number::Decimal(part.value).into(),
    }
}

/// An amplitude with its unit behind it.
pub(super) fn with_unit(sweep: &Sweep, quantity: Planar, part: Amplitude) -> Text {
    match (part.vanishes, in_newtons(sweep), quantity, sweep.arm) {
        _ if part.is_undecided => NOT_DECIDED.into(),
        (true, ..) => Text::zero(),
        (false, true, Planar::Force, _) => Piece::Quantity(part.value, Unit::NEWTON).into(),
        (false, true, Planar::Moment, Arm::Metre) => Piece::Quantity(part.value, Unit::NEWTON_METRE).into(),
        (false, ..) => phrase!("{} {}", size(sweep, quantity, part), unit(sweep, quantity)),
    }
}

/// A value of a parameter with its unit.
pub(super) fn value(parameter: &Parameter, at: &BigRational, is_angle: bool) -> Text {
    match unit_of_axis(parameter, is_angle) {
        "°" => number::degrees(at).into(),
        "" => number::number(at).into(),
        unit => phrase!("{} {}", number::number(at), unit.to_owned()),
    }
}

/// Zeros of an angle, rising: exact ones, and the decimals of those at no rational turn.
pub(super) fn zeros(parameter: &Parameter, at: &[BigRational], irrational: &[[BigRational; 2]]) -> Vec<Text> {
    let middle = |[low, high]: &[BigRational; 2]| (low + high) / BigRational::from_integer(2.into());
    let about = |at: &BigRational| match parameter.range.unit() {
        "" | "°" | "deg" => phrase!("≈ {}°", Text::figures(float(at))),
        unit => phrase!("{} {}", Number::Decimal(float(at)), unit.to_owned()),
    };
    let exact = at.iter().map(|at| (at.clone(), value(parameter, at, true)));
    let mut all: Vec<(BigRational, Text)> =
        exact.chain(irrational.iter().map(middle).map(|at| (at.clone(), about(&at)))).collect();
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all.into_iter().map(|(_, text)| text).collect()
}

/// The values of a point: that of the only parameter, or both with their names.
pub(super) fn place(sweep: &Sweep, point: &SweptEngine) -> Text {
    let named = sweep.parameters.len() > 1;
    let values = sweep.axes().zip(&point.values).map(|((parameter, is_angle), at)| match named {
        true => match name(sweep, parameter) {
            name if name == parameter.label => phrase!("{} {}", name, value(parameter, at, is_angle)),
            // With a number or a key in it a name needs a sign between.
            name => phrase!("{} = {}", name, value(parameter, at, is_angle)),
        },
        false => value(parameter, at, is_angle),
    });
    Text::joined(values, " with ")
}

/// The values of a point in a table.
pub(super) fn place_cells(point: &SweptEngine) -> impl Iterator<Item = Text> {
    point.values.iter().map(|at| number::number(at).into())
}

/// The headings above the values of the parameters: `bank angle in °`.
pub(super) fn place_headings(sweep: &Sweep) -> impl Iterator<Item = Text> {
    sweep.axes().map(|(parameter, is_angle)| match unit_of_axis(parameter, is_angle) {
        "" => name(sweep, parameter).into(),
        unit => phrase!("{} in {}", name(sweep, parameter), unit.to_owned()),
    })
}

/// `bank angle in °`.
pub(super) fn axis_name(sweep: &Sweep, parameter: &Parameter, is_angle: bool) -> String {
    let name = name(sweep, parameter);
    match unit_of_axis(parameter, is_angle) {
        "" => name,
        // Patterns of whole names, for other languages.
        "°" => format!("{name} in °"),
        "rpm" => format!("{name} in rpm"),
        "mm" => format!("{name} in mm"),
        unit => format!("{name} ({unit})"),
    }
}

/// What a parameter is called on a page: `throws`; `throws 2` beside another value of the list, and its key where even that is not clear.
pub(super) fn name(sweep: &Sweep, parameter: &Parameter) -> String {
    let with_places = |parameter: &Parameter| {
        let key = parameter.key.to_string();
        let places = key.split('.').filter(|part| part.parse::<usize>().is_ok());
        [parameter.label.as_str()].into_iter().chain(places).collect::<Vec<_>>().join(" ")
    };
    let is_clear = |name: &dyn Fn(&Parameter) -> String| {
        sweep.parameters.iter().all(|other| other == parameter || name(other) != name(parameter))
    };
    match parameter {
        _ if is_clear(&|parameter| parameter.label.clone()) => parameter.label.clone(),
        _ if is_clear(&with_places) => with_places(parameter),
        _ => parameter.key.to_string(),
    }
}

fn unit_of_axis(parameter: &Parameter, is_angle: bool) -> &str {
    match parameter.unit() {
        "" if is_angle => "°",
        "deg" => "°",
        unit => unit,
    }
}
