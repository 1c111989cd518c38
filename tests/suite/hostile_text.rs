//! Is a person's text only ever shown, in every field, by every command, in every format?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crankstar::page::{Format, Options};

use crate::support::program::{call, scratch};
use crate::support::rooms;

/// What does harm somewhere: to a terminal, Markdown, HTML, LaTeX, Typst, a spreadsheet.
const HARM: &str = "=cmd()|x \u{1b}[31m\u{7}\u{9b}31m\u{202e}\u{2066}\u{200b}\u{7f} | `a` ```` $`b`$ $\\input{/etc/hostname}$ \
    <script>alert(1)</script> <!-- [x](javascript:alert(1)) ![y](z) % # & _ ^ ~ {} {{ title }} {% if %} << title >> \"q\" 'r' \
    \n# heading\n\n- item\r\n| a | b |\n\\\\[2em] \\end{document} ]]> @all **b** #panic(1) // /*  \u{feff}end";

/// A TOML string.
fn quoted(text: &str) -> String {
    let letters = text.chars().map(|letter| match letter {
        '"' | '\\' => format!("\\{letter}"),
        letter if letter == ' ' || letter.is_ascii_graphic() => letter.to_string(),
        letter => format!("\\U{:08X}", u32::from(letter)),
    });
    format!("\"{}\"", letters.collect::<String>())
}

/// Harm with a word by which it is found again.
fn harm(word: &str) -> String {
    quoted(&format!("{HARM}{word}"))
}

/// A layout file with harm in every text it may hold, and all numbers.
fn layout_text() -> String {
    let texts = ["number", "revision", "project", "author", "checked", "date", "objective"];
    let block: String = texts.map(|key| format!("{key} = {}\n", harm(&format!("of-{key}")))).concat();
    format!(
        "title = {}\nsource = {}\nspeed = \"3000 rpm\"\ncycle = \"four-stroke\"\nfiring_order = \"1-3-2\"\nbearings = [0.15, 0.05, -0.05, -0.15]\n\
         effects = [\"torque\", \"remedy\"]\n[document]\n{block}assumptions = [{}, \"[one] of [two]\", \"* = 1\"]\n\
         [inline]\nthrows = [0, 240, 120]\npositions = [\"100 mm\", 0, \"-100 mm\"]\n\
         [mechanism]\nsource = {}\nreciprocating_mass = \"0.5 kg\"\ncrank_radius = \" 45  mm \"\nrod_length = \"150 mm\"\n\
         [crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = 0.06\npin_mass = 0.4\nweb_mass = 2\nweb_radius = 0.01\n",
        harm("of-title"),
        harm("of-source"),
        harm("of-assumption"),
        harm("of-mechanism-source"),
    )
}

/// Characters that a terminal or an editor obeys.
fn acts(letter: char) -> bool {
    letter.is_control() && letter != '\n' && letter != '\t'
        || ['\u{202e}', '\u{2066}', '\u{200b}', '\u{feff}', '\u{2028}'].contains(&letter)
}

fn nothing_acts(what: &str, text: &str) {
    let found = text.char_indices().find(|(_, letter)| acts(*letter));
    assert_eq!(found.map(|(at, letter)| (letter, text[..at].lines().last())), None, "{what}");
}

/// Markdown without its fenced blocks, in which nothing is markup; the fences have to be in pairs.
fn without_fences(what: &str, text: &str) -> String {
    let mut fence: Option<&str> = None;
    let mut rest = String::new();
    for line in text.lines() {
        let ticks = &line[..line.len() - line.trim_start_matches('`').len()];
        match fence {
            None if ticks.len() >= 3 => fence = Some(ticks),
            Some(open) if line == open => fence = None,
            Some(_) => {}
            None => rest += &format!("{line}\n"),
        }
    }
    assert_eq!(fence, None, "{what}: a fence is open at the end");
    rest
}

/// Whether a piece stands in the text without a backslash before it.
fn bare(text: &str, piece: &str) -> bool {
    text.match_indices(piece).any(|(at, _)| {
        let backslashes = text[..at].len() - text[..at].trim_end_matches('\\').len();
        backslashes.is_multiple_of(2)
    })
}

