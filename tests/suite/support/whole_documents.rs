//! How does a test come by a document on any masses and any rods? The head is given; the proofs are made here, by a
//! reading of src/kernel/proof/README.md that shares nothing with the program.

use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::motion::SliderCrank;
use crankstar::numbers::evaluate;
use crankstar::proof::{
    Coefficient, Cylinder, Document, Format, GearedClaim, Masses, Quantity, RodClaim, RodStatement, Sense, Shape,
    ShapeClaim, ShapeEvidence, TurningMassClaim, VerdictClaim, WholeClaim, WholeOutcome,
};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::written::{ratio, vectors};

/// A cylinder on a throw and a bank in turns, of mass and crank radius 1.
pub fn cylinder(name: &str, [throw, bank, position]: [&str; 3], rod: Option<[&str; 2]>) -> Cylinder {
    let known = |[r, e]: [&str; 2]| RodStatement::Known(RodClaim { ratio: ratio(r), offset: ratio(e) });
    Cylinder {
        name: name.to_owned(),
        throw: ratio(throw),
        bank: ratio(bank),
        position: ratio(position),
        reciprocating_mass: BigRational::one(),
        crank_radius: BigRational::one(),
        rod: rod.map_or(RodStatement::Unknown, known),
        knuckle_weight: BigRational::zero(),
        speed: 1,
        crankshaft: None,
    }
}

pub fn turning(name: &str, order: u32, sense: Sense, [position, angle, mass_radius]: [&str; 3]) -> TurningMassClaim {
    let [position, angle, mass_radius] = [position, angle, mass_radius].map(ratio);
    TurningMassClaim {
        name: name.to_owned(),
        order,
        sense,
        position,
        angle,
        mass_radius,
        coefficient_of: None,
        axis: Vec::new(),
    }
}

pub fn document(
    masses: Masses,
    orders: &[u32],
    with_torque: bool,
    cylinders: Vec<Cylinder>,
    turning_masses: Vec<TurningMassClaim>,
) -> Document {
    let torque = with_torque.then_some(Quantity::TORQUE);
    let mut document = Document {
        format: Format::Classify,
        title: "by hand".to_owned(),
        masses,
        orders: orders.to_vec(),
        quantities: [Quantity::FORCE, Quantity::MOMENT].into_iter().chain(torque).collect(),
        all_orders: false,
        reference_plane: BigRational::zero(),
        cylinders,
        turning_masses,
        verdicts: Vec::new(),
        wholes: Vec::new(),
        shapes: Vec::new(),
        theorems: Vec::new(),
        recurrences: Vec::new(),
    };
    fill(&mut document);
    document
}

/// What one source adds: coefficient, whether that is zero, and the term in each sense.
struct Part {
    name: String,
    coefficient: Coefficient,
    is_zero: bool,
    terms: Vec<Option<Term>>,
}

struct Sums {
    coefficient: Coefficient,
    is_zero: bool,
    names: Vec<Vec<String>>,
    sums: Vec<PhasorSum>,
}

pub fn senses(quantity: Quantity) -> Vec<Option<Sense>> {
    match quantity {
        Quantity::TORQUE => vec![None],
        _ => vec![Some(Sense::Direct), Some(Sense::Reverse)],
    }
}

fn before(rod: &RodStatement, quantity: Quantity, order: u32) -> (Coefficient, bool, i64) {
    let odd = order % 2 == 1;
    match (rod, quantity) {
        (RodStatement::Link(_), _) => panic!("documents by hand have no links"),
        (RodStatement::Unknown, Quantity::TORQUE) => (Coefficient::CommonTorque, false, 1),
        (RodStatement::Known(rod), Quantity::TORQUE) => {
            (Coefficient::Torque(rod.clone()), rod.ratio.is_zero() && order != 2, 1)
        }
        (RodStatement::Unknown, _) if order == 1 => (Coefficient::One, false, 1),
        (RodStatement::Unknown, _) => (Coefficient::Common, odd, 1),
        (RodStatement::Known(rod), _) if order == 1 => {
            let centric = rod.offset.is_zero();
            (if centric { Coefficient::One } else { Coefficient::Rod(rod.clone()) }, false, 1)
        }
        (RodStatement::Known(rod), _) => {
            let other = RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
            let zero = rod.ratio.is_zero() || (rod.offset.is_zero() && odd);
            (Coefficient::Rod(other), zero, if rod.offset.is_negative() && odd { -1 } else { 1 })
        }
    }
}

