//! Can counterweights do it? An answer of existence: the weights themselves, and the proof for the engine with them.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::answer::{Answer, Evidence, Status};
use super::error::ClaimError;
use super::finding::{Finding, Witness};
use super::statement::{Balanced, Possible, Statement};
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::file::units;
use crate::numbers;
use crate::order::{self, Factor, OrderSum};
use crate::proof::{Planar, Sense};
use crate::remedy::{ComparableEngine, Weight, two_planes};

/// Bits behind the point of the enclosures that masses are compared by.
const BITS: u32 = 128;

/// The words before the planes.
pub(super) const BEGINNING: &str = "counterweights at ";

/// `counterweights at 0.21 m and -0.21 m can balance the direct first-order force and moment`, perhaps with
/// `with a crankshaft lighter than 11.6 kg` behind it.
pub(super) fn parse(text: &str) -> Result<Statement, ClaimError> {
    let right = "such as \"counterweights at 0.2 m and -0.2 m can balance the direct first-order force and moment with a \
                 crankshaft lighter than 11.6 kg\", or \"… the direct first-order moment\"";
    let no_claim = || ClaimError::new(format!("`{text}` is not a claim about what counterweights can do"), right);
    let rest = text.strip_prefix(BEGINNING).ok_or_else(no_claim)?;
    let (planes, rest) = rest.split_once(" can balance the direct first-order ").ok_or_else(no_claim)?;
    let plane = |text: &str| units::metres(&text.trim().replace('−', "-"));
    let planes: Result<Vec<BigRational>, String> = planes.split(" and ").map(plane).collect();
    let planes = planes.map_err(|right| ClaimError::new("cannot read the positions of the counterweights", right))?;
    if planes.len() > 2 || planes.first() == planes.get(1) {
        return Err(ClaimError::new("counterweights are in one plane or two", right));
    }
    let (what, mass) = match rest.split_once(" with a crankshaft lighter than ") {
        Some((what, mass)) => (what, Some(mass)),
        None => (rest, None),
    };
    let balanced = match what {
        "force and moment" => Balanced::ForceAndMoment,
        "moment" => Balanced::Moment,
        _ => return Err(no_claim()),
    };
    if balanced == Balanced::Moment && planes.len() == 1 {
        return Err(ClaimError::new("a couple needs counterweights in two planes", right));
    }
    let lighter_than =
        mass.map(|text| units::mass(text).map_err(|right| ClaimError::new("cannot read the mass", right)));
    Ok(Statement::CanBalance(Possible { planes, balanced, lighter_than: lighter_than.transpose()? }))
}

/// Finds the weights and proves the engine with them.
pub(super) fn answer(engine: &Engine, claimed: &Possible) -> Answer {
    let subject = match ComparableEngine::new(engine) {
        Ok(subject) => subject,
        Err(missing) => return Answer::nothing(missing.to_string()),
    };
    let plane = engine.reference_plane();
    let [force, moment] = Planar::BOTH.map(|quantity| order::all_masses(engine, quantity, 1, Sense::Direct));
    let [Some(force), Some(moment)] = [&force, &moment].map(plain) else {
        return Answer::nothing("the first order of these rods has a coefficient of its own");
    };
    let arms: Vec<BigRational> = claimed.planes.iter().map(|position| position - plane).collect();
    let vectors = match (arms.as_slice(), claimed.balanced) {
        ([_], _) => vec![half(&force).scaled(&-BigRational::one())],
        // Two that are opposite: they leave the force as it is.
        ([first, second], Balanced::Moment) => {
            let couple = half(&moment).scaled(&(BigRational::one() / (second - first)));
            vec![couple.clone(), couple.scaled(&-BigRational::one())]
        }
        (planes, Balanced::ForceAndMoment) => match <&[BigRational; 2]>::try_from(planes) {
            Ok(planes) => in_two_planes(&force, &moment, planes),
            Err(_) => return Answer::nothing("counterweights are in one plane or two"),
        },
        (_, Balanced::Moment) => return Answer::nothing("a couple needs counterweights in two planes"),
    };
    let added = |by: &dyn Fn(usize) -> BigRational| {
        let two = BigRational::from_integer(2.into());
        let each = vectors.iter().enumerate().map(|(index, vector)| vector.scaled(&(by(index) * &two)));
        each.fold(PhasorSum::new(Vec::new()), |sum, vector| sum.plus(&vector))
    };
    let left = [force.plus(&added(&|_| BigRational::one())), moment.plus(&added(&|index| arms[index].clone()))];
    let names = [
        "The direct force of order 1 with these counterweights",
        "The direct moment of order 1 with these counterweights",
    ];
    let asked = usize::from(claimed.balanced == Balanced::Moment)..2;
    let evidence: Vec<Evidence> = asked.map(|index| Evidence::comparison(names[index], left[index].clone())).collect();
    let balances = evidence.iter().all(Evidence::vanishes);
    let is_light = match (&claimed.lighter_than, engine.crankshaft_mass(), subject.scale()) {
        (None, ..) => Some(true),
        (Some(limit), Some(bare), Some([unit, radius])) => {
            let masses: Vec<PhasorSum> = vectors.iter().map(|vector| vector.scaled(&(&unit / &radius))).collect();
            lighter(&masses, &(limit - bare))
        }
        (Some(_), ..) => return Answer::nothing("the mass of the crankshaft needs the masses and the crank radius"),
    };
    // One weight, or two against force and moment, are the only ones; other couples than this one may be lighter.
    let is_only = claimed.balanced == Balanced::ForceAndMoment;
    let status = match (balances, is_light) {
        (true, Some(true)) => Status::True,
        (false, _) | (true, Some(false)) if is_only => Status::False,
        (false, _) | (true, Some(false) | None) => Status::NotDecided,
    };
    Answer { status, finding: Finding::Witness(Box::new(witness(engine, &subject, claimed, vectors))), evidence }
}