fn markdown_is_whole(what: &str, text: &str) {
    let text = without_fences(what, text);
    for piece in ["<script", "<!--", "[x]", "![y]", "# heading\n", "$\\input", "\n- item", "`a`", "$`b`$", "**b**"] {
        assert!(!bare(&text, piece), "{what}: {piece} is markup");
    }
    let pipes = |line: &str| {
        let escaped = line.replace("\\\\", "").replace("\\|", "");
        escaped.matches('|').count()
    };
    let mut columns = None;
    for line in text.lines() {
        columns = line.starts_with('|').then(|| columns.unwrap_or(pipes(line)));
        assert!(columns.is_none_or(|columns| columns == pipes(line)), "{what}: a row of another width: {line}");
    }
}

fn latex_is_whole(what: &str, text: &str) {
    assert!(!text.contains("\\input") && !text.contains("<script") && !text.contains("\\\\[2em]"), "{what}");
    assert_eq!(text.matches("\\end{document}").count(), 1, "{what}");
    for line in text.lines() {
        let item = line.strip_prefix("\\item ").unwrap_or_default();
        assert!(!item.starts_with('['), "{what}: a label: {line}");
    }
}

fn html_is_whole(what: &str, text: &str) {
    for piece in ["<script>alert", "<!-- [x]", "<b>", "onerror=alert", "<h1>heading", "href=\"javascript"] {
        assert!(!text.contains(piece), "{what}: {piece} is markup");
    }
    assert_eq!(text.matches("<script").count(), text.matches("</script>").count(), "{what}");
    assert_eq!(text.matches("<table").count(), text.matches("</table>").count(), "{what}");
}

/// Typst without its strings, in which nothing is markup; the quotes have to be in pairs.
fn without_strings(what: &str, text: &str) -> String {
    let (mut rest, mut inside, mut letters) = (String::new(), false, text.chars());
    while let Some(letter) = letters.next() {
        match letter {
            '\\' if inside => drop(letters.next()),
            '\\' => rest.extend([letter].into_iter().chain(letters.next())),
            '"' => inside = !inside,
            _ if inside => {}
            _ => rest.push(letter),
        }
    }
    assert!(!inside, "{what}: a string is open at the end");
    rest
}

fn typst_is_whole(what: &str, text: &str) {
    let text = without_strings(what, text);
    for piece in ["#panic", "@all", "`a`", "$`b`$", "<script", "<!--", "**b**", "# heading", "//", "/*"] {
        assert!(!bare(&text, piece), "{what}: {piece} is markup");
    }
    // What is escaped no longer counts.
    let plain = text.replace("\\\\", "").replace("\\[", "").replace("\\]", "").replace("\\$", "");
    assert_eq!(plain.matches('[').count(), plain.matches(']').count(), "{what}");
    assert!(plain.matches('$').count().is_multiple_of(2), "{what}");
}

fn csv_is_inert(what: &str, text: &str) {
    for field in text.lines().flat_map(|line| line.split(',')) {
        let begin = field.trim_start_matches('"');
        let fraction = begin.strip_prefix('-').and_then(|number| number.split_once('/'));
        let whole = |digits: &str| digits.bytes().all(|byte| byte.is_ascii_digit());
        let number =
            begin.parse::<f64>().is_ok() || fraction.is_some_and(|(above, below)| whole(above) && whole(below));
        assert!(number || !begin.starts_with(['=', '+', '-', '@']), "{what}: {field} is a formula");
    }
}

fn file_is_harmless(path: &Path) {
    let (what, text) = (path.display().to_string(), fs::read_to_string(path).expect("a text"));
    nothing_acts(&what, &text);
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("md") => markdown_is_whole(&what, &text),
        Some("tex") => latex_is_whole(&what, &text),
        Some("html") => html_is_whole(&what, &text),
        Some("typ") => typst_is_whole(&what, &text),
        Some("txt") => {}
        Some("csv") => csv_is_inert(&what, &text),
        Some("svg") => {
            assert!(!text.contains("<script") && !text.contains("<!--"), "{what}");
            assert_eq!(text.matches('<').count(), text.matches('>').count(), "{what}");
        }
        Some("json") => drop(serde_json::from_str::<serde_json::Value>(&text).expect("JSON")),
        Some("toml") => drop(crankstar::file::parse_layout("again", &text).expect("a layout file")),
        other => panic!("{what}: no check for {other:?}"),
    }
}

/// Output and messages of a call; what stands on the terminal does nothing there.
fn answered(arguments: &[&str]) -> String {
    let output = call(arguments);
    let (out, error) = (String::from_utf8(output.stdout), String::from_utf8(output.stderr));
    let (out, error) = (out.expect("UTF-8"), error.expect("UTF-8"));
    nothing_acts(&format!("{arguments:?}, standard output"), &out);
    nothing_acts(&format!("{arguments:?}, standard error"), &error);
    assert!(output.status.success(), "{arguments:?}: {error}");
    out
}

