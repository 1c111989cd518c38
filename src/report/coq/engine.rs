//! How is an engine written in Coq? Each number a fraction, each name in a comment.

use super::evidence::fraction;
use super::not_stated::has_pistons;
use crate::proof::{Cylinder, Document, Sense, TurningMassClaim};
use crate::text::coq_comment;

/// The definition of the engine: the pistons where the verdicts are about them, and the masses that turn.
pub(super) fn definition(document: &Document) -> String {
    let cylinders = document.cylinders.iter().filter(|_| has_pistons(document)).map(cylinder).collect();
    let turning = document.turning_masses.iter().map(turning_mass).collect();
    format!(
        "(* Angles in turns; lengths, masses and radii in units that the whole engine shares. *)\n\
         Definition the_engine : engine := Engine {}\n  (* cylinders: throw, bank, position, mass, crank radius *)\n{}\n  \
         (* turning masses: order, sense, position, angle, mass times radius *)\n{}.\n",
        fraction(&document.reference_plane),
        list(cylinders),
        list(turning)
    )
}

fn cylinder(cylinder: &Cylinder) -> (String, String) {
    let Cylinder { throw, bank, position, reciprocating_mass, crank_radius, .. } = cylinder;
    let numbers = [throw, bank, position, reciprocating_mass, crank_radius].map(fraction);
    (format!("Cylinder {}", numbers.join(" ")), coq_comment(&cylinder.name))
}

fn turning_mass(mass: &TurningMassClaim) -> (String, String) {
    let numbers = [&mass.position, &mass.angle, &mass.mass_radius].map(fraction);
    (format!("TurningMass {} {} {}", mass.order, sense(mass.sense), numbers.join(" ")), coq_comment(&mass.name))
}

/// A list, each entry with what it is called.
fn list(entries: Vec<(String, String)>) -> String {
    if entries.is_empty() {
        return "  nil".to_owned();
    }
    let last = entries.len() - 1;
    let line = |(index, (entry, name)): (usize, (String, String))| {
        let sign = if index == last { "]" } else { ";" };
        format!("    {entry}{sign} (* {name} *)\n")
    };
    format!("  [::\n{}", entries.into_iter().enumerate().map(line).collect::<String>()).trim_end().to_owned()
}

/// A sense as Engine.v calls it.
pub(super) fn sense(sense: Sense) -> &'static str {
    sense.choose("Direct", "Reverse")
}
