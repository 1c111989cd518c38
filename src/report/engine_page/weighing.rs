//! How large is each order beside the others, and which are too small to be told one by one?

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::super::calculation::{Unit, about_the_axis};
use super::super::residual;
use crate::engine::{Crankshaft, DOES_NOT_EXIST, Effects, Engine, LengthUnit, Mechanism, Rod};
use crate::loads::{self, Bound, LeftOut, Loads, Swing, TorqueOrder};
use crate::motion::SliderCrank;
use crate::numbers;
use crate::order::{self, Masses};
use crate::page::{self, Piece, Setting, Text, number, phrase};
use crate::proof::{Axial, Planar, Quantity, Shape};
use crate::report::texts::engine as text;
use crate::verdict::{Judgement, OrderVerdict};

/// What is reported one by one of an engine, and what together.
#[derive(Clone, Debug, PartialEq)]
pub struct Weighing {
    /// An order below this part of the largest one, or of one piston's force, is reported with the others that are; by default that of the
    /// layout, else a hundredth.
    pub above: Option<f64>,
    /// All orders are reported one by one.
    pub all: bool,
    /// The orders were asked for: each is reported.
    pub asked: bool,
    /// λ of rods that a file does not give; 2/7 by default.
    pub rod_ratio: Option<BigRational>,
}

static USUAL: Weighing = Weighing { above: None, all: false, asked: false, rod_ratio: None };

impl Weighing {
    /// What is reported where nothing else is asked for: what is above a hundredth.
    pub fn usual() -> &'static Self {
        &USUAL
    }

    /// The part of the largest order from which on an order of this engine is reported by itself.
    pub(in crate::report) fn above(&self, engine: &Engine) -> f64 {
        let given = || engine.above().and_then(ToPrimitive::to_f64);
        self.above.or_else(given).unwrap_or(0.01)
    }

    /// Below this an order is reported with others, in multiples of m r ω²: a part of the largest order, or of what one piston does: its m r ω²,
    /// that at the end of the engine, half of that at the crank radius, about its torque of order 2.
    pub(in crate::report) fn limit(&self, engine: &Engine, quantity: Quantity, most: f64) -> f64 {
        let of_one = engine.cylinders().iter().map(|cylinder| {
            let mass = order::mass_radius(engine, cylinder).abs();
            match quantity {
                Quantity::FORCE => mass,
                Quantity::MOMENT => mass * engine.arm(cylinder).abs(),
                Quantity::TORQUE | Quantity::ROLL => {
                    mass * &cylinder.crank_radius / BigRational::from_integer(2.into())
                }
            }
        });
        let of_one = of_one.max().and_then(|largest| largest.to_f64()).unwrap_or(0.0);
        self.above(engine) * most.max(of_one)
    }

    /// Whether every order of this engine is reported by itself.
    pub(in crate::report) fn tells_all(&self, engine: &Engine) -> bool {
        self.all || self.asked || engine.orders_given()
    }

    /// λ of rods that are not given.
    fn ratio(&self) -> BigRational {
        self.rod_ratio.clone().unwrap_or_else(assumed_ratio)
    }
}

/// λ where neither the layout nor the reader gives it: 2/7, a rod 3.5 crank radii long, as the drawings have it.
pub(in crate::report) fn assumed_ratio() -> BigRational {
    BigRational::new(2.into(), 7.into())
}

/// An engine in numbers, order by order.
pub(in crate::report) struct Weighed<'a> {
    weighing: &'a Weighing,
    /// With rods, and no masses but those that the verdicts are about.
    pub engine: Engine,
    pub loads: Loads,
    left: LeftOut,
    /// λ of the rods, where the file gives none.
    pub assumed: Option<BigRational>,
    /// Every order is reported by itself.
    tells_all: bool,
}

