//! Which tables has the layout file of a corrected engine? Those of the weights that stay, and those of what is built.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::parts::{counterweight_parts, in_few_terms, mass_step};
use super::rounded::{is_of_link, rounded};
use super::{Built, Remedy, Replaced, Weight};
use crate::engine::{Balancer, Counterweight, Cylinder, Engine, Rod};
use crate::exact::{PhasorSum, Term, Turn};
use crate::file::{
    balancer_table, comment, counted_from_its_throw, counterweight_in_multiples, counterweight_table, exact_number,
    without_balancers, without_counterweights,
};
use crate::numbers;
use crate::order::Factor;
use crate::proof::Sense;

/// The weights that the file has still: those of the engine that the remedy does not resize, by index.
pub(super) struct Kept {
    pub counterweights: Vec<Counterweight>,
    pub balancers: Vec<Balancer>,
    /// Whether the file lists its counterweights anew, and its balancer shafts.
    lists: [bool; 2],
}

impl Kept {
    pub fn of(remedy: &Remedy) -> Self {
        let crankshaft = remedy.subject.engine().crankshaft();
        let resized: Vec<&Built> = remedy.resized().collect();
        let staying = |count: usize, of: fn(&Replaced) -> &Vec<usize>| -> Vec<usize> {
            let goes = |index: &usize| resized.iter().any(|plane| of(&plane.replaced).contains(index));
            (0..count).filter(|index| !goes(index)).collect()
        };
        let counterweights = staying(crankshaft.counterweights.len(), |replaced| &replaced.counterweights);
        let balancers = staying(crankshaft.balancers.len(), |replaced| &replaced.balancers);
        // A layout whose balance factor makes the counterweights has no others.
        let made = !crankshaft.balance_factors.is_empty();
        Kept {
            lists: [
                made || counterweights.len() < crankshaft.counterweights.len(),
                balancers.len() < crankshaft.balancers.len(),
            ],
            counterweights: counterweights.iter().map(|index| crankshaft.counterweights[*index].clone()).collect(),
            balancers: balancers.iter().map(|index| crankshaft.balancers[*index].clone()).collect(),
        }
    }
}

/// The text of a layout file with the weights of a remedy behind it.
pub(super) fn with_tables(remedy: &Remedy, source: &str) -> String {
    let engine = remedy.subject.engine();
    let kept = Kept::of(remedy);
    let mut text = source.to_owned();
    if kept.lists[0] {
        text = without_counterweights(&text);
    }
    if kept.lists[1] {
        text = without_balancers(&text);
    }
    text = text.trim_end().to_owned() + "\n";
    if kept.lists.contains(&true) {
        text += &format!("\n{}", comment(&there(remedy, &kept)));
    }
    if kept.lists[0] {
        text.extend(kept.counterweights.iter().map(|weight| counterweight_of_throw(remedy, weight)));
    }
    if kept.lists[1] {
        text.extend(kept.balancers.iter().map(|shaft| balancer_table(engine, shaft, unit(remedy).as_ref())));
    }
    let orders = remedy.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    let head =
        format!("Cancels force and moment of these orders: {orders}. Tables at one position are parts of one weight.");
    let built = &remedy.built;
    if !built.is_empty() {
        text += &format!("\n{}", comment(&head));
    }
    if built.iter().any(|plane| is_of_link(&plane.becomes)) {
        text += &comment(ROUNDED);
    }
    let mut heading = String::new();
    for plane in built {
        let tables = tables(remedy, plane);
        let own = heading_of(&plane.becomes);
        if !tables.is_empty() && own != heading {
            text += &format!("\n{}", comment(&own));
            heading = own;
        }
        if tables.len() > 1 {
            text += &comment(&together(remedy, &plane.becomes, tables.len()));
        }
        text.extend(tables);
    }
    text
}

