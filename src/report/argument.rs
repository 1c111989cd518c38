//! How does a person argue that a sum is zero, or that it is not? Sentences that can be checked by hand.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::star::{Ray, Star, source_names};
use super::typeset;
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term, Turn};
use crate::order::Source;
use crate::page::Text;
use crate::proof::{Certificate, Polygon, Quantity, Residue, Step};
use crate::verdict::{Reason, Verdict, mirror_partners, opposed_partners, reason};

/// Longer sums than this are not written out modulo the prime.
const MOST_TERMS_WRITTEN: usize = 9;

/// The sentences that prove a verdict.
pub(super) fn argument(engine: &Engine, verdict: &Verdict) -> Text {
    Text::phrase(words(engine, verdict), Vec::new())
}

fn words(engine: &Engine, verdict: &Verdict) -> String {
    let star = Star::new(verdict);
    match reason(engine, verdict) {
        Reason::NoWeight if verdict.sources.is_empty() => "No mass has a part in it.".to_owned(),
        Reason::NoWeight if verdict.quantity == Quantity::Moment && stand_in_the_plane(engine, verdict) => {
            "Every cylinder stands in the reference plane: all arms are zero.".to_owned()
        }
        Reason::NoWeight => "All masses are zero.".to_owned(),
        Reason::Mirror => format!("By symmetry: {}", mirror(engine)),
        Reason::Cancels => format!("Like directions cancel: {}.", cancelling(engine, verdict)),
        Reason::OpposedPairs => opposed(engine, verdict),
        Reason::Rotation { fold } => {
            let turn = typeset::angle(&Turn::fraction(1, i64::from(fold)));
            format!(
                "By symmetry: turned by {turn} the star is the same star, so its sum is the same when turned by {turn}, \
                 and only zero is. In polygons: {}",
                polygons(engine, &star)
            )
        }
        Reason::Polygons => polygons(engine, &star),
        Reason::OneDirection(term) => format!(
            "Like directions collected, one vector is left: {} at {}. It is not zero.",
            typeset::number(&term.weight),
            typeset::angle(&term.angle)
        ),
        Reason::TwoDirections(first, second) => format!(
            "Like directions collected, two vectors are left: {} at {} and {} at {}. Two vectors cancel only where they \
             are opposite and equally long, which these are not.",
            typeset::number(&first.weight),
            typeset::angle(&first.angle),
            typeset::number(&second.weight),
            typeset::angle(&second.angle)
        ),
        Reason::Certificate => "No set of regular polygons makes up this star; the certificate shows it.".to_owned(),
    }
}

/// Whether it is the arms that leave nothing of a moment of pistons.
fn stand_in_the_plane(engine: &Engine, verdict: &Verdict) -> bool {
    let arm = |source: &Source| match source {
        Source::Piston(index) => Some(engine.arm(&engine.cylinders()[*index])),
        _ => None,
    };
    verdict.sources.iter().all(|source| arm(source).is_some_and(|arm| arm.is_zero()))
}

fn mirror(engine: &Engine) -> String {
    let partners = mirror_partners(engine).unwrap_or_default().into_iter().enumerate();
    let cylinders: Vec<Source> = (0..engine.cylinders().len()).map(Source::Piston).collect();
    format!(
        "the reference plane is a mirror plane of the crankshaft. The cylinders {} have the same throw, bank and mass, and \
         opposite arms, so their vectors cancel in every order.",
        pairs(engine, &cylinders, partners.filter(|(index, partner)| index < partner)).join(", ")
    )
}

fn opposed(engine: &Engine, verdict: &Verdict) -> String {
    let partners = opposed_partners(&verdict.sum).unwrap_or_default();
    let turned = match verdict.quantity {
        Quantity::Moment => ", each multiplied by its arm,",
        _ => "",
    };
    let pairs = pairs(engine, &verdict.sources, partners.into_iter());
    match pairs.as_slice() {
        [pair] => format!("By opposed pairs: the vectors of {pair}{turned} are equally long and opposite, and cancel."),
        _ => format!(
            "By opposed pairs: the vectors of {}{turned} are equally long and opposite, and cancel pair by pair.",
            pairs.join(", of ")
        ),
    }
}

/// `1 and 4`, a pair of sources each.
fn pairs(engine: &Engine, sources: &[Source], indices: impl Iterator<Item = (usize, usize)>) -> Vec<String> {
    let name = |index: usize| sources[index].name(engine);
    indices.map(|(first, second)| format!("{} and {}", name(first), name(second))).collect()
}

/// Each direction with the weights that cancel on it.
fn cancelling(engine: &Engine, verdict: &Verdict) -> String {
    let mut directions: Vec<(&Turn, Vec<(Source, &BigRational)>)> = Vec::new();
    for (source, term) in verdict.sources.iter().zip(verdict.sum.terms()) {
        let entry = (*source, &term.weight);
        match directions.iter_mut().find(|(angle, _)| *angle == &term.angle) {
            Some((_, members)) => members.push(entry),
            None => directions.push((&term.angle, vec![entry])),
        }
    }
    directions.sort_by_key(|(angle, _)| *angle);
    let one = |(angle, members): &(&Turn, Vec<(Source, &BigRational)>)| {
        let weights: Vec<String> = members.iter().map(|(_, weight)| typeset::number(weight)).collect();
        let names = source_names(engine, members.iter().map(|(source, _)| *source));
        let sum = weights.join(" + ").replace("+ −", "− ");
        let pistons = members.iter().all(|(source, _)| matches!(source, Source::Piston(_)));
        let kind = if pistons { "cylinders" } else { "vectors" };
        format!("at {} ({kind} {names}) {sum} = 0", typeset::angle(angle))
    };
    directions.iter().map(one).collect::<Vec<_>>().join("; ")
}

