//! What does an engine with masses do at its speed, in one table: how large is each order, what cures it, and what does that leave?

use super::super::calculation::{self, Unit};
use super::super::residual;
use super::cures::Cures;
use super::left::{Name, numbers};
use super::weighing::Weighed;
use crate::engine::{DOES_NOT_EXIST, Engine};
use crate::page::{Setting, Table, Text, number, phrase};
use crate::proof::{Axial, Planar, Quantity};
use crate::verdict::{EveryOrderTheorem, Judgement, NextLeft, OrderVerdict};

/// A row per order of force and of couple that stands out, with what it comes to: then the roll moment, the small orders, and the zeros.
pub(super) fn table(
    engine: &Engine,
    judged: &Judgement,
    theorem: Option<&EveryOrderTheorem>,
    weighed: &Weighed,
    speed: Text,
) -> Table {
    let orders: Vec<&OrderVerdict> = judged.orders.iter().filter(|order| order.exists()).collect();
    let cures = Cures::new(engine, judged, &orders, Some(weighed));
    let mut table =
        Table::new([phrase!("At {} rpm", speed), "Order".into(), "Size".into(), "Cure".into(), "Leaves".into()]);
    for order in &orders {
        let steps = cures.steps(order);
        let mut named = 0;
        for quantity in Planar::BOTH {
            for row in of_order(order, quantity, weighed, &cures, (&steps, &mut named)) {
                table.push(row);
            }
        }
    }
    for row in about_the_axis(weighed).into_iter().chain(small(&orders, weighed, theorem)).chain(zeros(judged, &orders))
    {
        table.push(row);
    }
    // Where nothing is cured nothing is said of cures.
    if table.rows.iter().all(|row| row[COLUMNS - 2..].iter().all(|cell| cell.plain().is_empty())) {
        [&mut table.header].into_iter().chain(&mut table.rows).for_each(|row| row.truncate(COLUMNS - 2));
    }
    table
}

/// Quantity, order, size, cure, and what that leaves.
const COLUMNS: usize = 5;

/// A step of a cure, and which of both vectors it leaves.
type Step = (Text, [bool; 2]);

/// The rows of force or moment of an order: one per step of its cure, up to the one that leaves nothing; `named` steps stand in rows above.
fn of_order(
    order: &OrderVerdict,
    quantity: Planar,
    weighed: &Weighed,
    cures: &Cures,
    (steps, named): (&[Step], &mut usize),
) -> Vec<Vec<Text>> {
    let whole = order.whole(quantity);
    if whole.is_balanced() || whole.is_decided() && !weighed.is_told(order.order, quantity) {
        return Vec::new();
    }
    let unit = weighed.unit_of_tables(quantity);
    let name: Text = Name::of(order, quantity, whole.shape, Some(weighed)).label.into();
    if !whole.is_decided() {
        return vec![uncured(name, order.order.into(), residual::whole_text(whole))];
    }
    let left = |kept: [bool; 2]| {
        let lengths = weighed.lengths(order.order, quantity).into_iter().zip(kept).zip(&whole.outcomes);
        let kept: Vec<f64> =
            lengths.filter(|((_, kept), of)| *kept && of.vanishes() == Some(false)).map(|((one, _), _)| one).collect();
        if kept.is_empty() { Text::zero() } else { size(kept.into_iter().sum(), unit) }
    };
    let left: Vec<Text> = steps.iter().map(|(_, kept)| left(*kept)).collect();
    let enough = left.iter().position(Text::is_zero).map_or(steps.len(), |last| last + 1);
    let above = std::mem::replace(named, enough.max(*named));
    let mut first = [name, order.order.into(), size(weighed.size(order.order, quantity), unit)].to_vec();
    let accepted = || if cures.is_accepted(order) { "usually uncorrected".into() } else { Text::default() };
    if steps.is_empty() {
        return vec![[first, vec![accepted(), Text::default()]].concat()];
    }
    let row = |(step, left): (usize, Text)| {
        let named = std::mem::replace(&mut first, vec![Text::default(); 3]);
        let cure = match step {
            _ if step >= above => steps[step].0.clone(),
            0 if above == 1 => "the same".into(),
            0 => "the first of these".into(),
            _ => "the other".into(),
        };
        let cure = if step == 0 { cure } else { phrase!("and {}", cure) };
        [named, vec![cure, left]].concat()
    };
    left.into_iter().take(enough).enumerate().map(row).collect()
}

/// A row without a cure.
fn uncured(name: Text, orders: Text, size: Text) -> Vec<Text> {
    vec![name, orders, size, Text::default(), Text::default()]
}

fn size(value: f64, unit: Unit) -> Text {
    unit.sized(value, Setting::Usual(number::decimal))
}

