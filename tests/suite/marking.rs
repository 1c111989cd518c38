//! Is what a class hands in read as it was meant, is nothing lost, and does nobody pay for another's mistake?

use std::fs;

use crankstar::claim::Judged;
use crankstar::classroom::{
    Distribution, Exercise, Outcome, Pupil, Scheme, Vary, mark_class, parse_exercise, parse_scheme, students,
};
use crankstar::file;
use crankstar::page;
use crankstar::report;
use crankstar::text::Format;
use crankstar::{BigRational, numbers};

use crate::support::class::{bytes, class_file, draw, right, sheet, toml, with_wrong_phases};
use crate::support::dice::Dice;
use crate::support::program::{program, scratch};

#[test]
fn an_exercise_among_the_sheets_writes_nowhere_else() {
    let folder = scratch("marking-traversal");
    let exercise = draw("I4", "Ada", &[1]);
    let table = toml(&exercise.pupils[0], "", &[right(&exercise.pupils[0].engine, 1, 4)]);
    for name in ["../../evil", "/tmp/evil", "..", ".", "", "a/b", "a\\b", "C:evil", "con", "Ada", "a\u{0}"] {
        let told = exercise.to_toml().replace("file = \"ada\"", &format!("file = {}", toml_string(name)));
        assert_ne!(told, exercise.to_toml());
        let error = parse_exercise("exercise.toml", &told).expect_err(name).to_string();
        assert!(error.contains("not a name of a student's files") && error.contains("hyphens"), "{name}: {error}");
    }
    fs::create_dir_all(folder.join("in/deep")).expect("a folder");
    let told = exercise.to_toml().replace("file = \"ada\"", "file = \"../../evil\"");
    fs::write(folder.join("in/deep/exercise.toml"), told).expect("a file");
    fs::write(folder.join("in/deep/evil.toml"), table.replace("sheet = \"ada\"", "student = \"Ada\"")).expect("a file");
    let run = program().current_dir(folder.join("in/deep")).args(["mark", ".", "--output", "marks"]).output();
    let run = run.expect("it starts");
    assert!(!run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
    assert!(!folder.join("in/evil.md").exists() && !folder.join("evil.md").exists());
    // What exercise writes is read again, the longest names and namesakes too.
    let long = format!("{0}\n{0}\nSolutions\nCON\n{0}", "a very long name ".repeat(9).trim());
    let exercise = draw("I4", &long, &[1]);
    assert_eq!(parse_exercise("e", &exercise.to_toml()).expect("it reads").pupils.len(), 5);
}

fn toml_string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('\u{0}', "\\u0000"))
}

#[test]
fn a_student_may_be_called_solutions() {
    let folder = scratch("marking-solutions");
    let exercise = draw("I4", "Solutions\nAda", &[1]);
    let table = |pupil: &Pupil| toml(pupil, "", &[right(&pupil.engine, 1, 4)]);
    for (student, place) in [("solutions", "in/solutions"), ("ada", "in/ada")] {
        fs::create_dir_all(folder.join(place)).expect("a folder");
        let pupil = exercise.pupils.iter().find(|pupil| pupil.file == student).expect("a student");
        fs::write(folder.join(place).join(format!("{student}.toml")), table(pupil)).expect("a table");
    }
    // Beside the exercise stand the solutions of the lecturer: pages, and no tables.
    fs::write(folder.join("in/exercise.toml"), exercise.to_toml()).expect("a file");
    fs::write(folder.join("in/solutions/solutions.md"), "# Solutions").expect("a file");
    let run = program().current_dir(&folder).args(["mark", "in", "--format", "csv"]).output().expect("it starts");
    let told = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success() && told.lines().count() == 3, "{told}");
    assert!(told.lines().skip(1).all(|line| line.contains(",marked,16,16,100,")), "{told}");
}

