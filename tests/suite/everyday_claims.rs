//! Are everyday sentences and Fourier series read as they are meant, and asked about where they may mean two things?

use crankstar::claim::{self, Answer, Finding, Predicate, Statement, Status, TermVerdict, Value, parse_statement};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::page::{Language, Text};
use crankstar::report;

use crate::support::class::vectors;
use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::german::{has_words, phrases};

fn engine(text: &str) -> Engine {
    match file::find(text) {
        Some(entry) => entry.engine().expect("it reads"),
        None => file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}")),
    }
}

fn answer(layout: &str, says: &str) -> Answer {
    let statement = parse_statement(says).unwrap_or_else(|error| panic!("{says}: {error:?}"));
    claim::answer(&engine(layout), &statement, None)
}

fn verdicts(answer: &Answer) -> Vec<(u32, bool, TermVerdict)> {
    match &answer.finding {
        Finding::Terms { terms, .. } => {
            terms.iter().map(|term| (term.wave.order, term.wave.is_sine, term.verdict)).collect()
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn everyday_sentences_say_what_the_words_of_the_readme_say() {
    for (canonical, sentences) in [
        (
            "second-order force vanishes",
            vec![
                "F2 = 0",
                "F_2=0",
                "F₂ = 0",
                "F2 vanishes",
                "force of order 2 vanishes",
                "the forces of second order cancel",
                "no second-order shaking force",
                "There is no second-order force.",
                "the engine has no secondary forces",
                "the second-order force vanishes",
                "secondary forces are balanced",
                "secondary force is zero",
                "no unbalanced 2nd-order inertia force",
                "no second-order force remains",
                "second-order force doesn't remain",
                "the shaking force at order 2 equals zero",
            ],
        ),
        (
            "second-order force does not vanish",
            vec![
                "F2 ≠ 0",
                "F2 != 0",
                "the second-order force is not balanced",
                "secondary forces are unbalanced",
                "there is a second-order force",
                "an unbalanced secondary force remains",
            ],
        ),
        (
            "first-order moment vanishes",
            vec!["M1 = 0", "C_{1} = 0", "no primary couple", "the primary moment is balanced"],
        ),
        ("first-order moment = √3", vec!["M1 = √3", "M_1 = sqrt(3)"]),
        ("second-order direct force vanishes", vec!["F2⁺ = 0", "F_2^+ = 0", "the direct force of order 2 cancels"]),
        (
            "orders 1 and 2 of the force vanish",
            vec![
                "F1 = F2 = 0",
                "primary and secondary forces are balanced",
                "no first- or second-order forces",
                "no force of orders 1 or 2",
                "no force of order 1 and no force of order 2",
                "no first-order and no second-order force",
                "first-order force and second-order force vanish",
                "first-order force vanishes and second-order force vanishes",
                "forces of orders 1 and 2 cancel",
            ],
        ),
        (
            "orders 2 vanish",
            vec![
                "F2 = M2 = 0",
                "second-order forces and moments are balanced",
                "no secondary force or couple",
                "neither a second-order force nor a second-order moment",
                "at order 2 there is no force or moment",
                "no force and no moment of order 2",
            ],
        ),
        ("every order of the force vanishes", vec!["no force of any order", "forces of all orders vanish"]),
        (
            "every order of the moment vanishes",
            vec![
                "the first, second and all higher orders of the moment vanish",
                "first and higher orders of the moment vanish",
                "no moments of first and higher order",
                "no moment of order 1 or higher",
                "moments of order 1 and higher vanish",
            ],
        ),
        (
            "every higher order of the moment vanishes",
            vec!["no moment of order 2 or higher", "second and higher orders of the moment vanish"],
        ),
    ] {
        let meant = parse_statement(canonical).expect(canonical);
        for sentence in sentences {
            assert_eq!(parse_statement(sentence).as_ref(), Ok(&meant), "{sentence}");
        }
    }
}

#[test]
fn a_sentence_that_may_mean_two_things_is_asked_about_and_others_are_not_read() {
    for sentence in [
        "the second order vanishes",
        "order 2 is balanced",
        "the force vanishes",
        "no shaking force",
        "no second-order force vanishes",
        "second-order forces and moments do not vanish",
        "primary and secondary forces are unbalanced",
        "no free second-order moment",
        "no second-order torque",
        "the direct force and moment of order 2 vanish",
        "F1 = M2 = 0",
    ] {
        let told = parse_statement(sentence).expect_err(sentence);
        assert!(
            told.message.contains("two things") && told.right.contains('"')
                || told.right.contains("such as")
                || told.right.contains("claim it"),
            "{sentence}: {told:?}"
        );
    }
    for sentence in [
        "second-order farce vanishes",
        "the engine is perfectly smooth",
        "F2 is small",
        "second-order force is larger than the first",
        "second force vanishes",
        "F2 ≠ 3",
        "forces",
    ] {
        assert!(parse_statement(sentence).is_err(), "{sentence}");
    }
}

/// None of these says one thing of all its orders and quantities.
#[test]
fn a_sentence_that_says_several_things_is_asked_to_be_divided() {
    for sentence in [
        "the engine has no primary force and an unbalanced secondary couple",
        "no first-order force and a second-order couple",
        "has no first-order force, a second-order force remains",
        "unbalanced second-order force and no first-order force",
        "first-order force exists and second-order force does not exist",
        "the first-order moment remains, the second-order moment does not",
        "first-order force vanishes, second-order force does not",
        "a second-order force without a second-order moment",
        "there is a second-order force and no second-order moment",
        "the engine has a second-order force and no moment",
        "no forces of orders 1, 2 and 4 and a force of order 6",
        "unbalanced second-order force and balanced first-order force",
        "no first-order, an unbalanced second-order force",
        "first and no second-order force",
        "first-order force and second-order moment vanish",
        "first-order force vanishes and second-order moment vanishes",
        "no second-order force and no first-order moment",
        "no second-order force or first-order moment",
        "first-order force and higher orders vanish",
        "every order of the force and the second-order moment vanish",
        "second-order force and higher moments vanish",
        "the second-order force and the direct force vanish",
        "the force and the first-order moment vanish",
        "primary or secondary forces vanish",
        "forces of orders 1 or 2 vanish",
        "second-order force exists or second-order moment exists",
        "third and higher orders of the force vanish",
        // Order 3 of a pin offset is in neither.
        "second, fourth and higher orders of the force vanish",
        "first, second, fourth and higher orders of the force vanish",
        "the first, fourth and higher orders of the force vanish",
    ] {
        let told = parse_statement(sentence).expect_err(sentence);
        assert!(told.message.contains("two things") && told.right.contains("such as"), "{sentence}: {told:?}");
    }
}

#[test]
fn orders_named_beside_the_higher_ones_are_claimed_too() {
    // The couple of order 1 is √10, those above it vanish.
    for says in ["first and higher orders of the moment vanish", "no moment of order 1 or higher"] {
        assert_eq!(answer("V8-crossplane", says).status, Status::False, "{says}");
    }
    assert!(answer("V8-crossplane", "no moment of order 2 or higher").status.holds());
}

#[test]
fn numbers_of_a_series_are_as_exact_as_they_are_written() {
    // c_2 is 0.25088, and 1.0035 for four.
    let [one, four] = [1, 4].map(|count| format!("mechanism.rod_ratio = 0.247\ninline.throws = {:?}", vec![0; count]));
    for (layout, number, expected) in [
        (&one, "1/4", TermVerdict::Wrong),
        (&one, "0.25", TermVerdict::Rounded),
        (&one, "0.250", TermVerdict::Wrong),
        (&one, "0.251", TermVerdict::Rounded),
        (&one, "0.247", TermVerdict::UpTo(1)),
        (&one, "λ", TermVerdict::UpTo(1)),
        (&one, "1.0 λ", TermVerdict::UpTo(1)),
        (&one, "1.02 λ", TermVerdict::Rounded),
        (&one, "51/50 λ", TermVerdict::Wrong),
        (&four, "", TermVerdict::Wrong),
        (&four, "1", TermVerdict::Wrong),
        (&four, "1/1", TermVerdict::Wrong),
        (&four, "1.0", TermVerdict::Rounded),
        (&four, "1.00", TermVerdict::Rounded),
        (&four, "1.000", TermVerdict::Wrong),
        (&four, "1.003", TermVerdict::Wrong),
        (&four, "1.004", TermVerdict::Rounded),
        // Rounded to 0.001, and four of them to 0.004.
        (&four, "4 · 0.250", TermVerdict::Wrong),
        (&four, "4 · 0.251", TermVerdict::Rounded),
        (&four, "4 · 0.252", TermVerdict::Wrong),
        (&four, "4 / 4.0", TermVerdict::Wrong),
    ] {
        let says = format!("F = m r ω² ({} cos θ + {number} cos 2θ)", if *layout == one { 1 } else { 4 });
        assert_eq!(verdicts(&answer(layout, &says))[1].2, expected, "{says}");
    }
}

#[test]
fn decimals_of_an_irrational_multiple_of_the_rod_ratio_are_rounded() {
    let vee = "mechanism.rod_ratio = 0.25\nvee = { bank_angle = 60, throws = [0] }";
    for (number, expected) in [
        ("√3/2", TermVerdict::UpTo(1)),
        ("0.866", TermVerdict::Rounded),
        ("0.87", TermVerdict::Rounded),
        ("0.867", TermVerdict::Wrong),
        ("433/500", TermVerdict::Wrong),
    ] {
        let says = format!("shaking force along = m r ω² (1.5 cos θ + {number} λ cos 2θ)");
        assert_eq!(verdicts(&answer(vee, &says))[1].2, expected, "{says}");
    }
}

/// The second-order vectors of both throws are opposite, so that a force is left nowhere but the moment is that of a couple.
#[test]
fn a_moment_that_is_0_about_one_plane_alone_is_said_to_be_so() {
    let twin = "inline.throws = [0, 180]";
    for says in ["second-order moment = 0", "second-order moment vanishes"] {
        let status = answer(twin, says).status;
        assert!(matches!(status, Status::TrueOnlyIf { met: true, .. }), "{says}: {status:?}");
    }
}

/// c_10 of λ = 1/4 is 4·10⁻⁸: nothing is proposed, and both vectors are there, of different lengths.
#[test]
fn vectors_too_slight_for_a_weight_are_needed_all_the_same() {
    let vee = "mechanism.rod_ratio = 0.25\nvee = { bank_angle = 70, throws = [0] }";
    for (needs, expected) in
        [("nothing", Status::False), ("two balancer shafts", Status::True), ("a Lanchester pair", Status::NotDecided)]
    {
        let answer = answer(vee, &format!("order 10 needs {needs}"));
        assert_eq!(answer.status, expected, "{needs}");
    }
}

#[test]
fn a_series_is_compared_term_by_term() {
    use TermVerdict::{Missing, NoRatio, Right, Rounded, UpTo, Wrong, WrongUnit};
    let two = "inline.throws = [0, 0]";
    let quarter = "mechanism.rod_ratio = 0.25\ninline.throws = [0, 0]";
    let turned = "inline.throws = [0, 90]";
    let yoke = "mechanism.scotch_yoke = true\ninline.throws = [0, 0]";
    for (layout, says, status, expected) in [
        (two, "F = 2 m r w^2 (cos(θ) + λ cos 2θ)", Status::True, vec![Right, UpTo(1)]),
        (two, "F = 2 m r ω² cos θ + 2 m r² ω²/L cos(2θ)", Status::True, vec![Right, UpTo(1)]),
        (
            two,
            "shaking force = 2 m r ω² (cos θ + (λ + λ^3/4) cos 2θ − λ³/4 cos 4θ)",
            Status::True,
            vec![Right, UpTo(3), UpTo(3)],
        ),
        (two, "F = 2 m r ω² (cos θ + λ (2cos²θ − 1))", Status::True, vec![Right, UpTo(1)]),
        (two, "F = 2 m r w^2 (cos(θ) + 1/4 cos 2θ)", Status::NotDecided, vec![Right, NoRatio]),
        (quarter, "F = 2 m r w^2 (cos(θ) + 1/4 cos 2θ)", Status::True, vec![Right, UpTo(1)]),
        (quarter, "F = 2 m r w^2 (cos(θ) + 0.254 cos 2θ)", Status::TrueAsRounded, vec![Right, Rounded]),
        (quarter, "F = 2 m r w^2 (cos(θ) + 0.257 cos 2θ)", Status::False, vec![Right, Wrong]),
        (two, "F = 2 m r ω² (cos θ + λ/2 cos 2θ)", Status::False, vec![Right, Wrong]),
        (two, "F = 2 m r ω² cos θ", Status::False, vec![Right, Missing]),
        (two, "F = 2 m r ω (cos θ + λ cos 2θ)", Status::False, vec![WrongUnit, WrongUnit]),
        (turned, "F = m r ω² (cos θ + cos(θ + 90°))", Status::True, vec![Right, Right]),
        (turned, "F = √2 m r ω² cos(θ + π/4)", Status::True, vec![Right, Right]),
        (turned, "F = √2 m r ω² cos(θ − 45°)", Status::False, vec![Right, Wrong]),
        ("I4", "F = 4 m r ω² λ cos 2θ", Status::True, vec![UpTo(1)]),
        ("I4", "F = 4 m r ω² (cos θ + λ cos 2θ)", Status::False, vec![Wrong, UpTo(1)]),
        // A zero without an order is one of every order, and a term that is said to be 0 is a claim.
        ("I6", "F = 0", Status::False, vec![Missing]),
        ("I3", "shaking force along = 0.0", Status::False, vec![Missing]),
        ("I6", "F = 0 cos 4θ", Status::True, vec![]),
        ("I6", "F = 0 cos 6θ", Status::False, vec![Missing]),
        ("I4", "F = 4 m r ω² λ cos 2θ + 0 cos 4θ", Status::False, vec![UpTo(1), Missing]),
        ("I4", "F = 4 m r ω² λ cos 2θ + m r ω² λ cos 4θ − m r ω² λ cos 4θ", Status::False, vec![UpTo(1), Missing]),
        ("I4", "F = 4 m r ω² (λ + 0 λ³) cos 2θ", Status::False, vec![Wrong]),
        ("I4", "F = 4 m r ω² (λ + 0 λ²) cos 2θ", Status::True, vec![UpTo(1)]),
        // A Scotch yoke has order 1 alone.
        (yoke, "F = 2 m r ω² cos θ", Status::True, vec![Right]),
        (yoke, "F = 2 m r ω² cos θ + 0 cos 2θ", Status::True, vec![Right]),
        (yoke, "F = 2 m r ω² (cos θ + λ cos 2θ)", Status::False, vec![Right, Wrong]),
        ("mechanism.scotch_yoke = true\ninline.throws = [0, 180]", "F = 0", Status::True, vec![]),
    ] {
        let answer = answer(layout, says);
        let found: Vec<TermVerdict> = verdicts(&answer).into_iter().map(|(_, _, verdict)| verdict).collect();
        assert_eq!((&answer.status, &found), (&status, &expected), "{layout}: {says}");
    }
    let told = answer("V8-flatplane", "F = m r ω² cos θ");
    assert!(
        matches!(&told.finding, Finding::Nothing(why) if why.contains("along")) && told.status == Status::NotDecided,
        "{told:?}"
    );
    assert_eq!(answer("V8-flatplane", "F = 0").status, Status::False);
    for (component, status) in [("along", Status::False), ("across", Status::False)] {
        assert_eq!(answer("V8-flatplane", &format!("shaking force {component} = 0")).status, status, "{component}");
    }
    assert_eq!(answer("V8-crossplane", "shaking force across = 0").status, Status::True);
    for wrong in [
        "F = m r ω² cos(θ/2)",
        "F = m r ω² tan θ",
        "F = m r ω² θ",
        "F = m r ω² cos(1)",
        "F = p cos θ",
        "F = 1/cos θ",
        "F = (cos 60θ)^4",
    ] {
        assert!(parse_statement(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn the_series_of_random_engines_found_in_the_time_domain_is_right_and_a_changed_one_is_wrong() {
    let mut dice = Dice::new(151);
    let (mut found, mut across_left) = (0, 0);
    while found < 40 {
        let text = every_form::known(&mut dice);
        let Ok(engine) = file::parse("layout.toml", &text) else { continue };
        if engine.has_links() || engine.has_offset() || engine.mechanisms().len() > 1 {
            continue;
        }
        for across in [false, true] {
            let [direct, reverse] = vectors(&engine, 1, crankstar::proof::Planar::Force, |_| [0.0, 0.0]);
            let (cosine, sine) = match across {
                false => ((direct + reverse).re / 2.0, (reverse - direct).im / 2.0),
                true => ((direct + reverse).im / 2.0, (direct - reverse).re / 2.0),
            };
            let series = |cosine: f64| {
                format!(
                    "shaking force {} = m r ω² ({cosine:.6} cos θ + ({sine:.6}) sin θ)",
                    if across { "across" } else { "along" }
                )
            };
            let of_first = |says: &str| -> Vec<TermVerdict> {
                let statement = parse_statement(says).unwrap_or_else(|error| panic!("{says}: {error:?}"));
                let answer = claim::answer(&engine, &statement, None);
                verdicts(&answer).into_iter().filter(|(order, ..)| *order == 1).map(|(_, _, verdict)| verdict).collect()
            };
            let agrees = |verdicts: &[TermVerdict]| {
                verdicts.iter().all(|one| [TermVerdict::Right, TermVerdict::Rounded].contains(one))
            };
            assert!(agrees(&of_first(&series(cosine))), "{text}\n{}", series(cosine));
            assert!(!agrees(&of_first(&series(cosine + 0.012_345))), "{text}\n{}", series(cosine + 0.012_345));
            across_left += usize::from(across && (cosine.abs() > 1e-6 || sine.abs() > 1e-6));
        }
        found += 1;
    }
    assert!(across_left > 8, "{across_left}");
}

#[test]
fn findings_of_series_have_german_for_every_phrase() {
    for (layout, says) in [
        ("inline.throws = [0, 0]", "F = m r ω² (cos θ + 1/4 cos 2θ) + m cos 3θ + 2 m r ω²"),
        ("inline.throws = [0, 0]", "F = 0"),
        ("mechanism.rod_ratio = 0.25\ninline.throws = [0, 0]", "F = 2 m r w^2 (cos(θ) + 0.254 cos 2θ)"),
        ("inline.throws = [0, 0]", "F = 2 m r w^2 (cos(θ) + λ cos 2θ)"),
        ("I6", "F = 0"),
    ] {
        let statement = parse_statement(says).expect(says);
        let text: Text = report::claim_finding(&statement, &claim::answer(&engine(layout), &statement, None));
        let mut page = crankstar::page::Document::new("x", text);
        page.has_contents = false;
        let missing: Vec<&str> =
            phrases(&page).into_iter().filter(|words| has_words(words) && !Language::De.knows(words)).collect();
        assert!(missing.is_empty(), "no German for {missing:#?}");
    }
}

#[test]
fn a_claim_that_no_force_remains_is_answered_with_its_orders() {
    let statement = parse_statement("F = 0").expect("a claim");
    for (layout, words) in
        [("I6", "cos 6θ: missing"), ("mechanism.scotch_yoke = true\ninline.throws = [0, 180]", "at any order")]
    {
        let text = report::claim_finding(&statement, &claim::answer(&engine(layout), &statement, None));
        let told = crankstar::page::text_in(&text, crankstar::page::Format::PLAIN);
        assert!(told.contains(words), "{told}");
    }
}

/// The statement, be its value named m r ω² or not.
fn without_its_name(says: &str) -> Statement {
    match parse_statement(says).expect(says) {
        Statement::Order { subject, predicate: Predicate::Equals(value, angle) } => {
            let predicate = Predicate::Equals(Value { is_bare: false, ..value }, angle);
            Statement::Order { subject, predicate }
        }
        other => other,
    }
}

#[test]
fn a_value_may_name_the_multiples_that_the_program_prints() {
    for (canonical, sentences) in [
        (
            "first-order moment ≈ 0.4490 ± 0.0001",
            vec![
                "first-order moment ≈ 0.4490 m r ω² ± 0.0001",
                "first-order moment ≈ 0.4490 m r w^2 +/- 0.0001 m r w^2",
            ],
        ),
        (
            "first-order moment ≈ 0.4490 a ± 0.0001",
            vec![
                "first-order moment ≈ 0.4490 m r ω² a ± 0.0001",
                "first-order moment ≈ 0.4490 m r w^2 a ± 0.0001 m r w^2 a",
                "first-order moment ≈ 0.4490 ± 0.0001 a",
                "The first-order moment is ≈ 0.4490 a ± 0.0001.",
            ],
        ),
        (
            "first-order moment = 0.449 a",
            vec!["M1 = 0.449 m r ω² a", "M₁ = 0.449·mrω²·a", "the first-order moment is 0.449 a"],
        ),
        ("second-order force = 4", vec!["F2 = 4 m r ω² c_2", "F2 = 4 m r ω² c₂", "second-order force is 4 m r ω² c_k"]),
        ("second-order moment is planar", vec!["the second-order moment is planar"]),
    ] {
        for says in sentences {
            assert_eq!(without_its_name(says), without_its_name(canonical), "{says}");
        }
    }
    assert_eq!(answer("I5-12453", "M1 ≈ 0.449 m r ω² a").status, Status::True);
    assert_eq!(answer("I5-12453", "the second-order moment is ≈ 4.980 m r ω² c_2 a").status, Status::True);
    // Of a higher order m r ω² alone is another number, and a force has no arm.
    let refused = parse_statement("M2 = 1.453 m r ω² a").expect_err("the rod decides it");
    assert!(refused.right.contains("c_2"), "{refused:?}");
    assert!(parse_statement("second-order force = 4 a").is_err());
}

/// The pistons of a crank of twice the speed have order 1 where the others have order 2.
#[test]
fn a_series_of_crankshafts_of_different_speeds_is_not_decided() {
    let geared = "crankshaft = [{ name = 'a', sense = 'with' }, { name = 'b', sense = 'with', speed = 2, offset = '-100 mm' }]\n\
        mechanism = { stroke = '80 mm', rod_ratio = 0.25 }\n\
        [[cylinder]]\ncrankshaft = 'a'\nthrow = 0\nbank = 0\nposition = 0\n\
        [[cylinder]]\ncrankshaft = 'b'\nthrow = 0\nbank = 0\nposition = 0\nreciprocating_mass = '1/4'\n";
    let found = answer(geared, "F = m r ω² (cos θ + 2 λ cos 2θ)");
    assert_eq!(found.status, Status::NotDecided, "{found:?}");
}
