//! Which ways to cheat do both checkers see through, where an order has several sums or masses that turn?

use crankstar::motion::SliderCrank;
use crankstar::proof::{
    Certificate, Coefficient, Document, Fault, Masses, Quantity, RodClaim, Sense, Shape, ShapeEvidence, WholeOutcome,
    check_document, coefficient_bounds, read_document,
};
use num_rational::BigRational;
use num_traits::Zero;

use crate::support::second;
use crate::support::verdicts::{self, judged, theorem};
use crate::support::whole_documents::{cylinder, document, fill, turning};
use crate::support::written::ratio;

/// Three throws on rods of two kinds, with the torque: force and moment of order 1 are one sum, all else is two.
fn unequal() -> Document {
    let short = Some(["1/4", "0"]);
    let cylinders = vec![
        cylinder("1", ["0", "0", "0"], short),
        cylinder("2", ["1/3", "0", "1"], short),
        cylinder("3", ["2/3", "0", "2"], Some(["1/5", "0"])),
    ];
    document(Masses::Reciprocating, &[1, 2, 3, 4], true, cylinders, Vec::new())
}

/// A single with a counterweight, and a balancer shaft at twice the speed against the crank.
fn with_masses(masses: Masses) -> Document {
    let rod = Some(["3/10", "0"]);
    let turning = vec![
        turning("counterweight", 1, Sense::Direct, ["0", "1/2", "1/2"]),
        turning("shaft", 2, Sense::Reverse, ["1/3", "1/2", "1/40"]),
    ];
    document(masses, &[1, 2, 3], true, vec![cylinder("1", ["0", "0", "0"], rod)], turning)
}

/// `(1 − ¾i) + 1 − 2 + ¾i = 0`: an endless rod that stands askew with the slope 3/4, a centric one, and two weights.
fn coincidence() -> Document {
    let cylinders = vec![
        cylinder("left", ["0", "0", "0"], Some(["0", "3/5"])),
        cylinder("right", ["0", "0", "0"], Some(["1/4", "0"])),
    ];
    let weights = vec![
        turning("weight", 1, Sense::Direct, ["0", "1/2", "1"]),
        turning("aside", 1, Sense::Direct, ["0", "1/4", "3/8"]),
    ];
    document(Masses::All, &[1, 2, 3], false, cylinders, weights)
}

fn fault_of(mut document: Document, change: impl FnOnce(&mut Document)) -> String {
    let honest = document.clone();
    change(&mut document);
    assert!(document != honest, "nothing was changed");
    let Fault { place, reason } = check_document(&document).expect_err("a cheat");
    let fault = format!("{place}: {reason}");
    second::refuses(&[(fault.as_str(), &document)]);
    fault
}

#[track_caller]
fn assert_holds(document: &Document) {
    check_document(document).unwrap_or_else(|fault| panic!("{fault}\n{}", serde_json::to_string(document).unwrap()));
    let json = serde_json::to_vec(document).expect("JSON");
    let read = read_document(&json).unwrap_or_else(|error| panic!("{error}"));
    read.check().expect("it holds when read again");
    second::accepts(&[document], &[]);
}

#[track_caller]
fn assert_refused(document: Document, change: impl FnOnce(&mut Document), words: &str) {
    let fault = fault_of(document, change);
    assert!(fault.contains(words), "{fault}");
}

/// The place of a whole.
fn whole(document: &Document, quantity: Quantity, order: u32, sense: Option<Sense>) -> usize {
    let at = |one: &crankstar::proof::WholeClaim| (one.quantity, one.order, one.sense) == (quantity, order, sense);
    document.wholes.iter().position(at).expect("a whole")
}

fn outcome(document: &Document, quantity: Quantity, order: u32, sense: Option<Sense>) -> WholeOutcome {
    document.wholes[whole(document, quantity, order, sense)].outcome
}

fn set(document: &mut Document, order: u32, sense: Sense, outcome: WholeOutcome) {
    let at = whole(document, Quantity::FORCE, order, Some(sense));
    document.wholes[at].outcome = outcome;
}

const DIRECT: Option<Sense> = Some(Sense::Direct);
const REVERSE: Option<Sense> = Some(Sense::Reverse);

