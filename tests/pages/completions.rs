//! Do the shells read their completions, and offer what they should? PowerShell where it is; elsewhere its quotes and braces are read.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A file with the completions of a shell.
fn script(shell: &str) -> PathBuf {
    let output = Command::new(env!("CARGO_BIN_EXE_crankstar")).args(["completions", shell]).output().expect("it runs");
    assert!(output.status.success());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("completions");
    fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(format!("crankstar.{shell}"));
    fs::write(&path, output.stdout).expect("a file");
    path
}

/// What a shell prints; it has nothing to complain of.
fn says(program: &str, arguments: &[&str], path: &Path) -> String {
    let run = Command::new(program).args(arguments).arg(path).output();
    let Output { status, stdout, stderr } =
        run.unwrap_or_else(|error| panic!("{program}: {error}; `.ci/run` installs it"));
    let complaint = String::from_utf8_lossy(&stderr);
    assert!(status.success() && complaint.is_empty(), "{program}: {complaint}");
    String::from_utf8_lossy(&stdout).into_owned()
}

#[test]
#[ignore = "needs bash"]
fn bash_loads_the_completions() {
    let ask = "source \"$0\"; COMP_WORDS=(crankstar cl); COMP_CWORD=1; _crankstar crankstar cl crankstar; echo \"${COMPREPLY[@]}\"";
    assert_eq!(says("bash", &["--norc", "-c", ask], &script("bash")).trim(), "classify");
}

#[test]
#[ignore = "needs zsh"]
fn zsh_loads_the_completions() {
    let ask = "autoload -Uz compinit && compinit -D -u; source \"$0\"; print $_comps[crankstar]; whence -w _crankstar; _crankstar_commands 2>/dev/null; true";
    let said = says("zsh", &["-f", "-c", ask], &script("zsh"));
    assert!(said.starts_with("_crankstar\n_crankstar: function\n"), "{said}");
}

#[test]
#[ignore = "needs fish"]
fn fish_loads_the_completions() {
    let said = |line: &str| {
        let ask = format!("source $argv[1]; complete -C '{line}'");
        says("fish", &["--no-config", "-c", &ask], &script("fish"))
    };
    assert!(said("crankstar cl").starts_with("classify\tDecide force and moment"), "{}", said("crankstar cl"));
    let maths = said("crankstar report --math ");
    assert!(maths.lines().any(|line| line.starts_with("dollars\t")), "{maths}");
}

#[test]
#[ignore = "asks PowerShell where it is installed"]
fn powershell_loads_the_completions() {
    let path = script("powershell");
    if Command::new("pwsh").arg("-Version").output().is_ok() {
        let ask = format!(
            ". '{}'; (TabExpansion2 'crankstar cl' 12).CompletionMatches.CompletionText",
            path.display().to_string().replace('\'', "''")
        );
        let output = Command::new("pwsh").args(["-NoProfile", "-Command", &ask]).output().expect("it runs");
        assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "classify");
    }
    let text = fs::read_to_string(path).expect("a script");
    assert_eq!(left_open(&text), None);
    for broken in [text.replacen('}', "", 1), text.replacen("'crankstar'", "'crankstar", 1), text.replacen('(', "", 1)]
    {
        assert!(left_open(&broken).is_some(), "a broken script is seen");
    }
}

/// What stands open at the end of a script of PowerShell, or is closed where nothing is open.
fn left_open(script: &str) -> Option<String> {
    let (mut open, mut quote) = (Vec::new(), None);
    for (number, line) in script.lines().enumerate() {
        for letter in line.chars() {
            // PowerShell takes printers' quotes for quotes.
            let kind = match letter {
                '\'' | '‘' | '’' | '‚' | '‛' => Some('\''),
                '"' | '“' | '”' | '„' => Some('"'),
                _ => None,
            };
            match (quote, kind) {
                (None, Some(begins)) => quote = Some(begins),
                (Some(inside), Some(ends)) if inside == ends => quote = None,
                (None, None) if letter == '#' => break,
                (None, None) if "({[".contains(letter) => open.push(letter),
                (None, None) if ")}]".contains(letter) => {
                    let of = ["()", "{}", "[]"].iter().find(|pair| pair.ends_with(letter));
                    if open.pop() != of.and_then(|pair| pair.chars().next()) {
                        return Some(format!("line {}: {line}", number + 1));
                    }
                }
                _ => {}
            }
        }
        // No text of the script goes on in the next line.
        if quote.is_some() {
            return Some(format!("line {}: {line}", number + 1));
        }
    }
    (!open.is_empty()).then(|| format!("{open:?}"))
}