/// The formats that the program names when it is asked for one that it does not have.
fn formats() -> Vec<String> {
    let output = call(&["report", "I4", "--format", "none"]);
    let error = String::from_utf8(output.stderr).expect("UTF-8");
    let (_, names) = error.split_once("[possible values: ").expect("a list");
    let (names, _) = names.split_once(']').expect("its end");
    names.split(", ").map(str::to_owned).collect()
}

fn hostile_layout(folder: &Path) -> PathBuf {
    let file = folder.join("=cmd|<script>`$\u{1b}[31m\u{202e}\n.toml");
    fs::write(&file, layout_text()).expect("a file");
    file
}

#[test]
fn no_text_of_a_layout_file_acts_in_the_output_of_any_command() {
    let folder = scratch("hostile-layout");
    let file = hostile_layout(&folder);
    let file = file.to_str().expect("UTF-8");
    let report = answered(&["report", file]);
    markdown_is_whole("report", &report);
    for word in ["title", "source", "number", "author", "objective", "assumption", "mechanism-source"] {
        assert!(report.contains(&format!("of-{word}")), "the text of {word} is not shown");
    }
    markdown_is_whole("report --math dollars", &answered(&["report", file, "--math", "dollars"]));
    latex_is_whole("report --format latex", &answered(&["report", file, "--format", "latex"]));
    markdown_is_whole("sweep", &answered(&["sweep", file, "--speed", "1000..3000:1000", "--format", "markdown"]));
    latex_is_whole("sweep", &answered(&["sweep", file, "--speed", "1000..3000:1000", "--format", "latex"]));
    html_is_whole("report --format html", &answered(&["report", file, "--format", "html"]));
    typst_is_whole("report --format typst", &answered(&["report", file, "--format", "typst"]));
    typst_is_whole("sweep", &answered(&["sweep", file, "--speed", "1000..3000:1000", "--format", "typst"]));
    html_is_whole("sweep", &answered(&["sweep", file, "--speed", "1000..3000:1000", "--format", "html"]));
    csv_is_inert("sweep", &answered(&["sweep", file, "--speed", "1000..3000:1000", "--format", "csv"]));
    for command in ["classify", "loads", "bearings", "compare I4", "sweep --speed=1000..3000:1000"] {
        let output = folder.join(format!("{}-data", command.split(' ').next().unwrap_or_default()));
        let output = output.to_str().expect("UTF-8");
        let arguments: Vec<&str> = command.split(' ').chain([file, "--format", "csv"]).collect();
        csv_is_inert(command, &answered(&arguments));
        answered(&arguments.iter().copied().chain(["--output", output]).collect::<Vec<_>>());
        let written = fs::read_dir(output).expect("a folder").map(|entry| entry.expect("an entry").path());
        let texts = written.map(|path| (file_is_harmless(&path), fs::read_to_string(&path).expect("a text")).1);
        let texts = texts.collect::<String>();
        assert!(!command.starts_with("compare") || texts.contains("'=cmd()|x"), "{command}: {texts}");
    }
    for command in [
        "classify",
        "loads",
        "bearings",
        "remedy",
        "compare I4",
        "accuracy",
        "classify --torque",
        "moments",
        "angle --at 30",
        "sweep --speed=1000..3000:1000",
    ] {
        let arguments: Vec<&str> = command.split(' ').chain([file]).collect();
        assert!(answered(&arguments).contains("of-title"), "{command}");
    }
    for command in ["classify", "loads", "bearings", "remedy", "compare I4", "classify --all-orders", "sweep"] {
        let mut arguments: Vec<&str> = command.split(' ').chain([file]).collect();
        arguments.extend(if command == "sweep" {
            ["--speed=1000..3000:1000", "--format=json"]
        } else {
            ["--json", "--orders=1"]
        });
        serde_json::from_str::<serde_json::Value>(&answered(&arguments)).expect("JSON");
    }
    for command in [
        "report",
        "bearings",
        "remedy",
        "compare I4",
        "accuracy",
        "moments",
        "angle",
        "sweep --speed=1000..3000:1000",
        "optimise",
    ] {
        let output = folder.join(command.split(' ').next().unwrap_or_default());
        let mut arguments: Vec<&str> =
            command.split(' ').chain([file, "--output", output.to_str().expect("UTF-8")]).collect();
        if command == "optimise" {
            if !cfg!(feature = "optimise") {
                continue;
            }
            arguments.extend(["--points", "2"]);
        }
        // A page is written in every format; what takes long in one is enough.
        for format in formats() {
            let chosen = ["--format", &format];
            if format == "markdown" || !["accuracy", "optimise"].contains(&command) {
                answered(&arguments.iter().copied().chain(chosen).collect::<Vec<_>>());
            }
        }
        let written = fs::read_dir(&output).expect("a folder").map(|entry| entry.expect("an entry").path());
        written.for_each(|path| file_is_harmless(&path));
    }
}

