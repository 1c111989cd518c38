//! How do pistons, rods and pins move? What their drawing needs of each cylinder.

use num_rational::BigRational;

use super::super::engine_page::assumed_ratio;
use super::super::residual::orders_in_words;
use super::super::typeset;
use super::super::views::axes;
use super::open_angle::{OpenAngle, decimal};
use super::scene::{Body, Knuckle};
use crate::engine::{Cylinder, Engine, Link};
use crate::page::Text;
use crate::proof::Sense;
use crate::report::texts::moving as text;
use crate::verdict::{Judgement, OrderVerdict};

/// Rods of a smaller ratio would not fit on the page.
fn least_ratio() -> BigRational {
    BigRational::new(1.into(), 8.into())
}

/// The cylinders from the free end on.
pub(super) fn bodies(engine: &Engine, open: Option<&OpenAngle>) -> Vec<Body> {
    let mut order: Vec<usize> = (0..engine.cylinders().len()).collect();
    let position = |index: usize| &engine.cylinders()[index].position;
    order.sort_by(|one, other| position(*other).cmp(position(*one)));
    let mut cranks: Vec<(usize, [f64; 2])> = Vec::new();
    let several = engine.crankshafts() > 1;
    let mut bodies: Vec<Body> = Vec::new();
    for index in order {
        let mut body = body(engine, index, open);
        let crankshaft = engine.cylinders()[index].crank;
        let crank = (crankshaft, [body.throw, body.throw_turns]);
        body.crank = cranks.iter().position(|other| *other == crank).unwrap_or(cranks.len());
        if body.crank == cranks.len() {
            cranks.push(crank);
        }
        body.colour = if several { crankshaft } else { body.crank };
        body.pin = (!bodies.iter().any(|other| other.crank == body.crank)).then(String::new);
        body.label = (!bodies.iter().any(|other| alike(other, &body))).then(String::new);
        bodies.push(body);
    }
    for first in 0..bodies.len() {
        let named = |of: &dyn Fn(&Body) -> bool| {
            let names = bodies.iter().filter(|body| of(body)).map(|body| body.name.as_str());
            typeset::names(&names.collect::<Vec<_>>())
        };
        let label = bodies[first].label.as_ref().map(|_| named(&|body| alike(body, &bodies[first])));
        let pin = bodies[first].pin.as_ref().map(|_| named(&|body| body.crank == bodies[first].crank));
        (bodies[first].label, bodies[first].pin) = (label, pin);
    }
    bodies
}

/// Whether two cylinders cover each other, seen from the free end.
fn alike(one: &Body, other: &Body) -> bool {
    let motion =
        |body: &Body| [body.throw, body.throw_turns, body.bank, body.bank_turns, body.radius, body.rod, body.aside];
    motion(one) == motion(other) && one.knuckle == other.knuckle && one.axis == other.axis
}

fn body(engine: &Engine, index: usize, open: Option<&OpenAngle>) -> Body {
    let cylinder = &engine.cylinders()[index];
    let [throw_turns, bank_turns] = open.map_or([0.0; 2], |open| open.enters_cylinder(index));
    let axis = axes(engine).get(cylinder.crank).copied().unwrap_or_default();
    // On a crank that turns the other way stands the mirror image of the pin of the equivalent crank, and of its offset.
    let (side, throw_turns) = match engine.sense_of(cylinder) {
        Sense::Direct => (1.0, throw_turns),
        Sense::Reverse => (-1.0, 2.0 * bank_turns - throw_turns),
    };
    let radius = &cylinder.crank_radius;
    let (rod, aside, knuckle) = match (cylinder.rod(), cylinder.link()) {
        (Some(rod), _) => {
            let length = radius / drawn(&rod.ratio);
            let aside = &length * &rod.offset;
            (length, aside, None)
        }
        (None, Some(link)) => {
            let (length, knuckle) = link_on_its_knuckle(link, radius);
            (length, BigRational::default(), Some(knuckle))
        }
        (None, None) => (radius / assumed_ratio(), BigRational::default(), None),
    };
    Body {
        name: cylinder.name.clone(),
        label: None,
        crank: 0,
        pin: None,
        colour: 0,
        axis: [axis.re, axis.im],
        speed: side * f64::from(engine.speed_of(cylinder)),
        throw: decimal(&engine.pin_angle(cylinder).degrees()),
        throw_turns,
        bank: decimal(&cylinder.bank.degrees()),
        bank_turns,
        radius: decimal(radius),
        aside: side * decimal(&aside),
        rod: decimal(&rod),
        knuckle,
    }
}

/// The ratio that a rod is drawn with.
fn drawn(given: &BigRational) -> BigRational {
    given.clone().max(least_ratio())
}

/// Length of a link, and the pin that it is on.
fn link_on_its_knuckle(link: &Link, radius: &BigRational) -> (BigRational, Knuckle) {
    let master = radius / drawn(&link.master);
    let knuckle = Knuckle {
        angle: decimal(&link.angle.degrees()),
        ahead: decimal(&link.knuckle_angle().degrees()),
        radius: decimal(&(&master * &link.knuckle)),
        master: decimal(&master),
    };
    (radius / drawn(&link.ratio), knuckle)
}

/// What is not drawn as the file has it.
pub(super) fn notes(engine: &Engine, judged: &Judgement) -> Vec<Text> {
    let unknown = engine.cylinders().iter().any(|cylinder| cylinder.rod().is_none() && cylinder.link().is_none());
    let links = engine.cylinders().iter().filter_map(Cylinder::link).map(|link| &link.ratio);
    let short = engine.rods().map(|rod| &rod.ratio).chain(links).any(|given| *given < least_ratio());
    let [usual, least] = [assumed_ratio(), least_ratio()].map(|ratio| typeset::number(&ratio));
    // The vectors of an order that is made of several sums have their coefficients.
    let is_one_sum =
        |order: &&OrderVerdict| matches!(order.parts.as_slice(), [only] if only.class.is_none() && only.exists);
    let is_turned = |order: &&OrderVerdict| engine.has_offset() && order.order % 2 == 1;
    let turned = judged.orders.iter().filter(is_one_sum).filter(is_turned).map(|order| order.order);
    let turned: Vec<u32> = turned.collect();
    let notes = [
        (unknown, text::rods_not_given(usual)),
        (short, text::long_rods(least)),
        (!turned.is_empty(), text::offset(orders_in_words(&turned))),
    ];
    notes.into_iter().filter(|(is_so, _)| *is_so).map(|(_, words)| words).collect()
}