/// What is said of the weights that the file has of its own, and of those that are resized.
fn there(remedy: &Remedy, kept: &Kept) -> String {
    let made = !remedy.subject.engine().crankshaft().balance_factors.is_empty();
    let listed = match (made, kept.lists) {
        (true, _) => "The counterweights that the balance factor of the file makes.",
        (false, [true, false]) => "The counterweights of the file.",
        (false, [false, true]) => "The balancer shafts of the file.",
        (false, _) => "The counterweights and balancer shafts of the file.",
    };
    let resized: Vec<&Built> = remedy.resized().collect();
    let was = |plane: &Built| {
        let size = plane
            .was
            .decimals(&remedy.subject)
            .map(|[size, degrees]| format!(", before {size:.6} m r at {degrees:.3}°"));
        format!("z = {}{}", plane.was.position, size.unwrap_or_default())
    };
    match resized.is_empty() {
        true => listed.to_owned(),
        false => {
            let planes: Vec<String> = resized.into_iter().map(was).collect();
            format!("{listed}\nResized, and listed below: {}.", planes.join("; "))
        }
    }
}

/// m r in kilogram-metres, where the file does not give it and weights are multiples of it.
fn unit(remedy: &Remedy) -> Option<BigRational> {
    let engine = remedy.subject.engine();
    remedy.subject.scale().is_none().then(|| engine.unit_mass() * engine.unit_radius())
}

/// What is said of weights that are not exact.
const ROUNDED: &str = "Against what links on a master rod leave there is no exact size: those weights are decimals, and leave less than 10^-6 of the load.";

fn heading_of(weight: &Weight) -> String {
    match (weight.order, weight.sense) {
        (1, Sense::Direct) => "On the crankshaft.".to_owned(),
        (order, Sense::Direct) => format!("A shaft at {order} times crank speed, with the crank."),
        (order, Sense::Reverse) => format!("A shaft at {order} times crank speed, against the crank."),
    }
}

/// What parts of one weight are together.
fn together(remedy: &Remedy, weight: &Weight, parts: usize) -> String {
    let at = format!("At z = {} one weight in {parts} parts", exact_number(&weight.position));
    match (weight.mass_radius(&remedy.subject), weight.decimals(&remedy.subject)) {
        (Some(size), Some([_, degrees])) => {
            let places = usize::try_from(4 - libm::log10(size).floor() as i64).unwrap_or(0);
            format!("{at}, together {size:.places$} kg m at {:.3}°.", in_one_turn(remedy, degrees))
        }
        (None, Some([multiple, degrees])) => {
            format!("{at}, together {multiple:.6} m r at {:.3}°.", in_one_turn(remedy, degrees))
        }
        (_, None) => format!("{at}."),
    }
}

/// An angle as the engine is drawn, from 0° to 360°.
fn in_one_turn(remedy: &Remedy, degrees: f64) -> f64 {
    let turn = Turn::new(BigRational::from_float(degrees / 360.0).unwrap_or_default());
    numbers::float(&remedy.subject.engine().convention().as_written(&turn).degrees())
}

/// A counterweight, with the throw that it belongs to.
fn counterweight_of_throw(remedy: &Remedy, weight: &Counterweight) -> String {
    let engine = remedy.subject.engine();
    let table = |weight: &Counterweight| match unit(remedy) {
        None => counterweight_table(weight, engine.convention()),
        Some(unit) => counterweight_in_multiples(weight, engine.convention(), &unit),
    };
    counted_from_its_throw(engine, weight, table)
}

