//! Is a table that many machines make in pieces the table that one makes, and is every piece that is missing, foreign or damaged refused?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use crankstar::file::Template;
use crankstar::report::data;
use crankstar::shard::{Merged, Question, Shard, Store};
use crankstar::sweep::{self, Geometry, Parameter};
use crankstar::table::{self, from_rows, rows};

use crate::support::dice::Dice;
use crate::support::program::{call, program, scratch};

const V8: &str = "cycle = \"four-stroke\"\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\n";

fn question(words: &str, pieces: usize) -> Question {
    Question { words: words.to_owned(), pieces }
}

/// What a piece of a question holds.
fn content(piece: usize) -> Vec<u8> {
    (0..piece * 7 % 40).map(|at| (at * piece % 251) as u8).collect()
}

/// Computes what the file of a shard lacks.
fn run(path: &Path, question: &Question, shard: Shard) {
    let mut store = Store::open(path, question, shard).expect("a file of pieces");
    let there = store.pieces();
    for piece in (0..question.pieces).filter(|piece| shard.takes(*piece) && !there.contains(piece)) {
        store.put(piece, &content(piece)).expect("it is written");
    }
    store.finish().expect("it ends");
}

fn shards(folder: &Path, question: &Question, of: usize) -> Vec<PathBuf> {
    let file = |number| {
        let path = folder.join(format!("{number}-of-{of}.shard"));
        run(&path, question, Shard::parse(&format!("{number}/{of}")).expect("a shard"));
        path
    };
    (1..=of).map(file).collect()
}

fn all(merged: &Merged) -> Vec<(usize, Vec<u8>)> {
    merged.pieces().map(|piece| (piece, merged.read(piece).expect("a piece"))).collect()
}

