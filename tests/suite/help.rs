//! Does the help fit a terminal, do help, README and docs name every command and option, and do their links and examples hold?

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::console;

fn succeeds(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_crankstar")).args(arguments).output().expect("the program starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

/// The commands, as the completions know them.
fn commands() -> Vec<String> {
    let script = succeeds(&["completions", "fish"]);
    let offered = script.lines().filter(|line| line.contains("__fish_crankstar_needs_command"));
    let named = offered.filter_map(|line| line.split("-a \"").nth(1)?.split('"').next());
    let commands: Vec<String> = named.filter(|name| *name != "help").map(str::to_owned).collect();
    assert!(commands.len() > 10, "{commands:?}");
    commands
}

/// The options that the help of a command lists.
fn options(command: &str) -> Vec<String> {
    let help = succeeds(&[command, "-h"]);
    let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with("--"));
    lines.map(|line| first_word(line).to_owned()).collect()
}

fn first_word(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or_default()
}

fn text(file: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).expect("a text")
}

#[test]
fn no_line_of_help_is_longer_than_eighty_columns() {
    let commands = commands();
    let mut asked = vec![vec!["-h"], vec!["--help"]];
    asked.extend(commands.iter().flat_map(|name| [vec![name, "-h"], vec![name, "--help"]]));
    for arguments in asked {
        for line in succeeds(&arguments).lines() {
            assert!(line.chars().count() <= 80, "{arguments:?}: {line}");
        }
    }
}

#[test]
fn help_names_every_command_once_below_a_question() {
    let help = succeeds(&["--help"]);
    let below = help.find("Which engine?").expect("a question");
    let list: Vec<&str> = help[below..].lines().take_while(|line| !line.starts_with("Options")).collect();
    let named: Vec<&str> = list.iter().filter(|line| line.starts_with("  ")).map(|line| first_word(line)).collect();
    for command in commands() {
        assert_eq!(named.iter().filter(|name| **name == command).count(), 1, "{command} in\n{help}");
    }
    assert_eq!(named.len(), commands().len(), "{help}");
}

#[test]
fn help_says_what_each_command_does_and_nothing_of_its_arguments() {
    let help = succeeds(&["--help"]);
    for command in commands() {
        let line = help.lines().find(|line| first_word(line) == command).unwrap_or_default();
        let about = line.trim_start().strip_prefix(&command).unwrap_or_default().trim();
        assert!(about.len() > 10 && !about.contains("Arguments"), "{line}");
    }
}