/// A table for each vector of what is in a plane, none of two that are opposite.
fn tables(remedy: &Remedy, plane: &Built) -> Vec<String> {
    let engine = remedy.subject.engine();
    let weight = &plane.becomes;
    let own = engine.unit_mass() * engine.unit_radius();
    let multiples = unit(remedy);
    let radius = remedy.radius_in(plane);
    // What is resized keeps its throw.
    let resized = plane.replaced.counterweights.first();
    let throw = resized.and_then(|index| engine.crankshaft().counterweights[*index].throw);
    // A shaft that is there keeps its axis, and a weight that it gets besides stands on that.
    let others =
        remedy.built.iter().filter(|other| (other.becomes.order, other.becomes.sense) == (weight.order, weight.sense));
    let there = std::iter::once(plane).chain(others).find_map(|plane| plane.replaced.balancers.first());
    let axis = there.map(|index| &engine.crankshaft().balancers[*index]);
    let counterweight = |angle: Turn, mass: BigRational| {
        let (radius, position) = (radius.clone(), weight.position.clone());
        Counterweight { throw, angle, mass, radius, position, crank: 0 }
    };
    let table = |coefficient_of: Option<usize>, size: BigRational, angle: Turn| {
        if (weight.order, weight.sense, coefficient_of) == (1, Sense::Direct, None) {
            return counterweight_of_throw(remedy, &counterweight(angle, &size / &radius));
        }
        let shaft = Balancer {
            order: weight.order,
            sense: weight.sense,
            mass_radius: size,
            coefficient_of,
            angle,
            position: weight.position.clone(),
            axis: axis.and_then(|there| there.axis.clone()),
        };
        balancer_table(engine, &shaft, multiples.as_ref())
    };
    if is_of_link(weight) {
        let as_written = |size: BigRational| if multiples.is_none() { size } else { size * &own };
        let rounded = rounded(&remedy.subject, weight);
        return rounded.map(|(size, angle)| table(None, as_written(size), angle)).into_iter().collect();
    }
    let parts = weight.vector.parts().iter();
    let terms = parts.flat_map(|(factor, sum)| in_few_terms(sum).into_iter().map(move |term| (factor, term)));
    let exact = terms.flat_map(|(factor, term): (&Factor, Term)| {
        coefficients(engine, factor, weight.order).into_iter().map(move |(coefficient_of, part)| {
            let turned = &term.angle + &weight.sense.signed(part.angle.clone());
            (coefficient_of, &term.weight * part.weight, turned)
        })
    });
    let exact = exact.map(|(coefficient_of, size, angle)| {
        let size = size * &own;
        let angle = if size.is_negative() { angle.opposite() } else { angle };
        (coefficient_of, size.abs(), angle)
    });
    let exact: Vec<(Option<usize>, BigRational, Turn)> = exact.collect();
    let is_plain = exact.iter().all(|(coefficient_of, ..)| coefficient_of.is_none());
    if exact.len() > 1 && is_plain && (weight.order, weight.sense) == (1, Sense::Direct) && multiples.is_none() {
        // Their masses add up to that of the weight.
        let terms = exact.into_iter().map(|(_, weight, angle)| Term { angle, weight });
        let step = mass_step(&engine.unit_mass());
        let parts =
            counterweight_parts(&counterweight(Turn::zero(), Zero::zero()), &PhasorSum::new(terms.collect()), &step);
        return parts.iter().map(|part| counterweight_of_throw(remedy, part)).collect();
    }
    exact.into_iter().map(|(coefficient_of, size, angle)| table(coefficient_of, size, angle)).collect()
}

/// A factor as the coefficients of cylinders, none for 1, each with what its direct vector is multiplied by.
fn coefficients(engine: &Engine, factor: &Factor, order: u32) -> Vec<(Option<usize>, Term)> {
    let Factor::Quadrature(rod) = factor else {
        let (coefficient_of, weight) = coefficient(engine, factor, order);
        return vec![(coefficient_of, Term { angle: Turn::zero(), weight })];
    };
    // y = −i (c_1 − 1), with the other sign where the offset has.
    let is_it = |own: &Rod| own.unsigned() == *rod;
    let found = engine.cylinders().iter().position(|one| engine.speed_of(one) == 1 && one.rod().is_some_and(is_it));
    let is_behind = found.and_then(|index| engine.cylinders()[index].rod()).is_some_and(|own| own.offset.is_negative());
    let [one, less] = [1, -1].map(|sign| BigRational::from_integer(sign.into()));
    let [own, plain] = if is_behind { [less, one] } else { [one, less] };
    let part = |weight| Term { angle: Turn::fraction(3, 4), weight };
    vec![(found, part(own)), (None, part(plain))]
}

/// The cylinder whose coefficient a factor is, and the sign between the two; none for 1.
fn coefficient(engine: &Engine, factor: &Factor, order: u32) -> (Option<usize>, BigRational) {
    let one = BigRational::from_integer(1.into());
    // Weights against what is left of no rod on a crankpin are not written by its terms, and against what faster cranks leave not at all.
    let is_plain = |cylinder: &Cylinder| cylinder.mechanism.is_none() || cylinder.rod().is_some();
    let of_cylinder = |(index, cylinder): (usize, &Cylinder)| {
        let (own, sign) = Factor::of_rod(cylinder.rod(), order);
        (is_plain(cylinder) && engine.speed_of(cylinder) == 1 && own == *factor).then_some((index, sign))
    };
    let found = engine.cylinders().iter().enumerate().filter(|_| *factor != Factor::One).find_map(of_cylinder);
    found.map_or((None, one), |(index, sign)| (Some(index), sign))
}
