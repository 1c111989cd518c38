//! What does `classify --json` hold? Every verdict with its terms and its certificate.

use num_rational::BigRational;

use super::recurrence_claims::{self, outcome_claim};
use crate::engine::{self, Engine, Mechanism, Rod};
use crate::exact::Term;
use crate::motion::Component;
use crate::numbers;
use crate::order::{self, Factor, Masses, Source, Sources};
use crate::proof::{
    self, Coefficient, CrankClaim, Cylinder, Document, Format, GearedClaim, KnuckleClaim, LinkClaim, LinkageClaim,
    OrderClaim, Quantity, RodClaim, RodStatement, ShapeClaim, TheoremClaim, TurningMassClaim, Vector, VerdictClaim,
    WholeClaim,
};
use crate::verdict::{self, EveryOrderTheorem, JudgedStar, OrderVerdict, Outcome, Theorem, Verdict, WholeOrder};

/// The verdicts on these masses of an engine as data: what `verify` reads. Statements on every order are in it where they
/// are given.
pub fn document(
    engine: &Engine,
    masses: Masses,
    orders: &[OrderVerdict],
    quantities: &[Quantity],
    every_order: Option<&EveryOrderTheorem>,
) -> Document {
    let asked: Vec<Quantity> = Quantity::ALL.into_iter().filter(|quantity| quantities.contains(quantity)).collect();
    // Where axes stand counts for the roll moment alone.
    let with_roll = quantities.contains(&Quantity::ROLL);
    let of_order = |order| asked.iter().flat_map(move |&quantity| verdicts(engine, order, quantity));
    let whole = |order| asked.iter().flat_map(move |&quantity| wholes(order, quantity));
    let shapes = |order: &OrderVerdict| {
        let claim = |quantity: Quantity, WholeOrder { shape, evidence, .. }: &WholeOrder| ShapeClaim {
            quantity,
            order: order.order,
            shape: *shape,
            evidence: evidence.clone(),
        };
        [claim(Quantity::FORCE, &order.force), claim(Quantity::MOMENT, &order.moment)]
    };
    let (theorems, recurrences) = match every_order {
        None => (Vec::new(), Vec::new()),
        Some(EveryOrderTheorem::Period(theorem)) => (theorem_claims(theorem), Vec::new()),
        Some(EveryOrderTheorem::Recurrences(all)) => (Vec::new(), recurrence_claims::claims(engine, all)),
    };
    Document {
        format: Format::Classify,
        title: engine.title().written().to_owned(),
        masses,
        orders: orders.iter().map(|order| order.order).collect(),
        quantities: quantities.to_vec(),
        all_orders: every_order.is_some(),
        reference_plane: engine.reference_plane().clone(),
        cylinders: engine.cylinders().iter().map(|one| cylinder(engine, one, with_roll)).collect(),
        turning_masses: turning_masses(engine, masses, with_roll),
        verdicts: orders.iter().flat_map(of_order).collect(),
        wholes: orders.iter().flat_map(whole).collect(),
        shapes: orders.iter().flat_map(shapes).collect(),
        theorems,
        recurrences,
    }
}

fn turning_masses(engine: &Engine, masses: Masses, with_roll: bool) -> Vec<TurningMassClaim> {
    let claim = |mass: &order::TurningMass| TurningMassClaim {
        name: mass.source.name(engine),
        order: mass.order,
        sense: mass.sense,
        position: mass.position.clone(),
        angle: mass.angle.turns().clone(),
        mass_radius: shaft_radius(engine, mass),
        coefficient_of: shaft_rod(engine, mass),
        axis: if with_roll { vectors(&mass.axis) } else { Vec::new() },
    };
    Sources::new(engine, masses).turning().iter().filter(|mass| is_whole(mass)).map(claim).collect()
}

/// Whether a claim is made of it: a shaft that is sized by a c_1 is there before 1 and before y, and is one mass.
pub(super) fn is_whole(mass: &order::TurningMass) -> bool {
    !matches!(mass.factor, Factor::Quadrature(_))
}

