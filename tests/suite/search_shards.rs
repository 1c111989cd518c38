//! Is a search in shards, on any number of machines and stopped at any time, the one that runs at once?

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::Command;

use crankstar::engine::Cycle;
use crankstar::exact::Turn;
use crankstar::search::{self, Front, Options, Pieces, Problem, SearchError, Way, search};
use crankstar::shard::{Merged, Shard, Store};

use crate::support::program::scratch;

fn json(front: &Front) -> String {
    serde_json::to_string_pretty(&search::document(front)).expect("a document")
}

fn problems() -> Vec<Problem> {
    let vee = Problem { bank_angle: Some(Turn::fraction(1, 4)), ..Problem::inline(12, Cycle::FourStroke, &[1, 2]) };
    let grid = Problem { grid: Some(4), ..Problem::inline(6, Cycle::FourStroke, &[1, 2]) };
    vec![
        Problem::inline(4, Cycle::FourStroke, &[1, 2]),
        Problem::inline(7, Cycle::TwoStroke, &[1, 2]),
        Problem::inline(8, Cycle::TwoStroke, &[1, 2, 4]),
        Problem { neighbours: true, ..Problem::inline(9, Cycle::TwoStroke, &[1, 2]) },
        Problem::inline(12, Cycle::TwoStroke, &[1, 2]),
        vee,
        grid,
    ]
}

fn parse(shard: &str) -> Shard {
    Shard::parse(shard).expect("a shard")
}

/// The files of all shards.
fn shards(pieces: &Pieces, folder: &Path, of: usize) -> Vec<PathBuf> {
    let file = |number: usize| {
        let path = folder.join(format!("{number}-{of}.shard"));
        pieces.keep(parse(&format!("{number}/{of}")), &path, &Options::default()).expect("a shard");
        path
    };
    (1..=of).map(file).collect()
}

#[test]
fn merged_shards_are_the_answer_of_one_search_in_any_number_order_and_grouping() {
    let folder = scratch("search-shards");
    for (place, problem) in problems().iter().enumerate() {
        let whole = json(&search(problem, &Options::default()).expect("a front"));
        let folder = folder.join(place.to_string());
        // Each machine cuts the question for itself.
        let pieces = || Pieces::new(problem, Way::default()).expect("a question");
        for of in [1, 2, 3, 7] {
            let mut files = shards(&pieces(), &folder, of);
            files.reverse();
            assert_eq!(json(&pieces().merged(&files).expect("a front")), whole, "{of} shards of {problem:?}");
            let (one, other) = files.split_at(of / 2);
            let question = pieces().question();
            let grouped = [one, other].map(|some| {
                let path =
                    folder.join(format!("{}-of-{of}-together.shard", some.len() + 10 * usize::from(some == other)));
                Merged::open(some, &question).and_then(|merged| merged.keep(&path, &question)).expect("a file");
                path
            });
            assert_eq!(
                json(&pieces().merged(&grouped).expect("a front")),
                whole,
                "{of} shards of {problem:?}, grouped"
            );
        }
    }
}

#[test]
fn two_shards_of_every_small_engine_are_its_search() {
    let folder = scratch("search-shards-small");
    for (cylinders, cycle) in (1..=10).flat_map(|n| [(n, Cycle::TwoStroke), (n, Cycle::FourStroke)]) {
        let problem = Problem { neighbours: cylinders % 3 == 0, ..Problem::inline(cylinders, cycle, &[1, 2, 4]) };
        let Ok(pieces) = Pieces::new(&problem, Way::default()) else { continue };
        let whole = json(&search(&problem, &Options::default()).expect("a front"));
        let folder = folder.join(format!("{cylinders}-{cycle:?}"));
        assert_eq!(json(&pieces.merged(&shards(&pieces, &folder, 2)).expect("a front")), whole, "{problem:?}");
    }
}

#[test]
fn a_shard_that_is_stopped_after_any_piece_goes_on_to_the_same_bytes() {
    let folder = scratch("search-shards-stopped");
    let problem = Problem::inline(10, Cycle::TwoStroke, &[1, 2]);
    let pieces = Pieces::new(&problem, Way::default()).expect("a question");
    let (at_once, stopped) = (folder.join("whole.shard"), folder.join("stopped.shard"));
    pieces.keep(parse("2/3"), &at_once, &Options::default()).expect("a shard");
    let stop = |_| ControlFlow::Break(());
    loop {
        // One more piece each time.
        match pieces.keep(parse("2/3"), &stopped, &Options { threads: 2, progress: &stop, ..Options::default() }) {
            Ok(()) => break,
            Err(error) => assert_eq!(error, SearchError::Stopped),
        }
    }
    assert_eq!(fs::read(&stopped).expect("bytes"), fs::read(&at_once).expect("bytes"));
}

