//! Which pages stand in `reports/`, and is every other page still what it was?
//!
//! What people read stands there. Of any other page a digest does, in `reports/digests.txt`: each change of it is seen. `CRANKSTAR_PAGES=FOLDER` writes
//! all pages there, to be compared with those of another commit, as `.ci/run` does. `CRANKSTAR_RENEW=1` renews both.

use std::collections::BTreeMap;
use std::env;
use std::fs::{self, File};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

/// The folder of the pages.
pub fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

/// The families of the catalogue that stand there, in Markdown and in LaTeX.
const READ: [&str; 9] = ["I2-", "I3/", "I4", "I5-", "I6", "V4-", "V6-", "V8-", "radial-9/"];
/// Folders beside the catalogue whose Markdown stands there with its pictures; of the engines of the world one for each kind of engine.
const BESIDE: [&str; 15] = [
    "atlas/",
    "engines/bmw-six/",
    "engines/commer-ts3/",
    "engines/ducati-90/",
    "engines/harley-shovelhead/",
    "engines/honda-rc211v/",
    "engines/kinner-r5/",
    "engines/mercedes-m112/",
    "engines/subaru-ej25/",
    "engines/vw-vr6/",
    "engines/yamaha-r1/",
    "examples/",
    "families/",
    "questions/",
    "stars/",
];
/// A page in each format that stands there in no other place.
const SAMPLES: [&str; 6] = [
    "atlas/atlas.tex",
    "examples/v8-gas/report.tex",
    "examples/v8-gas/report.typ",
    "examples/v8-gas/report.txt",
    "families/v-twin/report.html",
    "families/v6-split-pins/report.tex",
];

/// Whether a file stands there, by its place below `reports`.
pub fn is_kept(place: &str) -> bool {
    let is_of = |folders: &[&str]| folders.iter().any(|folder| place.starts_with(folder));
    let is_index = !place.trim_start_matches("engines/").contains('/');
    match place.rsplit('.').next() {
        Some("csv" | "toml") => true,
        Some("md" | "svg") => is_index || is_of(&READ) || is_of(&BESIDE),
        ending => SAMPLES.contains(&place) || (ending == Some("tex") && is_of(&READ)),
    }
}

/// Whether pages are renewed.
fn renews() -> bool {
    env::var_os("CRANKSTAR_RENEW").is_some()
}

/// What belongs into a folder of `reports`, by name: compared with what stands there and with the digests, or both are renewed.
pub fn compare(folder: &Path, written: &BTreeMap<String, String>) {
    compare_endings(folder, written, &["md", "svg", "tex", "toml", "csv"]);
}

/// The same for a folder elsewhere, all of which stands there.
pub fn compare_all(folder: &Path, written: &BTreeMap<String, String>) {
    compare_kept(folder, written, &["md", "svg", "toml"]);
}

/// The same for what belongs there in other formats.
pub fn compare_formats(folder: &Path, written: &BTreeMap<String, String>) {
    compare_endings(folder, written, &["html", "typ", "txt"]);
}

/// Files with other endings than these are not looked at.
fn compare_endings(folder: &Path, written: &BTreeMap<String, String>, endings: &[&str]) {
    let below = folder.strip_prefix(reports()).expect("a folder of reports").to_string_lossy().replace('\\', "/");
    let place = |name: &str| if below.is_empty() { name.to_owned() } else { format!("{below}/{name}") };
    if let Some(all) = env::var_os("CRANKSTAR_PAGES") {
        for (name, text) in written {
            let path = PathBuf::from(&all).join(place(name));
            fs::create_dir_all(path.parent().expect("a folder")).expect("the folder");
            fs::write(path, text).expect("a file");
        }
    }
    let (kept, others): (BTreeMap<_, _>, BTreeMap<_, _>) =
        written.iter().map(|(name, text)| (name.clone(), text)).partition(|(name, _)| is_kept(&place(name)));
    let kept = kept.into_iter().map(|(name, text)| (name, linked(&below, text))).collect();
    compare_kept(folder, &kept, endings);
    let others = others.into_iter().map(|(name, text)| (place(&name), format!("{:016x}", digest(text)))).collect();
    compare_digests(&below, &others, endings);
}

fn compare_kept(folder: &Path, kept: &BTreeMap<String, String>, endings: &[&str]) {
    let there = stored(folder, endings);
    if renews() {
        for name in there.keys().filter(|name| !kept.contains_key(*name)) {
            fs::remove_file(folder.join(name)).expect("a stale file");
        }
        if !kept.is_empty() {
            fs::create_dir_all(folder).expect("the folder");
        }
        // What is read by other tests at this moment is not touched.
        for (name, text) in kept.iter().filter(|(name, text)| there.get(*name) != Some(text)) {
            fs::write(folder.join(name), text).expect("a file");
        }
        // Where nothing is kept no folder is; one that holds something stays.
        let _ = fs::remove_dir(folder);
    }
    let stored = stored(folder, endings);
    let names = |files: &BTreeMap<String, String>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&stored), names(kept), "files of {}", folder.display());
    for (name, text) in kept {
        let first = stored[name].lines().zip(text.lines()).position(|(old, new)| old != new);
        assert!(&stored[name] == text, "{}/{name} differs, first in line {:?}", folder.display(), first.map(|n| n + 1));
    }
}

