//! What is left of an order, and how is it put in a few words?

use num_rational::BigRational;

use super::typeset::{self, Amount, Bearing, signed_degrees};
use crate::engine::{DOES_NOT_EXIST, Engine, Rod, WHY_NOT};
use crate::exact::{PhasorSum, Turn};
use crate::motion::Component;
use crate::numbers::{self, Direction};
use crate::order::{self, Factor, MassGroup, Masses};
use crate::page::{Text, phrase};
use crate::proof::Shape;
use crate::report::texts::residual as text;
use crate::verdict::{
    Balance, Class, JudgedStar, Judgement, OrderBalance, OrderVerdict, Outcome, TorquePart, TorqueVerdict, WholeOrder,
};

/// `|S|` of a star.
pub fn modulus<'a>(judged: impl Into<JudgedStar<'a>>) -> Amount {
    let judged = judged.into();
    if judged.vanishes() { Amount::zero() } else { modulus_of(judged.sum) }
}

/// `|S|` of a sum that is not zero.
pub(super) fn modulus_of(sum: &PhasorSum) -> Amount {
    Amount { exact: numbers::modulus(sum), decimal: numbers::length(numbers::evaluate(sum)) }
}

/// The direction of a sum that is not zero.
pub fn bearing(sum: &PhasorSum) -> Bearing {
    Bearing { exact: numbers::direction_of(sum), decimal: numbers::degrees(numbers::evaluate(sum)) }
}

/// That a sum vanishes, or how long it is and where it points, by its symbol in TeX.
pub(super) fn value<'a>(symbol: &str, judged: impl Into<JudgedStar<'a>>) -> Text {
    let judged = judged.into();
    match judged.vanishes() {
        true => Text::formula(format!("{symbol} = 0")),
        false => phrase!(
            "{}, length {}, angle {}",
            Text::formula(format!("{symbol} \\ne 0")),
            modulus(judged),
            bearing(judged.sum)
        ),
    }
}

/// The largest value through a revolution, `½(|P⁺| + |P⁻|)`.
pub fn largest(balance: &Balance) -> Amount {
    let [direct, reverse] = balance.verdicts().map(|verdict| &verdict.sum);
    let length = |sum| numbers::length(numbers::evaluate(sum));
    Amount { exact: numbers::half_of_lengths(direct, reverse), decimal: (length(direct) + length(reverse)) / 2.0 }
}

/// The word for a shape.
pub fn shape_name(shape: Shape) -> &'static str {
    match shape {
        Shape::Balanced => "balanced",
        Shape::Rotating => "rotating",
        Shape::CounterRotating => "counter-rotating",
        Shape::Planar => "planar",
        Shape::Elliptical => "elliptical",
        Shape::NotDecided => "not decided",
        Shape::DoesNotExist => DOES_NOT_EXIST,
    }
}

/// The number of an order, and the sources that it is about where not all are meant.
pub fn order_name(order: &OrderBalance) -> String {
    match &order.class {
        None => order.order.to_string(),
        Some(class) => format!("{} ({})", order.order, class_words(class, order.order)),
    }
}

/// `= 0.25`, `≈ 0.2748`.
fn equals(value: &BigRational) -> String {
    let text = typeset::short(value);
    if typeset::is_long(value) { text } else { format!("= {text}") }
}

/// `, λ = 0.25`, `, λ = 0.25, δ = 0.1`.
fn rod_words(rod: &Rod) -> String {
    let offset = if rod.is_centric() { String::new() } else { format!(", δ {}", equals(&rod.offset)) };
    format!(", λ {}{offset}", equals(&rod.ratio))
}

/// `cylinders 1–3, λ = 0.25`, `balancer shaft 1`.
fn class_words(class: &Class, order: u32) -> String {
    let (factor, own_order) = class.factor.own(order);
    let rod = match factor {
        Factor::Quadrature(rod) => {
            let size = equals(&rod.offset);
            let size = size.strip_prefix("= ").map_or_else(|| size.clone(), |value| format!("= ±{value}"));
            format!(", λ {}, δ {size}, Im", equals(&rod.ratio))
        }
        Factor::Linkage(linkage) => format!(", Δ = ±{}", typeset::degrees(&linkage.apart.degrees())),
        Factor::Corrected(linkage, component) => {
            let [apart, correction] =
                [&linkage.apart, &linkage.correction].map(|angle| typeset::degrees(&angle.degrees()));
            let part = match component {
                Component::Real => "Re",
                Component::Imaginary => "Im",
            };
            format!(", Δ = ±{apart}, ε = ±{correction}, {part}")
        }
        other => other.rod().map(rod_words).unwrap_or_default(),
    };
    let own = (own_order != order).then(|| format!("order {own_order} of its own crankshaft"));
    let named: Vec<String> = [class_sources(class)].into_iter().chain(own).collect();
    format!("{}{rod}", named.join(", "))
}