/// The rod whose coefficient a balancer shaft is sized by, as data.
pub(super) fn shaft_rod(engine: &Engine, mass: &order::TurningMass) -> Option<RodStatement> {
    balancer(engine, mass).and_then(|shaft| engine.cylinders().get(shaft.coefficient_of?)).map(rod_statement)
}

/// The mass-radius of what turns, before the coefficient of that rod: the sign of the coefficient is the checker's to find.
pub(super) fn shaft_radius(engine: &Engine, mass: &order::TurningMass) -> num_rational::BigRational {
    let parts = balancer(engine, mass).map(|shaft| order::shaft_parts(engine, shaft)).into_iter().flatten();
    let own = parts.into_iter().find(|(factor, _)| *factor == mass.factor);
    own.map_or_else(|| mass.mass_radius.clone(), |(_, part)| &mass.mass_radius * part.weight)
}

fn balancer<'a>(engine: &'a Engine, mass: &order::TurningMass) -> Option<&'a engine::Balancer> {
    let Source::Balancer(index) = mass.source else { return None };
    engine.crankshaft().balancers.get(index)
}

fn cylinder(engine: &Engine, cylinder: &engine::Cylinder, with_roll: bool) -> Cylinder {
    let crank = engine.crank_of(cylinder).filter(|_| with_roll);
    Cylinder {
        name: cylinder.name.clone(),
        throw: cylinder.throw.turns().clone(),
        bank: cylinder.bank.turns().clone(),
        position: cylinder.position.clone(),
        reciprocating_mass: order::mass_radius(engine, cylinder) / &cylinder.crank_radius,
        crank_radius: cylinder.crank_radius.clone(),
        rod: rod_statement(cylinder),
        knuckle_weight: knuckle_weight(cylinder),
        speed: engine.speed_of(cylinder),
        crankshaft: crank.map(|crank| CrankClaim { sense: crank.sense, axis: vectors(&crank.axis) }),
    }
}

/// What is known of the rod of a cylinder, as data.
pub(super) fn rod_statement(cylinder: &engine::Cylinder) -> RodStatement {
    match &cylinder.mechanism {
        None => RodStatement::Unknown,
        Some(Mechanism::SliderCrank(rod)) => RodStatement::Known(rod_claim(rod)),
        Some(Mechanism::Link(link)) => RodStatement::Link(LinkClaim {
            master: link.master.clone(),
            knuckle: link.knuckle.clone(),
            angle: link.angle.turns().clone(),
            correction: link.correction.turns().clone(),
            ratio: link.ratio.clone(),
        }),
    }
}

/// The mass at the knuckle pin of a cylinder's link times the crank radius, in multiples of m r.
pub(super) fn knuckle_weight(cylinder: &engine::Cylinder) -> BigRational {
    &cylinder.knuckle_mass * &cylinder.crank_radius
}

/// A rod as data.
pub(super) fn rod_claim(rod: &Rod) -> RodClaim {
    RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.clone() }
}

/// What a force is multiplied by, as data.
pub(super) fn coefficient_claim(factor: &Factor) -> Coefficient {
    match factor {
        Factor::One => Coefficient::One,
        Factor::Open | Factor::OpenTorque => Coefficient::Common,
        Factor::OnPin(..) => unreachable!("no force of the engine has a number of a crankpin"),
        Factor::Motion(rod) | Factor::Side(rod) | Factor::Torque(rod) => Coefficient::Rod(rod_claim(rod)),
        Factor::DecimalTorque(_) => unreachable!("it is not judged"),
        Factor::Quadrature(rod) => Coefficient::Quadrature(rod_claim(rod)),
        Factor::Linkage(linkage) => Coefficient::Linkage(LinkageClaim {
            ratio: linkage.ratio.clone(),
            knuckle: linkage.knuckle.clone(),
            apart: linkage.apart.turns().clone(),
        }),
        Factor::Geared(speed, of) => {
            Coefficient::Geared(GearedClaim { speed: *speed, of: Box::new(coefficient_claim(of)) })
        }
        Factor::Corrected(linkage, component) => Coefficient::Corrected(KnuckleClaim {
            ratio: linkage.ratio.clone(),
            knuckle: linkage.knuckle.clone(),
            master: linkage.master.clone(),
            apart: linkage.apart.turns().clone(),
            correction: linkage.correction.turns().clone(),
            part: match component {
                Component::Real => proof::Part::Real,
                Component::Imaginary => proof::Part::Imaginary,
            },
        }),
    }
}

