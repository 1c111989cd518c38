//! Does the program answer as its help says: output, messages, exit status?

use std::fs;
use std::process::{Command, Output, Stdio};

use crankstar::page::{self, Format, Options};

use crate::support::program::scratch;

fn crankstar(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_crankstar")).args(arguments).output().expect("the program starts")
}

fn succeeds(arguments: &[&str]) -> String {
    let output = crankstar(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

/// The message on standard error of a call that ends with this status and prints nothing else.
fn fails(arguments: &[&str], status: i32) -> String {
    let output = crankstar(arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?} prints on standard output");
    String::from_utf8(output.stderr).expect("a text")
}

fn text(path: &std::path::Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

#[test]
fn list_prints_a_row_an_engine_in_eighty_columns_with_what_it_leaves_first() {
    let list = succeeds(&["list"]);
    assert!(list.lines().all(|line| line.chars().count() <= 80), "{list}");
    let engines = crankstar::file::catalogue().expect("the catalogue reads");
    let document = crankstar::report::catalogue_answer(&engines);
    let wide = Format::Terminal { width: 120, colour: false };
    let wide = page::write(&document, wide, &Options::default()).remove(0).text;
    for (entry, layout) in &engines {
        let starts = |line: &&str| line.starts_with(&format!(" {} ", entry.name));
        assert_eq!(list.lines().filter(starts).count(), 1, "{}", entry.name);
        assert!(wide.lines().find(starts).is_some_and(|line| line.contains(layout.title().written())), "{wide}");
    }
    for (name, cells) in [("I4", ["even, 180°", "2", "none"]), ("V8-crossplane", ["even, 90°", "4", "1"])] {
        let line = wide.lines().find(|line| line.starts_with(&format!(" {name} "))).expect("a row");
        let told: Vec<&str> = line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
        assert_eq!(told[2..], cells, "{line}");
    }
}

#[test]
fn a_long_title_is_broken_into_lines_of_eighty_columns() {
    let file = scratch("long-title").join("w12.toml");
    fs::write(&file, include_str!("../pages/w12.toml")).expect("the folder takes files");
    let answer = succeeds(&["classify", text(&file)]);
    assert!(answer.starts_with("W12, two narrow V6") && answer.contains("All other forces"), "{answer}");
    assert!(answer.lines().all(|line| line.chars().count() <= 80), "{answer}");
}

#[test]
fn names_are_read_in_upper_and_lower_case() {
    assert_eq!(succeeds(&["classify", "v8-crossPLANE"]), succeeds(&["classify", "V8-crossplane"]));
}

#[test]
fn output_that_is_no_terminal_has_no_colours() {
    assert!(!succeeds(&["classify", "I4"]).contains('\u{1b}'));
}

#[test]
fn remedy_proposes_weights_and_its_json_verifies() {
    let table = succeeds(&["remedy", "V8-crossplane", "--orders", "1,2"]);
    assert!(table.contains("√10/3 ≈ 1.054 m r at z = 1.5"), "{table}");
    for words in ["counterweight", "−arctan(1/3) ≈", "−18.43°"] {
        assert!(table.contains(words), "no {words} in\n{table}");
    }
    let pair = succeeds(&["remedy", "I4", "--orders", "2"]);
    assert!(pair.contains("Lanchester pair") && pair.contains("0.5 m r |c₂|"), "{pair}");
    let none = succeeds(&["remedy", "I6", "--orders", "1,2"]);
    assert!(none.contains("no weight is needed"), "{none}");
    let file = scratch("remedy").join("i3.json");
    let skewed = ["remedy", "I3", "--balance-factor", "1", "--skew", "30,0,-30", "--planes", "1.2,-1.2", "--json"];
    fs::write(&file, succeeds(&skewed)).expect("the folder takes files");
    assert!(succeeds(&["verify", text(&file)]).contains("certificates hold"));
}

#[test]
fn remedy_writes_its_page_into_a_folder() {
    let folder = scratch("remedy-section");
    succeeds(&["remedy", "V2-45", "--output", text(&folder)]);
    let section = fs::read_to_string(folder.join("remedy.md")).expect("the section");
    let title = "# V2, 45°, one crankpin: remedies";
    let row = "| counterweight | 1×, with the crank | 0 | 1 $`m\\,r`$ | 180° |";
    for words in [title, "## The weights", row, "## Counterweights alone", "| 0.35 | "] {
        assert!(section.contains(words), "no {words} in\n{section}");
    }
}

#[test]
fn what_remedy_cannot_take_is_told() {
    let refused = |arguments: &[&str], status| fails(&[&["remedy", "I3"], arguments].concat(), status);
    assert!(refused(&["--planes", "1,1"], 1).contains("both planes are at 1"));
    assert!(refused(&["--planes", "1"], 2).contains("--planes: 1 position; give two"));
    assert!(refused(&["--planes", "1,x"], 2).contains("cannot read `x`"));
    assert!(refused(&["--planes", "1 mm,2 mm"], 2).contains("count in spacings"));
    assert!(refused(&["--balance-factor=-1"], 2).contains("0 or more"));
    assert!(refused(&["--balance-factor", "1,1,1,1"], 1).contains("4 balance factors for 3 throws"));
    assert!(refused(&["--balance-factor", "1", "--skew", "x"], 2).contains("cannot read `x`"));
    assert!(fails(&["remedy", "I3", "--skew", "1"], 2).contains("--balance-factor"));
}

#[test]
fn every_engine_of_the_catalogue_verifies() {
    let folder = scratch("verify-all");
    for (entry, engine) in crankstar::file::catalogue().expect("the catalogue reads") {
        let file = folder.join(format!("{}.json", entry.name));
        let mut asked = vec!["classify", entry.name, "--json", "--orders", "1,2,3,4,5,6,8,10,12"];
        // The torque of links is not judged.
        asked.extend((!engine.has_links()).then_some("--torque"));
        fs::write(&file, succeeds(&asked)).expect("a file");
        assert!(succeeds(&["verify", text(&file)]).contains("certificates hold"), "{}", entry.name);
    }
}

#[test]
fn verify_reads_standard_input() {
    let json = succeeds(&["classify", "I6", "--json"]);
    let mut child = Command::new(env!("CARGO_BIN_EXE_crankstar"))
        .args(["verify", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), json.as_bytes()).expect("written");
    assert!(child.wait().expect("it ends").success());
}

#[test]
fn an_engine_of_standard_input_is_called_so_in_a_comparison() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_crankstar"))
        .args(["compare", "-", "I4"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let layout = b"inline.throws = [0, 180, 180, 0]\n";
    std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), layout).expect("written");
    let told = String::from_utf8(child.wait_with_output().expect("it ends").stdout).expect("a text");
    assert!(told.contains("standard input has ") && !told.contains("\n- has "), "{told}");
}

#[test]
fn standard_input_is_named_once() {
    for arguments in [&["verify", "-", "-"][..], &["verify", "-", "--engine", "-"], &["compare", "-", "I4", "-"]] {
        assert!(fails(arguments, 2).contains("standard input is named twice"), "{arguments:?}");
    }
}

#[test]
fn verify_refuses_a_changed_verdict_and_says_where() {
    let folder = scratch("verify-changed");
    let json = succeeds(&["classify", "I4", "--json"]);
    let file = folder.join("changed.json");
    fs::write(&file, json.replacen("\"vanishes\": true", "\"vanishes\": false", 1)).expect("a file");
    let message = fails(&["verify", text(&file)], 1);
    assert!(message.contains("verdicts[0] (force, order 1, direct)"), "{message}");
}

#[test]
fn a_command_that_reads_files_of_its_own_says_so_of_an_engine_of_the_catalogue() {
    for command in ["rotor", "flywheel"] {
        assert!(fails(&[command, "I4"], 1).contains("`I4` is an engine of the catalogue"), "{command}");
    }
}

#[test]
fn verify_checks_each_of_several_files_and_counts_those_that_are_refused() {
    let folder = scratch("verify-several");
    let json = succeeds(&["classify", "I4", "--json"]);
    let changed = json.replacen("\"vanishes\": true", "\"vanishes\": false", 1);
    let [good, bad, other] = ["good", "bad", "other"].map(|name| folder.join(name));
    for (file, text) in [(&good, &json), (&bad, &changed), (&other, &succeeds(&["classify", "I6", "--json"]))] {
        fs::write(file, text).expect("a file");
    }
    assert_eq!(succeeds(&["verify", text(&good), text(&other)]).matches("certificates hold").count(), 2);
    for (arguments, words) in [
        (vec!["verify", text(&good), text(&bad), text(&other)], ["verdicts[0]", "1 of 3 documents are refused"]),
        (
            vec!["verify", "--engine", "I4", text(&good), text(&other)],
            ["is not that of I4", "1 of 2 documents are refused"],
        ),
    ] {
        let output = crankstar(&arguments);
        assert_eq!(output.status.code(), Some(1));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(words.iter().all(|words| message.contains(words)), "{message}");
    }
}

#[test]
fn verify_refuses_what_is_no_json_output() {
    let folder = scratch("verify-other");
    for (name, bytes) in [
        ("empty", &b""[..]),
        ("text", b"hello"),
        ("binary", b"\xff\x00\x01"),
        ("object", b"{}"),
        ("deep", &[b'['; 100_000]),
    ] {
        let file = folder.join(name);
        fs::write(&file, bytes).expect("a file");
        assert!(fails(&["verify", text(&file)], 1).contains("is not an output of `classify --json`"), "{name}");
    }
    assert!(fails(&["verify", text(&folder.join("missing"))], 1).contains("cannot read"));
}

#[test]
fn a_report_is_written_with_its_diagrams_and_again_over_itself() {
    let folder = scratch("report").join("deep/I4-report");
    for _ in 0..2 {
        let summary = succeeds(&["report", "I4", "--output", text(&folder)]);
        assert!(summary.contains("report.md") && summary.contains("4, planar"));
        let mut names: Vec<_> =
            fs::read_dir(&folder).expect("the folder").map(|e| e.expect("an entry").file_name()).collect();
        names.sort();
        assert_eq!(
            names,
            [
                "direct-and-reverse.svg",
                "end-view.svg",
                "order-1.svg",
                "order-2.svg",
                "order-4.svg",
                "order-6.svg",
                "report.md",
                "side-view.svg"
            ]
        );
    }
    assert_eq!(
        fs::read_dir(folder.parent().expect("a parent")).expect("a folder").count(),
        1,
        "nothing else is left behind"
    );
}

#[test]
fn a_report_for_latex_is_one_file() {
    let folder = scratch("latex").join("out");
    succeeds(&["report", "I3", "--format", "latex", "--output", text(&folder)]);
    let names: Vec<_> = fs::read_dir(&folder).expect("the folder").map(|e| e.expect("an entry").file_name()).collect();
    assert_eq!(names, ["report.tex"]);
}

#[test]
fn a_report_that_cannot_be_written_leaves_nothing() {
    let folder = scratch("blocked");
    let file = folder.join("taken");
    fs::write(&file, "mine").expect("a file");
    assert!(fails(&["report", "I4", "--output", text(&file)], 1).contains("is a file"));
    assert!(fails(&["report", "I4", "--output", text(&file.join("below"))], 1).contains("cannot write"));
    assert_eq!(fs::read_to_string(&file).expect("still there"), "mine");
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1);
}

#[test]
fn without_a_folder_the_text_alone_is_printed() {
    assert!(succeeds(&["report", "I2-180"]).starts_with("# "));
    assert!(succeeds(&["report", "I2-180", "--format", "latex"]).starts_with("\\documentclass"));
    let dollars = succeeds(&["report", "I2-180", "--math", "dollars"]);
    assert!(dollars.contains("$P_{1}^{+}") && !dollars.contains("$`"));
}

#[test]
fn an_option_of_another_format_is_refused() {
    let of_pages = ["--math", "--siunitx", "--fragment"];
    let told = |arguments: &[&str], formats: &str, why: &str| {
        let told = fails(arguments, 2);
        assert!(told.contains(&format!("is for pages in {formats}, and {why}")), "{arguments:?}: {told}");
    };
    told(&["report", "I4", "--siunitx"], "LaTeX", "this page is in another format");
    told(&["report", "I4", "--fragment"], "LaTeX, Typst and HTML", "this page is in another format");
    told(&["report", "I4", "--format", "latex", "--math", "dollars"], "Markdown", "this page is in another format");
    for option in of_pages {
        let option = if option == "--math" { &[option, "dollars"][..] } else { &[option] };
        assert!(fails(&[&["moments", "I4"], option].concat(), 2).contains("no page is written"), "{option:?}");
        let data = ["accuracy", "examples/four.toml", "--format", "csv"];
        assert!(fails(&[&data, option].concat(), 2).contains("no page is written"), "{option:?}");
    }
    for option in [&["--symbols", "nope.toml"][..], &["--stamp"]] {
        for data in [&["--json"][..], &["--format", "json"], &["--format", "csv"], &["--output", "loads.csv"]] {
            let told = fails(&[&["loads", "examples/four.toml"], data, option].concat(), 2);
            assert!(told.contains("is for pages and answers, and data is written"), "{data:?}: {told}");
        }
    }
    assert!(fails(&["classify", "examples/four.toml", "--rod-ratio", "0.3"], 2).contains("this layout gives its own"));
}

#[test]
fn the_choice_of_orders_is_refused_where_none_are_listed() {
    let folder = scratch("listed_orders");
    fs::create_dir_all(&folder).expect("a folder");
    let open = folder.join("open.toml");
    fs::write(&open, "[vee]\nbank_angle = 'phi'\nthrows = [0]\n").expect("written");
    let open = text(&open);
    for option in [&["--above", "50"][..], &["--all"], &["--rod-ratio", "1/4"]] {
        let refused = |arguments: &[&str], why: &str| {
            let told = fails(&[arguments, option].concat(), 2);
            assert!(told.contains(why), "{arguments:?} {option:?}: {told}");
        };
        refused(&["classify", open], "an engine without unknowns");
        refused(&["report", open], "an engine without unknowns");
        refused(&["classify", "I4", "--firing"], "orders of force and moment");
        for data in [&["--json"][..], &["--format", "csv"], &["--format", "coq"]] {
            refused(&[&["classify", "I4"], data].concat(), "data has every order");
        }
        if option[0] != "--rod-ratio" {
            refused(&["loads", "examples/four.toml", "--json"], "data has every order");
            refused(&["loads", "examples/four.toml", "--format", "csv"], "data has every order");
        }
    }
}

/// Without a folder a format that is named is printed, of every command.
#[test]
fn a_page_whose_format_is_named_is_printed() {
    let claims = "examples/five-claims.toml";
    assert!(succeeds(&["check", claims, "--format", "latex"]).starts_with("\\documentclass"));
    assert!(!succeeds(&["check", claims]).contains("documentclass"));
}

#[test]
fn only_the_orders_asked_for_are_judged() {
    let report = succeeds(&["report", "I4", "--orders", "2"]);
    assert!(report.contains("### Order 2") && !report.contains("### Order 1") && !report.contains("order-4.svg"));
    assert!(!succeeds(&["classify", "I4", "--json"]).contains("torque"));
    assert!(succeeds(&["classify", "I4", "--json", "--torque"]).contains("torque"));
}

#[test]
fn wrong_usage_ends_with_status_two() {
    for arguments in [
        &["classify"][..],
        &["clasify", "I4"],
        &["classify", "I4", "--orders", "0"],
        &["classify", "I4", "--orders", "1001"],
        &["classify", "I4", "--orders", "1.5"],
        &["report", "I4", "--format", "word"],
        &[],
    ] {
        assert!(!fails(arguments, 2).is_empty());
    }
}

#[test]
fn wrong_input_ends_with_status_one_and_says_what_would_be_right() {
    assert!(fails(&["classify", "V8"], 1).contains("V8-crossplane, V8-flatplane"));
    assert!(fails(&["classify", "Q7"], 1).contains("crankstar list"));
    assert!(fails(&["classify", "no/such.toml"], 1).contains("cannot read `no/such.toml`"));
    assert!(fails(&["classify", env!("CARGO_TARGET_TMPDIR")], 1).contains("is not a file"));
    let folder = scratch("binary");
    let file = folder.join("binary.toml");
    fs::write(&file, b"title = \"\xff\"").expect("a file");
    assert!(fails(&["classify", text(&file)], 1).contains("not in UTF-8, in line 1; save it as UTF-8"));
}

#[test]
fn a_file_of_another_kind_is_told_in_one_line_with_the_command_that_reads_it() {
    let folder = scratch("other-kinds");
    let kinds = [
        ("layout", "[inline]\nthrows = [0]\n[mechanism]\nstroke = 1", "classify", &["loads", "classify", "sweep"][..]),
        ("shaft", "[[mass]]\nmass = 1\nradius = 1", "rotor", &["rotor"]),
        ("diagram", "areas = ['52 mm²']\nspeed = 3", "flywheel", &["flywheel"]),
        ("claims", "[[claim]]\nlayout = 'I4'\nsays = 'force order 1 is zero'", "check", &["check"]),
    ];
    for (name, written, reader, own) in kinds {
        let file = folder.join(format!("{name}.toml"));
        fs::write(&file, written).expect("a file");
        for (other, _, _, commands) in kinds.iter().filter(|(.., commands)| *commands != own) {
            for command in *commands {
                let range = if *command == "sweep" { &["--speed", "1..2:1"][..] } else { &[] };
                let told = fails(&[&[command, text(&file)], range].concat(), 1);
                let one = told.matches("error").count() == 1 && told.contains("this file holds");
                assert!(one && told.contains(&format!("crankstar {reader}`")), "{command} {name}, not {other}: {told}");
            }
        }
    }
}

#[test]
fn a_space_or_the_end_of_a_line_behind_the_name_of_an_engine_changes_nothing() {
    for name in ["I4 ", " I4", "I4\r"] {
        assert_eq!(succeeds(&["classify", name]), succeeds(&["classify", "I4"]), "{name:?}");
    }
}

#[test]
fn a_value_that_is_none_is_told_in_words_of_a_person() {
    for (arguments, words) in [
        (&["classify", "I4", "--above", "-1"][..], "a number of percent from 0 to 100"),
        (&["torsion", "I4", "--speed", "-5"], "a speed above 0"),
        (&["exercise", "I4", "--seed", "-1"], "a whole number is needed, without sign and unit"),
        (&["exercise", "I4", "--orders", "1/2"], "an order is a whole number from 1 to 1000"),
        (&["loads", "I4", "--digits", "x"], "a whole number is needed"),
        (&["loads", "I4", "--digits", "20"], "20 is not from 2 to 12"),
        (&["loads", "I4", "--digits", "-3"], "-3 is not from 2 to 12"),
        (&["angle", "I4", "--gravity", "9.81 m/s"], "a number is needed, such as 0.5, without a unit"),
    ] {
        let told = fails(arguments, 2);
        let foreign = ["tip:", "literal", "found in string", "..="].iter().find(|foreign| told.contains(**foreign));
        assert!(told.contains(words) && foreign.is_none(), "{arguments:?}: {told}");
    }
}

#[test]
fn a_folder_named_like_a_family_of_engines_does_not_hide_which_engines_there_are() {
    let folder = scratch("folder-of-a-report");
    fs::create_dir(folder.join("V8")).expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_crankstar")).args(["classify", "V8"]).current_dir(folder).output();
    let said = String::from_utf8(output.expect("it runs").stderr).expect("text");
    assert!(said.contains("`V8` is not a file; the catalogue has V8-crossplane, V8-flatplane"), "{said}");
}

#[test]
fn a_reader_that_stops_reading_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_crankstar"))
        .args(["classify", "radial-18", "--json", "--orders", "1,2,4,6,8,10,12,14,16,18"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success() && output.stderr.is_empty());
}

#[test]
fn completions_are_printed_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(succeeds(&["completions", shell]).contains("classify"), "{shell}");
    }
}