#[test]
fn every_file_that_is_not_read_is_named() {
    let folder = scratch("marking-unread");
    let exercise = draw("I4", "Ada\nBob", &[1]);
    let put = |name: &str, text: &str| {
        let path = folder.join("in").join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    };
    fs::create_dir_all(folder.join("in")).expect("a folder");
    fs::write(folder.join("exercise.toml"), exercise.to_toml()).expect("a file");
    put("ada.toml", &toml(&exercise.pupils[0], "", &[right(&exercise.pupils[0].engine, 1, 4)]));
    let unread = ["ada.pdf", "bob.ods", "bob/table.docx", "readme", ".hidden.toml", "1/2/3/4/5/6/deep.toml"];
    unread.iter().for_each(|name| put(name, "x"));
    put("bob/exercise.toml", "seed = 1");
    put("marks.csv", "student,sheet,outcome\nada,ada,marked");
    let run = |arguments: &[&str]| {
        let mut run = program();
        run.current_dir(&folder).args(["mark", "in", "--exercise", "exercise.toml"]).args(arguments);
        String::from_utf8_lossy(&run.output().expect("it starts").stdout).into_owned()
    };
    for told in [run(&[]), run(&["--format", "markdown"]), run(&["--format", "csv"]), run(&["--output", "in/marks"])] {
        let told = told.replace("\n", " ").split_whitespace().collect::<Vec<_>>().join(" ").replace('\\', "");
        for name in unread.iter().take(5).chain(&["1/2/3/4/5/6", "bob/exercise.toml", "marks.csv"]) {
            assert!(told.contains(name), "{name}: {told}");
        }
    }
    // Its own pages are no sheets.
    let again = run(&["--output", "in/marks"]);
    assert_eq!(again.matches("marks.md").count(), 1, "{again}");
    assert!(run(&["--format", "csv"]).contains("Ada,ada,marked,16,16,100"));
}

#[test]
fn a_stray_quote_costs_its_own_row_and_no_other() {
    let exercise = draw("V6-60-even", "Ada\nMüller, José\nBob", &[1, 2]);
    let whole = class_file(&exercise);
    let marks = |lines: &[String]| mark_class(&exercise, vec![bytes("all.csv", lines.join("\n"))], &Scheme::default());
    let full = marks(&whole);
    assert!((0..3).all(|student| sheet(&full, student).counts().right == 32), "{full:?}");
    let mut dice = Dice::new(41);
    let filled = |line: &String| line.matches(',').count() > 3 && !line.ends_with(',') && !line.starts_with("sheet");
    for _ in 0..300 {
        let mut lines = whole.clone();
        let place = dice.below(lines.len() as u64) as usize;
        if !filled(&lines[place]) {
            continue;
        }
        let student = exercise.pupils.iter().position(|pupil| lines[place].starts_with(&format!("{},", pupil.file)));
        let signs: Vec<usize> = lines[place].char_indices().map(|(at, _)| at).collect();
        let at = signs[dice.below(signs.len() as u64) as usize];
        lines[place].insert(at, '"');
        let results = marks(&lines);
        for other in 0..3 {
            let counts = sheet(&results, other).counts();
            let lost = 32 - counts.right;
            let most = if Some(other) == student { 2 } else { 0 };
            assert!(lost <= most, "student {other}, {lost} lost: {}\n{results:?}", lines[place]);
        }
        // What was lost is told.
        let lost = student.is_some_and(|student| sheet(&results, student).counts().right < 32);
        let told = student.is_some_and(|student| {
            let counts = sheet(&results, student).counts();
            counts.unreadable > 0 || !sheet(&results, student).not_read.is_empty()
        });
        assert!(!lost || told || results.len() > 3, "{}\n{results:?}", lines[place]);
    }
}

