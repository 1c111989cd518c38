//! Which masses balance a shaft? Masses, radii, angles and planes that are wanted, exactly, with all solutions or the reason why there is none.
//!
//! With `U = m r e^{iβ}` a shaft is balanced where `ΣU = 0` and `ΣzU = 0`: four real equations (theory, section 7). Whether they hold,
//! and whether what is wanted exists, is decided by exact sums; what is found is exact where a closed form is known.

mod answer;
mod exact;
mod secondary;
mod solve;
mod triangle;
mod wanted;

use num_rational::BigRational;

use crate::exact::{PhasorSum, Term};
use crate::file::{Rotor, RotorMass};
pub use answer::{Answer, Found, NotSolved, Reason};
pub use exact::Real;
pub use secondary::{Secondary, secondary};
pub(crate) use wanted::Wanted;
use wanted::mass_radius;

/// `ΣU` and `ΣzU` about position 0 of the masses of which all is known, each of this weight.
fn sums(rotor: &Rotor, weight: impl Fn(&RotorMass) -> Option<BigRational>) -> [PhasorSum; 2] {
    let known = rotor.masses.iter().filter(|mass| Wanted::of(mass).is_none());
    let terms = known.filter_map(|mass| {
        let (angle, weight, at) = (mass.angle.clone()?, weight(mass)?, mass.position.as_ref()?);
        let couple = Term { angle: angle.clone(), weight: &weight * at };
        Some([Term { angle, weight }, couple])
    });
    let (force, couple) = terms.map(|[force, couple]| (force, couple)).unzip();
    [PhasorSum::new(force), PhasorSum::new(couple)]
}

/// What balances these masses.
///
/// # Errors
/// Unknowns that are not solved for.
pub fn balance(rotor: &Rotor) -> Result<Answer, NotSolved> {
    solve::solve(rotor, sums(rotor, |mass| mass_radius(rotor, mass)))
}

/// What the share of the reciprocating masses that is balanced in two wheels does, and what the rest does; lengths of stars of order 1,
/// in kilogram-metres and kilogram square metres: times ω² they are newtons and newton-metres.
#[derive(Clone, Debug)]
pub struct Locomotive {
    /// The hammer blow of each wheel: of the part of its weight that balances the share.
    pub hammer_blow: [PhasorSum; 2],
    /// Variation of the tractive force.
    pub tractive: PhasorSum,
    /// Swaying couple about the middle between the wheels.
    pub swaying: PhasorSum,
}

/// Those of a shaft whose two wanted masses are in the planes of the wheels; none where nothing reciprocates.
pub fn locomotive(rotor: &Rotor) -> Option<Locomotive> {
    let wheels: Vec<&BigRational> = rotor
        .masses
        .iter()
        .filter(|mass| Wanted::of(mass) == Wanted { size: true, angle: true, position: false })
        .filter_map(|mass| mass.position.as_ref())
        .collect();
    let has = rotor.masses.iter().any(|mass| mass.reciprocating > BigRational::from_integer(0.into()));
    let [one, other] = wheels.as_slice() else { return None };
    if !has || one == other {
        return None;
    }
    let [force, couple] = sums(rotor, |mass| Some(&mass.reciprocating * mass.radius.as_ref()?));
    let rest = BigRational::from_integer(1.into()) - &rotor.share;
    let middle = (*one + *other) / BigRational::from_integer(2.into());
    // The weight is opposite to what it balances.
    let part =
        |at: &BigRational, from: &BigRational| couple.minus(&force.scaled(from)).scaled(&(&rotor.share / (from - at)));
    Some(Locomotive {
        hammer_blow: [part(one, other), part(other, one)],
        tractive: force.scaled(&rest),
        swaying: couple.minus(&force.scaled(&middle)).scaled(&rest),
    })
}
