//! What is told of a star that was found? Its throws, its firing order, the moments that it leaves.

use crate::page::{Table, Text, number, phrase};
use crate::proof::Sense;
use crate::report::residual;
use crate::report::typeset::Amount;
use crate::search::{FoundStar, Front, Moment};

/// A row a star, the best of the first order first.
pub(super) fn stars(front: &Front) -> Table {
    let moments = front.stars.first().map_or(&[][..], |star| &star.moments);
    let with_neighbours = front.problem.neighbours;
    let header = [Text::from("Star"), "Firing order".into(), "Throws in °".into()];
    let header = header.into_iter().chain(moments.iter().map(heading));
    let minor = front.stars.first().map_or(&[][..], |star| &star.minor);
    let header = header.chain(minor.iter().map(|(order, _)| phrase!("Order {}", order.to_string())));
    let header = header.chain(with_neighbours.then(|| "Neighbours".into())).chain(["Equal stars".into()]);
    let mut table = Table::new(header);
    for (index, star) in front.stars.iter().enumerate() {
        let cells = [(index + 1).into(), firing_order(star).unwrap_or_else(|| "uneven".into()), throws(star)];
        let cells = cells.into_iter().chain(star.moments.iter().map(amount));
        let cells = cells.chain(star.minor.iter().map(|(_, sum)| match sum.vanishes() {
            true => Text::zero(),
            false => residual::modulus_of(sum).into(),
        }));
        let neighbours = || star.neighbours.map_or_else(Text::default, Text::from);
        let cells = cells.chain(with_neighbours.then(neighbours)).chain([equal_stars(star)]);
        table.push(cells.collect());
    }
    table
}

fn heading(moment: &Moment) -> Text {
    match moment.sense {
        None => phrase!("Moment of order {}", moment.order),
        Some(Sense::Direct) => Text::formula(format!("C_{{{}}}^+", moment.order)),
        Some(Sense::Reverse) => Text::formula(format!("C_{{{}}}^-", moment.order)),
    }
}

/// The length of a moment: exact where a closed form is known.
fn amount(moment: &Moment) -> Text {
    match moment.sum.vanishes() {
        true => Text::zero(),
        false => Amount { exact: moment.modulus(), decimal: moment.decimal }.into(),
    }
}

/// The moments that a star leaves, in a row; none where all of them vanish.
pub(super) fn left(star: &FoundStar) -> Option<Text> {
    let told = |moment: &Moment| match moment.sense {
        None => phrase!("{} of order {}", amount(moment), moment.order),
        Some(Sense::Direct) => phrase!("{} direct of order {}", amount(moment), moment.order),
        Some(Sense::Reverse) => phrase!("{} reverse of order {}", amount(moment), moment.order),
    };
    let left = Text::joined(star.moments.iter().filter(|moment| !moment.sum.vanishes()).map(told), ", ");
    (!left.is_empty()).then_some(left)
}

/// How many are as good, where that is known.
fn equal_stars(star: &FoundStar) -> Text {
    star.classes.map_or_else(|| "not counted".into(), |classes| classes.to_string().into())
}

/// `1-5-3-4-2-6`.
pub(super) fn firing_order(star: &FoundStar) -> Option<Text> {
    let cylinders = star.firing_order.as_ref()?.iter().map(|cylinder| (cylinder + 1).to_string());
    Some(cylinders.collect::<Vec<_>>().join("-").into())
}

/// The angles of the throws along the shaft, in degrees without their sign.
pub(super) fn throws(star: &FoundStar) -> Text {
    let angles = star.throws.iter().map(|throw| number::number(&throw.degrees()));
    angles.collect::<Vec<_>>().join(" ").into()
}