#[test]
fn lines_are_read_in_the_encodings_of_spreadsheets_and_with_units_in_the_header() {
    let exercise = draw("I4", "Ada\nJosé Müller", &[1, 2]);
    let plain = class_file(&exercise).join("\r\n");
    let header = plain.replacen("direct,reverse", "Direct (deg),Reverse [°]", 1);
    let utf16 = |little: bool| -> Vec<u8> {
        let mark = if little { [0xff, 0xfe] } else { [0xfe, 0xff] };
        let pairs = header.replace(',', "\t");
        let pairs = pairs.encode_utf16().flat_map(|unit| if little { unit.to_le_bytes() } else { unit.to_be_bytes() });
        mark.into_iter().chain(pairs).collect()
    };
    let latin = header.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect::<Vec<u8>>();
    let files = [plain.clone().into_bytes(), header.clone().into_bytes(), latin, utf16(true), utf16(false)];
    for (number, content) in files.into_iter().enumerate() {
        let results = mark_class(&exercise, vec![bytes("all.csv", content)], &Scheme::default());
        assert_eq!(results.len(), 2, "{number}: {results:?}");
        for student in 0..2 {
            assert_eq!(sheet(&results, student).part(), BigRational::from_integer(1.into()), "{number}");
        }
    }
    let table = toml(&exercise.pupils[1], "# Müller", &[right(&exercise.pupils[1].engine, 1, 4)]);
    let latin = table.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect::<Vec<u8>>();
    let results = mark_class(&exercise, vec![bytes("jose-mueller.toml", latin)], &Scheme::default());
    assert_eq!(sheet(&results, 1).counts().right, 12);
    let radians = plain.replacen("direct,", "direct (rad),", 1);
    let results = mark_class(&exercise, vec![bytes("all.csv", radians)], &Scheme::default());
    assert!(format!("{results:?}").contains("direct (rad)"), "{results:?}");
}

/// The only entry of a sheet with one sum of a crank star.
fn judged(throws: &str, key: &str, written: &str, scheme: &Scheme) -> Judged {
    let engine = file::parse("layout.toml", &format!("inline.throws = [{throws}]")).expect("it reads");
    let list = students("Ada").expect("a list");
    let exercise = Exercise::draw(&engine, &[1], &list, 1, Vary::NOTHING).expect("an engine");
    let table = match key {
        "phase" => format!("[[table]]\norder = 1\nrows = [{{ cylinder = 2, direct = \"{written}\" }}]"),
        key => format!("[[table]]\norder = 1\nsums = {{ {key} = \"{written}\" }}"),
    };
    let results = mark_class(&exercise, vec![bytes("ada.toml", table)], scheme);
    let entries = &sheet(&results, 0).tables[0].entries;
    entries.iter().find(|entry| entry.written.is_some()).expect("an entry").judged
}

#[test]
fn entries_are_read_as_people_write_them() {
    let scheme = Scheme::default();
    // |1 + e^(i 60°)| = √3 = 1.7320508…
    for written in ["≈1.732", "≈ 1.73", "~1.73", "1.73 m r", "1.73 m·r", "1.732mr", "≈1,73 m r", "√3 m r", "sqrt(3)"]
    {
        assert_eq!(judged("0, 60", "force_direct", written, &scheme), Judged::Right, "{written}");
    }
    for written in ["≈1.74", "≈3", "1.72 m r", "≈0"] {
        assert_eq!(judged("0, 60", "force_direct", written, &scheme), Judged::Wrong, "{written}");
    }
    // What cannot be read is not wrong.
    for written in ["about two", "1.73 kg r", "1.7.3", "≈", "m r", "\\\"1.73"] {
        assert_eq!(judged("0, 60", "force_direct", written, &scheme), Judged::Unreadable, "{written}");
    }
    // Half of e^(i 60°) − 1: its length is ½.
    assert_eq!(judged("0, 60", "moment_direct", "0.5 m r", &scheme), Judged::Right);
    assert_eq!(judged("0, '1/7 turn'", "phase", "≈51.4°", &scheme), Judged::Right);
    assert_eq!(judged("0, '1/7 turn'", "phase", "≈51°", &scheme), Judged::Coarse);
    assert_eq!(judged("0, '1/7 turn'", "phase", "51.", &scheme), Judged::Coarse);
    assert_eq!(judged("0, '1/7 turn'", "phase", "51", &scheme), Judged::Wrong);
}

