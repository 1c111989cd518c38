//! Does any command still count in SI units where inches and pounds are asked for?
//!
//! The layout files are written in inches and pounds throughout, so that no unit of the SI stands in them as a person's own word.

use std::fs;
use std::path::Path;

use crate::support::program::{call, scratch};

const LAYOUTS: [(&str, &str); 4] = [
    ("v8.toml", include_str!("inch/v8.toml")),
    ("i3.toml", include_str!("inch/i3.toml")),
    ("h4.toml", include_str!("inch/h4.toml")),
    ("r9.toml", include_str!("inch/r9.toml")),
];

const CLAIMS: &str = "title = 'Claims in pounds'\n[[statement]]\ntext = 'The side force, and what cures the first order.'\nsource = 'a book'\n\
    conclusion = 'See below.'\n[[statement.claim]]\nlayout = 'v8.toml'\nsays = 'side force = F tan β'\n\
    [[statement.claim]]\nlayout = 'i3.toml'\nsays = 'second-order force vanishes'\n\
    [[statement.claim]]\nlayout = 'i3.toml'\nsays = 'counterweights at -0.1 and 0.1 can balance the direct first-order force and moment'\n";

/// Names that are nothing but units.
const UNITS: [&str; 18] = [
    "mm", "kg", "N·m", "kN", "kN·m", "kW", "kJ", "cm³", "kg·m", "kg·mm", "kg·m²", "m/s", "m/s²", "N·m/rad", "N·a",
    "MPa", "kPa", "Nm",
];
/// Names that are symbols or words too: units behind a number, behind `in`, or alone in brackets.
const LETTERS: [&str; 5] = ["m", "N", "J", "W", "bar"];

/// The units of the SI in a text, each between its neighbours; `letters` are looked for beside [`UNITS`].
fn units_of_the_si(text: &str, letters: &[&str]) -> Vec<String> {
    let is_inside = |letter: char| letter.is_alphanumeric() || "·/²³µ.,−-".contains(letter);
    let words: Vec<&str> = text.split(|letter: char| !is_inside(letter)).filter(|word| !word.is_empty()).collect();
    let is_number = |word: &str| {
        let digits = word.trim_start_matches(['−', '-']);
        digits.starts_with(|letter: char| letter.is_ascii_digit())
            && digits.chars().all(|letter| letter.is_ascii_digit() || "./,·⁻-".contains(letter))
    };
    let mut found = Vec::new();
    for (index, word) in words.iter().enumerate() {
        let word = word.trim_end_matches(['.', ',']);
        let before = index.checked_sub(1).map_or("", |before| words[before]);
        let after = words.get(index + 1).copied().unwrap_or_default();
        let is_symbol = after.starts_with(['r', 'ω']);
        let behind = is_number(before) || before == "in" || text.contains(&format!("({word})"));
        if UNITS.contains(&word) || letters.contains(&word) && behind && !is_symbol {
            found.push(format!("{before} {word} {after}"));
        }
    }
    found
}

/// The lines of a page in Markdown without formulas, and without the table of the symbols of formulas, which stay in SI units.
fn prose(page: &str) -> String {
    let mut inside = false;
    let mut symbols = false;
    let mut kept = String::new();
    for line in page.lines() {
        if line.starts_with("```") || line.starts_with("$`") || line.starts_with("$$") {
            inside = line.starts_with("```") && !inside;
            continue;
        }
        symbols = line.starts_with("| Symbol | Meaning | Unit") || symbols && line.starts_with('|');
        if !inside && !symbols {
            let mut parts = line.split('$');
            kept.extend(parts.next());
            // Every other part is a formula.
            parts.skip(1).step_by(2).for_each(|part| kept.push_str(part));
            kept.push('\n');
        }
    }
    kept
}

/// The words of a drawing.
fn words(drawing: &str) -> String {
    drawing.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| format!("{text}\n")).collect()
}

#[track_caller]
fn assert_in_inches(what: &str, text: &str, letters: &[&str]) {
    let found = units_of_the_si(text, letters);
    assert!(found.is_empty(), "{what}: {found:?}");
}