/// y of a rod with an offset, and the sign that it has.
fn first_aside(rod: &RodStatement) -> Option<(Coefficient, i64)> {
    let RodStatement::Known(rod) = rod else { return None };
    let other = RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.abs() };
    let sign = if rod.offset.is_negative() { -1 } else { 1 };
    (!rod.offset.is_zero()).then_some((Coefficient::Quadrature(other), sign))
}

fn parts(document: &Document, quantity: Quantity, order: u32) -> Vec<Part> {
    let k = i64::from(order);
    let arm = |position: &BigRational| match quantity {
        Quantity::MOMENT => position - &document.reference_plane,
        _ => BigRational::one(),
    };
    let whole = |number: i64| BigRational::from_integer(number.into());
    let do_rods_differ = document.cylinders.windows(2).any(|pair| pair[0].rod != pair[1].rod);
    let mut parts = Vec::new();
    if matches!(document.masses, Masses::Reciprocating | Masses::All) {
        // A crank that turns faster has the orders that its speed divides, each as the order of its own motion.
        for cylinder in document.cylinders.iter().filter(|cylinder| order.is_multiple_of(cylinder.speed)) {
            let (speed, own) = (cylinder.speed, order / cylinder.speed);
            let (coefficient, is_zero, sign) = before(&cylinder.rod, quantity, own);
            let coefficient = match (coefficient, speed) {
                (Coefficient::One, _) => Coefficient::One,
                (of, 1) => of,
                (of, speed) => Coefficient::Geared(GearedClaim { speed, of: Box::new(of) }),
            };
            let (k, faster) = (i64::from(own), i64::from(speed));
            let radius = &cylinder.crank_radius;
            let by = match quantity {
                Quantity::TORQUE => radius * whole(faster * faster * faster),
                _ => arm(&cylinder.position) * whole(faster * faster),
            };
            let weight = &cylinder.reciprocating_mass * radius * by * whole(sign);
            let (b, a) = (Turn::new(cylinder.throw.clone()), Turn::new(cylinder.bank.clone()));
            let term = |sense: Option<Sense>| {
                let angle = match sense {
                    None => &b.times(k) + &a.times(-k),
                    Some(Sense::Direct) => &b.times(k) + &a.times(1 - k),
                    Some(Sense::Reverse) => &b.times(-k) + &a.times(k + 1),
                };
                Some(Term { angle, weight: weight.clone() })
            };
            let terms = senses(quantity).into_iter().map(term).collect();
            let name = cylinder.name.clone();
            match first_aside(&cylinder.rod).filter(|_| quantity != Quantity::TORQUE && own == 1 && do_rods_differ) {
                None => parts.push(Part { name, coefficient, is_zero, terms }),
                // c_1 = 1 + iy, conjugated against the crank.
                Some((y, sign)) => {
                    let aside = senses(quantity).into_iter().map(|sense| {
                        let Term { angle, weight } = term(sense)?;
                        let quarter =
                            if sense == Some(Sense::Direct) { Turn::fraction(1, 4) } else { Turn::fraction(3, 4) };
                        Some(Term { angle: &angle + &quarter, weight: weight * whole(sign) })
                    });
                    let aside = aside.collect();
                    let y = if speed == 1 { y } else { Coefficient::Geared(GearedClaim { speed, of: Box::new(y) }) };
                    parts.push(Part { name: name.clone(), coefficient: Coefficient::One, is_zero: false, terms });
                    parts.push(Part { name, coefficient: y, is_zero: false, terms: aside });
                }
            }
        }
    }
    if quantity != Quantity::TORQUE {
        for mass in document.turning_masses.iter().filter(|mass| mass.order == order) {
            let weight = whole(2 * k * k) * &mass.mass_radius * arm(&mass.position);
            let term = Term { angle: Turn::new(mass.angle.clone()), weight };
            let terms = senses(quantity).into_iter().map(|one| (one == Some(mass.sense)).then(|| term.clone()));
            let name = mass.name.clone();
            parts.push(Part { name, coefficient: Coefficient::One, is_zero: false, terms: terms.collect() });
        }
    }
    parts
}

