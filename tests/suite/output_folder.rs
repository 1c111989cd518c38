//! Does `--output` keep what it promises, whenever the program is killed and whoever else writes?

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::support::dice::Dice;
use crate::support::program::{call, program, scratch};

/// All files below a folder with their bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("an entry").path());
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    entries.filter(|path| path.is_file()).map(|path| (name(&path), fs::read(&path).expect("bytes"))).collect()
}

fn report(engine: &str, folder: &Path) -> Command {
    let mut command = program();
    command.args(["report", engine, "--output"]).arg(folder).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// The report of an engine as an undisturbed run writes it.
fn undisturbed(engine: &str, scratch: &Path) -> BTreeMap<String, Vec<u8>> {
    let folder = scratch.join(format!("whole-{engine}"));
    assert!(report(engine, &folder).status().expect("it runs").success());
    let whole = files(&folder);
    assert!(whole.len() > 3 && whole.contains_key("report.md"));
    whole
}

/// Starts a report and kills it after so long; whether it had come to its end before.
fn killed(engine: &str, folder: &Path, after: Duration) -> bool {
    let mut child = report(engine, folder).spawn().expect("it starts");
    thread::sleep(after);
    let ended = child.try_wait().expect("a status").is_some();
    // It may have ended by now.
    let _ = child.kill();
    child.wait().expect("a status");
    ended
}

#[test]
fn a_new_folder_is_whole_or_absent_whenever_the_program_is_killed_and_the_next_run_clears_up() {
    let scratch = scratch("output-killed-new");
    let whole = undisturbed("V8-crossplane", &scratch);
    let mut dice = Dice::new(7);
    for round in 0..30_u64 {
        let folder = scratch.join("new").join("report");
        killed("V8-crossplane", &folder, Duration::from_micros(500 * round + dice.below(3000)));
        let found = files(&folder);
        assert!(found.is_empty() && !folder.exists() || found == whole, "round {round}: {:?}", found.keys());
        if folder.exists() {
            fs::remove_dir_all(&folder).expect("removed");
        }
    }
    let folder = scratch.join("new").join("report");
    assert!(report("V8-crossplane", &folder).status().expect("it runs").success());
    let left: Vec<_> =
        fs::read_dir(scratch.join("new")).expect("a folder").map(|e| e.expect("an entry").file_name()).collect();
    assert_eq!(left, ["report"], "what killed runs have staged is gone");
}

#[test]
fn in_an_old_folder_each_file_is_whole_and_the_next_run_mends_what_a_killed_one_left() {
    let scratch = scratch("output-killed-old");
    let (old, new) = (undisturbed("I4", &scratch), undisturbed("V8-crossplane", &scratch));
    let folder = scratch.join("report");
    let mut dice = Dice::new(11);
    for round in 0..30_u64 {
        assert!(report("I4", &folder).status().expect("it runs").success());
        fs::write(folder.join("notes.txt"), "mine").expect("a file");
        killed("V8-crossplane", &folder, Duration::from_micros(500 * round + dice.below(3000)));
        for (name, bytes) in files(&folder) {
            let is_whole = old.get(&name) == Some(&bytes) || new.get(&name) == Some(&bytes);
            assert!(is_whole || name == "notes.txt" || name.starts_with('.'), "round {round}: {name} is of neither");
        }
        let page = fs::read(folder.join("report.md")).expect("a page");
        let is_new = page == new["report.md"];
        assert!(
            !is_new || new.iter().all(|(name, bytes)| files(&folder).get(name) == Some(bytes)),
            "the page is the last"
        );
        assert!(report("V8-crossplane", &folder).status().expect("it runs").success());
        let mended = files(&folder);
        assert!(new.iter().all(|(name, bytes)| mended.get(name) == Some(bytes)), "round {round}");
        assert!(mended.keys().all(|name| !name.starts_with('.')), "{:?}", mended.keys());
        assert_eq!(mended["notes.txt"], b"mine");
    }
}

#[test]
fn two_writers_at_once_leave_the_report_of_one_of_them() {
    let scratch = scratch("output-two-writers");
    let (one, other) = (undisturbed("I4", &scratch), undisturbed("V8-crossplane", &scratch));
    for round in 0..10 {
        // Every other time the folder is there before.
        let folder = scratch.join(format!("report-{round}"));
        if round % 2 == 1 {
            fs::create_dir(&folder).expect("a folder");
        }
        let mut writers = ["I4", "V8-crossplane"].map(|engine| report(engine, &folder).spawn().expect("it starts"));
        assert!(writers.iter_mut().all(|writer| writer.wait().expect("a status").success()), "round {round}");
        let found = files(&folder);
        let is = |whole: &BTreeMap<String, Vec<u8>>| whole.iter().all(|(name, bytes)| found.get(name) == Some(bytes));
        assert!(is(&one) || is(&other), "round {round}: a mix");
        assert!(found.keys().all(|name| one.contains_key(name) || other.contains_key(name)), "{:?}", found.keys());
        let beside = fs::read_dir(&scratch).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        assert!(beside.into_iter().all(|name| !name.to_string_lossy().starts_with('.')), "nothing is left beside");
    }
}

/// A staged folder that a writer holds.
#[cfg(unix)]
fn locked(staging: &Path) -> fs::File {
    let lock = fs::File::open(staging).expect("a folder");
    lock.lock().expect("a lock");
    lock
}

/// The same on Windows: a file beside the folder, which nobody else can open.
#[cfg(windows)]
fn locked(staging: &Path) -> fs::File {
    use std::os::windows::fs::OpenOptionsExt;
    let mut options = fs::File::options();
    options.write(true).create(true).truncate(false).share_mode(0);
    options.open(staging.with_extension("crankstar-lock")).expect("a lock")
}

/// One file, of a remedy, a drawing or data: the old one stays until the new one is whole.
#[test]
#[cfg(unix)]
fn a_file_that_is_replaced_on_a_full_disk_is_the_old_one() {
    let scratch = scratch("output-full-file");
    for call in ["remedy I3 --write old.toml", "figure I4 end-view --output old.svg", "classify I4 --output old.csv"] {
        let old = scratch.join(call.rsplit(' ').next().expect("a name"));
        fs::write(&old, "old").expect("a file");
        let script = format!("trap '' XFSZ; ulimit -f 0; exec \"$0\" {call}");
        let program = env!("CARGO_BIN_EXE_crankstar");
        let output = Command::new("sh").args(["-c", &script, program]).current_dir(&scratch).output().expect("a shell");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{call}: {message}");
        let name = old.file_name().expect("a name").to_string_lossy().into_owned();
        assert!(message.contains(&format!("cannot write `{name}`: ")), "{call}: {message}");
        assert_eq!(fs::read_to_string(&old).expect("the old one"), "old", "{call}");
    }
    assert!(files(&scratch).keys().all(|name| !name.starts_with('.')));
}

/// A link is written through and stays one; so is a pipe, which has no place for another file to take.
#[test]
#[cfg(unix)]
fn links_and_pipes_that_are_written_to_stay_what_they_are() {
    let scratch = scratch("output-links");
    let shell = |script: &str| {
        let program = env!("CARGO_BIN_EXE_crankstar");
        let output = Command::new("sh").args(["-c", script, program]).current_dir(&scratch).output().expect("a shell");
        assert!(output.status.success(), "{script}: {}", String::from_utf8_lossy(&output.stderr));
    };
    for (call, begin) in [
        ("remedy I3 --write", "# The throws"),
        ("figure I4 end-view --output", "<svg "),
        ("classify I4 --format json --output", "{"),
        ("sweep V2-45 --bank-angle 0..90:30 --format csv --output", "bank_angle"),
    ] {
        let ending = match call.split(' ').next() {
            Some("figure") => "svg",
            Some("classify") => "json",
            Some("sweep") => "csv",
            _ => "toml",
        };
        let name = |name: &str| scratch.join(format!("{name}.{ending}"));
        shell(&format!(
            "echo old >real.{ending}; ln -s real.{ending} link.{ending}; \"$0\" {call} link.{ending}; \
             mkfifo pipe.{ending}; cat pipe.{ending} >read.{ending} & \"$0\" {call} pipe.{ending}; wait"
        ));
        assert!(name("link").is_symlink() && !name("pipe").is_file(), "{call}");
        for written in ["real", "read"] {
            let text = fs::read_to_string(name(written)).expect("a text");
            assert!(text.starts_with(begin), "{call} {written}: {text}");
        }
    }
}

#[test]
fn what_another_writer_has_staged_is_left_alone_and_what_a_killed_one_has_is_not() {
    let scratch = scratch("output-staging");
    let (held, abandoned, foreign) = (
        scratch.join(".report.1-0.crankstar-partial"),
        scratch.join(".report.2-0.crankstar-partial"),
        scratch.join(".report.mine.crankstar-partial"),
    );
    for folder in [&held, &abandoned, &foreign] {
        fs::create_dir(folder).expect("a folder");
        fs::write(folder.join("report.md"), "half").expect("a file");
    }
    let _lock = locked(&held);
    assert!(report("I4", &scratch.join("report")).status().expect("it runs").success());
    assert!(held.join("report.md").is_file() && foreign.join("report.md").is_file() && !abandoned.exists());
}

/// A file system that is full, or a limit on the size of files, is told; nothing is half written.
#[test]
#[cfg(unix)]
fn a_disk_that_is_full_is_told_and_nothing_is_half_written() {
    let scratch = scratch("output-full");
    let whole = undisturbed("I4", &scratch);
    let run = |folder: &Path| {
        let script = "trap '' XFSZ; ulimit -f 4; exec \"$0\" report V8-crossplane --output \"$1\"";
        let program = env!("CARGO_BIN_EXE_crankstar");
        Command::new("sh").args(["-c", script, program]).arg(folder).output().expect("a shell")
    };
    let fresh = scratch.join("fresh");
    let output = run(&fresh);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("cannot write the folder") && !fresh.exists(), "{message}");
    let old = scratch.join("whole-I4");
    assert_eq!(run(&old).status.code(), Some(1));
    assert!(files(&old).keys().all(|name| !name.starts_with('.')));
    assert_eq!(files(&old)["report.md"], whole["report.md"], "the page is the last");
    let left = fs::read_dir(&scratch)
        .expect("a folder")
        .filter(|e| e.as_ref().expect("an entry").file_name().to_string_lossy().starts_with('.'));
    assert_eq!(left.count(), 0);
}

