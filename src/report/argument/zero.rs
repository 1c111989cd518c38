//! How is it told that a sum is zero? By a symmetry, or by the regular polygons that are drawn.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::super::star::source_names;
use super::star::{ExactRay, ExactStar};
use super::sums::listed;
use crate::engine::Engine;
use crate::exact::{MOST_VECTORS, MinimalStar, StarClass, Turn, minimal_stars, taken_apart};
use crate::order::Source;
use crate::page::number::angle;
use crate::page::{Choice, Number, Text, phrase};
use crate::proof::{Polygon, Quantity};
use crate::report::rising;
use crate::report::texts::argument as text;
use crate::verdict::{JudgedStar, corners, mirror_partners, opposed_partners};

/// A mirror plane across the crankshaft.
pub(super) fn mirror(engine: &Engine) -> Text {
    let partners = mirror_partners(engine).unwrap_or_default().into_iter().enumerate();
    let cylinders: Vec<Source> = (0..engine.cylinders().len()).map(Source::Piston).collect();
    let pairs = pairs(engine, &cylinders, partners.filter(|(index, partner)| index < partner));
    text::mirror(Text::joined(pairs, ", "))
}

/// Vectors that are equally long and opposite, two by two.
pub(super) fn opposed(engine: &Engine, star: JudgedStar<'_>) -> Text {
    let partners = opposed_partners(star.sum).unwrap_or_default();
    // A source with several vectors, as a link has, is known by their directions.
    let sources: BTreeSet<Source> = star.sources.iter().copied().collect();
    let pairs = match sources.len() < star.sources.len() {
        false => pairs(engine, star.sources, partners.into_iter()),
        true => {
            let one = |index: usize| {
                let at = angle(&star.sum.terms()[index].angle);
                phrase!("{} at {}", star.sources[index].name(engine), at)
            };
            partners.into_iter().map(|(first, second)| phrase!("{} and {}", one(first), one(second))).collect()
        }
    };
    let number = Choice::one_or_more(pairs.len());
    let listed = if pairs.len() == 1 { listed(pairs) } else { Text::joined(pairs, ", of ") };
    match star.quantity {
        Quantity::MOMENT => text::opposed_with_arms(listed, number),
        Quantity::FORCE | Quantity::Axial(_) => text::opposed(listed, number),
    }
}

/// `1 and 4`, a pair of sources each.
fn pairs(engine: &Engine, sources: &[Source], indices: impl Iterator<Item = (usize, usize)>) -> Vec<Text> {
    let name = |index: usize| sources[index].name(engine);
    indices.map(|(first, second)| phrase!("{} and {}", name(first), name(second))).collect()
}

/// Each direction with the weights that cancel on it.
pub(super) fn cancelling(engine: &Engine, star: JudgedStar<'_>) -> Text {
    let mut directions: Vec<(&Turn, Vec<(Source, &BigRational)>)> = Vec::new();
    for (source, term) in star.sources.iter().zip(star.sum.terms()) {
        let entry = (*source, &term.weight);
        match directions.iter_mut().find(|(angle, _)| *angle == &term.angle) {
            Some((_, members)) => members.push(entry),
            None => directions.push((&term.angle, vec![entry])),
        }
    }
    directions.sort_by_key(|(angle, _)| *angle);
    directions.retain(|(_, members)| members.iter().any(|(_, weight)| !weight.is_zero()));
    let one = |(direction, members): &(&Turn, Vec<(Source, &BigRational)>)| {
        let names = source_names(engine, members.iter().map(|(source, _)| *source));
        phrase!("at {} ({}) {} = {}", angle(direction), names, added(members), Text::zero())
    };
    text::cancelling(Text::joined(directions.iter().map(one), "; "))
}

/// `4.5 − 1.5 − 3`.
fn added(members: &[(Source, &BigRational)]) -> Text {
    let mut sum = Text::default();
    for (_, weight) in members {
        sum = match (sum.is_empty(), weight.is_negative()) {
            (true, _) => Number::exact(weight).into(),
            (false, false) => phrase!("{} + {}", sum, Number::exact(weight)),
            (false, true) => phrase!("{} − {}", sum, Number::exact(&weight.abs())),
        };
    }
    sum
}

/// A star that a turn carries into itself, and its polygons.
pub(super) fn rotation(engine: &Engine, star: JudgedStar<'_>, fold: u32) -> Text {
    let symmetry = text::rotation(angle(&Turn::fraction(1, i64::from(fold))));
    // A word on turned vectors has to come before the star is spoken of.
    let sentences = negative_turned(star).into_iter().chain([symmetry]).chain(sentences(engine, star));
    Text::joined(sentences, " ")
}

/// The polygons that the star is made of.
pub(super) fn polygons(engine: &Engine, star: JudgedStar<'_>) -> Text {
    let sentences = negative_turned(star).into_iter().chain(sentences(engine, star));
    Text::joined(sentences.chain(class(star)), " ")
}