fn sums(document: &Document, quantity: Quantity, order: u32) -> Vec<Sums> {
    let mut all: Vec<(Coefficient, bool, Vec<Part>)> = Vec::new();
    for part in parts(document, quantity, order) {
        match all.iter_mut().find(|(coefficient, ..)| *coefficient == part.coefficient) {
            Some((_, _, list)) => list.push(part),
            None => all.push((part.coefficient.clone(), part.is_zero, vec![part])),
        }
    }
    if all.is_empty() {
        all.push((Coefficient::One, false, Vec::new()));
    }
    let made = all.into_iter().map(|(coefficient, is_zero, parts)| {
        let of = |place: usize| parts.iter().filter_map(move |part| Some((&part.name, part.terms[place].clone()?)));
        let places = 0..senses(quantity).len();
        Sums {
            coefficient,
            is_zero,
            names: places.clone().map(|place| of(place).map(|(name, _)| name.clone()).collect()).collect(),
            sums: places.map(|place| PhasorSum::new(of(place).map(|(_, term)| term).collect())).collect(),
        }
    });
    made.collect()
}

/// The coefficient as the room `motion` has it.
pub fn number(coefficient: &Coefficient, order: u32) -> Option<Complex<f64>> {
    let crank = |rod: &RodClaim| SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).expect("it turns round");
    match coefficient {
        Coefficient::One => Some(Complex::one()),
        Coefficient::Common | Coefficient::CommonTorque => None,
        Coefficient::Rod(rod) => Some(crank(rod).coefficient(order).to_complex()),
        Coefficient::Quadrature(rod) => Some(crank(rod).coefficient(1).to_complex().im.into()),
        Coefficient::Linkage(_) | Coefficient::Corrected(_) => panic!("documents by hand have no links"),
        Coefficient::Geared(geared) => number(&geared.of, order / geared.speed),
        Coefficient::Torque(rod) => Some(crank(rod).torque_coefficient(order).to_complex()),
    }
}

fn weights(left: &[&Sums], place: usize) -> f64 {
    let terms = left.iter().flat_map(|group| group.sums[place].collected());
    terms.map(|term| term.weight.abs().to_f64().expect("a float")).sum()
}

/// The whole in floats, and how long it would be if nothing cancelled; none where a rod is not known.
fn total(left: &[&Sums], quantity: Quantity, order: u32, place: usize) -> Option<(Complex<f64>, f64)> {
    left.iter().try_fold((Complex::zero(), 0.0), |(sum, reach), group| {
        let c = number(&group.coefficient, order)?;
        let c = if senses(quantity)[place] == Some(Sense::Reverse) { c.conj() } else { c };
        let own: f64 = weights(&[group], place);
        Some((sum + c * evaluate(&group.sums[place]), reach + c.norm() * own))
    })
}

fn outcome(groups: &[Sums], quantity: Quantity, order: u32, place: usize) -> WholeOutcome {
    let left = left(groups, place);
    match left.len() {
        0 => WholeOutcome::Zero,
        1 => WholeOutcome::NotZero,
        _ => match total(&left, quantity, order, place) {
            None => WholeOutcome::Open,
            Some((sum, reach)) if sum.norm() > 1e-10 * reach => WholeOutcome::NotZeroByEnclosure { bits: 128 },
            Some(_) => WholeOutcome::NotDecided { below: 1e-30 * weights(&left, place) },
        },
    }
}

fn left(groups: &[Sums], place: usize) -> Vec<&Sums> {
    groups.iter().filter(|group| !group.is_zero && !group.sums[place].vanishes()).collect()
}

fn verdict(quantity: Quantity, order: u32, place: usize, group: &Sums, is_alone: bool) -> VerdictClaim {
    let sum = &group.sums[place];
    let (value, vanishes) = (evaluate(sum), sum.vanishes());
    VerdictClaim {
        quantity,
        order,
        sense: senses(quantity)[place],
        of: if is_alone { Vec::new() } else { group.names[place].clone() },
        vanishes,
        terms: vectors(sum),
        modulus: if vanishes { 0.0 } else { value.norm() },
        angle_deg: (!vanishes).then(|| crankstar::numbers::degrees(value)),
        certificate: sum.certificate(),
    }
}

