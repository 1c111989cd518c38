//! How do the force of one piston and its two vectors belong together? One cylinder of the engine, worked out and drawn.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use super::star::towards;
use super::{table, typeset};
use crate::engine::{Cylinder, Engine};
use crate::exact::Turn;
use crate::numbers;
use crate::page::{Block, Number, Picture, Text};
use crate::proof::Sense;
use crate::report::texts::example as text;
use crate::verdict::OrderBalance;

/// What stands before equations (1) and (2): one cylinder of these sums, of order 1 or 2, put into them, with a picture.
pub fn worked(engine: &Engine, balance: &OrderBalance) -> Vec<Block> {
    // Above order 2 a coefficient may be negative or imaginary, and the picture would need more words than it explains.
    // A link's vector is made of several there, and in order 1 too where its knuckle angle is corrected; that of a crank which turns faster
    // is of another order of its own.
    let is_one = (engine.has_one_vector_per_order() && engine.faster_crank().is_none())
        || (balance.order == 1 && engine.is_centric());
    let is_shown = balance.exists && balance.order <= 2 && is_one;
    let Some((cylinder, weight)) = chosen(engine, balance).filter(|_| is_shown) else { return Vec::new() };
    let mut blocks = vec![two_vectors(balance.order).into(), numbers_of(cylinder, weight, balance).into()];
    let has_side_part = balance.order == 1 && cylinder.rod().is_some_and(|rod| !rod.offset.is_zero());
    blocks.extend(has_side_part.then(|| text::offset().into()));
    blocks.push(picture(cylinder, balance.order).into());
    blocks.push(text::all_cylinders().into());
    blocks
}

/// A cylinder of the sums that has a mass: one whose throw and axis are both turned where there is one.
fn chosen<'a>(engine: &'a Engine, balance: &'a OrderBalance) -> Option<(&'a Cylinder, &'a BigRational)> {
    let direct = &balance.force.direct;
    let terms = direct.sources.iter().zip(direct.sum.terms());
    let pistons = terms.filter_map(|(source, term)| Some((engine.cylinders().get(source.piston()?)?, &term.weight)));
    let is_plain = |angle: &Turn| *angle == Turn::zero();
    pistons
        .filter(|(_, weight)| weight.is_positive())
        .min_by_key(|(cylinder, _)| usize::from(is_plain(&cylinder.throw)) + usize::from(is_plain(&cylinder.bank)))
}

/// A cosine along a line as the half sum of two vectors that turn.
fn two_vectors(order: u32) -> Text {
    match order {
        1 => text::first_order(),
        k => text::higher_order(k, Text::formula(format!("\\cos {k}(\\theta + \\beta - \\alpha)"))),
    }
}

/// The numbers of the cylinder put into (2).
fn numbers_of(cylinder: &Cylinder, weight: &BigRational, balance: &OrderBalance) -> Text {
    let order = balance.order;
    let formula = |sense| table::phase_formula(i64::from(order), sense, true);
    text::numbers(
        cylinder.name.clone(),
        typeset::angle(&cylinder.throw),
        typeset::degrees(&typeset::signed_degrees(&cylinder.bank)),
        Number::exact(weight),
        formula(Sense::Direct),
        table::working(cylinder, order, Sense::Direct),
        formula(Sense::Reverse),
        table::working(cylinder, order, Sense::Reverse),
    )
}

/// One panel, and the length of the force at its largest, in millimetres.
const PANEL: (f64, f64) = (74.0, 70.0);
const CENTRE: Point = Point::new(37.0, 33.0);
const REACH: f64 = 25.0;
const CRANK: f64 = 7.0;

fn picture(cylinder: &Cylinder, order: u32) -> Picture {
    let mut figure = Figure::new(2.0 * PANEL.0, PANEL.1);
    // At the one the force points outwards, at the other inwards.
    for (column, wanted) in [50, 130].into_iter().enumerate() {
        let corner = Point::new(column as f64 * PANEL.0, 0.0);
        draw(&mut figure, corner, cylinder, order, &crank_angle(cylinder, order, wanted));
    }
    let name = cylinder.name.clone();
    let caption = match order {
        1 => text::two_angles(name),
        _ => text::two_angles_of_order(name, order),
    };
    Picture::new("direct-and-reverse", caption, figure)
}

/// `k(θ + β − α)`: how far the vectors are turned from the axis.
fn from_axis(cylinder: &Cylinder, order: u32, crank: &Turn) -> Turn {
    (&(crank + &cylinder.throw) - &cylinder.bank).times(i64::from(order))
}

/// The crank angle, in tens of degrees, at which the vectors stand nearest to this many degrees from the axis.
fn crank_angle(cylinder: &Cylinder, order: u32, wanted: i64) -> Turn {
    let distance = |crank: &Turn| {
        let degrees = typeset::signed_degrees(&from_axis(cylinder, order, crank)).abs();
        (degrees - BigRational::from_integer(wanted.into())).abs()
    };
    let angles = (1..36).map(|tens| Turn::fraction(tens, 36));
    angles.min_by_key(distance).unwrap_or_else(Turn::zero)
}

fn draw(figure: &mut Figure, corner: Point, cylinder: &Cylinder, order: u32, crank: &Turn) {
    let centre = corner + CENTRE;
    let axis = towards(&cylinder.bank);
    let turned = from_axis(cylinder, order, crank);
    let [direct, reverse] = [&cylinder.bank + &turned, &cylinder.bank - &turned];
    figure.heading(corner + Point::new(PANEL.0 / 2.0, PANEL.1 - 5.0), format!("θ = {}", typeset::angle(crank)));
    let guide = Stroke { ink: Ink::Grey, width: 0.25, dash: Dash::Dashed };
    figure.line(centre - axis * REACH, centre + axis * REACH, guide);
    figure.circle(centre, CRANK, Stroke::solid(Ink::Light, 0.3), None);
    let pin = centre + towards(&(crank + &cylinder.throw)) * CRANK;
    figure.line(centre, pin, Stroke::solid(Ink::Grey, 0.9));
    figure.circle(pin, 1.1, Stroke::solid(Ink::Grey, 0.3), Some(Ink::Light));
    let tip = centre + axis * (numbers::direction(&turned).re * REACH);
    let halves = [(&direct, Ink::Blue, "½ direct"), (&reverse, Ink::Orange, "½ reverse")];
    for (angle, ..) in &halves {
        figure.line(
            centre + towards(angle) * (REACH / 2.0),
            tip,
            Stroke { ink: Ink::Grey, width: 0.2, dash: Dash::Dotted },
        );
    }
    figure.arrow(centre, tip, Stroke::solid(Ink::Red, 1.1));
    for (angle, ink, name) in halves {
        let along = towards(angle);
        figure.arrow(centre, centre + along * (REACH / 2.0), Stroke::solid(ink, 0.7));
        label(figure, centre + along * (REACH / 2.0 + 3.0), along, name);
    }
    // Beyond the tip; beside it where the axis would run through the word.
    let outward = (tip - centre) / (tip - centre).norm().max(1.0);
    match outward.re.abs() < 0.3 {
        true => figure.text(tip + outward * 2.5 + Point::new(1.5, 0.0), "force", Anchor::Start),
        false => label(figure, tip + outward * 3.2, outward, "force"),
    }
}

/// A word beyond the tip of an arrow.
fn label(figure: &mut Figure, at: Point, along: Point, name: &'static str) {
    let anchor = match along.re / along.norm().max(1e-9) {
        x if x > 0.3 => Anchor::Start,
        x if x < -0.3 => Anchor::End,
        _ => Anchor::Middle,
    };
    figure.text(at, name, anchor);
}