#[test]
fn no_text_of_a_file_of_masses_acts() {
    let folder = scratch("hostile-masses");
    let file = folder.join("shaft.toml");
    let shaft = include_str!("../../examples/shaft.toml");
    let shaft = shaft.replace("\"Four masses and two planes\"", &harm("of-title"));
    fs::write(&file, shaft.replace("\"A\"", &harm("of-name"))).expect("a file");
    let file = file.to_str().expect("UTF-8");
    let page = answered(&["rotor", file, "--format", "markdown"]);
    markdown_is_whole("rotor", &page);
    assert!(page.contains("of-title") && page.contains("of-name"), "{page}");
    latex_is_whole("rotor", &answered(&["rotor", file, "--format", "latex"]));
    html_is_whole("rotor", &answered(&["rotor", file, "--format", "html"]));
    typst_is_whole("rotor", &answered(&["rotor", file, "--format", "typst"]));
    csv_is_inert("rotor", &answered(&["rotor", file, "--format", "csv"]));
}

#[test]
fn no_text_of_a_turning_moment_diagram_acts() {
    let file = scratch("hostile-diagram").join("diagram.toml");
    let diagram = include_str!("../../examples/turning-moment.toml");
    fs::write(&file, diagram.replace("\"Four strokes as triangles\"", &harm("of-title"))).expect("a file");
    let file = file.to_str().expect("UTF-8");
    let page = answered(&["flywheel", file, "--format", "markdown"]);
    markdown_is_whole("flywheel", &page);
    assert!(page.contains("of-title"), "{page}");
    latex_is_whole("flywheel", &answered(&["flywheel", file, "--format", "latex"]));
    html_is_whole("flywheel", &answered(&["flywheel", file, "--format", "html"]));
    typst_is_whole("flywheel", &answered(&["flywheel", file, "--format", "typst"]));
    csv_is_inert("flywheel", &answered(&["flywheel", file, "--format", "csv"]));
}

#[test]
fn no_text_of_a_claims_file_acts() {
    let folder = scratch("hostile-claims");
    fs::write(folder.join("i3.toml"), layout_text()).expect("a file");
    let says = quoted("first-order force vanishes");
    let text = format!(
        "title = {}\n[[claim]]\nlayout = \"i3.toml\"\nsays = {says}\nsource = {}\nplace = {}\nwords = {}\n\
         [[statement]]\ntext = {}\nsource = {}\nconclusion = {}\n[[statement.claim]]\nlayout = \"i3.toml\"\nsays = {says}\nsource = {}\n\
         [[table]]\nlayout = \"i3.toml\"\norder = 1\nsums = {{ force_direct = \" 0 \" }}\n",
        harm("of-title"),
        harm("of-claim-source"),
        harm("of-place"),
        harm("of-words"),
        harm("of-text"),
        harm("of-statement-source"),
        harm("of-conclusion"),
        harm("of-inner-source"),
    );
    let file = folder.join("claims.toml");
    fs::write(&file, &text).expect("a file");
    assert!(answered(&["check", file.to_str().expect("UTF-8")]).contains("true"));
    let find = |_: &str| crankstar::file::parse("i3.toml", &layout_text()).map_err(|error| error.to_string());
    let claims = crankstar::claim::parse_claims("<script>.toml", &text, &find).expect("it reads");
    let page = crankstar::report::claims_page(&claims);
    let page = crankstar::page::write(&page, Format::GITHUB, &Options::default()).remove(0);
    nothing_acts("the page of claims", &page.text);
    // What the page folds away is markup of its own.
    markdown_is_whole("the page of claims", &page.text);
    for word in ["title", "text", "statement-source", "claim-source", "conclusion", "place", "words"] {
        assert!(page.text.contains(&format!("of-{word}")), "the text of {word} is not shown");
    }
}

