//! What is said of a star that was found? Its throws, its firing order, the moments that it leaves.

use crate::page::{Table, Text, Unit, number, phrase};
use crate::proof::Sense;
use crate::report::typeset::Amount;
use crate::search::{FoundStar, Front, Moment, Sizes};

/// A row a star, the best of the first order first.
pub(super) fn stars(front: &Front) -> Table {
    let first = front.stars.first();
    let mut table = Table::of(front.stars.iter().enumerate())
        .column("Star", |(index, _)| index + 1)
        .column("Firing order", |(_, star)| firing_order(star).unwrap_or_else(|| "uneven".into()))
        .column("Throws in °", |(_, star)| throws(star));
    for (place, moment) in first.iter().flat_map(|star| star.moments.iter().enumerate()) {
        table = table.column(heading(moment), |(_, star)| amount(&star.moments[place]));
        if let Some(sizes) = &front.limits.sizes {
            table = table
                .column(phrase!("in {}", Unit::NEWTON_METRE), |(_, star)| newton_metres(&star.moments[place], sizes));
        }
    }
    for (place, (order, _)) in first.iter().flat_map(|star| star.minor.iter().enumerate()) {
        table = table.column(phrase!("Order {}", order.to_string()), |(_, star)| Amount::of(&star.minor[place].1));
    }
    table
        .column_if(front.problem.neighbours, "Neighbours", |(_, star)| {
            star.neighbours.map_or_else(Text::default, Text::from)
        })
        .column("Equal stars", |(_, star)| equal_stars(star))
        .done()
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

fn newton_metres(moment: &Moment, sizes: &Sizes) -> Text {
    match moment.sum.vanishes() {
        true => Text::zero(),
        false => Text::measured(moment.decimal * sizes.newton_metres(moment.order), Unit::NEWTON_METRE),
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
    star.classes.map_or_else(|| "not counted".into(), |classes| number::grouped(&classes.to_string()).into())
}

/// `1-5-3-4-2-6`.
pub(super) fn firing_order(star: &FoundStar) -> Option<Text> {
    let cylinders = star.firing_order.as_ref()?.iter().map(|cylinder| (cylinder + 1).to_string());
    Some(cylinders.collect::<Vec<_>>().join("-").into())
}

/// The angles of the throws along the shaft, in degrees without their sign.
pub(super) fn throws(star: &FoundStar) -> Text {
    let angles = star.throws.iter().map(|throw| number::number(&throw.degrees()));
    angles.collect::<Vec<_>>().join(", ").into()
}