/// Calls the command with `--units inch` for pages into a folder; reads what it prints and every page and drawing it writes.
#[track_caller]
fn assert_command(folder: &Path, arguments: &[&str]) {
    let name = arguments.join(" ");
    let output = folder.join("page");
    let _ = fs::remove_dir_all(&output);
    let mut all: Vec<String> = arguments.iter().map(|argument| (*argument).to_owned()).collect();
    all.extend(["--units".to_owned(), "inch".to_owned()]);
    if !["classify", "figure"].contains(&arguments[0]) {
        all.extend(["--output".to_owned(), output.display().to_string()]);
    }
    for argument in &mut all {
        if folder.join(&*argument).is_file() {
            *argument = folder.join(&*argument).display().to_string();
        }
    }
    let answer = call(&all);
    let told = String::from_utf8(answer.stdout).expect("text");
    assert!(answer.status.success(), "{name}: {}", String::from_utf8_lossy(&answer.stderr));
    let said = if arguments[0] == "figure" { words(&told) } else { told.replace(&folder.display().to_string(), "") };
    // In narrow columns the mass of `m r` stands at the end of a line, and its radius in the next.
    assert_in_inches(&name, &said, &LETTERS[1..]);
    let Ok(files) = fs::read_dir(&output) else { return };
    for file in files {
        let path = file.expect("a file").path();
        let text = || fs::read_to_string(&path).expect("text");
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("md") => assert_in_inches(&format!("{name}, {}", path.display()), &prose(&text()), &LETTERS),
            Some("svg" | "html") => assert_in_inches(&format!("{name}, {}", path.display()), &words(&text()), &LETTERS),
            Some(_) | None => {}
        }
    }
}

fn with_layouts(name: &str) -> std::path::PathBuf {
    let folder = scratch(name);
    for (name, text) in LAYOUTS {
        fs::write(folder.join(name), text).expect("a layout");
    }
    fs::write(folder.join("claims.toml"), CLAIMS).expect("claims");
    folder
}

#[test]
fn commands_of_the_masses_print_no_si_units_where_inches_are_asked_for() {
    let folder = with_layouts("inch-masses");
    for layout in ["i3.toml", "v8.toml", "h4.toml", "r9.toml"] {
        for command in ["classify", "loads", "remedy"] {
            assert_command(&folder, &[command, layout]);
        }
    }
    for command in ["bearings", "accuracy", "optimise", "firing"] {
        assert_command(&folder, &[command, "i3.toml"]);
    }
    for drawing in ["end-view", "side-view"] {
        assert_command(&folder, &["figure", "v8.toml", drawing]);
    }
}

#[test]
fn reports_print_no_si_units_where_inches_are_asked_for() {
    let folder = with_layouts("inch-reports");
    assert_command(&folder, &["report", "v8.toml"]);
    assert_command(&folder, &["report", "i3.toml", "--accuracy"]);
    assert_command(&folder, &["report", "h4.toml"]);
}

#[test]
fn commands_of_gas_and_torsion_print_no_si_units_where_inches_are_asked_for() {
    let folder = with_layouts("inch-gas");
    for command in ["torque", "torsion", "bearings", "firing"] {
        assert_command(&folder, &[command, "v8.toml"]);
    }
}

#[test]
fn sweeps_comparisons_searches_and_claims_print_no_si_units_where_inches_are_asked_for() {
    let folder = with_layouts("inch-others");
    assert_command(&folder, &["sweep", "v8.toml", "--speed", "1000..2000:1000"]);
    assert_command(&folder, &["sweep", "i3.toml", "--spacing", "3..4:1in"]);
    assert_command(&folder, &["sweep", "i3.toml", "--rod-ratio", "0.2..0.3:0.1", "--speed", "1000..2000:1000"]);
    assert_command(&folder, &["figure", "i3.toml", "sweep:moment-2", "--speed", "1000..2000:1000"]);
    assert_command(&folder, &["compare", "i3.toml", "v8.toml"]);
    assert_command(&folder, &["search", "--cylinders", "3", "--cycle", "four-stroke"]);
    assert_command(&folder, &["check", "claims.toml"]);
}

#[test]
fn documents_of_data_stay_in_si_units() {
    let folder = with_layouts("inch-data");
    let layout = folder.join("i3.toml").display().to_string();
    let calls: [&[&str]; 3] =
        [&["loads", &layout, "--json"], &["bearings", &layout, "--json"], &["remedy", &layout, "--json"]];
    for arguments in calls {
        let si = call(arguments);
        let inch: Vec<&str> = arguments.iter().copied().chain(["--units", "inch"]).collect();
        let inch = call(&inch);
        assert!(si.status.success() && !si.stdout.is_empty(), "{}", String::from_utf8_lossy(&si.stderr));
        assert_eq!(si.stdout, inch.stdout, "{arguments:?}");
    }
}
