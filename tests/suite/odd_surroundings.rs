//! Does the program answer in odd surroundings: closed or full outputs, paths that are no text, sizes that no engine has?

use std::fs;
use std::process::{Command, Stdio};

use crate::support::program::{call, program, scratch};

/// Runs a line of the shell in which `$0` is the program.
#[cfg(unix)]
fn shell(line: &str) -> (Option<i32>, String) {
    let output = Command::new("sh").args(["-c", line, env!("CARGO_BIN_EXE_crankstar")]).output().expect("a shell");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
#[cfg(unix)]
fn outputs_that_are_closed_or_full_are_no_panic() {
    for call in
        ["list", "classify I4", "classify I4 --json", "--help", "nonsense", "classify nonsense", "completions bash"]
    {
        for to in [">&-", "2>&-", ">&- 2>&-", "2>/dev/full", "| head -c 10"] {
            let (code, error) = shell(&format!("\"$0\" {call} {to}"));
            assert!(matches!(code, Some(0..=2)), "{call} {to}: {code:?} {error}");
            assert!(!error.contains("panicked"), "{call} {to}: {error}");
        }
    }
    for call in ["classify I4", "--help", "--version"] {
        let (code, error) = shell(&format!("\"$0\" {call} >/dev/full"));
        assert!(code == Some(1) && error.starts_with("error: cannot write to standard output"), "{code:?} {error}");
    }
}

#[test]
#[cfg(unix)]
fn standard_output_that_is_closed_is_told_and_one_that_is_thrown_away_or_left_is_none() {
    for call in [
        "list",
        "classify I4",
        "classify I4 --json",
        "classify I4 --format csv",
        "sweep V2-90 --bank-angle 0..90:10 --format csv",
        "--help",
        "--version",
        "completions zsh",
    ] {
        let (code, error) = shell(&format!("\"$0\" {call} >&-"));
        assert_eq!(
            (code, error.as_str()),
            (Some(1), "error: cannot write to standard output: it is closed\n"),
            "{call}"
        );
        for to in [">/dev/null", "1<>/dev/null", "| head -n 1 >/dev/null", "<&- >/dev/null"] {
            let (code, error) = shell(&format!("\"$0\" {call} {to}"));
            assert_eq!((code, error.as_str()), (Some(0), ""), "{call} {to}");
        }
    }
}

#[test]
#[cfg(unix)]
fn a_full_disk_advises_no_format() {
    for call in ["classify I4 --format csv", "sweep V2-90 --bank-angle 0..90:10 --format csv"] {
        let (code, error) = shell(&format!("\"$0\" {call} >/dev/full"));
        assert_eq!(code, Some(1), "{error}");
        assert!(error.contains("No space left on device") && !error.contains("--format"), "{call}: {error}");
    }
}

#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    let mut child = program().args(["report", "V8-crossplane"]).stdout(Stdio::piped()).spawn().expect("it starts");
    drop(child.stdout.take());
    assert!(child.wait().expect("a status").success());
}

#[test]
#[cfg(unix)]
fn paths_that_are_no_text_are_read_and_written() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = scratch("no-text");
    let file = folder.join(OsStr::from_bytes(b"\xff\xfe.toml"));
    let output = folder.join(OsStr::from_bytes(b"out-\xff"));
    fs::write(
        &file,
        "[inline]\nthrows = [0, 180, 180, 0]\nmechanism.rod_ratio = 0.3\n"
            .replace("mechanism", "[mechanism]\n")
            .replace("]\n.", "]\n"),
    )
    .expect("a file");
    for arguments in [
        vec!["classify"],
        vec!["compare", "I4"],
        vec!["report"],
        vec!["accuracy"],
        vec!["sweep", "--set", "mechanism.rod_ratio=0.2..0.3:0.1"],
    ] {
        let mut arguments: Vec<&OsStr> = arguments.into_iter().map(OsStr::new).collect();
        arguments.push(file.as_os_str());
        if arguments[0] != "classify" {
            arguments.extend([OsStr::new("--output"), output.as_os_str()]);
        }
        let answer = call(&arguments);
        assert!(answer.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&answer.stderr));
    }
    assert!(output.join("report.md").is_file() && output.join("sweep.csv").is_file());
    fs::write(folder.join("claims.toml"), "[[claim]]\nlayout = \"I4\"\nsays = \"first-order force vanishes\"\n")
        .expect("a file");
    let claims = folder.join(OsStr::from_bytes(b"\xff.toml"));
    fs::rename(folder.join("claims.toml"), &claims).expect("renamed");
    assert!(call(&[OsStr::new("check"), claims.as_os_str()]).status.success());
}

