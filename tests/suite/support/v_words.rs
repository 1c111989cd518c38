//! How are the tables of the page on V engines written?

use std::collections::BTreeSet;

use crankstar::exact::Turn;
use num_rational::BigRational;

use super::pin_stars::{ORDERS, Vanishing};
use super::torus::{Place, Places};
use super::v_angles::{Class, Found, apart, lines, meeting, together};

const SUBSCRIPTS: [&str; 3] = ["M₁", "M₂", "M₄"];

/// The sums that vanish.
pub fn name(vanishing: &Vanishing) -> String {
    let names: Vec<&str> = SUBSCRIPTS.iter().zip(vanishing).filter(|(_, gone)| **gone).map(|(name, _)| *name).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// The files of a class: `star-1-2`.
pub fn stem(vanishing: &Vanishing) -> String {
    let orders = ORDERS.iter().zip(vanishing).filter(|(_, gone)| **gone).map(|(order, _)| format!("-{order}"));
    let orders: String = orders.collect();
    if orders.is_empty() { "star-none".to_owned() } else { format!("star{orders}") }
}

fn degrees(turns: &BigRational) -> String {
    format!("{}°", turns * BigRational::from_integer(360.into()))
}

fn point([phi, delta]: &Place) -> String {
    format!("({}, {})", degrees(phi), degrees(delta))
}

fn angles(turns: &BTreeSet<Turn>) -> String {
    turns.iter().map(|turn| degrees(turn.turns())).collect::<Vec<_>>().join(", ")
}

/// All points, or those on lines of even firing alone; of all, those on such lines are bold.
fn written(places: &Places, even: &BTreeSet<Turn>, only_even: bool) -> String {
    let Places::At(all) = places else { return if only_even { "all".to_owned() } else { "everywhere".to_owned() } };
    let fires = |place: &Place| even.contains(&apart(place));
    let shown = all.iter().filter(|place| !only_even || fires(place));
    let one = |place: &Place| if fires(place) && !only_even { format!("**{}**", point(place)) } else { point(place) };
    let list: Vec<String> = shown.map(one).collect();
    if list.is_empty() { "nowhere".to_owned() } else { list.join(", ") }
}

/// Where each order vanishes of a star that has it.
pub fn points(found: &Found) -> String {
    let free = &found.classes[&[false; 3]];
    let none = BTreeSet::new();
    let row = |at: usize| {
        let k = ORDERS[at];
        let less = if k == 1 {
            String::new()
        } else {
            format!(" − {}φ", if k == 2 { String::new() } else { (k - 1).to_string() })
        };
        let times = if k == 1 { String::new() } else { k.to_string() };
        let Places::At(all) = &free.places[at] else { panic!("points") };
        format!(
            "| {k} | {times}δ{less} ≡ 180° | {}φ − {times}δ ≡ 180° | {} | {} |\n",
            k + 1,
            all.len(),
            written(&free.places[at], &none, false)
        )
    };
    let rows: String = (0..3).map(row).collect();
    format!(
        "| Order | Direct vanishes where | Reverse vanishes where | Points | Both vanish at (φ, δ) |\n| --- | --- | --- | --- | --- |\n{rows}"
    )
}

/// The classes of stars.
pub fn classes(found: &Found) -> String {
    let row = |(vanishing, class): (&Vanishing, &Class)| {
        let [one, two, _] = &class.places;
        let [both, all] = together(&class.places);
        let cells = [one, two, &both, &all].map(|places| written(places, &class.even, false)).join(" | ");
        let counts = class.counts.map(|count| if count == 0 { "–".to_owned() } else { count.to_string() }).join(" | ");
        let stem = stem(vanishing);
        let first = &class.first;
        format!(
            "| {} | {} | {counts} | {cells} | [layout]({stem}.toml), [proof]({stem}.json) |\n",
            name(vanishing),
            first.list()
        )
    };
    let rows: String = found.classes.iter().map(row).collect();
    format!(
        "| Zero | First star | 1 | 2 | 3 | 4 | 5 | 6 | Order 1 | Order 2 | Orders 1 and 2 | Orders 1, 2 and 4 | Files |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n{rows}"
    )
}

/// The stars that can fire evenly.
pub fn even(found: &Found) -> String {
    let rows = found.even.iter().map(|(kind, stars)| {
        let places = &found.classes[&kind.vanishing].places;
        let [both, all] = together(places);
        let [one, two, _] = places;
        let cells = [one, two, &both, &all].map(|places| written(places, &kind.turns, true)).join(" | ");
        let turns = angles(&kind.turns);
        let (count, first) = (stars.len(), stars[0].list());
        format!(
            "| {} | {} | {count} | {first} | {} | {turns} | {cells} |\n",
            kind.pins,
            kind.cycle,
            name(&kind.vanishing)
        )
    });
    format!(
        "| Pins | Cycle | Stars | First star | Zero | φ − δ | Order 1 | Order 2 | Orders 1 and 2 | Orders 1, 2 and 4 |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n{}",
        rows.collect::<String>()
    )
}

/// Where on the lines of even firing one vector is left.
pub fn one_left(found: &Found) -> String {
    let all: BTreeSet<&Turn> = found.even.keys().flat_map(|kind| &kind.turns).collect();
    let lines = lines();
    let rows = all.into_iter().map(|turn| {
        let cells = lines[..2].iter().flat_map(|[direct, reverse]| {
            let [rotating, counter] = [meeting(reverse, turn), meeting(direct, turn)];
            let both = rotating == counter;
            [rotating, counter].map(|place| if both { format!("{}, none left", point(&place)) } else { point(&place) })
        });
        format!("| {} | {} |\n", degrees(turn.turns()), cells.collect::<Vec<_>>().join(" | "))
    });
    format!(
        "| φ − δ | Order 1 rotates | Order 1 counter-rotates | Order 2 rotates | Order 2 counter-rotates |\n\
         | --- | --- | --- | --- | --- |\n{}",
        rows.collect::<String>()
    )
}

/// The shafts of the stars that can fire evenly.
pub fn shafts(found: &Found) -> String {
    let primed = |vanishing: &Vanishing| name(vanishing).replace('M', "M′");
    let rows = found.shafts.iter().map(|((pins, force, moment), shafts)| {
        let (count, first) = (shafts.len(), shafts[0].list());
        format!("| {pins} | {} | {} | {count} | {first} |\n", name(force), primed(moment))
    });
    format!(
        "| Pins | Zero, force | Zero, moment | Shafts | First shaft |\n| --- | --- | --- | --- | --- |\n{}",
        rows.collect::<String>()
    )
}
