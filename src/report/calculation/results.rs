//! What comes out, order by order and summed, each line worked out from the figures that it prints?

use num_traits::{ToPrimitive, Zero};

use super::amounts::{Unit, waveform};
use super::books::second_coefficient;
use super::expression::{Expression, Line, fraction, half, power, quantity};
use crate::engine::Engine;
use crate::loads::{Harmonic, Loads, OrderLoads, Outcome, Swing, Vector, Waveform};
use crate::motion;
use crate::numbers;
use crate::order;
use crate::page::{Text, phrase};
use crate::proof::{Planar, Quantity, Sense};

/// Most terms of the series of a coefficient that are printed.
const MOST_TERMS: usize = 7;
/// The part of a coefficient that a printed series may omit.
const SMALLEST_TAIL: f64 = 2e-7;

/// Lines with what they are about.
pub(super) struct Group {
    pub heading: Text,
    pub lines: Vec<Line>,
}

/// The lines of every order that is left, forces before moments.
pub(super) fn orders(engine: &Engine, loads: &Loads) -> Vec<Group> {
    loads.orders.iter().filter_map(|order| of_order(engine, loads, order)).collect()
}

fn of_order(engine: &Engine, loads: &Loads, order: &OrderLoads) -> Option<Group> {
    if order.force.vanishes() && order.moment.vanishes() {
        return None;
    }
    let mut lines: Vec<Line> = coefficient(engine, order).into_iter().collect();
    for (quantity, swing) in [(Planar::Force, &order.force), (Planar::Moment, &order.moment)] {
        if swing.vanishes() {
            continue;
        }
        for (sense, vector) in [(Sense::Direct, &swing.direct), (Sense::Reverse, &swing.reverse)] {
            lines.extend(length(engine, order, quantity, sense, vector));
        }
        lines.extend(extremes(engine, loads, order.order, quantity, swing));
        lines.extend(textbook(engine, loads, order, quantity, swing));
    }
    Some(Group { heading: phrase!("Order {}, line by line", order.order), lines })
}

/// `c_2 = λ + λ³/4 + …` of equal centric cranks; the value alone where the series is long or the crank offset.
fn coefficient(engine: &Engine, order: &OrderLoads) -> Option<Line> {
    let value = order.coefficient.as_ref()?.to_complex();
    let rod = engine.rods().next()?;
    let symbol = format!("c_{{{}}}", order.order);
    if order.order == 1 && rod.offset.is_zero() {
        return None;
    }
    if !rod.offset.is_zero() {
        let symbol = format!("\\left|{symbol}\\right|");
        return Some(Line { symbol, expression: quantity("", value.norm()), unit: "" });
    }
    let series = (1..=MOST_TERMS).map(|terms| motion::series(order.order, terms)).find(|series| {
        let tail = series.tail(&rod.ratio).and_then(|tail| tail.to_f64()).unwrap_or(1.0);
        tail.abs() <= SMALLEST_TAIL * value.re.abs()
    });
    let expression = series.map_or_else(|| quantity("", value.re), |series| expansion(&series, rod.ratio.to_f64()));
    Some(Line { symbol, expression, unit: "" })
}

fn expansion(series: &motion::Series, ratio: Option<f64>) -> Expression {
    let ratio = quantity("\\lambda", ratio.unwrap_or(f64::NAN));
    let term = |(exponent, coefficient): &(u32, num_rational::BigRational)| {
        let whole = |number: &num_bigint::BigInt| Expression::Number(number.magnitude().to_u64().unwrap_or(u64::MAX));
        let raised = if *exponent == 1 { ratio.clone() } else { power(ratio.clone(), *exponent) };
        let above = match coefficient.numer().magnitude().to_u64() {
            Some(1) => raised,
            _ => Expression::Product(vec![whole(coefficient.numer()), raised]),
        };
        let size = if coefficient.is_integer() { above } else { fraction(above, whole(coefficient.denom())) };
        if *coefficient < num_rational::BigRational::zero() { Expression::Minus(Box::new(size)) } else { size }
    };
    let mut terms: Vec<Expression> = series.terms().iter().map(term).collect();
    terms.push(Expression::Dots);
    Expression::Sum(terms)
}

/// The letters of force and moment: of their exact stars, their rotating vectors, their sizes.
type Letters = [&'static str; 2];
const STARS: Letters = ["P", "C"];
const VECTORS: Letters = ["V", "W"];
const SIZES: Letters = ["F", "M"];

fn letter(of: Planar, [force, moment]: Letters) -> &'static str {
    of.choose(force, moment)
}

/// `|V_2⁺|`: the length of a star or a rotating vector.
fn length_of(letters: Letters, order: u32, of: Planar, sense: Sense) -> String {
    let sign = sense.choose("+", "-");
    format!("\\left|{}_{{{order}}}^{{{sign}}}\\right|", letter(of, letters))
}