/// Names of students, what they write, and what their files are called.
#[test]
fn no_text_of_a_class_acts() {
    let folder = scratch("hostile-class");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    // Its lines are names of their own; one that is read wrongly is named by its file.
    fs::write(folder.join("class.txt"), format!("{HARM}of-name\nBob\nCarl\n")).expect("a file");
    for format in formats() {
        let out = format!("out-{format}");
        answered(&[
            "exercise",
            "V2-90",
            "--students",
            &path("class.txt"),
            "--format",
            &format,
            "--output",
            &path(&out),
        ]);
        let handed_in = folder.join(format!("in-{format}"));
        fs::create_dir_all(&handed_in).expect("a folder");
        let table = |whose: &str| {
            format!(
                "{whose}\n[[table]]\norder = 1\nrows = [{{ cylinder = 1, direct = {}, reverse = \"<b>\" }}]\nsums = {{ force_direct = {} }}\n",
                quoted("`a` | <script>alert(1)</script>"),
                harm("of-entry")
            )
        };
        fs::write(handed_in.join("bob.toml"), table("student = 'Bob'")).expect("a file");
        fs::write(handed_in.join("carl.toml"), format!("student = 'Carl'\n[convention]\nsense = {}", harm("of-sense")))
            .expect("a file");
        fs::write(handed_in.join("<b>`x` | y.toml"), table(&format!("student = {}", harm("of-student"))))
            .expect("a file");
        let key = path(&format!("{out}/exercise.toml"));
        let marks = path(&format!("marks-{format}"));
        let arguments =
            ["mark", handed_in.to_str().expect("UTF-8"), "--exercise", &key, "--format", &format, "--output", &marks];
        let told = answered(&arguments);
        for word in ["of-name", "of-sense", "of-student"] {
            assert!(told.contains(word), "{word} is not shown:\n{told}");
        }
        csv_is_inert("the marks", &fs::read_to_string(Path::new(&marks).join("marks.csv")).expect("a table"));
        for file in source_files(&folder.join(&out)).into_iter().chain(source_files(Path::new(&marks))) {
            match file.extension().is_some_and(|ending| ending == "toml") {
                // An exercise, or a table to fill in.
                true => nothing_acts(&file.display().to_string(), &fs::read_to_string(&file).expect("a text")),
                false => file_is_harmless(&file),
            }
        }
    }
}

/// Every value and every key of the file in turn is harm: the message that repeats it does nothing.
#[test]
fn no_message_acts_whatever_is_wrong_in_the_file() {
    let folder = scratch("hostile-messages");
    let file = folder.join("wrong.toml");
    let whole = layout_text();
    let mut refused = 0;
    for (index, line) in whole.lines().enumerate() {
        let Some((key, _)) = line.split_once(" = ") else { continue };
        for wrong in [
            format!("{key} = {}", harm("x")),
            format!("{} = 1", harm("x")),
            format!("{line} # \u{9b}31m\u{202e}\u{1b}[31m"),
        ] {
            let lines: Vec<&str> =
                whole.lines().enumerate().map(|(at, line)| if at == index { &*wrong } else { line }).collect();
            fs::write(&file, lines.join("\n")).expect("a file");
            let output = call(&["classify", file.to_str().expect("UTF-8")]);
            nothing_acts(&wrong, &String::from_utf8(output.stderr).expect("UTF-8"));
            nothing_acts(&wrong, &String::from_utf8(output.stdout).expect("UTF-8"));
            refused += usize::from(output.status.code() == Some(1));
        }
    }
    assert!(refused > 40, "only {refused} files were refused");
}

#[test]
fn no_message_acts_whatever_the_arguments_are() {
    for arguments in [
        vec!["classify", HARM],
        vec!["compare", HARM, "I4"],
        vec!["check", HARM],
        vec!["verify", HARM],
        vec!["classify", "I4", "--orders", HARM],
        vec![HARM],
        vec!["sweep", "I4", "--set", HARM],
        vec!["sweep", "I4", "--set", "title=0..1:1"],
        vec!["sweep", "I4", "--set", "speed=0..1:1 <script>"],
        vec!["sweep", "I4", "--set", "mechanism.source=0..1:1"],
        vec!["search", "--cylinders", "4", "--cycle", "two-stroke", "--bank-angle", HARM],
        vec!["search", "--cylinders", "4", "--cycle", "two-stroke", "--resume", "/dev/null/\u{1b}[31m"],
        vec!["remedy", "I4", "--planes", HARM],
        vec!["remedy", "I4", "--balance-factor", HARM],
        vec!["report", "I4", "--output", "/dev/null/\u{1b}[31m/\u{202e}"],
    ] {
        let output = call(&arguments);
        assert!(!output.status.success(), "{arguments:?}");
        assert!(!output.stderr.is_empty() && output.stdout.is_empty(), "{arguments:?}");
        nothing_acts(&format!("{arguments:?}"), &String::from_utf8(output.stderr).expect("UTF-8"));
    }
}