/// Fish takes the help of a value in double quotes, and PowerShell takes printers' quotes for quotes.
#[test]
fn no_help_in_completions_holds_what_a_shell_would_expand() {
    let script = succeeds(&["completions", "fish"]);
    let quoted: Vec<&str> = script.split("-a \"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(quoted.len() > 20, "{}", quoted.len());
    for values in quoted {
        assert!(!values.contains(['$', '`']), "{values}");
    }
    let descriptions: Vec<&str> = script.split("-d '").skip(1).collect();
    assert!(descriptions.iter().all(|text| !text.lines().next().unwrap_or_default().contains(['‘', '’', '“', '”'])));
}

#[test]
fn the_first_table_of_the_page_of_commands_names_every_command_once() {
    let page = text("docs/commands.md");
    let table: String = page
        .lines()
        .skip_while(|line| !line.starts_with("| Question"))
        .take_while(|line| line.starts_with('|'))
        .collect();
    for command in commands() {
        assert_eq!(table.matches(&format!("[{command}](#{command})")).count(), 1, "{command} in {table}");
    }
}

#[test]
fn the_page_of_commands_tells_every_option() {
    let page = text("docs/commands.md");
    let section = |name: &str| {
        let (_, rest) = page.split_once(&format!("\n## {name}\n")).unwrap_or_else(|| panic!("no section of {name}"));
        rest.split("\n## ").next().unwrap_or_default().to_owned()
    };
    let (every_command, every_page) = (section("Every command"), section("Every page"));
    let mut found = 0;
    for command in commands() {
        let own = section(&command) + &every_command;
        let told = match own.contains("[every page](#every-page)") {
            true => own + &every_page,
            false => own,
        };
        for option in options(&command) {
            let is_told = told.match_indices(&option).any(|(at, _)| !told[at + option.len()..].starts_with(['-', 's']));
            assert!(is_told, "{option} of {command} is not told");
            found += 1;
        }
    }
    assert!(found > 80, "only {found} options were found");
}

/// Whether a list of the page of commands, between these words, has these names, and no other.
#[track_caller]
fn assert_listed(before: &str, behind: &str, names: impl IntoIterator<Item = String>) {
    let page = text("docs/commands.md");
    let list = page.split_once(before).and_then(|(_, rest)| rest.split_once(behind));
    let (list, _) = list.unwrap_or_else(|| panic!("no list between {before:?} and {behind:?}"));
    let is_part = |letter: char| letter.is_ascii_lowercase() || letter == '-';
    let words = list.split(|letter| !is_part(letter)).filter(|word| !word.is_empty() && *word != "and");
    let (told, names) = (words.map(str::to_owned).collect::<BTreeSet<_>>(), names.into_iter().collect::<BTreeSet<_>>());
    let (missing, wrong): (Vec<_>, Vec<_>) = (names.difference(&told).collect(), told.difference(&names).collect());
    assert!(missing.is_empty() && wrong.is_empty(), "docs/commands.md lacks {missing:?}, and {wrong:?} are wrong");
}

#[test]
fn the_page_of_commands_lists_all_that_write_pages_have_data_and_have_a_schema() {
    let write_pages = commands().into_iter().filter(|name| options(name).iter().any(|option| option == "--fragment"));
    assert_listed("\n## Every page\n", " write pages:", write_pages);
    let have_data = crankstar::data::TABLES.iter().map(|(question, _)| (*question).to_owned());
    assert_listed("\n## Data\n", " give tables of columns", have_data);
    assert_listed("\n`crankstar schema ", "`\n", crankstar::report::schema_names().into_iter().map(str::to_owned));
}

#[test]
fn links_of_the_readme_and_of_docs_lead_somewhere() {
    let mut found = 0;
    for file in [
        "README.md",
        "CONTRIBUTING.md",
        "docs/classroom.md",
        "docs/commands.md",
        "docs/data.md",
        "docs/proved.md",
        "reports/speed/README.md",
        "docs/theory.md",
        "docs/walkthroughs.md",
        "src/kernel/claim/README.md",
        "src/kernel/file/README.md",
        "src/kernel/proof/README.md",
        "src/kernel/search/README.md",
        "src/kernel/stars/README.md",
    ] {
        let page = text(file);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let folder = folder.parent().expect("a folder");
        let written = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        let drawn = page.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next());
        for link in written.chain(drawn).filter(|link| !link.starts_with("http")) {
            let (path, heading) = link.split_once('#').unwrap_or((link, ""));
            let target =
                if path.is_empty() { text(file) } else { fs::read_to_string(folder.join(path)).unwrap_or_default() };
            assert!(folder.join(path).exists(), "{file} leads to {link}");
            // As GitHub names headings: in small letters, without points, spaces as hyphens.
            let anchor =
                |line: &str| line.trim_start_matches('#').trim().to_lowercase().replace('.', "").replace(' ', "-");
            let is_there = |line: &str| anchor(line) == heading;
            assert!(heading.is_empty() || target.lines().any(is_there), "{file} leads to {link}");
            found += 1;
        }
    }
    assert!(found > 60, "only {found} links were found");
}

#[test]
fn the_console_examples_of_the_readme_and_of_docs_are_what_the_program_prints() {
    let mut found = 0;
    for file in [
        "README.md",
        "CONTRIBUTING.md",
        "docs/classroom.md",
        "docs/commands.md",
        "docs/data.md",
        "docs/theory.md",
        "docs/walkthroughs.md",
    ] {
        for example in console::examples(&text(file)) {
            let printed = example.run();
            assert!(
                console::matches(&example.printed, &printed),
                "{file}, $ {}\nis to print\n{}\nand prints\n{printed}",
                example.command,
                example.printed
            );
            found += 1;
        }
    }
    assert!(found > 0, "no example was found");
}

#[test]
fn an_example_that_prints_something_else_is_found() {
    let page = "A\n```console\n$ crankstar classify I4\nI4\n...\nend\n\n$ crankstar 'two words' \"3\"\n```\n```sh\n$ crankstar x\n```\n";
    let examples = console::examples(page);
    let commands: Vec<&str> = examples.iter().map(|example| example.command.as_str()).collect();
    assert_eq!(commands, ["crankstar classify I4", "crankstar 'two words' \"3\""]);
    assert_eq!(examples[1].arguments(), ["two words", "3"]);
    let printed = &examples[0].printed;
    for right in ["I4\nend\n", "I4\na\n\nb\nend\n", "I4\nend\nend"] {
        assert!(console::matches(printed, right), "{right}");
    }
    for wrong in ["", "I4\n", "I4\na\nend\nb\n", "I5\nend\n", " I4\nend\n", "x\nI4\nend\n"] {
        assert!(!console::matches(printed, wrong), "{wrong}");
    }
}