/// `|V| = |c| |P|`, where the star of the verdicts is all that adds to it.
fn length(engine: &Engine, order: &OrderLoads, of: Planar, sense: Sense, vector: &Vector) -> Option<Line> {
    if vector.outcome == Outcome::Zero {
        return None;
    }
    let symbol = length_of(VECTORS, order.order, of, sense);
    let star = numbers::evaluate(&order::star(engine, of, order.order, Some(sense))).norm();
    let star_symbol = length_of(STARS, order.order, of, sense);
    let c = order.coefficient.as_ref().map(|coefficient| coefficient.to_complex().norm());
    // Other masses than the reciprocating ones add to the vector of order 1.
    let is_star = c.is_some_and(|c| (c * star - vector.value.norm()).abs() <= 1e-12 * vector.value.norm());
    let expression = match (is_star, c, order.order) {
        (true, Some(1.0), 1) => quantity(star_symbol, star),
        (true, Some(c), _) => Expression::Product(vec![
            quantity(format!("\\left|c_{{{}}}\\right|", order.order), c),
            quantity(star_symbol, star),
        ]),
        _ => with_rotating(engine, order, sense, star_symbol, star, vector)
            .unwrap_or_else(|| quantity("", vector.value.norm())),
    };
    Some(Line { symbol, expression, unit: "" })
}

/// `|V_1⁺| = (1 + 2 m_rot/m) |P_1⁺|` of equal centric cylinders with equal rotating masses and no others.
fn with_rotating(
    engine: &Engine,
    order: &OrderLoads,
    sense: Sense,
    star_symbol: String,
    star: f64,
    vector: &Vector,
) -> Option<Expression> {
    let mechanism = engine.dimensions();
    let rotating = engine.cylinders()[0].rotating_mass.to_f64()?;
    let mass = mechanism.mass.as_ref()?.to_f64()?;
    let inner = Expression::Sum(vec![
        Expression::Number(1),
        fraction(
            Expression::Product(vec![Expression::Number(2), quantity("m_{\\mathrm{rot}}", rotating)]),
            quantity("m", mass),
        ),
    ]);
    let whole = (1.0 + 2.0 * rotating / mass) * star;
    let alike = (whole - vector.value.norm()).abs() <= 1e-12 * whole;
    let is_so = (order.order, sense) == (1, Sense::Direct) && alike;
    is_so.then(|| Expression::Product(vec![inner, quantity(star_symbol, star)]))
}

/// Half of K times an expression, or half of it where there are no newtons.
fn halved(loads: &Loads, inner: Expression) -> Expression {
    let mut factors = vec![half()];
    factors.extend(loads.scale.as_ref().map(|scale| quantity("K", scale.force())));
    factors.push(inner);
    Expression::Product(factors)
}

/// The largest and, where it differs and is not zero, the smallest length of an order.
fn extremes(engine: &Engine, loads: &Loads, order: u32, of: Planar, swing: &Swing) -> Vec<Line> {
    let unit = Unit::of(engine, loads, of).unit.tex;
    let letter = letter(of, SIZES);
    let vector = |sense, vector: &Vector| quantity(length_of(VECTORS, order, of, sense), vector.value.norm());
    let (direct, reverse) = (vector(Sense::Direct, &swing.direct), vector(Sense::Reverse, &swing.reverse));
    let largest = |expression| Line { symbol: format!("\\hat {letter}_{{{order}}}"), expression, unit };
    match (swing.direct.outcome == Outcome::Zero, swing.reverse.outcome == Outcome::Zero) {
        (true, _) => vec![largest(halved(loads, reverse))],
        (_, true) => vec![largest(halved(loads, direct))],
        _ => {
            let both = Expression::Sum(vec![direct.clone(), reverse.clone()]);
            let mut lines = vec![largest(halved(loads, both))];
            if !swing.path.is_line {
                let (longer, shorter) = match swing.direct.value.norm() > swing.reverse.value.norm() {
                    true => (direct, reverse),
                    false => (reverse, direct),
                };
                let difference = Expression::Sum(vec![longer, Expression::Minus(Box::new(shorter))]);
                let symbol = format!("\\check {letter}_{{{order}}}");
                lines.push(Line { symbol, expression: halved(loads, difference), unit });
            }
            lines
        }
    }
}

/// The second order with `c_2 = λ` alone, as textbooks take it.
fn textbook(engine: &Engine, loads: &Loads, order: &OrderLoads, of: Planar, swing: &Swing) -> Option<Line> {
    let [lambda, c] = second_coefficient(engine, order)?;
    let star = (swing.direct.value.norm() + swing.reverse.value.norm()) / c;
    let [direct, reverse] = Sense::BOTH.map(|sense| length_of(STARS, 2, of, sense));
    let inner = Expression::Product(vec![
        quantity("\\lambda", lambda),
        quantity(format!("\\left({direct} + {reverse}\\right)"), star),
    ]);
    Some(Line {
        symbol: format!("\\hat {}_{{2}}^{{c_2 = \\lambda}}", letter(of, SIZES)),
        expression: halved(loads, inner),
        unit: Unit::of(engine, loads, of).unit.tex,
    })
}