/// More masses that turn than this are counted, not named.
const MOST_NAMED: usize = 3;

/// `cylinders 1–3`, `balancer shaft 1`, `6 other masses`: those that turn, and those at knuckle pins.
pub fn class_sources(class: &Class) -> String {
    let names: Vec<&str> = class.cylinders.iter().map(String::as_str).collect();
    let cylinders = match names.as_slice() {
        [] => None,
        [only] => Some(format!("cylinder {only}")),
        several => Some(format!("cylinders {}", typeset::names(several))),
    };
    let turning = match class.turning.as_slice() {
        [] => None,
        named if named.len() <= MOST_NAMED => Some(named.join(", ")),
        many => Some(format!("{} other masses", many.len())),
    };
    typeset::listed(cylinders.into_iter().chain(turning))
}

/// What is known of an order that several sums make up: zero, `not 0, elliptical`, `not decided`.
pub(super) fn whole_text(whole: &WholeOrder) -> Text {
    let nothing_known = whole.outcomes.contains(&Outcome::Open);
    match whole.shape {
        Shape::Balanced => Text::zero(),
        Shape::DoesNotExist => DOES_NOT_EXIST.into(),
        Shape::NotDecided if nothing_known => "depends on the rods".into(),
        Shape::NotDecided if !whole.is_left() => "not decided".into(),
        Shape::NotDecided => "not 0".into(),
        shape => phrase!("not 0, {}", shape_name(shape)),
    }
}

/// The same beside the size of what is left: `elliptical`.
pub(super) fn beside_size(whole: &WholeOrder) -> Text {
    match whole.shape {
        Shape::Rotating | Shape::CounterRotating | Shape::Planar | Shape::Elliptical => shape_name(whole.shape).into(),
        Shape::Balanced | Shape::DoesNotExist | Shape::NotDecided => whole_text(whole),
    }
}

/// The force and the moment of a whole order in a few words each.
pub fn whole(order: &OrderVerdict) -> [Text; 2] {
    match order.parts.as_slice() {
        [only] => [force(only), moment(only)],
        _ => [&order.force, &order.moment].map(whole_text),
    }
}

/// The force of an order in a few words: zero, `4, planar`, or that the order does not exist.
pub fn force(order: &OrderBalance) -> Text {
    if order.exists { summary(&order.force, None) } else { DOES_NOT_EXIST.into() }
}

/// The moment of an order in a few words: zero or `couple √10 ≈ 3.162, rotating`.
pub fn moment(order: &OrderBalance) -> Text {
    let words = if order.moment_is_couple() { "couple {}, {}" } else { "moment {}, {}" };
    if order.exists { summary(&order.moment, Some(words)) } else { DOES_NOT_EXIST.into() }
}

/// The inertia torque of an order in a few words: zero or its amplitude.
pub fn torque(torque: &TorqueVerdict) -> Text {
    match torque.parts.as_slice() {
        [only] => torque_part(only),
        _ if !torque.exists() => DOES_NOT_EXIST.into(),
        _ => match torque.outcome.vanishes() {
            Some(true) => Text::zero(),
            Some(false) => "not 0".into(),
            None => "not decided".into(),
        },
    }
}

/// The roll moment of an order in a few words: zero, or what the forces leave by their arms and what the torques leave.
pub fn roll(roll: &TorqueVerdict) -> Text {
    let (of_torques, of_arms): (Vec<&TorquePart>, Vec<&TorquePart>) =
        roll.parts.iter().filter(|part| part.exists && !part.verdict.vanishes()).partition(|part| is_of_torques(part));
    let sizes = |parts: &[&TorquePart]| Text::joined(parts.iter().map(|part| modulus(&part.verdict).into()), " and ");
    match (of_arms.is_empty(), of_torques.is_empty()) {
        _ if !roll.exists() => DOES_NOT_EXIST.into(),
        (true, true) => Text::zero(),
        (false, true) => phrase!("arms {}", sizes(&of_arms)),
        (true, false) => phrase!("torque {}", sizes(&of_torques)),
        (false, false) => phrase!("arms {}, torque {}", sizes(&of_arms), sizes(&of_torques)),
    }
}

