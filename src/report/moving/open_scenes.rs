//! How is a family without values shown in motion? One scene per open angle, all else at values for the drawing.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::super::engine_page::Weighing;
use super::super::typeset;
use super::scene;
use super::scene::Scene;
use crate::engine::{DELTA, Family, PHI};
use crate::family;
use crate::order::Masses;
use crate::page::Text;
use crate::proof::Quantity;
use crate::report::texts::moving as text;
use crate::verdict::Judgement;

/// The scenes of a family, one per open angle, or one where only lengths are open; none where no member can be built.
///
/// What is moved starts at 90° (φ) or 0 (δ); the other angle stays at such a value, and open lengths are drawn as 1, 1/2, 1/3, …
pub fn open_scenes(family: &Family, orders: &[u32]) -> Vec<Scene> {
    let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
    let mut angles: Vec<&str> = [PHI, DELTA].into_iter().filter(|angle| unknowns.contains(angle)).collect();
    if angles.is_empty() {
        angles.push("");
    }
    angles.into_iter().filter_map(|angle| one(family, orders, angle)).collect()
}

/// The scene in which this angle moves.
fn one(family: &Family, orders: &[u32], moving: &str) -> Option<Scene> {
    let values = drawn(family);
    let (angles, lengths): (Values, Values) =
        values.into_iter().partition(|(name, _)| [PHI, DELTA].contains(&name.as_str()));
    let fixed: Values =
        angles.iter().filter(|(name, _)| *name != moving).map(|(name, v)| (name.clone(), v.clone())).collect();
    let along = family.with(&fixed).ok()?;
    let all: Values = angles.into_iter().chain(lengths.clone()).collect();
    let engine = family.with(&all).ok()?.only()?.ok()?;
    let judged = Judgement::of(&engine, orders, Masses::Reciprocating, &Quantity::PLANAR).ok()?;
    let open = family::comparable(&along).ok().and_then(|()| family::classify(&along, orders).ok());
    let open = open.as_ref().map(|open| (&along, open.as_slice()));
    let mut made = scene(&engine, &judged, open, Weighing::usual());
    made.notes.splice(0..0, held(&fixed).into_iter().chain(lengths_drawn(&lengths)));
    Some(made)
}

/// Which other angle does not move.
fn held(fixed: &Values) -> Option<Text> {
    let symbol = |name: &str| name.replace(PHI, "φ").replace(DELTA, "δ");
    let one = |(name, value): (&String, &BigRational)| format!("{} = {}", symbol(name), typeset::turns(value));
    let all: Vec<String> = fixed.iter().map(one).collect();
    (!all.is_empty()).then(|| text::held(all.join(", ")))
}

/// Which lengths the moment is drawn with.
fn lengths_drawn(lengths: &Values) -> Option<Text> {
    let one = |(name, value): (&String, &BigRational)| format!("{name} = {}", typeset::number(value));
    let all: Vec<String> = lengths.iter().map(one).collect();
    (!all.is_empty()).then(|| text::open_lengths(all.join(", ")))
}

/// Unknowns by name with their values: angles in turns.
type Values = BTreeMap<String, BigRational>;

/// A value for the drawing of every unknown.
fn drawn(family: &Family) -> Values {
    let mut parts = 0;
    let mut value = |name: &str| match name {
        PHI => BigRational::new(1.into(), 4.into()),
        DELTA => BigRational::default(),
        _ => {
            parts += 1;
            BigRational::new(1.into(), parts.into())
        }
    };
    family.unknowns().into_iter().map(|name| (name.to_owned(), value(name))).collect()
}