/// The peak of the sum over the orders: both components at its angle, and their length.
pub(super) fn peak(engine: &Engine, loads: &Loads, of: Planar) -> Option<Vec<Line>> {
    let waveform = waveform(loads, of);
    let peak = waveform.peak();
    let angle = peak.angle.filter(|_| waveform.harmonics().len() > 1)?;
    let unit = Unit::of(engine, loads, of);
    let letter = letter(of, SIZES);
    let mut lines = Vec::new();
    let mut squares = Vec::new();
    for (mark, component) in [("\\parallel", 0), ("\\perp", 1)] {
        let terms = components(waveform, component, letter, mark, angle, unit.factor);
        if terms.is_empty() {
            continue;
        }
        let expression = if let [only] = terms.as_slice() { only.clone() } else { Expression::Sum(terms) };
        let line = Line { symbol: format!("{letter}_{{{mark}}}(\\theta^{{*}})"), expression, unit: unit.unit.tex };
        squares.push(power(quantity(line.symbol.clone(), line.value()), 2));
        lines.push(line);
    }
    if squares.len() > 1 {
        let expression = Expression::Root(Box::new(Expression::Sum(squares)));
        lines.push(Line { symbol: format!("\\hat {letter}"), expression, unit: unit.unit.tex });
    }
    Some(lines)
}

/// `A_k cos(kθ + ε_k)` of one component: along direction 0, or across it.
fn components(
    waveform: &Waveform,
    component: usize,
    letter: &str,
    mark: &str,
    angle: f64,
    factor: f64,
) -> Vec<Expression> {
    let largest = waveform.harmonics().iter().map(|h| h.direct.norm() + h.reverse.norm()).fold(0.0, f64::max);
    let term = |harmonic: &Harmonic| {
        // Re and Im of d e^{ikθ} + r e^{−ikθ} are Re((d + r̄) e^{ikθ}) and Re(−i(d − r̄) e^{ikθ}).
        let phasor = match component {
            0 => harmonic.direct + harmonic.reverse.conj(),
            _ => (harmonic.direct - harmonic.reverse.conj()) * -num_complex::Complex::i(),
        };
        // What is left of a component that cancels is rounding.
        let is_left = phasor.norm() > 1e-12 * largest;
        is_left.then(|| cosine(harmonic.order, phasor * factor, letter, mark, angle))
    };
    waveform.harmonics().iter().filter_map(term).collect()
}

fn cosine(order: u32, phasor: num_complex::Complex<f64>, letter: &str, mark: &str, angle: f64) -> Expression {
    let turned = Expression::Degrees("\\theta^{*}".to_owned(), angle);
    let turned = match order {
        1 => turned,
        _ => Expression::Product(vec![Expression::Number(u64::from(order)), turned]),
    };
    let degrees = super::expression::rounded(phasor.arg().to_degrees(), 6);
    let shifted = match degrees.abs() < 1e-9 {
        true => turned,
        false => Expression::Sum(vec![
            turned,
            Expression::Degrees(format!("\\varepsilon_{{{order}{mark}}}"), phasor.arg().to_degrees()),
        ]),
    };
    let amplitude = quantity(format!("{letter}_{{{order}{mark}}}"), phasor.norm());
    Expression::Product(vec![amplitude, Expression::Cosine(Box::new(shifted))])
}

/// The amplitude of each order of the inertia torque.
pub(super) fn torque(engine: &Engine, loads: &Loads) -> Option<Group> {
    let torque = loads.torque.as_ref()?;
    let unit = Unit::of(engine, loads, Quantity::TORQUE);
    let mut lines = Vec::new();
    if let Some(scale) = &loads.scale {
        let factors =
            vec![quantity("K", scale.force()), quantity("r", scale.crank_radius.to_f64().unwrap_or(f64::INFINITY))];
        lines.push(Line { symbol: "K\\,r".to_owned(), expression: Expression::Product(factors), unit: unit.unit.tex });
    }
    for order in torque.orders.iter().filter(|order| order.vector.outcome != Outcome::Zero) {
        let k = order.order;
        let star = numbers::evaluate(&order::star(engine, Quantity::TORQUE, k, None)).norm();
        let mut factors: Vec<Expression> = loads.scale.iter().map(|scale| quantity("K\\,r", scale.torque())).collect();
        match &order.coefficient {
            Some(coefficient) => {
                factors.push(quantity(format!("\\left|t_{{{k}}}\\right|"), coefficient.to_complex().norm()));
                factors.push(quantity(format!("\\left|Q_{{{k}}}\\right|"), star));
            }
            None => factors.push(quantity(format!("\\left|t_{{{k}}} Q_{{{k}}}\\right|"), order.vector.value.norm())),
        }
        let symbol = format!("\\hat T_{{{k}}}");
        lines.push(Line { symbol, expression: Expression::Product(factors), unit: unit.unit.tex });
    }
    Some(Group { heading: "Inertia torque, line by line".into(), lines })
}