/// What an order of the roll moment is called, and all others.
const ROLL: [&str; 2] = ["Roll moment", "All other roll moments"];

/// The orders of the torque, and of the roll moment where it is another, that stand out. Then those that vanish.
fn about_the_axis(weighed: &Weighed) -> Vec<Vec<Text>> {
    let rolls = weighed.loads.rolling() == Some(Axial::Torque);
    let of_torque = if rolls { ROLL } else { ["Inertia torque", "All other torques"] };
    let shown = [(Axial::Roll, ROLL), (Axial::Torque, of_torque)].into_iter();
    let mut rows = Vec::new();
    for (quantity, [name, others]) in shown.filter(|(of, _)| calculation::about_the_axis(&weighed.loads, *of).is_some())
    {
        let orders = weighed.about_the_axis(quantity);
        let most = orders.iter().map(|(_, size)| *size).fold(0.0, f64::max);
        let unit = weighed.unit(Quantity::Axial(quantity)).for_values_up_to(most);
        let is_shown = |order: u32| weighed.is_told(order, Quantity::Axial(quantity));
        let (shown, small): (Vec<_>, Vec<_>) =
            orders.into_iter().filter(|(_, value)| *value > 0.0).partition(|(order, _)| is_shown(*order));
        for (order, value) in shown {
            rows.push(uncured(name.into(), order.into(), size(value, unit)));
        }
        // Of the roll moment of geared cranks no bound of the orders that were not looked at is known.
        let (others, beyond) = if quantity == Axial::Torque { (others, Some(MORE.to_owned())) } else { (name, None) };
        let orders: Vec<String> = small.iter().map(|(order, _)| order.to_string()).chain(beyond).collect();
        if let Some(most) = weighed.rest_in_multiples(Quantity::Axial(quantity)).1 {
            let most = phrase!("≤ {}", unit.sized(most, Setting::Fixed(bound)));
            rows.push(uncured(others.into(), Text::label(orders.join(", ")), most));
        }
        let zeros: Vec<String> = weighed.zeros_about_the_axis(quantity).map(|order| order.to_string()).collect();
        if !zeros.is_empty() {
            rows.push(uncured(name.into(), Text::label(zeros.join(", ")), Text::zero()));
        }
    }
    rows
}

/// And all orders that were not looked at.
const MORE: &str = "…";

/// The orders that are not told one by one: what they and all that were not looked at add up to, at most.
fn small(orders: &[&OrderVerdict], weighed: &Weighed, theorem: Option<&EveryOrderTheorem>) -> Vec<Vec<Text>> {
    let looked_at: Vec<u32> = orders.iter().map(|order| order.order).collect();
    let of = |(quantity, name): (Planar, &'static str)| {
        let next = theorem.map_or(NextLeft::NotKnown, |theorem| theorem.next_left(&[quantity], &looked_at));
        let (small, most) = weighed.rest_in_multiples(quantity);
        let unit = weighed.unit_of_tables(quantity);
        let mut named: Vec<String> = small.iter().map(u32::to_string).collect();
        match next {
            NextLeft::None if small.is_empty() => return None,
            NextLeft::None => {}
            NextLeft::Order(next) if small.is_empty() => named.extend([next.to_string(), MORE.to_owned()]),
            NextLeft::Order(_) | NextLeft::NotKnown => named.push(MORE.to_owned()),
        }
        let most = unit.sized(most?, Setting::Fixed(bound));
        Some(uncured(name.into(), Text::label(named.join(", ")), phrase!("≤ {}", most)))
    };
    [(Planar::Force, "All other forces"), (Planar::Moment, "All other moments")].into_iter().filter_map(of).collect()
}

/// The orders that are zero, and those that are not there.
fn zeros(judged: &Judgement, existing: &[&OrderVerdict]) -> Vec<Vec<Text>> {
    let [forces, moments] =
        Planar::BOTH.map(|quantity| numbers(existing.iter().copied(), |order| order.whole(quantity).is_balanced()));
    let missing = numbers(&judged.orders, |order| !order.exists());
    let rows = match forces == moments {
        true => vec![("Force and moment", forces, Text::zero())],
        false => vec![("Force", forces, Text::zero()), ("Moment", moments, Text::zero())],
    };
    rows.into_iter()
        .chain([("Force and moment", missing, DOES_NOT_EXIST.into())])
        .filter(|(_, orders, _)| !orders.is_empty())
        .map(|(name, orders, size)| uncured(name.into(), Text::label(orders.join(", ")), size))
        .collect()
}

/// No less than a value, to two figures.
fn bound(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { number::sensible(number::raised_to(value, 2)) }
}
