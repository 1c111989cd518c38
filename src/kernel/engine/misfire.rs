//! What presses on the pistons when a cylinder does not fire?

use num_rational::BigRational;
use num_traits::Zero;

use super::draft::Draft;
use super::gas::{Gas, Heat, PressureLaw, PressureTable, Setting};
use super::model::Engine;

/// Why a cylinder cannot be kept from firing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoMisfire {
    /// No cylinder has this name.
    #[error("there is no cylinder `{name}` to misfire; the cylinders are {}", .names.join(", "))]
    NoSuchCylinder {
        /// The name.
        name: String,
        /// Those of the cylinders.
        names: Vec<String>,
    },
    /// A stage of a compressor, by the name of its cylinder.
    #[error("cylinder {0} is a stage of a compressor, in which nothing fires; name one that does")]
    Compressor(String),
    /// Neither gas nor harmonics of the torque.
    #[error(
        "the layout does not say what a cylinder does that fires; add [gas], or [[torsion.harmonic]] for the torsion alone"
    )]
    NothingFires,
}

impl Engine {
    /// The cylinder that was kept from firing, by its index.
    pub fn misfire(&self) -> Option<usize> {
        self.draft().misfire
    }

    /// The same engine, with nothing burning in the cylinder of this name: the charge of an ideal cycle expands as it was compressed. A table of
    /// pressures does not tell that, and the crankcase's pressure is put for it on both sides of the piston; harmonics of the torque do not either, and it gives none.
    ///
    /// # Errors
    /// No such cylinder, or nothing that says how it fires.
    pub fn misfiring(&self, name: &str) -> Result<Engine, NoMisfire> {
        let names = || self.cylinders().iter().map(|cylinder| cylinder.name.clone());
        let Some(index) = names().position(|other| other == name) else {
            return Err(NoMisfire::NoSuchCylinder { name: name.to_owned(), names: names().collect() });
        };
        let has_harmonics = self.torsion().is_some_and(|torsion| !torsion.harmonics.is_empty());
        let gas = match self.gas() {
            None if has_harmonics => None,
            None => return Err(NoMisfire::NothingFires),
            Some(gas) => Some(self.unburnt(gas, index).ok_or_else(|| NoMisfire::Compressor(name.to_owned()))?),
        };
        let told_by = self.partner(index).filter(|_| self.is_second_piston(index)).unwrap_or(index);
        let draft = Draft { gas, misfire: Some(told_by), ..self.clone().into_draft() };
        Ok(Engine::new(draft, self.reference_plane().clone(), self.orders().to_vec()))
    }

    /// The gas with a law of its own in this cylinder; none of a compressor.
    fn unburnt(&self, gas: &Gas, index: usize) -> Option<Gas> {
        let mut gas = gas.clone();
        let partner = self.partner(index);
        let chamber = &mut gas.chambers[index];
        let law = match &gas.laws[chamber.law] {
            PressureLaw::Cycle(ideal) => {
                let mut motored = ideal.clone();
                motored.heat = Heat::Released(BigRational::zero());
                motored.expansion_exponent = motored.compression_exponent.clone();
                motored.assumed.extend([Setting::Heat, Setting::ExpansionExponent]);
                PressureLaw::Cycle(motored)
            }
            PressureLaw::Table(_) => {
                let cycle = self.cycle()?;
                let rows = [BigRational::zero(), cycle.turns()].map(|turns| (turns, chamber.crankcase.clone()));
                PressureLaw::Table(PressureTable::new(rows.into(), cycle).ok()?)
            }
            PressureLaw::Stage(_) => return None,
        };
        if let PressureLaw::Table(_) = law {
            chamber.below = None;
        }
        chamber.law = gas.laws.len();
        if let Some(partner) = partner {
            gas.chambers[partner] = gas.chambers[index].clone();
        }
        gas.laws.push(law);
        Some(gas)
    }
}
