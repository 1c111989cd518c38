//! Which numbers does a certificate hold, and of which sum? As `classify --json` holds them.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::super::typeset;
use super::sums::{MOST_IN_LIST, image_tex, sum_tex, vectors};
use crate::exact::{PhasorSum, Term};
use crate::page::Text;
use crate::proof::{Certificate, Polygon, Residue, Step};
use crate::report::texts::argument as text;
use crate::verdict::Verdict;

/// The numbers of the certificate of a verdict.
pub fn certificate(verdict: &Verdict) -> Text {
    certificate_of(&verdict.sum, &verdict.certificate)
}

/// The numbers of the certificate of any sum.
pub(in crate::report) fn certificate_of(sum: &PhasorSum, certificate: &Certificate) -> Text {
    let collected = sum.collected();
    match certificate {
        Certificate::Polygons { polygons } if polygons.is_empty() => text::no_polygon(),
        Certificate::Polygons { polygons } => of_polygons(polygons),
        Certificate::Residue(residue) => of_residue(&collected, residue),
        Certificate::Splitting { steps } => of_splitting(&collected, steps),
    }
}

fn of_polygons(polygons: &[Polygon]) -> Text {
    let list = listed_polygons(polygons);
    match polygons.iter().any(|polygon| polygon.weight.is_negative()) {
        false => text::polygons(list),
        true => text::polygons_subtracted(list),
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
        Some(sum) => text::sum(Text::formula(format!("S = {sum}"))),
        None if collected.len() <= MOST_IN_LIST => text::sum_of_vectors(vectors(collected)),
        None => text::sum_of_many(collected.len()),
    }
}

fn of_residue(collected: &[Term], claim: &Residue) -> Text {
    let Residue { conductor, prime, root, scale, residue } = claim;
    if conductor.is_one() {
        // Every vector lies at angle 0: the sum is a number.
        let (residue, prime) = (residue.to_string(), prime.to_string());
        return match scale.is_one() {
            true => text::whole_number(the_sum(collected), residue, prime),
            false => text::times_whole_number(the_sum(collected), scale.to_string(), residue, prime),
        };
    }
    let map = Text::formula(format!("e^{{2\\pi i/{conductor}}} \\mapsto {root}"));
    let times = if scale.is_one() { "S".to_owned() } else { format!("{scale}\\,S") };
    let not_zero = format!("\\equiv {residue} \\not\\equiv 0 \\pmod{{{prime}}}");
    let of = [prime, root, conductor].map(|number| Text::label(number.to_string()));
    let [prime_text, root_text, conductor_text] = of;
    match image_tex(collected, scale, conductor, root) {
        Some(image) => text::image(
            the_sum(collected),
            prime_text,
            root_text,
            conductor_text,
            map,
            Text::formula(format!("{times} \\mapsto {image} {not_zero}")),
        ),
        None => text::long_image(
            the_sum(collected),
            prime_text,
            root_text,
            conductor_text,
            map,
            Text::formula(format!("w \\cdot {root}^{{{conductor}\\,t/360^\\circ}}")),
            Text::formula(format!("{times} \\mapsto {}", not_zero.trim_start_matches("\\equiv "))),
        ),
    }
}

fn of_splitting(collected: &[Term], steps: &[Step]) -> Text {
    let step = |step: &Step| match step {
        Step::Class { angle, modulus } => text::class(fraction(angle), modulus.to_string()),
        Step::Compare { prime, first, second } => {
            text::classes(first.to_string(), second.to_string(), prime.to_string())
        }
    };
    if steps.is_empty() {
        return text::lone_vector(the_sum(collected));
    }
    text::splitting(the_sum(collected), Text::joined(steps.iter().map(step), "; of these, "))
}
