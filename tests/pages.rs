//! Do the reports look right where they are read: in LaTeX, in Typst, on a Markdown page, in a browser?
//!
//! `pages/completions.rs` asks it of the shells.
//!
//! These tests need pdflatex, Typst for Python, pdftotext, pandoc 3, node with KaTeX and playwright-core, and Chromium: `.ci/run` installs them and runs
//! `cargo test --test pages -- --ignored`.

#![allow(clippy::disallowed_types)]

#[path = "suite/studies/catalogue.rs"]
mod catalogue;
#[path = "pages/completions.rs"]
mod completions;
#[path = "pages/moving.rs"]
mod moving;

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crankstar::claim::parse_claims;
use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::page::{self, Alone, Document, Format, Language, Math, Options, Symbols};
use crankstar::proof::Quantity;
use crankstar::report::{self, Compared, Contents};
use crankstar::text::Untrusted;
use crankstar::verdict::Judgement;
use serde_json::Value;

/// A fresh folder with a page in it.
fn write_page(name: &str, document: &Document, format: Format) -> PathBuf {
    // Tests run beside each other: each has folders of its own.
    let test = std::thread::current().name().unwrap_or("pages").to_owned();
    let folder =
        Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{test}-{format:?}").replace(['(', ')'], "-")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    for file in page::write(document, format, &Options::default()) {
        fs::write(folder.join(file.name), file.text).expect("a file");
    }
    folder
}

fn report_of(engine: &Engine) -> Document {
    let judged = Judgement::new(engine, engine.orders(), &Quantity::PLANAR).expect("orders");
    report::engine_page(Contents {
        engine,
        judged: &judged,
        family: None,
        needed: None,
        in_motion: false,
        accuracy: None,
        weighing: report::Weighing::usual(),
    })
}

/// Layouts that strain the page: masses, long fractions, many cylinders, odd angles, a title full of special characters.
const STRANGE: [(&str, &str); 7] = [
    ("masses", include_str!("pages/masses.toml")),
    ("radial", include_str!("pages/radial.toml")),
    ("w12", include_str!("pages/w12.toml")),
    ("v20", include_str!("pages/v20.toml")),
    ("v6-37-3", include_str!("pages/v6-37-3.toml")),
    ("unequal-rods", include_str!("pages/unequal-rods.toml")),
    ("two-open-angles", include_str!("pages/two-open-angles.toml")),
];

/// The reports on the catalogue and on layouts from outside it.
fn reports() -> Vec<(String, Document)> {
    let catalogue = file::catalogue().expect("the catalogue reads").into_iter();
    let catalogue = catalogue.map(|(entry, engine)| (entry.name.to_owned(), report_of(&engine)));
    let strange = STRANGE.map(|(name, text)| {
        let page = match file::parse_layout(name, text).expect("it reads") {
            Layout::Known(engine, _) => report_of(&engine),
            Layout::Open(open) => {
                report::family_page(&open, &family::classify(&open, open.orders()).expect("orders"), false)
            }
        };
        (format!("strange-{name}"), page)
    });
    catalogue.chain(strange).collect()
}

/// The stored reports on families and on examples with numbers, each in a folder of its own.
fn families() -> Vec<PathBuf> {
    let reports = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    let folders = ["families", "examples"].map(|below| fs::read_dir(reports.join(below)).expect("folders"));
    folders.into_iter().flatten().map(|entry| entry.expect("an entry").path()).collect()
}

/// The stored atlas: its table is as wide as a page can be.
fn atlas() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/atlas")
}

/// A comparison of engines in line, in V and round.
fn comparison() -> Document {
    let orders = [1, 2, 4];
    let catalogue = file::catalogue().expect("the catalogue reads");
    let few =
        catalogue.iter().filter(|(entry, _)| ["I5", "V6", "ra"].iter().any(|begin| entry.name.starts_with(begin)));
    let compared: Vec<Compared> = few
        .map(|(entry, layout)| Compared::new(Untrusted::new(entry.name), layout, &orders).expect("orders"))
        .collect();
    report::compare_page(&compared)
}

/// The stored claims, answered.
fn claims() -> Document {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/claims");
    let text = fs::read_to_string(folder.join("claims.toml")).expect("the claims");
    let find = |name: &str| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => {
            let text = fs::read_to_string(folder.join(name)).map_err(|error| error.to_string())?;
            file::parse(name, &text).map_err(|error| error.to_string())
        }
    };
    report::claims_page(&parse_claims("claims.toml", &text, &find).unwrap_or_else(|error| panic!("{error}")))
}