/// The terms of a sum as data.
pub(super) fn vectors(terms: &[Term]) -> Vec<Vector> {
    terms.iter().map(|term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() }).collect()
}

/// The verdicts on one quantity of an order, by what their sums are multiplied by.
fn verdicts(engine: &Engine, order: &OrderVerdict, quantity: Quantity) -> Vec<VerdictClaim> {
    match quantity {
        Quantity::Axial(axial) => {
            let parts: Vec<_> = order.about_the_axis(axial).into_iter().flat_map(|torque| &torque.parts).collect();
            parts.iter().map(|part| verdict_claim(engine, &part.verdict, parts.len() > 1)).collect()
        }
        Quantity::Planar(planar) => {
            let of_part = |part: &verdict::OrderBalance| {
                part.balance(planar).verdicts().map(|verdict| verdict_claim(engine, verdict, order.parts.len() > 1))
            };
            order.parts.iter().flat_map(of_part).collect()
        }
    }
}

fn verdict_claim(engine: &Engine, verdict: &Verdict, is_part: bool) -> VerdictClaim {
    let (modulus, angle_deg) = decimals(verdict.into());
    let names = || verdict.sources.iter().map(|source| source.name(engine)).collect();
    VerdictClaim {
        quantity: verdict.quantity,
        order: verdict.order,
        sense: verdict.sense,
        of: if is_part { names() } else { Vec::new() },
        vanishes: verdict.vanishes(),
        terms: vectors(verdict.sum.terms()),
        modulus,
        angle_deg,
        certificate: verdict.certificate.clone(),
    }
}

/// The length of a star, not a number where it is beyond the range of decimals, and its direction in degrees where it has one.
pub(super) fn decimals(star: JudgedStar<'_>) -> (f64, Option<f64>) {
    match star.vanishes() {
        true => (0.0, None),
        false => (numbers::length_of(star.sum), Some(numbers::degrees(numbers::evaluate(star.sum)))),
    }
}

/// What is said of one quantity of an order that has several sums; nothing of one that has one.
fn wholes(order: &OrderVerdict, quantity: Quantity) -> Vec<WholeClaim> {
    let claim = |(sense, outcome): (&Option<proof::Sense>, &Outcome)| WholeClaim {
        quantity,
        order: order.order,
        sense: *sense,
        outcome: outcome_claim(outcome),
    };
    let both = [Some(proof::Sense::Direct), Some(proof::Sense::Reverse)];
    match quantity {
        Quantity::Axial(axial) => {
            let torque = order.about_the_axis(axial).into_iter().filter(|torque| torque.parts.len() > 1);
            torque.map(|torque| claim((&None, &torque.outcome))).collect()
        }
        _ if order.parts.len() < 2 => Vec::new(),
        Quantity::Planar(planar) => both.iter().zip(&order.whole(planar).outcomes).map(claim).collect(),
    }
}

/// The statements as data, with the verdicts that prove them.
fn theorem_claims(theorem: &Theorem) -> Vec<TheoremClaim> {
    let claim = |verdicts: &Vec<Verdict>| {
        let first = verdicts.first()?;
        let order = |verdict: &Verdict| OrderClaim {
            order: verdict.order,
            vanishes: verdict.vanishes(),
            certificate: verdict.certificate.clone(),
        };
        Some(TheoremClaim {
            quantity: first.quantity,
            sense: first.sense?,
            period: theorem.period.into(),
            survivors: verdict::survivors(verdicts),
            verdicts: verdicts.iter().map(order).collect(),
        })
    };
    let quantities = [&theorem.force, &theorem.moment];
    quantities.into_iter().flat_map(|every| [&every.direct, &every.reverse]).filter_map(claim).collect()
}
