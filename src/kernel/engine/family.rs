//! Which engines does a file with unknowns describe? A family: angles in φ and δ, positions in symbols.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;

use super::build_error::BuildError;
use super::draft::ReferencePlane;
use super::linear::Linear;
use super::model::Engine;
use crate::exact::Turn;

/// The unknown bank angle.
pub const PHI: &str = "phi";
/// The unknown angle of a split pin.
pub const DELTA: &str = "delta";

/// All engines that a layout file with unknowns describes: the angles are in turns, φ and δ may be in them, and symbols
/// in its lengths.
pub type Family = Engine<Linear, Linear>;

impl Family {
    /// The unknowns that are left, by name.
    pub fn unknowns(&self) -> BTreeSet<&str> {
        let parts = self.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank, &cylinder.position]);
        parts.flat_map(|linear| linear.symbols().keys()).map(String::as_str).collect()
    }

    /// Whether φ turns a bank, not the throws alone.
    pub fn has_open_banks(&self) -> bool {
        self.cylinders().iter().any(|cylinder| cylinder.bank.symbols().contains_key(PHI))
    }

    /// Whether δ turns the parts of a crankpin against each other, not whole throws alone.
    pub fn has_open_splits(&self) -> bool {
        let of_split = |one: &Linear, other: &Linear| one.coefficient(DELTA) != other.coefficient(DELTA);
        let mut cylinders = self.cylinders().iter();
        cylinders
            .any(|one| self.cylinders().iter().any(|other| one.pin == other.pin && of_split(&one.throw, &other.throw)))
    }

    /// The family with some unknowns known: angles in turns, lengths in the unit of the positions.
    ///
    /// # Errors
    /// What does not hold together with them.
    pub fn with(&self, values: &BTreeMap<String, BigRational>) -> Result<Family, BuildError> {
        let known = |linear: &Linear| Some(linear.with(values));
        let plane = self.plane(self.reference_plane().with(values));
        let cylinders = self.cylinders().iter().filter_map(|cylinder| cylinder.map(known, known)).collect();
        let mut draft = self.draft().with_cylinders(cylinders, plane);
        draft.open_firing = self.open_firing().map(|firing| firing.with(values));
        draft.build()
    }

    /// The one engine of a family without unknowns; `None` where one is left. It fires where the family can with its values.
    ///
    /// # Errors
    /// What does not hold together in it.
    pub fn only(&self) -> Option<Result<Engine, BuildError>> {
        let turn = |linear: &Linear| linear.as_known().cloned().map(Turn::new);
        let cylinders = self.cylinders().iter().map(|cylinder| cylinder.map(turn, |place| place.as_known().cloned()));
        let cylinders = cylinders.collect::<Option<Vec<_>>>()?;
        let plane = self.plane(self.reference_plane().as_known()?.clone());
        let mut draft = self.draft().with_cylinders(cylinders, plane);
        if let Some((cycle, open)) = self.cycle().zip(draft.open_firing.take()) {
            draft.firing = open.known(cycle, &draft.cylinders);
        }
        Some(draft.build())
    }

    /// The plane of a member, named where that of the family is.
    fn plane<L>(&self, at: L) -> ReferencePlane<L> {
        if self.reference_plane_given() { ReferencePlane::Named(at) } else { ReferencePlane::OfFamily(at) }
    }
}