/// The files of a folder with one of these endings, by name.
fn stored(folder: &Path, endings: &[&str]) -> BTreeMap<String, String> {
    let Ok(entries) = fs::read_dir(folder) else { return BTreeMap::new() };
    let paths = entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_file());
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    let files = paths.filter(|path| ends_so(&name(path), endings));
    files.map(|path| (name(&path), fs::read_to_string(&path).expect("a text"))).collect()
}

fn ends_so(name: &str, endings: &[&str]) -> bool {
    name != DIGESTS && name.rsplit_once('.').is_some_and(|(_, ending)| endings.contains(&ending))
}

/// A page without links to pages that do not stand there: only their words are left.
pub fn linked(below: &str, text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(end) = rest.find("](") {
        let (before, behind) = rest.split_at(end);
        let target = behind[2..].split(')').next().unwrap_or_default();
        let is_page = target.ends_with("report.md") || target.ends_with(".html");
        let is_missing = is_page && !target.contains("://") && !is_kept(&joined(below, target));
        match before.rfind('[').filter(|_| is_missing) {
            Some(start) => {
                out += &before[..start];
                out += &before[start + 1..];
                rest = &behind[2 + target.len() + 1..];
            }
            None => {
                out += before;
                out += "](";
                rest = &behind[2..];
            }
        }
    }
    out + rest
}

/// Where a link from a folder leads.
fn joined(below: &str, target: &str) -> String {
    let mut parts: Vec<&str> = below.split('/').filter(|part| !part.is_empty()).collect();
    for part in target.split('/') {
        if part == ".." {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    parts.join("/")
}

/// The file of the digests: lines of a digest and a place.
const DIGESTS: &str = "digests.txt";

/// Compares digests of what belongs into a folder, or renews them.
fn compare_digests(below: &str, wanted: &BTreeMap<String, String>, endings: &[&str]) {
    let is_own = |place: &str| {
        let (folder, name) = place.rsplit_once('/').unwrap_or(("", place));
        folder == below && ends_so(name, endings)
    };
    let mut file = File::options().read(true).write(renews()).open(reports().join(DIGESTS)).expect("the digests");
    // Tests renew their parts of it at once.
    if renews() { file.lock() } else { file.lock_shared() }.expect("a lock");
    let mut text = String::new();
    file.read_to_string(&mut text).expect("text");
    let lines = text.lines().filter_map(|line| line.split_once(' '));
    let mut all: BTreeMap<String, String> = lines.map(|(digest, place)| (place.into(), digest.into())).collect();
    if renews() {
        all.retain(|place, _| !is_own(place));
        all.extend(wanted.clone());
        let lines: String = all.iter().map(|(place, digest)| format!("{digest} {place}\n")).collect();
        file.rewind().and_then(|()| file.set_len(0)).and_then(|()| file.write_all(lines.as_bytes())).expect("written");
    }
    all.retain(|place, _| is_own(place));
    let differ: Vec<&String> =
        wanted.iter().filter(|(place, digest)| all.get(*place) != Some(digest)).map(|(p, _)| p).collect();
    assert!(differ.is_empty(), "{differ:?} are not what reports/{DIGESTS} says; CRANKSTAR_PAGES=FOLDER writes them");
    let gone: Vec<&String> = all.keys().filter(|place| !wanted.contains_key(*place)).collect();
    assert!(gone.is_empty(), "reports/{DIGESTS} tells of {gone:?}, which are not written");
}

/// FNV-1a of 64 bits: whoever means to change a page unseen is not what it is for.
fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn digests_are_those_of_fnv_1a() {
    assert_eq!(digest(""), 0xcbf2_9ce4_8422_2325);
    assert_eq!(digest("foobar"), 0x8594_4171_f739_67e8);
}

#[test]
fn a_link_to_a_page_that_is_not_kept_leaves_its_words() {
    let text =
        "| [I1](../I1/report.md) | [I4](../I4/report.md) ![a](x.svg) [b](c) [atlas](atlas.html) [d](http://e.f/g.html)";
    let wanted = "| I1 | [I4](../I4/report.md) ![a](x.svg) [b](c) atlas [d](http://e.f/g.html)";
    assert_eq!(linked("atlas", text), wanted);
}