/// A mount point cannot be renamed or replaced; where none may be made here, there is nothing to test.
#[test]
#[cfg(target_os = "linux")]
fn a_mount_point_is_filled() {
    let scratch = scratch("output-mount");
    let script = "mount -t tmpfs -o size=4m none \"$1\" 2>/dev/null || exit 77; \
        \"$0\" report I4 --output \"$1\" >/dev/null && \"$0\" report I4 --output \"$1\" >/dev/null && test -s \"$1/report.md\"";
    let program = env!("CARGO_BIN_EXE_crankstar");
    let status = Command::new("unshare").args(["-rm", "sh", "-c", script, program]).arg(&scratch).output();
    match status.map(|output| output.status.code()) {
        Ok(Some(0)) => {}
        // No leave to mount, or no such tool.
        Ok(Some(77)) | Err(_) => eprintln!("no file system can be mounted here"),
        Ok(Some(1)) if Command::new("unshare").args(["-rm", "true"]).status().is_ok_and(|status| !status.success()) => {
            eprintln!("no name space can be made here");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_stands_in_the_place_of_a_file_is_told_before_any_file_is_replaced() {
    let scratch = scratch("output-place");
    let folder = scratch.join("report");
    for taken in ["report.md", "order-2.svg", "side-view.svg"] {
        let _ = fs::remove_dir_all(&folder);
        assert!(report("I4", &folder).status().expect("it runs").success());
        fs::remove_file(folder.join(taken)).expect("removed");
        fs::create_dir(folder.join(taken)).expect("a folder");
        let before = files(&folder);
        let output = call(&["report".as_ref(), "V8-crossplane".as_ref(), "--output".as_ref(), folder.as_os_str()]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains(&format!("{taken}` is a folder, where a file is needed")), "{message}");
        assert!(files(&folder) == before, "{taken}: a file was replaced");
    }
    // A sheet stands in a folder inside the folder.
    let class = scratch.join("class");
    fs::create_dir(&class).expect("a folder");
    fs::write(class.join("sheets"), "mine").expect("a file");
    let output = call(&["exercise".as_ref(), "I4".as_ref(), "--output".as_ref(), class.as_os_str()]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("sheets` is a file, where a folder is needed"), "{message}");
    assert_eq!(files(&class).len(), 1, "{:?}", files(&class).keys());
}

#[test]
fn a_folder_that_cannot_be_is_told() {
    let scratch = scratch("output-cannot");
    fs::write(scratch.join("file"), "").expect("a file");
    for folder in [scratch.join("file"), scratch.join("file/below"), "/dev/null/below".into(), "/proc/crankstar".into()]
    {
        let output = call(&["report".as_ref(), "I4".as_ref(), "--output".as_ref(), folder.as_os_str()]);
        assert_eq!(output.status.code(), Some(1), "{}", folder.display());
        assert!(String::from_utf8_lossy(&output.stderr).starts_with("error: "), "{}", folder.display());
    }
}