/// What each product of two numbers in `|direct|² − |reverse|²` is multiplied by.
fn pairs(groups: &[Sums], order: u32) -> Vec<PhasorSum> {
    let is_real = |group: &Sums| match &group.coefficient {
        Coefficient::Rod(_) => order.is_multiple_of(2),
        _ => true,
    };
    let there = groups.iter().filter(|group| !group.is_zero && !group.sums.iter().all(PhasorSum::vanishes));
    // An imaginary number is a real one a quarter turn on, and in a reverse sum back.
    let there: Vec<[PhasorSum; 2]> = there
        .map(|group| match is_real(group) {
            true => [group.sums[0].clone(), group.sums[1].clone()],
            false => [(0, 1), (1, 3)]
                .map(|(sense, quarter): (usize, i64)| group.sums[sense].turned(&Turn::fraction(quarter, 4))),
        })
        .collect();
    let mut pairs = Vec::new();
    for (place, one) in there.iter().enumerate() {
        for other in &there[place..] {
            let product = |sense: usize| one[sense].times(&other[sense].conjugate());
            let half = product(0).minus(&product(1));
            let whole = if std::ptr::eq(one, other) { half } else { half.plus(&half.conjugate()) };
            pairs.push(PhasorSum::new(whole.collected()));
        }
    }
    pairs
}

fn shape(groups: &[Sums], quantity: Quantity, order: u32, wholes: [Option<bool>; 2]) -> (Shape, Option<ShapeEvidence>) {
    match wholes {
        _ if groups.iter().all(|group| group.is_zero || group.names.iter().all(Vec::is_empty)) => {
            return (Shape::DoesNotExist, None);
        }
        [Some(true), Some(true)] => return (Shape::Balanced, None),
        [Some(false), Some(true)] => return (Shape::Rotating, None),
        [Some(true), Some(false)] => return (Shape::CounterRotating, None),
        [Some(false), Some(false)] => (),
        _ => return (Shape::NotDecided, None),
    }
    let alone = match (groups, &left(groups, 0)[..], &left(groups, 1)[..]) {
        ([only], ..) => Some(only),
        (_, [direct], [reverse]) if direct.coefficient == reverse.coefficient => Some(*direct),
        _ => None,
    };
    if let Some(group) = alone {
        let difference = group.sums[0].squared_modulus().minus(&group.sums[1].squared_modulus());
        let certificate = PhasorSum::new(difference.collected()).certificate();
        let shape = if certificate.claims_zero() { Shape::Planar } else { Shape::Elliptical };
        return (shape, Some(ShapeEvidence::Certificate(certificate)));
    }
    let pairs = pairs(groups, order);
    if pairs.iter().all(PhasorSum::vanishes) {
        return (Shape::Planar, Some(ShapeEvidence::Pairs(pairs.iter().map(PhasorSum::certificate).collect())));
    }
    let totals = [0, 1].map(|place| total(&left(groups, place), quantity, order, place));
    if let [Some((direct, reach)), Some((reverse, other))] = totals
        && (direct.norm_sqr() - reverse.norm_sqr()).abs() > 1e-9 * (reach * reach + other * other)
    {
        return (Shape::Elliptical, Some(ShapeEvidence::Bits(128)));
    }
    (Shape::NotDecided, None)
}

/// Makes verdicts, wholes and shapes anew.
pub fn fill(document: &mut Document) {
    let (mut verdicts, mut wholes, mut shapes) = (Vec::new(), Vec::new(), Vec::new());
    for &order in &document.orders {
        for &quantity in &document.quantities {
            let groups = sums(document, quantity, order);
            let (count, is_alone) = (senses(quantity).len(), groups.len() == 1);
            for group in &groups {
                verdicts.extend((0..count).map(|place| verdict(quantity, order, place, group, is_alone)));
            }
            let outcomes: Vec<WholeOutcome> =
                (0..count).map(|place| outcome(&groups, quantity, order, place)).collect();
            if !is_alone {
                let claim = |(place, &outcome): (usize, &WholeOutcome)| {
                    let sense = senses(quantity)[place];
                    WholeClaim { quantity, order, sense, outcome }
                };
                wholes.extend(outcomes.iter().enumerate().map(claim));
            }
            if quantity != Quantity::TORQUE {
                let is_zero = |place: usize| match (is_alone, outcomes[place]) {
                    (true, _) => Some(groups[0].sums[place].vanishes()),
                    (_, WholeOutcome::Zero) => Some(true),
                    (_, WholeOutcome::NotZero | WholeOutcome::NotZeroByEnclosure { .. }) => Some(false),
                    (_, WholeOutcome::NotDecided { .. } | WholeOutcome::Open) => None,
                };
                let (shape, evidence) = shape(&groups, quantity, order, [is_zero(0), is_zero(1)]);
                shapes.push(ShapeClaim { quantity, order, shape, evidence });
            }
        }
    }
    (document.verdicts, document.wholes, document.shapes) = (verdicts, wholes, shapes);
}
