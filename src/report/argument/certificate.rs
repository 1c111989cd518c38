//! Which numbers does a certificate hold, and of which sum? As `classify --json` holds them.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::super::typeset;
use super::sums::{MOST_IN_LIST, image_tex, sum_tex, vectors};
use crate::exact::{PhasorSum, Term};
use crate::page::{Text, phrase};
use crate::proof::{Certificate, Polygon, Residue, Step};
use crate::verdict::Verdict;

/// The numbers of the certificate of a verdict.
pub fn certificate(verdict: &Verdict) -> Text {
    certificate_of(&verdict.sum, &verdict.certificate)
}

/// The numbers of the certificate of any sum.
pub(in crate::report) fn certificate_of(sum: &PhasorSum, certificate: &Certificate) -> Text {
    let collected = sum.collected();
    match certificate {
        Certificate::Polygons { polygons } if polygons.is_empty() => {
            "No polygon is needed, the collected sum is empty.".into()
        }
        Certificate::Polygons { polygons } => of_polygons(polygons),
        Certificate::Residue(residue) => of_residue(&collected, residue),
        Certificate::Splitting { steps } => of_splitting(&collected, steps),
    }
}

fn of_polygons(polygons: &[Polygon]) -> Text {
    let list = listed_polygons(polygons);
    match polygons.iter().any(|polygon| polygon.weight.is_negative()) {
        false => phrase!("Polygons as (sides; turn of a corner; weight): {}.", list),
        true => phrase!(
            "Polygons as (sides; turn of a corner; weight): {}. A negative weight subtracts a polygon; if its number of sides is odd, that equals adding it turned by half a turn.",
            list
        ),
    }
}

/// `(3; 0; 1), (2; 1/4; 1)`: sides, turn of a corner, weight.
pub(in crate::report) fn listed_polygons(polygons: &[Polygon]) -> String {
    let one = |p: &Polygon| format!("({}; {}; {})", p.sides, fraction(&p.rotation), fraction(&p.weight));
    typeset::listed(polygons.iter().map(one))
}

fn fraction(value: &BigRational) -> String {
    value.to_string().replace('-', "−")
}

/// The sum that is reduced.
fn the_sum(collected: &[Term]) -> Text {
    match sum_tex(collected) {
        Some(sum) => phrase!("The collected sum is {}.", Text::formula(format!("S = {sum}"))),
        None if collected.len() <= MOST_IN_LIST => {
            phrase!("The collected sum $S$ has the vectors {}.", vectors(collected))
        }
        None => phrase!("The collected sum $S$ has {} vectors.", collected.len()),
    }
}

fn of_residue(collected: &[Term], claim: &Residue) -> Text {
    let Residue { conductor, prime, root, scale, residue } = claim;
    if conductor.is_one() {
        // Every vector lies at angle 0: the sum is a number.
        let (residue, prime) = (residue.to_string(), prime.to_string());
        return match scale.is_one() {
            true => phrase!(
                "{} It is a whole number that is {} modulo {}, so it is not zero.",
                the_sum(collected),
                residue,
                prime
            ),
            false => phrase!(
                "{} Times {} it is a whole number that is {} modulo {}, so it is not zero.",
                the_sum(collected),
                scale.to_string(),
                residue,
                prime
            ),
        };
    }
    let map = Text::formula(format!("e^{{2\\pi i/{conductor}}} \\mapsto {root}"));
    let times = if scale.is_one() { "S".to_owned() } else { format!("{scale}\\,S") };
    let not_zero = format!("\\equiv {residue} \\not\\equiv 0 \\pmod{{{prime}}}");
    let of = [prime, root, conductor].map(|number| Text::label(number.to_string()));
    let [prime_text, root_text, conductor_text] = of;
    match image_tex(collected, scale, conductor, root) {
        Some(image) => phrase!(
            "{} Modulo the prime {} the powers of {} repeat after {}, so {} maps sums to sums: {}.",
            the_sum(collected),
            prime_text,
            root_text,
            conductor_text,
            map,
            Text::formula(format!("{times} \\mapsto {image} {not_zero}"))
        ),
        None => phrase!(
            "{} Modulo the prime {} the powers of {} repeat after {}, so {} maps sums to sums. A vector of weight \
             $w$ at the angle $t$ becomes {}; added up, {}.",
            the_sum(collected),
            prime_text,
            root_text,
            conductor_text,
            map,
            Text::formula(format!("w \\cdot {root}^{{{conductor}\\,t/360^\\circ}}")),
            Text::formula(format!("{times} \\mapsto {}", not_zero.trim_start_matches("\\equiv ")))
        ),
    }
}

fn of_splitting(collected: &[Term], steps: &[Step]) -> Text {
    let step = |step: &Step| match step {
        Step::Class { angle, modulus } => phrase!(
            "the vectors at {} of a turn plus multiples of 1/{} must sum to zero by themselves",
            fraction(angle),
            modulus.to_string()
        ),
        Step::Compare { prime, first, second } => phrase!(
            "the classes {} and {} of the prime {} must be equal, so their difference must be zero",
            first.to_string(),
            second.to_string(),
            prime.to_string()
        ),
    };
    phrase!(
        "{} If it were zero, then {}; but one vector remains, and it is not zero.",
        the_sum(collected),
        Text::joined(steps.iter().map(step), "; of these, ")
    )
}