impl<'a> Weighed<'a> {
    /// These masses of an engine; none where they have no size.
    pub fn new(engine: &Engine, masses: Masses, orders: &[u32], weighing: &'a Weighing) -> Option<Self> {
        let is_open = engine.cylinders().iter().any(|cylinder| cylinder.mechanism.is_none());
        let engine = with_sizes(engine, masses, weighing)?;
        let loads = loads::loads(&engine, orders).ok()?;
        let torque: Vec<u32> = loads.torque.iter().flat_map(|torque| &torque.orders).map(|order| order.order).collect();
        let left = loads::left_out(&engine, orders, &torque).ok()?;
        let tells_all = weighing.tells_all(&engine);
        let assumed = is_open.then(|| weighing.ratio());
        Some(Weighed { weighing, engine, loads, left, assumed, tells_all })
    }

    /// The same beside other engines, which may have asked for some of the orders: those below the threshold are reported together.
    pub fn beside_others(self) -> Self {
        Weighed { tells_all: false, ..self }
    }

    /// Whether cures of every order are asked for.
    pub fn asks_for_all(&self) -> bool {
        self.weighing.all
    }

    /// The part of the largest from which on an order is reported by itself.
    pub fn above(&self) -> f64 {
        self.weighing.above(&self.engine)
    }

    /// What an order traces, in multiples of m r ω².
    pub fn swing(&self, order: u32, quantity: Planar) -> Option<&Swing> {
        Some(self.loads.orders.iter().find(|of| of.order == order)?.swing(quantity))
    }

    /// The largest force, moment, torque or roll moment of an order, in its multiples of m r ω².
    pub fn size(&self, order: u32, quantity: impl Into<Quantity>) -> f64 {
        self.sizes(quantity.into()).into_iter().find(|(of, _)| *of == order).map_or(0.0, |(_, size)| size)
    }

    /// The orders of the torque or of the roll moment, with their amplitudes.
    pub fn about_the_axis(&self, quantity: Axial) -> Vec<(u32, f64)> {
        self.axial(quantity).map(|order| (order.order, order.vector.value.norm())).collect()
    }

    /// Those that are proved to vanish.
    pub fn zeros_about_the_axis(&self, quantity: Axial) -> impl Iterator<Item = u32> {
        let zeros = self.axial(quantity).filter(|order| order.vector.outcome.vanishes() == Some(true));
        zeros.map(|order| order.order)
    }

    fn axial(&self, quantity: Axial) -> impl Iterator<Item = &TorqueOrder> {
        about_the_axis(&self.loads, quantity).into_iter().flat_map(|torque| &torque.orders)
    }

    /// The vectors of an order, with the crank and against it, in multiples of m r ω².
    pub fn lengths(&self, order: u32, quantity: Planar) -> [f64; 2] {
        let lengths = |swing: &Swing| [&swing.direct, &swing.reverse].map(|vector| vector.value.norm() / 2.0);
        self.swing(order, quantity).map_or([0.0; 2], lengths)
    }

    /// The path of an order: its size along and across direction 0, and the direction of its longer axis.
    pub fn path(&self, order: u32, quantity: Planar) -> Option<([f64; 2], Option<f64>)> {
        let swing = self.swing(order, quantity)?;
        Some(([swing.along(), swing.across()], swing.direction()))
    }

    fn sizes(&self, quantity: Quantity) -> Vec<(u32, f64)> {
        match quantity {
            Quantity::Planar(quantity) => {
                self.loads.orders.iter().map(|of| (of.order, largest(of.swing(quantity)))).collect()
            }
            Quantity::Axial(quantity) => self.about_the_axis(quantity),
        }
    }

    /// The largest size of all orders.
    fn most(&self, quantity: Quantity) -> f64 {
        self.sizes(quantity).into_iter().map(|(_, size)| size).fold(0.0, f64::max)
    }

    /// Below this an order is reported with others.
    pub fn limit(&self, quantity: impl Into<Quantity>) -> f64 {
        let quantity = quantity.into();
        self.weighing.limit(&self.engine, quantity, self.most(quantity))
    }