#[test]
fn a_number_with_too_few_digits_does_not_earn_all_its_points() {
    let usual = Scheme::default();
    for (throws, key, coarse, fine, enough) in [
        ("0, 60", "force_direct", "2.", "1.7", "1.73"),
        // Half of 2 sin 7.22°: 0.1257.
        ("0, 14.44", "moment_direct", "0.1", "0.13", "0.126"),
    ] {
        assert_eq!(judged(throws, key, coarse, &usual), Judged::Coarse, "{coarse}");
        assert_eq!(judged(throws, key, fine, &usual), Judged::Right, "{fine}");
        let strict = parse_scheme("s", "digits = 3\ncoarse = 0").expect("a scheme");
        assert_eq!(judged(throws, key, fine, &strict), Judged::Coarse, "{fine}");
        assert_eq!(judged(throws, key, enough, &strict), Judged::Right, "{enough}");
        let mild = parse_scheme("s", "digits = 1").expect("a scheme");
        assert_eq!(judged(throws, key, coarse, &mild), Judged::Right, "{coarse}");
    }
    // What is exact has digits enough.
    assert_eq!(judged("0, 90", "force_direct", "√2", &usual), Judged::Right);
    assert_eq!(judged("0, 0", "force_direct", "2", &usual), Judged::Right);
    assert_eq!(judged("0, 0", "force_direct", "2.", &usual), Judged::Right);
    for wrong in ["digits = 0", "digits = 13", "digits = 2.5", "coarse = 2", "digits = 'x'"] {
        assert!(parse_scheme("s", wrong).is_err(), "{wrong}");
    }
    // The points, the sheet and the marks say so.
    let exercise = draw("I4", "Ada", &[1]);
    let pupil = &exercise.pupils[0];
    let marked = |text: &str| {
        let table = format!("[[table]]\norder = 1\nrows = [{{ cylinder = 1, direct = \"{text}\" }}]");
        let results = mark_class(&exercise, vec![bytes("ada.toml", table)], &usual);
        sheet(&results, 0).points.clone()
    };
    let true_phase = right(&pupil.engine, 1, 4).phases[0][0].clone();
    let whole: f64 = true_phase.parse().expect("a number");
    assert_eq!(whole.fract(), 0.0, "throws are multiples of 15°");
    assert_eq!(marked(&format!("{whole}.")), BigRational::from_integer(1.into()));
    let three = parse_scheme("s", "digits = 3").expect("a scheme");
    let text = |scheme: &Scheme| {
        let page = report::exercise_sheet(pupil, &[1], "ada.toml", scheme);
        crankstar::page::write(&page, crankstar::page::Format::PLAIN, &crankstar::page::Options::default())[0]
            .text
            .clone()
    };
    assert!(text(&usual).contains("at least 2 significant") && text(&three).contains("at least 3 significant"));
}

#[test]
fn a_row_with_more_cells_than_columns_counts_nothing_and_is_told() {
    let exercise = draw("I4", "Ada\nBob", &[1, 2]);
    let whole = class_file(&exercise);
    let place = whole.iter().position(|line| line.contains(",cylinder 2,")).expect("a row");
    let marks = |line: String| {
        let mut lines = whole.clone();
        lines[place] = line;
        mark_class(&exercise, vec![bytes("all.csv", lines.join("\n"))], &Scheme::default())
    };
    let (before, _) = whole[place].rsplit_once(',').expect("cells");
    let (before, _) = before.rsplit_once(',').expect("cells");
    for more in [",6,32,", ",6,32,7", ",0,0,0", ",,,x"] {
        let results = marks(format!("{before}{more}"));
        let ada = sheet(&results, 0);
        assert_eq!((ada.counts().missing, ada.counts().wrong, ada.counts().unreadable), (2, 0, 0), "{more}");
        let told: Vec<String> = ada.not_read.iter().map(|row| row.escaped(Format::Plain)).collect();
        assert!(told.len() == 1 && told[0].starts_with(&format!("line {}: more cells", place + 1)), "{told:?}");
        assert_eq!(sheet(&results, 1).not_read.len(), 0, "{more}");
    }
    let empty = marks(format!("{before},,,"));
    assert!(sheet(&empty, 0).not_read.is_empty() && sheet(&empty, 0).counts().missing == 2, "{empty:?}");
}