#[test]
fn the_honest_documents_are_accepted() {
    let unequal = unequal();
    assert_holds(&unequal);
    let of = |order: u32, quantity: Quantity| -> Vec<Vec<String>> {
        let these = unequal.verdicts.iter().filter(|one| (one.order, one.quantity) == (order, quantity));
        these.map(|one| one.of.clone()).collect()
    };
    assert_eq!(of(1, Quantity::FORCE), [vec![], Vec::<String>::new()]);
    assert_eq!(of(2, Quantity::FORCE), [vec!["1", "2"], vec!["1", "2"], vec!["3"], vec!["3"]]);
    assert_eq!(of(1, Quantity::TORQUE), [vec!["1", "2"], vec!["3"]]);
    // There is no third order of the force, whatever its sums are.
    assert_eq!(outcome(&unequal, Quantity::FORCE, 3, DIRECT), WholeOutcome::Zero);
    assert!(unequal.verdicts.iter().any(|one| one.order == 3 && !one.vanishes));
    assert_eq!(outcome(&unequal, Quantity::FORCE, 2, DIRECT), WholeOutcome::NotZeroByEnclosure { bits: 128 });
    for masses in [Masses::All, Masses::Rotating, Masses::Counterweights] {
        assert_holds(&with_masses(masses));
    }
    let all = with_masses(Masses::All);
    assert_eq!(outcome(&all, Quantity::FORCE, 2, DIRECT), WholeOutcome::NotZero);
    assert_eq!(outcome(&all, Quantity::MOMENT, 2, DIRECT), WholeOutcome::Zero);
    let checked = check_document(&all).expect("it holds");
    assert_eq!((checked.masses, checked.wholes, checked.open_wholes), (vec![Masses::All], 4, 0));
    let coincidence = coincidence();
    assert_holds(&coincidence);
    assert!(matches!(outcome(&coincidence, Quantity::FORCE, 1, DIRECT), WholeOutcome::NotDecided { .. }));
    assert_eq!(check_document(&coincidence).expect("it holds").open_wholes, 1);
}

#[test]
fn coefficients_are_those_of_the_solver() {
    let meet = |[low, high]: &[BigRational; 2], other: &crankstar::motion::Enclosure| {
        *low <= other.high && other.low <= *high && high - low < ratio("1/1000000000000000000")
    };
    for (rod_ratio, offset) in [
        ("1/4", "0"),
        ("1/4", "1/20"),
        ("3/10", "-1/7"),
        ("9/10", "1/20"),
        ("1/1000", "1/3"),
        ("0", "1/4"),
        ("0", "0"),
        ("1/3", "2/3"),
    ] {
        let rod = RodClaim { ratio: ratio(rod_ratio), offset: ratio(offset) };
        let Ok(crank) = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()) else { continue };
        for order in [1, 2, 3, 4, 5, 6, 7, 8, 12, 25] {
            for quantity in [Quantity::FORCE, Quantity::TORQUE] {
                let theirs = match quantity {
                    Quantity::TORQUE => crank.torque_coefficient(order),
                    _ => crank.coefficient(order),
                };
                let [re, im] = coefficient_bounds(&rod, quantity, order, 96).expect("few points");
                let both = meet(&re, &theirs.re) && meet(&im, &theirs.im);
                assert!(both, "{rod_ratio} {offset} {order} {quantity:?}: {re:?} {im:?} {theirs:?}");
            }
        }
    }
}

#[test]
fn a_rod_that_all_but_reaches_over_the_shaft_takes_too_many_points() {
    let rod = |offset: &str| RodClaim { ratio: ratio("1/2"), offset: ratio(offset) };
    assert!(coefficient_bounds(&rod("499/1000"), Quantity::TORQUE, 2, 64).is_ok());
    for offset in
        ["499999999/1000000000", "49999999999999999999999999999999999999999/100000000000000000000000000000000000000000"]
    {
        assert!(coefficient_bounds(&rod(offset), Quantity::FORCE, 2, 64).is_err());
        assert!(coefficient_bounds(&rod(offset), Quantity::TORQUE, 2, 64).is_err());
    }
    assert!(coefficient_bounds(&rod("1/4"), Quantity::FORCE, 4_000_000_000, 64).is_err());
}

