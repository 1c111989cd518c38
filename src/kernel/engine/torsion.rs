//! What is a crankshaft that twists? Discs with moments of inertia, the shafts and gears between them, and what damps them.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::cycle_order::CycleOrder;
use crate::text::counted;

/// More discs are not read.
pub const MOST_DISCS: usize = 200;

/// Discs that shafts and gears join into a tree; without branches a row, from the free end on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Torsion {
    /// Moment of inertia of each disc, in kg m².
    pub inertias: Vec<BigRational>,
    /// Absolute damping of each disc, in N m s per radian; none where nothing damps any.
    pub dampings: Vec<BigRational>,
    /// The shafts between them.
    pub shafts: Vec<ElasticShaft>,
    /// The gears between them, which do not give way.
    pub gears: Vec<Gear>,
    /// Rings that damp a disc.
    pub dampers: Vec<Damper>,
    /// On which disc each crankpin stands, by its number from 0; the first pins on the first discs where nothing is said.
    pub pins: Vec<usize>,
    /// The torque of one cylinder by orders, where it is given in place of the gas.
    pub harmonics: Vec<Harmonic>,
    /// The speed that permissible stresses refer to, in revolutions a minute.
    pub rated_speed: Option<BigRational>,
    /// Over which speeds the vibration is shown, in revolutions a minute.
    pub speeds: Option<[BigRational; 2]>,
}

/// A massless shaft between two discs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElasticShaft {
    /// The discs, by their numbers from 0.
    pub ends: [usize; 2],
    /// Stiffness k in N m per radian.
    pub stiffness: BigRational,
    /// Loss factor η: the complex stiffness is k (1 + iη) + iΩc.
    pub loss_factor: BigRational,
    /// Relative damping c in N m s per radian.
    pub damping: BigRational,
    /// Its section, where a stress is asked for.
    pub section: Option<Section>,
    /// Its steel, where a permissible stress is asked for.
    pub steel: Option<Steel>,
}

impl ElasticShaft {
    /// A shaft without damping.
    pub fn between(ends: [usize; 2], stiffness: BigRational) -> Self {
        let zero = BigRational::zero;
        ElasticShaft { ends, stiffness, loss_factor: zero(), damping: zero(), section: None, steel: None }
    }
}

/// The section of a shaft.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Outer diameter in metres.
    pub outer: BigRational,
    /// That of the bore in metres, 0 where there is none.
    pub inner: BigRational,
}

/// What a permissible stress of a classification society depends on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steel {
    /// Tensile strength in pascals.
    pub tensile_strength: BigRational,
    /// Whether it is an alloy steel, else a carbon steel.
    pub is_alloy: bool,
    /// The factor c_K of the shape of the shaft.
    pub shape_factor: BigRational,
}

/// Two discs in mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gear {
    /// The discs, by their numbers from 0.
    pub ends: [usize; 2],
    /// Speed of the second over that of the first, negative where they turn in opposite senses.
    pub ratio: BigRational,
}

/// A ring beside a disc: viscous without a spring, tuned with one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damper {
    /// The disc, by its number from 0.
    pub disc: usize,
    /// Moment of inertia of the ring, in kg m².
    pub inertia: BigRational,
    /// Stiffness between ring and disc; none of a viscous damper.
    pub stiffness: Option<DamperValue>,
    /// Damping between them, in N m s per radian.
    pub damping: DamperValue,
}

/// A value of a damper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DamperValue {
    /// As written.
    Given(BigRational),
    /// The best by the textbook's formula, for the first mode.
    Best,
}

/// An order of the torque of each cylinder, `t cos(κψ + phase)` by its own angle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Harmonic {
    /// The order κ.
    pub order: CycleOrder,
    /// Amplitude t in N m.
    pub torque: BigRational,
    /// Its phase in turns; it counts where several orders are added.
    pub phase: BigRational,
}

