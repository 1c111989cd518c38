//! Are sheets drawn alike everywhere, and is a class marked as it deserves, whatever it hands in?

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crankstar::BigRational;
use crankstar::claim::{Judged, SUMS, Star};
use crankstar::classroom::{
    Content, Convention, Counts, Draw, Exercise, HandedIn, MarkedSheet, Outcome, Pupil, Scheme, Vary, can_be_set,
    csv_to_fill_in, mark_class, marks_table, parse_exercise, parse_scheme, students, toml_to_fill_in,
};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::order;
use crankstar::page::{self, Format, Language, Options};
use crankstar::proof::Sense;
use crankstar::report;
use crankstar::table::csv;

use crate::support::class::{Answer, decimals, mirrored, right, toml, vectors, with_wrong_phases};
use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::german::{has_words, phrases};
use crate::support::program::{call, program, scratch};
use crate::support::written::of_catalogue as engine;

fn draw(layout: &str, names: &str, seed: u64) -> Exercise {
    let students = students(names).expect("a list");
    Exercise::draw(&engine(layout), &[1, 2], &students, seed, Vary::ALL).expect("engines")
}

fn handed_in(name: &str, text: impl Into<String>) -> HandedIn {
    HandedIn { name: name.to_owned(), content: Content::Bytes(text.into().into_bytes()) }
}

fn number(value: i64) -> BigRational {
    BigRational::from_integer(value.into())
}

/// The marked sheet of the only student.
fn marked(exercise: &Exercise, text: &str) -> MarkedSheet {
    let name = format!("{}.toml", exercise.pupils[0].file);
    let mut results = mark_class(exercise, vec![handed_in(&name, text)], &Scheme::default());
    match results.remove(0).outcome {
        Outcome::Marked(sheet) => *sheet,
        other => panic!("{other:?}\n{text}"),
    }
}

fn answers(pupil: &Pupil, places: usize) -> Vec<Answer> {
    [1, 2].map(|order| right(&pupil.engine, order, places)).into()
}

#[test]
fn a_student_and_a_seed_have_one_sheet_whoever_else_is_in_the_list() {
    let alone = draw("V6-60-even", "José Müller", 7);
    let among = draw("V6-60-even", "Ada\nBob\n\nJosé  Müller \nCarl", 7);
    assert_eq!(alone.pupils[0].engine, among.pupils[2].engine);
    assert_ne!(draw("V6-60-even", "José Müller", 8).pupils[0].engine, alone.pupils[0].engine);
    // What was drawn on one machine is drawn on every other.
    let cylinders = alone.pupils[0].engine.cylinders().iter();
    let drawn: Vec<String> =
        cylinders.map(|one| format!("{} {} {}", one.throw.degrees(), one.position, one.reciprocating_mass)).collect();
    assert_eq!(drawn.join(", "), DRAWN);
}

/// Of José Müller, seed 7.
const DRAWN: &str = "210 9/100 2, 330 0 2, 90 -9/100 2, 150 9/100 2, 270 0 2, 30 -9/100 2";

#[test]
fn the_sheets_of_a_class_differ_and_leave_something_to_find() {
    let names: String = (0..60).map(|index| format!("Student {index}\n")).collect();
    for layout in ["I4", "I5-12453", "V8-crossplane", "V6-60-even", "boxer-4", "radial-5", "V2-90"] {
        let base = engine(layout);
        let zeros = |engine: &Engine| -> BTreeSet<bool> {
            let stars = [1, 2].map(|order| Star::of(engine, order));
            let sums =
                stars.iter().flat_map(|star| SUMS.map(|of| Sense::BOTH.map(|sense| star.sum(of, sense).vanishes())));
            sums.flatten().collect()
        };
        let class = draw(layout, &names, 3);
        let different: BTreeSet<String> =
            class.pupils.iter().map(|pupil| format!("{:?}", pupil.engine.cylinders())).collect();
        assert!(different.len() > 40, "{layout}: only {} different sheets", different.len());
        for pupil in &class.pupils {
            assert!(zeros(&pupil.engine).is_superset(&zeros(&base)), "{layout}: {}", pupil.file);
            assert_eq!(pupil.engine.cylinders().len(), base.cylinders().len());
        }
        let plain =
            Exercise::draw(&base, &[1, 2], &students("Ada").expect("a list"), 3, Vary::NOTHING).expect("it reads");
        for order in [1, 2] {
            assert_eq!(Star::of(&plain.pupils[0].engine, order), Star::of(&base, order), "{layout}");
        }
    }
}