#[test]
fn accuracy_tells_errors_and_times_and_writes_a_page() {
    let folder = scratch("accuracy").join("page");
    let asked = ["accuracy", "I1", "--rod-ratio", "0.2,0.3"];
    let document: serde_json::Value =
        serde_json::from_str(&succeeds(&[&asked[..], &["--json"]].concat())).expect("JSON");
    let of_force = |table: &str| {
        let rows = document[table].as_array().expect("a table").iter();
        rows.filter(|row| row["case"] == 2 && row["load"] == "force").collect::<Vec<_>>()
    };
    let digits = of_force("peaks")[0]["at_least"].as_str().expect("a number");
    assert!(digits.starts_with("1.29999999999999999999") || digits.starts_with("1.30000000000000000000"), "{digits}");
    let methods = of_force("methods");
    assert!(methods.len() > 10 && methods.iter().all(|method| method["time_s"].is_f64()), "{methods:?}");
    succeeds(&[&asked[..], &["--output", text(&folder)]].concat());
    let page = fs::read_to_string(folder.join("accuracy.md")).expect("the page");
    for name in ["force-1.svg", "inertia-torque-1.svg", "force-2.svg", "inertia-torque-2.svg"] {
        assert!(page.contains(&format!("({name})")) && folder.join(name).is_file(), "{name}");
    }
}