#[test]
fn a_file_cut_off_anywhere_is_gone_on_with_and_a_changed_byte_never_changes_the_answer() {
    let file = scratch("search-shards-damaged").join("state.shard");
    let options = || Options { resume: Some(file.clone()), ..Options::default() };
    let five = Problem::inline(5, Cycle::TwoStroke, &[1, 2]);
    let whole = json(&search(&five, &options()).expect("a front"));
    let text = fs::read(&file).expect("bytes");
    let mut refused = 0;
    for at in 0..text.len() {
        fs::write(&file, &text[..at]).expect("written");
        assert_eq!(json(&search(&five, &options()).expect("it goes on")), whole, "cut off at {at}");
        assert_eq!(fs::read(&file).expect("bytes"), text);
        let mut bytes = text.clone();
        bytes[at] ^= 1 << (at % 8);
        fs::write(&file, &bytes).expect("written");
        match search(&five, &options()) {
            Ok(front) => assert_eq!(json(&front), whole, "{at}"),
            Err(error) => {
                refused += 1;
                assert!(error.to_string().contains("state.shard"), "{at}: {error}");
            }
        }
    }
    assert!(refused > text.len() / 2, "{refused} of {}", text.len());
    let other = Problem::inline(5, Cycle::TwoStroke, &[1, 2, 4]);
    fs::write(&file, &text).expect("written");
    let told = search(&other, &options()).expect_err("refused").to_string();
    assert!(told.contains("belongs to another question"), "{told}");
}

#[test]
fn a_missing_an_unfinished_and_a_foreign_shard_are_told() {
    let folder = scratch("search-shards-refused");
    let problem = Problem::inline(8, Cycle::TwoStroke, &[1, 2]);
    let pieces = Pieces::new(&problem, Way::default()).expect("a question");
    let files = shards(&pieces, &folder, 3);
    let refusal = |files: &[PathBuf]| pieces.merged(files).expect_err("refused").to_string();
    let missing = refusal(&files[1..]);
    assert!(missing.contains("pieces are in none of the files; shard 1/3 computes"), "{missing}");
    let one_each = shards(&pieces, &folder, pieces.question().pieces);
    let missing = refusal(&one_each[1..]);
    assert!(missing.contains("pieces is in none of the files"), "{missing}");
    let stopped = folder.join("stopped.shard");
    let bytes = fs::read(&files[0]).expect("bytes");
    fs::write(&stopped, &bytes[..bytes.len() - 5]).expect("written");
    let told = refusal(&[stopped, files[1].clone(), files[2].clone()]);
    assert!(told.contains("is not finished"), "{told}");
    let other = Problem { orders: vec![1, 2, 4], ..problem.clone() };
    let foreign = Pieces::new(&other, Way::default()).expect("a question");
    fs::create_dir(folder.join("other")).expect("a folder");
    let foreign = shards(&foreign, &folder.join("other"), 1);
    assert!(refusal(&[&files[..], &foreign[..]].concat()).contains("another question"));
}

