//! Are lengths and directions in closed form the numbers that they stand for?

use crate::support::dice::Dice;
use crate::support::{decimals, whole_degrees};
use crankstar::engine::Engine;
use crankstar::exact::{PhasorSum, Turn};
use crankstar::file;
use crankstar::numbers::{self, Budget, Direction, Form};
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use num_bigint::BigInt;
use num_rational::BigRational;

/// The catalogue, and in-line engines whose stars lead to cubic and quintic fields.
fn engines() -> Vec<(String, Engine)> {
    let catalogue = file::catalogue().expect("the catalogue reads").into_iter();
    // A star of a link is made of many vectors of uneven lengths.
    let catalogue = catalogue.filter(|(_, engine)| !engine.has_links());
    let odd = [("I7", "1-3-5-7-6-4-2"), ("I9", "1-3-5-7-9-8-6-4-2"), ("I11", "1-3-5-7-9-11-10-8-6-4-2")];
    let odd = odd.map(|(name, order)| {
        let text = format!("cycle = 'four-stroke'\nfiring_order = '{order}'\n[inline]");
        (name.to_owned(), file::parse(name, &text).expect("it reads"))
    });
    catalogue.map(|(entry, layout)| (entry.name.to_owned(), layout)).chain(odd).collect()
}

/// Every sum of these engines that does not vanish.
fn sums() -> Vec<(String, PhasorSum)> {
    let mut sums = Vec::new();
    for (name, layout) in engines() {
        for order in [1, 2, 4, 6, 8, 10] {
            for quantity in [Quantity::FORCE, Quantity::MOMENT] {
                for sense in [Sense::Direct, Sense::Reverse] {
                    let sum = order::star(&layout, quantity, order, Some(sense));
                    if !sum.vanishes() {
                        sums.push((format!("{name}, {} {order} {}", quantity.name(), sense.name()), sum));
                    }
                }
            }
        }
    }
    sums
}

#[test]
fn every_length_agrees_with_its_sum_to_fifty_digits_and_its_text_reads_back() {
    let sums = sums();
    assert!(sums.len() > 250);
    for (name, sum) in sums {
        let length = numbers::modulus(&sum).unwrap_or_else(|| panic!("{name} has no closed form"));
        assert!(decimals::agree(&decimals::form(&length), &decimals::modulus(&sum)), "{name}: {length}");
        assert_eq!(Form::parse(&length.to_string()).as_ref(), Some(&length), "{name}: {length}");
    }
}

#[test]
fn every_direction_agrees_with_its_sum_to_fifty_digits() {
    let mut kinds = [0, 0, 0];
    for (name, sum) in sums() {
        let (re, im) = decimals::sum(&sum);
        match numbers::direction_of(&sum) {
            Some(Direction::Turn(turn)) => {
                let (cos, sin) = decimals::cos_sin(&turn);
                assert!(decimals::agree(&(&re * &sin / decimals::one()), &(&im * &cos / decimals::one())), "{name}");
                assert!((&re * &cos + &im * &sin) > BigInt::from(0), "{name} points the other way");
                kinds[0] += 1;
            }
            Some(Direction::Arctangent { tangent, opposite }) => {
                let tangent = decimals::form(&tangent);
                assert!(decimals::agree(&(&re * &tangent / decimals::one()), &im), "{name}");
                assert_eq!(re < BigInt::from(0), opposite, "{name}");
                kinds[1] += 1;
            }
            Some(Direction::Turned { by, tangent }) => {
                let (cos, sin) = decimals::cos_sin(&by);
                // Turned back, the direction is an arctangent.
                let one = decimals::one();
                let [back_re, back_im] = [(&re * &cos + &im * &sin) / &one, (&im * &cos - &re * &sin) / &one];
                let tangent = decimals::form(&tangent);
                assert!(back_re > BigInt::from(0), "{name} points the other way");
                assert!(decimals::agree(&(&back_re * &tangent / &one), &back_im), "{name}");
                kinds[1] += 1;
            }
            None => kinds[2] += 1,
        }
    }
    assert!(kinds[0] > 200 && kinds[1] > 10, "{kinds:?}");
}

#[test]
fn known_lengths_are_printed_as_a_book_would() {
    let length = |engine: &str, quantity, order, sense| {
        let layout = file::find(engine).expect("in the catalogue").engine().expect("it reads");
        numbers::modulus(&order::star(&layout, quantity, order, Some(sense))).expect("small").to_string()
    };
    assert_eq!(length("I3", Quantity::MOMENT, 1, Sense::Direct), "√3");
    assert_eq!(length("V8-crossplane", Quantity::MOMENT, 1, Sense::Direct), "2√10");
    assert_eq!(length("V8-crossplane", Quantity::FORCE, 4, Sense::Direct), "4√2");
    assert_eq!(length("I5-12453", Quantity::MOMENT, 1, Sense::Direct), "√(50 − 22√5)/2");
    assert_eq!(length("V6-90-split", Quantity::MOMENT, 1, Sense::Direct), "(3√2 + √6)/2");
    assert_eq!(length("I6-two-stroke", Quantity::MOMENT, 2, Sense::Direct), "2√3");
}

#[test]
fn the_moment_plane_of_the_cross_plane_v8_is_minus_arctan_one_third() {
    let v8 = file::find("V8-crossplane").expect("in the catalogue").engine().expect("it reads");
    let sum = order::star(&v8, Quantity::MOMENT, 1, Some(Sense::Direct));
    let third = Form::rational(BigRational::new((-1).into(), 3.into()));
    assert_eq!(numbers::direction_of(&sum), Some(Direction::Arctangent { tangent: third, opposite: false }));
}

