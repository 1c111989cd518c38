//! Does `figure` write each drawing by itself, in both formats?

use std::fs;

use crate::support::program::{call, scratch};

const FAMILY: &str = "reports/families/v-twin/layout.toml";
const WITH_BEARINGS: &str = "reports/examples/thesis-v8-crossplane/layout.toml";

fn succeeds(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

/// The message of a call that ends with this status.
fn fails(arguments: &[&str], status: i32) -> String {
    let output = call(arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}");
    String::from_utf8(output.stderr).expect("a text")
}

fn names(layout: &str, more: &[&str]) -> Vec<String> {
    let list = succeeds(&[&["figure", layout], more].concat());
    list.lines().map(str::to_owned).collect()
}

fn has(names: &[String], wanted: &[&str]) {
    for name in wanted {
        assert!(names.iter().any(|listed| listed == name), "no {name} in {names:?}");
    }
}

/// Every name in both formats.
fn are_drawn(layout: &str, names: &[String], more: &[&str]) {
    for name in names {
        let svg = succeeds(&[&["figure", layout, name], more].concat());
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{layout} {name}");
        let tikz = succeeds(&[&["figure", layout, name, "--format", "tikz"], more].concat());
        assert!(tikz.ends_with("\\end{tikzpicture}\n") && !tikz.contains("documentclass"), "{layout} {name}");
        assert!(tikz.contains("\\definecolor{csred}"), "{layout} {name}: the colours are missing");
    }
}

#[test]
fn every_drawing_of_the_cross_plane_v8_is_listed_and_drawn() {
    let names = names("V8-crossplane", &[]);
    has(&names, &["end-view", "side-view", "star:1", "star:2", "star:4"]);
    are_drawn("V8-crossplane", &names, &[]);
}

#[test]
fn an_engine_with_numbers_and_bearings_has_its_loads_and_both_drawings_of_each_bearing() {
    let names = names(WITH_BEARINGS, &[]);
    has(&names, &["force-along", "moment-path", "bearing:1", "polar:1", "polar:5", "star:1:pistons"]);
    let mut once = names.clone();
    once.sort();
    once.dedup();
    assert_eq!(once.len(), names.len(), "{names:?}");
    are_drawn(WITH_BEARINGS, &["polar:3".to_owned(), "bearing:2".to_owned(), "force-along".to_owned()], &[]);
}

#[test]
fn a_family_has_its_amplitudes_and_a_sweep_its_curves() {
    let family = names(FAMILY, &[]);
    has(&family, &["amplitudes"]);
    are_drawn(FAMILY, &family, &[]);
    let range = ["--bank-angle", "0..180:30"];
    let sweep = names("V2-45", &range);
    has(&sweep, &["sweep:force-1"]);
    are_drawn("V2-45", &sweep, &range);
}

#[test]
fn a_star_of_any_order_can_be_asked_for() {
    let star = succeeds(&["figure", "I4", "star:10"]);
    assert!(star.contains("Force, direct, order 10"), "{star}");
}

#[test]
fn a_name_that_the_layout_lacks_is_told_with_those_that_it_has() {
    let told = fails(&["figure", "I4", "star:pear"], 1);
    assert!(told.contains("no figure `star:pear`") && told.contains("end-view, star:2"), "{told}");
    assert!(fails(&["figure", "I4", "polar:1"], 1).contains("there are"));
    assert!(fails(&["figure", "I4", "end-view", "--format", "svg", "--standalone"], 2).contains("--standalone"));
    assert!(fails(&["figure", "no-such-engine", "end-view"], 1).contains("no-such-engine"));
    assert!(fails(&["figure", "I4", "end-view", "--output", "/"], 1).contains("not a name of a file"));
}

#[test]
fn a_list_of_names_is_no_file_and_says_where_it_is_empty() {
    let folder = scratch("figure_list");
    let file = folder.join("list.svg");
    let told = fails(&["figure", "I4", "--output", file.to_str().expect("a path")], 2);
    assert!(told.contains("--output needs the name of a figure") && !file.exists(), "{told}");
    for (option, more) in [("--format", &["--format", "tikz"][..]), ("--standalone", &["--standalone"])] {
        let told = fails(&[&["figure", "I4"], more].concat(), 2);
        assert!(told.contains(&format!("{option} needs the name of a figure")), "{told}");
    }
    let open = folder.join("open.toml");
    let cylinder = |position: &str| format!("[[cylinder]]\nthrow = 0\nbank = 0\nposition = {position}\n");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(&open, cylinder("0") + &cylinder("'a'")).expect("written");
    let output = call(&["figure", open.to_str().expect("a path")]);
    assert!(output.status.success() && output.stdout.is_empty(), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("there is no figure of"), "{output:?}");
}

#[test]
fn program_and_version_are_named_only_where_asked_for() {
    for format in ["svg", "tikz"] {
        let bare = ["figure", "I4", "end-view", "--format", format];
        let named = format!("crankstar {}", env!("CARGO_PKG_VERSION"));
        assert!(!succeeds(&bare).contains(&named));
        assert!(succeeds(&[&bare[..], &["--stamp"]].concat()).contains(&named));
    }
}

#[test]
fn the_ending_of_the_file_says_the_format() {
    let folder = scratch("figure-files");
    let path = |name: &str| folder.join(name).to_str().expect("a path in UTF-8").to_owned();
    for (name, begin) in [("star.tex", "% \\usepackage"), ("star.svg", "<svg ")] {
        succeeds(&["figure", "I4", "star:2", "--output", &path(name)]);
        assert!(fs::read_to_string(path(name)).expect("a drawing").starts_with(begin));
    }
    succeeds(&["figure", "I4", "star:2", "--output", &path("whole.tex"), "--standalone"]);
    assert!(fs::read_to_string(path("whole.tex")).expect("a drawing").starts_with("\\documentclass"));
}

#[test]
fn a_drawing_is_not_written_under_the_name_of_another_format() {
    let folder = scratch("figure-other-names");
    let path = |name: &str| folder.join(name).to_str().expect("a path in UTF-8").to_owned();
    for (name, more, words) in [
        ("a.png", &[][..], "named as a file of png, and a drawing is SVG or TikZ"),
        ("a.pdf", &[], "end the name in .svg or .tex"),
        ("a.csv", &["--format", "svg"], "named as a file of csv"),
        ("a.tex", &["--format", "svg"], "named as a file of TikZ, and holds SVG; end the name in .svg"),
        ("a.svg", &["--format", "tikz"], "named as a file of SVG, and holds TikZ; end the name in .tex"),
    ] {
        let told = fails(&[&["figure", "I4", "star:2", "--output", &path(name)], more].concat(), 2);
        assert!(told.contains(words) && !folder.join(name).exists(), "{name}: {told}");
    }
    for (name, begin) in [("a.TEX", "% \\usepackage"), ("a.tikz", "% \\usepackage"), ("a.SVG", "<svg "), ("a", "<svg ")]
    {
        succeeds(&["figure", "I4", "star:2", "--output", &path(name)]);
        assert!(fs::read_to_string(path(name)).expect("a drawing").starts_with(begin), "{name}");
    }
}

#[test]
fn digits_are_refused_where_they_would_change_nothing() {
    assert!(fails(&["figure", "I4", "star:2", "--digits", "6"], 2).contains("--digits has no effect on a drawing"));
    assert!(!succeeds(&["figure", "--help"]).contains("--digits"));
    assert!(succeeds(&["figure", "I4", "star:2", "--units", "inch"]).contains("<svg"));
}