/// Whoever makes the digests for an altered file is still told where it does not fit the question.
#[test]
fn counts_and_stars_that_cannot_have_come_of_their_piece_are_refused_though_their_digest_is_right() {
    let folder = scratch("search-shards-altered");
    let seven = Problem::inline(7, Cycle::TwoStroke, &[1, 2]);
    let pieces = Pieces::new(&seven, Way::default()).expect("a question");
    let question = pieces.question();
    let file = shards(&pieces, &folder, 1).remove(0);
    let merged = Merged::open(std::slice::from_ref(&file), &question).expect("a file");
    let value =
        |number| -> serde_json::Value { serde_json::from_slice(&merged.read(number).expect("a piece")).expect("JSON") };
    let values: Vec<serde_json::Value> = (0..question.pieces).map(value).collect();
    let has_stars = |value: &serde_json::Value| !value["stars"].as_array().expect("stars").is_empty();
    let with = values.iter().position(has_stars).expect("a star");
    let another = (0..values.len()).find(|other| *other != with).expect("two pieces");
    type Damage<'a> = Box<dyn Fn(&mut Vec<serde_json::Value>) + 'a>;
    let set = |key: &'static str, to: u64| -> Damage { Box::new(move |values| values[with][key] = to.into()) };
    let of_star =
        |key: &'static str, to: u64| -> Damage { Box::new(move |values| values[with]["stars"][0][key] = to.into()) };
    let damages: Vec<(&str, Damage)> = vec![
        ("no star was decided", set("judged", 0)),
        ("more were decided than there are", set("judged", 721)),
        ("a sum that would wrap", set("judged", u64::MAX)),
        ("more starts than there are", set("cut", u64::MAX)),
        ("an unknown key", set("more", 1)),
        ("no class", of_star("classes", 0)),
        ("more classes than were decided", of_star("classes", 700)),
        ("more classes than can be counted", of_star("classes", u64::MAX)),
        ("no star", of_star("stars", 0)),
        ("more stars than its classes hold", of_star("stars", 1_000_000)),
        (
            "a star of another piece",
            Box::new(|values| {
                values[another]["stars"] = values[with]["stars"].clone();
                values[another]["judged"] = 300.into();
            }),
        ),
        (
            "a star twice",
            Box::new(|values| {
                let star = values[with]["stars"][0].clone();
                values[with]["stars"].as_array_mut().expect("stars").push(star);
            }),
        ),
        ("no piece", Box::new(|values| values[with] = "nothing".into())),
    ];
    let write = |name: &str, values: &[serde_json::Value]| {
        let path = folder.join(format!("{name}.shard"));
        let mut store = Store::open(&path, &question, Shard::WHOLE).expect("a file");
        for (number, value) in values.iter().enumerate() {
            store.put(number, value.to_string().as_bytes()).expect("written");
        }
        store.finish().expect("written");
        path
    };
    let whole = json(&search(&seven, &Options::default()).expect("a front"));
    assert_eq!(json(&pieces.merged(&[write("as it was", &values)]).expect("a front")), whole);
    for (what, damage) in damages {
        let mut damaged = values.clone();
        damage(&mut damaged);
        let message = pieces.merged(&[write(what, &damaged)]).expect_err(what).to_string();
        assert!(message.contains("does not fit this search at piece"), "{what}: {message}");
    }
}

#[test]
fn the_program_searches_in_shards_and_tells_what_does_not_go_together() {
    let folder = scratch("search-shards-program");
    let file = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let call = |more: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_crankstar"))
            .args(["search", "--cylinders", "8", "--cycle", "two-stroke"])
            .args(more)
            .output()
            .expect("the program starts");
        let text = |bytes| String::from_utf8(bytes).expect("a text");
        (output.status.success(), text(output.stdout), text(output.stderr))
    };
    let (one, other, both) = (file("1.shard"), file("2.shard"), file("both.shard"));
    for (shard, path) in [("1/2", &one), ("2/2", &other)] {
        let (is_done, told, _) = call(&["--shard", shard, "--output", path]);
        assert!(is_done && told.contains("Written: "), "{told}");
    }
    for like in [&[][..], &["--json"], &["--format", "csv"]] {
        let merged = call(&[like, &["--merge", &other, &one]].concat());
        assert_eq!(merged, call(like), "{like:?}");
    }
    let (is_done, told, _) = call(&["--output", &both, "--merge", &one, &other]);
    assert!(is_done && told.contains(" pieces"), "{told}");
    assert_eq!(call(&["--merge", &both]), call(&[]));
    for (more, word) in [
        (&["--shard", "1/2"][..], "--output NAME.shard"),
        (&["--shard", "0/2", "--output", &one], "is not a shard"),
        (&["--shard", "1/2", "--output", &other], "holds shard 2/2"),
        (&["--shard", "1/2", "--output", &one, "--merge", &other], "cannot be used"),
        (&["--resume", &both, "--merge", &other], "cannot be used"),
        (&["--merge", &one], "shard 2/2 computes"),
    ] {
        let (is_done, told, error) = call(more);
        assert!(!is_done && told.is_empty() && error.contains(word), "{more:?}: {error}");
    }
}