#[test]
fn forms_are_read_as_a_person_writes_them() {
    for (written, printed) in [
        ("sqrt(12)", "2√3"),
        ("√3/2", "√3/2"),
        ("½√3(√3−1)", "(3 − √3)/2"),
        ("√(5−2√5)", "√(5 − 2√5)"),
        ("√(6+3√3)", "(3√2 + √6)/2"),
        ("-√10", "−√10"),
        ("2*3·√2", "6√2"),
        ("1.5", "3/2"),
        ("3·cos(40°)", "3·cos(40°)"),
        ("√0", "0"),
        ("cos(1°)cos(2°)", "cos(1°)·cos(2°)"),
        ("cos(36°)·sin(36°)", "cos(18°)/2"),
        ("√5·cos(20°)·cos(10°)·sin(10°)", "√5·sin(40°)/4"),
        ("cos(1°)cos(1°)", "cos²(1°)"),
        ("sin²(4.5°)cos²(1°)cos(1°)", "cos³(1°)·sin²(4.5°)"),
        ("cos⁴(1°)", "cos⁴(1°)"),
        ("−1 + √5", "√5 − 1"),
        ("−√2 − 1", "−1 − √2"),
        ("sin²(30°)", "1/4"),
        ("2*sqrt(3)*sin(4.5°)", "2√3·sin(4.5°)"),
        ("3·cos(60°)", "3/2"),
    ] {
        assert_eq!(Form::parse(written).expect(written).to_string(), printed);
    }
    for wrong in ["", "√", "2√", "√-1", "√(1−√2)", "1/√2", "cos(40)", "(1", "1)", "1/0", "x", "tan(1°)"]
    {
        assert_eq!(Form::parse(wrong), None, "{wrong}");
    }
    let deep = "(".repeat(10_000) + "1" + &")".repeat(10_000);
    assert_eq!(Form::parse(&deep), None);
    assert_eq!(Form::parse(&"√".repeat(100_000)), None);
}

#[test]
fn closed_forms_stop_at_conductor_1000() {
    let unit = |turn: Turn| crankstar::exact::Term { angle: turn, weight: BigRational::from_integer(1.into()) };
    let sum = |n: i64| PhasorSum::new(vec![unit(Turn::zero()), unit(Turn::fraction(1, n))]);
    assert!(numbers::modulus(&sum(1000)).is_some());
    assert!(numbers::modulus(&sum(1001)).is_none());
}

/// Every length that two random engines of each form leave, with what its search spent.
fn random_lengths(mut look: impl FnMut(&PhasorSum, Option<Form>, (u32, u32))) {
    let mut dice = Dice::new(7);
    for form in whole_degrees::FORMS.iter().cycle().take(2 * whole_degrees::FORMS.len()) {
        let layout = file::parse("random", &whole_degrees::file(&mut dice, form, 24)).expect("it reads");
        for (quantity, sense) in [(Quantity::FORCE, Sense::Direct), (Quantity::MOMENT, Sense::Reverse)] {
            for order in [1, 2, 4] {
                let sum = order::star(&layout, quantity, order, Some(sense));
                if !sum.vanishes() {
                    let mut budget = Budget::new();
                    let length = numbers::modulus_within(&sum, &mut budget);
                    look(&sum, length, budget.spent());
                }
            }
        }
    }
}

#[test]
fn lengths_of_random_engines_stay_within_the_budget_and_agree_to_fifty_digits() {
    let (mut found, mut all) = (0, 0);
    random_lengths(|sum, length, (tests, proposals)| {
        assert!(tests <= Budget::TESTS && proposals <= Budget::PROPOSALS);
        all += 1;
        if let Some(length) = length {
            found += 1;
            assert!(decimals::agree(&decimals::form(&length), &decimals::modulus(sum)), "{length}");
            assert_eq!(Form::parse(&length.to_string()).as_ref(), Some(&length), "{length}");
        }
    });
    assert!(found > all / 3, "{found} of {all}");
}

#[test]
fn a_search_for_a_form_takes_the_same_steps_each_time() {
    let run = || {
        let mut lengths = Vec::new();
        random_lengths(|_, length, spent| lengths.push((length, spent)));
        lengths
    };
    assert_eq!(run(), run());
}

#[test]
fn a_spent_budget_ends_in_no_form() {
    let mut budget = Budget::new();
    let layout = file::parse("i8", "[inline]\nthrows = [0, 11, 47, 101, 190, 222, 251, 333]").expect("it reads");
    let sum = order::star(&layout, Quantity::MOMENT, 1, Some(Sense::Direct));
    while numbers::modulus_within(&sum, &mut budget).is_some() || budget.spent().1 + 1000 < Budget::PROPOSALS {
        let before = budget.spent();
        numbers::modulus_within(&sum, &mut budget);
        if budget.spent() == before {
            break;
        }
    }
    assert!(budget.spent().0 <= Budget::TESTS && budget.spent().1 <= Budget::PROPOSALS);
    assert_eq!(numbers::modulus_within(&sum, &mut budget), None);
}

#[test]
fn a_bank_factor_is_found_at_any_bank_angle() {
    let text = "[vee]\nbank_angle = 77\nthrows = [0, 72, 144, 216, 288]";
    let layout = file::parse("V10", text).expect("it reads");
    let sum = order::star(&layout, Quantity::MOMENT, 1, Some(Sense::Direct));
    let length = numbers::modulus(&sum).expect("a form");
    assert!(decimals::agree(&decimals::form(&length), &decimals::modulus(&sum)), "{length}");
}