#[test]
fn names_lead_nowhere_else_and_no_two_students_have_the_same_files() {
    let list = "../../etc/passwd\n/root/.ssh\n..\n.\n\\\\host\\share\nC:\\x\nCON\ncom1\n\u{202e}evil\nAda\nada\nAda\nada 2\n王\n李\n\u{0}\n";
    let list = students(list).expect("a list");
    let files: BTreeSet<&str> = list.iter().map(|student| student.file.as_str()).collect();
    assert_eq!(files.len(), list.len(), "{files:?}");
    for file in files {
        let is_plain = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-';
        assert!(!file.is_empty() && file.len() < 70 && file.chars().all(is_plain), "{file}");
        assert!(!["con", "com1"].contains(&file) && !file.starts_with('-'), "{file}");
    }
    assert_eq!(list.iter().filter(|student| student.is_namesake).count(), 1);
    assert!(students("\n \n").is_err() && students(&"x".repeat(201)).is_err());
}

#[test]
fn the_file_of_an_exercise_reads_back_as_it_was_whatever_the_names_are() {
    let names = "\"quote\" \\ back\n'''\n\"\"\"\n# no\n[x]\n<b>\n\u{7}bell\nمحمد\n";
    let exercise = draw("V8-crossplane", names, 5);
    let again = parse_exercise("exercise.toml", &exercise.to_toml()).expect("it reads");
    assert_eq!((again.seed, &again.orders), (5, &vec![1, 2]));
    assert_eq!(again.pupils.len(), exercise.pupils.len());
    for (one, other) in exercise.pupils.iter().zip(&again.pupils) {
        assert_eq!((&one.name, &one.file), (&other.name, &other.file));
        assert_eq!(one.engine.cylinders(), other.engine.cylinders());
    }
}

/// What student `index` of the class hands in: the text, and the points, of 48, with how many entries are right, following, wrong, missing.
fn student(index: usize, pupil: &Pupil) -> (Option<String>, Option<(BigRational, [usize; 4])>) {
    let answers = answers(pupil, 4);
    let all = |points, counts| Some((number(points), counts));
    match index % 10 {
        0..=2 => (Some(toml(pupil, "", &answers)), all(48, [40, 0, 0, 0])),
        3 => {
            // To two decimals, and one sum wrong in the last of them.
            let mut rounded = [1, 2].map(|order| right(&pupil.engine, order, 2)).to_vec();
            let sums = rounded.iter_mut().flat_map(|answer| answer.sums.iter_mut().flatten());
            let sum = sums.into_iter().find(|sum| *sum != "0").expect("something is left");
            *sum = format!("{:.2}", sum.parse::<f64>().expect("a number") + 0.01);
            (Some(toml(pupil, "", &rounded)), all(46, [39, 0, 1, 0]))
        }
        4 => {
            let off = |cylinder| if cylinder == 2 { [15.0, 0.0] } else { [0.0, 0.0] };
            let wrong = [with_wrong_phases(&pupil.engine, 1, 4, off), answers[1].clone()];
            (Some(toml(pupil, "", &wrong)), all(47, [37, 2, 1, 0]))
        }
        5 => (
            Some(toml(pupil, "sense = 'clockwise'", &answers.iter().map(mirrored).collect::<Vec<_>>())),
            all(48, [40, 0, 0, 0]),
        ),
        6 => {
            // Phases that are their own mirror images are right all the same, and so are the lengths.
            let phases = answers.iter().flat_map(|answer| answer.phases.iter().flatten());
            let own = phases.filter(|phase| ["0.00000", "180.00000"].contains(&phase.as_str())).count();
            let mirror = answers.iter().map(mirrored).collect::<Vec<_>>();
            let (points, counts) =
                if own + 16 > 24 { (own + 16, [own + 8, 0, 32 - own, 0]) } else { (24, [40, 0, 0, 0]) };
            (Some(toml(pupil, "", &mirror)), all(points as i64, counts))
        }
        7 => {
            let mut missing = answers;
            missing[1].phases.pop();
            missing[0].sums[1][0].clear();
            (Some(toml(pupil, "", &missing)), all(44, [37, 0, 0, 3]))
        }
        8 => (Some(toml(pupil, "", &answers).replace("order = 2", "order = ")), None),
        _ => (None, None),
    }
}