    /// Whether what is left of an order is reported by itself.
    pub fn is_told(&self, order: u32, quantity: impl Into<Quantity>) -> bool {
        let quantity = quantity.into();
        self.tells_all || self.size(order, quantity) >= self.limit(quantity)
    }

    /// Whether so much, in multiples of m r ω², is worth a shaft.
    pub fn is_worth_it(&self, size: f64, quantity: impl Into<Quantity>) -> bool {
        let quantity = quantity.into();
        size > 0.0 && (self.weighing.all || size >= self.limit(quantity))
    }

    /// What part of the largest force, or of the largest moment, an order is: the larger of both; none where it is the largest.
    pub fn part(&self, order: u32) -> Option<f64> {
        let parts = Planar::BOTH.map(|quantity| self.size(order, quantity) / self.most(quantity.into()));
        let part = parts.into_iter().filter(|part| part.is_finite()).fold(0.0, f64::max);
        (part < 1.0).then_some(part)
    }

    /// The unit of a quantity.
    pub fn unit(&self, quantity: Quantity) -> Unit {
        let mut unit = Unit::of(&self.engine, &self.loads, quantity);
        if self.loads.scale.is_none()
            && quantity == Quantity::MOMENT
            && self.engine.length_unit() == LengthUnit::Spacing
        {
            unit.unit = page::Unit::MULTIPLE_SPACING;
        }
        unit
    }

    /// The unit in which the orders of a quantity are read best, one beside the other.
    pub fn unit_of_tables(&self, quantity: Planar) -> Unit {
        self.unit(quantity.into()).for_values_up_to(self.most(quantity.into()))
    }

    /// The speed in rpm, where masses and speed are given and the crankshaft turns.
    pub fn speed(&self) -> Option<Text> {
        let speed = &self.loads.scale.as_ref()?.speed;
        (!speed.is_zero()).then(|| super::super::typeset::short(speed).into())
    }

    /// What stands over the column of a quantity, and the size of an order in it: 0 is proved, all else is rounded.
    pub fn column(&self, quantity: Planar) -> (Unit, impl Fn(&OrderVerdict) -> Text) {
        let unit = self.unit_of_tables(quantity);
        let cell = move |order: &OrderVerdict| {
            let whole = order.whole(quantity);
            match whole.shape {
                Shape::Balanced => Text::zero(),
                Shape::DoesNotExist => DOES_NOT_EXIST.into(),
                _ if unit.factor == 0.0 => Text::zero(),
                _ if whole.is_decided() => {
                    let size = self.size(order.order, quantity) * unit.factor;
                    Piece::Measured(size, unit.unit, Setting::Usual(number::decimal)).into()
                }
                _ => residual::whole_text(whole),
            }
        };
        (unit, cell)
    }

    /// A value in its unit.
    pub fn amount(&self, value: f64, quantity: impl Into<Quantity>) -> Option<Text> {
        let quantity = quantity.into();
        let unit = self.unit(quantity);
        (unit.factor != 0.0).then(|| Piece::Quantity(value * unit.factor, unit.unit).into())
    }

    /// The coefficient that all vectors of an order have, named: its length where an offset turns them. None where no common one was called for,
    /// and where it is 1.
    fn coefficient(&self, order: u32, named: String) -> Option<String> {
        let of_order = self.loads.orders.iter().find(|of| of.order == order)?;
        let value = of_order.coefficient.as_ref()?.to_complex();
        let length = numbers::length(value);
        let name = if value.im == 0.0 { named } else { format!("|{named}|") };
        let sign = if value.im == 0.0 && value.re < 0.0 { "−" } else { "" };
        (length != 1.0).then(|| format!("{name} ≈ {sign}{}", number::sensible(length)))
    }

