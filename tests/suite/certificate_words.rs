//! Do the numbers that a page prints of a certificate recompute: the sum in angles, and its image modulo the prime?

use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::page::{Format, Math, text_in};
use crankstar::proof::Certificate;
use crankstar::report::verdict_certificate;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

use crate::support::every_verdict::{all_engines, all_verdicts};
use crate::true_sentences::said;

/// `9\,e^{i\,40^{\circ}}` and the like.
fn read_sum(text: &str) -> PhasorSum {
    let spaced = text.replace(" - ", " + -");
    let number = |text: &str| -> BigRational {
        let text = text.replace("\\tfrac{", "").replace("}{", "/").replace('}', "");
        match text.split_once('.') {
            Some((whole, places)) => {
                let scale = BigInt::from(10).pow(places.len() as u32);
                BigRational::new(format!("{whole}{places}").parse().expect("digits"), scale)
            }
            None => text.parse().expect("a fraction"),
        }
    };
    let term = |text: &str| {
        let (sign, text) = text.strip_prefix('-').map_or((1, text), |rest| (-1, rest));
        let (weight, angle) = text.split_once("e^{i\\,").expect("a vector");
        let angle = angle.trim_end_matches("^{\\circ}}").trim_start_matches('(').trim_end_matches(')');
        let weight = if weight.is_empty() { BigRational::one() } else { number(weight.trim_end_matches("\\,")) };
        Term { angle: Turn::from_degrees(&number(angle)), weight: weight * BigRational::from_integer(sign.into()) }
    };
    PhasorSum::new(spaced.split(" + ").map(term).collect())
}

/// `2\cdot 3^{4} - 3^{1}` modulo a prime.
fn read_image(text: &str, prime: &BigInt) -> BigInt {
    let spaced = text.replace(" - ", " + -");
    let term = |text: &str| -> BigInt {
        let (sign, text) = text.strip_prefix('-').map_or((1, text), |rest| (-1, rest));
        let (factor, power) = text.split_once("\\cdot ").unwrap_or(("1", text));
        let (base, exponent) = power.split_once("^{").expect("a power");
        let exponent: BigInt = exponent.trim_end_matches('}').parse().expect("an exponent");
        let base: BigInt = base.parse().expect("a base");
        factor.parse::<BigInt>().expect("a factor") * base.modpow(&exponent, prime) * sign
    };
    spaced.split(" + ").map(term).sum::<BigInt>().mod_floor(prime)
}

#[test]
fn a_residue_certificate_prints_the_sum_and_its_image_and_both_recompute() {
    let mut printed = 0;
    for engine in all_engines().into_iter().step_by(3) {
        for verdict in all_verdicts(&engine) {
            let Certificate::Residue(claim) = &verdict.certificate else { continue };
            let text = text_in(&verdict_certificate(&verdict), Format::Markdown(Math::Dollars));
            let formula = |start: &str| {
                let rest = text.split_once(start)?.1;
                Some(rest.split_once('$')?.0.to_owned())
            };
            if let Some(sum) = formula("$S = ") {
                assert_eq!(read_sum(&sum).collected(), verdict.sum.collected(), "{text}");
                if let Some(image) = formula("S \\mapsto ") {
                    let image = image.split(" \\equiv").next().expect("an image").to_owned();
                    assert_eq!(read_image(&image, &claim.prime), claim.residue, "{text}");
                    printed += 1;
                }
            } else {
                assert!(text.contains("The collected sum $S$ has "), "{text}");
            }
        }
    }
    assert!(printed > 100, "only {printed}");
}

/// A single vector needs no step that splits the sum.
#[test]
fn the_certificate_of_one_vector_has_no_empty_clause() {
    let one = "inline = { throws = ['0.12345'] }\n";
    let told = said("report", one, &["--orders", "1", "--format", "text"]);
    assert!(told.contains("It is one vector, and it is not zero.") && !told.contains("then ;"), "{told}");
    let three = "inline = { throws = [0, '100.00001', 200] }\n";
    let told = said("report", three, &["--orders", "1", "--format", "text", "--lang", "de"]);
    assert!(told.contains("Wäre sie null, so müsste gelten: "), "{told}");
}