/// Why discs and springs are no shaft.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoShaft {
    /// Fewer than two discs, or more than [`MOST_DISCS`].
    #[error("{0} moments of inertia; a torsional model has 2 to {MOST_DISCS}")]
    Discs(usize),
    /// Not one stiffness fewer than inertias, in a row of discs.
    #[error("{stiffnesses} stiffnesses for {discs} moments of inertia; {discs} discs in a row need {}", .discs - 1)]
    Stiffnesses {
        /// How many discs.
        discs: usize,
        /// How many stiffnesses.
        stiffnesses: usize,
    },
    /// Not one damping for each disc.
    #[error("{} for {discs} moments of inertia; name one for each disc, 0 where there is none", counted(*.dampings, "damping"))]
    Dampings {
        /// How many discs.
        discs: usize,
        /// How many dampings.
        dampings: usize,
    },
    /// An inertia or a stiffness that is not above 0: of what, by its number from 1.
    #[error("the {0} {1} is not above 0")]
    NotPositive(&'static str, usize),
    /// A damping or a loss factor below 0: of what, by its number from 1.
    #[error("the {0} {1} is below 0: it would feed the vibration")]
    Negative(&'static str, usize),
    /// A gear of ratio 0, by its number from 1.
    #[error("gear {0} has a ratio of 0")]
    NoRatio(usize),
    /// A shaft, a gear or a damper at a disc that is not there.
    #[error("{} {} is at disc {disc}; there are {discs}, numbered from 1", .what.0, .what.1)]
    NoDisc {
        /// What stands there, by its number from 1.
        what: (&'static str, usize),
        /// The disc by its number from 1.
        disc: usize,
        /// How many discs there are.
        discs: usize,
    },
    /// A shaft or a gear between discs that are joined already.
    #[error("{0} {1} joins discs that are joined already: branches may close no ring")]
    Ring(&'static str, usize),
    /// Discs that no shaft joins to the first, by the number of one from 1.
    #[error("no shaft and no gear joins disc {0} to the first")]
    Apart(usize),
    /// A bore that leaves nothing of a shaft, by its number from 1.
    #[error("the bore of shaft {0} is not smaller than its outer diameter")]
    Hollow(usize),
    /// Not one disc for each crankpin.
    #[error("{} named for {}; name one for each (a boxer pair is one)", counted(*given, "disc"), counted(*pins, "crankpin"))]
    Pins {
        /// How many are given.
        given: usize,
        /// How many crankpins there are.
        pins: usize,
    },
    /// A crankpin on a disc that is not there, both by their numbers from 1.
    #[error("crankpin {pin} is on disc {disc}; there are {discs}, numbered from 1")]
    NoSuchDisc {
        /// The crankpin.
        pin: usize,
        /// The disc.
        disc: usize,
        /// How many discs there are.
        discs: usize,
    },
    /// A crankpin of two crankshafts, by its number from 1.
    #[error("crankpin {0} is of two crankshafts; number those of each by themselves")]
    OfTwoCranks(usize),
    /// A crankpin on a disc that gears turn otherwise than its crankshaft, both by their numbers from 1.
    #[error(
        "crankpin {pin} is on disc {disc}, which gears turn at another speed, or in another sense, beside the first crankpin than its crankshaft turns"
    )]
    Geared {
        /// The crankpin.
        pin: usize,
        /// The disc.
        disc: usize,
    },
}

impl Torsion {
    /// Whether anything damps it.
    pub fn is_damped(&self) -> bool {
        let of_shaft = |shaft: &ElasticShaft| shaft.loss_factor.is_positive() || shaft.damping.is_positive();
        let of_damper = |damper: &Damper| !matches!(&damper.damping, DamperValue::Given(value) if !value.is_positive());
        self.dampings.iter().any(Signed::is_positive)
            || self.shafts.iter().any(of_shaft)
            || self.dampers.iter().any(of_damper)
    }

    /// Whether it says more than a row of discs: then amplitudes are asked for.
    pub fn has_forced(&self) -> bool {
        let has_section = self.shafts.iter().any(|shaft| shaft.section.is_some());
        !self.harmonics.is_empty() || self.rated_speed.is_some() || self.speeds.is_some() || has_section
    }

    /// Whether its discs are a row without gears.
    pub fn is_row(&self) -> bool {
        self.gears.is_empty() && self.shafts.iter().enumerate().all(|(index, shaft)| shaft.ends == [index, index + 1])
    }

    /// The speed of each disc over that of the first crankpin; none of discs that nothing joins to it.
    pub fn ratios(&self) -> Vec<Option<BigRational>> {
        let one = || BigRational::from_integer(1.into());
        let joints = || {
            let shafts = self.shafts.iter().map(|shaft| (shaft.ends, one()));
            shafts.chain(self.gears.iter().map(|gear| (gear.ends, gear.ratio.clone())))
        };
        let mut ratios = vec![None; self.inertias.len()];
        let mut next = vec![(self.pins.first().copied().unwrap_or(0), one())];
        while let Some((disc, ratio)) = next.pop() {
            for ([from, to], gear) in joints() {
                if from == disc && ratios[to].is_none() {
                    next.push((to, &ratio * &gear));
                } else if to == disc && ratios[from].is_none() {
                    next.push((from, &ratio / &gear));
                }
            }
            ratios[disc] = Some(ratio);
        }
        ratios
    }

    /// Whether it is a shaft for crankpins of these speeds, below 0 against the first crankshaft.
    ///
    /// # Errors
    /// The first thing that does not fit.
    pub fn check(&self, pins: &[i64]) -> Result<(), NoShaft> {
        let discs = self.inertias.len();
        if !(2..=MOST_DISCS).contains(&discs) {
            return Err(NoShaft::Discs(discs));
        }
        if self.is_row() && self.shafts.len() + 1 != discs {
            return Err(NoShaft::Stiffnesses { discs, stiffnesses: self.shafts.len() });
        }
        if !self.dampings.is_empty() && self.dampings.len() != discs {
            return Err(NoShaft::Dampings { discs, dampings: self.dampings.len() });
        }
        self.check_values()?;
        self.check_tree()?;
        if self.pins.len() != pins.len() {
            return Err(NoShaft::Pins { given: self.pins.len(), pins: pins.len() });
        }
        if let Some((pin, disc)) = self.pins.iter().enumerate().find(|(_, disc)| **disc >= discs) {
            return Err(NoShaft::NoSuchDisc { pin: pin + 1, disc: disc + 1, discs });
        }
        let ratios = self.ratios();
        let turns_so =
            |(pin, disc): (usize, &usize)| ratios[*disc] == Some(BigRational::new(pins[pin].into(), pins[0].into()));
        let alone = self.pins.iter().enumerate().find(|(pin, disc)| !turns_so((*pin, *disc)));
        alone.map_or(Ok(()), |(pin, disc)| Err(NoShaft::Geared { pin: pin + 1, disc: disc + 1 }))
    }

    fn check_values(&self) -> Result<(), NoShaft> {
        let given = |setting: &DamperValue| matches!(setting, DamperValue::Given(_));
        let value = |setting: &DamperValue| match setting {
            DamperValue::Given(value) => value.clone(),
            DamperValue::Best => BigRational::zero(),
        };
        positive("moment of inertia of disc", self.inertias.iter())?;
        positive("stiffness of shaft", self.shafts.iter().map(|shaft| &shaft.stiffness))?;
        not_negative("loss factor of shaft", self.shafts.iter().map(|shaft| &shaft.loss_factor))?;
        not_negative("damping of shaft", self.shafts.iter().map(|shaft| &shaft.damping))?;
        not_negative("damping of disc", self.dampings.iter())?;
        positive("inertia of the ring of damper", self.dampers.iter().map(|damper| &damper.inertia))?;
        for (index, damper) in self.dampers.iter().enumerate() {
            if value(&damper.damping).is_negative() {
                return Err(NoShaft::Negative("damping of damper", index + 1));
            }
            if damper.stiffness.as_ref().is_some_and(|one| given(one) && !value(one).is_positive()) {
                return Err(NoShaft::NotPositive("stiffness of damper", index + 1));
            }
        }
        let sections = self.shafts.iter().map(|shaft| &shaft.section).enumerate();
        match sections.filter_map(|(index, section)| Some((index, section.as_ref()?))).find(|(_, section)| {
            !section.outer.is_positive() || section.inner.is_negative() || section.inner >= section.outer
        }) {
            Some((index, _)) => Err(NoShaft::Hollow(index + 1)),
            None => Ok(()),
        }
    }

    /// Whether shafts and gears join all discs, each in one way.
    fn check_tree(&self) -> Result<(), NoShaft> {
        let discs = self.inertias.len();
        let mut group: Vec<usize> = (0..discs).collect();
        let shafts = self.shafts.iter().map(|shaft| shaft.ends).enumerate().map(|(at, ends)| (("shaft", at + 1), ends));
        let gears = self.gears.iter().map(|gear| gear.ends).enumerate().map(|(at, ends)| (("gear", at + 1), ends));
        for (what, ends) in shafts.chain(gears) {
            if let Some(disc) = ends.into_iter().find(|disc| *disc >= discs) {
                return Err(NoShaft::NoDisc { what, disc: disc + 1, discs });
            }
            let [one, other] = ends.map(|disc| group[disc]);
            if one == other {
                return Err(NoShaft::Ring(what.0, what.1));
            }
            group.iter_mut().filter(|at| **at == other).for_each(|at| *at = one);
        }
        if let Some(index) = self.gears.iter().position(|gear| gear.ratio.is_zero()) {
            return Err(NoShaft::NoRatio(index + 1));
        }
        if let Some(index) = self.dampers.iter().position(|damper| damper.disc >= discs) {
            return Err(NoShaft::NoDisc { what: ("damper", index + 1), disc: self.dampers[index].disc + 1, discs });
        }
        match group.iter().position(|at| *at != group[0]) {
            Some(disc) => Err(NoShaft::Apart(disc + 1)),
            None => Ok(()),
        }
    }
}

fn positive<'a>(what: &'static str, mut values: impl Iterator<Item = &'a BigRational>) -> Result<(), NoShaft> {
    let wrong = values.position(|value| !value.is_positive());
    wrong.map_or(Ok(()), |index| Err(NoShaft::NotPositive(what, index + 1)))
}

fn not_negative<'a>(what: &'static str, mut values: impl Iterator<Item = &'a BigRational>) -> Result<(), NoShaft> {
    let wrong = values.position(Signed::is_negative);
    wrong.map_or(Ok(()), |index| Err(NoShaft::Negative(what, index + 1)))
}