#[test]
fn auto_takes_a_number_and_leaves_the_layout() {
    let folder = scratch("auto");
    let file = folder.join("i4.toml");
    let numbers = "speed = 3000\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = \"0.1 m\"\n\
        [mechanism]\nreciprocating_mass = 0.5\ncrank_radius = 0.04\nrod_length = 0.14\n";
    fs::write(&file, numbers).expect("a file");
    let file = file.to_str().expect("UTF-8");
    let answer = |arguments: &[&str]| {
        let output = call(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let plain = answer(&["loads", file, "--auto"]);
    assert_eq!(answer(&["loads", "--auto", file]), plain);
    assert_eq!(answer(&["loads", "--auto", "0.1", file]), plain);
    assert_eq!(answer(&["loads", file, "--auto=0.1"]), plain);
    assert_eq!(answer(&["loads", file, "--auto", "0.1%"]), plain);
    assert_eq!(answer(&["loads", file, "--auto", "--json"]), answer(&["loads", "--auto", "0.1", "--json", file]));
    let refused = call(&["loads", file, "--auto", "80"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("from 0.000000001 to 50"));
}

#[test]
fn angles_of_more_than_a_million_turns_are_refused_by_name() {
    let search = ["search", "--cylinders", "4", "--cycle", "two-stroke", "--bank-angle"];
    for angle in ["1e100", "-1e100", "360000001", "1000001 turn"] {
        let output = call(&[&search[..], &[angle]].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() != Some(0) && !message.contains("280"), "{angle}: {message}");
        let sweep = call(&["sweep", "V2-90", "--bank-angle", &format!("{angle}..{angle}:1")]);
        assert!(!sweep.status.success(), "{angle}");
    }
    let message = call(&[&search[..], &["1e100"]].concat()).stderr;
    assert!(String::from_utf8_lossy(&message).contains("more than 1000000 turns"));
}

/// The largest and the smallest quantities that are read give numbers everywhere; beyond them a word.
#[test]
fn no_output_holds_an_infinite_number() {
    let folder = scratch("infinite");
    let file = folder.join("large.toml");
    let path = file.to_str().expect("UTF-8");
    let mut answered = 0;
    for size in ["1e40", "1e-40", "1e99"] {
        for keys in ["speed", "reciprocating_mass", "crank_radius", "spacing", "all"] {
            let of = |key: &str| if keys == key || keys == "all" { size } else { "1" };
            let text = format!(
                "speed = {}\nbearings = [5, 3, 1, -1, -5]\neffects = [\"torque\", \"remedy\"]\n[inline]\nthrows = [0, 90, 270, 180]\nspacing = \"{} m\"\n\
                 [mechanism]\nreciprocating_mass = {}\ncrank_radius = {}\nrod_ratio = 0.3\n[crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = 1\n",
                of("speed"),
                of("spacing"),
                of("reciprocating_mass"),
                of("crank_radius")
            );
            fs::write(&file, &text).expect("a file");
            for command in [
                "classify",
                "classify --json",
                "loads",
                "loads --json",
                "bearings",
                "bearings --json",
                "report",
                "remedy",
                "remedy --json",
                "compare I4",
                "compare I4 --json",
                "sweep --speed=1..2:1 --format=json",
                "sweep --speed=1..2:1 --format=csv",
                "report --format=latex",
                "accuracy",
            ] {
                // It takes a second or more: masses, lengths and speed together, and speed alone, stand for the others.
                if command == "accuracy" && !["speed", "all"].contains(&keys) {
                    continue;
                }
                let arguments: Vec<&str> = command.split(' ').chain([path]).collect();
                let output = call(&arguments);
                let (out, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
                assert!(matches!(output.status.code(), Some(0 | 1)), "{command}, {keys} {size}: {error}");
                // Quantities that no engine has are told, and answered.
                let is_refused = error.lines().any(|line| line.starts_with("error"));
                assert_eq!(output.status.success(), !is_refused, "{command}, {keys} {size}: {error}");
                answered += usize::from(output.status.success());
                let words = out.split(|letter: char| !letter.is_alphanumeric());
                let odd = words.into_iter().find(|word| ["inf", "NaN", "nan", "Infinity"].contains(word));
                assert_eq!(odd, None, "{command}, {keys} {size}");
                let is_null = |line: &&str| {
                    line.contains("null")
                        && !line.contains("_theta_deg")
                        && (line.contains("value") || line.contains("force") || line.contains("peak"))
                };
                assert!(
                    !command.contains("json") || out.lines().find(is_null).is_none(),
                    "{command}, {keys} {size}: {:?}",
                    out.lines().find(is_null)
                );
            }
        }
    }
    assert!(answered > 50, "only {answered} calls were answered");
}

#[test]
fn a_wrong_value_of_an_option_is_wrong_usage() {
    for arguments in [
        &["sweep", "I4"][..],
        &["sweep", "V8-crossplane", "--bank-angle", "0..180"],
        &["compare", "I4"],
        &["remedy", "I4", "--planes", "0"],
        &["remedy", "I4", "--speeds", "2000,x"],
        &["search", "--cylinders", "4", "--cycle", "four-stroke", "--limit", "2=-1"],
        &["classify", "I4", "--firing", "--mode-shape", "1,2,3,x"],
        &["figure", "I4", "star:2", "--format", "svg", "--standalone"],
        &["loads", "examples/four.toml", "--format", "text", "--above", "20"],
    ] {
        let output = call(arguments);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{arguments:?}: {told}");
    }
    let torque = call(&["classify", "I4", "--torque", "--format", "csv"]);
    assert!(
        String::from_utf8_lossy(&torque.stderr).contains("--torque asks for is in the table `torque`"),
        "{torque:?}"
    );
}