fn polygons(engine: &Engine, star: &Star) -> String {
    let turned = if star.has_turned { "With the vectors of negative arms turned by 180°: " } else { "" };
    let sentences: Vec<String> = star.polygons.iter().map(|polygon| polygon_sentence(engine, star, polygon)).collect();
    format!("{turned}{}", sentences.join(" "))
}

fn polygon_sentence(engine: &Engine, star: &Star, polygon: &Polygon) -> String {
    let corners: Vec<&Ray> = (0..polygon.sides)
        .filter_map(|j| {
            let angle = Turn::new(&polygon.rotation + BigRational::new(j.into(), polygon.sides.into()));
            star.rays.iter().find(|ray| ray.angle == angle)
        })
        .collect();
    let shape = typeset::polygon_name(polygon.sides);
    let whole = corners.iter().all(|ray| ray.total() == polygon.weight);
    if whole && polygon.weight.is_one() && corners.iter().all(|ray| ray.members.len() == 1) {
        let mut corners = corners;
        corners.sort_by_key(|ray| ray.members[0].0);
        let names: Vec<String> = corners.iter().map(|ray| ray.names(engine)).collect();
        return format!("Vectors {} are {}, so they sum to zero.", listed(&names), corners_of(polygon.sides, &shape));
    }
    let places: Vec<String> =
        corners.iter().map(|ray| format!("{} ({})", typeset::angle(&ray.angle), ray.names(engine))).collect();
    let weight = typeset::number(&polygon.weight);
    let share = if whole { format!("{weight} long each") } else { format!("taken {weight} long each") };
    format!("The vectors at {}, {share}, are {} and sum to zero.", listed(&places), corners_of(polygon.sides, &shape))
}

fn corners_of(sides: u64, shape: &str) -> String {
    if sides == 2 { shape.to_owned() } else { format!("the corners of {shape}") }
}

fn listed(items: &[String]) -> String {
    match items {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// The numbers of the certificate, as `classify --json` holds them.
pub(super) fn certificate(verdict: &Verdict) -> Text {
    Text::phrase(certificate_of(&verdict.sum, &verdict.certificate), Vec::new())
}

/// The numbers of the certificate of any sum.
pub(super) fn certificate_of(sum: &PhasorSum, certificate: &Certificate) -> String {
    match certificate {
        Certificate::Polygons { polygons } if polygons.is_empty() => {
            "Certificate: no polygon is needed, the collected sum is empty.".to_owned()
        }
        Certificate::Polygons { polygons } => {
            let one = |p: &Polygon| format!("({}; {}; {})", p.sides, fraction(&p.rotation), fraction(&p.weight));
            let list: Vec<String> = polygons.iter().map(one).collect();
            format!("Certificate, polygons as (sides; turn of a corner; weight): {}.", list.join(", "))
        }
        Certificate::Residue(residue) => residue_sentence(&sum.collected(), residue),
        Certificate::Splitting { steps } => splitting_sentence(steps),
    }
}

fn fraction(value: &BigRational) -> String {
    value.to_string().replace('-', "−")
}

fn residue_sentence(collected: &[Term], claim: &Residue) -> String {
    let Residue { conductor, prime, root, scale, residue } = claim;
    if conductor.is_one() {
        // Every vector lies at angle 0: the sum is a number.
        return format!(
            "Certificate: times {scale} the sum is a whole number that is {residue} modulo {prime}, so it is not zero."
        )
        .replace("times 1 the sum", "the sum");
    }
    let map = format!("$e^{{2\\pi i/{conductor}}} \\mapsto {root}$");
    let times = if scale.is_one() { String::new() } else { format!(", {scale} times over,") };
    let sum = if collected.len() <= MOST_TERMS_WRITTEN { written_sum(collected, claim) } else { "S".to_owned() };
    format!(
        "Certificate: modulo the prime {prime} the powers of {root} repeat after {conductor}, so {map} maps sums to sums. The \
         collected sum{times} becomes ${sum} \\equiv {residue} \\not\\equiv 0 \\pmod{{{prime}}}$."
    )
}

fn written_sum(collected: &[Term], claim: &Residue) -> String {
    let term = |(index, term): (usize, &Term)| {
        let weight = (&term.weight * BigRational::from_integer(claim.scale.clone())).to_integer();
        let exponent = (term.angle.turns() * BigRational::from_integer(claim.conductor.clone())).to_integer();
        let exponent: BigInt = exponent.mod_floor(&claim.conductor);
        let sign = match (weight.is_negative(), index) {
            (true, _) => "-",
            (false, 0) => "",
            (false, _) => "+",
        };
        let factor = if weight.abs().is_one() { String::new() } else { format!("{}\\cdot ", weight.abs()) };
        format!("{sign}{factor}{}^{{{exponent}}}", claim.root)
    };
    collected.iter().enumerate().map(term).collect()
}

fn splitting_sentence(steps: &[Step]) -> String {
    let step = |step: &Step| match step {
        Step::Class { angle, modulus } => {
            format!(
                "the vectors at {} of a turn plus multiples of 1/{modulus} must sum to zero by themselves",
                fraction(angle)
            )
        }
        Step::Compare { prime, first, second } => {
            format!(
                "the classes {first} and {second} of the prime {prime} must be equal, so their difference must be zero"
            )
        }
    };
    let list: Vec<String> = steps.iter().map(step).collect();
    format!(
        "Certificate: if the sum were zero, then {}; but one vector is left, and it is not zero.",
        list.join("; of these, ")
    )
}