/// The classes of minimal stars in it that are no regular polygons.
fn class(star: JudgedStar<'_>) -> Option<Text> {
    static STARS: LazyLock<Vec<MinimalStar>> = LazyLock::new(|| minimal_stars(MOST_VECTORS));
    let classes = taken_apart(star.sum, &STARS)?.into_iter().map(|part| &STARS[part.star].class);
    let classes = rising(classes.filter(|class| !class.is_regular()));
    let named = |class: &StarClass| Text::formula(class.to_string());
    (!classes.is_empty()).then(|| {
        text::minimal_stars(Text::joined(classes.into_iter().map(named), ", "), Text::code("crankstar stars --atlas"))
    })
}

/// What is done with vectors of negative weight, where there are some.
fn negative_turned(star: JudgedStar<'_>) -> Option<Text> {
    ExactStar::new(star).has_turned.then(|| text::negative_turned(star.quantity == Quantity::MOMENT))
}

/// A sentence on all polygons of this many sides; or, where some are taken away, on the polygons that make up the star.
fn sentences(engine: &Engine, star: JudgedStar<'_>) -> Vec<Text> {
    let star = ExactStar::new(star);
    if star.polygons.iter().any(|polygon| !is_part(&star, polygon)) {
        return vec![text::made_of_polygons(Text::joined(star.polygons.iter().map(added_or_taken), "; "))];
    }
    let sides = rising(star.polygons.iter().map(|polygon| polygon.sides));
    let of = |sides: u64| {
        let mut polygons: Vec<&Polygon> = star.polygons.iter().filter(|polygon| polygon.sides == sides).collect();
        let first =
            |polygon: &&Polygon| rays(&star, polygon).iter().flat_map(|ray| &ray.members).map(|one| one.0).min();
        polygons.sort_by_key(first);
        polygons
    };
    sides.into_iter().map(|sides| sentence(engine, &star, sides, &of(sides))).collect()
}

/// Whether vectors of the star, or parts of them, are the corners.
fn is_part(star: &ExactStar, polygon: &Polygon) -> bool {
    polygon.weight.is_positive()
        && rays(star, polygon).len() as u64 == polygon.sides
        && rays(star, polygon).iter().all(|ray| ray.total() >= polygon.weight)
}

/// The rays that point to the corners.
fn rays<'a>(star: &'a ExactStar, polygon: &Polygon) -> Vec<&'a ExactRay> {
    let corners = corners(polygon);
    corners.terms().iter().filter_map(|corner| star.rays.iter().find(|ray| ray.angle == corner.angle)).collect()
}

fn names(engine: &Engine, ray: &ExactRay) -> String {
    source_names(engine, ray.members.iter().map(|(source, _)| *source))
}

/// A sentence on polygons with the same number of sides.
fn sentence(engine: &Engine, star: &ExactStar, sides: u64, polygons: &[&Polygon]) -> Text {
    let members =
        |polygons: &[&Polygon]| Text::joined(polygons.iter().map(|polygon| member(engine, star, polygon)), "; ");
    match (sides, polygons) {
        (2, [only]) => text::opposite(inside(engine, star, only)),
        (2, several) => text::opposite_pairs(members(several)),
        (_, [only]) => text::polygon(inside(engine, star, only), name(sides)),
        (_, several) => text::polygons_alike(name(sides), members(several)),
    }
}

/// The corners of a polygon inside of a sentence that goes on.
fn inside(engine: &Engine, star: &ExactStar, polygon: &Polygon) -> Text {
    let corners = member(engine, star, polygon);
    if is_by_name(star, polygon) { corners } else { corners.and(",") }
}

/// Whether each corner is one whole vector, which has a name.
fn is_by_name(star: &ExactStar, polygon: &Polygon) -> bool {
    rays(star, polygon).iter().all(|ray| ray.total() == polygon.weight && ray.members.len() == 1)
}

/// The corners of one polygon: by the names of their vectors, or by their directions where a vector is a part or several.
fn member(engine: &Engine, star: &ExactStar, polygon: &Polygon) -> Text {
    let mut corners = rays(star, polygon);
    let is_whole = corners.iter().all(|ray| ray.total() == polygon.weight);
    if is_by_name(star, polygon) {
        corners.sort_by_key(|ray| ray.members[0].0);
        return listed(corners.into_iter().map(|ray| names(engine, ray).into()).collect());
    }
    let places = corners.into_iter().map(|ray| phrase!("{} ({})", angle(&ray.angle), names(engine, ray)));
    let places = listed(places.collect());
    match is_whole {
        true => phrase!("at {}, {} long each", places, Number::exact(&polygon.weight)),
        false => phrase!("at {}, taken {} long each", places, Number::exact(&polygon.weight)),
    }
}

/// What the corners are those of.
fn name(sides: u64) -> Text {
    match sides {
        3 => "a regular triangle".into(),
        5 => "a regular pentagon".into(),
        7 => "a regular heptagon".into(),
        more => phrase!("a regular {}-gon", more.to_string()),
    }
}

/// A polygon of a list, by its corners; one of negative weight is taken away.
fn added_or_taken(polygon: &Polygon) -> Text {
    let corners = corners(polygon);
    let at = listed(corners.terms().iter().map(|corner| angle(&corner.angle).into()).collect());
    let weight = Number::exact(&polygon.weight.abs());
    if polygon.weight.is_negative() { text::taken_away(weight, at) } else { text::added(weight, at) }
}
