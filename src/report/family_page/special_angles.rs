//! At which angles does order 1 vanish or do counterweights cancel it, and what remains of order 2 there?

use std::collections::{BTreeMap, BTreeSet};

use super::super::residual;
use super::words;
use crate::engine::{DELTA, Family, PHI};
use crate::exact::Turn;
use crate::family::OpenOrder;
use crate::page::Text;
use crate::proof::Quantity;
use crate::report::texts::family as text;
use crate::verdict::Judgement;

/// A sentence for each group of angles where the same remains; none where order 1 always or never loses its reverse vectors.
pub(super) fn sentences(family: &Family, orders: &[OpenOrder]) -> Vec<Text> {
    let mut groups: Vec<(BTreeSet<Turn>, There)> = Vec::new();
    for (angle, vanishes) in angles(orders).unwrap_or_default() {
        let there = There { vanishes, remains: remains(family, &angle) };
        match groups.iter_mut().find(|(_, other)| other.is_like(&there)) {
            Some((angles, _)) => _ = angles.insert(angle),
            None => groups.push((BTreeSet::from([angle]), there)),
        }
    }
    let sentence = |(angles, there): (BTreeSet<Turn>, There)| match there.remains {
        Some(remains) => text::first_cancelled_rest(words::list(&angles), there.vanishes, remains),
        None => text::first_cancelled(words::list(&angles), there.vanishes),
    };
    groups.into_iter().map(sentence).chain(of_two_angles(family, orders)).collect()
}

/// What an angle leaves.
struct There {
    /// Whether all of order 1 vanishes, without counterweights.
    vanishes: bool,
    /// What remains of order 2.
    remains: Option<Text>,
}

impl There {
    fn is_like(&self, other: &There) -> bool {
        let plain = |there: &There| there.remains.as_ref().map(Text::plain);
        self.vanishes == other.vanishes && plain(self) == plain(other)
    }
}

/// Where counterweights cancel order 1 of a family with two open angles: where the one reverse vector vanishes that does not always do so.
fn of_two_angles(family: &Family, orders: &[OpenOrder]) -> Option<Text> {
    let unknowns = family.unknowns();
    let first = orders.iter().find(|order| order.order == 1)?;
    let mut open = [&first.force[1], &first.moment[1]].into_iter().filter(|reverse| !reverse.always());
    let condition = words::conditions_of(open.next()?)?;
    let is_one_of_two = [PHI, DELTA].iter().all(|angle| unknowns.contains(angle)) && open.next().is_none();
    is_one_of_two.then(|| text::counterweights_where(condition))
}

/// The bank angles at which both reverse vectors of order 1 vanish, and whether both direct ones, which counterweights cancel, do so too.
fn angles(orders: &[OpenOrder]) -> Option<Vec<(Turn, bool)>> {
    let first = orders.iter().find(|order| order.order == 1)?;
    let [direct, reverse] = [0, 1].map(|sense| [&first.force[sense], &first.moment[sense]]);
    let angles = match reverse.map(|vector| vector.always()) {
        [true, true] => None,
        [true, false] => reverse[1].bank_angles(),
        [false, true] => reverse[0].bank_angles(),
        [false, false] => Some(reverse[0].bank_angles()?.intersection(&reverse[1].bank_angles()?).cloned().collect()),
    };
    let vanishes = |angle: &Turn| {
        direct.iter().all(|vector| vector.always() || vector.bank_angles().is_some_and(|angles| angles.contains(angle)))
    };
    Some(angles?.into_iter().map(|angle| (angle.clone(), vanishes(&angle))).collect())
}

/// What remains of order 2 at an angle; none where lengths are open besides, or no piston has the order.
fn remains(family: &Family, angle: &Turn) -> Option<Text> {
    let values = BTreeMap::from([(PHI.to_owned(), angle.turns().clone())]);
    let member = family.with(&values).ok()?.only()?.ok()?;
    let judged = Judgement::new(&member, &[2], &[Quantity::FORCE, Quantity::MOMENT]).ok()?;
    let second = judged.orders.first().filter(|order| matches!(&order.parts[..], [only] if only.exists))?;
    let [force, moment] = residual::whole(second);
    Some(match (force.is_zero(), moment.is_zero()) {
        (true, true) => text::second_balanced(),
        (false, true) => text::second_force(force),
        (true, false) => text::second_moment(moment),
        (false, false) => text::second_force_and_moment(force, moment),
    })
}