/// The pages that are about several engines.
fn wide_pages() -> [(&'static str, Document); 3] {
    let index = catalogue::page(&file::catalogue().expect("the catalogue reads"));
    [("comparison", comparison()), ("claims", claims()), ("catalogue", index)]
        .map(|(name, page)| (name, Document { name: "report", ..page }))
}

/// The number of drawings beside a page.
fn drawings(folder: &Path) -> usize {
    let names = fs::read_dir(folder).expect("the folder").map(|file| file.expect("a file").file_name());
    names.filter(|name| name.to_string_lossy().ends_with(".svg")).count()
}

/// How LaTeX asks for another run; the log names a package by a like word, too.
const ASKS_FOR_ANOTHER_RUN: [&str; 2] = ["Rerun LaTeX", "Rerun to get"];

/// Compiles a report until LaTeX asks for no other run, and looks for complaints in the log.
fn compile(name: &str, folder: &Path) {
    let mut log = String::new();
    for attempt in 0..4 {
        // The first run finds where things are, and needs no page for it.
        let draft = (attempt == 0).then_some("-draftmode");
        let arguments = ["-interaction=nonstopmode", "-halt-on-error", "report.tex"];
        run(folder, "pdflatex", &draft.into_iter().chain(arguments).collect::<Vec<_>>(), "");
        log = String::from_utf8_lossy(&fs::read(folder.join("report.log")).expect("a log")).into_owned();
        if attempt > 0 && !ASKS_FOR_ANOTHER_RUN.iter().any(|asks| log.contains(asks)) {
            break;
        }
    }
    let complaints = ["Overfull", "Missing character", "undefined", "LaTeX Font Warning"];
    for complaint in complaints.into_iter().chain(ASKS_FOR_ANOTHER_RUN) {
        assert!(!log.contains(complaint), "{name}: {complaint} in {}/report.log", folder.display());
    }
}

/// Runs a tool in a folder; standard input and output are text.
fn run(folder: &Path, program: &str, arguments: &[&str], input: &str) -> String {
    let mut child = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap_or_else(|error| panic!("{program}: {error}; .ci/run installs it"));
    child.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("the tool reads");
    let output = child.wait_with_output().expect("the tool ends");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{program} in {}:\n{text}\n{errors}", folder.display());
    text
}

#[test]
#[ignore = "needs pdflatex"]
fn every_report_compiles_without_errors_missing_references_or_overfull_lines() {
    for (name, page) in reports() {
        compile(&name, &write_page(&name, &page, Format::Latex));
    }
}

#[test]
#[ignore = "needs pdflatex"]
fn every_stored_page_compiles_without_errors_missing_references_or_overfull_lines() {
    for family in families() {
        let name = family.file_name().expect("a name").to_string_lossy().into_owned();
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-families").join(&name);
        fs::create_dir_all(&folder).expect("a folder");
        let (layout, output) = (family.join("layout.toml"), folder.to_str().expect("UTF-8"));
        let arguments = ["report", layout.to_str().expect("UTF-8"), "--format", "latex", "--output", output];
        run(&folder, env!("CARGO_BIN_EXE_crankstar"), &arguments, "");
        compile(&name, &folder);
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-atlas");
    fs::create_dir_all(&folder).expect("a folder");
    fs::copy(atlas().join("atlas.tex"), folder.join("report.tex")).expect("the atlas");
    compile("atlas", &folder);
}

/// The notation of another book.
const NOTATION: &str = r#"
[symbols]
alpha = "\\gamma_{b}"
beta = "\\hat\\chi"
gamma = "\\tau"
lambda = "\\mu"
theta = "\\vartheta"
phi = "\\Phi"
psi = "\\xi"
omega = "\\Omega"
c_k = "b_k"
P_k = "\\Pi_k"
F_k = "\\mathbf{Q}'_k"
Q_k = "D_k"
"#;

fn in_another_notation() -> Options {
    Options { symbols: Symbols::read("symbols.toml", NOTATION).expect("it reads"), ..Options::default() }
}

#[test]
#[ignore = "needs pdflatex"]
fn fragments_compile_inside_one_document_in_another_notation_too() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-fragments");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let mut host = include_str!("pages/host.tex").to_owned();
    for (name, page) in reports().into_iter().filter(|(name, _)| name.starts_with("strange") || name.starts_with("V8"))
    {
        let options = Options { fragment: true, label: Some(name.clone()), ..in_another_notation() };
        for file in page::write(&page, Format::Latex, &options) {
            fs::write(folder.join(format!("{name}.tex")), file.text).expect("a file");
        }
        host.push_str(&format!("\\input{{{name}}}\n"));
    }
    fs::write(folder.join("report.tex"), host + "\\end{document}\n").expect("a file");
    compile("fragments", &folder);
}

#[test]
#[ignore = "needs pdflatex"]
fn a_drawing_of_its_own_fits_its_paper() {
    let (_, page) = reports().remove(0);
    for (index, picture) in page.pictures().into_iter().enumerate() {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("pages-alone-{index}"));
        fs::create_dir_all(&folder).expect("a folder");
        let text = Alone::TikzDocument.write(picture, &in_another_notation());
        fs::write(folder.join("report.tex"), text).expect("a file");
        compile(&picture.name, &folder);
        let log = fs::read_to_string(folder.join("report.log")).expect("a log");
        assert!(log.contains("(1 page"), "{}", picture.name);
    }
}

