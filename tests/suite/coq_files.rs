//! Does `classify --format coq` state each verdict as a theorem, refuse what it cannot state, and keep a person's text in its comment?
//!
//! Whether Coq accepts the files is for `formal/run`.

use std::f64::consts::TAU;
use std::fs;

use crankstar::proof::{AnyDocument, Document as ClassifyDocument, read_document};
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::program::{call, scratch};

fn answered(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

fn refused(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(!output.status.success(), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    String::from_utf8(output.stderr).expect("a text")
}

/// The file without its comments, which nest and hold strings.
fn without_comments(text: &str) -> String {
    let (mut out, mut depth, mut rest) = (String::new(), 0_usize, text);
    while let Some(letter) = rest.chars().next() {
        if rest.starts_with("(*") {
            depth += 1;
            rest = &rest[2..];
        } else if depth > 0 && rest.starts_with("*)") {
            depth -= 1;
            rest = &rest[2..];
        } else {
            assert!(letter != '"', "a quote opens a string, in comments too");
            if depth == 0 {
                out.push(letter);
            }
            rest = &rest[letter.len_utf8()..];
        }
    }
    assert_eq!(depth, 0, "a comment is open at the end");
    out
}

#[test]
fn each_verdict_of_the_document_is_a_theorem_that_says_the_same() {
    for engine in ["radial-9", "V8-crossplane", "I6", "V6-90-split", "boxer-2", "V10-72"] {
        let json = answered(&["classify", engine, "--torque", "--json"]);
        let AnyDocument::Classify(document) = read_document(json.as_bytes()).expect("a document") else {
            panic!("{engine}: verdicts on an engine")
        };
        let file = answered(&["classify", engine, "--torque", "--format", "coq"]);
        let mut named = Vec::new();
        for verdict in &document.verdicts {
            let sense = verdict.sense.map(|sense| format!("_{}", sense.name())).unwrap_or_default();
            let name = format!("{}{sense}_order_{}", verdict.quantity.name(), verdict.order);
            let (relation, lemma) = if verdict.vanishes { ("= 0%R.", "@vanishes ") } else { ("<> 0%R.", "@is_left ") };
            let theorem = file.split("Theorem ").find(|piece| piece.starts_with(&format!("{name} :")));
            let theorem = theorem.unwrap_or_else(|| panic!("{engine}: no theorem {name}"));
            assert!(theorem.contains(relation) && theorem.contains(lemma), "{engine}: {theorem}");
            named.push(name);
        }
        let lengths = document.shapes.iter().filter(|shape| shape.evidence.is_some()).count();
        let forces = document.orders.len() * document.quantities.len();
        let exact = file.matches("\nTheorem real_force_repeats ").count();
        assert_eq!(file.matches("\nTheorem ").count(), named.len() + lengths + forces + exact, "{engine}");
        assert_eq!(file.matches("\nTheorem real_").count(), forces + exact, "{engine}");
        // Every theorem is among those whose axioms are printed, and none is admitted.
        let (_, last) = file.split_once("Definition verdicts :=").expect("the list of theorems");
        assert!(named.iter().all(|name| last.contains(&format!("\n  {name}"))), "{engine}: {last}");
        let (vectors, forces) = last.split_once("Print Assumptions verdicts.\n").expect("their axioms");
        assert!(!vectors.contains("real_"), "no force is said to need no axiom, {engine}: {vectors}");
        assert!(forces.ends_with("Print Assumptions forces.\n"), "{engine}");
        assert!(!["Axiom", "Admitted", "Parameter", "admit"].iter().any(|word| file.contains(word)), "{engine}");
    }
}

/// The verdicts on an engine of the catalogue.
fn document(engine: &str) -> ClassifyDocument {
    match read_document(answered(&["classify", engine, "--json"]).as_bytes()).expect("a document") {
        AnyDocument::Classify(document) => document,
        _ => panic!("{engine}: verdicts on an engine"),
    }
}

/// The statement of a theorem, in one line.
fn stated(file: &str, name: &str) -> Option<String> {
    let (_, theorem) = file.split_once(&format!("Theorem {name} :\n"))?;
    let (statement, _) = theorem.split_once("\nProof. ")?;
    Some(statement.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[test]
fn a_force_vanishes_at_every_real_angle_where_all_its_vectors_do_and_else_is_left_at_some() {
    for engine in ["radial-9", "V8-crossplane", "I6", "V6-90-split", "boxer-2", "V10-72", "I5-12453"] {
        let arguments = |format: &[&'static str]| [&["classify", engine, "--torque"], format].concat();
        let json = answered(&arguments(&["--json"]));
        let AnyDocument::Classify(document) = read_document(json.as_bytes()).expect("a document") else {
            panic!("{engine}: verdicts on an engine")
        };
        let file = answered(&arguments(&["--format", "coq"]));
        for quantity in &document.quantities {
            for order in &document.orders {
                let mut sums = document.verdicts.iter().filter(|v| (v.quantity, v.order) == (*quantity, *order));
                let (what, zero) = (quantity.name(), if quantity.name() == "torque" { "0" } else { "(0, 0)" });
                let expected = match sums.all(|verdict| verdict.vanishes) {
                    true => format!("forall (c : R * R) (theta : R), {what} c the_engine {order} theta = {zero}."),
                    false => format!(
                        "forall c : R * R, c <> (0, 0) -> exists theta : R, {what} c the_engine {order} theta <> {zero}."
                    ),
                };
                let name = format!("real_{what}_order_{order}");
                assert_eq!(stated(&file, &name), Some(expected), "{engine}");
            }
        }
    }
}

#[test]
fn where_masses_turn_with_the_order_the_number_of_the_motion_is_one() {
    let folder = scratch("coq-rotating");
    let layout = folder.join("single.toml");
    let text = "title = 'Single'\n[inline]\nthrows = [0]\n[mechanism]\nreciprocating_mass = '0.5 kg'\nrotating_mass = '0.4 kg'\n\
        crank_radius = '45 mm'\nrod_length = '150 mm'\n";
    fs::write(&layout, text).expect("a file");
    let layout = layout.to_str().expect("a path");
    let file = answered(&["classify", layout, "--orders", "1,2", "--masses", "all", "--format", "coq"]);
    let first = stated(&file, "real_force_order_1").expect("a theorem");
    assert_eq!(first, "exists theta : R, force (1, 0) the_engine 1 theta <> (0, 0).");
    let second = stated(&file, "real_force_order_2").expect("a theorem");
    assert!(second.starts_with("forall c : R * R, c <> (0, 0) -> "), "nothing turns with it: {second}");
}

/// Where all pistons stand together, each by its mass and along its bank; the crank radius is 1.
fn place(document: &ClassifyDocument, rod: f64, theta: f64) -> [f64; 2] {
    let turns = |angle: &BigRational| TAU * angle.to_f64().expect("a float");
    document.cylinders.iter().fold([0.0, 0.0], |[x, y], cylinder| {
        let (mass, bank) = (cylinder.reciprocating_mass.to_f64().expect("a float"), turns(&cylinder.bank));
        let psi = theta + turns(&cylinder.throw) - bank;
        let piston = mass * (psi.cos() + (rod * rod - psi.sin().powi(2)).sqrt());
        [x + piston * bank.cos(), y + piston * bank.sin()]
    })
}

#[test]
fn the_force_of_the_exact_motion_repeats_after_the_turn_that_is_stated_and_after_no_smaller_part_of_a_turn() {
    let engines = [
        ("I6", Some(6)),
        ("V8-crossplane", Some(4)),
        ("I4", Some(2)),
        ("V12-60", Some(6)),
        ("radial-9", None),
        ("I2-360", None),
    ];
    for (engine, parts) in engines {
        let document = document(engine);
        let file = answered(&["classify", engine, "--format", "coq"]);
        let said = stated(&file, "real_force_repeats");
        let expected = |parts: u32| {
            format!(
                "forall m r l omega t : R, omega <> 0 -> exact_force the_engine m r l omega (t + radians (1 # {parts}) / omega) \
                 = exact_force the_engine m r l omega t."
            )
        };
        assert_eq!(said, parts.map(expected), "{engine}");
        let moved = |parts: u32| {
            let angles = (0..40).map(|step| 0.157 * f64::from(step));
            let far = angles.map(|theta| {
                let [now, then] = [theta, theta + TAU / f64::from(parts)].map(|theta| place(&document, 3.1, theta));
                (now[0] - then[0]).abs().max((now[1] - then[1]).abs())
            });
            far.fold(0.0, f64::max)
        };
        for other in 2..=24 {
            let repeats = parts.is_some_and(|parts| parts % other == 0);
            assert_eq!(moved(other) < 1e-12, repeats, "{engine}, 1/{other} of a turn: {}", moved(other));
        }
    }
}

#[test]
fn of_rods_that_differ_or_stand_off_no_turn_is_stated() {
    let folder = scratch("coq-exact");
    for (index, rest) in
        ["rod_ratio = [0.3, 0.3, 0.3, 0.25]", "rod_ratio = 0.3\noffset_ratio = 0.01"].iter().enumerate()
    {
        let layout = folder.join(format!("{index}.toml"));
        fs::write(&layout, format!("title = 'Four'\n[inline]\nthrows = [0, 180, 180, 0]\n[mechanism]\n{rest}\n"))
            .expect("a file");
        let file = answered(&["classify", layout.to_str().expect("a path"), "--format", "coq"]);
        assert_eq!(stated(&file, "real_force_repeats"), None, "{rest}");
    }
    let file = answered(&["classify", "I4", "--orders", "2", "--format", "coq"]);
    assert_eq!(stated(&file, "real_force_repeats"), None, "order 1 was not asked for");
}

#[test]
fn rods_that_differ_have_a_part_each_and_a_force_in_all_where_each_part_vanishes() {
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/formal/engines/rods.toml");
    let file = answered(&["classify", layout, "--orders", "2,4", "--format", "coq"]);
    assert!(
        file.contains("Definition part_1 : engine := part_of the_engine [:: true; true; true; true; false; "),
        "{file}"
    );
    assert!(file.contains("Definition part_2 : engine := part_of the_engine [:: false; false; "), "{file}");
    assert_eq!(
        stated(&file, "force_direct_order_2_part_2").as_deref(),
        Some("vector e part_2 (Force Direct) 2 = 0%R.")
    );
    assert_eq!(
        stated(&file, "real_force_order_2").as_deref(),
        Some(
            "forall (c_1 c_2 : R * R) (theta : R), together [:: force c_1 part_1 2; force c_2 part_2 2] theta = (0, 0)."
        )
    );
    assert_eq!(
        stated(&file, "force_direct_order_4_part_2").as_deref(),
        Some("vector e part_2 (Force Direct) 4 <> 0%R.")
    );
    assert_eq!(stated(&file, "real_force_order_4"), None, "whether the parts cancel needs their numbers");
}

#[test]
fn statements_on_every_order_have_a_certificate_for_each_even_order_of_a_period() {
    let file = answered(&["classify", "I6", "--orders", "2", "--all-orders", "--format", "coq"]);
    let every = file.split("Theorem force_direct_every_even_order").nth(1).expect("a theorem");
    let every = every.split("Qed.").next().expect("a proof");
    assert!(every.contains("(k mod 6) \\in ([:: 0] : seq Z)"), "{every}");
    assert_eq!(every.matches("(Evidence ").count(), 3, "orders 2, 4 and 6: {every}");
    assert!(file.contains("Theorem force_direct_order_1 :"), "order 1 was not asked for and stands apart");
    assert_eq!(
        stated(&file, "real_force_every_even_order").as_deref(),
        Some(
            "forall (k : Z) (c : R * R), (2 <= k)%Z -> (k mod 2 = 0)%Z -> c <> (0, 0) -> \
             (exists theta : R, force c the_engine k theta <> (0, 0)) <-> \
             (k mod 6)%Z \\in ([:: 0]%Z : seq Z) \\/ (k mod 6)%Z \\in ([:: 0]%Z : seq Z)."
        )
    );
}

/// Whether a statement on every order says that this one is left: that no factor has it among its zeros.
fn left_at(statement: &str, order: u32) -> bool {
    let (_, said) = statement.split_once("<-> ").expect("what is left");
    said.split(" /\\ ").all(|factor| {
        let rest = factor.strip_prefix("(k mod ").expect("a modulus");
        let (modulus, rest) = rest.split_once(") \\notin (").expect("residues");
        let zeros = rest.split_once(" : seq Z").expect("a list").0.trim_start_matches("[:: ").trim_end_matches(']');
        let modulus: u32 = modulus.parse().expect("a number");
        !zeros.split("; ").any(|zero| zero.parse() == Ok(order % modulus))
    })
}

#[test]
fn every_order_of_rods_with_an_offset_is_left_where_the_recurrences_say_so() {
    let folder = scratch("coq-every-order");
    let engines = [
        ("three", "[inline]\nthrows = [0, 120, 240]\n", "0.05"),
        ("vee", "[vee]\nbank_angle = 60\nthrows = [0, 120, 240]\npin_split = 60\n", "0.05"),
        ("long", "[inline]\nthrows = ['0 turn', '1/7 turn', '4/11 turn', '7/13 turn']\n", "0"),
        ("long vee", "[vee]\nbank_angle = 54.5\nthrows = [0, 120, 240, '14/11 turn']\n", "0.05"),
        ("two kinds", "[inline]\nthrows = [0, 90, 180, 270, 0, 72]\n", "[0.05, 0.05, 0.05, 0.05, 0, 0]"),
    ];
    for (title, text, offset) in engines {
        let layout = folder.join("layout.toml");
        let text = format!("title = '{title}'\n{text}[mechanism]\nrod_ratio = 0.25\noffset_ratio = {offset}\n");
        fs::write(&layout, text).expect("a file");
        let asked = ["classify", layout.to_str().expect("a path"), "--orders", "1", "--all-orders"];
        let json = answered(&[&asked[..], &["--json"]].concat());
        let AnyDocument::Classify(document) = read_document(json.as_bytes()).expect("a document") else {
            panic!("{title}: verdicts on an engine")
        };
        let file = answered(&[&asked[..], &["--format", "coq"]].concat());
        assert!(!document.recurrences.is_empty(), "{title}");
        for claim in &document.recurrences {
            for (parity, first, classes) in [("even", 2, &claim.even), ("odd", 3, &claim.odd)] {
                let name = format!("{}_{}_every_{parity}_order", claim.quantity.name(), claim.sense.name());
                for (index, class) in classes.iter().enumerate() {
                    let part =
                        if classes.len() > 1 || class.of.len() < document.cylinders.len() { index + 1 } else { 0 };
                    let name = if part == 0 { name.clone() } else { format!("{name}_part_{part}") };
                    let statement = stated(&file, &name).unwrap_or_else(|| panic!("{title}: no {name}"));
                    for order in (first..200).step_by(2) {
                        let zero = class.factors.iter().any(|factor| factor.zeros.contains(order));
                        assert_eq!(left_at(&statement, order), !zero, "{title}, order {order}: {statement}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_firing_star_is_the_torque_of_cylinders_that_turn_once_in_a_cycle() {
    let file = answered(&["classify", "I4", "--firing", "--orders", "1/2,2", "--format", "coq"]);
    assert!(
        file.contains("Cylinder (-3 # 4) (0 # 1) (0 # 1) (1 # 1) (1 # 1); (* 2 *)"),
        "it fires at 540 of 720: {file}"
    );
    assert_eq!(
        stated(&file, "real_torque_order_1").as_deref(),
        Some("forall (c : R * R) (theta : R), torque c the_engine 1 theta = 0.")
    );
    assert_eq!(
        stated(&file, "real_torque_order_4").as_deref(),
        Some("forall c : R * R, c <> (0, 0) -> exists theta : R, torque c the_engine 4 theta <> 0.")
    );
    assert!(file.contains("cycle of two revolutions") && file.contains("order k is order k/2 of the crank"), "{file}");
}

#[test]
fn a_firing_star_is_stated_at_every_order_class_by_class() {
    let rods = concat!(env!("CARGO_MANIFEST_DIR"), "/formal/engines/rods.toml");
    let folder = scratch("coq-firing-classes");
    let two_kinds = folder.join("rods.toml");
    let text = fs::read_to_string(rods).expect("a layout");
    let (title, rest) = text.split_once('\n').expect("a title");
    fs::write(
        &two_kinds,
        format!("{title}\ncycle = 'two-stroke'\nfiring_angles = [0, 270, 180, 90, 0, 270, 180, 90]\n{rest}"),
    )
    .expect("a file");
    for (engine, classes) in [("I4", 1), ("V8-crossplane", 1), ("I3", 1), (two_kinds.to_str().expect("a path"), 2)] {
        let asked = ["classify", engine, "--firing", "--all-orders"];
        let json = answered(&[&asked[..], &["--json"]].concat());
        let AnyDocument::Firing(document) = read_document(json.as_bytes()).expect("a document") else {
            panic!("{engine}: firing stars")
        };
        let verdicts = document.pattern.expect("every order").verdicts;
        let file = answered(&[&asked[..], &["--format", "coq"]].concat());
        assert_eq!(file.matches("Theorem torque_every_order").count(), classes, "{engine}");
        for class in 0..classes {
            let part = if classes == 1 { String::new() } else { format!("_part_{}", class + 1) };
            let said = stated(&file, &format!("torque_every_order{part}")).unwrap_or_else(|| panic!("{engine}{part}"));
            assert!(
                said.starts_with("forall k, 1 <= k -> vector e ") && said.contains(" Torque k <> 0%R <-> "),
                "{said}"
            );
            let real = stated(&file, &format!("real_torque_every_order{part}")).expect("the torque itself");
            assert!(
                real.starts_with("forall (k : Z) (c : R * R), (1 <= k)%Z -> c <> (0, 0) -> (exists theta : R, "),
                "{real}"
            );
            // Twice through the period, and on beyond it.
            let orders = (1..).zip(verdicts.iter().skip(class).step_by(classes).cycle()).take(3 * verdicts.len());
            for (order, verdict) in orders {
                assert_eq!(is_among(&said, order), !verdict.vanishes, "{engine}, order {order} of the cycle: {said}");
            }
        }
    }
}

/// Whether a statement by one period says that this order is left.
fn is_among(statement: &str, order: u32) -> bool {
    let (_, rest) = statement.split_once("<-> (k mod ").expect("a modulus");
    let (modulus, rest) = rest.split_once(") \\in (").expect("residues");
    let residues = rest.split_once(" : seq Z").expect("a list").0.trim_start_matches("[:: ").trim_end_matches(']');
    let modulus: u32 = modulus.parse().expect("a number");
    residues.split("; ").any(|residue| residue.parse() == Ok(order % modulus))
}

#[test]
fn paths_of_classes_are_stated_too() {
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/formal/engines/large-denominator.toml");
    let file = answered(&["classify", layout, "--orders", "1", "--format", "coq"]);
    assert!(file.contains("(Split [:: Class ") && file.contains("; Compare "), "{file}");
}

#[test]
fn counterweights_stand_in_the_engine() {
    let folder = scratch("coq-counterweights");
    let layout = folder.join("single.toml");
    let text = "title = 'Single'\n[inline]\nthrows = [0]\n[mechanism]\nreciprocating_mass = '0.5 kg'\ncrank_radius = '45 mm'\n\
        rod_length = '150 mm'\n[crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = 0.06\n";
    fs::write(&layout, text).expect("a file");
    let layout = layout.to_str().expect("a path");
    let file = answered(&["classify", layout, "--orders", "1", "--format", "coq"]);
    assert!(file.contains("TurningMass 1 Direct "), "{file}");
    let alone = answered(&["classify", layout, "--orders", "1", "--masses", "counterweights", "--format", "coq"]);
    assert!(!alone.contains("  Cylinder "), "the verdicts are not about the pistons: {alone}");
}

#[test]
fn what_the_file_cannot_state_is_refused_with_the_reason() {
    let folder = scratch("coq-refusals");
    let layout = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).expect("a file");
        path.to_str().expect("a path").to_owned()
    };
    let open = layout("open.toml", "title = 'Open'\n[vee]\nbank_angle = 'phi'\nthrows = [0]\n");
    let below = layout(
        "below.toml",
        "title = 'Below'\n[inline]\nthrows = [0, 90]\n[mechanism]\nrod_ratio = 0.25\noffset_ratio = [0.05, '-0.05']\n",
    );
    let long = layout("long.toml", "title = 'Long'\n[inline]\nthrows = ['0 turn', '1/1000003 turn']\n");
    let far = layout(
        "far.toml",
        "title = 'Far'\ncycle = 'two-stroke'\nfiring_order = '1-2'\n[inline]\nthrows = ['0 turn', '1/1009 turn']\n",
    );
    let cases = [
        (vec!["radial-9-master"], "has no rod on the crankpin"),
        (vec![open.as_str()], "has unknowns; give them values"),
        (vec![long.as_str(), "--all-orders"], "2000006"),
        (
            vec![below.as_str(), "--orders", "3"],
            "cylinder 2 has an offset below 0, which turns the sign of its odd orders",
        ),
        (vec![below.as_str(), "--all-orders"], "omit them and --all-orders"),
        (vec![far.as_str(), "--firing", "--all-orders"], "at most 720 are decided"),
        (vec![open.as_str(), "--firing"], "has unknowns; give them values"),
        (vec!["I4", "--output", "x.json"], "is named as a file of json"),
    ];
    for (arguments, reason) in cases {
        let all: Vec<&str> = ["classify", "--format", "coq"].into_iter().chain(arguments).collect();
        let told = refused(&all);
        assert!(told.contains(reason), "{all:?}: {told}");
    }
}

#[test]
fn no_title_leaves_its_comment() {
    const HARM: &str =
        "*) Axiom f : False. (* \" (* ( * ) *) \n *)\r*) Print Assumptions \u{1b}[31m \u{202e} Qed. **) (** end";
    let folder = scratch("coq-hostile");
    let layout = folder.join("hostile.toml");
    // The names of cylinders are letters and digits: the reader of layout files sees to it.
    let title = toml::Value::String(format!("{HARM}title"));
    let text = format!("title = {title}\n[inline]\nthrows = [0, 180]\n");
    fs::write(&layout, text).expect("a file");
    let arguments = ["classify", layout.to_str().expect("a path"), "--format", "coq", "--all-orders", "--torque"];
    let file = answered(&arguments);
    assert!(file.contains("endtitle"), "{file}");
    let plain = without_comments(&file);
    assert!(!["Axiom", "False", "endtitle"].iter().any(|word| plain.contains(word)), "{plain}");
    assert!(plain.is_ascii() && !plain.contains('\u{1b}'), "{plain}");
    assert!(!file.contains('\u{1b}') && !file.contains('\u{202e}'), "{file}");
    assert_eq!(plain.matches("Print Assumptions").count(), 2, "{plain}");
}
