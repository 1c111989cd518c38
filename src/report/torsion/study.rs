//! Which modes has the shaft of an engine, at which critical speeds?

use std::sync::OnceLock;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::excited::Excited;
use super::vibration::{DamperStudy, Excess, ResonanceOrder, TwistAtSpeed, Vibration};
use crate::engine::{CycleOrder, ElasticShaft, Engine, Torsion};
use crate::firing::{self, NoStar};
use crate::page::{Number, Text, Unit};
use crate::report::rising;
use crate::torsion::{Critical, CriticalSpeeds, Train, critical_speeds};

/// Orders up to this one, and to the first major order, are shown where none are asked for, in halves.
const USUAL_HALVES: u32 = 24;
/// Stars that differ by less than this part are equally long for all that decimals tell.
const ALIKE: f64 = 1e-9;

/// The modes of an engine's shaft, with their critical speeds.
#[derive(Clone, Debug)]
pub struct TorsionStudy {
    /// The engine.
    pub engine: Engine,
    /// The modes, rising; of equal frequencies those first that an order excites.
    pub modes: Vec<CriticalSpeeds>,
    /// The speed of the layout in revolutions a minute, where it has one above 0.
    pub speed: Option<f64>,
    /// Its discs and shafts in decimals.
    pub train: Train,
    /// What excites it, once that is asked for.
    excited: OnceLock<Option<Excited>>,
    pub(super) cached: Cached,
}

/// What the page, the answer and several tables ask for, each computed once.
#[derive(Clone, Debug, Default)]
pub(super) struct Cached {
    pub at_speed: OnceLock<Option<Vibration>>,
    pub resonances: OnceLock<Vec<ResonanceOrder>>,
    pub range: OnceLock<Vec<TwistAtSpeed>>,
    pub excesses: OnceLock<Vec<Excess>>,
    pub dampers: OnceLock<Vec<DamperStudy>>,
}

/// Why there is no study.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoTorsion {
    /// The layout has no table of the shaft.
    #[error(
        "the layout does not give the torsional data of the shaft; add a table [torsion] with inertias = [\"0.03 kg m^2\", …], one per disc from the free end on, and stiffnesses = [\"1 MN m/rad\", …], one between each two"
    )]
    NoShaft,
    /// There are no firing stars.
    #[error("{0}")]
    NoStar(NoStar),
}

impl TorsionStudy {
    /// The modes with the critical speeds of these orders; of those up to 12, and to the first major order, where there are none.
    ///
    /// # Errors
    /// See [`NoTorsion`].
    pub fn new(engine: &Engine, orders: &[CycleOrder]) -> Result<Self, NoTorsion> {
        let torsion = engine.torsion().ok_or(NoTorsion::NoShaft)?;
        let firing = firing::firing_of(engine).map_err(NoTorsion::NoStar)?;
        let cycle = firing.cycle;
        let orders = rising(match orders {
            [] => {
                let all = (1..=USUAL_HALVES.max(2 * firing.first_major_order())).filter_map(CycleOrder::of_halves);
                let given = torsion.harmonics.iter().map(|harmonic| harmonic.order);
                all.filter(|order| order.exists_in(cycle)).chain(given).collect()
            }
            asked => asked.to_vec(),
        });
        let modes = critical_speeds(engine, torsion, &orders).map_err(NoTorsion::NoStar)?;
        let speed = engine.dimensions().speed.as_ref().and_then(BigRational::to_f64).filter(|speed| *speed > 0.0);
        let train = Train::new(torsion);
        Ok(TorsionStudy {
            engine: engine.clone(),
            modes,
            speed,
            train,
            excited: OnceLock::new(),
            cached: Cached::default(),
        }
        .sorted())
    }

    /// With the modes of equal frequency that an order excites before the others: so the first is excited where its frequency is.
    fn sorted(mut self) -> Self {
        let mut modes = std::mem::take(&mut self.modes);
        modes.sort_by_cached_key(|speeds| (speeds.mode.alike.start, self.strongest(speeds).is_empty()));
        self.modes = modes;
        self
    }

    /// The same at another speed than that of the layout, in revolutions a minute.
    #[must_use]
    pub fn at(self, speed: f64) -> Self {
        TorsionStudy { speed: Some(speed), cached: Cached::default(), ..self }.sorted()
    }

    /// Its shaft.
    pub fn torsion(&self) -> &Torsion {
        self.engine.torsion().unwrap_or_else(|| unreachable!("a torsional study needs a [torsion] table"))
    }

    /// Whether its discs are a row.
    pub(super) fn is_row(&self) -> bool {
        self.torsion().is_row()
    }

    /// The shaft from a disc to the next, by the number of the disc from 0.
    pub(super) fn shaft_behind(&self, disc: usize) -> Option<&ElasticShaft> {
        self.torsion().shafts.iter().find(|shaft| shaft.ends == [disc, disc + 1])
    }

    /// What excites the train; none where the layout has neither harmonics nor gas with a speed above 0.
    pub(super) fn excited(&self) -> Option<&Excited> {
        self.excited.get_or_init(|| Excited::new(&self.engine, self.torsion(), &self.train)).as_ref()
    }

    /// Whether it is proved that an order of the torque twists nothing.
    pub(super) fn is_still_at(&self, order: CycleOrder) -> bool {
        self.excited().is_some_and(|excited| excited.is_still(order))
    }

    /// Whether that is proved of all orders that are added.
    pub(super) fn is_still(&self) -> bool {
        self.excited().is_some_and(|excited| excited.orders().all(|order| excited.is_still(order)))
    }

    /// A twist by an order, in degrees.
    pub(super) fn twist_of(&self, order: CycleOrder, value: f64) -> Text {
        if self.is_still_at(order) { Text::zero() } else { Number::Decimal(value).into() }
    }

    /// A torque by an order, whose unit is given elsewhere.
    pub(super) fn torque_of(&self, order: CycleOrder, value: f64) -> Text {
        if self.is_still_at(order) { Text::zero() } else { Text::measured(value, Unit::NEWTON_METRE) }
    }

    /// The highest speed that matters: the end of the range where one is given, else the speed of the layout.
    pub(super) fn highest_speed(&self) -> Option<f64> {
        self.torsion().speeds.as_ref().and_then(|speeds| speeds[1].to_f64()).or(self.speed)
    }

    /// The orders of a mode by the length of their stars, the longest first; of equally long ones the lowest order first. Those above
    /// the highest speed are omitted where there is one.
    pub(super) fn strongest<'b>(&self, mode: &'b CriticalSpeeds) -> Vec<&'b Critical> {
        let met = |critical: &&Critical| self.highest_speed().is_none_or(|speed| critical.rpm <= speed);
        let mut orders: Vec<&Critical> = mode.orders.iter().filter(met).collect();
        let in_steps = |critical: &Critical| (mode.part(critical) / ALIKE).round();
        orders.sort_by(|one, other| in_steps(other).total_cmp(&in_steps(one)).then(one.order.cmp(&other.order)));
        orders.retain(|critical| !critical.vanishes && in_steps(critical) > 0.0);
        orders
    }
}
