//! What has a reader to know of a drawing of stars? Colours, turned arrows and short names, as far as they are in it.

use std::collections::BTreeMap;

use super::panel::MOST_LABELS;
use super::sheet::order_rows;
use super::{Ray, Scale, Star};
use crate::engine::Engine;
use crate::order::Source;
use crate::page::{Text, phrase};
use crate::proof::Quantity;
use crate::report::texts::star as text;
use crate::verdict::{JudgedStar, OrderBalance};

/// What is below the stars of an order.
pub(in crate::report) fn star_legend(engine: &Engine, order: &OrderBalance) -> Text {
    let verdicts = order_rows(order).into_iter().flatten();
    let drawn = verdicts.map(|verdict| {
        let star = Star::of(engine, verdict);
        let scale = Scale::of([&star], verdict.quantity, engine);
        (verdict.quantity, star, scale)
    });
    legend(engine, &drawn.collect::<Vec<_>>())
}

/// What is below stars that are drawn to one scale: those of the inertia torque, and firing stars.
pub(in crate::report) fn legend_of_one_scale(engine: &Engine, judged: &[JudgedStar<'_>]) -> Text {
    let stars: Vec<Star> = judged.iter().map(|judged| Star::new(*judged)).collect();
    let Some(first) = judged.first() else { return Text::default() };
    let scale = Scale::of(&stars, first.quantity, engine);
    legend(engine, &judged.iter().zip(stars).map(|(judged, star)| (judged.quantity, star, scale)).collect::<Vec<_>>())
}

/// The words for what is in stars of these quantities.
pub(super) fn legend(engine: &Engine, drawn: &[(Quantity, Star, Scale)]) -> Text {
    let mut words: Vec<Text> = vec![text::direction()];
    let any = |holds: &dyn Fn(Quantity, &Star) -> bool| drawn.iter().any(|(quantity, star, _)| holds(*quantity, star));
    let sides = |least: u64, most: u64| {
        any(&|_, star| star.polygons.iter().any(|polygon| (least..=most).contains(&polygon.sides)))
    };
    words.extend(any(&|quantity, _| matches!(quantity, Quantity::Planar(_))).then(text::halved));
    words.extend(any(&|_, star| star.by_crank).then(|| match any(&|_, star| !star.by_crank) {
        false => text::by_crankshaft(),
        true => text::some_by_crankshaft(),
    }));
    words.extend(match (sides(2, 2), sides(3, u64::MAX)) {
        (false, false) => None,
        (true, false) => Some(text::bars()),
        (false, true) => Some(text::polygons()),
        (true, true) => Some(text::polygons_and_bars()),
    });
    words.extend(any(&|_, star| star.resultant.is_some()).then(text::resultant));
    let is_turned = |is_moment: bool| any(&|of, star| star.has_turned && (of == Quantity::MOMENT) == is_moment);
    words.extend(match [is_turned(false), is_turned(true)] {
        [false, false] => None,
        [false, true] => Some(text::negative_arm()),
        [true, false] => Some(text::negative_weight()),
        [true, true] => Some(text::negative_weight_or_product()),
    });
    let arrows =
        drawn.iter().flat_map(|(_, star, scale)| labelled(star).iter().flat_map(|ray| ray.arrows(scale.millimetres)));
    let counted = arrows.map(|(_, count)| count).find(|count| *count > 1);
    words.extend(counted.map(text::drawn_as_one));
    words.extend(short_names(engine, drawn.iter().flat_map(|(_, star, _)| labelled(star))));
    if any(&|_, star| star.rays.len() > MOST_LABELS) {
        words.push("Stars with this many directions are not labelled; the table has them.".into());
    }
    Text::joined(words, " ")
}

/// The rays that have their names beside them.
fn labelled(star: &Star) -> &[Ray] {
    if star.rays.len() <= MOST_LABELS { &star.rays } else { &[] }
}

/// What the names of masses that turn mean, as far as they are there.
fn short_names<'a>(engine: &Engine, rays: impl Iterator<Item = &'a Ray>) -> Option<Text> {
    let mut kinds = BTreeMap::new();
    let mut counted = None;
    for ray in rays {
        match ray.counts_turning() {
            true => counted = counted.or(Some(ray.turning().count())),
            false => kinds.extend(ray.turning().filter_map(|source| kind(engine, source))),
        }
    }
    let counted = counted.map(|count| phrase!("+{} for {} rotating masses", count, count));
    let words: Vec<Text> = kinds.into_values().chain(counted).collect();
    (!words.is_empty()).then(|| text::short_names(Text::joined(words, ", ")))
}

/// What the short names of these mean, where tables have them without a drawing.
pub(in crate::report) fn short_names_in_tables(engine: &Engine, sources: impl Iterator<Item = Source>) -> Option<Text> {
    let kinds: BTreeMap<_, _> = sources.filter_map(|source| kind(engine, source)).collect();
    (!kinds.is_empty()).then(|| text::short_names(Text::joined(kinds.into_values(), ", ")))
}

/// A short name, and what it stands for.
fn kind(engine: &Engine, source: Source) -> Option<(&'static str, Text)> {
    match source {
        Source::Piston(_) => None,
        Source::BigEnd(_) if engine.has_yokes_alone() => Some(("rot", text::turning_with_pin())),
        Source::BigEnd(_) => Some(("rod", text::big_end())),
        Source::Knuckle(_) => Some(("kn", text::knuckle())),
        Source::KnuckleAtPin(_) => Some(("kn on", text::knuckle_at_pin())),
        Source::KnuckleOffPin(_) => Some(("kn off", text::knuckle_off_pin())),
        Source::Pin(_) => Some(("pin", text::crankpin())),
        Source::Webs(_) => Some(("webs", text::webs())),
        Source::Counterweight(_) => Some(("cw", text::counterweight())),
        Source::Balancer(_) => Some(("shaft", text::balancer())),
    }
}