#[test]
fn accuracy_needs_rods_and_says_so() {
    assert!(fails(&["accuracy", "I4"], 1).contains("--rod-ratio 0.3"));
    assert!(fails(&["accuracy", "I4", "--rod-ratio", "1"], 2).contains("from 0 to below 1"));
}

#[test]
fn remedy_names_small_orders_and_cancels_them_where_they_are_asked_for() {
    let usual = succeeds(&["remedy", "I3"]).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(usual.contains("cancelled only on request:") && !usual.contains("shaft 4"), "{usual}");
    for more in [["--all"].as_slice(), &["--above", "0"], &["--orders", "1,2,4,6"]] {
        let all = succeeds(&[&["remedy", "I3"], more].concat());
        assert!(all.contains("shaft 4") && !all.contains("only on request"), "{all}");
    }
}

#[test]
fn orders_may_have_blanks_behind_their_commas() {
    for command in ["classify", "remedy", "compare", "firing", "sweep"] {
        let of = |orders: &str| {
            let more: &[&str] = match command {
                "compare" => &["I3"],
                "sweep" => &["--set", "inline.throws.2=0..90:45"],
                _ => &[],
            };
            succeeds(&[&[command, "I4", "--orders", orders], more].concat())
        };
        assert_eq!(of("1, 2 ,4"), of("1,2,4"), "{command}");
    }
    let stars = |orders: &str| succeeds(&["search", "--cylinders", "4", "--cycle", "four-stroke", "--orders", orders]);
    assert_eq!(stars("1, 2"), stars("1,2"));
    for wrong in [["compare", "I4", "--orders", "1, x"], ["sweep", "I4", "--orders", "1,0"]] {
        assert!(fails(&wrong, 2).contains("an order is a whole number from 1 to 1000"), "{wrong:?}");
    }
}

#[test]
fn what_is_no_order_and_what_is_no_option_are_told_without_wrong_tips() {
    for order in ["0", "1001", "x", "1/3"] {
        let told = fails(&["classify", "I4", "--orders", order], 2);
        assert!(
            told.contains(&format!("`{order}` is not an order; an order is a whole number from 1 to 1000")),
            "{told}"
        );
    }
    for arguments in [["classify", "-5"], ["torque", "--speed"]] {
        let told = fails(&arguments, 2);
        assert!(told.contains(&format!("unexpected argument '{}'", arguments[1])) && told.contains("Usage"), "{told}");
        assert!(!told.contains("tip") && !told.contains("\n\n\n"), "{told}");
    }
    assert!(fails(&["classify", "I4", "--order", "2"], 2).contains("a similar argument exists: '--orders'"));
}