/// The vector of the coefficient 1; none where others are left.
fn plain(sums: &OrderSum) -> Option<PhasorSum> {
    if sums.vanishes() {
        return Some(PhasorSum::new(Vec::new()));
    }
    sums.only().filter(|(factor, _)| **factor == Factor::One).map(|(_, sum)| sum.clone())
}

/// `U = −P/2`: an order's vector is twice what turns.
fn half(vector: &PhasorSum) -> PhasorSum {
    vector.scaled(&BigRational::new(1.into(), 2.into()))
}

/// The two weights that take force and moment away.
fn in_two_planes(force: &PhasorSum, moment: &PhasorSum, arms: &[BigRational; 2]) -> Vec<PhasorSum> {
    let [force, moment] = [force, moment].map(|vector| OrderSum::single(Factor::One, vector.clone()));
    let weights = two_planes(1, Sense::Direct, &force, &moment, arms);
    let at = |arm: &BigRational| {
        let weight = weights.iter().find(|weight| weight.position == *arm);
        weight.and_then(|weight| plain(&weight.vector)).unwrap_or_else(|| PhasorSum::new(Vec::new()))
    };
    arms.iter().map(at).collect()
}

/// Whether the lengths add up to less than the limit, by enclosures; none where these do not tell.
fn lighter(vectors: &[PhasorSum], limit: &BigRational) -> Option<bool> {
    let ends = vectors
        .iter()
        .map(length)
        .fold([BigRational::zero(), BigRational::zero()], |[low, high], [a, b]| [low + a, high + b]);
    match ends {
        [_, high] if high < *limit => Some(true),
        [low, _] if low >= *limit => Some(false),
        _ => None,
    }
}

/// Ends that enclose the length of a sum.
fn length(vector: &PhasorSum) -> [BigRational; 2] {
    let [square, _] = numbers::enclose(&vector.squared_modulus(), BITS);
    let unit = BigInt::from(1) << BITS;
    let scaled = |end: BigRational| (end.max(BigRational::zero()) * &unit * &unit).floor().to_integer().sqrt();
    [BigRational::new(scaled(square.low), unit.clone()), BigRational::new(scaled(square.high) + 2, unit.clone())]
}

fn witness(engine: &Engine, subject: &ComparableEngine, claimed: &Possible, vectors: Vec<PhasorSum>) -> Witness {
    let weights = vectors.into_iter().zip(&claimed.planes).map(|(vector, position)| Weight {
        order: 1,
        sense: Sense::Direct,
        position: position.clone(),
        vector: OrderSum::single(Factor::One, vector),
    });
    let weights: Vec<Weight> = weights.filter(|weight| !weight.vector.vanishes()).collect();
    let masses: Option<Vec<f64>> = weights.iter().map(|weight| weight.mass_at_crank_radius(subject)).collect();
    let bare = engine.crankshaft_mass().map(|mass| numbers::float(&mass));
    let crankshaft_mass = bare.zip(masses.as_ref()).map(|(bare, masses)| bare + masses.iter().sum::<f64>());
    Witness { weights, masses, crankshaft_mass, crankshafts: engine.crankshafts() }
}
