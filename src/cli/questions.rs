//! Which command answers which question? The list of commands in `--help`.

use std::fmt::Write;

use clap::Command;

/// The questions, each with the commands that answer it.
const QUESTIONS: [(&str, &[&str]); 9] = [
    ("Which engine?", &["list", "atlas"]),
    ("How does it balance?", &["classify", "firing", "report", "figure"]),
    ("How large is it?", &["loads", "bearings", "torque", "angle", "moments", "torsion", "accuracy"]),
    ("What cures it?", &["remedy", "optimise", "rotor"]),
    ("How does it change?", &["sweep"]),
    ("Which is best?", &["compare", "values", "search", "stars"]),
    ("Is it true?", &["check", "verify"]),
    ("In the classroom?", &["exercise", "mark"]),
    ("In a shell, in an editor", &["completions", "man", "schema"]),
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
    for (question, names) in QUESTIONS {
        let _ = writeln!(list, "{header}{question}{header:#}");
        for command in names.iter().filter_map(|name| program.find_subcommand(name)) {
            let name = command.get_name();
            let about = command.get_about().map(ToString::to_string).unwrap_or_default();
            let _ = writeln!(list, "  {literal}{name:<width$}{literal:#}  {about}");
        }
        list.push('\n');
    }
    list
}
