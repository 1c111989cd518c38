//! What has a reader to know of a drawing of stars? Colours, turned arrows and short names, as far as they are in it.

use std::collections::BTreeSet;

use super::panel::MOST_LABELS;
use super::sheet::order_rows;
use super::{Ray, Scale, Star};
use crate::engine::Engine;
use crate::order::Source;
use crate::page::{Text, phrase};
use crate::proof::Quantity;
use crate::verdict::{JudgedStar, OrderBalance};

/// What is below the stars of an order.
pub(in crate::report) fn star_legend(engine: &Engine, order: &OrderBalance) -> Text {
    let verdicts = order_rows(order).into_iter().flatten();
    let drawn = verdicts.map(|verdict| {
        let star = Star::of(engine, verdict);
        let scale = Scale::of([&star], verdict.quantity, engine);
        (verdict.quantity, star, scale)
    });
    legend(&drawn.collect::<Vec<_>>())
}

/// What is below stars that are drawn to one scale: those of the inertia torque, and firing stars.
pub(in crate::report) fn legend_of_one_scale(engine: &Engine, judged: &[JudgedStar<'_>]) -> Text {
    let stars: Vec<Star> = judged.iter().map(|judged| Star::new(*judged)).collect();
    let Some(first) = judged.first() else { return Text::default() };
    let scale = Scale::of(&stars, first.quantity, engine);
    legend(&judged.iter().zip(stars).map(|(judged, star)| (judged.quantity, star, scale)).collect::<Vec<_>>())
}

/// The words for what is in stars of these quantities.
pub(super) fn legend(drawn: &[(Quantity, Star, Scale)]) -> Text {
    let mut words: Vec<Text> = vec!["The dashed line is direction 0.".into()];
    let any = |holds: &dyn Fn(Quantity, &Star) -> bool| drawn.iter().any(|(quantity, star, _)| holds(*quantity, star));
    let sides = |least: u64, most: u64| {
        any(&|_, star| star.polygons.iter().any(|polygon| (least..=most).contains(&polygon.sides)))
    };
    words.extend(any(&|quantity, _| matches!(quantity, Quantity::Planar(_))).then(|| HALVED.into()));
    words.extend(any(&|_, star| star.by_crank).then(|| "Each arrow is the resultant of one crankshaft.".into()));
    words.extend(match (sides(2, 2), sides(3, u64::MAX)) {
        (false, false) => None,
        (true, false) => Some("Each coloured bar joins two opposite vectors that cancel.".into()),
        (false, true) => Some("The vectors at the corners of a coloured polygon sum to zero.".into()),
        (true, true) => Some(
            "The vectors at the corners of a coloured polygon, or at the ends of a coloured bar, sum to zero.".into(),
        ),
    });
    words.extend(any(&|_, star| star.resultant.is_some()).then(|| "The red arrow in outline is the resultant.".into()));
    let is_turned = |is_moment: bool| any(&|of, star| star.has_turned && (of == Quantity::MOMENT) == is_moment);
    words.extend(match [is_turned(false), is_turned(true)] {
        [false, false] => None,
        [false, true] => Some("A vector with a negative arm is drawn turned by 180°.".into()),
        [true, false] => Some("A vector with a negative weight is drawn turned by 180°.".into()),
        [true, true] => Some(
            "A vector with a negative weight, or a negative product of weight and arm, is drawn turned by 180°.".into(),
        ),
    });
    let arrows =
        drawn.iter().flat_map(|(_, star, scale)| labelled(star).iter().flat_map(|ray| ray.arrows(scale.millimetres)));
    let counted = arrows.map(|(_, count)| count).find(|count| *count > 1);
    words.extend(counted.map(|count| phrase!("({} ×): {} equal vectors drawn as one.", count, count)));
    words.extend(short_names(drawn.iter().flat_map(|(_, star, _)| labelled(star))));
    if any(&|_, star| star.rays.len() > MOST_LABELS) {
        words.push("Stars with this many directions are not labelled; the table has them.".into());
    }
    Text::joined(words, " ")
}

/// Why the vectors of a star are half as long as those of the table.
const HALVED: &str = "Vectors are drawn halved, as they count in force and moment.";

/// The rays that have their names beside them.
fn labelled(star: &Star) -> &[Ray] {
    if star.rays.len() <= MOST_LABELS { &star.rays } else { &[] }
}

/// What the names of masses that turn mean, as far as they are there.
fn short_names<'a>(rays: impl Iterator<Item = &'a Ray>) -> Option<Text> {
    let mut kinds: BTreeSet<&'static str> = BTreeSet::new();
    let mut counted = None;
    for ray in rays {
        match ray.counts_turning() {
            true => counted = counted.or(Some(ray.turning().count())),
            false => kinds.extend(ray.turning().filter_map(kind)),
        }
    }
    let counted = counted.map(|count| phrase!("+{} for {} rotating masses", count, count));
    let words: Vec<Text> = kinds.into_iter().map(Text::from).chain(counted).collect();
    (!words.is_empty()).then(|| phrase!("Short names: {}.", Text::joined(words, ", ")))
}

/// What a short name stands for.
fn kind(source: Source) -> Option<&'static str> {
    match source {
        Source::Piston(_) => None,
        Source::BigEnd(_) => Some("rod for the big end of a rod"),
        Source::Knuckle(_) => Some("kn for the mass at a knuckle pin, as far as it moves as the master piston does"),
        Source::KnuckleAtPin(_) => Some("kn on for that mass at the crankpin"),
        Source::KnuckleOffPin(_) => Some("kn off for what is taken from it there, at the angle of the knuckle"),
        Source::Pin(_) => Some("pin for a crankpin"),
        Source::Webs(_) => Some("webs for the webs of a throw"),
        Source::Counterweight(_) => Some("cw for a counterweight"),
        Source::Balancer(_) => Some("shaft for a balancer shaft"),
    }
}