#[test]
fn a_class_of_sixty_is_marked_as_each_deserves_and_no_sheet_stops_another() {
    let folder = scratch("classroom-sixty");
    let names: String = (0..60).map(|index| format!("Ada Müller {index}\n")).collect();
    fs::write(folder.join("class.txt"), names).expect("a list");
    let path = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let done = call(&[
        "exercise",
        "V8-crossplane",
        "--students",
        &path("class.txt"),
        "--seed",
        "11",
        "--output",
        &path("out"),
    ]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let key = fs::read_to_string(folder.join("out/exercise.toml")).expect("the exercise");
    let exercise = parse_exercise("exercise.toml", &key).expect("it reads");
    assert_eq!(exercise.pupils.len(), 60);
    let expected: Vec<_> = exercise
        .pupils
        .iter()
        .enumerate()
        .map(|(index, pupil)| {
            for file in [
                format!("sheets/{0}/{0}.toml", pupil.file),
                format!("sheets/{}/sheet.md", pupil.file),
                format!("solutions/{}/solutions.md", pupil.file),
            ] {
                assert!(folder.join("out").join(&file).is_file(), "{file}");
            }
            let (text, expected) = student(index, pupil);
            let place = folder.join("handed-in").join(format!("{index}"));
            fs::create_dir_all(&place).expect("a folder");
            let has_text = text.is_some();
            if let Some(text) = text {
                fs::write(place.join(format!("{}.toml", pupil.file)), text).expect("a file");
            }
            (has_text, expected)
        })
        .collect();
    let output = call(&["mark", &path("handed-in"), "--exercise", &path("out/exercise.toml"), "--format", "csv"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let marks = String::from_utf8(output.stdout).expect("a text");
    assert_eq!(marks.lines().count(), 61);
    for ((line, pupil), (index, (has_text, expected))) in
        marks.lines().skip(1).zip(&exercise.pupils).zip(expected.iter().enumerate())
    {
        let begin = match (has_text, expected) {
            (true, Some((points, [right, follows, wrong, missing]))) => {
                let percent = (points * number(10000) / number(48)).round() / number(100);
                let percent = file::exact_number(&percent);
                format!(
                    "Ada Müller {index},{},marked,{points},48,{percent},{right},{follows},{wrong},0,{missing},",
                    pupil.file
                )
            }
            (true, None) => format!("Ada Müller {index},{},unreadable,", pupil.file),
            (false, _) => format!("Ada Müller {index},{},not handed in,", pupil.file),
        };
        assert!(line.starts_with(&begin), "{line}\nis not\n{begin}");
        assert!(index % 10 != 8 || line.contains("line "), "the place of the mistake: {line}");
        assert!(index % 10 != 5 || line.contains("sense clockwise"), "{line}");
    }
    let pages =
        call(&["mark", &path("handed-in"), "--exercise", &path("out/exercise.toml"), "--output", &path("marks")]);
    assert!(pages.status.success());
    let count = |name: &str| fs::read_dir(folder.join(name)).expect("a folder").count();
    assert_eq!(count("marks/students"), 48);
    let one =
        fs::read_to_string(folder.join(format!("marks/students/{}.md", exercise.pupils[4].file))).expect("a page");
    assert!(one.contains("**47 of 48 points.**") && one.matches("**follows**").count() == 3, "{one}");
    assert!(one.contains("cylinder 3, direct phase") && one.contains("**wrong**"), "{one}");
}

#[test]
fn every_engine_has_its_sums_and_a_right_table_brings_all_points_in_every_convention() {
    let mut dice = Dice::new(15);
    let (mut found, mut consequential) = (0, 0);
    while found < 60 {
        let text = every_form::known(&mut dice);
        let Ok(engine) = file::parse("layout.toml", &text) else { continue };
        // Links have several vectors, and crankshafts of several speeds a star for each: neither has a table with a row per cylinder.
        if !engine.has_links() && engine.faster_crank().is_none() {
            for (order, quantity) in [(1, SUMS[0]), (2, SUMS[1]), (4, SUMS[0])] {
                let star = Star::of(&engine, order);
                for sense in Sense::BOTH {
                    let right = order::star(&engine, quantity, order, Some(sense));
                    assert!(
                        engine.has_offset() || star.sum(quantity, sense).minus(&right).vanishes(),
                        "order {order}\n{text}"
                    );
                }
            }
        }
        if can_be_set(&engine).is_err() {
            continue;
        }
        let list = students(&format!("Student {found}")).expect("a list");
        let exercise = Exercise::draw(&engine, &[1, 2], &list, found, Vary::ALL).expect("an engine");
        let pupil = &exercise.pupils[0];
        let all = |sheet: &MarkedSheet| assert_eq!(sheet.points, sheet.possible, "{text}\n{sheet:?}");
        let right = answers(pupil, 6);
        all(&marked(&exercise, &toml(pupil, "", &right)));
        // The mirror image and the exchange of the columns, from the right table by hand.
        let mirror: Vec<Answer> = right.iter().map(mirrored).collect();
        all(&marked(&exercise, &toml(pupil, "sense = 'clockwise'", &mirror)));
        let exchange = |answer: &Answer| {
            let mut other = answer.clone();
            other.phases.iter_mut().for_each(|phases| phases.reverse());
            other.sums.iter_mut().for_each(|sums| sums.reverse());
            other
        };
        let exchanged: Vec<Answer> = right.iter().map(exchange).collect();
        all(&marked(&exercise, &toml(pupil, "vectors = 'swapped'", &exchanged)));
        // Reversed throws: the table of the engine that has them.
        let mut draft = pupil.engine.clone().into_draft();
        draft.cylinders.iter_mut().for_each(|cylinder| cylinder.throw = -&cylinder.throw);
        // Cylinders on one pin keep what they had in common.
        let reversed = Pupil { engine: draft.build().expect("an engine"), ..pupil.clone() };
        all(&marked(&exercise, &toml(pupil, "throws = 'reversed'", &answers(&reversed, 6))));
        // Another plane: the moments about the first cylinder.
        let mut draft = pupil.engine.clone().into_draft();
        let plane = draft.cylinders[0].position.clone();
        draft.reference_plane = crankstar::engine::ReferencePlane::Named(plane.clone());
        let moved = Pupil { engine: draft.build().expect("an engine"), ..pupil.clone() };
        all(&marked(&exercise, &toml(pupil, &format!("plane = '{plane}'"), &answers(&moved, 6))));
        // One wrong phase: the sums of its column are those of the phases that are written.
        let off = |cylinder| if cylinder == 0 { [0.0, 37.0] } else { [0.0, 0.0] };
        let wrong = [with_wrong_phases(&pupil.engine, 1, 6, off), right[1].clone()];
        let sheet = marked(&exercise, &toml(pupil, "", &wrong));
        assert_eq!(sheet.counts().wrong, 1, "{text}\n{sheet:?}");
        assert_eq!(sheet.points, &sheet.possible - number(1), "{text}");
        consequential += sheet.counts().consequential;
        found += 1;
    }
    assert!(consequential > 60, "only {consequential} sums followed");
}

#[test]
fn a_number_is_judged_within_its_own_digits_and_an_exact_one_exactly() {
    let exercise = Exercise::draw(&engine("V8-crossplane"), &[1], &students("Ada").expect("a list"), 1, Vary::NOTHING)
        .expect("an engine");
    // The moment of order 1 is 2√10.
    let judged = |written: &str| {
        let sheet = marked(&exercise, &format!("[[table]]\norder = 1\nsums = {{ moment_direct = \"{written}\" }}"));
        sheet.tables[0].entries.iter().find(|entry| entry.written.is_some()).expect("an entry").judged
    };
    for right in ["2√10", "2 sqrt(10)", "sqrt(40)", "√10·2", "6.3", "6,32", "6.325", "6.3246", "6.32455532033675866"]
    {
        assert_eq!(judged(right), Judged::Right, "{right}");
    }
    for wrong in ["6.31", "6.33", "6.3245", "6.32455532033675867", "6", "7", "0", "0.0", "√41", "-6.32", "6.320"] {
        assert_eq!(judged(wrong), Judged::Wrong, "{wrong}");
    }
    for unreadable in ["six", "6..3", "√", "6.3 kg", "1/0"] {
        assert_eq!(judged(unreadable), Judged::Unreadable, "{unreadable}");
    }
    let five = Exercise::draw(&engine("I5-12453"), &[1], &students("Ada").expect("a list"), 1, Vary::NOTHING)
        .expect("an engine");
    let star = Star::of(&five.pupils[0].engine, 1).sum(SUMS[1], Sense::BOTH[0]);
    let exact = crankstar::numbers::modulus(&star).expect("a closed form").to_string();
    let decimal = crankstar::numbers::evaluate(&star).norm();
    for (written, expected) in [
        (exact.as_str(), Judged::Right),
        (&format!("{decimal:.3}"), Judged::Right),
        ("2 sin 36°", Judged::Wrong),
        ("2 sin(36 deg)", Judged::Wrong),
    ] {
        let sheet = marked(&five, &format!("[[table]]\norder = 1\nsums = {{ moment_direct = \"{written}\" }}"));
        assert_eq!(
            sheet.tables[0].entries.iter().find(|entry| entry.written.is_some()).expect("it").judged,
            expected,
            "{written}"
        );
    }
}

#[test]
fn trigonometric_lengths_are_judged_exactly() {
    // Two of five throws: |1 + e^(2πi/5)| = 2 cos 36°, |1 − e^(2πi/5)| = 2 sin 36°.
    for (throws, length, near) in [("0, 72", "2 cos 36°", "1.61803398875"), ("0, 252", "2 sin 36°", "1.1755705046")] {
        let two = file::parse("layout.toml", &format!("inline.throws = [{throws}]")).expect("it reads");
        let list = students("Ada").expect("a list");
        let exercise = Exercise::draw(&two, &[1], &list, 1, Vary::NOTHING).expect("an engine");
        let counts = |written: &str| {
            marked(&exercise, &format!("[[table]]\norder = 1\nsums = {{ force_direct = \"{written}\" }}")).counts()
        };
        assert_eq!(counts(length).right, 1, "{length}");
        assert_eq!(counts(near).right, 1, "{near}");
        assert_eq!(counts(&near.replace('.', "0.")).right, 0);
        assert_eq!(counts("2 sin 35.9999999°").wrong, 1);
    }
}

#[test]
fn phases_count_modulo_a_turn_and_within_their_own_digits() {
    let seven = file::parse("layout.toml", "inline.throws = [0, '1/7 turn']").expect("it reads");
    let exercise =
        Exercise::draw(&seven, &[1], &students("Ada").expect("a list"), 1, Vary::NOTHING).expect("an engine");
    let counts = |written: &str| {
        let row = format!("[[table]]\norder = 1\nrows = [{{ cylinder = 2, direct = \"{written}\" }}]");
        marked(&exercise, &row).counts()
    };
    for right in [
        "1/7 turn",
        "360/7",
        "51.43",
        "51,4",
        "51.4°",
        "-308.57",
        "411.4286",
        "2/7 pi rad",
        "0.14286 turn",
        "≈ 0,1429 turn",
        "0.2857 pi rad",
    ] {
        assert_eq!(counts(right).right, 1, "{right}");
    }
    for wrong in ["51", "51.44", "51.428", "52.43", "0", "0.14285 turn", "0.2858 pi rad"] {
        assert_eq!(counts(wrong).wrong, 1, "{wrong}");
    }
    assert_eq!(counts("51.4.3").unreadable, 1);
    // The mirror image is another convention, which is not declared.
    let row = "[[table]]\norder = 1\nrows = [{ cylinder = 2, direct = \"-51.43\" }]";
    let sheet = marked(&exercise, row);
    assert!(sheet.counts().right == 1 && sheet.undeclared[0].clockwise);
}

/// Far away a moment is the force many times over.
#[test]
fn a_plane_has_a_comma_too_and_is_not_far_from_the_engine() {
    let exercise = draw("V6-60-even", "Ada", 4);
    let outcome = |plane: &str| {
        let text = format!("[convention]\nplane = '{plane}'\n[[table]]\norder = 1\n");
        mark_class(&exercise, vec![handed_in("ada.toml", text)], &Scheme::default()).remove(0).outcome
    };
    let near = outcome("1,5");
    assert!(matches!(near, Outcome::Marked(_)), "{near:?}");
    match outcome("1000000") {
        Outcome::Unreadable(why) => {
            assert!(why.escaped(crankstar::text::Format::Plain).contains("ten times the length"))
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn lines_of_a_spreadsheet_say_the_same_as_toml() {
    let exercise = draw("V6-60-even", "Ada Lovelace\nMüller, José\n\"Q\"", 4);
    let mut lines = String::new();
    for (index, pupil) in exercise.pupils.iter().enumerate() {
        let filled = csv_to_fill_in(pupil, &[1, 2]);
        let answers = answers(pupil, 4);
        for (number, line) in filled.lines().enumerate().filter(|(number, _)| index == 0 || *number > 0) {
            let value = |row: &str, order: usize| -> Option<[String; 2]> {
                let answer = &answers[order];
                if let Some(name) = row.strip_prefix("cylinder ") {
                    let place = pupil.engine.cylinders().iter().position(|cylinder| cylinder.name == name)?;
                    return Some(answer.phases[place].clone());
                }
                Some(answer.sums[usize::from(row == "sum of moments")].clone())
            };
            let fields: Vec<&str> = line.rsplitn(5, ',').collect();
            let order = fields.get(3).and_then(|order| order.parse::<usize>().ok());
            match order.filter(|_| number > 0).and_then(|order| value(fields[2], order - 1)) {
                Some([direct, reverse]) => {
                    lines.push_str(&format!("{},{},{},{direct},{reverse}\n", fields[4], fields[3], fields[2]))
                }
                None => lines.push_str(&format!("{line}\n")),
            }
        }
    }
    let counts = |text: String| -> Vec<Counts> {
        let results = mark_class(&exercise, vec![handed_in("all.csv", text)], &Scheme::default());
        assert_eq!(results.len(), 3, "{results:?}");
        results
            .into_iter()
            .map(|result| match result.outcome {
                Outcome::Marked(sheet) => sheet.counts(),
                other => panic!("{other:?}"),
            })
            .collect()
    };
    let right = Counts { right: 32, ..Counts::default() };
    assert_eq!(counts(lines.clone()), [right; 3], "{lines}");
    // As a spreadsheet in German writes it.
    let german = lines
        .replace("\"Müller, José\"", "Müller; José")
        .replace(',', ";")
        .replace("Müller; José", "\"Müller, José\"")
        .replace('.', ",");
    assert_eq!(counts(format!("\u{feff}{}", german.replace('\n', "\r\n"))), [right; 3], "{german}");
    assert_eq!(counts(format!("sep=;\r\n{german}")), [right; 3], "{german}");
}

#[test]
fn what_cannot_be_marked_is_told_and_stops_no_other() {
    let exercise = draw("I4", "Ada\nBob\nCarl\nDora\nEve\nFred\nGeorge", 2);
    let [ada, bob, carl, ..] = exercise.pupils.as_slice() else { panic!("students") };
    let right = toml(ada, "", &answers(ada, 4));
    let files = vec![
        handed_in("x.toml", right.clone()),
        handed_in("bob.toml", "rows = ["),
        handed_in("carl-1.toml", toml(carl, "", &answers(carl, 4))),
        handed_in("carl-2.toml", toml(carl, "", &answers(carl, 4))),
        handed_in("carl-3.toml", toml_to_fill_in(carl, &[1, 2])),
        handed_in("d.toml", "student = 'Dora'\n[[table]]\norder = 6"),
        handed_in("e.toml", "student = 'Eve'\n[[table]]\norder = 1\nrows = [{ cylinder = 9 }]"),
        handed_in("f.toml", "student = 'Fred'\n[convention]\nsense = 'left'"),
        handed_in("g.toml", right.replace("sheet = \"ada\"", "sheet = \"george\"\nstudent = \"Ada\"")),
        handed_in("h.toml", "student = 'Mallory'"),
        HandedIn { name: "i.toml".to_owned(), content: Content::Unreadable("no permission".to_owned()) },
        handed_in("j.csv", "a,b\n1,2"),
    ];
    let results = mark_class(&exercise, files, &Scheme::default());
    let told: Vec<String> = results
        .iter()
        .map(|result| match &result.outcome {
            Outcome::Marked(sheet) => format!("{} of {}", sheet.points, sheet.possible),
            Outcome::Unreadable(why) => why.escaped(crankstar::text::Format::Plain),
            Outcome::NotHandedIn => "none".to_owned(),
            Outcome::HandedInTwice => "twice".to_owned(),
            Outcome::NotRead(why) => why.to_string(),
        })
        .collect();
    let keywords = [
        "32 of 32",
        "line 1",
        "twice",
        "0 of 32",
        "line 4: cannot read the cylinder `9`",
        "line 3: cannot read the sense `left`",
        "none",
        "not that of `Ada`",
        "Mallory",
        "no permission",
        "columns",
    ];
    assert_eq!(told.len(), keywords.len(), "{told:#?}");
    for (told, keyword) in told.iter().zip(keywords) {
        assert!(told.contains(keyword), "{keyword}: {told}");
    }
    assert_eq!(bob.file, "bob");
    assert_eq!(csv(&marks_table(&results)).lines().count(), 12);
}

#[test]
fn a_scheme_counts_as_it_says_and_a_wrong_one_is_told_with_its_place() {
    let scheme =
        parse_scheme("scheme.toml", "phase = '1/2'\nsum = 4\nconsequential = 0.25\nundeclared = 1").expect("a scheme");
    let exercise = draw("V8-crossplane", "Ada", 1);
    let pupil = &exercise.pupils[0];
    let off = |cylinder| if cylinder == 0 { [10.0, 0.0] } else { [0.0, 0.0] };
    let wrong = [with_wrong_phases(&pupil.engine, 1, 4, off), right(&pupil.engine, 2, 4)];
    let results = mark_class(&exercise, vec![handed_in("ada.toml", toml(pupil, "", &wrong))], &scheme);
    let Outcome::Marked(sheet) = &results[0].outcome else { panic!("not marked") };
    // 32 phases and 8 sums; one phase is wrong, two sums follow.
    assert_eq!(
        (&sheet.possible, &sheet.points),
        (&number(48), &(number(48) - BigRational::new(1.into(), 2.into()) - number(6)))
    );
    for (text, place) in [
        ("phase = -1", "scheme.toml:1"),
        ("sum = 2\nconsequential = 2", "scheme.toml:2"),
        ("colour = 1", "colour"),
        ("sum = 'x'", "scheme.toml:1"),
        ("phase = 0\nsum = 0", "no entry earns a point"),
    ] {
        let message = parse_scheme("scheme.toml", text).expect_err(text).to_string();
        assert!(message.contains(place), "{message}");
    }
    assert_eq!(parse_scheme("scheme.toml", &scheme.to_toml()).expect("it reads"), scheme);
}

#[test]
fn another_convention_that_is_not_declared_is_named_with_all_that_are_alike() {
    let exercise = draw("I4", "Student 5", 9);
    let pupil = &exercise.pupils[0];
    let mirror: Vec<Answer> = answers(pupil, 4).iter().map(mirrored).collect();
    let sheet = marked(&exercise, &toml(pupil, "", &mirror));
    assert!(sheet.declared == Convention::default() && sheet.undeclared.len() > 1, "{sheet:?}");
    assert_eq!(sheet.points, &sheet.possible / number(2));
    assert!(sheet.undeclared[0].clockwise && sheet.undeclared.iter().any(|one| one.swapped && !one.clockwise));
}

#[test]
fn pages_of_a_class_have_german_for_every_phrase_and_show_names_as_texts() {
    let exercise = draw("V6-60-even", "<script>alert(1)</script>\n$x$ | `y`\nBob\nEve\nCarl", 2);
    let [first, second, bob, ..] = exercise.pupils.as_slice() else { panic!("students") };
    let mirror: Vec<Answer> = answers(bob, 4).iter().map(mirrored).collect();
    let off = |cylinder| if cylinder == 0 { [10.0, 0.0] } else { [0.0, 0.0] };
    let mut wrong = [with_wrong_phases(&first.engine, 1, 4, off), right(&first.engine, 2, 4)];
    wrong[1].phases[1] = ["?".to_owned(), String::new()];
    let files = vec![
        handed_in("1.toml", toml(first, "", &wrong)),
        handed_in("2.toml", toml(second, "sense = 'clockwise'\nplane = '0 mm'", &answers(second, 4))),
        handed_in("3.toml", toml(bob, "", &mirror)),
        handed_in("eve.toml", "["),
        handed_in("4.toml", "student = '<b>'"),
    ];
    let scheme = Scheme::default();
    let results = mark_class(&exercise, files, &scheme);
    let mut pages = vec![report::marks_page(&exercise, &results, &scheme), report::marks_answer(&results, &scheme)];
    for pupil in &exercise.pupils {
        pages.push(report::exercise_sheet(pupil, &[1, 2], "x.toml", &scheme));
        pages.push(report::exercise_solutions(pupil, &[1, 2]).expect("orders"));
    }
    for result in &results {
        if let (Some(pupil), Outcome::Marked(sheet)) = (result.pupil, &result.outcome) {
            pages.push(report::marked_page(pupil, sheet, &scheme));
        }
    }
    let plain =
        Exercise::draw(&engine("I4"), &[1], &students("Ada").expect("a list"), 1, Vary::NOTHING).expect("an engine");
    pages.push(report::exercise_sheet(&plain.pupils[0], &[1], "x.toml", &scheme));
    let phrases: BTreeSet<&str> = pages.iter().flat_map(phrases).collect();
    let missing: Vec<&&str> = phrases.iter().filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
    for page in &pages {
        for format in [Format::GITHUB, Format::Html, Format::Latex, Format::Typst, Format::PLAIN] {
            let text = &page::write(page, format, &Options::default())[0].text;
            assert!(format == Format::PLAIN || !text.contains("<script>alert"), "{format:?}");
        }
    }
}

#[test]
fn the_command_writes_nothing_outside_of_its_folder_and_refuses_what_makes_no_table() {
    let folder = scratch("classroom-names");
    fs::write(folder.join("class.txt"), "../evil\n/tmp/evil\nAda\nAda\n").expect("a list");
    let run = |arguments: &[&str]| program().current_dir(&folder).args(arguments).output().expect("it starts");
    let done =
        run(&["exercise", "I4", "--students", "class.txt", "--output", "out", "--table", "csv", "--vary", "throws"]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(String::from_utf8_lossy(&done.stderr).contains("`Ada` is in the list before"));
    let names = |folder: &Path| -> BTreeSet<String> {
        let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        entries.map(|name| name.to_string_lossy().into_owned()).collect()
    };
    assert_eq!(names(&folder), BTreeSet::from(["class.txt".to_owned(), "out".to_owned()]));
    let files = ["ada", "ada-2", "evil", "tmp-evil"].map(str::to_owned);
    assert_eq!(names(&folder.join("out/sheets")), BTreeSet::from(files.clone()));
    assert_eq!(names(&folder.join("out/solutions")), BTreeSet::from(files));
    assert!(names(&folder.join("out/sheets/ada-2")).contains("ada-2.csv"));
    for (arguments, keyword) in [
        (vec!["exercise", "I4", "--students", "class.txt"], "--output"),
        (vec!["exercise", "radial-7-master"], "articulated"),
        (vec!["exercise", "I4", "--orders", "3"], "order 3"),
        (vec!["exercise", "I4", "--vary", "nothing,throws"], "alone"),
        (vec!["exercise", "I4", "--students", "nobody.txt"], "no list of students `nobody.txt`"),
        (vec!["exercise", "I4", "--units", "inch"], "omit --units"),
        (vec!["mark", "."], "exercise.toml"),
        (vec!["mark", "class.txt", "--exercise", "out/exercise.toml"], "neither a folder nor a CSV"),
        (vec!["mark", "out", "--scheme", "class.txt"], "class.txt"),
    ] {
        let output = run(&arguments);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && told.contains(keyword), "{arguments:?}: {told}");
    }
    // As a spreadsheet or an old editor saves them: Windows-1252, and UTF-16 with its mark.
    let utf16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    for (list, bytes) in [("ansi", b"J\xf6rg\r\nAda".to_vec()), ("unicode", utf16("\u{feff}Jörg\r\nAda"))] {
        fs::write(folder.join(list), bytes).expect("a list");
        let output = format!("out-{list}");
        let done = run(&["exercise", "I4", "--students", list, "--output", &output]);
        assert!(done.status.success(), "{list}: {}", String::from_utf8_lossy(&done.stderr));
        let expected = BTreeSet::from(["ada", "joerg"].map(str::to_owned));
        assert_eq!(names(&folder.join(output).join("sheets")), expected, "{list}");
    }
    fs::write(folder.join("table.xlsx"), b"PK\x03\x04\0\0\xff").expect("no list");
    let told = run(&["exercise", "I4", "--students", "table.xlsx", "--output", "none"]);
    assert!(String::from_utf8_lossy(&told.stderr).contains("`table.xlsx` is not a text"));
    let sheet = run(&["exercise", "I4", "--seed", "3"]);
    assert!(sheet.status.success() && String::from_utf8_lossy(&sheet.stdout).contains("## To find"));
}

#[test]
fn the_independent_student_agrees_with_the_program() {
    let engine = engine("V8-crossplane");
    let [direct, reverse] = vectors(&engine, 1, SUMS[1], |_| [0.0, 0.0]);
    assert_eq!([direct, reverse].map(|vector| decimals(vector.norm(), 6)), ["6.324555", "0"]);
}

/// SplitMix64 as Steele, Lea and Flood have it.
fn splitmix64(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mixed = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

#[test]
fn the_generator_is_splitmix64_from_an_fnv_1a_hash() {
    let mut known = 1_234_567;
    let bits = [splitmix64(&mut known), splitmix64(&mut known)];
    assert_eq!(bits, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973]);
    // FNV-1a of "a" is af63dc4c8601ec8c; nine zero bytes more only multiply.
    let mut state = (0..9).fold(0xaf63_dc4c_8601_ec8c_u64, |hash, _| hash.wrapping_mul(0x0000_0100_0000_01b3));
    let mut draw = Draw::of("a", 0);
    for _ in 0..3 {
        assert_eq!(draw.bits(), splitmix64(&mut state));
    }
}

#[test]
fn a_layout_that_is_drawn_clockwise_is_given_as_it_is_drawn() {
    let layout = "rotation = 'clockwise'\nseen_from = 'flywheel'\n\
        vee = { bank_angle = 70, throws = [10, 130, 250], pin_split = 20, spacing = '100 mm', bank_offset = '20 mm' }\n";
    let engine = file::parse("layout.toml", layout).expect("it reads");
    let exercise = Exercise::draw(&engine, &[1], &students("Ada").expect("a list"), 1, Vary::NOTHING).expect("engines");
    let given = &exercise.pupils[0].engine;
    assert_eq!(given.convention(), engine.convention());
    let angles = |engine: &Engine| -> Vec<_> {
        engine.cylinders().iter().map(|one| (one.throw.clone(), one.bank.clone(), one.position.clone())).collect()
    };
    assert_eq!(angles(given), angles(&engine));
}