    /// What the two stars of an order make together at most, below them: the number of the box, plain and as prose. Nothing where that is zero or not decided.
    pub fn together(&self, order: u32, quantity: Planar, units: page::Units) -> Option<[String; 2]> {
        let swing = self.swing(order, quantity)?;
        let vectors = [&swing.direct, &swing.reverse].map(|vector| &vector.outcome);
        if swing.vanishes() || vectors.iter().any(|outcome| outcome.vanishes().is_none()) {
            return None;
        }
        let unit = self.unit(quantity.into());
        let (value, unit) = units.of(swing.largest() * unit.factor, unit.unit);
        let (value, unit) = unit.at_sight(value);
        let amount = format!("≈ {}{}", number::sensible(value), number::behind(unit));
        let words = format!("together at most {amount}");
        let names = [format!("c{}", number::lowered(order)), format!("$c_{{{order}}}$")];
        Some(names.map(|name| match self.coefficient(order, name) {
            Some(coefficient) => format!("{words} ({coefficient})"),
            None => words.clone(),
        }))
    }

    /// The orders that are not told, of those that are looked at, and what they and all others add up to at most: a part of the largest
    /// order whose size is shown where it is one, else an amount.
    pub fn rest<'b>(
        &self,
        quantity: Planar,
        judged: impl IntoIterator<Item = &'b OrderVerdict>,
    ) -> (Vec<u32>, Option<Rest>) {
        let (small, most) = self.rest_in_multiples(quantity);
        let shown = judged.into_iter().filter(|order| order.whole(quantity).is_decided());
        let largest = shown.map(|order| self.size(order.order, quantity)).fold(0.0, f64::max);
        let rest = most.and_then(|most| match most < largest {
            true => Some(Rest::Part(most / largest)),
            false => {
                let unit = self.unit(quantity.into());
                let bound = Piece::AtMost((most * unit.factor).next_up(), unit.unit);
                (unit.factor != 0.0).then(|| Rest::Amount(bound.into()))
            }
        });
        (small, rest)
    }

    /// The same in multiples of m r ω².
    pub fn rest_in_multiples(&self, quantity: impl Into<Quantity>) -> (Vec<u32>, Option<f64>) {
        let quantity = quantity.into();
        let small: Vec<(u32, f64)> = self
            .sizes(quantity)
            .into_iter()
            .filter(|(order, size)| *size > 0.0 && !self.is_told(*order, quantity))
            .collect();
        let bound: Option<Bound> = match quantity {
            Quantity::FORCE => self.left.force,
            Quantity::MOMENT => self.left.moment,
            Quantity::TORQUE => self.left.torque,
            Quantity::ROLL => None,
        };
        let beyond = bound.map_or(0.0, |bound| bound.most);
        let doubt = |order: u32| match quantity {
            Quantity::Planar(quantity) => self.swing(order, quantity).map_or(0.0, Swing::doubt),
            Quantity::Axial(_) => 0.0,
        };
        let doubt: f64 = small.iter().map(|(order, _)| doubt(*order)).sum();
        let most = (small.iter().map(|(_, size)| size).sum::<f64>() + beyond + doubt).next_up();
        let is_worth_a_word = most.is_finite() && most >= NOTHING * self.most(quantity);
        let is_some = !(small.is_empty() && bound.is_none());
        (small.into_iter().map(|(order, _)| order).collect(), (is_some && is_worth_a_word).then_some(most))
    }
}

/// What adds up to less than this part of the largest order is not worth a word: the tables have it.
const NOTHING: f64 = 1e-6;

/// How much orders add up to, at most.
pub(in crate::report) enum Rest {
    /// A part of the largest order.
    Part(f64),
    Amount(Text),
}

fn largest(swing: &Swing) -> f64 {
    if swing.vanishes() { 0.0 } else { swing.largest() }
}

/// With the masses that the verdicts are about, and with the pistons alone where there are verdicts on these too.
pub(in crate::report) struct WeighedParts<'a> {
    pub as_judged: Option<Weighed<'a>>,
    pub pistons: Option<Weighed<'a>>,
}