#[test]
#[ignore = "needs pdflatex"]
fn pages_of_several_engines_compile_and_the_poster_fits_its_sheet() {
    for (name, page) in wide_pages() {
        compile(name, &write_page(name, &page, Format::Latex));
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-poster");
    fs::create_dir_all(&folder).expect("a folder");
    let poster = report::poster(&file::catalogue().expect("the catalogue reads"), Language::De);
    fs::write(folder.join("report.tex"), &poster[1].text).expect("the poster");
    compile("poster", &folder);
    let log = String::from_utf8_lossy(&fs::read(folder.join("report.log")).expect("a log")).into_owned();
    assert!(log.contains("report.pdf (1 page"), "{}", folder.display());
}

/// Where the text of a page begins and ends, in the points of PDF; a comma hangs a little into the margin.
const TEXT: std::ops::RangeInclusive<u32> = 60..=536;

/// Compiles a report in Typst without a warning, and looks for words in the margins.
fn typeset(name: &str, folder: &Path) {
    let script = "import typst; _, warnings = typst.compile_with_warnings('report.typ', output='report.pdf'); \
                  print(*(warning.message for warning in warnings), sep='\\n', end='')";
    let warnings = run(folder, "python3", &["-c", script], "");
    assert_eq!(warnings, "", "{name}: {}/report.typ", folder.display());
    let words = run(folder, "pdftotext", &["-bbox", "report.pdf", "-"], "");
    for line in words.lines().filter(|line| line.contains("<word")) {
        let place = |name: &str| -> u32 {
            let (_, rest) = line.split_once(&format!("{name}=\"")).expect("a place");
            rest.split('.').next().and_then(|points| points.parse().ok()).expect("a number")
        };
        let fits = TEXT.contains(&place("xMin")) && TEXT.contains(&place("xMax"));
        assert!(fits, "{name}: {line} is in the margin of {}/report.pdf", folder.display());
    }
}

#[test]
#[ignore = "needs Typst for Python and pdftotext"]
fn every_report_is_typeset_by_typst_without_warnings_inside_its_margins() {
    for (name, page) in reports() {
        typeset(&name, &write_page(&name, &page, Format::Typst));
    }
}

#[test]
#[ignore = "needs pdflatex"]
fn a_german_report_compiles_without_errors_missing_references_or_overfull_lines() {
    let layout = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/examples/v8-small-block/layout.toml");
    let engine = file::parse("layout.toml", &fs::read_to_string(layout).expect("a layout file")).expect("an engine");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-german");
    fs::create_dir_all(&folder).expect("a folder");
    let options = Options { language: Language::De, ..Options::default() };
    for file in page::write(&report_of(&engine), Format::Latex, &options) {
        fs::write(folder.join(file.name), file.text).expect("a file");
    }
    compile("german", &folder);
}

/// Every formula that pandoc finds in a document.
fn formulas(node: &Value, found: &mut Vec<String>) {
    match node {
        Value::Object(object) if object.get("t").is_some_and(|kind| kind == "Math") => {
            found.push(object["c"][1].as_str().expect("TeX").to_owned());
        }
        Value::Object(object) => object.values().for_each(|value| formulas(value, found)),
        Value::Array(array) => array.iter().for_each(|value| formulas(value, found)),
        _ => {}
    }
}

#[test]
#[ignore = "needs pandoc 3 and node with KaTeX"]
fn every_formula_is_found_by_pandoc_and_read_by_katex() {
    let forms = [(Math::Github, "gfm"), (Math::Dollars, "markdown")];
    let mut all = BTreeSet::new();
    for (name, page) in reports() {
        for (math, format) in forms {
            let folder = write_page(&name, &page, Format::Markdown(math));
            let text = fs::read_to_string(folder.join("report.md")).expect("a report");
            let json = run(&folder, "pandoc", &["-f", format, "-t", "json", "report.md"], "");
            let mut found = Vec::new();
            formulas(&serde_json::from_str(&json).expect("JSON"), &mut found);
            let written = match math {
                Math::Github => text.matches("$`").count() + text.matches("```math").count(),
                Math::Dollars => text.replace("$$", "$").replace("\\$", "").matches('$').count() / 2,
                other => panic!("how {other:?} marks formulas is not known here"),
            };
            assert_eq!(found.len(), written, "{name} as {format}");
            all.extend(found);
        }
    }
    let stored = families().into_iter().map(|folder| (folder, "report.md"));
    for (folder, page) in stored.chain([(atlas(), "README.md")]) {
        let json = run(&folder, "pandoc", &["-f", "gfm", "-t", "json", page], "");
        let mut found = Vec::new();
        formulas(&serde_json::from_str(&json).expect("JSON"), &mut found);
        all.extend(found);
    }
    for (_, page) in reports() {
        let text = page::write(&page, Format::Markdown(Math::Dollars), &in_another_notation()).remove(0).text;
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let json = run(folder, "pandoc", &["-f", "markdown", "-t", "json"], &text);
        let mut found = Vec::new();
        formulas(&serde_json::from_str(&json).expect("JSON"), &mut found);
        all.extend(found);
    }
    assert!(all.len() > 100);
    let list = serde_json::to_string(&all).expect("JSON");
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pages/katex.cjs");
    run(Path::new(env!("CARGO_TARGET_TMPDIR")), "node", &[script], &list);
}

/// What a browser is to look at: a file, and the title that its check gives it.
type Looked = (PathBuf, String);

/// A page with its check, for a browser: in this folder, which it writes to, with this many pictures.
fn to_look_at(folder: &Path, page: &str, pictures: usize) -> Looked {
    let body = run(folder, "pandoc", &["-f", "gfm", "-t", "html", "--mathml", page], "");
    let page = folder.join("page.html");
    fs::write(&page, include_str!("pages/check.html").replace("BODY", &body)).expect("a page");
    (page, format!("{pictures} pictures, 0 broken, fits"))
}

/// Looks at all pages in one browser.
fn look(pages: &[Looked]) {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pages/look.cjs");
    let list = serde_json::to_string(pages).expect("JSON");
    run(Path::new(env!("CARGO_TARGET_TMPDIR")), "node", &[script], &list);
}

#[test]
#[ignore = "needs pandoc 3, node with playwright-core, and Chromium"]
fn every_page_shows_its_pictures_and_fits_a_browser_window() {
    let mut pages = Vec::new();
    for (name, page) in reports() {
        let folder = write_page(&name, &page, Format::GITHUB);
        let pictures = fs::read_dir(&folder).expect("the folder").filter(|file| {
            let name = file.as_ref().expect("a file").file_name();
            name.to_string_lossy().ends_with(".svg")
        });
        pages.push(to_look_at(&folder, "report.md", pictures.count() + usize::from(!name.contains("open"))));
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages-atlas");
    fs::create_dir_all(&folder).expect("a folder");
    for file in fs::read_dir(atlas()).expect("the atlas") {
        let file = file.expect("a file");
        fs::copy(file.path(), folder.join(file.file_name())).expect("a copy");
    }
    pages.push(to_look_at(&folder, "README.md", drawings(&atlas())));
    look(&pages);
}

#[test]
#[ignore = "needs pandoc 3, node with playwright-core, and Chromium"]
fn pages_of_several_engines_show_their_pictures_and_fit_a_browser_window() {
    let pages = wide_pages().map(|(name, page)| {
        let folder = write_page(name, &page, Format::GITHUB);
        to_look_at(&folder, "report.md", drawings(&folder))
    });
    look(&pages);
}
