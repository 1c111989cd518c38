//! What does a source file take from elsewhere in the crate, however it spells it?
//!
//! Every path that starts at `crate`, `crankstar`, `self` or `super` (for [`paths`] at a name in scope, too) is followed, in imports
//! with braces, renames and globs, in code and inside macros alike: all are the same tokens. Comments and strings are none.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// What stands for the crate as a whole: a path that ends at its root, or a glob of it, through which anything could come.
pub const ROOT: &str = "crate";

/// The last name of a path that takes all there is.
const GLOB: &str = "*";

/// A path, by its names from the root of the crate down.
pub type Path = Vec<String>;

/// What a path is written for.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum For {
    Code,
    /// An import, under this name; of a glob `*`.
    Import(String),
    /// An import that others may take from here: `pub use`.
    HandedOn(String),
}

/// The first names below the root of all paths in the text of the module `module`, as in `["exact", "decide"]`.
pub fn names(text: &str, module: &[&str]) -> BTreeSet<String> {
    let found = read(text, module, false);
    let first = |path: Path| path.into_iter().next().filter(|name| name != GLOB).unwrap_or_else(|| ROOT.to_owned());
    found.into_iter().map(|(path, _)| first(path)).collect()
}

/// All paths in the text, those too that start at a name in scope: they are below `module`, and may be of another crate.
pub fn paths(text: &str, module: &[&str]) -> BTreeSet<(Path, For)> {
    read(text, module, true)
}

fn read(text: &str, module: &[&str], names_in_scope: bool) -> BTreeSet<(Path, For)> {
    let tokens: TokenStream = text.parse().expect("the tokens of a source file");
    let mut reader = Reader { found: BTreeSet::new(), names_in_scope, import: None };
    reader.code(&listed(tokens), &module.iter().map(|&name| name.to_owned()).collect());
    reader.found
}

struct Reader {
    found: BTreeSet<(Path, For)>,
    /// Whether paths are followed that start at a name in scope.
    names_in_scope: bool,
    /// What an import is for, while it is read.
    import: Option<fn(String) -> For>,
}

impl Reader {
    /// Code in the module `module`.
    fn code(&mut self, tokens: &[TokenTree], module: &Path) {
        let (mut place, mut public) = (0, None);
        while place < tokens.len() {
            let word_at = |ahead: usize| tokens.get(place + ahead).and_then(word).unwrap_or_default();
            let braces = tokens.get(place + 2).and_then(in_braces);
            place += match (word_at(0).as_str(), &tokens[place], braces) {
                ("mod", _, Some(inside)) => {
                    self.code(&inside, &step(module.clone(), &word_at(1)));
                    3
                }
                ("extern", _, _) if word_at(1) == "crate" && root(&word_at(2), module).is_some() => {
                    self.take(Path::new(), GLOB.to_owned());
                    3
                }
                ("pub", _, _) => {
                    let length = 1 + usize::from(tokens.get(place + 1).is_some_and(is_visibility));
                    public = Some(place + length);
                    length
                }
                ("use", _, _) => {
                    let tree = tokens[place + 1..].split(|token| is_sign(token, ';')).next().unwrap_or_default();
                    self.import = Some(if public == Some(place) { For::HandedOn } else { For::Import });
                    self.branches(tree, module, None);
                    self.import = None;
                    1 + tree.len()
                }
                (start, _, _) if self.start(start, module).is_some() && are_colons(&tokens[place + 1..]) => {
                    self.path(&tokens[place..], module, None)
                }
                (_, TokenTree::Group(group), _) => {
                    self.code(&listed(group.stream()), module);
                    1
                }
                _ => 1,
            };
        }
    }