#[test]
fn an_order_that_is_not_asked_for_costs_itself_and_is_told_with_its_line() {
    let exercise = draw("I4", "Ada\nBob", &[1, 2]);
    let mut lines = class_file(&exercise);
    let row = lines.iter().position(|line| line.contains(",1,cylinder 1,")).expect("a row");
    let stray = lines[row].replace(",1,cylinder 1,", ",5,cylinder 1,");
    lines.insert(row, stray);
    let tables = [1, 5, 2].map(|order| right(&exercise.pupils[0].engine, order, 4));
    let table = toml(&exercise.pupils[0], "", &tables);
    let line = table.lines().position(|line| line == "order = 5").expect("a table") + 1;
    for (name, content, line) in [("all.csv", lines.join("\n"), row + 1), ("ada.toml", table, line)] {
        let results = mark_class(&exercise, vec![bytes(name, content)], &Scheme::default());
        let ada = sheet(&results, 0);
        assert_eq!(ada.points, ada.possible, "{ada:?}");
        let told: Vec<String> = ada.not_read.iter().map(|row| row.escaped(Format::Plain)).collect();
        assert_eq!(told, [format!("line {line}: order 5 is not asked for; the orders are 1, 2")]);
    }
}

#[test]
fn nothing_that_is_said_of_a_csv_speaks_of_toml() {
    let exercise = draw("I4", "Ada\nAda\nBob", &[1, 2]);
    let whole = class_file(&exercise).join("\n");
    let mut dice = Dice::new(7);
    let mut told = String::new();
    let mut hand_in = |name: &str, content: Vec<u8>| {
        for result in mark_class(&exercise, vec![bytes(name, content)], &Scheme::default()) {
            match &result.outcome {
                Outcome::Unreadable(why) => told.push_str(&(why.escaped(Format::Plain) + "\n")),
                Outcome::NotRead(why) => told.push_str(&format!("{why}\n")),
                Outcome::Marked(sheet) => {
                    sheet.not_read.iter().for_each(|row| told.push_str(&(row.escaped(Format::Plain) + "\n")));
                }
                Outcome::NotHandedIn | Outcome::HandedInTwice => {}
            }
        }
    };
    for name in ["bob.csv", "x.csv", "x.xlsx"] {
        for content in [
            "",
            "x",
            "a,b\n1,2",
            "order,row,direct,reverse,student\n1,cylinder 1,0,0,\n",
            "student,order,row,direct,reverse\nAda,1,cylinder 1,0,0\nMallory,1,x,,\nBob,1,convention sense,left,\nBob,x,y,z,w",
        ] {
            hand_in(name, content.as_bytes().to_vec());
        }
        hand_in(name, vec![0xff, 0x00, 0x80, 0x22]);
    }
    for _ in 0..200 {
        let mut content = whole.clone().into_bytes();
        for _ in 0..3 {
            let place = dice.below(content.len() as u64) as usize;
            content[place] = [b'"', b',', b'\n', b'=', 0xe9, b'x'][dice.below(6) as usize];
        }
        hand_in("all.csv", content);
    }
    assert!(told.lines().count() > 30, "{told}");
    for toml in ["TOML", "[[", " = \"", "[convention]"] {
        assert!(!told.contains(toml), "{toml}: {told}");
    }
    let folder = scratch("marking-csv");
    fs::write(folder.join("exercise.toml"), exercise.to_toml()).expect("a file");
    fs::write(folder.join("all.csv"), [0xff, 0xff, 0x80]).expect("a file");
    for arguments in [["mark", "all.csv"], ["mark", "none.csv"]] {
        let run = program().current_dir(&folder).args(arguments).output().expect("it starts");
        let said = String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr);
        assert!(!said.contains("TOML"), "{said}");
    }
}