#[test]
fn a_wrong_outcome_is_refused() {
    let all = [
        WholeOutcome::Zero,
        WholeOutcome::NotZero,
        WholeOutcome::Open,
        WholeOutcome::NotZeroByEnclosure { bits: 128 },
        WholeOutcome::NotDecided { below: 1e-40 },
    ];
    let mut cheats = Vec::new();
    for document in [unequal(), with_masses(Masses::All), coincidence()] {
        for index in 0..document.wholes.len() {
            for wrong in all {
                let right = document.wholes[index].outcome;
                if std::mem::discriminant(&wrong) == std::mem::discriminant(&right) {
                    continue;
                }
                let mut cheat = document.clone();
                cheat.wholes[index].outcome = wrong;
                let fault = check_document(&cheat).expect_err("a cheat");
                assert!(fault.place.starts_with(&format!("wholes[{index}]")), "{fault}");
                cheats.push(("another outcome", cheat));
            }
        }
    }
    second::refuses(&cheats);
}

#[test]
fn a_whole_that_is_missing_or_stands_twice_or_elsewhere_is_refused() {
    assert_refused(unequal(), |d| d.wholes.truncate(3), "this statement is missing");
    assert_refused(unequal(), |d| d.wholes.clear(), "this statement is missing");
    assert_refused(unequal(), |d| d.wholes = d.wholes[1..].to_vec(), "another statement stands here");
    assert_refused(unequal(), |d| d.wholes.push(d.wholes[0].clone()), "more than orders with several sums have");
    assert_refused(unequal(), |d| d.wholes[1].sense = None, "another statement");
    assert_refused(unequal(), |d| d.wholes[0].order = 2, "another statement");
    assert_refused(unequal(), |d| d.wholes[0].quantity = Quantity::MOMENT, "another statement");
    assert_refused(unequal(), |d| d.wholes.swap(1, 2), "another statement");
    let alone = document(Masses::Reciprocating, &[1], false, vec![cylinder("1", ["0"; 3], None)], Vec::new());
    let surplus = unequal().wholes[0].clone();
    assert_refused(alone, |d| d.wholes.push(surplus), "more than orders");
}

#[test]
fn bits_out_of_range_or_too_few_are_refused() {
    let by = |bits| move |d: &mut Document| set(d, 2, Sense::Direct, WholeOutcome::NotZeroByEnclosure { bits });
    for bits in [0, 31, 513, u32::MAX] {
        assert_refused(unequal(), by(bits), "an enclosure has 32 to 512 bits");
    }
    // A counterweight that is 10^-40 from taking all of c_2 away.
    let near = |digits: usize| {
        let mut document = with_masses(Masses::All);
        let rod = RodClaim { ratio: ratio("3/10"), offset: BigRational::zero() };
        let [[low, _], _] = coefficient_bounds(&rod, Quantity::FORCE, 2, 480).expect("few points");
        let ten = num_bigint::BigInt::from(10).pow(u32::try_from(digits).expect("few"));
        let rounded = (low * BigRational::from_integer(ten.clone())).floor() / BigRational::from_integer(ten);
        document.turning_masses[1].mass_radius = rounded / BigRational::from_integer(8.into());
        document.turning_masses[1].position = BigRational::zero();
        fill(&mut document);
        document
    };
    let decided = |bits: u32, digits: usize| {
        let mut document = near(digits);
        set(&mut document, 2, Sense::Reverse, WholeOutcome::NotZeroByEnclosure { bits });
        let shape = document.shapes.iter_mut().find(|one| (one.quantity, one.order) == (Quantity::FORCE, 2)).unwrap();
        (shape.shape, shape.evidence) = (Shape::Elliptical, Some(ShapeEvidence::Bits(bits)));
        let checked = check_document(&document).map(|_| ()).map_err(|fault| fault.to_string());
        match &checked {
            Ok(()) => second::accepts(&[document], &[]),
            Err(fault) => second::refuses(&[(fault.as_str(), document)]),
        }
        checked
    };
    assert_eq!(decided(128, 40), Ok(()));
    assert!(decided(32, 40).is_err_and(|fault| fault.contains("zero is not excluded by an enclosure with 32 bits")));
    assert_eq!(decided(512, 110), Ok(()));
    assert!(decided(256, 110).is_err_and(|fault| fault.contains("not excluded")));
    // What is very near to zero can be left undecided, and what is not cannot.
    assert_holds(&near(40));
    assert_holds(&near(110));
    let hidden = |d: &mut Document| set(d, 2, Sense::Reverse, WholeOutcome::NotDecided { below: 1e-9 });
    assert_refused(near(9), hidden, "at most 10^-15 of the terms");
}