fn source_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    entries.flat_map(|path| if path.is_dir() { source_files(&path) } else { vec![path] }).collect()
}

/// `file: field` of each line of the source that fits.
fn found_in_source(fits: impl Fn(&str) -> Option<String>) -> BTreeSet<String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = BTreeSet::new();
    for path in source_files(&source).into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs")) {
        let name = rooms::path_in_crate(&path).display().to_string();
        let text = fs::read_to_string(&path).expect("a text");
        found.extend(text.lines().filter_map(&fits).map(|what| format!("{name}: {what}")));
    }
    found
}

fn set(lines: &[&str]) -> BTreeSet<String> {
    lines.iter().map(|line| (*line).to_owned()).collect()
}

/// A new field of a person's text is to be given harm in this file, and then listed here.
#[test]
fn every_field_of_a_persons_text_is_tried_here() {
    let field = |line: &str| {
        let (name, kind) = line.trim().strip_prefix("pub ")?.split_once(": ")?;
        (kind.contains("Untrusted") && !name.contains('(')).then(|| name.to_owned())
    };
    #[rustfmt::skip]
    let known = set(&[
        "engine/draft.rs: title", "engine/draft.rs: source", "engine/draft.rs: file",
        "engine/dimensions.rs: source", "engine/dimensions.rs: written",
        "engine/title_block.rs: rows", "engine/title_block.rs: objective", "engine/title_block.rs: assumptions",
        "claim/file.rs: title", "claim/file.rs: text", "claim/file.rs: source", "claim/file.rs: conclusion",
        "claim/file.rs: engine", "claim/file.rs: says", "claim/student.rs: engine",
        "claim/provenance.rs: source", "claim/provenance.rs: place", "claim/provenance.rs: words",
        "claim/handwritten.rs: text", "claim/star_marks.rs: written",
        "classroom/students.rs: name", "classroom/exercise.rs: name", "classroom/results.rs: files", "classroom/marking.rs: not_read",
        "report/values.rs: rows", "sweep/record.rs: title", "report/compare/mod.rs: name", "report/atlas/entry.rs: title", "report/moments/mod.rs: name",
        "file/diagram_keys.rs: title", "file/rotor_keys.rs: title", "file/rotor_keys.rs: name",
    ]);
    assert_eq!(found_in_source(field), known);
}

/// The text as it was written leaves its type only for JSON, for a file of the same kind, and for reading.
#[test]
fn a_persons_text_leaves_its_type_unescaped_in_few_places() {
    let file = |line: &str| line.contains(".written()").then(String::new);
    #[rustfmt::skip]
    let known = set(&[
        // JSON
        "report/document.rs: ", "report/family_page/document.rs: ", "report/loads_document.rs: ", "report/catalogue/document.rs: ",
        "report/remedy/document.rs: ", "report/optimise/data.rs: ",
        "report/compare/document.rs: ", "report/firing/document.rs: ", "table/json.rs: ",
        // a layout file that is written again, and one that is shown line by line
        "optimise/file.rs: ", "remedy/file.rs: ", "report/optimise/layouts.rs: ", "page/write/compose.rs: ",
        // a title of the catalogue, by which its translation is found
        "page/language/mod.rs: ",
        // a key that is compared, escaped
        "table/named.rs: ",
        // a person's words in a drawing, escaped there
        "page/svg.rs: ",
        // one text of a person before another
        "cli/moments.rs: ",
        // a claim that is read
        "claim/file.rs: ",
        // a value of Python, which obeys no text
        "python/columns.rs: ", "python/engine.rs: ",
        // a student's name in the file of an exercise, and in the table that is filled in
        "classroom/exercise.rs: ", "classroom/fill_in.rs: ",
    ]);
    assert_eq!(found_in_source(file), known);
}