    /// The branches of an import, between commas; `base` is the path before the braces, none where there is none.
    fn branches(&mut self, tokens: &[TokenTree], module: &Path, base: Option<&Path>) {
        for branch in tokens.split(|token| is_sign(token, ',')) {
            let colons = branch.iter().take_while(|token| is_sign(token, ':')).count();
            match (branch.get(colons), base) {
                (None, _) => {}
                (Some(TokenTree::Group(group)), _) => self.branches(&listed(group.stream()), module, base),
                (Some(token), Some(base)) if is_sign(token, '*') => {
                    self.take(step(base.clone(), GLOB), GLOB.to_owned())
                }
                (Some(_), _) => {
                    self.path(&branch[colons..], module, base);
                }
            }
        }
    }

    /// Where a path with this first word starts; none where it starts at another crate, or at a name in scope that is not followed.
    fn start(&self, word: &str, module: &Path) -> Option<Path> {
        let in_scope = || (self.names_in_scope && !word.is_empty()).then(|| step(module.clone(), word));
        root(word, module).or_else(in_scope)
    }

    /// One path and what hangs on it; returns how many tokens it has.
    fn path(&mut self, tokens: &[TokenTree], module: &Path, base: Option<&Path>) -> usize {
        let first = tokens.first().and_then(word).unwrap_or_default();
        let start = base.map_or_else(|| self.start(&first, module), |base| Some(step(base.clone(), &first)));
        let Some(mut path) = start else { return 1 };
        let mut length = 1;
        while are_colons(&tokens[length..])
            && let Some(next) = tokens.get(length + 2)
        {
            length += 3;
            match (next, word(next)) {
                (_, Some(name)) => path = step(path, &name),
                (TokenTree::Group(group), None) => {
                    self.branches(&listed(group.stream()), module, Some(&path));
                    return length;
                }
                (token, None) if is_sign(token, '*') => {
                    self.take(step(path, GLOB), GLOB.to_owned());
                    return length;
                }
                // Generic arguments, which are code of their own.
                (_, None) => {
                    length -= 1;
                    break;
                }
            }
        }
        let renamed = tokens.get(length).and_then(word).filter(|word| word == "as");
        let renamed = renamed.and_then(|_| tokens.get(length + 1).and_then(word));
        let name = renamed.or_else(|| path.last().cloned()).unwrap_or_default();
        self.take(path, name);
        length
    }

    fn take(&mut self, path: Path, name: String) {
        self.found.insert((path, self.import.map_or(For::Code, |import| import(name))));
    }
}

/// Where a path with this first word starts; none where the word is no start.
fn root(word: &str, module: &Path) -> Option<Path> {
    match word {
        "crate" | "crankstar" => Some(Path::new()),
        "self" => Some(module.clone()),
        "super" => Some(step(module.clone(), "super")),
        _ => None,
    }
}

fn step(mut path: Path, word: &str) -> Path {
    match word {
        "self" => {}
        "super" => {
            path.pop();
        }
        name => path.push(name.to_owned()),
    }
    path
}

/// An identifier, without the mark of a raw one.
fn word(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Ident(name) => Some(name.to_string().trim_start_matches("r#").to_owned()),
        TokenTree::Group(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => None,
    }
}

fn is_sign(token: &TokenTree, sign: char) -> bool {
    match token {
        TokenTree::Punct(punct) => punct.as_char() == sign,
        TokenTree::Group(_) | TokenTree::Ident(_) | TokenTree::Literal(_) => false,
    }
}

fn are_colons(tokens: &[TokenTree]) -> bool {
    tokens.len() > 1 && tokens[..2].iter().all(|token| is_sign(token, ':'))
}

fn in_braces(token: &TokenTree) -> Option<Vec<TokenTree>> {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(listed(group.stream())),
        TokenTree::Group(_) | TokenTree::Ident(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => None,
    }
}

/// `(crate)`, `(super)`, `(in …)` after `pub`: who may see a thing, and no import.
fn is_visibility(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => {
            let first = group.stream().into_iter().next().as_ref().and_then(word);
            first.is_some_and(|word| ["crate", "super", "self", "in"].contains(&word.as_str()))
        }
        TokenTree::Group(_) | TokenTree::Ident(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    }
}

fn listed(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}
