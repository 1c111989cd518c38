//! Is a person at a terminal told that a command still works, and does that go away?

#![cfg(target_os = "linux")]

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::support::program::{program, scratch};

/// Starts a call on a terminal of its own; `$0` is the program.
fn on_a_terminal(call: &str, folder: &Path) -> Child {
    let call = call.replace("$0", env!("CARGO_BIN_EXE_crankstar"));
    let mut command = Command::new("script");
    command.args(["--quiet", "--flush", "--return", "--command", &call, "/dev/null"]).current_dir(folder);
    command.env("TERM", "xterm").stdin(Stdio::null()).stdout(Stdio::piped());
    command.spawn().expect("`script` of util-linux")
}

/// All that a terminal is sent.
fn sent(mut child: Child) -> String {
    let mut bytes = Vec::new();
    child.stdout.take().expect("a pipe").read_to_end(&mut bytes).expect("bytes");
    assert!(child.wait().expect("a status").success());
    String::from_utf8_lossy(&bytes).into_owned()
}

/// What the last line of a terminal shows after all that was sent: a line is erased, or written on from its first column.
fn last_line(sent: &str) -> String {
    let line = sent.rsplit(['\r', '\n']).find(|line| !line.is_empty()).unwrap_or_default();
    line.rsplit("\u{1b}[2K").next().unwrap_or_default().to_owned()
}

#[test]
fn a_command_that_takes_long_is_told_on_a_terminal_until_it_ends() {
    let scratch = scratch("progress-spinner");
    let folder = scratch.join("report");
    fs::create_dir(&folder).expect("a folder");
    // The program waits for as long as another writer holds the folder.
    let lock = fs::File::open(&folder).expect("a folder");
    lock.lock().expect("a lock");
    let mut child = on_a_terminal("$0 report I4 --output report 2>&1 >answer.txt", &scratch);
    let mut told = Vec::new();
    let mut bytes = child.stdout.take().expect("a pipe");
    while !String::from_utf8_lossy(&told).contains("computing") {
        let mut some = [0; 64];
        let count = bytes.read(&mut some).expect("bytes");
        assert!(count > 0, "it ended without a word: {}", String::from_utf8_lossy(&told));
        told.extend_from_slice(&some[..count]);
    }
    lock.unlock().expect("unlocked");
    bytes.read_to_end(&mut told).expect("bytes");
    assert!(child.wait().expect("a status").success());
    let told = String::from_utf8_lossy(&told).into_owned();
    assert_eq!(last_line(&told), "", "{told:?}");
    assert!(fs::read_to_string(scratch.join("answer.txt")).expect("an answer").contains("Written: "));
}

#[test]
fn a_bar_goes_away_and_none_is_drawn_between_rows_on_a_terminal() {
    let scratch = scratch("progress-bar");
    let ask = "$0 sweep V2-90 --bank-angle 0..90:0.1 --orders 1 --format csv";
    let apart = sent(on_a_terminal(&format!("{ask} --output points.csv >/dev/null"), &scratch));
    assert!(apart.contains("pieces") && last_line(&apart).is_empty(), "{apart:?}");
    let rows = sent(on_a_terminal(ask, &scratch));
    let printed: Vec<&str> = rows.split("\r\n").filter(|line| !line.is_empty()).collect();
    let table = fs::read_to_string(scratch.join("points.csv")).expect("a table");
    assert_eq!(printed, table.lines().collect::<Vec<_>>(), "rows and nothing else");
}

#[test]
fn nothing_is_told_where_no_terminal_is() {
    let output = program()
        .args(["sweep", "V2-90", "--bank-angle", "0..90:0.1", "--orders", "1", "--format", "csv"])
        .output()
        .expect("it runs");
    assert!(output.status.success() && output.stderr.is_empty());
}
