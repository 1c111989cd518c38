//! How is it put for which φ and δ a sum vanishes in which both enter on their own?

use num_rational::BigRational;

use super::circle_words::{self, none_of};
use super::coordinate::{self, Coordinate};
use super::unknowns::{NEVER, alternatives, exactly, names, together, zero_where};
use crate::family::{Circle, Classes, Corner, Root, Triangle};
use crate::page::{Text, phrase};
use crate::report::texts::family as text;

/// `0 where δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`; `0 on a curve, at one φ for each δ`.
pub(super) fn condition(classes: &Classes) -> Text {
    let [u, v] = names([&classes.u, &classes.v]);
    if classes.is_curve() {
        return text::curve(v, u);
    }
    let open = classes.circle.iter().flat_map(circle_words::open);
    zero_where(zeros(classes), open).unwrap_or_else(|| none_of(classes.circle.as_ref()))
}

/// `δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`; none where no zero in the range is known.
fn zeros(classes: &Classes) -> Option<Text> {
    let both = [&classes.u, &classes.v];
    coordinate::in_words(rational(classes.rational(), both).chain(irrational(classes.irrational(), both)))
}

/// `δ ≡ 90° and φ ≡ 60°`, or `δ ≡ 180°`: zeros at rational turns of the first unknown.
pub(super) fn rational<'a>(
    zeros: impl Iterator<Item = (&'a BigRational, &'a Option<Vec<Root>>)>,
    [u, v]: [&'a [BigRational; 2]; 2],
) -> impl Iterator<Item = Vec<Coordinate>> {
    zeros.flat_map(move |(at, roots)| {
        let own = || Coordinate::exact(u, at);
        match roots {
            None => vec![vec![own()]],
            Some(roots) => roots.iter().map(|root| vec![own(), Coordinate::of(v, root)]).collect(),
        }
    })
}

/// `φ ≈ 12.5° and δ ≈ 75.52°`: zeros at no rational turn of the first unknown.
pub(super) fn irrational<'a>(
    zeros: impl Iterator<Item = ([&'a BigRational; 2], f64)>,
    [u, v]: [&'a [BigRational; 2]; 2],
) -> impl Iterator<Item = Vec<Coordinate>> {
    zeros.map(move |(ends, degrees)| vec![Coordinate::between(u, ends), Coordinate::near(v, degrees)])
}

/// Why it vanishes there, and nowhere else.
pub(super) fn why(classes: &Classes) -> Text {
    let [u, v] = names([&classes.u, &classes.v]);
    let lead = text::two_classes(u.clone(), v.clone());
    let equal = match (&classes.circle, classes.is_curve()) {
        (_, true) => text::equal_for_every(u, v),
        (None, false) => text::never_equal(),
        (Some(circle), false) => {
            let degree = (circle.polynomial.degree() / 2).to_string();
            let difference = text::difference(degree, u.clone(), circle.claim.arcs.len());
            Text::joined([difference, so(circle, zeros(classes), &u)], " ")
        }
    };
    Text::joined([lead, equal], " ")
}

/// What follows from a circle for the zeros that are known.
pub(super) fn so(circle: &Circle, zeros: Option<Text>, u: &str) -> Text {
    let told = match (zeros, circle.is_complete()) {
        (Some(zeros), true) => text::so_zeros(zeros),
        (None, true) => text::so_none(),
        (Some(zeros), false) => text::zeros_but_on_open_arcs(zeros),
        (None, false) => text::no_zero_but_on_open_arcs(),
    };
    let only = circle.irrational().map(|near| {
        let [from, to] = circle_words::between(circle, near);
        text::irrational(from, to, u.to_owned())
    });
    Text::joined([told].into_iter().chain(only).chain(circle_words::open(circle).map(text::step_limit)), " ")
}

/// `0 where φ ≡ 90° and δ ≡ 45°, or φ ≈ 30° and δ ≈ 75.52°`.
pub(super) fn triangle_condition(triangle: &Triangle) -> Text {
    match corners(triangle) {
        Some(corners) => phrase!("0 where {}", corners),
        None if triangle.corners.is_empty() => "never 0".into(),
        None => NEVER.into(),
    }
}

fn corners(triangle: &Triangle) -> Option<Text> {
    let corner = |corner: &Corner| match corner {
        Corner::Exact(exact) => together(&exact.conditions, exactly),
        Corner::Near(degrees) => {
            let each = triangle.multiples.iter().zip(degrees);
            coordinate::in_words([each.map(|(times, degrees)| Coordinate::near(times, *degrees)).collect()])
        }
    };
    alternatives(triangle.corners.iter().filter_map(corner))
}

/// Why it vanishes there, and nowhere else.
pub(super) fn triangle_why(triangle: &Triangle) -> Text {
    match (corners(triangle), triangle.corners.len()) {
        (None, 1..) => text::sides_not_turned(),
        (None, 0) => text::triangle_impossible(),
        (Some(corners), 1) => text::flat_triangle(corners),
        (Some(corners), _) => text::triangle(corners),
    }
}