#[test]
fn an_unreadable_entry_is_counted_as_such() {
    let exercise = draw("I4", "Ada", &[1]);
    let mut answer = right(&exercise.pupils[0].engine, 1, 4);
    answer.phases[0][0] = "north".to_owned();
    answer.phases[1][0] = "7.7".to_owned();
    let files = vec![bytes("ada.toml", toml(&exercise.pupils[0], "", &[answer]))];
    let results = mark_class(&exercise, files, &Scheme::default());
    let counts = sheet(&results, 0).counts();
    assert_eq!((counts.unreadable, counts.wrong), (1, 1));
    let page = report::marks_answer(&results, &Scheme::default());
    let options = crankstar::page::Options::default();
    let text = crankstar::page::write(&page, crankstar::page::Format::PLAIN, &options)
        .into_iter()
        .map(|file| file.text)
        .collect::<String>();
    assert!(text.contains("Not readable"), "{text}");
}

#[test]
fn points_have_a_mean_a_spread_and_a_histogram() {
    let names: String = (0..8).map(|index| format!("Student {index}\n")).collect();
    let exercise = draw("I4", &names, &[1]);
    // So many phases off by 10°, and every sum that of the phases.
    let handed_in = exercise.pupils.iter().enumerate().take(6).map(|(index, pupil)| {
        let off = |cylinder: usize| if cylinder < index.min(4) { [10.0, 10.0] } else { [0.0, 0.0] };
        bytes(&format!("{}.toml", pupil.file), toml(pupil, "", &[with_wrong_phases(&pupil.engine, 1, 4, off)]))
    });
    let results = mark_class(&exercise, handed_in.collect(), &Scheme::default());
    let points: Vec<f64> = (0..6).map(|student| numbers_of(&sheet(&results, student).points)).collect();
    let mean = points.iter().sum::<f64>() / 6.0;
    let variance = points.iter().map(|points| (points - mean).powi(2)).sum::<f64>() / 6.0;
    let found = Distribution::of(&results).expect("marked sheets");
    assert_eq!(found.sheets, 6);
    assert!((numbers_of(&found.mean) - mean).abs() < 1e-12 && (numbers_of(&found.variance) - variance).abs() < 1e-9);
    assert!(
        numbers_of(&found.variance) > 0.25 && found.tenths.iter().sum::<usize>() == 6 && found.tenths[9] >= 1,
        "{found:?}"
    );
    let written = |page: &crankstar::page::Document| {
        let files = crankstar::page::write(page, crankstar::page::Format::GITHUB, &crankstar::page::Options::default());
        files.into_iter().map(|file| file.name + &file.text).collect::<String>()
    };
    let page = written(&report::marks_page(&exercise, &results, &Scheme::default()));
    assert!(page.contains("standard deviation") && page.contains("points.svg") && page.contains("90 to 100"));
    assert!(written(&report::marks_answer(&results, &Scheme::default())).contains("standard deviation"));
    assert!(Distribution::of(&results[6..]).is_none());
}

fn numbers_of(value: &BigRational) -> f64 {
    numbers::float(value)
}

#[cfg(not(feature = "xlsx"))]
#[test]
fn a_workbook_that_cannot_be_read_is_told_with_what_reads_it() {
    let exercise = draw("V6-60-even", "Ada\nJosé Müller", &[1, 2]);
    let results = mark_class(&exercise, vec![bytes("all.xlsx", b"PK\x03\x04")], &Scheme::default());
    let told = format!("{results:?}");
    assert!(told.contains("without the feature `xlsx`") && told.contains("CSV") && results.len() == 3, "{told}");
}

#[test]
fn a_right_entry_is_called_so_and_no_direction() {
    let exercise = draw("I4", "Ada", &[1]);
    let pupil = &exercise.pupils[0];
    let table = toml(pupil, "", &[right(&pupil.engine, 1, 4)]);
    let results = mark_class(&exercise, vec![bytes("ada.toml", table)], &Scheme::default());
    let page = report::marked_page(pupil, sheet(&results, 0), &Scheme::default());
    let german = page::Options { language: page::Language::De, ..page::Options::default() };
    let page = page::write(&page, page::Format::GITHUB, &german).remove(0).text;
    assert!(page.contains("| richtig |") && !page.contains("rechts"), "{page}");
}