impl<'a> WeighedParts<'a> {
    pub fn new(engine: &Engine, judged: &Judgement, weighing: &'a Weighing) -> Self {
        let orders: Vec<u32> = judged.orders.iter().map(|order| order.order).collect();
        let of = |masses| Weighed::new(engine, masses, &orders, weighing);
        let pistons = judged.pistons.as_ref().and_then(|_| of(Masses::Reciprocating));
        WeighedParts { as_judged: of(judged.masses), pistons }
    }
}

/// The engine with rods, and with no masses but these.
fn with_sizes(engine: &Engine, masses: Masses, weighing: &Weighing) -> Option<Engine> {
    let rod = Mechanism::SliderCrank(Rod { ratio: weighing.ratio(), offset: BigRational::zero() });
    let mut draft = engine.clone().into_draft();
    for cylinder in &mut draft.cylinders {
        cylinder.mechanism.get_or_insert_with(|| rod.clone());
    }
    match masses {
        _ if masses == order::masses_as_built(engine) => {}
        Masses::Reciprocating => {
            let has_knuckles = draft.cylinders.iter().any(|cylinder| !cylinder.knuckle_mass.is_zero());
            if has_knuckles {
                return None;
            }
            draft.crankshaft = Crankshaft::default();
            draft.cylinders.iter_mut().for_each(|cylinder| cylinder.rotating_mass = BigRational::zero());
        }
        Masses::All | Masses::Rotating | Masses::Counterweights => return None,
    }
    // Bearings, gas and the like are other questions.
    let torque = engine.effects().torque || !engine.geared_cranks().is_empty() && engine.has_judged_torque();
    draft.effects = Effects { torque, ..Effects::default() };
    draft.bearings = Vec::new();
    // At rest nothing shakes; what would is told in multiples, as where no speed is given.
    draft.dimensions.speed = draft.dimensions.speed.filter(|speed| !speed.is_zero());
    (draft.gas, draft.torsion) = (None, None);
    draft.build().ok()
}

/// `at 6000 rpm`, `λ = 2/7 assumed`; nothing where the rods are given and no speed is.
pub(in crate::report) fn circumstances(weighed: Option<&Weighed>) -> Option<Text> {
    let weighed = weighed?;
    let speed = weighed.loads.scale.as_ref().map(|scale| super::super::typeset::short(&scale.speed));
    let ratio = weighed.assumed.as_ref().map(super::super::typeset::short);
    match (speed, ratio) {
        (None, None) => None,
        (Some(speed), None) => Some(phrase!("at {} rpm", speed)),
        (None, Some(ratio)) => Some(phrase!("λ = {} assumed", ratio)),
        (Some(speed), Some(ratio)) => Some(phrase!("at {} rpm, λ = {} assumed", speed, ratio)),
    }
}

/// At which speed sizes are, and with which rods, above a table of them.
pub(super) fn sizes(weighed: Option<&Weighed>) -> Option<Text> {
    let Weighed { engine, loads, assumed, .. } = weighed?;
    // One coefficient for all pistons, and no newtons.
    let is_plain = engine.mechanisms().len() == 1 && engine.faster_crank().is_none() && loads.scale.is_none();
    let assumed = assumed.as_ref().filter(|_| is_plain).and_then(coefficients);
    let sizes = circumstances(weighed).map_or_else(text::sizes_of_layout, text::sizes_under);
    Some(assumed.into_iter().fold(sizes, |sizes, words| sizes.and(" ").and(words)))
}

/// With what the exact numbers are multiplied where the layout gives no rods.
fn coefficients(ratio: &BigRational) -> Option<Text> {
    let crank = SliderCrank::new(ratio.clone(), BigRational::zero()).ok()?;
    let of = |order: u32| Text::from(number::decimal(crank.coefficient(order).re.to_float()));
    Some(text::coefficients(of(2), of(4)))
}