fn refusal(paths: &[PathBuf], question: &Question) -> String {
    match Merged::open(paths, question).and_then(Merged::whole) {
        Ok(_) => panic!("{paths:?} are merged"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn shards_are_disjoint_and_complete() {
    for of in 1..20 {
        let shards: Vec<Shard> =
            (1..=of).map(|number| Shard::parse(&format!("{number}/{of}")).expect("a shard")).collect();
        for piece in 0..100 {
            assert_eq!(shards.iter().filter(|shard| shard.takes(piece)).count(), 1, "{piece} of {of}");
        }
    }
    for text in ["0/3", "4/3", "1", "1/0", "a/3", "-1/3", "1/3/3", ""] {
        assert!(Shard::parse(text).is_err_and(|error| error.to_string().contains("i/N")), "{text}");
    }
}

#[test]
fn merging_does_not_depend_on_the_number_of_shards_their_order_or_how_they_are_grouped() {
    let folder = scratch("shards-associative");
    let mut dice = Dice::new(88);
    for round in 0..12 {
        let question = question(&format!("question {round}"), dice.below(30) as usize);
        let whole: Vec<(usize, Vec<u8>)> = (0..question.pieces).map(|piece| (piece, content(piece))).collect();
        let of = 1 + dice.below(8) as usize;
        let folder = folder.join(round.to_string());
        let mut files = shards(&folder, &question, of);
        for at in 0..files.len() {
            let other = dice.below(files.len() as u64) as usize;
            files.swap(at, other);
        }
        let merged = Merged::open(&files, &question).and_then(Merged::whole).expect("all are there");
        assert_eq!(all(&merged), whole);
        // (A B) C = A (B C), byte for byte.
        let cut = dice.below(of as u64 + 1) as usize;
        let grouped: Vec<Vec<u8>> = [0, 1]
            .into_iter()
            .map(|side| {
                let (first, rest) = files.split_at(cut);
                let (group, others) = if side == 0 { (first, rest) } else { (rest, first) };
                let part = folder.join(format!("part-{side}.shard"));
                Merged::open(group, &question).and_then(|part_of| part_of.keep(&part, &question)).expect("a part");
                let both: Vec<PathBuf> = [part].into_iter().chain(others.iter().cloned()).collect();
                let end = folder.join(format!("all-{side}.shard"));
                Merged::open(&both, &question).and_then(|merged| merged.keep(&end, &question)).expect("all");
                fs::read(end).expect("a file")
            })
            .collect();
        assert_eq!(grouped[0], grouped[1]);
    }
}

#[test]
fn a_file_that_stops_anywhere_is_refused_by_a_merge_and_gone_on_with_by_its_shard() {
    let folder = scratch("shards-stopped");
    let question = question("stops", 9);
    let shard = Shard::parse("2/2").expect("a shard");
    let path = folder.join("2.shard");
    run(&path, &question, shard);
    let whole = fs::read(&path).expect("a file");
    for length in 0..whole.len() {
        fs::write(&path, &whole[..length]).expect("a file that stops");
        assert!(Merged::open(std::slice::from_ref(&path), &question).is_err(), "{length}");
        run(&path, &question, shard);
        assert_eq!(fs::read(&path).expect("a file"), whole, "{length}");
    }
}

#[test]
fn a_byte_that_is_changed_anywhere_is_noticed() {
    let folder = scratch("shards-damaged");
    let question = question("damage", 7);
    let files = shards(&folder, &question, 2);
    let whole = fs::read(&files[0]).expect("a file");
    for at in 0..whole.len() {
        for change in [1, 0x20, 0x80] {
            let mut damaged = whole.clone();
            damaged[at] ^= change;
            fs::write(&files[0], &damaged).expect("a damaged file");
            let told = refusal(&files, &question);
            assert!(!told.contains('\n') && told.contains("1-of-2.shard"), "{at}: {told}");
        }
    }
    for more in ["x", "\n", "piece 1 0 00000000\n"] {
        fs::write(&files[0], [&whole, more.as_bytes()].concat()).expect("a longer file");
        assert!(refusal(&files, &question).contains("damaged"), "{more}");
    }
}

#[test]
fn what_is_missing_foreign_or_of_another_format_is_told_in_one_line() {
    let folder = scratch("shards-refused");
    let asked = question("asked", 10);
    let files = shards(&folder, &asked, 3);
    let told = refusal(&[files[0].clone(), files[2].clone()], &asked);
    assert!(told.contains("3 of the 10 pieces") && told.contains("shard 2/3"), "{told}");
    let foreign = question("another", 10);
    let told = refusal(&files, &foreign);
    assert!(told.contains("another question"), "{told}");
    let cut = question("asked", 11);
    assert!(refusal(&files, &cut).contains("another question"));
    let text = fs::read(&files[1]).expect("a file");
    let newer = String::from_utf8_lossy(&text).replacen("crankstar pieces 1", "crankstar pieces 2", 1);
    fs::write(&files[1], newer).expect("a newer file");
    assert!(refusal(&files, &asked).contains("format 2"));
    fs::write(&files[1], "theta,force\n0,1\n").expect("a table");
    assert!(refusal(&files, &asked).contains("not a file of pieces"));
    assert!(refusal(&[folder.join("none.shard")], &asked).contains("cannot read"));
    // The same file under the number of another shard.
    let other = Shard::parse("1/3").expect("a shard");
    let told = Store::open(&files[2], &asked, other).err().expect("refused").to_string();
    assert!(told.contains("holds shard 3/3"), "{told}");
    // Two machines that do not agree.
    let strange = folder.join("strange.shard");
    let mut store = Store::open(&strange, &asked, other).expect("a file of pieces");
    store.put(0, b"something else").expect("it is written");
    store.finish().expect("it ends");
    let told = refusal(&[files[0].clone(), strange], &asked);
    assert!(told.contains("differ in piece 0"), "{told}");
}

#[test]
fn one_process_at_a_time_writes_a_file() {
    let folder = scratch("shards-locked");
    let question = question("lock", 4);
    let path = folder.join("1.shard");
    let first = Store::open(&path, &question, Shard::WHOLE).expect("a file of pieces");
    let told = Store::open(&path, &question, Shard::WHOLE).err().expect("refused").to_string();
    assert!(told.contains("another process"), "{told}");
    drop(first);
    assert!(Store::open(&path, &question, Shard::WHOLE).is_ok());
}

#[test]
fn merged_sweeps_are_the_bytes_of_one_run() {
    let folder = scratch("shards-sweep");
    let layout = folder.join("v8.toml");
    fs::write(&layout, V8).expect("a layout");
    let layout = layout.to_str().expect("a path");
    let mut dice = Dice::new(19);
    for round in 0..3 {
        let (key, step) = [("vee.bank_angle", "1/5"), ("vee.pin_split", "-0.25"), ("vee.spacing", "1/100")][round];
        let to = ["150", "-150", "9"][round];
        let mut ask = vec!["sweep".to_owned(), layout.to_owned()];
        ask.extend(["--set".to_owned(), format!("{key}={}..{to}:{step}", if round == 2 { 1 } else { 0 })]);
        ask.extend(["--orders".to_owned(), ["1,2", "2,4", "1"][round].to_owned()]);
        let with = |more: &[&str]| {
            let all: Vec<String> = ask.iter().cloned().chain(more.iter().map(|text| (*text).to_owned())).collect();
            let output = call(&all);
            assert!(output.status.success(), "{all:?}: {}", String::from_utf8_lossy(&output.stderr));
            output.stdout
        };
        let whole = with(&["--format", "csv"]);
        let of = 2 + dice.below(3);
        let files: Vec<String> = (1..=of)
            .rev()
            .map(|number| {
                let file = folder.join(format!("{round}-{number}.shard")).to_str().expect("a path").to_owned();
                with(&["--shard", &format!("{number}/{of}"), "--output", &file]);
                file
            })
            .collect();
        let files: Vec<&str> = files.iter().map(String::as_str).collect();
        assert_eq!(with(&[&["--format", "csv", "--merge"], files.as_slice()].concat()), whole);
        let both = folder.join(format!("{round}-both.shard"));
        with(&[&["--output", both.to_str().expect("a path"), "--merge"], &files[..2]].concat());
        let grouped = [&["--format", "csv", "--merge", both.to_str().expect("a path")], &files[2..]].concat();
        assert_eq!(with(&grouped), whole);
        let kept = folder.join(format!("{round}-kept.shard"));
        let resumed = ["--format", "csv", "--resume", kept.to_str().expect("a path")];
        assert_eq!(with(&resumed), whole);
        let bytes = fs::read(&kept).expect("the pieces");
        fs::write(&kept, &bytes[..bytes.len() * 2 / 3]).expect("pieces that stop");
        assert_eq!(with(&resumed), whole);
    }
}

/// The table of pressures is in a file of its own, which two machines may have in two states.
#[test]
fn shards_of_layouts_that_name_other_pressures_are_of_another_question() {
    let folder = scratch("shards-pressures");
    let (layout, table) = (folder.join("single.toml"), folder.join("pressures.csv"));
    let text = "cycle = 'two-stroke'\nfiring_angles = [0]\neffects = ['gas']\nspeed = 1000\ninline.throws = [0]\n\
        mechanism = { stroke = '80 mm', rod_length = '150 mm', reciprocating_mass = '0.5 kg' }\n\
        gas = { bore = '80 mm', unit = 'bar', table = 'pressures.csv' }\n";
    fs::write(&layout, text).expect("a layout");
    let file = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let ask = |highest: u32, more: &[&str]| {
        fs::write(&table, format!("angle,pressure\n0,{highest}\n180,1\n360,{highest}\n")).expect("a table");
        let values = ["--speed", "1000..1300:1", "--orders", "2", "--value", "torque.cycle.highest"];
        call(&[&["sweep", &file("single.toml")], &values[..], more].concat())
    };
    for (shard, highest) in [("1/2", 50), ("2/2", 50), ("2/2", 60)] {
        let name = file(&format!("{}-{highest}.shard", &shard[..1]));
        assert!(ask(highest, &["--shard", shard, "--output", &name]).status.success());
    }
    let merged = |other: &str| ask(50, &["--format", "csv", "--merge", &file("1-50.shard"), &file(other)]);
    assert!(merged("2-50.shard").status.success());
    let refused = merged("2-60.shard");
    let told = String::from_utf8_lossy(&refused.stderr);
    assert!(!refused.status.success() && told.contains("another question"), "{told}");
    let both = file("both.csv");
    let same = format!("{}/./both.csv", folder.to_str().expect("a path"));
    let sweep = ["sweep", "V6-60-shared", "--bank-angle", "0..9:1"];
    let search = ["search", "--cylinders", "4", "--cycle", "two-stroke"];
    for asked in [&sweep[..], &search] {
        let one = call(&[asked, &["--format", "csv", "--resume", &both, "--output", &same]].concat());
        assert_eq!(one.status.code(), Some(2), "{}", String::from_utf8_lossy(&one.stderr));
    }
}

#[test]
fn a_worker_that_is_killed_loses_nothing_that_was_finished() {
    let folder = scratch("shards-killed");
    let (layout, shard) = (folder.join("v8.toml"), folder.join("1.shard"));
    fs::write(&layout, V8).expect("a layout");
    let ask = |command: &mut std::process::Command| {
        command.arg("sweep").arg(&layout).args(["--bank-angle", "0..179.9:0.1", "--orders", "1,2"]);
    };
    let mut worker = program();
    ask(&mut worker);
    worker.args(["--shard", "1/1", "--output"]).arg(&shard);
    let mut running = worker.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program starts");
    let is_in = || fs::metadata(&shard).is_ok_and(|file| file.len() > 40_000);
    while !is_in() && running.try_wait().expect("a state").is_none() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    running.kill().expect("it is killed, or ended");
    running.wait().expect("it ends");
    let before = fs::read(&shard).expect("what it left");
    assert!(worker.status().expect("the program starts").success());
    let after = fs::read(&shard).expect("the whole shard");
    // All but a piece at work is there as it was written.
    let kept = before.windows(6).rposition(|bytes| bytes == b"piece ").map_or(0, |at| at);
    assert!(kept > 0 && after.starts_with(&before[..kept]));
    let mut merge = program();
    ask(&mut merge);
    let merged = merge.args(["--format", "csv", "--merge"]).arg(&shard).output().expect("the program starts");
    let mut whole = program();
    ask(&mut whole);
    assert_eq!(merged.stdout, whole.args(["--format", "csv"]).output().expect("the program starts").stdout);
}

#[test]
fn rows_of_a_table_read_back_to_the_same_table() {
    for (text, key) in [
        (V8.to_owned(), "vee.bank_angle=0..179:1"),
        (
            format!(
                "{V8}[mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.3\nreciprocating_mass = 0.6\nrotating_mass = 0.2\n"
            ),
            "speed=0..6000:97",
        ),
    ] {
        let template = Template::new("v8.toml", &text).expect("TOML");
        let parameters = [Parameter::parse(key).expect("a parameter")];
        let sweep = sweep::sweep(&template, &parameters, &[1, 2, 4], &Geometry::default()).expect("a sweep");
        let table = data::sweep_points(&sweep);
        let read = from_rows(&table, &rows(&table)).expect("its own rows");
        assert_eq!(read, table);
        assert_eq!(table::csv(&read), table::csv(&table));
        assert_eq!(from_rows(&table, "1,2\n"), None);
        assert_eq!(from_rows(&table, rows(&table).trim_end()), None);
    }
}

#[test]
fn options_that_do_not_go_together_are_told() {
    let folder = scratch("shards-misuse");
    let file = folder.join("a.shard");
    let file = file.to_str().expect("a path");
    let ask = ["sweep", "V8-crossplane", "--bank-angle", "0..90:30"];
    for (more, word) in [
        (&["--shard", "1/2"][..], "--output NAME.shard"),
        (&["--shard", "1/2", "--output", "x.csv"], "`x.csv` is named as a file of data"),
        (&["--shard", "3/2", "--output", file], "`3/2` is not a shard"),
        (&["--shard", "1/2", "--output", file, "--format", "csv"], "in no format yet"),
        (&["--resume", file], "--format csv or parquet"),
        (&["--merge", file], "--format csv or parquet"),
        (&["--merge", file, "--format", "csv"], "cannot read"),
        (&["--shard", "1/2", "--merge", file], "cannot be used"),
    ] {
        let output = call(&[&ask, more].concat());
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && told.contains(word), "{more:?}: {told}");
    }
    assert!(!folder.join("a.shard").exists(), "nothing was written");
}

#[test]
#[ignore = "starts the daemons of Slurm for a minute, as root; it says so where Slurm is not installed"]
fn an_array_job_of_slurm_loses_nothing_when_a_node_is_killed() {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/cluster/test-slurm.sh");
    let mut command = std::process::Command::new("bash");
    let output = command.arg(script).env("CRANKSTAR", env!("CARGO_BIN_EXE_crankstar")).env("LAST", "17.9982").output();
    let output = output.expect("bash starts");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    println!("{told}");
    assert!(output.status.success(), "{told}{}", String::from_utf8_lossy(&output.stderr));
    assert!(told.contains("nothing is lost") || told.starts_with("skipped: "), "{told}");
}