#[test]
fn a_bound_that_is_too_small_or_too_large_is_refused() {
    let below = |below: f64| move |d: &mut Document| set(d, 1, Sense::Direct, WholeOutcome::NotDecided { below });
    assert_refused(coincidence(), below(1e-120), "less than what an enclosure with 256 bits leaves");
    assert_refused(coincidence(), below(5e-14), "at most 10^-15 of the terms");
    for none in [0.0, -1e-40, f64::NAN, f64::INFINITY] {
        assert_refused(coincidence(), below(none), "`below`");
    }
}

#[test]
fn an_order_of_unknown_rods_beside_a_shaft_is_open() {
    let shaft = turning("shaft", 2, Sense::Direct, ["0", "0", "1"]);
    let one = document(Masses::All, &[1, 2], false, vec![cylinder("1", ["0"; 3], None)], vec![shaft]);
    assert_holds(&one);
    assert_eq!(outcome(&one, Quantity::FORCE, 2, DIRECT), WholeOutcome::Open);
    assert_eq!(outcome(&one, Quantity::FORCE, 2, REVERSE), WholeOutcome::NotZero);
    let decided = |d: &mut Document| set(d, 2, Sense::Direct, WholeOutcome::NotZeroByEnclosure { bits: 64 });
    assert_refused(one.clone(), decided, "it is `open`");
    let force = one.shapes.iter().position(|shape| shape.order == 2).expect("a shape");
    assert_refused(one, |d| d.shapes[force].shape = Shape::Rotating, "the shape contradicts the verdicts");
}

#[test]
fn wrong_names_are_refused() {
    let at = |d: &Document| d.verdicts.iter().position(|one| one.of == ["1", "2"]).expect("a sum of two");
    assert_refused(
        unequal(),
        |d| {
            let at = at(d);
            d.verdicts[at].of.pop();
        },
        "here stands a verdict on",
    );
    assert_refused(
        unequal(),
        |d| {
            let at = at(d);
            d.verdicts[at].of.clear();
        },
        "here stands a verdict on",
    );
    assert_refused(
        unequal(),
        |d| {
            let at = at(d);
            d.verdicts[at].of.reverse();
        },
        "here stands a verdict on",
    );
    assert_refused(unequal(), |d| d.verdicts[0].of.push("1".to_owned()), "here stands a verdict on");
    let all = || with_masses(Masses::All);
    assert_refused(all(), |d| d.turning_masses[0].name = "1".to_owned(), "is called 1 too");
    assert_refused(all(), |d| d.turning_masses[0].name = "shaft".to_owned(), "is called shaft too");
    assert_refused(all(), |d| d.turning_masses[1].name = "other".to_owned(), "here stands a verdict on");
}

#[test]
fn masses_that_turn_have_their_place() {
    let all = || with_masses(Masses::All);
    assert_refused(all(), |d| d.masses = Masses::Reciprocating, "so there is none here");
    assert_refused(all(), |d| d.masses = Masses::Rotating, "");
    assert_refused(with_masses(Masses::Rotating), |d| d.masses = Masses::All, "");
    assert_refused(all(), |d| d.turning_masses[0].order = 0, "from 1 on");
    assert_refused(all(), |d| d.turning_masses[0].order = 2, "");
    assert_refused(all(), |d| d.turning_masses[0].sense = Sense::Reverse, "");
    assert_refused(all(), |d| d.turning_masses[0].angle = ratio("1/3"), "the angle of counterweight");
    assert_refused(all(), |d| d.turning_masses[1].position = ratio("1/7"), "the weight of shaft");
    assert_refused(all(), |d| drop(d.turning_masses.pop()), "");
    let more = turning("more", 3, Sense::Direct, ["0", "0", "1"]);
    assert_refused(all(), |d| d.turning_masses.push(more), "");
    // 2 U, and not U or 2 k² U with another k.
    for weight in ["1/40", "1/20", "1/10"] {
        let change = |d: &mut Document| {
            let at = d.verdicts.iter().position(|one| one.of == ["shaft"]).expect("the shaft's");
            d.verdicts[at].terms[0].weight = ratio(weight);
        };
        assert_refused(all(), change, "the weight of shaft is");
    }
    // 2 · 2² · 1/40.
    let shaft = all();
    let shaft = shaft.verdicts.iter().find(|one| one.of == ["shaft"]).expect("the shaft's");
    assert_eq!(shaft.terms[0].weight, ratio("1/5"));
}