/// Whether a part of the roll moment is of torques; else of forces with their arms.
pub(super) fn is_of_torques(part: &TorquePart) -> bool {
    match &part.class {
        Some(class) => is_of_torque(&class.factor),
        // Masses that only turn have no torque.
        None => part.verdict.sources.iter().any(|source| source.piston().is_some()),
    }
}

fn is_of_torque(factor: &Factor) -> bool {
    match factor {
        Factor::Geared(_, own) => is_of_torque(own),
        own => matches!(own, Factor::Torque(_) | Factor::DecimalTorque(_) | Factor::OpenTorque),
    }
}

/// The same of one of its sums.
pub fn torque_part(part: &TorquePart) -> Text {
    if !part.exists { DOES_NOT_EXIST.into() } else { modulus(&part.verdict).into() }
}

/// Whose masses the verdicts are about, where the engine has others than the reciprocating ones.
pub(super) fn whose_masses(engine: &Engine, judged: &Judgement) -> Option<Text> {
    if let Some(why) = judged.not_as_built {
        return Some(text::not_as_built(why.to_string()));
    }
    let groups = order::groups_of(engine);
    (groups.len() > 1).then(|| match judged.masses {
        Masses::All => text::as_built(Text::joined(groups.into_iter().map(|group| group_words(group).into()), ", ")),
        masses => text::masses_alone(masses_words(masses)),
    })
}

/// `order 2`, `orders 2, 6`.
pub(super) fn orders_in_words(orders: &[impl ToString]) -> Text {
    match orders {
        [only] => phrase!("order {}", only.to_string()),
        several => phrase!("orders {}", typeset::listed(several.iter().map(ToString::to_string))),
    }
}

/// What a group of masses is called.
pub(super) fn group_words(group: MassGroup) -> &'static str {
    match group {
        MassGroup::Reciprocating => "reciprocating masses",
        MassGroup::Rotating => "rotating masses",
        MassGroup::Crankshaft => "pins and webs",
        MassGroup::Counterweights => "counterweights",
        MassGroup::Balancers => "balancer shafts",
    }
}

/// The masses that verdicts are about.
fn masses_words(masses: Masses) -> Text {
    match masses {
        Masses::Reciprocating => text::reciprocating(),
        Masses::Rotating => text::rotating_alone(),
        Masses::Counterweights => text::counterweights(),
        Masses::All => text::engine_as_built(),
    }
}

/// Why an order does not exist, of the masses that verdicts are about.
pub(super) fn why_not(masses: Masses) -> Text {
    match masses {
        Masses::Reciprocating | Masses::All => WHY_NOT.into(),
        Masses::Rotating | Masses::Counterweights => text::only_own_order(),
    }
}

/// In what masses that turn are counted, where they are a sum of their own beside the pistons.
pub(super) fn turning_unit(judged: &Judgement) -> Option<Text> {
    let mut classes = judged.orders.iter().flat_map(|order| &order.parts).filter_map(|part| part.class.as_ref());
    // Links with a corrected knuckle angle, and crankshafts of several speeds, have a part of pistons there, and their own words for it.
    let is_apart = |class: &Class| class.factor == Factor::One && !class.turning.is_empty();
    classes.any(is_apart).then(text::in_no_coefficient)
}

/// In words with places for size and shape; without them in both alone.
fn summary(balance: &Balance, words: Option<&'static str>) -> Text {
    let size = || Text::from(largest(balance));
    match (balance.shape, words) {
        (Shape::Balanced, _) => Text::zero(),
        (shape, Some(words)) => phrase!(words, size(), shape_name(shape)),
        (shape, None) => phrase!("{}, {}", size(), shape_name(shape)),
    }
}

/// What a moment is called: a couple only where the force of its order vanishes.
pub(super) fn moment_name(order: &OrderBalance) -> &'static str {
    if order.moment_is_couple() { "couple" } else { "moment" }
}

/// The major axis, `(arg P⁺ + arg P⁻)/2` (theory, section 3), as a line in `(−90°, 90°]`.
pub(super) fn line_bearing(balance: &Balance) -> Bearing {
    let product = bearing(&balance.direct.sum.times(&balance.reverse.sum));
    let half = |turn: &Turn| {
        let degrees = signed_degrees(turn) / BigRational::from_integer(2.into());
        Turn::from_degrees(&degrees)
    };
    let exact = match &product.exact {
        Some(Direction::Turn(turn)) => Some(Direction::Turn(half(turn))),
        _ => None,
    };
    Bearing { exact, decimal: product.decimal / 2.0 }
}
