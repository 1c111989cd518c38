//! How are the reader's symbols written in a file: `[symbols]`, each with its name in TeX?

use std::fmt;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde_spanned::Spanned;

use super::spelling::{is_plain, spelled};
use super::symbol::{SYMBOLS, Symbol};
use super::{Name, Symbols};
use crate::file::LayoutError;
use crate::file::written::{place, read};

/// Letters that mean something else on a page, and have no other names.
const TAKEN: [&str; 20] =
    ["a", "e", "f", "i", "j", "k", "l", "m", "n", "p", "r", "s", "u", "x", "y", "z", "K", "R", "T", "U"];
/// The same of letters with an index.
const TAKEN_INDEXED: [&str; 7] = ["e", "m", "r", "x", "y", "z", "U"];
/// A plain name is no longer than this.
const LONGEST: usize = 8;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    symbols: Keys,
}

/// One key per symbol.
macro_rules! keys {
    ($($field:ident $name:literal),* $(,)?) => {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Keys {
            $(#[serde(rename = $name)] $field: Option<Spanned<Given>>,)*
        }

        impl Keys {
            fn given(self) -> Vec<(&'static str, Spanned<Given>)> {
                [$(($name, self.$field)),*].into_iter().filter_map(|(key, given)| Some((key, given?))).collect()
            }
        }
    };
}

keys! {
    alpha "alpha", beta "beta", gamma "gamma", delta "delta", theta "theta", lambda "lambda", rho "rho", phi "phi",
    psi "psi", omega "omega", small_c "c_k", small_t "t_k", large_c "C_k", large_f "F_k", large_m "M_k", large_p "P_k",
    large_q "Q_k", large_v "V_k",
}

/// `"\\psi"`, or `{ tex = "\\psi", text = "ψ" }`.
struct Given {
    tex: String,
    text: Option<String>,
}

impl<'de> Deserialize<'de> for Given {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Both {
            tex: String,
            text: Option<String>,
        }
        struct Shape;
        impl<'de> Visitor<'de> for Shape {
            type Value = Given;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a text in quotes, or { tex = \"…\", text = \"…\" }")
            }
            fn visit_str<E: Error>(self, tex: &str) -> Result<Given, E> {
                Ok(Given { tex: tex.to_owned(), text: None })
            }
            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Given, A::Error> {
                let Both { tex, text } = Both::deserialize(MapAccessDeserializer::new(keys))?;
                Ok(Given { tex, text })
            }
        }
        deserializer.deserialize_any(Shape)
    }
}

impl Symbols {
    /// Reads a file of symbols; `file` is the name that messages show.
    ///
    /// # Errors
    /// Where it is no such file, a name is none that every format can show, or two symbols would have the same.
    pub fn read(file: &str, source: &str) -> Result<Self, LayoutError> {
        symbols(source).map_err(|error| error.in_file(file, source))
    }
}

fn symbols(source: &str) -> Result<Symbols, LayoutError> {
    let given = read::<File>(source)?.symbols.given();
    let mut renamed: Vec<(Symbol, Name)> = Vec::new();
    for (key, given) in &given {
        if let Some(symbol) = SYMBOLS.into_iter().find(|symbol| symbol.key == *key) {
            renamed.push((symbol, name(symbol, given)?));
        }
    }
    for (index, (symbol, name)) in renamed.iter().enumerate() {
        let place = given.iter().find(|(key, _)| *key == symbol.key).and_then(|(_, given)| place(given));
        let twice = |other: &str, right: String| {
            Err(LayoutError::new(
                format!("`{}` would be the name of {} and of {other}", name.tex, symbol.key),
                right,
                place.clone(),
            ))
        };
        if let Some((other, _)) = renamed[..index].iter().find(|(_, other)| other == name) {
            return twice(other.key, format!("{} has it already", other.key));
        }
        let is_renamed = |other: &Symbol| renamed.iter().any(|(renamed, _)| renamed == other);
        let usual = SYMBOLS.into_iter().find(|other| !is_renamed(other) && usual(*other) == *name);
        if let Some(other) = usual {
            return twice(other.key, format!("another name, or one for {} too", other.key));
        }
        let taken: &[&str] = if symbol.has_index { &TAKEN_INDEXED } else { &TAKEN };
        if taken.contains(&name.tex.as_str()) {
            return twice("another quantity of the pages", "another name".to_owned());
        }
    }
    renamed.retain(|(symbol, name)| usual(*symbol) != *name);
    Ok(Symbols { renamed })
}

/// What a symbol is called where nobody renames it.
fn usual(symbol: Symbol) -> Name {
    let tex = if symbol.has_index { symbol.tex.to_owned() } else { format!("\\{}", symbol.tex) };
    Name { tex, plain: symbol.letter.to_string() }
}

fn name(symbol: Symbol, given: &Spanned<Given>) -> Result<Name, LayoutError> {
    let Given { tex, text } = given.get_ref();
    let wrong = |message: String, right: &str| Err(LayoutError::new(message, right, place(given)));
    let without_index = |name: &str| {
        let bare = name.strip_suffix("_k").or_else(|| name.strip_suffix("_{k}")).or_else(|| name.strip_suffix('ₖ'));
        bare.unwrap_or(name).to_owned()
    };
    let tex = tex.trim();
    let bare = if symbol.has_index { without_index(tex) } else { tex.to_owned() };
    let Some(plain) = spelled(&bare) else {
        let right = "a letter such as a or \\psi, also with \\hat, \\bar, \\mathbf, … around it, a prime or an index";
        return wrong(format!("`{tex}` cannot be the name of a symbol"), right);
    };
    let Some(text) = text else { return Ok(Name { tex: bare, plain }) };
    let text = if symbol.has_index { without_index(text.trim()) } else { text.trim().to_owned() };
    match is_plain(&text) && text.chars().count() <= LONGEST {
        true => Ok(Name { tex: bare, plain: text }),
        false => {
            wrong(format!("`{text}` cannot stand for a symbol in words"), "at most eight letters and digits, such as ψ")
        }
    }
}
