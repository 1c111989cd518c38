//! What has a reader to know of a drawing of stars? Colours, turned arrows and short names, as far as they are in it.

use std::collections::BTreeSet;

use super::panel::MOST_LABELS;
use super::sheet::order_rows;
use super::{Ray, Scale, Star};
use crate::engine::Engine;
use crate::order::Source;
use crate::page::{Text, phrase};
use crate::proof::Quantity;
use crate::verdict::{JudgedStar, OrderBalance, Verdict};

/// What stands below the stars of an order.
pub(in crate::report) fn star_legend(engine: &Engine, order: &OrderBalance) -> Text {
    let rows = order_rows(order).into_iter().map(|row| row.map(JudgedStar::from).to_vec());
    legend(engine, &rows.collect::<Vec<_>>())
}

/// What stands below the stars of the inertia torque.
pub(in crate::report) fn torque_legend(engine: &Engine, verdicts: &[&Verdict]) -> Text {
    legend(engine, &[verdicts.iter().map(|verdict| JudgedStar::from(*verdict)).collect()])
}

/// What stands below firing stars.
pub(in crate::report) fn firing_legend(engine: &Engine, stars: &[JudgedStar<'_>]) -> Text {
    legend(engine, &[stars.to_vec()])
}

/// The words for stars whose rows have a scale each.
fn legend(engine: &Engine, rows: &[Vec<JudgedStar<'_>>]) -> Text {
    let mut words: Vec<Text> = vec!["The dashed line is direction 0.".into()];
    let drawn: Vec<(JudgedStar<'_>, Star, Scale)> = rows.iter().flat_map(|row| of_row(engine, row)).collect();
    let any =
        |holds: &dyn Fn(&JudgedStar<'_>, &Star) -> bool| drawn.iter().any(|(judged, star, _)| holds(judged, star));
    let sides = |least: u64, most: u64| {
        any(&|_, star| star.polygons.iter().any(|polygon| (least..=most).contains(&polygon.sides)))
    };
    words.extend(match (sides(2, 2), sides(3, u64::MAX)) {
        (false, false) => None,
        (true, false) => Some("Each coloured bar joins two opposite vectors that cancel.".into()),
        (false, true) => Some("The vectors at the corners of a coloured polygon sum to zero.".into()),
        (true, true) => Some(
            "The vectors at the corners of a coloured polygon, or at the ends of a coloured bar, sum to zero.".into(),
        ),
    });
    if any(&|judged, star| star.resultant.is_some() && judged.quantity != Quantity::TORQUE) {
        words.push(
            "The red arrow in outline is the resultant; half the direct and half the reverse one make what is left."
                .into(),
        );
    } else if any(&|_, star| star.resultant.is_some()) {
        words.push("The red arrow in outline is the resultant.".into());
    }
    if any(&|judged, star| star.has_turned && judged.quantity == Quantity::MOMENT) {
        words.push("A vector with a negative arm is drawn turned by 180°.".into());
    } else if any(&|_, star| star.has_turned) {
        words.push("A vector with a negative weight is drawn turned by 180°.".into());
    }
    let arrows =
        drawn.iter().flat_map(|(_, star, scale)| labelled(star).iter().flat_map(|ray| ray.arrows(scale.millimetres)));
    let counted = arrows.map(|(_, count)| count).find(|count| *count > 1);
    words.extend(counted.map(|count| phrase!("({} ×): {} equal vectors drawn as one.", count, count)));
    words.extend(short_names(drawn.iter().flat_map(|(_, star, _)| labelled(star))));
    if any(&|_, star| star.rays.len() > MOST_LABELS) {
        words.push("Stars of so many directions have no names; the table has them.".into());
    }
    Text::joined(words, " ")
}

fn of_row<'a>(engine: &Engine, row: &[JudgedStar<'a>]) -> Vec<(JudgedStar<'a>, Star, Scale)> {
    let stars: Vec<Star> = row.iter().map(|judged| Star::new(*judged)).collect();
    let Some(first) = row.first() else { return Vec::new() };
    let scale = Scale::of(&stars, first.quantity, engine);
    row.iter().zip(stars).map(|(judged, star)| (*judged, star, scale)).collect()
}

/// The rays that have their names beside them.
fn labelled(star: &Star) -> &[Ray] {
    if star.rays.len() <= MOST_LABELS { &star.rays } else { &[] }
}

/// What the names of masses that turn mean, as far as they stand there.
fn short_names<'a>(rays: impl Iterator<Item = &'a Ray>) -> Option<Text> {
    let mut kinds: BTreeSet<&'static str> = BTreeSet::new();
    let mut counted = None;
    for ray in rays {
        match ray.counts_turning() {
            true => counted = counted.or(Some(ray.turning().count())),
            false => kinds.extend(ray.turning().filter_map(kind)),
        }
    }
    let counted = counted.map(|count| phrase!("+{} for {} masses that turn", count, count));
    let words: Vec<Text> = kinds.into_iter().map(Text::from).chain(counted).collect();
    (!words.is_empty()).then(|| phrase!("Short names: {}.", Text::joined(words, ", ")))
}

/// What a short name stands for.
fn kind(source: Source) -> Option<&'static str> {
    match source {
        Source::Piston(_) => None,
        Source::BigEnd(_) => Some("rod for the big end of a rod"),
        Source::Knuckle(_) | Source::KnuckleAtPin(_) | Source::KnuckleOffPin(_) => {
            Some("kn for the mass at a knuckle pin")
        }
        Source::Pin(_) => Some("pin for a crankpin"),
        Source::Webs(_) => Some("webs for the webs of a throw"),
        Source::Counterweight(_) => Some("cw for a counterweight"),
        Source::Balancer(_) => Some("shaft for a balancer shaft"),
    }
}
