//! Which command answers which question? The list of commands in `--help`.

use std::fmt::Write;

use clap::Command;

/// The questions, each with the first of the commands that answer it; the others follow it.
const QUESTIONS: [(&str, &str); 9] = [
    ("Which engine?", "list"),
    ("How does it balance?", "classify"),
    ("How large is it?", "loads"),
    ("What cures it?", "remedy"),
    ("How does it change?", "sweep"),
    ("Which is best?", "compare"),
    ("Is it true?", "check"),
    ("In the classroom?", "exercise"),
    ("In a shell, in an editor", "completions"),
];

/// The program with its commands listed by questions, in place of one long list.
pub fn by_question(program: Command) -> Command {
    let commands = commands(&program);
    let header = program.get_styles().get_header();
    let page = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{commands}{header}Options:{header:#}\n{{options}}\n\ncrankstar COMMAND --help shows the options of a command.{{after-help}}"
    );
    program.help_template(page)
}

/// Each question with its commands, a line each.
fn commands(program: &Command) -> String {
    let (header, literal) = (program.get_styles().get_header(), program.get_styles().get_literal());
    let width = program.get_subcommands().map(|command| command.get_name().len()).max().unwrap_or(0);
    let mut list = String::new();
    for command in program.get_subcommands() {
        let name = command.get_name();
        if let Some((question, _)) = QUESTIONS.iter().find(|(_, first)| *first == name) {
            let _ = writeln!(list, "{}{header}{question}{header:#}", if list.is_empty() { "" } else { "\n" });
        }
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        let _ = writeln!(list, "  {literal}{name:<width$}{literal:#}  {about}");
    }
    list.push('\n');
    list
}