#[test]
fn a_rod_to_the_other_side_changes_the_sign_of_odd_orders() {
    let document = || {
        let cylinders = vec![
            cylinder("1", ["0", "0", "0"], Some(["1/4", "1/20"])),
            cylinder("2", ["1/2", "0", "1"], Some(["1/4", "-1/20"])),
        ];
        document(Masses::Reciprocating, &[1, 2, 3], true, cylinders, Vec::new())
    };
    assert_holds(&document());
    let third = document().verdicts.iter().position(|one| one.order == 3 && one.quantity == Quantity::FORCE).unwrap();
    // Turned by half a turn and against the other side: the same direction, so that nothing cancels.
    assert!(document().verdicts[third].of.is_empty() && !document().verdicts[third].vanishes);
    let honest = |d: &mut Document| d.verdicts[third].terms[1].weight = ratio("1");
    assert_refused(document(), honest, "the weight of 2 is 1, it should be -1");
}

#[test]
fn shapes_of_several_sums_have_evidence_of_their_own() {
    let force = |d: &Document, order: u32| {
        d.shapes.iter().position(|one| (one.quantity, one.order) == (Quantity::FORCE, order)).expect("a shape")
    };
    // Two numbers, and so three products of two of them.
    let two = force(&unequal(), 2);
    let pairs = || match &unequal().shapes[two].evidence {
        Some(ShapeEvidence::Pairs(pairs)) => pairs.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(pairs().len(), 3);
    let with = |evidence| move |d: &mut Document| d.shapes[two].evidence = evidence;
    let changed = |change: fn(&mut Vec<Certificate>)| {
        let mut pairs = pairs();
        change(&mut pairs);
        with(Some(ShapeEvidence::Pairs(pairs)))
    };
    let none = || Certificate::Polygons { polygons: Vec::new() };
    assert_refused(unequal(), changed(|all| drop(all.pop())), "2 certificates for 3 pairs of 2 numbers");
    assert_refused(unequal(), changed(|all| all.push(all[0].clone())), "4 certificates for 3 pairs of 2 numbers");
    assert_refused(unequal(), changed(Vec::clear), "0 certificates");
    let kinds = "planar is shown by `pairs`";
    assert_refused(unequal(), with(Some(ShapeEvidence::Certificate(none()))), kinds);
    assert_refused(unequal(), with(Some(ShapeEvidence::Bits(128))), kinds);
    assert_refused(unequal(), with(None), kinds);
    assert_refused(unequal(), |d| d.shapes[two].shape = Shape::Rotating, "contradicts");
    assert_refused(unequal(), |d| d.shapes[two].shape = Shape::NotDecided, kinds);
    let elliptical = |d: &mut Document| {
        (d.shapes[two].shape, d.shapes[two].evidence) = (Shape::Elliptical, Some(ShapeEvidence::Bits(128)))
    };
    assert_refused(unequal(), elliptical, "equal lengths are not excluded");
    // A single with a shaft: c_2 direct, c_2 and the shaft against it.
    let all = || with_masses(Masses::All);
    let two = force(&all(), 2);
    assert_eq!(all().shapes[two].evidence, Some(ShapeEvidence::Bits(128)));
    let hidden = |d: &mut Document| (d.shapes[two].shape, d.shapes[two].evidence) = (Shape::NotDecided, None);
    assert_refused(all(), hidden, "not so near to each other");
    assert_refused(all(), |d| d.shapes[two].evidence = Some(ShapeEvidence::Bits(16)), "32 to 512 bits");
    let planar = |d: &mut Document| {
        (d.shapes[two].shape, d.shapes[two].evidence) = (Shape::Planar, Some(ShapeEvidence::Pairs(pairs())));
    };
    assert_refused(all(), planar, "shapes");
    // One sum a vector: the certificate, and nothing else.
    let moment = 1;
    assert!(matches!(unequal().shapes[moment].evidence, Some(ShapeEvidence::Certificate(_))));
    for other in [Some(ShapeEvidence::Bits(128)), Some(ShapeEvidence::Pairs(pairs()))] {
        let change = |d: &mut Document| d.shapes[moment].evidence = other;
        assert_refused(unequal(), change, "a certificate compares them");
    }
    // One kind of evidence, under its own key.
    let mut both = serde_json::to_value(unequal()).expect("JSON");
    both["shapes"][2]["bits"] = serde_json::json!(128);
    assert!(checked(&both).is_err_and(|error| error.contains("a shape has one of")));
    let vague = |d: &mut Document| (d.shapes[moment].shape, d.shapes[moment].evidence) = (Shape::NotDecided, None);
    assert_refused(unequal(), vague, "a certificate that compares the two moduli is missing");
}

#[test]
fn lengths_that_are_equal_without_a_mirror_are_compared_pair_by_pair() {
    // Turned by a twelfth: no longer mirrored in the reference direction.
    let mut tilted = unequal();
    for cylinder in &mut tilted.cylinders {
        cylinder.throw += ratio("1/12");
        cylinder.bank += ratio("1/12");
    }
    fill(&mut tilted);
    assert_holds(&tilted);
    let two = |one: &&crankstar::proof::ShapeClaim| (one.quantity, one.order) == (Quantity::FORCE, 2);
    let shape = tilted.shapes.iter().find(two).expect("a shape");
    assert!(
        shape.shape == Shape::Planar
            && matches!(&shape.evidence, Some(ShapeEvidence::Pairs(pairs)) if pairs.len() == 3)
    );
    // Of an engine whose vectors are not equally long no pairs are all zero.
    let mut uneven = tilted.clone();
    uneven.cylinders[2].bank += ratio("1/8");
    fill(&mut uneven);
    let at = uneven.shapes.iter().position(|one| two(&one)).expect("a shape");
    assert_eq!(uneven.shapes[at].shape, Shape::Elliptical);
    let claimed = shape.clone();
    assert_refused(uneven, |d| d.shapes[at] = claimed, "shapes");
}

#[test]
fn statements_on_every_order_are_about_masses_that_turn_with_the_crank() {
    let mut all = with_masses(Masses::All);
    all.turning_masses.truncate(1);
    let engine = "[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.3\n";
    let layout = crankstar::file::parse("single", engine).expect("it reads");
    let theorem = theorem(&layout).expect("a theorem");
    let honest = verdicts::document(&layout, &judged(&layout, &[2], false), false, Some(&theorem));
    // The counterweight is half of the single's order 1: it takes the direct vector away.
    all.cylinders = honest.cylinders.clone();
    (all.orders, all.quantities) = (vec![2], verdicts::quantities(false));
    (all.all_orders, all.theorems) = (true, honest.theorems.clone());
    fill(&mut all);
    assert!(check_document(&all).expect_err("order 1 is another").place.starts_with("theorems[0]"));
    let direct = &mut all.theorems[0];
    let zero = crate::support::written::sum("1@0 1@1/2");
    (direct.survivors.order_one, direct.verdicts[0].vanishes) = (false, true);
    direct.verdicts[0].certificate = zero.certificate();
    assert_holds(&all);
    let shaft = turning("shaft", 4, Sense::Reverse, ["1/3", "1/2", "1/40"]);
    assert_refused(all, |d| d.turning_masses.push(shaft), "masses that turn with the crank, or none");
}

fn checked(tree: &serde_json::Value) -> Result<crankstar::proof::Checked, String> {
    let read = read_document(tree.to_string().as_bytes()).map_err(|error| error.to_string())?;
    read.check().map_err(|fault| fault.to_string())
}

#[test]
fn the_outcomes_are_written_in_words() {
    let json = |outcome: WholeOutcome| serde_json::to_string(&outcome).expect("JSON");
    assert_eq!(json(WholeOutcome::Zero), "\"zero\"");
    assert_eq!(json(WholeOutcome::NotZero), "\"not-zero\"");
    assert_eq!(json(WholeOutcome::Open), "\"open\"");
    assert_eq!(json(WholeOutcome::NotZeroByEnclosure { bits: 64 }), "{\"not-zero-by-enclosure\":{\"bits\":64}}");
    assert_eq!(json(WholeOutcome::NotDecided { below: 1e-40 }), "{\"not-decided\":{\"below\":1e-40}}");
    let masses = [Masses::Reciprocating, Masses::Rotating, Masses::Counterweights, Masses::All];
    let words = masses.map(|masses| serde_json::to_string(&masses).expect("JSON"));
    assert_eq!(words, ["\"reciprocating\"", "\"rotating\"", "\"counterweights\"", "\"all\""]);
    assert_eq!(serde_json::to_string(&Coefficient::Common).expect("JSON"), "\"common\"");
}
